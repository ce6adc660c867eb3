//! Machine code against an interpreter, and against itself.
#![cfg(feature = "jit")]

mod agree;
mod common;
mod march;
