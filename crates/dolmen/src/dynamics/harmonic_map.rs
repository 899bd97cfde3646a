//! Steady response to harmonic ground motion, measured in a time history; shared by the maps of frames and of chains.

use super::TimeFunction;

/// Number of cycles, of the ground and of the slowest mode, before the measurement; number of measured cycles of the ground. Our choice: at a damping
/// ratio of 2 % the transient has then decayed to 1/150, with friction sooner. `steady` reports whether a transient remains.
const CYCLES_BEFORE: f64 = 40.0;
const CYCLES_READ: f64 = 5.0;
/// Largest number of cycles of the ground before the measurement, which limits memory and time. Our choice.
const CYCLES_MOST: f64 = 2000.0;
/// Number of samples per cycle of the ground.
const SAMPLES_A_CYCLE: f64 = 40.0;
/// Relative change of the peak between measured cycles above which a point is not steady. Our choice.
const STEADY_MOST: f64 = 0.01;

/// One point of a harmonic map of a frame (its parts are storeys) or of a chain (its parts are joints).
#[derive(Clone, Debug, PartialEq)]
pub struct HarmonicPoint {
    /// Frequency of the ground, Hz.
    pub frequency_hz: f64,
    /// Amplitude of its acceleration, m/s².
    pub ground_acceleration_m_s2: f64,
    /// Largest drift of each storey, m, or largest rotation of each joint, rad, over the measured cycles. If the run ended early: over the whole run.
    pub deformation: Vec<f64>,
    /// Fraction of the measured cycles in which the slider of each storey slips, or each joint is open or turns against its friction, –. If the run
    /// ended early: fraction of the whole run.
    pub moving_share: Vec<f64>,
    /// Whether the response is steady: the peaks of the measured cycles agree within 1 %.
    pub steady: bool,
    /// Whether a storey leaned beyond the range of the model, or a link fell.
    pub fell: bool,
}

/// The measured part of a harmonic run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    frequency_hz: f64,
    amplitude_m_s2: f64,
    pub(super) step_s: f64,
    first: usize,
    from_s: f64,
    pub(super) to_s: f64,
    finished: bool,
}

/// Response of one part (storey or joint) at one point of the map.
pub(super) struct PartAtPoint {
    /// Largest deformation, m or rad.
    most: f64,
    /// Fraction of the time in which the part moves, –.
    share: f64,
    is_steady: bool,
}

/// A harmonic ground motion and its measurement window. The run first has the required number of cycles of the ground and of the slowest mode,
/// rounded up to whole cycles of the ground; the measured cycles follow.
pub(super) fn harmonic_ground(
    frequency_hz: f64,
    amplitude_m_s2: f64,
    slowest_hz: f64,
) -> (TimeFunction, Window) {
    let before = if slowest_hz > 0.0 {
        (CYCLES_BEFORE * frequency_hz / slowest_hz)
            .min(CYCLES_MOST)
            .ceil()
    } else {
        CYCLES_BEFORE
    };
    let ground = TimeFunction::Harmonic {
        amplitude: amplitude_m_s2,
        frequency_hz,
        phase_rad: 0.0,
    };
    let window = Window {
        frequency_hz,
        amplitude_m_s2,
        step_s: 1.0 / (frequency_hz * SAMPLES_A_CYCLE),
        first: (before * SAMPLES_A_CYCLE) as usize,
        from_s: before / frequency_hz,
        to_s: (before + CYCLES_READ) / frequency_hz,
        finished: true,
    };
    (ground, window)
}

impl Window {
    /// The measurement window of a run; the whole run if it ended early.
    pub(super) fn of_run(self, finished: bool, ended_s: f64) -> Self {
        if finished {
            return self;
        }
        Window {
            from_s: 0.0,
            to_s: ended_s,
            finished: false,
            ..self
        }
    }

    /// Measures one part, from its deformation and rate at the samples, its largest deformation of the whole run, and the intervals in which it
    /// moves, which may overlap.
    pub(super) fn part(
        &self,
        (values, rates): (&[f64], &[f64]),
        most: f64,
        moving_s: &[[f64; 2]],
    ) -> PartAtPoint {
        let share = self.share(moving_s);
        let cycle = SAMPLES_A_CYCLE as usize;
        let last = self.first + CYCLES_READ as usize * cycle;
        if !self.finished || values.len() <= last {
            return PartAtPoint {
                most,
                share,
                is_steady: self.finished,
            };
        }
        let peak_of = |from: usize| {
            (from..from + cycle).fold(0.0_f64, |most, j| {
                let way = [rates[j] * self.step_s, rates[j + 1] * self.step_s];
                most.max(largest_of_cubic([values[j], values[j + 1]], way))
            })
        };
        let cycles = (0..CYCLES_READ as usize).map(|k| peak_of(self.first + k * cycle));
        let (least, most) = cycles.fold((f64::INFINITY, 0.0_f64), |(least, most), peak| {
            (least.min(peak), most.max(peak))
        });
        PartAtPoint {
            most,
            share,
            is_steady: most - least <= STEADY_MOST * most,
        }
    }

    /// Fraction of the window that the intervals cover.
    fn share(&self, times_s: &[[f64; 2]]) -> f64 {
        let mut times_s = times_s.to_vec();
        times_s.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut covered_s, mut until_s) = (0.0, self.from_s);
        for [from_s, to_s] in times_s {
            let (from_s, to_s) = (from_s.max(until_s), to_s.min(self.to_s));
            if to_s > from_s {
                covered_s += to_s - from_s;
                until_s = to_s;
            }
        }
        covered_s / (self.to_s - self.from_s)
    }

    /// The point of the map with these parts.
    pub(super) fn point(&self, parts: Vec<PartAtPoint>) -> HarmonicPoint {
        HarmonicPoint {
            frequency_hz: self.frequency_hz,
            ground_acceleration_m_s2: self.amplitude_m_s2,
            deformation: parts.iter().map(|part| part.most).collect(),
            moving_share: parts.iter().map(|part| part.share).collect(),
            steady: self.finished && parts.iter().all(|part| part.is_steady),
            fell: !self.finished,
        }
    }
}

/// Largest absolute value between two samples, from the cubic through their values and slopes (slopes times the interval). For a sine with 40 samples
/// per cycle the error is 2e-6; the samples alone miss up to 3e-3.
fn largest_of_cubic(values: [f64; 2], slopes: [f64; 2]) -> f64 {
    let ends = values[0].abs().max(values[1].abs());
    if slopes[0] * slopes[1] >= 0.0 {
        return ends;
    }
    // y = y0 + d0 s + b s² + c s³; the slope d0 + 2 b s + 3 c s² has one zero in 0 … 1
    let rise = values[1] - values[0];
    let b = 3.0 * rise - 2.0 * slopes[0] - slopes[1];
    let c = slopes[0] + slopes[1] - 2.0 * rise;
    let q = -(b + (b * b - 3.0 * c * slopes[0]).max(0.0).sqrt().copysign(b));
    let turns = [slopes[0] / q, q / (3.0 * c)];
    turns
        .into_iter()
        .filter(|s| (0.0..=1.0).contains(s))
        .map(|s| (values[0] + s * (slopes[0] + s * (b + s * c))).abs())
        .fold(ends, f64::max)
}
