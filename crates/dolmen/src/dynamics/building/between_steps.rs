//! Peaks between the steps of a run.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r | `row` | a value as a row of the state: r s |
//! | p, v, w | | value, rate and second rate at a step: r s, r A s + r B a, r A² s + r A B a + r B a′ |

use super::building_peaks::Peak;
use super::stepping::{Ground, Stepping, states_at};

/// The states at selected steps and their neighbours, for interpolation between them.
pub(super) struct BetweenSteps<'a, S> {
    stepping: &'a S,
    ground: &'a dyn Fn(usize) -> Ground,
    steps: usize,
    h: f64,
    wanted: Vec<usize>,
    states: Vec<Vec<f64>>,
}

impl<'a, S: Stepping> BetweenSteps<'a, S> {
    /// Interpolation around the steps `around` of a run of `steps` steps of `h` seconds, which starts at rest. `starts` are the states at
    /// the beginnings of blocks.
    pub(super) fn new(
        stepping: &'a S,
        (steps, h): (usize, f64),
        ground: &'a dyn Fn(usize) -> Ground,
        starts: &[Vec<f64>],
        around: impl Iterator<Item = usize>,
    ) -> Self {
        let mut wanted: Vec<usize> = around
            .flat_map(|step| step.saturating_sub(1)..=(step + 1).min(steps - 1))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        BetweenSteps {
            states: states_at(stepping, starts, &wanted, ground),
            stepping,
            ground,
            steps,
            h,
            wanted,
        }
    }

    /// The steps that begin before and after `step`.
    fn sides(&self, step: usize) -> impl Iterator<Item = usize> {
        let sides = [step.checked_sub(1), (step + 1 < self.steps).then_some(step)];
        sides.into_iter().flatten()
    }

    /// Value, first and second rate of rows at both ends of the step that begins at `from`.
    fn ends<const N: usize>(&self, of: &[Rates<'_>; N], from: usize) -> Option<[[[f64; 3]; 2]; N]> {
        let at = |step: usize| self.wanted.binary_search(&step).ok();
        let (a, b) = (&self.states[at(from)?], &self.states[at(from + 1)?]);
        let ground = (self.ground)(from);
        Some(
            of.each_ref()
                .map(|of| [of.at(a, ground, 0, self.h), of.at(b, ground, 1, self.h)]),
        )
    }

    /// The peak of a value near the step where it is largest.
    pub(super) fn top(&self, row: &[f64], (value, step): (f64, usize)) -> Peak {
        let there = Peak {
            value,
            at_s: step as f64 * self.h,
        };
        if value == 0.0 {
            return there;
        }
        let of = [Rates::new(row, self.stepping)];
        let inside = |from: usize| -> Option<Peak> {
            let [ends] = self.ends(&of, from)?;
            let (part, value) = top(ends)?;
            Some(Peak {
                value,
                at_s: (from as f64 + part) * self.h,
            })
        };
        let tops = self.sides(step).filter_map(inside);
        tops.fold(there, |best, next| {
            if next.value.abs() > best.value.abs() {
                next
            } else {
                best
            }
        })
    }

    /// The longest vector of two values near the step where it is longest: the values, and the time, s.
    pub(super) fn longest(&self, rows: [&[f64]; 2], (value, step): ([f64; 2], usize)) -> ([f64; 2], f64) {
        let there = (value, step as f64 * self.h);
        if value == [0.0; 2] {
            return there;
        }
        let of = rows.map(|row| Rates::new(row, self.stepping));
        let inside = |from: usize| -> Option<([f64; 2], f64)> {
            let (part, value) = longest(self.ends(&of, from)?)?;
            Some((value, (from as f64 + part) * self.h))
        };
        let length = |(of, _): &([f64; 2], f64)| of[0].hypot(of[1]);
        let tops = self.sides(step).filter_map(inside);
        tops.fold(
            there,
            |best, next| {
                if length(&next) > length(&best) { next } else { best }
            },
        )
    }
}

/// A value, its rate and its second rate as rows of the state.
struct Rates<'a> {
    row: &'a [f64],
    first: Vec<f64>,
    second: Vec<f64>,
    ground: [[f64; 2]; 2],
}

impl<'a> Rates<'a> {
    fn new(row: &'a [f64], stepping: &impl Stepping) -> Self {
        let first = stepping.rate_row(row);
        Rates {
            row,
            ground: [stepping.ground_of_row(row), stepping.ground_of_row(&first)],
            second: stepping.rate_row(&first),
            first,
        }
    }

