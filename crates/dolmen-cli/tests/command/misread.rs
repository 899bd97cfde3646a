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
    // 0.05 g of offset, 392 m in 40 s, and the mean velocity of a sine that begins at rest, 0.2 m/s
    let words = run("offset.csv");
    assert!(
        words.contains("PROBABLY A SLIP: with x the ground ends 400 m away"),
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
    // it is not said to move at an acceleration that friction alone lets it reach
    assert!(
        words.contains(
            "Only if it does, it begins to move at 0.400 g horizontal, or on ground that tilts by 21.8°, or less"
        ),
        "{words}"
    );
}

#[test]
fn holds_columns_of_a_table_that_matter_are_refused_and_other_numbers_named() {
    let scratch = Scratch::new("columns-unread");
    let text = STONES.split("blocks").next().unwrap().to_owned() + "blocks = { file = \"b.csv\" }\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let with = |head: &str, cells: [&str; 2], language: &str| {
        let [base, body] = cells;
        let table = format!("이름,폭(mm),높이(mm),{head}\n기단,1000,500,{base}\n탑신,400,1100,{body}\n");
        fs::write(scratch.path().join("b.csv"), table).unwrap();
        let answer = scratch.briefly(&format!("check . --language {language}"));
        (answer.status, format!("{}{}", answer.words(), answer.stderr))
    };
    for (head, cells) in [
        ("수량", ["1", "2"]),
        ("경사", ["", "1/30"]),
        ("편심(mm)", ["0", "120"]),
        ("eccentricity (mm)", ["0", "120"]),
        ("압축강도(MPa)", ["80", "80"]),
    ] {
        let (status, words) = with(head, cells, "en");
        assert!(
            status == 2
                && words.contains("is no column of blocks")
                && words.contains("write the list in the project file"),
            "{words}"
        );
        assert!(
            with(head, cells, "ko").1.contains("프로젝트 파일에 목록을 적고"),
            "{head}"
        );
    }
    let (status, words) = with("무게(kN)", ["13", "4.5"], "en");
    assert!(
        status == 0
            && words.contains("PROBABLY A SLIP")
            && words.contains("does not use the numbers of 무게(kN)"),
        "{words}"
    );
    for (head, cells) in [
        ("비고", ["깨짐", ""]),
        ("번호", ["2", "1"]),
        ("수량", ["1", "1"]),
        ("편심(mm)", ["0", "0"]),
    ] {
        let (status, words) = with(head, cells, "en");
        assert!(status == 0 && !words.contains("SLIP"), "{words}");
    }
}

#[test]
fn refuses_storeys_that_begin_with_the_top_by_their_names() {
    let gate = |[first, second]: [&str; 2], more: &str| {
        format!(
            "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = {{ length = \"mm\", mass = \"t\", stiffness = \"kN/mm\" }}\n{more}\
             storeys = [{{ name = \"{first}\", mass = 52, height = 3600 }}, {{ name = \"{second}\", mass = 38, height = 4200 }}]\n\
             [direction.x]\nstiffness = [4.0, 6.0]\n"
        )
    };
    for names in [["2층", "1층"], ["상층", "하층"], ["upper", "lower"]] {
        let (status, words) = said("storeys-top-first", &gate(names, ""), "check project.toml");
        let why = "by their names the list begins with the top";
        assert!(
            status == 2 && words.contains(why) && words.contains("allow"),
            "{words}"
        );
        let meant = gate(names, "allow = [\"storeys\"]\n");
        let (status, words) = said("storeys-meant", &meant, "check project.toml");
        assert_eq!(status, 0, "{words}");
        let [upper, lower] = names;
        let (status, words) = said("storeys-lowest", &gate([lower, upper], ""), "check project.toml");
        assert_eq!(status, 0, "{words}");
    }
}

#[test]
fn holds_axial_forces_far_below_the_weight_are_named_in_the_short_answer() {
    let gate = "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = { length = \"m\", force = \"kN\", mass = \"t\", stiffness = \"kN/mm\" }\n\
                axial = \"storey\"\nstoreys = [{ mass = 38, height = 4.2, axial_force = 200 }, { mass = 52, height = 3.6, axial_force = 110 }]\n\
                [direction.x]\nstiffness = [6.0, 4.0]\n";
    let (status, words) = said("light-axial", gate, "check project.toml");
    assert_eq!(status, 0, "{words}");
    // 90 kN of 372.7 kN, and 110 kN of 509.9 kN
    for level in [
        "Level 1 loads its storey with only 0.24 times",
        "Level 2 loads its storey with only 0.22 times",
    ] {
        assert!(
            words.contains(level) && words.contains("P-delta is understated"),
            "{words}"
        );
    }
}

#[test]
fn refuses_a_list_that_begins_with_the_top_by_its_names() {
    let stones = |[first, second, third]: [&str; 3]| {
        STONES.split("blocks").next().unwrap().to_owned()
            + &format!(
                "blocks = [{{ name = \"{first}\", width = 1.2, height = 0.3 }}, {{ name = \"{second}\", width = 0.6, height = 1.2 }}, \
                 {{ name = \"{third}\", width = 1.5, height = 0.4 }}]\n"
            )
    };
    for names in [["roof", "body", "base"], ["1층 옥개석", "1층 탑신", "기단"]] {
        let (status, words) = said("top-first", &stones(names), "check project.toml");
        assert!(
            status == 2
                && words.contains("by their names the list begins with the top")
                && words.contains("allow"),
            "{words}"
        );
        let allowed = stones(names).replace("density", "allow = [\"blocks\"]\ndensity");
        let (status, words) = said("top-first-meant", &allowed, "check project.toml");
        assert_eq!(status, 0, "{words}");
    }
    let (status, words) = said(
        "base-first",
        &stones(["base", "body", "roof"]),
        "check project.toml",
    );
    assert_eq!(status, 0, "{words}");
}

