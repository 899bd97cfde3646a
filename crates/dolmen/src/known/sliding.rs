//! A rigid block that slides on a moving base by Coulomb's law in one direction: closed forms, and the exact solution from
//! event to event.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a | `a` | acceleration of the base | m/s² |
//! | u, w | `slip`, `w` | displacement and velocity of the block relative to the base | m, m/s |
//! | d | `direction` | sign of w; 0 where the block sticks | – |
//! | μ_s g, μ_k g | `hold`, `drag` | largest acceleration with static friction; deceleration by kinetic friction | m/s² |
//! | η | – | μ g / largest acceleration of the base | – |
//!
//! ```text
//! stuck while |a| ≤ μ_s g; otherwise w' = −a − μ_k g d, until w = 0
//! ```

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::bisection::sign_change;

/// Friction between block and base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Static coefficient, at least the kinetic one.
    pub static_coefficient: f64,
    /// Kinetic coefficient, above 0.
    pub kinetic_coefficient: f64,
    /// Gravity, m/s².
    pub gravity_m_s2: f64,
}

impl Friction {
    /// Equal static and kinetic coefficients.
    pub fn single(coefficient: f64, gravity_m_s2: f64) -> Friction {
        Friction {
            static_coefficient: coefficient,
            kinetic_coefficient: coefficient,
            gravity_m_s2,
        }
    }
}

/// The slip of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Slip {
    /// Largest distance from its starting point on the base, m, including times between samples.
    pub peak_m: f64,
    /// Slip after the block has come to rest, with its sign, m.
    pub residual_m: f64,
    /// Time of the final rest, s; 0 if it never moved.
    pub rest_s: f64,
    /// Slip at the samples, with its sign, m.
    pub slip_m: Vec<f64>,
}

/// Slip, m, of a block on a base that accelerates from rest with a constant A for a time t and then keeps its velocity.
///
/// ```text
/// ½ A t² (A/μg − 1)      0 for A ≤ μ g
/// ```
///
/// # Source
/// Newmark, N. M. (1965) Géotechnique 15(2):139-160: V²/(2gN) (1 − N/A) with V = A t.
///
/// # Example
/// ```
/// use dolmen::known::sliding::rectangular_pulse_slip_m;
/// assert!((rectangular_pulse_slip_m(0.5 * 9.81, 0.2, 0.3, 9.81) - 0.0654).abs() < 5e-7);
/// ```
pub fn rectangular_pulse_slip_m(
    acceleration_m_s2: f64,
    duration_s: f64,
    friction_coefficient: f64,
    gravity_m_s2: f64,
) -> f64 {
    let excess = acceleration_m_s2 / (friction_coefficient * gravity_m_s2) - 1.0;
    0.5 * acceleration_m_s2 * duration_s * duration_s * excess.max(0.0)
}

/// Peak-to-peak slip, m, of a block in steady state on a base that moves with acceleration a sin ω t, if it slides all the
/// time.
///
/// ```text
/// (2a/ω²) √(1 − (πη/2)²)      η = μg/a ≤ 1/√(1 + π²/4) = 0.53703
/// ```
///
/// `None` above that η: the block then sticks twice in a period.
pub fn harmonic_slip_m(
    acceleration_m_s2: f64,
    frequency_hz: f64,
    friction_coefficient: f64,
    gravity_m_s2: f64,
) -> Option<f64> {
    let eta = friction_coefficient * gravity_m_s2 / acceleration_m_s2;
    let omega = TAU * frequency_hz;
    let part = 1.0 - (FRAC_PI_2 * eta).powi(2);
    (eta.abs() <= 1.0 / FRAC_PI_2.hypot(1.0)).then(|| 2.0 * acceleration_m_s2 / (omega * omega) * part.sqrt())
}

