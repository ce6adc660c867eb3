//! What data determine of parameters that they cannot hold apart.
//!
//! # Purpose
//! Say "Ke + R*b/Ke = 0.05477 V*s/rad" where Ke and b alone are not known.
//!
//! # Method
//! Points that the data allow lie along the valley. Simple forms, a product of powers of the parameters or
//! a sum of two products of two of them, are tried in the order of their length; the first that stays the
//! same all along, within what the noise allows, is what is determined. A factor that equals a fixed
//! parameter of the right dimension gets its name.
//!
//! # Numerical aspects
//! The interval is that of the linear form at the minimum, weak directions left out, widened to what the
//! form takes along the valley.

use super::valley::{Directions, Valley};
use crate::estimate::triangle::Triangle;
use crate::model::{Model, Parameter};
use crate::units::{Unit, digits_within, significant};

/// What is determined; SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Combination {
    /// The expression; a bare number in it is in the units of the model file.
    pub expression: String,
    /// The parameters in it that the fit moves.
    pub names: Vec<String>,
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
    pub unit: Unit,
}

impl Combination {
    /// "Ke + R*b/Ke = 0.05477 V*s (0.05475 to 0.05479)"
    pub fn words(&self) -> String {
        let [value, low, high] = [self.value, self.low, self.high].map(|x| self.unit.difference_from_si(x));
        let shown = |x: f64| significant(x, digits_within(value, high - low));
        let unit = if self.unit.text() == "1" { String::new() } else { format!(" {}", self.unit.text()) };
        format!("{} = {}{unit} ({} to {})", self.expression, shown(value), shown(low), shown(high))
    }
}

/// Exponents of a product of powers.
const EXPONENTS: [f64; 6] = [1.0, -1.0, 2.0, -2.0, 0.5, -0.5];
/// Exponents in a sum of two products.
const IN_SUMS: [f64; 4] = [1.0, 0.0, -1.0, 2.0];
/// A factor this near to a fixed parameter, relatively, is that parameter.
const SAME: f64 = 5e-3;
/// Widest interval that still counts as determined, as a share of the value.
const WIDE: f64 = 0.5;
/// Share of the allowed scatter that a form may show along the valley.
const STEADY: f64 = 2.0;
/// How far, as a share, a parameter must go along the valley for a form to be tried on it.
const GOES: f64 = 0.02;

/// A product of powers of unknowns.
type Monomial = Vec<(usize, f64)>;

/// m₁ + k·m₂, or m₁ alone.
struct Form {
    first: Monomial,
    second: Option<(f64, Monomial)>,
}

/// The valley and what lies in it.
pub struct Search<'a> {
    /// The model with the fitted values.
    pub model: &'a Model,
    /// Numbers of the free parameters: the first unknowns.
    pub free: &'a [usize],
    /// The minimum and its surroundings.
    pub valley: &'a Valley<'a>,
    pub directions: &'a Directions,
    /// Points that the data allow.
    pub points: &'a [Vec<f64>],
}

