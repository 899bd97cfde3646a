// SOURCE     none but arithmetic: records made from single degrees of freedom under white force, discretised exactly
//            (zero-order hold), so that every pole is known.
// GOAL       identify() finds every mode and no other, without bias, and states its scatter correctly.
//
//      o  4 floors × (x, y), storey stiffness 1 → 0.6,        8 channels × 10 min × 100 Hz
//      |  y 4 % stiffer: pairs of modes 2 % apart,            white sensor noise 20 dB below the motion
//     _|_ sensors turned by 30°                               20 seeds (100 to 119) that chose no default
//
// PARAMETERS f1 1.5 Hz, ζ 1 %.
// PUBLISHED  floors of the scatter, Au (2014): sd(f)/f = √(ζ/2πN_c), sd(ζ)/ζ = 1/√(2πζN_c).
// TOLERANCE  bias of f: 0.05 % for each mode; the mean of 20 seeds itself has a scatter of 0.03 % at 1.5 Hz, so the limit is 0.05 %
//            + 1 standard error for each mode, and 0.02 % for the mean of all modes. bias of ζ: 7 %; the mean of 20 seeds has a
//            scatter of 2.5 %. Stated over true scatter: 20 seeds give the ratio of one mode to 16 %, so the limits of its root mean
//            square over all modes are 0.8 … 1.25.

use dolmen::modal::{
    Criteria, Identify, MadeMode, MadeRecord, Method, Modes, ReferenceCase, assurance, identify,
};
use dolmen::signal::{Channel, Quantity, Record};
use dolmen_linalg::Complex64;

const SEEDS: std::ops::Range<u64> = 100..120;

fn found(made: &MadeRecord) -> Modes {
    identify(&made.make().unwrap(), &Identify::default())
        .unwrap()
        .modes
}

/// Pairs of true and found modes, in order; panics unless each mode was found and no other.
pub(super) fn matched(truth: &[MadeMode], modes: &Modes, seed: u64) {
    let hz: Vec<f64> = modes.modes.iter().map(|m| m.frequency_hz).collect();
    assert_eq!(modes.modes.len(), truth.len(), "seed {seed}: found {hz:?}");
    for (truth, mode) in truth.iter().zip(&modes.modes) {
        let shape: Vec<Complex64> = truth.shape.iter().map(|x| Complex64::new(*x, 0.0)).collect();
        let alike = assurance(&shape, &mode.shape);
        assert!(
            (mode.frequency_hz / truth.frequency_hz - 1.0).abs() < 0.01 && alike > 0.7,
            "seed {seed}: {} Hz found as {} Hz, assurance {alike}",
            truth.frequency_hz,
            mode.frequency_hz
        );
    }
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len() as f64
}

pub(super) fn deviation(x: &[f64]) -> f64 {
    let m = mean(x);
    (x.iter().map(|x| (x - m).powi(2)).sum::<f64>() / (x.len() - 1) as f64).sqrt()
}

#[test]
fn holds_every_mode_of_close_pairs_and_no_other_unbiased_with_its_scatter_stated() {
    let truth = ReferenceCase::ClosePairs.made(0).unwrap().modes;
    let runs: Vec<Modes> = SEEDS
        .map(|seed| {
            let modes = found(&ReferenceCase::ClosePairs.made(seed).unwrap());
            matched(&truth, &modes, seed);
            modes
        })
        .collect();
    let (mut biases, mut ratios) = (Vec::new(), Vec::new());
    for (i, truth) in truth.iter().enumerate() {
        let of = |value: &dyn Fn(&dolmen::modal::Mode) -> f64| -> Vec<f64> {
            runs.iter().map(|r| value(&r.modes[i])).collect()
        };
        let f = of(&|m| m.frequency_hz / truth.frequency_hz - 1.0);
        let zeta = of(&|m| m.damping_ratio.unwrap() / truth.damping_ratio - 1.0);
        let error = deviation(&f) / (runs.len() as f64).sqrt();
        assert!(
            mean(&f).abs() < 5e-4 + error,
            "{} Hz: bias {:e}",
            truth.frequency_hz,
            mean(&f)
        );
        assert!(
            mean(&zeta).abs() < 0.07,
            "{} Hz: bias of ζ {}",
            truth.frequency_hz,
            mean(&zeta)
        );
        biases.push(mean(&f));
        let stated_f = mean(&of(&|m| m.frequency_sd_hz.unwrap() / truth.frequency_hz));
        let stated_zeta = mean(&of(&|m| m.damping_ratio_sd.unwrap() / truth.damping_ratio));
        ratios.push((stated_f / deviation(&f)).powi(2));
        ratios.push((stated_zeta / deviation(&zeta)).powi(2));
    }
    assert!(mean(&biases).abs() < 2e-4, "mean bias {:e}", mean(&biases));
    let ratio = mean(&ratios).sqrt();
    assert!((0.8..1.25).contains(&ratio), "stated over true scatter {ratio}");
}

