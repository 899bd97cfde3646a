// SOURCE     Park and Min (2010), Figs 4 and 5: in its translational modes, the columns of Heunginjimun have equal amplitude and phase.
// GOAL       Columns that move together, or as points of a rotating floor, raise no alarm beyond the stated probability; a column that
//            moves separately is found.
//
//     c1   c2   c3   c4      u_c = a + θ s_c      →  one column with another amplitude, or another phase
//     |    |    |    |
//   ──┴────┴────┴────┴──  → y
//
// PARAMETERS Two levels of four columns along x that move in y, at 1.1 and 4.2 Hz, damping 2 %; simulated ambient records, noise 10 %.
// PUBLISHED  The similarity only; no numbers.
// TOLERANCE  A false alarm in at most 1 % of surveys, calibration included; none in the twelve surveys of this test. Closed forms 1e-12.

use crate::made_mode::made_mode;
use dolmen::modal::{Identify, MadeMode, MadeRecord, Method, Mode, Modes, identify};
use dolmen::signal::{Channel, Quantity};
use dolmen::structure::{ColumnsMove, ColumnsOfLevel, ColumnsTogether, columns_together};
use dolmen_linalg::Complex64;

const Y: [f64; 3] = [0.0, 1.0, 0.0];
const ASIDE_M: [f64; 4] = [0.0, 4.0, 8.5, 13.0];
const HEIGHT_M: [f64; 2] = [5.84, 13.53];

fn channels() -> Vec<Channel> {
    let each = HEIGHT_M.iter().enumerate();
    let each = each.flat_map(|(level, z)| {
        ASIDE_M.iter().enumerate().map(move |(column, x)| Channel {
            name: format!("c{}{}", level + 1, column + 1),
            quantity: Quantity::Acceleration,
            position_m: Some([*x, 0.0, *z]),
            direction: Some(Y),
        })
    });
    each.collect()
}

/// Shapes of the two modes at all sensors, with a rotation of the floors and a factor on the first level's third column.
fn shapes(turn_of_13_m: f64, third: f64) -> [Vec<f64>; 2] {
    [[0.85, 1.0], [1.0, -0.75]].map(|levels| {
        let mut shape: Vec<f64> = levels
            .iter()
            .flat_map(|u| ASIDE_M.iter().map(move |x| u * (1.0 + turn_of_13_m * x / 13.0)))
            .collect();
        shape[2] *= third;
        shape
    })
}

fn seen(seed: u64, shapes: [Vec<f64>; 2]) -> Vec<ColumnsOfLevel> {
    let frequencies_hz = [1.1, 4.2];
    let modes = frequencies_hz
        .into_iter()
        .zip(shapes)
        .map(|(frequency_hz, shape)| MadeMode {
            frequency_hz,
            damping_ratio: 0.02,
            shape,
        });
    let record = MadeRecord {
        modes: modes.collect(),
        sampling_rate_hz: 20.0,
        seed,
        ..MadeRecord::default()
    };
    let mut found = identify(&record.make().unwrap(), &Identify::default())
        .unwrap()
        .modes;
    found.channels = channels();
    columns_together(&found, Y, &ColumnsTogether::default())
}

#[test]
fn holds_columns_that_move_as_one_raise_no_alarm_and_one_apart_is_named() {
    for seed in 1..=6 {
        let as_one = seen(seed, shapes(0.0, 1.0));
        assert_eq!(as_one.len(), 4, "two levels in two modes");
        assert!(
            as_one.iter().all(|level| level.moves == ColumnsMove::AsOne),
            "{seed}: {as_one:?}"
        );
        // the floor of an eccentric hall: its columns are on one line
        let turning = seen(seed, shapes(0.3, 1.0));
        assert!(
            turning.iter().all(|level| level.moves == ColumnsMove::Turning),
            "{seed}: {turning:?}"
        );
        // a loose foot: a quarter more motion than the others
        let apart = seen(seed, shapes(0.0, 1.25));
        for level in &apart {
            match level.height_m == HEIGHT_M[0] {
                true => assert_eq!(
                    level.moves,
                    ColumnsMove::Apart { any_of: vec![2] },
                    "{seed}: {level:?}"
                ),
                false => assert_eq!(level.moves, ColumnsMove::AsOne, "{seed}: {level:?}"),
            }
        }
        let [first, ..] = apart.as_slice() else { panic!() };
        let third = &first.columns[2];
        assert!(
            (third.of_others.norm() - 1.25).abs() < 4.0 * third.of_others_sd,
            "{third:?}"
        );
    }
}

