//! Ground motion: base acceleration in one to three directions, linear between its samples.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a_i | `acceleration_m_s2` | acceleration of the base at t = i Δt | m/s² |
//! | Δt | `time_step_s` | between samples | s |
//! | θ | `angle_rad` | from x towards y, seen from above | rad |

use super::{Processing, SignalError};

/// Largest acceleration: no ground moves faster, and sums of squares below it stay finite. Our choice, as for records.
const ACCELERATION_MOST_M_S2: f64 = 1e100;
/// Longest time step, s: coarser sampling loses the shaking that moves stones. Our choice.
const TIME_STEP_MOST_S: f64 = 1.0;
/// Shortest time step, s: below it the samples of a minute can no longer be counted exactly. Our choice.
const TIME_STEP_LEAST_S: f64 = 1e-9;

/// Direction of one series of a ground motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Horizontal, to the right.
    X,
    /// Horizontal, away from the viewer: x turned by 90° to the left, seen from above.
    Y,
    /// Vertical, up.
    Z,
}

impl Component {
    /// All three, in order.
    pub const ALL: [Component; 3] = [Component::X, Component::Y, Component::Z];

    /// "x", "y", "z".
    pub fn name(self) -> &'static str {
        ["x", "y", "z"][self as usize]
    }
}

impl std::fmt::Display for Component {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// Acceleration of the base in one to three directions, all finite, at one time step.
///
/// Sample i is at t = i Δt. The acceleration is linear between samples, and zero before the first and after the last sample. A direction without
/// a series is zero throughout.
///
/// # Limits
/// The series are used as given, without base-line correction or filter. A cut record whose first or last sample is not zero starts or stops
/// with a jump; [`tapered`](GroundMotion::tapered) removes the jump.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion};
/// let motion = GroundMotion::new("hand made", 0.01, vec![(Component::X, vec![0.0, 2.0, -3.0, 0.0])])?;
/// assert_eq!(motion.peak_acceleration_m_s2(), 3.0);
/// assert_eq!(motion.acceleration_at_m_s2(0.005), [1.0, 0.0, 0.0]);
/// assert_eq!(motion.scaled_to_peak(Component::X, 1.5)?.acceleration_m_s2(Component::X), [0.0, 1.0, -1.5, 0.0]);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GroundMotion {
    name: String,
    time_step_s: f64,
    given: [bool; 3],
    series: [Vec<f64>; 3],
    history: Vec<Processing>,
}

impl GroundMotion {
    /// Makes a motion from the series of one to three directions, m/s², sampled every Δt.
    ///
    /// # Errors
    /// [`SignalError::Empty`] without a series or below 2 samples, [`SignalError::SameName`] for a direction given twice,
    /// [`SignalError::Ragged`], [`SignalError::TimeStep`], [`SignalError::NotFinite`], [`SignalError::TooLarge`].
    pub fn new(
        name: impl Into<String>,
        time_step_s: f64,
        series: Vec<(Component, Vec<f64>)>,
    ) -> Result<Self, SignalError> {
        if !(TIME_STEP_LEAST_S..=TIME_STEP_MOST_S).contains(&time_step_s) {
            return Err(SignalError::TimeStep {
                given: time_step_s,
                least: TIME_STEP_LEAST_S,
                most: TIME_STEP_MOST_S,
            });
        }
        let length = series.first().map_or(0, |(_, samples)| samples.len());
        if length < 2 {
            return Err(SignalError::Empty {
                channels: series.len(),
                samples: length,
            });
        }
        let mut motion = GroundMotion {
            name: name.into(),
            time_step_s,
            given: [false; 3],
            series: [Vec::new(), Vec::new(), Vec::new()],
            history: Vec::new(),
        };
        for (j, (component, _)) in series.iter().enumerate() {
            if let Some(i) = series[..j].iter().position(|(before, _)| before == component) {
                return Err(SignalError::SameName {
                    name: component.name().to_owned(),
                    first: i + 1,
                    second: j + 1,
                });
            }
        }
        for (component, samples) in series {
            let direction = component as usize;
            if samples.len() != length {
                return Err(SignalError::Ragged {
                    channel: component.name().to_owned(),
                    samples: samples.len(),
                    first: length,
                });
            }
            motion.given[direction] = true;
            motion.series[direction] = samples;
        }
        for (given, samples) in motion.given.iter().zip(&mut motion.series) {
            if !given {
                samples.resize(length, 0.0);
            }
        }
        motion.checked()
    }

