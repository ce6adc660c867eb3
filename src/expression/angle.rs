//! Purpose: which names of an expression hold an angle, whatever their units say.
//!
//! Method: an angle counts as 1 in a dimension, so that `1/s` may be an angular speed or a rate constant. Its place
//! tells: the terms of a sum hold the same power of an angle, factors add theirs, what a sine takes is an angle and
//! what an exponential takes is none. From the names that are known the others follow, from the leaves upwards and
//! from the whole downwards.
//!
//! Numerical aspects: none; powers are small fractions. A number may stand beside an angle and beside none, and a
//! factor of π may turn turns into radians: neither tells anything.

use super::{BinaryOp, Expr, Function};
use crate::units::Ratio;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// What is known of the names of expressions, and what is found out.
#[derive(Debug, Default)]
pub struct Angles {
    /// Powers of an angle, by name.
    pub powers: BTreeMap<String, Ratio>,
    /// Names of moments of inertia: what is divided by one is a torque, which holds no angle, and the quotient an
    /// angular acceleration.
    pub inertias: BTreeSet<String>,
    /// Names of what moves by itself: the sine of a small angle is the angle, so that in `-k*sin(q)` k may be a rate
    /// constant.
    pub moving: BTreeSet<String>,
    /// Names of numbers that may turn turns into radians, as one that is 2π does.
    pub turners: BTreeSet<String>,
}

/// The power of an angle in an expression.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Power {
    /// A number, which may stand beside anything.
    Any,
    /// Nothing is known.
    Open,
    Of(Ratio),
}

/// An expression with what is known of its parts.
struct Node<'a> {
    e: &'a Expr,
    power: Power,
    is_inertia: bool,
    parts: Vec<Node<'a>>,
}

impl Power {
    fn known(self) -> Option<Ratio> {
        match self {
            Self::Of(p) => Some(p),
            _ => None,
        }
    }

    /// As a factor.
    fn factor(self) -> Option<Ratio> {
        if self == Self::Any { Some(Ratio::ZERO) } else { self.known() }
    }

    /// Of a product with another to a power of 1 or −1.
    fn with(self, other: Self, sign: Ratio) -> Self {
        match (self, other) {
            (Self::Any, Self::Any) => Self::Any,
            (Self::Open, _) | (_, Self::Open) => Self::Open,
            (a, b) => a.factor().zip(b.factor()).map_or(Self::Open, |(a, b)| Self::Of(a.plus(b.times(sign)))),
        }
    }

    /// Of two that stand beside one another.
    fn beside(self, other: Self) -> Self {
        match (self, other) {
            (Self::Of(a), Self::Of(b)) if a != b => Self::Open,
            (Self::Of(a), _) | (_, Self::Of(a)) => Self::Of(a),
            (Self::Any, Self::Any) => Self::Any,
            _ => Self::Open,
        }
    }
}

