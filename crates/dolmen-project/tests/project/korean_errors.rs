// SOURCE     Our own sentences.
// GOAL       An error of a project file is in Korean if Korean is requested, and otherwise unchanged.
// TOLERANCE  Names, keys and values of the file stay as they are.

#[path = "../../../dolmen-cli/tests/command/english.rs"]
mod english;

use dolmen_project::parse_project;
use dolmen_words::Language;
use english::english_in;
use std::fs;
use std::path::Path;

/// One mistake in a shipped example: the example, the text, its wrong replacement, and the English message.
struct Mistake {
    example: &'static str,
    written: &'static str,
    instead: &'static str,
    said: &'static str,
}

const fn mistake(
    example: &'static str,
    written: &'static str,
    instead: &'static str,
    said: &'static str,
) -> Mistake {
    Mistake {
        example,
        written,
        instead,
        said,
    }
}

const MISTAKES: [Mistake; 32] = [
    mistake(
        "naju_flagpole",
        "schema = 1",
        "schema = 2",
        "schema = 2 is not known",
    ),
    mistake(
        "naju_flagpole",
        r#"kind = "chain""#,
        r#"kind = "chian""#,
        r#"did you mean "chain"?"#,
    ),
    mistake(
        "naju_flagpole",
        "gravity = 9.81",
        "gravity = 9,81",
        "a decimal comma? Write 9.81",
    ),
    mistake(
        "naju_flagpole",
        r#"kind = "chain""#,
        "kind = “chain”",
        "curly quotes are no quotes of TOML",
    ),
    mistake(
        "naju_flagpole",
        r#"joints = "unknown""#,
        r#"joint = "unknown""#,
        r#"belongs to kind = "stack""#,
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68,",
        "lenght = 3.68,",
        r#"did you mean "length"?"#,
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68, ",
        "",
        r#"links[1] has no "length", but needs it"#,
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68",
        "length = 3680",
        "did you mean mm?",
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68",
        r#"length = "3.68 kN""#,
        "wrong kind of unit",
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68",
        r#"length = "3.68 metre""#,
        "unknown unit",
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68",
        "length = -3.68",
        "must be above 0",
    ),
    mistake(
        "naju_flagpole",
        "length = 3.68",
        "length = true",
        "must be a number",
    ),
    mistake(
        "naju_flagpole",
        "value = 38.95",
        r#"value = "38.95""#,
        "is text without a unit",
    ),
    mistake(
        "naju_flagpole",
        "centroid = 1.64",
        "centroid = 4.64",
        "lies above the link",
    ),
    mistake(
        "naju_flagpole",
        "cov = 0.03",
        "cov = 3",
        "cov is standard deviation / mean",
    ),
    mistake("naju_flagpole", r#"peak = "0.1 g""#, "peak = 0.1", "has no unit"),
    mistake(
        "naju_flagpole",
        r#"variants = ["loose", "wedged"]"#,
        r#"variants = ["lose"]"#,
        r#"there is no variant "lose""#,
    ),
    mistake(
        "naju_flagpole",
        r#"tilt = { x = "1/177""#,
        r#"tilt = { x = "one""#,
        "is not a tilt",
    ),
    mistake("piled_blocks", "width = 300", "width = 300000", "probably a slip"),
    mistake(
        "piled_blocks",
        r#"name = "block 2""#,
        r#"name = "block 1""#,
        "is also the name of blocks[1]",
    ),
    mistake(
        "piled_blocks",
        r#"density = { value = 2600, source = "assumed" }"#,
        "",
        "has no density",
    ),
    mistake(
        "piled_blocks",
        "value = 0.3,",
        "value = 30,",
        "stone on stone has 0.4 to 0.8",
    ),
    mistake(
        "piled_blocks",
        "height = 100 },",
        r#"height = 100, on = "blok 1" },"#,
        "is no block",
    ),
    mistake(
        "heunginjimun_gate",
        r#"axial = "storey" "#,
        "",
        "axial_force is given without axial",
    ),
    mistake(
        "heunginjimun_gate",
        "stiffness = [32.6523, 96.1441]",
        "stiffness = [32.6523]",
        "has 1 elements for 2 storeys",
    ),
    mistake(
        "heunginjimun_gate",
        "mass = 290",
        "mass = 290000",
        "is outside 1 t to 20 000 t",
    ),
    mistake(
        "twisting_floor",
        "sides = [10, 8], ",
        "",
        "has neither sides nor outline",
    ),
    mistake("twisting_floor", "soil = \"S4\"\n", "", r#"site has no "soil""#),
    mistake(
        "twisting_floor",
        "damping_ratio = 0.1273",
        "damping_ratio = 12.73",
        "above 1 nothing swings any more",
    ),
    mistake("palisaden", "file = \"record.npy\"\n", "", "names no file"),
    mistake(
        "palisaden",
        r#"sampling_rate = "100 Hz""#,
        r#"sampling_rate = "0.01 Hz""#,
        "vibration is recorded at",
    ),
    mistake(
        "palisaden",
        "column = 2",
        "column = 1",
        "is that of channels[1] too",
    ),
];

#[test]
fn holds_errors_of_project_files_are_korean_where_it_is_asked_for() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut wrong = Vec::new();
    for mistake in MISTAKES {
        let text = fs::read_to_string(examples.join(mistake.example).join("project.toml")).unwrap();
        assert!(
            text.contains(mistake.written),
            "{}: {}",
            mistake.example,
            mistake.written
        );
        let broken = text.replacen(mistake.written, mistake.instead, 1);
        let Err(error) = parse_project(&broken, "project.toml") else {
            wrong.push(format!("{:?} is let pass", mistake.instead));
            continue;
        };
        let [korean, english] = [Language::Korean, Language::English].map(|language| error.text(language));
        if !english.contains(mistake.said) || english != error.to_string() {
            wrong.push(format!("{:?} is not said:\n{english}", mistake.said));
        }
        // a line of the file itself is printed after its number and a bar
        let is_own = |line: &str| line.trim_start().starts_with(|sign: char| sign.is_ascii_digit());
        let said: Vec<&str> = korean.lines().filter(|line| !is_own(line)).collect();
        let said = said.join("\n").replace('|', "");
        let is_korean = said.starts_with("오류: ") && !said.contains("= help") && !said.contains("error");
        if !is_korean || english_in(&said).is_some() {
            wrong.push(format!("{:?} in:\n{korean}", english_in(&said)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn regress_a_korean_error() {
    let text = "schema = 1\nkind = \"chian\"\nname = \"당간\"\n";
    let said = r#"
오류: kind = "chian"은 쓸 수 없는 값이다
  --> project.toml:2:8
   |
 2 | kind = "chian"
   |        ^^^^^^^ "chain", "frame", "stack", "building" 또는 "survey"이어야 한다
   = 도움말: "chain"을 쓰려던 것인가?
"#;
    let error = parse_project(text, "project.toml").unwrap_err();
    assert_eq!(error.text(Language::Korean), said.trim_start());
}
