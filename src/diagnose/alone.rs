//! Marks by which a law may act in one recording of several alone.
//!
//! # Purpose
//! Between two trials a weight was put down, a damper filled or a sensor set anew. What is the same over a whole recording and
//! another in the next goes with no signal, and every law that can hold a value for a recording would be taken for it.
//!
//! # Method
//! Each recording has a mark: a parameter that is 1 in it and 0 elsewhere. An offset, a constant force or another value of a
//! parameter times a mark is a law like any other.

use super::catalogue::Alone;
use super::catalogue::edit::free_name;
use crate::model::Model;
use crate::record::{Kind, Recording};
use std::borrow::Cow;

/// Recordings that are marked at most: more of them are a fleet, whose members are compared otherwise.
const MOST: usize = 5;

/// The recordings with their marks, where there are several.
pub fn marked<'r>(model: &Model, recordings: &'r [Recording]) -> Cow<'r, [Recording]> {
    let is_asked =
        (2..=MOST).contains(&recordings.len()) && recordings.iter().all(|r| r.kind != Kind::Trials);
    if !is_asked {
        return Cow::Borrowed(recordings);
    }
    let mut all = recordings.to_vec();
    for k in 0..all.len() {
        let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let wanted = format!("in_{}", all[k].name.chars().map(plain).collect::<String>());
        let is_taken = |n: &str| all.iter().any(|r| r.find(n).is_some() || r.mark.as_deref() == Some(n));
        all[k].mark = Some(free_name(model, &wanted, is_taken));
    }
    Cow::Owned(all)
}

/// The marks of recordings; pieces of one have the same.
pub fn marks(recordings: &[Recording]) -> Vec<Alone> {
    let mut found: Vec<Alone> = Vec::new();
    for r in recordings {
        let Some(mark) = r.mark.clone().filter(|m| found.iter().all(|a| a.mark != *m)) else { continue };
        let recording = r.name.split(", piece ").next().unwrap_or(&r.name).to_owned();
        found.push(Alone { mark, recording });
    }
    found
}
