//! Random loads by their spectral density, or as filtered white noise if it is rational.
//!
//! All densities are two-sided over the circular frequency: σ² = ∫ S dω from −∞ to ∞, unit² s/rad.

use super::DynamicsError;
use crate::structure::wind::GustFace;
use dolmen_linalg::{ComplexMatrix, Matrix};
use std::f64::consts::TAU;

/// Spectral density of one random force or acceleration.
#[derive(Clone, Debug, PartialEq)]
pub enum Spectrum {
    /// S0 at every frequency.
    White {
        /// S0, unit² s/rad.
        density: f64,
    },
    /// S0 ω_c² / (ω² + ω_c²): slow load such as wind gusts, with few components above the corner frequency.
    LowPass {
        /// S0 at ω = 0, unit² s/rad.
        density: f64,
        /// ω_c, rad/s.
        corner_rad_s: f64,
    },
    /// Ground acceleration of Kanai (1957) and Tajimi (1960): white noise filtered by the soil as one oscillator. Its density does not vanish
    /// at ω = 0, so the velocity and displacement of the ground are unbounded.
    KanaiTajimi {
        /// S0 of the rock, (m/s²)² s/rad.
        density: f64,
        /// ω_g of the soil, rad/s.
        ground_rad_s: f64,
        /// ζ_g of the soil.
        ground_damping_ratio: f64,
    },
    /// As Kanai-Tajimi, with the second filter of Clough & Penzien (1975), which removes slow motion.
    CloughPenzien {
        /// S0 of the rock, (m/s²)² s/rad.
        density: f64,
        /// ω_g of the soil, rad/s.
        ground_rad_s: f64,
        /// ζ_g of the soil.
        ground_damping_ratio: f64,
        /// ω_f of the second filter, rad/s.
        filter_rad_s: f64,
        /// ζ_f of the second filter.
        filter_damping_ratio: f64,
    },
    /// Linear between given points; below the first point constant, above the last point 0.
    Table {
        /// Angular frequencies, ascending, rad/s.
        angular_frequency_rad_s: Vec<f64>,
        /// Density at each frequency, unit² s/rad.
        density: Vec<f64>,
    },
    /// Force of a turbulent wind on the strips of a face, weighted by a pattern: φᵀ S_F φ/4π, N² s/rad.
    Gusts {
        /// The face.
        face: Box<GustFace>,
        /// φ, one value for each strip.
        shape: Vec<f64>,
    },
}

/// Filter ẋ = A x + b w: white noise w of intensity 1 gives the load c·x.
pub(super) struct ShapingFilter {
    pub(super) a: Matrix,
    pub(super) b: Vec<f64>,
    pub(super) c: Vec<f64>,
}

impl Spectrum {
    /// White noise with E w(t) w(t') = δ(t − t'): S0 = 1/2π.
    pub fn unit_white() -> Self {
        Spectrum::White { density: 1.0 / TAU }
    }

    /// S at a circular frequency.
    pub fn density(&self, angular_frequency_rad_s: f64) -> f64 {
        let w = angular_frequency_rad_s;
        let oscillator = |own: f64, zeta: f64| ((own * own - w * w).powi(2), (2.0 * zeta * own * w).powi(2));
        match self {
            Spectrum::White { density } => *density,
            Spectrum::LowPass {
                density,
                corner_rad_s,
            } => density * corner_rad_s * corner_rad_s / (w * w + corner_rad_s * corner_rad_s),
            Spectrum::KanaiTajimi {
                density,
                ground_rad_s,
                ground_damping_ratio,
            } => {
                let (apart, damped) = oscillator(*ground_rad_s, *ground_damping_ratio);
                density * (ground_rad_s.powi(4) + damped) / (apart + damped)
            }
            Spectrum::CloughPenzien {
                filter_rad_s,
                filter_damping_ratio,
                ..
            } => {
                let (apart, damped) = oscillator(*filter_rad_s, *filter_damping_ratio);
                self.without_filter().density(w) * w.powi(4) / (apart + damped)
            }
            Spectrum::Table {
                angular_frequency_rad_s: at,
                density,
            } => {
                let w = w.abs();
                let above = at.partition_point(|x| *x < w);
                if above == 0 {
                    density[0]
                } else if above == at.len() {
                    0.0
                } else {
                    let part = (w - at[above - 1]) / (at[above] - at[above - 1]);
                    density[above - 1] + part * (density[above] - density[above - 1])
                }
            }
            // one-sided over Hz is 4π times two-sided over rad/s; ω = 0 uses the lowest positive frequency
            Spectrum::Gusts { face, shape } => {
                let hz = (w.abs() / TAU).max(face.lowest_hz());
                face.force_density_n2_hz(hz).form(shape, shape) / (2.0 * TAU)
            }
        }
    }

