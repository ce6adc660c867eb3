//! A model fitted to recordings.

use super::asking::Asking;
use crate::Result;
use crate::diagnose::{Request, begins_in_motion, held_inputs, read_held, says_held, spread_of};
use crate::estimate::fit::{
    self as estimate, Fit, FitOptions, HeldOut, ParameterEstimate, ResidualSpectrum, Status, Warning,
    residual_spectra,
};
use crate::estimate::{Correlation, correlations};
use crate::model::Model;
use crate::record::quality::{outliers, wrapped_angle};
use crate::record::{Kind, Recording, Source};
use crate::report::fit::{FitReport, json, page, text};
use crate::simulate::Budget;
use crate::units::counted;
use std::borrow::Cow;
use std::fmt;
use std::path::Path;

/// Asks for a fit of a model's free parameters and initial states to recordings, by simulation.
///
/// The last 40 % of a recording is held out, unless its spans or [`Fitting::holdout`] say otherwise. Inputs that the
/// recordings show to be held between their samples are read so, as in [`diagnose`](crate::diagnose()), with a warning.
///
/// ```
/// use gyrospec::{Model, Recording, fit};
/// let folder = tempfile::tempdir().unwrap();
/// let file = folder.path().join("decay.csv");
/// let rows = (0..100).map(|k| format!("{0},{1}\n", 0.1 * k as f64, (-0.1 * k as f64 / 2.0).exp()));
/// std::fs::write(&file, format!("t [s],y [1]\n{}", rows.collect::<String>())).unwrap();
/// let model = Model::parse(
///     "name = \"decay\"\n[parameters]\nT = { value = 1.0, unit = \"s\", min = 0.1, max = 10.0, fit = true }\n\
///      [states]\nx = { unit = \"1\", rate = \"-x/T\", initial = 1.0 }\n[outputs]\ny = { unit = \"1\", equals = \"x\" }\n",
/// )?;
/// let recordings = [Recording::read(&file)?];
/// let fitted = fit(&model, &recordings).seed(1).run()?;
/// assert!((fitted.parameter("T").unwrap().value - 2.0).abs() < 1e-3);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn fit<'a>(model: &'a Model, recordings: &'a [Recording]) -> Fitting<'a> {
    Asking::new(model, recordings)
}

/// A fit that is asked for; see [`fit`].
pub type Fitting<'a> = Asking<'a, Fitted<'a>>;

impl<'a> Fitting<'a> {
    /// Fits the model.
    ///
    /// # Errors
    /// Where a channel is missing, recordings hold the same data, or the model cannot be simulated.
    pub fn run(self) -> Result<Fitted<'a>> {
        let Request { model, source, recordings, separate, seed, time_limit, progress } = self.request;
        let begin = FitOptions { separate_holdout: !separate.is_empty(), progress, ..FitOptions::default() };
        let model = &*estimate::begun(model, recordings, &begin)?;
        let (mut recordings, mut separate) = (model.all_joined(recordings)?, model.all_joined(separate)?);
        estimate::setup::keep_apart(model, &recordings, &separate)?;
        let options = FitOptions {
            seed,
            separate_holdout: !separate.is_empty(),
            budget: Budget::new(u64::MAX, time_limit),
            progress,
            ..FitOptions::default()
        };
        let mut fit =
            estimate::fit(model, &recordings, &options).map_err(|e| model.refusal().unwrap_or(e))?;
        if fit.ended_early.is_none() {
            let held = held_inputs(&fit, &recordings, options.separate_holdout, seed);
            if !held.is_empty() {
                read_held(recordings.to_mut(), &held);
                read_held(separate.to_mut(), &held);
                fit = estimate::fit(model, &recordings, &options)?;
            }
            fit.warnings.extend(held.iter().map(|name| Warning { message: says_held(name) }));
            let moves = begins_in_motion(&fit, &recordings, options.separate_holdout, seed);
            fit.warnings.extend(moves.map(|message| Warning { message }));
            estimate::ascertain(&mut fit, &recordings, &options)?;
        }
        let held_out = estimate::holdout(&fit, &recordings, &separate, &options.without_limit())?;
        let turned = turns(model, &recordings).map(|message| Warning { message });
        let seen = strays(model, &recordings).chain(turned);
        let more: Vec<Warning> = seen.chain(says_nothing(&fit, &recordings)).collect();
        fit.warnings.extend(more);
        let spectra = residual_spectra(&fit);
        let correlations = correlations(&fit, &recordings);
        let several = |p: &ParameterEstimate| p.status == Status::Constant && differs(&recordings, &p.name);
        fit.parameters.iter_mut().filter(|p| several(p)).for_each(|p| p.value = f64::NAN);
        // a model that was not read from a file: its own text stands among the inputs
        let source =
            source.cloned().unwrap_or_else(|| Source::of(Path::new("model"), model.to_toml().as_bytes()));
        Ok(Fitted { fit, source, held_out, spectra, correlations, recordings, separate, seed })
    }
}

/// Whether recordings know a parameter by several values, so that it has none for all of them.
fn differs(recordings: &[Recording], name: &str) -> bool {
    let known = recordings.iter().flat_map(|r| &r.constants).filter(|c| c.name == name).map(|c| c.value);
    known.clone().zip(known.skip(1)).any(|(a, b)| a != b)
}

/// Samples of outputs that stand far off alone: a fit takes them as they are.
fn strays<'a>(model: &'a Model, recordings: &'a [Recording]) -> impl Iterator<Item = Warning> + 'a {
    let both = move |r: &'a Recording| model.outputs.iter().filter_map(move |o| Some((r, r.find(&o.name)?)));
    recordings.iter().filter(|r| r.kind == Kind::Time).flat_map(both).filter_map(|(r, channel)| {
        let fault = outliers(channel).filter(|f| f.sure)?;
        let (samples, name) = (counted(fault.samples, "sample"), &channel.name);
        let message = format!(
            "{samples} of `{name}` in '{}' stand far off alone, the first at {} s, and are fitted as they are: leave \
             cells without a measurement empty; `gyrospec diagnose` leaves them out by itself",
            r.name,
            fault.spans.first()?.from
        );
        Some(Warning { message })
    })
}

