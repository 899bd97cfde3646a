//! A chain with the behaviour of its joints: springs, dashpots, opening beds, dry friction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ_i | `across_rad` | θ_i − θ_{i−1}, rotation across joint i; θ_0 is the lean of the whole chain | rad |
//! | k_i | `stiffness_n_m_rad` | spring of joint i | N m/rad |
//! | d_i | `damping_n_m_s_rad` | dashpot of joint i | N m s/rad |
//! | N_i | | weight above joint i | N |
//! | b_i | `bed_width_m` | width of the bed in joint i | m |
//! | f_s, f_k | `static_moment_n_m`, `kinetic_moment_n_m` | moment of dry friction before and during rotation of the joint | N m |

use super::DynamicsError;
use super::chain_props::Prop;
use super::chain_rotations::ChainRotations;
use crate::structure::{Chain, StructureError};
use dolmen_linalg::generalized_symmetric_eigen;

/// Largest allowed lean of the whole chain, rad.
const LEAN_MOST_RAD: f64 = std::f64::consts::FRAC_PI_6;

/// Whether a joint opens.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum JointOpening {
    /// The joint carries any moment.
    #[default]
    Held,
    /// The moment is at most N b/2; then the stone above rotates about the edge of its bed.
    AtBedEdge,
}

/// Dry friction of a joint against rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum JointFriction {
    /// No friction.
    #[default]
    None,
    /// A slider in parallel with the spring: Coulomb's law without regularisation; sticking is exact.
    Coulomb {
        /// Moment at which the joint begins to rotate, N m; at least the kinetic one.
        static_moment_n_m: f64,
        /// Moment during rotation, N m.
        kinetic_moment_n_m: f64,
    },
}

impl JointFriction {
    /// Coulomb's law with equal static and kinetic moments.
    pub fn coulomb(moment_n_m: f64) -> Self {
        JointFriction::Coulomb {
            static_moment_n_m: moment_n_m,
            kinetic_moment_n_m: moment_n_m,
        }
    }

    /// Static and kinetic moment, N m; `None` without friction. A moment of 0 counts as no friction, because the joint would stick and slip at
    /// the same time.
    pub(super) fn moments_n_m(self) -> Option<[f64; 2]> {
        match self {
            JointFriction::Coulomb {
                static_moment_n_m,
                kinetic_moment_n_m,
            } if static_moment_n_m > 0.0 => Some([static_moment_n_m, kinetic_moment_n_m]),
            _ => None,
        }
    }
}

/// One joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainJoint {
    /// Stiffness k, N m/rad, 0 or positive.
    pub stiffness_n_m_rad: f64,
    /// Dashpot d, N m s/rad, 0 or positive.
    pub damping_n_m_s_rad: f64,
    /// Whether it opens.
    pub opening: JointOpening,
    /// Dry friction in parallel with the spring.
    pub friction: JointFriction,
}

impl ChainJoint {
    /// A spring that carries any moment, without a dashpot or friction.
    pub fn spring(stiffness_n_m_rad: f64) -> Self {
        ChainJoint {
            stiffness_n_m_rad,
            damping_n_m_s_rad: 0.0,
            opening: JointOpening::Held,
            friction: JointFriction::None,
        }
    }
}

/// A chain with its joints, for simulations of motion.
///
/// ```text
/// moment of joint i:  τ_i = k_i φ_i                                      held
///                     τ_i = k_i φ_i, at most N_i b_i/2 in size           at the edge of the bed
/// side support:       F = s (u − g) beyond its gap g, 0 within; u = Σ c_i sin θ_i
/// with friction:      τ_i + q_i, q_i = f_k sign φ_i' while the joint rotates; while it sticks φ_i' = 0 and |q_i| ≤ f_s
/// ```
///
/// # Limits
/// An open joint is elastic: its moment stays at N b/2, with N the weight above it at rest, and it closes on the same path. A landing stone
/// loses no energy, although a real bed dissipates some, and no stone slides. The moment of friction is a constant that adds to that of the
/// bed: it represents friction next to the bed (posts, dowels, packing). It does not represent friction in the bed itself, whose moment is
/// limited by the edge. The centre of rotation stays in the middle of the bed; the edge at b/2 is included only through the moment.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainModel {
    pub(super) chain: Chain,
    pub(super) joints: Vec<ChainJoint>,
    pub(super) rotations: ChainRotations,
    /// N b/2, infinite for a held joint.
    pub(super) moment_most_n_m: Vec<f64>,
    pub(super) lean_rad: f64,
    pub(super) props: Vec<Prop>,
}

