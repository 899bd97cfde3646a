//! A frame for the series of its motion, and its state.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | M, K, C | `mass_kg`, `k`, `c` | masses of the levels, stiffness with P-delta, viscous damping | kg, N/m, N s/m |
//! | z | `offset_m` | position of the slider of a Jenkins element, on the axis of its drift | m |

use super::DynamicsError;
use super::frame_friction::{FrictionFrame, StoreyFriction};
use super::frame_tenon::Joint;
use dolmen_linalg::Matrix;
use std::ops::Range;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Slider {
    /// No slider.
    Absent,
    /// It sticks.
    Stuck,
    /// It slips towards +1 or −1.
    Slipping(f64),
}

#[derive(Clone, Debug, Default)]
pub(super) struct State {
    pub(super) y: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) slider: Vec<Slider>,
    pub(super) offset_m: Vec<f64>,
    /// Tenons of each storey.
    pub(super) joint: Vec<Option<Joint>>,
}

/// A frame for the series.
pub(super) struct Model {
    pub(super) mass_kg: Vec<f64>,
    pub(super) friction: Vec<StoreyFriction>,
    /// Stiffness of the tenons of each storey as built, N/m; 0 for none.
    pub(super) tenon_n_m: Vec<f64>,
    /// Level below each slider; `None` for the ground.
    pub(super) below: Vec<Option<usize>>,
    pub(super) k: Rows,
    pub(super) c: Option<Rows>,
}

/// A sparse matrix: the nonzero entries of all rows, one row after the other.
#[derive(Default)]
pub(super) struct Rows {
    ends: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Rows {
    fn of(matrix: &Matrix) -> Self {
        let mut rows = Rows::default();
        for i in 0..matrix.rows() {
            let row = (0..matrix.columns()).map(|j| (j, matrix[(i, j)]));
            rows.entries.extend(row.filter(|(_, x)| *x != 0.0));
            rows.ends.push(rows.entries.len());
        }
        rows
    }

    pub(super) fn clear(&mut self) {
        self.ends.clear();
        self.entries.clear();
    }

    /// Adds a row: `factor` times the entries of `sum` in `columns`, which become zero again.
    pub(super) fn add(&mut self, factor: f64, sum: &mut [f64], columns: Range<usize>) {
        for j in columns {
            if sum[j] != 0.0 {
                self.entries.push((j, factor * sum[j]));
                sum[j] = 0.0;
            }
        }
        self.ends.push(self.entries.len());
    }

    /// The rows, from the first.
    pub(super) fn each(&self) -> impl Iterator<Item = &[(usize, f64)]> {
        let mut begin = 0;
        self.ends.iter().map(move |&end| {
            let row = &self.entries[begin..end];
            begin = end;
            row
        })
    }

    pub(super) fn row(&self, i: usize) -> &[(usize, f64)] {
        let begin = if i == 0 { 0 } else { self.ends[i - 1] };
        &self.entries[begin..self.ends[i]]
    }

    /// Adds row i to `sum`. Returns the range of columns in which it has entries.
    pub(super) fn sum_up(&self, i: usize, sum: &mut [f64]) -> Range<usize> {
        let row = self.row(i);
        for (j, a) in row {
            sum[*j] += a;
        }
        match (row.first(), row.last()) {
            (Some((first, _)), Some((last, _))) => *first..last + 1,
            _ => i..i,
        }
    }

    /// xᵀ A x.
    fn form(&self, x: &[f64]) -> f64 {
        let mut form = 0.0;
        for (row, x_i) in self.each().zip(x) {
            let mut sum = 0.0;
            for (j, a) in row {
                sum += a * x[*j];
            }
            form += x_i * sum;
        }
        form
    }

    fn size(&self, i: usize) -> f64 {
        self.row(i).iter().map(|(_, a)| a.abs()).sum()
    }
}

impl Model {
    pub(super) fn of(frame: &FrictionFrame) -> Result<Self, DynamicsError> {
        let n = frame.frame.storeys().len();
        let k = frame.frame.stiffness_matrix(&frame.stiffness_n_m)?;
        Ok(Model {
            mass_kg: frame.frame.storeys().iter().map(|s| s.mass_kg).collect(),
            friction: frame.friction.iter().map(|friction| friction.acting()).collect(),
            tenon_n_m: frame
                .tenons
                .iter()
                .map(|tenon| tenon.map_or(0.0, |of| of.stiffness_n_m))
                .collect(),
            below: (0..n).map(|i| frame.below(i)).collect(),
            k: Rows::of(&k),
            c: frame.damping_matrix()?.as_ref().map(Rows::of),
        })
    }

