//! Friction of given size that acts at many points of one joint, in a conic programme.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | S | `strength` | friction of all points together, over the weight |
//! | n, v_k | –, `slips` | number of points; slip rate at a point, in the plane of the joint |
//! | F | – | power of the friction over S: Σ |v_k| / n |
//! | R_k | – | rotation in the plane, for each point |
//!
//! ```text
//! F(v) = Σ |v_k| / n  ≥  |Σ R_kᵀ v_k| / n        equal in a mechanism in which R_k turns v_k into a common direction
//! ```
//!
//! Each choice of rotations is one disc: a force z with |z| ≤ S, of which every point takes R_k z / n. Forces of discs are possible forces of the points,
//! so that a programme with a few discs is on the safe side, and as good as one with all points where no disc for its mechanism resists more.

use super::limit_pushes::{Column, HeldFriction};
use std::collections::BTreeMap;

/// Coefficients (of order 1) below this are rounding errors and are left out. Our choice.
const ROUNDING: f64 = 1e-13;
/// Share of the power of the friction that may be left out. Our choice: the limit is lower by no more.
const LEFT_OUT: f64 = 1e-6;

/// One disc of forces that its points can take together.
#[derive(Clone)]
pub(super) struct HeldDisc {
    /// Columns of the two components of z.
    pub(super) parts: [Column; 2],
    /// Σ R_k / n, by rows.
    turns: [[f64; 2]; 2],
}

impl HeldDisc {
    /// The sum of the forces of all points.
    pub(super) fn resultant(&self, force: [f64; 2]) -> [f64; 2] {
        self.turns.map(|row| row[0] * force[0] + row[1] * force[1])
    }
}

impl HeldFriction {
    /// The disc of equal forces at all points.
    pub(super) fn even(&self) -> HeldDisc {
        self.disc(|_| [1.0, 0.0])
    }

    /// The disc that resists a mechanism most, if all points together resist it by clearly more than a rate.
    pub(super) fn disc_against(&self, velocities: &[f64], rate: f64) -> Option<HeldDisc> {
        let along =
            |column: &Column| -> f64 { column.iter().map(|&(row, value)| value * velocities[row]).sum() };
        let slips: Vec<[f64; 2]> = self
            .points
            .iter()
            .map(|[first, second]| [along(first), along(second)])
            .collect();
        let power = slips.iter().map(|slip| slip[0].hypot(slip[1])).sum::<f64>() / slips.len() as f64;
        let towards = |point: usize| {
            let [x, y] = slips[point];
            match x.hypot(y) {
                length if length > 0.0 => [x / length, y / length],
                _ => [1.0, 0.0],
            }
        };
        (power * (1.0 - LEFT_OUT) > rate).then(|| self.disc(towards))
    }

    /// The disc whose first component acts at each point along a unit vector.
    fn disc(&self, towards: impl Fn(usize) -> [f64; 2]) -> HeldDisc {
        let share = 1.0 / self.points.len() as f64;
        let mut sums = [0, 1].map(|_| BTreeMap::<usize, f64>::new());
        let mut turns = [[0.0; 2]; 2];
        for (point, columns) in self.points.iter().enumerate() {
            let [x, y] = towards(point);
            for (sum, way) in sums.iter_mut().zip([[x, y], [-y, x]]) {
                for (column, part) in columns.iter().zip(way) {
                    for &(row, value) in column {
                        *sum.entry(row).or_default() += share * part * value;
                    }
                }
            }
            for (sum, row) in turns.iter_mut().zip([[x, -y], [y, x]]) {
                *sum = [0, 1].map(|k| sum[k] + share * row[k]);
            }
        }
        let parts = sums.map(|sum| {
            sum.into_iter()
                .filter(|(_, value)| value.abs() > ROUNDING)
                .collect()
        });
        HeldDisc { parts, turns }
    }
}
