//! Modes at multiples of one frequency that are steadier than modes: steps that never pause, a bell, an engine.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | f₀ | `fundamental_hz` | frequency of the steps |
//! | n_i | `multiple` | multiple of f₀ nearest to mode i |
//! | δ | `WITHIN` | largest distance of a mode from its multiple, relative to the mode |
//! | p | `chance` | probability that so many modes lie so near to multiples by chance |

use crate::modal::modes::{Mode, Modes};
use crate::modal::{Method, Note};

/// Largest distance from a multiple, relative to the frequency. Our choice: steps whose intervals vary by 2 % had lines within 0.08 % of the
/// multiples of their mean.
const WITHIN: f64 = 0.0015;
/// Fewest modes at multiples of one frequency. Our choice.
const MEMBERS_LEAST: usize = 4;
/// Kurtosis below which a motion is steadier than most modes are. Our choice: ten lines of steps had 1.5 to 2.5. The modes of a cable, also at
/// multiples, have 3.
const KURTOSIS_MOST: f64 = 2.6;
/// Largest probability of chance. Our choice.
const CHANCE_MOST: f64 = 1e-4;
/// Highest multiple at which the lowest member may lie, and frequencies of steps, bells and engines, Hz. Our choice.
const LOWEST_MULTIPLE: usize = 4;
const FUNDAMENTAL_HZ: [f64; 2] = [0.3, 30.0];

/// Removes modes at multiples of one frequency that are steadier than modes, and names them. They remain while they are single or random.
pub(crate) fn leave_out_combs(modes: &mut Modes, notes: &mut Vec<Note>) {
    if modes.method == Method::Era {
        return;
    }
    while let Some((fundamental_hz, members)) = comb(&modes.modes) {
        let frequency_hz = members.iter().map(|at| modes.modes[*at].frequency_hz).collect();
        notes.push(Note::Comb {
            fundamental_hz,
            frequency_hz,
        });
        let mut at = 0..;
        modes
            .modes
            .retain(|_| at.next().is_none_or(|at| !members.contains(&at)));
    }
}

/// The fundamental frequency with the most members, Hz, and the indices of these modes.
///
/// ```text
/// |f_i − n_i f₀| ≤ δ f_i,   p = M Σ over sets of modes of Π 2 δ n_i  ≤  M C(N, k) (mean of 2 δ n_i)^k          M candidates for f₀
/// ```
fn comb(modes: &[Mode]) -> Option<(f64, Vec<usize>)> {
    let steady: Vec<usize> = (0..modes.len())
        .filter(|at| modes[*at].kurtosis.is_some_and(|of| of.kurtosis < KURTOSIS_MOST))
        .collect();
    let candidates = steady.iter().flat_map(|at| {
        let hz = modes[*at].frequency_hz;
        (1..=LOWEST_MULTIPLE).map(move |multiple| hz / multiple as f64)
    });
    let candidates: Vec<f64> = candidates
        .filter(|hz| (FUNDAMENTAL_HZ[0]..=FUNDAMENTAL_HZ[1]).contains(hz))
        .collect();
    let mut best: Option<(f64, Vec<usize>)> = None;
    for first_hz in &candidates {
        let (hz, members) = members(modes, &steady, *first_hz);
        let is_comb = members.len() >= MEMBERS_LEAST
            && chance(modes, &members, hz) * candidates.len() as f64 <= CHANCE_MOST;
        // of equal counts the largest fundamental: half of it has the same members
        let is_better = best.as_ref().is_none_or(|(best_hz, of)| {
            members.len() > of.len() || members.len() == of.len() && hz > *best_hz
        });
        if is_comb && is_better {
            best = Some((hz, members));
        }
    }
    best
}

fn multiple(mode: &Mode, fundamental_hz: f64) -> f64 {
    (mode.frequency_hz / fundamental_hz).round()
}

