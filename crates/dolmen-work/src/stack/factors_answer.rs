//! Factors on the springs of a stack's joints, from the modes of a survey.

use dolmen::blocks::{BesideInSmallMotion, JointFactors, StiffnessOf};
use dolmen::structure::LeftOut;
use dolmen::structure::stack::{Body, Stack};

/// Root mean square of the misfit, in standard deviations, up to which a common factor explains the modes. Our choice, as for
/// measured frequencies.
const MISFIT_MOST: f64 = 3.0;

/// Factors on the springs of a stack's joints, from the modes of a survey.
#[derive(Clone, Debug)]
pub struct FactorsAnswer {
    /// The stack in the file.
    pub stack: Stack,
    /// The factors.
    pub found: JointFactors,
    /// Modes of the survey's records that are not along x or y.
    pub left_out: Vec<LeftOut>,
    /// The role of each side support: a spring without a factor, or none.
    pub beside: Vec<BesideInSmallMotion>,
    /// Directions of the survey without sway of a stack.
    pub other_directions: Vec<String>,
    /// Whether modes of records are among them, counted from the lowest in the record.
    pub is_from_record: bool,
}

impl FactorsAnswer {
    /// The stones of a factor's joint, or for a bed the stones on it.
    pub fn names(&self, factor: usize) -> [Vec<&str>; 2] {
        let joints = self.found.factors.get(factor).map_or(&[][..], |of| &of.joints);
        let joints = joints.iter().filter_map(|&joint| self.stack.joints().get(joint));
        let (mut upper, mut lower): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
        for joint in joints {
            for (names, name) in [
                (&mut upper, self.stack.name(Body::Block(joint.upper))),
                (&mut lower, self.stack.name(joint.lower)),
            ] {
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        }
        [upper, lower]
    }

    /// K_n and K_s of the file, Pa/m, for a factor; `None` if its joints differ.
    pub fn drawn_stiffness_pa_m(&self, factor: usize) -> Option<[f64; 2]> {
        let joints = &self.found.factors.get(factor)?.joints;
        let of = |joint: &usize| {
            let material = self.stack.joints()[*joint].material;
            [material.normal_stiffness_pa_m, material.shear_stiffness_pa_m]
        };
        let first = of(joints.first()?);
        joints.iter().all(|joint| of(joint) == first).then_some(first)
    }

    /// Whether no common factor for all springs explains the modes.
    pub fn common_misses(&self) -> bool {
        self.found.common.misfit > MISFIT_MOST
    }

    /// Root mean square misfit of the best factors, in standard deviations, if none explain the modes; if a factor for each bed was not
    /// sought, that of the common factor.
    pub fn misfit(&self) -> Option<f64> {
        match self.found.explains {
            Some(true) => None,
            Some(false) => self.found.best_misfit,
            None => self.common_misses().then_some(self.found.common.misfit),
        }
    }

    /// Whether a factor is common to all joints of a bed.
    pub fn is_of_beds(&self) -> bool {
        self.found.of == StiffnessOf::Bed
    }
}
