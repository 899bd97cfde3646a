//! A damper beside the rule and the best, as text.

use super::Table;
use dolmen::damper::{Aim, Choice, Compared, DesignEnd, Goal};
use dolmen_words::Language;
use dolmen_work::building::{RoomCheck, TogetherAnswer, TogetherChoice, TuneAnswer, direction_words};
use std::fmt::Write as _;

/// What is compared, what each choice does, tunings with their names, and what being off costs.
pub fn tune_text(answer: &TuneAnswer) -> String {
    let mut out = given(answer);
    for words in room_words(&answer.room, |row| {
        let choice = answer.comparison.rows.get(row).map(|row| row.choice);
        choice.map_or(String::new(), |choice| choice_words(choice, answer.mode))
    }) {
        let _ = writeln!(out, "{words}");
    }
    out += &choices(answer);
    out += &sentences(answer);
    out += &tunings(answer);
    out += &off(answer);
    out
}

/// Dampers that need more room than they have, and rooms that nothing is held against, a sentence each.
pub fn room_words(room: &RoomCheck, row: impl Fn(usize) -> String) -> Vec<String> {
    let mut all: Vec<String> = room
        .beyond()
        .map(|of| {
            format!(
                "BEYOND ITS ROOM: {}, damper {} needs {:.1} mm each way under {} and has {:.1} mm",
                row(of.row),
                of.damper,
                1e3 * of.stroke_m,
                of.under(Language::English),
                1e3 * of.room_m
            )
        })
        .collect();
    if room.is_unjudged() {
        all.push(
            "ROOM NOT JUDGED: the file says how much room there is, and has no [motion.NAME] or [site] to hold it against; the loads here have no size"
                .to_owned(),
        );
    }
    all
}

/// From this relative difference on numbers at prepared frequencies are called rough.
const ROUGH: f64 = 1e-3;

/// What the goal is, in words.
pub fn goal_words(goal: Goal) -> &'static str {
    match goal {
        Goal::LargestRms => "the largest standard deviation of the points",
        Goal::MeanSquare => "the root of the mean variance of the points",
        Goal::LargestPeak => {
            "the largest amplitude of the points under a harmonic load of that place and direction, of any frequency alike (its spectrum is not in this goal)"
        }
    }
}

/// A choice in words; `mode` from 1.
pub fn choice_words(choice: Choice, mode: usize) -> String {
    match choice {
        Choice::Given => "as in the file".to_owned(),
        Choice::Rule => format!("the rule: farthest from the centre of mode {mode}"),
        Choice::TunedBest => "where it is, tuned best".to_owned(),
        Choice::PlacedBest => "placed best, tuned as in the file".to_owned(),
        Choice::Best => "placed and tuned best".to_owned(),
    }
}

fn given(answer: &TuneAnswer) -> String {
    let comparison = &answer.comparison;
    let mut out = String::new();
    if let Some(row) = comparison.row(Choice::Given) {
        let damper = &row.damper;
        let of = answer
            .variant
            .as_ref()
            .map_or(String::new(), |name| format!(" (variant {name})"));
        let _ = writeln!(
            out,
            "\nDamper {}{of}: {:.1} kg on floor {} at x = {} m, y = {} m, along {}",
            answer.damper,
            damper.mass_kg,
            answer.floor,
            damper.place_m[0],
            damper.place_m[1],
            direction_words(damper.direction_degrees)
        );
    }
    let centre = match answer.mode_centre_m {
        Some([x, y]) => format!("its centre at x = {x:.3} m, y = {y:.3} m"),
        None => "it does not turn".to_owned(),
    };
    let _ = writeln!(
        out,
        "Mode {}: {:.4} Hz ({:.5} rad/s), damping {:.4}, {centre}; modal mass at the damper {:.1} kg, mass ratio {:.5}",
        answer.mode,
        answer.mode_frequency_hz,
        std::f64::consts::TAU * answer.mode_frequency_hz,
        answer.mode_damping_ratio,
        comparison.modal_mass_kg,
        comparison.mass_ratio
    );
    if answer.others > 0 {
        let _ = writeln!(
            out,
            "The other {} dampers of the file are left out here: each is judged alone first, and all together below",
            answer.others
        );
    }
    if let Some(most) = answer.stroke_most {
        let _ = writeln!(
            out,
            "What is designed keeps to {most} of the stroke of the file's damper"
        );
    }
    if answer.off_by > 0.0 {
        let _ = writeln!(
            out,
            "What is designed is the best with its frequency off by {:.1} % either way, the goal at its own",
            100.0 * answer.off_by
        );
    }
    let names: Vec<&str> = answer.points.iter().map(|point| point.name.as_str()).collect();
    let _ = writeln!(
        out,
        "Load: {}, along {}\nMade small: {} {}, along {}",
        answer.load.english(),
        direction_words(answer.load_direction_degrees),
        goal_words(answer.goal),
        names.join(", "),
        direction_words(answer.direction_degrees)
    );
    out
}

