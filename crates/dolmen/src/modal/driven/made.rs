//! Simulated records above a measured ground: two storeys on a footing on soil (spring and dashpot), excited by waves and by wind, and one mass.

use crate::modal::synthetic::{MadeMode, Oscillator};
use crate::numeric::Random;
use crate::signal::{Channel, Quantity, Record, SignalError, low_pass};
use dolmen_linalg::Complex64;
use std::f64::consts::{PI, TAU};

/// Storeys, t and N/m; footing, t and N/m.
const MASS_KG: [f64; 2] = [20e3, 15e3];
const STIFFNESS: [f64; 2] = [2.2e7, 1.5e7];
const FOOTING_KG: f64 = 25e3;
const GROUND: f64 = 8e7;
/// N s/m: 0.08 of critical for all masses on the ground spring.
const GROUND_DAMPING: f64 = 3.5e5;
/// Samples of the computed forces and motion per sample of the record.
const FINER: usize = 4;
const RATE_HZ: f64 = 100.0;

/// A simulated two-storey frame on a footing in soft ground, and its excitation: 20 and 15 t on 22 and 15 MN/m, a footing of 25 t on 80
/// MN/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeOnGround {
    /// Seed of its random forces and noise.
    pub seed: u64,
    /// Duration, s.
    pub duration_s: f64,
    /// Largest root mean square force of the waves on the footing, kN.
    pub waves_kn: f64,
    /// Duration of strong waves, which start at a tenth of the record, s; `None`: always strong.
    pub quake_s: Option<f64>,
    /// Root mean square force of the wind on each storey, kN.
    pub wind_kn: f64,
    /// Noise of every sensor relative to its motion.
    pub noise: f64,
}

impl MadeOnGround {
    /// Damping ratio of both modes on a fixed base.
    pub const DAMPING: f64 = 0.02;

    /// Frequencies on a fixed base, Hz, in closed form.
    pub fn held_hz() -> [f64; 2] {
        let ([m1, m2], [k1, k2]) = (MASS_KG, STIFFNESS);
        let (a, b) = ((k1 + k2) / m1, k2 / m2);
        let (sum, product) = (a + b, a * b - k2 * k2 / (m1 * m2));
        let root = (sum * sum - 4.0 * product).sqrt();
        [sum - root, sum + root].map(|twice| (0.5 * twice).sqrt() / TAU)
    }

    /// Acceleration of floor and roof over that of the ground, in closed form.
    ///
    /// ```text
    /// H = 1 + ω² (K − ω² M + iω C)⁻¹ M 1
    /// ```
    pub fn response(frequency_hz: f64) -> [Complex64; 2] {
        let omega = TAU * frequency_hz;
        let ([m1, m2], [k1, k2]) = (MASS_KG, STIFFNESS);
        let [a, b] = of_mass_and_stiffness();
        let spring = Complex64::new(1.0, omega * b); // K + iω b K
        let mass = Complex64::new(omega * omega, -omega * a); // ω² M − iω a M
        let d11 = spring * (k1 + k2) - mass * m1;
        let d12 = -spring * k2;
        let d22 = spring * k2 - mass * m2;
        let det = d11 * d22 - d12 * d12;
        let square = omega * omega;
        [
            Complex64::ONE + square * (d22 * m1 - d12 * m2) / det,
            Complex64::ONE + square * (d11 * m2 - d12 * m1) / det,
        ]
    }

    /// Channels "ground", "floor", "roof": absolute accelerations, m/s², at 100 Hz.
    ///
    /// # Errors
    /// [`SignalError`] of a record that is too short for its filter.
    pub fn make(&self) -> Result<Record, SignalError> {
        let rate_hz = RATE_HZ * FINER as f64;
        let steps = (self.duration_s * rate_hz) as usize;
        let forces = self.forces(steps, rate_hz)?;
        let mut state = [[0.0; 3]; 2];
        let mut samples: [Vec<f64>; 3] = Default::default();
        for step in 0..steps - 1 {
            let [now, next] = [step, step + 1].map(|at| [forces[0][at], forces[1][at], forces[2][at]]);
            if step % FINER == 0 {
                let a = acceleration(&state, now);
                for (samples, a) in samples.iter_mut().zip([a[0], a[0] + a[1], a[0] + a[2]]) {
                    samples.push(a);
                }
            }
            runge_kutta(&mut state, (now, next), 1.0 / rate_hz);
        }
        let mut random = Random::new(self.seed, 9);
        for of in &mut samples {
            let power = of.iter().map(|x| x * x).sum::<f64>() / of.len() as f64;
            of.iter_mut()
                .for_each(|x| *x += self.noise * power.sqrt() * random.normal());
        }
        let channel = |name: &str| Channel {
            quantity: Quantity::Acceleration,
            direction: Some([1.0, 0.0, 0.0]),
            ..Channel::named(name)
        };
        Record::new(
            ["ground", "floor", "roof"].map(channel).to_vec(),
            samples.to_vec(),
            RATE_HZ,
        )
    }

