//! The table of errors as text.

use super::{recorded, words};
use crate::gyro::{HeadingError, SIGN, SimulatedError};
use crate::rolling::{Against, Row, Table};
use std::fmt::Write;

/// The table as text, with what of it to trust.
///
/// ```
/// use gyrospec::Silent;
/// use gyrospec::rolling::{Against, Compass, Excitation, Request};
/// let (_, roll, _) = gyrospec::gyro::seed::example_3_1();
/// let request = Request {
///     compass: Compass::paper(),
///     excitation: Excitation::irregular(roll),
///     against: Against::card(45),
///     days: None,
/// };
/// let text = gyrospec::report::rolling::text(&request.table(&Silent)?);
/// assert!(text.contains("heading °        mean") && text.contains("45.0"));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn text(table: &Table) -> String {
    let mut out = table.recorded.as_ref().map_or_else(String::new, recorded::told);
    let s = &table.compass.sphere;
    let latitude = format!("latitude {:.1}°", s.latitude.to_degrees());
    let place = match table.against {
        Against::Latitude { heading } => format!("heading {:.0}°", heading.to_degrees()),
        Against::Heading(_) => latitude,
        Against::Height { heading } => format!("heading {:.0}°, {latitude}", heading.to_degrees()),
    };
    let _ = writeln!(
        out,
        "Heading error of a gyrocompass by rolling, {place}; h = {} m above the roll axis\n\
         compass: {}; elastic part: {}\nmotion: {}\nsign: {SIGN}\n{}\n",
        s.lever,
        words::origin(&table.compass.origin),
        words::part(table.compass.part.name()),
        words::motion(table),
        words::PARTS_OF_SPREAD
    );
    let beyond = words::beyond(&table.smallness);
    if !beyond.is_empty() {
        let _ = writeln!(out, "{beyond}\n");
    }
    out.push_str(&heads(table));
    table.rows.iter().for_each(|r| line(&mut out, r));
    out.push('\n');
    if table.compass.speed != 0.0 {
        out.push_str("The mean holds the error of course and speed, v_N/(R U cos φ + v_E).\n");
    }
    out + &words::note(table)
}

fn line(out: &mut String, row: &Row) {
    let e = &row.error;
    let _ = write!(
        out,
        "{:>9}   {:>10.5}° ±{:>9.5}°  {:>9.5}°  {:>9.5}°",
        format!("{:.1}", row.value),
        words::plain(e.mean().to_degrees()),
        e.deviation.to_degrees(),
        e.deviation_linear.to_degrees(),
        e.deviation_quadratic.to_degrees()
    );
    if !row.is_exact() {
        out.push_str(&within(e));
    }
    if let Some(summed) = row.summed {
        let _ = write!(out, "   {:>10.5}°", words::plain(summed.to_degrees()));
    }
    if let Some(measured) = row.measured {
        let _ = write!(out, "   {:>10.5}°", words::plain(measured.to_degrees()));
    }
    if let Some(m) = &row.simulated {
        let _ = write!(out, "   {}", beside(m));
    }
    out.push('\n');
}

fn heads(table: &Table) -> String {
    let any = |has: fn(&Row) -> bool| table.rows.iter().any(has);
    let first = match table.against {
        Against::Heading(_) => "heading °",
        Against::Latitude { .. } => "latitude °",
        Against::Height { .. } => "height m",
    };
    let mut out = format!("{first:>10}        mean  ±  spread   of it quick     slow");
    if any(|r| !r.is_exact()) {
        out.push_str("   mean within");
    }
    if any(|r| r.error.linearised.is_some()) {
        out.push_str("   linearised");
    }
    if any(|r| r.summed.is_some()) {
        out.push_str("   mean by sums");
    }
    if any(|r| r.measured.is_some()) {
        out.push_str("   mean, measured spectrum");
    }
    if any(|r| r.simulated.is_some()) {
        out.push_str("   simulated: mean (99 %), spread (99 %)");
    }
    out + "\n"
}

/// The margin of a mean that was simulated, and what a linear part in its place would give.
fn within(e: &HeadingError) -> String {
    let margin = format!("   ±{:.5}° ", e.rectified_margin.to_degrees());
    let Some(linearised) = e.linearised else { return margin };
    let off = match e.rectified {
        0.0 => String::new(),
        true_one => format!(" ({:+.0} %)", 100.0 * (linearised / true_one - 1.0)),
    };
    let mean = words::plain((e.mean() - e.rectified + linearised).to_degrees());
    format!("{margin}  {mean:>10.5}°{off}")
}

fn beside(m: &SimulatedError) -> String {
    let spread = m.variance.max(0.0).sqrt();
    let margin = if spread > 0.0 { 0.5 * m.variance_margin / spread } else { 0.0 };
    format!(
        "{:.5}° (±{:.5}), {:.5}° (±{:.5})",
        m.mean.to_degrees(),
        m.mean_margin.to_degrees(),
        spread.to_degrees(),
        margin.to_degrees()
    )
}
