//! The rolling error as it is asked for: a compass, what moves the ship, and the rows wanted.
//!
//! `gyrospec roll-error` parses words into these types and prints what comes back; programs in Rust and Python call
//! the same.
//!
//! ```
//! use gyrospec::Silent;
//! use gyrospec::gyro::seed;
//! use gyrospec::rolling::{Against, Compass, Excitation, Request};
//! // Example 3.1 of the paper
//! let (sphere, roll, heading) = seed::example_3_1();
//! let request = Request {
//!     compass: Compass { sphere, ..Compass::paper() },
//!     excitation: Excitation::irregular(roll),
//!     against: Against::Heading(vec![heading]),
//!     days: None,
//! };
//! let table = request.table(&Silent)?;
//! assert!((table.rows[0].error.mean().to_degrees() + 4.497).abs() < 5e-4);
//! # Ok::<(), gyrospec::Error>(())
//! ```

mod against;
mod analysis;
mod card;
mod case;
#[cfg(feature = "symbolic")]
mod closed_form;
#[cfg(feature = "symbolic")]
mod closed_motion;
mod compass;
mod equations;
mod error_spectrum;
mod excitation;
mod free;
mod obstacle;
mod recorded;
mod request;
mod scorsby;
mod table;
mod table_answer;
mod trials;
mod waves;

pub use against::Against;
pub use analysis::{Analysis, FAST_SHARE, SLOW, STEADY, analyse};
pub use card::{Card, Column};
pub use case::{Days, Row};
#[cfg(feature = "symbolic")]
pub use closed_form::{ClosedForm, ClosedValues, closed_form, closed_values};
#[cfg(feature = "symbolic")]
pub use closed_motion::closed_form_on;
pub use compass::{Compass, Origin};
pub use error_spectrum::{Density, ErrorSpectrum, error_spectrum};
pub use excitation::{Excitation, ShipMotion, Source};
pub use free::{LeftAlone, left_alone};
pub use obstacle::Obstacle;
pub use recorded::Recorded;
pub use request::{Prepared, Request};
pub use scorsby::{Approval, Scorsby, TableError, TableMotion};
pub use table::{MeasuredRoll, Table};
pub use trials::{Identification, TrialRow, identification};
pub use waves::{SeaMotion, Waves};