    /// Standard deviation of the ground displacement, m, if this is the density of the ground acceleration.
    ///
    /// # Errors
    /// [`DynamicsError::Unbounded`] unless the density vanishes with ω⁴ at ω = 0, as only that of Clough & Penzien does.
    pub fn ground_displacement_rms_m(&self) -> Result<f64, DynamicsError> {
        let Spectrum::CloughPenzien {
            density,
            ground_rad_s,
            ground_damping_ratio,
            filter_rad_s,
            filter_damping_ratio,
        } = self
        else {
            return Err(DynamicsError::Unbounded {
                quantity: "the displacement of the ground",
                why: "its acceleration has a density that does not vanish at frequency 0, and displacement divides it by ω⁴: use Clough & Penzien's, which filters slow motion out",
            });
        };
        self.check()?;
        // displacement of the second filter: white noise through two oscillators, ∫ of a rational spectrum of order four
        let (g, zg, f, zf) = (
            *ground_rad_s,
            *ground_damping_ratio,
            *filter_rad_s,
            *filter_damping_ratio,
        );
        let (cg, cf) = (2.0 * zg * g, 2.0 * zf * f);
        let a = [
            g * g * f * f,
            cg * f * f + cf * g * g,
            g * g + f * f + cg * cf,
            cg + cf,
        ];
        let b = [g * g, cg];
        let above = a[0] * a[3] * b[1] * b[1] + b[0] * b[0] * (a[2] * a[3] - a[1]);
        let below = 2.0 * a[0] * (a[1] * a[2] * a[3] - a[0] * a[3] * a[3] - a[1] * a[1]);
        Ok((TAU * density * above / below).sqrt())
    }

    fn without_filter(&self) -> Spectrum {
        match self {
            Spectrum::CloughPenzien {
                density,
                ground_rad_s,
                ground_damping_ratio,
                ..
            } => Spectrum::KanaiTajimi {
                density: *density,
                ground_rad_s: *ground_rad_s,
                ground_damping_ratio: *ground_damping_ratio,
            },
            other => other.clone(),
        }
    }

