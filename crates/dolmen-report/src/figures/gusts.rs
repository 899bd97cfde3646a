//! A building in the wind: response of its floors, by height.

use super::axis::Axis;
use super::ink::{BLUE, Line, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen_words::Language;
use dolmen_work::building::{BuildingWind, FloorInWind, WindMotion};

/// The quantity over the height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GustPlot {
    /// Peak acceleration at the worst corner, m/s².
    Acceleration,
    /// Mean and peak displacement along the wind, mm.
    Displacement,
}

const COLOURS: [&str; 2] = [BLUE, VERMILLION];
const SIZE_PX: [f64; 2] = [560.0, 380.0];
const MILLIMETRES: f64 = 1e3;

/// Lines over the height, the wind along x and along y.
pub(crate) fn gust_profile(
    plot: GustPlot,
    wind: &BuildingWind,
    heights_m: &[f64],
    language: Language,
) -> String {
    let line = |motion: &WindMotion, of: &dyn Fn(&FloorInWind) -> f64| -> Vec<[f64; 2]> {
        let floors = motion.floors.iter().zip(heights_m);
        let each = floors.map(|(floor, height_m)| [of(floor), *height_m]);
        std::iter::once([0.0, 0.0]).chain(each).collect()
    };
    let mut lines: Vec<(Vec<[f64; 2]>, Line, Signs)> = Vec::new();
    for (axis, along) in wind.along.iter().enumerate() {
        let name = ["x", "y"][axis].to_owned();
        let solid = Line::new(COLOURS[axis], 2.2);
        let thin = Line::new(COLOURS[axis], 1.4);
        match plot {
            GustPlot::Acceleration => {
                let corner = |floor: &FloorInWind| floor.corner_m_s2.peak();
                if along.with.is_some() {
                    let dashed = (line(&along.without, &corner), thin.dashed());
                    lines.push((dashed.0, dashed.1, Signs::WindWithoutDampers(name.clone())));
                }
                lines.push((line(along.as_it_is(), &corner), solid, Signs::WindAlong(name)));
            }
            GustPlot::Displacement => {
                let mean = |floor: &FloorInWind| MILLIMETRES * floor.displacement_m.mean;
                let peak = |floor: &FloorInWind| MILLIMETRES * floor.displacement_m.peak();
                let motion = along.as_it_is();
                lines.push((line(motion, &mean), thin.dashed(), Signs::WindMean(name.clone())));
                lines.push((line(motion, &peak), solid, Signs::WindPeak(name)));
            }
        }
    }
    let most = |axis: usize| {
        let all = lines.iter().flat_map(|(points, ..)| points);
        all.map(|point| point[axis]).fold(0.0, f64::max)
    };
    let (name, title) = match plot {
        GustPlot::Acceleration => (Axes::AccelerationSi, Titles::AccelerationInTheWind),
        GustPlot::Displacement => (Axes::Displacement, Titles::DisplacementInTheWind),
    };
    let x = Axis::linear(say(name, language), 0.0, 1.06 * most(0), 6);
    let y = Axis::linear(say(Axes::Height, language), 0.0, 1.03 * most(1), 6);
    let mut drawn = Plot::new(SIZE_PX, x, y);
    for (points, line, words) in lines {
        drawn.line(points, line);
        drawn.key(Key::Line(line), say(words, language));
    }
    drawn.svg(say(title, language))
}