fn choices(answer: &TuneAnswer) -> String {
    let heads: Vec<String> = ["damper", "x, m", "y, m", "frequency, Hz", "damping ratio"]
        .into_iter()
        .map(str::to_owned)
        .chain(answer.points.iter().map(|point| point.name.clone()))
        .chain(["goal", "stroke"].map(str::to_owned))
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 1);
    let mut none = vec!["none".to_owned()];
    none.extend(["", "", "", ""].map(str::to_owned));
    none.extend(answer.points.iter().map(|_| "1.0000".to_owned()));
    none.extend(["1.0000".to_owned(), String::new()]);
    table.row(none);
    for row in &answer.comparison.rows {
        let mut cells = vec![choice_words(row.choice, answer.mode)];
        let damper = &row.damper;
        cells.extend([
            format!("{:.3}", damper.place_m[0] + 0.0),
            format!("{:.3}", damper.place_m[1] + 0.0),
            format!("{:.5}", damper.frequency_hz),
            format!("{:.5}", damper.damping_ratio),
        ]);
        cells.extend(answer.ratios(row).iter().map(|ratio| format!("{ratio:.4}")));
        cells.push(format!("{:.4}", row.cost / answer.comparison.cost_without));
        cells.push(format!("{:.3}", answer.stroke_ratio(row)));
        table.row(cells);
    }
    format!(
        "\n{} over that without a damper; the stroke over that of the damper as in the file\n{}",
        match answer.goal {
            Goal::LargestPeak => "Largest amplitude under a harmonic load",
            Goal::LargestRms | Goal::MeanSquare => "Standard deviation of the motion",
        },
        table.text()
    )
}

/// What to take from it, one sentence a line.
fn sentences(answer: &TuneAnswer) -> String {
    let mut out = String::from("\n");
    for sentence in findings(answer) {
        let _ = writeln!(out, "{sentence}");
    }
    out
}

/// What the comparison says, in sentences: points made worse than without a damper, and what each choice costs.
pub fn findings(answer: &TuneAnswer) -> Vec<String> {
    let mut all = Vec::new();
    for row in &answer.comparison.rows {
        for (point, ratio) in answer.worse(row) {
            all.push(format!(
                "WORSE THAN NO DAMPER: {}, {} moves {ratio:.4} of what it moves without",
                choice_words(row.choice, answer.mode),
                point.name
            ));
        }
    }
    if let Some(most) = answer.stroke_most {
        let rows = answer.comparison.rows.iter();
        for row in rows.filter(|row| answer.is_beyond_stroke(row)) {
            all.push(format!(
                "STROKE NOT KEPT: '{}' moves {:.4} of the stroke of the file's damper, and {most} was asked for",
                choice_words(row.choice, answer.mode),
                answer.stroke_ratio(row)
            ));
        }
    }
    for row in answer
        .comparison
        .rows
        .iter()
        .filter(|row| row.damper.damping_ratio > 1.0)
    {
        all.push(format!(
            "NO DAMPER: '{}' has a damping ratio of {:.3}: above 1 nothing swings any more, and a project file refuses it",
            choice_words(row.choice, answer.mode),
            row.damper.damping_ratio
        ));
    }
    let more = |choice: Choice, words: &str| -> Option<String> {
        let share = answer.costs(choice, Choice::Best)?;
        Some(match share >= 0.0 {
            true => format!("{words} leaves {:.1} % more than the best", 100.0 * share),
            false => format!(
                "{words} leaves {:.1} % less than the best within the limits asked for, and does not keep them",
                -100.0 * share
            ),
        })
    };
    all.extend(more(Choice::Rule, "The rule, far from the centre of the mode,"));
    all.extend(more(Choice::Given, "The file's damper"));
    if answer.comparison.apart > ROUGH {
        all.push(format!(
            "ROUGH: maps, lines, tunings, curves of being out of tune and searches are off by up to {:.1} %: something is damped too lightly for them; \
             the rows of the table are computed afresh",
            100.0 * answer.comparison.apart
        ));
    }
    let unsettled = |row: &&Compared| !matches!(row.end, None | Some(DesignEnd::Optimum));
    for row in answer.comparison.rows.iter().filter(unsettled) {
        let words = match row.end {
            Some(DesignEnd::Limit) => format!(
                "ended where its search is bounded, at {:.5} Hz and damping ratio {:.5}: there may be better beyond",
                row.damper.frequency_hz, row.damper.damping_ratio
            ),
            None | Some(DesignEnd::Optimum | DesignEnd::Stalled) => {
                "is the best that was seen, but its search did not settle to 1e-6".to_owned()
            }
        };
        all.push(format!("'{}' {words}", choice_words(row.choice, answer.mode)));
    }
    all
}

