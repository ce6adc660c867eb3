//! # What it is
//! A parameter is no constant: viscosity with temperature, stiffness with load, gain with voltage.
//!
//! # Signature in a recording
//! Fits on parts of the recording give other values, in step with the signal.
//!
//! # Equation
//! ```text
//!     p -> p (1 + a (u - mean u))        with an input, a channel or a state
//!     p -> p (1 + a x^2)                 with a state, an input or a channel that goes through 0
//!     p -> p (1 + a |x|)                 with such an input or channel, as a resistance with the flow through it
//!     p -> p/(1 + a |x|)                 with a state, saturating;  or p/(1 + a x^2), as iron and eddy currents do
//!     p -> p/(1 + a |u|)                 with an input or a channel that is never negative, as an inhibitor slows a reaction; or p/(1 + a u^2)
//!     p -> p exp(a (u - mean u))
//!     p -> p (u/mean u)^n                with an input or a channel that stays above 0, as heat transfer with a flow
//!     p -> p + c (u - p)                 with a channel in the place of a known p of its kind, c = 1
//!     and the same with an output that is no state, as its expression stands
//!     c -> c (1 + a sign(v))             with the speed, or the difference of two, that a damper c multiplies
//!     T -> T (1 + a sign(u - x))         of a state that follows, x' = (u - x)/T, as a valve that fills faster than it vents
//!     p x -> p x (1 + a x^2), p x/(1 + a |x|), p x/(1 + a x^2)    with what p multiplies, as a tyre with its slip
//! ```
//!
//! # What else looks like this
//! parameter-change, parameter-drift (when the signal drifts), cross-coupling (a sum, not a
//! product).
//!
//! # Reference
//! P. C. Young, P. McKenna, J. Bruun, Identification of non-linear stochastic systems by state
//! dependent parameter estimation, Int. J. Control 74 (2001) 1837.
//!
//! # Example
//! The lag of a gyrosphere's liquid that grows as it cools; a tyre whose side force saturates with its slip angle; the force factor of a loudspeaker, which falls as its coil
//! leaves the gap; an inductance whose iron saturates with the current.

use super::arguments;
use super::between::{self, Between, Of};
use super::terms::{factors, has_factor, rewritten, with_factor};
use super::{
    Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, draft::POSITIVE, edit,
};
use crate::expression::Expr;
use crate::model::{Output, Parameter, State};
use crate::units::Unit;

/// A parameter that varies with a signal.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-dependence",
    "a parameter that varies with a signal",
    Group::Ignored,
    include_str!("parameter_dependence.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel, SignalKind::Input]).filter(|s| !s.is_heading()).collect();
    let names = scene.acting_parameters();
    let pairs = names.iter().flat_map(|p| signals.iter().map(move |s| (p, *s)));
    // what a constant alone gains with a channel is a coupling of that
    let couples =
        |p: &str, s: &Signal| s.kind == SignalKind::Channel && !scene.trials && is_constant_term(scene, p);
    let own = pairs.clone().filter(|(p, s)| !couples(p, s));
    let mut all: Vec<Proposal> = own.filter_map(|(p, s)| at(scene, p, s)).collect();
    all.extend(pairs.clone().filter_map(|(p, s)| in_place(scene, p, s)));
    all.extend(pairs.clone().filter_map(|(p, s)| in_power(scene, p, s)));
    if !scene.trials {
        let terms = arguments::terms(scene.model);
        let forms = |p: &str, s: &Signal| {
            // what is an input times its own square is its characteristic
            let own = multiplies(&terms, p, &s.name);
            let kind = of_its_kind(scene, p, s).is_some();
            let hinders = is_amount(s) && s.max >= BENDS * s.min;
            WITH_RECORDED.iter().filter(move |f| match f {
                Form::Exponential => !kind,
                Form::Saturating | Form::SaturatingSquare => hinders && !own,
                _ => !own,
            })
        };
        all.extend(pairs.flat_map(|(p, s)| forms(p, s).filter_map(|f| on_state(scene, p, s, *f))));
        let states: Vec<&Signal> = scene.moving(&[SignalKind::State]).filter(|s| !s.is_heading()).collect();
        for p in &names {
            for s in &states {
                let alone = stands_alone(scene, p, &s.name);
                // where a level saturates that a parameter multiplies, it is a saturable rate
                let rate = s.mean > 0.5 * s.spread && multiplies(&terms, p, &s.name);
                let forms = FORMS.iter().filter(|f| !alone || f.saturates());
                let forms = forms.filter(|f| !rate || **f != Form::Saturating);
                all.extend(forms.filter_map(|f| on_state(scene, p, s, *f)));
            }
            all.extend(scene.model.outputs.iter().filter_map(|o| on_output(scene, p, o)));
        }
        let kinds = [Of::Positions, Of::Speeds].into_iter();
        let elements: Vec<Between> = kinds.flat_map(|of| between::all(scene, of)).collect();
        all.extend(names.iter().flat_map(|p| on_arguments(scene, p, (&terms, &elements))));
        all.extend(dampers(scene).iter().filter_map(|(p, speed)| each_way(scene, p, speed)));
        all.extend(scene.model.states.iter().filter_map(|x| up_and_down(scene, x)));
    }
    all
}

