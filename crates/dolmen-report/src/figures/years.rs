//! A structure over the years on one time axis: frequencies with their explanation, each survey compared with earlier ones, T², tilt.

use super::axis::{Axis, Scale, Tick};
use super::ink::{Anchor, BLACK, GREY, Label, Line, SERIES, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Titles, say};
use crate::watch::{damage_name, label};
use dolmen::monitoring::{TiltTrend, WatchedMode};
use dolmen_words::message::Both;
use dolmen_words::{Language, Quantity, messages};
use dolmen_work::inspected::WatchedDamage;
use dolmen_work::watched::WatchAnswer;
use dolmen_work::watched_log::WatchedLog;

/// Days of a year, for the axis of time.
const YEAR_DAYS: f64 = 365.2425;
/// Height of a panel, and the gap between two, px of the plot's height.
const PANEL_PX: f64 = 150.0;
const GAP: f64 = 0.12;
/// Largest number of time ticks.
const TICKS_MOST: f64 = 10.0;

messages! {
    /// Names of the panels.
    pub(crate) enum Panels in "figure.years" {
        Frequencies => { en: "Frequency, relative to its median (%)", ko: "중앙값 대비 고유진동수 (%)" },
        Average => { en: "Moving average over its limit (–)", ko: "이동평균/한계 (–)" },
        TSquared => { en: "T² over its limit (–)", ko: "T²/한계 (–)" },
        Tilt => { en: "Tilt (mm/m)", ko: "기울기 (mm/m)" },
        Logged { label: Both, unit: String } => { en: "{label} ({unit})", ko: "{label} ({unit})" },
        Damages => { en: "Damage by inspections (mm)", ko: "점검에서 잰 손상 (mm)" },
        Trend => { en: "trend of a log", ko: "연속 기록의 추세" },
        Mode { frequency: Quantity } => { en: "{frequency}", ko: "{frequency}" },
        Explained => { en: "explained", ko: "모델의 설명값" },
        Alarm => { en: "confirmed alarm", ko: "확정된 경보" },
        Earthquake => { en: "earthquake", ko: "지진" },
        Works => { en: "works, events", ko: "보수·사건" },
    }
}

/// Contents of one panel.
struct Panel {
    name: String,
    lines: Vec<(Vec<[f64; 2]>, Line)>,
    dots: Vec<([f64; 2], Shape, f64, &'static str)>,
    /// Values that the range must contain.
    within: Vec<f64>,
}

impl Panel {
    fn new(name: Panels, language: Language) -> Self {
        Panel {
            name: say(name, language),
            lines: Vec::new(),
            dots: Vec::new(),
            within: Vec::new(),
        }
    }

