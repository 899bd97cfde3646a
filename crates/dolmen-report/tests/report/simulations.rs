// SOURCE     glTF 2.0 specification (Khronos, 2021), sec. 3 and 4: binary container, accessors, animations.
// GOAL       Words, JSON, figures and animation describe a simulation alike; the animation is valid and moves as the history does.
// PARAMETERS Two blocks of 0.3 × 0.2 × 0.1 m under a pulse of 0.6 g along x, μ 0.3.
// TOLERANCE  single precision in the animation (6e-8 of a position); none elsewhere.

use dolmen::assess::{DamageState, DamageThresholds, stack_damage};
use dolmen::blocks::{ContactLaw, Outcome, Springs, simulate_springs};
use dolmen::signal::{Component, GroundMotion};
use dolmen::stability::stack::{StackLimits, stack_limits};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use dolmen_project::Names;
use dolmen_report::figures::{
    Shaking, stack_after, stack_capacity, stack_governing, stack_histories, stack_view,
};
use dolmen_report::film::{FILM_STEP_S, stack_film};
use dolmen_report::json::simulation_json;
use dolmen_report::tables::{energy_csv, joints_csv, poses_csv};
use dolmen_report::text::{TextStyle, simulation_text};
use dolmen_words::Language;
use dolmen_work::motion::MotionAnswer;
use dolmen_work::stack::{StackRuns, StackSimulation};
use serde_json::Value;

fn simulation() -> StackSimulation {
    let block = |name: &str, z: f64| Block {
        name: name.into(),
        solid: Solid::cuboid(0.3, 0.2, 0.1).unwrap().placed(&Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        }),
        density_kg_m3: 2600.0,
    };
    let blocks = vec![block("lower", 0.0), block("upper, \"odd\" <one>", 0.1)];
    let stack = Stack::new(blocks, JointMaterial::with_friction(0.3), 9.80665).unwrap();
    let pulse = vec![0.0, 5.884, 5.884, -5.884, -5.884, 0.0];
    let motion = GroundMotion::new("pulse", 0.05, vec![(Component::X, pulse)]).unwrap();
    let options = Springs {
        rest_s: 0.25,
        ..Springs::default()
    };
    let history = simulate_springs(&stack, Some(&motion), &options, &mut |_| true).unwrap();
    let limits = stack_limits(&stack, &StackLimits::default()).unwrap();
    StackSimulation {
        without_wind: false,
        tilt_left_out: None,
        gaps: None,
        lean: None,
        measured_by: None,
        loosened: Vec::new(),
        damage: stack_damage(&stack, &limits, &history, &DamageThresholds::default()),
        limits,
        file: "project.toml".into(),
        name: Names {
            en: Some("Two blocks".into()),
            ko: Some("블록 2단".into()),
        },
        variant: None,
        stack,
        motion: MotionAnswer {
            files: vec![(Component::X, "pulse.csv".into())],
            peaks_read_m_s2: vec![(Component::X, 5.884)],
            turned_rad: None,
            taken_off: None,
            measured: None,
            motion,
        },
        law: ContactLaw::Springs(options),
        history,
    }
}

/// The terminal text in one line.
fn said_of(simulation: &StackSimulation) -> String {
    let text = simulation_text(&StackRuns::of(simulation.clone()), TextStyle::plain());
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The terminal text on its outcome.
fn ended(simulation: &StackSimulation) -> String {
    let said = said_of(simulation);
    let (_, ended) = said.split_once("-------------------- ").unwrap();
    ended.trim_start_matches("! ").to_owned()
}

/// The JSON and the numbers of a .glb.
fn opened(film: &[u8]) -> (Value, Vec<u8>) {
    let word = |at: usize| u32::from_le_bytes(film[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&film[..4], word(4), word(8)), (&b"glTF"[..], 2, film.len()));
    let text = word(12);
    assert_eq!((&film[16..20], text % 4), (&b"JSON"[..], 0));
    let bytes = word(20 + text);
    assert_eq!((&film[24 + text..28 + text], bytes % 4), (&b"BIN\0"[..], 0));
    assert_eq!(28 + text + bytes, film.len());
    (
        serde_json::from_slice(&film[20..20 + text]).unwrap(),
        film[28 + text..].to_vec(),
    )
}

/// The rows of an accessor.
fn rows(json: &Value, bytes: &[u8], accessor: &Value) -> Vec<Vec<f64>> {
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    let width = match accessor["type"].as_str().unwrap() {
        "SCALAR" => 1,
        "VEC3" => 3,
        _ => 4,
    };
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let (start, length) = (
        view["byteOffset"].as_u64().unwrap(),
        view["byteLength"].as_u64().unwrap(),
    );
    let numbers: Vec<f64> = bytes[start as usize..(start + length) as usize]
        .chunks(4)
        .map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap())))
        .collect();
    assert_eq!(numbers.len() as u64, width * accessor["count"].as_u64().unwrap());
    numbers.chunks(width as usize).map(<[f64]>::to_vec).collect()
}

