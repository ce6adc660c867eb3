//! The greatest common divisor of polynomials in many symbols.
//!
//! Purpose: ratios without common factors.
//! Method: what an image modulo a prime shows to be free of a symbol is reduced to the coefficients of that symbol;
//! the rest goes by pseudo-division with primitive remainders in the symbol of least degree.
//! References: D. E. Knuth, The Art of Computer Programming 2, section 4.6.1, algorithm E.
//! Numerical aspects: exact. Meant for the sizes of formulas; a general factorisation is not attempted.

use super::integer::Integer;
use super::modular::common_degree_bound;
use super::polynomial::Polynomial;
use super::ring::Monomial;
use crate::Result;

/// The greatest common divisor, its first coefficient above 0; that of 0 and 0 is 0.
///
/// # Errors
/// Not computed, where a power grows beyond the packed form.
pub fn gcd(x: &Polynomial, y: &Polynomial) -> Result<Polynomial> {
    if x.is_zero() || y.is_zero() {
        let other = if x.is_zero() { y } else { x };
        return Ok(if other.content().is_negative() {
            other.scaled(&Integer::from(-1))
        } else {
            other.clone()
        });
    }
    let number = x.content().gcd(&y.content());
    let common = shared_monomial(x, y)?;
    let (x, y) = (without_monomial(&primitive(x)?)?, without_monomial(&primitive(y)?)?);
    primitive_gcd(&x, &y)?.times_term(common, &number)
}

/// The largest monomial that divides every term of both.
fn shared_monomial(x: &Polynomial, y: &Polynomial) -> Result<Monomial> {
    let (ring, p, q) = (x.ring(), x.common_monomial(), y.common_monomial());
    let powers = |k| ring.power(k, ring.exponent(p, k).min(ring.exponent(q, k)));
    (0..ring.names().len()).try_fold(Monomial::ONE, |product, k| ring.product(product, powers(k)?))
}

/// The polynomial without the powers of symbols that all its terms share.
fn without_monomial(x: &Polynomial) -> Result<Polynomial> {
    let common = Polynomial::term(x.ring(), x.common_monomial(), Integer::ONE);
    Ok(x.divided_by(&common)?.unwrap_or_else(|| x.clone()))
}

/// The polynomial without its numeric content, first coefficient above 0.
pub fn primitive(x: &Polynomial) -> Result<Polynomial> {
    let content = Polynomial::constant(x.ring(), x.content());
    Ok(x.divided_by(&content)?.unwrap_or_else(|| x.clone()))
}

fn primitive_gcd(x: &Polynomial, y: &Polynomial) -> Result<Polynomial> {
    let one = Polynomial::constant(x.ring(), 1);
    if x.as_constant().is_some() || y.as_constant().is_some() {
        return Ok(one);
    }
    if x.divided_by(y)?.is_some() {
        return Ok(y.clone());
    }
    if y.divided_by(x)?.is_some() {
        return Ok(x.clone());
    }
    let mut main: Option<(u32, usize)> = None;
    for symbol in 0..x.ring().names().len() {
        let degrees = (x.degree(symbol), y.degree(symbol));
        if degrees == (0, 0) {
            continue;
        }
        if common_degree_bound(x, y, symbol) == 0 {
            return gcd_free_of(symbol, x, y);
        }
        main = main.into_iter().chain([(degrees.0.min(degrees.1), symbol)]).min();
    }
    main.map_or(Ok(one), |(_, symbol)| by_remainders(symbol, x, y))
}

/// The divisor does not hold the symbol, so it divides all coefficients of its powers.
fn gcd_free_of(symbol: usize, x: &Polynomial, y: &Polynomial) -> Result<Polynomial> {
    let mut parts = x.coefficients(symbol)?;
    parts.extend(y.coefficients(symbol)?);
    parts.retain(|part| !part.is_zero());
    parts.sort_by_key(|part| part.terms().len());
    let mut common = primitive(&parts[0])?;
    for part in &parts[1..] {
        common = primitive_gcd(&common, &primitive(part)?)?;
        if common.as_constant().is_some() {
            break;
        }
    }
    Ok(common)
}

/// The common divisor of the coefficients of one symbol's powers.
pub fn content_in(symbol: usize, x: &Polynomial) -> Result<Polynomial> {
    gcd_free_of(symbol, x, &Polynomial::constant(x.ring(), 0))
}

fn by_remainders(symbol: usize, x: &Polynomial, y: &Polynomial) -> Result<Polynomial> {
    let (content_x, content_y) = (content_in(symbol, x)?, content_in(symbol, y)?);
    let common = primitive_gcd(&content_x, &content_y)?;
    let mut upper = x.divided_by(&content_x)?.expect("content divides");
    let mut lower = y.divided_by(&content_y)?.expect("content divides");
    if upper.degree(symbol) < lower.degree(symbol) {
        std::mem::swap(&mut upper, &mut lower);
    }
    while lower.degree(symbol) > 0 {
        let rest = remainder(symbol, &upper, &lower)?;
        upper = lower;
        if rest.is_zero() {
            return primitive(&common.times(&upper)?);
        }
        let rest = primitive(&rest)?;
        lower = rest.divided_by(&content_in(symbol, &rest)?)?.expect("content divides");
    }
    Ok(common)
}

/// The pseudo-remainder of the division in one symbol.
fn remainder(symbol: usize, x: &Polynomial, y: &Polynomial) -> Result<Polynomial> {
    let ring = x.ring();
    let divisor = y.coefficients(symbol)?;
    let (degree, lead) = (divisor.len() as u32 - 1, &divisor[divisor.len() - 1]);
    let mut rest = x.clone();
    while !rest.is_zero() && rest.degree(symbol) >= degree {
        let top = rest.coefficients(symbol)?.pop().expect("a coefficient");
        let shift = ring.power(symbol, rest.degree(symbol) - degree)?;
        let taken = y.times(&top)?.times_term(shift, &Integer::ONE)?;
        rest = rest.times(lead)?.minus(&taken);
    }
    Ok(rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Ring;

    #[test]
    fn a_common_factor_comes_out_of_random_products() {
        let ring = Ring::new(["x", "y", "z", "w"].map(String::from).to_vec()).unwrap();
        let v: Vec<_> = (0..4).map(|k| Polynomial::symbol(&ring, k).unwrap()).collect();
        let n = |k: i64| Polynomial::constant(&ring, k);
        let square = |p: &Polynomial| p.times(p).unwrap();
        // (x² + 3 y z − w), (x y − 2 z w² + 1), (x + y)(z − 5 w)
        let f = square(&v[0]).plus(&v[1].times(&v[2]).unwrap().scaled(&3.into())).minus(&v[3]);
        let g = v[0]
            .times(&v[1])
            .unwrap()
            .minus(&v[2].times(&square(&v[3])).unwrap().scaled(&2.into()))
            .plus(&n(1));
        let h = v[0].plus(&v[1]).times(&v[2].minus(&v[3].scaled(&5.into()))).unwrap();
        let x = f.times(&g).unwrap().times(&f).unwrap().scaled(&6.into());
        let y = f.times(&h).unwrap().scaled(&(-4).into());
        assert_eq!(gcd(&x, &y).unwrap(), f.scaled(&2.into()));
        assert_eq!(gcd(&g, &h).unwrap(), n(1));
        assert_eq!(gcd(&x.times(&h).unwrap(), &y.times(&g).unwrap()).unwrap().terms().len(), {
            f.times(&g).unwrap().times(&h).unwrap().terms().len()
        });
    }
}
