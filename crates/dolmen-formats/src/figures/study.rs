//! Figures of a study: capacity against each input, what fell and what survived at which shaking, and frames as shaking grows.

use super::Figure;
use super::axis::{Axis, Tick};
use super::ink::{Anchor, BLUE, GREY, Label, Line, ORANGE, SERIES, SKY, Shape, VERMILLION};
use super::plot::{Key, Plot};
use crate::Language;
use crate::study::{FrameMaps, LevelRow, RunOutcome, StudyAnswer, StudyKind, input_words};
use dolmen::assess::{Reached, Trial};
use std::collections::BTreeMap;

/// Size of a figure, px.
const SIZE_PX: [f64; 2] = [640.0, 380.0];
/// Room left for the texts of a level on its axis, px.
const LEVEL_PX: f64 = 110.0;
/// Part of the way to the next level that dots of one level spread over.
const SPREAD: f64 = 0.24;
/// Colours of a share, the least first: from nothing to all of the time.
const SHARES: [(f64, &str, f64); 5] = [
    (0.0, SKY, 0.12),
    (0.05, SKY, 0.45),
    (0.2, SKY, 0.9),
    (0.4, BLUE, 0.75),
    (0.6, BLUE, 1.0),
];

/// The figures of a study.
pub fn study_figures(answer: &StudyAnswer, language: Language) -> Vec<Figure> {
    let mut figures = Vec::new();
    let mut add = |name: String, svg: String| figures.push(Figure { name, svg });
    if answer.study.scan.is_some() {
        let mut by_input: BTreeMap<Option<usize>, Vec<LevelRow>> = BTreeMap::new();
        for row in answer.levels() {
            by_input.entry(row.input).or_default().push(row);
        }
        for (input, rows) in &by_input {
            let (name, label) = match input {
                Some(input) => {
                    let input = &answer.inputs[*input];
                    (
                        input.column.clone(),
                        named(&input_words(&input.path, language), &input.unit),
                    )
                }
                None if answer.study.variants.len() > 1 => {
                    ("all".to_owned(), language.pick("variant", "대안").to_owned())
                }
                None => (
                    "all".to_owned(),
                    language.pick("nothing is varied", "변수 없음").to_owned(),
                ),
            };
            add(
                format!("capacity-{name}"),
                capacity(answer, rows, &label, language),
            );
            add(
                format!("survived-{name}"),
                survived(answer, *input, rows, &label, language),
            );
        }
    }
    if answer.kind == StudyKind::Frame && answer.study.scan.is_some() {
        for (name, label, factor) in [
            (
                "peak_drift_m",
                language.pick("Largest drift (mm)", "최대 층간변위 (mm)"),
                1e3,
            ),
            (
                "slipping_share",
                language.pick("Slips, % of the time", "미끄러짐 시간 비율 (%)"),
                100.0,
            ),
            (
                "residual_drift_m",
                language.pick("Drift left (mm)", "잔류 층간변위 (mm)"),
                1e3,
            ),
        ] {
            add(
                format!("growth-{name}"),
                growth(answer, name, (label, factor), language),
            );
        }
    }
    for map in &answer.maps {
        if !map.harmonic.is_empty() {
            for (storey, name) in map.storeys.iter().enumerate() {
                let svg = harmonic(map, storey, (name, answer.gravity_m_s2), language);
                add(format!("harmonic-{}-{}", map.case + 1, storey + 1), svg);
            }
        }
    }
    let released: Vec<&FrameMaps> = answer.maps.iter().filter(|map| !map.release.is_empty()).collect();
    if !released.is_empty() {
        let frequency = (
            language.pick("Apparent frequency (Hz)", "겉보기 진동수 (Hz)"),
            1.0,
        );
        add(
            "release-frequency".to_owned(),
            release(
                &released,
                frequency,
                |swing| swing.apparent_frequency_hz,
                language,
            ),
        );
        let damping = (language.pick("Equivalent damping (%)", "등가감쇠비 (%)"), 100.0);
        add(
            "release-damping".to_owned(),
            release(
                &released,
                damping,
                |swing| swing.equivalent_damping_ratio,
                language,
            ),
        );
    }
    figures
}