    /// Name of the motion.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The same motion under another name.
    #[must_use]
    pub fn renamed(self, name: impl Into<String>) -> Self {
        GroundMotion {
            name: name.into(),
            ..self
        }
    }

    /// Time between samples, s.
    pub fn time_step_s(&self) -> f64 {
        self.time_step_s
    }

    /// Number of samples in each direction.
    pub fn length(&self) -> usize {
        self.series[0].len()
    }

    /// From the first sample to the last, s: (samples − 1) Δt.
    pub fn duration_s(&self) -> f64 {
        (self.length() - 1) as f64 * self.time_step_s
    }

    /// Whether a series was given for this direction; otherwise the direction is zero.
    pub fn has(&self, component: Component) -> bool {
        self.given[component as usize]
    }

    /// Acceleration of the base in one direction, m/s², at t = i Δt; zeros if that direction was not given.
    pub fn acceleration_m_s2(&self, component: Component) -> &[f64] {
        &self.series[component as usize]
    }

    /// Acceleration of the base at any time in x, y and z, m/s²: linear between samples, zero outside the motion.
    #[inline]
    pub fn acceleration_at_m_s2(&self, time_s: f64) -> [f64; 3] {
        if !(time_s >= 0.0 && time_s <= self.duration_s()) {
            return [0.0; 3]; // NaN too
        }
        let steps = time_s / self.time_step_s;
        let i = (steps as usize).min(self.length() - 2);
        let part = (steps - i as f64).min(1.0); // the division may round up past the last sample
        let between = |samples: &Vec<f64>| samples[i] + part * (samples[i + 1] - samples[i]);
        [
            between(&self.series[0]),
            between(&self.series[1]),
            between(&self.series[2]),
        ]
    }

    /// Largest absolute acceleration of all directions, each taken alone, m/s².
    pub fn peak_acceleration_m_s2(&self) -> f64 {
        let peaks = Component::ALL.map(|component| self.component_peak_m_s2(component));
        peaks.into_iter().fold(0.0, f64::max)
    }

    /// Largest absolute acceleration in one direction, m/s²: the PGA of that component.
    pub fn component_peak_m_s2(&self, component: Component) -> f64 {
        let samples = self.acceleration_m_s2(component);
        samples.iter().fold(0.0, |peak, a| f64::max(peak, a.abs()))
    }

    /// The samples of one direction, to be changed in place; the caller adds the change to the history.
    pub(super) fn samples_mut(&mut self, component: Component) -> &mut [f64] {
        &mut self.series[component as usize]
    }

    /// Processing history since the motion was measured or made, oldest step first.
    pub fn history(&self) -> &[Processing] {
        &self.history
    }

    /// Adds a step to the history. A reader adds [`Processing::Read`] first; functions of this crate that change a motion add their own step.
    pub fn note(&mut self, step: Processing) {
        self.history.push(step);
    }

    /// Multiplies all directions by one factor.
    ///
    /// # Errors
    /// [`SignalError::Argument`] if the factor is not finite, [`SignalError::TooLarge`].
    pub fn scaled(mut self, factor: f64) -> Result<Self, SignalError> {
        if !factor.is_finite() {
            return Err(SignalError::Argument {
                argument: "factor",
                given: factor,
                allowed: "a finite number",
            });
        }
        for a in self.series.iter_mut().flatten() {
            *a *= factor;
        }
        self.history.push(Processing::Scaled { factor });
        self.checked()
    }

