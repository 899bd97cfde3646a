//! The numbers of a run, by kind of structure, with their names.

use super::kind::StudyKind;

/// Defines a struct of numbers whose fields are also the columns of tables, in their order.
macro_rules! measures {
    ($(#[$about:meta])* $name:ident { $($(#[$of:meta])* $field:ident),+ $(,)? }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            $($(#[$of])* pub $field: f64,)+
        }

        impl $name {
            /// Names of the numbers, units last.
            pub const NAMES: &'static [&'static str] = &[$(stringify!($field)),+];

            /// The numbers in the order of their names.
            fn values(&self) -> Vec<f64> {
                vec![$(self.$field),+]
            }

            /// From numbers in the order of their names; `None` if their count differs.
            fn of_values(values: &[f64]) -> Option<Self> {
                let [$($field),+] = values else { return None };
                Some($name { $($field: *$field),+ })
            }
        }
    };
}

measures! {
    /// The numbers of a run of a stack.
    StackMeasures {
        /// Largest opening of a joint, m.
        peak_uplift_m,
        /// Largest slip of a joint, m.
        peak_slip_m,
        /// Largest residual slip, m.
        residual_slip_m,
        /// Largest residual slip relative to the width of its joint, –.
        residual_slip_ratio,
        /// Largest rocking of a joint relative to its slenderness angle, –.
        peak_rocking_ratio,
        /// Largest tilt of a stone, rad.
        peak_tilt_rad,
        /// Largest residual tilt, rad.
        residual_tilt_rad,
        /// Largest twist of a joint, rad.
        peak_yaw_rad,
        /// Energy created by the integration relative to the input, –.
        energy_made_ratio,
        /// Time step, s.
        time_step_s,
    }
}

measures! {
    /// The numbers of a run of a frame.
    FrameMeasures {
        /// Largest displacement of the top, m.
        peak_displacement_m,
        /// Largest drift of a storey, m.
        peak_drift_m,
        /// Largest drift ratio of a storey, –.
        peak_drift_ratio,
        /// Largest drift ratio of a storey, including the surveyed lean, –.
        peak_lean_ratio,
        /// Residual displacement of the top, m.
        residual_displacement_m,
        /// Largest residual drift, m.
        residual_drift_m,
        /// Largest share of the time in which a storey slips, –.
        slipping_share,
        /// Largest accumulated slip of a storey, m.
        slipped_way_m,
        /// Deepest crushing of a face of a tenon, m; NaN without tenons that can crush.
        crushed_depth_m,
        /// Energy error of the integration, –.
        energy_left_over_ratio,
    }
}

measures! {
    /// The numbers of a run of a chain.
    ChainMeasures {
        /// Largest displacement of the top, m.
        peak_top_displacement_m,
        /// Largest rotation of a link, rad.
        peak_rotation_rad,
        /// Largest rotation of a joint, rad.
        peak_joint_rotation_rad,
        /// Largest share of the time in which a joint is open, –.
        open_share,
        /// Largest accumulated rotation of a joint against friction, rad.
        slipped_rad,
        /// Largest residual rotation, rad.
        residual_rotation_rad,
        /// Energy error of the integration, –.
        energy_left_over_ratio,
    }
}

measures! {
    /// The numbers of a run of a building.
    BuildingMeasures {
        /// Largest displacement of the top along x or y, m.
        peak_top_displacement_m,
        /// Largest drift of a storey along x or y, m.
        peak_drift_m,
        /// Largest drift at a corner, in any direction, m.
        peak_corner_drift_m,
        /// The same relative to the height of its storey, –.
        peak_corner_drift_ratio,
        /// Largest shear of the base along x, N.
        base_shear_x_n,
        /// Largest shear of the base along y, N.
        base_shear_y_n,
        /// Largest torque of the base, N m.
        base_torque_n_m,
        /// Largest stroke of a damper, m.
        peak_stroke_m,
        /// Largest stroke relative to the room of its damper, –.
        stroke_over_room,
    }
}

/// The numbers of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RunMeasures {
    /// Nothing was run.
    #[default]
    None,
    /// Measures of a stack.
    Stack(StackMeasures),
    /// Measures of a frame.
    Frame(FrameMeasures),
    /// Measures of a chain.
    Chain(ChainMeasures),
    /// Measures of a building.
    Building(BuildingMeasures),
}

impl RunMeasures {
    /// Names of the numbers of a kind, units last.
    pub fn names(kind: StudyKind) -> &'static [&'static str] {
        match kind {
            StudyKind::Stack => StackMeasures::NAMES,
            StudyKind::Frame => FrameMeasures::NAMES,
            StudyKind::Chain => ChainMeasures::NAMES,
            StudyKind::Building => BuildingMeasures::NAMES,
        }
    }

    fn own_names(&self) -> &'static [&'static str] {
        match self {
            RunMeasures::None => &[],
            RunMeasures::Stack(_) => StackMeasures::NAMES,
            RunMeasures::Frame(_) => FrameMeasures::NAMES,
            RunMeasures::Chain(_) => ChainMeasures::NAMES,
            RunMeasures::Building(_) => BuildingMeasures::NAMES,
        }
    }

    /// Whether nothing was run.
    pub fn is_none(&self) -> bool {
        matches!(self, RunMeasures::None)
    }

    /// The numbers in the order of their names; empty if nothing was run.
    pub fn values(&self) -> Vec<f64> {
        match self {
            RunMeasures::None => Vec::new(),
            RunMeasures::Stack(of) => of.values(),
            RunMeasures::Frame(of) => of.values(),
            RunMeasures::Chain(of) => of.values(),
            RunMeasures::Building(of) => of.values(),
        }
    }

    /// The number of a name; `None` if nothing was run, or if runs of this kind have no such number.
    pub fn named(&self, name: &str) -> Option<f64> {
        let place = self.own_names().iter().position(|own| *own == name)?;
        self.values().get(place).copied()
    }

    /// From numbers in the order of the names of a kind; the empty state from no numbers; `None` if their count differs.
    pub fn of_values(kind: StudyKind, values: &[f64]) -> Option<Self> {
        if values.is_empty() {
            return Some(RunMeasures::None);
        }
        Some(match kind {
            StudyKind::Stack => RunMeasures::Stack(StackMeasures::of_values(values)?),
            StudyKind::Frame => RunMeasures::Frame(FrameMeasures::of_values(values)?),
            StudyKind::Chain => RunMeasures::Chain(ChainMeasures::of_values(values)?),
            StudyKind::Building => RunMeasures::Building(BuildingMeasures::of_values(values)?),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_numbers_come_back_under_their_names() {
        for kind in [
            StudyKind::Stack,
            StudyKind::Frame,
            StudyKind::Chain,
            StudyKind::Building,
        ] {
            let names = RunMeasures::names(kind);
            let values: Vec<f64> = (0..names.len()).map(|n| n as f64).collect();
            let made = RunMeasures::of_values(kind, &values).unwrap();
            assert_eq!(made.values(), values);
            for (name, value) in names.iter().zip(&values) {
                assert_eq!(made.named(name), Some(*value), "{kind:?} {name}");
            }
            assert_eq!(RunMeasures::of_values(kind, &values[1..]), None);
            assert_eq!(RunMeasures::of_values(kind, &[]), Some(RunMeasures::None));
        }
    }
}
