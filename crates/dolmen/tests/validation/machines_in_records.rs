// SOURCE     as made_records.rs, with sines added, so that the effect of the machine is known exactly.
// GOAL       Notes name the machines, which are not modes; modes near them and at their frequency are found; every peak that is not a mode
//            has its reason.
// TOLERANCE  as in made_records.rs.

use super::made_records::{deviation, matched};
use dolmen::modal::{
    Criteria, Harmonics, Identify, MadeMode, MadeRecord, Note, ReferenceCase, Refusal, identify,
};
use dolmen::signal::{Channel, Record};

#[test]
fn holds_a_machine_is_named_and_neither_a_mode_nor_a_reason_to_keep_high_frequencies() {
    let record = ReferenceCase::ShearChain.made(100).unwrap().make().unwrap();
    let with_tone = |c: usize| -> Vec<f64> {
        let level = record.samples(c).iter().fold(0.0_f64, |m, y| m.max(y.abs()));
        let turn = 2.0 * std::f64::consts::PI * 24.7 / record.sampling_rate_hz();
        let tone = (0..record.length()).map(|t| 0.2 * level * (turn * t as f64).sin());
        record
            .samples(c)
            .iter()
            .zip(tone)
            .map(|(y, tone)| y + tone)
            .collect()
    };
    let noisy = Record::new(record.channels().to_vec(), (0..2).map(with_tone).collect(), 100.0).unwrap();
    let (still, humming) = (
        identify(&record, &Identify::default()).unwrap(),
        identify(&noisy, &Identify::default()).unwrap(),
    );
    assert_eq!(humming.settings.decimation, still.settings.decimation);
    assert_eq!(humming.modes.modes.len(), 2);
    assert!(
        humming
            .notes
            .iter()
            .any(|n| n.to_string().contains("random forces, at 24.7")),
        "{:?}",
        humming.notes
    );
}

#[test]
fn holds_the_hum_of_the_mains_and_an_engine_are_named_and_no_mode_is_lost() {
    let made = ReferenceCase::ClosePairs.made(100).unwrap();
    let record = made.make().unwrap();
    let hum = |c: usize| -> Vec<f64> {
        let y = record.samples(c);
        let wave = |hz: f64, t: usize| (2.0 * std::f64::consts::PI * hz * t as f64 / 100.0 + c as f64).sin();
        let spread = 2.0_f64.sqrt() * deviation(y);
        let at = |t: usize| spread * (wave(41.0, t) + 0.5 * wave(15.0, t));
        y.iter().enumerate().map(|(t, y)| y + at(t)).collect()
    };
    let noisy = Record::new(record.channels().to_vec(), (0..8).map(hum).collect(), 100.0).unwrap();
    let found = identify(&noisy, &Identify::default()).unwrap();
    matched(&made.modes, &found.modes, 100);
    assert!(
        found.modes.modes.iter().all(|mode| !mode.harmonic()),
        "{:?}",
        found.notes
    );
    let Some(Note::Tones { tones }) = found.notes.iter().find(|n| matches!(n, Note::Tones { .. })) else {
        panic!("no tones in {:?}", found.notes);
    };
    assert_eq!(tones.len(), 2, "{tones:?}");
    for (tone, hz) in tones.iter().zip([15.0, 41.0]) {
        assert!((tone.frequency_hz - hz).abs() < 0.02, "{tone:?}");
        assert!(tone.kurtosis.is_some_and(|k| k.kurtosis < 1.7), "{tone:?}");
    }
    // pairs 2 % apart with a damping ratio of 1 %: their bands overlap
    assert!(
        found.notes.iter().any(|n| matches!(n, Note::ClosePairs { .. })),
        "{:?}",
        found.notes
    );
}

#[test]
fn holds_an_engine_that_runs_for_half_of_the_time_is_no_peak_that_needs_a_mode() {
    let made = ReferenceCase::ClosePairs.made(200).unwrap();
    let record = made.make().unwrap();
    let hum = |c: usize| -> Vec<f64> {
        let y = record.samples(c);
        let level = 0.3 * 2.0_f64.sqrt() * deviation(y);
        let wave = |t: usize| (2.0 * std::f64::consts::PI * 14.0 * t as f64 / 100.0 + c as f64).sin();
        let runs = |t: usize| t < 30_000;
        y.iter()
            .enumerate()
            .map(|(t, y)| if runs(t) { y + level * wave(t) } else { *y })
            .collect()
    };
    let noisy = Record::new(record.channels().to_vec(), (0..8).map(hum).collect(), 100.0).unwrap();
    for harmonics in [Harmonics::Flag, Harmonics::Remove] {
        let options = Identify {
            harmonics,
            ..Identify::default()
        };
        let found = identify(&noisy, &options).unwrap();
        matched(&made.modes, &found.modes, 200);
        let tone = found.notes.iter().find_map(|note| match note {
            Note::Tones { tones } => tones.iter().find(|tone| (tone.frequency_hz - 14.0).abs() < 0.02),
            _ => None,
        });
        let share = tone.and_then(|tone| tone.kurtosis).map(|k| k.share);
        assert!(
            share.is_some_and(|share| (share - 0.5).abs() < 0.13),
            "{:?}",
            found.notes
        );
        assert!(
            !found
                .notes
                .iter()
                .any(|n| matches!(n, Note::PeaksWithoutMode { .. })),
            "{:?}",
            found.notes
        );
    }
}

