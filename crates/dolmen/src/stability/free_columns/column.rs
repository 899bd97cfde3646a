//! A row of equal columns that rock at foot and head.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | n | `count` | columns | – |
//! | b, h | `width_m`, `height_m` | width of foot and head, height of the column | m |
//! | N, e | `normal_n`, `eccentricity_m` | axial force of one column; distance of the resultants from its axis at foot and head | N, m |
//! | θ, u, V | `rotation_rad`, `drift_m`, `force_n` | rotation of the columns, displacement of the head, force on all columns | rad, m, N |

use super::foot::FootSection;
use crate::numeric::{Bracketing, bracketed_root, maximum_between, nodes_15};
use crate::stability::StabilityError;

/// Equal free-standing columns with the weight on their heads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeColumns {
    count: usize,
    section: FootSection,
    height_m: f64,
    axial_n: f64,
    bed_stiffness_n_m3: Option<f64>,
}

/// A point of the curve of force against drift.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ColumnPoint {
    /// θ, rad.
    pub rotation_rad: f64,
    /// u, m.
    pub drift_m: f64,
    /// V, the horizontal resistance of all columns, N.
    pub force_n: f64,
}

/// Resistance of columns under weight alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ColumnStanding {
    /// Lift-off of the edges of foot and head.
    pub uplift: ColumnPoint,
    /// Largest resistance.
    pub greatest: ColumnPoint,
    /// Fall: V is 0.
    pub falls: ColumnPoint,
}

/// Ratio of the ends of one quadrature interval of e(θ) beyond uplift. Our choice: accurate to 1e-14.
const PANEL: f64 = 2.0;

impl FreeColumns {
    /// `axial_n` is the total weight on the columns, shared equally; a bed stiffness of `None` means a rigid bed.
    ///
    /// # Errors
    /// [`StabilityError::Option`] unless all are positive.
    pub fn new(
        count: usize,
        section: FootSection,
        height_m: f64,
        axial_n: f64,
        bed_stiffness_n_m3: Option<f64>,
    ) -> Result<FreeColumns, StabilityError> {
        let breadth_m = match section {
            FootSection::Rectangle { breadth_m, .. } => breadth_m,
            FootSection::Circle { diameter_m } => diameter_m,
        };
        let given = [
            ("count", count as f64),
            ("width_m", section.width_m()),
            ("breadth_m", breadth_m),
            ("height_m", height_m),
            ("axial_n", axial_n),
            ("bed_stiffness_n_m3", bed_stiffness_n_m3.unwrap_or(1.0)),
        ];
        for (option, given) in given {
            if !(given > 0.0 && given.is_finite()) {
                return Err(StabilityError::Option {
                    option,
                    given,
                    allowed: "positive and finite",
                });
            }
        }
        Ok(FreeColumns {
            count,
            section,
            height_m,
            axial_n,
            bed_stiffness_n_m3,
        })
    }

    /// n.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The total weight on the columns, N.
    pub fn axial_n(&self) -> f64 {
        self.axial_n
    }

    /// Lateral stiffness of the beds of foot and head in full contact, N/m: 2 n k_w I/h². The weight reduces it by N/h. `None` for a rigid bed,
    /// where it is unbounded.
    pub fn bed_stiffness_n_m(&self) -> Option<f64> {
        let moment_n_m = self.bed_stiffness_n_m3? * self.section.second_moment_m4();
        Some(2.0 * self.count as f64 * moment_n_m / self.height_m.powi(2))
    }

    /// The bed stiffness at which columns with this weight just stand, N/m³: k_w = N h/(2 n I), that is k_w B b³/6 = N h/n.
    pub fn least_bed_stiffness_n_m3(&self) -> f64 {
        self.normal_n() * self.height_m / (2.0 * self.section.second_moment_m4())
    }

    /// The columns on beds that give this stiffness at small drift, N/m.
    pub fn on_beds_of(&self, stiffness_n_m: f64) -> FreeColumns {
        let per_bed_m = 2.0 * self.count as f64 * self.section.second_moment_m4() / self.height_m.powi(2);
        FreeColumns {
            bed_stiffness_n_m3: Some(stiffness_n_m / per_bed_m),
            ..*self
        }
    }

    /// Lift-off of the edges of foot and head; `None` for a rigid bed, where they lift at once.
    pub fn uplift(&self) -> Option<ColumnPoint> {
        let bed = self.bed_stiffness_n_m3?;
        Some(self.at(self.section.uplift_rotation_rad(bed, self.normal_n())))
    }

    /// atan(b/h), at which columns on rigid beds fall.
    pub(super) fn rigid_fall_rad(&self) -> f64 {
        (self.section.width_m() / self.height_m).atan()
    }

