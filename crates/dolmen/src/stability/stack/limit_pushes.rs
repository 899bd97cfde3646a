//! Possible forces of the joints and ties of a piece, as columns of its force balance.

/// Rows of the force balance, with the terms of a unit force in them.
pub(super) type Column = Vec<(usize, f64)>;

/// Possible forces of a joint or tie at one point: columns of the force balance, one per unknown component.
pub(super) enum Push {
    /// Coulomb's cone |f₁, f₂| ≤ f₀: columns of the normal and of μ times the two directions of the plane.
    Cone([Column; 3]),
    /// Compression only.
    Normal(Column),
    /// All stress blocks of one joint, each in Coulomb's cone; the sum of their forces over their single capacities is at most 1.
    Toes(Vec<ToePush>),
    /// Friction of given size at many points of one joint.
    Held(HeldFriction),
    /// Any direction in a plane up to a strength (over the weight), which may be infinite.
    Disc([Column; 2], f64),
    /// Tension only, up to a strength (over the weight), which may be infinite.
    Pull(Column, f64),
}

impl Push {
    /// Whether its force has a limit beside its cone: the programme then has a variable for it.
    pub(super) fn is_bounded(&self) -> bool {
        match self {
            Push::Toes(_) | Push::Held(_) => true,
            Push::Disc(_, strength) | Push::Pull(_, strength) => strength.is_finite(),
            Push::Cone(_) | Push::Normal(_) => false,
        }
    }
}

/// Friction of given size at the points of one joint, shared equally.
pub(super) struct HeldFriction {
    /// Friction of all points together, over the weight.
    pub(super) strength: f64,
    /// For each point, the columns of unit forces along two directions of the plane.
    pub(super) points: Vec<[Column; 2]>,
}

/// One stress block: the columns of its cone, and the fraction of the joint's capacity per unit of force.
pub(super) struct ToePush {
    pub(super) parts: [Column; 3],
    pub(super) share: f64,
}
