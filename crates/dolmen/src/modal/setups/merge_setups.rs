//! Merges the setups of a survey, each identified separately, through the sensors that stayed in place.
//!
//! φ_s, r and α_s: see merged_mode.rs; f_s, σ_s: frequency (or damping ratio) in setup s and its standard deviation.

use super::merged_mode::{MergedMode, MergingMode};
use super::pairing::{ObservedMode, Pairing, pair_modes, shared};
use super::reference_gains::{ReferenceFault, reference_faults};
use super::sensor_places::SensorPlaces;
use crate::modal::{ModalError, Modes, assurance};

/// Options of [`merge_setups`].
#[derive(Clone, Debug, PartialEq)]
pub struct MergeSetups {
    /// Pairing of the modes of two setups; default 5 % of frequency, otherwise as [`Pairing`].
    pub pairing: Pairing,
}

impl Default for MergeSetups {
    fn default() -> Self {
        MergeSetups {
            pairing: Pairing {
                frequency_within: 0.05,
                ..Pairing::default()
            },
        }
    }
}

/// A mode found in only some setups.
#[derive(Clone, Debug, PartialEq)]
pub struct PartialMode {
    /// Frequency, Hz, in the first setup with the mode.
    pub frequency_hz: f64,
    /// Setups with the mode, from 0.
    pub setups: Vec<usize>,
    /// Setups with a mode of that frequency (within 2 %) that has another shape at the references, or another partner.
    pub unlike_in: Vec<usize>,
}

/// The merged result of several setups.
#[derive(Clone, Debug, PartialEq)]
pub struct MergedSetups {
    /// The modes found in every setup, at all sensors.
    pub modes: Modes,
    /// How each mode was merged, in the same order.
    pub merged: Vec<MergedMode>,
    /// Modes missing in some setups: left out.
    pub partial: Vec<PartialMode>,
    /// Indices, in `modes.channels`, of the sensors in more than one setup.
    pub references: Vec<usize>,
    /// References whose gain or sign differs between setups.
    pub reference_faults: Vec<ReferenceFault>,
}

/// Largest relative difference between the frequencies of one mode in two setups, for any shapes. Our choice.
const ONE_FREQUENCY: f64 = 0.02;
/// Least MAC at the references of one mode in two setups that other setups do not show. Our choice.
const ONE_SHAPE: f64 = 0.9;

