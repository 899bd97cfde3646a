//! Records with a main shock and an aftershock, and records that miss part of an earthquake.
//!
//! SOURCE      simulated records with known times and stiffness
//! GOAL        Every earthquake is found, the other parts contain none, and each has its own lasting change; a value that a record may miss
//!             is "at least".
//! PARAMETERS  two storeys, 2.5 and 6.5 Hz, 2 %; the first earthquake leaves the stiffness unchanged, the second leaves 90 % of it
//! PUBLISHED   nothing; frequencies in closed form
//! TOLERANCE   two of the stated standard deviations; counts by binomial chance

use dolmen::modal::{
    AtLeast, Identify, LastingChange, Losses, MadeEarthquake, Part, StrongMotion, strong_motion,
};
use dolmen::signal::Record;

/// A quiet part, a shock without damage, and a shock that leaves 90 % of the stiffness: three records, joined in this order.
fn two(seed: u64, [first, second]: [f64; 2]) -> Record {
    let shock = |seed: u64, peak_m_s2: f64, softened: [f64; 2]| {
        let made = MadeEarthquake {
            seed,
            duration_s: 220.0,
            arrival_s: 80.0,
            peak_m_s2,
            softened,
            ..MadeEarthquake::default()
        };
        made.make().unwrap()
    };
    let both = [
        shock(seed, first, [0.85, 1.0]),
        shock(seed + 500, second, [0.7, 0.9]),
    ];
    let samples = (0..3).map(|c| both.iter().flat_map(|of| of.samples(c)).copied().collect());
    Record::new(both[0].channels().to_vec(), samples.collect(), 100.0).unwrap()
}

fn found(record: &Record, losses: &Losses) -> StrongMotion {
    strong_motion(record, &Identify::default(), losses).unwrap()
}

fn is_within(of: &LastingChange, truth: f64) -> bool {
    (of.ratio - truth).abs() < 1.96 * of.ratio_sd.unwrap()
}

#[test]
fn holds_a_main_shock_and_its_aftershock_are_two_with_a_change_each() {
    const RUNS: u64 = 6;
    let left = 0.9_f64.sqrt() - 1.0;
    let (mut first, mut second, mut in_all) = (0, 0, 0);
    for seed in 0..RUNS {
        let sizes = [[2.0, 1.2], [0.5, 2.0]][seed as usize % 2];
        let found = found(&two(seed, sizes), &Losses::default());
        let arrivals: Vec<f64> = found.events.iter().map(|of| of.shaking.arrival_s).collect();
        let [one, other] = arrivals[..] else {
            panic!("{seed} {arrivals:?}")
        };
        assert!(
            (one - 80.0).abs() < 2.5 && (other - 300.0).abs() < 2.5,
            "{arrivals:?}"
        );
        let spans: Vec<[f64; 2]> = found.quiet.iter().map(|of: &Part| of.span_s).collect();
        assert!(
            spans[0][1] < 80.5 && spans[1][0] > 100.0 && spans[1][1] < 300.5 && spans[2][0] > 320.0,
            "{spans:?}"
        );
        // noise and mean of each are those of the quiet part before it
        let noise = |event: usize| found.events[event].channels[2].noise;
        assert!(
            (noise(1) / noise(0) - 1.0).abs() < 0.3,
            "{} {}",
            noise(0),
            noise(1)
        );
        first += usize::from(is_within(&found.events[0].changes[0], 0.0));
        second += usize::from(is_within(&found.events[1].changes[0], left));
        in_all += usize::from(is_within(&found.changes[0], left));
        assert_eq!(found.compared, Some([0, 2]));
        let lasting = found.lasting().unwrap();
        assert!(lasting.before_hz < 3.0 && found.events[1].lasting().is_some());
    }
    let least = RUNS as usize - 1;
    assert!(
        first >= least && second >= least && in_all >= least,
        "{first} {second} {in_all}"
    );
}