#[test]
fn holds_frequencies_in_another_unit_are_asked_about_and_differences_have_a_size() {
    let surveys = |before: &str, after: &str| {
        format!(
            "schema = 1\nkind = \"survey\"\nname = \"a\"\n[survey.2020-05-01]\ntemperature_c = 15\nfrequencies.x = {before}\n\
             [survey.2024-05-01]\ntemperature_c = 15\nfrequencies.x = {after}\n"
        )
    };
    // (2.6 / 2.95)^2 = 0.777
    let (_, words) = said(
        "no-deviations",
        &surveys("[2.95]", "[2.60]"),
        "compare project.toml",
    );
    assert!(words.contains("2.950 Hz −11.9 % (−22 % of stiffness)"), "{words}");
    for (after, says) in [
        ("[1.475, 4.05]", "all 2 frequencies are 0.500 times"),
        ("[18.535, 50.89]", "angular frequencies (rad/s)"),
        ("[0.4695, 1.2892]", "angular frequencies (rad/s)"),
        ("[0.1235, 0.339]", "periods (s)"),
    ] {
        let (_, words) = said(
            "one-factor",
            &surveys("[2.95, 8.1]", after),
            "compare project.toml",
        );
        assert!(
            words.contains("PROBABLY A SLIP") && words.contains(says),
            "{words}"
        );
        assert!(!words.contains("if it is the same mode"), "{words}");
    }
}

#[test]
fn holds_exchanged_directions_and_another_unit_of_tilt_are_asked_about_over_years() {
    let scratch = Scratch::new("years-slips");
    let text = "schema = 1\nkind = \"survey\"\nname = \"a\"\nsurveys = { file = \"s.csv\" }\n[watch]\ntilt_limit = \"1/70\"\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let off = [
        0.4, -0.7, 0.1, 0.9, -0.5, -0.2, 0.6, -0.8, 0.3, -0.4, 0.8, -0.1, -0.6, 0.2,
    ];
    let watched = |is_exchanged: bool, of_tilt: f64| {
        let mut table = "date,temperature (°C),frequency x (Hz),frequency y (Hz),tilt x (mm/m)\n".to_owned();
        for (i, off) in off.iter().enumerate() {
            let warm = f64::from(u8::from(i % 2 == 0));
            let temperature = 6.0 + 14.0 * warm + 2.0 * off;
            let weather = 1.0 - 0.0008 * (temperature - 13.0);
            let mut hz = [
                2.95 * weather * (1.0 + 0.0006 * off),
                3.12 * weather * (1.0 - 0.0005 * off),
            ];
            let is_late = i >= 10;
            if is_exchanged && is_late {
                hz.reverse();
            }
            let tilt = (10.0 + 0.08 * f64::from(u8::try_from(i).unwrap()) + 0.05 * off)
                * if is_late { of_tilt } else { 1.0 };
            let month = 5 + 6 * (i % 2);
            writeln!(
                table,
                "{}-{month:02}-03,{temperature:.1},{:.4},{:.4},{tilt:.3}",
                2012 + i / 2,
                hz[0],
                hz[1]
            )
            .unwrap();
        }
        fs::write(scratch.path().join("s.csv"), table).unwrap();
        let answer = scratch.briefly("watch project.toml");
        format!("{}{}", answer.words(), answer.stderr)
    };
    let words = watched(true, 1.0);
    assert!(
        words.contains(
            "PROBABLY A SLIP: since 2017-05-03 the modes along x and y have each other's frequency"
        ),
        "{words}"
    );
    for (of_tilt, says) in [(0.1, "0.1 times"), (10.0, "10 times"), (0.01, "0.01 times")] {
        let words = watched(false, of_tilt);
        assert!(
            words.contains("PROBABLY A SLIP: the tilt along x became") && words.contains(says),
            "{of_tilt}: {words}"
        );
    }
    let words = watched(false, 1.0);
    assert!(
        !words.contains("SLIP") && !words.contains("each other's"),
        "{words}"
    );
}

#[test]
fn refuses_a_tilted_stone_in_its_bed_by_its_tilt() {
    let tilted = STONES.replace("height = 0.5 }", "height = 0.5, tilt = { x = \"1/10\" } }");
    let (status, words) = said("tilted-stone", &tilted, "check project.toml");
    assert!(
        status == 2 && words.contains("blocks[1].tilt.x = 1/10 presses an edge"),
        "{words}"
    );
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
        format!(
            "{{ name = \"{name}\", width = 0.3, depth = 0.3, height = 1.0, on = \"ground\", at = [{x}, {y}] }}, "
        )
    };
    let blocks = leg("a", -0.6, -0.3) + &leg("b", 0.6, -0.3) + &leg("c", 0.0, 0.3);
    let text = format!(
        "schema = 1\nkind = \"stack\"\nname = \"a\"\ndensity = 2600\njoint = {{ friction = 0.6 }}\n\
         blocks = [{blocks}{{ name = \"slab\", width = 1.6, depth = 1.0, height = 0.2, at = [0, 0], on = [\"a\", \"b\", \"c\"] }}]\n"
    );
    let (_, words) = said("three-legs", &text, "check project.toml");
    assert!(words.contains("towards"), "{words}");
}
