//! The data of figures of dampers, wind, columns, directions and years.

use super::gusts::GustPlot;
use super::study_drawing::StudyFigure;
use super::tune::TuneFigure;
use super::words::{Axes, Columns};
use crate::document::Series;
use dolmen::damper::MapCell;
use dolmen::stability::stack::StackLimitStates;
use dolmen_words::Sentence;
use dolmen_work::building::{BuildingWind, FloorInWind, TuneAnswer, WindMotion};
use dolmen_work::frame::StoreyColumns;
use dolmen_work::loads::LoadedStorey;
use dolmen_work::watched::WatchAnswer;

/// Effect of a damper at places along a line: the motion of each point relative to that without it.
fn position_series(answer: &TuneAnswer) -> Vec<Series> {
    let comparison = &answer.comparison;
    let place = |axis: usize| {
        comparison
            .line_given
            .iter()
            .map(move |cell| cell.damper.place_m[axis])
    };
    let mut all = vec![
        Series::numbers(Columns::DamperX, "m", place(0)),
        Series::numbers(Columns::DamperY, "m", place(1)),
    ];
    let over = |cells: &[MapCell], point: usize| -> Vec<f64> {
        let each = cells
            .iter()
            .map(|cell| answer.over_without(&cell.point_rms)[point]);
        each.collect()
    };
    for (at, point) in answer.points.iter().enumerate() {
        let name = || point.name.clone();
        let given = Columns::AsGiven(name());
        let best = Columns::TunedBest(name());
        all.push(Series::numbers(given, "", over(&comparison.line_given, at)));
        all.push(Series::numbers(best, "", over(&comparison.line_best, at)));
    }
    all
}

/// The goal for each place of the floor.
fn plan_series(answer: &TuneAnswer) -> Vec<Series> {
    let cells = || answer.comparison.map.cells.iter().flatten();
    let goal = cells().map(|cell| cell.cost / answer.comparison.cost_without);
    vec![
        Series::numbers(Columns::DamperX, "m", cells().map(|cell| cell.damper.place_m[0])),
        Series::numbers(Columns::DamperY, "m", cells().map(|cell| cell.damper.place_m[1])),
        Series::numbers(Columns::Goal, "", goal),
    ]
}

/// The goal with detuned frequency or damping, for the given damper and the optimum.
fn robustness_series(answer: &TuneAnswer) -> Vec<Series> {
    let comparison = &answer.comparison;
    let mut all = Vec::new();
    let pairs = [
        (Columns::OffFrequency, &comparison.off_frequency),
        (Columns::OffDamping, &comparison.off_damping),
    ];
    for (what, pair) in pairs {
        for (damper, points) in [Columns::Given, Columns::Best].into_iter().zip(pair) {
            let factor = points.iter().map(|point| point.factor);
            let goal = points.iter().map(|point| point.cost / comparison.cost_without);
            let named = Columns::GoalOff {
                what: what.clone().into(),
                damper: damper.into(),
            };
            all.push(Series::numbers(Columns::Factor, "", factor));
            all.push(Series::numbers(named, "", goal));
        }
    }
    all
}

/// The goal on each floor.
fn floor_series(answer: &TuneAnswer) -> Vec<Series> {
    let floors = || answer.floors.iter().flat_map(|of| &of.comparison.floors);
    let goal = floors().map(|of| of.cost / answer.comparison.cost_without);
    vec![
        Series::numbers(Columns::Floor, "", floors().map(|of| of.floor as f64)),
        Series::numbers(Columns::DamperX, "m", floors().map(|of| of.damper.place_m[0])),
        Series::numbers(Columns::DamperY, "m", floors().map(|of| of.damper.place_m[1])),
        Series::numbers(Columns::Goal, "", goal),
    ]
}

/// The numbers of a figure of one damper.
pub(crate) fn tune_series(answer: &TuneAnswer, figure: TuneFigure) -> Vec<Series> {
    match figure {
        TuneFigure::Position => position_series(answer),
        TuneFigure::Plan => plan_series(answer),
        TuneFigure::Floors => floor_series(answer),
        TuneFigure::Robustness => robustness_series(answer),
    }
}

/// Effect of the wind on each floor.
pub(crate) fn gust_series(plot: GustPlot, wind: &BuildingWind, heights_m: &[f64]) -> Vec<Series> {
    let mut all = vec![Series::numbers(Columns::Height, "m", heights_m.iter().copied())];
    let of_floors = |motion: &WindMotion, of: &dyn Fn(&FloorInWind) -> f64| -> Vec<f64> {
        motion.floors.iter().map(of).collect()
    };
    for (along, name) in wind.along.iter().zip(["x", "y"]) {
        let axis = || Sentence::of_symbol(name);
        let motion = along.as_it_is();
        match plot {
            GustPlot::Acceleration => {
                let corner = |floor: &FloorInWind| floor.corner_m_s2.peak();
                let head = Columns::AccelerationAlong(axis());
                all.push(Series::numbers(head, "m/s²", of_floors(motion, &corner)));
                if along.with.is_some() {
                    let head = Columns::WithoutDampers(axis());
                    all.push(Series::numbers(head, "m/s²", of_floors(&along.without, &corner)));
                }
            }
            GustPlot::Displacement => {
                let mean = of_floors(motion, &|floor| floor.displacement_m.mean);
                let peak = of_floors(motion, &|floor| floor.displacement_m.peak());
                all.push(Series::numbers(Columns::MeanAlong(axis()), "m", mean));
                all.push(Series::numbers(Columns::PeakAlong(axis()), "m", peak));
            }
        }
    }
    all
}

