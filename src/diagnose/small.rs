//! What is left beside findings for sure, and is too small to be one.
//!
//! # Method
//! Of what the last round fitted, the likeliest whose likelihood ratio stands and pays for its parameters is told, with what
//! is as likely, where it lowers the error by less than a further finding must. So small a thing may be noise of an input
//! or a law that is not quite the one that was found; who reads it can tell.

use super::choose::{CHANCE, TIE, gain, worth_of};
use super::measure::Measure;
use super::search::{Refitted, Round};
use super::words::sentence;

/// The note, where there is something to tell.
pub fn told(round: &Round, now: &Measure) -> Option<String> {
    let worth = |r: &Refitted| worth_of(&r.proposal, &r.measure) - now.likelihood;
    let stands = |r: &&Refitted| {
        r.p_value < CHANCE && worth(r) > TIE && gain(now, &r.measure) > 0.0 && !r.is_pressed() && !r.is_cut
    };
    let most = round.fitted.iter().filter(stands).max_by(|a, b| worth(a).total_cmp(&worth(b)))?;
    let falls = 100.0 * (1.0 - (-0.5 * gain(now, &most.measure)).exp());
    let mut codes = vec![most.proposal.code];
    for r in round.fitted.iter().filter(stands).filter(|r| worth(r) > worth(most) - TIE) {
        if !codes.contains(&r.proposal.code) {
            codes.push(r.proposal.code);
        }
    }
    let also = match &codes[1..] {
        [] => String::new(),
        others => format!("; {} would fit as well", others.join(", ")),
    };
    Some(format!(
        "something small is left for sure, too little to be named: it looks as if {}; that lowers the error by another \
         {falls:.1} % ({}{also})",
        sentence(&most.proposal, &most.fit),
        codes[0]
    ))
}