#[test]
fn exact_film_moves_each_block_as_its_history_does() {
    let simulation = simulation();
    let (json, bytes) = opened(&stack_film(&simulation));
    assert_eq!(json["nodes"].as_array().unwrap().len(), 4); // z up to y up, ground, two blocks
    let animation = &json["animations"][0];
    let time_s = &simulation.history.time_s;
    for channel in animation["channels"].as_array().unwrap() {
        let sampler = &animation["samplers"][channel["sampler"].as_u64().unwrap() as usize];
        let times = rows(&json, &bytes, &sampler["input"]);
        assert!(times.windows(2).all(|pair| pair[1][0] > pair[0][0]));
        let end = time_s.last().unwrap();
        assert!(
            (times.last().unwrap()[0] / end - 1.0).abs() < 1e-6
                && times.len() as f64 >= 0.4 * end / FILM_STEP_S
        );
        let values = rows(&json, &bytes, &sampler["output"]);
        assert_eq!(values.len(), times.len());
        let block = channel["target"]["node"].as_u64().unwrap() as usize - 2;
        let last = simulation.poses(simulation.samples() - 1)[block];
        let [w, x, y, z] = last.rotation;
        let exact = match channel["target"]["path"].as_str().unwrap() {
            "translation" => last.centroid_m.to_vec(),
            _ => vec![x, y, z, w],
        };
        for (found, exact) in values.last().unwrap().iter().zip(exact) {
            assert!((found - exact).abs() < 6e-8, "{found} {exact}");
        }
    }
    // a box of 12 triangles about its own centroid
    let place = &json["meshes"][1]["primitives"][0]["attributes"]["POSITION"];
    let corners = rows(&json, &bytes, place);
    assert_eq!(corners.len(), 36);
    assert!(corners.iter().all(|c| (c[2].abs() - 0.05).abs() < 1e-7));
}

#[test]
fn holds_tables_have_a_row_a_sample_and_names_cannot_break_them() {
    let simulation = simulation();
    for (table, columns) in [
        (joints_csv(&simulation), 1 + 4 * 2),
        (poses_csv(&simulation), 1 + 7 * 2),
        (energy_csv(&simulation), 8),
    ] {
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        assert_eq!(reader.headers().unwrap().len(), columns);
        assert_eq!(reader.records().map(Result::unwrap).count(), simulation.samples());
    }
}

