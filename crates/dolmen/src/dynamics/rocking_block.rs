//! One rigid block that rocks on its edges (Housner's model), exact between events: a fast second method besides simulating stacks.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | α | `slenderness_rad` | angle between the vertical and the line from the edge to the mass centre | rad |
//! | p | `frequency_parameter_rad_s` | √(m g R / I_0), I_0 about the edge | rad/s |
//! | r | `velocity_ratio` | angular velocity after an impact / before it | – |
//! | u, s | `u`, `side` | magnitude and sign of the rotation, positive towards +x | rad |
//! | a_x, a_z | `horizontal`, `vertical` | acceleration of the ground | m/s² |
//! | σ | – | time within a step, as a fraction of the step | – |

use super::DynamicsError;
use std::f64::consts::FRAC_PI_2;

/// A rigid block on two edges that do not slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RockingBlock {
    /// α, rad: 0 < α < π/2.
    pub slenderness_rad: f64,
    /// p, rad/s, positive, for gravity `gravity_m_s2`.
    pub frequency_parameter_rad_s: f64,
    /// m R² / I_0, –: 0 to 1; ¾ for every uniform rectangle. It affects only the forces at the edge.
    pub inertia_ratio: f64,
    /// r of an impact, –: 0 to 1; 0 if the block stops at its first impact.
    pub velocity_ratio: f64,
    /// g, m/s².
    pub gravity_m_s2: f64,
}

impl RockingBlock {
    /// A uniform rectangle, with the velocity ratio of an impact at the new edge without bounce or sliding.
    ///
    /// ```text
    /// tan α = B/H      p² = 3 g / (2 √(B² + H²))      r = max(0, 1 − 1.5 sin²α)
    /// ```
    ///
    /// # Errors
    /// [`DynamicsError::Argument`] unless width, height and gravity are positive.
    ///
    /// # Source
    /// Housner, G. W. (1963) Bull. Seism. Soc. Am. 53(2):403-417; his r is the square of ours.
    pub fn rectangle(width_m: f64, height_m: f64, gravity_m_s2: f64) -> Result<Self, DynamicsError> {
        for (argument, given) in [
            ("width_m", width_m),
            ("height_m", height_m),
            ("gravity_m_s2", gravity_m_s2),
        ] {
            positive(argument, given)?;
        }
        let slenderness_rad = width_m.atan2(height_m);
        Ok(RockingBlock {
            slenderness_rad,
            frequency_parameter_rad_s: (1.5 * gravity_m_s2 / width_m.hypot(height_m)).sqrt(),
            inertia_ratio: 0.75,
            velocity_ratio: (1.0 - 1.5 * slenderness_rad.sin().powi(2)).max(0.0),
            gravity_m_s2,
        })
    }

    /// A rigid beam on equal rigid columns, free at foot and head: its rotation follows the equation of one block.
    ///
    /// ```text
    /// tan α = b/h,  R = √(b² + h²)/2,  p² = 3g/(4R)          of a column
    /// p̂² = p² (1 + 2γ)/(1 + 3γ)                              γ: mass of the beam over that of all columns
    /// r = (1 − 1.5 sin²α + 3γ cos 2α)/(1 + 3γ)               no bounce, no slip at foot and head; 0 where the formula is negative
    /// ```
    ///
    /// Lift-off is at g tan α for any γ. `inertia_ratio` is 1, so `friction_needed` and `least_pressure_ratio` of its history are
    /// meaningless.
    ///
    /// # Input
    /// * `beam_to_columns` -- γ: 0 for columns without a beam, infinite for massless columns
    ///
    /// # Errors
    /// [`DynamicsError::Argument`] unless width, height and gravity are positive and γ is 0 or more.
    ///
    /// # Limits
    /// Uniform columns of rectangular section; for an infinite γ, any section. The beam stays level because the columns are equal.
    ///
    /// # Source
    /// Makris, N. & Vassiliou, M. F. (2013) Earthquake Eng. Struct. Dyn. 42(5):707-726, whose r is the square of ours.
    ///
    /// # Example
    /// ```
    /// use dolmen::dynamics::RockingBlock;
    /// let column = RockingBlock::rectangle(0.5, 4.0, 9.81)?;
    /// let frame = RockingBlock::frame_on_columns(0.5, 4.0, 5.0, 9.81)?;
    /// let slower = frame.frequency_parameter_rad_s / column.frequency_parameter_rad_s;
    /// assert!((slower - 0.82916).abs() < 5e-6);
    /// # Ok::<(), dolmen::dynamics::DynamicsError>(())
    /// ```
    pub fn frame_on_columns(
        width_m: f64,
        height_m: f64,
        beam_to_columns: f64,
        gravity_m_s2: f64,
    ) -> Result<Self, DynamicsError> {
        let column = RockingBlock::rectangle(width_m, height_m, gravity_m_s2)?;
        if beam_to_columns.is_nan() || beam_to_columns < 0.0 {
            return Err(DynamicsError::Argument {
                argument: "beam_to_columns",
                given: beam_to_columns,
                allowed: "0 or a positive number",
            });
        }
        let share = 1.0 / (1.0 + 3.0 * beam_to_columns); // 0 for columns without mass
        let of = |column: f64, beam: f64| column * share + beam * (1.0 - share);
        let alpha = column.slenderness_rad;
        let velocity_ratio = of(1.0 - 1.5 * alpha.sin().powi(2), (2.0 * alpha).cos());
        Ok(RockingBlock {
            frequency_parameter_rad_s: column.frequency_parameter_rad_s * of(1.0, 2.0 / 3.0).sqrt(),
            inertia_ratio: 1.0,
            velocity_ratio: velocity_ratio.max(0.0),
            ..column
        })
    }

