//! modelDescription.xml of FMI 2.0 and 3.0, as far as a simulation from outside needs it.

use super::xml::{child, is, number};
use crate::units::Unit;
use crate::{Error, Result};
use gyrospec_fmi::{Number, Version};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// What a variable is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    Parameter,
    Input,
    Output,
    Other,
}

/// A number of the unit, or an array of them.
#[derive(Debug, Clone)]
pub(crate) struct Variable {
    pub name: String,
    pub reference: u32,
    pub role: Role,
    pub number: Number,
    /// Whether it changes at events only.
    pub is_discrete: bool,
    /// Its numbers: one, or as many as the array has.
    pub start: Vec<f64>,
    /// Sizes of an array.
    pub sizes: Vec<usize>,
    pub unit: Unit,
    /// Whether the description gives its unit.
    pub has_unit: bool,
    pub meaning: Option<String>,
    pub range: (Option<f64>, Option<f64>),
    /// The variable whose rate it is: a number in the order of the file, or a reference.
    derivative: Option<u32>,
    is_reinit: bool,
}

/// One interface of a unit.
#[derive(Debug, Clone)]
pub(crate) struct Interface {
    pub identifier: String,
    pub has_slopes: bool,
    /// Whether its steps may be of any length, in a unit that steps itself.
    pub takes_any_step: bool,
    /// Whether an input may run straight during a step.
    pub takes_input_slopes: bool,
    /// s, where its own steps have one length.
    pub own_step: Option<f64>,
}

/// What a unit says of itself.
#[derive(Debug, Clone)]
pub(crate) struct Description {
    pub version: Version,
    pub name: String,
    pub token: String,
    pub exchange: Option<Interface>,
    pub simulation: Option<Interface>,
    pub variables: Vec<Variable>,
    /// Positions of each state and its rate among the variables.
    pub states: Vec<(usize, usize)>,
    pub indicators: usize,
    /// Whether an event may move a state.
    pub resets: bool,
    /// What is left out: variables that are no real numbers, units that are not known.
    pub notes: Vec<String>,
}

impl Description {
    /// Reads the text of modelDescription.xml.
    ///
    /// # Errors
    /// Text that is no XML; a version or an interface that is not supported; structure that points nowhere.
    pub fn read(text: &str) -> Result<Self> {
        let document = Document::parse(text)
            .map_err(|e| Error::bad_input(format!("modelDescription.xml is no XML: {e}")))?;
        let root = document.root_element();
        let version = version(&root)?;
        let units = units(&root);
        let types = types(&root);
        let mut notes = Vec::new();
        let mut reader = Reader { version, units, types, notes: &mut notes, sizes: sizes(&root) };
        let (variables, places) = reader.variables(&root)?;
        let states = states(&root, version, &variables, &places)?;
        let two_indicators = number(&root, "numberOfEventIndicators").unwrap_or(0.0) as usize;
        let structure = child(&root, "ModelStructure");
        let three_indicators = structure
            .iter()
            .flat_map(Node::children)
            .filter(|n| n.has_tag_name("EventIndicator"))
            .filter_map(|n| number(&n, "valueReference"))
            .map(|r| variables.iter().find(|v| f64::from(v.reference) == r).map_or(1, |v| v.start.len()))
            .sum();
        let interface = |name: &str| child(&root, name).and_then(|n| interface(&n, version));
        let resets = states.iter().any(|s| variables[s.0].is_reinit);
        let mut description = Self {
            version,
            name: root.attribute("modelName").unwrap_or("an FMU").to_owned(),
            token: ["guid", "instantiationToken"]
                .iter()
                .find_map(|k| root.attribute(*k))
                .unwrap_or("")
                .to_owned(),
            exchange: interface("ModelExchange"),
            simulation: interface("CoSimulation"),
            indicators: if version == Version::Two { two_indicators } else { three_indicators },
            variables,
            states,
            resets,
            notes,
        };
        description.judge_states()?;
        if description.exchange.is_none() && description.simulation.is_none() {
            let only = if child(&root, "ScheduledExecution").is_some() {
                "Scheduled Execution only"
            } else {
                "no interface"
            };
            let e = Error::bad_input(format!(
                "this FMU has {only}: nobody can step it from one sample to the next"
            ));
            return Err(e.with_hint("export it for Model Exchange or Co-Simulation"));
        }
        Ok(description)
    }