impl ChainModel {
    /// A chain and its joints, lowest first.
    ///
    /// # Errors
    /// [`DynamicsError::ChainCount`] unless there is one joint per link; [`DynamicsError::ChainPart`] for a value out of range;
    /// [`DynamicsError::NoBedWidth`] for an opening joint without a bed width.
    pub fn new(
        chain: Chain,
        joints: Vec<ChainJoint>,
        rotations: ChainRotations,
    ) -> Result<Self, DynamicsError> {
        let needed = chain.links().len();
        if joints.len() != needed {
            return Err(DynamicsError::ChainCount {
                argument: "joints",
                given: joints.len(),
                needed,
            });
        }
        let mut moment_most_n_m = vec![f64::INFINITY; needed];
        let mut weight_n = 0.0;
        for (i, (joint, link)) in joints.iter().zip(chain.links()).enumerate().rev() {
            for (argument, given) in [
                ("stiffness_n_m_rad", joint.stiffness_n_m_rad),
                ("damping_n_m_s_rad", joint.damping_n_m_s_rad),
            ] {
                if !(given >= 0.0 && given.is_finite()) {
                    return Err(DynamicsError::ChainPart {
                        part: "joint",
                        number: i + 1,
                        argument,
                        given,
                        allowed: "0 or a positive number",
                    });
                }
            }
            if let JointFriction::Coulomb {
                static_moment_n_m,
                kinetic_moment_n_m,
            } = joint.friction
            {
                let part = |argument, given, allowed| DynamicsError::ChainPart {
                    part: "joint",
                    number: i + 1,
                    argument,
                    given,
                    allowed,
                };
                if !(kinetic_moment_n_m >= 0.0 && kinetic_moment_n_m.is_finite()) {
                    let allowed = "0 or a positive number";
                    return Err(part("kinetic_moment_n_m", kinetic_moment_n_m, allowed));
                }
                if !(static_moment_n_m >= kinetic_moment_n_m && static_moment_n_m.is_finite()) {
                    let allowed = "at least the kinetic one";
                    return Err(part("static_moment_n_m", static_moment_n_m, allowed));
                }
            }
            weight_n += link.mass_kg * chain.gravity_m_s2();
            if joint.opening == JointOpening::AtBedEdge {
                let width_m = link
                    .bed_width_m
                    .ok_or(DynamicsError::NoBedWidth { joint: i + 1 })?;
                moment_most_n_m[i] = 0.5 * weight_n * width_m;
            }
        }
        let supports = chain.side_supports().iter();
        let props = supports.map(|support| Prop::of(&chain, support));
        Ok(ChainModel {
            props: props.collect::<Result<_, StructureError>>()?,
            chain,
            joints,
            rotations,
            moment_most_n_m,
            lean_rad: 0.0,
        })
    }

    /// The model with a stress-free lean of all links and beds: the whole chain is rotated about its foot. The gaps of side supports are
    /// measured from that position.
    ///
    /// # Errors
    /// [`DynamicsError::Argument`] for an angle of 30° or more in either direction: N b/2 is valid for level beds.
    pub fn leaning(mut self, lean_rad: f64) -> Result<Self, DynamicsError> {
        if lean_rad.is_nan() || lean_rad.abs() >= LEAN_MOST_RAD {
            return Err(DynamicsError::Argument {
                argument: "lean_rad",
                given: lean_rad,
                allowed: "below 30° (0.524 rad) in size",
            });
        }
        self.lean_rad = lean_rad;
        for prop in &mut self.props {
            prop.leaning(lean_rad, self.rotations);
        }
        Ok(self)
    }

