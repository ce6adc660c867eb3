//! The spectral integral I_n.
