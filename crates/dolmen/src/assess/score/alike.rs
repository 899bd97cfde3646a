//! Checks that a pagoda resembles the training pagodas of the score, apart from its six factors.

use crate::structure::stack::{Joint, JointMaterial, PagodaFactors, Stack};
use std::fmt;

/// Relative difference up to which a material counts as that of the designs. Our choice: granite is 2600 to 2700 kg/m³.
const ALIKE: f64 = 0.05;

/// A difference between a stack and the training pagodas of the score.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unlike {
    /// A quantity of a joint or a stone differs.
    Quantity {
        /// The quantity.
        quantity: UnlikeQuantity,
        /// Value of the stack.
        given: f64,
        /// Value of the designs.
        trained: f64,
    },
    /// Joints have cohesion or tension.
    Bonds,
    /// The stack has dowels or clamps.
    Ties,
    /// The stack has side supports.
    SideSupports,
    /// Static loads act on the stack.
    Loads,
    /// The supports of the stack move.
    SupportsMove,
    /// Edges of joints crush.
    Crushes {
        /// The least compressive strength of a joint, Pa.
        strength_pa: f64,
    },
    /// Inspections found damage that changes the model.
    Damage {
        /// Number of damages.
        count: usize,
    },
    /// It leans, by a survey.
    Leans {
        /// Horizontal / vertical, both directions combined.
        slope: f64,
    },
    /// The measured frequency differs from that of the model.
    Frequency {
        /// Measured frequency, Hz.
        measured_hz: f64,
        /// Frequency of the model, Hz.
        computed_hz: f64,
    },
}

/// A quantity of a joint or a stone that is not a factor of the score.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnlikeQuantity {
    /// Static friction coefficient, –.
    Friction,
    /// Kinetic friction coefficient, –.
    KineticFriction,
    /// Normal stiffness of a joint, Pa/m.
    NormalStiffness,
    /// Shear stiffness of a joint, Pa/m.
    ShearStiffness,
    /// Damping ratio of a joint, –.
    DampingRatio,
    /// Density, kg/m³.
    Density,
}

impl fmt::Display for UnlikeQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            UnlikeQuantity::Friction => "friction",
            UnlikeQuantity::KineticFriction => "kinetic friction",
            UnlikeQuantity::NormalStiffness => "normal stiffness in Pa/m",
            UnlikeQuantity::ShearStiffness => "shear stiffness in Pa/m",
            UnlikeQuantity::DampingRatio => "damping ratio of a joint",
            UnlikeQuantity::Density => "density in kg/m³",
        })
    }
}

impl fmt::Display for Unlike {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unlike::Quantity {
                quantity,
                given,
                trained,
            } => write!(f, "{quantity} is {given}, trained {trained}"),
            Unlike::Bonds => f.write_str("joints are bonded, trained dry"),
            Unlike::Ties => f.write_str("it has dowels or clamps, trained without"),
            Unlike::SideSupports => f.write_str("it has side supports, trained without"),
            Unlike::Loads => f.write_str("static loads act on it, trained without"),
            Unlike::SupportsMove => f.write_str("its supports move, trained on supports at rest"),
            Unlike::Crushes { strength_pa } => write!(
                f,
                "its edges crush at {:.3} MPa, trained without crushing",
                strength_pa / 1e6
            ),
            Unlike::Damage { count: 1 } => {
                f.write_str("it has one damage found by inspection, trained undamaged")
            }
            Unlike::Damage { count } => write!(
                f,
                "it has {count} damages found by inspections, trained undamaged"
            ),
            Unlike::Leans { slope } => write!(f, "it leans by 1/{:.0}, trained upright", 1.0 / slope),
            Unlike::Frequency {
                measured_hz,
                computed_hz,
            } => write!(
                f,
                "a survey measured {measured_hz:.2} Hz, a pagoda as trained has {computed_hz:.2} Hz"
            ),
        }
    }
}