/// Angles that jump by a turn: a fit takes the jumps for motion, and an input runs back through all of it.
pub(super) fn turns<'a>(model: &'a Model, recordings: &'a [Recording]) -> impl Iterator<Item = String> + 'a {
    let named = model.inputs.iter().map(|i| &i.name).chain(model.outputs.iter().map(|o| &o.name));
    let each = named.flat_map(|name| recordings.iter().map(move |r| (r, r.find(name))));
    each.filter_map(|(r, channel)| {
        let fault = wrapped_angle(channel.filter(|_| r.kind == Kind::Time)?)?;
        Some(format!(
            "`{}` in '{}' jumps by a turn, first at {} s, and is read as it stands: mark its channel `wraps = true`; \
             `gyrospec diagnose` mends that by itself",
            fault.channel,
            r.name,
            fault.spans.first()?.to
        ))
    })
}

/// Outputs of which a fitted model says nothing: its error is as large as they move.
fn says_nothing<'a>(fit: &'a Fit, recordings: &'a [Recording]) -> impl Iterator<Item = Warning> + 'a {
    fit.model.outputs.iter().zip(&fit.rmse).filter_map(|(o, rmse)| {
        let spread = spread_of(recordings, &o.name);
        (*rmse > spread && spread > 0.0).then(|| Warning {
            message: format!(
                "the fitted model says nothing of `{}`: its error is as large as that moves; start its parameters \
                 nearer to the instrument's, or give them bounds",
                o.name
            ),
        })
    })
}

/// A fitted model; see [`fit`].
pub struct Fitted<'a> {
    fit: Fit,
    source: Source,
    held_out: Vec<HeldOut>,
    spectra: Vec<ResidualSpectrum>,
    correlations: Vec<Correlation>,
    recordings: Cow<'a, [Recording]>,
    separate: Cow<'a, [Recording]>,
    seed: u64,
}

/// A parameter after the fit, in the unit of the model file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Estimated {
    /// The parameter's name in the model.
    pub name: String,
    /// The estimate, in `unit`.
    pub value: f64,
    /// Lower end of the 95 % interval; NaN where there is none.
    pub low: f64,
    /// Upper end of the 95 % interval; NaN where there is none.
    pub high: f64,
    /// The unit that the model gives the parameter.
    pub unit: String,
    /// Whether the fit was free to move it.
    pub is_free: bool,
    /// Whether it is pressed against a bound of the model file.
    pub is_at_bound: bool,
}

impl Fitted<'_> {
    /// The model with the fitted values.
    pub fn model(&self) -> &Model {
        &self.fit.model
    }

    /// Every parameter.
    pub fn parameters(&self) -> impl Iterator<Item = Estimated> {
        self.fit.parameters.iter().map(|p| Estimated {
            name: p.name.clone(),
            value: p.unit.from_si(p.value),
            low: p.unit.from_si(p.low),
            high: p.unit.from_si(p.high),
            unit: p.unit.text().to_owned(),
            is_free: matches!(p.status, Status::Fitted | Status::AtBound(_)),
            is_at_bound: matches!(p.status, Status::AtBound(_)),
        })
    }

    /// The parameter of a name.
    pub fn parameter(&self, name: &str) -> Option<Estimated> {
        self.parameters().find(|p| p.name == name)
    }

    /// Root mean square of measured less simulated on what was fitted, by output, in the output's unit.
    pub fn rmse(&self, output: &str) -> Option<f64> {
        let at = self.fit.model.outputs.iter().position(|o| o.name == output)?;
        Some(self.fit.model.outputs[at].unit.difference_from_si(self.fit.rmse[at]))
    }

    /// The same on what was held out; none where nothing was.
    pub fn holdout_rmse(&self, output: &str) -> Option<f64> {
        let at = self.fit.model.outputs.iter().position(|o| o.name == output)?;
        let held = self.held_out.iter().find(|h| h.output == at)?;
        Some(self.fit.model.outputs[at].unit.difference_from_si(held.rmse)).filter(|r| r.is_finite())
    }

    /// Whether the data tell every free parameter.
    pub fn is_determined(&self) -> bool {
        let is_told =
            |p: &ParameterEstimate| p.status != Status::Fitted || p.low.is_finite() || p.high.is_finite();
        self.fit.unseen.is_empty() && self.fit.parameters.iter().all(is_told)
    }

    /// What should be known about the fit though it went on.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        self.fit.warnings.iter().map(|w| w.message.as_str())
    }

    /// The fit in words and a table.
    pub fn text(&self) -> String {
        text(&self.report())
    }

    /// The fit as JSON, schema `gyrospec.fit/1`.
    ///
    /// # Errors
    /// `NotComputed`, should a number not be writable.
    pub fn json(&self) -> Result<String> {
        json(&self.report())
    }

    /// The fit as one HTML page with pictures.
    pub fn html(&self) -> String {
        page(&self.report())
    }

    fn report(&self) -> FitReport<'_> {
        FitReport {
            fit: &self.fit,
            source: &self.source,
            held_out: &self.held_out,
            recordings: &self.recordings,
            separate: &self.separate,
            spectra: &self.spectra,
            correlations: &self.correlations,
            seed: self.seed,
        }
    }
}

impl fmt::Debug for Fitted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Fitted").field("model", &self.fit.model.name).finish_non_exhaustive()
    }
}
