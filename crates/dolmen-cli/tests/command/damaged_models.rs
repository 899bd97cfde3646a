// SOURCE     docs/damage.md; by hand: a block of width b with its centre h above its bed begins to rock at g b / 2 h; with a share s of its bed
//            lost at one side, at g (b / 2 − s b) / h towards that side. For chains and frames: project files with the damage written into the numbers.
// GOAL       Inspections change the model: check and simulate judge the structure as last inspected, and the headline says so.
// TOLERANCE  1e-8 of the closed forms, as the limit solver allows; otherwise none: the two files give the same answers.

use super::stores::json;
use super::verbs::Scratch;
use serde_json::Value;
use std::fs;

const BLOCK: &str = "schema = 1\nkind = \"stack\"\nname = \"pier\"\nunits = { length = \"m\" }\ndensity = 2600\njoint = { friction = 0.9 }\n";
const ONE: &str = "blocks = [{ name = \"stone\", width = 1.0, depth = 1.2, height = 2.0 }]\n";

fn write(scratch: &Scratch, file: &str, text: &str) {
    fs::write(scratch.path().join(file), text).unwrap();
}

fn inspection(date: &str, part: &str, model: &str) -> String {
    format!(
        "[survey.{date}]\ninspections = [{{ part = \"{part}\", what = \"loss\", model = {{ {model} }} }}]\n"
    )
}

fn capacity(scratch: &Scratch, text: &str) -> (f64, [f64; 2]) {
    write(scratch, "pier.toml", text);
    let found = json(scratch, "check pier.toml");
    let of = found.pointer("/state/check/stack/capacity").unwrap();
    let at = |axis: usize| of["direction"][axis].as_f64().unwrap();
    (of["acceleration_g"].as_f64().unwrap(), [at(0), at(1)])
}

#[test]
fn exact_a_bed_that_lost_a_fifth_at_one_side_tips_about_a_fifth_of_its_width_further_in() {
    let scratch = Scratch::new("damaged-bed");
    let (whole, _) = capacity(&scratch, &format!("{BLOCK}{ONE}"));
    assert!((whole - 0.5).abs() < 1e-8, "{whole}");
    for (side, share, towards, expected) in [
        ("x+", 0.2, [1.0, 0.0], 0.3),
        ("x-", 0.2, [-1.0, 0.0], 0.3),
        // 0.6 − 0.3 · 1.2, over 1
        ("y-", 0.3, [0.0, -1.0], 0.24),
    ] {
        let lost = inspection(
            "2026-05-12",
            "stone",
            &format!("bed_lost = {share}, side = \"{side}\""),
        );
        let (least, direction) = capacity(&scratch, &format!("{BLOCK}{ONE}{lost}"));
        assert!((least - expected).abs() < 1e-8, "{side}: {least}");
        let along = direction[0] * towards[0] + direction[1] * towards[1];
        assert!(along > 0.999, "{side}: {direction:?}");
    }
    // at least half of its bed: its weight is outside the remaining bed
    let lost = inspection("2026-05-12", "stone", "bed_lost = 0.55, side = \"x+\"");
    write(&scratch, "pier.toml", &format!("{BLOCK}{ONE}{lost}"));
    let answer = scratch.briefly("check pier.toml");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(answer.words().contains("unstable"), "{}", answer.stdout);
}

#[test]
fn holds_a_run_rocks_about_what_is_left_of_the_bed_by_both_laws() {
    let scratch = Scratch::new("damaged-run");
    // 0.4 g for a second: above g (b/2 − s b)/h = 0.3 g, below 0.5 g
    let push_by = |g: &str| -> String {
        (0..600)
            .map(|i| if (100..300).contains(&i) { g } else { "0\n" })
            .collect()
    };
    write(&scratch, "right.csv", &push_by("-0.4\n"));
    write(&scratch, "left.csv", &push_by("0.4\n"));
    let push = |side: &str| {
        format!("[motion.{side}]\nfiles = {{ x = \"{side}.csv\" }}\nunit = \"g\"\nsample_step_s = 0.005\n")
    };
    let lost = inspection("2026-05-12", "stone", "bed_lost = 0.2, side = \"x+\"");
    let both = push("right") + &push("left");
    let whole = format!("{BLOCK}{ONE}{both}");
    // the ground moves left: the stone is pushed to the right, where its bed is lost
    for (text, side, falls) in [
        (&whole, "right", false),
        (&(whole.clone() + &lost), "right", true),
        (&(whole.clone() + &lost), "left", false),
    ] {
        write(&scratch, "pier.toml", text);
        for law in ["springs", "rigid"] {
            let found = json(
                &scratch,
                &format!("simulate pier.toml --motion {side} --law {law}"),
            );
            let fell = found["outcome"]["kind"] == "fell";
            assert_eq!(fell, falls, "{side} {law}: {}", found["outcome"]);
        }
    }
}

