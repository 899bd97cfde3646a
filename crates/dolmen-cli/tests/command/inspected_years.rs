// SOURCE     docs/watch.md#inspections, docs/store.md; the slope of a line through readings of known error: ordinary least squares, written here.
//            Modes of the changed pole of the example: `dolmen check` of its model with three quarters of one joint (scripts/example-years).
// GOAL       Stores keep the findings of inspections and follow them over the years: their number, the growth of each damage, when it reaches its
//            limit, and which part of a model explains changes in the same period.
// TOLERANCE  1e-3 of the standard deviation that the last written digit leaves; else none: words, rows, exit statuses.

use super::stores::{FILE, content, database, good, json};
use super::verbs::Scratch;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;

/// A project of yearly inspections from 2018 on, each with entries.
fn inspected(scratch: &Scratch, folder: &str, entries: &[&str], more: &str) {
    let mut text = format!("schema = 1\nkind = \"survey\"\nname = \"{folder}\"\n{more}");
    for (at, entries) in entries.iter().enumerate() {
        write!(
            text,
            "[survey.{}-05-01]\nmade_up = true\ninspections = [{entries}]\n",
            2018 + at
        )
        .unwrap();
    }
    fs::create_dir_all(scratch.path().join(folder)).unwrap();
    fs::write(scratch.path().join(folder).join("project.toml"), text).unwrap();
}

fn crack(size: &str) -> String {
    format!(
        "{{ part = \"stone 3\", what = \"crack\", name = \"C1\", size = \"{size}\", limit = \"0.80 mm\", severity = \"slight\" }}"
    )
}

fn cracks(sizes: &[&str]) -> Vec<String> {
    sizes.iter().map(|size| crack(size)).collect()
}

fn borrowed(all: &[String]) -> Vec<&str> {
    all.iter().map(String::as_str).collect()
}

const LINE: [&str; 8] = [
    "0.20 mm", "0.25 mm", "0.30 mm", "0.35 mm", "0.40 mm", "0.45 mm", "0.50 mm", "0.55 mm",
];

#[test]
fn exact_a_crack_grows_as_the_line_through_its_readings_and_reaches_its_limit() {
    let scratch = Scratch::new("inspected-line");
    inspected(&scratch, "pole", &borrowed(&cracks(&LINE)), "");
    let found = json(&scratch, "watch pole");
    let damage = found.pointer("/inspected/damages/0").unwrap();
    // by hand: years 0 … 7, Σ (t − t̄)² = 42; the last digit is 0.01 mm
    let sd = 1e-5 / 12f64.sqrt() / 42f64.sqrt();
    let number = |key: &str| damage[key].as_f64().unwrap();
    assert!((number("per_year") - 5e-5).abs() < 0.05 * sd, "{damage}");
    assert!((number("sd_per_year") / sd - 1.0).abs() < 1e-3, "{damage}");
    assert!((number("years_to_limit") - 5.0).abs() < 0.01, "{damage}");
    assert_eq!(damage["beyond_limit"], false);
    let answer = scratch.briefly("watch pole");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let words = answer.words();
    assert!(
        words.contains("0.050 ± 0.001 mm a year, beyond chance"),
        "{words}"
    );
    assert!(words.contains("limit of 0.8 mm in 2030-05"), "{words}");
}

#[test]
fn holds_a_damage_at_its_limit_is_an_alarm_until_a_repair_answers_it() {
    let scratch = Scratch::new("inspected-limit");
    let beyond = cracks(&["0.60 mm", "0.70 mm", "0.85 mm"]);
    inspected(&scratch, "pole", &borrowed(&beyond), "");
    let answer = scratch.briefly("watch pole");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(
        answer
            .words()
            .contains("0.85 mm, at its limit of 0.8 mm or beyond"),
        "{}",
        answer.stdout
    );
    // an inspection of another part does not close it
    let mut elsewhere = beyond.clone();
    elsewhere.push("{ part = \"stone 1\", what = \"growth\" }".to_owned());
    inspected(&scratch, "pole", &borrowed(&elsewhere), "");
    let answer = scratch.briefly("watch pole");
    assert_eq!(answer.status, 1, "{}", answer.stdout);
    assert!(answer.words().contains("does not list it"), "{}", answer.stdout);
    let repair = "[watch]\nworks = [{ date = \"2020-09-01\", kind = \"repair\", what = \"injected\" }]\n";
    inspected(&scratch, "pole", &borrowed(&elsewhere), repair);
    let answer = scratch.briefly("watch pole");
    assert_eq!(answer.status, 0, "{}", answer.stdout);
    let found = json(&scratch, "watch pole");
    assert_eq!(found["open_alarms"], 0);
}

