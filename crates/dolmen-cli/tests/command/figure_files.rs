//! The figures of a report as files: each as SVG and PNG, named by its number, and its data in full precision.

use super::verbs::Scratch;
use std::fs;
use std::path::Path;

fn names(folder: &Path) -> Vec<String> {
    let each = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    let mut names: Vec<String> = each.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

/// The columns of a table of numbers by their headers.
fn columns(file: &Path) -> Vec<(String, Vec<f64>)> {
    let text = fs::read_to_string(file).unwrap();
    let mut lines = text.trim_start_matches('\u{feff}').lines();
    let heads: Vec<String> = lines.next().unwrap().split(',').map(str::to_owned).collect();
    let rows: Vec<Vec<f64>> = lines
        .map(|line| {
            line.split(',')
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect();
    let column = |at: usize| {
        rows.iter()
            .map(|row| row.get(at).copied().unwrap_or(f64::NAN))
            .collect()
    };
    heads
        .into_iter()
        .enumerate()
        .map(|(at, head)| (head, column(at)))
        .collect()
}

#[test]
fn holds_each_figure_of_the_page_is_a_file_under_its_number() {
    let scratch = Scratch::with_examples("figure_files");
    for (example, flags) in [
        ("three_storey_pagoda", "--motion el-centro-1940-ns --keep-first 2"),
        ("gate_through_the_seasons", ""),
    ] {
        let answer = scratch.dolmen(&format!(
            "report examples/{example} {flags} -o {example}.html --figures {example}"
        ));
        assert!(answer.status < 2, "{}", answer.stderr);
        let page = fs::read_to_string(scratch.path().join(format!("{example}.html"))).unwrap();
        let folder = scratch.path().join(example);
        let there = names(&folder);
        let mut drawn = 0;
        for caption in page.split("<figcaption><span class=\"no\">Figure ").skip(1) {
            let number = caption.split('<').next().unwrap();
            for ending in ["svg", "png", "csv"] {
                let name = format!("figure-{number}.{ending}");
                assert!(there.contains(&name), "{example}: no {name} in {there:?}");
            }
            let numbers = fs::read_to_string(folder.join(format!("figure-{number}.csv"))).unwrap();
            assert!(
                numbers.lines().count() > 1,
                "{example}, figure {number}: {numbers}"
            );
            drawn += 1;
        }
        assert!(drawn > 0, "{example}: no figure");
        assert_eq!(there.iter().filter(|name| name.ends_with(".png")).count(), drawn);
        let list = fs::read_to_string(folder.join("figures.csv")).unwrap();
        assert_eq!(list.lines().count(), drawn + 1, "{list}");
        let png = fs::read(folder.join(there.iter().find(|name| name.ends_with(".png")).unwrap())).unwrap();
        assert!(png.starts_with(b"\x89PNG"));
    }
}

#[test]
fn agrees_the_numbers_of_figures_are_those_of_the_simulation() {
    let scratch = Scratch::with_examples("figure_numbers");
    let run = "examples/three_storey_pagoda --motion el-centro-1940-ns --keep-first 3";
    let reported = scratch.dolmen(&format!("report {run} -o r.html --figures figures"));
    assert!(reported.status < 2, "{}", reported.stderr);
    let simulated = scratch.dolmen(&format!("simulate {run} -o run"));
    assert!(simulated.status < 2, "{}", simulated.stderr);
    let joints = columns(&scratch.path().join("run/joints.csv"));
    let folder = scratch.path().join("figures");
    let mut compared = 0;
    for name in names(&folder) {
        if !(name.starts_with("figure-") && name.ends_with(".csv")) {
            continue;
        }
        let table = columns(&folder.join(&name));
        for (head, shown) in &table {
            let Some(joint) = head
                .strip_prefix("Opening: ")
                .and_then(|rest| rest.strip_suffix(" (mm)"))
            else {
                continue;
            };
            let wanted = format!("{}: opening_m", joint.replacen(" / ", " on ", 1));
            let (_, metres) = joints.iter().find(|(head, _)| *head == wanted).unwrap();
            assert_eq!(table[0].1, joints[0].1, "times");
            assert_eq!(shown.len(), metres.len(), "{head}");
            for (shown, metres) in shown.iter().zip(metres) {
                assert!((shown - 1e3 * metres).abs() <= 1e-12 * shown.abs(), "{head}");
            }
            compared += 1;
        }
    }
    assert!(compared > 2, "{compared} joints");
}

#[test]
fn holds_a_figure_that_somebody_changed_stays_and_several_projects_have_folders() {
    let scratch = Scratch::with_examples("figure_folders");
    let run = "report examples/heunginjimun_gate examples/twenty_storeys --samples 0 -o all.html --figures all --language ko";
    assert!(scratch.dolmen(run).status < 2);
    let folders = names(&scratch.path().join("all"));
    let folders: Vec<&String> = folders.iter().filter(|name| !name.starts_with('.')).collect();
    assert_eq!(folders.len(), 2, "{folders:?}");
    assert!(
        folders[0].starts_with("1 ") && folders[1].starts_with("2 "),
        "{folders:?}"
    );
    let csv = scratch.path().join("all").join(folders[0]).join("figures.csv");
    fs::write(&csv, "mine").unwrap();
    let again = scratch.dolmen(run);
    assert_eq!(again.status, 2);
    assert_eq!(fs::read_to_string(&csv).unwrap(), "mine");
}