impl Angles {
    /// Takes an expression that holds the power `whole` of an angle, where that is known, and finds out what it
    /// tells of its names. Gives the power that the expression has by its own parts.
    ///
    /// ```
    /// use gyrospec::expression::{Angles, Expr};
    /// use gyrospec::units::Ratio;
    /// let mut angles = Angles::default();
    /// angles.powers.insert("V".into(), Ratio::ZERO);
    /// angles.take(&Expr::parse("k*V - w + 0*sin(w*t)")?, None);
    /// assert_eq!(angles.powers["w"], Ratio::ONE);
    /// angles.take(&Expr::parse("k*V - w")?, None);
    /// assert_eq!(angles.powers["k"], Ratio::ONE);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn take(&mut self, e: &Expr, whole: Option<Ratio>) -> Option<Ratio> {
        let node = self.node(e);
        self.push(&node, whole);
        node.power.known()
    }

    fn node<'a>(&self, e: &'a Expr) -> Node<'a> {
        let parts: Vec<Node<'a>> = match e {
            Expr::Number(_) | Expr::Name(_) => Vec::new(),
            Expr::Neg(a) => vec![self.node(a)],
            Expr::Binary(_, a, b) => vec![self.node(a), self.node(b)],
            Expr::Call(_, arguments) => arguments.iter().map(|a| self.node(a)).collect(),
        };
        let inertia = |n: &Node<'_>| n.is_inertia;
        let (power, is_inertia) = match e {
            Expr::Number(x) => (if turns(*x) { Power::Open } else { Power::Any }, false),
            Expr::Name(name) => (self.of_name(name), self.inertias.contains(name)),
            Expr::Neg(_) => (parts[0].power, parts[0].is_inertia),
            Expr::Binary(op, _, b) => {
                let sum = matches!(op, BinaryOp::Add | BinaryOp::Sub) && parts.iter().all(inertia);
                (binary(*op, &parts, b), sum)
            }
            Expr::Call(function, _) if self.may_be_small(*function, e) => (Power::Open, false),
            Expr::Call(function, _) => (of_call(*function, &parts), false),
        };
        Node { e, power, is_inertia, parts }
    }

    /// Whether a function may hand on a small angle as it is.
    fn may_be_small(&self, function: Function, e: &Expr) -> bool {
        if !matches!(function, Function::Sin | Function::Tan | Function::Sinh | Function::Tanh) {
            return false;
        }
        let (mut is_timed, mut moves) = (false, false);
        e.visit(&mut |part| {
            if let Expr::Name(name) = part {
                is_timed |= name == "t";
                moves |= self.moving.contains(name);
            }
        });
        moves && !is_timed
    }

    fn of_name(&self, name: &str) -> Power {
        match (self.powers.get(name), name) {
            _ if self.turners.contains(name) => Power::Open,
            (Some(p), _) => Power::Of(*p),
            (None, "t") => Power::Of(Ratio::ZERO),
            (None, _) => Power::Open,
        }
    }

    fn push(&mut self, node: &Node<'_>, wanted: Option<Ratio>) {
        match node.e {
            Expr::Number(_) => {}
            Expr::Name(name) => {
                let learns =
                    wanted.filter(|_| !["pi", "t"].contains(&name.as_str()) && !self.turners.contains(name));
                if let Some(p) = learns {
                    self.powers.entry(name.clone()).or_insert(p);
                }
            }
            Expr::Neg(_) => self.push(&node.parts[0], wanted),
            Expr::Binary(op, _, b) => self.push_binary(*op, node, b, wanted),
            Expr::Call(function, _) => self.push_call(*function, node, wanted),
        }
    }

    fn push_binary(&mut self, op: BinaryOp, node: &Node<'_>, exponent: &Expr, wanted: Option<Ratio>) {
        let [a, b] = node.parts.as_slice() else { return };
        let less = |p: Option<Ratio>, q: Option<Ratio>| p.zip(q).map(|(p, q)| p.plus(q.negative()));
        match op {
            BinaryOp::Add | BinaryOp::Sub => {
                let each = wanted.or(node.power.known());
                self.push(a, each);
                self.push(b, each);
            }
            BinaryOp::Mul => {
                self.push(a, less(wanted, b.power.factor()));
                self.push(b, less(wanted, a.power.factor()));
            }
            BinaryOp::Div => {
                let torque = b.is_inertia.then_some(Ratio::ZERO);
                let above = wanted.zip(b.power.factor()).map(|(w, p)| w.plus(p));
                self.push(a, torque.or(above));
                self.push(b, less(a.power.factor(), wanted));
            }
            BinaryOp::Pow => {
                let inverse =
                    exponent.constant().filter(|x| *x != 0.0).and_then(|x| Ratio::from_f64(1.0 / x));
                self.push(a, wanted.zip(inverse).map(|(w, i)| w.times(i)));
                self.push(b, Some(Ratio::ZERO));
            }
        }
    }

    fn push_call(&mut self, function: Function, node: &Node<'_>, wanted: Option<Ratio>) {
        let (none, one) = (Some(Ratio::ZERO), Some(Ratio::ONE));
        let beside = node.parts.iter().fold(Power::Any, |p, n| p.beside(n.power)).known();
        let rest = match function {
            Function::Delay | Function::Lag => none,
            _ => wanted.or(beside),
        };
        let first = match function {
            Function::Sin | Function::Cos | Function::Tan => one,
            Function::Exp
            | Function::Ln
            | Function::Sinh
            | Function::Cosh
            | Function::Tanh
            | Function::Asin
            | Function::Acos
            | Function::Atan => none,
            Function::Sqrt => wanted.map(|w| w.plus(w)),
            Function::Abs | Function::Delay | Function::Lag => wanted,
            Function::Sign | Function::Step | Function::Foreign(_) => None,
            Function::Atan2 | Function::Relay => beside,
            _ => rest,
        };
        let rest = match function {
            Function::Atan2 | Function::Relay => beside,
            Function::Foreign(_) => None,
            _ => rest,
        };
        for (i, part) in node.parts.iter().enumerate() {
            self.push(part, if i == 0 { first } else { rest });
        }
    }
}