#[test]
fn holds_several_cracks_of_one_part_need_names_and_counts_need_none() {
    let scratch = Scratch::new("inspected-several");
    let two = "{ part = \"stone 3\", what = \"crack\", size = \"0.2 mm\", severity = \"severe\" }, \
               { part = \"stone 3\", what = \"crack\", size = \"0.4 mm\" }";
    inspected(&scratch, "pole", &[two, two, two], "");
    let found = json(&scratch, "watch pole");
    let of = &found["inspected"];
    assert_eq!(of["damages"].as_array().unwrap().len(), 0, "{of}");
    assert_eq!(of.pointer("/several_alike/0/most").unwrap(), 2, "{of}");
    let counts = of.pointer("/inspections/2/counts/0").unwrap();
    assert_eq!(
        (&counts["severe"], &counts["not_rated"]),
        (&1.into(), &1.into()),
        "{of}"
    );
    let words = scratch.briefly("watch pole").words();
    assert!(words.contains("name = \"C1\""), "{words}");
    // too few readings for a slope: the answer gives the reading error
    let few = ["0.2 mm", "0.2 mm", "0.6 mm"]
        .map(|size| format!("{{ part = \"stone 3\", what = \"crack\", size = \"{size}\" }}"));
    inspected(&scratch, "few", &borrowed(&few), "");
    let words = scratch.briefly("watch few").words();
    assert!(words.contains("it grew by 0.40 ± 0.08 mm"), "{words}");
}

#[test]
fn refuses_a_name_that_tells_nothing() {
    let scratch = Scratch::new("inspected-name");
    let entry = "{ part = \"stone 3\", what = \"crack\", name = \" \" }";
    inspected(&scratch, "pole", &[entry], "");
    let answer = scratch.briefly("check pole");
    assert_eq!(answer.status, 2);
    assert!(answer.stderr.contains("must have 1 to 40"), "{}", answer.stderr);
    let korean = scratch.briefly("check pole --language ko");
    assert!(korean.stderr.contains("1~40자"), "{}", korean.stderr);
}

fn kept(scratch: &Scratch, store: &str) -> Value {
    let shown = json(scratch, &format!("survey show pole {store}"));
    shown["surveys"].clone()
}

#[test]
fn holds_a_store_keeps_inspections_and_what_is_made_up() {
    let scratch = Scratch::new("inspected-kept");
    inspected(&scratch, "pole", &borrowed(&cracks(&LINE)), "");
    good(scratch.briefly(&format!("survey add pole --who kim {FILE}")));
    let surveys = kept(&scratch, FILE);
    assert_eq!(surveys[0]["is_made_up"], true, "{surveys}");
    let entry = surveys.pointer("/7/inspections/0").unwrap();
    assert_eq!((&entry["what"], &entry["name"]), (&"crack".into(), &"C1".into()));
    assert_eq!(
        (&entry["size_m"], &entry["limit_m"]),
        (&5.5e-4.into(), &8e-4.into())
    );
    // the exported project gives the same answers
    good(scratch.briefly(&format!("survey export pole -o back {FILE}")));
    let of = |folder: &str| json(&scratch, &format!("watch {folder}"))["inspected"].clone();
    assert_eq!(of("back"), of("pole"));
    // a copy of the store contains the same
    good(scratch.briefly("survey import s.db --store other.db"));
    assert_eq!(kept(&scratch, "--store other.db"), surveys);
    assert_eq!(content(&scratch, "--store other.db"), content(&scratch, FILE));
}

#[test]
fn holds_a_store_of_the_schema_before_gets_what_its_texts_have() {
    let scratch = Scratch::new("inspected-migrated");
    inspected(&scratch, "pole", &borrowed(&cracks(&LINE)), "");
    good(scratch.briefly(&format!("survey add pole --who kim {FILE}")));
    let (surveys, held) = (kept(&scratch, FILE), content(&scratch, FILE));
    let before = database(&scratch);
    before
        .execute_batch("drop table inspection_item; drop table made_up; pragma user_version = 4")
        .unwrap();
    drop(before);
    assert_eq!(kept(&scratch, FILE), surveys);
    assert_eq!(content(&scratch, FILE), held);
}