    fn values(&self) -> Vec<f64> {
        let of_lines = self
            .lines
            .iter()
            .flat_map(|(points, _)| points.iter().map(|p| p[1]));
        let of_dots = self.dots.iter().map(|(at, ..)| at[1]);
        of_lines
            .chain(of_dots)
            .chain(self.within.iter().copied())
            .collect()
    }
}

/// All data of a history on one time axis.
pub fn years(answer: &WatchAnswer, language: Language) -> String {
    let when: Vec<f64> = answer
        .surveys
        .iter()
        .map(|survey| 1970.0 + survey.day / YEAR_DAYS)
        .collect();
    let mut panels = Vec::new();
    if !answer.watched.modes.is_empty() {
        panels.push(frequencies(answer, &when, language));
        panels.push(averages(answer, &when, language));
    }
    panels.extend(t_squared(answer, &when, language));
    panels.extend(tilts(answer, &when, language));
    let logs = answer.logs.iter().enumerate();
    panels.extend(logs.filter_map(|(i, log)| logged(log, colour(i), language)));
    panels.extend(damages(answer, language));
    let count = panels.len() as f64;
    let x = time_axis(&all_times(answer, &when));
    let (mut ticks, mut drawn) = (Vec::new(), Vec::new());
    for (i, panel) in panels.iter().enumerate() {
        let own = Axis::around("", &panel.values(), 4);
        let base = (count - 1.0 - i as f64) * (1.0 + GAP);
        let up = move |value: f64| base + (value - own.from) / (own.to - own.from);
        ticks.extend(own.ticks.iter().map(|tick| Tick {
            at: up(tick.at),
            text: tick.text.clone(),
        }));
        drawn.push((base, up));
    }
    let y = Axis {
        name: String::new(),
        from: 0.0,
        to: count * (1.0 + GAP),
        scale: Scale::Linear,
        ticks,
        grid: true,
    };
    let mut plot = Plot::new([720.0, 70.0 + PANEL_PX * count], x, y);
    for (i, (day, _)) in answer.works.iter().enumerate() {
        let at = 1970.0 + day / YEAR_DAYS;
        if (plot.x.from..=plot.x.to).contains(&at) {
            plot.upright(at, Line::new(GREY, 1.2).dashed());
            let label = Label::new(format!("{}", i + 1), Anchor::Start)
                .small()
                .coloured(GREY);
            plot.text([at, plot.y.to], [3.0, 8.0], label);
        }
    }
    for of in &answer.earthquakes {
        let at = 1970.0 + of.day / YEAR_DAYS;
        if (plot.x.from..=plot.x.to).contains(&at) {
            plot.upright(at, Line::new(VERMILLION, 1.4).dashed());
        }
    }
    for (panel, (base, up)) in panels.iter().zip(&drawn) {
        for (points, line) in &panel.lines {
            plot.line(points.iter().map(|[x, y]| [*x, up(*y)]).collect(), *line);
        }
        for ([x, y], shape, size, colour) in &panel.dots {
            plot.sized_dot([*x, up(*y)], *shape, *size, colour);
        }
        let label = Label::new(&panel.name, Anchor::Start).small().bold();
        plot.text([plot.x.from, base + 1.0 + 0.5 * GAP], [4.0, 0.0], label);
    }
    keys(&mut plot, answer, language);
    plot.svg(say(Titles::YearsOfAStructure, language))
}

fn keys(plot: &mut Plot, answer: &WatchAnswer, language: Language) {
    for (i, mode) in answer.watched.modes.iter().enumerate() {
        let unit = dolmen_words::Unit::si("Hz");
        let frequency = Quantity::new(
            mode.track.frequency_hz,
            unit,
            dolmen_words::Digits::Significant(3),
        );
        plot.key(
            Key::Dot(Shape::Circle, colour(i)),
            say(Panels::Mode { frequency }, language),
        );
    }
    if !answer.watched.modes.is_empty() {
        plot.key(Key::Line(Line::new(GREY, 1.5)), say(Panels::Explained, language));
    }
    if answer.logs.iter().any(|log| !log.trend.line.is_empty()) {
        plot.key(Key::Line(Line::new(BLACK, 1.4)), say(Panels::Trend, language));
    }
    for (i, of) in shown_damages(answer).into_iter().enumerate() {
        plot.key(Key::Dot(DAMAGE, colour(i)), damage_name(of).text(language));
    }
    if !answer.watched.alarms.is_empty() {
        plot.key(Key::Dot(Shape::Diamond, VERMILLION), say(Panels::Alarm, language));
    }
    if !answer.earthquakes.is_empty() {
        plot.key(
            Key::Line(Line::new(VERMILLION, 1.4).dashed()),
            say(Panels::Earthquake, language),
        );
    }
    if !answer.works.is_empty() {
        plot.key(
            Key::Line(Line::new(GREY, 1.2).dashed()),
            say(Panels::Works, language),
        );
    }
}

fn colour(i: usize) -> &'static str {
    SERIES[i % SERIES.len()]
}

