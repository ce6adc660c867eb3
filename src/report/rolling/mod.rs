//! The rolling error of a gyrocompass as text, as JSON, as a card and as a page with pictures.

mod approval;
mod card;
#[cfg(feature = "symbolic")]
mod formula;
mod free;
mod json;
mod page;
mod recorded;
mod tail;
mod text;
mod words;

pub use approval::{approval_json, approval_text};
pub use card::card;
#[cfg(feature = "symbolic")]
pub use formula::{formula_json, formula_text};
pub use free::free_text;
pub use json::json;
pub use page::{Sheet, page};
pub use text::text;