/// Exact slip of a block on a base whose acceleration is linear between samples; after the last sample the base keeps its
/// velocity. Between two events u is a cubic in time. `None` unless every number is finite, the step positive, and 0 < μ_k
/// ≤ μ_s.
///
/// # Limits
/// Rounding: 1e-13 of the peak for a record of 1560 samples.
///
/// # Example
/// ```
/// use dolmen::known::sliding::{record_slip, Friction};
/// // 0.5 g for 0.2 s, with a final ramp of 0.1 ms
/// let base: Vec<f64> = (0..4001).map(|i| if i < 2000 { 0.5 * 9.81 } else { 0.0 }).collect();
/// let slip = record_slip(&base, 1e-4, &Friction::single(0.3, 9.81));
/// assert!(slip.is_some_and(|slip| (slip.peak_m - 0.0654).abs() < 5e-5));
/// ```
pub fn record_slip(base_acceleration_m_s2: &[f64], step_s: f64, friction: &Friction) -> Option<Slip> {
    let finite = base_acceleration_m_s2.iter().all(|a| a.is_finite());
    if !(finite && step_s > 0.0 && step_s.is_finite()) {
        return None;
    }
    let mut block = Block::at_rest(friction)?;
    let mut slip_m: Vec<f64> = base_acceleration_m_s2.first().map(|_| 0.0).into_iter().collect();
    for pair in base_acceleration_m_s2.windows(2) {
        let (mut a, slope, mut left) = (pair[0], (pair[1] - pair[0]) / step_s, step_s);
        while left > 0.0 {
            let spent = block.along_a_line(a, slope, left);
            a += slope * spent;
            left -= spent;
        }
        slip_m.push(block.slip);
    }
    block.coast();
    Some(block.report(slip_m))
}

/// Exact slip of a block on a base that accelerates from rest with A sin(2π f t) for a time and then keeps its velocity,
/// which is zero after whole periods. Slip is given every `sample_s` as long as the base accelerates. `None` unless every
/// number is finite, f, the time and the step positive, and 0 < μ_k ≤ μ_s.
///
/// # Limits
/// Events are bracketed by the extremes of w, which are known, and located to adjacent floating-point numbers.
///
/// # Example
/// ```
/// use dolmen::known::sliding::{sine_slip, Friction};
/// let g = 9.80665;
/// let slip = sine_slip(0.5 * g, 2.0, 10.0, 0.01, &Friction::single(0.3, g));
/// assert!(slip.is_some_and(|slip| (slip.peak_m - 24.48e-3).abs() < 5e-6));
/// ```
pub fn sine_slip(
    acceleration_m_s2: f64,
    frequency_hz: f64,
    duration_s: f64,
    sample_s: f64,
    friction: &Friction,
) -> Option<Slip> {
    const SAME: f64 = 1e-12; // includes the sample at the end of the motion in spite of rounding
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let given = [frequency_hz, duration_s, sample_s].into_iter().all(positive);
    if !given || !acceleration_m_s2.is_finite() {
        return None;
    }
    let base = Sine {
        amplitude: acceleration_m_s2,
        omega: TAU * frequency_hz,
    };
    let mut block = Block::at_rest(friction)?;
    let mut slip_m = Vec::new();
    while block.time < duration_s {
        let event = if block.direction == 0.0 {
            block.let_go(&base)
        } else {
            block.stops(&base, duration_s)
        };
        let end = event.map_or(duration_s, |event| event.min(duration_s));
        loop {
            let sample = slip_m.len() as f64 * sample_s;
            if sample > end * (1.0 + SAME) {
                break;
            }
            slip_m.push(block.under_a_sine(&base, sample.min(end)).0);
        }
        let (slip, w) = block.under_a_sine(&base, end);
        (block.time, block.slip, block.w) = (end, slip, w);
        if event.is_some_and(|event| event < duration_s) {
            if block.direction == 0.0 {
                let half_period = (base.omega * end / PI + SAME).floor();
                block.direction =
                    -base.amplitude.signum() * if half_period % 2.0 == 0.0 { 1.0 } else { -1.0 };
            } else {
                block.stop();
            }
        }
    }
    block.coast();
    Some(block.report(slip_m))
}

/// A base that moves with acceleration `amplitude` sin(`omega` t).
struct Sine {
    amplitude: f64,
    omega: f64,
}

/// The state of the block between two events.
#[derive(Clone)]
struct Block {
    hold: f64,
    drag: f64,
    time: f64,
    slip: f64,
    w: f64,
    direction: f64,
    peak: f64,
    rest: f64,
}