/// Says below the plot how it was computed.
fn explain(plot: &mut Plot, answer: &StudyAnswer, language: Language) {
    plot.note(&answer.method(language));
    for note in &answer.notes {
        plot.note(note);
    }
}

fn named(path: &str, unit: &str) -> String {
    if unit.is_empty() {
        path.to_owned()
    } else {
        format!("{path} ({unit})")
    }
}

/// Ends of the scan, g.
fn largest_g(answer: &StudyAnswer) -> f64 {
    let peaks = answer.runs.iter().map(|run| run.peak_ground_acceleration_m_s2);
    peaks.filter(|peak| peak.is_finite()).fold(0.0, f64::max) / answer.gravity_m_s2
}

/// The levels of an input side by side: places, and the axis.
fn level_axis(rows: &[LevelRow], label: &str) -> Axis {
    let shown = |text: &str| {
        let text = text.trim_matches('"');
        let short: String = text.chars().take(16).collect();
        if short.len() < text.len() {
            format!("{short}…")
        } else {
            short
        }
    };
    let mut axis = Axis::linear(label, -0.6, rows.len() as f64 - 0.4, 4);
    axis.grid = false;
    axis.ticks = rows
        .iter()
        .enumerate()
        .map(|(i, row)| Tick {
            at: i as f64,
            text: shown(&row.text),
        })
        .collect();
    axis
}

fn wide(rows: &[LevelRow]) -> [f64; 2] {
    [SIZE_PX[0].max(LEVEL_PX * rows.len() as f64), SIZE_PX[1]]
}

/// First falls at each level: every scan a dot, median and 5 to 95 %.
fn capacity(answer: &StudyAnswer, rows: &[LevelRow], label: &str, language: Language) -> String {
    let largest = largest_g(answer);
    let y_name = match answer.kind {
        StudyKind::Stack => language.pick(
            "First fall: peak ground acceleration (g)",
            "최초 낙하: 최대지반가속도 (g)",
        ),
        StudyKind::Frame => language.pick(
            "Drift limit: peak ground acceleration (g)",
            "층간변위 한계: 최대지반가속도 (g)",
        ),
    };
    let y = Axis::linear(y_name, 0.0, 1.06 * largest, 6);
    let mut plot = Plot::new(wide(rows), level_axis(rows, label), y);
    let g = answer.gravity_m_s2;
    let at = |found: Option<Reached>| {
        let reached = found.filter(|found| found.is_reached());
        reached.map(|found| found.value() / g)
    };
    let above = |found: Option<Reached>| found.map(|found| at(Some(found)).unwrap_or(1.03 * largest));
    let (mut tails, mut left_out) = (false, false);
    for (i, row) in rows.iter().enumerate() {
        let place = i as f64;
        let tail = |probability| above(row.quantile_m_s2(3, probability));
        if let (Some(low), Some(high)) = (tail(0.05), tail(0.95)) {
            plot.block([place - 0.3, low], [place + 0.3, high], SKY, 0.25);
            tails = true;
        }
        let count = row.scans.len();
        let spread = |k: usize| match count {
            0 | 1 => 0.0,
            _ => SPREAD * (2.0 * k as f64 / (count - 1) as f64 - 1.0),
        };
        let usable = row.first_m_s2(3);
        for (k, value) in usable.iter().enumerate() {
            match value {
                Reached::At(value) => {
                    plot.sized_dot([place + spread(k), value / g], Shape::Circle, 3.0, BLUE);
                }
                Reached::Above(_) => {
                    plot.sized_dot([place + spread(k), 1.03 * largest], Shape::Triangle, 3.5, GREY);
                }
            }
        }
        // what is known of a scan that cannot be used: that its capacity lies somewhere here
        for (k, scan) in row.left_out().enumerate() {
            let x = place + spread(usable.len() + k);
            let high = scan.fell_m_s2().map_or(1.06 * largest, |fell| fell / g);
            let low = scan.survived_m_s2() / g;
            plot.line(vec![[x, low], [x, high]], Line::new(GREY, 1.2).dashed());
            left_out = true;
        }
        if let Some(median) = at(row.quantile_m_s2(3, 0.5)) {
            plot.line(
                vec![[place - 0.3, median], [place + 0.3, median]],
                Line::new(VERMILLION, 2.2),
            );
        }
    }
    let joined: Vec<[f64; 2]> = rows
        .iter()
        .enumerate()
        .filter_map(|(i, row)| Some([i as f64, at(row.quantile_m_s2(3, 0.5))?]))
        .collect();
    plot.line(joined, Line::new(VERMILLION, 1.0).dashed());
    plot.key(
        Key::Dot(Shape::Circle, BLUE),
        language.pick("one scan", "해석 1건"),
    );
    plot.key(
        Key::Dot(Shape::Triangle, GREY),
        language.pick("not up to the largest tried", "최대 입력까지 낙하 없음"),
    );
    if left_out {
        plot.key(
            Key::Line(Line::new(GREY, 1.2).dashed()),
            language.pick("unusable: somewhere here", "사용 불가: 이 범위"),
        );
    }
    plot.key(
        Key::Line(Line::new(VERMILLION, 2.2)),
        language.pick("median", "중앙값"),
    );
    if tails {
        plot.key(Key::Block(SKY, 0.4), language.pick("5 to 95 %", "5–95 %"));
    }
    explain(&mut plot, answer, language);
    plot.svg(language.pick("Capacity against an input", "입력변수에 따른 내진성능"))
}

