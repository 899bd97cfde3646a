// SOURCE     Closed form of the made frame: examples/frame_on_soft_ground/README.md.
// GOAL       Recorded inputs give the modes of a fixed base, in both languages and in JSON.
// TOLERANCE  2.5 of the stated deviations; 1 % with the ground.

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

/// Numbers of the figure whose header contains these words, by column.
fn figure_with(scratch: &Scratch, folder: &str, head: &str) -> Vec<Vec<f64>> {
    let files = std::fs::read_dir(scratch.path().join(folder)).unwrap();
    let texts = files.filter_map(|file| std::fs::read_to_string(file.unwrap().path()).ok());
    let is_of = |text: &String| !text.contains("<svg") && text.lines().next().unwrap_or("").contains(head);
    let text = texts
        .filter(is_of)
        .find(|text| text.lines().count() > 20)
        .unwrap_or_else(|| panic!("no figure has {head}"));
    let rows = text.lines().skip(1).map(|row| {
        let cells = row.split(',').map(|cell| cell.parse().unwrap());
        cells.collect()
    });
    rows.collect()
}

#[test]
fn holds_the_report_draws_responses_and_coherence_with_their_numbers() {
    let scratch = Scratch::with_examples("driven_responses");
    let said = scratch.dolmen(&format!("report examples/{PROJECT} -o r.html --figures en"));
    assert_eq!(said.status, 0, "{}", said.stderr);
    let page = std::fs::read_to_string(scratch.path().join("r.html")).unwrap();
    for words in [
        "Frequency response to G",
        "Coherence with the inputs",
        "comes out at",
    ] {
        assert!(page.contains(words), "{words}");
    }
    let coherence = figure_with(&scratch, "en", "coherence of ");
    assert!(
        coherence
            .iter()
            .all(|row| row[1..].iter().all(|c| (0.0..=1.0).contains(c)))
    );
    // the input exceeds the wind: near the first mode, most of the motion follows it
    let about: Vec<f64> = coherence
        .iter()
        .filter(|row| (2.2..2.7).contains(&row[0]))
        .map(|row| row[row.len() - 1])
        .collect();
    let mean = about.iter().sum::<f64>() / about.len() as f64;
    assert!(mean > 0.7, "{mean}");
    // the roof responds most near the first mode of the fixed base
    let response = figure_with(&scratch, "en", "phase of ");
    let low = response.iter().filter(|row| (0.5..4.0).contains(&row[0]));
    let top = low
        .max_by(|a, b| a[a.len() - 2].total_cmp(&b[b.len() - 2]))
        .unwrap();
    assert!((top[0] / HELD_HZ[0] - 1.0).abs() < 0.1, "{top:?}");
    let korean = scratch.dolmen(&format!(
        "report examples/{PROJECT} -o k.html --figures ko --language ko"
    ));
    assert_eq!(korean.status, 0, "{}", korean.stderr);
    assert!(!figure_with(&scratch, "ko", "기여도 함수").is_empty());
}