    /// Smooth forces on the footing and the two storeys, N.
    fn forces(&self, steps: usize, rate_hz: f64) -> Result<Vec<Vec<f64>>, SignalError> {
        const CORNER_HZ: f64 = 15.0;
        let strong = |step: usize| {
            let t = step as f64 / rate_hz - 0.1 * self.duration_s;
            match self.quake_s {
                None => 1.0,
                Some(lasts) if (0.0..lasts).contains(&t) => (PI * t / lasts).sin().powi(2) + 0.002,
                Some(_) => 0.002,
            }
        };
        let noise = |source: u64| -> Vec<f64> {
            let mut random = Random::new(self.seed, source);
            (0..steps).map(|_| random.normal()).collect()
        };
        let names = ["waves", "wind low", "wind high"].map(Channel::named).to_vec();
        let white = Record::new(names, (0..3).map(noise).collect(), rate_hz)?;
        let smooth = low_pass(white, CORNER_HZ, 4)?;
        let unit = (rate_hz / (2.0 * CORNER_HZ)).sqrt() * 1e3;
        let waves = smooth.samples(0).iter().enumerate();
        let waves = waves
            .map(|(step, x)| self.waves_kn * unit * strong(step) * x)
            .collect();
        let wind = |of: usize| -> Vec<f64> {
            smooth
                .samples(of)
                .iter()
                .map(|x| self.wind_kn * unit * x)
                .collect()
        };
        Ok(vec![waves, wind(1), wind(2)])
    }
}

/// One mass on a spring above a ground that moves at random, whose spectrum falls with the frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeOneMass {
    /// Seed of its ground and noise.
    pub seed: u64,
    /// Frequency on the fixed ground, Hz.
    pub frequency_hz: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
    /// Duration, s.
    pub duration_s: f64,
    /// Noise of both sensors over their motion.
    pub noise: f64,
}

impl MadeOneMass {
    /// Channels "ground" and "mass": absolute accelerations at 100 Hz, exact for a ground acceleration that is constant over each sample.
    ///
    /// # Errors
    /// [`SignalError`] of a record without samples.
    pub fn make(&self) -> Result<Record, SignalError> {
        const COLOUR: f64 = 0.9; // of the sample before
        let mode = MadeMode {
            frequency_hz: self.frequency_hz,
            damping_ratio: self.damping_ratio,
            shape: vec![1.0],
        };
        let mut random = Random::new(self.seed, 0);
        let mut last = 0.0;
        let ground: Vec<f64> = (0..(self.duration_s * RATE_HZ) as usize)
            .map(|_| {
                last = COLOUR * last + random.normal();
                last
            })
            .collect();
        let own = Oscillator::new(&mode, RATE_HZ, Quantity::Acceleration);
        let relative = own.driven(ground.iter().map(|a| -a));
        let mass: Vec<f64> = relative.zip(&ground).map(|(x, a)| x + a).collect();
        let noisy = |mut of: Vec<f64>| {
            let power = of.iter().map(|x| x * x).sum::<f64>() / of.len() as f64;
            of.iter_mut()
                .for_each(|x| *x += self.noise * power.sqrt() * random.normal());
            of
        };
        let samples = [ground, mass].map(noisy).to_vec();
        Record::new(["ground", "mass"].map(Channel::named).to_vec(), samples, RATE_HZ)
    }
}

/// Acceleration of the footing, and of the storeys relative to it, m/s².
///
/// ```text
/// m_i (x_i'' + u'') + (C x')_i + (K x)_i = w_i;   m_f u'' + c_g u' + k_g u = F + shear of the first storey
/// ```
/// C gives equal damping ratios on a fixed base: C = a M + b K with 2 ζ ω = a + b ω² for both modes.
fn acceleration([x, v]: &[[f64; 3]; 2], [waves, w1, w2]: [f64; 3]) -> [f64; 3] {
    let [a, b] = of_mass_and_stiffness();
    let ([m1, m2], [k1, k2]) = (MASS_KG, STIFFNESS);
    let [r1, r2] = [x[1] + b * v[1], x[2] + b * v[2]];
    let on_1 = w1 - (k1 + k2) * r1 + k2 * r2 - a * m1 * v[1];
    let on_2 = w2 + k2 * r1 - k2 * r2 - a * m2 * v[2];
    // the mass-proportional part also acts on the footing, so that the internal forces of the frame are in equilibrium
    let shear = k1 * r1 + a * (m1 * v[1] + m2 * v[2]);
    let u = (waves + shear - GROUND * x[0] - GROUND_DAMPING * v[0]) / FOOTING_KG;
    [u, on_1 / m1 - u, on_2 / m2 - u]
}

/// a, 1/s, and b, s.
fn of_mass_and_stiffness() -> [f64; 2] {
    let [f1, f2] = MadeOnGround::held_hz().map(|f| TAU * f);
    let twice = 2.0 * MadeOnGround::DAMPING / (f1 + f2);
    [twice * f1 * f2, twice]
}

fn runge_kutta(state: &mut [[f64; 3]; 2], (now, next): ([f64; 3], [f64; 3]), step_s: f64) {
    let middle = std::array::from_fn(|i| 0.5 * (now[i] + next[i]));
    let [x, v] = *state;
    let moved =
        |of: [f64; 3], by: [f64; 3], h: f64| -> [f64; 3] { std::array::from_fn(|i| of[i] + h * by[i]) };
    let half = 0.5 * step_s;
    let a1 = acceleration(state, now);
    let v2 = moved(v, a1, half);
    let a2 = acceleration(&[moved(x, v, half), v2], middle);
    let v3 = moved(v, a2, half);
    let a3 = acceleration(&[moved(x, v2, half), v3], middle);
    let v4 = moved(v, a3, step_s);
    let a4 = acceleration(&[moved(x, v3, step_s), v4], next);
    let mean = |a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0)
    };
    *state = [
        moved(x, mean(v, v2, v3, v4), step_s),
        moved(v, mean(a1, a2, a3, a4), step_s),
    ];
}
