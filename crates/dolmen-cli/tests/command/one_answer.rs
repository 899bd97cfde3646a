// SOURCE     Answers that new users found misleading or contradictory.
// GOAL       One count of assumed inputs, one direction of a ratio, one word for equal parts, and a key to type in each refusal.
// TOLERANCE  none: words, numbers as printed and exit statuses.

use super::verbs::Scratch;
use std::fs;

fn said(name: &str, text: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen(words);
    (answer.status, answer.words() + &answer.stderr)
}

const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\n\
    links = [{ name = \"pole\", weight = \"40 kN\", length = 10, centroid = 5, breadth = 0.8, bed_width = 0.8 }]\n\
    joints = [{ stiffness = \"3 MN*m/rad\" }]\n";

const BLOCKS: &str = "schema = 1\nkind = \"stack\"\nname = \"Blocks\"\nevidence = \"measured\"\ndensity = 2600\n\
    joint = { friction = { value = 0.6, source = \"assumed\" }, normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.05 }\n\
    blocks = [{ name = \"low\", width = 1.0, depth = 1.0, height = 1.0 }, { name = \"high\", width = 0.8, depth = 0.8, height = 1.0 }]\n";

#[test]
fn holds_assumed_inputs_are_counted_once_and_named() {
    let (_, words) = said("one-count", BLOCKS, "check project.toml");
    let of = words
        .split("assumed inputs: ")
        .nth(1)
        .and_then(|rest| rest.split_whitespace().nth(2))
        .unwrap();
    let finding = format!("Assumed, not measured, 1 of {of} inputs: all joints: friction");
    assert!(words.contains(&finding), "{finding}: {words}");
    let more = BLOCKS.replace("evidence = \"measured\"", "evidence = \"assumed\"");
    let (_, words) = said("one-count-more", &more, "check project.toml");
    let of = words.split("assumed inputs: ").nth(1).unwrap();
    let of: Vec<&str> = of.split_whitespace().take(3).collect();
    let finding = format!("Assumed, not measured, {} inputs: ", of.join(" "));
    assert!(
        words.contains(&finding) && words.contains(" more (every result"),
        "{finding}: {words}"
    );
    // assumptions of Dolmen count too
    let taken = BLOCKS.replace(", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.05", "");
    let (_, words) = said("one-count-taken", &taken, "check project.toml");
    assert!(
        words.contains("assumed inputs: 3 of") && words.contains("Assumed, not measured, 3 of"),
        "{words}"
    );
}

#[test]
fn holds_a_run_without_damping_says_so_in_its_headline() {
    let run = "simulate project.toml --motion el-centro-1940-ns";
    let (_, words) = said("undamped", POLE, run);
    let verdict = words.split("VERDICT").nth(1).unwrap();
    let headline = verdict.split(" - ").next().unwrap();
    assert!(headline.contains("computed with 0 % damping"), "{words}");
    let damped = format!("damping_ratio = 0.02\n{POLE}");
    let (_, words) = said("damped", &damped, run);
    assert!(!words.contains("0 % damping"), "{words}");
    let study = format!(
        "{POLE}[study.s]\nmotions = [\"el-centro-1940-ns\"]\npeak = {{ from = \"0.2 g\", to = \"0.4 g\", steps = 2 }}\n"
    );
    let (_, words) = said("undamped-study", &study, "study project.toml");
    let at = words.find("Computed with 0 % damping").unwrap_or(usize::MAX);
    assert!(at < words.find("reached").unwrap_or(0), "{words}");
}

#[test]
fn holds_a_bed_is_as_oblong_as_its_link_and_one_value_is_no_range() {
    let oblong = POLE.replace("breadth = 0.8", "breadth = 0.8, depth = 0.4");
    let (_, words) = said("oblong", &oblong, "check project.toml");
    // (0.4/0.8)²
    assert!(
        words.contains("at most 1; 25.0 % of it") && !words.contains("25.0 % to"),
        "{words}"
    );
}

#[test]
fn holds_equal_posts_have_equal_ranges() {
    let posts = "schema = 1\nkind = \"stack\"\nname = \"Trilithon\"\ndensity = 2600\n\
        joint = { friction = 0.6, normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.3 }\n\
        trilithon = { span = 1.2, post_width = 0.8, post_height = 3.2, depth = 1.0, lintel_height = 0.7, overhang = 0.1 }\n\
        [survey.2026-01-01]\nfrequencies.y = [{ value = 5.0, sd = 0.02 }]\nfrequencies.x = [{ value = 6.0, sd = 0.02 }]\n";
    let (_, words) = said("equal-posts", posts, "identify project.toml");
    let range = |post: &str| {
        let row = words
            .split(&format!("post {post} on the ground "))
            .nth(1)
            .unwrap();
        row.split(" lintel on")
            .next()
            .unwrap()
            .split(" post ")
            .next()
            .unwrap()
            .to_owned()
    };
    assert_eq!(range("1").trim(), range("2").trim(), "{words}");
}

#[test]
fn refuses_to_write_springs_and_says_what_to_type() {
    let surveyed = format!("{BLOCKS}[survey.2026-01-01]\nfrequencies.x = [{{ value = 9.0, sd = 0.1 }}]\n");
    let (status, words) = said("springs-typed", &surveyed, "identify project.toml --write");
    assert_eq!(status, 2, "{words}");
    assert!(
        words.contains("normal_stiffness = \"") && words.contains("survey = \"2026-01-01\""),
        "{words}"
    );
}

#[test]
fn refuses_a_tilt_without_a_direction_and_says_what_to_type() {
    let leaning = format!("{POLE}[survey.2026-01-01]\ntilt = \"1/85\"\n");
    let (status, words) = said("tilt-typed", &leaning, "check project.toml");
    assert_eq!(status, 2, "{words}");
    assert!(
        words.contains("say in which direction: tilt = { x = \"1/85\" }"),
        "{words}"
    );
    let outside = format!("{POLE}[survey.2026-01-01.records]\nfile = \"../far/away.qqq\"\n");
    let (status, words) = said("outside-typed", &outside, "check project.toml");
    assert!(
        status == 2 && words.contains("copy it into the folder of the project"),
        "{words}"
    );
}

#[test]
fn holds_a_report_without_an_ending_is_a_page_and_an_empty_licence_is_none() {
    let scratch = Scratch::new("no-ending");
    let report =
        format!("{POLE}[report]\nauthors = [{{ name = \"A. Kim\", role = \"engineer\", licence = \"\" }}]\n");
    fs::write(scratch.path().join("project.toml"), report).unwrap();
    let answer = scratch.dolmen("report project.toml -o 제출");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(answer.stdout.contains("제출.html"), "{}", answer.stdout);
    let page = fs::read_to_string(scratch.path().join("제출.html")).unwrap();
    assert!(page.contains("A. Kim") && !scratch.path().join("제출").exists());
}