/// Whole years, or months if all surveys lie within two years.
fn time_axis(when: &[f64]) -> Axis {
    let (first, last) = (
        when.first().copied().unwrap_or(0.0),
        when.last().copied().unwrap_or(1.0),
    );
    let room = 0.02 * (last - first).max(0.05);
    let (from, to) = (first - room, last + room);
    let months = ((to - from) * 12.0 / TICKS_MOST).ceil().max(1.0);
    let step = if to - from > 2.0 {
        (months / 12.0).ceil() * 12.0
    } else {
        months
    };
    let start = (from * 12.0 / step).ceil() * step;
    let count = ((to * 12.0 - start) / step).floor().max(0.0) as usize;
    let ticks = (0..=count).map(|i| {
        let month = (start + i as f64 * step).round();
        let (year, of_year) = ((month / 12.0).floor(), month.rem_euclid(12.0) + 1.0);
        Tick {
            at: month / 12.0,
            text: match step % 12.0 == 0.0 {
                true => format!("{year:.0}"),
                false => format!("{year:.0}-{of_year:02.0}"),
            },
        }
    });
    Axis {
        name: String::new(),
        from,
        to,
        scale: Scale::Linear,
        ticks: ticks.collect(),
        grid: true,
    }
}

fn frequencies(answer: &WatchAnswer, when: &[f64], language: Language) -> Panel {
    let mut panel = Panel::new(Panels::Frequencies, language);
    let size = dot_size(when.len());
    for (i, mode) in answer.watched.modes.iter().enumerate() {
        let relative = |hz: f64| 100.0 * (hz / mode.track.frequency_hz - 1.0);
        for (survey, at) in when.iter().enumerate() {
            let found = mode.track.modes.get(survey).copied().flatten();
            let frequency = found.and_then(|j| answer.surveys[survey].frequencies_hz.get(j));
            if let Some(hz) = frequency {
                panel
                    .dots
                    .push(([*at, relative(*hz)], Shape::Circle, size, colour(i)));
            }
        }
        let explained: Vec<[f64; 2]> = when
            .iter()
            .zip(&mode.explained_hz)
            .filter_map(|(at, hz)| Some([*at, relative((*hz)?)]))
            .collect();
        panel
            .lines
            .push((explained, Line::new(colour(i), 1.2).faint(0.6)));
    }
    panel
}

fn dot_size(surveys: usize) -> f64 {
    if surveys > 150 { 1.4 } else { 2.6 }
}

fn averages(answer: &WatchAnswer, when: &[f64], language: Language) -> Panel {
    let mut panel = Panel::new(Panels::Average, language);
    panel.within = vec![-1.1, 1.1];
    let ends = [
        when.first().copied().unwrap_or(0.0),
        when.last().copied().unwrap_or(1.0),
    ];
    for limit in [-1.0, 1.0] {
        panel.lines.push((
            vec![[ends[0], limit], [ends[1], limit]],
            Line::new(VERMILLION, 1.0).dashed(),
        ));
    }
    for (i, mode) in answer.watched.modes.iter().enumerate() {
        panel.lines.extend(
            average(mode, when)
                .into_iter()
                .map(|points| (points, Line::new(colour(i), 1.3))),
        );
        for alarm in &mode.judged.alarms {
            let judged = mode
                .judged
                .judged
                .iter()
                .find(|judged| judged.survey == alarm.survey);
            if let Some(judged) = judged {
                let at = [when[alarm.survey], judged.average];
                panel.dots.push((at, Shape::Diamond, 4.5, VERMILLION));
            }
        }
    }
    panel
}

/// Consecutive surveys with a verdict.
fn average(mode: &WatchedMode, when: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let mut runs: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    for judged in &mode.judged.judged {
        let is_alarm = mode
            .judged
            .alarms
            .iter()
            .any(|alarm| alarm.survey == judged.survey);
        if judged.score.is_ok() {
            let last = runs.len() - 1;
            runs[last].push([when[judged.survey], judged.average]);
        }
        if is_alarm {
            runs.push(Vec::new());
        }
    }
    runs.retain(|run| run.len() > 1);
    runs
}

