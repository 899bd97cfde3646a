//! The model of a frame with dry friction in its storeys.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k_i | `stiffness_n_m` | spring of storey i, always in action | N/m |
//! | k_s | `stuck_stiffness_n_m` | spring in series with the slider (Jenkins) | N/m |
//! | f_s, f_k | `static_force_n`, `kinetic_force_n` | slip force before and while slipping | N |
//! | μ | `friction_coefficient` | slip force over axial force | – |
//! | ζ | `damping_ratio` | damping ratio of a mode | – |

use super::DynamicsError;
use super::frame_tenon::Tenon;
use crate::structure::Frame;
use dolmen_linalg::{Matrix, generalized_symmetric_eigen};

/// Dry friction of one storey. Together with the storey's own spring k_i it covers the three interpretations of the source:
///
/// ```text
/// (a) k_i > 0, Coulomb     rigid until it slips, then k_i and a constant force
/// (b) k_i = 0, Jenkins     spring in series with a slider: the text of the source
/// (c) k_i > 0, Jenkins     both: stiff when stuck (k_i + k_s), soft when slipping (k_i)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StoreyFriction {
    /// No friction.
    None,
    /// A slider in parallel with the storey's own spring: Coulomb's law without regularisation; sticking is exact.
    Coulomb {
        /// Force at which it starts to slip, N; at least the kinetic one.
        static_force_n: f64,
        /// Force while it slips, N.
        kinetic_force_n: f64,
    },
    /// A slider in series with a spring, both in parallel with the storey's own spring.
    Jenkins {
        /// Stiffness of the series spring k_s, N/m.
        stuck_stiffness_n_m: f64,
        /// Force at which it starts to slip, N; at least the kinetic one.
        static_force_n: f64,
        /// Force while it slips, N.
        kinetic_force_n: f64,
    },
}

impl StoreyFriction {
    /// Coulomb's law with one force.
    pub fn coulomb(slip_force_n: f64) -> Self {
        StoreyFriction::Coulomb {
            static_force_n: slip_force_n,
            kinetic_force_n: slip_force_n,
        }
    }

    /// A Jenkins element with one force.
    pub fn jenkins(stuck_stiffness_n_m: f64, slip_force_n: f64) -> Self {
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n: slip_force_n,
            kinetic_force_n: slip_force_n,
        }
    }

    /// The static and the kinetic force, N; `None` without friction.
    pub(super) fn limits_n(self) -> Option<[f64; 2]> {
        match self.acting() {
            StoreyFriction::None => None,
            StoreyFriction::Coulomb {
                static_force_n,
                kinetic_force_n,
            }
            | StoreyFriction::Jenkins {
                static_force_n,
                kinetic_force_n,
                ..
            } => Some([static_force_n, kinetic_force_n]),
        }
    }

    /// The effective friction: a slider with zero force is left out, because it would stick and slip at the same time.
    pub(super) fn acting(self) -> Self {
        match self {
            StoreyFriction::Coulomb { static_force_n, .. }
            | StoreyFriction::Jenkins { static_force_n, .. }
                if static_force_n == 0.0 =>
            {
                StoreyFriction::None
            }
            other => other,
        }
    }
}

/// The motion on which sliders act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrictionActsOn {
    /// The storey drift: joints rub against each other as the storey deforms.
    Drift,
    /// The displacement relative to the ground, as eq. 11 of the source is printed: for reproduction.
    Displacement,
}

/// Viscous damping.
#[derive(Clone, Debug, PartialEq)]
pub enum ViscousDamping {
    /// No spring, only friction.
    None,
    /// A dashpot in each storey, on its drift, N s/m.
    Dashpots(Vec<f64>),
    /// C = a M + b K with K for slipping sliders, P-delta included.
    Rayleigh {
        /// a, 1/s.
        mass_per_s: f64,
        /// b, s.
        stiffness_s: f64,
    },
    /// One damping ratio in every mode of the frame with sticking sliders (Coulomb: slipping), within the slack of its tenons. A frame that
    /// falls within the slack has no such mode: there the modes are those with all tenons bearing. The dashpots act at any drift.
    Modal(f64),
}

/// A frame with springs, friction and damping, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionFrame {
    pub(super) frame: Frame,
    pub(super) stiffness_n_m: Vec<f64>,
    pub(super) friction: Vec<StoreyFriction>,
    pub(super) acts_on: FrictionActsOn,
    /// Tenons of the storeys, on their drifts.
    pub(super) tenons: Vec<Option<Tenon>>,
    pub(super) damping: ViscousDamping,
}