/// Merges the modes of several setups (post-separate estimation re-scaling).
///
/// ```text
/// α_s = φ_s* r / φ_s* φ_s                     least squares of α φ_s = r at the places that setups before s show
/// mean f = Σ f_s/σ_s² / Σ 1/σ_s²,   χ² = Σ (f_s - mean)²/σ_s²,   sd = √(1/Σ 1/σ_s²) √max(1, χ²/(S - 1))
/// ```
/// The setups are added one by one. The modes of a setup are paired with those of the earlier setups by frequency and by their shapes at
/// the common places, then scaled and combined; a place in several setups has their mean. If the setups disagree on a value, the standard
/// deviation of its mean is multiplied by √(χ²/(S - 1)).
///
/// # Errors
/// [`ModalError::Setups`] with fewer than two setups; [`ModalError::NoReference`] for a setup without a sensor in common with earlier
/// ones.
///
/// # Limits
/// The scale of a mode is inaccurate if the reference is near a node: the standard deviation of the shape includes this, and
/// `reference_assurance` shows it. With one reference there is no such check.
///
/// # Source
/// Reynders, Magalhães, De Roeck & Cunha (2009) Proc. IMAC XXVII; Döhler, Andersen & Mevel (2010) Proc. IMAC XXVIII, which calls the
/// strategy PoSER. Increased standard deviation: Birge (1932) Phys. Rev. 40:207. Differs from the sources: each setup is scaled to the
/// mean of the earlier ones instead of the first alone, so that references may change from setup to setup.
pub fn merge_setups(setups: &[Modes], options: &MergeSetups) -> Result<MergedSetups, ModalError> {
    let [first, others @ ..] = setups else {
        return Err(ModalError::Setups { given: 0 });
    };
    if others.is_empty() {
        return Err(ModalError::Setups { given: 1 });
    }
    let mut places = SensorPlaces::of(&first.channels);
    let mut growing: Vec<MergingMode> = first.modes.iter().map(MergingMode::of).collect();
    let mut partial = Vec::new();
    for (index, setup) in others.iter().enumerate() {
        let number = index + 1;
        let channel_places =
            places.channel_places(&setup.channels, number, options.pairing.place_within_m)?;
        let known: Vec<ObservedMode> = growing.iter().map(|g| g.observed(&places)).collect();
        let paired = pair_modes(&known, &ObservedMode::all(setup, 0), &options.pairing)?;
        for &alone in &paired.only_first {
            partial.push(Left {
                mode: PartialMode {
                    frequency_hz: growing[alone].members[0].frequency_hz,
                    setups: (0..number).collect(),
                    unlike_in: Vec::new(),
                },
                observed: known[alone].clone(),
            });
        }
        partial.extend(paired.only_second.iter().map(|&alone| Left {
            mode: PartialMode {
                frequency_hz: setup.modes[alone].frequency_hz,
                setups: vec![number],
                unlike_in: Vec::new(),
            },
            observed: ObservedMode::of(&setup.modes[alone], &setup.channels, 0),
        }));
        let mut next = Vec::with_capacity(paired.pairs.len());
        for pair in &paired.pairs {
            let mut mode = growing[pair.first].clone();
            mode.doubtful |= pair.doubtful();
            mode.add(&setup.modes[pair.second], &channel_places, places.channels.len());
            next.push(mode);
        }
        growing = next;
    }
    let partial = joined(partial, setups.len(), options.pairing.place_within_m);
    let mut found = Vec::with_capacity(growing.len());
    for mode in &growing {
        found.push(mode.finished()?);
    }
    found.sort_by(|a, b| a.0.frequency_hz.total_cmp(&b.0.frequency_hz));
    let (modes, merged) = found.into_iter().unzip();
    let references = places.seen_by(2);
    Ok(MergedSetups {
        modes: Modes {
            modes,
            channels: places.channels,
            method: first.method,
            duration_s: setups.iter().map(|s| s.duration_s).sum(),
            history: first.history.clone(),
        },
        merged,
        partial,
        references,
        reference_faults: reference_faults(setups, &options.pairing)?,
    })
}

/// A mode that is missing in some setups, with its shape.
struct Left {
    mode: PartialMode,
    observed: ObservedMode,
}

