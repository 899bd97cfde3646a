//! A simulated motion of a frame: what the ground did, where the levels went, loops of force and drift, sticking and slipping.

use super::Figure;
use super::axis::Axis;
use super::ink::{GREY, Line, SERIES};
use super::plot::{Key, Plot};
use super::stack_histories::{Series, plot};
use dolmen::dynamics::FrameEnergy;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::{Component, GroundMotion};
use dolmen_words::Language;
use dolmen_work::frame::FrameSimulation;

/// Width and height of a loop, px: nearly square.
const LOOP_PX: [f64; 2] = [420.0, 340.0];
/// Width of the bands, px, and height of one.
const BANDS_PX: f64 = 760.0;
const BAND_PX: f64 = 34.0;

/// Acceleration of the ground in one direction, g.
pub(super) fn ground(motion: &GroundMotion, component: Component) -> Series {
    let samples = motion.acceleration_m_s2(component).iter().enumerate();
    Series {
        name: motion.name().to_owned(),
        points: samples
            .map(|(i, a)| [i as f64 * motion.time_step_s(), a / STANDARD_GRAVITY_M_S2])
            .collect(),
    }
}

/// A figure of a simulated frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FramePlot {
    Ground,
    Levels,
    /// Force against drift of a storey, 0 the lowest.
    Loop(usize),
    Slips,
    Energy,
}

impl FramePlot {
    /// Those of a simulation, in the order in which they are shown.
    pub(crate) fn all(simulation: &FrameSimulation) -> Vec<Self> {
        let mut all = vec![Self::Ground, Self::Levels];
        all.extend((0..simulation.storeys.len()).map(Self::Loop));
        all.extend((!simulation.history.slips.is_empty()).then_some(Self::Slips));
        all.push(Self::Energy);
        all
    }

