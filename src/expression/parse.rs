//! Reads an expression.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = unary { ("*" | "/") unary }
//! unary   = ("-" | "+") unary | power
//! power   = atom [ "^" unary ]
//! atom    = number | name | function "(" sum { "," sum } ")" | "(" sum ")"
//! ```

use super::foreign;
use super::{BinaryOp, Expr, Foreign, Function};
use crate::error::nearest;
use crate::text::is_lost;
use crate::{Error, Result};

/// Nesting and length beyond this are refused, so that no later walk runs out of stack.
const DEEPEST: usize = 400;
const LONGEST_CHAIN: usize = 2000;

/// Where a subexpression stands in the text (in characters), in the shape of its tree.
#[derive(Debug, Clone)]
pub(super) struct Span {
    pub start: usize,
    pub end: usize,
    pub children: Vec<Span>,
}

type Spanned = (Expr, Span);

impl Expr {
    /// Reads an expression.
    ///
    /// # Errors
    /// A syntax error shows the text and points at the column (from 1); an unknown function is
    /// answered with the nearest known one.
    pub fn parse(text: &str) -> Result<Self> {
        spanned(text).map(|(expr, _)| expr)
    }
}

impl std::str::FromStr for Expr {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self> {
        Self::parse(text)
    }
}

/// Reads the whole text, with the places of all subexpressions.
pub(super) fn spanned(text: &str) -> Result<Spanned> {
    let chars: Vec<char> = text.chars().collect();
    let mut reader = Reader { text, chars: &chars, at: 0, depth: 0, joints: 0 };
    reader.spaces();
    if reader.peek().is_none() {
        return Err(Error::bad_input("the expression is empty").with_hint("write 0 for nothing"));
    }
    let tree = reader.sum()?;
    match reader.peek() {
        None => Ok(tree),
        Some(')') => Err(reader.error(reader.at, 1, "this ) closes nothing")),
        Some(c) => Err(reader.error(reader.at, 1, format!("an operator is missing before {c:?}"))),
    }
}