impl Search<'_> {
    /// All that is determined of some parameters that trade; each combination brings one that the others
    /// did not link yet.
    pub fn run(&self, trading: &[usize]) -> Vec<Combination> {
        let mut found = Vec::new();
        if let Some(form) = self.product_of_all(trading) {
            return self.told(&form).into_iter().collect();
        }
        let mut linked: Vec<Vec<usize>> = trading.iter().map(|j| vec![*j]).collect();
        for length in 0..2 {
            for (i, a) in trading.iter().enumerate() {
                for b in &trading[i + 1..] {
                    let group = |j: usize| linked.iter().position(|g| g.contains(&j));
                    let (Some(one), Some(other)) = (group(*a), group(*b)) else { continue };
                    let form = if length == 0 { self.product(*a, *b) } else { self.sum(*a, *b) };
                    let Some(told) = form.filter(|_| one != other).and_then(|f| self.told(&f)) else {
                        continue;
                    };
                    found.push(told);
                    let moved = linked.remove(one.max(other));
                    linked[one.min(other)].extend(moved);
                }
            }
        }
        found
    }

    /// A product of powers of three parameters or more, where one alone stays the same.
    fn product_of_all(&self, trading: &[usize]) -> Option<Form> {
        let positive = self.points.iter().all(|p| trading.iter().all(|j| p[*j] > 0.0));
        if trading.len() < 3 || !positive || self.points.len() <= trading.len() {
            return None;
        }
        let mut triangle = Triangle::new(trading.len());
        let column = |j: &usize| -> Vec<f64> {
            self.points.iter().map(|p| (p[*j] / self.valley.x[*j]).ln()).collect()
        };
        let columns: Vec<Vec<f64>> = trading.iter().map(column).collect();
        let views: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        triangle.push(&views, &vec![0.0; self.points.len()]);
        let svd = triangle.factor().thin_svd().ok()?;
        let last = trading.len() - 1;
        let weights: Vec<f64> = (0..trading.len()).map(|i| svd.V()[(i, last)]).collect();
        let lead = weights.iter().fold(0.0, |m: f64, w| if w.abs() > m.abs() { *w } else { m });
        let round = |w: &f64| (2.0 * w / lead).round() / 2.0;
        let first: Monomial = trading.iter().zip(weights.iter().map(round)).map(|(j, w)| (*j, w)).collect();
        let form = Form { first, second: None };
        (form.first.iter().all(|(_, w)| *w != 0.0) && self.is_steady(&form)).then_some(form)
    }

    fn product(&self, a: usize, b: usize) -> Option<Form> {
        let forms = EXPONENTS.iter().map(|w| Form { first: vec![(a, 1.0), (b, *w)], second: None });
        forms.into_iter().find(|f| self.is_steady(f))
    }

    fn sum(&self, a: usize, b: usize) -> Option<Form> {
        let monomials: Vec<Monomial> = IN_SUMS
            .iter()
            .flat_map(|p| IN_SUMS.iter().map(move |q| (*p, *q)))
            .filter(|e| *e != (0.0, 0.0))
            .map(|(p, q)| vec![(a, p), (b, q)])
            .collect();
        let length = |m: &Monomial| m.iter().map(|(_, w)| if *w < 0.0 { 1.5 } else { w.abs() }).sum::<f64>();
        let mut pairs: Vec<(&Monomial, &Monomial)> = Vec::new();
        for m in &monomials {
            // no powers of one and the same product
            let both = |n: &&Monomial| m[0].1 * n[1].1 != m[1].1 * n[0].1;
            pairs.extend(monomials.iter().filter(both).map(|n| (m, n)));
        }
        pairs.sort_by(|x, y| (length(x.0) + length(x.1)).total_cmp(&(length(y.0) + length(y.1))));
        pairs.into_iter().find_map(|(m, n)| {
            let k = self.factor(m, n)?;
            let form = Form { first: m.clone(), second: Some((k, n.clone())) };
            self.is_steady(&form).then_some(form)
        })
    }

    /// The k for which m + k·n changes least along the valley.
    fn factor(&self, m: &Monomial, n: &Monomial) -> Option<f64> {
        let count = self.points.len() as f64;
        let mean = |of: &Monomial| self.points.iter().map(|p| value(of, p)).sum::<f64>() / count;
        let (mm, nm) = (mean(m), mean(n));
        let together = |a: &Monomial, am: f64| -> f64 {
            self.points.iter().map(|p| (value(a, p) - am) * (value(n, p) - nm)).sum()
        };
        let k = -together(m, mm) / together(n, nm);
        (k.is_finite() && k != 0.0).then_some(k)
    }

    /// Whether a form stays the same along the valley while its parameters do not.
    fn is_steady(&self, form: &Form) -> bool {
        let spread = |of: &dyn Fn(&[f64]) -> f64| {
            let values = self.points.iter().map(|p| of(p));
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |r, v| (r.0.min(v), r.1.max(v)));
            if low.is_finite() && high.is_finite() { high - low } else { f64::INFINITY }
        };
        let moves = |(j, _): &(usize, f64)| {
            let most = self.points.iter().fold(0.0, |m: f64, p| m.max(p[*j].abs()));
            spread(&|p| p[*j]) > GOES * most
        };
        let center = form.value(self.valley.x);
        let allowed = STEADY * 2.0 * self.half(form) + 1e-6 * center.abs();
        center.is_finite() && form.first.iter().all(moves) && spread(&|p| form.value(p)) <= allowed
    }

    /// Half the interval that the linear form about the minimum gives.
    fn half(&self, form: &Form) -> f64 {
        let x = self.valley.x;
        let slope = |j: usize| {
            let norm = self.directions.scale[j] * self.valley.noise.sqrt();
            let h = 1e-6 * if x[j] == 0.0 { norm } else { x[j].abs() };
            let at = |d: f64| {
                let mut moved = x.to_vec();
                moved[j] += d;
                form.value(&moved)
            };
            (at(h) - at(-h)) / (2.0 * h)
        };
        let moved: Vec<usize> =
            form.first.iter().chain(form.second.iter().flat_map(|s| &s.1)).map(|m| m.0).collect();
        let gradient: Vec<f64> =
            (0..x.len()).map(|j| if moved.contains(&j) { slope(j) } else { 0.0 }).collect();
        self.valley.reach * (self.valley.noise * self.directions.variance_of(&gradient)).sqrt()
    }

    fn told(&self, form: &Form) -> Option<Combination> {
        let value = form.value(self.valley.x);
        let half = self.half(form);
        let along = self.points.iter().map(|p| form.value(p));
        let (low, high) = along.fold((value - half, value + half), |r, v| (r.0.min(v), r.1.max(v)));
        let first = self.unit(&form.first);
        let mut expression = self.text(&form.first);
        if let Some((k, second)) = &form.second {
            expression += &self.second(*k, second, &first);
        }
        let mut names: Vec<usize> = form.first.iter().map(|m| m.0).collect();
        names.extend(form.second.iter().flat_map(|s| s.1.iter().map(|m| m.0)));
        names.sort_unstable();
        names.dedup();
        let names = names.iter().map(|j| self.parameter(*j).name.clone()).collect();
        (high - low <= WIDE * value.abs()).then_some(Combination {
            expression,
            names,
            value,
            low,
            high,
            unit: first,
        })
    }

    fn parameter(&self, j: usize) -> &Parameter {
        &self.model.parameters[self.free[j]]
    }

    fn unit(&self, m: &Monomial) -> Unit {
        let of = |(j, w): &(usize, f64)| self.parameter(*j).unit.of_differences().power(*w);
        let used = m.iter().filter(|(_, w)| *w != 0.0).map(of);
        used.reduce(|a, b| a.times(&b)).unwrap_or_else(Unit::one)
    }

    /// " + k*m", with the name of a fixed parameter for k where one has its value and dimension.
    fn second(&self, k: f64, m: &Monomial, whole: &Unit) -> String {
        let unit = whole.over(&self.unit(m));
        let same = |p: &&Parameter| {
            !p.fit
                && p.unit.dimension() == unit.dimension()
                && (k.abs() - p.value).abs() <= SAME * p.value.abs()
        };
        let inverse = |p: &&Parameter| {
            let turned = Unit::one().over(&p.unit);
            !p.fit && turned.dimension() == unit.dimension() && (k.abs() * p.value - 1.0).abs() <= SAME
        };
        let (sign, text) = (if k < 0.0 { " - " } else { " + " }, self.text(m));
        let fixed = &self.model.parameters;
        if let Some(p) = fixed.iter().find(same) {
            return format!("{sign}{}*{text}", p.name);
        }
        if let Some(p) = fixed.iter().find(inverse) {
            return format!("{sign}{text}/{}", p.name);
        }
        if unit.dimension().is_none() && (k.abs() - 1.0).abs() <= SAME {
            return format!("{sign}{text}");
        }
        format!("{sign}{}*{text}", significant(unit.difference_from_si(k.abs()), 4))
    }

    /// A product as an expression: what stands above the line first.
    fn text(&self, m: &Monomial) -> String {
        let power = |(j, w): &(usize, f64)| {
            let name = &self.parameter(*j).name;
            if w.abs() == 1.0 { name.clone() } else { format!("{name}^{}", w.abs()) }
        };
        let above: Vec<String> = m.iter().filter(|(_, w)| *w > 0.0).map(power).collect();
        let below: Vec<String> = m.iter().filter(|(_, w)| *w < 0.0).map(power).collect();
        let top = if above.is_empty() { "1".to_string() } else { above.join("*") };
        match below.len() {
            0 => top,
            1 => format!("{top}/{}", below[0]),
            _ => format!("{top}/({})", below.join("*")),
        }
    }
}

impl Form {
    fn value(&self, x: &[f64]) -> f64 {
        value(&self.first, x) + self.second.as_ref().map_or(0.0, |(k, m)| k * value(m, x))
    }
}

fn value(m: &Monomial, x: &[f64]) -> f64 {
    m.iter().filter(|(_, w)| *w != 0.0).map(|(j, w)| x[*j].powf(*w)).product()
}
