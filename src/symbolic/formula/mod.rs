//! Formulas in the user's own letters.

mod alphabet;
mod bounded;
mod calculus;
mod code;
mod derive;
mod factor;
mod glyph;
mod identifier;
mod latex;
mod page;
mod request;
mod resultant;
mod rule;
mod sampler;
mod seed;
mod sine;
mod text;
mod transfer;
mod verify;
mod walk;

pub(super) use bounded::{Bounded, bounded};
pub use calculus::{derivative, known_letter, symbols, value};
pub use derive::{LAPLACE, Source};
pub use identifier::CodeLanguage;
pub use request::FormulaRequest;
pub use rule::Relation;
pub use sampler::{Sampler, Values, completed};
pub use seed::irregular_roll;
pub use sine::SineMean;
pub(super) use text::{leading_minus, terms};
pub use transfer::{Mean, numeric};

use crate::expression::Expr;
use crate::{Error, Result};
use alphabet::Alphabet;
use factor::{Known, Writer};
use resultant::{candidates, sums};
use rule::Rule;

/// A formula: a name and what it is equal to.
///
/// ```
/// use gyrospec::symbolic::Formula;
/// let formula = Formula::parse("alpha", "-P^2*sin(2*K)/(2*C0*cos(phi))")?;
/// assert_eq!(formula.text(), "α = −P² sin 2K / (2 C0 cos φ)");
/// assert_eq!(formula.latex(), r"\alpha = -\frac{P^{2} \sin 2 K}{2 C_{0} \cos \varphi}");
/// let values = [("P", 2.0), ("K", 0.5), ("C0", 4.0), ("phi", 0.0)];
/// let values = values.iter().map(|(name, value)| (name.to_string(), *value)).collect();
/// assert_eq!(formula.evaluate(&values)?, -0.5 * 1f64.sin());
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Formula {
    /// The left side.
    pub name: String,
    /// The symbols in which the left side is differentiated.
    pub by: Vec<String>,
    /// The right side.
    pub expression: Expr,
}

impl Formula {
    /// A formula as it is written.
    ///
    /// # Errors
    /// Bad input, where the right side cannot be read.
    pub fn parse(name: &str, right: &str) -> Result<Self> {
        Ok(Self { name: name.into(), by: Vec::new(), expression: Expr::parse(right)? })
    }

    /// Its value.
    ///
    /// # Errors
    /// Bad input, where a symbol has no value.
    pub fn evaluate(&self, values: &Values) -> Result<f64> {
        value(&self.expression, &|name| values.get(name).copied())
    }

    /// Its derivative in one symbol, simplified where that can be done; symbols that a relation gives as a power of
    /// one name, such as b in b² = μ² + ε², vary with it.
    ///
    /// # Errors
    /// Not computed, where a function in it has none.
    pub fn derivative(&self, symbol: &str, simplifier: &Simplifier) -> Result<Self> {
        let mut slope = derivative(&self.expression, symbol)?;
        for relation in &simplifier.relations {
            if let [(name, power)] = sampler::powers(&relation.left)[..]
                && name != symbol
                && relation.right.mentions(symbol)
            {
                // ∂y/∂b · (∂r/∂x)/(k bᵏ⁻¹) for bᵏ = r(x)
                let inner = derivative(&relation.right, symbol)?;
                let outer = derivative(&self.expression, name)?;
                slope = slope + outer * inner / (Expr::number(power) * Expr::name(name).pow(power - 1.0));
            }
        }
        let expression = simplifier.simplify(&slope).unwrap_or(slope);
        let by = self.by.iter().cloned().chain([symbol.to_owned()]).collect();
        Ok(Self { name: self.name.clone(), by, expression })
    }

    /// What it is times another formula: their ratio, simplified under the relations.
    ///
    /// # Errors
    /// Not computed, where the other formula is 0 or a part is beyond simplification.
    pub fn ratio_to(&self, other: &Self, simplifier: &Simplifier) -> Result<Self> {
        if simplifier.vanishes(&other.expression)? {
            return Err(Error::bad_input(format!(
                "{} is zero for all values: there is no ratio to it",
                other.text()
            )));
        }
        let ratio = self.expression.clone() / other.expression.clone();
        Ok(Self { name: "ratio".into(), by: Vec::new(), expression: simplifier.simplify(&ratio)? })
    }

