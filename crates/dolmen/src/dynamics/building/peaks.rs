//! Largest values of a run, between its steps.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r | `row` | a value as a row of the state: r s |
//! | p, v, w | | value, rate and second rate at a step: r s, r A s + r B a, r A² s + r A B a + r B a′ |

use super::history::{BuildingPeaks, FloorPeak, Ground, Peak, StoreyPeak};
use super::looking::{LOOKED_AT, Looker, Reach, look, reaches};
use super::stepping::{Stepping, states_at};
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;

/// What is looked at in a run.
pub(super) struct Watcher {
    floors: usize,
    reaches: Vec<Reach>,
    base_rows: [Vec<f64>; 3],
    /// Rows of the points over the coordinates.
    watched: Vec<Vec<f64>>,
    /// O, then the absolute accelerations of the points, then the rates of the strokes, turned: states × rows.
    pub(super) outputs: Matrix,
    own: usize,
}

/// Histories that are kept, from rest on.
pub(super) struct Kept {
    /// u, v, θ of each floor, then strokes: a column for each step.
    pub(super) coordinates: Matrix,
    /// Base shear and torque: a column for each step.
    pub(super) base: Matrix,
    /// Displacement of each point.
    pub(super) moved: Vec<Vec<f64>>,
    /// Absolute acceleration of each point.
    pub(super) felt: Vec<Vec<f64>>,
}

impl Kept {
    pub(super) fn new(coordinates: usize, points: usize, steps: usize) -> Self {
        let at_rest = || {
            let mut values = Vec::with_capacity(steps + 1);
            values.push(0.0);
            values
        };
        Kept {
            coordinates: Matrix::zeros(coordinates, steps + 1),
            base: Matrix::zeros(3, steps + 1),
            moved: (0..points).map(|_| at_rest()).collect(),
            felt: (0..points).map(|_| at_rest()).collect(),
        }
    }

    /// Nothing.
    pub(super) fn none(coordinates: usize, points: usize) -> Self {
        Kept {
            coordinates: Matrix::zeros(coordinates, 0),
            base: Matrix::zeros(3, 0),
            moved: vec![Vec::new(); points],
            felt: vec![Vec::new(); points],
        }
    }
}

/// Largest values of the building, and of each point: displacement and absolute acceleration.
pub(super) struct Found {
    pub(super) building: BuildingPeaks,
    pub(super) watched: Vec<[Peak; 2]>,
}

impl Watcher {
    pub(super) fn new(building: &VibratingBuilding, stepping: &impl Stepping, watched: &[Vec<f64>]) -> Self {
        let own = stepping.outputs();
        let (states, coordinates) = (own.columns(), building.building().coordinates());
        let mut others: Vec<Vec<f64>> = watched
            .iter()
            .map(|row| {
                // the ground itself is what r A B a brings, with its sign turned
                let displacement: Vec<f64> = (0..states)
                    .map(|k| row.iter().zip(own.column(k)).map(|(r, o)| r * o).sum())
                    .collect();
                stepping.rate_row(&stepping.rate_row(&displacement))
            })
            .collect();
        others.extend((coordinates..own.rows()).map(|i| {
            // a displacement: the ground adds nothing to its rate at once
            let stroke: Vec<f64> = (0..states).map(|k| own[(i, k)]).collect();
            stepping.rate_row(&stroke)
        }));
        let outputs = Matrix::from_fn(states, own.rows() + others.len(), |k, i| {
            match i.checked_sub(own.rows()) {
                None => own[(i, k)],
                Some(other) => others[other][k],
            }
        });
        Watcher {
            floors: building.building().floors().len(),
            reaches: reaches(building),
            base_rows: building.building().base_rows(),
            watched: watched.to_vec(),
            own: own.rows(),
            outputs,
        }
    }

    /// ιᵀ K q of one column of coordinates: only the lowest storey's walls hold to the ground.
    fn base_of(&self, column: &[f64], base: &mut [f64]) {
        for (sum, row) in base.iter_mut().zip(&self.base_rows) {
            *sum = row[0] * column[0] + row[1] * column[1] + row[2] * column[2];
        }
    }

    /// Strokes in the outputs.
    fn masses(&self) -> usize {
        self.own - 3 * self.floors
    }

    /// How many values are looked at besides those of the storeys.
    pub(super) fn others(&self) -> usize {
        2 * self.masses() + 3 + 2 * self.watched.len()
    }

    pub(super) fn reaches(&self) -> &[Reach] {
        &self.reaches
    }

