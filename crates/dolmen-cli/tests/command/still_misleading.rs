// SOURCE     Runs and reports whose headline or silence was misleading about the file.
// GOAL       Each now describes the structure in the file, and what was not examined.

use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

fn written(scratch: &Scratch, name: &str, text: &str) {
    fs::write(scratch.path().join(name), text).unwrap();
}

fn json(scratch: &Scratch, words: &str) -> Value {
    let answer = scratch.dolmen(&format!("{words} --json"));
    serde_json::from_str(&answer.stdout).unwrap_or_else(|error| panic!("{words}: {error}: {}", answer.stderr))
}

const DAMPERS: &str = "schema = 1\nkind = \"building\"\nname = \"two dampers\"\nevidence = \"assumed\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"N/mm\" }\np_delta = false\n\
    floors = [{ name = \"roof\", mass = 100, sides = [10, 8], height = 30, stiffness = { centre = [0, 0], matrix = [[520800, 0, 0], [0, 364560, -182280], [0, -182280, 4982320]] } }]\n\
    damping = { ratio = 0.015 }\n\
    [damper.a]\nkind = \"tmd\"\nfloor = 1\nplace = [4, 1]\ndirection = \"y\"\nmass = 2.0\nfrequency = \"0.27 Hz\"\ndamping_ratio = 0.1\nstroke = \"400 mm\"\n\
    [damper.b]\nkind = \"tmd\"\nfloor = 1\nplace = [-4, -2]\ndirection = \"y\"\nmass = 1.5\nfrequency = \"0.36 Hz\"\ndamping_ratio = 0.08\nstroke = \"270 mm\"\n\
    [damper.c]\nkind = \"tmd\"\nfloor = 1\nplace = [0, 3]\ndirection = \"y\"\nmass = 1.0\nfrequency = \"0.31 Hz\"\ndamping_ratio = 0.05\n\
    [motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\nturn = \"90 deg\"\npeak = \"0.1 g\"\n[limits]\nstorey_drift = \"1/50\"\nsource = \"a\"\n";

#[test]
fn agrees_the_headline_of_a_report_with_the_run_of_all_dampers() {
    let scratch = Scratch::new("all-dampers");
    written(&scratch, "room.toml", DAMPERS);
    let run = scratch.briefly("simulate room.toml --motion ec");
    let report = scratch.briefly("report room.toml -o r.html --quiet");
    assert_eq!((run.status, report.status), (0, 0), "{}", run.words());
    assert!(
        run.words().contains("near demand (room/stroke of b 1.02)"),
        "{}",
        run.words()
    );
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    assert!(
        page.contains("near demand (room/stroke of b 1.02)")
            && !page.contains("below demand (room/stroke of b 0.961)"),
        "{page}"
    );
}

#[test]
fn holds_a_report_judges_the_motions_of_a_file_with_dampers_by_drift_as_well() {
    let scratch = Scratch::new("dampers-drift");
    let roomy = DAMPERS
        .replace("\"400 mm\"", "\"4 m\"")
        .replace("\"270 mm\"", "\"4 m\"");
    let (without, _) = roomy.split_once("[limits]").unwrap();
    let strict = roomy.replace("1/50", "1/2000");
    for (text, status, word) in [
        (without, 0, "Earthquake ec: not decided (no limit is known)"),
        (
            strict.as_str(),
            1,
            "Earthquake ec: below demand (capacity/demand 0.",
        ),
    ] {
        written(&scratch, "d.toml", text);
        let run = scratch.briefly("simulate d.toml --motion ec");
        let report = scratch.briefly("report d.toml -o r.html --quiet");
        assert_eq!((run.status, report.status), (status, status), "{}", run.words());
        assert!(run.words().contains(word), "{}", run.words());
        let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
        assert!(page.contains(word) && !page.contains("above demand ("), "{word}");
        // the numbers behind it
        assert!(
            page.contains("Under motion ec,") && page.contains("(room 4000"),
            "{word}"
        );
    }
}

#[test]
fn holds_the_head_of_a_report_and_its_answers_say_which_variant_is_red() {
    let scratch = Scratch::with_examples("red-variant");
    let report = scratch.briefly("report examples/arch -o r.html --quiet");
    assert_eq!(report.status, 1, "{}", report.words());
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    let head = page.split("class=\"answers\"").next().unwrap();
    let head = head.split("class=\"verdict unstable\"").nth(1).unwrap_or(head);
    for said in [
        "As given: Own weight: stable",
        "Variant “Ring of 0.15 m”: Own weight: unstable",
    ] {
        assert!(head.contains(said), "{said}: {head}");
    }
    let cards = page.split("class=\"answers\"").nth(1).unwrap();
    let card = "as given: stable; variant “Ring of 0.15 m”: unstable";
    assert!(cards.contains(card), "{}", &cards[..1000.min(cards.len())]);
}

