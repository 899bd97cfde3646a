//! Resultant drifts of a frame from the drifts in its two directions.

use super::frame_history::FrameHistory;

/// Number of points between two samples at which the resultant is evaluated. Our choice.
const PLACES: usize = 8;

/// The largest resultant of a storey's drift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameResultant {
    /// Magnitude, m.
    pub drift_m: f64,
    /// Time, s.
    pub at_s: f64,
    /// Components in the two directions, m.
    pub parts_m: [f64; 2],
}

/// The largest resultant drift of each storey over the common samples of both directions, lowest storey first.
///
/// ```text
/// r(t) = √(δ_1² + δ_2²)
/// ```
/// Between samples, δ is the cubic through its values and rates. Its error is (ω Δt)⁴/384 of an oscillation: 1e-5 for a step of a tenth of the
/// period. The result is never below the peak of either direction alone, which is located between samples.
pub fn resultant_drifts(histories: [&FrameHistory; 2]) -> Vec<FrameResultant> {
    let storeys = 0..histories[0].drift_peaks.len().min(histories[1].drift_peaks.len());
    storeys.map(|storey| of_storey(histories, storey)).collect()
}

fn of_storey(histories: [&FrameHistory; 2], storey: usize) -> FrameResultant {
    let drifts = histories.map(|of| of.drift_m(storey));
    let rates = histories.map(|of| of.drift_speed_m_s(storey));
    let times = &histories[0].time_s;
    let samples = times.len().min(histories[1].time_s.len());
    let between = |i: usize, x: f64| {
        let h = times[i + 1] - times[i];
        [0, 1].map(|d| {
            let ends = [drifts[d][i], drifts[d][i + 1]];
            cubic(ends, [rates[d][i] * h, rates[d][i + 1] * h], x)
        })
    };
    let mut most = FrameResultant::default();
    let mut consider = |at_s: f64, parts_m: [f64; 2]| {
        let drift_m = parts_m[0].hypot(parts_m[1]);
        if drift_m > most.drift_m || drift_m.is_nan() {
            most = FrameResultant {
                drift_m,
                at_s,
                parts_m,
            };
        }
    };
    for i in 0..samples {
        consider(times[i], [drifts[0][i], drifts[1][i]]);
        for place in 1..PLACES {
            if i + 1 < samples {
                let x = place as f64 / PLACES as f64;
                consider(times[i] + x * (times[i + 1] - times[i]), between(i, x));
            }
        }
    }
    // the exact peaks of each direction, combined with the drift of the other direction at that time
    for (d, history) in histories.iter().enumerate() {
        let peak = history.drift_peaks[storey];
        let before = times[..samples]
            .partition_point(|t| *t <= peak.at_s)
            .saturating_sub(1);
        let mut parts_m = match before + 1 < samples {
            true => {
                let h = times[before + 1] - times[before];
                between(before, ((peak.at_s - times[before]) / h).clamp(0.0, 1.0))
            }
            false => [0.0; 2],
        };
        parts_m[d] = peak.value_m;
        consider(peak.at_s, parts_m);
    }
    most
}

/// Cubic with the given values and rates at 0 and 1, evaluated at x.
fn cubic([a, b]: [f64; 2], [da, db]: [f64; 2], x: f64) -> f64 {
    let y = 1.0 - x;
    y * y * (a * (1.0 + 2.0 * x) + da * x) + x * x * (b * (1.0 + 2.0 * y) - db * y)
}