#[test]
fn exact_a_block_on_a_loosened_bed_sways_by_the_root_of_what_is_left() {
    let scratch = Scratch::new("damaged-stiffness");
    // u and θ of the centroid, h above a bed of area A and second moment I: [K_s A, −K_s A h; −K_s A h, K_s A h² + K_n I], m and m (b² + H²)/12
    let (shear, rocking, h) = (4e8 * 1.2, 1e9 * 1.2 / 12.0, 1.0_f64);
    let (mass, inertia) = (2600.0 * 2.4, 2600.0 * 2.4 * (1.0 + 4.0) / 12.0);
    let (a, b) = (shear / mass, (shear * h * h + rocking) / inertia);
    let coupled = (shear * h).powi(2) / (mass * inertia);
    let square = 0.5 * (a + b - ((a - b).powi(2) + 4.0 * coupled).sqrt());
    let whole_hz = square.sqrt() / std::f64::consts::TAU;
    let sways_hz = |scratch: &Scratch, text: &str| {
        write(scratch, "pier.toml", text);
        let found = json(scratch, "check pier.toml");
        let first = found.pointer("/state/check/stack/frequencies/sway_x_hz").unwrap();
        first.as_f64().unwrap()
    };
    let motion = "[motion.rest]\nfiles = { x = \"rest.csv\" }\nunit = \"g\"\nsample_step_s = 0.01\n";
    write(&scratch, "rest.csv", &"0.01\n0\n".repeat(50));
    let whole = format!("{BLOCK}{ONE}{motion}");
    let loose = whole.clone() + &inspection("2026-05-12", "stone", "stiffness_left = 0.25");
    assert!((sways_hz(&scratch, &whole) / whole_hz - 1.0).abs() < 1e-6);
    assert!((sways_hz(&scratch, &loose) / (0.5 * whole_hz) - 1.0).abs() < 1e-6);
    // springs include the loss; rigid joints have none, and the answer says so
    let run = |law: &str| scratch.briefly(&format!("simulate pier.toml --motion rest --law {law}"));
    let unseen = "Rigid joints have no stiffness";
    assert!(!run("springs").words().contains(unseen));
    let rigid = run("rigid").words();
    assert!(rigid.contains(unseen) && rigid.contains("below stone"), "{rigid}");
    let korean = scratch.briefly("simulate pier.toml --motion rest --law rigid --language ko");
    assert!(
        korean
            .words()
            .contains("강성 저하는 이 해석 결과에 나타나지 않는다"),
        "{}",
        korean.stdout
    );
    // its stiffness was identified after the inspection, so it includes the loss
    let identified =
        "normal_stiffness = { value = \"8e8 Pa/m\", source = \"identified\", survey = \"2026-05-20\" }";
    let found = BLOCK.replace("friction = 0.9", &format!("friction = 0.9, {identified}"))
        + ONE
        + &inspection("2026-05-12", "stone", "stiffness_left = 0.25")
        + "[survey.2026-05-20]\nfrequencies.x = [3.0]\n";
    write(&scratch, "pier.toml", &found);
    let answer = scratch.briefly("check pier.toml");
    assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer.stderr.contains("identified from survey 2026-05-20"),
        "{}",
        answer.stderr
    );
}

const PIERS: &str = "blocks = [{ name = \"low\", width = 1.0, height = 0.6 }, { name = \"high\", width = 0.8, height = 0.6 }, { name = \"cap\", width = 0.9, height = 0.2 }]\n";
const TIES: &str = "ties = [{ lower = \"low\", upper = \"high\", position = [0, 0, 0.6], shear_stiffness = \"20 kN/mm\", shear_strength = \"15 kN\" }]\n";