impl FrictionFrame {
    /// A frame with stiffness k_i and friction in each storey, both on its drift, without viscous damping.
    ///
    /// # Errors
    /// [`DynamicsError::Count`]; [`DynamicsError::Storey`] for a force or stiffness that is negative or not a number, a static
    /// force below the kinetic one, or a series spring with zero stiffness; [`DynamicsError::Structure`] for a stiffness.
    pub fn new(
        frame: Frame,
        stiffness_n_m: Vec<f64>,
        friction: Vec<StoreyFriction>,
    ) -> Result<Self, DynamicsError> {
        frame.check_stiffness(&stiffness_n_m)?;
        if friction.len() != frame.storeys().len() {
            return Err(DynamicsError::Count {
                argument: "friction",
                given: friction.len(),
                needed: frame.storeys().len(),
            });
        }
        for (i, friction) in friction.iter().enumerate() {
            check_friction(i + 1, friction)?;
        }
        Ok(FrictionFrame {
            frame,
            stiffness_n_m,
            tenons: vec![None; friction.len()],
            friction,
            acts_on: FrictionActsOn::Drift,
            damping: ViscousDamping::None,
        })
    }

    /// The frame with sliders that act on the given motion.
    pub fn acting_on(self, acts_on: FrictionActsOn) -> Self {
        FrictionFrame { acts_on, ..self }
    }

    /// The frame with tenons in its storeys, in parallel with their springs and friction.
    ///
    /// # Errors
    /// [`DynamicsError::Count`]; [`DynamicsError::Storey`] for a negative slack, or a stiffness, force or depth that is not positive.
    pub fn with_tenons(self, tenons: Vec<Option<Tenon>>) -> Result<Self, DynamicsError> {
        if tenons.len() != self.frame.storeys().len() {
            return Err(DynamicsError::Count {
                argument: "tenons",
                given: tenons.len(),
                needed: self.frame.storeys().len(),
            });
        }
        for (i, tenon) in tenons.iter().enumerate() {
            tenon.map_or(Ok(()), |tenon| tenon.check(i + 1))?;
        }
        Ok(FrictionFrame { tenons, ..self })
    }

    /// The frame with viscous damping.
    ///
    /// # Errors
    /// [`DynamicsError::Count`], [`DynamicsError::Storey`] and [`DynamicsError::Argument`] for values that are negative or not numbers,
    /// for a damping ratio of 1 or more, or for Rayleigh damping that drives a falling shape.
    pub fn with_damping(self, damping: ViscousDamping) -> Result<Self, DynamicsError> {
        match &damping {
            ViscousDamping::None => {}
            ViscousDamping::Dashpots(dashpots) => {
                if dashpots.len() != self.frame.storeys().len() {
                    return Err(DynamicsError::Count {
                        argument: "dashpots",
                        given: dashpots.len(),
                        needed: self.frame.storeys().len(),
                    });
                }
                for (i, &given) in dashpots.iter().enumerate() {
                    not_negative(i + 1, "dashpot_n_s_m", given)?;
                }
            }
            ViscousDamping::Rayleigh {
                mass_per_s,
                stiffness_s,
            } => {
                for (argument, given) in [("mass_per_s", *mass_per_s), ("stiffness_s", *stiffness_s)] {
                    if !(given >= 0.0 && given.is_finite()) {
                        return Err(DynamicsError::Argument {
                            argument,
                            given,
                            allowed: "0 or a positive number",
                        });
                    }
                }
                self.check_rayleigh(*mass_per_s, *stiffness_s)?;
            }
            ViscousDamping::Modal(ratio) => {
                if !(0.0..1.0).contains(ratio) {
                    return Err(DynamicsError::Argument {
                        argument: "damping_ratio",
                        given: *ratio,
                        allowed: "0 or more and below 1: is it in percent?",
                    });
                }
            }
        }
        Ok(FrictionFrame { damping, ..self })
    }

    /// In a falling shape of K, ω² < 0, and b K drives that shape further: a + b ω² must not be negative.
    fn check_rayleigh(&self, mass_per_s: f64, stiffness_s: f64) -> Result<(), DynamicsError> {
        let k = self.stiffness_matrix(Sliders::Slipping)?;
        let eigen = generalized_symmetric_eigen(&k, &self.frame.mass_matrix())?;
        let least = eigen.values.first().copied().unwrap_or(0.0);
        let most = eigen.values.last().copied().unwrap_or(0.0).abs().max(least.abs());
        if mass_per_s + stiffness_s * least < -1e-12 * stiffness_s * most {
            return Err(DynamicsError::Argument {
                argument: "stiffness_s",
                given: stiffness_s,
                allowed: "so small that mass_per_s + stiffness_s ω² is not negative in the shape in which the frame falls \
                          when every slider slips: lower it, raise mass_per_s, or give dashpots",
            });
        }
        Ok(())
    }