/// Share of its greatest value by which an amount may be shown below 0: a sensor has noise and a zero.
const ZERO: f64 = 0.05;

/// Whether a signal is an amount, which is never negative.
fn is_amount(signal: &Signal) -> bool {
    signal.min >= -ZERO * signal.max
}

/// A parameter of rates that varies with what an output gives, where that is neither a state nor made of the parameter.
fn on_output(scene: &Scene, p: &str, o: &Output) -> Option<Proposal> {
    let signal = scene.signal(&o.name).filter(|s| s.varies() && !s.is_heading())?;
    let plain = matches!(o.equals, Expr::Name(_)) || o.equals.mentions(p);
    let defined = scene.model.definitions.iter().any(|d| o.equals.mentions(&d.name));
    if plain
        || defined
        || edit::find(&o.equals, &|e| matches!(e, Expr::Call(f, _) if f.has_memory())).is_some()
    {
        return None;
    }
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let unit = Unit::one().over(&scene.unit(&o.name));
    let a = d.amplitude("a", &unit, ANY, "relative change of the parameter for a unit of the output");
    let mean = d.constant(&format!("{}_mean", o.name), &signal.unit, signal.mean, "mean of the recording");
    let states = scene.model.states.iter().filter(|s| o.equals.mentions(&s.name));
    states.for_each(|s| d.uses(&s.name));
    let text = format!("({p}*(1 + {a}*({} - {mean})))", o.equals);
    d.replace(p, &text, |place| matches!(place, edit::Place::Rate(_)));
    d.start(&[0.3 / signal.spread]);
    d.done(&format!("{} varies with {}, relatively by {{0}}", scene.words(p), scene.words(&o.name)))
}

/// How a parameter may vary with a signal.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Linear,
    Quadratic,
    Modulus,
    Saturating,
    SaturatingSquare,
    Exponential,
}

/// Those with an input or a channel, beside the linear one ([`at`]).
const WITH_RECORDED: [Form; 5] =
    [Form::Quadratic, Form::Modulus, Form::Saturating, Form::SaturatingSquare, Form::Exponential];

/// Those with a state.
const FORMS: [Form; 5] =
    [Form::Linear, Form::Quadratic, Form::Saturating, Form::SaturatingSquare, Form::Exponential];

impl Form {
    fn saturates(self) -> bool {
        matches!(self, Self::Saturating | Self::SaturatingSquare)
    }

    /// Whether it grows alike on both sides of 0.
    fn grows_both_ways(self) -> bool {
        matches!(self, Self::Quadratic | Self::Modulus)
    }
}

