//! Errors of keys, tables and variants: the full text of every message.

use super::project::{CHAIN, chain_with, refused};

#[test]
fn refuses_a_missing_key() {
    let text = chain_with(&[(r#"length = 2.61, "#, r#""#)]);
    let said = r##"
error: links[2] has no "length", but needs it
  --> project.toml:7:3
   |
 7 |   { weight = 15.13, centroid = 1.18 },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: write length = …: length from joint to joint
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_unknown_key_and_names_the_nearest() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"lenght = 2.61"#)]);
    let said = r##"
error: links[2] has no key "lenght"
  --> project.toml:7:21
   |
 7 |   { weight = 15.13, lenght = 2.61, centroid = 1.18 },
   |                     ^^^^^^ unknown key
   = help: did you mean "length"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_table_named_in_korean_and_names_the_key() {
    for (header, key) in [
        ("[부지]", "site"),
        ("[조사.2026-09-03]", "survey"),
        ("[ 단위 ]", "units"),
    ] {
        let said = refused(&format!("{CHAIN}\n{header}\nzone = 1\n"));
        let given = header.trim_matches(['[', ']', ' ']).split('.').next().unwrap();
        let help = format!("= help: keys are English words: is \"{given}\" {key}?");
        assert!(said.contains(&help), "{said}");
    }
    // a word that is not a key, or that names a part, is quoted
    let said = refused(&format!("{CHAIN}\n[variant.부지]\n"));
    assert!(said.contains("stands in quotes: [variant.\"부지\"]"), "{said}");
}

#[test]
fn refuses_a_bare_ratio_and_quotes_it() {
    let said = refused(&format!("{CHAIN}\n[survey.2026-09-03]\ntilt = {{ x = 1/85 }}\n"));
    assert!(said.contains("= help: put it in quotes: \"1/85\""), "{said}");
}

#[test]
fn refuses_an_unknown_key_like_no_other_and_lists_all() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = 2.61, colour = "grey""#)]);
    let said = r##"
error: links[2] has no key "colour"
  --> project.toml:7:36
   |
 7 |   { weight = 15.13, length = 2.61, colour = "grey", centroid = 1.18 },
   |                                    ^^^^^^ unknown key
   = help: known keys are name, weight, mass, length, centroid, inertia, inertia_across, breadth, depth, bed_width
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_key_swallowed_by_the_table_above() {
    let text = chain_with(&[(
        r#"joints = "unknown"
"#,
        r#"
[survey.2010-05-12]
temperature_c = 18
joints = "unknown"
"#,
    )]);
    let said = r##"
error: "joints" belongs to the top level but stands below [survey.2010-05-12] (line 11)
   --> project.toml:13:1
    |
 13 | joints = "unknown"
    | ^^^^^^ swallowed by the table above it
    = help: move it above the first [table]: in TOML a key belongs to the last [table] before it
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_key_swallowed_by_a_table_within_its_own() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.2010-05-12.records]
file = "a.csv"
temperature_c = 18
"#
    );
    let said = r##"
error: "temperature_c" belongs to [survey.2010-05-12] but stands below [survey.2010-05-12.records] (line 12)
   --> project.toml:14:1
    |
 14 | temperature_c = 18
    | ^^^^^^^^^^^^^ swallowed by the table above it
    = help: move it above line 12, below [survey.2010-05-12]: in TOML a key belongs to the last [table] before it
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_newer_schema() {
    let text = chain_with(&[(r#"schema = 1"#, r#"schema = 2"#)]);
    let said = r##"
error: schema = 2 is not known
  --> project.toml:1:10
   |
 1 | schema = 2
   |          ^ must be 1
   = help: the file is of a newer format: this is Dolmen 0.1.0, which reads schema 1; get a Dolmen that reads schema 2
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_schema_that_never_was() {
    let text = chain_with(&[(r#"schema = 1"#, r#"schema = 0"#)]);
    let said = r##"
error: schema = 0 is not known
  --> project.toml:1:10
   |
 1 | schema = 0
   |          ^ must be 1
   = help: Dolmen 0.1.0 reads schema 1: write schema = 1
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_file_without_schema() {
    let text = chain_with(&[(
        r#"schema = 1
"#,
        r#""#,
    )]);
    let said = r##"
error: the file has no "schema", but needs it
  --> project.toml:1:1
   |
 1 | kind = "chain"
   | ^
   = help: write schema = 1 as the first line: it is the version of the file format
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_schema_in_quotes() {
    let text = chain_with(&[(r#"schema = 1"#, r#"schema = "1""#)]);
    let said = r##"
error: schema = "1" is text
  --> project.toml:1:10
   |
 1 | schema = "1"
   |          ^^^ must be a whole number
   = help: write a number without quotes
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_unknown_kind() {
    let text = chain_with(&[(r#""chain""#, r#""chian""#)]);
    let said = r##"
error: kind = "chian" is not known
  --> project.toml:2:8
   |
 2 | kind = "chian"
   |        ^^^^^^^ must be "chain", "frame", "stack", "building" or "survey"
   = help: did you mean "chain"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_key_of_another_kind() {
    let text = chain_with(&[(
        r#"joints ="#,
        r#"storeys = []
joints ="#,
    )]);
    let said = r##"
error: "storeys" belongs to kind = "frame", but this file has kind = "chain"
   --> project.toml:10:1
    |
 10 | storeys = []
    | ^^^^^^^ has no meaning here
    = help: take it out, or write kind = "frame"
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_two_problems_at_once() {
    let text = chain_with(&[
        (r#"centroid = 1.18"#, r#"centroid = 5.2"#),
        (r#"weight = 6.78"#, r#"wieght = 6.78"#),
    ]);
    let said = r##"
error: links[2].centroid = 5.2 m lies above the link's top
  --> project.toml:7:47
   |
 7 |   { weight = 15.13, length = 2.61, centroid = 5.2 },
   |                                               ^^^ must be 0 to 2.61 m, the link's own length
   = help: centroid is measured from the link's lower joint, not from the ground

error: links[3] has no key "wieght"
  --> project.toml:8:5
   |
 8 |   { wieght = 6.78, length = 1.63, centroid = 0.78 },
   |     ^^^^^^ unknown key
   = help: did you mean "weight"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_chain_without_joints() {
    let text = chain_with(&[(
        r#"joints = "unknown"
"#,
        r#""#,
    )]);
    let said = r##"
error: a chain needs joints
  --> project.toml:1:1
   |
 1 | schema = 1
   | ^
   = help: write joints = "unknown" if nobody has measured them, or [ { stiffness = … }, … ]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_misspelt_unknown() {
    let text = chain_with(&[(r#""unknown""#, r#""unkown""#)]);
    let said = r##"
error: joints = "unkown" is not known
   --> project.toml:10:10
    |
 10 | joints = "unkown"
    |          ^^^^^^^^ must be a list, lowest first, "unknown", "identified" or { source = "identified", survey = … }
    = help: did you mean "unknown"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_fewer_joints_than_links() {
    let text = chain_with(&[(
        r#""unknown""#,
        r#"[ { stiffness = 253800 }, { stiffness = 81900 } ]"#,
    )]);
    let said = r##"
error: joints has 2 elements for 3 links
   --> project.toml:10:10
    |
 10 | joints = [ { stiffness = 253800 }, { stiffness = 81900 } ]
    |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ must be 3, one for each of the links, lowest first
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_what_is_not_toml() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = 2.61.2"#)]);
    let said = r##"
error: this is not TOML: invalid float, expected nothing
  --> project.toml:7:34
   |
 7 |   { weight = 15.13, length = 2.61.2, centroid = 1.18 },
   |                                  ^^
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_key_given_twice() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = 2.61, length = 2.7"#)]);
    let said = r##"
error: this is not TOML: duplicate key
  --> project.toml:7:36
   |
 7 |   { weight = 15.13, length = 2.61, length = 2.7, centroid = 1.18 },
   |                                    ^^^^^^
   = help: "length" is given twice in the same table: keep one
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_date_where_text_must_be() {
    let text = chain_with(&[(
        r#"joints ="#,
        r#"description = 2010-05-12
joints ="#,
    )]);
    let said = r##"
error: description = 2010-05-12 is a date
   --> project.toml:10:15
    |
 10 | description = 2010-05-12
    |               ^^^^^^^^^^ must be text or a table
    = help: put it in quotes: "2010-05-12"
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_survey_without_a_name() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey]
temperature_c = 18
"#
    );
    let said = r##"
error: survey.temperature_c = 18 is a number
   --> project.toml:13:17
    |
 13 | temperature_c = 18
    |                 ^^ must be a table
    = help: temperature_c belongs one level deeper: give the survey a name, [survey.NAME], and put it there
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_number_where_a_list_must_be() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a]
frequencies = { x = 1.1 }
"#
    );
    let said = r##"
error: survey.a.frequencies.x = 1.1 is a number
   --> project.toml:13:21
    |
 13 | frequencies = { x = 1.1 }
    |                     ^^^ must be a list
    = help: put it in brackets: [1.1]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_unknown_key_in_a_variant() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[variant.repaired]
links = { 2 = { centriod = 1.0 } }
"#
    );
    let said = r##"
error: in variant "repaired": links[2] has no key "centriod"
   --> project.toml:13:17
    |
 13 | links = { 2 = { centriod = 1.0 } }
    |                 ^^^^^^^^ unknown key
    = help: did you mean "centroid"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_what_a_variant_makes_impossible() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[variant.repaired]
links = { 2 = { length = 1.0 } }
"#
    );
    let said = r##"
error: in variant "repaired": links[2].centroid = 1.18 m lies above the link's top
  --> project.toml:7:47
   |
 7 |   { weight = 15.13, length = 2.61, centroid = 1.18 },
   |                                               ^^^^ must be 0 to 1 m, the link's own length
   = help: centroid is measured from the link's lower joint, not from the ground
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_element_that_a_variant_does_not_find() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[variant.repaired]
links = { 7 = { length = 1.0 } }
"#
    );
    let said = r##"
error: in variant "repaired": links has no element "7"
   --> project.toml:13:11
    |
 13 | links = { 7 = { length = 1.0 } }
    |           ^ must be a number from 1 to 3
    = help: a list is changed by number, links = { 2 = { … } }, or replaced: links = [ … ]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_variant_that_changes_units() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[variant.repaired]
units = { force = "N" }
"#
    );
    let said = r##"
error: variant "repaired" cannot change units
   --> project.toml:13:1
    |
 13 | units = { force = "N" }
    | ^^^^^ holds for the whole file
    = help: take it out, or make another file
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_variant_without_a_name() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[variant]
joints = "unknown"
"#
    );
    let said = r##"
error: variant.joints is not a table
   --> project.toml:13:10
    |
 13 | joints = "unknown"
    |          ^^^^^^^^^ must be a table
    = help: give the variant a name: [variant.NAME] above what it changes
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}
