//! Integrals with letters: tables, formulas, rendering, audit.
