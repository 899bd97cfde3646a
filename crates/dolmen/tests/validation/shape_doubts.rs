// SOURCE     Modes of a frame and of a chain with known stiffness, at sensors of which one is reversed, exchanged or in another unit.
// GOAL       Shapes that contradict the model are detected, and the answer names the change of sensors.
//
//        o x2, y2
//        |          modes along x and y  →  (a sensor is changed)  →  which one was it?
//        o x1, y1
//      /////
//
// PARAMETERS Gate: 180 and 120 t, x 30 and 18, y 45 and 30 MN/m. Flagpole of Naju (Choi 2021).
// PUBLISHED  Nothing.
// TOLERANCE  none: names; shares by closed form 1e-9.

use crate::choi_2021::{naju, twice_the_least};
use crate::made_mode::made_mode;
use dolmen::modal::{Method, Mode, Modes};
use dolmen::numeric::Random;
use dolmen::signal::{Channel, Quantity};
use dolmen::structure::{
    ChannelChange, Convention, Frame, LeftOut, ShapeDoubt, Storey, chain_shape_doubt, directional_modes,
    frame_shape_doubt,
};
use dolmen_linalg::Complex64;

fn gate() -> Frame {
    let storey = |mass_kg: f64, height_m: f64, axial_n: f64| Storey {
        mass_kg,
        height_m,
        axial_n,
    };
    let storeys = vec![storey(180e3, 4.8, 300e3 * 9.81), storey(120e3, 4.1, 120e3 * 9.81)];
    Frame::new(storeys, Convention::Drift).unwrap()
}

fn channel(name: &str, z: f64, direction: [f64; 3]) -> Channel {
    Channel {
        name: name.into(),
        quantity: Quantity::Acceleration,
        position_m: Some([0.0, 0.0, z]),
        direction: Some(direction),
    }
}

fn modes(channels: Vec<Channel>, mut all: Vec<(f64, Vec<f64>)>) -> Modes {
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let phase = Complex64::from_polar(1.0, 0.3);
    let mode = |(frequency_hz, shape): (f64, Vec<f64>)| Mode {
        frequency_sd_hz: Some(0.002 * frequency_hz),
        ..made_mode(frequency_hz, shape.into_iter().map(|x| phase * x).collect())
    };
    Modes {
        modes: all.into_iter().map(mode).collect(),
        channels,
        method: Method::SsiCov,
        duration_s: 600.0,
        history: vec![],
    }
}

/// x1, x2, y1, y2 of the gate.
fn of_gate() -> Modes {
    let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let channels = vec![
        channel("x1", 4.8, x),
        channel("x2", 8.9, x),
        channel("y1", 4.8, y),
        channel("y2", 8.9, y),
    ];
    let along = |k: [f64; 2], at: usize| {
        let found = gate().natural_modes(&k).unwrap();
        found.into_iter().map(move |mode| {
            let mut shape = vec![0.0; 4];
            shape[at..at + 2].copy_from_slice(&mode.displacement);
            (mode.frequency_hz, shape)
        })
    };
    let all = along([30e6, 18e6], 0).chain(along([45e6, 30e6], 2));
    modes(channels, all.collect())
}

fn changed(change: impl Fn(&mut Vec<Complex64>)) -> Option<ShapeDoubt> {
    let mut seen = of_gate();
    seen.modes.iter_mut().for_each(|mode| change(&mut mode.shape));
    frame_shape_doubt(&gate(), &seen)
}

#[test]
fn holds_shapes_of_the_model_are_not_doubted() {
    assert_eq!(changed(|_| {}), None);
    // nor do they agree with a chain
    let chain = naju();
    let k = twice_the_least(&chain);
    assert_eq!(chain_shape_doubt(&chain, &of_chain(&k, |_| {})), None);
}

#[test]
fn exact_the_change_that_was_made_of_a_gates_sensors_is_named() {
    let turned = changed(|shape| shape[1] = -shape[1]).unwrap();
    // with two sensors in a direction, either may be the changed one
    for name in ["x1", "x2"] {
        let channel = name.to_owned();
        assert!(
            turned.changes.contains(&ChannelChange::Turned { channel }),
            "{turned:?}"
        );
    }
    assert_eq!(turned.changes.len(), 2, "{turned:?}");
    assert!(
        turned.is_of(0) && turned.is_of(1) && turned.changed < 1e-9,
        "{turned:?}"
    );
    let mixed = changed(|shape| shape.swap(1, 3)).unwrap();
    let exchanged = |a: &str, b: &str| ChannelChange::Exchanged {
        channels: [a.to_owned(), b.to_owned()],
    };
    assert!(mixed.changes.contains(&exchanged("x2", "y2")), "{mixed:?}");
    let scaled = changed(|shape| shape[2] *= 10.0).unwrap();
    let tenth = |of: &ChannelChange| matches!(of, ChannelChange::Scaled { channel, factor } if channel == "y1" && (factor - 0.1).abs() < 1e-12);
    assert!(scaled.changes.iter().any(tenth), "{scaled:?}");
}