#[test]
fn exact_the_line_of_elastic_joints_is_the_capacity_of_their_first_joint_over_its_ratio() {
    let scratch = Scratch::with_examples("line-of-elastic-joints");
    let file = "examples/three_storey_pagoda/at_its_site.toml";
    let report = scratch.briefly(&format!("report {file} -o r.html --quiet"));
    assert!(report.status < 2, "{}", report.words());
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    // what stands on the dew basin slides at 0.600 g, and first at 0.372 of the spectrum
    let line = "on elastic joints, the first joint to move: 1.61";
    assert!(page.contains(line), "no {line}");
}

const LEANING: &str = "schema = 1\nkind = \"frame\"\nname = \"n1\"\nunits = { length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\n\
    storeys = [{ name = \"low\", mass = 40, height = 4.0 }, { name = \"mid\", mass = 25, height = 3.1 }]\n\
    [direction.strong]\nalong = \"x\"\nstiffness = [3.0, 2.5]\ndamping_ratio = 0.03\n[direction.weak]\nstiffness = \"unknown\"\nalong = \"y\"\n\
    [limits]\nstorey_drift = \"1/60\"\nsource = \"a\"\n[motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n\
    [survey.2026-05-01]\ntilt = { strong = \"1/200\", y = \"1/14\" }\n";

#[test]
fn holds_a_run_of_a_frame_that_leans_beyond_its_limit_is_red() {
    let scratch = Scratch::new("leans-beyond");
    written(&scratch, "n1.toml", LEANING);
    let checked = scratch.briefly("check n1.toml");
    let run = scratch.briefly("simulate n1.toml --motion ec");
    assert_eq!((checked.status, run.status), (1, 1), "{}", run.words());
    assert!(
        run.words().contains("Tilt: beyond its limit") && run.words().contains("✕"),
        "{}",
        run.words()
    );
    written(&scratch, "n2.toml", &LEANING.replace("1/14", "1/140"));
    assert_eq!(scratch.briefly("simulate n2.toml --motion ec").status, 0);
}

