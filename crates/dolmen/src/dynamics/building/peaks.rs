//! Outputs of a run as rows of its state, and their largest values.

use super::between_steps::BetweenSteps;
use super::building_peaks::{BuildingPeaks, FloorPeak, Peak, ResultantDrift, StoreyPeak};
use super::peak_tracking::{FloorExtent, LongestDrift, PeakTracker, TRACKED, factors, floor_extents};
use super::stepping::{Ground, Stepping};
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;

/// A corner whose squared drift at steps is below this fraction of the largest cannot be the farthest between them: for ten steps a period a
/// peak is at most 1/cos²(π/10) of the value at a step. Our choice.
const NEAR_LONGEST: f64 = 0.8;

/// The outputs of a run.
pub(super) struct Watcher {
    floors: usize,
    centres_m: Vec<[f64; 2]>,
    floor_extents: Vec<FloorExtent>,
    /// ιᵀ K: only the walls of the lowest storey transfer force to the ground.
    base_rows: [Vec<f64>; 3],
    /// Rows of the points over the coordinates.
    watched: Vec<Vec<f64>>,
    /// O, then the absolute accelerations of the points, then the rates of the strokes, transposed: states × rows.
    pub(super) outputs: Matrix,
    own: usize,
}

/// Requested histories, from rest on.
pub(super) struct RequestedHistories {
    /// u, v, θ of each floor, then strokes: a column for each step.
    pub(super) coordinates: Matrix,
    /// Base shear and torque: a column for each step.
    pub(super) base: Matrix,
    /// Displacement of each point.
    pub(super) moved: Vec<Vec<f64>>,
    /// Absolute acceleration of each point.
    pub(super) felt: Vec<Vec<f64>>,
}

impl RequestedHistories {
    pub(super) fn new(coordinates: usize, points: usize, steps: usize) -> Self {
        let at_rest = || {
            let mut values = Vec::with_capacity(steps + 1);
            values.push(0.0);
            values
        };
        RequestedHistories {
            coordinates: Matrix::zeros(coordinates, steps + 1),
            base: Matrix::zeros(3, steps + 1),
            moved: (0..points).map(|_| at_rest()).collect(),
            felt: (0..points).map(|_| at_rest()).collect(),
        }
    }

    pub(super) fn none(coordinates: usize, points: usize) -> Self {
        RequestedHistories {
            coordinates: Matrix::zeros(coordinates, 0),
            base: Matrix::zeros(3, 0),
            moved: vec![Vec::new(); points],
            felt: vec![Vec::new(); points],
        }
    }
}

