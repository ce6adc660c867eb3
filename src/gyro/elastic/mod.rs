//! How the centre of mass gives way: one elastic part a file, and their [`Assembly`].

mod assembly;
mod backlash;
mod compliance;
mod follower;
mod friction;
mod in_time;
mod inertia;
mod lag;
mod option;
mod part;
mod pendulum;
mod relaxing;
mod slosh;
mod suspension;

pub use assembly::{Assembly, together};
pub use backlash::Backlash;
pub use compliance::Compliance;
pub use friction::Friction;
pub use in_time::InTime;
pub use inertia::Inertia;
pub use lag::Lag;
pub use option::{Asked, Given, PartOption};
pub use part::{Boxed, Elastic, Letters};
pub use pendulum::Pendulum;
pub use relaxing::Relaxing;
pub use slosh::Slosh;
pub use suspension::{Flow, Suspension, Swing, Tilt};

/// The parts that can be asked for beside the lag: one a line, each described by its own file.
pub const PARTS: [&Asked; 7] = [
    &inertia::ASKED,
    &relaxing::ASKED,
    &slosh::ASKED,
    &pendulum::ASKED,
    &compliance::ASKED,
    &friction::ASKED,
    &backlash::ASKED,
];

/// The parts that options ask for, by name and numbers in SI; [`together`] makes one of them.
///
/// ```
/// use gyrospec::gyro::elastic::asked;
/// let parts = asked(|option| (option == "friction").then(|| vec![2.0]));
/// assert_eq!(parts[0].name(), "dry friction");
/// assert!(asked(|_| None).is_empty());
/// ```
pub fn asked(given: impl Fn(&str) -> Option<Vec<f64>>) -> Vec<Box<dyn Elastic>> {
    let made = |part: &&Asked| {
        let numbers: Vec<Option<Vec<f64>>> = part.options.iter().map(|o| given(o.name)).collect();
        numbers.iter().any(Option::is_some).then(|| (part.make)(&numbers))
    };
    PARTS.iter().filter_map(made).collect()
}
