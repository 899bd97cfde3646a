// SOURCE     Files that a stranger gave to the command, and whose answers he took for more than they are.
// GOAL       The headline or an error says what the answer leaves out or cannot know.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fmt::Write as _;
use std::fs;

const STONES: &str = "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = { friction = 0.6 }\n\
    blocks = [{ name = \"b\", width = 1.0, height = 0.5 }, { name = \"p\", width = 0.4, height = 2.2 }]\n";

const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"a\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\n\
    links = [{ name = \"s1\", weight = 20, length = 3, centroid = 1.5, breadth = 0.6 }, \
    { name = \"s2\", weight = 10, length = 2.5, centroid = 1.2, breadth = 0.5 }]\n";

fn said(name: &str, text: &str, words: &str) -> (i32, String) {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly(words);
    (answer.status, format!("{}{}", answer.words(), answer.stderr))
}

fn headline(words: &str) -> &str {
    words
        .split_once("VERDICT")
        .map_or("", |(_, rest)| rest.split(['●', '◆', '○']).next().unwrap_or(rest))
}

#[test]
fn holds_wind_and_loads_in_no_combination_stand_in_the_headline() {
    let joints = "joints = [{ stiffness = 2000, bed_width = 0.6 }, { stiffness = 800, bed_width = 0.5 }]\n";
    let wind = "wind = { speed = \"40 m/s\", means = \"gust\", force_coefficient = 2.0 }\n\
        loads = [{ name = \"a\", at = \"s2\", force = \"0.1 kN\" }]\n";
    let text = |factors: &str| POLE.to_owned() + joints + wind + "[combination.service]\n" + factors;
    let (_, words) = said("wind-left-out", &text("loads = 1.0\n"), "check project.toml");
    assert!(
        headline(&words).contains("not in it: the wind of the file"),
        "{words}"
    );
    let (_, words) = said("loads-left-out", &text("wind = 0.1\n"), "check project.toml");
    assert!(
        headline(&words).contains("not in it: static loads of the file"),
        "{words}"
    );
    let (_, words) = said(
        "both-counted",
        &text("wind = 0.1\nloads = 1.0\n"),
        "check project.toml",
    );
    assert!(!words.contains("not in it"), "{words}");
}

#[test]
fn holds_a_pole_that_only_its_side_posts_hold_says_so_in_the_headline() {
    let posts = "joints = [{ stiffness = 60 }, { stiffness = 300 }]\n\
        side_supports = [{ height = 2.0, stiffness = \"2 kN/mm\", gap = \"0 mm\" }]\n";
    let (_, words) = said("only-posts", &(POLE.to_owned() + posts), "check project.toml");
    assert!(
        headline(&words).contains("held by its side supports alone (load factor 0.829 without them)"),
        "{words}"
    );
}

#[test]
fn refuses_two_tilts_of_the_latest_day_unless_one_is_chosen() {
    let surveys = "[survey.\"2024-05-01 am\"]\ntilt = { x = \"1/20\" }\n[survey.\"2024-05-01 pm\"]\ntilt = { x = \"1/300\" }\n";
    let (status, words) = said("tilts", &(STONES.to_owned() + surveys), "check project.toml");
    assert!(
        status == 2 && words.contains("their tilts differ") && words.contains("as_surveyed"),
        "{words}"
    );
    let chosen = STONES.to_owned() + "as_surveyed = \"2024-05-01 am\"\n" + surveys;
    let (_, words) = said("tilt-chosen", &chosen, "check project.toml");
    // tan(atan(0.2 / 1.1) - atan(1 / 20))
    assert!(words.contains("0.131 g"), "{words}");
}

#[test]
fn holds_an_offset_of_a_motion_and_per_cent_of_gravity_are_seen() {
    let scratch = Scratch::new("motion-offset");
    fs::write(scratch.path().join("project.toml"), STONES).unwrap();
    let wave = |i: i32| (0.05 * f64::from(i)).sin();
    let (mut offset, mut percent) = ("time_s,a (g)\n".to_owned(), "time_s,a (%g)\n".to_owned());
    for i in 0..4000 {
        let t = 0.01 * f64::from(i);
        writeln!(offset, "{t},{}", 0.05 + 0.1 * wave(i)).unwrap();
        writeln!(percent, "{t},{}", 10.0 * wave(i)).unwrap();
    }
    fs::write(scratch.path().join("offset.csv"), offset).unwrap();
    fs::write(scratch.path().join("percent.csv"), percent).unwrap();
    let run = |words: &str| {
        let answer = scratch.briefly(&format!("simulate . --law rigid --motion-file {words}"));
        format!("{}{}", answer.words(), answer.stderr)
    };
    let words = run("offset.csv");
    assert!(
        words.contains("PROBABLY A SLIP: with x the ground ends 392 m away"),
        "{words}"
    );
    assert!(run("percent.csv --unit gal").contains("%g"), "{words}");
    let read = scratch.dolmen("motion --motion-file percent.csv").words();
    assert!(read.contains("0.1000"), "{read}");
}

