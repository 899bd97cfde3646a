//! Modes that the user requests: a refused candidate near a given frequency becomes a mode that carries the reason of its refusal.

use super::candidate::Candidate;
use super::options::Identify;
use super::quality::{Diagram, near, test_for_machines, to_one_quantity};
use super::shared_steps::mode_of;
use super::subspace::{Cluster, Criteria, Deviations, Fate};
use super::{Accepted, ModalError, Mode, Modes, Note, Pole, Refusal, RefusedPeak};
use crate::signal::Record;

/// Fewest model orders in an acceptable cluster of poles. Our choice: with many channels, two orders agree by chance.
const ORDERS_LEAST: usize = 3;

/// The refused candidate for each requested frequency: a cluster of poles, otherwise a single pole that may not be a mode, otherwise the
/// visible peak. `set_aside` are peaks that an earlier step classified as something else.
pub(super) fn candidates(
    options: &Identify,
    (peaks, set_aside): (&Modes, &[Candidate]),
    diagram: &Diagram<'_>,
    deviations: &mut dyn Deviations,
) -> Result<Vec<Candidate>, ModalError> {
    let mut found = Vec::new();
    for &asked_hz in &options.accept_hz {
        let within_hz = options.accept_within * asked_hz;
        let apart = |mode: &Mode| (mode.frequency_hz - asked_hz).abs();
        let is_found = |peak_hz: f64| {
            let found = diagram.clusters.iter().filter(|group| group.fate == Fate::Mode);
            found
                .into_iter()
                .any(|group| near(group.medoid.frequency_hz, peak_hz))
        };
        let refused = peaks.modes.iter().filter(|peak| !is_found(peak.frequency_hz));
        let own = refused.map(|peak| Candidate {
            mode: peak.clone(),
            refusal: diagram.refusal(peak.frequency_hz),
        });
        let visible = own
            .chain(set_aside.iter().cloned())
            .filter(|of| apart(&of.mode) <= within_hz)
            .min_by(|a, b| apart(&a.mode).total_cmp(&apart(&b.mode)));
        let is_here = |frequency_hz: f64| {
            let of_peak = visible
                .as_ref()
                .is_none_or(|of| near(frequency_hz, of.mode.frequency_hz));
            (frequency_hz - asked_hz).abs() <= within_hz && of_peak
        };
        let asked = match visible {
            Some(_) => Asked::VisiblePeak(asked_hz),
            None => Asked::NoPeak(asked_hz),
        };
        let group = group_at(diagram, asked, &is_here);
        let is_set_aside = |mode: &Mode| set_aside.iter().any(|of| of.mode == *mode);
        let told = visible
            .as_ref()
            .filter(|of| is_set_aside(&of.mode))
            .and_then(|of| of.refusal);
        if let Some(group) = group {
            let mut own = group.clone();
            if own.deviation.is_none() {
                own.deviation = deviations.deviation(&own.medoid).ok();
            }
            found.push(Candidate {
                mode: mode_of(&own, diagram.duration_s),
                refusal: told.or(Some(diagram.of_group(group))),
            });
        } else if let Some(mut visible) = visible {
            if let Some(pole) = pole_at(diagram, visible.mode.frequency_hz) {
                let own = Cluster {
                    deviation: deviations.deviation(&pole).ok(),
                    orders: vec![pole.order],
                    frequency_spread_hz: 0.0,
                    damping_ratio_spread: 0.0,
                    fate: Fate::FewOrders,
                    medoid: pole,
                };
                visible.mode = mode_of(&own, diagram.duration_s);
            }
            found.push(visible);
        }
    }
    Ok(found)
}

#[derive(Clone, Copy)]
enum Asked {
    /// There is a visible peak near the requested frequency.
    VisiblePeak(f64),
    /// No candidate is near the requested frequency.
    NoPeak(f64),
}

impl Asked {
    fn frequency_hz(self) -> f64 {
        match self {
            Asked::VisiblePeak(hz) | Asked::NoPeak(hz) => hz,
        }
    }
}

/// The refused cluster of poles near the requested frequency: at a visible peak the one with the most orders, otherwise the nearest.
fn group_at<'a>(diagram: &Diagram<'a>, asked: Asked, is_here: &dyn Fn(f64) -> bool) -> Option<&'a Cluster> {
    let apart = |group: &Cluster| (group.medoid.frequency_hz - asked.frequency_hz()).abs();
    let groups = diagram.clusters.iter().filter(|group| {
        group.fate != Fate::Mode && group.orders.len() >= ORDERS_LEAST && is_here(group.medoid.frequency_hz)
    });
    match asked {
        Asked::VisiblePeak(_) => groups.max_by(|a, b| {
            let orders = a.orders.len().cmp(&b.orders.len());
            orders.then(apart(b).total_cmp(&apart(a)))
        }),
        Asked::NoPeak(_) => groups.min_by(|a, b| apart(a).total_cmp(&apart(b))),
    }
}