#[test]
fn holds_every_end_has_its_word_and_its_kind() {
    let mut simulation = simulation();
    assert_eq!(simulation.history.outcome, Outcome::Stood);
    // a residual slip of half a joint's width is more than standing
    let joint = &mut simulation.damage.joints[0];
    (joint.residual_slip_m, joint.residual_slip_ratio) = (0.0125, 0.0125 / 0.3);
    let slip_mm = 1e3 * joint.peak_slip_m;
    simulation.damage.state = DamageState::Severe;
    let said = format!(
        "It shifted and stood; no stone fell. Largest for the width of its joint: 'lower' on 'ground' slipped by up to {slip_mm:.1} mm and lies \
         12.5 mm from its place, 4.2 % of the width (DS3)"
    );
    assert!(
        ended(&simulation).starts_with(&said),
        "{said}: {}",
        ended(&simulation)
    );
    assert_eq!(simulation_json(&simulation)["damage_state"], 3);
    // a run that ends before the motion has no verdict except a fall
    let law = simulation.law.clone();
    simulation.law = ContactLaw::Springs(Springs {
        duration_s: Some(0.1),
        ..Springs::default()
    });
    assert!(ended(&simulation).starts_with("The run ended before the motion: 0.10 s of its 0.25 s were run"));
    assert_eq!(
        simulation_json(&simulation)["outcome"]["kind"],
        "ended_before_the_motion"
    );
    assert!(!simulation.is_whole());
    simulation.law = law;
    for joint in &mut simulation.damage.joints {
        (joint.residual_slip_m, joint.residual_slip_ratio) = (0.0, 0.0);
    }
    let ends = [
        (Outcome::Stood, "It stood; ", "stood"),
        (
            Outcome::Uplifted { joint: 1, at_s: 0.1 },
            "It rocked and stood; ",
            "rocked_and_stood",
        ),
        (
            Outcome::Slid {
                block: 1,
                slip_m: 0.0834,
                margin_ratio: 0.4,
            },
            "It slid and stood; no stone fell, but 'upper, \"odd\" <one>' lies 83.4 mm from its place; from its plumb line to the edge that carries it 40 %",
            "slid",
        ),
        (
            Outcome::Fell {
                block: 1,
                joint: 0,
                at_s: 0.2,
            },
            "It fell; 'upper, \"odd\" <one>' came down, first of all, at 0.20 s; by then '",
            "fell",
        ),
        (
            Outcome::Stopped { at_s: 0.2 },
            "The run was stopped at 0.20 s",
            "stopped",
        ),
        (
            Outcome::Diverged { at_s: 0.2 },
            "The run diverged at 0.2000 s",
            "diverged",
        ),
    ];
    for (outcome, word, kind) in ends {
        let falls = matches!(outcome, Outcome::Fell { .. });
        let whole = !matches!(outcome, Outcome::Stopped { .. } | Outcome::Diverged { .. });
        simulation.history.outcome = outcome;
        assert!(ended(&simulation).starts_with(word), "{}", ended(&simulation));
        assert_eq!(simulation_json(&simulation)["outcome"]["kind"], kind);
        assert_eq!((simulation.falls(), simulation.is_whole()), (falls, whole));
    }
}

#[test]
fn holds_energy_is_told_whole_and_a_run_that_makes_it_is_warned_of() {
    let mut simulation = simulation();
    let text = said_of(&simulation);
    assert!(
        text.contains("put in by the ground") && !text.contains("do not use this run"),
        "{text}"
    );
    simulation.history.energy_made_j = 0.01 * simulation.history.energy.last().unwrap().input_j;
    assert!(said_of(&simulation).contains("more than 0.1 %: do not use this run"));
}

#[test]
fn holds_figures_speak_both_languages_and_escape_names() {
    let simulation = simulation();
    let limits = stack_limits(&simulation.stack, &StackLimits::default()).unwrap();
    for (language, said) in [
        (
            Language::English,
            [
                "at the end, true scale",
                "residual displacements × ",
                "slides: a/g = μ",
                "peak of the motion that was run: 0.600",
            ],
        ),
        (
            Language::Korean,
            [
                "종료 시점, 실제 축척",
                "배 확대",
                "미끄러짐: a/g = μ",
                "해석한 지반운동의 최댓값: 0.600",
            ],
        ),
    ] {
        let shaking = Shaking {
            motion: Some(0.6),
            ..Shaking::default()
        };
        let mut all = vec![
            stack_view(&simulation.stack, language),
            stack_after(&simulation, language),
            stack_governing(&limits, &shaking, language),
            stack_capacity(&limits, &shaking, language),
        ];
        let histories = stack_histories(&simulation, language);
        assert_eq!(histories.len(), 5);
        all.extend(histories.into_iter().map(|figure| figure.svg));
        assert!(
            all.iter()
                .all(|svg| svg.starts_with("<svg") && !svg.contains("NaN") && !svg.contains("<one>"))
        );
        let page = all.concat();
        for said in said {
            assert!(page.contains(said), "{language:?}: {said}");
        }
    }
}
