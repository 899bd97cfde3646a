//! Numbers of a storey in plan with their units.

use dolmen::structure::building::PlanSolution;
use dolmen_words::{Digits, Quantity, Unit};

/// Suitable units for k_x, k_y, k_θ.
pub(super) struct Units {
    all: [Unit; 3],
}

impl Units {
    pub(super) fn of(all: impl Iterator<Item = [f64; 3]>) -> Self {
        let all: Vec<[f64; 3]> = all.collect();
        let lateral: Vec<f64> = all.iter().flat_map(|k| [k[0], k[1]]).collect();
        let turning: Vec<f64> = all.iter().map(|k| k[2]).collect();
        let (lateral, turning) = (Unit::of(&lateral, "N/m"), Unit::of(&turning, "N·m/rad"));
        Units {
            all: [lateral.clone(), lateral, turning],
        }
    }

    pub(super) fn unit(&self, at: usize) -> Unit {
        self.all[at].clone()
    }

    pub(super) fn stiffness(&self, one: &PlanSolution, at: usize) -> Quantity {
        Quantity {
            sd_si: one.stiffness_sd.map(|sd| sd[at]),
            ..Quantity::new(one.stiffness[at], self.all[at].clone(), Digits::Significant(4))
        }
    }
}

pub(super) fn eccentricity(one: &PlanSolution, at: usize) -> Quantity {
    Quantity {
        sd_si: one.eccentricity_sd_m.map(|sd| sd[at]),
        ..Quantity::new(one.eccentricity_m[at], Unit::si("m"), Digits::Fixed(3))
    }
}
