//! A better minimum of the model as given, to which a finding led its parameters.
//!
//! # Purpose
//! A fit that ended at a lesser minimum leaves what any law may lower that leads the parameters out of it, be its own size
//! nothing: the first finding is then none.
//!
//! # Method
//! The model is fitted once more from the parameters beside a first finding. Where that lowers much of what the finding
//! did, the search begins anew from there.

use super::backward::fitted_from;
use super::bench::Bench;
use super::choose::floor;
use super::measure::Scale;
use crate::estimate::Fit;

/// Share of what a first finding lowers, as a logarithm, from which on the model without it must not lower it too.
const MOSTLY: f64 = 0.1;

/// The model as given, fitted from where one with a finding has its parameters, if much of what that lowers is lowered so too:
/// the fit before had ended at a lesser minimum.
pub fn better(bench: &Bench, base: &Fit, with: &Fit) -> Option<Fit> {
    let mut model = base.model.clone();
    for (own, there) in model.parameters.iter_mut().zip(&with.model.parameters) {
        own.value = there.value;
    }
    let fit = fitted_from(bench, &model, with, bench.steps(&model))?;
    let scale = Scale::of(base, bench.is_trials());
    let [before, with, there] = [base, with, &fit].map(|f| scale.squares(f));
    let falls = (before / there).ln();
    (falls > floor(0.0) && falls > MOSTLY * (before / with).ln()).then_some(fit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::record::Channel;
    use crate::record::Recording;
    use crate::units::Unit;

    /// x" = u - x' / 5 - k x with k = 4, and u of three sines.
    fn swinging() -> Recording {
        let push = |t: f64| (0.7 * t).sin() + (1.9 * t).sin() + (3.1 * t).sin();
        let (mut x, mut v, h) = (0.0, 0.0, 1e-3);
        let (mut time, mut pushes, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..60_000 {
            let t = h * f64::from(i);
            if i % 50 == 0 {
                time.push(t);
                pushes.push(push(t));
                values.push(x);
            }
            v += h * (push(t) - 0.2 * v - 4.0 * x);
            x += h * v;
        }
        let unit = |text: &str| Unit::parse(text).unwrap();
        let push = Channel::new("u", unit("N"), time.clone(), pushes);
        Recording::from_channels("swing", vec![push, Channel::new("x", unit("m"), time, values)]).unwrap()
    }

    #[test]
    fn a_finding_that_led_the_parameters_to_another_minimum_leads_the_model_without_it_there() {
        let text = "name = 'm'\n[inputs]\nu = { unit = 'N' }\n[parameters]\nm = { value = 1, unit = 'kg' }\nd = { value = 0.2, unit = 'N*s/m' }\n\
            k = { value = 30, unit = 'N/m', fit = true, min = 1 }\n[states]\nx = { rate = 'v', unit = 'm', initial = 0 }\n\
            v = { rate = '(u - d*v - k*x)/m', unit = 'm/s', initial = 0 }\n[outputs]\n\
            x = { equals = 'x', unit = 'm' }";
        let model = Model::parse(text).unwrap();
        let bench = Bench::new(&model, vec![swinging()], false, 1);
        let at = |k: f64, steps: usize| {
            let mut model = model.clone();
            model.parameters.iter_mut().filter(|p| p.name == "k").for_each(|p| p.value = k);
            let options = bench.options(crate::estimate::fit::Effort::Near, steps);
            crate::estimate::fit(&model, &bench.recordings, &options).unwrap()
        };
        let (astray, right) = (at(30.0, 20), at(4.1, 0));
        let k = |fit: &Fit| fit.parameters.iter().find(|p| p.name == "k").unwrap().value;
        assert!(k(&astray) > 10.0, "{}", k(&astray));
        let found = better(&bench, &astray, &right).unwrap();
        assert!((k(&found) - 4.0).abs() < 0.02, "{}", k(&found));
        assert!(better(&bench, &found, &astray).is_none());
    }
}
