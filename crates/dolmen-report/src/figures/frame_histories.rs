//! A simulated motion of a frame: ground motion, displacements of levels, loops of force and drift, sticking and slipping.

use super::axis::Axis;
use super::history_series::{band_series, history_series, loop_series};
use super::identification::{Figure, drawn};
use super::ink::{GREY, Line, SERIES};
use super::lines::{Lines, Series};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen::dynamics::FrameEnergy;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::{Component, GroundMotion};
use dolmen_words::Language;
use dolmen_work::frame::{ColumnsInMotion, FrameSimulation, FrameTogether};
use std::f64::consts::TAU;

/// Width and height of a loop, px: nearly square.
const LOOP_PX: [f64; 2] = [420.0, 340.0];
/// Width and height of a drift in plan, px: equal scales.
const PLAN_PX: [f64; 2] = [420.0, 400.0];
/// Corners of a circle.
const CIRCLE: usize = 120;
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
    /// Drift of the worst storey in plan, both directions together.
    Path,
    Slips,
    Energy,
    /// Measured and simulated acceleration of a sensor, 0 the lowest.
    Measured(usize),
    /// Rotation of the columns, the frame on them alone.
    Columns,
}

impl FramePlot {
    /// The figures of a simulation, in order.
    pub(crate) fn all(simulation: &FrameSimulation) -> Vec<Self> {
        let mut all = vec![Self::Ground, Self::Levels];
        all.extend((0..simulation.storeys.len()).map(Self::Loop));
        all.extend(simulation.together_once().is_some().then_some(Self::Path));
        all.extend((!simulation.history.slips.is_empty()).then_some(Self::Slips));
        all.push(Self::Energy);
        let sensors = simulation.beside.as_ref().map_or(0, |of| of.sensors.len());
        all.extend((0..sensors).rev().map(Self::Measured));
        all.extend(matches!(simulation.columns, ColumnsInMotion::Alone(_)).then_some(Self::Columns));
        all
    }

