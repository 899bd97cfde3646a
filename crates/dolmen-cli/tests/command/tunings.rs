// SOURCE     The shipped floors: Hwang, Min & Hong's, and one on which their rule fails.
// GOAL       What a user reads about a damper, the files written, and the refusals.
// TOLERANCE  half a unit of the fourth digit of ratios computed separately.

use super::verbs::Scratch;
use std::fs;

fn ratios(choice: &serde_json::Value) -> Vec<f64> {
    let list = choice["point_ratio"].as_array().unwrap();
    list.iter().map(|ratio| ratio.as_f64().unwrap()).collect()
}

/// Sentences before they are wrapped.
fn unwrapped(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn close(given: &[f64], expected: &[f64]) {
    assert_eq!(given.len(), expected.len());
    for (a, b) in given.iter().zip(expected) {
        assert!((a - b).abs() < 6e-5, "{given:?} {expected:?}");
    }
}

#[test]
fn published_the_rule_makes_an_edge_worse_and_every_file_says_so() {
    let scratch = Scratch::with_examples("tune_far");
    let answer = scratch.dolmen("tune examples/far_from_the_centre --map 12 -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    for said in [
        "Worse than no damper: ‘the rule: farthest from the centre of mode 1’, by these factors: left end 1.0430.",
        "placed and tuned best",
        "Den Hartog (1956)",
        "What the goal grows by when the damper is out of tune",
    ] {
        let whole = unwrapped(&answer.stdout);
        assert!(whole.contains(said), "{said}: {}", answer.stdout);
    }
    let out = scratch.path().join("out/tmd");
    let text = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text("tune.json")).unwrap();
    let choices = json["choices"].as_array().unwrap();
    let names: Vec<&str> = choices
        .iter()
        .map(|row| row["choice"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["given", "rule", "tuned_best", "placed_best", "best"]);
    close(&ratios(&choices[1]), &[1.0430, 0.3708]);
    assert_eq!(choices[1]["worse_than_none"], true);
    close(&ratios(&choices[4]), &[0.5642, 0.4621]);
    assert_eq!(choices[4]["end"], "optimum");
    let place = choices[4]["damper"]["place_m"][0].as_f64().unwrap();
    assert!((place - 0.4447).abs() < 5e-4, "{place}");
    assert_eq!(json["map"]["cells"].as_array().unwrap().len(), 144);
    for figure in ["position", "plan", "robustness"] {
        assert!(text(&format!("{figure}.svg")).starts_with("<svg"), "{figure}");
    }
}

#[test]
fn published_ratios_of_the_twisting_floor() {
    let scratch = Scratch::with_examples("tune_floor");
    let answer = scratch.dolmen("--json tune examples/twisting_floor --map 4");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let damper = &json["dampers"][0];
    assert_eq!(damper["variant"], "damped");
    close(&ratios(&damper["choices"][0]), &[0.5019, 0.4897]);
    let centre = damper["mode"]["centre_m"][0].as_f64().unwrap();
    assert!((centre + 23.378).abs() < 1e-3, "{centre}");
}

#[test]
fn refuses_what_has_no_damper_to_tune() {
    let scratch = Scratch::with_examples("tune_refused");
    let answer = scratch.dolmen("tune examples/naju_flagpole");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("only buildings have dampers to tune"),
        "{}",
        answer.stderr
    );
    let path = scratch.path().join("examples/far_from_the_centre/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let tune = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        fs::write(&path, text.replace(from, to)).unwrap();
        let answer = scratch.dolmen("tune examples/far_from_the_centre --map 4");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        answer.stderr
    };
    let said = tune("place = [0, 0]", "place = [6, 0]");
    assert!(said.contains("outside"), "{said}");
    let said = tune("direction = \"y\"", "direction = \"x\"");
    assert!(said.contains("moves only in y here"), "{said}");
    let said = tune("mass = 10.0", "mass = 1000.0");
    assert!(said.contains("mass ratio"), "{said}");
    fs::write(&path, &text).unwrap();
    let answer = scratch.dolmen("tune examples/far_from_the_centre --damper none");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("there is no damper \"none\""),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_all_dampers_are_judged_together_and_apart() {
    let scratch = Scratch::with_examples("tune_together");
    let answer = scratch.dolmen("--json tune examples/several_dampers --map 3 --share-mass");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let names: Vec<&str> = json["dampers"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["damper"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["pair-1", "pair-2", "tank"]);
    let rows = json["together"][0]["rows"].as_array().unwrap();
    let choices: Vec<&str> = rows.iter().map(|row| row["choice"].as_str().unwrap()).collect();
    let mut expected = vec!["without", "given"];
    expected.extend(["only"; 5]);
    expected.extend(["all_but"; 5]);
    expected.extend(["tuned_best", "best", "best_shared"]);
    assert_eq!(choices, expected);
    let cost = |choice: &str| {
        let row = rows.iter().find(|row| row["choice"] == choice).unwrap();
        row["cost_ratio"].as_f64().unwrap()
    };
    assert_eq!(cost("without"), 1.0);
    assert!(cost("given") < 1.0 && cost("tuned_best") < cost("given"));
    assert!(cost("best") <= cost("tuned_best") * (1.0 + 1e-6));
    assert!(cost("best_shared") <= cost("best") * (1.0 + 1e-6));
    // a damper in the table of all equals the same damper alone
    let alone = &json["dampers"][2]["choices"][0];
    let only = rows.iter().find(|row| row["damper"] == "tank").unwrap();
    let ratios = only["point_ratio"].as_array().unwrap();
    for (a, b) in ratios.iter().zip(alone["point_ratio"].as_array().unwrap()) {
        assert!((a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-9);
    }
}

#[test]
fn regress_a_damper_far_out_of_tune_is_tuned_as_well_as_one_in_tune() {
    let scratch = Scratch::with_examples("tune_far_off");
    let path = scratch.path().join("examples/far_from_the_centre/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let off = text.replace("tuning = \"den_hartog\"", "frequency = 1.2\ndamping_ratio = 0.1");
    fs::write(&path, off).unwrap();
    let answer = scratch.dolmen("--json tune examples/far_from_the_centre --map 10");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let damper = &json["dampers"][0];
    let best = &damper["choices"][4];
    close(&ratios(best), &[0.5642, 0.4621]);
    let tuned = damper["choices"][2]["cost_ratio"].as_f64().unwrap();
    assert!((tuned - 0.469_26).abs() < 5e-5, "{tuned}");
    let without = damper["cost_without_damper"].as_f64().unwrap();
    let cells = damper["map"]["cells"].as_array().unwrap();
    let costs = cells.iter().map(|cell| cell["cost"].as_f64().unwrap() / without);
    let least = costs.fold(f64::INFINITY, f64::min);
    assert!(least > 0.4620 && least < 0.4680, "{least}");
}

#[test]
fn regress_peaks_are_compared_with_peaks() {
    let scratch = Scratch::with_examples("tune_peak");
    let answer = scratch.dolmen("tune examples/far_from_the_centre --goal largest-peak -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        unwrapped(&answer.stdout).contains("Largest amplitudes of the points under a harmonic load"),
        "{}",
        answer.stdout
    );
    let out = scratch.path().join("out/tmd");
    let text = fs::read_to_string(out.join("tune.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(json["map"]["cells"].as_array().unwrap().is_empty());
    assert!(!out.join("plan.svg").exists() && !out.join("position.svg").exists());
    // the goal is the largest response of the points, over the largest without dampers
    let without: Vec<f64> = json["points"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| point["without_damper"].as_f64().unwrap())
        .collect();
    for row in json["choices"].as_array().unwrap() {
        let each = ratios(row)
            .into_iter()
            .zip(&without)
            .map(|(ratio, without)| ratio * without);
        let largest = each.fold(0.0, f64::max);
        let cost = row["cost"].as_f64().unwrap();
        assert!((largest / cost - 1.0).abs() < 1e-9, "{largest} {cost}");
    }
}

#[test]
fn regress_a_mode_that_does_not_turn_has_no_farthest_place() {
    let scratch = Scratch::new("tune_rule");
    let text = r#"schema = 1
kind = "building"
name = "rule"
p_delta = false
floors = [
  { mass = 1e5, sides = [12, 8], height = 30, stiffness = { x = 4e6, y = 5.4e6, rotation = 2e8, centre = [0, 0] } },
]
damping.ratio = 0.02
[damper.d0]
kind = "tmd"
floor = 1
place = [1, 0]
direction = "x"
mass_ratio = 0.05
tuning = "den_hartog"
"#;
    fs::write(scratch.path().join("rule.toml"), text).unwrap();
    let answer = scratch.dolmen("--json tune rule.toml --map 4");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let rule = &json["dampers"][0]["choices"][1];
    assert_eq!(rule["damper"]["place_m"], serde_json::json!([1.0, 0.0]));
}

#[test]
fn holds_rooms_are_held_against_strokes_under_the_motions_of_the_file() {
    let scratch = Scratch::with_examples("tune_room");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let whole = fs::read_to_string(&file).unwrap();
    let (before, after) = whole.split_once("[site]").unwrap();
    let (site, after) = after.split_once("# The damper of the source").unwrap();
    let (damper, motions) = after.split_once("# An earthquake to simulate").unwrap();
    let text = format!("{before}# {damper}# {motions}");
    let roomy =
        |text: &str, mm: &str| text.replace("mass = 5.125", &format!("mass = 5.125\nstroke = \"{mm} mm\""));
    // 211.25 mm under el-centro, as in `simulate`
    fs::write(&file, roomy(&text, "211")).unwrap();
    let answer = scratch.dolmen("tune examples/twisting_floor --map 2");
    assert_eq!(answer.status, 0, "a tuning is done: {}", answer.stderr);
    let said =
        "Damper tmd is beyond its room under motion el-centro: it needs 211.3 mm each way and has 211.0 mm.";
    let whole = unwrapped(&answer.stdout);
    let (place, table) = (whole.find(said), whole.find("Standard deviation"));
    assert!(place.is_some() && place < table, "{}", answer.stdout);
    fs::write(&file, roomy(&text, "212")).unwrap();
    let answer = scratch.dolmen("--json tune examples/twisting_floor --map 2");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let strokes = json["dampers"][0]["strokes_under_motions"].as_array().unwrap();
    assert_eq!(strokes.len(), 5);
    assert!((strokes[0]["stroke_m"].as_f64().unwrap() - 0.21125).abs() < 5e-6);
    // under the spectrum of the site, as in `check`
    fs::write(&file, roomy(&format!("{before}[site]{site}# {damper}"), "212")).unwrap();
    let answer = scratch.dolmen("--json check examples/twisting_floor");
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let stroke_mm = 1e3
        * json["variants"][0]["state"]["check"]["building"]["standing"]["spectral_with_dampers"]["strokes_m"]
            [0]
        .as_f64()
        .unwrap();
    let answer = scratch.dolmen("tune examples/twisting_floor --map 2");
    assert_eq!(answer.status, 0, "a tuning is done: {}", answer.stderr);
    let said = format!("under the spectrum of the site: it needs {stroke_mm:.1} mm each way");
    assert!(
        unwrapped(&answer.stdout).contains(&said),
        "{said}: {}",
        answer.stdout
    );
    // a room, and no stroke to compare with it
    fs::write(&file, roomy(&format!("{before}# {damper}"), "212")).unwrap();
    let answer = scratch.dolmen("tune examples/twisting_floor --map 2");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = "the file has no motion or site to hold it against";
    assert!(unwrapped(&answer.stdout).contains(said), "{}", answer.stdout);
}

/// A floor that twists, with two masses at its ends.
const TWO_MASSES: &str = "schema = 1\nkind = \"building\"\nname = \"Two\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"N/mm\" }\n\
    p_delta = false\nfloors = [{ name = \"roof\", mass = 100, sides = [10, 8], height = 30, walls = [\n\
    { x = 0, y = -4, stiffness_x = 260 }, { x = 0, y = 4, stiffness_x = 260 },\n\
    { x = -5, y = 0, stiffness_y = 240 }, { x = 5, y = 0, stiffness_y = 130 }] }]\ndamping = { ratio = 0.02 }\n\
    points = [{ name = \"l\", floor = 1, place = [-5, 0] }, { name = \"r\", floor = 1, place = [5, 0] }]\n\
    [damper.a]\nkind = \"tmd\"\nfloor = 1\nplace = [5, 0]\ndirection = \"y\"\nmass = 2\ntuning = \"den_hartog\"\n\
    [damper.b]\nkind = \"tmd\"\nfloor = 1\nplace = [-5, 0]\ndirection = \"y\"\nmass = 1.5\nmode = 3\ntuning = \"den_hartog\"\n";

#[test]
fn regress_a_search_that_fails_is_never_the_best_and_options_of_single_dampers_say_so() {
    let scratch = Scratch::new("two-masses");
    fs::write(scratch.path().join("project.toml"), TWO_MASSES).unwrap();
    let answer = scratch.dolmen("--json tune project.toml --load base --stroke-most 0.5 --map 3");
    let json: serde_json::Value =
        serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}", answer.stderr));
    let rows = json["together"][0]["rows"].as_array().unwrap();
    let cost = |choice: &str| {
        let row = rows.iter().find(|row| row["choice"] == choice).unwrap();
        row["cost_ratio"].as_f64().unwrap()
    };
    assert!(
        cost("best") <= cost("tuned_best") * (1.0 + 1e-9),
        "{} {}",
        cost("best"),
        cost("tuned_best")
    );
    let words = |flags: &str| {
        unwrapped(
            &scratch
                .briefly(&format!("tune project.toml {flags} --map 3"))
                .stdout,
        )
    };
    let off = words("--load base --off 0.1");
    assert!(
        off.contains("for each damper by itself, not for all together"),
        "{off}"
    );
    let peaks = words("--load force --goal largest-peak");
    assert!(peaks.contains("These are standard deviations"), "{peaks}");
}

/// Three floors that twist, with a mass on the second; the points stand on the third.
const THREE_FLOORS: &str = "schema = 1\nkind = \"building\"\nname = \"Three\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"N/mm\" }\n\
    p_delta = false\nfloors = [\n\
    { mass = 100, sides = [12, 8], height = 3, stiffness = { x = 90000, y = 70000, rotation = \"2e9 N*m\", centre = [-1, 0] } },\n\
    { mass = 100, sides = [12, 8], height = 3, stiffness = { x = 80000, y = 60000, rotation = \"1.8e9 N*m\", centre = [-1, 0] } },\n\
    { mass = 80, sides = [12, 8], height = 3, stiffness = { x = 70000, y = 50000, rotation = \"1.5e9 N*m\", centre = [-1, 0] } },\n\
    ]\ndamping = { ratio = 0.02 }\n\
    points = [{ name = \"l\", floor = 3, place = [-6, 0] }, { name = \"r\", floor = 3, place = [6, 0] }]\n\
    [damper.a]\nkind = \"tmd\"\nfloor = 2\nplace = [3, 0]\ndirection = \"y\"\nmass = 5\ntuning = \"den_hartog\"\n";

#[test]
fn agrees_another_floor_gives_what_the_damper_gives_when_the_file_puts_it_there() {
    let scratch = Scratch::new("tune-floors");
    fs::write(scratch.path().join("project.toml"), THREE_FLOORS).unwrap();
    let read = |command: &str| -> serde_json::Value {
        let answer = scratch.dolmen(command);
        serde_json::from_str(&answer.stdout).unwrap_or_else(|_| panic!("{}", answer.stderr))
    };
    let found = read("--json tune project.toml --floors all --map 4");
    let damper = &found["dampers"][0];
    let designs = damper["floors"]["designs"].as_array().unwrap();
    assert_eq!(designs.len(), 3);
    assert_eq!(damper["floors"]["best"], 3);
    assert_eq!(damper["other_floors"], 2);
    let ratio = |floor: usize| designs[floor - 1]["cost_ratio"].as_f64().unwrap();
    assert_eq!(damper["choices"][4]["cost_ratio"].as_f64().unwrap(), ratio(2));
    assert!(ratio(3) < ratio(2) && ratio(2) < ratio(1) && ratio(1) < 1.0);
    for floor in [1, 3] {
        let moved = THREE_FLOORS.replace("floor = 2\n", &format!("floor = {floor}\n"));
        fs::write(scratch.path().join("moved.toml"), moved).unwrap();
        let moved = read("--json tune moved.toml --map 4");
        let best = moved["dampers"][0]["choices"][4]["cost_ratio"].as_f64().unwrap();
        assert!((ratio(floor) / best - 1.0).abs() < 1e-4, "{floor} {best}");
        assert!(moved["dampers"][0]["floors"].is_null());
    }
}

#[test]
fn holds_other_floors_are_compared_when_asked_for_and_offered_when_not() {
    let scratch = Scratch::new("tune-floors-said");
    fs::write(scratch.path().join("project.toml"), THREE_FLOORS).unwrap();
    let offered = unwrapped(&scratch.briefly("tune project.toml --map 3").stdout);
    assert!(
        offered.contains("searched only on its own floor, 2: `dolmen tune --floors all` compares the others"),
        "{offered}"
    );
    let asked = scratch
        .briefly("tune project.toml --floors all --map 3 -o out")
        .stdout;
    assert!(asked.lines().count() <= 15, "{asked}");
    let said = unwrapped(&asked);
    assert!(said.contains("the file's floor, 2, gives 0."), "{said}");
    assert!(said.contains("floor 3 would give 0."), "{said}");
    assert!(
        said.contains("2, as in the file") && said.contains("3, the best"),
        "{said}"
    );
    let figure = fs::read_to_string(scratch.path().join("out/a/floors.svg")).unwrap();
    assert!(figure.starts_with("<svg"), "{figure}");
    let korean = scratch
        .briefly("tune project.toml --floors 1-2 --map 3 --language ko")
        .stdout;
    assert!(unwrapped(&korean).contains("2번 바닥"), "{korean}");
    for (floors, why) in [
        ("2-9", "the building has floors 1 to 3"),
        ("few", "two floors, such as 3-12"),
    ] {
        let refused = scratch.dolmen(&format!("tune project.toml --floors {floors}"));
        assert_eq!(refused.status, 2, "{}", refused.stdout);
        assert!(refused.stderr.contains(why), "{}", refused.stderr);
    }
}

#[test]
fn holds_a_wider_search_ends_no_worse_than_the_narrower() {
    // of random pairs of dampers, one on which the search over the masses alone ended 1.1 % above the row before it
    let scratch = Scratch::with_examples("tune_shared");
    let path = scratch.path().join("examples/far_from_the_centre/project.toml");
    let text = fs::read_to_string(&path).unwrap();
    let (floor, _) = text.split_once("[damper.").unwrap();
    let damper = |name: &str, x: f64, mass: f64, tuned: [f64; 2]| {
        let [hertz, ratio] = tuned;
        format!(
            "[damper.{name}]\nkind = \"tmd\"\nfloor = 1\nplace = [{x}, 0]\ndirection = \"y\"\nmass = {mass}\nfrequency = {hertz}\ndamping_ratio = {ratio}\n"
        )
    };
    let both = damper("a", -1.3, 5.4, [0.36, 0.16]) + &damper("b", -4.1, 4.3, [0.239, 0.06]);
    fs::write(&path, floor.to_owned() + &both).unwrap();
    let answer = scratch.dolmen(
        "--json tune examples/far_from_the_centre --share-mass --map 3 --load ground --ground 1 --goal mean-square",
    );
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let rows = json["together"][0]["rows"].as_array().unwrap();
    let cost = |choice: &str| {
        let row = rows.iter().find(|row| row["choice"] == choice).unwrap();
        row["cost_ratio"].as_f64().unwrap()
    };
    let [best, shared] = ["best", "best_shared"].map(cost);
    assert!(shared <= best, "{shared} beyond {best}");
}
