// SOURCE     examples/frame_on_soft_ground and examples/palisaden, written and read back; headers of glTF and PNG.
// GOAL       A record written for other programs reads back as the same record; figures, animated shapes and drawings can be used.
// TOLERANCE  1e-9 of a frequency for samples of 13 digits, none for doubles.

use super::verbs::Scratch;
use serde_json::Value;

const FRAME: &str = "examples/frame_on_soft_ground";
const HOUSE: &str = "examples/palisaden";

fn frequencies(json: &str) -> Vec<f64> {
    let value: Value = serde_json::from_str(json).unwrap();
    let modes = value["surveys"][0]["records"]["modes"]["modes"]
        .as_array()
        .unwrap();
    modes
        .iter()
        .map(|mode| mode["frequency_hz"].as_f64().unwrap())
        .collect()
}

#[test]
fn holds_a_record_written_as_uff_or_csv_has_the_same_modes() {
    let scratch = Scratch::with_examples("exchanged");
    let before = frequencies(&scratch.dolmen(&format!("identify {FRAME} --json")).stdout);
    assert_eq!(before.len(), 3);
    for (file, flag, ground, unit, within) in [
        ("text.uff", "", "1+X", "", 1e-9),
        ("binary.unv", " --binary", "1+X", "", 0.0),
        ("table.csv", "", "G [m/s2]", "unit = \"m/s2\"\n", 0.0),
    ] {
        let said = scratch.dolmen(&format!("record {FRAME} -o {file}{flag}"));
        assert_eq!((said.status, said.stdout.trim()), (0, file), "{}", said.stderr);
        let project = format!(
            "schema = 1\nkind = \"survey\"\nname = {{ en = \"Back\" }}\n[survey.one.records]\nfile = \"{file}\"\n{unit}\
             [survey.one.records.modal]\ninputs = [\"{ground}\"]\n"
        );
        std::fs::write(scratch.path().join("back.toml"), project).unwrap();
        let said = scratch.dolmen("identify back.toml --json");
        let after = frequencies(&said.stdout);
        assert_eq!(after.len(), before.len(), "{file}: {}", said.stderr);
        for (a, b) in after.iter().zip(&before) {
            assert!((a / b - 1.0).abs() <= within, "{file}: {a} {b}");
        }
    }
}

#[test]
fn refuses_other_formats_and_records_that_are_not_there() {
    let scratch = Scratch::with_examples("exchanged_refused");
    for (typed, why) in [
        (
            format!("record {FRAME} -o a.wav"),
            "ends in none of .uff, .unv and .csv",
        ),
        (format!("record {FRAME} --binary -o a.csv"), "a CSV file is text"),
        (
            format!("record {FRAME} --survey 1999 -o a.uff"),
            "there is no survey \"1999\"",
        ),
        (
            format!("record {FRAME} --setup 2 -o a.uff"),
            "0 of the project are of that description",
        ),
        (format!("record {FRAME} --json -o a.uff"), "has no JSON"),
        (
            "record examples/wall -o a.uff".to_owned(),
            "no survey of the project has a vibration record",
        ),
    ] {
        let said = scratch.dolmen(&typed);
        assert_ne!(said.status, 0, "{typed}");
        assert!(said.stderr.contains(why), "{typed}: {}", said.stderr);
    }
    let korean = scratch.dolmen(&format!("record {FRAME} --language ko --setup 2 -o a.uff"));
    assert!(
        korean.stderr.contains("조건에 맞는 기록이 0개"),
        "{}",
        korean.stderr
    );
}

#[test]
fn holds_the_record_is_drawn_and_modes_move_in_files_for_other_programs() {
    let scratch = Scratch::with_examples("exchanged_figures");
    scratch.dolmen(&format!("identify {HOUSE} -o out"));
    let bytes = |name: &str| std::fs::read(scratch.path().join("out").join(name)).unwrap();
    for name in [
        "channels",
        "spectrogram",
        "likeness",
        "mode-shapes",
        "singular-values",
    ] {
        assert!(
            bytes(&format!("ambient-{name}.svg")).starts_with(b"<svg"),
            "{name}"
        );
        assert!(
            bytes(&format!("ambient-{name}.png")).starts_with(b"\x89PNG"),
            "{name}"
        );
    }
    for mode in 1..=7 {
        let film = bytes(&format!("ambient-mode-{mode}.glb"));
        assert!(film.starts_with(b"glTF\x02\0\0\0"), "{mode}");
        assert_eq!(
            film.len(),
            u32::from_le_bytes(film[8..12].try_into().unwrap()) as usize
        );
    }
    let json: Value = serde_json::from_slice(&bytes("identification.json")).unwrap();
    let seen = &json["surveys"][0]["records"]["seen"];
    assert_eq!(seen["used_s"][1].as_f64(), Some(600.0));
    assert_eq!(seen["channels"].as_array().unwrap().len(), 6);
    assert_eq!(seen["spectrogram"]["asked"].as_bool(), Some(false));
}

#[test]
fn refuses_a_spectrogram_of_no_channel_and_draws_the_one_that_is_named() {
    let scratch = Scratch::with_examples("exchanged_spectrogram");
    let file = scratch.path().join(format!("{HOUSE}/project.toml"));
    let text = std::fs::read_to_string(&file).unwrap();
    for (name, is_there) in [("ch4", true), ("ch9", false)] {
        let added = format!("\n[survey.ambient.records.modal]\nspectrogram = \"{name}\"\n");
        std::fs::write(&file, format!("{text}{added}")).unwrap();
        let said = scratch.dolmen(&format!("identify {HOUSE} --json"));
        match is_there {
            true => {
                let json: Value = serde_json::from_str(&said.stdout).unwrap();
                let drawn = &json["surveys"][0]["records"]["seen"]["spectrogram"];
                assert_eq!(
                    (drawn["channel"].as_str(), drawn["asked"].as_bool()),
                    (Some("ch4"), Some(true))
                );
            }
            false => assert!(
                said.stderr
                    .contains("modal.spectrogram names \"ch9\", but the channels used are ch1"),
                "{}",
                said.stderr
            ),
        }
    }
}

#[test]
fn holds_a_drawing_is_written_as_a_picture_too() {
    let scratch = Scratch::with_examples("exchanged_drawing");
    let said = scratch.dolmen("draw examples/three_storey_pagoda -o stones.png");
    assert_eq!(said.status, 0, "{}", said.stderr);
    assert!(
        std::fs::read(scratch.path().join("stones.png"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
    let said = scratch.dolmen("draw examples/three_storey_pagoda -o stones.pdf");
    assert!(said.stderr.contains("or a PNG (.png)"), "{}", said.stderr);
}
