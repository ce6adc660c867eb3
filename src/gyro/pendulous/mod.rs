//! A single-rotor compass of Sperry's kind, and what is to be known of it on a voyage.

mod compass;
mod voyage;

pub use compass::{Corrector, PendulousCompass};
pub use voyage::{AtLatitude, OnHeading, SettledVoyage, Voyage};
