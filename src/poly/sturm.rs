//! Root counts where Routh's array has a vanishing leading entry.
//!
//! # Purpose
//! The number of roots in the right half plane and the presence of roots on the imaginary axis
//! for any real polynomial, exactly.
//!
//! # Method
//! H(s) = E(s²) + s·O(s²). The common divisor g of E and O holds all roots that lie symmetrically
//! to the axis; of what is left, LHP − RHP is the Cauchy index of Im H(jω)/Re H(jω), counted by
//! Sturm's chain. The axis roots of g(s²) are the negative roots of g, counted with multiplicity.
//!
//! # References
//! F. R. Gantmacher, The Theory of Matrices, vol. 2, ch. XV §§ 3, 6.
//!
//! # Numerical aspects
//! Exact; primitive remainder sequences over the integers. Polynomials descend.

use super::stability::Stability;
use crate::exact::IBig;
use dashu_base::{Abs, Gcd, Signed};

type Poly = Vec<IBig>;

/// Where the roots of `h` lie; `h[0]` ≠ 0.
pub fn classify(h: &[IBig]) -> Stability {
    let zeros = h.iter().rev().take_while(|a| **a == IBig::ZERO).count();
    let h = &h[..h.len() - zeros];
    let n = h.len() - 1;
    // powers of s² in the even and the odd part
    let even: Poly = h.iter().skip(n % 2).step_by(2).cloned().collect();
    let odd: Poly = h.iter().skip((n + 1) % 2).step_by(2).cloned().collect();
    let (even, odd) = (trim(even), trim(odd));
    let g = gcd(even.clone(), odd.clone());
    let symmetric = g.len() - 1;
    let on_axis = negative_roots(g.clone());
    let apart = right_half_plane(&quotient(&even, &g), &quotient(&odd, &g));
    match symmetric - on_axis + apart {
        0 if zeros + on_axis > 0 => Stability::Axis,
        0 => unreachable!("a polynomial with all roots on the left has a regular Routh array"),
        count => Stability::Unstable(count),
    }
}

/// Right-half-plane roots of E(s²) + s·O(s²) with E and O coprime and no root at 0.
fn right_half_plane(even: &[IBig], odd: &[IBig]) -> usize {
    let u = on_axis(even, 0);
    let v = on_axis(odd, 1);
    let n = u.len().max(v.len()) - 1;
    // LHP − RHP = −index(V/U) for n even, +index(U/V) for n odd
    let balance = if u.len() > v.len() { -cauchy_index(u, v) } else { cauchy_index(v, u) };
    (n as i64 - balance) as usize / 2
}

/// ω^k·p(−ω²) as a polynomial in ω.
fn on_axis(p: &[IBig], k: usize) -> Poly {
    if p.is_empty() {
        return Vec::new();
    }
    let degree = p.len() - 1;
    let mut out = vec![IBig::ZERO; 2 * degree + 1 + k];
    for (i, a) in p.iter().enumerate() {
        out[2 * i] = if (degree - i).is_multiple_of(2) { a.clone() } else { -a };
    }
    out
}

/// The Cauchy index of q/p over the whole line, deg q < deg p.
fn cauchy_index(p: Poly, q: Poly) -> i64 {
    let chain = chain(p, q);
    variations(chain.iter().map(|p| sign(&p[0]) * parity(p))) - variations(chain.iter().map(|p| sign(&p[0])))
}

/// Roots of g on the negative half line, with multiplicity; g(0) ≠ 0.
fn negative_roots(mut g: Poly) -> usize {
    let mut count = 0;
    while g.len() > 1 {
        let slope = derivative(&g);
        let chain = chain(g.clone(), slope.clone());
        let below = variations(chain.iter().map(|p| sign(&p[0]) * parity(p)));
        let at_zero = variations(chain.iter().map(|p| sign(&p[p.len() - 1])));
        count += (below - at_zero) as usize;
        g = gcd(g, slope);
    }
    count
}

/// Sturm's chain: p, q, then each the negated remainder of the two before it.
fn chain(p: Poly, q: Poly) -> Vec<Poly> {
    let mut chain = vec![p];
    let mut next = q;
    while !next.is_empty() {
        chain.push(next);
        let k = chain.len();
        next = remainder(&chain[k - 2], &chain[k - 1]).into_iter().map(|a| -a).collect();
    }
    chain
}

fn variations(signs: impl Iterator<Item = i64>) -> i64 {
    let signs: Vec<i64> = signs.filter(|s| *s != 0).collect();
    signs.windows(2).filter(|w| w[0] != w[1]).count() as i64
}

fn sign(a: &IBig) -> i64 {
    match a {
        a if *a == IBig::ZERO => 0,
        a if a.is_negative() => -1,
        _ => 1,
    }
}

/// −1 where a polynomial changes its sign between −∞ and +∞.
fn parity(p: &[IBig]) -> i64 {
    if p.len().is_multiple_of(2) { -1 } else { 1 }
}

fn derivative(p: &[IBig]) -> Poly {
    let n = p.len() - 1;
    primitive(p[..n].iter().enumerate().map(|(i, a)| a * IBig::from(n - i)).collect())
}

/// The greatest common divisor, primitive; of two polynomials that are not both zero.
fn gcd(mut p: Poly, mut q: Poly) -> Poly {
    while !q.is_empty() {
        let r = remainder(&p, &q);
        p = q;
        q = r;
    }
    primitive(p)
}

/// A positive multiple of the remainder of p by q, primitive; empty for zero.
fn remainder(p: &[IBig], q: &[IBig]) -> Poly {
    let (mut r, lead, negative) = (p.to_vec(), q[0].clone().abs(), q[0].is_negative());
    while r.len() >= q.len() {
        let factor = if negative { -&r[0] } else { r[0].clone() };
        for a in &mut r {
            *a *= &lead;
        }
        for (a, b) in r.iter_mut().zip(q) {
            *a -= &factor * b;
        }
        r.remove(0);
        r = trim(r);
    }
    primitive(r)
}

/// p/q where q divides p over the rationals; a positive multiple of it, primitive.
fn quotient(p: &[IBig], q: &[IBig]) -> Poly {
    let lead = q[0].clone().abs();
    let (mut r, mut out) = (p.to_vec(), Vec::new());
    while r.len() >= q.len() {
        for a in r.iter_mut().chain(&mut out) {
            *a *= &lead;
        }
        let factor = &r[0] / &q[0];
        for (a, b) in r.iter_mut().zip(q) {
            *a -= &factor * b;
        }
        r.remove(0);
        out.push(factor);
    }
    out
}

fn trim(mut p: Poly) -> Poly {
    let zeros = p.iter().take_while(|a| **a == IBig::ZERO).count();
    p.split_off(zeros)
}

fn primitive(p: Poly) -> Poly {
    let divisor = p
        .iter()
        .fold(IBig::ZERO, |g, a| if g == IBig::ZERO { a.clone().abs() } else { IBig::from((&g).gcd(a)) });
    if divisor == IBig::ZERO {
        return p;
    }
    p.into_iter().map(|a| a / &divisor).collect()
}
