//! Direction of a channel of a motion.

/// Direction of the positive numbers of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// Horizontal.
    Horizontal {
        /// From north, clockwise seen from above, °: 0 north, 90 east.
        azimuth_deg: f64,
    },
    /// Vertical.
    Up,
    /// Vertical, positive downwards.
    Down,
}

impl Orientation {
    pub(crate) const NORTH: Orientation = Orientation::Horizontal { azimuth_deg: 0.0 };
    pub(crate) const EAST: Orientation = Orientation::Horizontal { azimuth_deg: 90.0 };

    /// Horizontal at this azimuth, reduced to 0 … 360.
    pub(super) fn horizontal(azimuth_deg: f64) -> Option<Self> {
        azimuth_deg.is_finite().then(|| Orientation::Horizontal {
            azimuth_deg: azimuth_deg.rem_euclid(360.0),
        })
    }

    /// From the word for a direction: "180", "N-S", "UP", "DWN", "Deg" after an omitted number.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        match word.trim().to_uppercase().as_str() {
            "N-S" | "NS" | "N" | "NORTH" => Some(Self::NORTH),
            "E-W" | "EW" | "E" | "EAST" => Some(Self::EAST),
            "U-D" | "UD" | "UP" | "Z" | "VER" | "VERT" => Some(Orientation::Up),
            "DN" | "DWN" | "DOWN" => Some(Orientation::Down),
            number => match number.parse::<f64>() {
                Ok(degrees) if (0.0..=360.0).contains(&degrees) => Self::horizontal(degrees),
                _ => None,
            },
        }
    }

    /// From the last letter of a SEED channel code: N, E and Z point north, east and up within 5°; other letters state no direction.
    pub(crate) fn of_channel_code(code: &str) -> Option<Self> {
        match code.trim().chars().last() {
            Some('N') => Some(Self::NORTH),
            Some('E') => Some(Self::EAST),
            Some('Z') => Some(Orientation::Up),
            _ => None,
        }
    }
}

impl std::fmt::Display for Orientation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Orientation::Horizontal { azimuth_deg } => write!(f, "{azimuth_deg}° from north"),
            Orientation::Up => f.write_str("up"),
            Orientation::Down => f.write_str("down"),
        }
    }
}