#[test]
fn holds_two_channels_of_any_quantity_show_both_modes() {
    for quantity in [Quantity::Acceleration, Quantity::Displacement] {
        for seed in 100..105 {
            let made = MadeRecord {
                quantity,
                ..ReferenceCase::ShearChain.made(seed).unwrap()
            };
            matched(&made.modes, &found(&made), seed);
        }
    }
}

#[test]
fn holds_plscf_finds_every_mode_and_no_other() {
    let options = Identify {
        method: Method::Plscf,
        ..Identify::default()
    };
    let seeds = [
        (ReferenceCase::ShearChain, 100..105),
        (ReferenceCase::ClosePairs, 100..102),
    ];
    for (case, seeds) in seeds {
        for seed in seeds {
            let made = case.made(seed).unwrap();
            let modes = identify(&made.make().unwrap(), &options).unwrap().modes;
            matched(&made.modes, &modes, seed);
            for mode in &modes.modes {
                assert!(mode.frequency_sd_hz.is_some() && mode.damping_ratio_sd.is_some());
                assert!(mode.shape_sd.is_none(), "the method gives none");
            }
        }
    }
}

#[test]
fn holds_scale_order_and_sign_of_channels_do_not_move_the_modes() {
    let made = ReferenceCase::ClosePairs.made(100).unwrap();
    let record = made.make().unwrap();
    let l = record.channels().len();
    let turned: Vec<Vec<f64>> = (0..l)
        .map(|c| record.samples(l - 1 - c).iter().map(|y| -1e-4 * y).collect())
        .collect();
    let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
    let turned = Record::new(names, turned, record.sampling_rate_hz()).unwrap();
    let (a, b) = (
        identify(&record, &Identify::default()).unwrap(),
        identify(&turned, &Identify::default()).unwrap(),
    );
    assert_eq!(a.modes.modes.len(), b.modes.modes.len());
    for (a, b) in a.modes.modes.iter().zip(&b.modes.modes) {
        assert!((a.frequency_hz / b.frequency_hz - 1.0).abs() < 1e-9);
        let mirrored: Vec<Complex64> = b.shape.iter().rev().copied().collect();
        assert!(assurance(&a.shape, &mirrored) > 1.0 - 1e-9);
    }
    let again = identify(&record, &Identify::default()).unwrap();
    assert_eq!(a.modes, again.modes, "the same record gives the same bits");
}

fn refusal(record: &Record, options: &Identify) -> String {
    identify(record, options).unwrap_err().to_string()
}

