//! The effect of a damage on the model.

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
    /// The outward direction of the side, x and y.
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

/// The effect of a damage on the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InModel {
    /// A part of the bed below the part no longer bears.
    BedLost {
        /// Fraction of its width.
        share: f64,
        /// The side from which it is lost; `None` for a chain that moves in one direction.
        side: Option<Side>,
    },
    /// The remaining share of the stiffness of the joint below a link or stone, or of a storey.
    StiffnessLeft(f64),
    /// The dowels and clamps between a stone and the stones below it are broken.
    TiesBroken,
    /// A stone is missing.
    Lost,
    /// An earlier inspection gave one of these effects, and it was repaired since.
    Mended,
}

impl InModel {
    /// Whether it can be what a later inspection found of a damage that had this effect: the same effect on the same side, the loss of the
    /// stone, or its repair.
    pub(super) fn may_follow(self, earlier: InModel) -> bool {
        match (earlier, self) {
            (InModel::Mended, _) | (_, InModel::Mended | InModel::Lost) => true,
            (InModel::BedLost { side, .. }, InModel::BedLost { side: later, .. }) => side == later,
            (InModel::StiffnessLeft(_), InModel::StiffnessLeft(_))
            | (InModel::TiesBroken, InModel::TiesBroken) => true,
            (
                InModel::BedLost { .. } | InModel::StiffnessLeft(_) | InModel::TiesBroken | InModel::Lost,
                InModel::BedLost { .. } | InModel::StiffnessLeft(_) | InModel::TiesBroken,
            ) => false,
        }
    }
}
