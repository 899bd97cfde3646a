//! Results of the modes of a survey for the storey of a building in plan.

use crate::beside_file::BesideFile;
use dolmen::structure::building::{
    EccentricityFrom, Outline, PlanBounds, PlanMode, PlanSolution, PlanStiffness, PlanStorey,
};

/// Results of the modes of a survey for the storey of a building with one floor.
#[derive(Clone, Debug)]
pub struct PlanAnswer {
    /// The modes used, ascending.
    pub modes: Vec<PlanMode>,
    /// Their floor.
    pub storey: PlanStorey,
    /// Its outline in plan, if known.
    pub outline: Option<Outline>,
    /// Its centre of mass in plan, m.
    pub centre_of_mass_m: [f64; 2],
    /// The stiffness in the file.
    pub written: Written,
    /// Every solution.
    pub found: PlanStiffness,
    /// Load factor λ for each solution, in the same order.
    pub load_factors: Vec<f64>,
    /// Whether a given twist was not used, because that of the other mode along x or y is missing.
    pub twist_unused: bool,
    /// Bounds of the stiffness over every centre of rigidity on the floor, where the modes do not determine it.
    pub bounds: Option<PlanBounds>,
    /// The only solution compared with the stiffness of the file.
    pub beside_file: Option<BesideFile>,
    /// Sensors at the height of the floor that stand outside its sides.
    pub off_floor: Vec<String>,
    /// The record whose shapes determined the twists.
    pub from_record: Option<FromRecord>,
}

/// A record whose sensors determine the motion of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FromRecord {
    /// Number of sensors on the floor.
    pub sensors: usize,
    /// Number of its modes; the lowest three are used.
    pub modes_found: usize,
    /// Share of their shapes at the sensors that is not the motion of a rigid floor.
    pub unexplained: f64,
}

impl PlanAnswer {
    /// Smallest and largest coordinates of the corners of the floor along x and y, m.
    pub fn sides_m(&self) -> Option<[[f64; 2]; 2]> {
        let corners = self.outline.as_ref()?.corners_m();
        let side = |axis: usize| {
            let along = corners.iter().map(|corner| corner[axis]);
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
                [least.min(at), most.max(at)]
            })
        };
        Some([side(0), side(1)])
    }

    /// The solution, if only one is accepted and its centre of rigidity comes from the modes, not from the file.
    pub fn determined(&self) -> Option<&PlanSolution> {
        let mut accepted = self.found.accepted();
        let one = accepted.next().filter(|_| accepted.next().is_none());
        one.filter(|_| self.found.eccentricity_from == EccentricityFrom::Twists)
    }
}

/// The stiffness of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// k_x, k_y, N/m, k_θ about the centre of rigidity, N·m/rad.
    pub stiffness: [f64; 3],
    /// Centre of rigidity from the centre of mass, m.
    pub eccentricity_m: [f64; 2],
}
