//! A study, as text: how its runs ended, capacities by value of each input, trends.

use super::Table;
use super::fragility::fragility_text;
use dolmen::assess::{AssessError, Direction, Reached, reached_quantile};
use dolmen_project::Scan;
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::study::{
    CapacityOf, LevelRow, ResponseMaps, Run, RunOutcome, SCANS_OF_TAILS, ScanVerdict, StudyAnswer, StudyKind,
    TrendAnswer, part_of_step,
};
use std::fmt::Write as _;

/// Everything that is printed of a study.
///
/// # Errors
/// As [`StudyAnswer::trends`].
pub fn study_text(answer: &StudyAnswer) -> Result<String, AssessError> {
    let mut out = heading(answer);
    out += &outcomes(answer);
    if answer.study.scan.is_none() {
        return Ok(out + &releases(answer));
    }
    out += &levels(answer);
    out += &growth(answer);
    out += &trends(answer, &answer.trends()?);
    out += &fragility_text(answer)?;
    Ok(out + &releases(answer))
}

fn heading(answer: &StudyAnswer) -> String {
    let study = &answer.study;
    let mut out = format!(
        "{}\n\nStudy \"{}\" of {}",
        answer.file,
        study.name,
        answer.name.english()
    );
    if let Some(title) = &study.title {
        let _ = write!(out, ": {}", title.english());
    }
    let count = |n: usize, word: &str| format!("{n} {word}{}", if n == 1 { "" } else { "s" });
    let _ = write!(out, "\n  {}", count(answer.cases.len(), "case"));
    if let Some(samples) = study.samples {
        let _ = write!(
            out,
            " ({samples} samples of each combination, seed {})",
            study.seed
        );
    }
    if let Some(scan) = &study.scan {
        let _ = write!(
            out,
            " × {} × {}",
            count(answer.motions.len(), "motion"),
            count(study.turns_rad.len(), "direction")
        );
        let (what, values, unit) = match scan {
            Scan::Scales(values) => ("scales", values.clone(), ""),
            Scan::Peaks(values) => (
                "peaks of the ground",
                values.iter().map(|peak| peak / answer.gravity_m_s2).collect(),
                " g",
            ),
        };
        match values.as_slice() {
            [] => {}
            [only] => {
                let _ = write!(out, ", {what} {}{unit}", significant(*only, 3));
            }
            [first, .., last] => {
                let _ = write!(
                    out,
                    ", {} {what} from {} to {}{unit}, the first fall to {} of a step",
                    values.len(),
                    significant(*first, 3),
                    significant(*last, 3),
                    part_of_step(study.refine)
                );
            }
        }
    }
    let _ = writeln!(out, "\n  {}", answer.method(Language::English));
    for note in &answer.notes {
        let _ = writeln!(out, "  note: {note}");
    }
    out
}

fn outcomes(answer: &StudyAnswer) -> String {
    if answer.study.scan.is_none() {
        return String::new();
    }
    let mut out = format!("  {} runs", answer.runs.len());
    for (outcome, count) in answer.outcomes() {
        let word = match (answer.kind, outcome) {
            (StudyKind::Frame, RunOutcome::Fell) => "beyond the drift limit",
            (StudyKind::Building, RunOutcome::Fell) => "beyond the last drift limit",
            (_, outcome) => outcome.word(),
        };
        let _ = write!(out, ", {count} {word}");
    }
    out.push('\n');
    if let Some((beyond, all, least)) = answer.beyond_room() {
        let _ = writeln!(
            out,
            "BEYOND ITS ROOM: in {beyond} of {all} runs a damper needs more room than it has, from {} g on: the runs do not have its stops, and are too good there",
            significant(least / answer.gravity_m_s2, 3)
        );
    }
    for (why, count) in answer.refusals() {
        let _ = writeln!(out, "  refused {count} ×: {why}");
    }
    if !answer.missing.is_empty() {
        let _ = writeln!(
            out,
            "\nNOT FINISHED: {} of {} scans are missing; the same command goes on from here. What follows is of the part that is done",
            answer.missing.len(),
            answer.jobs()
        );
    }
    out
}