/// Whether a parameter times that state alone, or what was found of both, is a term of the model: its law is a damping or a
/// stiffness, which have names of their own where they grow.
fn stands_alone(scene: &Scene, p: &str, state: &str) -> bool {
    let added = &scene.model.parameters[scene.own_parameters..];
    let is_own = |n: &str| n == p || n == state || added.iter().any(|a| a.name == n);
    let is_plain = |t: &Expr| has_factor(t, p) && has_factor(t, state) && t.names().into_iter().all(is_own);
    let rates =
        scene.model.states.iter().map(|s| edit::laws_of(scene.model, edit::sum_of(scene.model, &s.rate)));
    rates.flatten().any(|t| is_plain(&t))
}

/// Whether a parameter stands in the rates in terms of constants alone, and nowhere else.
fn is_constant_term(scene: &Scene, p: &str) -> bool {
    let model = scene.model;
    let rates = model.states.iter().flat_map(|s| edit::laws_of(model, edit::sum_of(model, &s.rate)));
    let is_parameter = |n: &str| model.parameters.iter().any(|own| own.name == n);
    let is_read = model.outputs.iter().any(|o| o.equals.mentions(p));
    let mut own = rates.filter(|t| edit::reaches(model, t, p)).peekable();
    !is_read && own.peek().is_some() && own.all(|t| t.names().into_iter().all(is_parameter))
}

/// Whether a parameter multiplies a signal in some term.
fn multiplies(terms: &[Expr], p: &str, signal: &str) -> bool {
    terms.iter().any(|t| has_factor(t, p) && has_factor(t, signal))
}

fn on_state(scene: &Scene, p: &str, signal: &Signal, form: Form) -> Option<Proposal> {
    let (s, size) = (&signal.name, signal.size());
    let level = signal.mean.abs() > signal.spread;
    // about a level that is never 0 a square is a slope, and about 0 an exponential is one
    let is_about_nothing = !level && !is_amount(signal);
    if form.grows_both_ways() && level || form == Form::Exponential && is_about_nothing {
        return None;
    }
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let unit = scene.unit(s);
    let power = if matches!(form, Form::Quadratic | Form::SaturatingSquare) { 2.0 } else { 1.0 };
    let limits = if form.saturates() { POSITIVE } else { ANY };
    let a =
        d.amplitude("a", &Unit::one().over(&unit.power(power)), limits, "relative change of the parameter");
    let part = if form.grows_both_ways() || form.saturates() { s.clone() } else { d.centred(signal) };
    let text = match form {
        Form::Linear => format!("({p}*(1 + {a}*{part}))"),
        Form::Quadratic => format!("({p}*(1 + {a}*{s}^2))"),
        Form::Modulus => format!("({p}*(1 + {a}*abs({s})))"),
        Form::Saturating => format!("({p}/(1 + {a}*abs({s})))"),
        Form::SaturatingSquare => format!("({p}/(1 + {a}*{s}^2))"),
        Form::Exponential => format!("({p}*exp({a}*{part}))"),
    };
    d.uses(s);
    d.replace(p, &text, |_| true);
    if form.saturates() {
        d.divides(p, size.powf(power));
    }
    let start =
        if form == Form::Linear || form == Form::Exponential { signal.spread } else { size.powf(power) };
    d.start(&[0.3 / start]);
    let how = match form {
        Form::Linear => "varies with",
        Form::Quadratic => "varies with the square of",
        Form::Modulus => "varies with the size of",
        Form::Saturating | Form::SaturatingSquare if signal.kind != SignalKind::State => "falls off with",
        Form::Saturating | Form::SaturatingSquare => "saturates with",
        Form::Exponential => "varies exponentially with",
    };
    d.done(&format!("{} {how} {}, relatively by {{0}}", scene.words(p), scene.words(s)))
}

/// A parameter that varies with what it multiplies in a term: a sum, a quotient or a definition, of which a spring or a
/// damper between two bodies has names of its own where it grows.
fn on_arguments(scene: &Scene, p: &str, (terms, elements): (&[Expr], &[Between])) -> Vec<Proposal> {
    let found = arguments::each(scene.model, terms.iter().filter(|t| has_factor(t, p)));
    let is_element = |x: &Expr| {
        elements.iter().any(|b| b.parameter == p && b.difference == *x)
            || matches!(x, Expr::Name(n) if stands_alone(scene, p, n))
    };
    let forms = [Form::Modulus, Form::Quadratic, Form::Saturating, Form::SaturatingSquare];
    let of = |x: &Expr| {
        let forms = forms.into_iter().filter(|f| f.saturates() || !is_element(x));
        forms.filter_map(|f| on_argument(scene, p, x, f)).collect::<Vec<_>>()
    };
    found.iter().flat_map(of).collect()
}