fn of_chain(k: &[f64], change: impl Fn(&mut Vec<f64>)) -> Modes {
    let chain = naju();
    let heights: Vec<f64> = chain
        .joint_heights_m()
        .into_iter()
        .skip(1)
        .chain([chain.height_m()])
        .collect();
    let channels = heights
        .iter()
        .map(|z| channel(&format!("{z:.2}"), *z, [1.0, 0.0, 0.0]));
    let found = chain.natural_modes(k).unwrap();
    let all = found.into_iter().map(|mode| {
        let mut shape: Vec<f64> = heights
            .iter()
            .map(|z| chain.displacement_at(&mode.coordinates, *z).unwrap())
            .collect();
        change(&mut shape);
        (mode.frequency_hz, shape)
    });
    modes(channels.collect(), all.collect())
}

#[test]
fn exact_of_a_chains_sensors_the_one_that_is_wrong_is_named_alone() {
    let chain = naju();
    let k = twice_the_least(&chain);
    let name = |at: usize| {
        let heights = chain.joint_heights_m();
        let z = heights.get(at + 1).copied().unwrap_or(chain.height_m());
        format!("{z:.2}")
    };
    for wrong in 0..chain.links().len() {
        let found = chain_shape_doubt(&chain, &of_chain(&k, |shape| shape[wrong] = -shape[wrong]));
        let Some(found) = found else {
            // the lowest point hardly moves
            assert_eq!(wrong, 0);
            continue;
        };
        let channel = name(wrong);
        assert_eq!(found.changes, [ChannelChange::Turned { channel }], "{found:?}");
    }
    let swapped = chain_shape_doubt(&chain, &of_chain(&k, |shape| shape.swap(1, 3))).unwrap();
    let channels = [name(1), name(3)];
    assert_eq!(
        swapped.changes,
        [ChannelChange::Exchanged { channels }],
        "{swapped:?}"
    );
}

#[test]
fn exact_axes_turned_by_an_angle_are_no_slip_of_one_sensor() {
    // the axes of all sensors are rotated by 35°: sin² of it is the share of every mode in the other direction
    let angle = 35_f64.to_radians();
    let (sin, cos) = angle.sin_cos();
    let turned = changed(|shape| {
        for (x, y) in [(0, 2), (1, 3)] {
            let (a, b) = (shape[x], shape[y]);
            shape[x] = a * cos + b * sin;
            shape[y] = b * cos - a * sin;
        }
    })
    .unwrap();
    assert!(
        turned.changes.is_empty() && turned.is_of(0) && turned.is_of(1),
        "{turned:?}"
    );
    assert!((turned.unexplained - sin * sin).abs() < 1e-9, "{turned:?}");
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];

fn frame(masses_kg: &[f64]) -> Frame {
    let storey = |mass_kg: &f64| Storey {
        mass_kg: *mass_kg,
        height_m: 4.0,
        axial_n: 0.0,
    };
    Frame::new(masses_kg.iter().map(storey).collect(), Convention::Drift).unwrap()
}

/// Modes of one storey at one place with a sensor along x and one along y.
fn of_one_storey(place: [f64; 2], all: &[(f64, [f64; 2])]) -> Modes {
    let at = |name: &str, direction| Channel {
        position_m: Some([place[0], place[1], 4.0]),
        ..channel(name, 4.0, direction)
    };
    let each = all.iter().map(|(hz, shape)| (*hz, shape.to_vec()));
    modes(vec![at("x", X), at("y", Y)], each.collect())
}