/// Every run: what fell and what survived, at which peak, by level.
fn survived(
    answer: &StudyAnswer,
    input: Option<usize>,
    rows: &[LevelRow],
    label: &str,
    language: Language,
) -> String {
    let largest = largest_g(answer);
    let y = Axis::linear(
        language.pick("Peak ground acceleration (g)", "최대지반가속도 (g)"),
        0.0,
        1.04 * largest,
        6,
    );
    let mut plot = Plot::new(wide(rows), level_axis(rows, label), y);
    let level_of = |job: usize| {
        let case = answer.case(job);
        rows.iter().position(|row| match input {
            Some(input) => case.texts.get(input).is_some_and(|text| *text == row.text),
            None => case.variant.as_deref().is_none_or(|variant| variant == row.text) || rows.len() == 1,
        })
    };
    // every scan of a level has its own column
    let mut columns: Vec<Vec<usize>> = vec![Vec::new(); rows.len()];
    for run in &answer.runs {
        if let Some(level) = level_of(run.job).filter(|level| columns[*level].last() != Some(&run.job)) {
            columns[level].push(run.job);
        }
    }
    for run in answer.runs.iter().filter(|run| run.scale > 0.0) {
        let Some(level) = level_of(run.job) else { continue };
        let own = &columns[level];
        let column = own.iter().position(|job| *job == run.job).unwrap_or(0) as f64;
        let spread = if own.len() > 1 {
            0.38 * (2.0 * column / (own.len() - 1) as f64 - 1.0)
        } else {
            0.0
        };
        let at = [
            level as f64 + spread,
            run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2,
        ];
        let (shape, size, colour) = match (run.outcome.trial(), run.damage_state) {
            (Trial::Fell, _) => (Shape::Cross, 3.0, VERMILLION),
            (Trial::Unknown, _) => (Shape::Ring, 3.0, GREY),
            (_, 3) => (Shape::Square, 2.6, ORANGE),
            (_, 0) => (Shape::Circle, 2.0, SKY),
            _ => (Shape::Circle, 2.6, BLUE),
        };
        plot.sized_dot(at, shape, size, colour);
    }
    match answer.kind {
        StudyKind::Stack => {
            plot.key(
                Key::Dot(Shape::Circle, SKY),
                language.pick("nothing moved", "움직임 없음"),
            );
            plot.key(Key::Dot(Shape::Circle, BLUE), "DS1, DS2");
            plot.key(Key::Dot(Shape::Square, ORANGE), "DS3");
            plot.key(Key::Dot(Shape::Cross, VERMILLION), language.pick("fell", "낙하"));
        }
        StudyKind::Frame => {
            plot.key(Key::Dot(Shape::Circle, SKY), language.pick("stuck", "고착"));
            plot.key(
                Key::Dot(Shape::Circle, BLUE),
                language.pick("slipped", "미끄러짐"),
            );
            plot.key(
                Key::Dot(Shape::Cross, VERMILLION),
                language.pick("beyond the drift limit", "층간변위 한계 초과"),
            );
        }
    }
    let unusable = |outcome: RunOutcome| outcome.trial() == Trial::Unknown;
    if answer.outcomes().into_keys().any(unusable) {
        plot.key(
            Key::Dot(Shape::Ring, GREY),
            language.pick("no result", "결과 없음"),
        );
    }
    explain(&mut plot, answer, language);
    plot.svg(language.pick("What fell and what survived", "낙하와 생존"))
}

