//! Recorded channels whose name means something else in the model: they are told, and those that may act get a name of
//! their own, by which laws can speak of them.

use crate::model::Model;
use crate::record::Recording;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Names that every model knows: the circle's number and the time.
const KNOWN: [&str; 2] = ["pi", "t"];

/// What is recorded under a name that the model uses otherwise.
#[derive(Debug, Default)]
pub struct Namesakes {
    /// Names of constants, and what their channels are called instead.
    renamed: Vec<(String, String)>,
    /// What a reader should know.
    pub notes: Vec<String>,
}

impl Namesakes {
    /// Those of all recordings of a diagnosis.
    pub fn of<'r>(model: &Model, recordings: impl Iterator<Item = &'r Recording>) -> Self {
        let is_read = |name: &str| {
            model.inputs.iter().any(|i| i.name == name) || model.outputs.iter().any(|o| o.name == name)
        };
        let is_constant =
            |name: &str| KNOWN.contains(&name) || model.parameters.iter().any(|p| p.name == name);
        let is_computed = |name: &str| {
            model.states.iter().any(|s| s.name == name) || model.definitions.iter().any(|d| d.name == name)
        };
        let channels: BTreeSet<&str> =
            recordings.flat_map(|r| &r.channels).map(|c| c.name.as_str()).filter(|n| !is_read(n)).collect();
        let is_taken = |n: &str| is_read(n) || is_constant(n) || is_computed(n) || channels.contains(n);
        let mut found = Self::default();
        for name in &channels {
            if is_computed(name) {
                found.notes.push(not_compared(name));
            } else if is_constant(name) {
                let mut own = format!("{name}_recorded");
                while is_taken(&own) {
                    own.push('_');
                }
                found.notes.push(other_name(name, &own));
                found.renamed.push(((*name).to_string(), own));
            }
        }
        found
    }

    /// Recordings in which no channel has the name of a constant.
    pub fn apart<'r>(&self, recordings: &'r [Recording]) -> Cow<'r, [Recording]> {
        let mut apart = Cow::Borrowed(recordings);
        for (name, own) in &self.renamed {
            let channels = apart.to_mut().iter_mut().flat_map(|r| &mut r.channels);
            channels.filter(|c| c.name == *name).for_each(|c| c.name.clone_from(own));
        }
        apart
    }
}

/// That a computed quantity is recorded and yet not compared.
fn not_compared(name: &str) -> String {
    format!(
        "`{name}` is recorded and is computed by the model, but no output has that name, so that it is not compared: an output `{name}` would compare it"
    )
}

/// That a recorded quantity has the name of something else.
fn other_name(name: &str, own: &str) -> String {
    format!(
        "the recording has a channel `{name}`, and in the model `{name}` is something else, which does not follow it: the channel is called `{own}` here, and has to be called so in the recording for a written model that reads it"
    )
}