/// Joins modes of one frequency and shape in different setups, and lists for the others where the shape differs.
fn joined(mut all: Vec<Left>, setups: usize, place_within_m: f64) -> Vec<PartialMode> {
    all.sort_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz));
    let is_near = |a: &PartialMode, b: &PartialMode| {
        (a.frequency_hz / b.frequency_hz - 1.0).abs() <= ONE_FREQUENCY
            && a.setups.iter().all(|s| !b.setups.contains(s))
    };
    let is_alike = |a: &ObservedMode, b: &ObservedMode| {
        let [phi, psi] = shared(&a.shape, &b.shape, place_within_m);
        // at a single place all shapes are equal
        phi.len() > 1 && assurance(&phi, &psi) >= ONE_SHAPE
    };
    let mut partial: Vec<Left> = Vec::with_capacity(all.len());
    for one in all {
        let mut near = partial.iter_mut();
        let is_same = |of: &Left| {
            is_near(&of.mode, &one.mode)
                && is_alike(&of.observed, &one.observed)
                && of.mode.setups.len() + one.mode.setups.len() < setups
        };
        match near.find(|of| is_same(of)) {
            Some(same) => {
                same.mode.setups.extend(one.mode.setups);
                same.mode.setups.sort_unstable();
            }
            None => partial.push(one),
        }
    }
    let modes: Vec<PartialMode> = partial.into_iter().map(|of| of.mode).collect();
    let unlike_in = |mode: &PartialMode| {
        let near = modes.iter().filter(|other| is_near(mode, other));
        let mut setups: Vec<usize> = near.flat_map(|other| other.setups.clone()).collect();
        setups.sort_unstable();
        setups.dedup();
        setups
    };
    let each = modes.iter().map(|mode| PartialMode {
        unlike_in: unlike_in(mode),
        ..mode.clone()
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Method, Mode, ReferenceCase, assurance};
    use crate::signal::Channel;
    use dolmen_linalg::Complex64;

    #[test]
    fn exact_changes_of_a_mean_sum_to_its_variance_widened_where_the_setups_differ() {
        for factor in [1.0, 1.003] {
            let mut setups = [
                setup(&[0, 1, 2], Complex64::ONE, 1.0),
                setup(&[0, 1, 3], Complex64::ONE, factor),
            ];
            for (s, setup) in setups.iter_mut().enumerate() {
                for (i, mode) in setup.modes.iter_mut().enumerate() {
                    // the frequencies of one setup change together in its first block, and in opposite directions in its second
                    let apart = if i % 2 == 0 { 0.6 } else { -0.6 };
                    mode.frequency_sd_hz = Some(0.002 * (s + 1) as f64);
                    mode.frequency_changes_hz = [0.8, apart].map(|c| c * 0.002 * (s + 1) as f64).to_vec();
                }
            }
            let found = merge_setups(&setups, &MergeSetups::default())
                .unwrap()
                .modes
                .modes;
            for mode in &found {
                let square: f64 = mode.frequency_changes_hz.iter().map(|d| d * d).sum();
                assert_eq!(mode.frequency_changes_hz.len(), 4);
                assert!(
                    (square.sqrt() / mode.frequency_sd_hz.unwrap() - 1.0).abs() < 1e-12,
                    "{mode:?}"
                );
            }
            // 0.8² − 0.6² of the variances
            let pairs = found[0]
                .frequency_changes_hz
                .iter()
                .zip(&found[1].frequency_changes_hz);
            let product: f64 = pairs.map(|(a, b)| a * b).sum();
            let sds = found[0].frequency_sd_hz.unwrap() * found[1].frequency_sd_hz.unwrap();
            assert!((product / sds - 0.28).abs() < 1e-12, "{product} {sds}");
        }
    }

    /// Exact modes of four floors at the given channels; each shape has its own scale.
    fn setup(channels: &[usize], scale: Complex64, factor: f64) -> Modes {
        let made = ReferenceCase::ClosePairs.made(0).unwrap();
        let mode = |m: &crate::modal::MadeMode| Mode {
            frequency_sd_hz: Some(0.002),
            damping_ratio_sd: Some(0.001),
            shape: channels.iter().map(|c| scale * m.shape[*c]).collect(),
            shape_sd: Some(vec![0.01; channels.len()]),
            orders: vec![8],
            ..Mode::made(factor * m.frequency_hz, m.damping_ratio, &[])
        };
        Modes {
            modes: made.modes.iter().map(mode).collect(),
            channels: channels.iter().map(|c| Channel::named(format!("s{c}"))).collect(),
            method: Method::SsiCov,
            duration_s: 600.0,
            history: Vec::new(),
        }
    }

    #[test]
    fn exact_shapes_come_back_whole_whatever_the_scale_of_each_setup() {
        let setups = [
            setup(&[6, 7, 0, 1], Complex64::ONE, 1.0),
            setup(&[2, 6, 3, 7], Complex64::new(-0.3, 0.2), 1.0),
            setup(&[4, 5, 3, 2], Complex64::new(0.0, 2.0), 1.0), // references of the second setup alone
        ];
        let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
        assert_eq!((found.modes.modes.len(), found.partial.len()), (8, 0));
        let names: Vec<&str> = found.modes.channels.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["s6", "s7", "s0", "s1", "s2", "s3", "s4", "s5"]);
        assert_eq!(found.references, [0, 1, 4, 5]);
        let truth = ReferenceCase::ClosePairs.made(0).unwrap().modes;
        for (mode, truth) in found.modes.modes.iter().zip(&truth) {
            let whole: Vec<Complex64> = [6, 7, 0, 1, 2, 3, 4, 5]
                .map(|c: usize| Complex64::new(truth.shape[c], 0.0))
                .to_vec();
            assert!(assurance(&mode.shape, &whole) > 1.0 - 1e-12, "{mode:?}");
            assert!((mode.frequency_hz - truth.frequency_hz).abs() < 1e-12);
            assert!((mode.frequency_sd_hz.unwrap() - 0.002 / 3.0_f64.sqrt()).abs() < 1e-15);
        }
        for merged in &found.merged {
            assert!(
                merged.reference_assurance[1..]
                    .iter()
                    .all(|mac| mac.is_some_and(|mac| mac > 1.0 - 1e-12))
            );
            assert!(!merged.frequency.differs());
        }
    }

    #[test]
    fn holds_setups_that_disagree_are_said_and_the_deviation_is_widened() {
        let setups = [
            setup(&[6, 7, 0], Complex64::ONE, 1.0),
            setup(&[6, 7, 1], Complex64::ONE, 1.01),
        ];
        let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
        for (mode, merged) in found.modes.modes.iter().zip(&found.merged) {
            let half = 0.005 * merged.frequency_hz[0]; // of the difference: sd of the mean, by the parts alone
            assert!(merged.frequency.differs() && (mode.frequency_sd_hz.unwrap() / half - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn holds_a_mode_that_one_setup_does_not_show_is_left_out_and_named() {
        let mut second = setup(&[6, 7, 1], Complex64::ONE, 1.0);
        let lost = second.modes.remove(2);
        let found = merge_setups(
            &[setup(&[6, 7, 0], Complex64::ONE, 1.0), second],
            &MergeSetups::default(),
        )
        .unwrap();
        assert_eq!(found.modes.modes.len(), 7);
        assert_eq!(
            found.partial,
            [PartialMode {
                frequency_hz: lost.frequency_hz,
                setups: vec![0],
                unlike_in: Vec::new(),
            }]
        );
    }

    #[test]
    fn holds_a_mode_that_only_the_first_setup_does_not_show_is_unlike_in_none() {
        let mut first = setup(&[6, 7, 0], Complex64::ONE, 1.0);
        let lost = first.modes.remove(2);
        let second = setup(&[6, 7, 1], Complex64::new(-0.3, 0.2), 1.0);
        let third = setup(&[6, 7, 2], Complex64::ONE, 1.001);
        let found = merge_setups(&[first, second, third], &MergeSetups::default()).unwrap();
        assert_eq!(
            found.partial,
            [PartialMode {
                frequency_hz: lost.frequency_hz,
                setups: vec![1, 2],
                unlike_in: Vec::new(),
            }]
        );
    }

    #[test]
    fn exact_factor_of_a_reference_of_another_gain_or_turned_round() {
        for (factor, words) in [
            (
                2.0,
                "a reference has another gain in setup 2: against the others \"s7\" moves 2.00",
            ),
            (
                -1.0,
                "a reference looks turned round in setup 2: against the others \"s7\" moves -1.00",
            ),
        ] {
            let mut setups = [
                setup(&[6, 7, 4, 0], Complex64::ONE, 1.0),
                setup(&[6, 7, 4, 1], Complex64::ONE, 1.0),
                setup(&[6, 7, 4, 2], Complex64::ONE, 1.0),
            ];
            for mode in &mut setups[1].modes {
                mode.shape[1] *= factor;
            }
            let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
            let [fault] = &found.reference_faults[..] else {
                panic!("{:?}", found.reference_faults)
            };
            let [suspect] = &fault.suspects[..] else {
                panic!("{fault:?}")
            };
            assert_eq!((fault.setups[0], suspect.channel.as_str()), (1, "s7"));
            assert!((suspect.factor / factor - 1.0).abs() < 1e-6, "{fault:?}");
            assert!(fault.to_string().contains(words), "{fault}");
            // the first setup is at fault, which the two others show
            setups.swap(0, 1);
            let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
            let [fault] = &found.reference_faults[..] else {
                panic!("{:?}", found.reference_faults)
            };
            assert_eq!(fault.setups[0], 0);
            assert!(
                (fault.suspects[0].factor / factor - 1.0).abs() < 1e-6,
                "{fault:?}"
            );
        }
    }

    /// Of two references either may have the other gain, and each has its own factor.
    #[test]
    fn exact_each_of_two_references_has_the_factor_that_explains_the_difference_alone() {
        let first = setup(&[6, 7, 0], Complex64::ONE, 1.0);
        let mut second = setup(&[6, 7, 1], Complex64::ONE, 1.0);
        for mode in &mut second.modes {
            mode.shape[1] *= 1.5;
        }
        let found = merge_setups(&[first, second], &MergeSetups::default()).unwrap();
        let [fault] = &found.reference_faults[..] else {
            panic!("{:?}", found.reference_faults)
        };
        assert_eq!(fault.suspects.len(), 2, "{fault:?}");
        for (channel, factor) in [("s7", 1.5), ("s6", 1.0 / 1.5)] {
            let suspect = fault.suspects.iter().find(|of| of.channel == channel).unwrap();
            assert!((suspect.factor / factor - 1.0).abs() < 1e-6, "{fault:?}");
        }
    }

    #[test]
    fn holds_a_mode_that_a_turned_sensor_hides_is_said_to_be_in_both_setups() {
        let first = setup(&[6, 7, 0], Complex64::ONE, 1.0);
        let mut second = setup(&[6, 7, 1], Complex64::ONE, 1.0);
        for mode in &mut second.modes {
            mode.shape[1] *= -1.0;
        }
        let found = merge_setups(&[first, second], &MergeSetups::default()).unwrap();
        let [fault] = &found.reference_faults[..] else {
            panic!("{:?}", found.reference_faults)
        };
        assert_eq!(fault.suspects.len(), 2); // of two references either may be turned
        assert!(
            fault.suspects.iter().all(|of| (of.factor + 1.0).abs() < 1e-6),
            "{fault:?}"
        );
        assert!(
            found.partial.iter().all(|p| !p.unlike_in.is_empty()),
            "{:?}",
            found.partial
        );
    }

    #[test]
    fn holds_references_that_agree_are_no_fault() {
        // a component with an error of twice its standard deviation, and one setup scaled by -0.4
        let first = setup(&[6, 7, 4, 0], Complex64::ONE, 1.0);
        let mut second = setup(&[6, 7, 4, 1], Complex64::new(-0.4, 0.0), 1.002);
        for (i, mode) in second.modes.iter_mut().enumerate() {
            mode.shape[i % 3] *= 1.02;
        }
        let found = merge_setups(&[first, second], &MergeSetups::default()).unwrap();
        assert_eq!(found.reference_faults, []);
    }

    #[test]
    fn refuses_one_setup_and_setups_without_a_reference() {
        let one = setup(&[0, 1], Complex64::ONE, 1.0);
        let message = merge_setups(std::slice::from_ref(&one), &MergeSetups::default())
            .unwrap_err()
            .to_string();
        assert!(message.starts_with("1 setups are given"), "{message}");
        let other = setup(&[2, 3], Complex64::ONE, 1.0);
        let message = merge_setups(&[one, other], &MergeSetups::default())
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("setup 2 has no sensor in common"),
            "{message}"
        );
    }
}
