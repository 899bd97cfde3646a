// SOURCE     Studies that a stranger ran, and whose answers he took for those of the structure as it is.
// GOAL       An answer says of which variant, values and damage it is; inputs that cannot act and states that the motion before reached are
//            named as such; merged shards stay.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fs;

/// Two stones that lean, with a bed that an inspection found smaller.
const POST: &str = r#"
schema = 1
kind = "chain"
name = "post"
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
damping_ratio = 0.03
links = [
 { name = "lower", weight = 30, length = 3, centroid = 1.5, breadth = 0.6, bed_width = 0.6 },
 { name = "upper", weight = 20, length = 3, centroid = 1.5, breadth = 0.5, bed_width = 0.5 },
]
joints = [{ stiffness = { value = 3000, cov = 0.2, source = "assumed" } }, { stiffness = 1500 }]
wind = { speed = "10 m/s", means = "gust", force_coefficient = 1.2 }
[survey.2024-01-01]
tilt = { x = "1/100" }
[[survey.2024-01-01.inspections]]
part = "lower"
what = "open joint"
model = { bed_lost = 0.3, side = "x+" }
[motion.a]
built_in = "el-centro-1940-ns"
[variant.sound]
as_inspected = "none"
[variant.plumb]
as_surveyed = "none"
"#;

fn studied(name: &str, study: &str) -> String {
    let scratch = Scratch::new(name);
    let text = format!("{POST}[study.s]\nmotions = [\"a\"]\nrest_s = 1\n{study}\n");
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.briefly("study .");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    answer.words()
}

#[test]
fn holds_a_study_says_of_which_variant_values_and_damage_its_runs_are() {
    let words = studied("study-sound", "variants = [\"sound\"]\npeak = [\"0.05 g\"]");
    assert!(words.contains("All of this is of the variant: sound."), "{words}");
    assert!(!words.contains("has the damage of inspections"), "{words}");

    let words = studied(
        "study-both",
        "variants = [\"sound\", \"plumb\"]\npeak = [\"0.05 g\"]",
    );
    for said in [
        "has the damage of inspections in the runs of variant plumb only: bed below “lower” less 30 %",
        "in the runs of variant plumb only: the runs start plumb",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }

    // a peak of 1 g upsets both
    let words = studied(
        "study-fallen",
        "variants = [\"sound\", \"plumb\"]\npeak = [\"1 g\"]\nrefine = 0",
    );
    assert!(
        words.contains("By variant, the weakest at which it reaches “falls”: sound"),
        "{words}"
    );

    let words = studied(
        "study-set",
        "set = { \"joints[2].stiffness\" = 1200 }\npeak = [\"0.05 g\"]",
    );
    assert!(
        words.contains(
            "values that the study sets in place of those of the file: joints[2].stiffness = 1200 kN·m/rad."
        ),
        "{words}"
    );
    assert!(
        words.contains("The model has the damage of inspections: bed"),
        "{words}"
    );

    let words = studied(
        "study-surveyed",
        "vary = { \"as_surveyed\" = [\"none\", \"2024-01-01\"] }\npeak = [\"0.05 g\"]",
    );
    assert!(
        words.contains("in the runs of as_surveyed = none only: the runs start plumb"),
        "{words}"
    );
}

#[test]
fn holds_an_input_that_cannot_act_in_the_runs_is_called_so() {
    for (name, vary, acts) in [
        ("study-wind", "\"wind.speed\" = [20, 30]", false),
        ("study-scale", "\"motion.a.scale\" = [1, 3]", false),
        ("study-joint", "\"joints[2].stiffness\" = [1400, 1500]", true),
    ] {
        let words = studied(name, &format!("vary = {{ {vary} }}\npeak = [\"0.05 g\"]"));
        let input = vary.split('"').nth(1).unwrap();
        let said = format!("{input} does not act in these runs");
        assert_eq!(words.contains(&said), !acts, "{words}");
        // nothing falls at 0.05 g, so that no trend can be seen
        assert_eq!(
            words.contains("cannot be said: none of the scans"),
            acts,
            "{words}"
        );
    }
}

#[test]
fn exact_a_number_of_a_study_is_shown_with_the_unit_of_its_key() {
    let scratch = Scratch::new("study-units");
    let study = "[study.s]\nmotions = [\"a\"]\nrest_s = 1\npeak = [\"0.05 g\"]\n\
        set = { \"links[1].length\" = 2.9, \"wind.speed\" = \"11 m/s\" }\n\
        vary = { \"joints[2].stiffness\" = [1400, \"1.6 MN*m/rad\"] }\n";
    fs::write(scratch.path().join("project.toml"), format!("{POST}{study}")).unwrap();
    let answer = scratch.dolmen("study .");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let said = "links[1].length = 2.9 m and wind.speed = 11 m/s.";
    assert!(answer.words().contains(said), "{}", answer.words());
    // a bare number stands for the unit of the file's `units`
    for line in answer
        .stdout
        .lines()
        .filter(|line| line.contains("joints[2].stiffness = 1400"))
    {
        let next = answer.stdout.lines().skip_while(|own| *own != line).nth(1);
        assert_eq!(next.map(str::trim), Some("kN·m/rad"), "{}", answer.stdout);
    }
    let korean = scratch.dolmen("study . --language ko").stdout;
    assert!(korean.contains("kN·m/rad"), "{korean}");
    let figures = fs::read_dir(scratch.path().join("studies/s")).unwrap();
    let figures = figures.filter_map(|file| fs::read_to_string(file.unwrap().path()).ok());
    let growth = figures.filter(|text| {
        let shown = ["1400 kN·m/rad", "1.6 MN*m/rad"];
        text.contains("<svg") && shown.iter().all(|shown| text.contains(shown))
    });
    assert!(growth.count() > 0);
}