#[test]
fn holds_a_lintel_that_rests_on_a_few_millimetres_says_so() {
    let box_at = |name: &str, x: [f64; 2], z: [f64; 2]| {
        let mut points = String::new();
        for (x, y, z) in (0..8).map(|i| (x[i & 1], [-0.3, 0.3][(i >> 1) & 1], z[i >> 2])) {
            write!(points, "[{x}, {y}, {z}], ").unwrap();
        }
        format!("{{ name = \"{name}\", shape = \"points\", coordinates = \"site\", points = [{points}] }}, ")
    };
    for (from, says) in [(0.695, true), (0.6, false)] {
        let blocks = box_at("a", [-0.65, -0.35], [0.0, 1.0])
            + &box_at("b", [from, 0.995], [0.0, 1.0])
            + &box_at("slab", [-0.7, 0.7], [1.0, 1.2]);
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = {{ friction = 0.6 }}\nblocks = [{blocks}]\n"
        );
        let (_, words) = said("narrow-bed", &text, "check project.toml");
        assert_eq!(
            words.contains("“slab” rests on “b” over 5.0 mm alone"),
            says,
            "{words}"
        );
    }
}

#[test]
fn holds_a_stone_hung_between_two_is_answered_at_its_site_too() {
    let mut blocks = String::new();
    for (name, x, z) in [
        ("left", [0.0, 1.0], [0.0, 1.5]),
        ("hung", [1.0, 1.4], [0.5, 1.0]),
        ("right", [1.4, 2.4], [0.0, 1.5]),
    ] {
        let mut points = String::new();
        for (x, y, z) in (0..8).map(|i| (x[i & 1], [-0.3, 0.3][(i >> 1) & 1], z[i >> 2])) {
            write!(points, "[{x}, {y}, {z}], ").unwrap();
        }
        write!(
            blocks,
            "{{ name = \"{name}\", shape = \"points\", coordinates = \"site\", points = [{points}] }}, "
        )
        .unwrap();
    }
    let text = format!(
        "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = {{ friction = 0.6 }}\nblocks = [{blocks}]\n\
         [site]\ncode = \"KDS 17 10 00\"\nzone = \"I\"\nreturn_period_years = 500\nsoil = \"S1\"\n"
    );
    let (status, words) = said("hung-stone", &text, "check project.toml");
    assert!(status != 2 && words.contains("unknown"), "{status}: {words}");
}

#[test]
fn refuses_an_earthquake_that_only_lifts() {
    let scratch = Scratch::new("only-lifts");
    fs::write(scratch.path().join("project.toml"), STONES).unwrap();
    let rows: String = (0..400)
        .map(|i| format!("{},{}\n", 0.01 * f64::from(i), (0.3 * f64::from(i)).sin()))
        .collect();
    fs::write(scratch.path().join("z.csv"), format!("time_s,a (m/s2)\n{rows}")).unwrap();
    let answer = scratch.briefly("simulate . --motion-file z=z.csv");
    assert_eq!(answer.status, 2, "{}", answer.words());
    assert!(
        answer.stderr.contains("has no horizontal component"),
        "{}",
        answer.stderr
    );
}

#[test]
fn holds_stones_that_share_their_load_say_what_moves_first() {
    let leg = |name: &str, x: f64, y: f64| {
        format!("{{ name = \"{name}\", width = 0.3, depth = 0.3, height = 1.0, position = [{x}, {y}, 0] }}, ")
    };
    let blocks = leg("a", -0.6, -0.3) + &leg("b", 0.6, -0.3) + &leg("c", 0.0, 0.3);
    let text = format!(
        "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = {{ friction = 0.6 }}\n\
         blocks = [{blocks}{{ name = \"slab\", width = 1.6, depth = 1.0, height = 0.2, position = [0, 0, 1.0], on = [\"a\", \"b\", \"c\"] }}]\n"
    );
    let (_, words) = said("three-legs", &text, "check project.toml");
    assert!(words.contains("towards"), "{words}");
}
