//! The model file: expressions, dimensions, dual numbers, built-in models.
