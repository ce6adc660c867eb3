//! How the centre of mass gives way: one elastic part a file.

mod backlash;
mod compliance;
mod follower;
mod friction;
mod in_time;
mod inertia;
mod lag;
mod option;
mod part;
mod relaxing;
mod slosh;

pub use backlash::Backlash;
pub use compliance::Compliance;
pub use friction::Friction;
pub use in_time::InTime;
pub use inertia::Inertia;
pub use lag::Lag;
pub use option::{Asked, Given, PartOption};
pub use part::{Boxed, Elastic, Letters};
pub use relaxing::Relaxing;
pub use slosh::Slosh;

/// The parts that can be asked for beside the lag: one a line, each described by its own file.
pub const PARTS: [&Asked; 6] = [
    &inertia::ASKED,
    &relaxing::ASKED,
    &slosh::ASKED,
    &compliance::ASKED,
    &friction::ASKED,
    &backlash::ASKED,
];

/// The part that options ask for, by name and numbers in SI; `None` where no option is of a part.
///
/// ```
/// use gyrospec::gyro::elastic::asked;
/// let part = asked(|option| (option == "friction").then(|| vec![2.0])).unwrap();
/// assert_eq!(part.name(), "dry friction");
/// assert!(asked(|_| None).is_none());
/// ```
pub fn asked(given: impl Fn(&str) -> Option<Vec<f64>>) -> Option<Box<dyn Elastic>> {
    PARTS.iter().find_map(|part| {
        let numbers: Vec<Option<Vec<f64>>> = part.options.iter().map(|o| given(o.name)).collect();
        numbers.iter().any(Option::is_some).then(|| (part.make)(&numbers))
    })
}
