// SOURCE     The shipped examples.
// GOAL       Terminal, page, index page, JSON and exit status take their words and colours from one judgement, and a flag of another kind is
//            refused by name.
// TOLERANCE  none: words, colours and exit statuses.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

#[test]
fn holds_a_building_beyond_its_stroke_is_red_wherever_it_is_judged() {
    let scratch = Scratch::with_examples("judged_stroke");
    let file = scratch.path().join("examples/several_dampers/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("stroke = \"600 mm\"", "stroke = \"20 mm\"")).unwrap();
    // the motion of the file, rotated to the dampers
    let moved = "examples/several_dampers --motion el-centro";
    let answer = scratch.dolmen(&format!("simulate {moved}"));
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(answer.stdout.contains("is beyond its room"), "{}", answer.stdout);
    let answer = scratch.dolmen(&format!("--json simulate {moved}"));
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let judgement = &json["judgement"];
    assert_eq!(judgement["colour"], "red");
    let earthquake = &judgement["versions"][0]["earthquake"];
    assert_eq!(earthquake["word"], "below demand");
    assert_eq!(earthquake["reasons"][0]["decided_by"], "room");
    assert_eq!(earthquake["reasons"][0]["part"], "pair-1");
    let answer = scratch.dolmen(&format!(
        "report examples/twisting_floor {moved} --samples 0 -o page.html"
    ));
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let index = page.split("</nav>").next().unwrap();
    let line = index
        .split("<li>")
        .find(|line| line.contains("report-2"))
        .unwrap();
    assert!(
        line.contains("✕ Own weight: stable · Earthquake el-centro: below demand (room/stroke of"),
        "{line}"
    );
    let own = page.split("id=\"report-2\"").nth(1).unwrap();
    let banner = own.split("class=\"answers\"").next().unwrap();
    assert!(
        banner.contains("verdict unstable")
            && banner.contains("✕ Own weight: stable · Earthquake el-centro: below demand (room/stroke of"),
        "{banner}"
    );
    assert!(!banner.contains('●'), "{banner}");
}

#[test]
fn holds_a_variant_beyond_its_room_under_its_site_is_named_and_shows_its_colour() {
    let scratch = Scratch::with_examples("judged_variant");
    let file = scratch.path().join("examples/twisting_floor/project.toml");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replace("mass = 5.125", "mass = 5.125\nstroke = \"20 mm\""),
    )
    .unwrap();
    let answer = scratch.dolmen("check examples/twisting_floor");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    assert!(
        answer.words().contains(
            "VERDICT Own weight: stable · Earthquake KDS 17 10 00, 2400 y: not decided (no limit is known)"
        ) && answer
            .words()
            .contains("VERDICT Own weight: stable · Earthquake KDS 17 10 00, 2400 y: below demand"),
        "{}",
        answer.stdout
    );
    let answer = scratch.dolmen("--json check examples/twisting_floor");
    assert_eq!(answer.status, 1, "{}", answer.stderr);
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let versions = &json["judgement"]["versions"];
    assert_eq!(json["judgement"]["colour"], "red");
    assert_eq!(
        (&versions[0]["colour"], &versions[1]["colour"]),
        (&Value::from("amber"), &Value::from("red"))
    );
    for (language, said) in [
        (
            "en",
            "Variant “With a tuned mass at the right end”: Own weight: stable · Earthquake KDS 17 10 00, 2400 y: below demand",
        ),
        (
            "ko",
            "자중: 안정 · 지진 KDS 17 10 00, 재현주기 2400년: 기준 불만족",
        ),
    ] {
        let answer = scratch.dolmen(&format!(
            "report examples/twisting_floor --samples 0 -o page.html --language {language}"
        ));
        assert_eq!(answer.status, 1, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
        let banner = page.split("<h2>").next().unwrap();
        assert!(
            banner.contains("verdict unstable") && banner.contains(said),
            "{banner}"
        );
    }
}

#[test]
fn holds_a_contradicted_load_factor_is_unknown_and_a_contradicted_stack_keeps_its_word() {
    let scratch = Scratch::with_examples("judged_survey");
    let pole = "schema = 1\nkind = \"chain\"\nname = { en = \"Pole\" }\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\n\
        links = [{ weight = 20, length = 3.0, centroid = 1.5, breadth = 0.5 }]\njoints = [{ stiffness = 100 }]\n";
    let surveyed = format!("{pole}[survey.2009]\nfrequencies = {{ x = [9.0] }}\n");
    fs::write(scratch.path().join("pole.toml"), surveyed).unwrap();
    let answer = scratch.dolmen("check pole.toml");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer
            .words()
            .contains("VERDICT Own weight: unknown (3.33 if this model were right; survey 2009"),
        "{}",
        answer.stdout
    );
    // the pagoda's published frequency is 16 % off that of the springs assumed
    let answer = scratch.dolmen("--json check examples/five_storey_pagoda");
    let json: Value = serde_json::from_str(&answer.stdout).unwrap();
    let version = &json["judgement"]["versions"][0];
    assert_eq!(version["weight"]["word"], "stable");
    assert_eq!(version["evidence"]["word"], "contradicted");
    assert_eq!(version["colour"], "amber");
}

