//! A model with its differences gathered: `u/tau - x/tau` is written `(u - x)/tau`, so that a law of the difference is
//! found however its author multiplied it out.

use super::catalogue::{edit, terms};
use crate::expression::{BinaryOp, Expr};
use crate::model::Model;

/// The model with k·a − k·b as k·(a − b) in all rates and definitions, where k is a product of parameters and a and b are
/// names of one unit.
pub fn gathered(model: &Model) -> Model {
    let mut new = model.clone();
    edit::for_each(&mut new, |_, e| *e = in_sums(model, e));
    new
}

/// An expression with the differences in each of its sums gathered.
fn in_sums(model: &Model, e: &Expr) -> Expr {
    let mut terms = Vec::new();
    signed(e, true, &mut terms);
    let Some((i, j, gathered)) = pair(model, &terms) else {
        return e.map_children(&mut |child| in_sums(model, child));
    };
    terms[i].1 = gathered;
    // what is added stands first: the difference at least is
    terms.remove(j);
    let first = terms.iter().position(|t| t.0).unwrap_or(0);
    let (_, start) = terms.remove(first);
    let joined = |sum: Expr, (is_added, term): (bool, Expr)| {
        let join = if is_added { edit::plus } else { edit::minus };
        join(&sum, &term)
    };
    in_sums(model, &terms.into_iter().fold(start, joined))
}

/// The terms of a sum, each with whether it is added.
fn signed(e: &Expr, plus: bool, terms: &mut Vec<(bool, Expr)>) {
    match e {
        Expr::Binary(BinaryOp::Add, a, b) => {
            signed(a, plus, terms);
            signed(b, plus, terms);
        }
        Expr::Binary(BinaryOp::Sub, a, b) => {
            signed(a, plus, terms);
            signed(b, !plus, terms);
        }
        Expr::Neg(a) => signed(a, !plus, terms),
        term => match edit::leading_minus(term) {
            Some(positive) => terms.push((!plus, positive)),
            None => terms.push((plus, term.clone())),
        },
    }
}

/// The first added and the first subtracted term that share all but a name, and their difference.
fn pair(model: &Model, terms: &[(bool, Expr)]) -> Option<(usize, usize, Expr)> {
    let numbered = |sign: bool| terms.iter().enumerate().filter(move |(_, t)| t.0 == sign);
    numbered(true)
        .flat_map(|(i, a)| numbered(false).map(move |(j, b)| (i, j, &a.1, &b.1)))
        .find_map(|(i, j, a, b)| Some((i, j, difference(model, a, b)?)))
}

/// k·(a − b) of k·a and k·b.
fn difference(model: &Model, left: &Expr, right: &Expr) -> Option<Expr> {
    let (ones, others) = (ends(model, left), ends(model, right));
    let pairs = ones.iter().flat_map(|a| others.iter().map(move |b| (*a, *b)));
    let alike = |(a, b): &(&str, &str)| {
        let unit = |n: &str| edit::unit_of_name(model, n).map(|u| u.dimension());
        let differ = a != b && !(is_parameter(model, a) && is_parameter(model, b));
        let rest = terms::without_factor(left, a);
        differ && unit(a) == unit(b) && rest.is_some() && rest == terms::without_factor(right, b)
    };
    let (a, b) = pairs.into_iter().find(alike)?;
    let both = Expr::Binary(BinaryOp::Sub, Box::new(Expr::name(a)), Box::new(Expr::name(b)));
    Some(terms::with_factor(left, &Expr::name(a), &both))
}

fn is_parameter(model: &Model, name: &str) -> bool {
    model.parameters.iter().any(|p| p.name == name)
}

/// The names that a difference with a term may be of: its only signal; of a product of parameters, each.
fn ends<'e>(model: &Model, term: &'e Expr) -> Vec<&'e str> {
    let (constants, signals): (Vec<&str>, Vec<&str>) =
        term.names().into_iter().partition(|n| is_parameter(model, n));
    match signals.len() {
        0 => constants,
        1 => signals,
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rate of x as it is gathered.
    fn of(rate: &str) -> String {
        let model = Model::parse(&format!(
            "name = \"a\"\n[inputs]\nu = {{ unit = \"K\" }}\nw = {{ unit = \"K\" }}\n[parameters]\nk = {{ value = 1, unit = \"s^-1\" }}\n\
             c = {{ value = 1, unit = \"K\" }}\n\
             T = {{ value = 2, unit = \"s\" }}\n[states]\nx = {{ rate = \"{rate}\", unit = \"K\", initial = 0 }}\n\
             [outputs]\ny = {{ equals = \"x\", unit = \"K\" }}\n"
        ));
        gathered(&model.unwrap()).states[0].rate.to_string()
    }

    #[test]
    fn differences_are_gathered() {
        assert_eq!(of("u/T - x/T"), "(u - x)/T");
        assert_eq!(of("-x/T + u/T"), "(u - x)/T");
        assert_eq!(of("k*w + u/T - x/T"), "k*w + (u - x)/T");
        assert_eq!(of("k*u - k*x + w/T - x/T"), "k*(u - x) + (w - x)/T");
        assert_eq!(of("(k*u - k*x)*T/T"), "k*(u - x)*T/T");
        assert_eq!(of("k*c - k*x"), "k*(c - x)");
    }

    #[test]
    fn nothing_else_is() {
        for rate in ["u/T - k*x", "(u - x)/T", "k*u + k*x", "w/T - abs(x)/T", "2*u/T - x/T"] {
            let model = of(rate);
            assert_eq!(model, Expr::parse(rate).unwrap().to_string());
        }
    }
}
