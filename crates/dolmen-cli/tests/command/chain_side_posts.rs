// SOURCE     The shipped flagpole between its side posts.
// GOAL       side_supports of a chain: tight in check and identify, with a gap in simulate, refused where impossible.
// TOLERANCE  ratios and words as each test says.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const POSTS: &str = "examples/naju_flagpole/side_posts.toml";

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.briefly(&format!("--json {words}"));
    serde_json::from_str(&answer.stdout)
        .unwrap_or_else(|why| panic!("{words}: {why}: {}{}", answer.stdout, answer.stderr))
}

#[test]
fn holds_tight_posts_count_in_the_check_and_loose_ones_do_not() {
    let scratch = Scratch::with_examples("side_posts_check");
    let check = json(&scratch, &format!("check {POSTS}"));
    let variant = |name: &str| -> &Value {
        let all = check["variants"].as_array().unwrap();
        &all.iter().find(|one| one["name"] == name).unwrap()["state"]["check"]["chain"]
    };
    let own = &check["state"]["check"]["chain"];
    let factor = |of: &Value| number(of, "/stability/load_factor");
    // a gap changes nothing, a tight post much
    assert_eq!(factor(own), factor(variant("without")));
    assert!(factor(variant("tight")) > 1.05 * factor(own));
    let without = number(variant("tight"), "/load_factor_without_supports");
    assert!((without / factor(own) - 1.0).abs() < 1e-12);
    assert_eq!(own["load_factor_without_supports"], Value::Null);
    let hz = |of: &Value| number(of, "/modes/0/frequency_hz");
    assert!(hz(variant("tight")) > 1.02 * hz(own));
    let said = scratch.dolmen(&format!("check {POSTS}"));
    assert!(
        said.words()
            .contains("leave its side supports with a gap out (1, the least gap 10.0 mm)"),
        "{}",
        said.stdout
    );
    assert!(
        said.words().contains("count its side supports without a gap (1)"),
        "{}",
        said.stdout
    );
}

#[test]
fn holds_posts_with_a_gap_are_met_in_motion() {
    let scratch = Scratch::with_examples("side_posts_simulate");
    let of = |variant: &str| {
        json(
            &scratch,
            &format!("simulate {POSTS} --motion el-centro {variant}"),
        )
    };
    let (own, tight, without) = (of(""), of("--variant tight"), of("--variant without"));
    let post = &own["side_supports"][0];
    let times = number(post, "/times_met");
    assert!(times >= 2.0, "{post}");
    // F = s (u − g)
    let force = 2e6 * (number(post, "/peak_displacement_m").abs() - 0.01);
    assert!(
        (number(post, "/peak_force_n").abs() / force - 1.0).abs() < 1e-9,
        "{post}"
    );
    assert_eq!(tight["side_supports"][0]["first_met_s"], 0.0);
    assert_eq!(without["side_supports"].as_array().map(Vec::len), Some(0));
    for run in [&own, &tight, &without] {
        assert!(number(run, "/energy/left_over_ratio") < 1e-9, "{}", run["energy"]);
    }
    // the supported part moves less
    let lowest = |run: &Value| number(run, "/links/0/peak_rotation_rad").abs();
    assert!(lowest(&own) < lowest(&without) && lowest(&tight) < lowest(&own));
    let answer = scratch.dolmen(&format!("simulate {POSTS} --motion el-centro --output out"));
    assert!(
        answer
            .words()
            .contains("It meets the side support at 3.00 m first at"),
        "{}",
        answer.stdout
    );
    let csv = fs::read_to_string(scratch.path().join("out/histories.csv")).unwrap();
    assert!(
        csv.lines().next().unwrap().ends_with(",support_1_force_n"),
        "{csv:.600}"
    );
    assert!(scratch.path().join("out/supports.svg").exists());
    let korean = scratch.briefly(&format!("simulate {POSTS} --motion el-centro --language ko"));
    assert!(korean.words().contains("측면 지지에"), "{}", korean.stdout);
}

#[test]
fn holds_a_pole_that_only_its_posts_hold_leans_on_them() {
    let scratch = Scratch::with_examples("side_posts_lean");
    let file = scratch.path().join("examples/naju_flagpole/side_posts.toml");
    let text = fs::read_to_string(&file).unwrap();
    // the lowest joint alone is too soft, and its bed does not open
    let text = text
        .replace(
            "{ value = 1109.5, source = \"assumed\" }",
            "150, damping = \"20 kN*m*s/rad\"",
        )
        .replace(
            "bed_width = { value = 0.65, source = \"assumed\" }",
            "opening = \"held\"",
        );
    let text = text.replace("damping_ratio = { value = 0.02, source = \"assumed\" }\n", "");
    fs::write(&file, &text).unwrap();
    let check = scratch.briefly(&format!("check {POSTS}"));
    assert_eq!(check.status, 1, "{}", check.stdout);
    assert!(
        check
            .words()
            .contains("It leans on its side supports without a gap (1)")
            || scratch
                .dolmen(&format!("check {POSTS}"))
                .words()
                .contains("It leans on its side supports without a gap (1)"),
        "{}",
        check.stdout
    );
    let run = json(
        &scratch,
        &format!("simulate {POSTS} --push 1e-3rad --duration 200"),
    );
    assert_ne!(run["outcome"]["kind"], "fell", "{}", run["outcome"]);
    assert!(number(&run, "/side_supports/0/times_met") >= 1.0);
    let alone = json(
        &scratch,
        &format!("simulate {POSTS} --push 1e-3rad --duration 200 --variant without"),
    );
    assert_eq!(alone["outcome"]["kind"], "fell", "{}", alone["outcome"]);
}

#[test]
fn refuses_a_post_that_cannot_be() {
    let scratch = Scratch::with_examples("side_posts_refused");
    let file = scratch.path().join("examples/naju_flagpole/side_posts.toml");
    let text = fs::read_to_string(&file).unwrap();
    let own = text
        .lines()
        .find(|line| line.starts_with("  { height = { value = 3.0") && line.contains("gap"))
        .unwrap();
    for (line, said) in [
        (
            "{ height = 12, stiffness = \"2 kN/mm\" }",
            "lies above the top of the chain, 10.83 m",
        ),
        (
            "{ height = 3, gap = \"1 cm\" }",
            "a side support needs side_supports[1].stiffness",
        ),
        (
            "{ stiffness = \"2 kN/mm\" }",
            "a side support needs side_supports[1].height",
        ),
        (
            "{ height = 3, stiffness = \"2 kN/mm\", gap = \"-1 mm\" }",
            "side_supports[1].gap",
        ),
        (
            "{ height = 3, stiffness = \"0 kN/mm\" }",
            "side_supports[1].stiffness",
        ),
        (
            "{ height = 3, stiffness = \"2 kN*m/rad\" }",
            "side_supports[1].stiffness",
        ),
        (
            "{ block = \"shaft 1\", stiffness = \"2 kN/mm\" }",
            "is for blocks: a chain is held at a height",
        ),
    ] {
        fs::write(&file, text.replacen(own, &format!("  {line},"), 1)).unwrap();
        let answer = scratch.briefly(&format!("check {POSTS}"));
        assert_eq!(answer.status, 2, "{line}: {}", answer.stdout);
        let stderr = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(stderr.contains(said), "{line}: {stderr}");
    }
}
