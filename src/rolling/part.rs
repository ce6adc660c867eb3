//! The elastic parts that a compass may have.

use crate::gyro::elastic::{Backlash, Compliance, Elastic, Friction, Inertia, Lag, Relaxing};

/// What gives way in a compass: one variant an elastic part of [`gyro::elastic`](crate::gyro::elastic).
#[derive(Debug, Clone, Copy)]
pub enum Part {
    /// (2.3).
    Lag,
    /// (2.2).
    Inertia,
    /// A second relaxation beside the lag.
    Flow(Relaxing),
    /// Along more than one direction.
    Compliance(Compliance),
    /// Dry friction.
    Friction(Friction),
    /// Free play.
    FreePlay(Backlash),
}

impl Part {
    /// The part itself.
    ///
    /// ```
    /// assert_eq!(gyrospec::rolling::Part::Inertia.elastic().name(), "lag with inertia (2.2)");
    /// ```
    pub fn elastic(self) -> Box<dyn Elastic> {
        match self {
            Self::Lag => Box::new(Lag),
            Self::Inertia => Box::new(Inertia),
            Self::Flow(part) => Box::new(part),
            Self::Compliance(part) => Box::new(part),
            Self::Friction(part) => Box::new(part),
            Self::FreePlay(part) => Box::new(part),
        }
    }

    /// Whether it is linear, so that its errors are exact and not simulated.
    pub fn is_linear(self) -> bool {
        !matches!(self, Self::Friction(_) | Self::FreePlay(_))
    }

    /// Whether it gives way along the vertical, which changes no mean.
    pub fn is_vertical(self) -> bool {
        matches!(self, Self::Compliance(Compliance { vertical: Some(_), .. }))
    }
}
