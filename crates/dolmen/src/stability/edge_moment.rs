//! The largest moment that a bed without tension carries, in its plane and in any direction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | N | `normal_n` | normal force | N |
//! | b, w | `width_m`, `depth_m` | sides of the bed | m |
//! | f | `strength_pa` | compressive strength of the bed | Pa |
//! | a | `share` | N/(f b w), fraction of the bed area in the stress block | |
//! | u | `along`, `across` | centre of the stress block from that of the bed, relative to the sides of the bed | |
//! | r | `slope` | the smaller component of u over the larger component | |

/// Dimensions of a rectangular bed relative to the axis of its moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BedEdge {
    /// b, width in the plane of the moment, m.
    pub width_m: f64,
    /// w, depth across that plane, m; `None` if only b is known: the bed then has the same capacity in every direction.
    pub depth_m: Option<f64>,
    /// f, compressive strength of the bed, Pa; `None` if it does not crush.
    pub strength_pa: Option<f64>,
}

impl BedEdge {
    /// The moment at which the resultant of the pressure reaches its farthest position, N m, under a normal force of N.
    ///
    /// ```text
    /// M = N (b/2 − N/(2 f w))        stress block f over N/(f w) at the edge;  f → ∞: N b/2
    /// ```
    ///
    /// The result is 0 if the bed crushes under N alone, or if N is tension.
    pub fn moment_n_m(&self, normal_n: f64) -> f64 {
        let crushed_m = self.strength_pa.map_or(0.0, |strength_pa| {
            normal_n / (strength_pa * self.depth_or_width_m())
        });
        (0.5 * normal_n * (self.width_m - crushed_m)).max(0.0)
    }

    /// The bed with its sides exchanged, for a moment about the other axis.
    pub fn across(&self) -> BedEdge {
        match self.depth_m {
            Some(depth_m) => BedEdge {
                width_m: depth_m,
                depth_m: Some(self.width_m),
                strength_pa: self.strength_pa,
            },
            None => *self,
        }
    }

    /// w, m; b if w is unknown.
    pub fn depth_or_width_m(&self) -> f64 {
        self.depth_m.unwrap_or(self.width_m)
    }

    /// Ratio of k across to k along for a bed of equal springs: w b³/12 along, b w³/12 across.
    pub fn stiffness_ratio_across(&self) -> f64 {
        (self.depth_or_width_m() / self.width_m).powi(2)
    }

    /// The largest moment in a direction, N m, [along b, along w], of any length: the resultant lies at M/N from the centre.
    ///
    /// ```text
    /// f → ∞:  M = N · distance from the centre to the edge in that direction
    /// else:   the stress block is cut off by a straight line, with area N/f and its centre in that direction;
    ///         u = (½ − p/3, ½ − q/3), p q = 2 a          a corner
    ///         u = (m/(12 a), ½ − a/2 − m²/(24 a))        a strip with slope m
    ///         (1 − a)/a times the value for 1 − a        all but a corner
    /// ```
    ///
    /// # Limits
    /// The bed is rigid and perfectly plastic; its rotation is not limited.
    pub fn moment_towards_n_m(&self, normal_n: f64, [along, across]: [f64; 2]) -> f64 {
        let Some(depth_m) = self.depth_m else {
            return self.moment_n_m(normal_n);
        };
        let length = along.hypot(across);
        let towards = [
            along.abs() / length / self.width_m,
            across.abs() / length / depth_m,
        ];
        let (most, least) = (towards[0].max(towards[1]), towards[0].min(towards[1]));
        let share = self.strength_pa.map_or(0.0, |strength_pa| {
            normal_n / (strength_pa * self.width_m * depth_m)
        });
        (normal_n * block_centre(share, least / most) / most).max(0.0)
    }