/// A chain of two floors, twenty minutes, with a machine of `strength` times the motion of the first mode (root mean squares) at its
/// frequency.
fn machine_on_a_mode(strength: f64, seed: u64) -> (MadeRecord, Record) {
    let made = MadeRecord {
        modes: [(2.0, [0.5, 1.0]), (6.3, [1.0, -0.5])]
            .map(|(frequency_hz, shape)| MadeMode {
                frequency_hz,
                damping_ratio: 0.015,
                shape: shape.to_vec(),
            })
            .to_vec(),
        duration_s: 1200.0,
        seed,
        ..MadeRecord::default()
    };
    let record = made.make().unwrap();
    let first = MadeRecord {
        modes: made.modes[..1].to_vec(),
        noise_ratio: 0.0,
        ..made.clone()
    };
    let alone = first.make().unwrap();
    let with_machine = |c: usize| -> Vec<f64> {
        let own = alone.samples(c);
        let spread = (own.iter().map(|y| y * y).sum::<f64>() / own.len() as f64).sqrt();
        let wave = |t: usize| (2.0 * std::f64::consts::PI * 2.0071 * t as f64 / 100.0).sin();
        let size = strength * spread * 2.0_f64.sqrt();
        let samples = record.samples(c).iter().enumerate();
        samples.map(|(t, y)| y + size * wave(t)).collect()
    };
    let samples = (0..2).map(with_machine).collect();
    let disturbed = Record::new(record.channels().to_vec(), samples, 100.0).unwrap();
    (made, disturbed)
}

#[test]
fn holds_a_machine_that_runs_on_a_mode_is_named() {
    let (strength, seed) = (2.0_f64, 100);
    let (_, record) = machine_on_a_mode(strength, seed);
    let found = identify(&record, &Identify::default()).unwrap();
    let tones = found.notes.iter().find_map(|note| match note {
        Note::TonesOnModes { tones } => Some(tones),
        _ => None,
    });
    let Some([tone]) = tones.map(Vec::as_slice) else {
        panic!("{strength}: {:?}", found.notes)
    };
    assert!((tone.frequency_hz - 2.0071).abs() < 2e-4, "{tone:?}");
    assert!((tone.strength / strength.powi(2)).ln().abs() < 0.7, "{tone:?}");
}

#[test]
fn holds_no_machine_is_seen_on_the_modes_of_records_without_one() {
    for seed in 100..106 {
        let (_, record) = machine_on_a_mode(0.0, seed);
        let found = identify(&record, &Identify::default()).unwrap();
        let is_tone = |note: &Note| {
            matches!(
                note,
                Note::TonesOnModes { .. } | Note::Tones { .. } | Note::Narrow { .. }
            )
        };
        assert!(!found.notes.iter().any(is_tone), "{:?}", found.notes);
    }
}

#[test]
fn holds_a_peak_that_is_no_mode_says_what_refused_it_and_by_how_much() {
    let record = ReferenceCase::ShearChain.made(100).unwrap().make().unwrap();
    let options = Identify {
        criteria: Criteria {
            damping_ratio_most: 0.008,
            ..Criteria::default()
        },
        ..Identify::default()
    };
    let found = identify(&record, &options).unwrap();
    let peaks = found.notes.iter().find_map(|note| match note {
        Note::PeaksWithoutMode { peaks } => Some(peaks),
        _ => None,
    });
    let peaks = peaks.unwrap();
    assert_eq!(peaks.len(), 2, "{peaks:?}");
    for (peak, hz) in peaks.iter().zip([1.1, 4.2]) {
        assert!((peak.frequency_hz / hz - 1.0).abs() < 0.03, "{peak:?}");
        let Some(Refusal::Damping {
            damping_ratio, most, ..
        }) = peak.refusal
        else {
            panic!("{peak:?}")
        };
        assert!(most == 0.008 && (0.01..0.04).contains(&damping_ratio), "{peak:?}");
    }
}

/// The measured record of the folder `examples/palisaden`: 32-bit floats, sample by sample.
fn palisaden() -> Record {
    let bytes = include_bytes!("../../../../examples/palisaden/record.npy");
    let start = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let values: Vec<f64> = bytes[start..]
        .chunks_exact(4)
        .map(|four| f64::from(f32::from_le_bytes(four.try_into().unwrap())))
        .collect();
    let channels = (1..=6).map(|c| Channel::named(format!("ch{c}"))).collect();
    let samples = (0..6).map(|c| values.iter().skip(c).step_by(6).copied().collect());
    Record::new(channels, samples.collect(), 100.0).unwrap()
}

#[test]
fn holds_no_machine_of_palisaden_becomes_a_mode() {
    // the three published modes, and no line between 11.2 and 24 Hz, where machines run (11.31, 13.27, 13.37, 20.53 Hz)
    let found = identify(&palisaden(), &Identify::default()).unwrap();
    let hz: Vec<f64> = found.modes.modes.iter().map(|mode| mode.frequency_hz).collect();
    for published in [1.882, 2.421, 2.687] {
        assert!(hz.iter().any(|hz| (hz / published - 1.0).abs() < 0.006), "{hz:?}");
    }
    assert!(hz.iter().all(|hz| *hz < 11.2), "{hz:?}");
}
