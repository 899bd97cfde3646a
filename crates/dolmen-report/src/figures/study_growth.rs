//! Figures of a study: response of its runs as the shaking increases (incremental dynamic analysis), maps of slipping, releases.

use super::axis::Axis;
use super::ink::{Anchor, BLUE, GREY, Label, Line, SERIES, SKY, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::study_drawing::{SIZE_PX, StudyDrawing, StudyFigure};
use super::words::{Axes, Growth, Studied, Titles, say};
use dolmen_words::Language;
use dolmen_work::study::{ResponseMaps, Run, RunOutcome, StudyAnswer, StudyKind, input_words};

/// Colours of a share, the smallest first: from nothing to all of the time.
const SHARES: [(f64, &str, f64); 5] = [
    (0.0, SKY, 0.12),
    (0.05, SKY, 0.45),
    (0.2, SKY, 0.9),
    (0.4, BLUE, 0.75),
    (0.6, BLUE, 1.0),
];

/// Figures of increasing shaking, of maps and of releases.
pub(super) fn growth_figures(answer: &StudyAnswer, language: Language) -> Vec<StudyDrawing> {
    let mut figures = Vec::new();
    let mut add = |shows, name: String, svg: String| figures.push(StudyDrawing::new(shows, name, svg));
    if answer.study.scan.is_some() {
        let told = grown(answer.kind).into_iter();
        for one in told.filter(|one| is_reached(answer, one.measure)) {
            let name = format!("growth-{}", one.measure);
            add(StudyFigure::Growth, name, growth(answer, one, language));
        }
    }
    for map in &answer.maps {
        if !map.harmonic.is_empty() {
            for part in 0..map.parts.len() {
                let svg = harmonic(answer, map, part, language);
                let name = format!("harmonic-{}-{}", map.case + 1, part + 1);
                add(StudyFigure::Harmonic, name, svg);
            }
        }
    }
    let released: Vec<&ResponseMaps> = answer.maps.iter().filter(|map| !map.release.is_empty()).collect();
    if !released.is_empty() {
        let frequency = (Axes::ApparentFrequency, 1.0);
        add(
            StudyFigure::Release,
            "release-frequency".to_owned(),
            release(
                &released,
                frequency,
                |swing| swing.apparent_frequency_hz,
                language,
            ),
        );
        let damping = (Axes::EquivalentDamping, 100.0);
        add(
            StudyFigure::Release,
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

/// Whether a number is nonzero in some run.
fn is_reached(answer: &StudyAnswer, measure: &str) -> bool {
    const NOTHING: f64 = 1e-6;
    let of = |run: &Run| run.measures.named(measure);
    answer
        .runs
        .iter()
        .any(|run| of(run).is_some_and(|value| value > NOTHING))
}

/// A number of the runs that is drawn against the shaking.
struct GrowthMeasure {
    /// Its name among the measures of a run.
    measure: &'static str,
    axis: Growth,
    /// Factor from the measure to the unit of the axis.
    factor: f64,
}

/// The numbers of a run that are drawn against the shaking.
fn grown(kind: StudyKind) -> Vec<GrowthMeasure> {
    let all = match kind {
        StudyKind::Stack => vec![
            ("peak_rocking_ratio", Growth::RockingRatio, 1.0),
            ("residual_slip_ratio", Growth::ResidualSlip, 100.0),
        ],
        StudyKind::Frame => vec![
            ("peak_drift_m", Growth::PeakDrift, 1e3),
            ("slipping_share", Growth::SlippingTime, 100.0),
            ("residual_drift_m", Growth::ResidualDrift, 1e3),
        ],
        StudyKind::Chain => vec![
            ("peak_top_displacement_m", Growth::TopDisplacement, 1e3),
            ("peak_joint_rotation_rad", Growth::JointRotation, 1e3),
            ("open_share", Growth::OpenTime, 100.0),
        ],
        StudyKind::Building => vec![
            ("peak_corner_drift_ratio", Growth::DriftRatio, 100.0),
            ("peak_stroke_m", Growth::Stroke, 1e3),
        ],
    };
    let each = all.into_iter();
    each.map(|(measure, axis, factor)| GrowthMeasure {
        measure,
        axis,
        factor,
    })
    .collect()
}

/// Share of slipping of a storey, or of opening and slipping of a joint, over frequency and acceleration of the ground.
fn harmonic(answer: &StudyAnswer, map: &ResponseMaps, part: usize, language: Language) -> String {
    let gravity = answer.gravity_m_s2;
    let name = map.parts.get(part).map_or("", String::as_str);
    let is_chain = answer.kind == StudyKind::Chain;
    let (still, moves, fell, title) = match is_chain {
        false => (
            Studied::WhiteStuck,
            Studied::SlipsUpToFive,
            Studied::AtDriftLimit,
            Titles::SlippingShare,
        ),
        true => (
            Studied::WhiteClosed,
            Studied::MovesUpToFive,
            Studied::FellOver,
            Titles::MovingShare,
        ),
    };
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
    let x = Axis::linear(say(Axes::FrequencyOfTheGround, language), x0, x1, 8);
    let mut y = Axis::logarithmic(
        say(Axes::AccelerationOfTheGround, language),
        &accelerations,
        language,
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
        let share = point.moving_share.get(part).copied().unwrap_or(0.0);
        if point.fell {
            plot.block(from, to, VERMILLION, 0.85);
        } else if share > 0.0 {
            let step = SHARES
                .iter()
                .rev()
                .find(|(least, ..)| share > *least)
                .unwrap_or(&SHARES[0]);
            plot.block(from, to, step.1, step.2);
        }
        if !point.steady && !point.fell {
            plot.sized_dot([point.frequency_hz, acceleration], Shape::Ring, 2.0, GREY);
        }
    }
    plot.key(Key::Block(SKY, 0.0), say(still, language));
    let moves = say(moves, language);
    for (least, colour, opacity) in SHARES {
        let text = if least == 0.0 {
            moves.clone()
        } else {
            format!("> {:.0} %", 100.0 * least)
        };
        plot.key(Key::Block(colour, opacity), text);
    }
    plot.key(Key::Block(VERMILLION, 0.85), say(fell, language));
    plot.key(Key::Dot(Shape::Ring, GREY), say(Studied::NotSteady, language));
    let words = if map.label.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {}", map.label)
    };
    plot.text([x1, y0], [-8.0, -14.0], Label::new(words, Anchor::End).bold());
    plot.svg(say(title, language))
}

/// One number of the runs without a fall against the peak of the ground, one line per scan; falls are on the upper edge.
fn growth(answer: &StudyAnswer, grown: GrowthMeasure, language: Language) -> String {
    let GrowthMeasure {
        measure,
        axis,
        factor,
    } = grown;
    let label = say(axis, language);
    const NAMED_MOST: usize = SERIES.len();
    let scans: Vec<(usize, Vec<[f64; 2]>)> = answer
        .runs
        .chunk_by(|a, b| a.job == b.job)
        .filter_map(|runs| {
            let stood = runs.iter().filter(|run| !falls(answer.kind, run));
            let points = stood.filter_map(|run| {
                let value = run.measures.named(measure)?;
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
    let peaks = answer.runs.iter().filter(|run| !run.measures.is_none());
    let peaks: Vec<f64> = peaks
        .map(|run| run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2)
        .collect();
    let most = all.iter().map(|point| point[1]).fold(1e-9, f64::max);
    let x = Axis::logarithmic(say(Axes::PeakGroundAcceleration, language), &peaks, language);
    let mut plot = Plot::new(SIZE_PX, x, Axis::linear(label.clone(), 0.0, 1.16 * most, 6));
    let few = scans.len() <= NAMED_MOST;
    for (i, (job, points)) in scans.into_iter().enumerate() {
        let colour = if few { SERIES[i % SERIES.len()] } else { SKY };
        for point in points.iter().filter(|_| few) {
            plot.sized_dot(*point, Shape::Circle, 2.5, colour);
        }
        plot.line(points, Line::new(colour, if few { 1.2 } else { 0.8 }));
        let fell = answer
            .runs
            .iter()
            .filter(|run| run.job == job && falls(answer.kind, run));
        for run in fell {
            let at = [
                run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2,
                (1.04 + 0.04 * (i % 3) as f64) * most,
            ];
            plot.sized_dot(at, Shape::Cross, 3.0, colour);
        }
        if few {
            let inputs = answer.inputs.iter().zip(answer.values_shown(job));
            let varied =
                inputs.map(|(input, value)| format!("{} {value}", input_words(&input.path, language)));
            let words: Vec<String> = answer.case(job).variant.iter().cloned().chain(varied).collect();
            plot.key(
                Key::Line(Line::new(colour, 2.2)),
                format!("{} {}", words.join(", "), answer.motion_of(job)),
            );
        }
    }
    if !few {
        fractiles(&mut plot, answer, (measure, factor), 1.04 * most, language);
    }
    if answer.runs.iter().any(|run| falls(answer.kind, run)) {
        let fell = match answer.kind {
            StudyKind::Stack => Studied::Fell,
            StudyKind::Chain | StudyKind::Frame | StudyKind::Building => Studied::FellOver,
        };
        plot.key(Key::Dot(Shape::Cross, GREY), say(fell, language));
    }
    plot.svg(label)
}

/// The median and the middle two thirds of the scans, at the peaks common to all scans; a fall is larger than any number.
fn fractiles(
    plot: &mut Plot,
    answer: &StudyAnswer,
    (measure, factor): (&str, f64),
    most: f64,
    language: Language,
) {
    let scans = answer.runs.chunk_by(|a, b| a.job == b.job).count();
    let usable = |run: &&Run| falls(answer.kind, run) || !run.measures.is_none();
    let mut runs: Vec<&Run> = answer.runs.iter().filter(usable).collect();
    runs.sort_by(|a, b| {
        let [a, b] = [a, b].map(|run| run.peak_ground_acceleration_m_s2);
        a.total_cmp(&b)
    });
    let same = |a: &&Run, b: &&Run| {
        let [a, b] = [a, b].map(|run| run.peak_ground_acceleration_m_s2);
        (a - b).abs() <= 1e-9 * b
    };
    let mut lines = [const { Vec::new() }; 3];
    for at_peak in runs.chunk_by(same).filter(|runs| runs.len() == scans) {
        let value = |run: &&Run| match falls(answer.kind, run) {
            true => f64::INFINITY,
            false => factor * run.measures.named(measure).unwrap_or(f64::NAN),
        };
        let mut values: Vec<f64> = at_peak.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        let x = at_peak[0].peak_ground_acceleration_m_s2 / answer.gravity_m_s2;
        for (line, part) in lines.iter_mut().zip([0.16, 0.5, 0.84]) {
            let value = values[((values.len() - 1) as f64 * part).round() as usize];
            if value <= most {
                line.push([x, value]);
            }
        }
    }
    for (line, dashed) in lines.into_iter().zip([true, false, true]) {
        let stroke = Line::new(VERMILLION, 2.0);
        plot.line(line, if dashed { stroke.dashed() } else { stroke });
    }
    plot.key(
        Key::Line(Line::new(VERMILLION, 2.0)),
        say(Studied::MedianWithSpread, language),
    );
}

/// Whether a run ended in a fall: its values until then are meaningless.
fn falls(kind: StudyKind, run: &Run) -> bool {
    !matches!(kind, StudyKind::Frame | StudyKind::Building) && run.outcome == RunOutcome::Fell
}

/// Midpoints between values, extended beyond the ends.
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

/// One number of the cycles of releases against their amplitude.
fn release(
    maps: &[&ResponseMaps],
    (axis, factor): (Axes, f64),
    value: impl Fn(&dolmen::dynamics::AtAmplitude) -> f64,
    language: Language,
) -> String {
    let points = |map: &ResponseMaps| -> Vec<[f64; 2]> {
        let each = map
            .release
            .iter()
            .map(|swing| [1e3 * swing.amplitude_m, factor * value(swing)]);
        each.filter(|point| point[1].is_finite()).collect()
    };
    let all: Vec<[f64; 2]> = maps.iter().flat_map(|map| points(map)).collect();
    let of = |k: usize| -> Vec<f64> { all.iter().map(|point| point[k]).collect() };
    let most = of(1).into_iter().fold(0.0, f64::max);
    let x = Axis::logarithmic(say(Axes::AmplitudeAtTheTop, language), &of(0), language);
    let name = say(axis, language);
    let y = Axis::linear(name.as_str(), 0.0, 1.1 * most, 6);
    let mut plot = Plot::new(SIZE_PX, x, y);
    for (i, map) in maps.iter().enumerate() {
        let colour = SERIES[i % SERIES.len()];
        let own = points(map);
        for point in &own {
            plot.sized_dot(*point, Shape::Circle, 2.5, colour);
        }
        plot.line(own, Line::new(colour, 1.2));
        let label = if map.label.is_empty() {
            say(Studied::Release, language)
        } else {
            map.label.clone()
        };
        plot.key(Key::Line(Line::new(colour, 2.2)), label);
    }
    plot.svg(name)
}
