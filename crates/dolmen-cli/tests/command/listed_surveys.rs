// SOURCE     The shipped examples with several surveys, and a frame whose two surveys have different tilts.
// GOAL       An answer does not depend on the order in which the file lists its surveys.
// TOLERANCE  none: the same words and numbers.

use super::verbs::{Answer, Scratch};
use std::fs;

/// The file with its `[survey.NAME]` tables, each with its own subtables, in reverse order.
fn reversed(text: &str) -> String {
    let of = |line: &str| {
        let name = line.trim_start_matches('[').strip_prefix("survey.")?;
        let end = name.find(['.', ']']).unwrap_or(name.len());
        Some(name[..end].to_owned())
    };
    let mut parts: Vec<(Option<String>, String)> = vec![(None, String::new())];
    for line in text.lines() {
        if line.starts_with('[')
            && parts
                .last()
                .is_none_or(|(name, _)| of(line).is_none() || *name != of(line))
        {
            parts.push((of(line), String::new()));
        }
        let (_, part) = parts.last_mut().unwrap();
        *part += line;
        *part += "\n";
    }
    let surveys: Vec<&String> = parts
        .iter()
        .filter(|(name, _)| name.is_some())
        .map(|(_, part)| part)
        .collect();
    assert!(surveys.len() > 1, "{text}");
    let mut next = surveys.into_iter().rev();
    let each = parts.iter().map(|(name, part)| match name {
        Some(_) => next.next().unwrap().as_str(),
        None => part.as_str(),
    });
    each.collect()
}

/// The words of an answer without the lines of the file that they name.
fn words(answer: &Answer) -> String {
    let text = answer.words();
    let mut parts = text.split("line ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |all, part| {
        all + "line " + part.trim_start_matches(|sign: char| sign.is_ascii_digit())
    })
}

#[test]
fn holds_answers_do_not_depend_on_the_order_in_which_surveys_are_listed() {
    let scratch = Scratch::with_examples("listed-surveys");
    let frame = "schema = 1\nkind = \"frame\"\nname = \"gate\"\nunits = { mass = \"t\", force = \"kN\", stiffness = \"kN/mm\" }\n\
        storeys = [{ name = \"hall\", mass = 60, height = 5 }, { name = \"loft\", mass = 40, height = 4 }]\n\
        direction.x = { stiffness = [8, 5], damping_ratio = 0.02 }\ndirection.y = { stiffness = [8, 5], damping_ratio = 0.02 }\n\
        [survey.2015-05-01]\nfrequencies.x = [1.2]\ntilt = { x = \"1/60\" }\n\
        [survey.2024-05-01]\nfrequencies.x = [1.0]\ntilt = { x = \"1/80\" }\nmade_up = true\n\
        [survey.2020-05-01]\nfrequencies.x = [1.1]\ntilt = { x = \"1/70\" }\nmade_up = true\n";
    // one without a date has no part in which is the latest, wherever it stands
    let tower = "schema = 1\nkind = \"building\"\nname = \"tower\"\nunits = { length = \"m\", mass = \"t\", stiffness = \"N/mm\" }\n\
        floors = [{ mass = 100, sides = [12, 8], height = 30, stiffness = { x = 9000, y = 7000, rotation = \"2e8 N*m\", centre = [0, 0] } }]\n\
        damping = { ratio = 0.02 }\n\
        [survey.2015-05-01]\ntilt = { x = \"1/60\" }\n\
        [survey.2024-05-01]\ntilt = { x = \"1/70\" }\n\
        [survey.first]\ntilt = { x = \"1/90\" }\n";
    for (name, text) in [("gate", frame), ("tower", tower)] {
        let folder = scratch.path().join("examples").join(name);
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("project.toml"), text).unwrap();
    }
    for (verb, example) in [
        ("check", "gate"),
        ("simulate --motion el-centro-1940-ns --duration 2", "gate"),
        ("compare", "gate"),
        ("check", "tower"),
        ("simulate --motion el-centro-1940-ns --duration 2", "tower"),
        ("check", "inspected_flagpole"),
        ("check", "damaged_pier"),
        ("compare", "gate_through_the_seasons"),
        ("watch", "gate_through_the_seasons"),
    ] {
        let path = scratch.path().join(format!("examples/{example}/project.toml"));
        let text = fs::read_to_string(&path).unwrap();
        let (verb, rest) = verb.split_once(' ').unwrap_or((verb, ""));
        let command = format!("{verb} examples/{example} {rest}");
        let first = scratch.dolmen(&command);
        fs::write(&path, reversed(&text)).unwrap();
        let other = scratch.dolmen(&command);
        fs::write(&path, text).unwrap();
        assert!(!first.stdout.is_empty(), "{command}: {}", first.stderr);
        assert_eq!(
            (words(&other), other.status),
            (words(&first), first.status),
            "{command}"
        );
    }
}
