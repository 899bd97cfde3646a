//! Compares the stiffness from a survey with that of the project file.

use serde::Serialize;

/// Number of standard deviations within which both are equal. As for measured frequencies.
const DEVIATIONS_MOST: f64 = 3.0;
/// Smallest relative difference that is reported, also if no deviation is known. Our choice.
const RATIO_LEAST: f64 = 1.05;
const RATIO_ALONE: f64 = 1.2;

/// Ratio of the identified stiffness to that of the file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BesideFile {
    /// Ratio of each spring, lowest first, or of k_x, k_y, k_θ.
    pub ratios: Vec<f64>,
    /// Their differences in combined standard deviations; `None` if none is known.
    pub deviations: Option<Vec<f64>>,
    /// Whether they differ beyond scatter.
    pub differs: bool,
    /// Whether the file marks all its values as assumed.
    pub is_assumed: bool,
}

impl BesideFile {
    /// Index of the spring with the largest relative difference, among those that differ beyond scatter.
    pub fn farthest(&self) -> Option<usize> {
        let deviations = |at: usize| self.deviations.as_ref().map(|all| all[at]);
        let apart = |at: &usize| self.ratios[*at].ln().abs();
        let all = (0..self.ratios.len()).filter(|&at| is_off(self.ratios[at], deviations(at)));
        all.max_by(|a, b| apart(a).total_cmp(&apart(b)))
    }
}

/// Whether a spring differs beyond scatter.
fn is_off(ratio: f64, deviations: Option<f64>) -> bool {
    let is_beyond = |most: f64| {
        let apart = ratio.ln().abs();
        apart > most.ln() || apart.is_nan()
    };
    match deviations {
        Some(sd) => is_beyond(RATIO_LEAST) && sd > DEVIATIONS_MOST,
        None => is_beyond(RATIO_ALONE),
    }
}

/// A stiffness and its standard deviation, 0 if unknown.
#[derive(Clone, Copy)]
pub(crate) struct KnownStiffness {
    pub(crate) value: f64,
    pub(crate) sd: f64,
}

/// Compares the stiffness found with that of the file.
pub(crate) fn beside(
    found: &[KnownStiffness],
    file: &[KnownStiffness],
    is_assumed: bool,
) -> Option<BesideFile> {
    if found.len() != file.len() || found.is_empty() {
        return None;
    }
    let both = || found.iter().zip(file);
    let ratios: Vec<f64> = both().map(|(a, b)| a.value / b.value).collect();
    let deviation = |(a, b): (&KnownStiffness, &KnownStiffness)| {
        let sd = a.sd.hypot(b.sd);
        (a.sd > 0.0).then(|| (a.value - b.value).abs() / sd)
    };
    let deviations: Option<Vec<f64>> = both().map(deviation).collect();
    let is_off = |(at, ratio): (usize, &f64)| {
        let deviations = deviations.as_ref().map(|all| all[at]);
        is_off(*ratio, deviations)
    };
    let differs = ratios.iter().enumerate().any(is_off);
    Some(BesideFile {
        ratios,
        deviations,
        differs,
        is_assumed,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(values: &[f64], sd: f64) -> Vec<KnownStiffness> {
        values
            .iter()
            .map(|value| KnownStiffness { value: *value, sd })
            .collect()
    }

    #[test]
    fn exact_a_ratio_is_told_in_deviations_of_both_and_scatter_is_none() {
        let found = beside(&all(&[33.0, 18.0], 0.3), &all(&[30.0, 18.0], 0.4), false).unwrap();
        assert!((found.ratios[0] - 1.1).abs() < 1e-12);
        // 3 over √(0.3² + 0.4²)
        assert!((found.deviations.as_ref().unwrap()[0] - 6.0).abs() < 1e-12 && found.differs);
        let rough = beside(&all(&[33.0], 1.0), &all(&[30.0], 1.0), false).unwrap();
        assert!(!rough.differs, "{rough:?}");
        let near = beside(&all(&[30.9], 0.1), &all(&[30.0], 0.0), false).unwrap();
        assert!(!near.differs, "3 % are no news: {near:?}");
        // of a spring 2 % off by ten deviations, one 10 % off by six and one 30 % off by two, the second differs most
        let far = beside(
            &[(30.6, 0.06), (33.0, 0.5), (39.0, 4.5)].map(|(value, sd)| KnownStiffness { value, sd }),
            &all(&[30.0; 3], 0.0),
            false,
        );
        assert_eq!(far.unwrap().farthest(), Some(1));
        assert!(
            beside(&all(&[40.0], 0.0), &all(&[30.0], 0.0), false)
                .unwrap()
                .differs
        );
    }
}