    /// Its frame.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Stiffness of the storeys' own springs, N/m.
    pub fn stiffness_n_m(&self) -> &[f64] {
        &self.stiffness_n_m
    }

    /// Friction of the storeys.
    pub fn friction(&self) -> &[StoreyFriction] {
        &self.friction
    }

    /// Tenons of the storeys.
    pub fn tenons(&self) -> &[Option<Tenon>] {
        &self.tenons
    }

    /// The motion on which the sliders act.
    pub fn acts_on(&self) -> FrictionActsOn {
        self.acts_on
    }

    /// Frequencies of the frame within the slack of its tenons, Hz, lowest first, with all sliders slipping, or all sliders of Jenkins
    /// elements sticking; `None` for a falling shape. A stuck Coulomb slider is rigid and does not count.
    ///
    /// # Errors
    /// [`DynamicsError::Structure`] if the range of values exceeds the precision of the numbers.
    pub fn frequencies_hz(&self, sliders: Sliders) -> Result<Vec<Option<f64>>, DynamicsError> {
        let k = self.stiffness_matrix(sliders)?;
        let eigen = generalized_symmetric_eigen(&k, &self.frame.mass_matrix())?;
        let hz = |&w: &f64| (w > 0.0).then(|| w.sqrt() / std::f64::consts::TAU);
        Ok(eigen.values.iter().map(hz).collect())
    }

    /// Damping ratio of each mode from the viscous damping, in the order of [`FrictionFrame::frequencies_hz`]; `None` for a falling shape.
    ///
    /// ```text
    /// ζ_j = φ_jᵀ C φ_j / (2 ω_j φ_jᵀ M φ_j)
    /// ```
    /// Terms between modes are neglected: small damping.
    ///
    /// # Errors
    /// [`DynamicsError::Structure`] if the range of values exceeds the precision of the numbers.
    pub fn damping_ratios(&self, sliders: Sliders) -> Result<Vec<Option<f64>>, DynamicsError> {
        self.damping_ratios_with(&self.stiffness_matrix(sliders)?)
    }

    /// The same for the modes with sticking sliders and all tenons bearing.
    ///
    /// # Errors
    /// As [`FrictionFrame::damping_ratios`].
    pub fn damping_ratios_bearing(&self) -> Result<Vec<Option<f64>>, DynamicsError> {
        self.damping_ratios_with(&self.bearing_matrix()?)
    }

    /// Damping ratio of each mode with this stiffness.
    fn damping_ratios_with(&self, k: &Matrix) -> Result<Vec<Option<f64>>, DynamicsError> {
        let c = self.damping_matrix()?;
        let eigen = generalized_symmetric_eigen(k, &self.frame.mass_matrix())?;
        let ratio = |(j, &w): (usize, &f64)| {
            let shape = eigen.vectors.column(j);
            let power = c.as_ref().map_or(0.0, |c| {
                let force = c.times(shape);
                force.iter().zip(shape).map(|(f, v)| f * v).sum::<f64>()
            });
            (w > 0.0).then(|| power / (2.0 * w.sqrt()))
        };
        Ok(eigen.values.iter().enumerate().map(ratio).collect())
    }

    /// K with P-delta, with slipping sliders or with sticking sliders of Jenkins elements, N/m.
    pub(super) fn stiffness_matrix(&self, sliders: Sliders) -> Result<Matrix, DynamicsError> {
        let mut k = self.frame.stiffness_matrix(&self.stiffness_n_m)?;
        if sliders == Sliders::Stuck {
            self.add_stuck(&mut k);
        }
        Ok(k)
    }

    /// The same with sticking sliders and all tenons bearing, N/m.
    fn bearing_matrix(&self) -> Result<Matrix, DynamicsError> {
        let each = self.stiffness_n_m.iter().zip(&self.tenons);
        let bearing_n_m: Vec<f64> = each
            .map(|(own, tenon)| own + tenon.map_or(0.0, |of| of.stiffness_n_m))
            .collect();
        let mut k = self.frame.stiffness_matrix(&bearing_n_m)?;
        self.add_stuck(&mut k);
        Ok(k)
    }

    /// Level below the slider of storey i, `None` for the ground.
    pub(super) fn below(&self, storey: usize) -> Option<usize> {
        match self.acts_on {
            FrictionActsOn::Drift => storey.checked_sub(1),
            FrictionActsOn::Displacement => None,
        }
    }

    fn add_stuck(&self, k: &mut Matrix) {
        for (i, friction) in self.friction.iter().enumerate() {
            if let StoreyFriction::Jenkins {
                stuck_stiffness_n_m, ..
            } = *friction
            {
                k[(i, i)] += stuck_stiffness_n_m;
                if let Some(j) = self.below(i) {
                    k[(j, j)] += stuck_stiffness_n_m;
                    k[(i, j)] -= stuck_stiffness_n_m;
                    k[(j, i)] -= stuck_stiffness_n_m;
                }
            }
        }
    }

