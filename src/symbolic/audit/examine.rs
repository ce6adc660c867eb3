//! The checks of one formula.

use super::compare::{Equality, Place, constant_ratio, differences, equality, in_words};
use super::limit::{Question, judge};
use super::request::{AuditRequest, ExampleEntry, FormulaEntry, IdentityEntry, LimitEntry};
use super::{Check, CheckKind, Examined};
use crate::expression::{Expr, Scope};
use crate::symbolic::formula::leading_minus;
use crate::symbolic::{
    Formula, Relation, Simplifier, Values, completed, formula, known_letter, symbols, value,
};
use crate::units::Unit;
use crate::{Error, Result};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// A printed formula: an expression, or both sides of an equation.
struct Printed {
    left: Option<Expr>,
    right: Expr,
}

impl Printed {
    fn read(text: &str) -> Result<Self> {
        match text.split_once('=') {
            Some((left, right)) => Ok(Self { left: Some(Expr::parse(left)?), right: Expr::parse(right)? }),
            None => Ok(Self { left: None, right: Expr::parse(text)? }),
        }
    }

    /// One expression: the left side less the right one.
    fn whole(&self) -> Expr {
        match &self.left {
            Some(left) => match leading_minus(&self.right) {
                Some(positive) => left.clone() + positive,
                None => left.clone() - self.right.clone(),
            },
            None => self.right.clone(),
        }
    }

    fn text(&self) -> String {
        let right = Formula { name: String::new(), by: Vec::new(), expression: self.right.clone() }.text();
        let right = right.trim_start_matches([' ', '=']);
        match &self.left {
            Some(left) => format!("{} = {right}", shown(left)),
            None => right.to_owned(),
        }
    }
}

fn shown(expression: &Expr) -> String {
    let formula = Formula { name: String::new(), by: Vec::new(), expression: expression.clone() };
    formula.text().trim_start_matches([' ', '=']).to_owned()
}

/// What all checks of one formula need.
struct Bench<'a> {
    printed: Printed,
    right: Option<Printed>,
    simplifier: Simplifier,
    units: BTreeMap<&'a str, Unit>,
}

/// Examines one formula.
pub fn examine(request: &AuditRequest, entry: &FormulaEntry) -> Result<Examined> {
    let bench = Bench::new(request, entry).map_err(|e| within(&entry.name, &e))?;
    let mut checks = Vec::new();
    if !bench.units.is_empty() {
        checks.push(bench.dimensions(entry)?);
    }
    checks.extend(bench.value()?);
    for limit in &entry.limits {
        checks.push(bench.limit(limit).map_err(|e| within(&entry.name, &e))?);
    }
    for identity in &entry.identities {
        checks.push(bench.identity(identity)?);
    }
    for example in &entry.examples {
        checks.push(bench.example(example).map_err(|e| within(&entry.name, &e))?);
    }
    Ok(Examined {
        name: entry.name.clone(),
        message: entry.message.clone(),
        printed: bench.printed.text(),
        right: bench.right.as_ref().map(Printed::text),
        checks,
    })
}

fn within(name: &str, e: &Error) -> Error {
    Error::new(e.kind(), format!("formula {name}: {e}"))
}

impl<'a> Bench<'a> {
    fn new(request: &'a AuditRequest, entry: &'a FormulaEntry) -> Result<Self> {
        let mut units = BTreeMap::new();
        for (name, unit) in request.units.iter().chain(&entry.units) {
            units.insert(name.as_str(), Unit::parse(unit)?);
        }
        let relations =
            request.relations.iter().map(|text| Relation::parse(text)).collect::<Result<Vec<_>>>()?;
        let mut simplifier = Simplifier { relations, ..Simplifier::default() };
        let right = match (&entry.right, &entry.derive) {
            (Some(_), Some(_)) => {
                return Err(Error::bad_input("both 'right' and 'derive' are given; one is enough"));
            }
            (Some(text), None) => Some(Printed::read(text)?),
            (None, Some(derive)) => {
                let own = derive.simplifier()?;
                simplifier.relations.extend(own.relations);
                simplifier.keep = own.keep;
                simplifier.order = own.order;
                let derived = formula(&derive.derivation()?, &simplifier)?;
                Some(Printed { left: None, right: derived.formula.expression })
            }
            (None, None) => None,
        };
        Ok(Self { printed: Printed::read(&entry.printed)?, right, simplifier, units })
    }

