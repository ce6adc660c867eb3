//! Noise models, least squares, intervals.
