//! Temperatures in degC that are differences: a difference has no zero, and 273.15 K would be taken off it.

use super::Model;
use crate::expression::{BinaryOp, Expr};
use crate::units::Unit;
use std::collections::{HashMap, HashSet};

/// How many times a sum holds the zero of the scale of degC: T once, T − T₀ not at all.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Zeros {
    Times(f64),
    /// Some times, by a factor that is no number.
    Some,
}

impl Zeros {
    fn plus(self, other: Self) -> Option<Self> {
        match (self, other) {
            // shares such as 0.7, 0.2 and 0.1 make 1 but for rounding
            (Self::Times(a), Self::Times(b)) if (a + b).abs() < 1e-9 * a.abs() => Some(Self::Times(0.0)),
            (Self::Times(a), Self::Times(b)) => Some(Self::Times(a + b)),
            (Self::Some, Self::Times(0.0)) | (Self::Times(0.0), Self::Some) => Some(Self::Some),
            // two unknown factors may be one
            _ => None,
        }
    }

    fn by(self, factor: f64) -> Self {
        if let Self::Times(a) = self { Self::Times(a * factor) } else { self }
    }
}

fn has_zero(unit: &Unit) -> bool {
    unit.to_si(0.0) != 0.0
}

/// A model with the zeros of its definitions, each counted once however often it stands.
struct Counted<'a> {
    units: HashMap<&'a str, &'a Unit>,
    definitions: HashMap<&'a str, Option<Zeros>>,
    parameters: HashSet<&'a str>,
}

impl Model {
    /// What a user should know of what is given in degC and is a difference, or decays towards no other temperature.
    pub(super) fn kelvin_notes(&self) -> Vec<String> {
        let counted = Counted::of(self);
        let is_difference =
            |e: &Expr| counted.mentions_zero(e) && counted.zeros(e) == Some(Zeros::Times(0.0));
        let differs = self.outputs.iter().filter(|o| has_zero(&o.unit) && is_difference(&o.equals)).map(|o| {
            let (name, unit) = (&o.name, &o.unit);
            format!("`{name}` is a difference of temperatures, and {unit} takes 273.15 off it: give it the unit K")
        });
        let states = self.states.iter().filter(|s| has_zero(&s.unit));
        let falls = states.filter(|s| counted.zeros(&s.rate).is_some_and(|z| z != Zeros::Times(0.0)));
        let falls = falls.map(|s| {
            format!(
                "the rate of `{}` goes with a temperature in kelvins, against no other: where that is a difference, give it the unit K instead of {}",
                s.name, s.unit
            )
        });
        differs.chain(falls).collect()
    }
}

impl<'a> Counted<'a> {
    fn of(model: &'a Model) -> Self {
        let units = model.names().into_iter().map(|(name, _, unit)| (name, unit)).collect();
        let parameters = model.parameters.iter().map(|p| p.name.as_str()).collect();
        let mut counted = Self { units, definitions: HashMap::new(), parameters };
        for d in model.definition_order().unwrap_or_default() {
            let zeros = counted.zeros(&d.equals);
            counted.definitions.insert(&d.name, zeros);
        }
        counted
    }

    fn mentions_zero(&self, e: &Expr) -> bool {
        let mut found = false;
        e.visit(&mut |x| {
            if let Expr::Name(n) = x {
                found |= self.units.get(n.as_str()).is_some_and(|u| has_zero(u));
            }
        });
        found
    }

    /// `None` where that is not known.
    fn zeros(&self, e: &Expr) -> Option<Zeros> {
        let none = Zeros::Times(0.0);
        let of = |x: &Expr| self.zeros(x);
        match e {
            Expr::Number(_) => Some(none),
            Expr::Name(n) => self.zeros_of_name(n),
            Expr::Neg(a) => Some(of(a)?.by(-1.0)),
            Expr::Binary(BinaryOp::Add, a, b) => of(a)?.plus(of(b)?),
            Expr::Binary(BinaryOp::Sub, a, b) => of(a)?.plus(of(b)?.by(-1.0)),
            Expr::Binary(BinaryOp::Mul, a, b) => match (of(a)?, of(b)?) {
                (x, y) if y == none => self.scaled(x, b, false),
                (x, y) if x == none => self.scaled(y, a, false),
                _ => None,
            },
            Expr::Binary(BinaryOp::Div, a, b) if of(b)? == none => self.scaled(of(a)?, b, true),
            Expr::Binary(_, a, b) => (of(a)? == none && of(b)? == none).then_some(none),
            Expr::Call(_, all) => all.iter().all(|x| of(x) == Some(none)).then_some(none),
        }
    }