/// An acceleration in g; "> " where it is only known to lie above.
fn in_g(answer: &StudyAnswer, value_m_s2: Option<Reached>) -> String {
    match value_m_s2 {
        Some(Reached::At(value)) => format!("{:.3}", value / answer.gravity_m_s2),
        Some(Reached::Above(value)) => format!("> {:.3}", value / answer.gravity_m_s2),
        None => "–".to_owned(),
    }
}

/// The same of a state that is reached at the least peak that was tried, or below.
fn begun_g(answer: &StudyAnswer, value_m_s2: Option<Reached>) -> String {
    const ROUNDING: f64 = 1e-9;
    let tried = answer.runs.iter().map(|run| run.peak_ground_acceleration_m_s2);
    let least = tried.fold(f64::INFINITY, f64::min);
    let begun = matches!(value_m_s2, Some(Reached::At(value)) if value <= least * (1.0 + ROUNDING));
    format!("{}{}", if begun { "≤ " } else { "" }, in_g(answer, value_m_s2))
}

fn levels(answer: &StudyAnswer) -> String {
    let levels = answer.levels();
    let states = answer.kind.states();
    let mut out = format!(
        "\nCapacity: peak acceleration of the ground at which it first {}, g; \">\": not up to the largest that was tried\n",
        match answer.kind {
            StudyKind::Stack => "sheds a stone",
            StudyKind::Chain => "falls",
            StudyKind::Frame => "leans beyond the drift limit",
            StudyKind::Building => "drifts beyond the last limit",
        }
    );
    let mut heads = vec![
        "input", "value", "scans", "fell", "least", "5 %", "median", "95 %", states[0],
    ];
    let milder = match answer.kind {
        StudyKind::Stack | StudyKind::Building => 3,
        StudyKind::Frame | StudyKind::Chain => 1,
    };
    heads.extend(&states[1..milder]);
    heads.push("survived above");
    let mut table = Table::new(&heads, 2);
    let name = |row: &LevelRow| match row.input {
        Some(input) => answer.inputs[input].path.clone(),
        None if answer.study.variants.len() > 1 => "variant".to_owned(),
        None => String::new(),
    };
    let mut last = String::new();
    for row in &levels {
        let own = name(row);
        let shown = if own == last { String::new() } else { own.clone() };
        last = own;
        let (usable, all) = (row.usable(), row.scans.len());
        let mut cells = vec![shown, row.text.clone(), of_all(usable, all)];
        if usable == 0 {
            cells.extend(["–".to_owned(), "unusable".to_owned()]);
            cells.resize(heads.len(), "–".to_owned());
            table.row(cells);
            continue;
        }
        cells.push(format!("{} of {usable}", row.fell()));
        cells.push(in_g(answer, row.least_m_s2()));
        cells.extend([0.05, 0.5, 0.95].map(|p| in_g(answer, row.quantile_m_s2(3, p))));
        let shown = match answer.kind {
            StudyKind::Building => in_g,
            _ => begun_g,
        };
        cells.extend((0..milder).map(|state| match answer.has_state(state) {
            true => shown(answer, row.quantile_m_s2(state, 0.5)),
            false => "–".to_owned(),
        }));
        cells.push(format!("{} of {usable}", row.survived_above()));
        table.row(cells);
    }
    out += &table.text();
    if levels.iter().any(|row| row.usable() < SCANS_OF_TAILS) {
        let _ = writeln!(out, "  5 % and 95 % are said of {SCANS_OF_TAILS} scans and more");
    }
    match answer.kind {
        StudyKind::Stack => out += "  DS1 to DS3: medians, to a step of the scan\n",
        StudyKind::Building => {
            out += "  a linear building drifts in proportion: limits are medians, exact up to the largest size that was tried; beyond yielding they say little\n";
        }
        StudyKind::Frame if !answer.has_state(0) => {
            out += "  slips: no storey slipped before the frame leaned too far, so there is no such state\n"
        }
        StudyKind::Frame | StudyKind::Chain => {}
    }
    out += &left_out(answer);
    let scans = answer.capacities();
    let usable = scans.iter().filter(|c| c.verdict.is_usable());
    let at_once = answer.fell_at_the_least();
    if at_once > 0 && answer.kind != StudyKind::Building {
        let _ = writeln!(
            out,
            "  LEAST SIZE FELLS: {at_once} of {} scans fell at the least size that was asked for; what lies below was only halved, and falls there may have been \
             passed over: scan smaller sizes",
            usable.clone().count()
        );
    }
    let above = usable
        .clone()
        .filter(|c| !c.survived_above_m_s2().is_empty())
        .count();
    if above > 0 {
        let _ = writeln!(
            out,
            "  {above} of {} scans survived a scale above their first fall: one critical acceleration says little",
            usable.count()
        );
    }
    out
}

