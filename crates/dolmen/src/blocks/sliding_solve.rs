//! Accelerations of a sliding pile, by Newton's method: the friction of every bed must equal its load.
//!
//! ```text
//! W_i(k) = −μ Σ N_p(k) (t_p, x_p × t_p)  if a joint slides,   k_i = 0 if it is stuck        three rows per joint
//! ```

use super::sliding_bed::{Friction, Pressure, Twist, Wrench};
use super::sliding_chain::{Chain, Load, Motion, Place, Shaking};
use dolmen_linalg::{Matrix, solve};
use glam::{DMat3, DVec2, DVec3};

/// Largest number of Newton steps of one solution.
const NEWTON_MOST: usize = 40;
/// Tolerance of the force balance of each stone, over its weight.
const TOLERANCE: f64 = 1e-12;
/// Tolerance if rounding prevents a better solution.
const ROUNDED: f64 = 1e-9;

/// Motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Slide {
    /// The joint moves as one with the block below.
    Stuck,
    /// Friction acts against the velocity.
    Slides,
    /// Friction acts against the acceleration from rest, with this coefficient.
    LetsGo {
        /// Friction coefficient.
        mu: f64,
    },
}

/// A stage of the Runge–Kutta step: positions and twists are `places` + gh ẋ and `twists` + gh k.
#[derive(Clone, Debug)]
pub(super) struct Stage<'a> {
    pub(super) places: &'a [Place],
    pub(super) twists: &'a [Twist],
    pub(super) gh: f64,
    pub(super) shaking: Shaking,
    pub(super) slides: &'a [Slide],
    /// Velocity or acceleration below which friction is smoothed; 0 means no smoothing.
    pub(super) smooth: f64,
}

/// The accelerations of a solution, with pressures and friction.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    pub(super) k: Vec<Twist>,
    pub(super) twists: Vec<Twist>,
    pub(super) motion: Motion,
    pub(super) load: Load,
    /// Pressure of each sliding joint.
    pub(super) pressures: Vec<Option<Pressure>>,
}

/// Why no accelerations exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoAcceleration {
    /// The pressure leaves the bed: the block above this joint begins to rock.
    Rocks(usize),
    /// The iteration does not converge.
    NoConvergence,
}

impl Chain {
    /// Accelerations that satisfy the friction law at a stage, from an initial guess.
    pub(super) fn accelerations(&self, stage: &Stage<'_>, guess: &[Twist]) -> Result<Solved, NoAcceleration> {
        let free: Vec<usize> = (0..guess.len())
            .filter(|&i| stage.slides[i] != Slide::Stuck)
            .collect();
        let mut solved = self.at(stage, guess.to_vec())?;
        let mut rows = self.rows(stage, &solved, &free);
        let mut left = self.size(&rows, &free, stage.shaking.weight);
        for _ in 0..NEWTON_MOST {
            if left <= TOLERANCE {
                return Ok(solved);
            }
            let step = self
                .newton(stage, &solved, &rows, &free)
                .ok_or(NoAcceleration::NoConvergence)?;
            let mut part = 1.0;
            loop {
                let mut k = solved.k.clone();
                for (&i, step) in free.iter().zip(&step) {
                    k[i] -= part * *step;
                }
                let tried = self.at(stage, k);
                if let Ok(tried) = tried {
                    let tried_rows = self.rows(stage, &tried, &free);
                    let tried_left = self.size(&tried_rows, &free, stage.shaking.weight);
                    if tried_left < left {
                        (solved, rows, left) = (tried, tried_rows, tried_left);
                        break;
                    }
                } else if part < 1e-3 {
                    return tried;
                }
                part *= 0.5;
                if part < 1e-6 {
                    return if left <= ROUNDED {
                        Ok(solved)
                    } else {
                        Err(NoAcceleration::NoConvergence)
                    };
                }
            }
        }
        if left <= ROUNDED {
            Ok(solved)
        } else {
            Err(NoAcceleration::NoConvergence)
        }
    }

    /// All quantities for given accelerations.
    fn at(&self, stage: &Stage<'_>, k: Vec<Twist>) -> Result<Solved, NoAcceleration> {
        let gh = stage.gh;
        let twists: Vec<Twist> = stage.twists.iter().zip(&k).map(|(w, k)| *w + gh * *k).collect();
        let mut places = Vec::with_capacity(k.len());
        let mut yaw = 0.0;
        for (place, twist) in stage.places.iter().zip(&twists) {
            let rate = DVec2::from_angle(-yaw).rotate(twist.truncate());
            let place = Place {
                shift: place.shift + gh * rate,
                yaw: place.yaw + gh * twist.z,
            };
            yaw += place.yaw;
            places.push(place);
        }
        let motion = self.motion(&places, &twists);
        let load = self.load(&motion, &k, stage.shaking);
        let mut pressures = Vec::with_capacity(k.len());
        for (i, slide) in stage.slides.iter().enumerate() {
            pressures.push(match slide {
                Slide::Stuck => None,
                _ => Some(self.pressure(i, &motion, &load, stage.shaking)?),
            });
        }
        Ok(Solved {
            k,
            twists,
            motion,
            load,
            pressures,
        })
    }