#[test]
fn holds_a_drawn_input_is_shown_in_the_unit_of_the_file() {
    let scratch = Scratch::new("study-drawn");
    let study = "[study.s]\nmotions = [\"a\"]\nrest_s = 1\nsamples = 2\npeak = [\"0.05 g\"]\n";
    fs::write(scratch.path().join("project.toml"), format!("{POST}{study}")).unwrap();
    let stopped = scratch.dolmen("study . --shard 1/2");
    assert_eq!(stopped.status, 0, "{}{}", stopped.stdout, stopped.stderr);
    let missing = scratch.dolmen("study missing .").words();
    let (_, shown) = missing
        .split_once("joints[1].stiffness = ")
        .unwrap_or_else(|| panic!("{missing}"));
    let (number, rest) = shown.split_once(' ').unwrap();
    // 3000 kN·m/rad on the half of the bed that is left, with a scatter of 20 %
    let number: f64 = number.parse().unwrap_or_else(|_| panic!("{missing}"));
    assert!(
        rest.starts_with("kN·m/rad") && (300.0..3000.0).contains(&number),
        "{missing}"
    );
}

#[test]
fn holds_a_state_of_the_motion_before_is_not_said_to_begin_after_it() {
    let scratch = Scratch::new("study-after");
    let text = "schema = 1\nkind = \"stack\"\nname = \"slider\"\ndensity = 2600\njoint = { friction = 0.1 }\n\
        blocks = [{ name = \"b\", width = 2, height = 0.3 }]\n[motion.main]\nbuilt_in = \"el-centro-1940-ns\"\n\
        [study.s]\nafter = { motion = \"main\", peak = [\"0.5 g\"] }\nmotions = [\"main\"]\npeak = [\"0.15 g\"]\nlaw = \"rigid\"\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let words = scratch.briefly("study .").words();
    assert!(words.contains("DS1 already in main alone"), "{words}");
}

#[test]
fn holds_a_simulated_stack_says_of_which_variant_it_is() {
    let scratch = Scratch::new("simulated-variant");
    let text = "schema = 1\nkind = \"stack\"\nname = \"pillar\"\ndensity = 2500\njoint = { friction = 0.6 }\n\
        blocks = [{ name = \"p\", width = 0.6, height = 1.0 }]\n[variant.low]\njoint = { friction = 0.5 }\n\
        [motion.a]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let words = scratch
        .briefly("simulate . --motion a --law rigid --variant low")
        .words();
    assert!(words.contains("All of this is of the variant: low."), "{words}");
    let words = scratch.briefly("simulate . --motion a --law rigid").words();
    assert!(!words.contains("of the variant"), "{words}");
}

#[test]
fn holds_only_runs_with_the_identified_stiffness_say_that_it_is_identified() {
    let scratch = Scratch::new("identified-variant");
    let text = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\n\
        links = [{ name = \"shaft\", mass = \"2000 kg\", length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\n\
        joints = \"identified\"\ndamping_ratio = 0.02\n[variant.braced]\njoints = [{ stiffness = 3000 }]\n\
        [motion.a]\nbuilt_in = \"el-centro-1940-ns\"\npeak = \"0.05 g\"\n\
        [study.s]\nvariants = [\"braced\"]\nmotions = [\"a\"]\nscale = [1]\n\
        [survey.2026-04-02]\nfrequencies = { x = [{ value = 2.0, sd = 0.01, source = \"measured\" }] }\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    for (words, is_said) in [
        ("simulate . --motion a", true),
        ("simulate . --motion a --variant braced", false),
        ("study .", false),
    ] {
        let answer = scratch.briefly(words);
        let said = format!("{}{}", answer.words(), answer.stderr);
        assert_eq!(
            said.contains("is identified from survey"),
            is_said,
            "{words}: {said}"
        );
    }
}

#[test]
fn holds_a_rank_by_a_study_of_a_variant_says_so() {
    let scratch = Scratch::new("rank-variant");
    let study = "[study.s]\nvariants = [\"sound\"]\nset = { \"joints[2].stiffness\" = 1200 }\nrest_s = 1\nrefine = 1\n\
        artificial = { count = 6, duration_s = 3, strong_s = 1, rise_s = 1 }\npeak = [\"0.2 g\", \"0.5 g\", \"1 g\", \"2 g\"]\n";
    fs::write(scratch.path().join("project.toml"), format!("{POST}{study}")).unwrap();
    fs::write(
        scratch.path().join("list.csv"),
        "name,project,study\npole,project.toml,s\n",
    )
    .unwrap();
    scratch.briefly("study .");
    let words = scratch.briefly("rank list.csv --state falls").words();
    for said in [
        "pole: study s is of the variant sound, not of the structure as it is",
        "pole: study s is of values set in place of those of the file: joints[2].stiffness = 1200",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
}
