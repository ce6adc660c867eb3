//! Elements of XML and their attributes.

use roxmltree::Node;

/// The first child of a name.
pub(super) fn child<'a, 'i>(of: &Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    of.children().find(|n| n.has_tag_name(name))
}

/// A finite number of an attribute.
pub(super) fn number(of: &Node<'_, '_>, key: &str) -> Option<f64> {
    of.attribute(key)?.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

/// Whether an attribute says so.
pub(super) fn is(of: &Node<'_, '_>, key: &str) -> bool {
    matches!(of.attribute(key), Some("true" | "1"))
}