    /// What a factor or a divisor makes of it; `None` where a signal stands there, as in Peltier's law.
    fn scaled(&self, zeros: Zeros, by: &Expr, divides: bool) -> Option<Zeros> {
        let mut is_fixed = true;
        by.visit(&mut |x| {
            if let Expr::Name(n) = x {
                is_fixed &= self.parameters.contains(n.as_str());
            }
        });
        match (zeros, by) {
            (Zeros::Times(0.0), _) => Some(zeros),
            (_, Expr::Number(x)) => Some(zeros.by(if divides { 1.0 / x } else { *x })),
            _ => is_fixed.then_some(Zeros::Some),
        }
    }

    fn zeros_of_name(&self, name: &str) -> Option<Zeros> {
        // a definition is what it equals, in whatever unit
        if let Some(zeros) = self.definitions.get(name) {
            return *zeros;
        }
        let Some(unit) = self.units.get(name) else { return Some(Zeros::Times(0.0)) };
        if has_zero(unit) {
            return Some(Zeros::Times(1.0));
        }
        // kelvins may be either
        let is_temperature = Unit::parse("K").is_ok_and(|k| k.dimension() == unit.dimension());
        (!is_temperature).then_some(Zeros::Times(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_in_degc_is_told_and_a_temperature_is_not() {
        let of = |rate: &str, output: &str| {
            let text = format!(
                "name = \"room\"\n[inputs]\nTa = {{ unit = \"degC\" }}\nP = {{ unit = \"W\" }}\n[parameters]\n\
                 C = {{ value = 1, unit = \"kJ/K\" }}\nh = {{ value = 1, unit = \"W/K\" }}\n\
                 [definitions]\ndT = {{ equals = \"T - Ta\", unit = \"degC\" }}\n[states]\n\
                 T = {{ rate = \"{rate}\", unit = \"degC\", initial = 20 }}\n[outputs]\n\
                 y = {{ equals = \"{output}\", unit = \"degC\" }}\n"
            );
            Model::parse(&text).unwrap().kelvin_notes().len()
        };
        let good = "(P - h*(T - Ta))/C";
        for (rate, output, told) in [
            (good, "T", 0),
            (good, "0.3*T + 0.7*Ta", 0),
            (good, "T + P/h", 0),
            (good, "Ta + (T - Ta)*exp(-P*t/C/(T - Ta))", 0),
            (good, "T - Ta", 1),
            (good, "2*(T - Ta)", 1),
            (good, "T - 0.7*Ta - 0.2*Ta - 0.1*Ta", 1),
            ("(P - h*(0.7*Ta + 0.2*Ta + 0.1*Ta - T))/C", "T", 0),
            ("(P - h*dT)/C", "Ta + dT", 0),
            ("(P*T/(T - Ta) - h*(T - Ta))/C", "T", 0),
            ("(P*h*T/P - h*(T - Ta))/C", "T", 0),
            ("(P - h*T)/C", "T", 1),
            ("(P - h*T + h*Ta)/C", "T", 0),
        ] {
            assert_eq!(of(rate, output), told, "{rate}; {output}");
        }
    }

    /// 2⁶⁰ ways lead through these definitions.
    #[test]
    fn a_definition_is_counted_once_however_often_it_stands() {
        let mut text = String::from(
            "name = \"chain\"\n[inputs]\nu = { unit = \"degC\" }\n[definitions]\nd0 = { equals = \"u\", unit = \"degC\" }\n",
        );
        for i in 1..=60 {
            text += &format!("d{i} = {{ equals = \"0.5*d{0} + 0.5*d{0}\", unit = \"degC\" }}\n", i - 1);
        }
        text += "[outputs]\ny = { equals = \"d60 - u\", unit = \"degC\" }\n";
        assert_eq!(Model::parse(&text).unwrap().kelvin_notes().len(), 1);
    }
}