    pub(crate) fn check(&self) -> Result<(), DynamicsError> {
        let positive = |argument, given: f64| match given > 0.0 && given.is_finite() {
            true => Ok(()),
            false => Err(DynamicsError::Argument {
                argument,
                given,
                allowed: "positive",
            }),
        };
        match self {
            Spectrum::White { density } => positive("density", *density),
            Spectrum::LowPass {
                density,
                corner_rad_s,
            } => {
                positive("density", *density)?;
                positive("corner_rad_s", *corner_rad_s)
            }
            Spectrum::KanaiTajimi {
                density,
                ground_rad_s,
                ground_damping_ratio,
            } => {
                positive("density", *density)?;
                positive("ground_rad_s", *ground_rad_s)?;
                positive("ground_damping_ratio", *ground_damping_ratio)
            }
            Spectrum::CloughPenzien {
                filter_rad_s,
                filter_damping_ratio,
                ..
            } => {
                self.without_filter().check()?;
                positive("filter_rad_s", *filter_rad_s)?;
                positive("filter_damping_ratio", *filter_damping_ratio)
            }
            Spectrum::Table {
                angular_frequency_rad_s: at,
                density,
            } => {
                if at.len() != density.len() || at.len() < 2 {
                    return Err(DynamicsError::Entries {
                        argument: "density",
                        given: density.len(),
                        needed: at.len().max(2),
                    });
                }
                ascending(at)?;
                match density.iter().find(|s| !(**s >= 0.0 && s.is_finite())) {
                    Some(&given) => Err(DynamicsError::Argument {
                        argument: "density",
                        given,
                        allowed: "0 or more",
                    }),
                    None => Ok(()),
                }
            }
            Spectrum::Gusts { face, shape } => {
                face.check()?;
                match shape.len() == face.strips.len() {
                    true => Ok(()),
                    false => Err(DynamicsError::Entries {
                        argument: "shape",
                        given: shape.len(),
                        needed: face.strips.len(),
                    }),
                }
            }
        }
    }

    /// Frequencies at which the density has a peak or a bend.
    pub(crate) fn breaks_rad_s(&self) -> Vec<f64> {
        match self {
            Spectrum::White { .. } => Vec::new(),
            Spectrum::LowPass { corner_rad_s, .. } => vec![*corner_rad_s],
            Spectrum::KanaiTajimi { ground_rad_s, .. } => vec![*ground_rad_s],
            Spectrum::CloughPenzien {
                ground_rad_s,
                filter_rad_s,
                ..
            } => vec![*filter_rad_s, *ground_rad_s],
            Spectrum::Table {
                angular_frequency_rad_s,
                ..
            } => angular_frequency_rad_s.clone(),
            Spectrum::Gusts { face, .. } => {
                let slow = face.strips.iter();
                let slow = slow.map(|strip| strip.wind.mean_speed_m_s / strip.wind.length_m);
                let middle = slow.sum::<f64>() / face.strips.len().max(1) as f64;
                [0.01, 0.1, 1.0].map(|part| part * TAU * middle).to_vec()
            }
        }
    }

    /// The filter that generates the load from white noise; `None` for a table and for gusts. White noise itself has no states.
    pub(super) fn filter(&self) -> Option<ShapingFilter> {
        let intensity = |density: f64| (TAU * density).sqrt();
        match self {
            Spectrum::White { .. } | Spectrum::Table { .. } | Spectrum::Gusts { .. } => None,
            Spectrum::LowPass {
                density,
                corner_rad_s,
            } => Some(ShapingFilter {
                a: Matrix::from_rows(&[[-corner_rad_s]]),
                b: vec![corner_rad_s * intensity(*density)],
                c: vec![1.0],
            }),
            Spectrum::KanaiTajimi {
                density,
                ground_rad_s: g,
                ground_damping_ratio,
            } => {
                let c = 2.0 * ground_damping_ratio * g;
                Some(ShapingFilter {
                    a: Matrix::from_rows(&[[0.0, 1.0], [-g * g, -c]]),
                    b: vec![0.0, intensity(*density)],
                    c: vec![g * g, c],
                })
            }
            Spectrum::CloughPenzien {
                density,
                ground_rad_s: g,
                ground_damping_ratio,
                filter_rad_s: f,
                filter_damping_ratio,
            } => {
                let (cg, cf) = (2.0 * ground_damping_ratio * g, 2.0 * filter_damping_ratio * f);
                // ü_f + c_f u̇_f + ω_f² u_f = a of Kanai & Tajimi; the ground's acceleration is ü_f
                Some(ShapingFilter {
                    a: Matrix::from_rows(&[
                        [0.0, 1.0, 0.0, 0.0],
                        [-g * g, -cg, 0.0, 0.0],
                        [0.0, 0.0, 0.0, 1.0],
                        [g * g, cg, -f * f, -cf],
                    ]),
                    b: vec![0.0, intensity(*density), 0.0, 0.0],
                    c: vec![g * g, cg, -f * f, -cf],
                })
            }
        }
    }
}

