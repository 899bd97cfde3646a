//! Collects histories of a building in the wind: peaks and variance of each row.

use super::wind_history_answer::InTime;
use super::wind_rows::{WindRows, largest};
use dolmen::damper::{GustHistory, GustMotion, GustPeak, GustRow};
use std::ops::Range;

/// The rows of a history by quantity; the worst of several rows is used.
pub(super) struct RequestedRows {
    pub(super) rows: Vec<GustRow>,
    pub(super) top_displacement: Range<usize>,
    pub(super) drifts: Vec<Range<usize>>,
    pub(super) top_acceleration: Range<usize>,
    pub(super) corner: Range<usize>,
    pub(super) base_shear: Range<usize>,
    pub(super) base_torque: Range<usize>,
}

impl RequestedRows {
    pub(super) fn of(mut of: WindRows) -> Self {
        let mut rows = Vec::new();
        let mut put = |own: Vec<GustRow>| {
            let first = rows.len();
            rows.extend(own);
            first..rows.len()
        };
        let drifts = of.floors.iter_mut().map(|floor| std::mem::take(&mut floor.drift));
        let drifts: Vec<Range<usize>> = drifts.map(&mut put).collect();
        let (mut displacement, mut acceleration, mut corner) = (Vec::new(), Vec::new(), Vec::new());
        if let Some(top) = of.floors.pop() {
            displacement.push(top.displacement);
            acceleration.push(top.acceleration);
            corner = top.corner;
        }
        RequestedRows {
            drifts,
            top_displacement: put(displacement),
            top_acceleration: put(acceleration),
            corner: put(corner),
            base_shear: put(vec![of.base_shear]),
            base_torque: put(of.base_torque),
            rows,
        }
    }
}

/// One row over all histories so far.
struct RowSeen {
    mean_square: GustPeak,
    peaks: Vec<f64>,
    squares: f64,
    samples: usize,
    first: Vec<f64>,
}

impl RowSeen {
    fn new(mean_square: GustPeak) -> Self {
        RowSeen {
            mean_square,
            peaks: Vec::new(),
            squares: 0.0,
            samples: 0,
            first: Vec::new(),
        }
    }

    fn see(&mut self, values: Vec<f64>) {
        let about = |x: &f64| (x - self.mean_square.mean).powi(2);
        self.squares += values.iter().map(about).sum::<f64>();
        self.samples += values.len();
        self.peaks
            .push(values.iter().fold(0.0, |most: f64, x| most.max(x.abs())));
        if self.peaks.len() == 1 {
            self.first = values;
        }
    }

    fn peak(&self) -> f64 {
        self.peaks.iter().sum()
    }
}

/// All rows and strokes.
pub(super) struct WindOutputs {
    rows: Vec<RowSeen>,
    /// For each stroke, each case.
    strokes: Vec<Vec<RowSeen>>,
}

impl WindOutputs {
    /// State before the first history; `all` is the motion by the mean square in each case.
    pub(super) fn new(rows: &[GustRow], all: &[GustMotion]) -> Self {
        let strokes = all.first().map_or(0, |of| of.strokes.len());
        let stroke = |k: usize| all.iter().map(|of| RowSeen::new(of.strokes[k])).collect();
        WindOutputs {
            rows: rows
                .iter()
                .map(|row| RowSeen::new(all[row.case].of(row)))
                .collect(),
            strokes: (0..strokes).map(stroke).collect(),
        }
    }

    /// Adds one history.
    pub(super) fn see(&mut self, history: GustHistory) {
        for (row, values) in self.rows.iter_mut().zip(history.values) {
            row.see(values);
        }
        for (case, strokes) in history.strokes.into_iter().enumerate() {
            for (all, values) in self.strokes.iter_mut().zip(strokes) {
                all[case].see(values);
            }
        }
    }

    /// The worst of some rows.
    pub(super) fn rows(&self, rows: Range<usize>) -> InTime {
        worst(&self.rows[rows])
    }

    /// The worst case of a stroke.
    pub(super) fn stroke(&self, stroke: usize) -> InTime {
        worst(&self.strokes[stroke])
    }
}

/// The row with the largest mean peak over the histories, with the largest by the mean square.
fn worst(all: &[RowSeen]) -> InTime {
    let found = all.iter().max_by(|a, b| a.peak().total_cmp(&b.peak()));
    InTime {
        mean_square: largest(all.iter().map(|of| of.mean_square)),
        mean: found.map_or(0.0, |of| of.mean_square.mean),
        rms: found.map_or(0.0, |of| (of.squares / of.samples.max(1) as f64).sqrt()),
        peaks: found.map_or(Vec::new(), |of| of.peaks.clone()),
        first: found.map_or(Vec::new(), |of| of.first.clone()),
    }
}