    pub(super) fn levels(&self) -> usize {
        self.mass_kg.len()
    }

    pub(super) fn damped(&self) -> bool {
        self.c.is_some()
    }

    /// Motion of the upper level minus that of the level below the slider.
    pub(super) fn across(&self, i: usize, x: &[f64]) -> f64 {
        x[i] - self.below[i].map_or(0.0, |j| x[j])
    }

    /// Longest step on which the series converges as fast as that of a sine over one radian, s.
    pub(super) fn step_most_s(&self) -> f64 {
        let n = self.levels();
        let mut stiffness: Vec<f64> = (0..n).map(|i| self.k.size(i)).collect();
        for (i, friction) in self.friction.iter().enumerate() {
            if let StoreyFriction::Jenkins {
                stuck_stiffness_n_m, ..
            } = *friction
            {
                stiffness[i] += 2.0 * stuck_stiffness_n_m;
                if let Some(j) = self.below[i] {
                    stiffness[j] += 2.0 * stuck_stiffness_n_m;
                }
            }
        }
        for (i, tenon_n_m) in self.tenon_n_m.iter().enumerate() {
            stiffness[i] += 2.0 * tenon_n_m;
            if let Some(below) = i.checked_sub(1) {
                stiffness[below] += 2.0 * tenon_n_m;
            }
        }
        let mut step = f64::INFINITY;
        for (i, &mass) in self.mass_kg.iter().enumerate() {
            if stiffness[i] > 0.0 {
                step = step.min((mass / stiffness[i]).sqrt());
            }
            if let Some(size) = self.c.as_ref().map(|c| c.size(i)).filter(|size| *size > 0.0) {
                step = step.min(mass / size);
            }
        }
        step
    }

    pub(super) fn damping_power(&self, v: &[f64]) -> f64 {
        self.c.as_ref().map_or(0.0, |c| c.form(v))
    }

    /// Energy of motion relative to the ground, J.
    pub(super) fn kinetic_j(&self, v: &[f64]) -> f64 {
        let terms = self.mass_kg.iter().zip(v);
        0.5 * terms.map(|(m, v)| m * v * v).sum::<f64>()
    }

    /// Energy in the springs minus the contribution of P-delta, J.
    pub(super) fn stored_j(&self, state: &State) -> f64 {
        let mut series = 0.0;
        for (i, friction) in self.friction.iter().enumerate() {
            if let StoreyFriction::Jenkins {
                stuck_stiffness_n_m, ..
            } = friction
            {
                let force = self.jenkins_force(i, state);
                series += force * force / stuck_stiffness_n_m;
            }
        }
        let joints = state.joint.iter().enumerate();
        let tenons: f64 = joints
            .filter_map(|(i, joint)| Some(joint.as_ref()?.stored_j(drift_m(&state.y, i))))
            .sum();
        0.5 * (self.k.form(&state.y) + series) + tenons
    }

    /// Force in the Jenkins element of a storey, N.
    pub(super) fn jenkins_force(&self, i: usize, state: &State) -> f64 {
        match (self.friction[i], state.slider[i]) {
            (
                StoreyFriction::Jenkins {
                    stuck_stiffness_n_m, ..
                },
                Slider::Stuck,
            ) => stuck_stiffness_n_m * (self.across(i, &state.y) - state.offset_m[i]),
            (StoreyFriction::Jenkins { kinetic_force_n, .. }, Slider::Slipping(sign)) => {
                sign * kinetic_force_n
            }
            _ => 0.0,
        }
    }
}

pub(super) fn drift_m(y: &[f64], storey: usize) -> f64 {
    y[storey] - storey.checked_sub(1).map_or(0.0, |below| y[below])
}
