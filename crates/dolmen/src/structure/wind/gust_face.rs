//! Forces of a turbulent wind on the strips of a face: mean forces and cross spectra.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | F̄ | `mean_forces_n` | ½ ρ C_f b h V² of each strip | N |
//! | χ | `force_per_speed` | ρ C_f b h V: force per speed of the gust, quasi-steady | N s/m |
//! | C | `coherence_decay` | decay constant: coherence exp(−C n (\|Δy\| + \|Δz\|)/V) | |
//! | J | `within` | coherence averaged over all pairs of points of a length | |

use super::{Turbulence, TurbulenceSpectrum, WindError};
use dolmen_linalg::{LinalgError, Matrix, symmetric_eigen};

/// Decay of the coherence across and up the face: C = 10.
pub const COHERENCE_DECAY: f64 = 10.0;

/// A horizontal strip of the face, as high as the tributary height of one floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GustStrip {
    /// Height of the lower edge above the ground, m.
    pub bottom_m: f64,
    /// Height of the upper edge above the ground, m.
    pub top_m: f64,
    /// Breadth across the wind, m.
    pub breadth_m: f64,
    /// Sum of the force coefficients of the windward and leeward sides.
    pub force_coefficient: f64,
    /// The wind at mid-height of the strip.
    pub wind: Turbulence,
}

/// The strips of a face from the lowest up, and the properties of the air flow.
#[derive(Clone, Debug, PartialEq)]
pub struct GustFace {
    /// The strips; they do not overlap.
    pub strips: Vec<GustStrip>,
    /// Air density ρ, kg/m³.
    pub air_density_kg_m3: f64,
    /// Spectrum of the turbulence.
    pub spectrum: TurbulenceSpectrum,
    /// C, default [`COHERENCE_DECAY`]; with 0 the same gust acts on the whole face.
    pub coherence_decay: f64,
}

impl GustFace {
    /// Refuses invalid strips.
    ///
    /// # Errors
    /// [`WindError::NotPositive`] if a dimension, coefficient or speed is not positive.
    pub fn check(&self) -> Result<(), WindError> {
        let positive = super::error::positive;
        positive("air_density_kg_m3", self.air_density_kg_m3)?;
        for strip in &self.strips {
            positive("strip_height_m", strip.top_m - strip.bottom_m)?;
            positive("breadth_m", strip.breadth_m)?;
            positive("force_coefficient", strip.force_coefficient)?;
            positive("mean_speed_m_s", strip.wind.mean_speed_m_s)?;
            positive("turbulence_intensity", strip.wind.intensity)?;
            positive("turbulence_length_m", strip.wind.length_m)?;
        }
        match self.coherence_decay >= 0.0 && self.coherence_decay.is_finite() {
            true => Ok(()),
            false => Err(WindError::NotPositive {
                quantity: "coherence_decay",
                given: self.coherence_decay,
            }),
        }
    }

    /// Frequency below which the spectral densities are constant within 1e-5, Hz.
    pub(crate) fn lowest_hz(&self) -> f64 {
        const FLAT: f64 = 1e-6;
        let slow = self.strips.iter();
        let slow = slow.map(|strip| FLAT * strip.wind.mean_speed_m_s / strip.wind.length_m);
        slow.fold(f64::INFINITY, f64::min)
    }

    /// Independent force patterns on the strips at a frequency, each with one value per strip and length 1. They are sorted by variance, the
    /// largest first, and include at least the fraction `part` of the total variance.
    ///
    /// # Errors
    /// [`LinalgError`] if the decomposition fails.
    pub fn independent_shapes(&self, frequency_hz: f64, part: f64) -> Result<Vec<Vec<f64>>, LinalgError> {
        let found = symmetric_eigen(&self.force_density_n2_hz(frequency_hz))?;
        let whole: f64 = found.values.iter().sum();
        let mut order: Vec<usize> = (0..found.values.len()).collect();
        order.sort_by(|a, b| found.values[*b].total_cmp(&found.values[*a]));
        let strong = order.into_iter().filter(|k| found.values[*k] > part * whole);
        Ok(strong.map(|k| found.vectors.column(k).to_vec()).collect())
    }

