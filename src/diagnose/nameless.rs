//! What of what a model leaves no law explains: what is no noise, and what wanders.

use super::innovations::Unlike;
use super::wandering::Wanders;
use crate::model::Output;

/// What no law explains.
pub struct Nameless {
    /// What is no noise.
    pub unlike: Option<Unlike>,
    /// What wanders.
    pub wanders: Option<Wanders>,
    /// Whether what wanders is all that is left: a test is sure that something is, and there is no other reason.
    pub is_all: bool,
}

impl Nameless {
    /// The state that a disturbance drives which nobody recorded.
    pub fn driven(&self) -> Option<&str> {
        self.wanders.as_ref().filter(|_| self.is_all)?.driven.as_deref()
    }

    /// Why it is not nothing.
    pub fn says(&self, outputs: &[Output], rmse: &[f64]) -> Option<String> {
        let acts = || Some(self.wanders.as_ref()?.acts(self.driven()?));
        self.unlike.as_ref().map(|u| u.says(outputs, rmse)).or_else(acts)
    }

    /// What wanders, where it is told beside the verdict.
    pub fn beside(&self) -> Option<String> {
        self.wanders.as_ref().filter(|_| self.driven().is_none()).map(|w| w.says.clone())
    }
}
