// SOURCE     what people write: small letters, Roman numerals as signs or digits, curly quotes, decimal commas, records of unequal length.
// GOAL       Unambiguous input is accepted; ambiguous input is refused with the fix.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fs;

const TOWER: &str = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = { friction = 0.7 }\n\
    blocks = [{ name = \"a\", width = 1, height = 1 }, { name = \"b\", width = 0.8, height = 1.2 }]\n";

fn site(zone: &str, soil: &str) -> String {
    format!(
        "{TOWER}[site]\ncode = \"kds 17 10 00\"\nzone = \"{zone}\"\nsoil = \"{soil}\"\nreturn_period_years = 1000\n"
    )
}

#[test]
fn holds_a_word_that_can_mean_one_thing_only_is_read_as_that() {
    let scratch = Scratch::new("habits-words");
    let answers: Vec<String> = [("II", "S2"), ("2", "s2"), ("Ⅱ", "S2"), ("ii", "s2")]
        .iter()
        .map(|(zone, soil)| {
            fs::write(scratch.path().join("p.toml"), site(zone, soil)).unwrap();
            let answer = scratch.dolmen("check p.toml");
            assert!(answer.status < 2, "{zone} {soil}: {}", answer.stderr);
            answer.stdout
        })
        .collect();
    assert!(answers.iter().all(|answer| *answer == answers[0]));
    fs::write(scratch.path().join("p.toml"), site("3", "S2")).unwrap();
    let answer = scratch.dolmen("check p.toml");
    assert!(
        answer.status == 2 && answer.stderr.contains("site.zone = \"3\" is not known"),
        "{}",
        answer.stderr
    );
}

#[test]
fn refuses_curly_quotes_and_decimal_commas_with_the_fix() {
    let scratch = Scratch::new("habits-toml");
    for (from, to, said) in [
        ("\"Tower\"", "“Tower”", "curly quotes are no quotes of TOML"),
        (
            "density = 2600",
            "density = 2600,5",
            "a decimal comma? Write 2600.5",
        ),
    ] {
        fs::write(scratch.path().join("p.toml"), TOWER.replace(from, to)).unwrap();
        let answer = scratch.dolmen("check p.toml");
        assert_eq!(answer.status, 2, "{}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}

#[test]
fn holds_files_of_a_motion_that_differ_in_length_are_cut_where_the_file_says_so() {
    let scratch = Scratch::new("habits-lengths");
    let at2 = |samples: usize| {
        let mut text = format!(
            "PEER NGA STRONG MOTION DATABASE RECORD\nA TEST\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {samples}, DT= .0100 SEC\n"
        );
        for i in 0..samples {
            let value = 0.1 * (0.3 * i as f64).sin();
            text += &format!("  {value:.7E}");
            if i % 5 == 4 {
                text += "\n";
            }
        }
        text + "\n"
    };
    fs::write(scratch.path().join("x.at2"), at2(799)).unwrap();
    fs::write(scratch.path().join("y.at2"), at2(797)).unwrap();
    let text =
        |more: &str| format!("{TOWER}[motion.pair]\nfiles = {{ x = \"x.at2\", y = \"y.at2\" }}\n{more}");
    fs::write(scratch.path().join("p.toml"), text("")).unwrap();
    let refused = scratch.dolmen("simulate p.toml --motion pair --json");
    assert_eq!(refused.status, 2, "{}", refused.stdout);
    assert!(refused.stderr.contains("shortest"), "{}", refused.stderr);
    fs::write(scratch.path().join("p.toml"), text("lengths = \"shortest\"\n")).unwrap();
    let cut = scratch.dolmen("simulate p.toml --motion pair --json");
    assert!(cut.status < 2, "{}", cut.stderr);
}

#[test]
fn holds_a_direction_whose_modes_all_twist_is_said_and_another_convention_alarms_nobody() {
    let scratch = Scratch::new("habits-twist");
    let gate = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }\naxial = \"storey\"\n\
        storeys = [{ mass = 290, height = 5.84, axial_force = 5919 }, { mass = 314, height = 7.69, axial_force = 3077 }]\n\
        [direction.weak]\nstiffness = \"unknown\"\n[survey.now]\n[[survey.now.modes.weak]]\nfrequency = 1.3\nkind = \"torsion\"\n";
    fs::write(scratch.path().join("p.toml"), gate).unwrap();
    let answer = scratch.briefly("identify p.toml");
    assert!(
        answer
            .words()
            .contains("No stiffness is sought in direction weak: every mode measured there twists"),
        "{}{}",
        answer.stdout,
        answer.stderr
    );
    let gate = Scratch::with_examples("habits-convention");
    let answer = gate.briefly("identify examples/heunginjimun_gate");
    assert!(!answer.stdout.contains('✕'), "{}", answer.stdout);
}