fn state(scratch: &Scratch, text: &str) -> Value {
    write(scratch, "pole.toml", text);
    json(scratch, "check pole.toml")["state"]["check"].clone()
}

#[test]
fn agrees_broken_ties_and_a_lost_stone_are_as_if_they_were_not_written() {
    let scratch = Scratch::new("damaged-stack");
    let broken = inspection("2026-05-12", "high", "ties_broken = true");
    assert_eq!(
        state(&scratch, &format!("{BLOCK}{PIERS}{TIES}{broken}")),
        state(&scratch, &format!("{BLOCK}{PIERS}"))
    );
    let (without, _) = PIERS.split_once(", { name = \"cap\"").unwrap();
    let gone = inspection("2026-05-12", "cap", "lost = true");
    assert_eq!(
        state(&scratch, &format!("{BLOCK}{PIERS}{TIES}{gone}")),
        state(&scratch, &format!("{BLOCK}{without}]\n{TIES}"))
    );
}

const CHAIN: &str = "schema = 1\nkind = \"chain\"\nname = \"pole\"\nunits = { length = \"m\", force = \"kN\", stiffness = \"kN*m/rad\" }\ncap = \"included\"\n";

fn chain(bed: &str, stiffness: &str) -> String {
    format!(
        "{CHAIN}links = [{{ name = \"low\", weight = 40, length = 3.5, centroid = 1.7, bed_width = 0.6 }}, {{ name = \"top\", weight = 18, length = 2.8, centroid = 1.3, bed_width = {bed} }}]\n\
         joints = [{{ stiffness = 3000 }}, {{ stiffness = {stiffness} }}]\n"
    )
}