    /// Mean force on each strip, N.
    pub fn mean_forces_n(&self) -> Vec<f64> {
        let each = self.strips.iter();
        each.map(|strip| 0.5 * self.force_per_speed(strip) * strip.wind.mean_speed_m_s)
            .collect()
    }

    fn force_per_speed(&self, strip: &GustStrip) -> f64 {
        let area_m2 = strip.breadth_m * (strip.top_m - strip.bottom_m);
        self.air_density_kg_m3 * strip.force_coefficient * area_m2 * strip.wind.mean_speed_m_s
    }

    /// One-sided cross spectral density of the strip forces at a frequency above 0, N²/Hz; real and symmetric.
    ///
    /// ```text
    /// S_ij = χ_i χ_j √(S_u,i S_u,j J_i J_j) · mean of exp(−c |z − z′|) over both strips                      strips × strips
    /// c = C n/V̄,  V̄ = (V_i + V_j)/2,  J_i = 2 (x − 1 + e^−x)/x²,  x = c b_i: the coherence averaged over the breadth
    /// ```
    /// Averaging over a strip gives the aerodynamic admittance: a gust smaller than the strip does not act on all of it.
    ///
    /// # Limits
    /// Quasi-steady and linear in the gust speed (the term I_u² is left out: about 3 % of the mean). Gusts act on the front and the back of the
    /// building at the same time, and aerodynamic damping is left out; both assumptions are conservative.
    ///
    /// # Source
    /// Davenport A. G. (1967) J. Struct. Div. ASCE 93(3):11–34. With one strip over the whole height and C = 9.2, the product of both J equals
    /// R_h R_b of EN 1991-1-4:2005, B.7 and B.8. Tested by `gusts`.
    pub fn force_density_n2_hz(&self, frequency_hz: f64) -> Matrix {
        let n = self.strips.len();
        let gusts: Vec<f64> = self
            .strips
            .iter()
            .map(|strip| self.force_per_speed(strip) * strip.wind.density(self.spectrum, frequency_hz).sqrt())
            .collect();
        let mut density = Matrix::zeros(n, n);
        for i in 0..n {
            for j in 0..=i {
                let together = gusts[i] * gusts[j] * self.together(i, j, frequency_hz);
                density[(i, j)] = together;
                density[(j, i)] = together;
            }
        }
        density
    }

    /// The coherence, averaged over strips i and j.
    fn together(&self, i: usize, j: usize, frequency_hz: f64) -> f64 {
        let (own, other) = (&self.strips[i], &self.strips[j]);
        let speed = 0.5 * (own.wind.mean_speed_m_s + other.wind.mean_speed_m_s);
        let c = self.coherence_decay * frequency_hz / speed;
        let breadth = (within(c * own.breadth_m) * within(c * other.breadth_m)).sqrt();
        let height = match i == j {
            true => within(c * (own.top_m - own.bottom_m)),
            false => {
                let gap = (own.bottom_m - other.top_m)
                    .max(other.bottom_m - own.top_m)
                    .max(0.0);
                let half = |strip: &GustStrip| decayed(c * (strip.top_m - strip.bottom_m));
                (-c * gap).exp() * half(own) * half(other)
            }
        };
        breadth * height
    }
}

/// Mean of e^(−x |s − t|) over s, t in (0, 1): 2 (x − 1 + e^−x)/x².
fn within(x: f64) -> f64 {
    // for smaller x the difference loses digits; the error of the series is x³/60
    const SMALL: f64 = 1e-4;
    match x < SMALL {
        true => 1.0 - x / 3.0 + x * x / 12.0,
        false => 2.0 * (x - 1.0 + (-x).exp()) / (x * x),
    }
}

