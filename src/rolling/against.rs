//! What the rows run over.

/// What the rows of a table run over.
#[derive(Debug, Clone, PartialEq)]
pub enum Against {
    /// Headings, rad.
    Heading(Vec<f64>),
    /// Latitudes from 0 to 80°, on one heading (rad).
    Latitude {
        /// rad.
        heading: f64,
    },
    /// Significant heights of the sea from 0.5 to 8 m, on one heading (rad).
    Height {
        /// rad.
        heading: f64,
    },
}

impl Against {
    /// All headings at so many degrees from each other.
    ///
    /// ```
    /// let gyrospec::rolling::Against::Heading(all) = gyrospec::rolling::Against::card(15) else { panic!() };
    /// assert_eq!(all.len(), 24);
    /// ```
    pub fn card(step: usize) -> Self {
        Self::Heading((0..360).step_by(step.max(1)).map(|k| f64::from(k).to_radians()).collect())
    }
}
