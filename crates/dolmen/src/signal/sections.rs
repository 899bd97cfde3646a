//! Second-order sections: designed from an analogue prototype and run in place, forwards and backwards, over a channel.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | n | `order` | order of the low-pass prototype |
//! | p | `p` | pole of the prototype (corner at 1 rad/s) |
//! | Ω | `omega` | corner of the analogue filter, warped so that the digital filter has the requested corner: 2 f_s tan(π f / f_s) |
//! | z | `z` | pole of the digital filter |
//! | b, a | `b`, `a` | y_i = b0 x_i + b1 x_(i-1) + b2 x_(i-2) - a1 y_(i-1) - a2 y_(i-2) |

use num_complex::Complex64;
use std::f64::consts::PI;

/// Fraction of a transient that may remain at the beginning of the record. The steady start and the odd reflection already reduce this end
/// effect. Our choice.
const TRANSIENT_LEFT: f64 = 0.01;

/// The analogue low-pass prototype of a digital filter. Its corner is 1 rad/s.
#[derive(Clone, Copy, Debug)]
pub(super) enum Prototype {
    /// Maximally flat at 0 Hz; gain 1/√2 at the corner.
    Butterworth,
    /// Type I: ripples of `ripple_db` below gain 1 up to the corner, then a steeper slope.
    Chebyshev {
        /// Depth of the ripple, dB.
        ripple_db: f64,
    },
}

impl Prototype {
    /// Poles with an imaginary part that is positive or zero; the others are their conjugates.
    fn poles(self, order: usize) -> Vec<Complex64> {
        let (across, along) = match self {
            Prototype::Butterworth => (1.0, 1.0),
            Prototype::Chebyshev { ripple_db } => {
                let epsilon = (10f64.powf(ripple_db / 10.0) - 1.0).sqrt();
                let mu = (1.0 / epsilon).asinh() / order as f64;
                (mu.sinh(), mu.cosh())
            }
        };
        (0..order.div_ceil(2))
            .map(|k| {
                if 2 * k + 1 == order {
                    return Complex64::new(-across, 0.0);
                }
                let theta = PI * (2 * k + 1) as f64 / (2 * order) as f64;
                Complex64::new(-across * theta.sin(), along * theta.cos())
            })
            .collect()
    }

    /// Gain at 0 rad/s: an even Chebyshev filter starts at the bottom of its ripple.
    fn gain_at_rest(self, order: usize) -> f64 {
        match self {
            Prototype::Chebyshev { ripple_db } if order.is_multiple_of(2) => 10f64.powf(-ripple_db / 20.0),
            _ => 1.0,
        }
    }
}

/// One section with its two states (transposed direct form II).
#[derive(Clone, Copy, Debug)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
    state: [f64; 2],
}

impl Section {
    fn step(&mut self, x: f64) -> f64 {
        let y = self.b[0] * x + self.state[0];
        self.state[0] = self.b[1] * x - self.a[0] * y + self.state[1];
        self.state[1] = self.b[2] * x - self.a[1] * y;
        y
    }

    /// Sets the states to the steady state of a constant input `x`; returns the constant output.
    fn settle(&mut self, x: f64) -> f64 {
        let y = x * (self.b[0] + self.b[1] + self.b[2]) / (1.0 + self.a[0] + self.a[1]);
        self.state[1] = self.b[2] * x - self.a[1] * y;
        self.state[0] = self.b[1] * x - self.a[0] * y + self.state[1];
        y
    }
}

/// A digital filter as a chain of second-order sections.
#[derive(Clone, Debug)]
pub(super) struct Sections {
    sections: Vec<Section>,
    /// Number of samples until a transient has decayed to [`TRANSIENT_LEFT`].
    pub(super) ringing: usize,
}

impl Sections {
    /// Low-pass with its corner at `corner`, in cycles per sample, 0 to 1/2.
    pub(super) fn low_pass(prototype: Prototype, order: usize, corner: f64) -> Self {
        let omega = warped(corner);
        let mut slowest = 0.0_f64;
        let mut sections: Vec<Section> = prototype
            .poles(order)
            .into_iter()
            .map(|p| {
                let z = bilinear(p * omega);
                slowest = slowest.max(z.norm());
                if p.im == 0.0 {
                    // (1 + 1/z) / (1 - p/z), gain 1 at z = 1
                    let gain = 0.5 * (1.0 - z.re);
                    Section {
                        b: [gain, gain, 0.0],
                        a: [-z.re, 0.0],
                        state: [0.0; 2],
                    }
                } else {
                    let a = [-2.0 * z.re, z.norm_sqr()];
                    let gain = 0.25 * (1.0 + a[0] + a[1]);
                    Section {
                        b: [gain, 2.0 * gain, gain],
                        a,
                        state: [0.0; 2],
                    }
                }
            })
            .collect();
        let rest = prototype.gain_at_rest(order);
        sections[0].b = sections[0].b.map(|b| b * rest);
        Sections {
            sections,
            ringing: ringing(slowest),
        }
    }