    /// Multiplies all directions by one factor so that the given direction reaches the given peak, m/s².
    ///
    /// # Errors
    /// [`SignalError::Argument`] if the peak is not a number from 0, [`SignalError::NoMotion`] if that direction does not move.
    pub fn scaled_to_peak(
        self,
        component: Component,
        peak_acceleration_m_s2: f64,
    ) -> Result<Self, SignalError> {
        let peak = self.component_peak_m_s2(component);
        if !(peak_acceleration_m_s2 >= 0.0 && peak_acceleration_m_s2.is_finite()) {
            return Err(SignalError::Argument {
                argument: "peak_acceleration_m_s2",
                given: peak_acceleration_m_s2,
                allowed: "0 or a positive number",
            });
        }
        let factor = peak_acceleration_m_s2 / peak;
        if factor.is_finite() {
            self.scaled(factor)
        } else {
            Err(SignalError::NoMotion {
                component: component.name(),
                peak_m_s2: peak,
            })
        }
    }

    /// The part of the motion from `from_s` to `to_s`, each rounded to the nearest sample, both included. Time starts again at 0.
    ///
    /// # Errors
    /// [`SignalError::Cut`] if the part is not within the motion or holds fewer than 2 samples.
    pub fn cut(mut self, from_s: f64, to_s: f64) -> Result<Self, SignalError> {
        let (start, end) = (
            (from_s / self.time_step_s).round(),
            (to_s / self.time_step_s).round(),
        );
        // the comparisons are false for NaN
        if !(start >= 0.0 && end <= (self.length() - 1) as f64 && end - start >= 1.0) {
            return Err(SignalError::Cut {
                from_s,
                to_s,
                least_s: self.time_step_s,
                duration_s: self.duration_s(),
            });
        }
        for samples in &mut self.series {
            samples.truncate(end as usize + 1);
            samples.drain(..start as usize);
        }
        self.history.push(Processing::Cut { from_s, to_s });
        Ok(self)
    }

    /// The first seconds of the motion; the rest is cut off.
    ///
    /// # Errors
    /// As [`GroundMotion::cut`].
    pub fn keep_first(self, seconds: f64) -> Result<Self, SignalError> {
        self.cut(0.0, seconds)
    }

    /// Tapers the motion to zero by half a cosine within this number of seconds at each end.
    ///
    /// ```text
    /// a_i ← a_i ½ (1 − cos(π t / seconds))        t = time from the nearer end < seconds
    /// ```
    ///
    /// # Errors
    /// [`SignalError::Argument`] if the two tapers do not fit into the motion.
    pub fn tapered(mut self, seconds: f64) -> Result<Self, SignalError> {
        if !(seconds > 0.0 && 2.0 * seconds <= self.duration_s()) {
            return Err(SignalError::Argument {
                argument: "seconds",
                given: seconds,
                allowed: "above 0 and at most half the duration of the motion",
            });
        }
        let last = self.length() - 1;
        for samples in &mut self.series {
            for (i, a) in samples.iter_mut().enumerate() {
                let from_end_s = i.min(last - i) as f64 * self.time_step_s;
                if from_end_s < seconds {
                    *a *= 0.5 * (1.0 - (std::f64::consts::PI * from_end_s / seconds).cos());
                }
            }
        }
        self.history.push(Processing::Tapered { each_end_s: seconds });
        Ok(self)
    }

