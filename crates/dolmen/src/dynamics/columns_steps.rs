//! Steps of columns on compliant beds: Runge-Kutta of Dormand and Prince with control of the local error.

use super::DynamicsError;
use super::column_run::{ColumnDashpots, ColumnEnergy, ColumnHistory, ColumnOutcome, ColumnRun};
use super::excitation::TimeFunction;
use crate::stability::{ColumnPoint, ColumnsBesideJoints, FreeColumns};

/// Intervals of the table of e(θ) beyond lift-off. Our choice: the error of e is below 1e-6 of the width.
const INTERVALS: usize = 400;
/// Exponent of the variable of that table, x = (θ0/θ)^0.4: e of a circle is smooth in it as θ → ∞.
const EXPONENT: f64 = 0.4;
/// Largest number of steps of a run. Our choice.
const STEPS_MOST: usize = 20_000_000;
/// Halvings to the moment of a peak. Our choice.
const HALVINGS: usize = 40;

/// θ, θ′, u, work of the ground, energy in the dashpots.
type State = [f64; 5];

/// Stages of Dormand and Prince: time, then the weights of the stages before.
const STAGES: [(f64, [f64; 6]); 6] = [
    (0.2, [0.2, 0.0, 0.0, 0.0, 0.0, 0.0]),
    (0.3, [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0]),
    (0.8, [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0]),
    (
        8.0 / 9.0,
        [
            19372.0 / 6561.0,
            -25360.0 / 2187.0,
            64448.0 / 6561.0,
            -212.0 / 729.0,
            0.0,
            0.0,
        ],
    ),
    (
        1.0,
        [
            9017.0 / 3168.0,
            -355.0 / 33.0,
            46732.0 / 5247.0,
            49.0 / 176.0,
            -5103.0 / 18656.0,
            0.0,
        ],
    ),
    (
        1.0,
        [
            35.0 / 384.0,
            0.0,
            500.0 / 1113.0,
            125.0 / 192.0,
            -2187.0 / 6784.0,
            11.0 / 84.0,
        ],
    ),
];
/// Weights of the error: fifth minus fourth order.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The equation of motion of the columns.
pub(super) struct Motion {
    held: ColumnsBesideJoints,
    uplift: ColumnPoint,
    falls: ColumnPoint,
    /// e and its slope by x at the ends of the intervals, from x at the fall to 1.
    table: Vec<(f64, f64)>,
    x_least: f64,
    /// e′(0), m.
    slope_m: f64,
    /// k_j/(k_j + k_b).
    joints_share: f64,
    /// ω0, rad/s.
    omega: f64,
    /// Rotation in balance with the tilt, rad.
    balance_rad: f64,
}

impl Motion {
    /// `None` if the bed is rigid or the columns do not stand.
    pub(super) fn of(columns: &FreeColumns, run: &ColumnRun) -> Result<Option<Self>, DynamicsError> {
        let held = ColumnsBesideJoints {
            columns: *columns,
            joints_n_m: run.joints_n_m,
        };
        let (Some(beds_n_m), Some(uplift)) = (columns.bed_stiffness_n_m(), columns.uplift()) else {
            return Ok(None);
        };
        let Some(falls) = held.falls(run.drift_most_m)? else {
            return Ok(None);
        };
        let ratio = (uplift.rotation_rad / (1.2 * falls.rotation_rad)).min(0.9);
        let x_least = ratio.powf(EXPONENT);
        let table = (0..=INTERVALS).map(|i| {
            let x = x_least + (1.0 - x_least) * i as f64 / INTERVALS as f64;
            let rotation = uplift.rotation_rad * x.powf(-1.0 / EXPONENT);
            let slope_m = columns.eccentricity_slope_m(rotation);
            (
                columns.eccentricity_m(rotation),
                -slope_m * rotation / (EXPONENT * x),
            )
        });
        let whole_n_m = beds_n_m + held.joints_n_m;
        Ok(Some(Motion {
            table: table.collect(),
            x_least,
            slope_m: columns.eccentricity_slope_m(0.0),
            joints_share: held.joints_n_m / whole_n_m,
            omega: ((whole_n_m - columns.axial_n() / columns.height_m()) / run.mass_kg).sqrt(),
            balance_rad: 0.0,
            held,
            uplift,
            falls,
        }))
    }

