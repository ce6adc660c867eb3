//! The terms of a sum as products of factors: where a law stands in a model.

use crate::expression::{BinaryOp, Expr};

/// Passes every term of the sums in an expression, and the sums themselves, through `with`: what stands between + and −,
/// however deep under quotients and products.
pub(super) fn rewritten(e: &Expr, with: &dyn Fn(&Expr) -> Option<Expr>) -> Expr {
    let again = |x: &Expr| Box::new(rewritten(x, with));
    let under = |x: &Expr| if matches!(x, Expr::Name(_)) { Box::new(x.clone()) } else { again(x) };
    match e {
        Expr::Neg(a) => Expr::Neg(again(a)),
        term => match (with(term), term) {
            (Some(new), _) => new,
            (None, Expr::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b)) => {
                Expr::Binary(*op, again(a), again(b))
            }
            (None, Expr::Binary(op @ (BinaryOp::Mul | BinaryOp::Div), a, b)) => {
                Expr::Binary(*op, under(a), under(b))
            }
            _ => term.clone(),
        },
    }
}

/// The factors of a product, without those that it is divided by.
pub(super) fn factors(term: &Expr) -> Vec<&Expr> {
    match term {
        Expr::Neg(a) | Expr::Binary(BinaryOp::Div, a, _) => factors(a),
        Expr::Binary(BinaryOp::Mul, a, b) => [factors(a), factors(b)].concat(),
        other => vec![other],
    }
}

/// Whether a product has a name as one of its factors.
pub(super) fn has_factor(term: &Expr, name: &str) -> bool {
    factors(term).iter().any(|f| matches!(f, Expr::Name(n) if n == name))
}

/// A product with one of its factors replaced, the first that equals it.
pub(crate) fn with_factor(term: &Expr, factor: &Expr, new: &Expr) -> Expr {
    if term == factor {
        return new.clone();
    }
    match term {
        Expr::Neg(a) => Expr::Neg(Box::new(with_factor(a, factor, new))),
        Expr::Binary(BinaryOp::Mul, a, b) => {
            let first = with_factor(a, factor, new);
            let second = if first == **a { with_factor(b, factor, new) } else { (**b).clone() };
            Expr::Binary(BinaryOp::Mul, Box::new(first), Box::new(second))
        }
        Expr::Binary(BinaryOp::Div, a, b) => {
            Expr::Binary(BinaryOp::Div, Box::new(with_factor(a, factor, new)), b.clone())
        }
        other => other.clone(),
    }
}

/// A product without one of its factors, a name; none where that is all there is.
pub(crate) fn without_factor(term: &Expr, name: &str) -> Option<Expr> {
    let is_it = |e: &Expr| matches!(e, Expr::Name(n) if n == name);
    match term {
        Expr::Neg(a) => Some(Expr::Neg(Box::new(without_factor(a, name)?))),
        Expr::Binary(BinaryOp::Mul, a, b) if is_it(a) => Some((**b).clone()),
        Expr::Binary(BinaryOp::Mul, a, b) if matches!(&**a, Expr::Neg(x) if is_it(x)) => {
            Some(Expr::Neg(b.clone()))
        }
        Expr::Binary(BinaryOp::Mul, a, b) if is_it(b) => Some((**a).clone()),
        Expr::Binary(BinaryOp::Mul, a, b) => {
            let of = |a: Expr, b: Expr| Expr::Binary(BinaryOp::Mul, Box::new(a), Box::new(b));
            match without_factor(a, name) {
                Some(left) => Some(of(left, (**b).clone())),
                None => Some(of((**a).clone(), without_factor(b, name)?)),
            }
        }
        Expr::Binary(BinaryOp::Div, a, b) => {
            let left = if is_it(a) { Expr::Number(1.0) } else { without_factor(a, name)? };
            Some(Expr::Binary(BinaryOp::Div, Box::new(left), b.clone()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn e(text: &str) -> Expr {
        Expr::parse(text).unwrap()
    }

    #[test]
    fn a_law_is_replaced_in_its_terms_alone() {
        let new = e("S/(1 + a*S)");
        let with = |t: &Expr| {
            (has_factor(t, "mu") && has_factor(t, "S")).then(|| with_factor(t, &Expr::name("S"), &new))
        };
        let of = |text: &str| rewritten(&e(text), &with).to_string();
        assert_eq!(of("D*(Sin - S) - mu*S*X/Y"), "D*(Sin - S) - mu*(S/(1 + a*S))*X/Y");
        assert_eq!(of("(u - mu*S)/M"), "(u - mu*(S/(1 + a*S)))/M");
        assert_eq!(of("mu*(S - X)"), "mu*(S - X)");
        assert_eq!(of("S*k/mu"), "S*k/mu");
    }

    #[test]
    fn a_factor_is_taken_out_of_a_product() {
        let of = |text: &str| without_factor(&e(text), "c").map(|e| e.to_string());
        assert_eq!(of("c*(a - b)").as_deref(), Some("a - b"));
        assert_eq!(of("-c*(a - b)/m").as_deref(), Some("-(a - b)/m"));
        assert_eq!(of("c/m*(a - b)").as_deref(), Some("1/m*(a - b)"));
        assert_eq!(of("2*(a - b)*c").as_deref(), Some("2*(a - b)"));
        assert_eq!((of("c"), of("k*(c - b)"), of("k/c")), (None, None, None));
    }
}