    /// The rotation at which the heads have this drift, rad.
    ///
    /// # Errors
    /// [`StabilityError::Numeric`] if the root is not found; no such case is known.
    pub fn rotation_at_rad(&self, drift_m: f64) -> Result<f64, StabilityError> {
        if drift_m <= 0.0 {
            return Ok(0.0);
        }
        // rolling increases the drift beyond h sin θ
        let most_rad = (drift_m / self.height_m).min(1.0).asin();
        let off = |rotation: f64| self.at(rotation).drift_m - drift_m;
        if off(most_rad) <= 0.0 {
            return Ok(most_rad);
        }
        Ok(bracketed_root(off, 0.0, most_rad, &Bracketing::default())?)
    }

    /// Drift at which the columns balance a horizontal force, up to their largest resistance, m; `None` if they do not.
    ///
    /// # Errors
    /// As [`FreeColumns::standing`].
    pub fn drift_under_m(&self, force_n: f64) -> Result<Option<f64>, StabilityError> {
        let rotation = self.rotation_under_rad(force_n)?;
        Ok(rotation.map(|rotation| self.at(rotation).drift_m))
    }

    /// The rotation of that drift, rad.
    pub(crate) fn rotation_under_rad(&self, force_n: f64) -> Result<Option<f64>, StabilityError> {
        let standing = self.standing()?;
        let Some(most) = standing
            .map(|standing| standing.greatest)
            .filter(|most| force_n < most.force_n)
        else {
            return Ok(None);
        };
        if force_n <= 0.0 {
            return Ok(Some(0.0));
        }
        let off = |rotation: f64| self.restoring_n(rotation) - force_n;
        Ok(Some(bracketed_root(
            off,
            0.0,
            most.rotation_rad,
            &Bracketing::default(),
        )?))
    }

    /// Resistance of the columns under weight alone; `None` if they do not stand.
    ///
    /// ```text
    /// full contact: tan ψ = λ θ, λ = k_w/k_least      V = n N tan(ψ − θ) is largest at θ = √(λ − 1)/λ
    /// ```
    /// Where this is below the rotation of lift-off, columns with λ near 1 fall before their edges lift.
    ///
    /// # Errors
    /// [`StabilityError::Numeric`] if a root is not found; no such case is known.
    pub fn standing(&self) -> Result<Option<ColumnStanding>, StabilityError> {
        let rigid_rad = self.rigid_fall_rad();
        let Some(bed) = self.bed_stiffness_n_m3 else {
            return Ok(Some(ColumnStanding {
                uplift: self.at(0.0),
                greatest: self.at(0.0),
                falls: self.at(rigid_rad),
            }));
        };
        let factor = bed / self.least_bed_stiffness_n_m3();
        if factor <= 1.0 {
            return Ok(None);
        }
        let balance = |rotation: f64| self.restoring_n(rotation);
        let uplift_rad = self.section.uplift_rotation_rad(bed, self.normal_n());
        let in_contact_rad = (factor - 1.0).sqrt() / factor;
        let greatest_rad = match in_contact_rad < uplift_rad {
            true => in_contact_rad,
            false => maximum_between(&balance, uplift_rad, rigid_rad),
        };
        if balance(greatest_rad) <= 0.0 {
            return Ok(None); // a factor that rounding does not tell from 1
        }
        let falls_rad = bracketed_root(balance, greatest_rad, rigid_rad, &Bracketing::default())?;
        Ok(Some(ColumnStanding {
            uplift: self.at(uplift_rad),
            greatest: self.at(greatest_rad),
            falls: self.at(falls_rad),
        }))
    }

    /// Drift and force at a rotation θ ≥ 0.
    ///
    /// ```text
    /// V = n N tan(ψ − θ),  tan ψ = 2 e(θ)/h          the resultants at foot and head and the force are in line
    /// u = h sin θ + 2 ∫ e sin θ dθ                    foot and head roll without slipping
    /// rigid bed, e = b/2:  V = n N tan(α − θ),  u = h sin θ + b (1 − cos θ),  tan α = b/h
    /// ```
    ///
    /// At θ = 0 on a rigid bed, V is the value just after the columns begin to move.
    ///
    /// # Limits
    /// Foot and head are equal, with equal beds; the weight of the column itself is included in N or neglected. Foot and head do not slip, and
    /// nothing crushes.
    pub fn at(&self, rotation_rad: f64) -> ColumnPoint {
        let rolled_m = match self.bed_stiffness_n_m3 {
            None => self.section.width_m() * 2.0 * (0.5 * rotation_rad).sin().powi(2),
            Some(_) => self.integral(0.0, rotation_rad, &|t| 2.0 * self.eccentricity_m(t) * t.sin()),
        };
        ColumnPoint {
            rotation_rad,
            drift_m: self.height_m * rotation_rad.sin() + rolled_m,
            force_n: self.restoring_n(rotation_rad),
        }
    }