    fn name(self) -> String {
        match self {
            Self::Ground => "ground".to_owned(),
            Self::Levels => "levels".to_owned(),
            Self::Loop(storey) => format!("loop-{}", storey + 1),
            Self::Slips => "slips".to_owned(),
            Self::Energy => "energy".to_owned(),
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, simulation: &FrameSimulation, language: Language) -> Option<String> {
        match self {
            Self::Ground => {
                let ground = ground(&simulation.motion.motion, simulation.component);
                let title = language.pick("Acceleration of the ground", "지반 가속도");
                plot(
                    &[ground],
                    language.pick("Acceleration (g)", "가속도 (g)"),
                    language,
                    title,
                )
            }
            Self::Levels => levels(simulation, language),
            Self::Loop(storey) => Some(hysteresis(simulation, storey, language)),
            Self::Slips => Some(bands(simulation, language)),
            Self::Energy => energy(simulation, language),
        }
    }
}

/// The figures of a simulation: ground, levels, one loop a storey, bands of slipping, energy.
pub fn frame_histories(simulation: &FrameSimulation, language: Language) -> Vec<Figure> {
    let all = FramePlot::all(simulation).into_iter();
    all.filter_map(|plot| {
        let svg = plot.draw(simulation, language)?;
        Some(Figure {
            name: plot.name(),
            svg,
        })
    })
    .collect()
}

fn over_time(simulation: &FrameSimulation, values: &[f64], factor: f64) -> Vec<[f64; 2]> {
    let pairs = simulation.history.time_s.iter().zip(values);
    pairs.map(|(t, y)| [*t, factor * y]).collect()
}

fn levels(simulation: &FrameSimulation, language: Language) -> Option<String> {
    let levels: Vec<Series> = (0..simulation.storeys.len())
        .map(|level| Series {
            name: simulation.storeys[level].clone(),
            points: over_time(simulation, &simulation.history.displacement_m[level], 1e3),
        })
        .collect();
    let name = language.pick("Displacement (mm)", "변위 (mm)");
    let title = language.pick("Displacement at the top of each storey", "각 층 상단의 변위");
    plot(&levels, name, language, title)
}

fn energy(simulation: &FrameSimulation, language: Language) -> Option<String> {
    let part = |name: &str, value: fn(&FrameEnergy) -> f64| {
        let values: Vec<f64> = simulation.history.energy.iter().map(value).collect();
        Series {
            name: name.to_owned(),
            points: over_time(simulation, &values, 1e-3),
        }
    };
    let parts = [
        part(language.pick("put in", "입력"), |e| e.input_j),
        part(language.pick("taken by friction", "마찰 소산"), |e| {
            e.friction_j
        }),
        part(language.pick("taken by dashpots", "점성 소산"), |e| {
            e.damping_j
        }),
        part(language.pick("moving and in springs", "운동·탄성"), |e| {
            e.kinetic_j + e.stored_j
        }),
    ];
    let name = language.pick("Energy (kJ)", "에너지 (kJ)");
    plot(
        &parts,
        name,
        language,
        language.pick("Where the energy went", "에너지 수지"),
    )
}

/// Force of a storey against its drift.
fn hysteresis(simulation: &FrameSimulation, storey: usize, language: Language) -> String {
    let drift: Vec<f64> = simulation
        .history
        .drift_m(storey)
        .iter()
        .map(|d| 1e3 * d)
        .collect();
    let force: Vec<f64> = simulation
        .storey_force_n(storey)
        .iter()
        .map(|f| 1e-3 * f)
        .collect();
    let names = [
        language.pick("Drift (mm)", "층간변위 (mm)"),
        language.pick("Force of the storey (kN)", "층 전단력 (kN)"),
    ];
    let title = language.pick("Force against drift", "층 전단력-층간변위 이력곡선");
    loops(
        names,
        [&drift, &force],
        (storey, &simulation.storeys[storey]),
        title,
    )
}

/// Values against each other, as one line; its number among others and its name.
pub(super) fn loops(
    names: [&str; 2],
    [x_values, y_values]: [&[f64]; 2],
    (number, name): (usize, &str),
    title: &str,
) -> String {
    let around = |name: &str, values: &[f64]| {
        let axis = Axis::around(name, values, 5);
        if axis.to - axis.from < 1e-6 {
            Axis::linear(name, -1.0, 1.0, 4)
        } else {
            axis
        }
    };
    let (x, y) = (around(names[0], x_values), around(names[1], y_values));
    let (x_ends, y_ends) = ([x.from, x.to], [y.from, y.to]);
    let mut plot = Plot::new(LOOP_PX, x, y);
    plot.line(vec![[x_ends[0], 0.0], [x_ends[1], 0.0]], Line::new(GREY, 0.6));
    plot.line(vec![[0.0, y_ends[0]], [0.0, y_ends[1]]], Line::new(GREY, 0.6));
    let line = Line::new(SERIES[number % SERIES.len()], 1.0);
    plot.line(
        x_values.iter().zip(y_values).map(|(x, y)| [*x, *y]).collect(),
        line,
    );
    plot.key(Key::Line(Line { width: 2.2, ..line }), name);
    plot.svg(title)
}

/// When each storey slipped: a band a storey.
fn bands(simulation: &FrameSimulation, language: Language) -> String {
    let history = &simulation.history;
    let end = history.time_s.last().copied().unwrap_or(1.0);
    let each: Vec<(usize, [f64; 2])> = history
        .slips
        .iter()
        .map(|s| (s.storey, [s.from_s, s.to_s]))
        .collect();
    let words = [
        language.pick("slips", "미끄러짐"),
        language.pick("When each storey slipped", "층별 미끄러짐 시각"),
    ];
    rows_of_bands(&simulation.storeys, &each, end, words, language)
}

/// A row of bands a part: its number, from when to when; the word for a band, and the title.
pub(super) fn rows_of_bands(
    names: &[String],
    bands: &[(usize, [f64; 2])],
    end_s: f64,
    [word, title]: [&str; 2],
    language: Language,
) -> String {
    let size = [BANDS_PX, 90.0 + BAND_PX * names.len() as f64];
    let x = Axis::linear(language.pick("Time (s)", "시간 (s)"), 0.0, end_s, 10);
    let mut plot = Plot::new(size, x, Axis::rows(names));
    for (part, [from_s, to_s]) in bands {
        let (row, colour) = (*part as f64, SERIES[part % SERIES.len()]);
        plot.block([*from_s, row - 0.32], [*to_s, row + 0.32], colour, 0.8);
    }
    for part in 0..names.len() {
        let row = part as f64;
        plot.line(vec![[0.0, row], [end_s, row]], Line::new(GREY, 0.5));
    }
    plot.key(Key::Block(SERIES[0], 0.8), word);
    plot.svg(title)
}
