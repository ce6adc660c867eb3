//! Tables as functions in MATLAB and Octave.

use super::code::{UNSTABLE, preface};
use super::recursion::Recursion;
use super::{Exporter, programs};
use crate::Result;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// One function an order; indices count from 1.
pub struct Matlab;

impl Exporter for Matlab {
    fn name(&self) -> &'static str {
        "matlab"
    }

    fn print(&self, orders: RangeInclusive<usize>) -> Result<String> {
        programs(orders.clone())?;
        let mut text: String = preface(UNSTABLE).iter().map(|line| format!("% {line}\n")).collect();
        text.push_str(
            "% MATLAB calls from elsewhere the first function of a file: one file an order, gyrospec_in.m.\n",
        );
        orders.for_each(|n| text.push_str(&function(n)));
        Ok(text)
    }
}

fn function(n: usize) -> String {
    let recursion = Recursion::new(n);
    let mut text = format!(
        "\nfunction value = gyrospec_i{n}(a, b)\n% I_{n} from a(1) = a0 ... a({}) = a{n} and b(1) = b0 ... b({n}) = b{}.\n",
        n + 1,
        n - 1
    );
    for (name, sum) in &recursion.steps {
        let _ = writeln!(text, "    {name} = {};", counted_from_one(sum));
    }
    let stable: Vec<String> = recursion.multipliers.iter().map(|q| format!("{q} > 0")).collect();
    let value = counted_from_one(&recursion.value);
    let _ = writeln!(
        text,
        "    if {}\n        value = {value};\n    else\n        value = NaN;\n    end\nend",
        stable.join(" && ")
    );
    text
}

/// `a[0]` as `a(1)`.
fn counted_from_one(sum: &str) -> String {
    let mut text = String::new();
    let mut parts = sum.split('[');
    text.push_str(parts.next().unwrap_or_default());
    for part in parts {
        let (index, rest) = part.split_once(']').unwrap_or((part, ""));
        let _ = write!(text, "({}){rest}", index.parse::<usize>().map_or(0, |k| k + 1));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Expr;
    use crate::integral::{Integrand, evaluate};
    use std::collections::HashMap;

    /// What the function of a text gives, by the expression language, for which `a(1)` is written `a_1`.
    fn run(text: &str, a: &[f64], b: &[f64]) -> f64 {
        let mut known: HashMap<String, f64> = HashMap::new();
        for (letter, numbers) in [("a", a), ("b", b)] {
            known.extend(numbers.iter().enumerate().map(|(k, v)| (format!("{letter}_{}", k + 1), *v)));
        }
        for line in text.lines().filter(|l| l.starts_with("    ") && l.contains(" = ") && !l.contains("NaN"))
        {
            let (name, sum) = line.trim().trim_end_matches(';').split_once(" = ").unwrap();
            let mut plain = sum.to_owned();
            for k in (1..=a.len()).rev() {
                plain = plain
                    .replace(&format!("a({k})"), &format!("a_{k}"))
                    .replace(&format!("b({k})"), &format!("b_{k}"));
            }
            let value = Expr::parse(&plain).unwrap().value(&|n: &str| known.get(n).copied()).unwrap();
            known.insert(name.to_owned(), value);
        }
        known["value"]
    }

    #[test]
    fn its_functions_give_the_integral() {
        let poles = [0.3, 1.0, 1.7, 2.5, 0.8];
        for n in 1..=5 {
            let mut a = vec![1.0];
            for p in &poles[..n] {
                // times s + p
                let shifted: Vec<f64> = [&[0.0][..], &a].concat().iter().map(|v| v * p).collect();
                a.push(0.0);
                a.iter_mut().zip(shifted).for_each(|(v, s)| *v += s);
            }
            let b: Vec<f64> = (0..n).map(|k| if k % 2 == 0 { 1.0 } else { -0.4 }).collect();
            let wanted = evaluate(&Integrand::new(&a, &b).unwrap()).unwrap().value;
            let text = Matlab.print(n..=n).unwrap();
            let got = run(&text, &a, &b);
            assert!((got / wanted - 1.0).abs() < 1e-12, "I_{n}: {got} and {wanted}\n{text}");
            assert!(text.contains(&format!("function value = gyrospec_i{n}(a, b)")));
        }
    }
}
