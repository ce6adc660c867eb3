//! A model on a recording.