    /// A unit that names a derivative, but lists none as a state's, would stand still under another's solver.
    fn judge_states(&mut self) -> Result<()> {
        let Some(rate) = self.variables.iter().find(|v| v.derivative.is_some() && self.states.is_empty())
        else {
            return Ok(());
        };
        let says = format!(
            "{} is a derivative, but the FMU's ModelStructure lists no derivative of a state",
            rate.name
        );
        match (&self.exchange, &self.simulation) {
            (None, _) => {}
            (Some(_), Some(_)) => {
                self.exchange = None;
                self.notes.push(format!("{says}: it steps itself, by Co-Simulation"));
            }
            (Some(_), None) => {
                return Err(Error::bad_input(format!("{says}: it would stand still"))
                    .with_hint("export it once more with its derivatives listed, or for Co-Simulation"));
            }
        }
        Ok(())
    }
}

fn version(root: &Node<'_, '_>) -> Result<Version> {
    match root.attribute("fmiVersion").unwrap_or_default() {
        "2.0" => Ok(Version::Two),
        v if v == "3.0" || v.starts_with("3.0.") => Ok(Version::Three),
        other => Err(Error::bad_input(format!("this FMU is of FMI version {other:?}; 2.0 and 3.0 are read"))
            .with_hint("export it once more for FMI 2.0 or 3.0")),
    }
}

fn interface(n: &Node<'_, '_>, version: Version) -> Option<Interface> {
    let slopes = if version == Version::Two {
        "providesDirectionalDerivative"
    } else {
        "providesDirectionalDerivatives"
    };
    Some(Interface {
        identifier: n.attribute("modelIdentifier")?.to_owned(),
        has_slopes: is(n, slopes),
        takes_any_step: is(n, "canHandleVariableCommunicationStepSize"),
        takes_input_slopes: version == Version::Two && is(n, "canInterpolateInputs"),
        own_step: number(n, "fixedInternalStepSize").filter(|s| *s > 0.0),
    })
}

/// The unit of each name in `UnitDefinitions`, where it can be said.
fn units(root: &Node<'_, '_>) -> BTreeMap<String, Option<Unit>> {
    let list = child(root, "UnitDefinitions");
    let all = list.iter().flat_map(Node::children).filter(|n| n.has_tag_name("Unit"));
    all.filter_map(|n| {
        let name = n.attribute("name")?.to_owned();
        let unit = spelled(&name).or_else(|| based(&child(&n, "BaseUnit")?));
        Some((name, unit))
    })
    .collect()
}

/// A unit by its name: `m/s2` and `N.m` are Modelica's way to write m/s^2 and N*m.
fn spelled(name: &str) -> Option<Unit> {
    if let Ok(unit) = Unit::parse(name) {
        return Some(unit);
    }
    let mut text = String::new();
    let mut before = ' ';
    for c in name.chars() {
        let is_power = c.is_ascii_digit() || c == '-';
        if is_power && before.is_alphabetic() {
            text.push('^');
        }
        text.push(if c == '.' { '*' } else { c });
        before = c;
    }
    Unit::parse(&text).ok()
}

/// A unit by its base units, where its factor is 1.
fn based(base: &Node<'_, '_>) -> Option<Unit> {
    let (factor, offset) = (number(base, "factor").unwrap_or(1.0), number(base, "offset").unwrap_or(0.0));
    if factor != 1.0 || offset != 0.0 {
        return None;
    }
    let powers = ["kg", "m", "s", "A", "K", "mol", "rad"].map(|k| (k, number(base, k).unwrap_or(0.0)));
    let terms: Vec<String> = powers
        .iter()
        .filter(|p| p.1 != 0.0)
        .map(|(k, p)| format!("{k}^{p}").replace("^1", if *p == 1.0 { "" } else { "^1" }))
        .collect();
    if number(base, "cd").is_some_and(|p| p != 0.0) {
        return None;
    }
    Unit::parse(if terms.is_empty() { "1".into() } else { terms.join("*") }.as_str()).ok()
}