    /// As plain text with Greek letters and raised figures.
    pub fn text(&self) -> String {
        let slope = |left: String, by: &String| format!("∂{left}/∂{}", glyph::text_name(by));
        let left = self.by.iter().fold(glyph::text_name(&self.name), slope);
        format!("{left} = {}", text::text(&self.expression))
    }

    /// As LaTeX: a formula that fits in a line without delimiters, a longer one as an `align*` of broken lines in
    /// which long sums have letters of their own (package amsmath).
    pub fn latex(&self) -> String {
        let slope = |left: String, by: &String| {
            format!(r"\frac{{\partial {left}}}{{\partial {}}}", glyph::latex_name(by))
        };
        let left = self.by.iter().fold(glyph::latex_name(&self.name), slope);
        page::set(&left, &self.expression)
    }

    /// As a function in a programming language; its arguments are the symbols in alphabetical order. Greek letters
    /// are written out, and a word that the language needs for itself takes an underscore.
    ///
    /// # Errors
    /// Bad input, where a name cannot be written in the language or two names become one.
    pub fn code(&self, language: CodeLanguage) -> Result<String> {
        code::function(self, language)
    }
}

/// How a formula is to be simplified and written.
///
/// ```
/// use gyrospec::expression::Expr;
/// use gyrospec::symbolic::{Relation, Simplifier};
/// let simplifier = Simplifier { relations: vec![Relation::parse("b^2 = mu^2 + eps^2")?], ..Simplifier::default() };
/// let simple = simplifier.simplify(&Expr::parse("(mu^4 - eps^4)/(mu - eps)/x")?)?;
/// assert_eq!(simple.to_string(), "b^2*(mu + eps)/x");
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, Default, Debug)]
pub struct Simplifier {
    /// Relations between the symbols.
    pub relations: Vec<Relation>,
    /// Factors that are to be kept together and printed as they are written.
    pub keep: Vec<Expr>,
    /// The order in which symbols are printed; the others follow as they appear.
    pub order: Vec<String>,
}

impl Simplifier {
    /// An expression without common factors, in factors, with the number in front.
    ///
    /// # Errors
    /// Not computed, where it is beyond the means described in the manual.
    pub fn simplify(&self, expression: &Expr) -> Result<Expr> {
        let desk = Desk::new(self, &[expression])?;
        let fraction = desk.alphabet.fraction(expression)?;
        desk.write(&fraction)
    }

    /// Whether an expression is zero for all values of its symbols that satisfy the relations.
    ///
    /// # Errors
    /// Not computed, where it is no ratio of polynomials in symbols and functions.
    pub fn vanishes(&self, expression: &Expr) -> Result<bool> {
        let (alphabet, rules) = self.ready(&[expression])?;
        Ok(rule::normal_form(&alphabet.fraction(expression)?, &rules)?.is_zero())
    }

    fn ready(&self, expressions: &[&Expr]) -> Result<(Alphabet, Vec<Rule>)> {
        let sides = self.relations.iter().flat_map(|relation| [&relation.left, &relation.right]);
        let all: Vec<&Expr> = expressions.iter().copied().chain(&self.keep).chain(sides).collect();
        let alphabet = Alphabet::new(&all, &self.order)?;
        let relations = self.relations.iter().cloned().chain(roots(&alphabet));
        let rules = relations.map(|r| Rule::forward(&r, &alphabet)).collect::<Result<Vec<_>>>()?;
        Ok((alphabet, rules))
    }
}

/// Alphabet, rules and known factors made ready for some expressions.
struct Desk {
    alphabet: Alphabet,
    rules: Vec<Rule>,
    known: Vec<Known>,
}

impl Desk {
    fn new(simplifier: &Simplifier, expressions: &[&Expr]) -> Result<Self> {
        let (alphabet, rules) = simplifier.ready(expressions)?;
        let mut known = Vec::new();
        for factor in &simplifier.keep {
            known.push(Known::new(factor, true, &alphabet, &rules)?);
        }
        for relation in &simplifier.relations {
            known.push(Known::new(&relation.right, false, &alphabet, &rules)?);
        }
        let sums = sums(expressions);
        for sum in sums.iter().filter(|sum| !sum.mentions(derive::LAPLACE)) {
            known.push(Known::new(sum, false, &alphabet, &rules)?);
        }
        for factor in candidates(&sums, &alphabet)? {
            known.push(Known::plain(&factor, &rules)?);
        }
        Ok(Self { alphabet, rules, known })
    }