/// Share of slipping of a storey over frequency and acceleration of the ground.
fn harmonic(map: &FrameMaps, storey: usize, (name, gravity): (&str, f64), language: Language) -> String {
    let mut frequencies: Vec<f64> = map.harmonic.iter().map(|point| point.frequency_hz).collect();
    let mut accelerations: Vec<f64> = map
        .harmonic
        .iter()
        .map(|p| p.ground_acceleration_m_s2 / gravity)
        .collect();
    for values in [&mut frequencies, &mut accelerations] {
        values.sort_by(f64::total_cmp);
        values.dedup();
    }
    let logarithms: Vec<f64> = accelerations.iter().map(|a| a.ln()).collect();
    let fy: Vec<f64> = edges(&logarithms).into_iter().map(f64::exp).collect();
    let fx = edges(&frequencies);
    let range = |edges: &[f64]| {
        [
            edges.first().copied().unwrap_or(0.0),
            edges.last().copied().unwrap_or(1.0),
        ]
    };
    let ([x0, x1], [y0, y1]) = (range(&fx), range(&fy));
    let x = Axis::linear(
        language.pick("Frequency of the ground (Hz)", "지반 진동수 (Hz)"),
        x0,
        x1,
        8,
    );
    let mut y = Axis::logarithmic(
        language.pick("Acceleration of the ground (g)", "지반 가속도 (g)"),
        &accelerations,
    );
    (y.from, y.to) = (y0, y1);
    y.ticks.retain(|tick| (y0..=y1).contains(&tick.at));
    let mut plot = Plot::new(SIZE_PX, x, y);
    let at = |values: &[f64], value: f64| values.iter().position(|known| *known == value);
    for point in &map.harmonic {
        let acceleration = point.ground_acceleration_m_s2 / gravity;
        let (Some(i), Some(j)) = (
            at(&frequencies, point.frequency_hz),
            at(&accelerations, acceleration),
        ) else {
            continue;
        };
        let (from, to) = ([fx[i], fy[j]], [fx[i + 1], fy[j + 1]]);
        let share = point.slipping_share.get(storey).copied().unwrap_or(0.0);
        if point.beyond_drift_limit {
            plot.block(from, to, VERMILLION, 0.85);
        } else if share > 0.0 {
            let step = SHARES
                .iter()
                .rev()
                .find(|(least, ..)| share > *least)
                .unwrap_or(&SHARES[0]);
            plot.block(from, to, step.1, step.2);
        }
        if !point.steady && !point.beyond_drift_limit {
            plot.sized_dot([point.frequency_hz, acceleration], Shape::Ring, 2.0, GREY);
        }
    }
    plot.key(Key::Block(SKY, 0.0), language.pick("white: stuck", "흰색: 고착"));
    for (least, colour, opacity) in SHARES {
        let text = if least == 0.0 {
            language.pick("slips, up to 5 %", "미끄러짐 5 % 이하").to_owned()
        } else {
            format!("> {:.0} %", 100.0 * least)
        };
        plot.key(Key::Block(colour, opacity), text);
    }
    plot.key(
        Key::Block(VERMILLION, 0.85),
        language.pick("drift limit", "층간변위 한계"),
    );
    plot.key(Key::Dot(Shape::Ring, GREY), language.pick("not steady", "비정상"));
    let words = if map.label.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {}", map.label)
    };
    plot.text([x1, y0], [-8.0, -14.0], Label::new(words, Anchor::End).bold());
    plot.svg(language.pick("Share of the time in which a storey slips", "미끄러짐 시간 비율"))
}