/// How a variable of that type is held; `None` for texts, bytes and clocks.
fn type_of(tag: &str, is_two: bool) -> Option<Number> {
    Some(match (tag, is_two) {
        ("Real", true) | ("Float64", false) => Number::Float64,
        ("Integer" | "Enumeration", true) | ("Int32", false) => Number::Int32,
        ("Boolean", _) => Number::Boolean,
        ("Float32", false) => Number::Float32,
        ("Int8", false) => Number::Int8,
        ("UInt8", false) => Number::UInt8,
        ("Int16", false) => Number::Int16,
        ("UInt16", false) => Number::UInt16,
        ("UInt32", false) => Number::UInt32,
        ("Int64" | "Enumeration", false) => Number::Int64,
        ("UInt64", false) => Number::UInt64,
        _ => return None,
    })
}

/// Unit, least and largest value.
type Attributes = (Option<String>, Option<f64>, Option<f64>);

/// Attributes that a variable has from its type.
fn types(root: &Node<'_, '_>) -> BTreeMap<String, Attributes> {
    let list = child(root, "TypeDefinitions");
    let all = list.iter().flat_map(Node::children).filter(Node::is_element);
    all.filter_map(|n| {
        let real = child(&n, "Real").unwrap_or(n);
        let own = (real.attribute("unit").map(str::to_owned), number(&real, "min"), number(&real, "max"));
        Some((n.attribute("name")?.to_owned(), own))
    })
    .collect()
}

/// Start values of whole numbers, by reference: sizes of arrays.
fn sizes(root: &Node<'_, '_>) -> BTreeMap<u32, usize> {
    let list = child(root, "ModelVariables");
    let all = list.iter().flat_map(Node::children).filter(|n| n.has_tag_name("UInt64"));
    all.filter_map(|n| {
        Some((n.attribute("valueReference")?.parse().ok()?, n.attribute("start")?.parse().ok()?))
    })
    .collect()
}

struct Reader<'a> {
    version: Version,
    units: BTreeMap<String, Option<Unit>>,
    types: BTreeMap<String, Attributes>,
    notes: &'a mut Vec<String>,
    sizes: BTreeMap<u32, usize>,
}

/// Most numbers that an array may have.
const LONGEST: usize = 4096;

