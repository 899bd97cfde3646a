//! Why the modes of a record lead to no stiffness.

/// What the sensors lack.
#[derive(Clone, Debug, PartialEq)]
pub enum WithoutStiffness {
    /// No channel has both a position and a direction.
    NoPlace,
    /// No sensor points within 15° of x or y.
    OffTheAxes {
        /// Names of those that have a position and a direction.
        channels: Vec<String>,
    },
}

impl std::fmt::Display for WithoutStiffness {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            WithoutStiffness::NoPlace => write!(
                f,
                "no stiffness is sought: no channel has both a position and a direction; give both to those that stand on the structure"
            ),
            WithoutStiffness::OffTheAxes { channels } => write!(
                f,
                "no stiffness is sought: no sensor points within 15° of x or y ({} do not); turn the axes of the project with the sensors, or give the \
                 direction in which each measures",
                channels.join(", ")
            ),
        }
    }
}
