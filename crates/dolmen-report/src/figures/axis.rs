//! Axes: range, ticks at round numbers, and the name with its unit.

use super::words::{Axes, say};
use dolmen_words::{Language, number};

/// Axes of fewer decades have grid lines at all multiples 1 to 9 and labels at 1, 2, 5. Our choice.
const DECADES_OF_DENSE_TICKS: f64 = 3.2;

/// Smallest number of ticks, if at least that many are requested: a single tick shows no scale.
const TICKS_LEAST: i64 = 2;

/// Fractions of the span kept free at both ends of an axis.
const FREE_SHARE: f64 = 0.04;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    Linear,
    Logarithmic,
}

/// A tick; without a text it is only a grid line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    pub(crate) text: String,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    /// Name with unit: "Frequency (Hz)".
    pub(crate) name: String,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) scale: Scale,
    pub(crate) ticks: Vec<Tick>,
    pub(crate) grid: bool,
}

impl Axis {
    /// A linear axis over exactly this range, with about `wanted` ticks.
    pub(crate) fn linear(name: impl Into<String>, from: f64, to: f64, wanted: usize) -> Self {
        let (from, to) = proper(from, to);
        let rough = (to - from) / wanted.max(1) as f64;
        let power = 10f64.powf(rough.log10().floor());
        let steps = [10.0, 5.0, 2.0, 1.0].map(|s| s * power);
        let ends = |step: f64| {
            let first = (from / step - 1e-9).ceil() as i64;
            (first, (to / step + 1e-9).floor() as i64)
        };
        // the finest step of at least the requested spacing; if it gives fewer than two ticks, the next finer step
        let coarse = steps.iter().rposition(|s| *s >= rough * 0.999).unwrap_or(0);
        let finer = (coarse..steps.len()).find(|i| {
            let (first, last) = ends(steps[*i]);
            last - first + 1 >= TICKS_LEAST.min(wanted as i64)
        });
        let step = steps[finer.unwrap_or(coarse)];
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        let (first, last) = ends(step);
        let tick = |i: i64| Tick {
            at: i as f64 * step,
            text: number::fixed(i as f64 * step, decimals),
        };
        Axis {
            name: name.into(),
            from,
            to,
            scale: Scale::Linear,
            ticks: (first..=last).map(tick).collect(),
            grid: true,
        }
    }

    /// A linear axis around these values, with some space at both ends.
    pub(crate) fn around(name: impl Into<String>, values: &[f64], wanted: usize) -> Self {
        let (least, most) = bounds(values);
        let room = FREE_SHARE * (most - least).max(1e-9 * most.abs()).max(f64::MIN_POSITIVE);
        Self::linear(name, least - room, most + room, wanted)
    }

    /// A logarithmic axis around these values; those that are not positive are left out.
    pub(crate) fn logarithmic(name: impl Into<String>, values: &[f64], language: Language) -> Self {
        let positive: Vec<f64> = values.iter().copied().filter(|v| *v > 0.0).collect();
        let (least, most) = bounds(&positive);
        let (least, most) = if least > 0.0 { (least, most) } else { (0.1, 10.0) };
        let room = (most / least).powf(FREE_SHARE).max(1.25);
        let (from, to) = (least / room, most * room);
        let decades = (to / from).log10();
        let named: &[u32] = match decades {
            d if d < 1.2 => &[1, 2, 3, 4, 5, 7],
            d if d < DECADES_OF_DENSE_TICKS => &[1, 2, 5],
            _ => &[1],
        };
        let mut ticks = Vec::new();
        for power in from.log10().floor() as i32..=to.log10().ceil() as i32 {
            for multiple in 1..10 {
                let at = f64::from(multiple) * 10f64.powi(power);
                if !(from..=to).contains(&at) {
                    continue;
                }
                let text = if named.contains(&multiple) {
                    let decimals = (-power).clamp(0, 12) as usize;
                    number::fixed(at, decimals)
                } else {
                    String::new()
                };
                if !text.is_empty() || decades < DECADES_OF_DENSE_TICKS {
                    ticks.push(Tick { at, text });
                }
            }
        }
        Axis {
            name: say(Axes::Logarithmic { name: name.into() }, language),
            from,
            to,
            scale: Scale::Logarithmic,
            ticks,
            grid: true,
        }
    }

    /// One row per name, at 0, 1, 2 … upwards.
    pub(crate) fn rows(names: &[String]) -> Self {
        let tick = |(i, text): (usize, &String)| Tick {
            at: i as f64,
            text: text.clone(),
        };
        Axis {
            name: String::new(),
            from: -0.6,
            to: names.len() as f64 - 0.4,
            scale: Scale::Linear,
            ticks: names.iter().enumerate().map(tick).collect(),
            grid: false,
        }
    }

    /// Position of a value on the axis, 0 to 1 within its range.
    fn share(&self, value: f64) -> f64 {
        let share = match self.scale {
            Scale::Linear => (value - self.from) / (self.to - self.from),
            Scale::Logarithmic => (value / self.from).ln() / (self.to / self.from).ln(),
        };
        if share.is_nan() {
            0.0
        } else {
            share.clamp(0.0, 1.0)
        }
    }

    /// Position of a value between two ends, px; a value beyond the axis is at its end.
    pub(crate) fn px(&self, value: f64, [start, end]: [f64; 2]) -> f64 {
        start + (end - start) * self.share(value)
    }
}

/// Smallest and largest finite value; 0 and 0 if there is none.
fn bounds(values: &[f64]) -> (f64, f64) {
    let finite = values.iter().copied().filter(|v| v.is_finite());
    let (least, most) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    });
    if least <= most { (least, most) } else { (0.0, 0.0) }
}

/// A range of nonzero length.
fn proper(from: f64, to: f64) -> (f64, f64) {
    if from.is_finite() && to.is_finite() && to > from {
        return (from, to);
    }
    let middle = if from.is_finite() { from } else { 0.0 };
    (middle - 1.0, middle + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks
            .iter()
            .map(|t| t.text.as_str())
            .filter(|t| !t.is_empty())
            .collect()
    }

    #[test]
    fn exact_linear_ticks_are_round() {
        assert_eq!(
            texts(&Axis::linear("", 0.0, 1.0, 5)),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        );
        assert_eq!(
            texts(&Axis::linear("", -12.0, 7.0, 4)),
            ["\u{2212}10", "\u{2212}5", "0", "5"]
        );
    }

    #[test]
    fn exact_logarithmic_ticks_name_powers() {
        assert_eq!(
            texts(&Axis::logarithmic("", &[1.9, 739.0], Language::English)),
            ["2", "5", "10", "20", "50", "100", "200", "500"]
        );
        assert_eq!(
            texts(&Axis::logarithmic("", &[1e-3, 1e3], Language::English)),
            ["0.001", "0.01", "0.1", "1", "10", "100", "1000"]
        );
    }

    #[test]
    fn holds_axes_of_nothing_or_of_one_value_can_be_drawn() {
        for axis in [
            Axis::around("", &[], 5),
            Axis::linear("", 3.0, 3.0, 5),
            Axis::around("", &[3.0], 5),
            Axis::logarithmic("", &[f64::NAN], Language::English),
        ] {
            assert!(axis.to > axis.from, "{axis:?}");
            assert_eq!(axis.px(axis.to, [0.0, 100.0]), 100.0);
        }
    }
}
