//! Largest values of a run, between its steps.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r | `row` | a value as a row of the state: r s |
//! | p, v, w | | value, rate and second rate at a step: r s, r A s + r B a, r A² s + r A B a + r B a′ |

use super::history::{BuildingPeaks, FloorPeak, Ground, Peak, StoreyPeak};
use super::stepping::{BLOCK, Stepping, states_at};
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;

/// What is looked at in a run.
pub(super) struct Watcher {
    floors: usize,
    reaches: Vec<Reach>,
    base_rows: [Vec<f64>; 3],
    /// Rows of the points over the coordinates.
    watched: Vec<Vec<f64>>,
    /// O, then the absolute accelerations of the points.
    pub(super) outputs: Matrix,
    own: usize,
}

/// Largest values of the building, and of each point: displacement and absolute acceleration.
pub(super) struct Found {
    pub(super) building: BuildingPeaks,
    pub(super) watched: Vec<[Peak; 2]>,
}

impl Watcher {
    pub(super) fn new(building: &VibratingBuilding, stepping: &impl Stepping, watched: &[Vec<f64>]) -> Self {
        let own = stepping.outputs();
        let states = own.columns();
        let accelerations: Vec<Vec<f64>> = watched
            .iter()
            .map(|row| {
                // the ground itself is what r A B a brings, with its sign turned
                let displacement: Vec<f64> = (0..states)
                    .map(|k| row.iter().zip(own.column(k)).map(|(r, o)| r * o).sum())
                    .collect();
                stepping.rate_row(&stepping.rate_row(&displacement))
            })
            .collect();
        let outputs = match accelerations.is_empty() {
            true => own.clone(),
            false => Matrix::from_fn(own.rows() + accelerations.len(), states, |i, k| {
                match i.checked_sub(own.rows()) {
                    None => own[(i, k)],
                    Some(point) => accelerations[point][k],
                }
            }),
        };
        Watcher {
            floors: building.building().floors().len(),
            reaches: reaches(building),
            base_rows: building.building().base_rows(),
            watched: watched.to_vec(),
            own: own.rows(),
            outputs,
        }
    }

    /// ιᵀ K q at each step: only the lowest storey's walls hold to the ground.
    pub(super) fn base(&self, coordinates: &Matrix) -> Matrix {
        let mut base = Matrix::zeros(3, coordinates.columns());
        let columns = coordinates.as_slice().chunks_exact(coordinates.rows());
        for (step, column) in columns.enumerate() {
            self.base_of(column, base.column_mut(step));
        }
        base
    }

    fn base_of(&self, column: &[f64], base: &mut [f64]) {
        for (sum, row) in base.iter_mut().zip(&self.base_rows) {
            *sum = row[0] * column[0] + row[1] * column[1] + row[2] * column[2];
        }
    }

