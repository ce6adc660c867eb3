//! `gyrospec integral`: one integral, or a file of them.

use super::progress::{Meter, aside, rest};
use super::{Outcome, output};
use crate::estimate::fit::Progress;
use crate::integral::crosscheck::{Crosscheck, crosscheck};
use crate::integral::{Integral, Integrand, evaluate};
use crate::text::{in_quotes, is_lost};
use crate::units::counted;
use crate::{Error, ErrorKind, Result};
use clap::Args;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};

const HELP: &str = "\
Examples:
  gyrospec integral --h \"1 2 3\" --g \"0 1\"          # 1/12
  gyrospec integral --h \"1 1\" --c \"1\" --json
  gyrospec integral --h \"1 2 3\" --g \"0 1\" --check
  gyrospec integral --batch cases.jsonl";

/// I_n = (1/2π) ∫ G(jω)/(H(jω)H(−jω)) dω, within two units in the last place.
#[derive(Args)]
#[command(after_help = HELP)]
pub struct Arguments {
    /// Coefficients a0 a1 … an of H, highest power first, between spaces or commas
    #[arg(long, allow_hyphen_values = true, required_unless_present = "batch")]
    h: Option<String>,
    /// Coefficients b0 … b(n-1) of the even polynomial G: of s^(2n-2), s^(2n-4) … 1
    #[arg(long, allow_hyphen_values = true, conflicts_with = "c")]
    g: Option<String>,
    /// C instead of G, highest power first: G = C(s)C(-s)
    #[arg(long, allow_hyphen_values = true)]
    c: Option<String>,
    /// A file of cases, one {"h":[…],"g":[…]} a line; - reads standard input
    #[arg(long, conflicts_with_all = ["h", "g", "c"])]
    batch: Option<PathBuf>,
    /// Answer in JSON
    #[arg(long)]
    json: bool,
    /// Answer a batch with one JSON object a line (this is also its default)
    #[arg(long)]
    json_lines: bool,
    /// Add the determinant, the quadrature and the other methods to each answer
    #[arg(long)]
    check: bool,
}

/// An answer in the fixed form.
#[derive(Serialize)]
#[serde(tag = "status", rename_all = "kebab-case")]
enum Reply {
    Ok {
        #[serde(flatten)]
        answer: Integral,
        #[serde(skip_serializing_if = "Option::is_none")]
        crosscheck: Option<Box<Crosscheck>>,
    },
    Unstable {
        right_half_plane_roots: usize,
    },
    ImaginaryAxis,
    OutOfRange {
        decimal: String,
    },
    BadInput {
        message: String,
    },
}

impl Reply {
    fn new(result: Result<Integral>, check: impl FnOnce() -> Option<Box<Crosscheck>>) -> Self {
        match result {
            Ok(answer) => Self::Ok { answer, crosscheck: check() },
            Err(e) => match e.kind() {
                ErrorKind::Unstable => {
                    Self::Unstable { right_half_plane_roots: e.right_half_plane_roots().unwrap_or(0) }
                }
                ErrorKind::ImaginaryAxis => Self::ImaginaryAxis,
                ErrorKind::OutOfRange => Self::OutOfRange { decimal: e.decimal().unwrap_or("").to_owned() },
                _ => Self::BadInput { message: e.message().to_owned() },
            },
        }
    }

