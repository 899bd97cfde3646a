// SOURCE     Closed forms of one joint and of two storeys; the same file with the stiffness written into it by `identify --write`.
// GOAL       "identified" is the stiffness from the modes of a survey, with its deviation, in check, simulate, study and report. Of several
//            solutions the worst decides; without any, the stiffness is unknown and the answer gives the reason.
// TOLERANCE  the digits written: a thousandth of a standard deviation.

use super::verbs::Scratch;
use serde_json::Value;
use std::f64::consts::TAU;
use std::fs;

/// One stone on one rotational joint: (2π f)² (I + m h²) = k − m g h.
const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ngravity = 9.81\n\
    links = [{ name = \"shaft\", mass = \"2000 kg\", length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\n\
    joints = \"identified\"\ndamping_ratio = { value = 0.02, source = \"assumed\" }\n\
    [motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n[study.sizes]\nmotions = [\"ec\"]\nscale = [0.5, 1.0]\n\
    [survey.2025-01-01]\nfrequencies = { x = [{ value = 3.0, sd = 0.01, source = \"measured\" }] }\n\
    [survey.2026-04-02]\nfrequencies = { x = [{ value = 2.0, sd = 0.01, source = \"measured\" }] }\n";

/// Two storeys with two measured frequencies, which two pairs of stiffness satisfy.
const GATE: &str = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }\n\
    storeys = [{ mass = 290, height = 5.84 }, { mass = 314, height = 7.69 }]\n\
    [direction.x]\nstiffness = \"identified\"\ndamping_ratio = { value = 0.02, source = \"assumed\" }\n\
    [limits]\nstorey_drift = \"1/100\"\nsource = \"a\"\n[motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\n\
    [survey.2026-04-02]\nfrequencies = { x = [{ value = 1.1, sd = 0.01, source = \"measured\" }, { value = 4.2, sd = 0.01, source = \"measured\" }] }\n";

fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.dolmen(&format!("{words} --json"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|error| panic!("{words}: {error}: {}", answer.stderr))
}

fn factor(found: &Value, at: &str) -> f64 {
    let check = found.pointer(at).unwrap();
    check
        .pointer("/stability/load_factor")
        .and_then(Value::as_f64)
        .unwrap_or_else(|| panic!("{check}"))
}

#[test]
fn exact_joints_of_the_latest_survey_have_the_stiffness_of_the_closed_form() {
    let scratch = Scratch::new("identified-pole");
    fs::write(scratch.path().join("project.toml"), POLE).unwrap();
    let inertia = 2000.0 * (9.0 + 0.36) / 12.0 + 2000.0 * 1.5 * 1.5;
    let gravity = 2000.0 * 9.81 * 1.5;
    let of_hz = |hz: f64| ((TAU * hz).powi(2) * inertia + gravity) / gravity;
    let found = json(&scratch, "check project.toml");
    let load_factor = factor(&found, "/state/check/chain");
    assert!(
        (load_factor / of_hz(2.0) - 1.0).abs() < 1e-5,
        "{load_factor} {}",
        of_hz(2.0)
    );
    let input = found["project"]["inputs"].as_array().unwrap();
    let joint = input
        .iter()
        .find(|of| of["path"] == "joints[1].stiffness")
        .unwrap();
    // d ln k / d ln f = 2 (k − m g h) / k, and the deviation of 2.0 Hz is half a per cent
    let cov = 2.0 * 0.005 * (1.0 - 1.0 / of_hz(2.0));
    assert!(
        (joint["cov"].as_f64().unwrap() / cov - 1.0).abs() < 0.01,
        "{joint} {cov}"
    );
    assert_eq!(
        found["project"]["from_surveys"]["parts"][0]["survey"],
        "2026-04-02"
    );
    let said = scratch.dolmen("check project.toml --samples 200");
    assert_eq!(said.status, 0, "{}", said.words());
    for words in [
        "The stiffness of the joints is identified from survey 2026-04-02: 986 ± 10 kN·m/rad. Nothing checks it",
        "Model: not measured (calibrated to 2026-04-02)",
        "stiffness unchecked, it fits by construction (survey 2026-04-02)",
        "○ With this stiffness it stands",
        "0 of 200 samples",
    ] {
        assert!(said.words().contains(words), "{words}: {}", said.words());
    }
    // the survey that the file names instead
    let other = POLE.replace(
        "\"identified\"",
        "{ source = \"identified\", survey = \"2025-01-01\" }",
    );
    fs::write(scratch.path().join("other.toml"), other).unwrap();
    let older = factor(&json(&scratch, "check other.toml"), "/state/check/chain");
    assert!((older / of_hz(3.0) - 1.0).abs() < 1e-5, "{older}");
}

#[test]
fn agrees_every_verb_with_the_file_that_has_the_stiffness_written_into_it() {
    let scratch = Scratch::new("identified-verbs");
    let alone = POLE.replace(
        "[survey.2025-01-01]\nfrequencies = { x = [{ value = 3.0, sd = 0.01, source = \"measured\" }] }\n",
        "",
    );
    fs::write(scratch.path().join("project.toml"), &alone).unwrap();
    fs::write(
        scratch.path().join("written.toml"),
        alone.replace("\"identified\"", "\"unknown\""),
    )
    .unwrap();
    assert_eq!(scratch.dolmen("identify written.toml --write").status, 0);
    let both = |words: &str, at: &str| {
        let of = |file: &str| json(&scratch, &words.replace("FILE", file)).pointer(at).cloned();
        let (own, written) = (of("project.toml"), of("written.toml"));
        assert!(
            own.is_some() && own == written,
            "{words} {at}: {own:?} {written:?}"
        );
    };
    both("check FILE", "/state");
    both("simulate FILE --motion ec", "/links");
    both("simulate FILE --motion ec", "/judgement/versions/0/earthquake");
    both("study FILE -o FILE.out", "/levels");
    let report = scratch.dolmen("report project.toml -o r.html --quiet");
    assert_eq!(report.status, 0, "{}", report.stderr);
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    assert!(
        page.contains("is identified from survey 2026-04-02"),
        "not on the page"
    );
    let simulated = scratch.briefly("simulate project.toml --motion ec").words();
    let study = scratch.briefly("study project.toml -o again").words();
    for said in [simulated, study] {
        assert!(said.contains("is identified from survey 2026-04-02"), "{said}");
    }
}

/// One frequency gives one joint's stiffness whatever the pole is: the answers, identified at once or written first, are not green.
#[test]
fn holds_no_answer_is_green_on_a_stiffness_that_nothing_checks() {
    let scratch = Scratch::new("identified-unchecked");
    let alone = POLE.replace(
        "[survey.2025-01-01]\nfrequencies = { x = [{ value = 3.0, sd = 0.01, source = \"measured\" }] }\n",
        "",
    );
    fs::write(scratch.path().join("own.toml"), &alone).unwrap();
    let unknown = alone.replace("\"identified\"", "\"unknown\"");
    fs::write(scratch.path().join("written.toml"), unknown).unwrap();
    let offered = scratch.dolmen("identify written.toml").words();
    assert!(offered.contains("by construction"), "{offered}");
    let written = scratch.dolmen("identify written.toml --write").words();
    assert!(written.contains("Nothing checks these values"), "{written}");
    for file in ["own.toml", "written.toml"] {
        let found = json(&scratch, &format!("check {file}"));
        let version = &found["judgement"]["versions"][0];
        assert_eq!(version["colour"], "amber", "{file}: {version}");
        assert_eq!(
            version["unchecked_stiffness_from"],
            serde_json::json!(["2026-04-02"])
        );
        let said = scratch.dolmen(&format!("check {file}")).words();
        assert!(!said.contains('●'), "{file}: {said}");
    }
}

#[test]
fn exact_of_two_solutions_the_worse_decides_and_both_are_named() {
    let scratch = Scratch::new("identified-gate");
    fs::write(scratch.path().join("project.toml"), GATE).unwrap();
    let found = json(&scratch, "check project.toml");
    let factors: Vec<f64> = [&found["state"], &found["variants"][0]["state"]]
        .iter()
        .map(|state| factor(state, "/check/frame/0/check"))
        .collect();
    assert!(factors[0] < factors[1], "{factors:?}");
    // ω² of both modes: product and sum, with the geometric stiffness N/h of each storey subtracted
    let inputs = found["project"]["inputs"].as_array().unwrap();
    let stiffness = |path: &str| {
        let of = inputs.iter().find(|of| of["path"] == path).unwrap();
        of["value"].as_f64().unwrap()
    };
    let (m1, m2, g) = (290e3, 314e3, 9.80665);
    let k1 = stiffness("direction.x.stiffness[1]") - (m1 + m2) * g / 5.84;
    let k2 = stiffness("direction.x.stiffness[2]") - m2 * g / 7.69;
    let squares = [1.1, 4.2].map(|hz: f64| (TAU * hz).powi(2));
    let product = k1 * k2 / (m1 * m2) / (squares[0] * squares[1]);
    let sum = ((k1 + k2) / m1 + k2 / m2) / (squares[0] + squares[1]);
    assert!(
        (product - 1.0).abs() < 1e-4 && (sum - 1.0).abs() < 1e-4,
        "{product} {sum}"
    );
    assert_eq!(found["project"]["from_surveys"]["solutions"], 2);
    assert_eq!(found["judgement"]["versions"][0]["solution"]["of"], 2);
    let said = scratch.dolmen("check project.toml").words();
    let number = found["project"]["from_surveys"]["solution"].as_u64().unwrap();
    for words in [
        "which 2 solutions explain".to_owned(),
        format!("What follows rests on solution {number}"),
        format!("Solution {}", 3 - number),
        format!("solution {number} of 2 from the survey"),
    ] {
        assert!(said.contains(&words), "{words}: {said}");
    }
    let run = scratch.briefly("simulate project.toml --motion ec");
    for words in ["Solution 1: ", "Solution 2: "] {
        assert!(run.words().contains(words), "{}", run.words());
    }
    // all together give the worst of the single ones
    let exit = |more: &str| {
        scratch
            .briefly(&format!("simulate project.toml --motion ec{more}"))
            .status
    };
    let other = exit(&format!(" --variant solution_{}", 3 - number));
    assert!(run.status == 1 || other != 1, "{} {other}", run.status);
    let study = GATE.to_owned() + "[study.s]\nmotions = [\"ec\"]\nscale = [0.5]\n";
    fs::write(scratch.path().join("study.toml"), study).unwrap();
    let studied = scratch.briefly("study study.toml -o out").words();
    assert!(studied.contains("that a check judges worst"), "{studied}");
}

#[test]
fn holds_what_no_survey_tells_stays_unknown_and_says_why() {
    let scratch = Scratch::new("identified-not");
    let said = |name: &str, text: String| {
        fs::write(scratch.path().join(name), text).unwrap();
        let answer = scratch.dolmen(&format!("check {name}"));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        assert!(
            answer.words().contains("Own weight: unknown"),
            "{}",
            answer.words()
        );
        answer.words()
    };
    let (head, _) = POLE.split_once("[survey.2025-01-01]").unwrap();
    let none = said("none.toml", head.to_owned());
    assert!(
        none.contains("no survey of the file has records or frequencies"),
        "{none}"
    );
    let one = said(
        "one.toml",
        GATE.replace(", { value = 4.2, sd = 0.01, source = \"measured\" }", ""),
    );
    assert!(one.contains("fewer modes than there are unknowns"), "{one}");
    let impossible = said("impossible.toml", GATE.replace("value = 4.2", "value = 1.3"));
    assert!(
        impossible.contains("no stiffness explains the modes of survey 2026-04-02"),
        "{impossible}"
    );
}

#[test]
fn refuses_a_survey_that_is_not_there_and_a_variant_that_seeks() {
    let scratch = Scratch::new("identified-refused");
    let refused = |text: String| {
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        let answer = scratch.dolmen("check project.toml");
        assert_eq!(answer.status, 2, "{}", answer.words());
        answer.stderr
    };
    let none = refused(POLE.replace("\"identified\"", "{ source = \"identified\", survey = \"2031\" }"));
    assert!(
        none.contains("joints is identified from survey \"2031\", which the file does not have"),
        "{none}"
    );
    let variant = POLE.replace("\"identified\"", "\"unknown\"") + "[variant.a]\njoints = \"identified\"\n";
    let variant = refused(variant);
    assert!(
        variant.contains("variant \"a\" leaves joints to a survey"),
        "{variant}"
    );
    let word = refused(POLE.replace("\"identified\"", "\"identify\""));
    assert!(word.contains("identified"), "{word}");
}

/// One joint and one frequency: any frequency has its stiffness, so that nothing checks the model.
#[test]
fn holds_as_many_frequencies_as_unknowns_check_nothing() {
    let scratch = Scratch::new("identified-by-construction");
    fs::write(scratch.path().join("project.toml"), POLE).unwrap();
    let answer = scratch.briefly("identify project.toml");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let said = "nothing checks it: with as many unknown stiffnesses as frequencies it fits whatever the structure is.";
    assert!(answer.words().contains(said), "{}", answer.stdout);
    assert!(answer.stdout.contains("○ Stiffness"), "{}", answer.stdout);
    assert!(!answer.stdout.contains("● Stiffness"), "{}", answer.stdout);
    let korean = scratch.briefly("identify project.toml --language ko").words();
    assert!(korean.contains("해는 하나이나 검증되지 않았다"), "{korean}");
}
