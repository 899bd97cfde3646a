//! Lasting change of the modes of a structure, between the parts of a record without an earthquake.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r | `ratio` | frequency after over frequency before, minus 1 |
//! | ν | `degrees_of_freedom` | degrees of freedom of the standard deviation of r |
//! | p | `chance` | probability of such a change by chance |

use super::lasting_change::LastingChange;
use super::mode_pairs::same_modes;
use super::part::Part;
use crate::modal::{ModalAnalysis, Mode};
use crate::numeric::{student_two_sided, welch};

/// Number of standard deviations within which two ratios of one mode agree.
const AGREES: f64 = 2.0;

/// Changes from each part to the next, and from the first part with modes to the last, tested together.
pub(super) struct Changes {
    /// From each part to the next.
    pub(super) by_event: Vec<Vec<LastingChange>>,
    /// Between the two compared parts.
    pub(super) in_all: Vec<LastingChange>,
}

/// The changes between the parts of a record.
///
/// ```text
/// t = r/sd,   p = P(|t_ν| ≥ |t|);   in ascending order p_H(k) = max_{j ≤ k} min(1, (m − j + 1) p(j)),   m changes
/// ```
///
/// # Source
/// Holm (1979) Scand. J. Stat. 6:65-70.
pub(super) fn changes(quiet: &[Part], compared: Option<[usize; 2]>) -> Changes {
    let events = quiet.len().saturating_sub(1);
    let mut spans: Vec<[usize; 2]> = (0..events).map(|at| [at, at + 1]).collect();
    let own = compared.filter(|of| !spans.contains(of));
    spans.extend(own);
    let mut all: Vec<Vec<LastingChange>> = spans.iter().map(|span| between(quiet, *span)).collect();
    test_together(&mut all);
    for (span, changes) in spans.iter().zip(&mut all) {
        for change in changes.iter_mut().filter(|of| of.is_beyond_chance()) {
            change.is_contradicted =
                is_contradicted((quiet.len(), *span), change, |span| between(quiet, span));
        }
    }
    let in_all = match (own, compared) {
        (Some(_), _) => all.pop().unwrap_or_default(),
        (None, Some([from, _])) => all[from].clone(),
        (None, None) => Vec::new(),
    };
    Changes {
        by_event: all,
        in_all,
    }
}

/// The changes from one part to the other, tested together.
pub(in crate::modal) fn between_parts(parts: &[Part; 2]) -> Vec<LastingChange> {
    changes(parts, None).by_event.pop().unwrap_or_default()
}

fn between(quiet: &[Part], [from, to]: [usize; 2]) -> Vec<LastingChange> {
    let (Some(before), Some(after)) = (&quiet[from].analysis, &quiet[to].analysis) else {
        return Vec::new();
    };
    let pairs = same_modes(&before.modes, &after.modes);
    let of = |analysis: &ModalAnalysis, at: usize| analysis.modes.modes[at].clone();
    let change = |pair: super::mode_pairs::SameMode| {
        let modes = [of(before, pair.before), of(after, pair.after)];
        let blocks = [before, after].map(|of| of.settings.time_blocks_effective);
        change_of(modes, blocks)
    };
    pairs.into_iter().map(change).collect()
}

fn change_of([before, after]: [Mode; 2], [blocks_before, blocks_after]: [usize; 2]) -> LastingChange {
    let part = |of: &Mode, blocks: usize| {
        let sd = of.frequency_sd_hz.map(|sd| sd / of.frequency_hz);
        sd.map(|sd| (sd * sd, of.degrees_of_freedom(blocks)))
    };
    let parts = part(&before, blocks_before).zip(part(&after, blocks_after));
    let spread = parts.map(|(a, b)| welch(&[a, b]));
    let ratio = after.frequency_hz / before.frequency_hz - 1.0;
    LastingChange {
        before_hz: before.frequency_hz,
        before_sd_hz: before.frequency_sd_hz,
        after_hz: after.frequency_hz,
        after_sd_hz: after.frequency_sd_hz,
        ratio,
        ratio_sd: spread.map(|(variance, _)| (1.0 + ratio) * variance.sqrt()),
        degrees_of_freedom: spread.map_or(f64::INFINITY, |(_, nu)| nu),
        chance: None,
        is_contradicted: false,
    }
}

/// Holm's procedure over all changes.
fn test_together(all: &mut [Vec<LastingChange>]) {
    let mut tests: Vec<(f64, &mut LastingChange)> = Vec::new();
    for change in all.iter_mut().flatten() {
        let statistic = change.ratio_sd.map(|sd| change.ratio / sd);
        let alone = statistic.and_then(|t| student_two_sided(t, change.degrees_of_freedom).ok());
        tests.extend(alone.map(|p| (p, change)));
    }
    tests.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (count, mut most) = (tests.len(), 0.0_f64);
    for (at, (alone, change)) in tests.into_iter().enumerate() {
        most = most.max(((count - at) as f64 * alone).min(1.0));
        change.chance = Some(most);
    }
}