#[test]
fn holds_a_chain_names_its_surveyed_tilt_in_check_as_in_simulate() {
    let scratch = Scratch::new("chain-tilt-named");
    let chain = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\n\
        links = [{ name = \"shaft\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\njoints = [{ stiffness = 600 }]\n\
        damping_ratio = 0.02\n[motion.ec]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.02 g\"\n[survey.2026-05-01]\ntilt = { x = \"1/120\" }\n";
    written(&scratch, "c.toml", chain);
    for words in ["check c.toml", "simulate c.toml --motion ec"] {
        let said = scratch.briefly(words).words();
        assert!(
            said.contains("leaning as surveyed (2026-05-01: x 1/120)"),
            "{words}: {said}"
        );
    }
}

#[test]
fn holds_two_tilts_that_differ_are_a_finding() {
    let scratch = Scratch::new("two-tilts");
    let tower = |own: &str| {
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = {{ friction = 0.7 }}\nblocks = [\n  {{ name = \"base\", width = 1.2, height = 0.4, tilt = {{ x = \"{own}\" }} }},\n  \
             {{ name = \"body\", width = 0.7, height = 1.3, tilt = {{ x = \"{own}\" }} }},\n  {{ name = \"top\", width = 0.5, height = 0.6, tilt = {{ x = \"{own}\" }} }},\n]\n[survey.2026-05-01]\ntilt = {{ x = \"1/15\" }}\n"
        )
    };
    written(&scratch, "apart.toml", &tower("1/100"));
    written(&scratch, "alike.toml", &tower("1/16"));
    let (apart, alike) = (
        scratch.briefly("check apart.toml").words(),
        scratch.briefly("check alike.toml").words(),
    );
    assert!(
        apart.contains("measured a tilt of x 1/15, but the blocks as the file places them lean by x 1/100"),
        "{apart}"
    );
    assert!(!alike.contains("measured a tilt of"), "{alike}");
}

#[test]
fn holds_a_check_names_a_motion_that_cannot_be_read() {
    let scratch = Scratch::new("motion-gone");
    let stack = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = { friction = 0.7 }\nblocks = [{ name = \"base\", width = 1.2, height = 0.4 }]\n\
        [motion.here]\nbuilt_in = \"el-centro-1940-ns\"\n[motion.gone]\nfiles = { x = \"gone.at2\" }\n";
    written(&scratch, "p.toml", stack);
    let answer = scratch.briefly("check p.toml");
    assert_eq!(answer.status, 0);
    assert!(
        answer
            .words()
            .contains("Motion gone of the file cannot be simulated"),
        "{}",
        answer.words()
    );
    assert!(!answer.words().contains("Motion here"), "{}", answer.words());
    let found = json(&scratch, "check p.toml");
    assert_eq!(found["unreadable_motions"][0]["motion"], "gone");
    let korean = scratch.briefly("check p.toml --language ko").words();
    assert!(korean.contains("파일의 지반운동 gone"), "{korean}");
}

#[test]
fn refuses_a_wrong_unit_of_length_once() {
    let scratch = Scratch::new("wrong-length");
    let stack = |unit: &str, factor: f64| {
        let block = |name: &str, width: f64, height: f64| {
            format!(
                "  {{ name = \"{name}\", width = {}, height = {} }},\n",
                width * factor,
                height * factor
            )
        };
        let blocks = block("base", 1.2, 0.4) + &block("shaft", 0.4, 1.6) + &block("cap", 0.8, 0.3);
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"pillar\"\ndensity = 2500\nunits = {{ {unit} }}\nblocks = [\n{blocks}]\n"
        )
    };
    let chain = "schema = 1\nkind = \"chain\"\nname = \"pole\"\nunits = { length = \"mm\", force = \"kN\" }\nlinks = [\n  { weight = 38, length = 3.68, centroid = 1.64 },\n  \
        { weight = 15, length = 2.61, centroid = 1.18 },\n  { weight = 6, length = 1.63, centroid = 0.78 },\n]\njoints = \"unknown\"\n";
    for (name, text, meant) in [
        ("mm.toml", stack("length = \"mm\"", 1.0), "m"),
        ("m.toml", stack("length = \"m\"", 1000.0), "mm"),
        ("none.toml", stack("force = \"kN\"", 1000.0), "mm"),
        ("chain.toml", chain.to_owned(), "m"),
    ] {
        written(&scratch, name, &text);
        let answer = scratch.briefly(&format!("check {name}"));
        assert_eq!(answer.status, 2);
        assert_eq!(
            answer.stderr.matches("error:").count(),
            1,
            "{name}: {}",
            answer.stderr
        );
        assert!(
            answer
                .stderr
                .contains(&format!("did you mean units = {{ length = \"{meant}\" }}?")),
            "{}",
            answer.stderr
        );
    }
    // one stone is one slip
    written(
        &scratch,
        "one.toml",
        &stack("length = \"m\"", 1.0).replace("width = 0.8", "width = 800"),
    );
    let one = scratch.briefly("check one.toml");
    assert!(one.stderr.contains("blocks[3].width"), "{}", one.stderr);
}

#[test]
fn holds_pages_name_inputs_by_what_they_are() {
    let scratch = Scratch::with_examples("pages-without-paths");
    scratch.briefly("report examples/naju_flagpole -o r.html --quiet");
    let page = fs::read_to_string(scratch.path().join("r.html")).unwrap();
    for path in [
        "links[1].weight",
        "(links, line",
        ", line 12)",
        "frequencies.x[1]",
    ] {
        assert!(!page.contains(path), "{path}");
    }
    assert!(page.contains("Warnings on reading the file"));
}

#[test]
fn holds_variants_stand_beside_each_other_with_what_the_site_asks() {
    let scratch = Scratch::new("variants-earthquake");
    // stiffer at the base: a larger load factor, and a larger spectral demand
    let frame = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"kN/mm\" }\nstoreys = [{ mass = 40, height = 4.0 }, { mass = 25, height = 3.1 }]\n\
        [direction.x]\nstiffness = [6.0, 1.2]\ndamping_ratio = 0.03\n[limits]\nstorey_drift = \"1/60\"\nsource = \"a\"\n[site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 1000\nsoil = \"S3\"\n\
        [variant.braced]\ntitle = \"Braced below\"\n[variant.braced.direction.x]\nstiffness = [9.0, 1.2]\ndamping_ratio = 0.03\n";
    written(&scratch, "f.toml", frame);
    let said = scratch.dolmen("check f.toml").words();
    assert!(said.contains("capacity/demand"), "{said}");
    let found = json(&scratch, "check f.toml");
    let ratio = |at: usize| {
        let reasons = &found["judgement"]["versions"][at]["earthquake"]["reasons"];
        let all = reasons
            .as_array()
            .unwrap()
            .iter()
            .filter_map(|of| of["ratio"].as_f64());
        all.fold(f64::INFINITY, f64::min)
    };
    let factor = |state: &Value| {
        state
            .pointer("/check/frame/0/check/stability/load_factor")
            .and_then(Value::as_f64)
            .unwrap()
    };
    let (from, to) = (factor(&found["state"]), factor(&found["variants"][0]["state"]));
    let is_worse = to > from && ratio(1) < ratio(0);
    assert_eq!(
        said.contains("is better under weight"),
        is_worse,
        "{from} {to} {} {}: {said}",
        ratio(0),
        ratio(1)
    );
}

#[test]
fn agrees_a_report_that_found_the_modes_does_not_say_that_they_were_not_sought() {
    let scratch = Scratch::with_examples("modes-found");
    let report = scratch.dolmen("report examples/gate_columns -o r.html --quiet");
    let page = fs::read_to_string(scratch.path().join("r.html"))
        .unwrap_or_else(|error| panic!("{error}: {}", report.stderr));
    let said = "not compared with survey 2026-05-20: the model has no frequency, its stiffness is not given";
    assert!(page.contains(said) && !page.contains("modes were not sought"));
}