    /// C, N s/m.
    pub(super) fn damping_matrix(&self) -> Result<Option<Matrix>, DynamicsError> {
        let n = self.frame.storeys().len();
        match &self.damping {
            ViscousDamping::None => Ok(None),
            ViscousDamping::Dashpots(dashpots) => {
                let mut c = Matrix::zeros(n, n);
                for (i, &dashpot) in dashpots.iter().enumerate() {
                    c[(i, i)] += dashpot;
                    if i > 0 {
                        c[(i - 1, i - 1)] += dashpot;
                        c[(i, i - 1)] -= dashpot;
                        c[(i - 1, i)] -= dashpot;
                    }
                }
                Ok(Some(c))
            }
            ViscousDamping::Rayleigh {
                mass_per_s,
                stiffness_s,
            } => {
                let mass = self.frame.mass_matrix();
                let k = self.frame.stiffness_matrix(&self.stiffness_n_m)?;
                let entry = |i, j| mass_per_s * mass[(i, j)] + stiffness_s * k[(i, j)];
                Ok(Some(Matrix::from_fn(n, n, entry)))
            }
            ViscousDamping::Modal(ratio) => {
                let k = self.stiffness_matrix(Sliders::Stuck)?;
                let mass = self.frame.mass_matrix();
                let mut eigen = generalized_symmetric_eigen(&k, &mass)?;
                let falls = eigen.values.iter().any(|omega_squared| *omega_squared <= 0.0);
                if falls && self.tenons.iter().any(Option::is_some) {
                    eigen = generalized_symmetric_eigen(&self.bearing_matrix()?, &mass)?;
                }
                // C = M (Σ 2ζω φ φᵀ) M with φᵀMφ = 1; a falling shape has no damping
                let entry = |i: usize, j: usize| {
                    let sum: f64 = (0..n)
                        .map(|m| {
                            let omega = eigen.values[m].max(0.0).sqrt();
                            2.0 * ratio * omega * eigen.vectors[(i, m)] * eigen.vectors[(j, m)]
                        })
                        .sum();
                    mass[(i, i)] * mass[(j, j)] * sum
                };
                Ok(Some(Matrix::from_fn(n, n, entry)))
            }
        }
    }
}

/// State of the sliders, for [`FrictionFrame::frequencies_hz`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sliders {
    /// All stick.
    Stuck,
    /// All slip.
    Slipping,
}

/// Slip force of each storey, μ N_i, N.
///
/// # Errors
/// [`DynamicsError::Argument`] for a coefficient outside 0 … 2.
///
/// # Limits
/// N_i is that of the frame at rest: changes by vertical shaking are not included.
pub fn slip_forces_n(frame: &Frame, friction_coefficient: f64) -> Result<Vec<f64>, DynamicsError> {
    if !(0.0..=2.0).contains(&friction_coefficient) {
        return Err(DynamicsError::Argument {
            argument: "friction_coefficient",
            given: friction_coefficient,
            allowed: "0 to 2",
        });
    }
    Ok(frame
        .storeys()
        .iter()
        .map(|s| friction_coefficient * s.axial_n)
        .collect())
}

fn check_friction(storey: usize, friction: &StoreyFriction) -> Result<(), DynamicsError> {
    let (static_force_n, kinetic_force_n) = match *friction {
        StoreyFriction::None => return Ok(()),
        StoreyFriction::Coulomb {
            static_force_n,
            kinetic_force_n,
        } => (static_force_n, kinetic_force_n),
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } => {
            if !(stuck_stiffness_n_m > 0.0 && stuck_stiffness_n_m.is_finite()) {
                return Err(DynamicsError::Storey {
                    storey,
                    argument: "stuck_stiffness_n_m",
                    given: stuck_stiffness_n_m,
                    allowed: "a positive number",
                });
            }
            (static_force_n, kinetic_force_n)
        }
    };
    not_negative(storey, "kinetic_force_n", kinetic_force_n)?;
    if !(static_force_n >= kinetic_force_n && static_force_n.is_finite()) {
        return Err(DynamicsError::Storey {
            storey,
            argument: "static_force_n",
            given: static_force_n,
            allowed: "at least the kinetic one",
        });
    }
    Ok(())
}

fn not_negative(storey: usize, argument: &'static str, given: f64) -> Result<(), DynamicsError> {
    if given >= 0.0 && given.is_finite() {
        Ok(())
    } else {
        Err(DynamicsError::Storey {
            storey,
            argument,
            given,
            allowed: "0 or a positive number",
        })
    }
}