    /// A block of `now` steps from `first` on, a column a row of the outputs: largest values, and histories where they are kept.
    pub(super) fn see(
        &self,
        block: &Matrix,
        (first, now): (usize, usize),
        looker: &mut Looker<'_>,
        kept: Option<&mut Kept>,
    ) {
        let (masses, points) = (self.masses(), self.watched.len());
        looker.storeys(block, (first, now));
        for k in 0..masses {
            looker.other(k, &block.column(3 * self.floors + k)[..now], first);
        }
        let sum = |row: &[f64]| -> Vec<f64> {
            let mut sum = vec![0.0; now];
            for (i, factor) in row.iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
                for (sum, x) in sum.iter_mut().zip(block.column(i)) {
                    *sum += factor * x;
                }
            }
            sum
        };
        let base = self.base_rows.each_ref().map(|row| sum(&row[..3]));
        for (axis, values) in base.iter().enumerate() {
            looker.other(masses + axis, values, first);
        }
        let moved: Vec<Vec<f64>> = self.watched.iter().map(|row| sum(row)).collect();
        for (i, values) in moved.iter().enumerate() {
            looker.other(masses + 3 + i, values, first);
        }
        for k in 0..points + masses {
            let felt = &block.column(self.own + k)[..now];
            looker.other(masses + 3 + points + k, felt, first);
        }
        let Some(kept) = kept else { return };
        for i in 0..now {
            let column = kept.coordinates.column_mut(first + i);
            for (k, to) in column.iter_mut().enumerate() {
                *to = block[(i, k)];
            }
            for (to, values) in kept.base.column_mut(first + i).iter_mut().zip(&base) {
                *to = values[i];
            }
        }
        for (i, values) in moved.into_iter().enumerate() {
            kept.moved[i].extend(values);
            kept.felt[i].extend(&block.column(self.own + i)[..now]);
        }
    }

    /// The top beside each of the largest values at steps.
    pub(super) fn peaks(
        &self,
        all: &[(f64, usize)],
        (steps, h): (usize, f64),
        states: &[Vec<f64>],
        stepping: &impl Stepping,
        ground: &dyn Fn(usize) -> Ground,
    ) -> Found {
        let (n, masses, points) = (self.floors, self.masses(), self.watched.len());
        let peaks = self.between(all, (steps, h), states, stepping, ground);
        let (storeys, rest) = peaks.split_at(LOOKED_AT * n);
        let (strokes, rest) = rest.split_at(masses);
        let (base, rest) = rest.split_at(3);
        let (moved, rest) = rest.split_at(points);
        let (felt, rates) = rest.split_at(points);
        let larger = |a: Peak, b: Peak| if b.value.abs() > a.value.abs() { b } else { a };
        let storeys = storeys.chunks_exact(LOOKED_AT);
        Found {
            watched: moved.iter().zip(felt).map(|(a, b)| [*a, *b]).collect(),
            building: BuildingPeaks {
                floors: storeys
                    .clone()
                    .map(|p| FloorPeak {
                        displacement_x_m: p[0],
                        displacement_y_m: p[1],
                        rotation_rad: p[2],
                    })
                    .collect(),
                storeys: storeys
                    .zip(&self.reaches)
                    .map(|(p, reach)| StoreyPeak {
                        drift_x_m: p[3],
                        drift_y_m: p[4],
                        twist_rad: p[5],
                        edge_drift_x_m: reach.is_known.then(|| larger(p[6], p[7])),
                        edge_drift_y_m: reach.is_known.then(|| larger(p[8], p[9])),
                    })
                    .collect(),
                strokes_m: strokes.to_vec(),
                stroke_rates_m_s: rates.to_vec(),
                base_shear_n: [base[0], base[1]],
                base_torque_n_m: base[2],
            },
        }
    }

    /// All values that are looked at, as rows of the state, in their order.
    fn rows(&self) -> Matrix {
        let (n, points) = (self.floors, self.watched.len());
        let masses = self.masses();
        let count = LOOKED_AT * n + self.others();
        let mut rows = Matrix::zeros(count, self.outputs.rows());
        for k in 0..self.outputs.rows() {
            let column: Vec<f64> = (0..self.outputs.columns())
                .map(|i| self.outputs[(k, i)])
                .collect();
            let into = rows.column_mut(k);
            look(&column[..3 * n], &self.reaches, &mut into[..LOOKED_AT * n]);
            let rest = &mut into[LOOKED_AT * n..];
            rest[..masses].copy_from_slice(&column[3 * n..self.own]);
            self.base_of(&column, &mut rest[masses..masses + 3]);
            for (i, row) in self.watched.iter().enumerate() {
                rest[masses + 3 + i] = row.iter().zip(&column).map(|(r, x)| r * x).sum();
                rest[masses + 3 + points + i] = column[self.own + i];
            }
            rest[masses + 3 + 2 * points..].copy_from_slice(&column[self.own + points..]);
        }
        rows
    }

    /// The tops beside the largest values at steps.
    fn between(
        &self,
        all: &[(f64, usize)],
        (steps, h): (usize, f64),
        states: &[Vec<f64>],
        stepping: &impl Stepping,
        ground: &dyn Fn(usize) -> Ground,
    ) -> Vec<Peak> {
        let mut wanted: Vec<usize> = all
            .iter()
            .filter(|(value, _)| *value != 0.0)
            .flat_map(|&(_, step)| step.saturating_sub(1)..=(step + 1).min(steps - 1))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        let found = states_at(stepping, states, &wanted, ground);
        let rows = self.rows();
        let mut row = vec![0.0; rows.columns()];
        let each = all.iter().enumerate().map(|(i, &(value, step))| {
            let there = Peak {
                value,
                at_s: step as f64 * h,
            };
            if value == 0.0 {
                return there;
            }
            for (k, entry) in row.iter_mut().enumerate() {
                *entry = rows[(i, k)];
            }
            let of = Rates::new(&row, stepping);
            let at = |step: usize| wanted.binary_search(&step).map(|i| &found[i][..]);
            let inside = |from: usize| -> Option<Peak> {
                let (a, b) = (at(from).ok()?, at(from + 1).ok()?);
                let g = ground(from);
                let ends = [of.at(a, g, 0, h), of.at(b, g, 1, h)];
                let (part, value) = top(ends)?;
                Some(Peak {
                    value,
                    at_s: (from as f64 + part) * h,
                })
            };
            let sides = [step.checked_sub(1), (step + 1 < steps).then_some(step)];
            let tops = sides.into_iter().flatten().filter_map(inside);
            tops.fold(there, |best, next| {
                if next.value.abs() > best.value.abs() {
                    next
                } else {
                    best
                }
            })
        });
        each.collect()
    }
}