    pub(super) fn check(&self) -> Result<(), DynamicsError> {
        let refuse = |argument, given, allowed| {
            Err(DynamicsError::Argument {
                argument,
                given,
                allowed,
            })
        };
        if !(self.slenderness_rad > 0.0 && self.slenderness_rad < FRAC_PI_2) {
            return refuse("slenderness_rad", self.slenderness_rad, "between 0 and π/2");
        }
        for (argument, given) in [
            ("inertia_ratio", self.inertia_ratio),
            ("velocity_ratio", self.velocity_ratio),
        ] {
            if !(0.0..=1.0).contains(&given) {
                return refuse(argument, given, "between 0 and 1");
            }
        }
        positive("frequency_parameter_rad_s", self.frequency_parameter_rad_s)?;
        positive("gravity_m_s2", self.gravity_m_s2)
    }
}

pub(super) fn positive(argument: &'static str, given: f64) -> Result<(), DynamicsError> {
    if given > 0.0 && given.is_finite() {
        return Ok(());
    }
    Err(DynamicsError::Argument {
        argument,
        given,
        allowed: "a positive number",
    })
}

/// The equation of motion of a [`RockingBlock`]; u is the magnitude and s the sign of its rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RockingEquation {
    /// u″ = −p² ((1 + a_z/g) sin(α − u) + s (a_x/g) cos(α − u)).
    #[default]
    Exact,
    /// u″ = −p² ((1 + a_z/g) (α − u) + s a_x/g): Housner's equation for slender blocks. The block lifts off at α g instead of g tan α.
    Linear,
}

/// Options of [`rock_block`](super::rock_block).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rocking {
    /// Default: exact.
    pub equation: RockingEquation,
    /// Rotation at the start, at rest, rad; positive towards +x. Default 0.
    pub start_rad: f64,
    /// Length of the run, s. Default `None`: the length of the motion plus `rest_s`.
    pub duration_s: Option<f64>,
    /// Time after the motion, s. Default 2.
    pub rest_s: f64,
    /// Time between samples of the history, s. Default 0.01.
    pub output_step_s: f64,
}

impl Default for Rocking {
    fn default() -> Self {
        Rocking {
            equation: RockingEquation::Exact,
            start_rad: 0.0,
            duration_s: None,
            rest_s: 2.0,
            output_step_s: 0.01,
        }
    }
}

/// End of a run of [`rock_block`](super::rock_block).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RockingOutcome {
    /// The block never lifted off.
    Stood,
    /// The block rocked and did not fall.
    Rocked,
    /// The block fell: its rotation exceeded 90°.
    Fell {
        /// Time of the fall, s.
        at_s: f64,
    },
    /// The ground accelerated downwards faster than the block, which the model does not cover; the run ends there.
    LeftTheGround {
        /// Its time, s.
        at_s: f64,
    },
}

/// One impact of the block on its base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RockingImpact {
    /// Its time, s.
    pub at_s: f64,
    /// Angular velocity just before the impact, rad/s; negative if the block returned from a positive rotation.
    pub velocity_rad_s: f64,
}

/// Motion of a rocking block.
#[derive(Clone, Debug, PartialEq)]
pub struct RockingHistory {
    /// Its end.
    pub outcome: RockingOutcome,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// Rotation at the samples, positive towards +x, rad.
    pub rotation_rad: Vec<f64>,
    /// Largest rotation, including times between samples, rad.
    pub peak_rotation_rad: f64,
    /// Time of the first lift-off, s.
    pub uplift_s: Option<f64>,
    /// All impacts.
    pub impacts: Vec<RockingImpact>,
    /// Smallest friction coefficient without slip of the edge, from the forces at the ends of all steps, –; infinite where the edge carried
    /// no force.
    pub friction_needed: f64,
    /// Smallest force on the ground at those times, over the weight, –; below 0 the block would have jumped.
    pub least_pressure_ratio: f64,
}