/// All differences between a stack and the training pagodas, apart from the six factors: friction, stiffness, damping and density by more than 5 %,
/// bonds, ties, side supports, static loads, moving supports and edges that crush; empty if there are none. Call this before [`super::ScoreModel::score`], which uses
/// only the factors.
pub fn unlike_trained(stack: &Stack) -> Vec<Unlike> {
    let mut unlike: Vec<Unlike> = Vec::new();
    let mut see = |quantity, given: f64, trained: f64| {
        let found = Unlike::Quantity {
            quantity,
            given,
            trained,
        };
        let is_alike = (given - trained).abs() <= ALIKE * trained;
        if !is_alike && !unlike.contains(&found) {
            unlike.push(found);
        }
    };
    let usual = JointMaterial::default();
    for joint in stack.joints() {
        let own = &joint.material;
        for (quantity, given, trained) in [
            (
                UnlikeQuantity::Friction,
                own.friction_static,
                usual.friction_static,
            ),
            (
                UnlikeQuantity::KineticFriction,
                own.friction_kinetic,
                usual.friction_kinetic,
            ),
            (
                UnlikeQuantity::NormalStiffness,
                own.normal_stiffness_pa_m,
                usual.normal_stiffness_pa_m,
            ),
            (
                UnlikeQuantity::ShearStiffness,
                own.shear_stiffness_pa_m,
                usual.shear_stiffness_pa_m,
            ),
            (
                UnlikeQuantity::DampingRatio,
                own.damping_ratio,
                usual.damping_ratio,
            ),
        ] {
            see(quantity, given, trained);
        }
    }
    let density = PagodaFactors::default().density_kg_m3;
    for block in stack.blocks() {
        see(UnlikeQuantity::Density, block.density_kg_m3, density);
    }
    let has_bonds = |joint: &Joint| joint.material.cohesion_pa > 0.0 || joint.material.tension_pa > 0.0;
    for (is_so, found) in [
        (stack.joints().iter().any(has_bonds), Unlike::Bonds),
        (!stack.ties().is_empty(), Unlike::Ties),
        (!stack.side_supports().is_empty(), Unlike::SideSupports),
        (!stack.static_loads().is_empty(), Unlike::Loads),
        (!stack.support_movements().is_empty(), Unlike::SupportsMove),
    ] {
        if is_so {
            unlike.push(found);
        }
    }
    let strengths = stack
        .joints()
        .iter()
        .filter_map(|joint| joint.material.compressive_strength_pa);
    unlike.extend(
        strengths
            .reduce(f64::min)
            .map(|strength_pa| Unlike::Crushes { strength_pa }),
    );
    unlike
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, Placement, Solid};

    fn stack(material: JointMaterial, density_kg_m3: f64) -> Stack {
        let block = |name: &str, from_m| Block {
            name: name.into(),
            solid: Solid::cuboid(0.6, 0.6, 0.5).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, from_m],
                ..Placement::default()
            }),
            density_kg_m3,
        };
        Stack::new(vec![block("a", 0.0), block("b", 0.5)], material, 9.81).unwrap()
    }

    #[test]
    fn holds_each_difference_is_named_once_and_a_twentieth_is_none() {
        let usual = JointMaterial::default();
        let of = |material: JointMaterial, density| unlike_trained(&stack(material, density));
        assert_eq!(of(usual, 2600.0), []);
        assert_eq!(of(usual, 2700.0), []);
        assert_eq!(of(usual, 2300.0).len(), 1); // two blocks, reported once
        let slippery = JointMaterial {
            friction_static: 0.5,
            friction_kinetic: 0.5,
            ..usual
        };
        let words: Vec<String> = of(slippery, 2600.0).iter().map(Unlike::to_string).collect();
        let wanted = [
            "friction is 0.5, trained 0.6",
            "kinetic friction is 0.5, trained 0.6",
        ];
        assert_eq!(words, wanted);
        let crushed = JointMaterial {
            compressive_strength_pa: Some(1e6),
            ..usual
        };
        assert_eq!(of(crushed, 2600.0), [Unlike::Crushes { strength_pa: 1e6 }]);
        let bonded = JointMaterial {
            cohesion_pa: 1e4,
            normal_stiffness_pa_m: 2e9,
            ..usual
        };
        assert_eq!(
            of(bonded, 2600.0),
            [
                Unlike::Quantity {
                    quantity: UnlikeQuantity::NormalStiffness,
                    given: 2e9,
                    trained: 1e9
                },
                Unlike::Bonds
            ]
        );
    }
}