#[test]
fn holds_what_a_record_misses_is_at_least() {
    let record = two(3, [2.0, 1.2]);
    let why = |found: &StrongMotion, event: usize| {
        found.events[event]
            .channels
            .iter()
            .map(|of| of.at_least)
            .collect::<Vec<_>>()
    };
    let whole = found(&record, &Losses::default());
    assert_eq!([why(&whole, 0), why(&whole, 1)], [[None; 3], [None; 3]]);
    // only the larger earthquake is clipped
    let clipped = Losses {
        clipped: vec!["roof".to_owned()],
        ..Losses::default()
    };
    let clipped = found(&record, &clipped);
    let at = if whole.largest().shaking.arrival_s < 200.0 {
        0
    } else {
        1
    };
    assert_eq!(why(&clipped, at), [None, None, Some(AtLeast::Clipped)]);
    assert_eq!(why(&clipped, 1 - at), [None; 3]);
    // eight seconds are lost during the first earthquake
    let mut samples: Vec<Vec<f64>> = (0..3).map(|c| record.samples(c).to_vec()).collect();
    samples.iter_mut().for_each(|own| own[8300..9100].fill(0.0));
    let holed = Record::new(record.channels().to_vec(), samples, 100.0).unwrap();
    let lost = Losses {
        lost_s: vec![[82.99, 91.0]],
        ..Losses::default()
    };
    let lost = found(&holed, &lost);
    assert_eq!(lost.events.len(), 2);
    assert!((lost.events[0].shaking.arrival_s - 80.0).abs() < 2.5);
    assert_eq!(why(&lost, 0), [Some(AtLeast::Lost); 3]);
    assert_eq!(why(&lost, 1), [None; 3]);
    assert!(
        lost.quiet.iter().all(|of| of.analysis.is_some()),
        "before is used"
    );
    // the record begins during an earthquake
    let rest = dolmen::signal::cut(record, 84.0, 290.0).unwrap();
    let edge = found(&rest, &Losses::default());
    assert_eq!(why(&edge, 0), [Some(AtLeast::Edge); 3]);
    let later = edge.later(84.0);
    assert!((later.events[0].shaking.arrival_s - 84.0).abs() < 0.6);
    assert!(later.events[0].channels[0].peak_at_s > 84.0 && later.quiet[1].span_s[1] > 280.0);
}

#[test]
fn holds_modes_above_the_ground_are_of_one_state() {
    // only the strong phase: afterwards the structure is stiffer again, and each mode would be found twice
    for seed in 0..4 {
        let made = MadeEarthquake {
            seed,
            softened: [0.7, 0.92],
            ..MadeEarthquake::default()
        };
        let options = Identify {
            inputs: vec![0],
            ..Identify::default()
        };
        let found = strong_motion(&made.make().unwrap(), &options, &Losses::default()).unwrap();
        let dolmen::modal::During::Driven(of) = &found.events[0].during else {
            panic!("{seed} {:?}", found.events[0].during)
        };
        let all: Vec<f64> = of
            .analysis
            .modes
            .modes
            .iter()
            .map(|mode| mode.frequency_hz)
            .collect();
        let near = |hz: f64| all.iter().filter(|of| (*of / hz - 1.0).abs() < 0.2).count();
        let truth = MadeEarthquake::frequencies_hz(made.softened[0]);
        assert_eq!(truth.map(near), [1, 1], "{seed} {all:?}");
    }
}

#[test]
fn holds_the_intervals_of_both_modes_hold_the_change() {
    const RUNS: u64 = 12;
    let (mut inside, mut of) = (0, 0);
    for seed in 100..100 + RUNS {
        let made = MadeEarthquake {
            seed,
            ..MadeEarthquake::default()
        };
        let found = found(&made.make().unwrap(), &Losses::default());
        let truth = made.softened[1].sqrt() - 1.0;
        for change in &found.changes {
            (inside, of) = (inside + usize::from(is_within(change, truth)), of + 1);
        }
        assert!(found.lasting().unwrap().before_hz < 3.0, "the lowest leads");
    }
    assert!(
        inside + 3 >= of && of + 2 >= 2 * RUNS as usize,
        "{inside} of {of}"
    );
}