    /// The letters of the formulas and of the relations between them, and those that have a unit.
    fn letters<'b>(&'b self, more: impl IntoIterator<Item = &'b Expr>) -> BTreeSet<String> {
        let sides = self.simplifier.relations.iter().flat_map(|relation| [&relation.left, &relation.right]);
        let printed = self.right.iter().chain([&self.printed]).flat_map(|p| p.left.iter().chain([&p.right]));
        let units = self.units.keys().copied();
        sides.chain(printed).chain(more).flat_map(symbols).chain(units).map(String::from).collect()
    }

    fn dimensions(&self, entry: &FormulaEntry) -> Result<Check> {
        let scope: Scope =
            self.units.iter().map(|(name, unit)| ((*name).to_owned(), unit.dimension())).collect();
        let whole = self.printed.whole();
        let wrong = match &entry.unit {
            Some(unit) => {
                let wanted = Unit::parse(unit)?.dimension();
                whole.expect_dimension(wanted, &scope, &whole.to_string()).err()
            }
            None => whole.dimension(&scope).err(),
        };
        Ok(Check {
            kind: CheckKind::Dimensions,
            holds: wrong.is_none(),
            message: wrong.map_or_else(|| "every term has the right dimension".into(), |e| e.to_string()),
            ratio: None,
        })
    }

    fn value(&self) -> Result<Option<Check>> {
        let Some(right) = &self.right else { return Ok(None) };
        let (printed, wanted) = (self.printed.whole(), right.whole());
        let equations = self.printed.left.is_some() && right.left.is_some();
        let equal = equality(&printed, &wanted, &self.simplifier);
        let ratio = constant_ratio(&printed, &wanted, &self.simplifier.relations)?;
        let message = match equal {
            Equality::Always => Some("equal to the right formula"),
            Equality::Positive => Some("equal to the right formula while all symbols are positive"),
            Equality::Never if equations && ratio.is_some() => Some("equal to the right equation"),
            Equality::Never => None,
        };
        if let Some(text) = message {
            let message = text.to_owned();
            return Ok(Some(Check { kind: CheckKind::Value, holds: true, message, ratio: Some(1.0) }));
        }
        let message = match ratio {
            Some(ratio) => format!("off by a constant: right/printed = {}", in_words(ratio)),
            None => places(&self.differences(right)),
        };
        Ok(Some(Check { kind: CheckKind::Value, holds: false, message, ratio }))
    }

    /// Equations are compared side by side.
    fn differences(&self, right: &Printed) -> Vec<Place> {
        let sides = |x: &Expr, y: &Expr| differences(x, y, &self.simplifier);
        match (&self.printed.left, &right.left) {
            (Some(x), Some(y)) => [sides(x, y), sides(&self.printed.right, &right.right)].concat(),
            _ => sides(&self.printed.whole(), &right.whole()),
        }
    }

    fn limit(&self, limit: &LimitEntry) -> Result<Check> {
        let (printed, becomes) = (self.printed.whole(), Expr::parse(&limit.becomes)?);
        known_letter(&limit.symbol, &self.letters([&becomes]))?;
        let mut relations = self.simplifier.relations.clone();
        for text in &limit.given {
            relations.push(Relation::parse(text)?);
        }
        let name = format!("{} → {}", limit.symbol, limit.to);
        let about = if limit.message.is_empty() { name } else { format!("{name} ({})", limit.message) };
        let question = Question { printed: &printed, becomes: &becomes, symbol: &limit.symbol, to: limit.to };
        judge(&question, &relations, &about, &shown(&becomes))
    }

    fn identity(&self, identity: &IdentityEntry) -> Result<Check> {
        let zero = Expr::parse(&identity.zero)?.substitute("printed", &self.printed.whole());
        let rest = self.simplifier.simplify(&zero)?;
        let holds = rest == Expr::Number(0.0);
        let message = match (holds, identity.message.as_str()) {
            (true, "") => "holds".into(),
            (true, about) => format!("holds: {about}"),
            (false, "") => format!("broken: {} is left where 0 must be", shown(&rest)),
            (false, about) => format!("broken ({about}): {} is left where 0 must be", shown(&rest)),
        };
        Ok(Check { kind: CheckKind::Identity, holds, message, ratio: None })
    }

    fn example(&self, example: &ExampleEntry) -> Result<Check> {
        let unit = Unit::parse(&example.unit)?;
        let printed = example.result.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
            Error::bad_input(format!("the result '{}' of an example is no number", example.result))
        })?;
        let mut values = Values::new();
        let letters = self.letters([]);
        for (name, number) in &example.values {
            known_letter(name, &letters)?;
            if !number.is_finite() {
                return Err(Error::bad_input(format!("the value of {name} in an example is not finite")));
            }
            let si = self.units.get(name.as_str()).map_or(*number, |unit| unit.to_si(*number));
            values.insert(name.clone(), si);
        }
        let values = completed(&values, &self.simplifier.relations)?;
        let of = |name: &str| values.get(name).copied();
        let own = unit.from_si(value(&self.printed.right, &of)?);
        let tolerance = half_last_digit(&example.result);
        let holds = (own - printed).abs() <= tolerance;
        let about = if example.message.is_empty() { String::new() } else { format!("{}: ", example.message) };
        let mut message = format!(
            "{about}the printed formula gives {own:.4e} {}, {} is printed",
            unit.text(),
            example.result
        );
        if let Some(right) = &self.right {
            let right = unit.from_si(value(&right.right, &of)?);
            let _ = write!(message, "; the right formula gives {right:.4e}");
        }
        let decades = (own / printed).abs().log10();
        if decades.abs() > 1.5 {
            let _ = write!(
                message,
                "; that is some 10^{decades:.0} times as much: check the units of the numbers"
            );
        }
        Ok(Check { kind: CheckKind::Example, holds, message, ratio: (!holds).then_some(own / printed) })
    }
}

/// Half a unit of the last printed digit.
fn half_last_digit(text: &str) -> f64 {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    0.5000001 * 10f64.powi(exponent.parse().unwrap_or(0) - decimals as i32)
}

fn places(places: &[Place]) -> String {
    let say = |place: &Place| match place {
        (Some(printed), Some(right)) => format!("printed {}, must be {}", shown(printed), shown(right)),
        (Some(printed), None) => format!("{} does not belong there", shown(printed)),
        (None, Some(right)) => format!("{} is missing", shown(right)),
        (None, None) => String::new(),
    };
    places.iter().map(say).collect::<Vec<_>>().join("; ")
}