/// Whether an earlier part shows the mode as it is after this change, or a later one as it was before.
fn is_contradicted(
    (parts, [from, to]): (usize, [usize; 2]),
    change: &LastingChange,
    between: impl Fn([usize; 2]) -> Vec<LastingChange>,
) -> bool {
    let is_other = |other: &LastingChange, off_hz: f64| {
        let sd = change
            .ratio_sd
            .unwrap_or(0.0)
            .hypot(other.ratio_sd.unwrap_or(0.0));
        other.ratio / change.ratio < 0.5 && off_hz.abs() / change.before_hz > AGREES * sd
    };
    let later = (to + 1..parts).any(|part| {
        let mut own = between([from, part]).into_iter();
        let same = own.find(|of| of.before_hz == change.before_hz);
        same.is_some_and(|of| is_other(&of, of.after_hz - change.after_hz))
    });
    later
        || (0..from).any(|part| {
            let mut own = between([part, to]).into_iter();
            let same = own.find(|of| of.after_hz == change.after_hz);
            same.is_some_and(|of| is_other(&of, of.before_hz - change.before_hz))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(frequency_hz: f64, sd_hz: f64) -> Mode {
        Mode {
            frequency_sd_hz: Some(sd_hz),
            ..Mode::made(frequency_hz, 0.01, &[1.0])
        }
    }

    fn from_to(before_hz: f64, after_hz: f64) -> LastingChange {
        change_of([mode(before_hz, 0.01), mode(after_hz, 0.01)], [30, 30])
    }

    #[test]
    fn exact_a_part_with_few_effective_blocks_proves_little() {
        // two equally strong blocks: one degree of freedom, where 12.7 deviations hold 95 %
        let few = change_of([mode(10.0, 1e-6), mode(10.2, 0.01)], [30, 2]);
        assert!((few.ratio_sd.unwrap() / 1.0e-3 - 1.0).abs() < 0.02, "{few:?}");
        assert!((few.degrees_of_freedom - 1.0).abs() < 0.05, "{few:?}");
        assert!((few.half_width_95().unwrap() / few.ratio_sd.unwrap() - 12.7).abs() < 0.5);
        let mut all = vec![vec![few.clone()]];
        test_together(&mut all);
        // 20 deviations, by chance in 3 % of all cases
        assert!(!all[0][0].is_beyond_chance(), "{:?}", all[0][0]);
        let many = from_to(10.0, 10.2);
        let mut all = vec![vec![many]];
        test_together(&mut all);
        assert!(all[0][0].is_beyond_chance());
    }

    #[test]
    fn exact_holm_s_probabilities_and_three_deviations() {
        let changes = [9.85, 10.0, 10.001].map(|after| from_to(10.0, after));
        let alone = changes.clone().map(|of| {
            let statistic = of.ratio / of.ratio_sd.unwrap();
            student_two_sided(statistic, of.degrees_of_freedom).unwrap()
        });
        let mut all = vec![changes[..2].to_vec(), changes[2..].to_vec()];
        test_together(&mut all);
        let chance: Vec<f64> = all.iter().flatten().map(|of| of.chance.unwrap()).collect();
        assert_eq!(chance[0], 3.0 * alone[0]);
        assert_eq!((chance[1], chance[2]), (1.0, 1.0));
        // 3.1 deviations among many
        let mut many = vec![vec![from_to(10.0, 10.0 - 0.045); 40]];
        test_together(&mut many);
        let of = &many[0][0];
        assert!(of.is_beyond_deviations() && !of.is_beyond_chance(), "{of:?}");
        // 2.5 deviations, alone: chance gives them in 1.5 % of all cases, and readers take three
        let mut one = vec![vec![from_to(10.0, 10.0 - 0.0353)]];
        test_together(&mut one);
        let of = &one[0][0];
        assert!(of.chance.unwrap() < LastingChange::CHANCE_MOST, "{of:?}");
        assert!(!of.is_beyond_chance());
    }

    #[test]
    fn exact_a_change_holds_in_all_parts() {
        let contradicted = |parts: [f64; 4], at: usize| {
            let between = |[from, to]: [usize; 2]| vec![from_to(parts[from], parts[to])];
            is_contradicted((4, [at, at + 1]), &from_to(parts[at], parts[at + 1]), between)
        };
        assert!(!contradicted([10.0, 9.5, 9.5, 9.48], 0));
        assert!(!contradicted([10.0, 9.99, 9.5, 9.51], 1));
        assert!(!contradicted([10.0, 9.5, 9.0, 9.0], 1));
        assert!(contradicted([10.0, 9.5, 10.0, 10.0], 0), "one part alone, after");
        assert!(contradicted([10.0, 9.5, 10.0, 10.0], 1), "one part alone, before");
    }
}
