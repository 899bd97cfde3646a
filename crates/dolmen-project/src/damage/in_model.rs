//! What a damage means for the model.

/// The side of a bed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Towards x.
    XPlus,
    /// Away from x.
    XMinus,
    /// Towards y.
    YPlus,
    /// Away from y.
    YMinus,
}

impl Side {
    /// The direction out of the bed, x and y.
    pub fn outward(self) -> [f64; 2] {
        match self {
            Side::XPlus => [1.0, 0.0],
            Side::XMinus => [-1.0, 0.0],
            Side::YPlus => [0.0, 1.0],
            Side::YMinus => [0.0, -1.0],
        }
    }

    /// The word in a project file: "x+".
    pub fn word(self) -> &'static str {
        match self {
            Side::XPlus => "x+",
            Side::XMinus => "x-",
            Side::YPlus => "y+",
            Side::YMinus => "y-",
        }
    }

    /// Whether it is a side along y.
    pub(crate) fn is_across(self) -> bool {
        matches!(self, Side::YPlus | Side::YMinus)
    }
}

/// What a damage means for the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InModel {
    /// A part of the bed below the part no longer bears.
    BedLost {
        /// Share of its width.
        share: f64,
        /// The side from which it is lost; `None` of a chain that moves in one direction.
        side: Option<Side>,
    },
    /// What is left of the stiffness of the joint below a link or stone, or of a storey.
    StiffnessLeft(f64),
    /// The dowels and clamps between a stone and what it stands on are broken.
    TiesBroken,
    /// A stone is gone.
    Lost,
    /// An earlier inspection said one of these, and it was mended since.
    Mended,
}
