//! The rolling error of a gyrocompass as text, as JSON, as a picture, as a page with pictures and as a deviation card.

mod approval;
mod card;
mod deviation;
mod distribution;
#[cfg(feature = "symbolic")]
mod formula;
mod free;
mod instruments;
mod json;
mod page;
mod recorded;
mod sea;
mod spectrum;
mod tail;
mod text;
mod words;

pub use approval::{approval_json, approval_page, approval_text};
pub use card::card;
pub use deviation::{deviation_csv, deviation_json, deviation_sheet, deviation_text};
#[cfg(feature = "symbolic")]
pub use formula::{formula_json, formula_text};
pub use free::free_text;
pub use instruments::instruments_text;
pub use json::json;
pub use page::{Sheet, page};
pub use spectrum::{spectrum_json, spectrum_page, spectrum_text};
pub use text::text;
