//! `gyrospec formula`: a mean value as a formula in the user's own symbols.

mod sheet;
mod values;

use super::{Outcome, input, output};
use crate::symbolic::{CodeLanguage, FormulaRequest, formula, irregular_roll, known_letter};
use crate::{Error, Result};
use clap::{Args, ValueEnum};
use sheet::Sheet;
use std::path::PathBuf;

/// Derive a mean square or mean product as a formula in your own symbols.
///
/// Give H and G, or transfer functions in s that one noise drives. The result is simplified and checked at random
/// points against the numeric engine; what does not agree is never printed.
#[derive(Args)]
#[command(after_help = HELP)]
pub struct FormulaCall {
    /// A TOML file with the names that the options of an expression have, relations as a list; - is standard input.
    file: Option<PathBuf>,
    /// H(s), for example "(T*s + 1)*(s^2 + 2*mu*s + b^2)".
    #[arg(long, allow_hyphen_values = true)]
    h: Option<String>,
    /// G(s), even in s; 1 if absent.
    #[arg(long, allow_hyphen_values = true, requires = "h", conflicts_with = "first")]
    g: Option<String>,
    /// Transfer function from the shaped noise to the first signal.
    #[arg(long, allow_hyphen_values = true, conflicts_with = "h")]
    first: Option<String>,
    /// The same to the second signal; without it the mean square of the first is derived.
    #[arg(long, allow_hyphen_values = true, requires = "first", conflicts_with = "h")]
    second: Option<String>,
    /// Transfer function from white noise to the shaped noise; 1 if absent.
    #[arg(long, allow_hyphen_values = true, requires = "first", conflicts_with = "h")]
    shaping: Option<String>,
    /// Density of the white noise, with mean square = (1/2 pi) integral over all w; 1 if absent.
    #[arg(long, allow_hyphen_values = true, requires = "first", conflicts_with = "h")]
    density: Option<String>,
    /// What stands before the integral.
    #[arg(long, allow_hyphen_values = true)]
    times: Option<String>,
    /// A relation between symbols, such as "b^2 = mu^2 + eps^2"; may be given often.
    #[arg(long = "relation")]
    relations: Vec<String>,
    /// A factor to keep together and print as written; may be given often.
    #[arg(long)]
    keep: Vec<String>,
    /// The order in which symbols are printed, such as "P h A b".
    #[arg(long, default_value = "")]
    order: String,
    /// The name of the result.
    #[arg(long)]
    name: Option<String>,
    /// A printed formula to set beside the result, with the ratio.
    #[arg(long, allow_hyphen_values = true)]
    printed: Option<String>,
    /// Derive the gyrocompass error on irregular roll, with the formula printed in 1978 beside it.
    #[arg(long, conflicts_with_all = ["file", "h", "g", "first", "second", "shaping", "density"])]
    seed: bool,
    /// Also the derivative in this symbol; may be given often.
    #[arg(long = "derivative")]
    derivatives: Vec<String>,
    /// Also the value, in consistent units: "T=0.44, mu=0.1, eps=0.8"; symbols on the left of a relation follow.
    /// H must be stable there.
    #[arg(long)]
    values: Option<String>,
    /// The form of the result.
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// Where the result goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
}

const HELP: &str = "\
Examples:
  gyrospec formula --h \"m*s^2 + r*s + c\" --g N --name x2
  gyrospec formula --first \"1/(T*s + 1)\" --shaping \"1/(s^2 + 2*z*w*s + w^2)\" --density S --format latex
  gyrospec formula --seed
  gyrospec formula request.toml --derivative T --values \"T=0.44, mu=0.1, eps=0.8\"

H may have any order up to 14. Where every coefficient is a letter of its own the answer is the table of that order;
up to order 10 it is short enough to be written as a formula, above that `gyrospec table` has it.

What is not attempted: a factorisation in full (factors that H was given in, their resultants, common divisors and
repeated factors are found; name others with --keep), relations that are not solved for a product of powers,
identities of functions that are not given as a relation.";

#[derive(Clone, Copy, ValueEnum, PartialEq)]
enum Format {
    Text,
    /// In the language of model files.
    Expression,
    Latex,
    Rust,
    Python,
    C,
    Json,
}

/// Runs the subcommand.
pub fn run(call: &FormulaCall) -> Result<Outcome> {
    let is_code = !matches!(call.format, Format::Text | Format::Json);
    if is_code && (call.values.is_some() || call.printed.is_some()) {
        return Err(Error::usage("--values and --printed are shown in text and JSON alone")
            .with_hint("leave --format away, or take --format json"));
    }
    let place = output::Place::open(&call.out)?;
    output::spare([&place], &call.file)?;
    let request = call.request()?;
    let simplifier = request.simplifier()?;
    let (derivation, printed) = (request.derivation()?, request.printed()?);
    let known = values::letters(&derivation, &simplifier, printed.as_ref());
    let given = call.values.as_deref().map(|text| values::read(text, &known)).transpose()?;
    call.derivatives.iter().try_for_each(|symbol| known_letter(symbol, &known))?;
    if let Some(name) = call.name.as_ref().filter(|name| known.iter().any(|k| k == *name)) {
        return Err(Error::usage(format!(
            "`{name}` is a symbol of the formula: its result cannot have that name"
        ))
        .with_hint("give --name another name"));
    }
    let derived = formula(&derivation, &simplifier)?;
    let mut shown = vec![derived.formula.clone()];
    for symbol in &call.derivatives {
        shown.push(derived.formula.derivative(symbol, &simplifier)?);
    }
    let values = given.map(|given| values::usable(&given, &derivation, &simplifier)).transpose()?;
    let sheet = Sheet { derived, shown, printed, simplifier, values };
    let text = match call.format {
        Format::Text => sheet.text()?,
        Format::Json => sheet.json()?,
        Format::Expression => sheet.each(|f| Ok(f.expression.to_string()))?,
        Format::Latex => sheet.each(|f| Ok(f.latex()))?,
        Format::Rust => sheet.each(|f| f.code(CodeLanguage::Rust))?,
        Format::Python => sheet.each(|f| f.code(CodeLanguage::Python))?,
        Format::C => sheet.each(|f| f.code(CodeLanguage::C))?,
    };
    let ready = if call.format == Format::Json { place.quoted(&text) } else { place.words(&text) };
    output::put(&[ready], &call.file)?;
    Ok(Outcome::Done)
}

impl FormulaCall {
    fn request(&self) -> Result<FormulaRequest> {
        let mut request = match &self.file {
            Some(path) => FormulaRequest::parse(&input::text(path)?).map_err(|e| e.with_file(path))?,
            None if self.seed => irregular_roll(),
            None => FormulaRequest::default(),
        };
        let given = [
            (&mut request.h, &self.h),
            (&mut request.g, &self.g),
            (&mut request.first, &self.first),
            (&mut request.second, &self.second),
            (&mut request.shaping, &self.shaping),
            (&mut request.density, &self.density),
            (&mut request.times, &self.times),
            (&mut request.name, &self.name),
            (&mut request.printed, &self.printed),
        ];
        for (place, option) in given {
            if option.is_some() {
                place.clone_from(option);
            }
        }
        request.relations.extend(self.relations.iter().cloned());
        request.keep.extend(self.keep.iter().cloned());
        if !self.order.is_empty() {
            request.order.clone_from(&self.order);
        }
        Ok(request)
    }
}
