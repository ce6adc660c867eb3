//! A compass with a liquid ballistic on a voyage, as text, as JSON and as a page with pictures.

mod json;
mod page;
mod text;

pub use json::json;
pub use page::page;
pub use text::text;