    pub(super) fn falls_rad(&self) -> f64 {
        self.falls.rotation_rad
    }

    /// The rotation at the start, after that in balance was found; `None` if the tilt overturns the columns.
    pub(super) fn start_rad(&mut self, run: &ColumnRun) -> Result<Option<f64>, DynamicsError> {
        let push_n = self.held.columns.axial_n() * run.tilt.abs();
        let Some(found) = self.held.rotation_under_rad(push_n, run.drift_most_m)? else {
            return Ok(None);
        };
        self.balance_rad = found.copysign(run.tilt);
        Ok(Some(run.start_rad.unwrap_or(self.balance_rad)))
    }

    /// A history of columns that fall at once.
    pub(super) fn fallen(&self, run: &ColumnRun) -> ColumnHistory {
        let falls_drift_m = self.falls.drift_m;
        ColumnHistory {
            outcome: ColumnOutcome::Fell { at_s: 0.0 },
            time_s: vec![0.0],
            drift_m: vec![0.0],
            peak_drift_m: (falls_drift_m - run.tilt.abs() * self.held.columns.height_m()).max(0.0),
            peak_at_s: 0.0,
            uplift_s: Some(0.0),
            uplift_drift_m: self.uplift.drift_m,
            falls_drift_m,
            rest_drift_m: 0.0,
            energy: ColumnEnergy::default(),
            peak_change: 0.0,
            steps: 0,
        }
    }

    /// e and e′ at a rotation, by the table beyond lift-off.
    fn lever(&self, rotation: f64) -> (f64, f64) {
        let size = rotation.abs();
        let uplift_rad = self.uplift.rotation_rad;
        if size <= uplift_rad {
            return (self.slope_m * rotation, self.slope_m);
        }
        let x = (uplift_rad / size).powf(EXPONENT).max(self.x_least);
        let width = (1.0 - self.x_least) / INTERVALS as f64;
        let place = ((x - self.x_least) / width).min(INTERVALS as f64 - 1e-9);
        let t = place.fract();
        let (e0, s0) = self.table[place as usize];
        let (e1, s1) = self.table[place as usize + 1];
        let (s0, s1) = (s0 * width, s1 * width);
        let (square, cube) = (3.0 * (e1 - e0) - 2.0 * s0 - s1, 2.0 * (e0 - e1) + s0 + s1);
        let e = e0 + t * (s0 + t * (square + t * cube));
        let by_x = (s0 + t * (2.0 * square + 3.0 * t * cube)) / width;
        (e.copysign(rotation), -by_x * EXPONENT * x / size)
    }

    /// u_θ, z_θ and the inertia over m.
    fn path(&self, rotation: f64, e: f64) -> (f64, f64, f64) {
        let h = self.held.columns.height_m();
        let (sin, cos) = rotation.sin_cos();
        (
            h * cos + 2.0 * e * sin,
            2.0 * e * cos - h * sin,
            h * h + 4.0 * e * e,
        )
    }

    fn rates(&self, state: &State, acceleration: f64, run: &ColumnRun) -> State {
        let [rotation, speed, drift_m, ..] = *state;
        let (e, slope) = self.lever(rotation);
        let (sway, rise, inertia) = self.path(rotation, e);
        let share = match run.dashpots {
            ColumnDashpots::InBeds => self.joints_share + (1.0 - self.joints_share) * slope / self.slope_m,
            ColumnDashpots::Constant => 1.0,
        };
        let dashpot = 2.0 * run.damping_ratio * self.omega * share * sway * sway; // over m
        let weight = self.held.columns.axial_n() / run.mass_kg;
        let joints = self.held.joints_n_m / run.mass_kg * drift_m;
        let push = (weight * run.tilt - acceleration - joints) * sway;
        let faster = (push - weight * rise - dashpot * speed - 4.0 * e * slope * speed * speed) / inertia;
        [
            speed,
            faster,
            sway * speed,
            -run.mass_kg * acceleration * sway * speed,
            run.mass_kg * dashpot * speed * speed,
        ]
    }

