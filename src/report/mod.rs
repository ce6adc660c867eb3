//! Text, JSON and HTML reports; computes nothing.