fn on_argument(scene: &Scene, p: &str, x: &Expr, form: Form) -> Option<Proposal> {
    let size = scene.arguments.iter().find(|(e, s)| e == x && *s > 0.0)?.1;
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let power = if matches!(form, Form::Modulus | Form::Saturating) { 1.0 } else { 2.0 };
    let limits = if form.saturates() { POSITIVE } else { ANY };
    let unit = Unit::one().over(&scene.unit_of(x).usual().power(power));
    let a = d.amplitude("a", &unit, limits, "relative change of the parameter");
    let law = match form {
        Form::Saturating => format!("({p}/(1 + {a}*abs({x})))"),
        Form::SaturatingSquare => format!("({p}/(1 + {a}*({x})^2))"),
        Form::Modulus => format!("({p}*(1 + {a}*abs({x})))"),
        _ => format!("({p}*(1 + {a}*({x})^2))"),
    };
    let (own, new) = (Expr::name(p), Expr::parse(&law).ok()?);
    let is_own = |t: &Expr| has_factor(t, p) && arguments::of(scene.model, t).as_ref() == Some(x);
    d.each(&|e| rewritten(e, &|t| is_own(t).then(|| with_factor(t, &own, &new))));
    x.names().iter().filter(|n| scene.signal(n).is_some()).for_each(|n| d.uses(n));
    d.term(&law);
    if form.saturates() {
        d.divides(p, size.powf(power));
    }
    d.start(&[0.3 / size.powf(power)]);
    let how = match form {
        Form::Modulus => "varies with the size of",
        Form::Saturating | Form::SaturatingSquare => "saturates with",
        _ => "varies with the square of",
    };
    let words = if let Expr::Name(n) = x { scene.words(n) } else { x.to_string() };
    d.done(&format!("{} {how} {words}, relatively by {{0}}", scene.words(p)))
}

fn at(scene: &Scene, p: &str, signal: &Signal) -> Option<Proposal> {
    // about a mean that is the parameter's own value it is the quantity in its place
    if of_its_kind(scene, p, signal).is_some_and(|own| (own.value - signal.mean).abs() < signal.spread) {
        return None;
    }
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let a = d.amplitude(
        "a",
        &Unit::one().over(&signal.unit),
        ANY,
        "relative change of the parameter for a unit of the signal",
    );
    // a value that is known holds where nothing acts, one that is fitted at the mean
    let is_known = scene.model.parameters.iter().any(|own| own.name == p && !own.fit);
    let part = if is_known { d.centred(signal) } else { d.about_mean(signal) };
    d.uses(&signal.name);
    d.replace(p, &format!("({p}*(1 + {a}*{part}))"), |_| true);
    d.start(&[0.3 / signal.spread]);
    d.done(&format!("{} varies with {}, relatively by {{0}}", scene.words(p), scene.words(&signal.name)))
}

/// By how much a signal must be larger somewhere than elsewhere for its power to be no slope.
const BENDS: f64 = 1.5;

/// A parameter that goes with a power of what stays above 0, as a refinement of one that goes with it.
fn in_power(scene: &Scene, p: &str, signal: &Signal) -> Option<Proposal> {
    if signal.min <= 0.0 || signal.max < BENDS * signal.min {
        return None;
    }
    let s = &signal.name;
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    d.refines();
    let n = d.amplitude("n", &Unit::one(), ANY, "power of the signal with which the parameter goes");
    let mean = d.constant(&format!("{s}_mean"), &signal.unit, signal.mean, "mean of the recording");
    d.uses(s);
    d.replace(p, &format!("({p}*(abs({s}/{mean}) + 1e-6)^{n})"), |_| true);
    d.start(&[0.5]);
    d.done(&format!("{} goes with {} to the power of {{0}}", scene.words(p), scene.words(s)))
}

