// SOURCE     output of the verbs with --json for the examples.
// GOAL       Any JSON key that is added, removed or renamed fails this test. No number lacks a value by accident.
// TOLERANCE  keys by name; other tests check the values. To accept a change: DOLMEN_WRITE_KEYS=1, then read the difference.

use super::verbs::{Scratch, root};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

const COMMANDS: [&str; 64] = [
    "check examples/naju_flagpole/two_directions.toml",
    "check examples/naju_flagpole/side_posts.toml",
    "simulate examples/naju_flagpole/side_posts.toml --motion el-centro --duration 3",
    "simulate examples/tower_in_wind --wind --repeats 2 --duration 20 --variant damped",
    "check examples/naju_flagpole --samples 20 --sensitivity",
    "check examples/naju_flagpole/wind.toml",
    "check examples/naju_flagpole/one_stone.toml",
    "check examples/wall/wind.toml",
    "check examples/heunginjimun_gate",
    "check examples/free_columns",
    "check examples/free_columns/wind.toml",
    "check examples/three_storey_pagoda --sensitivity",
    "check examples/piled_blocks",
    "check examples/p10",
    "check examples/twisting_floor",
    "check examples/several_dampers",
    "check examples/tower_in_wind",
    "check examples/tower_in_wind/loads.toml",
    "check examples/palisaden",
    "identify examples/naju_flagpole",
    "identify examples/heunginjimun_gate",
    "identify examples/struck_column",
    "identify examples/frame_on_soft_ground",
    "identify examples/frame_after_an_earthquake",
    "identify examples/gate_in_plan",
    "identify examples/gate_columns",
    "identify examples/five_storey_pagoda",
    "compare examples/gate_through_the_seasons",
    "watch examples/pagoda_over_the_years",
    "watch examples/flagpole_over_the_years",
    "watch examples/pagoda_with_a_logger",
    "watch examples/frame_after_an_earthquake",
    "simulate examples/three_storey_pagoda --motion el-centro-1940-ns --keep-first 2",
    "simulate examples/rubble",
    "simulate examples/piled_blocks --motion el-centro-1940-ns --keep-first 2 --law rigid",
    "simulate examples/piled_blocks --motion el-centro-1940-ns --keep-first 2 --law sliding",
    "simulate examples/arch/spreading.toml --law rigid --step 0.005",
    "simulate examples/naju_flagpole --variant wedged --motion el-centro-1940-ns --keep-first 2",
    "simulate examples/heunginjimun_gate --variant soft_below --motion el-centro-1940-ns --keep-first 2",
    "check examples/heunginjimun_gate/two_directions.toml",
    "check examples/heunginjimun_gate/loose_tenons.toml",
    "simulate examples/heunginjimun_gate/loose_tenons.toml --motion el-centro",
    "simulate examples/heunginjimun_gate/two_directions.toml --motion el-centro --keep-first 6 --variant leaning",
    "simulate examples/free_columns/rigid_stones.toml --motion el-centro-1940-ns --keep-first 2",
    "simulate examples/several_dampers --motion el-centro-1940-ns --keep-first 2",
    "simulate examples/free_columns/wind.toml --variant no_ties --motion el-centro-1940-ns --keep-first 2",
    "tune examples/twisting_floor --floors all",
    "tune examples/several_dampers",
    "motion --motion el-centro-1940-ns --spectrum",
    "motion --motion el-centro-1940-ns --match --site S4 --zone 1 --years 2400",
    "motion --make noise --seed 1 --duration 8 --peak 0.3g --convert records/1.csv",
    "motion --make noise --seed 2 --duration 8 --peak 0.3g --convert records/2.csv",
    "motion --suite 2 --from records --site S2 --t1 0.3",
    "score examples/pagodas_of_figure_19",
    "study examples/naju_flagpole --study growth",
    "rank examples/portfolio/pagodas.csv",
    "survey add examples/palisaden --name palisaden --store s.db",
    "survey add examples/naju_flagpole --name naju --store s.db",
    "survey list --store s.db",
    "survey add examples/inspected_flagpole --name inspected --store s.db",
    "survey show palisaden --store s.db",
    "survey show inspected --store s.db",
    "survey show naju --store s.db",
    "survey verify --store s.db",
];

/// What writes glTF, a format of its own.
const OF_GLTF: [&str; 3] = ["film.rs", "mode_film.rs", "gltf.rs"];

/// `serde_json::json!` makes `null` of what is not finite; `as_json!` says so.
#[test]
fn holds_no_answer_is_made_by_the_macro_that_hides_numbers() {
    let mut folders = ["dolmen-report/src", "dolmen-cli/src"]
        .map(|folder| root().join("crates").join(folder))
        .to_vec();
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if name.ends_with(".rs") && !OF_GLTF.contains(&name.as_str()) {
                let text = fs::read_to_string(&path).unwrap();
                let code = text.split("#[cfg(test)]").next().unwrap();
                let mut lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
                let hides = lines.find(|line| {
                    let brings =
                        line.ends_with("json;") || line.contains(", json}") || line.contains("{json");
                    (line.starts_with("use serde_json") && brings) || line.contains("serde_json::json!")
                });
                assert_eq!(hides, None, "{}", path.display());
            }
        }
    }
}

/// Every key with its path: "state.check.chain.modes[].frequency_hz".
fn gather(value: &Value, path: &str, keys: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                let path = format!("{path}.{name}");
                gather(field, &path, keys);
                keys.insert(path);
            }
        }
        Value::Array(items) => {
            for item in items {
                gather(item, &format!("{path}[]"), keys);
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// Paths of numbers that are neither finite nor infinite.
fn not_numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                let path = format!("{path}.{name}");
                if name == "not_finite" && field.to_string().contains("not_a_number") {
                    found.push(format!("{path}: {field}"));
                }
                not_numbers(field, &path, found);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| not_numbers(item, path, found)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

#[test]
fn regress_json_has_the_keys_that_it_had() {
    let scratch = Scratch::with_examples("keys");
    let mut keys = BTreeSet::new();
    for command in COMMANDS {
        let verb = command.split(' ').next().unwrap();
        let answer = scratch.briefly(&format!("{command} --json --quiet"));
        let found: Value = serde_json::from_str(&answer.stdout)
            .unwrap_or_else(|error| panic!("{command}: {error}: {}{}", answer.stdout, answer.stderr));
        gather(&found, verb, &mut keys);
        let mut lost = Vec::new();
        not_numbers(&found, verb, &mut lost);
        assert!(lost.is_empty(), "{command}: no number and no reason: {lost:?}");
    }
    let found: String = keys.iter().map(|key| format!("{key}\n")).collect();
    let file = root().join("crates/dolmen-cli/tests/command/keys.txt");
    if std::env::var_os("DOLMEN_WRITE_KEYS").is_some() {
        fs::write(&file, &found).unwrap();
    }
    let held = fs::read_to_string(&file).unwrap();
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<BTreeSet<_>>();
    let (held, found) = (lines(&held), lines(&found));
    let gone: Vec<&String> = held.difference(&found).collect();
    let come: Vec<&String> = found.difference(&held).collect();
    assert!(
        gone.is_empty() && come.is_empty(),
        "gone: {gone:?}, come: {come:?}"
    );
}