    pub(super) fn pressure(
        &self,
        joint: usize,
        motion: &Motion,
        load: &Load,
        shaking: Shaking,
    ) -> Result<Pressure, NoAcceleration> {
        let total = self.stones[joint].carried * shaking.weight;
        Pressure::of(&motion.beds[joint], total, load.resultant[joint]).ok_or(NoAcceleration::Rocks(joint))
    }

    /// Friction of the sliding joints, and the difference to their load.
    fn rows(&self, stage: &Stage<'_>, solved: &Solved, free: &[usize]) -> Vec<(Wrench, Friction)> {
        let row = |&i: &usize| {
            let (u, mu) = match stage.slides[i] {
                Slide::LetsGo { mu } => (solved.k[i], mu),
                _ => (solved.twists[i], self.stones[i].friction_kinetic),
            };
            let pressure = solved.pressures[i].as_ref();
            let friction = pressure.map_or(
                Friction {
                    wrench: DVec3::ZERO,
                    stiff: DMat3::ZERO,
                    with_resultant: [DVec3::ZERO; 2],
                },
                |pressure| pressure.friction(mu, u, stage.smooth),
            );
            (solved.load.wrench[i] - friction.wrench, friction)
        };
        free.iter().map(row).collect()
    }

    /// Largest residual, over the weight and the weight times the size of the bed.
    fn size(&self, rows: &[(Wrench, Friction)], free: &[usize], weight: f64) -> f64 {
        let of = |((residual, _), &i): (&(Wrench, Friction), &usize)| {
            let stone = &self.stones[i];
            let force = stone.carried * weight;
            (residual.truncate().length() / force).max(residual.z.abs() / (force * stone.bed_size))
        };
        rows.iter().zip(free).map(of).fold(0.0, f64::max)
    }

    /// Newton step: the load is linear in k; friction rotates with the velocity and increases with the pressure.
    fn newton(
        &self,
        stage: &Stage<'_>,
        solved: &Solved,
        rows: &[(Wrench, Friction)],
        free: &[usize],
    ) -> Option<Vec<Twist>> {
        let n = free.len();
        let mut matrix = Matrix::zeros(3 * n, 3 * n);
        for (column, &j) in free.iter().enumerate() {
            for c in 0..3 {
                let mut k = solved.k.clone();
                k[j][c] += 1.0;
                let load = self.load(&solved.motion, &k, stage.shaking);
                let gain = match stage.slides[j] {
                    Slide::LetsGo { .. } => 1.0,
                    _ => stage.gh,
                };
                for (row, (&i, (_, friction))) in free.iter().zip(rows).enumerate() {
                    let shift = load.resultant[i] - solved.load.resultant[i];
                    let mut change = load.wrench[i]
                        - solved.load.wrench[i]
                        - shift.x * friction.with_resultant[0]
                        - shift.y * friction.with_resultant[1];
                    if i == j {
                        change += gain * friction.stiff.col(c);
                    }
                    for r in 0..3 {
                        matrix[(3 * row + r, 3 * column + c)] = change[r];
                    }
                }
            }
        }
        let right: Vec<f64> = rows
            .iter()
            .flat_map(|(residual, _)| residual.to_array())
            .collect();
        // columns of almost stuck joints are larger by orders of magnitude
        let scale: Vec<f64> = (0..3 * n)
            .map(|column| {
                1.0 / matrix
                    .column(column)
                    .iter()
                    .fold(0.0, |most: f64, x| most.max(x.abs()))
            })
            .collect();
        for (column, scale) in scale.iter().enumerate() {
            matrix.column_mut(column).iter_mut().for_each(|x| *x *= scale);
        }
        let step = solve(&matrix, &Matrix::from_column(&right)).ok()?;
        let step: Vec<f64> = step
            .column(0)
            .iter()
            .zip(&scale)
            .map(|(x, scale)| x * scale)
            .collect();
        step.iter()
            .all(|x| x.is_finite())
            .then(|| step.chunks(3).map(|c| DVec3::new(c[0], c[1], c[2])).collect())
    }
}