    /// Value, rate × h and second rate × h² at the beginning (0) or the end (1) of a step.
    fn at(&self, state: &[f64], ground: Ground, end: usize, h: f64) -> [f64; 3] {
        let dot = |row: &[f64]| -> f64 { row.iter().zip(state).map(|(r, s)| r * s).sum() };
        let [now, then] = &self.ground;
        let sum = |of: &dyn Fn(usize) -> f64| -> f64 { of(0) + of(1) };
        let rate = dot(&self.first) + sum(&|axis| now[axis] * ground[axis][end]);
        let change = |axis: usize| (ground[axis][1] - ground[axis][0]) / h;
        let bend = dot(&self.second) + sum(&|axis| then[axis] * ground[axis][end] + now[axis] * change(axis));
        [dot(self.row), rate * h, bend * h * h]
    }
}

/// The polynomial of degree five with the given value, first and second rate at both ends of a step.
fn quintic([a, b]: [[f64; 3]; 2]) -> [f64; 6] {
    let (rise, slopes) = (b[0] - a[0] - a[1] - 0.5 * a[2], b[1] - a[1] - a[2]);
    let bends = b[2] - a[2];
    [
        a[0],
        a[1],
        0.5 * a[2],
        10.0 * rise - 4.0 * slopes + 0.5 * bends,
        -15.0 * rise + 7.0 * slopes - bends,
        6.0 * rise - 3.0 * slopes + 0.5 * bends,
    ]
}

fn value(c: &[f64; 6], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

fn slope(c: &[f64; 6], t: f64) -> f64 {
    (1..6).rev().fold(0.0, |sum, i| sum * t + i as f64 * c[i])
}

/// The point at which `rising` becomes false; it is true at the beginning of the step and false at its end.
fn turn(rising: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if rising(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The peak within a step, from value, first and second rate at both ends (in steps): the fraction of the step and the value there; `None`
/// without a peak inside.
fn top([a, b]: [[f64; 3]; 2]) -> Option<(f64, f64)> {
    if a[1] * b[1] >= 0.0 {
        return None; // it continues to rise or fall
    }
    let c = quintic([a, b]);
    let at = turn(|t| slope(&c, t) * a[1] > 0.0);
    Some((at, value(&c, at)))
}

/// The longest vector of two values within a step, as in [`top`].
fn longest(ends: [[[f64; 3]; 2]; 2]) -> Option<(f64, [f64; 2])> {
    let of = ends.map(quintic);
    let at = |t: f64| of.map(|c| value(&c, t));
    // half the rate of the squared length
    let rate = |t: f64| -> f64 { of.iter().map(|c| value(c, t) * slope(c, t)).sum() };
    if !(rate(0.0) > 0.0 && rate(1.0) < 0.0) {
        return None;
    }
    let part = turn(|t| rate(t) > 0.0);
    Some((part, at(part)))
}

/// Number of halvings of a step to find its peak: the value is flat there, so 1e-8 of a step changes it only by round-off.
const HALVINGS: usize = 26;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_top_of_a_wave_between_two_steps() {
        // cos(0.6 (t − 0.3)), ten steps a period
        let at = |t: f64| {
            let x: f64 = 0.6 * (t - 0.3);
            [x.cos(), -0.6 * x.sin(), -0.36 * x.cos()]
        };
        let (part, value) = top([at(0.0), at(1.0)]).unwrap();
        assert!(
            (part - 0.3).abs() < 1e-5 && (value - 1.0).abs() < 2e-6,
            "{part} {value}"
        );
        // quintic: itself
        let of = |t: f64| [t - t.powi(5), 1.0 - 5.0 * t.powi(4), -20.0 * t.powi(3)];
        let (part, value) = top([of(0.0), of(1.0)]).unwrap();
        let expected = 0.2_f64.powf(0.25);
        assert!((part - expected).abs() < 1e-7 && (value - of(expected)[0]).abs() < 1e-15);
        assert!(top([of(0.0), of(0.5)]).is_none(), "it rises throughout");
    }

    #[test]
    fn exact_longest_vector_between_two_steps() {
        // half the rate of the squared length: −(3 − t) + 4 (1 + 4 t (1 − t)) (1 − 2 t)
        let x = |t: f64| [3.0 - t, -1.0, 0.0];
        let y = |t: f64| [1.0 + 4.0 * t * (1.0 - t), 4.0 - 8.0 * t, -8.0];
        let (part, [x_there, y_there]) = longest([[x(0.0), x(1.0)], [y(0.0), y(1.0)]]).unwrap();
        let rate = -x_there + 4.0 * y_there * (1.0 - 2.0 * part);
        assert!(rate.abs() < 1e-6, "{part}: {rate}");
        assert!((x_there - x(part)[0]).abs() < 1e-14 && (y_there - y(part)[0]).abs() < 1e-14);
        assert!(
            longest([[x(0.0), x(1.0)], [[0.0; 3]; 2]]).is_none(),
            "it shrinks throughout"
        );
    }
}