fn tunings(answer: &TuneAnswer) -> String {
    let heads = [
        "tuning, where the damper is",
        "made for",
        "f/f of the mode",
        "c/(2 m ω)",
        "c/(2 m Ω)",
        "goal",
    ];
    let mut table = Table::new(&heads, 2);
    for row in &answer.comparison.tunings {
        let (name, aim) = match (row.rule, row.aim) {
            (Some(rule), _) => (rule.source().to_owned(), rule.aim().to_owned()),
            (None, aim) => (
                "exact, with the mode's damping".to_owned(),
                aim_words(aim).to_owned(),
            ),
        };
        table.row(vec![
            name,
            aim,
            format!("{:.7}", row.tuning.frequency_ratio),
            format!("{:.7}", row.tuning.damping_ratio),
            format!("{:.7}", row.tuning.damping_ratio_on_structure()),
            format!("{:.4}", row.cost / answer.comparison.cost_without),
        ]);
    }
    format!(
        "\nω is the damper's own frequency, Ω that of the mode: Den Hartog's book and Hwang, Min & Hong divide by the second\n{}",
        table.text()
    )
}

fn aim_words(aim: Option<Aim>) -> &'static str {
    match aim {
        Some(Aim::ForceHarmonic) => "peak under a harmonic force",
        Some(Aim::ForceRandom) => "variance under a white-noise force",
        Some(Aim::BaseHarmonic) => "peak under a harmonic base acceleration",
        Some(Aim::BaseRandom) => "variance under a white-noise base acceleration",
        None => "",
    }
}

fn off(answer: &TuneAnswer) -> String {
    let mut table = Table::new(
        &[
            "frequency off by",
            "-20 %",
            "-10 %",
            "-4 %",
            "+4 %",
            "+10 %",
            "+20 %",
        ],
        1,
    );
    for (which, name) in ["as in the file", "placed and tuned best"]
        .into_iter()
        .enumerate()
    {
        let mut cells = vec![name.to_owned()];
        cells.extend([0.8, 0.9, 0.96, 1.04, 1.1, 1.2].map(|factor| {
            answer
                .detuned(which, factor)
                .map_or(String::new(), |share| format!("{:+.1} %", 100.0 * share))
        }));
        table.row(cells);
    }
    format!(
        "\nWhat the goal grows by when the damper is out of tune\n{}",
        table.text()
    )
}