/// "3 of 5", or "5" where all are.
fn of_all(some: usize, all: usize) -> String {
    if some == all {
        all.to_string()
    } else {
        format!("{some} of {all}")
    }
}

/// Scans that cannot be used, with what is known of each.
fn left_out(answer: &StudyAnswer) -> String {
    const NAMED_MOST: usize = 10;
    let scans = answer.capacities();
    let left_out: Vec<&CapacityOf> = scans.iter().filter(|scan| !scan.verdict.is_usable()).collect();
    if left_out.is_empty() {
        return String::new();
    }
    let mut out = format!(
        "  UNUSABLE: {} of {} scans are in no quantile and no trend: runs below their first fall were refused, gave no result or are missing\n",
        left_out.len(),
        scans.len()
    );
    let g = |value_m_s2: f64| format!("{:.3} g", value_m_s2 / answer.gravity_m_s2);
    for scan in left_out.iter().take(NAMED_MOST) {
        let words = match scan.verdict {
            ScanVerdict::Refused => "its inputs were refused".to_owned(),
            ScanVerdict::Missing => "not finished".to_owned(),
            _ if scan.survived_m_s2() > 0.0 => {
                let fell = scan
                    .fell_m_s2()
                    .map_or(String::new(), |fell| format!(", fell at {}", g(fell)));
                format!("survived up to {}, unknown above{fell}", g(scan.survived_m_s2()))
            }
            _ => match scan.fell_m_s2() {
                Some(fell) => format!("unknown below {}, where it fell", g(fell)),
                None => "no run of it can be used".to_owned(),
            },
        };
        let _ = writeln!(
            out,
            "    scan {} ({}): {words}",
            scan.job + 1,
            scan_words(answer, scan.job)
        );
    }
    if left_out.len() > NAMED_MOST {
        let _ = writeln!(
            out,
            "    and {} more: capacities.csv",
            left_out.len() - NAMED_MOST
        );
    }
    out
}