/// The known parameter of that name, where a recorded quantity that the model does not read is of its kind.
fn of_its_kind<'s>(scene: &'s Scene, p: &str, signal: &Signal) -> Option<&'s Parameter> {
    let own = scene.model.parameters.iter().find(|own| own.name == p && !own.fit)?;
    let is_kind = own.unit.dimension() == signal.unit.dimension() && !own.unit.dimension().is_none();
    (signal.kind == SignalKind::Channel && is_kind).then_some(own)
}

/// A recorded quantity in the place of a known one of its kind: the temperature of a room that the model holds at a value.
fn in_place(scene: &Scene, p: &str, signal: &Signal) -> Option<Proposal> {
    of_its_kind(scene, p, signal)?;
    let s = &signal.name;
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let c = d.amplitude("c", &Unit::one(), ANY, "share of the recorded quantity in the parameter's place");
    d.uses(s);
    d.replace(p, &format!("({p} + {c}*({s} - {p}))"), |_| true);
    d.start(&[1.0]);
    d.done(&format!("{} stands in the place of {}, {{0}} of it", scene.words(s), scene.words(p)))
}

/// The dampers of a model: a parameter, and the speed, or the difference of two, that it multiplies.
fn dampers(scene: &Scene) -> Vec<(String, Expr)> {
    let alone = scene.motions().into_iter().filter_map(|m| m.speed).flat_map(|v| {
        let own = scene.acting_parameters().into_iter().filter(|p| stands_alone(scene, p, &v));
        own.map(|p| (p, Expr::name(&v))).collect::<Vec<_>>()
    });
    let between = between::all(scene, Of::Speeds).into_iter();
    alone.chain(between.map(|b| (b.parameter, b.difference))).collect()
}

/// How much larger than its mean a parameter is one way, and smaller the other.
fn difference(d: &mut Draft) -> String {
    d.amplitude("a", &Unit::one(), (-1.0, 1.0), "half the difference of both ways, as a share of the mean")
}

/// A damper that is harder one way than the other.
fn each_way(scene: &Scene, p: &str, speed: &Expr) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let a = difference(&mut d);
    speed.names().iter().for_each(|n| d.uses(n));
    let law = format!("({p}*(1 + {a}*sign({speed})))");
    let (own, new) = (Expr::name(p), Expr::parse(&law).ok()?);
    let is_speed = |f: &&Expr| speed.names().iter().all(|n| f.mentions(n));
    let damps = |t: &Expr| has_factor(t, p) && factors(t).iter().any(is_speed);
    d.each(&|e| rewritten(e, &|t| damps(t).then(|| with_factor(t, &own, &new))));
    d.term(&law);
    d.start(&[0.3]);
    let words = if let Expr::Name(n) = speed { scene.words(n) } else { speed.to_string() };
    d.done(&format!("{} is harder one way than the other: {{0}} more of it where {words} is positive, as much less where it is negative", scene.words(p)))
}

/// A state that follows faster upwards than downwards, or slower: its time or its gain is not the same both ways.
fn up_and_down(scene: &Scene, x: &State) -> Option<Proposal> {
    let over = edit::follows(scene.model, x)?;
    scene.signal(&x.name).filter(|s| s.varies() && !s.is_heading())?;
    let acting = scene.acting_parameters();
    let p = acting.iter().find(|p| x.rate.mentions(p) && !over.mentions(p))?;
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let a = difference(&mut d);
    d.uses(&x.name);
    let is_own = |place: edit::Place| matches!(place, edit::Place::Rate(s) if s == x.name);
    d.replace(p, &format!("({p}*(1 + {a}*sign({over})))"), is_own);
    d.start(&[0.3]);
    let says = format!(
        "{} is not the same both ways: {{0}} of it is added where {over} is positive, and taken off where it is negative",
        scene.words(p)
    );
    d.done(&says)
}
