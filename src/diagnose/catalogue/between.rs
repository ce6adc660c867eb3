//! What stands between two bodies: a parameter times the difference of their positions or speeds, such as a spring or a
//! damper. A law of the difference acts on both, as the element does.

use super::arguments::terms;
use super::terms::{factors, has_factor, rewritten, with_factor, without_factor};
use super::{Draft, Motion, Scene, Signal, draft::SiteKind, edit};
use crate::expression::{BinaryOp, Expr};
use crate::model::Model;
use crate::units::Unit;

/// What the difference is one of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// Positions, as a spring feels them.
    Positions,
    /// Speeds, as a damper feels them.
    Speeds,
}

/// An element between two bodies, or between a body and what drives it.
#[derive(Debug, Clone)]
pub struct Between {
    /// The parameter: a stiffness or a damping.
    pub parameter: String,
    /// The difference as it stands, or the definition that is one.
    pub difference: Expr,
    /// What the difference is one of.
    pub of: Of,
    /// The first state on whose rate it acts.
    pub state: String,
    /// Unit of the parameter times the difference.
    pub force: Unit,
    /// Unit of the difference.
    pub unit: Unit,
    /// Root mean square of the difference.
    pub size: f64,
}

impl Between {
    /// Root mean square of the element's force.
    pub fn force_size(&self, scene: &Scene) -> f64 {
        let value = scene.model.parameters.iter().find(|p| p.name == self.parameter).map(|p| p.value.abs());
        self.size * value.filter(|v| *v > 0.0).unwrap_or(1.0)
    }

    /// Whether a term is the element, and if so its difference, either way round.
    fn stands_in<'t>(&self, term: &'t Expr) -> Option<&'t Expr> {
        let is_own = |f: &&Expr| **f == self.difference || turned(f).as_ref() == Some(&self.difference);
        factors(term).into_iter().find(is_own).filter(|_| has_factor(term, &self.parameter))
    }

    /// Puts a law in the place of parameter times difference wherever the element acts; `law` gives it for the
    /// difference as it stands there, and is told whether that is turned round.
    pub fn obeys(&self, d: &mut Draft, law: &dyn Fn(&str, bool) -> String) {
        let new = |term: &Expr| {
            let difference = self.stands_in(term)?;
            let is_turned = *difference != self.difference;
            let law = Expr::parse(&format!("({})", law(&format!("({difference})"), is_turned))).ok()?;
            Some(with_factor(&without_factor(term, &self.parameter)?, difference, &law))
        };
        d.each(&|e| rewritten(e, &new));
        let term = Expr::parse(&law(&format!("({})", self.difference), false));
        d.term(&term.map(|e| e.to_string()).unwrap_or_default());
    }

    /// A draft at the element's state.
    pub fn draft<'a>(&self, scene: &'a Scene<'a>, code: &'static str) -> Draft<'a> {
        Draft::new(scene, code, SiteKind::State, &self.state)
    }
}

/// b − a of a − b.
fn turned(e: &Expr) -> Option<Expr> {
    let Expr::Binary(BinaryOp::Sub, a, b) = e else { return None };
    Some(Expr::Binary(BinaryOp::Sub, b.clone(), a.clone()))
}

/// The elements of a model that feel positions or speeds, each once.
pub fn all(scene: &Scene, of: Of) -> Vec<Between> {
    let motions = scene.motions();
    let mut found: Vec<Between> = Vec::new();
    for term in terms(scene.model) {
        let new = element(scene, &motions, &term).filter(|b| b.of == of);
        found.extend(
            new.filter(|n| found.iter().all(|b| b.parameter != n.parameter || b.stands_in(&term).is_none())),
        );
    }
    found
}

fn element(scene: &Scene, motions: &[Motion], term: &Expr) -> Option<Between> {
    let parameters = &scene.model.parameters;
    let is_known = |e: &Expr| {
        matches!(e, Expr::Number(_)) || matches!(e, Expr::Name(n) if parameters.iter().any(|p| p.name == *n))
    };
    let (known, others): (Vec<&Expr>, Vec<&Expr>) = factors(term).into_iter().partition(|f| is_known(f));
    let &[difference] = others.as_slice() else { return None };
    let name = known.iter().find_map(|e| if let Expr::Name(n) = e { Some(n.clone()) } else { None })?;
    let sides = sides(scene, difference)?;
    let is_any = |of: &dyn Fn(&Motion) -> Option<&String>| {
        motions.iter().any(|m| of(m).is_some_and(|n| sides.contains(n)))
    };
    let of = if is_any(&|m| m.speed.as_ref()) {
        Of::Speeds
    } else if is_any(&|m| m.position.as_ref()) && !is_any(&|m| m.speed.is_none().then_some(&m.state)) {
        Of::Positions
    } else {
        return None;
    };
    let rate_of = |m: &Motion| scene.model.states.iter().find(|s| s.name == m.state).map(|s| &s.rate);
    let acts = |m: &&Motion| rate_of(m).is_some_and(|r| edit::reaches(scene.model, r, &name));
    let unit = scene.unit_of(difference).usual();
    let parameter = Expr::name(&name);
    Some(Between {
        state: motions.iter().find(acts)?.state.clone(),
        force: scene
            .unit_of(&Expr::Binary(BinaryOp::Mul, Box::new(parameter), Box::new(difference.clone())))
            .usual(),
        size: scene.arguments.iter().find(|(e, _)| e == difference)?.1,
        parameter: name,
        difference: difference.clone(),
        of,
        unit,
    })
}

/// The two signals of a difference, where both move.
fn sides(scene: &Scene, difference: &Expr) -> Option<[String; 2]> {
    let moves = |n: &String| scene.signal(n).is_some_and(Signal::varies);
    names(scene.model, difference).filter(|sides| sides.iter().all(moves))
}

/// The two names of a difference, or of the definition that is one.
fn names(model: &Model, difference: &Expr) -> Option<[String; 2]> {
    let opened = match difference {
        Expr::Name(n) => &model.definitions.iter().find(|d| d.name == *n)?.equals,
        other => other,
    };
    let Expr::Binary(BinaryOp::Sub, a, b) = opened else { return None };
    let (Expr::Name(a), Expr::Name(b)) = (&**a, &**b) else { return None };
    Some([a.clone(), b.clone()])
}