/// How a frame or a chain behaves as the shaking grows, scan by scan: some sizes of each.
fn growth(answer: &StudyAnswer) -> String {
    const SCANS_MOST: usize = 6;
    let (over, columns): (&str, &[(&str, &str, f64)]) = match answer.kind {
        StudyKind::Stack => return String::new(),
        StudyKind::Frame => (
            "storeys",
            &[
                ("drift, mm", "peak_drift_m", 1e3),
                ("drift, % of height", "peak_drift_ratio", 100.0),
                ("slips, % of the time", "slipping_share", 100.0),
                ("drift left, mm", "residual_drift_m", 1e3),
            ],
        ),
        StudyKind::Chain => (
            "links and joints",
            &[
                ("top moves, mm", "peak_top_displacement_m", 1e3),
                ("leans, mrad", "peak_rotation_rad", 1e3),
                ("joint turns, mrad", "peak_joint_rotation_rad", 1e3),
                ("open, % of the time", "open_share", 100.0),
                ("slips, mrad", "slipped_rad", 1e3),
            ],
        ),
        StudyKind::Building => (
            "storeys",
            &[
                ("top moves, mm", "peak_top_displacement_m", 1e3),
                ("drift at a corner, mm", "peak_corner_drift_m", 1e3),
                ("% of height", "peak_corner_drift_ratio", 100.0),
                ("base shear x, kN", "base_shear_x_n", 1e-3),
                ("y, kN", "base_shear_y_n", 1e-3),
                ("stroke, mm", "peak_stroke_m", 1e3),
            ],
        ),
    };
    let mut scans: Vec<&[Run]> = answer.runs.chunk_by(|a, b| a.job == b.job).collect();
    scans.retain(|runs| runs.iter().any(|run| !run.measures.is_none()));
    if scans.is_empty() || scans.len() > SCANS_MOST {
        return String::new();
    }
    let at = |run: &Run, name: &str| run.measures.named(name).unwrap_or(f64::NAN);
    let mut out = format!("\nAs the shaking grows: largest over the {over}\n");
    let mut heads = vec!["scan", "peak, g"];
    heads.extend(columns.iter().map(|column| column.0));
    let mut table = Table::new(&heads, 1);
    for runs in scans {
        for (i, run) in some(runs).into_iter().enumerate() {
            let mut cells = vec![
                if i == 0 {
                    scan_words(answer, run.job)
                } else {
                    String::new()
                },
                format!("{:.3}", run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2),
            ];
            if answer.kind == StudyKind::Chain && run.outcome == RunOutcome::Fell {
                cells.push("fell".to_owned());
                cells.resize(heads.len(), "–".to_owned());
            } else {
                let each = columns
                    .iter()
                    .map(|(_, name, factor)| significant(factor * at(run, name), 3));
                cells.extend(each);
            }
            table.row(cells);
        }
    }
    out += &table.text();
    out
}

/// A scan in words, as short as tells it from the others.
fn scan_words(answer: &StudyAnswer, job: usize) -> String {
    let case = answer.case(job);
    let mut words: Vec<String> = case.variant.iter().cloned().collect();
    let each = answer.inputs.iter().zip(&case.texts);
    words.extend(each.map(|(input, text)| format!("{} = {text}", input.path)));
    if answer.motions.len() > 1 || words.is_empty() {
        words.push(answer.motion_of(job).to_owned());
    }
    if answer.study.turns_rad.len() > 1 {
        words.push(format!("{:.4}°", answer.turn_rad(job).to_degrees()));
    }
    words.join(", ")
}

/// The softest and the stiffest swing of each release, and how much of a map slips.
fn releases(answer: &StudyAnswer) -> String {
    let mut out = String::new();
    let released: Vec<&ResponseMaps> = answer.maps.iter().filter(|map| map.release.len() > 1).collect();
    if !released.is_empty() {
        out += "\nLet go: apparent frequency and equivalent damping, swing by swing\n";
        let heads = ["case", "swing, mm", "frequency, Hz", "damping, %"];
        let mut table = Table::new(&heads, 1);
        for map in released {
            for (i, swing) in some(&map.release).into_iter().enumerate() {
                table.row(vec![
                    if i == 0 { map.label.clone() } else { String::new() },
                    significant(1e3 * swing.amplitude_m, 3),
                    format!("{:.3}", swing.apparent_frequency_hz),
                    format!("{:.2}", 100.0 * swing.equivalent_damping_ratio),
                ]);
            }
        }
        out += &table.text();
    }
    let mapped: Vec<&ResponseMaps> = answer
        .maps
        .iter()
        .filter(|map| !map.harmonic.is_empty())
        .collect();
    if !mapped.is_empty() {
        let (does, heads) = match answer.kind {
            StudyKind::Chain => ("joint opens or slips", ["joint below", "moves", "falls"]),
            _ => ("storey slips", ["storey", "slips", "drift limit"]),
        };
        let _ = writeln!(
            out,
            "\nHarmonic ground: at how many points of the map each {does}"
        );
        let [part, moves, fell] = heads;
        let mut table = Table::new(&["case", part, "points", moves, fell, "not steady"], 2);
        for map in mapped {
            let fell = map.harmonic.iter().filter(|point| point.fell).count();
            let unsteady = map.harmonic.iter().filter(|p| !p.steady && !p.fell).count();
            for (part, name) in map.parts.iter().enumerate() {
                let moves = map
                    .harmonic
                    .iter()
                    .filter(|p| p.moving_share.get(part).is_some_and(|s| *s > 0.0));
                table.row(vec![
                    if part == 0 {
                        map.label.clone()
                    } else {
                        String::new()
                    },
                    name.clone(),
                    map.harmonic.len().to_string(),
                    moves.count().to_string(),
                    fell.to_string(),
                    unsteady.to_string(),
                ]);
            }
        }
        out += &table.text();
    }
    out
}