/// Largest values of the building, and of each point: displacement and absolute acceleration.
pub(super) struct LargestValues {
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
                // the contribution of the ground is that of r A B a, with the sign reversed
                let displacement: Vec<f64> = (0..states)
                    .map(|k| row.iter().zip(own.column(k)).map(|(r, o)| r * o).sum())
                    .collect();
                stepping.rate_row(&stepping.rate_row(&displacement))
            })
            .collect();
        others.extend((coordinates..own.rows()).map(|i| {
            // a displacement: the ground has no direct effect on its rate
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
            centres_m: building
                .building()
                .floors()
                .iter()
                .map(|floor| floor.centre_m)
                .collect(),
            floor_extents: floor_extents(building),
            base_rows: building.building().base_rows(),
            watched: watched.to_vec(),
            own: own.rows(),
            outputs,
        }
    }

    /// Strokes in the outputs.
    fn masses(&self) -> usize {
        self.own - 3 * self.floors
    }

    /// Number of values in addition to those of the storeys.
    pub(super) fn others(&self) -> usize {
        2 * self.masses() + 3 + 2 * self.watched.len()
    }

    pub(super) fn floor_extents(&self) -> &[FloorExtent] {
        &self.floor_extents
    }

    /// Processes a block of `now` steps from `first` on, one column for each row of the outputs: largest values, and histories if requested.
    pub(super) fn see(
        &self,
        block: &Matrix,
        (first, now): (usize, usize),
        tracker: &mut PeakTracker<'_>,
        kept: Option<&mut RequestedHistories>,
    ) {
        let (masses, points) = (self.masses(), self.watched.len());
        tracker.storeys(block, (first, now));
        for k in 0..masses {
            tracker.other(k, &block.column(3 * self.floors + k)[..now], first);
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
            tracker.other(masses + axis, values, first);
        }
        let moved: Vec<Vec<f64>> = self.watched.iter().map(|row| sum(row)).collect();
        for (i, values) in moved.iter().enumerate() {
            tracker.other(masses + 3 + i, values, first);
        }
        for k in 0..points + masses {
            let felt = &block.column(self.own + k)[..now];
            tracker.other(masses + 3 + points + k, felt, first);
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

    /// Interpolated peaks next to the largest values at steps, and next to the longest drifts.
    pub(super) fn peaks(
        &self,
        (all, longest): (&[(f64, usize)], &[Vec<LongestDrift>]),
        (steps, h): (usize, f64),
        states: &[Vec<f64>],
        stepping: &impl Stepping,
        ground: &dyn Fn(usize) -> Ground,
    ) -> LargestValues {
        let (n, masses, points) = (self.floors, self.masses(), self.watched.len());
        let moved = all
            .iter()
            .filter(|(value, _)| *value != 0.0)
            .map(|(_, step)| *step);
        let around = moved.chain(longest.iter().flatten().map(|longest| longest.step));
        let between = BetweenSteps::new(stepping, (steps, h), ground, states, around);
        let mut row = vec![0.0; self.outputs.rows()];
        let each = all.iter().enumerate().map(|(which, &found)| {
            self.row(which, &mut row);
            between.top(&row, found)
        });
        let peaks: Vec<Peak> = each.collect();
        let each = longest.iter().enumerate();
        let resultants: Vec<ResultantDrift> = each
            .map(|(storey, longest)| self.resultant(storey, longest, &between))
            .collect();
        let (storeys, rest) = peaks.split_at(TRACKED * n);
        let (strokes, rest) = rest.split_at(masses);
        let (base, rest) = rest.split_at(3);
        let (moved, rest) = rest.split_at(points);
        let (felt, rates) = rest.split_at(points);
        let larger = |a: Peak, b: Peak| if b.value.abs() > a.value.abs() { b } else { a };
        let storeys = storeys.chunks_exact(TRACKED);
        LargestValues {
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
                    .zip(&self.floor_extents)
                    .zip(resultants)
                    .map(|((p, reach), resultant)| StoreyPeak {
                        resultant,
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

    /// The longest drift of a storey, from those of its corners at steps.
    fn resultant(
        &self,
        storey: usize,
        corners: &[LongestDrift],
        between: &BetweenSteps<'_, impl Stepping>,
    ) -> ResultantDrift {
        let of = |value: usize| {
            let mut row = vec![0.0; self.outputs.rows()];
            self.row(TRACKED * storey + value, &mut row);
            row
        };
        let (drift_x, drift_y, twist) = (of(3), of(4), of(5));
        let turned = |drift: &[f64], arm: f64| -> Vec<f64> {
            drift.iter().zip(&twist).map(|(d, t)| d + arm * t).collect()
        };
        let most = corners.iter().map(LongestDrift::squared).fold(0.0, f64::max);
        let each = corners.iter().zip(&self.floor_extents[storey].corners);
        let near = each.filter(|(found, _)| found.squared() >= NEAR_LONGEST * most);
        let tops = near.map(|(found, from_centre)| {
            let (along_x, along_y) = (
                turned(&drift_x, -from_centre[1]),
                turned(&drift_y, from_centre[0]),
            );
            let ([x, y], at_s) = between.longest([&along_x, &along_y], (found.drift, found.step));
            ResultantDrift {
                size_m: x.hypot(y),
                at_s,
                place_m: [0, 1].map(|axis| self.centres_m[storey][axis] + from_centre[axis]),
                direction_degrees: y.atan2(x).to_degrees(),
            }
        });
        let longer = |a: ResultantDrift, b: ResultantDrift| if b.size_m > a.size_m { b } else { a };
        tops.reduce(longer).unwrap_or_default()
    }

    /// The `which`-th output as a row of the state: a sum of rows of the outputs.
    fn row(&self, which: usize, row: &mut [f64]) {
        let (n, masses, points) = (self.floors, self.masses(), self.watched.len());
        row.fill(0.0);
        let mut add = |output: usize, factor: f64| {
            if factor != 0.0 {
                for (entry, value) in row.iter_mut().zip(self.outputs.column(output)) {
                    *entry += factor * value;
                }
            }
        };
        let (storey, value) = (which / TRACKED, which % TRACKED);
        if storey < n {
            let [own, below] = factors(value, &self.floor_extents[storey]);
            for k in 0..3 {
                add(3 * storey + k, own[k]);
                if storey > 0 {
                    add(3 * (storey - 1) + k, below[k]);
                }
            }
            return;
        }
        let other = which - TRACKED * n;
        let base = other.wrapping_sub(masses);
        let point = base.wrapping_sub(3);
        if other < masses {
            add(3 * n + other, 1.0);
        } else if base < 3 {
            for (k, factor) in self.base_rows[base][..3].iter().enumerate() {
                add(k, *factor);
            }
        } else if point < points {
            for (k, factor) in self.watched[point].iter().enumerate() {
                add(k, *factor);
            }
        } else {
            add(self.own + point - points, 1.0);
        }
    }
}