    /// Where each value is largest at a step, and the top beside it.
    pub(super) fn peaks(
        &self,
        (coordinates, base, watched): (&Matrix, &Matrix, [&[Vec<f64>]; 2]),
        h: f64,
        states: &[Vec<f64>],
        stepping: &impl Stepping,
        ground: &dyn Fn(usize) -> Ground,
    ) -> Found {
        let (n, steps) = (self.floors, coordinates.columns());
        let mut all = largest(LOOKED_AT * n, steps, |step, values| {
            look(&coordinates.column(step)[..3 * n], &self.reaches, values);
        });
        let masses = self.own - 3 * n;
        all.extend(largest(masses, steps, |step, values| {
            values.copy_from_slice(&coordinates.column(step)[3 * n..]);
        }));
        all.extend(largest(3, steps, |step, values| {
            values.copy_from_slice(base.column(step))
        }));
        let points = self.watched.len();
        for histories in watched {
            all.extend(histories.iter().map(|history| {
                let each = history.iter().copied().enumerate();
                each.fold((0.0_f64, 0), |most, (step, value)| {
                    if value.abs() > most.0.abs() {
                        (value, step)
                    } else {
                        most
                    }
                })
            }));
        }
        let peaks = self.between(&all, (steps, h), states, stepping, ground);
        let (storeys, rest) = peaks.split_at(LOOKED_AT * n);
        let (strokes, rest) = rest.split_at(masses);
        let (base, rest) = rest.split_at(3);
        let (moved, felt) = rest.split_at(points);
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
                base_shear_n: [base[0], base[1]],
                base_torque_n_m: base[2],
            },
        }
    }

    /// All values that are looked at, as rows of the state, in their order.
    fn rows(&self) -> Matrix {
        let (n, points) = (self.floors, self.watched.len());
        let masses = self.own - 3 * n;
        let count = LOOKED_AT * n + masses + 3 + 2 * points;
        let mut rows = Matrix::zeros(count, self.outputs.columns());
        for k in 0..self.outputs.columns() {
            let column = self.outputs.column(k).to_vec();
            let into = rows.column_mut(k);
            look(&column[..3 * n], &self.reaches, &mut into[..LOOKED_AT * n]);
            let rest = &mut into[LOOKED_AT * n..];
            rest[..masses].copy_from_slice(&column[3 * n..self.own]);
            self.base_of(&column, &mut rest[masses..masses + 3]);
            for (i, row) in self.watched.iter().enumerate() {
                rest[masses + 3 + i] = row.iter().zip(&column).map(|(r, x)| r * x).sum();
                rest[masses + 3 + points + i] = column[self.own + i];
            }
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

/// Least and most y and x of a floor from its centre of mass.
struct Reach {
    is_known: bool,
    x: [f64; 2],
    y: [f64; 2],
    /// The centre of mass from that of the floor below.
    from_below: [f64; 2],
}

fn reaches(building: &VibratingBuilding) -> Vec<Reach> {
    let floors = building.building().floors();
    let each = floors.iter().enumerate().map(|(i, floor)| {
        let corners = floor
            .outline
            .as_ref()
            .map_or(&[][..], |outline| outline.corners_m());
        let extent = |axis: usize| {
            corners
                .iter()
                .map(|corner| corner[axis] - floor.centre_m[axis])
                .fold([0.0_f64; 2], |[least, most], from| {
                    [least.min(from), most.max(from)]
                })
        };
        let below = if i > 0 {
            floors[i - 1].centre_m
        } else {
            floor.centre_m
        };
        Reach {
            is_known: floor.outline.is_some(),
            x: extent(0),
            y: extent(1),
            from_below: [floor.centre_m[0] - below[0], floor.centre_m[1] - below[1]],
        }
    });
    each.collect()
}

/// Values that are looked at in each storey, in this order.
const LOOKED_AT: usize = 10;

/// Displacements, drifts of the centre, of the edges, and twists, storey after storey.
fn look(column: &[f64], reaches: &[Reach], values: &mut [f64]) {
    let mut below = [0.0; 3];
    let storeys = column
        .chunks_exact(3)
        .zip(reaches)
        .zip(values.chunks_exact_mut(LOOKED_AT));
    for ((own, reach), values) in storeys {
        let [u, v, theta] = [own[0], own[1], own[2]];
        let twist = theta - below[2];
        // the floor below at the centre of the floor above
        let drift_x = u - (below[0] - reach.from_below[1] * below[2]);
        let drift_y = v - (below[1] + reach.from_below[0] * below[2]);
        values.copy_from_slice(&[
            u,
            v,
            theta,
            drift_x,
            drift_y,
            twist,
            drift_x - reach.y[0] * twist,
            drift_x - reach.y[1] * twist,
            drift_y + reach.x[0] * twist,
            drift_y + reach.x[1] * twist,
        ]);
        below = [u, v, theta];
    }
}

/// The first largest of each of `count` values at each step: the largest of a block of steps, and only where it is more than before, when.
fn largest(count: usize, steps: usize, mut at: impl FnMut(usize, &mut [f64])) -> Vec<(f64, usize)> {
    if count == 0 {
        return Vec::new();
    }
    let mut values = vec![0.0; count * BLOCK];
    let mut found = vec![(0.0_f64, 0); count];
    let mut most = vec![0.0_f64; count];
    for first in (0..steps).step_by(BLOCK) {
        let block = BLOCK.min(steps - first);
        most.fill(0.0);
        for (step, values) in values.chunks_exact_mut(count).take(block).enumerate() {
            at(first + step, values);
            for (value, most) in values.iter().zip(&mut most) {
                let size = value.abs();
                *most = if size > *most { size } else { *most };
            }
        }
        for (i, (most, found)) in most.iter().zip(&mut found).enumerate() {
            if *most > found.0.abs() {
                let mut column = values.iter().skip(i).step_by(count).take(block);
                let step = column.position(|value| value.abs() == *most).unwrap_or(0);
                *found = (values[step * count + i], first + step);
            }
        }
    }
    found
}

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
