//! A building in the first history of the wind.

use super::history_series::history_series;
use super::identification::{Figure, drawn};
use super::lines::{Lines, Series};
use super::words::{Axes, Signs, Titles, say};
use dolmen_project::strokes_of;
use dolmen_words::Language;
use dolmen_work::building::{InTime, MotionInTime, WindSimulation};

/// A figure over time, the wind along x, 0, or y, 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WindPlot {
    /// Displacement of the top floor along the wind.
    Top(usize),
    /// Acceleration of its worst corner.
    Corner(usize),
    /// Strokes of the dampers.
    Strokes(usize),
}

const AXES: [&str; 2] = ["x", "y"];

impl WindPlot {
    /// The figures of a simulation, in order.
    pub(crate) fn all(run: &WindSimulation) -> Vec<Self> {
        let mut all = vec![Self::Top(0), Self::Top(1), Self::Corner(0), Self::Corner(1)];
        if !run.dampers.is_empty() {
            all.extend([Self::Strokes(0), Self::Strokes(1)]);
        }
        all
    }

    fn name(self) -> String {
        match self {
            Self::Top(axis) => format!("top-{}", AXES[axis]),
            Self::Corner(axis) => format!("corner-{}", AXES[axis]),
            Self::Strokes(axis) => format!("strokes-{}", AXES[axis]),
        }
    }

    /// Its SVG; `None` without a sample.
    pub(crate) fn draw(self, run: &WindSimulation, language: Language) -> Option<String> {
        self.lines(run, language).draw(language)
    }

    pub(crate) fn numbers(self, run: &WindSimulation) -> Vec<crate::document::Series> {
        history_series(|language| Some(self.lines(run, language)))
    }

    fn lines(self, run: &WindSimulation, language: Language) -> Lines {
        let axis = |axis: usize| AXES[axis].to_owned();
        match self {
            Self::Top(of) => Lines {
                axis: Axes::Displacement,
                title: Titles::TopFloorInWindAlong(axis(of)),
                lines: both(run, of, language, |motion| (&motion.top_displacement_m, 1e3)),
            },
            Self::Corner(of) => Lines {
                axis: Axes::AccelerationSi,
                title: Titles::CornerInWindAlong(axis(of)),
                lines: both(run, of, language, |motion| (&motion.corner_m_s2, 1.0)),
            },
            Self::Strokes(of) => {
                let motion = run.along[of].as_it_is();
                let names = strokes_of(&run.dampers).into_iter().map(|stroke| stroke.name);
                let strokes = names.zip(&motion.strokes_m);
                Lines {
                    axis: Axes::Stroke,
                    title: Titles::TravelOfTheDampersInWindAlong(axis(of)),
                    lines: strokes
                        .map(|(name, stroke)| over_time(run, name, stroke, 1e3))
                        .collect(),
                }
            }
        }
    }
}

/// A quantity without dampers, then with them, in the same gusts.
fn both<'a>(
    run: &'a WindSimulation,
    axis: usize,
    language: Language,
    of: impl Fn(&'a MotionInTime) -> (&'a InTime, f64),
) -> Vec<Series> {
    let along = &run.along[axis];
    let line = |name: String, motion: &'a MotionInTime| {
        let (value, factor) = of(motion);
        over_time(run, name, value, factor)
    };
    match &along.with {
        None => vec![line(
            say(Signs::WindAlong(AXES[axis].to_owned()), language),
            &along.without,
        )],
        Some(with) => vec![
            line(say(Signs::WithoutDampers, language), &along.without),
            line(say(Signs::WithDampers, language), with),
        ],
    }
}

fn over_time(run: &WindSimulation, name: String, of: &InTime, factor: f64) -> Series {
    let values = of.first.iter().enumerate();
    Series {
        name,
        points: values
            .map(|(k, value)| [k as f64 * run.time_step_s, factor * value])
            .collect(),
    }
}

/// The figures of a simulation: top, corner and strokes of the first history, for each wind.
pub fn wind_histories(run: &WindSimulation, language: Language) -> Vec<Figure> {
    let all = WindPlot::all(run).into_iter();
    drawn(all.map(|plot| (plot.name(), plot.draw(run, language))))
}