/// Mean of e^(−x s) over s in (0, 1): (1 − e^−x)/x.
fn decayed(x: f64) -> f64 {
    match x < 1e-12 {
        true => 1.0,
        false => -(-x).exp_m1() / x,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(decay: f64) -> GustFace {
        let strip = |bottom_m: f64, top_m, breadth_m, speed| GustStrip {
            bottom_m,
            top_m,
            breadth_m,
            force_coefficient: 1.3,
            wind: Turbulence {
                mean_speed_m_s: speed,
                intensity: 0.2,
                length_m: 100.0,
            },
        };
        GustFace {
            strips: vec![strip(2.0, 6.0, 10.0, 20.0), strip(6.0, 11.0, 8.0, 24.0)],
            air_density_kg_m3: 1.25,
            spectrum: TurbulenceSpectrum::Kaimal,
            coherence_decay: decay,
        }
    }

    /// The same density by sums over many points of both strips, each point with the wind speed of its strip.
    fn by_points(face: &GustFace, i: usize, j: usize, hz: f64) -> f64 {
        const POINTS: usize = 200;
        let middle = |k: usize, low: f64, high: f64| low + (high - low) * (k as f64 + 0.5) / POINTS as f64;
        let (own, other) = (&face.strips[i], &face.strips[j]);
        let speed = 0.5 * (own.wind.mean_speed_m_s + other.wind.mean_speed_m_s);
        let c = face.coherence_decay * hz / speed;
        let average = |a: [f64; 2], b: [f64; 2]| {
            let all = (0..POINTS).flat_map(|k| (0..POINTS).map(move |l| (k, l)));
            let sum: f64 = all
                .map(|(k, l)| (-c * (middle(k, a[0], a[1]) - middle(l, b[0], b[1])).abs()).exp())
                .sum();
            sum / (POINTS * POINTS) as f64
        };
        let breadth = |strip: &GustStrip| average([0.0, strip.breadth_m], [0.0, strip.breadth_m]);
        let height = average([own.bottom_m, own.top_m], [other.bottom_m, other.top_m]);
        (breadth(own) * breadth(other)).sqrt() * height
    }

    #[test]
    fn agrees_with_sums_over_points_of_both_strips() {
        let face = face(10.0);
        for hz in [0.003, 0.05, 0.4, 1.5] {
            for (i, j) in [(0, 0), (1, 1), (0, 1)] {
                let (exact, sum) = (face.together(i, j, hz), by_points(&face, i, j, hz));
                assert!((exact / sum - 1.0).abs() < 2e-3, "{hz} {i} {j}: {exact} {sum}");
            }
        }
    }

    #[test]
    fn exact_one_gust_over_the_whole_face_without_decay() {
        let face = face(0.0);
        let density = face.force_density_n2_hz(0.1);
        let whole = density[(0, 0)] + density[(1, 1)] + 2.0 * density[(0, 1)];
        let sum = density[(0, 0)].sqrt() + density[(1, 1)].sqrt();
        assert!((whole / (sum * sum) - 1.0).abs() < 1e-12);
        // χ = ρ C_f A V, S_u = σ² · 6.8 f/(1 + 10.2 f)^(5/3)/n with f = 0.1 · 100/20 = 0.5
        let speed: f64 = 16.0 * 6.8 * 0.5 / 6.1_f64.powf(5.0 / 3.0) / 0.1;
        let force = 1.25 * 1.3 * 40.0 * 20.0;
        assert!((density[(0, 0)] / (force * force * speed) - 1.0).abs() < 1e-12);
        let mean = face.mean_forces_n()[0];
        assert!((mean - 0.5 * 1.25 * 400.0 * 1.3 * 40.0).abs() < 1e-9);
    }

    #[test]
    fn refuses_a_strip_without_breadth() {
        let mut face = face(10.0);
        face.strips[1].breadth_m = 0.0;
        assert_eq!(
            face.check(),
            Err(WindError::NotPositive {
                quantity: "breadth_m",
                given: 0.0
            })
        );
    }
}
