//! What the modes of a survey say of a building's storey in plan.

use dolmen::structure::building::{Outline, PlanMode, PlanStiffness, PlanStorey};

/// What the modes of a survey say of the storey of a building with one floor.
#[derive(Clone, Debug)]
pub struct PlanAnswer {
    /// The modes that went in, ascending.
    pub modes: Vec<PlanMode>,
    /// The floor that they are of.
    pub storey: PlanStorey,
    /// Its outline in plan, if that is known.
    pub outline: Option<Outline>,
    /// Its centre of mass in plan, m.
    pub centre_of_mass_m: [f64; 2],
    /// The stiffness that the file has.
    pub written: Written,
    /// Every solution.
    pub found: PlanStiffness,
    /// Load factor λ with each solution, in the same order.
    pub load_factors: Vec<f64>,
    /// A twist is given, but not those of both modes along x and y: it was not used.
    pub twist_unused: bool,
}

/// The stiffness of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// k_x, k_y, N/m, k_θ about the centre of rigidity, N·m/rad.
    pub stiffness: [f64; 3],
    /// Centre of rigidity from the centre of mass, m.
    pub eccentricity_m: [f64; 2],
}