/// Whether a number as a factor may turn turns into radians or back: 2π, π/30 and the like, as people round them.
pub(crate) fn turns(x: f64) -> bool {
    let near = |y: f64| (y - 1.0).abs() < 1e-3;
    let known = [PI, 2.0 * PI, 4.0 * PI, PI / 30.0, PI / 180.0];
    known.iter().any(|k| near(x.abs() / k) || near(x.abs() * k))
}

fn binary(op: BinaryOp, parts: &[Node<'_>], exponent: &Expr) -> Power {
    let (a, b) = (&parts[0], &parts[1]);
    match op {
        BinaryOp::Add | BinaryOp::Sub => a.power.beside(b.power),
        BinaryOp::Mul => a.power.with(b.power, Ratio::ONE),
        BinaryOp::Div if b.is_inertia && a.power == Power::Open => Power::Of(Ratio::ONE),
        BinaryOp::Div => a.power.with(b.power, Ratio::ONE.negative()),
        BinaryOp::Pow => match (a.power, exponent.constant().and_then(Ratio::from_f64)) {
            (Power::Of(p), Some(e)) => Power::Of(p.times(e)),
            (Power::Of(p), None) if p != Ratio::ZERO => Power::Open,
            (power, _) => power,
        },
    }
}

fn of_call(function: Function, parts: &[Node<'_>]) -> Power {
    let half = |p: Ratio| Ratio::new(1, 2).map(|h| p.times(h));
    match function {
        Function::Sin
        | Function::Cos
        | Function::Tan
        | Function::Sinh
        | Function::Cosh
        | Function::Tanh
        | Function::Exp
        | Function::Ln
        | Function::Sign
        | Function::Step
        | Function::Relay => Power::Any,
        Function::Asin | Function::Acos | Function::Atan | Function::Atan2 => Power::Of(Ratio::ONE),
        Function::Sqrt => match parts[0].power {
            Power::Of(p) => half(p).map_or(Power::Open, Power::Of),
            other => other,
        },
        Function::Abs | Function::Delay | Function::Lag | Function::RateLimit => parts[0].power,
        Function::Foreign(_) => Power::Open,
        Function::Curve => parts.iter().skip(2).step_by(2).fold(Power::Any, |p, n| p.beside(n.power)),
        Function::Surface(n, m) => {
            let values = 2 + usize::from(n) + usize::from(m);
            parts.iter().skip(values).fold(Power::Any, |p, n| p.beside(n.power))
        }
        Function::Min | Function::Max | Function::Clamp | Function::Backlash | Function::Hysteresis => {
            parts.iter().fold(Power::Any, |p, n| p.beside(n.power))
        }
    }
}
