//! The closed list of units: parse, convert, check dimensions.