/// For a peak without a mode: the decaying pole at this peak that is nearest to all other poles there.
fn pole_at(diagram: &Diagram<'_>, peak_hz: f64) -> Option<Pole> {
    const AT_PEAK: f64 = 0.01; // relative
    let poles = diagram.stabilization.poles.iter();
    let here = poles.filter(|of| {
        let is_here = (of.pole.frequency_hz / peak_hz - 1.0).abs() <= AT_PEAK;
        !of.stability.possible() && of.pole.damping_ratio > 0.0 && is_here
    });
    let here: Vec<&Pole> = here.map(|of| &of.pole).collect();
    let mut orders: Vec<usize> = here.iter().map(|pole| pole.order).collect();
    orders.dedup();
    let apart = |p: &Pole| -> f64 { here.iter().map(|q| (p.root_hz() - q.root_hz()).norm()).sum() };
    let middle = here.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
    (orders.len() >= ORDERS_LEAST).then(|| (*middle).clone())
}

/// The modes that a step removed, each with its refusal.
pub(super) fn taken_out(
    before: &[Mode],
    after: &[Mode],
    refusal: impl Fn(&Mode) -> Refusal,
) -> Vec<Candidate> {
    let is_left = |mode: &&Mode| after.iter().all(|kept| kept.frequency_hz != mode.frequency_hz);
    let taken = before.iter().filter(is_left);
    taken
        .map(|mode| Candidate {
            mode: mode.clone(),
            refusal: Some(refusal(mode)),
        })
        .collect()
}

/// The nearest refused candidate for each requested frequency without a mode. Notes name the requested modes that were found anyway, and the
/// frequencies without a candidate. `seen_hz` are the peaks of the spectrum.
pub(super) fn accepted(
    options: &Identify,
    found: &[Mode],
    (candidates, seen_hz): (&[Candidate], &[f64]),
    notes: &mut Vec<Note>,
) -> Vec<Mode> {
    let mut all: Vec<Mode> = Vec::new();
    let mut already_hz: Vec<f64> = Vec::new();
    for &asked_hz in &options.accept_hz {
        let within_hz = options.accept_within * asked_hz;
        let apart = |mode: &Mode| (mode.frequency_hz - asked_hz).abs();
        let of_candidates = candidates.iter().filter(|of| apart(&of.mode) <= within_hz);
        let chosen = of_candidates.min_by(|a, b| apart(&a.mode).total_cmp(&apart(&b.mode)));
        let own = found.iter().filter(|mode| apart(mode) <= within_hz);
        let own = own.min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let is_own = |mode: &&Mode| {
            let sd_hz = mode.frequency_sd_hz.unwrap_or(0.0);
            let reach_hz = (3.0 * sd_hz).max(mode.damping_ratio.unwrap_or(0.0) * mode.frequency_hz);
            apart(mode) <= reach_hz || chosen.is_none_or(|of| apart(mode) <= apart(&of.mode))
        };
        match (own.filter(is_own), chosen) {
            (Some(mode), _) => already_hz.push(mode.frequency_hz),
            (None, Some(of)) if all.iter().any(|taken| taken.frequency_hz == of.mode.frequency_hz) => {}
            (None, Some(of)) => all.push(Mode {
                accepted: Some(Accepted {
                    asked_hz,
                    refusal: of.refusal,
                }),
                ..of.mode.clone()
            }),
            (None, None) => notes.push(nothing(asked_hz, within_hz, found, seen_hz)),
        }
    }
    already_hz.dedup();
    if !already_hz.is_empty() {
        notes.push(Note::AcceptedAlready {
            frequency_hz: already_hz,
        });
    }
    all.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    all
}

/// The note for a frequency without a candidate: names the nearest mode or peak on either side.
fn nothing(asked_hz: f64, within_hz: f64, found: &[Mode], seen_hz: &[f64]) -> Note {
    let all = || {
        found
            .iter()
            .map(|mode| mode.frequency_hz)
            .chain(seen_hz.iter().copied())
    };
    let below = all().filter(|hz| *hz < asked_hz).max_by(f64::total_cmp);
    let above = all().filter(|hz| *hz > asked_hz).min_by(f64::total_cmp);
    Note::NothingToAccept {
        asked_hz,
        within_hz,
        nearest_hz: [below, above].into_iter().flatten().collect(),
    }
}