    fn name(self) -> String {
        match self {
            Self::Ground => "ground".to_owned(),
            Self::Levels => "levels".to_owned(),
            Self::Loop(storey) => format!("loop-{}", storey + 1),
            Self::Path => "plan".to_owned(),
            Self::Slips => "slips".to_owned(),
            Self::Energy => "energy".to_owned(),
            Self::Columns => "columns".to_owned(),
            Self::Measured(sensor) => format!("measured-{}", sensor + 1),
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, simulation: &FrameSimulation, language: Language) -> Option<String> {
        match self {
            Self::Ground | Self::Levels | Self::Energy | Self::Columns | Self::Measured(_) => {
                self.lines(simulation, language)?.draw(language)
            }
            Self::Loop(storey) => Some(hysteresis(simulation, storey, language)),
            Self::Path => path(simulation, language),
            Self::Slips => Some(bands(simulation, language)),
        }
    }

    /// The numbers of the figure.
    pub(crate) fn series(self, simulation: &FrameSimulation) -> Vec<crate::document::Series> {
        match self {
            Self::Ground | Self::Levels | Self::Energy | Self::Columns | Self::Measured(_) => {
                history_series(|language| self.lines(simulation, language))
            }
            Self::Loop(storey) => loop_series(LOOP, drift_and_force(simulation, storey)),
            Self::Path => match simulation.together_once() {
                Some(together) => loop_series(plan_axes(together), path_mm(together)),
                None => Vec::new(),
            },
            Self::Slips => band_series(&simulation.storeys, &slipped(simulation)),
        }
    }

    /// The figures with lines over time.
    fn lines(self, simulation: &FrameSimulation, language: Language) -> Option<Lines> {
        match self {
            Self::Ground => Some(Lines {
                axis: Axes::Acceleration,
                title: Titles::AccelerationOfTheGround,
                lines: vec![ground(&simulation.motion.motion, simulation.component)],
            }),
            Self::Levels => Some(levels(simulation)),
            Self::Energy => Some(energy(simulation, language)),
            Self::Columns => rotations(simulation),
            Self::Measured(sensor) => measured(simulation, sensor, language),
            Self::Loop(_) | Self::Path | Self::Slips => None,
        }
    }
}

/// The figures of a simulation: ground, levels, one loop per storey, bands of slipping, energy.
pub fn frame_histories(simulation: &FrameSimulation, language: Language) -> Vec<Figure> {
    let all = FramePlot::all(simulation).into_iter();
    drawn(all.map(|plot| (plot.name(), plot.draw(simulation, language))))
}

fn over_time(simulation: &FrameSimulation, values: &[f64], factor: f64) -> Vec<[f64; 2]> {
    let pairs = simulation.history.time_s.iter().zip(values);
    pairs.map(|(t, y)| [*t, factor * y]).collect()
}

fn levels(simulation: &FrameSimulation) -> Lines {
    let levels: Vec<Series> = (0..simulation.storeys.len())
        .map(|level| Series {
            name: simulation.storeys[level].clone(),
            points: over_time(simulation, &simulation.history.displacement_m[level], 1e3),
        })
        .collect();
    Lines {
        axis: Axes::Displacement,
        title: Titles::DisplacementAtTheTopOfEachStorey,
        lines: levels,
    }
}

/// Measured and simulated acceleration of a sensor, g.
fn measured(simulation: &FrameSimulation, sensor: usize, language: Language) -> Option<Lines> {
    let all = simulation.beside.as_ref()?;
    let of = all.sensors.get(sensor)?;
    let line = |name: Signs, samples: &[f64]| Series {
        name: say(name, language),
        points: samples
            .iter()
            .enumerate()
            .map(|(i, a)| [i as f64 * all.step_s, a / STANDARD_GRAVITY_M_S2])
            .collect(),
    };
    Some(Lines {
        axis: Axes::Acceleration,
        title: Titles::MeasuredAndSimulated,
        lines: vec![
            line(Signs::AsMeasured, &of.measured_m_s2),
            line(Signs::AsSimulated, &of.simulated_m_s2),
        ],
    })
}

fn rotations(simulation: &FrameSimulation) -> Option<Lines> {
    let ColumnsInMotion::Alone(alone) = &simulation.columns else {
        return None;
    };
    let pairs = alone.history.time_s.iter().zip(&alone.history.rotation_rad);
    Some(Lines {
        axis: Axes::LinkRotation,
        title: Titles::RotationOfTheColumns,
        lines: vec![Series {
            name: simulation.storeys.first().cloned().unwrap_or_default(),
            points: pairs.map(|(t, rotation)| [*t, 1e3 * rotation]).collect(),
        }],
    })
}

fn energy(simulation: &FrameSimulation, language: Language) -> Lines {
    let part = |name: Signs, value: fn(&FrameEnergy) -> f64| {
        let values: Vec<f64> = simulation.history.energy.iter().map(value).collect();
        Series {
            name: say(name, language),
            points: over_time(simulation, &values, 1e-3),
        }
    };
    let has_tenons = simulation.frame.tenons().iter().any(Option::is_some);
    let mut parts = vec![
        part(Signs::PutIn, |e| e.input_j),
        part(Signs::TakenByFriction, |e| e.friction_j),
        part(Signs::TakenByDashpots, |e| e.damping_j),
        part(Signs::MovingAndInSprings, |e| e.kinetic_j + e.stored_j),
    ];
    parts.extend(has_tenons.then(|| part(Signs::TakenByCrushing, |e| e.crushing_j)));
    Lines {
        axis: Axes::Energy,
        title: Titles::WhereTheEnergyWent,
        lines: parts,
    }
}

/// The axes of a loop.
const LOOP: [Axes; 2] = [Axes::Drift, Axes::ForceOfTheStorey];

/// Drift of a storey, mm, and its force, kN.
fn drift_and_force(simulation: &FrameSimulation, storey: usize) -> [Vec<f64>; 2] {
    let drift_m = simulation.history.drift_m(storey);
    let force_n = simulation.storey_force_n(storey);
    [
        drift_m.iter().map(|d| 1e3 * d).collect(),
        force_n.iter().map(|f| 1e-3 * f).collect(),
    ]
}

/// Force of a storey against its drift.
fn hysteresis(simulation: &FrameSimulation, storey: usize, language: Language) -> String {
    let [drift, force] = drift_and_force(simulation, storey);
    let title = Titles::ForceAgainstDrift;
    loops(
        LOOP,
        [&drift, &force],
        (storey, &simulation.storeys[storey]),
        title,
        language,
    )
}

/// One line of values against each other, with its number and name.
pub(super) fn loops(
    names: [Axes; 2],
    [x_values, y_values]: [&[f64]; 2],
    (number, name): (usize, &str),
    title: Titles,
    language: Language,
) -> String {
    let around = |name: Axes, values: &[f64]| {
        let name = say(name, language);
        let axis = Axis::around(name.as_str(), values, 5);
        if axis.to - axis.from < 1e-6 {
            Axis::linear(name, -1.0, 1.0, 4)
        } else {
            axis
        }
    };
    let [x_name, y_name] = names;
    let (x, y) = (around(x_name, x_values), around(y_name, y_values));
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
    plot.svg(say(title, language))
}

/// The axes of a drift in plan.
fn plan_axes(together: &FrameTogether) -> [Axes; 2] {
    together
        .directions
        .clone()
        .map(|direction| Axes::DriftAlong { direction })
}

/// Drift of the worst storey in both directions, mm.
fn path_mm(together: &FrameTogether) -> [Vec<f64>; 2] {
    together
        .path_m
        .each_ref()
        .map(|drift| drift.iter().map(|d| 1e3 * d).collect())
}

/// The path of the worst storey's drift in plan, and the circle of its largest resultant.
fn path(simulation: &FrameSimulation, language: Language) -> Option<String> {
    let together = simulation.together_once()?;
    let [x, y] = path_mm(together);
    let radius = 1e3 * together.storeys[together.worst].drift_m;
    let round =
        |part: fn(f64) -> f64| (0..=CIRCLE).map(move |i| radius * part(TAU * i as f64 / CIRCLE as f64));
    let circle: Vec<[f64; 2]> = round(f64::cos)
        .zip(round(f64::sin))
        .map(|(x, y)| [x, y])
        .collect();
    let [x_name, y_name] = plan_axes(together).map(|axis| say(axis, language));
    let ends = [-radius, radius];
    let mut plot = Plot::new(
        PLAN_PX,
        Axis::around(x_name.as_str(), &ends, 5),
        Axis::around(y_name.as_str(), &ends, 5),
    );
    plot.line(circle, Line::new(GREY, 0.8));
    let line = Line::new(SERIES[together.worst % SERIES.len()], 1.0);
    plot.line(x.into_iter().zip(y).map(|(x, y)| [x, y]).collect(), line);
    plot.key(
        Key::Line(Line { width: 2.2, ..line }),
        &simulation.storeys[together.worst],
    );
    Some(plot.svg(say(Titles::DriftInPlan, language)))
}

/// When each storey slipped, s.
fn slipped(simulation: &FrameSimulation) -> Vec<(usize, [f64; 2])> {
    let each = simulation.history.slips.iter();
    each.map(|s| (s.storey, [s.from_s, s.to_s])).collect()
}

/// Slipping times of each storey, one band per storey.
fn bands(simulation: &FrameSimulation, language: Language) -> String {
    let history = &simulation.history;
    let end = history.time_s.last().copied().unwrap_or(1.0);
    let each = slipped(simulation);
    let words = (Signs::Slips, Titles::WhenEachStoreySlipped);
    rows_of_bands(&simulation.storeys, &each, end, words, language)
}

/// A row of bands per part: its number and intervals; the word for a band, and the title.
pub(super) fn rows_of_bands(
    names: &[String],
    bands: &[(usize, [f64; 2])],
    end_s: f64,
    (word, title): (Signs, Titles),
    language: Language,
) -> String {
    let size = [BANDS_PX, 90.0 + BAND_PX * names.len() as f64];
    let x = Axis::linear(say(Axes::Time, language), 0.0, end_s, 10);
    let mut plot = Plot::new(size, x, Axis::rows(names));
    for (part, [from_s, to_s]) in bands {
        let row = *part as f64;
        plot.block([*from_s, row - 0.32], [*to_s, row + 0.32], SERIES[0], 0.8);
    }
    for part in 0..names.len() {
        let row = part as f64;
        plot.line(vec![[0.0, row], [end_s, row]], Line::new(GREY, 0.5));
    }
    plot.key(Key::Block(SERIES[0], 0.8), say(word, language));
    plot.svg(say(title, language))
}
