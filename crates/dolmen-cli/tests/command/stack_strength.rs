// SOURCE     Rectangular stress block by hand: N/(2 f l) inside the edge.
// GOAL       The key `strength` of a joint reaches answer, headline, JSON, loads and simulation in both languages; a mistyped value is refused.
// TOLERANCE  three printed digits; 1e-8 in JSON.

use super::verbs::Scratch;
use std::fs;

/// 0.5 × 0.8 × 2.4 m of 2600 kg/m³, g 10: N = 24.96 kN over 0.4 m², 62.4 kPa.
fn pillar(joint: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"stack\"\nname = \"Pillar\"\ngravity = 9.80665\ndensity = 2600\njoint = {{ friction = 0.9{joint} }}\n\
         blocks = [{{ name = \"pillar\", width = 0.5, depth = 0.8, height = 2.4 }}]\n{more}"
    )
}

fn scratch(name: &str, text: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch
}

fn json(scratch: &Scratch, words: &str) -> serde_json::Value {
    let answer = scratch.briefly(&format!("{words} --json"));
    serde_json::from_str(&answer.stdout).unwrap()
}

/// The block's resistance: (b/2 − N/(2 f l)) / h, with N = γ b l H.
fn moves_at_g(strength_pa: f64) -> f64 {
    (0.25 - 0.5 * 2.4 * 2600.0 * 9.80665 * 0.5 / strength_pa) / 1.2
}

#[test]
fn exact_a_strength_moves_the_pivot_in_and_the_answer_says_what_it_costs() {
    let scratch = scratch("crushing-pillar", &pillar(", strength = \"0.4 MPa\"", ""));
    let answer = scratch.briefly("check project.toml");
    let words = answer.words();
    let first = format!("it begins to move at {:.3} g", moves_at_g(4e5));
    assert_eq!(answer.status, 0, "{words}");
    assert!(words.contains(&first), "{first}: {words}");
    assert!(
        words.contains("Crushing governs: with a compressive strength of 0.400 MPa it begins to move at 0.176 g, at 0.208 g if no edge crushed."),
        "{words}"
    );
    let korean = scratch.briefly("check project.toml --language ko").words();
    assert!(
        korean.contains("압괴가 지배한다: 압축강도 0.400 MPa에서 0.176 g에 움직이기 시작하며"),
        "{korean}"
    );
    let found = json(&scratch, "check project.toml");
    let state = &found["check"];
    let text = found.to_string();
    assert!(text.contains("\"compressive_strength_pa\":400000.0"), "{text}");
    let at = |key: &str| {
        let from = text.find(&format!("\"{key}\":")).unwrap() + key.len() + 3;
        let until = from + text[from..].find([',', '}']).unwrap();
        text[from..until]
            .parse::<f64>()
            .unwrap_or_else(|_| panic!("{state}"))
    };
    assert!((at("moves_at_g") / moves_at_g(4e5) - 1.0).abs() < 1e-8);
    assert!((at("uncrushed_g") / (0.25 / 1.2) - 1.0).abs() < 1e-8);
    assert!((at("crushed_m") - 0.5 * 2.4 * 2600.0 * 9.80665 * 0.5 / 4e5).abs() < 1e-9);
}

#[test]
fn exact_a_joint_too_weak_for_its_weight_is_unstable_and_the_headline_says_that_it_crushes() {
    // The 2.4 m press with 61.2 kPa, below every strength that a file may give; a heavy stone on a small bed presses more
    let text = "schema = 1\nkind = \"stack\"\nname = \"Heavy\"\ndensity = 2600\njoint = { friction = 0.9, strength = \"0.2 MPa\" }\n\
                blocks = [{ name = \"foot\", width = 0.3, depth = 0.3, height = 0.5 }, { name = \"cap\", width = 1, depth = 1, height = 0.9 }]\n";
    let scratch = scratch("too-weak", text);
    let answer = scratch.briefly("check project.toml");
    let words = answer.words();
    assert_eq!(answer.status, 1, "{words}");
    assert!(
        words.contains("Own weight: unstable (edges of stones crush)"),
        "{words}"
    );
    assert!(
        words.contains("the stone crushes: 0.268 MPa over the whole joint, and its strength is 0.200 MPa"),
        "{words}"
    );
    assert!(words.contains("it would if no edge crushed"), "{words}");
    let korean = scratch.briefly("check project.toml --language ko").words();
    assert!(korean.contains("불안정(석재 모서리 압괴)"), "{korean}");
    let run = scratch.briefly("simulate project.toml --motion el-centro-1940-ns --repeats 1");
    assert_eq!(run.status, 1, "{} {}", run.words(), run.stderr);
}