    /// One step: the new state, its rates, and the error over the tolerance.
    fn step(
        &self,
        from: (&State, &State),
        h: f64,
        tolerance: f64,
        at: &dyn Fn(&State, f64) -> State,
    ) -> Stepped {
        let (state, first) = from;
        let mut rates = [*first; 7];
        let mut next = *state;
        for (stage, (time, weights)) in STAGES.iter().enumerate() {
            next = *state;
            for (weight, rate) in weights.iter().zip(&rates[..=stage]) {
                for (value, rate) in next.iter_mut().zip(rate) {
                    *value += h * weight * rate;
                }
            }
            rates[stage + 1] = at(&next, *time * h);
        }
        let error = |place: usize| {
            let sum: f64 = ERROR
                .iter()
                .zip(&rates)
                .map(|(weight, rate)| weight * rate[place])
                .sum();
            (h * sum).abs()
        };
        let uplift = self.uplift.rotation_rad;
        let of_rotation = error(0) / (uplift + state[0].abs().max(next[0].abs()));
        let of_speed = error(1) / (uplift * self.omega + state[1].abs().max(next[1].abs()));
        let error = of_rotation.max(of_speed) / tolerance;
        Stepped {
            state: next,
            rates: rates[6],
            // NaN of numbers that overflow asks for a shorter step
            error: if error.is_nan() { f64::INFINITY } else { error },
        }
    }

    /// The run from a rotation at rest, with a tolerance of its steps.
    pub(super) fn follow(
        &self,
        ground: &TimeFunction,
        run: &ColumnRun,
        (start_rad, tolerance): (f64, f64),
    ) -> ColumnHistory {
        let drift_at = |rotation: f64| self.held.columns.at(rotation.abs()).drift_m.copysign(rotation);
        let start_m = drift_at(start_rad);
        let mut breaks_s = ground.breaks_s(run.duration_s);
        breaks_s.push(run.duration_s);
        let longest_s = ground.step_most_s().min(1.0 / self.omega.min(1.0));
        let mut watch = Watch::new(self, run, start_m);
        let mut state: State = [start_rad, 0.0, start_m, 0.0, 0.0];
        let (mut time_s, mut next_break, mut h) = (0.0, 0, 0.01 / self.omega);
        let mut rates = self.rates(&state, ground.value(0.0), run);
        let mut is_open = false;
        while time_s < run.duration_s && watch.fell_s.is_none() {
            while breaks_s[next_break] <= time_s {
                next_break += 1;
            }
            let to_break = breaks_s[next_break] - time_s;
            let step_s = match h.min(longest_s) {
                h if h >= to_break * (1.0 - 1e-9) => to_break,
                h => h,
            };
            let at = |state: &State, later: f64| self.rates(state, ground.value(time_s + later), run);
            let stepped = self.step((&state, &rates), step_s, tolerance, &at);
            let factor = (0.9 * stepped.error.powf(-0.2)).clamp(0.2, 5.0);
            // shorter steps than rounding of the time allows are taken as they are
            let is_shortest = step_s <= 1e-14 * run.duration_s;
            if stepped.error <= 1.0 || is_shortest {
                let ends_at = if step_s == to_break {
                    breaks_s[next_break]
                } else {
                    time_s + step_s
                };
                watch.see(
                    (time_s, ends_at),
                    (&state, &rates),
                    (&stepped.state, &stepped.rates),
                );
                (time_s, state) = (ends_at, stepped.state);
                rates = self.rates(&state, ground.value(time_s), run);
                watch.history.steps += 1;
                if !state[0].is_finite() || watch.history.steps >= STEPS_MOST {
                    is_open = true;
                    break;
                }
            }
            let proposed_s = h;
            h = step_s * factor;
            if step_s == to_break && stepped.error <= 1.0 {
                h = h.max(proposed_s);
            }
        }
        watch.end(&state, (run, start_rad), is_open)
    }

    /// Energy in beds and weight up to a rotation, and in joints and the tilt at a drift, J.
    fn stored_j(&self, rotation: f64, drift_m: f64, run: &ColumnRun) -> f64 {
        let rises = self.held.columns.rise_between_m(0.0, rotation.abs());
        let joints_j = 0.5 * self.held.joints_n_m * drift_m * drift_m;
        self.held.columns.axial_n() * (rises - run.tilt * drift_m) + joints_j
    }
}