    /// Rotates the motion about the vertical by an angle from x towards y.
    ///
    /// ```text
    /// x ← x cos θ − y sin θ        y ← x sin θ + y cos θ
    /// ```
    ///
    /// # Errors
    /// [`SignalError::Argument`] if the angle is not finite.
    pub fn rotated(mut self, angle_rad: f64) -> Result<Self, SignalError> {
        if !angle_rad.is_finite() {
            return Err(SignalError::Argument {
                argument: "angle_rad",
                given: angle_rad,
                allowed: "a finite number",
            });
        }
        /// Sines below this limit are round-off: a quarter turn leaves nothing along the old axis.
        const ROUND_OFF: f64 = 4e-16;
        let exact = |x: f64| if x.abs() < ROUND_OFF { 0.0 } else { x };
        let (sin, cos) = angle_rad.sin_cos();
        let (sin, cos) = (exact(sin), exact(cos));
        let [x, y, _] = &mut self.series;
        for (x, y) in x.iter_mut().zip(y) {
            (*x, *y) = (*x * cos - *y * sin, *x * sin + *y * cos);
        }
        // after half a turn, the motion along x stays along x
        if sin != 0.0 {
            let horizontal = self.given[0] || self.given[1];
            self.given = [horizontal, horizontal, self.given[2]];
        }
        self.history.push(Processing::Rotated { angle_rad });
        Ok(self)
    }

