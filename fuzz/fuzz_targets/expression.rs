//! Expressions: what is read prints to a text that reads as the same tree.
#![no_main]

use gyrospec::expression::Expr;

libfuzzer_sys::fuzz_target!(|text: &str| {
    if let Ok(tree) = Expr::parse(text) {
        assert_eq!(Expr::parse(&tree.to_string()).ok(), Some(tree));
    }
});