/// One number of the runs of a frame against the peak of the ground, a line a scan.
fn growth(answer: &StudyAnswer, measure: &str, (label, factor): (&str, f64), language: Language) -> String {
    const NAMED_MOST: usize = SERIES.len();
    let place = answer.kind.measures().iter().position(|known| *known == measure);
    let scans: Vec<(usize, Vec<[f64; 2]>)> = answer
        .runs
        .chunk_by(|a, b| a.job == b.job)
        .filter_map(|runs| {
            let points = runs.iter().filter_map(|run| {
                let value = run.measures.get(place?)?;
                Some([
                    run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2,
                    factor * value,
                ])
            });
            Some((runs.first()?.job, points.collect()))
        })
        .collect();
    let all: Vec<[f64; 2]> = scans
        .iter()
        .flat_map(|(_, points)| points.iter().copied())
        .collect();
    let peaks: Vec<f64> = all.iter().map(|point| point[0]).collect();
    let most = all.iter().map(|point| point[1]).fold(1e-9, f64::max);
    let x = Axis::logarithmic(
        language.pick("Peak ground acceleration (g)", "최대지반가속도 (g)"),
        &peaks,
    );
    let mut plot = Plot::new(SIZE_PX, x, Axis::linear(label, 0.0, 1.08 * most, 6));
    let few = scans.len() <= NAMED_MOST;
    for (i, (job, points)) in scans.into_iter().enumerate() {
        let colour = if few { SERIES[i % SERIES.len()] } else { BLUE };
        for point in &points {
            plot.sized_dot(*point, Shape::Circle, 2.5, colour);
        }
        plot.line(points, Line::new(colour, 1.2));
        if few {
            let case = answer.case(job);
            let words: Vec<&str> = case
                .variant
                .iter()
                .chain(&case.texts)
                .map(String::as_str)
                .collect();
            plot.key(
                Key::Line(Line::new(colour, 2.2)),
                format!("{} {}", words.join(", "), answer.motion_of(job)),
            );
        }
    }
    plot.svg(label)
}

/// Half way between values, and as far beyond the ends.
fn edges(values: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return vec![0.0, 1.0];
    };
    let ends = if values.len() > 1 {
        [0.5 * (values[1] - first), 0.5 * (last - values[values.len() - 2])]
    } else {
        [0.5 * first.abs().max(1.0); 2]
    };
    let mut edges = vec![first - ends[0]];
    edges.extend(values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    edges.push(last + ends[1]);
    edges
}

/// One number of the swings of releases against their amplitude.
fn release(
    maps: &[&FrameMaps],
    (name, factor): (&str, f64),
    value: impl Fn(&dolmen::dynamics::AtAmplitude) -> f64,
    language: Language,
) -> String {
    let points = |map: &FrameMaps| -> Vec<[f64; 2]> {
        let each = map
            .release
            .iter()
            .map(|swing| [1e3 * swing.amplitude_m, factor * value(swing)]);
        each.filter(|point| point[1].is_finite()).collect()
    };
    let all: Vec<[f64; 2]> = maps.iter().flat_map(|map| points(map)).collect();
    let of = |k: usize| -> Vec<f64> { all.iter().map(|point| point[k]).collect() };
    let most = of(1).into_iter().fold(0.0, f64::max);
    let x = Axis::logarithmic(
        language.pick("Amplitude at the top (mm)", "상단 진폭 (mm)"),
        &of(0),
    );
    let y = Axis::linear(name, 0.0, 1.1 * most, 6);
    let mut plot = Plot::new(SIZE_PX, x, y);
    for (i, map) in maps.iter().enumerate() {
        let colour = SERIES[i % SERIES.len()];
        let own = points(map);
        for point in &own {
            plot.sized_dot(*point, Shape::Circle, 2.5, colour);
        }
        plot.line(own, Line::new(colour, 1.2));
        let label = if map.label.is_empty() {
            language.pick("release", "자유진동").to_owned()
        } else {
            map.label.clone()
        };
        plot.key(Key::Line(Line::new(colour, 2.2)), label);
    }
    plot.svg(name)
}