/// Adds the accepted modes, with the remaining channels, and tests each for machines.
pub(super) fn put_in(
    record: &Record,
    options: &Identify,
    mut accepted: Vec<Mode>,
    modes: &mut Modes,
    notes: &mut Vec<Note>,
) -> Result<(), ModalError> {
    if accepted.is_empty() {
        return Ok(());
    }
    for mode in &mut accepted {
        let least = options
            .criteria
            .damping_least_at(mode.frequency_hz, record.duration_s());
        let as_given = Identify {
            harmonics: super::Harmonics::Flag,
            criteria: Criteria {
                damping_ratio_least: Some(least), // the user allows it, however small its damping
                ..options.criteria.clone()
            },
            ..options.clone()
        };
        let all = (0..record.channels().len()).collect();
        let mut alone = Modes {
            modes: vec![mode.clone()],
            channels: record.channels().to_vec(),
            ..modes.clone()
        };
        test_for_machines(&[(record, all)], &as_given, &mut alone, &mut Vec::new())?;
        *mode = alone.modes.remove(0);
    }
    let place = |name: &str| record.channels().iter().position(|own| own.name == name);
    let kept: Vec<usize> = modes.channels.iter().filter_map(|c| place(&c.name)).collect();
    if kept.len() < record.channels().len() {
        accepted.iter_mut().for_each(|mode| mode.keep_channels(&kept));
    }
    let mut all = Modes {
        modes: accepted,
        channels: kept.iter().map(|&c| record.channels()[c].clone()).collect(),
        ..modes.clone()
    };
    to_one_quantity(&mut all, &mut Vec::new());
    join(all.modes, &mut modes.modes, notes);
    Ok(())
}

/// Adds the accepted modes in order of frequency, and names them in a note.
pub(super) fn join(accepted: Vec<Mode>, modes: &mut Vec<Mode>, notes: &mut Vec<Note>) {
    let named = |mode: &Mode| RefusedPeak {
        frequency_hz: mode.frequency_hz,
        refusal: mode.accepted.and_then(|of| of.refusal),
    };
    if accepted.is_empty() {
        return;
    }
    notes.push(Note::Accepted {
        modes: accepted.iter().map(named).collect(),
    });
    modes.extend(accepted);
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
}

#[cfg(test)]
mod tests {
    use super::super::{Clustering, Harmonics, Method, ModalAnalysis, ReferenceCase, identify};
    use super::*;
    use crate::modal::assurance;
    use dolmen_linalg::Complex64;
    use std::f64::consts::TAU;

    /// Modes of two floors (1.1 and 4.2 Hz, ζ 2 %). `most` is the largest allowed scatter of a cluster over its lower bound.
    fn two_floors(most: f64, accept_hz: &[f64]) -> ModalAnalysis {
        let record = ReferenceCase::ShearChain.made(3).unwrap().make().unwrap();
        let options = Identify {
            accept_hz: accept_hz.to_vec(),
            clustering: Clustering {
                deviation_over_floor_most: most,
                ..Clustering::default()
            },
            ..Identify::default()
        };
        identify(&record, &options).unwrap()
    }

    fn refused_at(analysis: &ModalAnalysis, near_hz: f64) -> RefusedPeak {
        let peaks = analysis.notes.iter().flat_map(|note| match note {
            Note::PeaksWithoutMode { peaks } => peaks.clone(),
            _ => Vec::new(),
        });
        let at: Vec<RefusedPeak> = peaks.filter(|of| near(of.frequency_hz, near_hz)).collect();
        at[0]
    }

