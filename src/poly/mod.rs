//! Polynomials over f64 and over exact numbers; roots; the Hurwitz test.
