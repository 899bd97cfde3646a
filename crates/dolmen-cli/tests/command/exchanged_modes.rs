// SOURCE     examples/frame_on_soft_ground and examples/palisaden, whose modes are written and read back; modes_pyuff.uff of pyuff 2.5.8.
// GOAL       identify, check and compare accept modes from another program, and those that Dolmen writes, as the modes of a survey.
// TOLERANCE  2e-5: the six digits of a universal file; for a table none, except 1e-15 for deviations, which are stored relative to the mean.

use super::verbs::{Scratch, root};
use serde_json::Value;

const HOUSE: &str = "examples/palisaden";

/// Two surveys of a chain of three stones: one written by pyuff, one by Dolmen.
const CHAIN: &str = r#"schema = 1
kind = "chain"
name = "Pillar"
units = { force = "kN", length = "m" }
links = [{ weight = 20, length = 3, centroid = 1.5 }, { weight = 15, length = 3, centroid = 1.5 }, { weight = 10, length = 3, centroid = 1.5 }]
joints = "unknown"
[survey."2026-04-02"]
modes = { file = "modes.uff" }
[survey."2024-04-02"]
frequencies = { x = [2.2, 6.6, 9.3] }
"#;

#[test]
fn holds_modes_that_dolmen_writes_are_read_back() {
    let scratch = Scratch::with_examples("exchanged_modes");
    let found = scratch.dolmen(&format!("identify {HOUSE} -o out --json"));
    let found: Value = serde_json::from_str(&found.stdout).unwrap();
    let modes = found["surveys"][0]["records"]["modes"]["modes"]
        .as_array()
        .unwrap();
    for (file, within) in [("ambient-modes.uff", 2e-5), ("ambient-modes.csv", 0.0)] {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Back\"\n[survey.\"2019-01-01\"]\nmodes = {{ file = \"out/{file}\" }}\n\
             [survey.\"2020-01-01\"]\nmodes = {{ file = \"out/{file}\" }}\n"
        );
        std::fs::write(scratch.path().join("back.toml"), text).unwrap();
        let said = scratch.dolmen("compare back.toml --json");
        let answer: Value = serde_json::from_str(&said.stdout).unwrap_or_else(|_| panic!("{}", said.stderr));
        let compared = answer["modes"].as_array().unwrap();
        assert_eq!(compared.len(), modes.len(), "{file}");
        for mode in modes {
            let [hz, sd] = ["frequency_hz", "frequency_sd_hz"].map(|key| mode[key].as_f64().unwrap());
            let back = compared.iter().find(|of| {
                let read = of["from"]["frequency_hz"].as_f64().unwrap();
                (read / hz - 1.0).abs() <= within
            });
            let back = back.unwrap_or_else(|| panic!("{file}: {hz} of {compared:?}"));
            let read = back["from"]["frequency_sd_hz"].as_f64().unwrap();
            let most = if within > 0.0 { 1e-6 } else { 1e-15 * sd };
            assert!((read - sd).abs() <= most, "{read} {sd}");
        }
    }
}

#[test]
fn holds_check_and_compare_use_the_modes_of_pyuff() {
    let scratch = Scratch::new("exchanged_modes_chain");
    let file = "crates/dolmen-records/tests/data/modes/modes_pyuff.uff";
    std::fs::copy(root().join(file), scratch.path().join("modes.uff")).unwrap();
    std::fs::write(scratch.path().join("project.toml"), CHAIN).unwrap();
    let found = scratch.dolmen("identify . --survey 2026-04-02");
    assert!(
        found.words().contains("2.125"),
        "{}{}",
        found.stdout,
        found.stderr
    );
    let compared = scratch.dolmen("compare .");
    assert!(
        compared.words().contains("2.2") && compared.words().contains("2.125"),
        "{}{}",
        compared.stdout,
        compared.stderr
    );
    let wrong = CHAIN.replace("modes.uff\" }", "modes.uff\", length = \"m\" }");
    std::fs::write(scratch.path().join("project.toml"), wrong).unwrap();
    let said = scratch.dolmen("check . --language ko");
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("길이의 단위가 있는데"), "{}", said.stderr);
}