/// A value, its rate and its second rate as rows of the state.
struct Rates<'a> {
    row: &'a [f64],
    first: Vec<f64>,
    second: Vec<f64>,
    ground: [[f64; 2]; 2],
}

impl<'a> Rates<'a> {
    fn new(row: &'a [f64], stepping: &impl Stepping) -> Self {
        let first = stepping.rate_row(row);
        Rates {
            row,
            ground: [stepping.ground_of_row(row), stepping.ground_of_row(&first)],
            second: stepping.rate_row(&first),
            first,
        }
    }

    /// Value, rate × h and second rate × h² at the beginning (0) or the end (1) of a step.
    fn at(&self, state: &[f64], ground: Ground, end: usize, h: f64) -> [f64; 3] {
        let dot = |row: &[f64]| -> f64 { row.iter().zip(state).map(|(r, s)| r * s).sum() };
        let [now, then] = &self.ground;
        let sum = |of: &dyn Fn(usize) -> f64| -> f64 { of(0) + of(1) };
        let rate = dot(&self.first) + sum(&|axis| now[axis] * ground[axis][end]);
        let change = |axis: usize| (ground[axis][1] - ground[axis][0]) / h;
        let bend = dot(&self.second) + sum(&|axis| then[axis] * ground[axis][end] + now[axis] * change(axis));
        [dot(self.row), rate * h, bend * h * h]
    }
}

/// The top within a step, from value, rate and bend at both ends (in steps): the part of the step and the value there; `None` if there
/// is none inside.
fn top([a, b]: [[f64; 3]; 2]) -> Option<(f64, f64)> {
    if a[1] * b[1] >= 0.0 {
        return None; // it goes on rising or falling
    }
    // the polynomial of the fifth degree, from its beginning
    let (rise, slopes) = (b[0] - a[0] - a[1] - 0.5 * a[2], b[1] - a[1] - a[2]);
    let bends = b[2] - a[2];
    let c = [
        a[0],
        a[1],
        0.5 * a[2],
        10.0 * rise - 4.0 * slopes + 0.5 * bends,
        -15.0 * rise + 7.0 * slopes - bends,
        6.0 * rise - 3.0 * slopes + 0.5 * bends,
    ];
    let value = |t: f64| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let slope = |t: f64| (1..6).rev().fold(0.0, |sum, i| sum * t + i as f64 * c[i]);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if slope(middle) * a[1] > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let at = 0.5 * (low + high);
    Some((at, value(at)))
}

/// Halvings of a step in which its top is sought: the value is flat there, so that 1e-8 of a step is round-off of it.
const HALVINGS: usize = 26;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_top_of_a_wave_between_two_steps() {
        // cos(0.6 (t − 0.3)), ten steps a period
        let at = |t: f64| {
            let x: f64 = 0.6 * (t - 0.3);
            [x.cos(), -0.6 * x.sin(), -0.36 * x.cos()]
        };
        let (part, value) = top([at(0.0), at(1.0)]).unwrap();
        assert!(
            (part - 0.3).abs() < 1e-5 && (value - 1.0).abs() < 2e-6,
            "{part} {value}"
        );
        // quintic: itself
        let of = |t: f64| [t - t.powi(5), 1.0 - 5.0 * t.powi(4), -20.0 * t.powi(3)];
        let (part, value) = top([of(0.0), of(1.0)]).unwrap();
        let expected = 0.2_f64.powf(0.25);
        assert!((part - expected).abs() < 1e-7 && (value - of(expected)[0]).abs() < 1e-15);
        assert!(top([of(0.0), of(0.5)]).is_none(), "it rises throughout");
    }
}