#[test]
fn exact_loads_find_the_same_lever_and_the_answer_gives_the_factor_without_crushing() {
    let push = "loads = [{ name = \"push\", at = \"pillar\", height = 2.4, force = [1000, 0, 0] }]\n";
    let scratch = scratch("pushed-pillar", &pillar(", strength = \"0.4 MPa\"", push));
    let answer = scratch.briefly("check project.toml");
    let words = answer.words();
    let weight_n = 0.96 * 2600.0 * 9.80665;
    let factor = weight_n * moves_at_g(4e5) * 1.2 / (1000.0 * 2.4);
    assert!(words.contains(&format!("{factor:.2}")), "{factor}: {words}");
    assert!(
        words.contains("Edges of stones crush on the way there; if none did, the factor would be 2.55"),
        "{words}"
    );
}

#[test]
fn holds_a_run_names_the_joint_that_crushes_with_time_force_and_factor() {
    let scratch = scratch("crushing-run", &pillar(", strength = \"0.4 MPa\"", ""));
    for law in ["rigid", "springs"] {
        let run = format!("simulate project.toml --motion el-centro-1940-ns --law {law} --repeats 1");
        let words = scratch.briefly(&run).words();
        assert!(
            words.contains("The stone crushes between 'pillar' and 'ground': at "),
            "{words}"
        );
        assert!(words.contains("with a strength of 0.400 MPa"), "{words}");
        assert!(
            scratch
                .briefly(&format!("{run} --full"))
                .words()
                .contains("bearable")
        );
        let found = json(&scratch, &run);
        let bearing = &found["joints"][0]["bearing"];
        let at = |key: &str| bearing[key].as_f64().unwrap_or_else(|| panic!("{key}: {found}"));
        assert!(bearing["crushes"] == true && at("ratio") >= 1.0, "{bearing}");
        assert!(
            (at("ratio") * at("bears_n") / at("force_n") - 1.0).abs() < 1e-12,
            "{bearing}"
        );
        let korean = scratch.briefly(&format!("{run} --language ko")).words();
        assert!(
            korean.contains("‘pillar’와 ‘지반’ 사이의 석재가 압괴한다"),
            "{korean}"
        );
        // under little shaking no edge crushes, and without a strength nothing is compared
        let still = format!("{run} --peak 0.02g --full");
        let words = scratch.briefly(&still).words();
        assert!(
            words.contains("No edge crushes: the most loaded bed, of 'pillar' on 'ground', bears 0."),
            "{words}"
        );
        assert!(!words.contains("(stone crushes)"), "{words}");
    }
    let bare = Scratch::new("no-crushing-run");
    fs::write(bare.path().join("project.toml"), pillar("", "")).unwrap();
    let run = "simulate project.toml --motion el-centro-1940-ns --law springs --repeats 1";
    assert!(json(&bare, run)["joints"][0]["bearing"].is_null());
    assert!(!bare.briefly(&format!("{run} --full")).words().contains("crush"));
}

#[test]
fn holds_a_joint_that_only_crushes_makes_the_judgement_amber() {
    // the pressure at rest is 0.5 of the strength, and the pillar rocks by less than a millimetre
    let scratch = scratch("crushing-amber", &pillar(", strength = \"0.125 MPa\"", ""));
    let answer = scratch
        .briefly("simulate project.toml --motion el-centro-1940-ns --peak 0.12g --law springs --repeats 1");
    let words = answer.words();
    assert!(words.contains("near demand (stone crushes)"), "{words}");
}

#[test]
fn holds_an_arch_that_crushes_is_not_shaken() {
    let text = "schema = 1\nkind = \"stack\"\nname = \"Arch\"\ndensity = 2600\njoint = { friction = 0.7, strength = \"0.1 MPa\" }\n\
                arch = { span = 4, thickness = 0.5, depth = 1, voussoirs = 9 }\n";
    let scratch = scratch("weak-arch", text);
    let check = scratch.briefly("check project.toml");
    assert_eq!(check.status, 1, "{}", check.words());
    assert!(
        check
            .words()
            .contains("Own weight: unstable (edges of stones crush)"),
        "{}",
        check.words()
    );
    let run = scratch.briefly("simulate project.toml --motion el-centro-1940-ns --peak 0.01g --repeats 1");
    assert_eq!(run.status, 1, "{} {}", run.words(), run.stderr);
    assert!(
        run.words()
            .contains("edges of stones that share their load crush"),
        "{}",
        run.words()
    );
}

#[test]
fn refuses_a_strength_in_megapascals_without_their_unit() {
    let scratch = scratch("strength-slip", &pillar(", strength = 30", ""));
    let answer = scratch.briefly("check project.toml");
    assert_eq!(answer.status, 2);
    assert!(
        answer.stderr.contains("joints crush at 0.1 MPa to 1 GPa"),
        "{}",
        answer.stderr
    );
    let korean = scratch.briefly("check project.toml --language ko");
    assert!(
        korean.stderr.contains("접합면의 압축강도는 0.1 MPa~1 GPa이다"),
        "{}",
        korean.stderr
    );
}
