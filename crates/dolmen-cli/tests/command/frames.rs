// SOURCE     The shipped gate (Park and Min 2010) and El Centro 1940 north-south.
// GOAL       What a user reads of a simulated frame, the files it writes, and its exit status follow from what happened.
// TOLERANCE  none: printed words. Histories against the peaks printed beside them: the sampling of the history.

use super::studies::rows;
use super::verbs::Scratch;
use std::collections::BTreeMap;
use std::fs;

const EL_CENTRO: &str = "--motion el-centro-1940-ns";

#[test]
fn holds_a_gate_slips_and_every_file_says_the_same() {
    let scratch = Scratch::with_examples("frame_slips");
    let answer = scratch.dolmen(&format!(
        "simulate examples/heunginjimun_gate --variant soft_below {EL_CENTRO} --peak 0.2g -o out"
    ));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in ["Direction weak", "Jenkins, 591.9 kN", "The largest drift is "] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let out = scratch.path().join("out/weak");
    let text = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text("simulation.json")).unwrap();
    assert_eq!(json["outcome"]["kind"], "finished");
    let upper = &json["storeys"][1];
    let peak = upper["peak_displacement_m"].as_f64().unwrap().abs();
    let rows: Vec<Vec<f64>> = text("histories.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    // level 2 after time and the three columns of level 1
    let most = rows.iter().map(|row| row[4].abs()).fold(0.0, f64::max);
    assert!(most <= peak && most > 0.999 * peak, "{most} {peak}");
    assert_eq!(most, upper["peak_displacement_at_samples_m"].as_f64().unwrap());
    // slips of one storey, each with its way: together what the table says
    let way: f64 = text("slips.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect::<Vec<_>>())
        .filter(|cells| cells[0] == "2")
        .map(|cells| cells[3].parse::<f64>().unwrap().abs())
        .sum();
    assert!((way - upper["slipped_way_m"].as_f64().unwrap()).abs() < 1e-12);
    assert!(json["energy"]["left_over_ratio"].as_f64().unwrap() < 1e-9);
    for figure in ["ground", "levels", "loop-1", "loop-2", "slips", "energy"] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
}

#[test]
fn holds_a_motion_of_the_file_is_the_same_as_typed() {
    let scratch = Scratch::with_examples("frame_motion");
    let gate = "--json simulate examples/heunginjimun_gate --variant soft_below";
    let json = |motion: &str| -> serde_json::Value {
        let answer = scratch.dolmen(&format!("{gate} {motion}"));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let whole: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
        whole["simulations"][0]["storeys"].clone()
    };
    let typed = json(&format!("{EL_CENTRO} --peak 0.2g"));
    assert_eq!(json("--motion el-centro"), typed);
    assert_ne!(json("--motion el-centro --peak 0.1g"), typed);
}

#[test]
fn holds_a_frame_that_leans_too_far_counts_as_fallen() {
    let scratch = Scratch::with_examples("frame_falls");
    let path = scratch.path().join("examples/heunginjimun_gate/project.toml");
    let soft = fs::read_to_string(&path)
        .unwrap()
        .replace("slipping_stiffness = [16.3, 48.1]", "slipping_stiffness = [0, 0]");
    fs::write(&path, soft).unwrap();
    let answer = scratch.dolmen(&format!(
        "simulate examples/heunginjimun_gate --variant soft_below {EL_CENTRO} --peak 0.6g"
    ));
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(
        answer.stdout.contains("‘lower storey’ leaned by more than 10 %"),
        "{}",
        answer.stdout
    );
    // and the check says so before: without its sliders it has no stiffness
    let check = scratch.dolmen("check examples/heunginjimun_gate");
    assert_eq!(check.status, 1);
    assert!(
        check
            .stdout
            .contains("While every joint slips, the load factor is 0"),
        "{}",
        check.stdout
    );
}

#[test]
fn refuses_what_cannot_be_simulated() {
    let scratch = Scratch::with_examples("frame_refused");
    let says = |command: &str, words: &str| {
        let answer = scratch.dolmen(command);
        assert_eq!(answer.status, 2, "{command}");
        assert!(answer.stderr.contains(words), "{words}: {}", answer.stderr);
    };
    let gate = "simulate examples/heunginjimun_gate";
    says(
        &format!("{gate} {EL_CENTRO}"),
        "the stiffness of no direction is known (weak, strong): `dolmen identify`",
    );
    says(
        &format!("{gate} --variant soft_below --direction strong {EL_CENTRO}"),
        "the stiffness of direction \"strong\" is unknown",
    );
    says(
        &format!("{gate} --variant soft_below --direction north {EL_CENTRO}"),
        "there is no direction \"north\": the file has weak, strong",
    );
}

#[test]
fn holds_frames_are_mapped_released_and_scanned() {
    let scratch = Scratch::with_examples("frames");
    let words = "study examples/heunginjimun_gate --study map -o out";
    let answer = scratch.dolmen(words);
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "Let go: apparent frequency",
        "Harmonic ground",
        "soft_below",
        "soft_above",
    ] {
        assert!(answer.stdout.contains(said), "{said}: {}", answer.stdout);
    }
    let folder = scratch.path().join("out/map");
    // stuck, the frame has its measured frequency; slipping, less
    let release = rows(&folder.join("release.csv"));
    let of = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    let below: Vec<_> = release
        .iter()
        .filter(|row| row["inputs"] == "soft_below")
        .collect();
    let (first, last) = (below.first().unwrap(), below.last().unwrap());
    assert!(of(first, "apparent_frequency_hz") < 0.9, "{first:?}");
    assert!((of(last, "apparent_frequency_hz") - 1.1).abs() < 0.02, "{last:?}");
    let map = rows(&folder.join("harmonic.csv"));
    assert!(map.iter().any(|row| row["slipping_share"] == "0"));
    assert!(map.iter().any(|row| of(row, "slipping_share") > 0.2));
    assert!(
        fs::read_to_string(folder.join("harmonic-1-1.svg"))
            .unwrap()
            .starts_with("<svg")
    );
    let grown = scratch.dolmen("study examples/heunginjimun_gate --study growth -o out");
    assert_eq!(grown.status, 0, "{}{}", grown.stdout, grown.stderr);
    let runs = rows(&scratch.path().join("out/growth/runs.csv"));
    let share = |row: &BTreeMap<String, String>| of(row, "slipping_share");
    assert!(runs.iter().any(|row| share(row) == 0.0) && runs.iter().any(|row| share(row) > 0.05));
}