/// One mode with these ordinates at one level of columns, each with a deviation of one hundredth.
fn one_level(ordinates: &[Complex64]) -> ColumnsMove {
    let mode = Mode {
        shape_sd: Some(vec![0.01; ordinates.len()]),
        ..made_mode(1.1, ordinates.to_vec())
    };
    let modes = Modes {
        modes: vec![mode],
        channels: channels()[..ordinates.len()].to_vec(),
        method: Method::SsiCov,
        duration_s: 600.0,
        history: vec![],
    };
    let options = ColumnsTogether { calibration: 0.0 };
    columns_together(&modes, Y, &options).remove(0).moves
}

#[test]
fn exact_the_limits_are_those_of_chi_squared() {
    let real = |x: f64| Complex64::new(x, 0.0);
    // two columns: χ² = d²/2 sd², two degrees of freedom: exp(−χ²/2) = 0.01 at d = sd √(4 ln 100)
    let limit = 0.01 * (4.0 * 100.0_f64.ln()).sqrt();
    assert_eq!(
        one_level(&[real(1.0), real(1.0 - 0.999 * limit)]),
        ColumnsMove::AsOne
    );
    assert_eq!(
        one_level(&[real(1.0), real(1.0 - 1.002 * limit)]),
        ColumnsMove::TwoDiffer
    );
    // a difference in phase counts like one in amplitude
    let behind = |angle: f64| Complex64::from_polar(1.0, angle);
    assert_eq!(
        one_level(&[behind(0.0), behind(0.0), behind(0.3), behind(0.0)]),
        ColumnsMove::Apart { any_of: vec![2] }
    );
    // four columns on a line agree with a floor, but no three are equal
    let floor = ASIDE_M.map(|x| real(1.0 - 0.05 * x));
    assert_eq!(one_level(&floor), ColumnsMove::Turning);
    // three different columns, not on a line: no single column explains the motion
    assert_eq!(
        one_level(&[real(1.0), real(0.5), real(0.9)]),
        ColumnsMove::Apart { any_of: vec![] }
    );
    // a rotating floor, with one column moving separately
    let mut off = floor;
    off[1] += real(0.2);
    assert_eq!(one_level(&off), ColumnsMove::Apart { any_of: vec![1] });
}

#[test]
fn holds_what_cannot_be_told_says_nothing() {
    let shape = vec![Complex64::new(1.0, 0.0); 4];
    let modes = |sd: Option<Vec<f64>>, channels: Vec<Channel>| Modes {
        modes: vec![Mode {
            shape_sd: sd,
            ..made_mode(1.1, shape.clone())
        }],
        channels,
        method: Method::Fdd,
        duration_s: 600.0,
        history: vec![],
    };
    let options = ColumnsTogether::default();
    let level = || channels()[..4].to_vec();
    assert!(columns_together(&modes(None, level()), Y, &options).is_empty());
    assert!(columns_together(&modes(Some(vec![0.01; 4]), level()), [1.0, 0.0, 0.0], &options).is_empty());
    let apart = (0..4).map(|i| Channel {
        position_m: Some([0.0, 0.0, i as f64]),
        ..level()[i].clone()
    });
    assert!(columns_together(&modes(Some(vec![0.01; 4]), apart.collect()), Y, &options).is_empty());
}
