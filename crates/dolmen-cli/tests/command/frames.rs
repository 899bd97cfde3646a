// SOURCE     The shipped gate (Park and Min 2010) and El Centro 1940 north-south.
// GOAL       The text on a simulated frame, its output files and the exit status follow from the simulation.
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
    // level 2, after time and the three columns of level 1
    let most = rows.iter().map(|row| row[4].abs()).fold(0.0, f64::max);
    assert!(most <= peak && most > 0.999 * peak, "{most} {peak}");
    assert_eq!(most, upper["peak_displacement_at_samples_m"].as_f64().unwrap());
    // slips of one storey, each with its length: the sum is in the table
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
    // the check says so too: without its sliders it has no stiffness
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
    // sticking, the frame has its measured frequency; slipping, a lower one
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

const TWO: &str = "simulate examples/heunginjimun_gate/two_directions.toml --motion el-centro";

#[test]
fn holds_two_components_meet_both_directions_together() {
    let scratch = Scratch::with_examples("frame_two");
    let answer = scratch.dolmen(&format!("--json {TWO}"));
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let runs = json["simulations"].as_array().unwrap();
    let of = |run: usize, key: &str| runs[run][key].as_str().unwrap().to_owned();
    assert_eq!([of(0, "direction"), of(0, "component")], ["strong", "x"]);
    assert_eq!([of(1, "direction"), of(1, "component")], ["weak", "y"]);
    let together = &runs[1]["together"];
    assert!(together["shared_friction"]["change_of_peaks"].as_f64().unwrap() <= 0.005);
    let most = |storey: usize| together["storeys"][storey]["peak_drift_m"].as_f64().unwrap();
    for storey in [0, 1] {
        for run in runs {
            let alone = run["storeys"][storey]["peak_drift_m"].as_f64().unwrap().abs();
            assert!(most(storey) >= alone && most(storey) < 1.5 * alone + 0.05);
        }
    }
    // the resultant is compared with the limit, once
    let parts = |run: usize| {
        let all = runs[run]["limits"]["parts"].as_array().unwrap().clone();
        all.iter()
            .map(|part| part["direction"].as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(parts(0), ["strong"; 2]);
    assert_eq!(parts(1), ["weak", "weak", "strong+weak", "strong+weak"]);
    let words = scratch.dolmen(TWO).stdout;
    for said in [
        "Both directions together: ‘lower storey’ drifts by up to",
        "share one slip force",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
}

#[test]
fn holds_a_surveyed_tilt_of_a_frame_is_in_its_runs_and_takes_of_its_drift() {
    let scratch = Scratch::with_examples("frame_leans");
    let json = |variant: &str| -> serde_json::Value {
        let answer = scratch.dolmen(&format!("--json {TWO} {variant}"));
        serde_json::from_str(&answer.stdout).unwrap()
    };
    let (upright, leaning) = (json(""), json("--variant leaning"));
    let part =
        |of: &serde_json::Value, key: &str| of["simulations"][1]["limits"]["parts"][0][key].as_f64().unwrap();
    assert_eq!((part(&upright, "taken"), part(&upright, "capacity")), (0.0, 0.02));
    // drift and lean as vectors in plan: 1/120 along the direction, 1/400 across it
    let left = (0.02_f64.powi(2) - (1.0_f64 / 400.0).powi(2)).sqrt() - 1.0 / 120.0;
    assert!((part(&leaning, "taken") - (0.02 - left)).abs() < 1e-12);
    assert!((part(&leaning, "capacity") - left).abs() < 1e-12);
    // before the shaking it is in equilibrium with its springs: τ N/(k − N/l)
    let tilt = |of: &serde_json::Value| of["simulations"][1]["lean"]["tilt_in_direction"].as_f64();
    assert_eq!((tilt(&upright), tilt(&leaning)), (None, Some(1.0 / 120.0)));
    let answer = scratch.dolmen("--json check examples/heunginjimun_gate/two_directions.toml");
    let check: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let state = &check["variants"][0]["state"];
    let at_rest = state["check"]["frame"][1]["lean"]["at_rest"][0].as_f64().unwrap();
    // the larger value of sticking and slipping joints
    let wanted = 16.3e6 / (16.3e6 - 5919e3 / 5.84) / 120.0;
    assert!((at_rest / wanted - 1.0).abs() < 1e-9, "{at_rest} {wanted}");
    let both = state["tilts"].as_array().unwrap().last().unwrap();
    assert_eq!(both["direction"], "strong+weak");
}

#[test]
fn holds_a_frame_that_leans_to_its_fall_is_unstable_and_near_it_marginal() {
    let scratch = Scratch::new("frame_lean_words");
    let said = |tilt: &str, more: &str| {
        let text = format!(
            "schema = 1\nkind = \"frame\"\nname = \"gate\"\nevidence = \"measured\"\n\
             units = {{ length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }}\n{more}\
             storeys = [{{ mass = 60, height = 4.0 }}]\n[direction.x]\nstiffness = [2.0]\n[direction.y]\nstiffness = [2.0]\n\
             [survey.2024-01-01]\ntilt = {tilt}\n"
        );
        fs::write(scratch.path().join("gate.toml"), text).unwrap();
        let answer = scratch.dolmen("check gate.toml");
        (answer.status, answer.stdout)
    };
    // k l/N = 13.6: at rest it leans by 1.08 of its tilt, and 10 % is a fall
    for (tilt, status, word) in [
        ("{ x = \"1/100\" }", 0, "Own weight: stable"),
        ("{ x = \"1/12\" }", 0, "Own weight: marginal"),
        ("{ x = \"1/10.5\" }", 1, "Own weight: unstable"),
        // both together
        ("{ x = \"1/15\", y = \"1/15\" }", 1, "Own weight: unstable"),
        ("{ x = \"1/17\", y = \"1/17\" }", 0, "Own weight: marginal"),
    ] {
        let (code, words) = said(tilt, "");
        assert!(code == status && words.contains(word), "{tilt}: {code} {words}");
    }
    let (code, words) = said("{ x = \"1/12\" }", "as_surveyed = \"none\"\n");
    assert!(code == 0 && words.contains("Own weight: stable"), "{words}");
    // its lean already reaches the allowable drift for earthquakes
    let (code, words) = said("{ x = \"1/50\" }", "limits = { storey_drift = \"1/60\" }\n");
    assert!(code == 1 && words.contains("Tilt: beyond its limit"), "{words}");
}

#[test]
fn refuses_two_components_where_a_direction_is_missing_or_not_placed() {
    let scratch = Scratch::with_examples("frame_two_refused");
    let path = scratch
        .path()
        .join("examples/heunginjimun_gate/two_directions.toml");
    let whole = fs::read_to_string(&path).unwrap();
    let says = |text: &str, more: &str, words: &str| {
        fs::write(&path, text).unwrap();
        let answer = scratch.dolmen(&format!("{TWO} {more}"));
        assert_eq!(answer.status, 2, "{words}: {}", answer.stdout);
        assert!(answer.stderr.contains(words), "{words}: {}", answer.stderr);
    };
    says(&whole, "--direction weak", "--direction weak names one direction");
    let unplaced = whole.replace("along = \"x\"\n", "");
    says(&unplaced, "", "write along = \"x\" in [direction.NAME]");
    let twice = whole.replace("along = \"x\"", "along = \"y\"");
    says(&twice, "", "directions strong and weak both lie along y");
    let start = whole.find("[direction.strong]").unwrap();
    let end = whole.find("[direction.weak]").unwrap();
    let alone = format!("{}{}", &whole[..start], &whole[end..]);
    says(&alone, "", "the frame has one direction, weak");
}
