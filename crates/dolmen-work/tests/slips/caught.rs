//! SOURCE: `data/slips.csv`, common mistakes of units and habits, as edits of the shipped examples. GOAL:
//! nine of ten are refused, or named in a warning at the beginning of the answer.

use crate::edit::{Slip, edited};
use crate::folder::{Folder, root};
use dolmen_project::{MotionSource, WarningKind};
use dolmen_words::Language;
use dolmen_work::motion::{GivenFile, MotionRequest};
use dolmen_work::{
    CheckOptions, IdentifyOptions, Opened, Silent, SimulateOptions, check, identify, prepare, told,
};
use std::collections::BTreeMap;
use std::path::Path;

fn slips() -> Vec<Slip> {
    let mut table = csv::Reader::from_path(root().join("data/slips.csv")).unwrap();
    let rows = table.records().map(|row| {
        let row = row.unwrap();
        let cell = |at: usize| row[at].to_owned();
        Slip {
            class: cell(0),
            file: cell(1),
            edit: cell(2),
            find: cell(3),
            replace: cell(4),
            says: cell(5),
        }
    });
    rows.collect()
}

/// El Centro as a file without unit and times, its numbers multiplied.
fn el_centro(factor: f64) -> Vec<u8> {
    let path = root().join("data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let values = text
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    let lines: Vec<String> = values.map(|value| format!("{}", value * factor)).collect();
    format!("acceleration\n{}\n", lines.join("\n")).into_bytes()
}

fn request(slip: &Slip) -> MotionRequest {
    let mut request = MotionRequest::default();
    for word in slip.find.split(';').chain(slip.replace.split(';')) {
        let (flag, value) = word.split_once('=').unwrap();
        match flag {
            "motion" => request.name = Some(value.to_owned()),
            "file" => {
                let bytes = el_centro(value.parse().unwrap());
                request.files = vec![GivenFile {
                    component: None,
                    name: "motion.csv".to_owned(),
                    bytes,
                }];
                request.sample_step_s = Some(0.02);
            }
            "unit" => request.unit = Some(value.to_owned()),
            "sample-step" => request.sample_step_s = value.parse().ok(),
            "scale" => request.scale = value.parse().ok(),
            "peak" => request.peak = Some(value.to_owned()),
            "turn" => request.turn_deg = value.parse().ok(),
            other => panic!("flag {other}"),
        }
    }
    request
}

/// Everything that Dolmen reports about a project with a mistake.
fn said(slip: &Slip) -> String {
    let path = root().join(&slip.file);
    let text = edited(&std::fs::read_to_string(&path).unwrap(), slip);
    let files = Folder(path.parent().unwrap_or(Path::new("")).to_owned());
    said_of(slip, text, &files).unwrap_or_else(|why| format!("{} error", told(&why)))
}

fn said_of(slip: &Slip, text: String, files: &Folder) -> Result<String, dolmen_work::WorkError> {
    let opened = Opened::read(text, slip.file.clone(), files)?;
    let project = &opened.project;
    let mut said = String::new();
    let variants = project
        .variants
        .iter()
        .flat_map(|variant| &variant.project.warnings);
    for warning in project.warnings.iter().chain(variants) {
        if warning.kind == WarningKind::Doubtful {
            said += &format!("{}: {}\n", warning.path, warning.message.text(Language::English));
        }
    }
    let motion = match (slip.edit.as_str(), slip.class.as_str(), project.motions.first()) {
        ("flag", ..) => Some(request(slip)),
        (_, "motion", Some(motion)) => Some(MotionRequest::named(&motion.name)),
        _ => None,
    };
    if let Some(motion) = motion {
        let options = SimulateOptions {
            motion,
            ..SimulateOptions::default()
        };
        let prepared = prepare(&opened, &options, files)?;
        for doubt in prepared.motion().unwrap().doubts() {
            said += &format!("motion: {doubt:?}\n");
        }
    }
    if slip.class == "sensors and records" {
        for survey in identify(&opened, &IdentifyOptions::default(), files, &Silent)?.surveys {
            for doubt in survey.records.iter().flat_map(|record| &record.doubts) {
                said += &format!("{doubt:?}\n");
            }
        }
    }
    if ["contradict", "measured frequenc"].contains(&slip.says.as_str()) {
        let all = CheckOptions {
            beside_the_verdict: true,
            ..CheckOptions::default()
        };
        let state = check(&opened, &all)?.state.unwrap();
        said += &format!("contradictions: {:?}\n", state.contradictions);
    }
    Ok(said)
}

#[test]
fn holds_nine_of_ten_slips_are_caught_as_the_book_says() {
    let mut classes: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    let (mut missed, slips) = (Vec::new(), slips());
    for slip in &slips {
        let is_caught = said(slip).to_lowercase().contains(&slip.says);
        let count = classes.entry(slip.class.clone()).or_default();
        count[0] += usize::from(is_caught);
        count[1] += 1;
        if !is_caught {
            missed.push(format!(
                "- `{}`: `{}` → `{}`\n",
                slip.file, slip.find, slip.replace
            ));
        }
    }
    let (caught, all) = (slips.len() - missed.len(), slips.len());
    let rows: String = classes
        .iter()
        .map(|(class, [caught, all])| format!("| {class} | {caught} of {all} |\n"))
        .collect();
    let table = format!("{rows}| **all** | **{caught} of {all}** |\n");
    let missed = missed.concat();
    assert!(all >= 200 && 10 * caught >= 9 * all, "{table}\n{missed}");
    let book = std::fs::read_to_string(root().join("docs/notices.md")).unwrap();
    assert!(
        book.contains(&table) && book.contains(&missed),
        "docs/notices.md must say\n{table}\n{missed}"
    );
}

#[test]
fn holds_no_example_is_doubted() {
    let examples = root().join("examples");
    let folders = std::fs::read_dir(examples)
        .unwrap()
        .map(|folder| folder.unwrap().path());
    let listed = folders.flat_map(|folder| std::fs::read_dir(folder).into_iter().flatten());
    let mut files: Vec<_> = listed.map(|file| file.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "toml"));
    assert!(files.len() > 20, "{}", files.len());
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let folder = Folder(path.parent().unwrap().to_owned());
        let opened = Opened::read(text, path.display().to_string(), &folder).unwrap();
        let doubts = opened
            .project
            .warnings
            .iter()
            .filter(|warning| warning.kind == WarningKind::Doubtful);
        assert_eq!(
            doubts
                .map(|of| of.message.text(Language::English))
                .collect::<Vec<_>>(),
            [""; 0],
            "{}",
            opened.file
        );
        // motions that have to be downloaded are missing
        for part in opened
            .project
            .motions
            .iter()
            .filter(|part| matches!(part.from, MotionSource::BuiltIn(_)))
        {
            let options = SimulateOptions {
                motion: MotionRequest::named(&part.name),
                ..SimulateOptions::default()
            };
            let prepared = prepare(&opened, &options, &folder).unwrap();
            assert_eq!(
                prepared.motion().unwrap().doubts(),
                [],
                "{} {}",
                opened.file,
                part.name
            );
        }
        for survey in identify(&opened, &IdentifyOptions::default(), &folder, &Silent)
            .unwrap()
            .surveys
        {
            let doubts = survey.records.iter().flat_map(|record| &record.doubts);
            assert_eq!(doubts.count(), 0, "{}", opened.file);
        }
    }
}
