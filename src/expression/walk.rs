//! Names, substitution and other walks over the tree.

use super::{Expr, Function};
use std::collections::BTreeSet;

/// Whether a text can be a name of a model: a letter or `_`, then letters, digits and `_`.
pub fn is_name(text: &str) -> bool {
    let mut chars = text.chars();
    chars.next().is_some_and(|c| c.is_alphabetic() || c == '_')
        && chars.all(|c| c.is_alphanumeric() || c == '_')
}

impl Expr {
    /// The direct parts, from left to right.
    pub fn children(&self) -> Vec<&Self> {
        match self {
            Self::Number(_) | Self::Name(_) => Vec::new(),
            Self::Neg(a) => vec![a],
            Self::Binary(_, a, b) => vec![a, b],
            Self::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// The same construct with every direct part replaced by what `change` makes of it.
    #[must_use]
    pub fn map_children(&self, change: &mut dyn FnMut(&Self) -> Self) -> Self {
        match self {
            Self::Number(_) | Self::Name(_) => self.clone(),
            Self::Neg(a) => Self::Neg(Box::new(change(a))),
            Self::Binary(op, a, b) => Self::Binary(*op, Box::new(change(a)), Box::new(change(b))),
            Self::Call(function, arguments) => Self::Call(*function, arguments.iter().map(change).collect()),
        }
    }

    /// Every name in it but `pi` and `t`.
    pub fn names(&self) -> BTreeSet<&str> {
        let mut names = BTreeSet::new();
        self.visit(&mut |e| {
            if let Self::Name(name) = e
                && name != "pi"
                && name != "t"
            {
                names.insert(name.as_str());
            }
        });
        names
    }

    /// Whether the name stands in it.
    pub fn mentions(&self, name: &str) -> bool {
        let mut found = false;
        self.visit(&mut |e| found |= matches!(e, Self::Name(n) if n == name));
        found
    }

    /// Whether the function is called in it.
    pub fn calls(&self, function: Function) -> bool {
        let mut found = false;
        self.visit(&mut |e| found |= matches!(e, Self::Call(f, _) if *f == function));
        found
    }

    /// Visits every subexpression, outermost first.
    pub fn visit<'a>(&'a self, see: &mut dyn FnMut(&'a Self)) {
        see(self);
        for child in self.children() {
            child.visit(see);
        }
    }

    /// The expression with a name replaced wherever it stands.
    ///
    /// ```
    /// use gyrospec::expression::Expr;
    /// let e = Expr::parse("2*v^2")?;
    /// assert_eq!(e.substitute("v", &Expr::parse("a + b")?).to_string(), "2*(a + b)^2");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn substitute(&self, name: &str, by: &Self) -> Self {
        self.substitute_each(&|n| (n == name).then(|| by.clone()))
    }

    /// The expression with every name replaced for which there is something to stand in its place.
    #[must_use]
    pub fn substitute_each(&self, by: &dyn Fn(&str) -> Option<Self>) -> Self {
        match self {
            Self::Name(n) => by(n).unwrap_or_else(|| self.clone()),
            _ => self.map_children(&mut |child| child.substitute_each(by)),
        }
    }

    /// The value of an expression of numbers alone; `None` where a name or a memory stands.
    pub fn constant(&self) -> Option<f64> {
        self.value(&|_| None)
    }

    /// The value with the names looked up; `None` where a name is unknown or a memory stands.
    ///
    /// ```
    /// use gyrospec::expression::Expr;
    /// let e = Expr::parse("2*x^2")?;
    /// assert_eq!(e.value(&|name| (name == "x").then_some(3.0)), Some(18.0));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn value(&self, lookup: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        match self {
            Self::Number(x) => Some(*x),
            Self::Name(name) if name == "pi" => Some(std::f64::consts::PI),
            Self::Name(name) => lookup(name),
            Self::Neg(a) => a.value(lookup).map(|x| -x),
            Self::Binary(op, a, b) => Some(op.of(a.value(lookup)?, b.value(lookup)?)),
            Self::Call(f, arguments) if !f.has_memory() && !matches!(f, Function::Foreign(_)) => {
                let values: Option<Vec<f64>> = arguments.iter().map(|a| a.value(lookup)).collect();
                values.map(|v| f.of(&v))
            }
            Self::Call(..) => None,
        }
    }
}