    /// Checks that every sample is a possible acceleration of the ground.
    fn checked(self) -> Result<Self, SignalError> {
        for (component, samples) in Component::ALL.iter().zip(&self.series) {
            let refused = |a: &f64| a.is_nan() || a.abs() > ACCELERATION_MOST_M_S2;
            if let Some(sample) = samples.iter().position(refused) {
                let (channel, value) = (component.name().to_owned(), samples[sample]);
                let time_s = sample as f64 * self.time_step_s;
                return Err(if value.is_finite() {
                    SignalError::TooLarge {
                        channel,
                        sample,
                        time_s,
                        value,
                        most: ACCELERATION_MOST_M_S2,
                    }
                } else {
                    SignalError::NotFinite {
                        channel,
                        sample,
                        time_s,
                        value,
                    }
                });
            }
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn motion(x: &[f64], y: &[f64]) -> GroundMotion {
        let series = vec![(Component::X, x.to_vec()), (Component::Y, y.to_vec())];
        GroundMotion::new("test", 0.1, series).unwrap()
    }

    #[test]
    fn exact_what_is_not_given_is_zero() {
        let motion = motion(&[1.0, -4.0, 2.0], &[0.5, 5.0, 0.0]);
        assert_eq!(motion.acceleration_m_s2(Component::Z), [0.0; 3]);
        assert!(motion.has(Component::Y) && !motion.has(Component::Z));
        assert_eq!(motion.component_peak_m_s2(Component::X), 4.0);
        assert_eq!(motion.peak_acceleration_m_s2(), 5.0);
        assert_eq!(motion.duration_s(), 0.2);
    }

    #[test]
    fn exact_straight_between_samples_and_zero_outside() {
        let motion = motion(&[1.0, -4.0, 2.0], &[0.5, 5.0, 0.0]);
        assert_eq!(motion.acceleration_at_m_s2(0.0), [1.0, 0.5, 0.0]);
        assert_eq!(motion.acceleration_at_m_s2(0.2), [2.0, 0.0, 0.0]);
        let [x, y, z] = motion.acceleration_at_m_s2(0.125);
        assert!((x + 2.5).abs() < 1e-14 && (y - 3.75).abs() < 1e-14 && z == 0.0);
        for outside in [-1e-9, 0.2 + 1e-9, f64::NAN, f64::INFINITY] {
            assert_eq!(motion.acceleration_at_m_s2(outside), [0.0; 3]);
        }
    }

    #[test]
    fn exact_first_seconds_taper_and_peak_with_their_history() {
        let ones = vec![(Component::X, vec![1.0; 101]), (Component::Z, vec![2.0; 101])];
        let made = GroundMotion::new("ones", 0.1, ones)
            .unwrap()
            .keep_first(5.0)
            .unwrap()
            .tapered(1.0)
            .unwrap()
            .scaled_to_peak(Component::Z, 0.5)
            .unwrap();
        assert_eq!((made.length(), made.duration_s()), (51, 5.0));
        let x = made.acceleration_m_s2(Component::X);
        for (sample, wanted) in [
            (0, 0.0),
            (5, 0.125),
            (10, 0.25),
            (40, 0.25),
            (45, 0.125),
            (50, 0.0),
        ] {
            assert!((x[sample] - wanted).abs() < 1e-15, "{sample}: {}", x[sample]);
        }
        let said: Vec<String> = made.history().iter().map(ToString::to_string).collect();
        assert_eq!(
            said,
            [
                "cut to 0 s … 5 s",
                "tapered by half a cosine, 1 s at each end",
                "scaled by 0.25"
            ]
        );
    }

    #[test]
    fn exact_a_quarter_turn_moves_x_to_y() {
        let turned = motion(&[1.0, 0.0], &[0.0, 1.0])
            .rotated(std::f64::consts::FRAC_PI_2)
            .unwrap();
        let near = |component, wanted: [f64; 2]| {
            let samples = turned.acceleration_m_s2(component);
            samples.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15)
        };
        assert!(near(Component::X, [0.0, -1.0]) && near(Component::Y, [1.0, 0.0]));
        assert!(turned.history()[0].to_string().starts_with("turned by 90"));
    }

    proptest! {
        #[test]
        fn holds_turning_keeps_the_length_of_the_vector(x in -9.0..9.0, y in -9.0..9.0, angle_rad in -7.0..7.0) {
            let turned = motion(&[x, 0.0], &[y, 0.0]).rotated(angle_rad).unwrap();
            let [u, v, _] = turned.acceleration_at_m_s2(0.0);
            prop_assert!((u.hypot(v) - x.hypot(y)).abs() < 1e-13);
        }
    }

    #[test]
    fn refuses_series_that_make_no_motion() {
        let say = |step: f64, series: Vec<(Component, Vec<f64>)>| {
            GroundMotion::new("test", step, series).unwrap_err().to_string()
        };
        let (x, y) = (Component::X, Component::Y);
        let pair = || vec![0.0, 1.0];
        assert_eq!(
            say(0.1, vec![(x, pair()), (y, vec![0.0; 3])]),
            "channel \"y\" has 3 samples, but the first has 2: all channels of one record share their time stamps"
        );
        assert_eq!(
            say(0.1, vec![(y, vec![0.0, f64::NAN])]),
            "channel \"y\" holds NaN at sample 1 (t = 0.1 s): cut the record before or after it, or leave the channel out"
        );
        assert!(say(0.1, vec![(x, vec![0.0, 1e101])]).contains("over-range"));
        assert!(say(0.1, vec![]).contains("0 channels of 0 samples"));
        assert!(say(0.1, vec![(x, vec![1.0])]).contains("1 channels of 1 samples"));
        assert!(
            say(0.1, vec![(y, pair()), (y, pair())])
                .contains("1 and 2 (counted from 1) are both named \"y\"")
        );
        for step in [0.0, -0.01, 2.0, f64::NAN, f64::INFINITY] {
            assert_eq!(
                say(step, vec![(x, pair())]),
                format!("time_step_s is {step}, but must be 0.000000001 to 1: is it in seconds?")
            );
        }
    }

    #[test]
    fn refuses_what_cannot_be_done() {
        let still = || motion(&[0.0, 0.0, 0.0], &[0.0, 1.0, 0.0]);
        let say = |refused: Result<GroundMotion, SignalError>| refused.unwrap_err().to_string();
        assert_eq!(
            say(still().scaled(f64::INFINITY)),
            "factor is inf, but must be a finite number"
        );
        assert_eq!(
            say(still().scaled_to_peak(Component::X, 3.0)),
            "the x component peaks at 0 m/s², so no factor scales it: name a component that moves"
        );
        assert!(say(still().scaled_to_peak(Component::Y, -1.0)).contains("0 or a positive number"));
        assert!(say(still().scaled(1e200)).contains("over-range"));
        assert!(say(still().keep_first(0.3)).contains("0 to 0.2 s"));
        for seconds in [0.0, -1.0, 0.11, f64::NAN] {
            assert!(say(still().tapered(seconds)).contains("half the duration"));
        }
        assert!(say(still().rotated(f64::NAN)).contains("angle_rad is NaN"));
    }
}
