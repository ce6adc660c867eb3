//! Names that a language can take.

use crate::model::Model;
use std::collections::{BTreeMap, BTreeSet};

const GREEK: [(char, &str); 25] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('ς', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

/// The names of a model, each with one that the language can take.
#[derive(Debug)]
pub(super) struct Names {
    given: BTreeMap<String, String>,
    taken: BTreeSet<String>,
}

impl Names {
    /// The names that expressions of the model use; no two are one, and none is reserved.
    pub fn new(model: &Model, reserved: &[&str]) -> Self {
        let taken = reserved.iter().map(|w| (*w).to_string()).collect();
        let mut names = Self { given: BTreeMap::new(), taken };
        let inputs = model.inputs.iter().map(|i| &i.name);
        let parameters = model.parameters.iter().map(|p| &p.name);
        let states = model.states.iter().map(|s| &s.name);
        let definitions = model.definitions.iter().map(|d| &d.name);
        let all: Vec<&String> = inputs.chain(parameters).chain(states).chain(definitions).collect();
        // names that can stay as they are have the first right to it
        let (plain, others): (Vec<&String>, Vec<&String>) =
            all.into_iter().partition(|n| plain(n) == n.as_str() && !names.taken.contains(n.as_str()));
        for name in plain.into_iter().chain(others) {
            let own = names.fresh(name);
            names.given.insert(name.clone(), own);
        }
        names
    }

    /// What the language calls a name; `pi` and `t` are themselves.
    pub fn of<'a>(&'a self, name: &'a str) -> &'a str {
        self.given.get(name).map_or(name, String::as_str)
    }

    /// A name like that one which nothing has yet.
    pub fn fresh(&mut self, like: &str) -> String {
        let mut own = plain(like);
        while !self.taken.insert(own.clone()) {
            own.push('_');
        }
        own
    }

    /// Whether something has that name.
    pub fn has(&self, name: &str) -> bool {
        self.taken.contains(name)
    }

    /// The names that had to change, with what they became.
    pub fn changed(&self) -> impl Iterator<Item = (&str, &str)> {
        self.given.iter().filter(|(a, b)| a != b).map(|(a, b)| (a.as_str(), b.as_str()))
    }
}

/// The name in the letters of ASCII.
pub(super) fn plain(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        let small = c.to_lowercase().next().unwrap_or(c);
        match GREEK.iter().find(|g| g.0 == small) {
            _ if c.is_ascii() => out.push(c),
            Some((_, word)) if small == c => out.push_str(word),
            Some((_, word)) => out.extend(word[..1].to_uppercase().chars().chain(word[1..].chars())),
            None => match digit(c) {
                Some(digit) => out.push(digit),
                None => out.push_str(&format!("u{:x}", u32::from(c))),
            },
        }
    }
    if out.chars().all(|c| c == '_') { format!("u{out}") } else { out }
}

/// The digit that a raised or lowered one is.
fn digit(c: char) -> Option<char> {
    let number = "⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉".chars().position(|d| d == c)?;
    char::from_digit(number as u32 % 10, 10)
}

/// A name for the model in letters and digits that nothing in it has.
pub(super) fn class(names: &Names, model: &str) -> String {
    let name = plain(model);
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    let joined: String = words.map(|w| w[..1].to_uppercase() + &w[1..]).collect();
    let begins = joined.starts_with(|c: char| c.is_ascii_alphabetic());
    let mut class = if begins { joined } else { format!("Model{joined}") };
    while names.has(&class) {
        class.push('_');
    }
    class
}