#[test]
fn holds_every_structure_of_a_store_is_watched_for_damage_at_its_limit() {
    let scratch = Scratch::new("inspected-all");
    inspected(
        &scratch,
        "pole",
        &borrowed(&cracks(&["0.60 mm", "0.70 mm", "0.85 mm"])),
        "",
    );
    inspected(&scratch, "other", &borrowed(&cracks(&LINE)), "");
    good(scratch.briefly(&format!("survey add pole other {FILE}")));
    let answer = scratch.briefly(&format!("watch --all {FILE}"));
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    let all = json(&scratch, &format!("watch --all {FILE}"));
    let first = &all["structures"][0];
    assert_eq!(
        (&first["structure"], &first["history"]["cracks_beyond"]),
        (&"pole".into(), &1.into()),
        "{all}"
    );
    assert_eq!(all["alarming"], 1, "{all}");
}

#[test]
fn agrees_the_years_name_the_joint_that_the_storm_loosened() {
    let scratch = Scratch::with_examples("inspected-part");
    let found = json(&scratch, "watch examples/flagpole_over_the_years");
    let there = found.pointer("/changed_parts/0").unwrap();
    assert_eq!(
        (&there["date_earliest"], &there["date_latest"]),
        (&"2021-05-12".into(), &"2021-11-07".into()),
        "{there}"
    );
    let part = there.pointer("/parts/0").unwrap();
    let best = &part["fits"][0];
    assert_eq!(best["part"], "shaft 3", "{part}");
    let between = |low: &str, high: &str| {
        let of = |key: &str| best[key].as_f64().unwrap();
        of(low) < 0.75 && 0.75 < of(high)
    };
    assert!(between("stiffness_left_lower", "stiffness_left_upper"), "{best}");
    assert_eq!(part["modes_hz"].as_array().unwrap().len(), 3, "{part}");
    // the bed that opened with it, and the growing crack
    let damage = |part: &str, name: Value| {
        let all = found.pointer("/inspected/damages").and_then(Value::as_array);
        let mut same = all
            .unwrap()
            .iter()
            .filter(|of| of["part"] == part && of["name"] == name);
        same.next().unwrap().clone()
    };
    let crack = damage("shaft 2", "C1".into());
    let (slope, sd) = (
        crack["per_year"].as_f64().unwrap(),
        crack["sd_per_year"].as_f64().unwrap(),
    );
    assert!(
        (slope - 3.5e-5).abs() < 2.5 * sd && crack["beyond_chance"] == true,
        "{crack}"
    );
    let bed = damage("shaft 3", Value::Null);
    assert!(
        (bed.pointer("/changes/0/size").unwrap().as_f64().unwrap() - 3e-3).abs() < 6e-4,
        "{bed}"
    );
    assert_eq!(damage("shaft 2", "C2".into())["beyond_chance"], false);
}

#[test]
fn holds_a_damage_beyond_its_limit_is_red_in_check_and_report_however_few_the_surveys() {
    let scratch = Scratch::new("inspected-limit");
    let pole = |size: &str, more: &str| {
        let model = "schema = 1\nkind = \"stack\"\nname = \"pier\"\ndensity = 2600\njoint = { friction = 0.7 }\n\
                     blocks = [{ name = \"stone 3\", width = 1.0, depth = 1.0, height = 1.0 }]\n";
        let text = format!(
            "{model}{more}[survey.2026-05-01]\ninspections = [{}]\n",
            crack(size)
        );
        fs::write(scratch.path().join("pier.toml"), text).unwrap();
        let found = scratch.briefly("check pier.toml --json");
        let judged: Value = serde_json::from_str(&found.stdout).unwrap();
        let version = &judged["judgement"]["versions"][0];
        (found.status, version["damage_beyond_limit"].as_u64().unwrap())
    };
    assert_eq!(pole("0.79 mm", ""), (0, 0));
    // mended after the inspection
    assert_eq!(
        pole(
            "0.90 mm",
            "[watch]\nworks = [{ date = \"2026-06-01\", kind = \"repair\", what = \"crack filled\" }]\n"
        ),
        (0, 0)
    );
    assert_eq!(pole("0.90 mm", ""), (1, 1));
    let answer = scratch.briefly("check pier.toml");
    let words = answer.words();
    assert!(words.contains("Damage beyond its limit: 1"), "{words}");
    assert!(words.contains("limit of 0.8 mm"), "{words}");
    let reported = scratch.briefly("report pier.toml -o pier.html");
    assert_eq!(reported.status, 1, "{}", reported.stderr);
    let page = fs::read_to_string(scratch.path().join("pier.html")).unwrap();
    assert!(page.contains("Damage beyond its limit: 1"), "{page}");
}