struct Stepped {
    state: State,
    rates: State,
    error: f64,
}

/// Peaks, samples and events of a run.
struct Watch<'a> {
    motion: &'a Motion,
    history: ColumnHistory,
    /// τ h, m.
    leans_m: f64,
    output_step_s: f64,
    fell_s: Option<f64>,
}

impl<'a> Watch<'a> {
    fn new(motion: &'a Motion, run: &ColumnRun, start_m: f64) -> Self {
        let balance = motion.balance_rad;
        let rest_drift_m = motion.held.columns.at(balance.abs()).drift_m.copysign(balance);
        let uplift_drift_m = motion.uplift.drift_m;
        Watch {
            motion,
            leans_m: run.tilt * motion.held.columns.height_m(),
            output_step_s: run.output_step_s,
            fell_s: None,
            history: ColumnHistory {
                outcome: ColumnOutcome::Stood,
                time_s: vec![0.0],
                drift_m: vec![start_m],
                peak_drift_m: start_m.abs(),
                uplift_s: (start_m.abs() > uplift_drift_m).then_some(0.0),
                rest_drift_m,
                ..motion.fallen(run)
            },
        }
    }

    /// The step between two times, as a cubic of the drift.
    fn see(
        &mut self,
        (from_s, to_s): (f64, f64),
        (a, a_rates): (&State, &State),
        (b, b_rates): (&State, &State),
    ) {
        let step_s = to_s - from_s;
        let (u0, u1) = (a[2], b[2]);
        let (s0, s1) = (a_rates[2] * step_s, b_rates[2] * step_s);
        let (square, cube) = (3.0 * (u1 - u0) - 2.0 * s0 - s1, 2.0 * (u0 - u1) + s0 + s1);
        let drift = |t: f64| u0 + t * (s0 + t * (square + t * cube));
        let mut see_peak = |t: f64| {
            let size = drift(t).abs();
            if size > self.history.peak_drift_m {
                (self.history.peak_drift_m, self.history.peak_at_s) = (size, from_s + t * step_s);
            }
        };
        if s0 * s1 < 0.0 {
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let t = 0.5 * (low + high);
                let slope = s0 + t * (2.0 * square + 3.0 * t * cube);
                if (slope > 0.0) == (s0 > 0.0) {
                    low = t
                } else {
                    high = t
                }
            }
            see_peak(low);
        }
        see_peak(1.0);
        let lifts_m = self.motion.uplift.drift_m;
        if self.history.uplift_s.is_none() && u1.abs() > lifts_m {
            let share = (lifts_m - u0.abs()) / (u1.abs() - u0.abs());
            self.history.uplift_s = Some(from_s + share.clamp(0.0, 1.0) * step_s);
        }
        while let Some(next_s) =
            Some(self.history.time_s.len() as f64 * self.output_step_s).filter(|next| *next <= to_s)
        {
            self.history.time_s.push(next_s);
            self.history.drift_m.push(drift((next_s - from_s) / step_s));
        }
        if (u1 + self.leans_m).abs() >= self.motion.falls.drift_m {
            self.fell_s = Some(to_s);
        }
    }

    fn end(self, state: &State, (run, start_rad): (&ColumnRun, f64), is_open: bool) -> ColumnHistory {
        let motion = self.motion;
        let stored = |rotation: f64, drift_m: f64| motion.stored_j(rotation, drift_m, run);
        let (e, _) = motion.lever(state[0]);
        let (_, _, inertia) = motion.path(state[0], e);
        let mut history = self.history;
        history.energy = ColumnEnergy {
            input_j: state[3],
            kinetic_j: 0.5 * run.mass_kg * inertia * state[1] * state[1],
            stored_j: stored(state[0], state[2]) - stored(start_rad, history.drift_m[0]),
            damping_j: state[4],
        };
        history.outcome = match (self.fell_s, history.uplift_s) {
            _ if is_open => ColumnOutcome::NotConverged,
            (Some(at_s), _) => ColumnOutcome::Fell { at_s },
            (None, Some(_)) => ColumnOutcome::Rocked,
            (None, None) => ColumnOutcome::Stood,
        };
        history
    }
}
