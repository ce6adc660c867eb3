//! Mean products of two filtered signals: random cases, and their exact value by partial fractions.

use super::families::{Family, coefficients, generator, polynomial};
use dashu_ratio::RBig;
use gyrospec::exact::rational;
use gyrospec::lti::TransferFunction;
use rand::RngExt;

/// White noise through `shaping`, then through each of two filters; the rate of the second where `rate`.
#[derive(Debug)]
pub struct Crossed {
    pub shaping: TransferFunction,
    pub first: TransferFunction,
    pub second: TransferFunction,
    pub rate: bool,
}

/// A filter of order n with at least `fall` more poles than zeros.
fn filter(family: Family, n: usize, fall: usize, rng: &mut impl rand::Rng) -> (Vec<f64>, Vec<f64>) {
    let h = polynomial(family, n, &mut generator(rng.random()));
    let c = coefficients(n + 1 - fall.min(n), rng);
    (c, h)
}

/// The case of a seed: orders 0 to 2 of the shaping and 1 to 4 of each filter; some with a white part, some with one
/// denominator for both.
pub fn case(family: Family, seed: u64) -> Crossed {
    let mut rng = generator(seed ^ 0x5eed_c0de);
    let made = |(c, h): (Vec<f64>, Vec<f64>)| TransferFunction::new(&c, &h).unwrap();
    let (order, rate) = (rng.random_range(0..3), rng.random_bool(0.6));
    let shaping = made(filter(family, order, usize::from(order > 0), &mut rng));
    let (falls, orders) = (rng.random_range(0..3), [0; 2].map(|_| rng.random_range(1..5)));
    // one may be white where the other falls off as 1/ω²
    let falls = [[1, 1], [0, 2], [2, 0]][falls];
    let falls = [0, 1].map(|i| falls[i].min(orders[i]));
    let (c, h) = filter(family, orders[0], falls[0], &mut rng);
    let (mut d, mut k) = filter(family, orders[1], falls[1], &mut rng);
    if rng.random_bool(0.2) {
        d.truncate(h.len() - falls[1].min(orders[0]));
        k.clone_from(&h);
    }
    Crossed { shaping, first: made((c, h)), second: made((d, k)), rate }
}

fn lifted(p: &[f64]) -> Vec<RBig> {
    p.iter().map(|x| rational(*x)).collect()
}

fn times(p: &[RBig], q: &[RBig]) -> Vec<RBig> {
    let mut out = vec![RBig::ZERO; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

/// p(−s).
fn mirrored(p: &[RBig]) -> Vec<RBig> {
    let odd = |i: usize| (p.len() - 1 - i) % 2 == 1;
    p.iter().enumerate().map(|(i, a)| if odd(i) { -a.clone() } else { a.clone() }).collect()
}

/// The exact mean of the two sides of zero lag: with P₁(s)P₂(−s)/(H₁(s)H₂(−s)) = A(s)/H₁(s) + B(s)/H₂(−s) the
/// correlation at 0+ is the quotient of the leading coefficients of A and H₁, that at 0− of B(−s) and H₂.
/// Nothing where the product does not fall off.
pub fn exactly(x: &Crossed) -> Option<RBig> {
    let [c, h] = [x.shaping.numerator(), x.shaping.denominator()].map(lifted);
    let (h1, h2) = (times(&h, &lifted(x.first.denominator())), times(&h, &lifted(x.second.denominator())));
    let (p1, mut p2) = (times(&c, &lifted(x.first.numerator())), times(&c, &lifted(x.second.numerator())));
    if x.rate {
        p2.push(RBig::ZERO);
    }
    let (n1, n2) = (h1.len() - 1, h2.len() - 1);
    let right = times(&p1, &mirrored(&p2));
    let n = n1 + n2;
    if right.len() > n {
        return None;
    }
    let turned = mirrored(&h2);
    // a row for each power s^(n−1) … 1; columns: A, then B, descending
    let entry = |row: usize, column: usize| {
        let (p, shift) = if column < n1 { (&turned, column) } else { (&h1, column - n1) };
        row.checked_sub(shift).and_then(|i| p.get(i)).cloned().unwrap_or(RBig::ZERO)
    };
    let mut rows: Vec<Vec<RBig>> = (0..n)
        .map(|row| {
            let known = (row + right.len()).checked_sub(n).map_or(RBig::ZERO, |i| right[i].clone());
            (0..n).map(|column| entry(row, column)).chain([known]).collect()
        })
        .collect();
    let solved = solve(&mut rows)?;
    let sign = if n2 % 2 == 0 { -RBig::ONE } else { RBig::ONE };
    let a = if n1 > 0 { &solved[0] / &h1[0] } else { RBig::ZERO };
    let b = if n2 > 0 { &solved[n1] * sign / &h2[0] } else { RBig::ZERO };
    Some((a + b) / RBig::from(2))
}

/// Gauss and Jordan on [M | y].
fn solve(rows: &mut [Vec<RBig>]) -> Option<Vec<RBig>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).find(|i| rows[*i][k] != RBig::ZERO)?;
        rows.swap(k, pivot);
        let lead = rows[k][k].clone();
        rows[k].iter_mut().skip(k).for_each(|x| *x = &*x / &lead);
        let own = rows[k].clone();
        for row in rows.iter_mut().enumerate().filter(|(i, _)| *i != k).map(|(_, row)| row) {
            let factor = row[k].clone();
            if factor != RBig::ZERO {
                for (x, y) in row.iter_mut().zip(&own).skip(k) {
                    *x = &*x - &factor * y;
                }
            }
        }
    }
    Some(rows.iter().map(|row| row[n].clone()).collect())
}
