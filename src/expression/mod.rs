//! The expression language of models and formulas: parse, print, check dimensions.