    /// Factor on a growing moment, added to a present moment, at which the bed reaches its capacity; 0 if the present moment exceeds it. Moments
    /// in N m, [along b, along w].
    pub fn reach(&self, normal_n: f64, there_n_m: [f64; 2], growing_n_m: [f64; 2]) -> f64 {
        const HALVINGS: usize = 60; // below the rounding of the limits
        if self.depth_m.is_none() {
            return reach_of_circle(self.moment_n_m(normal_n), there_n_m, growing_n_m);
        }
        let limits = [self.moment_n_m(normal_n), self.across().moment_n_m(normal_n)];
        // along each side, the stress block reaches no farther than under a moment in that direction only
        let most = (0..2).map(|axis| {
            let (limit, there, growing) = (limits[axis], there_n_m[axis], growing_n_m[axis]);
            match there.abs() >= limit {
                true => 0.0,
                false if growing == 0.0 => f64::INFINITY,
                false => (limit - there * growing.signum()) / growing.abs(),
            }
        });
        let most = most.fold(f64::INFINITY, f64::min);
        let passes = |times: f64| {
            let moment = [0, 1].map(|axis| there_n_m[axis] + times * growing_n_m[axis]);
            let size = moment[0].hypot(moment[1]);
            size == 0.0 || size < self.moment_towards_n_m(normal_n, moment)
        };
        if self.strength_pa.is_none() || most == 0.0 {
            return most;
        }
        if !passes(0.0) {
            return 0.0;
        }
        if most.is_infinite() {
            return most;
        }
        let (mut least, mut most) = (0.0, most);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (least + most);
            match passes(middle) {
                true => least = middle,
                false => most = middle,
            }
        }
        0.5 * (least + most)
    }
}

/// Factor on `growing` at which the sum of present and growing moment has this magnitude.
fn reach_of_circle(limit_n_m: f64, there_n_m: [f64; 2], growing_n_m: [f64; 2]) -> f64 {
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let left = limit_n_m * limit_n_m - dot(there_n_m, there_n_m);
    if left <= 0.0 {
        return 0.0;
    }
    let (size, along) = (dot(growing_n_m, growing_n_m), dot(there_n_m, growing_n_m));
    match size > 0.0 {
        // the root without cancellation
        true => left / (along + (along * along + size * left).sqrt()),
        false => f64::INFINITY,
    }
}

/// The larger component of u on a unit square for a stress block of area `share`; the smaller component is `slope` times as large.
fn block_centre(share: f64, slope: f64) -> f64 {
    if share <= 0.0 {
        return 0.5;
    }
    if share >= 1.0 {
        return 0.0;
    }
    let corner = share.min(1.0 - share);
    let both = share * (1.0 - share);
    let slant = 12.0 * slope * both / (1.0 + (1.0 + 12.0 * slope * slope * both).sqrt());
    if slant <= 2.0 * corner {
        return 0.5 - 0.5 * share - slant * slant / (24.0 * share);
    }
    let rest = 1.5 * (1.0 - slope);
    let longer = 0.5 * (rest + (rest * rest + 8.0 * corner * slope).sqrt());
    let centre = 0.5 - 2.0 * corner / (3.0 * longer);
    match share <= 0.5 {
        true => centre,
        false => centre * corner / share,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_edge_moment_with_and_without_strength() {
        let hard = BedEdge {
            width_m: 0.65,
            depth_m: Some(0.65),
            strength_pa: None,
        };
        assert!((hard.moment_n_m(68.3e3) - 22_197.5).abs() < 1e-9);
        // N = f w b/4: a block of a quarter of the bed, the resultant at 3/8 b
        let soft = BedEdge {
            strength_pa: Some(4.0 * 68.3e3 / (0.65 * 0.65)),
            ..hard
        };
        assert!((soft.moment_n_m(68.3e3) - 68.3e3 * 0.65 * 0.375).abs() < 1e-9);
        // at N = f w b the whole bed crushes
        assert!(soft.moment_n_m(4.0 * 68.3e3).abs() < 1e-9);
        assert_eq!((soft.moment_n_m(5.0 * 68.3e3), hard.moment_n_m(-1.0)), (0.0, 0.0));
    }
    #[test]
    fn exact_a_bed_of_unknown_plan_has_no_corners() {
        let bed = BedEdge {
            width_m: 0.6,
            depth_m: None,
            strength_pa: None,
        };
        let most = 0.3 * 50e3;
        for degrees in [0.0_f64, 30.0, 45.0, 200.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            assert!((bed.moment_towards_n_m(50e3, [cos, sin]) / most - 1.0).abs() < 1e-12);
            assert!((bed.reach(50e3, [0.0; 2], [cos, sin]) / most - 1.0).abs() < 1e-12);
            let there = [4e3, -9e3];
            let times = bed.reach(50e3, there, [cos, sin]);
            let end = (there[0] + times * cos).hypot(there[1] + times * sin);
            assert!((end / most - 1.0).abs() < 1e-12, "{end}");
        }
        assert_eq!(bed.reach(50e3, [12e3, 12e3], [1.0, 0.0]), 0.0);
        assert_eq!(bed.across(), bed);
    }
}