/// Appends the numbers of an answer, whatever its format.
fn numbers(value: &Value, all: &mut Vec<f64>) {
    match value {
        Value::Number(number) => all.push(number.as_f64().unwrap()),
        Value::Array(items) => items.iter().for_each(|item| numbers(item, all)),
        Value::Object(fields) => fields.values().for_each(|field| numbers(field, all)),
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

fn same_numbers(scratch: &Scratch, damaged: &str, by_hand: &str) {
    let (mut own, mut other) = (Vec::new(), Vec::new());
    numbers(&state(scratch, damaged), &mut own);
    numbers(&state(scratch, by_hand), &mut other);
    assert_eq!(own.len(), other.len());
    for (a, b) in own.iter().zip(&other) {
        assert!((a - b).abs() <= 1e-9 * a.abs().max(b.abs()), "{a} {b}");
    }
    assert!(!own.is_empty());
}

#[test]
fn agrees_a_damaged_chain_and_frame_are_those_written_so_by_hand() {
    let scratch = Scratch::new("damaged-chain");
    let loose = inspection("2026-05-12", "top", "stiffness_left = 0.75");
    same_numbers(&scratch, &(chain("0.5", "900") + &loose), &chain("0.5", "675"));
    // the pivot moves by 0.2 b: 0.5 · (1 − 0.4); the stiffness changes with the third power, 900 · 0.8³
    let less = inspection("2026-05-12", "top", "bed_lost = 0.2");
    same_numbers(&scratch, &(chain("0.5", "900") + &less), &chain("0.3", "460.8"));
    let frame = |hall: &str| {
        format!(
            "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = {{ mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }}\n\
             storeys = [{{ name = \"hall\", mass = 60, height = 5 }}, {{ name = \"loft\", mass = 40, height = 4 }}]\n\
             direction.x = {{ stiffness = [{hall}, 5], damping_ratio = 0.02 }}\n"
        )
    };
    let broken = inspection("2026-05-12", "hall", "stiffness_left = 0.5");
    same_numbers(&scratch, &(frame("8") + &broken), &frame("4"));
}

#[test]
fn agrees_every_stiffness_of_a_damaged_storey_is_reduced() {
    let scratch = Scratch::new("damaged-storey");
    let frame = |columns: &str, direction: &str| {
        format!(
            "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = {{ mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }}\n\
             storeys = [{{ name = \"hall\", mass = 60, height = 5{columns} }}]\n[direction.x]\ndamping_ratio = 0.02\n{direction}"
        )
    };
    let broken = inspection("2026-05-12", "hall", "stiffness_left = 0.5");
    let slips = |stuck: &str, slipping: &str| {
        let friction = format!("law = \"jenkins\"\ncoefficient = 0.03\nslipping_stiffness = [{slipping}]\n");
        frame(
            "",
            &format!("stiffness = [{stuck}]\n[direction.x.friction]\n{friction}"),
        )
    };
    same_numbers(&scratch, &(slips("8", "5") + &broken), &slips("4", "2.5"));
    let tenons = |own: &str, tenons: &str| {
        let loose = format!("slack = [\"4 mm/m\"]\nstiffness = [{tenons}]\n");
        frame("", &format!("stiffness = [{own}]\n[direction.x.tenons]\n{loose}"))
    };
    same_numbers(&scratch, &(tenons("8", "6") + &broken), &tenons("4", "3"));
    // on its columns alone: their beds
    let columns = |bed: &str| {
        let feet = format!(", columns = {{ count = 4, diameter = 0.5, bed_stiffness = \"{bed} GPa/m\" }}");
        frame(&feet, "stiffness = [0]\n")
    };
    same_numbers(&scratch, &(columns("0.8") + &broken), &columns("0.4"));
    write(
        &scratch,
        "pier.toml",
        &(frame(", columns = { count = 4, diameter = 0.5 }", "stiffness = [0]\n") + &broken),
    );
    let refused = scratch.briefly("check pier.toml");
    assert_ne!(refused.status, 0);
}

#[test]
fn agrees_a_bed_lost_at_one_side_loses_less_stiffness_across_it() {
    let scratch = Scratch::new("damaged-two-axes");
    let pole = |bed: &str, joint: &str| {
        format!(
            "{CHAIN}links = [{{ name = \"low\", weight = 40, length = 3.5, centroid = 1.7, bed_width = 0.6 }}, {{ name = \"top\", weight = 18, length = 2.8, centroid = 1.3, bed_width = {bed} }}]\n\
             joints = [{{ stiffness = 3000, stiffness_across = 3600, bed_depth = 0.8 }}, {{ {joint} }}]\n"
        )
    };
    let whole = pole("0.5", "stiffness = 900, stiffness_across = 600, bed_depth = 0.4");
    // equal springs: k ∝ b³ along the side, ∝ b across it; 0.9³ = 0.729
    for (side, bed, joint) in [
        (
            "y+",
            "0.5",
            "stiffness = 810, stiffness_across = 437.4, bed_depth = 0.32",
        ),
        (
            "x-",
            "0.4",
            "stiffness = 656.1, stiffness_across = 540, bed_depth = 0.4",
        ),
    ] {
        let lost = inspection("2026-05-12", "top", &format!("bed_lost = 0.1, side = \"{side}\""));
        same_numbers(&scratch, &(whole.clone() + &lost), &pole(bed, joint));
    }
    // without a side it may be either
    let lost = inspection("2026-05-12", "top", "bed_lost = 0.1");
    let by_hand = pole(
        "0.4",
        "stiffness = 656.1, stiffness_across = 437.4, bed_depth = 0.32",
    );
    same_numbers(&scratch, &(whole + &lost), &by_hand);
    // left to the sides of the bed: 900 (0.4 / 0.5)² across, before the loss
    let ratio = pole("0.5", "stiffness = 900, bed_depth = 0.4");
    let lost = inspection("2026-05-12", "top", "bed_lost = 0.1, side = \"x+\"");
    let by_hand = pole(
        "0.4",
        "stiffness = 656.1, stiffness_across = 518.4, bed_depth = 0.4",
    );
    same_numbers(&scratch, &(ratio + &lost), &by_hand);
}

#[test]
fn holds_the_headline_says_which_damage_and_the_last_word_of_inspections_counts() {
    let scratch = Scratch::new("damaged-headline");
    let found = inspection("2024-05-12", "top", "stiffness_left = 0.75");
    let other = "[survey.2025-05-12]\ninspections = [{ part = \"low\", what = \"crack\" }]\n";
    write(&scratch, "pole.toml", &(chain("0.5", "900") + &found + other));
    let words = scratch.briefly("check pole.toml").words();
    assert!(
        words.contains("with the damage of inspections: “top” with 75 % of its stiffness (2024-05-12)"),
        "{words}"
    );
    let korean = scratch.briefly("check pole.toml --language ko").words();
    assert!(korean.contains("점검에서 확인된 손상 반영"), "{korean}");
    let judged = json(&scratch, "check pole.toml");
    assert_eq!(judged.pointer("/project/damage/0/stiffness_left").unwrap(), 0.75);
    // more damage in a later inspection, then a repair
    let worse = inspection("2025-06-01", "top", "stiffness_left = 0.5");
    same_numbers(
        &scratch,
        &(chain("0.5", "900") + &found + other + &worse),
        &chain("0.5", "450"),
    );
    let mended = inspection("2026-06-01", "top", "mended = true");
    same_numbers(
        &scratch,
        &(chain("0.5", "900") + &found + &worse + &mended),
        &chain("0.5", "900"),
    );
    // as built, and as found by one inspection
    let tables = found.clone() + &worse;
    let as_built = chain("0.5", "900").replace("cap = ", "as_inspected = \"none\"\ncap = ") + &tables;
    same_numbers(&scratch, &as_built, &chain("0.5", "900"));
    let at = chain("0.5", "900").replace("cap = ", "as_inspected = \"2024-05-12\"\ncap = ") + &tables;
    same_numbers(&scratch, &at, &chain("0.5", "675"));
    // for comparison: a variant without the damage
    let beside = chain("0.5", "900") + &tables + "[variant.built]\nas_inspected = \"none\"\n";
    write(&scratch, "pole.toml", &beside);
    let both = json(&scratch, "check pole.toml");
    let factor = |path: &str| {
        let of = both.pointer(path).unwrap();
        of["check"]["chain"]["modes"][0]["frequency_hz"].as_f64().unwrap()
    };
    assert!(
        factor("/state") < 0.95 * factor("/variants/0/state"),
        "{} {}",
        factor("/state"),
        factor("/variants/0/state")
    );
}

#[test]
fn agrees_a_study_has_the_damage_and_says_so() {
    let scratch = Scratch::new("damaged-study");
    let study = "[study.s]\nmotions = [\"el-centro-1940-ns\"]\npeak = { from = \"0.1 g\", to = \"0.2 g\", steps = 2 }\n";
    let loose = inspection("2026-05-12", "top", "stiffness_left = 0.75");
    let runs = |folder: &str, text: &str| {
        write(&scratch, "pole.toml", text);
        let answer = scratch.briefly(&format!("study pole.toml -o {folder}"));
        let table = fs::read_to_string(scratch.path().join(folder).join("s/runs.csv")).unwrap();
        (answer.words(), table)
    };
    let (said, damaged) = runs("damaged", &(chain("0.5", "900") + study + &loose));
    let (_, by_hand) = runs("by-hand", &(chain("0.5", "675") + study));
    let (_, whole) = runs("whole", &(chain("0.5", "900") + study));
    assert_eq!(damaged, by_hand);
    assert_ne!(damaged, whole);
    assert!(
        said.contains("“top” with 75 % of its stiffness (2026-05-12)"),
        "{said}"
    );
    write(&scratch, "pole.toml", &(chain("0.5", "900") + study + &loose));
    let found = json(&scratch, "study pole.toml");
    assert_eq!(
        found.pointer("/damage_in_model/0/stiffness_left").unwrap(),
        0.75,
        "{found}"
    );
    let page = scratch.briefly("report pole.toml -o page.html");
    assert_eq!(page.status, 0, "{}{}", page.stdout, page.stderr);
    let page = fs::read_to_string(scratch.path().join("page.html")).unwrap();
    let page = page.replace('\u{202f}', " ");
    let each = page.matches("“top” with 75 % of its stiffness (2026-05-12)");
    // in the headline, and in the section of the study
    assert!(each.count() >= 2, "{page}");
    assert!(page.contains("The model has the damage of inspections"), "{page}");
}

#[test]
fn refuses_damage_that_the_model_cannot_have_with_the_reason() {
    let scratch = Scratch::new("damaged-refused");
    let survey = |date: &str, model: &str| inspection(date, "top", model);
    let pole = chain("0.5", "900");
    let identified = chain(
        "0.5",
        "{ value = 900, source = \"identified\", survey = \"2026-05-20\" }",
    ) + "[survey.2026-05-20]\nfrequencies.x = [0.9]\n";
    for (text, why, korean) in [
        (
            pole.clone() + &survey("2026-05-12", "ties_broken = true"),
            "a chain takes bed_lost and stiffness_left",
            "bed_lost와 stiffness_left만",
        ),
        (
            pole.clone() + &survey("2026-05-12", "bed_lost = 0.5"),
            "stands beside what is left",
            "남은 접합면을 벗어난다",
        ),
        (
            pole.clone() + &survey("2026-05-12", "bed_lost = 0.2, side = \"y+\""),
            "moves in one direction",
            "한 방향으로",
        ),
        (
            pole.clone() + &survey("2026-05-12", "bed_lost = 1.5"),
            "0.95",
            "0.95",
        ),
        (
            pole.clone() + &survey("2026-05-12", "stiffness_left = 0.5, lost = true"),
            "must give one",
            "하나만",
        ),
        (
            pole.clone() + &survey("spring", "stiffness_left = 0.5"),
            "begins with no date",
            "날짜로 시작하지",
        ),
        (
            identified + &survey("2026-05-12", "stiffness_left = 0.5"),
            "the damage is in it already",
            "이미 반영되어",
        ),
        (
            format!("as_inspected = \"2020\"\n{pole}") + &survey("2026-05-12", "stiffness_left = 0.5"),
            "no inspection has this name",
            "점검 중에 이 이름이 없다",
        ),
        (
            format!("{BLOCK}{PIERS}") + &inspection("2026-05-12", "low", "lost = true"),
            "\"high\" stands on it alone",
            "이 부재 위에만",
        ),
        (
            format!("{BLOCK}{PIERS}") + &inspection("2026-05-12", "high", "bed_lost = 0.2"),
            "give side = \"x+\"",
            "하나를 준다",
        ),
        (
            format!("{BLOCK}{PIERS}") + &inspection("2026-05-12", "high", "ties_broken = true"),
            "no dowel or clamp",
            "은장이나 촉이 없다",
        ),
    ] {
        write(&scratch, "pole.toml", &text);
        for (language, why) in [("en", why), ("ko", korean)] {
            let answer = scratch.briefly(&format!("check pole.toml --language {language}"));
            assert_eq!(answer.status, 2, "{why}: {}{}", answer.stdout, answer.stderr);
            let said = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(said.contains(why), "{why}: {said}");
        }
    }
}

#[test]
fn refuses_two_damages_that_only_a_name_tells_apart() {
    let scratch = Scratch::new("damaged-twice");
    let stones = "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = { friction = 0.6 }\nblocks = [{ name = \"b\", width = 1.0, height = 0.5 }, { name = \"p\", width = 0.4, height = 2.2 }]\n";
    let loss = |name: &str, lost: &str, side: &str| {
        format!(
            "{{ part = \"p\", what = \"spalling\", {name}model = {{ bed_lost = {lost}, side = \"{side}\" }} }}"
        )
    };
    let survey =
        |day: &str, items: &[String]| format!("[survey.{day}]\ninspections = [{}]\n", items.join(", "));
    let in_one = survey("2024-05-01", &[loss("", "0.45", "x-"), loss("", "0.2", "x+")]);
    let in_two =
        survey("2023-05-01", &[loss("", "0.45", "x-")]) + &survey("2024-05-01", &[loss("", "0.2", "x+")]);
    for tables in [&in_one, &in_two] {
        write(&scratch, "project.toml", &(stones.to_owned() + tables));
        let answer = scratch.dolmen("check .");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(
            answer.stderr.contains("give each its own name"),
            "{}",
            answer.stderr
        );
    }
    // named, both count: (0.2 - 0.45 0.4) / 1.1 towards x- is what is left
    let named = survey(
        "2024-05-01",
        &[
            loss("name = \"a\", ", "0.45", "x-"),
            loss("name = \"b\", ", "0.2", "x+"),
        ],
    );
    write(&scratch, "project.toml", &(stones.to_owned() + &named));
    let checked = scratch.briefly("check .").words();
    assert!(checked.contains("begins to move at 0.018"), "{checked}");
    // the same damage, grown
    let grown =
        survey("2023-05-01", &[loss("", "0.2", "x-")]) + &survey("2024-05-01", &[loss("", "0.45", "x-")]);
    write(&scratch, "project.toml", &(stones.to_owned() + &grown));
    let checked = scratch.briefly("check .").words();
    assert!(checked.contains("begins to move at 0.018"), "{checked}");
}

#[test]
fn holds_damage_of_a_later_inspection_stands_in_the_headline() {
    let scratch = Scratch::new("damaged-later");
    let early = inspection("2024-05-12", "top", "stiffness_left = 0.75");
    let late = inspection("2026-05-12", "top", "stiffness_left = 0.5");
    let base = chain("0.5", "900").replace("cap = ", "as_inspected = \"2024-05-12\"\ncap = ");
    write(&scratch, "pole.toml", &(base.clone() + &early + &late));
    let words = scratch.briefly("check pole.toml").words();
    assert!(
        words.contains("not in it: the damage of inspection 2026-05-12"),
        "{words}"
    );
    let mended = inspection("2027-05-12", "top", "mended = true");
    write(&scratch, "pole.toml", &(base + &early + &late + &mended));
    let words = scratch.briefly("check pole.toml").words();
    assert!(!words.contains("not in it"), "{words}");
}

#[test]
fn holds_damage_recorded_as_larger_after_the_model_took_it_over_is_in_the_headline() {
    let scratch = Scratch::new("damaged-grown");
    let entry = |date: &str, size: &str, more: &str| {
        format!(
            "[survey.{date}]\ninspections = [{{ part = \"top\", what = \"loss\", size = \"{size}\"{more} }}]\n"
        )
    };
    let model = ", model = { stiffness_left = 0.75 }";
    let found = chain("0.5", "900") + &entry("2024-05-12", "60 mm", model);
    let words = |text: &str| {
        write(&scratch, "pole.toml", text);
        scratch.briefly("check pole.toml").words()
    };
    let said = "not in it: damage recorded as larger since (“top”: loss 60 mm → 110 mm, 2026-05-12)";
    let grown = found.clone() + &entry("2026-05-12", "110 mm", "");
    let headline = words(&grown);
    assert!(headline.contains(said), "{headline}");
    let judged = json(&scratch, "check pole.toml");
    let of = judged
        .pointer("/judgement/versions/0/grown_damage_left_out/0")
        .unwrap();
    assert_eq!(of["sizes_m"], serde_json::json!([0.06, 0.11]), "{of}");
    assert_eq!(
        (&of["since"], &of["survey"]),
        (&"2024-05-12".into(), &"2026-05-12".into())
    );
    let korean = scratch.briefly("check pole.toml --language ko").words();
    assert!(korean.contains("이후 점검에서 커진 손상 미반영"), "{korean}");
    // not by listing an older one later in the file, nor with an effect of its own, nor repaired, nor as small as before
    let part = "recorded as larger since";
    for text in [
        found.clone() + &entry("2022-05-12", "110 mm", ""),
        found.clone() + &entry("2026-05-12", "110 mm", ", model = { stiffness_left = 0.5 }"),
        found.clone() + &entry("2026-05-12", "110 mm", ", model = { mended = true }"),
        found.clone() + &entry("2026-05-12", "60 mm", ""),
        grown.clone() + &entry("2026-06-12", "60 mm", ""),
    ] {
        let headline = words(&text);
        assert!(!headline.contains(part), "{headline}");
    }
    // a worse severity without a larger size; a severe one is named once, as severe
    let rated = |first: &str, then: &str| {
        chain("0.5", "900")
            + &entry("2024-05-12", "60 mm", &format!(", severity = \"{first}\"{model}"))
            + &entry("2026-05-12", "60 mm", &format!(", severity = \"{then}\""))
    };
    let worse = words(&rated("slight", "moderate"));
    assert!(worse.contains("loss slight → moderate, 2026-05-12"), "{worse}");
    let severe = words(&rated("slight", "severe"));
    assert!(severe.contains("severe damage found"), "{severe}");
    assert!(!severe.contains(part), "{severe}");
}
