// SOURCE     none but arithmetic: records made from single degrees of freedom, divided into setups of four sensors.
// GOAL       Three setups of four sensors give the shapes at eight sensors, for any excitation of each setup.
//
//      o  four floors × (x, y), the y modes moved up by a     setup 1: top x, y and floor 1 x, y
//      |  sixth so that no two are neighbours                 setup 2: top x, y and floor 2 x, y
//     _|_ sensors turned by 30°                               setup 3: top x, y and floor 3 x, y
//
// TOLERANCE  frequencies within 4 of their stated standard deviations (8 modes × 2 sets of records: one in 1000 by
//            chance); shapes MAC > 0.99, as three records of ten minutes allow.

use dolmen::modal::{
    Identify, MadeMode, MadeRecord, MergeSetups, Modes, ReferenceCase, assurance, identify, joint_setups,
    merge_setups,
};
use dolmen::signal::{Channel, Record};
use dolmen_linalg::Complex64;

fn truth() -> Vec<MadeMode> {
    let mut modes = ReferenceCase::ClosePairs.made(0).unwrap().modes;
    for (i, mode) in modes.iter_mut().enumerate() {
        mode.frequency_hz *= if i % 2 == 1 { 7.0 / 6.0 } else { 1.0 };
    }
    modes
}

/// Record of the sensors of one setup under its own excitation.
fn record(channels: [usize; 4], seed: u64, gain: f64) -> Record {
    let made = MadeRecord {
        modes: truth(),
        seed,
        ..MadeRecord::default()
    };
    let whole = made.make().unwrap();
    let samples = channels
        .map(|c| whole.samples(c).iter().map(|y| gain * y).collect())
        .to_vec();
    let names = channels.map(|c| Channel::named(format!("sensor {c}"))).to_vec();
    Record::new(names, samples, whole.sampling_rate_hz()).unwrap()
}

fn records(seed: u64) -> [Record; 3] {
    [
        record([6, 7, 0, 1], seed, 1.0),
        record([6, 7, 2, 3], seed + 1, 0.02),
        record([6, 7, 4, 5], seed + 2, 7.0),
    ]
}

/// Checks that every mode and no other is found, within 4 of its standard deviations, with its shape at eight sensors.
fn compare(modes: &Modes, seed: u64) {
    let hz: Vec<f64> = modes.modes.iter().map(|m| m.frequency_hz).collect();
    let mut truth = truth();
    truth.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    assert_eq!((hz.len(), modes.channels.len()), (8, 8), "{hz:?}");
    for (mode, truth) in modes.modes.iter().zip(&truth) {
        let shape: Vec<Complex64> = [6, 7, 0, 1, 2, 3, 4, 5]
            .map(|c: usize| Complex64::new(truth.shape[c], 0.0))
            .to_vec();
        let alike = assurance(&mode.shape, &shape);
        let off = (mode.frequency_hz - truth.frequency_hz).abs() / mode.frequency_sd_hz.unwrap();
        assert!(
            alike > 0.99 && off < 4.0,
            "seed {seed}: {} Hz: MAC {alike}, {off} deviations off",
            truth.frequency_hz
        );
    }
}

#[test]
fn holds_three_setups_of_four_sensors_show_the_shapes_of_eight() {
    for seed in [100, 200] {
        let setups = records(seed).map(|r| identify(&r, &Identify::default()).unwrap().modes);
        let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
        assert_eq!(found.references, [0, 1], "{:?}", found.partial);
        compare(&found.modes, seed);
        let differing = found.merged.iter().filter(|m| m.frequency.differs()).count();
        assert_eq!(differing, 0, "{:?}", found.merged);
    }
}

#[test]
fn holds_three_setups_identified_as_one_show_the_shapes_of_eight() {
    for seed in [100, 200] {
        let found = joint_setups(&records(seed), &Identify::default(), 0.1).unwrap();
        assert_eq!(found.references, [0, 1]);
        compare(&found.modes, seed);
        for (strength, gain) in found.strength.iter().zip([1.0, 0.02, 7.0]) {
            assert!((strength / gain - 1.0).abs() < 0.3, "{:?}", found.strength);
        }
    }
}