fn t_squared(answer: &WatchAnswer, when: &[f64], language: Language) -> Option<Panel> {
    let all = &answer.watched.t_squared;
    let (first, last) = (all.first()?, all.last()?);
    let mut panel = Panel::new(Panels::TSquared, language);
    panel.within = vec![0.0, 1.1];
    let ends = [when[first.survey], when[last.survey]];
    panel.lines.push((
        vec![[ends[0], 1.0], [ends[1], 1.0]],
        Line::new(VERMILLION, 1.0).dashed(),
    ));
    // values far beyond the limit are drawn just beyond it
    const SHOWN_MOST: f64 = 3.0;
    let dots = all.iter().map(|found| {
        let ratio = (found.value / found.limit).min(SHOWN_MOST);
        let is_outside = found.value > found.limit;
        let colour = if is_outside { VERMILLION } else { GREY };
        (
            [when[found.survey], ratio],
            Shape::Circle,
            dot_size(when.len()),
            colour,
        )
    });
    panel.dots = dots.collect();
    Some(panel)
}

/// The first and the last time of surveys, logs and inspections.
fn all_times(answer: &WatchAnswer, when: &[f64]) -> Vec<f64> {
    let spans = answer.logs.iter().filter_map(|log| log.span()).flatten();
    let mut all: Vec<f64> = spans.map(|day| 1970.0 + day / YEAR_DAYS).collect();
    all.extend(when);
    let inspections = answer.inspected.inspections.iter();
    all.extend(inspections.map(|of| 1970.0 + of.day / YEAR_DAYS));
    all.extend(answer.earthquakes.iter().map(|of| 1970.0 + of.day / YEAR_DAYS));
    all.sort_by(f64::total_cmp);
    all
}

/// Largest number of drawn points of a log, and the gap at which its line breaks, days.
const LOGGED_MOST: usize = 1500;
const GAP_DAYS: f64 = 15.0;

/// Daily readings, the trend through them, and the limit if it is near.
fn logged(log: &WatchedLog, colour: &'static str, language: Language) -> Option<Panel> {
    let [first, last] = log.span()?;
    let daily = &log.trend.daily;
    let at = |day: f64| 1970.0 + day / YEAR_DAYS;
    let (days, values) = (&daily.days, &daily.values);
    let together = days.len().div_ceil(LOGGED_MOST);
    let mut panel = Panel::new(
        Panels::Logged {
            label: label(log),
            unit: if log.is_tilt() { "mm/m" } else { "mm" }.to_owned(),
        },
        language,
    );
    let mut runs: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    let mut before = first;
    for (some, read) in days.chunks(together).zip(values.chunks(together)) {
        let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
        if some[0] - before > GAP_DAYS * together as f64 {
            runs.push(Vec::new());
        }
        before = some[some.len() - 1];
        if let Some(run) = runs.last_mut() {
            run.push([at(mean(some)), 1000.0 * mean(read)]);
        }
    }
    let drawn = runs.into_iter().filter(|run| run.len() > 1);
    panel.lines = drawn
        .map(|run| (run, Line::new(colour, 0.8).faint(0.7)))
        .collect();
    let trend = days
        .iter()
        .zip(&log.trend.line)
        .map(|(day, value)| [at(*day), 1000.0 * value]);
    let trend: Vec<[f64; 2]> = trend.step_by(together).collect();
    if trend.len() > 1 {
        panel.lines.push((trend, Line::new(BLACK, 1.4)));
    }
    let farthest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let limit = log.trend.limit.filter(|limit| limit.size < 3.0 * farthest);
    if let Some(limit) = limit {
        let side = if log.trend.now < 0.0 && !limit.is_one_sided {
            -1.0
        } else {
            1.0
        };
        let size = 1000.0 * side * limit.size;
        let ends = vec![[at(first), size], [at(last), size]];
        panel.lines.push((ends, Line::new(VERMILLION, 1.0).dashed()));
    }
    Some(panel)
}