    #[test]
    fn exact_a_mode_that_a_test_refuses_is_taken_where_the_user_insists_with_the_reason() {
        let strict = two_floors(0.3, &[]);
        assert!(strict.modes.modes.is_empty());
        let told = refused_at(&strict, 4.2);
        assert!(
            matches!(told.refusal, Some(Refusal::Scattered { most: 0.3, .. })),
            "{told:?}"
        );
        // the frequency as a note prints it, with three decimals
        let asked_hz = (told.frequency_hz * 1e3).round() / 1e3;
        let insisted = two_floors(0.3, &[asked_hz]);
        let [mode] = &insisted.modes.modes[..] else {
            panic!("{:?}", insisted.modes)
        };
        let accepted = mode.accepted.unwrap();
        assert!(!mode.is_found() && accepted.asked_hz == asked_hz);
        assert!(
            matches!(accepted.refusal, Some(Refusal::Scattered { .. })),
            "{accepted:?}"
        );
        let truth = &ReferenceCase::ShearChain.made(3).unwrap().modes[1];
        let sd_hz = mode.frequency_sd_hz.unwrap();
        assert!(
            (mode.frequency_hz - truth.frequency_hz).abs() < 3.0 * sd_hz,
            "{mode:?}"
        );
        let shape: Vec<Complex64> = truth.shape.iter().map(|x| Complex64::new(*x, 0.0)).collect();
        assert!(assurance(&mode.shape, &shape) > 0.99);
        assert!(mode.kurtosis.is_some());
        let is_named = |note: &Note| matches!(note, Note::Accepted { modes } if modes.len() == 1);
        assert!(insisted.notes.iter().any(is_named), "{:?}", insisted.notes);
        // the same mode as with the default test
        let usual = two_floors(3.5, &[]);
        let apart_hz = (usual.modes.modes[1].frequency_hz - mode.frequency_hz).abs();
        assert!(apart_hz < 0.2 * sd_hz, "{apart_hz} {sd_hz}");
        assert!(usual.modes.modes[1].is_found());
    }

    #[test]
    fn holds_what_was_found_needs_no_acceptance_and_where_nothing_stands_nothing_is_taken() {
        let found = two_floors(3.5, &[4.2, 2.3]);
        assert_eq!(found.modes.modes.len(), 2);
        assert!(found.modes.modes.iter().all(Mode::is_found));
        let already: Vec<&Note> = found
            .notes
            .iter()
            .filter(
                |note| matches!(note, Note::AcceptedAlready { frequency_hz } if near(frequency_hz[0], 4.2)),
            )
            .collect();
        assert_eq!(already.len(), 1, "{:?}", found.notes);
        let nothing = found.notes.iter().find_map(|note| match note {
            Note::NothingToAccept {
                asked_hz,
                within_hz,
                nearest_hz,
            } => Some((*asked_hz, *within_hz, nearest_hz.clone())),
            _ => None,
        });
        let (asked_hz, within_hz, nearest_hz) = nothing.unwrap();
        assert_eq!((asked_hz, within_hz), (2.3, 0.03 * 2.3));
        assert!(
            near(nearest_hz[0], 1.1) && near(nearest_hz[1], 4.2),
            "{nearest_hz:?}"
        );
    }

    #[test]
    fn holds_a_machine_is_taken_where_the_user_insists_and_stays_one() {
        let still = ReferenceCase::ShearChain.made(5).unwrap().make().unwrap();
        let rate_hz = still.sampling_rate_hz();
        let humming = |c: usize| -> Vec<f64> {
            let samples = still.samples(c);
            let square = samples.iter().map(|y| y * y).sum::<f64>() / samples.len() as f64;
            let sine = |t: usize| (2.0 * square).sqrt() * (TAU * 24.7 * t as f64 / rate_hz).sin();
            samples.iter().enumerate().map(|(t, y)| y + sine(t)).collect()
        };
        let samples = (0..2).map(humming).collect();
        let record = Record::new(still.channels().to_vec(), samples, rate_hz).unwrap();
        let of = |harmonics, accept_hz: &[f64]| {
            let options = Identify {
                harmonics,
                accept_hz: accept_hz.to_vec(),
                ..Identify::default()
            };
            identify(&record, &options).unwrap()
        };
        let usual = of(Harmonics::Remove, &[]);
        assert_eq!(usual.modes.modes.len(), 2);
        let insisted = of(Harmonics::Remove, &[24.7]);
        let machine: Vec<&Mode> = insisted.modes.modes.iter().filter(|m| !m.is_found()).collect();
        assert_eq!((insisted.modes.modes.len(), machine.len()), (3, 1));
        assert!((machine[0].frequency_hz - 24.7).abs() < 0.05, "{:?}", machine[0]);
        let refusal = machine[0].accepted.unwrap().refusal;
        assert_eq!(refusal, Some(Refusal::Machine));
    }

    #[test]
    fn refuses_a_frequency_beyond_half_the_rate_and_a_free_decay() {
        let record = ReferenceCase::ShearChain.made(3).unwrap().make().unwrap();
        let refusal = |method, hz: f64| {
            let options = Identify {
                method,
                accept_hz: vec![hz],
                ..Identify::default()
            };
            identify(&record, &options).unwrap_err().to_string()
        };
        assert!(
            refusal(Method::SsiCov, 50.0).starts_with("accept is 50, but must be above 0 and below half")
        );
        assert!(refusal(Method::Era, 4.2).starts_with("no test refuses a mode of a free decay"));
    }
}