struct Reader<'a> {
    text: &'a str,
    chars: &'a [char],
    at: usize,
    depth: usize,
    joints: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.chars.get(self.at).copied()
    }

    fn spaces(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.at += 1;
        }
    }

    fn takes(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += 1;
            self.spaces();
        }
        found
    }

    fn error(&self, at: usize, length: usize, message: impl Into<String>) -> Error {
        Error::bad_input(message).with_column(at + 1).with_excerpt(self.text, at, length)
    }

    fn takes_one_of(&mut self, ops: [(char, BinaryOp); 2]) -> Option<BinaryOp> {
        ops.into_iter().find(|(c, _)| self.takes(*c)).map(|(_, op)| op)
    }

    fn sum(&mut self) -> Result<Spanned> {
        let mut left = self.product()?;
        while let Some(op) = self.takes_one_of([('+', BinaryOp::Add), ('-', BinaryOp::Sub)]) {
            let right = self.product()?;
            left = self.joined(op, left, right)?;
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Spanned> {
        let mut left = self.unary()?;
        while let Some(op) = self.takes_one_of([('*', BinaryOp::Mul), ('/', BinaryOp::Div)]) {
            let right = self.unary()?;
            left = self.joined(op, left, right)?;
        }
        Ok(left)
    }

    fn joined(&mut self, op: BinaryOp, left: Spanned, right: Spanned) -> Result<Spanned> {
        self.joints += 1;
        if self.joints > LONGEST_CHAIN {
            return Err(self
                .error(self.at.min(self.chars.len()), 1, "the expression is too long")
                .with_hint("split it into definitions"));
        }
        let span = Span { start: left.1.start, end: right.1.end, children: vec![left.1, right.1] };
        Ok((Expr::Binary(op, Box::new(left.0), Box::new(right.0)), span))
    }

    fn unary(&mut self) -> Result<Spanned> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error(self.at, 1, "the expression is nested too deeply"));
        }
        let start = self.at;
        let out = if self.takes('-') {
            let (inner, span) = self.unary()?;
            let span = Span { start, end: span.end, children: vec![span] };
            Ok((Expr::Neg(Box::new(inner)), span))
        } else if self.takes('+') {
            self.unary()
        } else {
            self.power()
        };
        self.depth -= 1;
        out
    }

    fn power(&mut self) -> Result<Spanned> {
        let base = self.atom()?;
        if self.peek() == Some('*') && self.chars.get(self.at + 1) == Some(&'*') {
            return Err(self.error(self.at, 2, "powers are written with ^"));
        }
        if !self.takes('^') {
            return Ok(base);
        }
        let exponent = self.unary()?;
        self.joined(BinaryOp::Pow, base, exponent)
    }

    fn atom(&mut self) -> Result<Spanned> {
        let start = self.at;
        match self.peek() {
            Some('(') => {
                self.takes('(');
                let (inner, mut span) = self.sum()?;
                let end = self.at + 1;
                self.closes(start)?;
                (span.start, span.end) = (start, end);
                Ok((inner, span))
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.word(),
            Some(c) => Err(self
                .error(start, 1, format!("{c:?} cannot stand here"))
                .with_hint("a number, a name, a function or ( is expected")),
            None => Err(self.error(start, 1, "the expression ends too early")),
        }
    }

    fn closes(&mut self, opened: usize) -> Result<()> {
        match self.peek() {
            Some(')') => {
                self.takes(')');
                Ok(())
            }
            Some(c) => Err(self.error(self.at, 1, format!("expected ) or an operator, found {c:?}"))),
            None => Err(self.error(opened, 1, "this ( is never closed")),
        }
    }

    fn number(&mut self) -> Result<Spanned> {
        let start = self.at;
        let digits = |r: &mut Self| {
            while r.peek().is_some_and(|c| c.is_ascii_digit()) {
                r.at += 1;
            }
        };
        digits(self);
        if self.peek() == Some('.') {
            self.at += 1;
            digits(self);
        }
        if matches!(self.peek(), Some('e' | 'E')) {
            let sign = usize::from(matches!(self.chars.get(self.at + 1), Some('+' | '-')));
            if self.chars.get(self.at + 1 + sign).is_some_and(char::is_ascii_digit) {
                self.at += 1 + sign;
                digits(self);
            }
        }
        let text: String = self.chars[start..self.at].iter().collect();
        let length = self.at - start;
        let value: Option<f64> = text.parse().ok().filter(|v: &f64| v.is_finite() && !is_lost(&text));
        let value = value.ok_or_else(|| self.error(start, length, format!("{text} is no number")))?;
        let span = Span { start, end: self.at, children: Vec::new() };
        self.spaces();
        Ok((Expr::Number(value), span))
    }

    fn word(&mut self) -> Result<Spanned> {
        let start = self.at;
        while self.peek().is_some_and(|c| c.is_alphanumeric() || c == '_') {
            self.at += 1;
        }
        let word: String = self.chars[start..self.at].iter().collect();
        let end = self.at;
        self.spaces();
        if self.peek() == Some('(') {
            return self.call(&word, start, end);
        }
        Ok((Expr::Name(word), Span { start, end, children: Vec::new() }))
    }

    fn call(&mut self, word: &str, start: usize, end: usize) -> Result<Spanned> {
        if word == foreign::NAME {
            return self.foreign(start, end);
        }
        let function = Function::named(word).ok_or_else(|| {
            let e = self.error(start, end - start, format!("unknown function {word:?}"));
            match nearest(word, Function::all().map(Function::name)) {
                Some(near) => e.with_hint(format!("the nearest known function is {near}")),
                None => e.with_hint(format!("for a product write {word}*(…)")),
            }
        })?;
        if matches!(function, Function::Surface(..)) {
            return self.surface(start);
        }
        let (arguments, children, last) = self.arguments()?;
        if !function.takes(arguments.len()) {
            let (name, wants, has) = (function.usage(), function.arity(), arguments.len());
            if function == Function::Curve {
                let message =
                    format!("{name} takes x and two or more knots of two numbers each, not {has} arguments");
                return Err(self.error(start, last - start, message));
            }
            let message =
                format!("{name} takes {wants} argument{}, not {has}", if wants == 1 { "" } else { "s" });
            return Err(self.error(start, last - start, message));
        }
        Ok((Expr::Call(function, arguments), Span { start, end: last, children }))
    }

    /// The arguments in parentheses, their places, and where the call ends.
    fn arguments(&mut self) -> Result<(Vec<Expr>, Vec<Span>, usize)> {
        let opened = self.at;
        self.takes('(');
        let (mut arguments, mut children) = (Vec::new(), Vec::new());
        if self.peek() != Some(')') {
            loop {
                let (argument, span) = self.sum()?;
                arguments.push(argument);
                children.push(span);
                if !self.takes(',') {
                    break;
                }
            }
        }
        let last = self.at + 1;
        self.closes(opened)?;
        Ok((arguments, children, last))
    }

    /// surface(x, y, [x1, …], [y1, …], [z11, z12, …]).
    fn surface(&mut self, start: usize) -> Result<Spanned> {
        let opened = self.at;
        self.takes('(');
        let (mut arguments, mut children) = (Vec::new(), Vec::new());
        for _ in 0..2 {
            let (argument, span) = self.sum()?;
            arguments.push(argument);
            children.push(span);
            self.follows(',')?;
        }
        let mut sizes = [0; 3];
        for (k, size) in sizes.iter_mut().enumerate() {
            self.follows('[')?;
            loop {
                let (argument, span) = self.sum()?;
                arguments.push(argument);
                children.push(span);
                *size += 1;
                if !self.takes(',') {
                    break;
                }
            }
            self.follows(']')?;
            if k < 2 {
                self.follows(',')?;
            }
        }
        let last = self.at + 1;
        self.closes(opened)?;
        let [n, m, values] = sizes;
        let count = |k: usize| u16::try_from(k).ok().filter(|k| *k >= 2);
        let (Some(columns), Some(rows)) = (count(n), count(m)) else {
            return Err(self.error(
                start,
                last - start,
                "a surface has two or more knots along x and along y",
            ));
        };
        if values != n * m {
            let message = format!(
                "{n} x and {m} y want {} values, a z for each y at the first x, then at the next; here are {values}",
                n * m
            );
            return Err(self.error(start, last - start, message));
        }
        Ok((Expr::Call(Function::Surface(columns, rows), arguments), Span { start, end: last, children }))
    }

    /// Goes past a character that must stand here.
    fn follows(&mut self, wanted: char) -> Result<()> {
        if self.takes(wanted) {
            return Ok(());
        }
        let found = self.peek().map_or("the end".to_owned(), |c| format!("{c:?}"));
        let e = self.error(self.at, 1, format!("expected {wanted:?}, found {found}"));
        Err(e.with_hint("a surface is written surface(x, y, [x1, x2, …], [y1, y2, …], [z11, z12, …])"))
    }

    /// fmu(k, …), a result of the unit that the model names.
    fn foreign(&mut self, start: usize, end: usize) -> Result<Spanned> {
        let (mut arguments, mut children, last) = self.arguments()?;
        let number = arguments.first().and_then(Expr::constant).filter(|k| k.fract() == 0.0);
        let number = number.and_then(|k| u16::try_from(k as i64).ok());
        let Some(foreign) = number.and_then(Foreign::spoken_of) else {
            let e = self.error(start, end - start, "there is no such result of an FMU");
            return Err(e.with_hint("fmu(k, …) stands in models with a line fmu = \"….fmu\""));
        };
        arguments.remove(0);
        children.remove(0);
        let function = Function::Foreign(foreign);
        if !function.takes(arguments.len()) {
            let (wants, has) = (foreign.arity(), arguments.len());
            let message =
                format!("this FMU takes {wants} arguments (time, states, inputs, parameters), not {has}");
            return Err(self.error(start, last - start, message));
        }
        Ok((Expr::Call(function, arguments), Span { start, end: last, children }))
    }
}