#[test]
fn refuses_what_cannot_work_and_says_what_to_do() {
    let record = ReferenceCase::ShearChain.made(100).unwrap().make().unwrap();
    let with = |change: fn(&mut Identify)| {
        let mut options = Identify::default();
        change(&mut options);
        refusal(&record, &options)
    };
    let message = with(|o| o.modes_wanted = Some(40));
    assert!(
        message.starts_with(
            "modes_wanted is 40, but a model of order 24 holds at most 12 modes: raise order_most"
        ),
        "{message}"
    );
    let message = with(|o| o.modes_wanted = Some(5));
    assert!(
        message.starts_with("modes_wanted is 5, but only 2 were found stable"),
        "{message}"
    );
    let message = with(|o| o.block_rows = Some(3));
    assert!(
        message.starts_with("block_rows is 3, but the lowest mode of interest (1."),
        "{message}"
    );
    let message = with(|o| o.order_most = Some(200));
    assert!(
        message.contains("block rows of 2 channels allow at most"),
        "{message}"
    );
    let message = with(|o| o.frequency_low_hz = Some(-1.0));
    assert!(
        message.starts_with("frequency_low_hz is -1, but must be"),
        "{message}"
    );
    let message = with(|o| o.decimation = Some(0));
    assert!(
        message.starts_with("decimation is 0, but must be at least 1"),
        "{message}"
    );

    let short = Record::new(
        record.channels().to_vec(),
        (0..2).map(|c| record.samples(c)[..300].to_vec()).collect(),
        100.0,
    );
    let message = refusal(&short.unwrap(), &Identify::default());
    assert!(
        message.starts_with("the record has 300 samples, but"),
        "{message}"
    );

    let dead = Record::new(
        record.channels().to_vec(),
        vec![record.samples(0).to_vec(), vec![0.25; record.length()]],
        100.0,
    );
    let message = refusal(&dead.unwrap(), &Identify::default());
    assert!(
        message.starts_with("channel \"made 2\" is dead: every sample is 0.25"),
        "{message}"
    );

    let modes = found(&ReferenceCase::ShearChain.made(100).unwrap());
    let message = modes.nearest(2.0, 0.1).unwrap_err().to_string();
    assert!(
        message.starts_with("no mode was found at 2 Hz (± 0.100 Hz); the modes found lie at 1."),
        "{message}"
    );
}

#[test]
fn refuses_to_find_modes_in_white_noise() {
    let silent = MadeRecord {
        noise_ratio: 1e6,
        ..ReferenceCase::ShearChain.made(100).unwrap()
    };
    match identify(&silent.make().unwrap(), &Identify::default()) {
        Ok(analysis) => assert!(analysis.modes.modes.is_empty(), "{:?}", analysis.modes),
        Err(fault) => assert!(
            fault.to_string().starts_with("no peak of the spectrum rises"),
            "{fault}"
        ),
    }
}

#[test]
fn holds_a_picked_mode_is_the_one_there_or_an_error() {
    let record = ReferenceCase::ShearChain.made(100).unwrap().make().unwrap();
    let picked = |hz: f64| {
        let options = Identify {
            pick_hz: vec![hz],
            ..Default::default()
        };
        identify(&record, &options).map(|found| found.modes.modes)
    };
    let modes = picked(4.22).unwrap();
    assert_eq!(modes.len(), 1);
    assert!((modes[0].frequency_hz - 4.2).abs() < 0.05);
    let fault = picked(3.0).unwrap_err().to_string();
    assert!(
        fault.starts_with("no mode was found at 3 Hz (± 0.060 Hz); the modes found lie at 1."),
        "{fault}"
    );
}

#[test]
fn holds_both_subspace_methods_and_a_few_references_find_the_modes() {
    let made = ReferenceCase::ClosePairs.made(101).unwrap();
    let record = made.make().unwrap();
    for (method, references) in [
        (Method::SsiCov, vec![]),
        (Method::SsiCov, vec![0, 1, 6, 7]),
        (Method::SsiData, vec![0, 1, 6, 7]),
    ] {
        let options = Identify {
            method,
            references,
            ..Default::default()
        };
        let found = identify(&record, &options).unwrap().modes;
        matched(&made.modes, &found, 101);
        for (mode, truth) in found.modes.iter().zip(&made.modes) {
            let sd_hz = mode.frequency_sd_hz.unwrap();
            assert!(
                (mode.frequency_hz - truth.frequency_hz).abs() < 4.5 * sd_hz,
                "{mode:?}"
            );
            assert!(sd_hz < 3.0 * mode.frequency_floor_hz(), "{mode:?}");
        }
    }
}

