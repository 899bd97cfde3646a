// SOURCE     Closed form of the made frame: examples/frame_on_soft_ground/README.md.
// GOAL       Inputs of a record give the modes of a held base, in both languages and in JSON.
// TOLERANCE  2.5 of the deviations stated; 1 % with the ground.

use super::verbs::Scratch;

const PROJECT: &str = "frame_on_soft_ground";

/// Closed form: the example's README.
const HELD_HZ: [f64; 3] = [2.436_59, 6.189_31, 8.866_08];
const TOGETHER_HZ: [f64; 3] = [2.265_27, 5.849_82, 8.462_49];

fn edited(scratch: &Scratch, from: &str, to: &str) {
    let file = scratch.path().join(format!("examples/{PROJECT}/project.toml"));
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains(from));
    std::fs::write(file, text.replace(from, to)).unwrap();
}

#[test]
fn exact_frequencies_of_a_held_base_stand_beside_those_with_the_ground() {
    let scratch = Scratch::with_examples("driven_record");
    let json = scratch.dolmen(&format!("identify examples/{PROJECT} --json"));
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    let record = &value["surveys"][0]["records"];
    assert_eq!(record["modes"]["method"], "okid");
    assert_eq!(record["driven"]["inputs"][0], "G");
    for (k, (held, together)) in HELD_HZ.iter().zip(TOGETHER_HZ).enumerate() {
        let mode = &record["modes"]["modes"][k];
        let of = |key: &str| mode[key].as_f64().unwrap();
        let off = (of("frequency_hz") - held) / of("frequency_sd_hz");
        assert!(off.abs() < 2.5, "{held}: {off} deviations");
        let beside = record["driven"]["modes"][k]["with_base_hz"].as_f64().unwrap();
        assert!((beside / together - 1.0).abs() < 0.01, "{together}: {beside}");
    }
    let korean = scratch.dolmen(&format!("identify examples/{PROJECT} --language ko"));
    assert!(korean.words().contains("지반운동을 입력으로 한 모드 분석"));
}

#[test]
fn refuses_inputs_that_are_no_channel_or_of_another_method() {
    let scratch = Scratch::with_examples("driven_refused");
    edited(&scratch, "inputs = [\"G\"]", "inputs = [\"cellar\"]");
    let unknown = scratch.dolmen(&format!("identify examples/{PROJECT}"));
    assert_ne!(unknown.status, 0);
    assert!(
        unknown.stderr.contains("modal.inputs names \"cellar\""),
        "{}",
        unknown.stderr
    );
    edited(
        &scratch,
        "inputs = [\"cellar\"]",
        "inputs = [\"G\"]\nmethod = \"ssi-cov\"",
    );
    let other = scratch.dolmen(&format!("identify examples/{PROJECT}"));
    assert_ne!(other.status, 0);
    assert!(
        other.stderr.contains("does not take measured inputs"),
        "{}",
        other.stderr
    );
}