fn tilts(answer: &WatchAnswer, when: &[f64], language: Language) -> Option<Panel> {
    let trends: Vec<&TiltTrend> = answer
        .watched
        .tilts
        .iter()
        .filter(|trend| trend.series.days.len() > 1)
        .collect();
    if trends.is_empty() {
        return None;
    }
    let mut panel = Panel::new(Panels::Tilt, language);
    let names: Vec<String> = trends
        .iter()
        .map(|trend| trend.series.direction.clone())
        .collect();
    panel.name = format!("{}: {}", panel.name, names.join(", "));
    for (i, trend) in trends.iter().enumerate() {
        let points: Vec<[f64; 2]> = trend
            .series
            .surveys
            .iter()
            .zip(&trend.series.ratios)
            .map(|(survey, ratio)| [when[*survey], 1000.0 * ratio])
            .collect();
        let colour = colour(i + answer.watched.modes.len());
        panel
            .dots
            .extend(points.iter().map(|at| (*at, Shape::Square, 2.4, colour)));
        panel.lines.push((points, Line::new(colour, 1.0)));
        if let Some(limit) = trend
            .slope
            .and_then(|slope| slope.reach)
            .map(|reach| 1000.0 * reach.limit)
        {
            let nearest = trend
                .series
                .ratios
                .iter()
                .fold(0.0_f64, |most, ratio| most.max(1000.0 * ratio.abs()));
            // a distant limit would flatten the measurements
            if limit.abs() < 3.0 * nearest {
                let ends = [
                    when.first().copied().unwrap_or(0.0),
                    when.last().copied().unwrap_or(1.0),
                ];
                panel.lines.push((
                    vec![[ends[0], limit], [ends[1], limit]],
                    Line::new(VERMILLION, 1.0).dashed(),
                ));
            }
        }
    }
    Some(panel)
}

/// Number of damages in the panel of inspections: the worst ones.
const DAMAGES_MOST: usize = 5;
/// Their marker; modes and tilts with the same colours have circles.
const DAMAGE: Shape = Shape::Square;

/// Damages with more than one reading.
fn shown_damages(answer: &WatchAnswer) -> Vec<&WatchedDamage> {
    let all = answer.inspected.damages.iter();
    all.filter(|of| of.readings.len() > 1)
        .take(DAMAGES_MOST)
        .collect()
}

/// Sizes of damage from inspections, and their limits if near.
fn damages(answer: &WatchAnswer, language: Language) -> Option<Panel> {
    let shown = shown_damages(answer);
    if shown.is_empty() {
        return None;
    }
    let mut panel = Panel::new(Panels::Damages, language);
    panel.within = vec![0.0];
    let at = |day: f64| 1970.0 + day / YEAR_DAYS;
    for (i, of) in shown.iter().enumerate() {
        let points: Vec<[f64; 2]> = of
            .readings
            .iter()
            .map(|read| [at(read.day), 1000.0 * read.size_m])
            .collect();
        let ends = [points[0][0], points[points.len() - 1][0]];
        let largest = points.iter().fold(0.0_f64, |most, point| most.max(point[1]));
        let dots = points.iter().map(|point| (*point, DAMAGE, 2.8, colour(i)));
        panel.dots.extend(dots);
        panel.lines.push((points, Line::new(colour(i), 1.0)));
        let limit = of.limit_m.map(|limit| 1000.0 * limit);
        // a distant limit would flatten the measurements
        if let Some(limit) = limit.filter(|limit| *limit < 3.0 * largest) {
            let line = Line::new(colour(i), 1.0).dashed();
            panel.lines.push((vec![[ends[0], limit], [ends[1], limit]], line));
        }
    }
    Some(panel)
}
