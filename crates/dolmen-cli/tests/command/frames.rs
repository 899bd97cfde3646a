// SOURCE     The shipped gate (Park and Min 2010) and El Centro 1940 north-south.
// GOAL       What a user reads of a simulated frame, the files it writes, and its exit status follow from what happened.
// TOLERANCE  none: printed words. Histories against the peaks printed beside them: the sampling of the history.

use super::verbs::Scratch;
use std::fs;

const EL_CENTRO: &str = "--motion el-centro-1940-ns";

#[test]
fn holds_a_gate_slips_and_every_file_says_the_same() {
    let scratch = Scratch::with_examples("frame_slips");
    let answer = scratch.dolmen(&format!(
        "simulate examples/heunginjimun_gate --variant soft_below {EL_CENTRO} --peak 0.2g -o out"
    ));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in ["Direction weak", "Jenkins, 591.9 kN", "STOOD: no storey leaned"] {
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
        answer
            .stdout
            .contains("DRIFT LIMIT: 'lower storey' leaned by more than 10 %"),
        "{}",
        answer.stdout
    );
    // and the check says so before: without its sliders it has no stiffness
    let check = scratch.dolmen("check examples/heunginjimun_gate");
    assert_eq!(check.status, 1);
    assert!(
        check
            .stdout
            .contains("while every joint slips: load factor 0.0000: unstable"),
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