    /// The curve of force against drift from upright to the fall, with `points` rotations; empty if the columns do not stand.
    ///
    /// # Errors
    /// As [`FreeColumns::standing`].
    pub fn curve(&self, points: usize) -> Result<Vec<ColumnPoint>, StabilityError> {
        let Some(standing) = self.standing()? else {
            return Ok(Vec::new());
        };
        // squared: the curvature is largest where the feet lift off
        let share = |i: usize| (i as f64 / (points.max(2) - 1) as f64).powi(2);
        let rotations = (0..points.max(2)).map(|i| share(i) * standing.falls.rotation_rad);
        Ok(rotations.map(|rotation| self.at(rotation)).collect())
    }

    pub(super) fn normal_n(&self) -> f64 {
        self.axial_n / self.count as f64
    }

    /// Their height, m.
    pub fn height_m(&self) -> f64 {
        self.height_m
    }

    /// V, N.
    pub(crate) fn restoring_n(&self, rotation_rad: f64) -> f64 {
        let lever = (2.0 * self.eccentricity_m(rotation_rad)).atan2(self.height_m);
        self.axial_n * (lever - rotation_rad).tan()
    }

    /// e′(θ) at θ ≥ 0, m; 0 on a rigid bed.
    pub(crate) fn eccentricity_slope_m(&self, rotation_rad: f64) -> f64 {
        let slope = |bed| {
            self.section
                .eccentricity_slope_m(bed, self.normal_n(), rotation_rad)
        };
        self.bed_stiffness_n_m3.map_or(0.0, slope)
    }

    /// e(θ) at θ ≥ 0, m.
    pub(crate) fn eccentricity_m(&self, rotation_rad: f64) -> f64 {
        match self.bed_stiffness_n_m3 {
            None => 0.5 * self.section.width_m(),
            Some(bed) => {
                let pressure = self.section.pressure(bed, self.normal_n(), rotation_rad);
                pressure.eccentricity_m
            }
        }
    }

    /// ∫ f dθ from `low` to `high`, divided where the feet lift off and at each doubling of θ beyond.
    pub(super) fn integral(&self, low: f64, high: f64, f: &dyn Fn(f64) -> f64) -> f64 {
        let mut sum = 0.0;
        let mut from = low;
        for cut in self.cuts(low, high) {
            let nodes = nodes_15(from, cut);
            sum += nodes.iter().map(|node| node.weight * f(node.x)).sum::<f64>();
            from = cut;
        }
        sum
    }

    /// Ends of the intervals between `low` and `high` in which e(θ) is smooth; `high` is the last.
    pub(super) fn cuts(&self, low: f64, high: f64) -> Vec<f64> {
        let uplift = self
            .bed_stiffness_n_m3
            .map(|bed| self.section.uplift_rotation_rad(bed, self.normal_n()));
        let mut cuts = Vec::new();
        if let Some(mut cut) = uplift {
            while cut < high {
                if cut > low {
                    cuts.push(cut);
                }
                cut *= PANEL;
            }
        }
        cuts.push(high);
        cuts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_columns_that_hardly_stand_fall_in_full_contact() {
        let of = |factor: f64| {
            let section = FootSection::Circle { diameter_m: 0.5 };
            let rigid = FreeColumns::new(4, section, 4.0, 294e3, None).unwrap();
            let bed = factor * rigid.least_bed_stiffness_n_m3();
            FreeColumns::new(4, section, 4.0, 294e3, Some(bed)).unwrap()
        };
        // tan θ = λ θ at the fall; the greatest resistance at tan ψ = λ θ, ψ′ = 1
        for factor in [1.0 + 1e-9, 1.0001, 1.0003] {
            let found = of(factor).standing().unwrap().unwrap();
            let falls = found.falls.rotation_rad;
            assert!((falls.tan() / falls - factor).abs() < 1e-12, "{factor} {found:?}");
            let greatest = found.greatest.rotation_rad * factor;
            assert!((greatest - (factor - 1.0).sqrt()).abs() < 1e-12 && falls < found.uplift.rotation_rad);
        }
        // beyond, the edges lift first; both sides of the change agree
        let beyond = of(1.001).standing().unwrap().unwrap();
        assert!(beyond.uplift.rotation_rad < beyond.greatest.rotation_rad);
        assert!(of(1.0 + 2.0 * f64::EPSILON).standing().is_ok());
        assert_eq!(of(1.0).standing().unwrap(), None);
    }
}