    fn write(&self, fraction: &crate::symbolic::Fraction) -> Result<Expr> {
        Writer { alphabet: &self.alphabet, rules: &self.rules, known: &self.known }.write(fraction)
    }
}

/// √x·√x = x for every root in the alphabet.
fn roots(alphabet: &Alphabet) -> Vec<Relation> {
    let root = |atom: &Expr| match atom {
        Expr::Call(crate::expression::Function::Sqrt, arguments) => {
            Some(Relation { left: atom.clone().pow(2.0), right: arguments[0].clone() })
        }
        _ => None,
    };
    alphabet.atoms().iter().filter_map(root).collect()
}

/// A mean value to be derived: times · (1/2π) ∫ … dω.
#[derive(Clone, PartialEq, Debug)]
pub struct Derivation {
    /// The name of the result.
    pub name: String,
    /// What is integrated.
    pub source: Source,
    /// What stands before the integral.
    pub times: Expr,
}

impl Derivation {
    /// The mean value at given values by the engine, without the formula.
    ///
    /// # Errors
    /// Unstable or imaginary axis, where H is not stable there; out of range, where the mean is infinite; bad input,
    /// where a symbol has no value.
    ///
    /// ```
    /// use gyrospec::ErrorKind;
    /// use gyrospec::symbolic::{FormulaRequest, Values};
    /// let oscillator = FormulaRequest { h: Some("s^2 + r*s + 1".into()), ..FormulaRequest::default() };
    /// let mean = |r: f64| oscillator.derivation()?.mean(&Values::from([("r".into(), r)]));
    /// assert_eq!(mean(0.25)?, 2.0);
    /// assert_eq!(mean(-0.25).unwrap_err().kind(), ErrorKind::Unstable);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn mean(&self, values: &Values) -> Result<f64> {
        let times = value(&self.times, &|name| values.get(name).copied())?;
        Ok(times * numeric(&self.source, values)?.value)
    }

    /// The order n of its I_n, without deriving it.
    ///
    /// # Errors
    /// Bad input for what is no integral of this kind.
    pub fn order(&self, simplifier: &Simplifier) -> Result<usize> {
        let expressions = self.source.expressions();
        Ok(self.source.prepare(&Desk::new(simplifier, &expressions)?.alphabet)?.b.len())
    }
}

/// A derived formula and how it was checked.
#[derive(Clone, PartialEq, Debug)]
pub struct Derived {
    /// The derived formula, simplified.
    pub formula: Formula,
    /// The order n of the integral.
    pub order: usize,
    /// The number of random points at which it agrees with the numeric engine.
    pub points: usize,
}

/// Derives a formula and checks it against the numeric engine before it is handed out.
///
/// # Errors
/// Bad input for what is no integral of this kind; not computed, where a check fails.
///
/// ```
/// use gyrospec::{FormulaRequest, formula};
/// // G(jω)/(H(jω)H(−jω)): white noise N through an oscillator; ω² in G is written −s^2
/// let text = |t: &str| Some(t.to_owned());
/// let request = FormulaRequest { h: text("m*s^2 + r*s + c"), g: text("N"), name: text("x2"), ..FormulaRequest::default() };
/// let derived = formula(&request.derivation()?, &request.simplifier()?)?;
/// assert_eq!(derived.formula.text(), "x2 = N / (2 r c)");
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn formula(derivation: &Derivation, simplifier: &Simplifier) -> Result<Derived> {
    let mut expressions = derivation.source.expressions();
    expressions.push(&derivation.times);
    let desk = Desk::new(simplifier, &expressions)?;
    let prepared = derivation.source.prepare(&desk.alphabet)?;
    let factors = desk.known.iter().map(Known::polynomial);
    let integral =
        prepared.integral(factors).map_err(|e| verify::true_reason(&derivation.source, simplifier, e))?;
    let mean = integral.times(&desk.alphabet.fraction(&derivation.times)?)?;
    let expression = desk.write(&mean)?;
    let points = verify::check(&derivation.source, &derivation.times, &simplifier.relations, &expression)?;
    let formula = Formula { name: derivation.name.clone(), by: Vec::new(), expression };
    Ok(Derived { formula, order: prepared.b.len(), points })
}