    fn line(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// One line of a batch; fields of other names are left alone.
#[derive(Deserialize)]
struct Case {
    h: Vec<f64>,
    g: Option<Vec<f64>>,
    c: Option<Vec<f64>>,
}

impl Case {
    fn integrand(&self) -> Result<Integrand<'_>> {
        match (&self.g, &self.c) {
            (Some(g), None) => Integrand::new(&self.h, g),
            (None, Some(c)) => Integrand::from_square(&self.h, c),
            _ => Err(Error::bad_input("give g or c, one of the two")),
        }
    }

    fn has_zero(&self) -> bool {
        [Some(&self.h), self.g.as_ref(), self.c.as_ref()].into_iter().flatten().flatten().any(|x| *x == 0.0)
    }

    fn reply(&self, check: bool) -> Reply {
        match self.integrand() {
            Ok(p) => Reply::new(evaluate(&p), || check.then(|| Box::new(crosscheck(&p)))),
            Err(e) => Reply::new(Err(e), || None),
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<Outcome> {
    if let Some(path) = &arguments.batch {
        return batch(path, arguments.check);
    }
    let numbers = |text: &Option<String>| text.as_deref().map(numbers).transpose();
    let json = arguments.json || arguments.json_lines;
    let read = || -> Result<Case> {
        let h = numbers(&arguments.h)?.unwrap_or_default();
        Ok(Case { h, g: numbers(&arguments.g)?, c: numbers(&arguments.c)? })
    };
    let case = match read() {
        Err(e) if json => {
            output::quoted(&format!("{}\n", Reply::new(Err(e.clone()), || None).line()))?;
            return Err(e);
        }
        case => case?,
    };
    let p = case.integrand();
    if json {
        output::quoted(&format!("{}\n", case.reply(arguments.check).line()))?;
        // the answer is on standard output; the exit code says that there is no value
        return match p.and_then(|p| evaluate(&p)) {
            Ok(_) => Ok(Outcome::Done),
            Err(e) => Err(e),
        };
    }
    let p = p?;
    let answer = evaluate(&p)?;
    let mut text = format!(
        "I_{} = {}\n  error at most  {:.2e}\n  condition      {:.3e}\n  method         {}\n",
        p.order(),
        answer.value,
        answer.error_bound,
        answer.condition,
        serde_json::to_value(answer.method)
            .ok()
            .and_then(|v| v.as_str().map(str::to_owned))
            .unwrap_or_default(),
    );
    if arguments.check {
        let all = serde_json::to_string_pretty(&crosscheck(&p)).unwrap_or_default();
        text += "by every method:\n";
        text += &all;
        text.push('\n');
    }
    output::words(&text)?;
    Ok(Outcome::Done)
}

/// Numbers between spaces or commas.
fn numbers(text: &str) -> Result<Vec<f64>> {
    let wrong = |word: &str| {
        let e = match word {
            "" => Error::bad_input("there is nothing between two commas"),
            _ => Error::bad_input(format!("`{word}` is no number")),
        };
        e.with_hint("write 1 2.5 -3e-4 …")
    };
    let number = |word: &str| match word.parse() {
        Ok(_) if is_lost(word) => Err(lost(word)),
        read => read.map_err(|_| wrong(word)),
    };
    if text.trim().is_empty() {
        return Ok(Vec::new());
    }
    if let Some(word) = may_be_decimal(text) {
        return Err(Error::bad_input(format!("`{word}` is one number with a decimal comma, or two"))
            .with_hint("write a point for decimals, 1.5, and a blank after a comma that separates numbers"));
    }
    let mut all = Vec::new();
    for part in text.split(',') {
        let before = all.len();
        for word in part.split_whitespace() {
            all.push(number(word)?);
        }
        if all.len() == before {
            return Err(wrong(""));
        }
    }
    Ok(all)
}

/// That a number is too small.
fn lost(word: &str) -> Error {
    Error::bad_input(format!("`{word}` is smaller than the smallest double, 4.9e-324"))
        .with_hint("multiply all coefficients of h, and of g, by a power of ten; I_n goes with g/h^2")
}

/// A number of a line of JSON that would be read as 0.
fn lost_in(line: &[u8]) -> Option<&str> {
    let is_apart = |c: char| c.is_whitespace() || ",:[]{}".contains(c);
    let outside = std::str::from_utf8(line).ok()?.split('"').step_by(2);
    outside.flat_map(|part| part.split(is_apart)).find(|word| is_lost(word))
}

/// A word with a comma between digits where blanks separate numbers too.
fn may_be_decimal(text: &str) -> Option<&str> {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let tight = |word: &&str| {
        let parts: Vec<&str> = word.split(',').collect();
        parts.windows(2).any(|w| is_digit(w[0].chars().last()) && is_digit(w[1].chars().next()))
    };
    let by_blanks = text.split(',').any(|part| part.split_whitespace().count() > 1);
    text.split_whitespace().find(tight).filter(|_| by_blanks)
}

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Lines that are read, answered on all cores and written before the next are read.
const BLOCK: usize = 8192;

fn batch(path: &Path, check: bool) -> Result<Outcome> {
    let source: Box<dyn Read> = if path == Path::new("-") {
        Box::new(std::io::stdin().lock())
    } else {
        Box::new(std::fs::File::open(path).map_err(|e| Error::io(path, &e))?)
    };
    let mut lines = BufReader::with_capacity(1 << 20, source);
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    let stdout = |e: std::io::Error| Error::io(Path::new("standard output"), &e);
    let mut number = 0;
    loop {
        let mut block = Vec::new();
        if lines.buffer().is_empty() {
            rest();
        }
        while block.len() < BLOCK {
            let mut line = Vec::new();
            if lines.read_until(b'\n', &mut line).map_err(|e| Error::io(path, &e))? == 0 {
                break;
            }
            if number == 0 && line.starts_with(BYTE_ORDER_MARK) {
                line.drain(..BYTE_ORDER_MARK.len());
            }
            // Lines may end with carriage returns alone.
            let line = line.strip_suffix(b"\n").unwrap_or(&line);
            for part in line.strip_suffix(b"\r").unwrap_or(line).split(|b| *b == b'\r') {
                number += 1;
                if !part.trim_ascii().is_empty() {
                    block.push((number, part.to_owned()));
                }
            }
            // a writer that waits for its answers gets them
            if !block.is_empty() && lines.buffer().is_empty() {
                break;
            }
        }
        if block.is_empty() {
            return Ok(Outcome::Done);
        }
        Meter.report(&format!("integrating, {} read", counted(number, "line")), None);
        let answers: Vec<String> =
            block.par_iter().map(|(number, line)| answer_line(*number, line, check).line()).collect();
        let write =
            || answers.iter().try_for_each(|a| writeln!(out, "{}", in_quotes(a))).and_then(|()| out.flush());
        aside(write).map_err(stdout)?;
    }
}

fn answer_line(number: usize, line: &[u8], check: bool) -> Reply {
    let line = line.trim_ascii();
    let no_object = || Reply::BadInput {
        message: format!(
            "line {number}: a case is an object such as {{\"h\":[1,2,3],\"g\":[0,1]}}, {}",
            this(line)
        ),
    };
    match serde_json::from_slice::<Case>(line) {
        // A list of lists would be read field by field.
        Ok(case) if line.starts_with(b"{") => match case.has_zero().then(|| lost_in(line)).flatten() {
            Some(word) => Reply::BadInput { message: format!("line {number}: {}", lost(word).message()) },
            None => case.reply(check),
        },
        Err(e) if line.starts_with(b"{") || e.is_syntax() || e.is_eof() => Reply::BadInput {
            message: format!("line {number}, column {}: {}", e.column(), reason(&e.to_string())),
        },
        _ => no_object(),
    }
}

/// What stands where an object should, in words.
fn this(line: &[u8]) -> &'static str {
    match line.first() {
        Some(b'[') => "this is a list",
        Some(b'"') => "this is a text",
        Some(b'n') => "this is null",
        Some(b't' | b'f') => "this is true or false",
        _ => "this is a number",
    }
}

/// A parser's message without its own count of lines.
fn reason(message: &str) -> &str {
    message.split(" at line ").next().unwrap_or(message)
}
