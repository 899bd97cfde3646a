//! Free oscillations of a mass on free-standing columns: the larger the amplitude, the lower the frequency.

use super::column::FreeColumns;
use crate::numeric::nodes_15;
use std::f64::consts::FRAC_PI_2;

impl FreeColumns {
    /// Frequency of free oscillations of `mass_kg` on the columns, Hz, with a parallel spring of `spring_n_m`. The amplitude must be below
    /// the rotation of zero force.
    ///
    /// ```text
    /// T/4 = ∫ ds √(m / 2 (E(Θ) − E(θ))),   E(Θ) − E(θ) = ∫ (V + k u) du,   ds² = du² + dz²
    /// ```
    ///
    /// z is the height to which the columns lift the mass. Quadrature over θ = Θ sin τ, where the integrand is not singular.
    ///
    /// # Limits
    /// Without losses: an impact as the columns pass the upright position takes energy, but does not change the period for the remaining
    /// amplitude. The settlement of the bed is not included in z.
    pub fn swing_frequency_hz(&self, mass_kg: f64, spring_n_m: f64, rotation_rad: f64) -> f64 {
        let work_n_m = |from: f64| {
            let columns = self.integral(from, rotation_rad, &|t| self.axial_n() * self.rise_m(t));
            let spring = if spring_n_m > 0.0 {
                let [from, to] = [from, rotation_rad].map(|rotation| self.at(rotation).drift_m);
                0.5 * spring_n_m * (to - from) * (to + from)
            } else {
                0.0
            };
            columns + spring
        };
        let mut quarter_s = 0.0;
        let mut from = 0.0;
        for cut in self.cuts(0.0, rotation_rad) {
            let to = if cut < rotation_rad {
                (cut / rotation_rad).asin()
            } else {
                FRAC_PI_2
            };
            for node in nodes_15(from, to) {
                let (sin, cos) = node.x.sin_cos();
                let rotation = rotation_rad * sin;
                let moved_m = self.sway_m(rotation).hypot(self.rise_m(rotation)) * rotation_rad * cos;
                quarter_s += node.weight * moved_m * (0.5 * mass_kg / work_n_m(rotation)).sqrt();
            }
            from = to;
        }
        0.25 / quarter_s
    }

    /// z at one rotation less that at another, m.
    pub(crate) fn rise_between_m(&self, from_rad: f64, to_rad: f64) -> f64 {
        self.integral(from_rad, to_rad, &|t| self.rise_m(t))
    }

    /// du/dθ, m.
    fn sway_m(&self, rotation_rad: f64) -> f64 {
        let (sin, cos) = rotation_rad.sin_cos();
        self.height_m() * cos + 2.0 * self.eccentricity_m(rotation_rad) * sin
    }

    /// dz/dθ, m: V du = N dz.
    fn rise_m(&self, rotation_rad: f64) -> f64 {
        let (sin, cos) = rotation_rad.sin_cos();
        2.0 * self.eccentricity_m(rotation_rad) * cos - self.height_m() * sin
    }
}