/// Some of many, evenly chosen, both ends among them.
fn some<T>(all: &[T]) -> Vec<&T> {
    const MOST: usize = 7;
    let last = all.len().saturating_sub(1);
    if last < MOST {
        return all.iter().collect();
    }
    (0..MOST).filter_map(|i| all.get(i * last / (MOST - 1))).collect()
}

fn trends(answer: &StudyAnswer, trends: &[TrendAnswer]) -> String {
    let trends: Vec<&TrendAnswer> = trends.iter().filter(|trend| trend.of_medians.pairs > 0).collect();
    if trends.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "\nTrends of the capacity, all else equal: Kendall's tau of the medians, ± what chance alone would give\n",
    );
    for trend in trends {
        let path = &answer.inputs[trend.input].path;
        let tau = &trend.of_medians;
        let words = match &trend.expected {
            Some((expected, verdict)) => {
                let said = expected.words.as_ref().map_or_else(
                    || {
                        let way = if expected.direction == Direction::Rising {
                            "rises"
                        } else {
                            "falls"
                        };
                        format!("the capacity {way} with {path}")
                    },
                    |words| words.english().to_owned(),
                );
                format!("{said}: {}", verdict.word())
            }
            None if tau.direction() == Some(Direction::Rising) => format!("the capacity rises with {path}"),
            None if tau.direction() == Some(Direction::Falling) => format!("the capacity falls with {path}"),
            None => format!("the capacity has no trend with {path} beyond chance"),
        };
        let _ = write!(
            out,
            "  {words}; tau = {:+.2} ± {:.2} in {} pairs",
            tau.tau, tau.tau_by_chance, tau.pairs
        );
        if trend.of_each.len() > 1 {
            let way = match (&trend.expected, tau.tau > 0.0) {
                (Some((expected, _)), _) => expected.direction,
                (None, true) => Direction::Rising,
                (None, false) => Direction::Falling,
            };
            let each: Vec<Reached> = trend.of_each.iter().copied().map(Reached::At).collect();
            let ends = if each.len() < SCANS_OF_TAILS {
                [0.0, 1.0]
            } else {
                [0.05, 0.95]
            };
            let range = ends.map(|p| reached_quantile(&each, p).map_or(f64::NAN, Reached::value));
            let _ = write!(
                out,
                ", the same way in {} of {} motions, directions and samples ({:+.2} to {:+.2}{})",
                trend.same_way(way),
                trend.of_each.len(),
                range[0],
                range[1],
                if each.len() < SCANS_OF_TAILS {
                    ""
                } else {
                    ", 5 to 95 %"
                }
            );
        }
        let (left_out, all) = (answer.left_out(), answer.jobs());
        if left_out > 0 {
            let _ = write!(out, "; of {} of {all} scans", all - left_out);
        }
        out.push('\n');
    }
    out
}