fn ascending(at: &[f64]) -> Result<(), DynamicsError> {
    let steps = at.windows(2).all(|pair| pair[1] > pair[0]);
    match at.iter().find(|w| !(**w >= 0.0 && w.is_finite())) {
        Some(&given) => Err(DynamicsError::Argument {
            argument: "angular_frequency_rad_s",
            given,
            allowed: "0 or more",
        }),
        None if steps => Ok(()),
        None => Err(DynamicsError::Argument {
            argument: "angular_frequency_rad_s",
            given: at.last().copied().unwrap_or(f64::NAN),
            allowed: "ascending",
        }),
    }
}

/// Kind of a random load.
#[derive(Clone, Debug, PartialEq)]
pub enum RandomInput {
    /// A force: its component at each degree of freedom, n values.
    Force(Vec<f64>),
    /// An acceleration of the base: the displacement of each degree of freedom per base displacement, n values.
    Base(Vec<f64>),
}

/// A random load; several loads are independent of each other.
#[derive(Clone, Debug, PartialEq)]
pub struct RandomLoad {
    /// Type of the input.
    pub input: RandomInput,
    /// Its spectral density.
    pub spectrum: Spectrum,
}

/// Correlated loads: their spectral matrix at given frequencies, linear between them, 0 beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectralMatrix {
    /// The kinds of the m loads.
    pub inputs: Vec<RandomInput>,
    /// Angular frequencies, ascending, rad/s.
    pub angular_frequency_rad_s: Vec<f64>,
    /// Density at each frequency: m × m, Hermitian and positive semidefinite, two-sided, unit² s/rad.
    pub density: Vec<ComplexMatrix>,
}

impl SpectralMatrix {
    pub(super) fn check(&self) -> Result<(), DynamicsError> {
        let m = self.inputs.len();
        let refused = |needed| DynamicsError::Matrix {
            matrix: "spectral",
            needed,
        };
        if self.density.len() != self.angular_frequency_rad_s.len() || self.density.len() < 2 {
            return Err(DynamicsError::Entries {
                argument: "density",
                given: self.density.len(),
                needed: self.angular_frequency_rad_s.len().max(2),
            });
        }
        ascending(&self.angular_frequency_rad_s)?;
        for matrix in &self.density {
            if matrix.rows() != m || matrix.columns() != m || m == 0 {
                return Err(refused("square, with one row a load"));
            }
            let largest = matrix
                .as_slice()
                .iter()
                .fold(0.0_f64, |most, z| most.max(z.norm()));
            for i in 0..m {
                for j in 0..m {
                    let apart = (matrix[(i, j)] - matrix[(j, i)].conj()).norm();
                    if apart.is_nan() || apart > 1e-9 * largest {
                        return Err(refused("Hermitian: S_ij the conjugate of S_ji"));
                    }
                }
            }
            let least = dolmen_linalg::hermitian_eigen(matrix)?.values[0];
            if least < -1e-9 * largest {
                return Err(refused(
                    "positive semidefinite: no combination of the loads may have a negative density (look for a coherence above 1)",
                ));
            }
        }
        Ok(())
    }

    pub(super) fn at(&self, w: f64) -> Option<ComplexMatrix> {
        let at = &self.angular_frequency_rad_s;
        let above = at.partition_point(|x| *x < w);
        if above == at.len() {
            return None;
        }
        if above == 0 {
            return Some(self.density[0].clone());
        }
        let part = (w - at[above - 1]) / (at[above] - at[above - 1]);
        let (low, high) = (&self.density[above - 1], &self.density[above]);
        Some(ComplexMatrix::from_fn(low.rows(), low.columns(), |i, j| {
            low[(i, j)] + part * (high[(i, j)] - low[(i, j)])
        }))
    }
}