#[test]
fn holds_a_pair_of_one_frequency_mixed_in_plan_is_taken_apart_and_accuses_no_sensor() {
    let one = frame(&[20e3]);
    for (low, high) in [
        ([1.0, 0.64], [0.43, 1.0]),
        ([1.0, 1.0], [1.0, -1.0]),
        ([0.8, 0.6], [1.0, -0.2]),
        ([0.5, 1.0], [1.0, -0.5]),
    ] {
        let seen = of_one_storey([1.5, 1.5], &[(1.759, low), (1.771, high)]);
        assert_eq!(frame_shape_doubt(&one, &seen), None, "{low:?} {high:?}");
        let along = [X, Y].map(|direction| directional_modes(&seen, direction));
        assert!(along.iter().all(|of| of.modes.len() == 1), "{low:?}: {along:?}");
        let hz = along.map(|of| of.modes[0].frequency_hz);
        assert!(hz[0] != hz[1], "{hz:?}");
    }
    // 5 % apart they are not one pair
    let seen = of_one_storey([1.5, 1.5], &[(1.7, [1.0, 1.0]), (1.785, [1.0, -1.0])]);
    assert!(directional_modes(&seen, X).modes.is_empty());
}

#[test]
fn holds_a_turn_about_the_origin_beside_as_many_modes_as_storeys_is_torsion() {
    let one = frame(&[20e3]);
    let turn = (0.9, [-0.5, 1.0]);
    let seen = of_one_storey([3.0, 1.5], &[turn, (1.2, [0.0, 1.0]), (1.5, [1.0, 0.0])]);
    assert_eq!(frame_shape_doubt(&one, &seen), None);
    let mut along = directional_modes(&seen, Y);
    assert!(along.keep(&seen, 1).is_empty());
    assert!(
        along.modes.len() == 1 && along.modes[0].frequency_hz == 1.2,
        "{along:?}"
    );
    assert!(
        along.left_out.contains(&LeftOut::Turns { frequency_hz: 0.9 }),
        "{along:?}"
    );
    // seen at the column on the axis it is a motion along y: it stays, and the other is beyond the model
    let seen = of_one_storey(
        [3.0, 0.0],
        &[(0.9, [0.0, 1.0]), (1.2, [0.0, 1.0]), (1.5, [1.0, 0.0])],
    );
    let mut along = directional_modes(&seen, Y);
    let beyond = along.keep(&seen, 1);
    assert!(beyond.len() == 1 && beyond[0].frequency_hz == 1.2, "{beyond:?}");
    // axes turned by 27°: no mode is left out for it
    let seen = of_one_storey([3.0, 1.5], &[(1.2, [-0.5, 1.0]), (1.5, [1.0, 0.5])]);
    let mut along = directional_modes(&seen, Y);
    assert!(
        along.keep(&seen, 1).is_empty() && along.modes.len() == 1,
        "{along:?}"
    );
}

#[test]
fn holds_no_factor_that_makes_a_channel_vanish_is_advised() {
    // 40° between the axes of the sensors and the model: with either channel alone everything is explained
    let (sin, cos) = 40_f64.to_radians().sin_cos();
    let seen = of_one_storey([0.0, 0.0], &[(1.2, [-sin, cos]), (1.5, [cos, sin])]);
    let found = frame_shape_doubt(&frame(&[20e3]), &seen).unwrap();
    assert!(found.changes.is_empty(), "{found:?}");
}

#[test]
fn holds_noise_accuses_no_sensor_of_200_gates() {
    let mut random = Random::new(20260307, 0);
    let mut no_root = 0;
    for gate in 0..200 {
        let mut draw = |mean: f64, sd: f64| mean * (sd * random.normal()).exp();
        let masses = [draw(38e3, 0.3), draw(52e3, 0.3)];
        let of = frame(&masses);
        let channels = vec![
            channel("x1", 4.0, X),
            channel("x2", 8.0, X),
            channel("y1", 4.0, Y),
            channel("y2", 8.0, Y),
        ];
        let mut all = Vec::new();
        for at in [0, 2] {
            let k = [draw(6e6, 0.3), draw(4e6, 0.3)];
            let found = of.natural_modes(&k).unwrap();
            let hz: Vec<f64> = found
                .iter()
                .map(|mode| mode.frequency_hz * draw(1.0, 0.002))
                .collect();
            let ratio = hz[1] / hz[0] + hz[0] / hz[1];
            no_root += usize::from(ratio < 2.0 * (1.0 + masses[1] / masses[0]).sqrt());
            for (hz, mode) in hz.into_iter().zip(found) {
                let mut shape: Vec<f64> = (0..4).map(|_| draw(1.0, 0.01) - 1.0).collect();
                (0..2).for_each(|storey| shape[at + storey] += mode.displacement[storey]);
                all.push((hz, shape));
            }
        }
        let doubt = frame_shape_doubt(&of, &modes(channels, all));
        assert_eq!(doubt, None, "{gate}");
    }
    // some of them have frequencies without any exact stiffness
    assert!(no_root >= 3, "{no_root}");
}
