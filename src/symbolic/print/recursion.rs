//! I_n as a straight-line program by Routh's rows.
//!
//! Purpose: code that keeps all its digits; the expanded determinants lose some by cancellation from order 8 on.
//! Method: the equations of the determinants are M p = b with the Hurwitz matrix M\[m\]\[i\] = a(2m+1−i). Its
//! transpose falls into Routh's rows and the multipliers q_k = r_(k−1)\[0\]/r_k\[0\], so that with
//! y_m = (b_m − Σ_(k<m) r_(k+1)\[m−k\] y_k) / r_(m+1)\[0\]
//! I_n = (−1)^(n−1) (y_0 − q_1 (y_1 − q_2 (y_2 − …))) / (2 a0). H is stable where all q_k are above 0.
//! References: E. J. Routh, A Treatise on the Stability of a Given State of Motion (1877); K. J. Åström,
//! Introduction to Stochastic Control Theory (1970), chapter 5.
//! Numerical aspects: the Hurwitz matrix of a stable H is totally nonnegative, so that elimination without exchange of
//! rows is stable; about n² operations against the thousands of the shared minors.

use std::fmt::Write;

/// Named sums in their order, and the last one, the value. `a[k]`, `b[k]`, decimals, `+ - * /`: all languages read them.
pub struct Recursion {
    /// A name and what it is.
    pub steps: Vec<(String, String)>,
    /// The names of the multipliers q_1 … q_n, all above 0 where H is stable.
    pub multipliers: Vec<String>,
    pub value: String,
}

impl Recursion {
    /// The program of order n, from 1 on.
    pub fn new(n: usize) -> Self {
        let mut steps = Vec::new();
        let rows = rows(n, &mut steps);
        for m in 0..n {
            // y_m = (b_m − Σ r_(k+1)[m−k] y_k) / r_(m+1)[0]
            let mut sum = format!("b[{m}]");
            for k in 0..m {
                if let Some(entry) = rows[k + 1].get(m - k) {
                    let _ = write!(sum, " - {entry} * y{k}");
                }
            }
            let sum = if sum.contains(' ') { format!("({sum})") } else { sum };
            steps.push((format!("y{m}"), format!("{sum} / {}", rows[m + 1][0])));
        }
        // y_0 − q_1 (y_1 − q_2 (y_2 − …)), from the inside out
        let mut inner = format!("y{}", n - 1);
        for k in (1..n - 1).rev() {
            steps.push((format!("z{k}"), format!("y{k} - q{} * {inner}", k + 1)));
            inner = format!("z{k}");
        }
        let value = match n {
            1 => String::from("y0"),
            _ if n % 2 == 1 => format!("(y0 - q1 * {inner})"),
            _ => format!("(q1 * {inner} - y0)"),
        };
        let multipliers = (1..=n).map(|k| format!("q{k}")).collect();
        Self { steps, multipliers, value: format!("{value} / (2.0 * a[0])") }
    }
}

/// Routh's rows r_0 … r_n as names of their entries; their steps are added.
fn rows(n: usize, steps: &mut Vec<(String, String)>) -> Vec<Vec<String>> {
    let every_second = |first: usize| (first..=n).step_by(2).map(|k| format!("a[{k}]")).collect::<Vec<_>>();
    let mut rows = vec![every_second(0), every_second(1)];
    for k in 1..=n {
        let (above, own) = (&rows[k - 1], &rows[k]);
        steps.push((format!("q{k}"), format!("{} / {}", above[0], own[0])));
        let mut next = Vec::new();
        for (j, upper) in above.iter().enumerate().skip(1) {
            // r_(k+1)[j−1] = r_(k−1)[j] − q_k r_k[j]
            let Some(entry) = own.get(j) else {
                next.push(upper.clone());
                continue;
            };
            let name = format!("r{}_{}", k + 1, j - 1);
            steps.push((name.clone(), format!("{upper} - q{k} * {entry}")));
            next.push(name);
        }
        rows.push(next);
    }
    rows
}
