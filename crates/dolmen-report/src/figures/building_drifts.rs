//! Drifts of the storeys of a building under a combination, by height, compared with their limit.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, Line, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen_words::Language;
use dolmen_work::loads::BuildingCombination;

/// Colours along x and y, as in the figures of the wind.
const COLOURS: [&str; 2] = [BLUE, VERMILLION];

/// Along x and along y, each storey from its floor to the next, % of its height.
pub(crate) fn building_drifts(of: &BuildingCombination, language: Language) -> String {
    let mut top_m = 0.0;
    let mut lines: [Vec<[f64; 2]>; 2] = [Vec::new(), Vec::new()];
    for storey in &of.storeys {
        let ends_m = [top_m, top_m + storey.height_m];
        for (line, ratio) in lines.iter_mut().zip(storey.drift_ratios()) {
            line.extend(ends_m.map(|height_m| [100.0 * ratio, height_m]));
        }
        top_m = ends_m[1];
    }
    let limit = of.drift_limit.map(|ratio| 100.0 * ratio);
    let all = lines.iter().flatten().map(|point| point[0]).chain(limit);
    let most = all.fold(0.0, f64::max);
    let x = Axis::linear(say(Axes::DriftOfHeight, language), 0.0, 1.06 * most, 6);
    let y = Axis::linear(say(Axes::Height, language), 0.0, 1.03 * top_m, 6);
    let mut plot = Plot::new([680.0, 360.0], x, y);
    for (axis, points) in lines.into_iter().enumerate() {
        let mut line = Line::new(COLOURS[axis], 2.0);
        if axis == 1 {
            line = line.dashed();
        }
        plot.line(points, line);
        let axis = ["x", "y"][axis].to_owned();
        plot.key(Key::Line(line), say(Signs::DriftAlong(axis), language));
    }
    if let Some(limit) = limit {
        let line = Line::new(BLACK, 1.6);
        plot.line(vec![[limit, 0.0], [limit, top_m]], line);
        plot.key(Key::Line(line), say(Signs::LimitOfDrift, language));
    }
    plot.svg(say(Titles::DriftsOfTheStoreys, language))
}