/// Resistance of free-standing columns against drift.
pub(crate) fn columns_series(columns: &StoreyColumns) -> Vec<Series> {
    let drift = columns.curve.iter().map(|point| 1e3 * point.drift_m);
    let force = columns.curve.iter().map(|point| 1e-3 * point.force_n);
    super::numbers::line_series(
        [Axes::Drift, Axes::ForceOfTheStorey],
        [drift.collect(), force.collect()],
    )
}

/// Resistance of a storey against its drift.
pub(crate) fn pushed_series(storey: &LoadedStorey) -> Vec<Series> {
    let drift = storey.under.curve.iter().map(|point| 1e3 * point.drift_m);
    let force = storey.under.curve.iter().map(|point| 1e-3 * point.force_n);
    super::numbers::line_series(
        [Axes::Drift, Axes::ForceOfTheStorey],
        [drift.collect(), force.collect()],
    )
}

/// First uplift in each direction of the plan, and the smallest first sliding.
pub(crate) fn direction_series(limits: &StackLimitStates, gravity_m_s2: f64) -> Vec<Series> {
    let Some(uplift) = super::stack_directions::uplift_g(limits, gravity_m_s2) else {
        return Vec::new();
    };
    let step = 360.0 / uplift.len() as f64;
    let mut all = vec![
        Series::numbers(Columns::Angle, "°", (0..uplift.len()).map(|k| step * k as f64)),
        Series::numbers(Columns::Uplift, "g", uplift),
    ];
    if let Some(sliding) = &limits.sliding {
        all.push(Series::numbers(
            Columns::Sliding,
            "g",
            [sliding.threshold.acceleration_g],
        ));
    }
    all
}

/// Frequencies of the surveys, and those of the explanation.
pub(crate) fn years_series(answer: &WatchAnswer) -> Vec<Series> {
    let surveys = || answer.surveys.iter();
    let mut all = vec![Series::words(
        Columns::Survey,
        surveys().map(|survey| Sentence::of_symbol(&survey.name)),
    )];
    for (i, mode) in answer.watched.modes.iter().enumerate() {
        let measured = surveys().enumerate().map(|(survey, of)| {
            let found = mode.track.modes.get(survey).copied().flatten();
            let hz = found.and_then(|j| of.frequencies_hz.get(j));
            hz.copied().unwrap_or(f64::NAN)
        });
        let explained = mode.explained_hz.iter().map(|hz| hz.unwrap_or(f64::NAN));
        let number = i + 1;
        all.push(Series::numbers(Columns::Nth(number), "Hz", measured));
        all.push(Series::numbers(Columns::Explained(number), "Hz", explained));
    }
    all
}

/// Columns of a study for its figures; their names are keys without a language.
pub(crate) fn study_series(answer: &dolmen_work::study::StudyAnswer, figure: StudyFigure) -> Vec<Series> {
    use dolmen_work::study::{
        ColumnValues, capacity_columns, fragility_columns, harmonic_columns, release_columns, run_columns,
    };
    let columns = match figure {
        StudyFigure::Capacity => capacity_columns(answer),
        StudyFigure::Fragility => fragility_columns(answer),
        StudyFigure::Harmonic => harmonic_columns(&answer.maps, answer.kind),
        StudyFigure::Release => release_columns(&answer.maps),
        StudyFigure::Survived | StudyFigure::Growth => run_columns(answer),
    };
    let series = columns.into_iter().map(|column| {
        let name = Sentence::of_symbol(&column.name);
        match column.values {
            ColumnValues::Numbers(values) => Series::numbers(
                name,
                "",
                values.into_iter().map(|value| value.unwrap_or(f64::NAN)),
            ),
            ColumnValues::Counts(values) => {
                Series::numbers(name, "", values.into_iter().map(|value| value as f64))
            }
            ColumnValues::Words(words) => {
                Series::words(name, words.iter().map(|word| Sentence::of_symbol(word)))
            }
        }
    });
    series.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::series_csv;
    use dolmen_words::Language;

    #[test]
    fn exact_columns_of_words_and_numbers() {
        let all = [
            Series::words(Columns::Part, [Sentence::of_symbol("base")]),
            Series::numbers(Columns::Mass, "kg", [2.5]),
        ];
        assert_eq!(
            series_csv(&all, Language::English),
            "\u{feff}Part,mass (kg)\nbase,2.5\n"
        );
        assert_eq!(
            series_csv(&all, Language::Korean),
            "\u{feff}부재,질량 (kg)\nbase,2.5\n"
        );
    }
}