impl Reader<'_> {
    /// The variables that are numbers, and the position among them of each variable of the file.
    fn variables(&mut self, root: &Node<'_, '_>) -> Result<(Vec<Variable>, Vec<Option<usize>>)> {
        let list = child(root, "ModelVariables");
        let (mut all, mut places) = (Vec::new(), Vec::new());
        for n in list.iter().flat_map(Node::children).filter(Node::is_element) {
            let own = match self.version {
                Version::Two => n.children().find_map(|c| Some((c, type_of(c.tag_name().name(), true)?))),
                Version::Three => type_of(n.tag_name().name(), false).map(|t| (n, t)),
            };
            places.push(own.map(|_| all.len()));
            match own {
                Some((own, number)) => all.push(self.variable(&n, &own, number)?),
                None if n.attribute("causality") == Some("input") => {
                    let name = n.attribute("name").unwrap_or_default();
                    self.notes.push(format!("the FMU's input {name} is no number: it keeps its start value"));
                }
                None => {}
            }
        }
        if self.version == Version::Three {
            refuse_twins(&all)?;
        }
        Ok((all, places))
    }

    fn variable(&mut self, n: &Node<'_, '_>, own: &Node<'_, '_>, number_of: Number) -> Result<Variable> {
        let wrong = |what: &str| Error::bad_input(format!("modelDescription.xml: {what}"));
        let name = n.attribute("name").ok_or_else(|| wrong("a variable has no name"))?.to_owned();
        let reference = n.attribute("valueReference").map(|r| (r, r.parse().ok()));
        let reference = match reference {
            Some((_, Some(reference))) => reference,
            Some((text, None)) => {
                return Err(wrong(&format!(
                    "{name} has the valueReference {text:?}, which is no whole number"
                )));
            }
            None => return Err(wrong(&format!("{name} has no valueReference"))),
        };
        let of_type =
            own.attribute("declaredType").and_then(|t| self.types.get(t)).cloned().unwrap_or_default();
        let given = own.attribute("unit").map(str::to_owned).or(of_type.0);
        let unit = given.as_ref().and_then(|u| self.units.get(u).cloned().unwrap_or_else(|| spelled(u)));
        if let (Some(given), None) = (&given, &unit) {
            self.notes.push(format!(
                "the FMU's {name} is in {given:?}, which is no known unit: it is taken as a pure number"
            ));
        }
        let sizes: Vec<usize> =
            n.children().filter(|c| c.has_tag_name("Dimension")).map(|d| self.size(&d)).collect();
        let count = sizes.iter().try_fold(1usize, |a, b| a.checked_mul(*b)).filter(|c| *c <= LONGEST);
        let count = count
            .ok_or_else(|| Error::bad_input(format!("{name} is an array of more than {LONGEST} numbers")))?;
        let words: Vec<f64> = own
            .attribute("start")
            .unwrap_or_default()
            .split_whitespace()
            .map(|w| match w {
                "true" => Ok(1.0),
                "false" => Ok(0.0),
                _ => w.parse().map_err(|_| wrong(&format!("{name} has the start {w:?}, which is no number"))),
            })
            .collect::<Result<_>>()?;
        let start = (0..count)
            .map(|i| words.get(i).or(words.first().filter(|_| words.len() == 1)).copied().unwrap_or(0.0))
            .collect();
        Ok(Variable {
            name,
            reference,
            role: match n.attribute("causality") {
                Some("parameter") => Role::Parameter,
                Some("input") => Role::Input,
                Some("output") => Role::Output,
                _ => Role::Other,
            },
            number: number_of,
            is_discrete: !number_of.is_real() || n.attribute("variability") == Some("discrete"),
            start,
            sizes,
            has_unit: unit.is_some(),
            unit: unit.unwrap_or_else(Unit::one),
            meaning: n.attribute("description").map(str::to_owned),
            range: (number(own, "min").or(of_type.1), number(own, "max").or(of_type.2)),
            derivative: own.attribute("derivative").and_then(|d| d.parse().ok()),
            is_reinit: is(own, "reinit"),
        })
    }

    fn size(&self, dimension: &Node<'_, '_>) -> usize {
        let fixed = dimension.attribute("start").and_then(|s| s.parse().ok());
        let by = || self.sizes.get(&dimension.attribute("valueReference")?.parse().ok()?).copied();
        fixed.or_else(by).unwrap_or(1)
    }
}

/// Refuses two variables of one reference: in FMI 3.0 each has its own.
fn refuse_twins(variables: &[Variable]) -> Result<()> {
    let mut known = BTreeMap::new();
    for v in variables {
        if let Some(other) = known.insert(v.reference, &v.name) {
            let (name, reference) = (&v.name, v.reference);
            return Err(Error::bad_input(format!(
                "modelDescription.xml: {other} and {name} have the same valueReference {reference}"
            )));
        }
    }
    Ok(())
}

/// Each state with its rate.
fn states(
    root: &Node<'_, '_>,
    version: Version,
    variables: &[Variable],
    places: &[Option<usize>],
) -> Result<Vec<(usize, usize)>> {
    let structure = child(root, "ModelStructure");
    let (rates, key): (Vec<Node<'_, '_>>, _) = match version {
        Version::Two => {
            let list = structure.and_then(|s| child(&s, "Derivatives"));
            (list.iter().flat_map(Node::children).filter(|n| n.has_tag_name("Unknown")).collect(), "index")
        }
        Version::Three => {
            let all = structure.iter().flat_map(Node::children);
            (all.filter(|n| n.has_tag_name("ContinuousStateDerivative")).collect(), "valueReference")
        }
    };
    let at = |number: u32| match version {
        Version::Two => places.get((number as usize).checked_sub(1)?).copied().flatten(),
        Version::Three => variables.iter().position(|v| v.reference == number),
    };
    let pair = |n: &Node<'_, '_>| -> Option<(usize, usize)> {
        let rate = at(n.attribute(key)?.parse().ok()?)?;
        Some((at(variables[rate].derivative?)?, rate))
    };
    let lost = |n: &Node<'_, '_>| {
        let number = n.attribute(key).unwrap_or_default();
        Error::bad_input(format!(
            "modelDescription.xml lists the variable of {key} {number:?} as the rate of a state, and no variable there \
             says so of itself by `derivative`"
        ))
    };
    rates.iter().map(|n| pair(n).ok_or_else(|| lost(n))).collect()
}