#[test]
fn holds_damping_of_separated_modes_from_their_peaks_without_bias() {
    for method in [Method::Efdd, Method::Fsdd] {
        let options = Identify {
            method,
            ..Default::default()
        };
        let runs: Vec<Modes> = SEEDS
            .map(|seed| {
                let made = ReferenceCase::ShearChain.made(seed).unwrap();
                let found = identify(&made.make().unwrap(), &options).unwrap().modes;
                matched(&made.modes, &found, seed);
                found
            })
            .collect();
        for i in 0..2 {
            let zeta: Vec<f64> = runs
                .iter()
                .map(|run| run.modes[i].damping_ratio.unwrap() / 0.02 - 1.0)
                .collect();
            let error = deviation(&zeta) / (zeta.len() as f64).sqrt();
            assert!(
                mean(&zeta).abs() < 0.1 + error,
                "{method:?}: bias of ζ {} ± {error}",
                mean(&zeta)
            );
            // the bias of the window alone would have been at least half as large again
            let window: Vec<f64> = runs.iter().map(|run| run.modes[i].window_bias.unwrap()).collect();
            assert!(mean(&window) > 0.05, "{window:?}");
        }
    }
}

#[test]
fn holds_80_seconds_give_the_first_mode_with_fewer_blocks_and_say_so() {
    let made = MadeRecord {
        duration_s: 80.0,
        ..ReferenceCase::ShearChain.made(100).unwrap()
    };
    let longer = Identify {
        block_rows: Some(20), // lags that 80 s hold 28 times
        ..Default::default()
    };
    let found = identify(&made.make().unwrap(), &longer).unwrap();
    let first = found.modes.nearest(1.1, 0.02).unwrap(); // the second is not always settled in 80 s of two channels
    assert!((first.frequency_hz - 1.1).abs() < 3.0 * first.frequency_sd_hz.unwrap());
    assert!(found.settings.time_blocks < 30, "{:?}", found.settings);
    let message = found.notes[0].to_string();
    assert!(
        message.starts_with("the record is short: standard deviations come from "),
        "{message}"
    );
}

/// Steel and single stones have less than 0.2 %. Such modes are found if they are wider than one and a half lines of the record, or
/// if the user gives a smaller limit.
#[test]
fn holds_a_mode_damped_by_less_than_usual_is_found_when_asked_for() {
    let mode = |frequency_hz, damping_ratio, shape: [f64; 4]| MadeMode {
        frequency_hz,
        damping_ratio,
        shape: shape.to_vec(),
    };
    let weak = mode(3.1, 0.0008, [0.3, 0.6, 0.8, 1.0]);
    let narrow = mode(5.2, 0.000_15, [0.6, 1.0, -0.4, -0.7]);
    let made = MadeRecord {
        modes: vec![
            weak.clone(),
            narrow.clone(),
            mode(8.3, 0.01, [-0.8, -0.9, 0.2, 1.0]),
        ],
        duration_s: 1200.0,
        seed: 3,
        ..MadeRecord::default()
    };
    let record = made.make().unwrap();
    let hz = |options: &Identify| identify(&record, options).unwrap().modes;
    let usual = hz(&Identify::default());
    matched(&[weak.clone(), made.modes[2].clone()], &usual, made.seed);
    let criteria = Criteria {
        damping_ratio_least: Some(0.000_05),
        ..Criteria::default()
    };
    let found = hz(&Identify {
        criteria,
        ..Identify::default()
    });
    matched(&made.modes, &found, made.seed);
    let sd = found.modes[0].frequency_sd_hz.unwrap();
    let off = (found.modes[0].frequency_hz - weak.frequency_hz).abs();
    assert!(off < 3.0 * sd && sd < 0.002, "{off} Hz off, {sd} Hz stated");
    let ratio = found.modes[0].damping_ratio.unwrap() / weak.damping_ratio;
    assert!((ratio - 1.0).abs() < 0.6, "{ratio} of the damping");
}