impl Block {
    fn at_rest(friction: &Friction) -> Option<Block> {
        let hold = friction.static_coefficient * friction.gravity_m_s2;
        let drag = friction.kinetic_coefficient * friction.gravity_m_s2;
        (drag > 0.0 && drag <= hold && hold.is_finite()).then_some(Block {
            hold,
            drag,
            time: 0.0,
            slip: 0.0,
            w: 0.0,
            direction: 0.0,
            peak: 0.0,
            rest: 0.0,
        })
    }

    /// Advances to the next event under a base acceleration a + slope t, by at most `left`; returns the elapsed time.
    fn along_a_line(&mut self, a: f64, slope: f64, left: f64) -> f64 {
        const ROUNDING: f64 = 1e-10; // our choice: between the rounding of a and any difference of meaning
        if self.direction == 0.0 {
            if a.abs() >= self.hold && (a.abs() > self.hold || a * slope > 0.0) {
                self.direction = -a.signum();
            } else {
                // Stuck until |a| reaches the limit of static friction.
                let reach = (slope.signum() * self.hold - a) / slope;
                let spent = if slope != 0.0 && reach < left { reach } else { left };
                self.time += spent;
                if spent < left {
                    self.direction = -slope.signum();
                }
                return spent;
            }
        }
        // d w = d w_0 + s t + q t², from d w_0 ≥ 0 to its first descent through 0.
        let d = self.direction;
        let (start, mut s, q) = (d * self.w, d * -a - self.drag, -0.5 * d * slope);
        if start == 0.0 && s.abs() < ROUNDING * self.drag {
            s = 0.0; // the block has just been released: rounding must not stop it
        }
        let stop = first_fall(start, s, q);
        let spent = stop.min(left);
        self.slip += d * spent * (start + spent * (0.5 * s + spent * q / 3.0));
        self.w = d * (start + spent * (s + spent * q)).max(0.0);
        self.time += spent;
        if stop <= left {
            self.stop();
        }
        spent
    }

    /// After the motion of the base, only friction acts.
    fn coast(&mut self) {
        if self.direction != 0.0 {
            self.slip += 0.5 * self.direction * self.w * self.w / self.drag;
            self.time += self.w.abs() / self.drag;
            self.stop();
        }
    }

    fn stop(&mut self) {
        (self.w, self.direction) = (0.0, 0.0);
        self.peak = self.peak.max(self.slip.abs());
        self.rest = self.time;
    }

    fn report(self, slip_m: Vec<f64>) -> Slip {
        Slip {
            peak_m: self.peak,
            residual_m: self.slip,
            rest_s: self.rest,
            slip_m,
        }
    }

    /// Slip and slip velocity at a time that is not after the next event.
    fn under_a_sine(&self, base: &Sine, time: f64) -> (f64, f64) {
        if self.direction == 0.0 {
            return (self.slip, 0.0);
        }
        let t = time - self.time;
        let (sin_0, cos_0) = (base.omega * self.time).sin_cos();
        let (sin, cos) = (base.omega * time).sin_cos();
        let base_w = base.amplitude / base.omega * (cos_0 - cos);
        let base_u = base.amplitude / base.omega * (cos_0 * t - (sin - sin_0) / base.omega);
        let drag = self.direction * self.drag;
        (
            self.slip + self.w * t - base_u - 0.5 * drag * t * t,
            self.w - base_w - drag * t,
        )
    }

    /// Time at which a stuck block is released, if ever.
    fn let_go(&self, base: &Sine) -> Option<f64> {
        if base.amplitude.abs() <= self.hold {
            return None;
        }
        let reach = (self.hold / base.amplitude.abs()).asin(); // |a| > μ_s g from here to π − here, in each half period
        let half_period = (base.omega * self.time / PI).floor();
        let phase = base.omega * self.time - half_period * PI;
        if phase < reach {
            Some((half_period * PI + reach) / base.omega)
        } else if phase < PI - reach {
            Some(self.time)
        } else {
            Some(((half_period + 1.0) * PI + reach) / base.omega)
        }
    }