#[test]
fn refuses_flags_of_another_kind_by_name() {
    let scratch = Scratch::with_examples("foreign_flags");
    let (pole, gate, stack, floor, tower) = (
        "examples/naju_flagpole",
        "examples/heunginjimun_gate",
        "examples/p10",
        "examples/twisting_floor",
        "examples/palisaden",
    );
    for (command, said) in [
        (
            format!("simulate {pole} --law rigid"),
            "--law is for stacks: this file has a chain",
        ),
        (
            format!("simulate {pole} --points 16"),
            "--points is for stacks: this file has a chain",
        ),
        (
            format!("simulate {pole} --to-the-end"),
            "--to-the-end is for stacks: this file has a chain",
        ),
        (
            format!("simulate {pole} --step 0.001"),
            "--step is for stacks and buildings: this file has a chain",
        ),
        (
            format!("simulate {gate} --step 0.001"),
            "--step is for stacks and buildings: this file has a frame",
        ),
        (
            format!("simulate {gate} --rotations large"),
            "--rotations is for chains: this file has a frame",
        ),
        (
            format!("simulate {gate} --push 1deg"),
            "--push lets a chain lean at the start: this file has a frame",
        ),
        (
            format!("simulate {stack} --direction x"),
            "--direction names a direction of a frame: this file has a stack",
        ),
        (
            format!("simulate {stack} --rotations small"),
            "--rotations is for chains: this file has a stack",
        ),
        (
            format!("simulate {floor} --law springs"),
            "--law is for stacks: this file has a building",
        ),
        (
            format!("check {stack} --samples 10"),
            "--samples draws the load factor of a chain, frame or building: this file has a stack",
        ),
        (
            format!("check {tower} --sensitivity"),
            "--sensitivity is for chains, frames, stacks and buildings: this file has a survey",
        ),
        (
            format!("report {stack} --samples 10 -o page.html"),
            "--samples draws the load factor of a chain, frame or building: this file has a stack",
        ),
        (
            format!("report {tower} --motion el-centro-1940-ns -o page.html"),
            "--motion is for chains, frames, stacks and buildings: this file has a survey",
        ),
    ] {
        let answer = scratch.dolmen(&command);
        assert_eq!(answer.status, 2, "{command}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{command}: {}", answer.stderr);
    }
    // with several projects, a flag applies to those that have it
    let answer = scratch.dolmen(&format!("report {tower} {floor} --samples 0 -o page.html"));
    assert_eq!(answer.status, 0, "{}", answer.stderr);
}

#[test]
fn holds_a_simulated_stack_that_a_survey_contradicts_is_not_decided() {
    let scratch = Scratch::new("contradicted_run");
    let stack = |hz: f64| {
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"Stones\"\ndensity = 2600\njoint = {{ friction = 0.6 }}\n\
             blocks = [{{ name = \"base\", width = 1.2, depth = 1.0, height = 0.5 }}, {{ name = \"cap\", width = 0.9, depth = 0.9, height = 0.3 }}]\n\
             [survey.2020-05-01]\nfrequencies.x = [{hz}]\n\
             [motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n"
        )
    };
    let word = |hz: f64, command: &str| {
        fs::write(scratch.path().join("stones.toml"), stack(hz)).unwrap();
        let answer = scratch.dolmen(&format!("--json {command}"));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let json: Value = serde_json::from_str(&answer.stdout).unwrap();
        json["judgement"]["versions"][0]["earthquake"].clone()
    };
    let run = "simulate stones.toml --motion ec --law springs";
    let modelled = {
        fs::write(scratch.path().join("stones.toml"), stack(1.0)).unwrap();
        let answer = scratch.dolmen("--json check stones.toml");
        let json: Value = serde_json::from_str(&answer.stdout).unwrap();
        json["judgement"]["versions"][0]["evidence"]["computed_hz"]
            .as_f64()
            .unwrap_or_else(|| panic!("{}", json["judgement"]))
    };
    let right = word(modelled, run);
    assert_eq!(right["word"], "above demand", "{right}");
    let contradicted = word(0.7 * modelled, run);
    assert_eq!(contradicted["word"], "not decided", "{contradicted}");
    assert_eq!(contradicted["reasons"][0]["decided_by"], "contradicted");
}