    /// Butterworth high-pass with its corner at `corner`, in cycles per sample, 0 to 1/2.
    ///
    /// Each pole p of the prototype becomes Ω/p; all zeros go to z = 1.
    pub(super) fn high_pass(order: usize, corner: f64) -> Self {
        let omega = warped(corner);
        let mut slowest = 0.0_f64;
        let sections = Prototype::Butterworth.poles(order).into_iter().map(|p| {
            let z = bilinear(omega / p);
            slowest = slowest.max(z.norm());
            let (b, a) = if p.im == 0.0 {
                let gain = 0.5 * (1.0 + z.re); // 1 at z = −1
                ([gain, -gain, 0.0], [-z.re, 0.0])
            } else {
                let a = [-2.0 * z.re, z.norm_sqr()];
                let gain = 0.25 * (1.0 - a[0] + a[1]);
                ([gain, -2.0 * gain, gain], a)
            };
            Section {
                b,
                a,
                state: [0.0; 2],
            }
        });
        let sections = sections.collect();
        Sections {
            sections,
            ringing: ringing(slowest),
        }
    }

    /// Butterworth band-pass between `low` and `high`, in cycles per sample, 0 to 1/2.
    ///
    /// Each pole p of the prototype becomes the two roots of s² - p B s + Ω₀² = 0, with B = Ω_high - Ω_low and
    /// Ω₀² = Ω_low Ω_high; zeros go to z = 1 and z = -1.
    pub(super) fn band_pass(order: usize, low: f64, high: f64) -> Self {
        let (omega_low, omega_high) = (warped(low), warped(high));
        let (width, centre_squared) = (omega_high - omega_low, omega_low * omega_high);
        let centre = Complex64::new(0.0, centre_squared.sqrt());
        let z_centre = (2.0 + centre) / (2.0 - centre);
        let mut slowest = 0.0_f64;
        let mut sections = Vec::with_capacity(order);
        for p in Prototype::Butterworth.poles(order) {
            let half = 0.5 * width * p;
            let root = (half * half - centre_squared).sqrt();
            let (z1, z2) = (bilinear(half + root), bilinear(half - root));
            slowest = slowest.max(z1.norm()).max(z2.norm());
            let pairs = if p.im == 0.0 {
                vec![(z1, z2)] // conjugate, or both real
            } else {
                vec![(z1, z1.conj()), (z2, z2.conj())]
            };
            for (z1, z2) in pairs {
                let a = [-(z1 + z2).re, (z1 * z2).re];
                let inverse = z_centre.inv();
                let raw = (1.0 - inverse * inverse) / (1.0 + a[0] * inverse + a[1] * inverse * inverse);
                let gain = 1.0 / raw.norm();
                sections.push(Section {
                    b: [gain, 0.0, -gain],
                    a,
                    state: [0.0; 2],
                });
            }
        }
        Sections {
            sections,
            ringing: ringing(slowest),
        }
    }

    /// Filters `x` in place, forwards and then backwards: no delay, and the gain is squared.
    ///
    /// The ends are extended by `ringing` samples of odd reflection, 2 x_0 - x_i, and each pass starts from the steady state of its first
    /// sample. Only these extensions need additional memory. `x` needs more than `ringing` samples.
    pub(super) fn forward_backward(&mut self, x: &mut [f64]) {
        let (n, edge) = (x.len(), self.ringing);
        debug_assert!(n > edge, "callers refuse shorter records");
        let (first, last) = (x[0], x[n - 1]);
        let mut after: Vec<f64> = (1..=edge).map(|i| 2.0 * last - x[n - 1 - i]).collect();

        self.settle(2.0 * first - x[edge]);
        for i in (1..=edge).rev() {
            self.step(2.0 * first - x[i]);
        }
        x.iter_mut().for_each(|v| *v = self.step(*v));
        after.iter_mut().for_each(|v| *v = self.step(*v));

        self.settle(after.last().copied().unwrap_or(x[n - 1]));
        for &v in after.iter().rev() {
            self.step(v);
        }
        x.iter_mut().rev().for_each(|v| *v = self.step(*v));
    }

    fn step(&mut self, x: f64) -> f64 {
        self.sections.iter_mut().fold(x, |v, section| section.step(v))
    }

    fn settle(&mut self, x: f64) {
        self.sections.iter_mut().fold(x, |v, section| section.settle(v));
    }
}

/// Analogue frequency that the bilinear transform maps to `frequency` (cycles per sample); the unit of time is one sample.
fn warped(frequency: f64) -> f64 {
    2.0 * (PI * frequency).tan()
}

/// Bilinear transform of a pole, s = 2 (z - 1) / (z + 1).
fn bilinear(s: Complex64) -> Complex64 {
    (2.0 + s) / (2.0 - s)
}

/// Number of samples until a pole of this modulus has decayed to [`TRANSIENT_LEFT`].
fn ringing(slowest: f64) -> usize {
    // if a pole is so near to 1 that its logarithm vanishes, the filter rings longer than any record: the cast saturates
    (TRANSIENT_LEFT.ln() / slowest.ln()).abs().ceil() as usize
}