    /// The stress-free lean of all links, rad.
    pub fn lean_rad(&self) -> f64 {
        self.lean_rad
    }

    /// Rotation across a joint (0 the lowest) from the stress-free position, for these rotations of the links, rad.
    pub(super) fn across_rad(&self, joint: usize, rotation_rad: &[f64]) -> f64 {
        let below = joint
            .checked_sub(1)
            .map_or(self.lean_rad, |below| rotation_rad[below]);
        rotation_rad[joint] - below
    }

    /// The model with dashpots proportional to the springs, so that the first mode of the chain has a given damping ratio.
    ///
    /// ```text
    /// d_i = 2 ζ ω (φᵀ M φ)/(φᵀ K_E φ) k_i          K φ = ω² M φ, K_E: K without gravity
    /// ```
    /// Higher modes have more damping, in proportion to their frequency.
    ///
    /// # Errors
    /// [`DynamicsError::Argument`] for a ratio outside 0 … 1, or for an unstable chain, which has no such mode.
    pub fn with_first_mode_damping(mut self, damping_ratio: f64) -> Result<Self, DynamicsError> {
        let refuse = |allowed| {
            Err(DynamicsError::Argument {
                argument: "damping_ratio",
                given: damping_ratio,
                allowed,
            })
        };
        if !(0.0..1.0).contains(&damping_ratio) {
            return refuse("0 or more and below 1: is it in percent?");
        }
        if damping_ratio == 0.0 {
            return Ok(self);
        }
        let stiffness: Vec<f64> = self.joints.iter().map(|joint| joint.stiffness_n_m_rad).collect();
        let mass = self.chain.mass_matrix();
        let eigen = generalized_symmetric_eigen(&self.chain.stiffness_matrix(&stiffness)?, &mass)?;
        let Some(&square) = eigen.values.first().filter(|value| **value > 0.0) else {
            return refuse(
                "left out: the chain falls by itself and has no first mode; give dashpots instead",
            );
        };
        let shape = eigen.vectors.column(0);
        let elastic: f64 = (0..shape.len())
            .map(|i| {
                let across = shape[i] - i.checked_sub(1).map_or(0.0, |below| shape[below]);
                stiffness[i] * across * across
            })
            .sum();
        let factor = 2.0 * damping_ratio * square.sqrt() * mass.form(shape, shape) / elastic;
        for joint in &mut self.joints {
            joint.damping_n_m_s_rad = factor * joint.stiffness_n_m_rad;
        }
        Ok(self)
    }

    /// The chain.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Its joints, lowest first.
    pub fn joints(&self) -> &[ChainJoint] {
        &self.joints
    }

    /// N b/2 of each joint, N m, lowest first; infinite for a held joint.
    pub fn moment_most_n_m(&self) -> &[f64] {
        &self.moment_most_n_m
    }

    /// Linear or exact equations.
    pub fn rotations(&self) -> ChainRotations {
        self.rotations
    }

    /// Whether a joint has dry friction.
    pub fn has_friction(&self) -> bool {
        self.joints
            .iter()
            .any(|joint| joint.friction.moments_n_m().is_some())
    }

    /// Moment of the spring of a joint (0 the lowest) at a rotation across it, N m.
    pub(super) fn moment_n_m(&self, joint: usize, across_rad: f64) -> f64 {
        let most = self.moment_most_n_m[joint];
        (self.joints[joint].stiffness_n_m_rad * across_rad).clamp(-most, most)
    }

    /// Energy in the spring of a joint, J.
    pub(super) fn spring_energy_j(&self, joint: usize, across_rad: f64) -> f64 {
        let (k, most) = (self.joints[joint].stiffness_n_m_rad, self.moment_most_n_m[joint]);
        let elastic = (k * across_rad).abs();
        if elastic <= most {
            0.5 * k * across_rad * across_rad
        } else {
            most * (across_rad.abs() - 0.5 * most / k)
        }
    }
}