/// All dampers of a building at once.
pub fn together_text(answer: &TogetherAnswer) -> String {
    let mut out = String::new();
    let of = answer
        .variant
        .as_ref()
        .map_or(String::new(), |name| format!(" (variant {name})"));
    let directions: Vec<String> = answer
        .load_directions_degrees
        .iter()
        .map(|degrees| direction_words(*degrees))
        .collect();
    let _ = writeln!(
        out,
        "\nAll dampers together{of}\nLoad: {}, along {}{}\nMade small: {}",
        answer.load.english(),
        directions.join(" and "),
        if directions.len() > 1 {
            ", independently"
        } else {
            ""
        },
        goal_words(answer.goal)
    );
    if let Some(most) = answer.stroke_most {
        let _ = writeln!(
            out,
            "What is designed keeps to {most} of the strokes of the file's dampers"
        );
    }
    for words in room_words(&answer.room, |row| {
        let row = answer.rows.get(row);
        row.map_or(String::new(), |row| together_words(&row.choice))
    }) {
        let _ = writeln!(out, "{words}");
    }
    let mut heads = vec!["dampers".to_owned()];
    for (point, degrees) in &answer.points {
        heads.push(format!("{} {}", point.name, direction_words(*degrees)));
    }
    heads.push("goal".to_owned());
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 1);
    for row in &answer.rows {
        let mut cells = vec![together_words(&row.choice)];
        cells.extend(answer.ratios(row).iter().map(|ratio| format!("{ratio:.4}")));
        cells.push(format!("{:.4}", answer.cost_ratio(row)));
        table.row(cells);
    }
    let _ = write!(out, "\nMotion over that without dampers\n{}", table.text());
    let mut table = Table::new(
        &[
            "as designed",
            "damper",
            "x, m",
            "y, m",
            "mass, t",
            "f, Hz",
            "damping, %",
            "besides",
        ],
        2,
    );
    for row in answer.rows.iter().filter(|row| row.end.is_some()) {
        for damper in &row.dampers {
            let [hz, ratio] = damper
                .own()
                .map_or(["none".to_owned(), "none".to_owned()], |[hz, ratio]| {
                    [format!("{hz:.5}"), format!("{:.3}", 100.0 * ratio)]
                });
            table.row(vec![
                together_words(&row.choice),
                damper.name.clone(),
                format!("{:.3}", damper.place_m[0] + 0.0),
                format!("{:.3}", damper.place_m[1] + 0.0),
                match damper.kind.mass_kg() {
                    0.0 => "none".to_owned(),
                    mass_kg => format!("{:.4}", 1e-3 * mass_kg),
                },
                hz,
                ratio,
                damper.rest(),
            ]);
        }
    }
    let _ = write!(out, "\n{}", table.text());
    for row in &answer.rows {
        for ((point, degrees), ratio) in answer.points.iter().zip(answer.ratios(row)) {
            if ratio > 1.0 + 1e-12 {
                let _ = writeln!(
                    out,
                    "WORSE THAN NO DAMPER: {}, {} along {} moves {ratio:.4} of what it moves without",
                    together_words(&row.choice),
                    point.name,
                    direction_words(*degrees)
                );
            }
        }
        for damper in row.dampers.iter().filter(|damper| damper.is_overdamped()) {
            let _ = writeln!(
                out,
                "NO DAMPER: '{}', damper {} has a damping ratio above 1: nothing swings there any more, and a project file refuses it",
                together_words(&row.choice),
                damper.name
            );
        }
        for (damper, ratio) in answer.beyond_stroke(row) {
            let _ = writeln!(
                out,
                "STROKE NOT KEPT: '{}', damper {damper} moves {ratio:.4} of its stroke as in the file, and {} was asked for",
                together_words(&row.choice),
                answer.stroke_most.unwrap_or_default()
            );
        }
        let words = match row.end {
            Some(DesignEnd::Limit) => "lies at the limit of a tuning that a damper may have",
            Some(DesignEnd::Stalled) => "is the best that was seen, but its search did not settle to 1e-6",
            None | Some(DesignEnd::Optimum) => continue,
        };
        let _ = writeln!(out, "'{}' {words}", together_words(&row.choice));
    }
    out
}

/// A choice of all dampers in words.
pub fn together_words(choice: &TogetherChoice) -> String {
    match choice {
        TogetherChoice::Without => "none".to_owned(),
        TogetherChoice::Given => "all as in the file".to_owned(),
        TogetherChoice::Only(name) => format!("{name} alone"),
        TogetherChoice::AllBut(name) => format!("all but {name}"),
        TogetherChoice::TunedBest => "all where they are, tuned best together".to_owned(),
        TogetherChoice::Best => "placed and tuned best together".to_owned(),
        TogetherChoice::BestShared => "the same, their mass shared anew".to_owned(),
    }
}
