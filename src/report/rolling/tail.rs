//! What is said of the mean error by frequencies far above the motion's own.

use crate::gyro::Tail;
use crate::units::significant;
use std::fmt::Write;

/// How much the tail counts for, and what to do about it. A share is that of [`Tail::share_above`]: what moving the
/// end of the band above a frequency changes the mean by, of the largest of these means.
pub fn text(tail: &Tail) -> String {
    let mut out = if tail.white {
        "This motion's acceleration has a white tail (infinite variance), which no ship has.".to_owned()
    } else {
        "This motion still moves where no ship does.".to_owned()
    };
    let _ = write!(
        out,
        " Where its band ends,\nabove {} rad/s, changes the mean by up to {} of the largest. On heading 45° it is",
        significant(tail.from, 3),
        percent(tail.share())
    );
    for (omega, mean, share) in tail.table() {
        let (mean, omega) = (mean.to_degrees(), significant(omega, 3));
        let _ = write!(out, " {mean:.3}° up to {omega} rad/s ({} by ends above),", percent(share));
    }
    let _ = writeln!(out, "\nand {:.3}° with all of them.", tail.whole.to_degrees());
    if tail.is_much() {
        out.push_str(
            "Say --band with the frequency above which this ship does not move: the answer depends on it. Its end is soft,\n\
             two low-passes that leave a quarter of the power at that frequency.\n",
        );
    }
    out
}

fn percent(share: f64) -> String {
    if share < 0.005 { "less than 1 %".to_owned() } else { format!("{:.0} %", 100.0 * share) }
}
