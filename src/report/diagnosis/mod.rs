//! A diagnosis as text and as a page with pictures.

mod figures;
mod html;
mod tables;
mod text;

pub use html::{html, page};
pub use text::text;
