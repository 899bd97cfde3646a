//! A mode that the clipping of a channel creates, and the frequencies that it comes from.

use crate::modal::Mode;

/// A mode that the clipping of a channel creates: its frequency is a sum or difference of those of the structure.
#[derive(Clone, Debug, PartialEq)]
pub struct FromClipping {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// The clipped channel.
    pub channel: String,
    /// Share of the power there, without what other channels explain, that clipping explains, 0 to 1.
    pub share: f64,
    /// The frequencies, Hz, that add up to this one, with their factors; empty if unknown.
    pub terms: Vec<(i32, f64)>,
}

/// Factors of one frequency, and of two, in the order in which they are tried.
const OF_ONE: [i32; 3] = [1, 3, 2];
const OF_TWO: [[i32; 2]; 5] = [[2, 1], [2, -1], [1, -2], [1, 1], [1, -1]];
/// Largest relative distance of a mode from the sum, unless the modes are wider. Our choice.
const NEAR: f64 = 0.01;

/// The simplest sum or difference of the frequencies of other modes that is near this mode; empty if there is none.
pub(super) fn terms_of(mode: &Mode, others: &[Mode]) -> Vec<(i32, f64)> {
    let width_hz = |of: &Mode| of.damping_ratio.unwrap_or(0.0) * of.frequency_hz;
    let is_near = |terms: &Vec<(i32, &Mode)>| {
        let sum_hz: f64 = terms.iter().map(|(n, of)| f64::from(*n) * of.frequency_hz).sum();
        let width_hz: f64 = terms
            .iter()
            .map(|(n, of)| f64::from(n.abs()) * width_hz(of))
            .sum();
        (sum_hz - mode.frequency_hz).abs() <= width_hz.max(NEAR * mode.frequency_hz)
    };
    let of_one = |n: i32| others.iter().map(move |a| vec![(n, a)]);
    let of_two = |[m, n]: [i32; 2]| {
        let pairs = others.iter().flat_map(|a| others.iter().map(move |b| [a, b]));
        pairs
            .filter(|[a, b]| a.frequency_hz != b.frequency_hz)
            .map(move |[a, b]| vec![(m, a), (n, b)])
    };
    let mut all = OF_ONE
        .into_iter()
        .flat_map(of_one)
        .chain(OF_TWO.into_iter().flat_map(of_two));
    let found = all.find(is_near).unwrap_or_default();
    found.into_iter().map(|(n, of)| (n, of.frequency_hz)).collect()
}

impl std::fmt::Display for FromClipping {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3} Hz", self.frequency_hz)?;
        let mut sign = " = ";
        for (n, hz) in &self.terms {
            if *n < 0 {
                sign = " - ";
            }
            write!(f, "{sign}{} x {hz:.3} Hz", n.abs())?;
            sign = " + ";
        }
        write!(f, " (\"{}\", {:.0} %)", self.channel, 100.0 * self.share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, identify};

    #[test]
    fn exact_terms_of_multiples_sums_and_differences() {
        let made = MadeMode {
            frequency_hz: 3.24,
            damping_ratio: 0.01,
            shape: vec![1.0, 0.5],
        };
        let record = MadeRecord {
            modes: vec![made],
            duration_s: 120.0,
            ..MadeRecord::default()
        };
        let found = identify(&record.make().unwrap(), &Identify::default()).unwrap();
        let at = |frequency_hz: f64| Mode {
            frequency_hz,
            damping_ratio: Some(0.005),
            ..found.modes.modes[0].clone()
        };
        let others = [3.24, 20.41, 57.32].map(at);
        let (a, b) = (3.24, 20.41);
        for (hz, terms) in [
            (9.737, vec![(3, a)]),
            (3.25, vec![(1, a)]),
            (13.922, vec![(1, b), (-2, a)]),
            (26.91, vec![(1, b), (2, a)]),
            (37.6, vec![(2, b), (-1, a)]),
            (5.0, vec![]),
        ] {
            let mut found = terms_of(&at(hz), &others);
            found.sort_by(|x, y| y.1.total_cmp(&x.1));
            assert_eq!(found, terms, "{hz}");
        }
    }
}