    /// Time at which a sliding block stops; `None` if it does not stop before `end`. Between the times at which |a| = μ_k
    /// g, w is monotonic.
    fn stops(&self, base: &Sine, end: f64) -> Option<f64> {
        const SAME: f64 = 1e-9; // of 1/ω: the block has just been released at this time
        let reach = (self.drag / base.amplitude.abs()).asin();
        let along = |time: f64| self.direction * self.under_a_sine(base, time).1;
        let mut half_period = (base.omega * self.time / PI).floor();
        let mut low = self.time;
        while low < end {
            for phase in [reach, PI - reach] {
                let high = (half_period * PI + phase) / base.omega;
                if high <= self.time + SAME / base.omega {
                    continue;
                }
                if along(high) < 0.0 {
                    return Some(sign_change(along, low, high));
                }
                low = high;
            }
            half_period += 1.0;
        }
        None
    }
}

/// First t ≥ 0 at which start + s t + q t² decreases through 0, from start ≥ 0; infinity if there is none.
fn first_fall(start: f64, s: f64, q: f64) -> f64 {
    let under = s * s - 4.0 * q * start;
    if under < 0.0 || (q >= 0.0 && s >= 0.0) {
        return f64::INFINITY;
    }
    // The smallest positive root, without cancellation.
    if s < 0.0 {
        2.0 * start / (under.sqrt() - s)
    } else {
        (s + under.sqrt()) / (-2.0 * q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const G: f64 = 9.81;
    const STANDARD: f64 = 9.80665;

    fn near(value: f64, expected: f64, tolerance: f64) {
        assert!(
            (value - expected).abs() <= tolerance,
            "{value} is not {expected} within {tolerance}"
        );
    }

    /// El Centro 1940 north-south from the repository, scaled to a peak, m/s².
    fn el_centro(peak_m_s2: f64) -> Vec<f64> {
        let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
        let values: Vec<f64> = text
            .lines()
            .skip(1)
            .map(|line| line.split(',').nth(1).unwrap().parse().unwrap())
            .collect();
        assert_eq!(values.len(), 1560);
        let peak = values.iter().fold(0.0, |peak: f64, a| peak.max(a.abs()));
        values.iter().map(|a| a / peak * peak_m_s2).collect()
    }

    #[test]
    fn exact_rectangular_pulse() {
        near(rectangular_pulse_slip_m(0.5 * G, 0.2, 0.3, G), 65.40e-3, 5e-6);
        near(
            rectangular_pulse_slip_m(0.5 * STANDARD, 0.2, 0.3, STANDARD),
            65.378e-3,
            5e-7,
        );
        assert_eq!(rectangular_pulse_slip_m(0.2 * G, 0.2, 0.3, G), 0.0);
        // Linear interpolation gives the pulse a final ramp of one step: the error is of first order in the step.
        let slip = |steps: usize| {
            let base: Vec<f64> = (0..2 * steps)
                .map(|i| if i < steps { 0.5 * G } else { 0.0 })
                .collect();
            record_slip(&base, 0.2 / steps as f64, &Friction::single(0.3, G)).unwrap()
        };
        let [coarse, fine] = [1000, 10_000].map(|steps| slip(steps).peak_m - 0.0654);
        near(coarse / fine, 10.0, 0.05);
        assert!(fine.abs() < 1e-5);
    }

    #[test]
    fn exact_sine_of_ten_seconds() {
        let slip = sine_slip(0.5 * STANDARD, 2.0, 10.0, 0.01, &Friction::single(0.3, STANDARD)).unwrap();
        near(slip.peak_m, 24.48e-3, 5e-6);
        near(slip.residual_m.abs(), 0.420_31e-3, 5e-9);
        assert_eq!(slip.slip_m.len(), 1001);
    }

    #[test]
    fn exact_harmonic_base() {
        // η = 0.5, after the initial drift has died out: the last two of many periods.
        let (a, frequency) = (0.4 * G, 2.0);
        let slip = sine_slip(a, frequency, 50.0, 1e-4, &Friction::single(0.2, G)).unwrap();
        let last = &slip.slip_m[slip.slip_m.len() - 10_000..];
        let [most, least] = [1.0, -1.0].map(|d| last.iter().fold(f64::NEG_INFINITY, |m, u| m.max(d * u)));
        near(
            (most + least) / harmonic_slip_m(a, frequency, 0.2, G).unwrap(),
            1.0,
            1e-6,
        );
        assert_eq!(harmonic_slip_m(G, 1.0, 0.538, G), None);
    }

    #[test]
    fn holds_a_sampled_sine_tends_to_the_sine() {
        let friction = Friction {
            static_coefficient: 0.3,
            kinetic_coefficient: 0.25,
            gravity_m_s2: G,
        };
        let sine = sine_slip(0.5 * G, 2.0, 10.0, 0.01, &friction).unwrap();
        let error = |per_second: u32| {
            let step = 1.0 / f64::from(per_second);
            let sample = |i: u32| 0.5 * G * (TAU * 2.0 * f64::from(i) * step).sin();
            let base: Vec<f64> = (0..=10 * per_second).map(sample).collect();
            let record = record_slip(&base, step, &friction).unwrap();
            let every = (per_second / 100) as usize;
            let differences = sine.slip_m.iter().zip(record.slip_m.iter().step_by(every));
            differences.fold(0.0, |most: f64, (u, v)| most.max((u - v).abs()))
        };
        let [coarse, fine] = [error(1000), error(10_000)];
        assert!(
            fine < 2e-8 && (80.0..120.0).contains(&(coarse / fine)),
            "{coarse} {fine}"
        );
    }

    /// Reference record for other engines. Our own value; a separate program with fifty digits gave the same fifteen
    /// digits.
    #[test]
    fn regress_el_centro() {
        let slip = record_slip(&el_centro(0.5 * G), 0.02, &Friction::single(0.2, G)).unwrap();
        near(slip.peak_m, 29.730_716_778_79e-3, 1e-13);
        near(slip.residual_m, -13.813_294_068_49e-3, 1e-13);
        near(slip.rest_s, 26.266_088_939, 1e-9);
    }

    /// Small steps with limited velocity change by friction, without event detection.
    #[test]
    fn holds_small_steps_slide_alike() {
        const PARTS: u32 = 20_000;
        let base = el_centro(0.5 * G);
        let slip = record_slip(&base, 0.02, &Friction::single(0.2, G)).unwrap();
        let h = 0.02 / f64::from(PARTS);
        let (mut u, mut w) = (0.0, 0.0_f64);
        for (i, pair) in base.windows(2).enumerate() {
            for part in 0..PARTS {
                let a = pair[0] + (pair[1] - pair[0]) * (f64::from(part) + 0.5) / f64::from(PARTS);
                let free = w - a * h;
                let next = free.signum() * (free.abs() - 0.2 * G * h).max(0.0);
                u += 0.5 * (w + next) * h;
                w = next;
            }
            near(u, slip.slip_m[i + 1], 1e-6);
        }
    }

    #[test]
    fn holds_slip_turned_round_is_slip_turned_round() {
        let base = el_centro(0.5 * G);
        let turned: Vec<f64> = base.iter().map(|a| -a).collect();
        let friction = Friction {
            static_coefficient: 0.25,
            kinetic_coefficient: 0.2,
            gravity_m_s2: G,
        };
        let [slip, back] = [base, turned].map(|base| record_slip(&base, 0.02, &friction).unwrap());
        assert_eq!((slip.peak_m, slip.residual_m), (back.peak_m, -back.residual_m));
    }

    #[test]
    fn refuses_what_is_not_a_number_or_not_friction() {
        let friction = Friction::single(0.2, G);
        assert_eq!(record_slip(&[0.0, f64::NAN], 0.02, &friction), None);
        assert_eq!(record_slip(&[0.0, 1.0], 0.0, &friction), None);
        assert_eq!(record_slip(&[0.0, 1.0], 0.02, &Friction::single(0.0, G)), None);
        assert_eq!(sine_slip(1.0, -2.0, 10.0, 0.01, &friction), None);
        let weaker_at_rest = Friction {
            static_coefficient: 0.1,
            ..friction
        };
        assert_eq!(record_slip(&[0.0, 1.0], 0.02, &weaker_at_rest), None);
    }
}
