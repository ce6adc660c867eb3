//! A diagnosis as text and as a page with pictures.

mod html;
mod svg;
mod text;

pub use html::html;
pub use text::text;