/// The modes at multiples, with the fundamental frequency that fits them best: that of a single line may be off by as much as its multiple.
fn members(modes: &[Mode], steady: &[usize], first_hz: f64) -> (f64, Vec<usize>) {
    let mut hz = first_hz;
    let mut found: Vec<usize> = Vec::new();
    for _ in 0..3 {
        found.clear();
        for &at in steady {
            let nearest_hz = multiple(&modes[at], hz) * hz;
            if (modes[at].frequency_hz - nearest_hz).abs() <= WITHIN * modes[at].frequency_hz {
                found.push(at);
            }
        }
        // each relative to its frequency, as the distances are
        let each = found
            .iter()
            .map(|&at| modes[at].frequency_hz / multiple(&modes[at], hz));
        let (sum, count) = each.fold((0.0, 0.0), |(sum, count), each| (sum + each, count + 1.0));
        if count > 0.0 {
            hz = sum / count;
        }
    }
    (hz, found)
}

/// Largest probability that as many of all modes, at random frequencies, lie at multiples.
fn chance(modes: &[Mode], members: &[usize], hz: f64) -> f64 {
    let count = members.len();
    let near = |at: &usize| (2.0 * WITHIN * multiple(&modes[*at], hz)).min(1.0);
    let mean = members.iter().map(near).sum::<f64>() / count as f64;
    let choices = (0..count).map(|i| (modes.len() - i) as f64 / (count - i) as f64);
    choices.product::<f64>() * mean.powi(count as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Kurtosis;
    use crate::numeric::Random;

    fn modes(of: &[(f64, f64)]) -> Modes {
        let mode = |(frequency_hz, kurtosis): &(f64, f64)| Mode {
            kurtosis: Some(Kurtosis {
                frequency_hz: *frequency_hz,
                kurtosis: *kurtosis,
                deviation: 0.2,
                share: 1.0,
            }),
            ..Mode::made(*frequency_hz, 0.01, &[])
        };
        Modes {
            modes: of.iter().map(mode).collect(),
            channels: Vec::new(),
            method: Method::SsiCov,
            duration_s: 600.0,
            history: Vec::new(),
        }
    }

    fn left(of: &[(f64, f64)]) -> (Vec<f64>, Vec<Note>) {
        let (mut modes, mut notes) = (modes(of), Vec::new());
        leave_out_combs(&mut modes, &mut notes);
        (modes.modes.iter().map(|mode| mode.frequency_hz).collect(), notes)
    }

    /// Frequencies and kurtoses as identified from ten minutes of a frame (2.312, 6.233, 9.498 and 12.009 Hz) under steps at 1.887 Hz.
    const STEPS: [(f64, f64); 13] = [
        (2.307, 3.75),
        (3.7746, 1.54),
        (5.6595, 1.59),
        (6.230, 2.86),
        (7.549, 1.62),
        (9.432, 1.74),
        (11.325, 1.73),
        (12.028, 2.64),
        (13.217, 2.12),
        (15.107, 2.28),
        (16.995, 2.26),
        (18.891, 2.46),
        (20.777, 2.40),
    ];

    #[test]
    fn holds_steps_that_never_pause_make_no_modes() {
        let (kept, notes) = left(&STEPS);
        assert_eq!(kept, [2.307, 6.230, 12.028]);
        let [
            Note::Comb {
                fundamental_hz,
                frequency_hz,
            },
        ] = &notes[..]
        else {
            panic!("{notes:?}")
        };
        assert!((fundamental_hz / 1.888 - 1.0).abs() < 1e-3, "{fundamental_hz}");
        assert_eq!(frequency_hz.len(), 10);
    }

    #[test]
    fn holds_the_modes_of_a_cable_are_no_comb_and_random_frequencies_seldom_are() {
        let cable: Vec<(f64, f64)> = (1..10).map(|n| (1.9 * f64::from(n), 2.9)).collect();
        assert_eq!(left(&cable).0.len(), 9);
        let mut random = Random::new(5, 0);
        let mut count = 0;
        for _ in 0..2000 {
            // even if every one is as steady as a line of steps
            let mut hz: Vec<f64> = (0..9).map(|_| 1.0 + 19.0 * random.uniform()).collect();
            hz.sort_by(f64::total_cmp);
            let each: Vec<(f64, f64)> = hz.into_iter().map(|hz| (hz, 2.0)).collect();
            count += usize::from(!left(&each).1.is_empty());
        }
        assert!(count <= 2, "{count}");
    }
}
