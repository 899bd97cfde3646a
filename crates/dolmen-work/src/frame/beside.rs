//! Compares a simulated frame with the measurement of a survey above the same ground.

use crate::motion::{MeasuredChannel, MotionAnswer};
use dolmen::dynamics::{FrameHistory, FrictionFrame};
use dolmen::signal::{Component, SeriesBeside, series_beside};

/// Largest height of a sensor above the top level, as a fraction of the total height.
const ABOVE_TOP: f64 = 0.02;

/// A direction of a frame compared with the measurement along it.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameBeside {
    /// The survey.
    pub survey: String,
    /// Whether the record contains an earthquake.
    pub stands_out: bool,
    /// Time between samples, s.
    pub step_s: f64,
    /// Each sensor, ordered by height.
    pub sensors: Vec<SensorBeside>,
    /// Channels without a place in the model, or without a known direction.
    pub left_out: Vec<String>,
}

/// A sensor, and the model at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorBeside {
    /// The channel.
    pub channel: String,
    /// Its height, m.
    pub height_m: f64,
    /// Measured absolute acceleration, m/s².
    pub measured_m_s2: Vec<f64>,
    /// Absolute acceleration of the model, m/s².
    pub simulated_m_s2: Vec<f64>,
    /// Their agreement.
    pub beside: SeriesBeside,
}

impl SensorBeside {
    /// Smallest correlation, and largest relative difference of the peaks, for which model and structure agree. Our choice: an error of 5 % in
    /// a frequency brings the correlation below it within ten periods.
    pub const CORRELATION_LEAST: f64 = 0.9;
    /// See [`SensorBeside::CORRELATION_LEAST`].
    pub const PEAK_WITHIN: f64 = 0.2;

    /// Whether model and structure agree here.
    pub fn follows(&self) -> bool {
        let of = &self.beside;
        let off = (of.peak_simulated / of.peak_measured - 1.0).abs();
        of.correlation >= Self::CORRELATION_LEAST && off <= Self::PEAK_WITHIN
    }
}

impl FrameBeside {
    /// Sensors at which the model moves the opposite way but otherwise alike: they may be turned.
    pub fn turned(&self) -> impl Iterator<Item = &SensorBeside> {
        let is_turned = |of: &&SensorBeside| of.beside.correlation <= -SensorBeside::CORRELATION_LEAST;
        self.sensors.iter().filter(is_turned)
    }

    /// Whether model and structure agree at every sensor.
    pub fn follows(&self) -> bool {
        !self.sensors.is_empty() && self.sensors.iter().all(SensorBeside::follows)
    }

    /// Whether they disagree at a sensor.
    pub fn differs(&self) -> bool {
        !self.sensors.iter().all(SensorBeside::follows)
    }

    /// The highest sensor.
    pub fn highest(&self) -> Option<&SensorBeside> {
        self.sensors.last()
    }
}

/// The run of one direction compared with the measurement along it; `None` if the motion is not from a survey, was changed, or has another
/// direction.
pub(super) fn beside(
    (motion, component): (&MotionAnswer, Component),
    direction: &str,
    frame: &FrictionFrame,
    history: &FrameHistory,
) -> Option<FrameBeside> {
    let measured = motion.measured.as_deref()?;
    if direction != component.name() {
        return None;
    }
    let ground = motion.motion.acceleration_m_s2(component);
    let mut levels_m = vec![0.0];
    for storey in frame.frame().storeys() {
        levels_m.push(levels_m[levels_m.len() - 1] + storey.height_m);
    }
    let top_m = levels_m[levels_m.len() - 1];
    let at_steps = |samples: &[f64]| -> Vec<f64> {
        let times = (0..ground.len()).map(|i| i as f64 * measured.step_s);
        times.map(|t| at(&history.time_s, samples, t)).collect()
    };
    let levels: Vec<Vec<f64>> = std::iter::once(ground.to_vec())
        .chain(history.acceleration_m_s2.iter().map(|level| at_steps(level)))
        .collect();
    let fits = |of: &&MeasuredChannel| {
        of.component == component && (0.0..=top_m * (1.0 + ABOVE_TOP)).contains(&of.height_m)
    };
    let mut sensors: Vec<SensorBeside> = measured
        .channels
        .iter()
        .filter(fits)
        .map(|of| {
            let height_m = of.height_m.min(top_m);
            let above = levels_m
                .partition_point(|z| *z < height_m)
                .clamp(1, levels_m.len() - 1);
            let share = (height_m - levels_m[above - 1]) / (levels_m[above] - levels_m[above - 1]);
            let pairs = levels[above - 1].iter().zip(&levels[above]);
            let simulated: Vec<f64> = pairs.map(|(low, high)| low + share * (high - low)).collect();
            SensorBeside {
                channel: of.name.clone(),
                height_m: of.height_m,
                beside: series_beside([&of.acceleration_m_s2, &simulated, ground], measured.step_s),
                measured_m_s2: of.acceleration_m_s2.clone(),
                simulated_m_s2: simulated,
            }
        })
        .collect();
    sensors.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
    let of_axis = measured.channels.iter().filter(|of| of.component == component);
    let elsewhere = measured
        .channels
        .iter()
        .filter(|of| !motion.motion.has(of.component));
    let misplaced = of_axis.filter(|of| !fits(of)).chain(elsewhere);
    let misplaced = misplaced.map(|of| of.name.clone());
    Some(FrameBeside {
        survey: measured.survey.clone(),
        stands_out: measured.stands_out,
        step_s: measured.step_s,
        left_out: measured.left_out.iter().cloned().chain(misplaced).collect(),
        sensors,
    })
}

/// Interpolates samples linearly at given times; repeats the last sample after the end.
fn at(time_s: &[f64], samples: &[f64], t: f64) -> f64 {
    let next = time_s.partition_point(|of| *of < t);
    match (next.checked_sub(1), samples.get(next)) {
        (None, Some(first)) => *first,
        (Some(before), Some(after)) => {
            let share = (t - time_s[before]) / (time_s[next] - time_s[before]);
            samples[before] + share * (after - samples[before])
        }
        (_, None) => samples.last().copied().unwrap_or(0.0),
    }
}
