// SOURCE     What an engineer's first reading of the answers missed: two surveys without modes, samples that fall, a study beyond the limit
//            of its file, wind without a limit.
// GOAL       The answer gives what decides, and no green word beside it contradicts it.
// TOLERANCE  none: words and exit statuses; the moment of wind and its drift are printed numbers of `check`.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const SURVEYS: &str = "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n\
    [survey.2010]\ntilt = { x = \"1/170\", y = \"1/300\" }\n\
    inspections = [{ part = \"base\", what = \"crack\", size = \"0.2 mm\" }, { part = \"base\", what = \"spalling\", size = \"40 mm\" }]\n\
    [survey.2024]\ntilt = { x = \"1/120\", y = \"1/310\" }\n\
    inspections = [{ part = \"base\", what = \"crack\", size = \"0.5 mm\" }, { part = \"mid\", what = \"loss\" }]\n";

/// One stone on a bed of 0.6 m: 20 kN at 1.5 m, so that a stiffness below 30 kN m/rad is unstable.
const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ndamping_ratio = 0.02\n\
    links = [{ name = \"shaft\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\n";

const BUILDING: &str = "schema = 1\nkind = \"building\"\nname = \"Pavilion\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }\n\
    floors = [{ mass = 60, sides = [12, 8], height = 4.5, stiffness = { x = 3, y = 2.2, rotation = \"60 MN*m/rad\", centre = [1, 0] } }]\n\
    damping.ratio = 0.03\n";

const WIND: &str = "wind = { code = \"EN 1991-1-4\", speed = \"45 m/s\", means = \"10 min\", terrain = \"II\", force_coefficient = 1.3 }\n";

struct Said {
    status: i32,
    words: String,
}

fn of(name: &str, text: &str, command: &str) -> Said {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(command);
    Said {
        status: answer.status,
        words: format!("{}{}", answer.words(), answer.stderr),
    }
}

fn json(name: &str, text: &str, command: &str) -> Value {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(&format!("--json {command}"));
    serde_json::from_str(&answer.stdout)
        .unwrap_or_else(|why| panic!("{why}: {}{}", answer.stdout, answer.stderr))
}

#[test]
fn holds_tilts_and_inspections_are_compared_without_modes() {
    let said = of("readings", SURVEYS, "compare project.toml");
    assert_eq!(said.status, 0, "{}", said.words);
    for words in [
        "it leans further: x 1/170 to 1/120 (+2.45 mm/m) and y 1/300 to 1/310 (−0.11 mm/m)",
        "worse or new: crack of “base” (0.2 mm to 0.5 mm) and loss of “mid” (new)",
        "Not in inspection 2024, mended or not looked for: spalling of “base”",
        "No frequencies of both surveys are known (none in 2010 and 2024)",
    ] {
        assert!(said.words.contains(words), "{words}: {}", said.words);
    }
    let found = json("readings-json", SURVEYS, "compare project.toml");
    let change = found["tilts"][0]["change"].as_f64().unwrap();
    assert!((change - (1.0 / 120.0 - 1.0 / 170.0)).abs() < 1e-12, "{found}");
    assert_eq!(found["inspections"][0]["course"], "sized");

    // other marks: no statement about tilts
    let other = SURVEYS.replace("[survey.2010]", "[survey.2010]\ndatum = \"bolt A\"");
    let other = other.replace("[survey.2024]", "[survey.2024]\ndatum = \"bolt B\"");
    let said = of("readings-datum", &other, "compare project.toml");
    assert!(
        said.words.contains("different marks") && !said.words.contains("leans further"),
        "{}",
        said.words
    );

    // nothing grew
    let calm = SURVEYS.replace("1/120", "1/180").replace("0.5 mm", "0.2 mm");
    let calm = calm.replace(", { part = \"mid\", what = \"loss\" }", "");
    let said = of("readings-calm", &calm, "compare project.toml");
    assert!(
        said.words.contains("no tilt grew")
            && said.words.contains("nothing new and nothing larger (1 compared)"),
        "{}",
        said.words
    );
}

#[test]
fn holds_samples_that_fall_are_in_the_word() {
    // 100 kN m/rad is 3.3 times the stiffness that the weight needs; with a cov of 80 % some of a hundred samples are below 30
    let scattered = format!("{POLE}joints = [{{ stiffness = {{ value = 100, cov = 0.8 }} }}]\n");
    let said = of("samples", &scattered, "check project.toml --samples 400");
    assert!(
        said.status == 0 && said.words.contains("VERDICT Own weight: marginal (falls in "),
        "{}",
        said.words
    );
    let found = json("samples-json", &scattered, "check project.toml --samples 400");
    let version = &found["judgement"]["versions"][0];
    let share = version["falling_share"].as_f64().unwrap();
    assert!(
        share > 0.01 && version["weight"]["word"] == "marginal",
        "{version}"
    );
    // a cov with which all stand changes nothing
    let narrow = scattered.replace("cov = 0.8", "cov = 0.05");
    let said = of("samples-narrow", &narrow, "check project.toml --samples 400");
    assert!(
        said.words.contains("VERDICT Own weight: stable"),
        "{}",
        said.words
    );
    assert!(!said.words.contains("of samples)"), "{}", said.words);
}

#[test]
fn holds_a_study_names_the_allowable_drift_of_its_file() {
    let limited = format!(
        "{BUILDING}[limits]\nstorey_drift = \"1/100\"\n[motion.e]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n\
         [study.s]\nmotions = [\"e\"]\npeak = [\"0.01 g\", \"0.2 g\", \"0.4 g\"]\n"
    );
    let said = of("study-limit", &limited, "study project.toml");
    assert!(
        said.words
            .contains("1 of 1 scan drifted beyond the allowable 1.00 % of a storey"),
        "{}",
        said.words
    );
    let wide = limited.replace("1/100", "1/10").replace("0.4 g", "0.21 g");
    let said = of("study-within", &wide, "study project.toml");
    assert!(
        said.words
            .contains("None of 1 scan drifted beyond the allowable 10.0 % of a storey"),
        "{}",
        said.words
    );
    let said = of(
        "study-none",
        &limited.replace("[limits]\nstorey_drift = \"1/100\"\n", ""),
        "study project.toml",
    );
    assert!(!said.words.contains("allowable"), "{}", said.words);
}

#[test]
fn holds_wind_is_judged_by_the_limits_of_the_file_or_not_at_all() {
    let blown = format!("{BUILDING}{WIND}");
    let said = of("wind-no-limit", &blown, "check project.toml");
    assert!(
        said.status == 0 && said.words.contains("Wind: not decided (no limit is known)"),
        "{}",
        said.words
    );
    // far beyond the limit of the file for earthquakes
    let limited = format!("{blown}[limits]\nstorey_drift = \"1/400\"\n");
    for command in [
        "check project.toml",
        "simulate project.toml --wind --repeats 1 --duration 60",
    ] {
        let said = of("wind-drift", &limited, command);
        assert!(
            said.status == 1 && said.words.contains("Wind: beyond its limits (limit/drift 0."),
            "{command}: {}",
            said.words
        );
    }
    // within the limit nothing is stated: it is a limit for earthquakes
    let wide = limited.replace("1/400", "1/11").replace("45 m/s", "10 m/s");
    let said = of("wind-wide", &wide, "check project.toml");
    assert!(said.words.contains("Wind: not decided"), "{}", said.words);
}

#[test]
fn holds_a_full_answer_has_what_the_brief_one_has() {
    let scratch = Scratch::with_examples("full-has-all");
    for example in ["pagoda_with_a_logger", "pagoda_over_the_years"] {
        let brief = scratch.briefly(&format!("check examples/{example}"));
        let full = scratch.dolmen(&format!("check examples/{example}")).words();
        // line breaks of the short and the full answer may differ
        let findings = brief
            .stdout
            .lines()
            .filter(|line| ["  ○ ", "  ◆ ", "  - "].iter().any(|mark| line.starts_with(mark)));
        let mut count = 0;
        for line in findings {
            assert!(
                full.contains(&line.trim().chars().take(40).collect::<String>()),
                "{example}: {line}: {full}"
            );
            count += 1;
        }
        assert!(count > 0, "{example}: {}", brief.stdout);
    }
}

#[test]
fn holds_what_decides_stands_before_what_it_depends_on() {
    let pole = format!(
        "{POLE}joints = [{{ stiffness = {{ value = 90, cov = 0.1 }} }}]\n[survey.2026-04-02]\ntilt = {{ x = \"1/300\" }}\n"
    );
    let answer = of("order", &pole, "check . --samples 200 --sensitivity");
    let at = |words: &str| {
        answer
            .words
            .find(words)
            .unwrap_or_else(|| panic!("{words}: {}", answer.words))
    };
    assert!(
        at("With this stiffness it stands") < at("With the scatter given")
            && at("With the scatter given") < at("Inputs with the largest effect on"),
        "{}",
        answer.words
    );
    // criteria for unknown stiffness have no effect if the stiffness is known
    assert!(
        !answer.words.contains("buckling of a post on one spring"),
        "{}",
        answer.words
    );
    let unknown = of("unknown", &format!("{POLE}joints = \"unknown\"\n"), "check .");
    assert!(
        unknown.words.contains("buckling of a post on one spring"),
        "{}",
        unknown.words
    );
}
