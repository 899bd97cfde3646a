//! A structure as entered, in a vertical plane: the outline of each part in metres, and its position on the sheet.

use super::hull::hull;
use super::side_posts::{DrawnSupport, SidePosts, side_posts};
use dolmen::signal::Component;
use dolmen::structure::stack::{Body, Stack};
use dolmen_project::{
    BuildingPart, ChainAxis, ChainPart, ColumnsPart, FramePart, Quantity, StackPart, Structure,
};

/// Widths that are not in the file, as fractions of the height. Our choice: they only support names.
const CHAIN_WIDTH: f64 = 0.07;
const FRAME_WIDTH: f64 = 0.7;
const FLOOR_WIDTH: f64 = 0.5;
/// A column and its beam, as fractions of a storey's width and height. Our choice: recognisable as a frame.
const COLUMN_WIDTH: f64 = 0.08;
const BEAM_HEIGHT: f64 = 0.12;
/// Set-back of an upper storey of a frame as a fraction of its width, as in its sketch.
const SET_BACK: f64 = 0.06;
/// Exaggerated offsets reach this fraction of the widest part, exaggerated tilts this slope. Our choice: visible, but not mistaken for
/// the shape.
const OFFSET_SHARE: f64 = 0.12;
pub(super) const SLOPE_DRAWN: f64 = 0.12;

/// A part.
#[derive(Clone, Debug)]
pub(super) struct PartOutline {
    pub(super) name: String,
    /// Corners in order, m: across, up.
    pub(super) corners_m: Vec<[f64; 2]>,
    /// Further pieces of the same stone, m.
    pub(super) further_m: Vec<Vec<[f64; 2]>>,
    /// Between the columns of a frame, m.
    pub(super) openings_m: Vec<Vec<[f64; 2]>>,
}

impl PartOutline {
    /// Smallest and largest coordinates across and up, m.
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        super::stack_view::bounds(self.corners().copied())
    }

    /// Corners of all its pieces, m.
    fn corners(&self) -> impl Iterator<Item = &[f64; 2]> {
        self.corners_m.iter().chain(self.further_m.iter().flatten())
    }

    pub(super) fn middle(&self) -> [f64; 2] {
        let [least, most] = self.bounds();
        [0.5 * (least[0] + most[0]), 0.5 * (least[1] + most[1])]
    }
}

/// All parts seen along one axis, the farthest first.
#[derive(Clone, Debug)]
pub(super) struct Elevation {
    /// 0: x is across; 1: y is.
    pub(super) axis: usize,
    pub(super) parts: Vec<PartOutline>,
    /// Posts at the sides of the pole.
    pub(super) posts: SidePosts,
    /// Whether the file gives the widths.
    pub(super) has_widths: bool,
    /// Whether the drawn columns and beams have no positions in the file.
    pub(super) is_frame: bool,
    /// Exaggeration of the offsets and tilts of stones; 1 if there are none.
    pub(super) offsets_times: f64,
    pub(super) tilts_times: f64,
}

/// Levels closer than this are one, m.
const LEVEL_M: f64 = 1e-3;

impl Elevation {
    /// Whether every part stands on top of another or on the ground.
    pub(super) fn is_stacked(&self) -> bool {
        let bounds: Vec<[[f64; 2]; 2]> = self.parts.iter().map(PartOutline::bounds).collect();
        let bottom = bounds
            .iter()
            .map(|[least, _]| least[1])
            .fold(f64::INFINITY, f64::min);
        let is_level = |level: f64| {
            (level - bottom).abs() <= LEVEL_M
                || bounds.iter().any(|[_, most]| (level - most[1]).abs() <= LEVEL_M)
        };
        bounds.iter().all(|[least, _]| is_level(least[1]))
    }

    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        let parts = self.parts.iter().flat_map(PartOutline::corners);
        let all = parts.chain(self.posts.posts.iter().flatten());
        super::stack_view::bounds(all.copied())
    }
}

/// One view for motion in a plane, two for a structure with a plan; none for a survey alone, or a stack that cannot be built.
pub(super) fn elevations(structure: &Structure, exaggerate: bool) -> Vec<Elevation> {
    match structure {
        Structure::Chain(part) => part.axes().iter().map(|axis| of_chain(part, *axis)).collect(),
        Structure::Frame(part) => frame_axes(part)
            .into_iter()
            .map(|axis| of_frame(part, axis))
            .collect(),
        Structure::Building(part) => (0..2).map(|axis| of_building(part, axis)).collect(),
        Structure::Stack(part) => {
            // as entered: upright; the surveyed lean is drawn separately
            let part = &StackPart {
                lean: None,
                ..(**part).clone()
            };
            let stack = match part.is_loose {
                true => part.build_loose(&mut Quantity::nominal).ok(),
                false => part.build(&mut Quantity::nominal).ok(),
            };
            let each = stack
                .iter()
                .flat_map(|stack| (0..2).map(move |axis| (stack, axis)));
            each.map(|(stack, axis)| of_stack(part, stack, axis, exaggerate))
                .collect()
        }
        Structure::Survey => Vec::new(),
    }
}

fn plain(axis: usize, parts: Vec<PartOutline>, has_widths: bool) -> Elevation {
    Elevation {
        axis,
        parts,
        posts: SidePosts::default(),
        has_widths,
        is_frame: false,
        offsets_times: 1.0,
        tilts_times: 1.0,
    }
}

/// A box from `low` upwards, about the middle.
fn a_box(name: String, [left, right]: [f64; 2], low: f64, height: f64) -> PartOutline {
    let high = low + height;
    PartOutline {
        name,
        corners_m: vec![[left, low], [right, low], [right, high], [left, high]],
        further_m: Vec::new(),
        openings_m: Vec::new(),
    }
}

fn name_or_number(name: Option<&String>, index: usize) -> String {
    name.cloned().unwrap_or_else(|| (index + 1).to_string())
}

fn of_chain(part: &ChainPart, axis: ChainAxis) -> Elevation {
    let total: f64 = part.links.iter().map(|link| link.length.value).sum();
    let mut low = 0.0;
    let mut has_widths = true;
    let mut parts = Vec::new();
    for (index, link) in part.links.iter().enumerate() {
        // wind from the opposite side acts on the face seen from here
        let seen_by = match axis {
            ChainAxis::Along => ChainAxis::Across,
            ChainAxis::Across => ChainAxis::Along,
        };
        let bed = part.bed(index, &mut Quantity::nominal);
        let given = link.met_by_wind(seen_by, bed, &mut Quantity::nominal);
        has_widths &= given.is_some();
        let width = given.unwrap_or(CHAIN_WIDTH * total);
        let name = name_or_number(link.name.as_ref(), index);
        parts.push(a_box(name, [-0.5 * width, 0.5 * width], low, link.length.value));
        low += link.length.value;
    }
    let own = part
        .side_supports
        .iter()
        .filter(|support| support.axis.unwrap_or(ChainAxis::Along) == axis);
    let supports = own.map(|support| DrawnSupport {
        height_m: support.height.value,
        is_tight: support.gap.as_ref().is_none_or(|gap| gap.value == 0.0),
    });
    let half_width = |height_m: f64| {
        let at = parts.iter().find(|part| part.bounds()[1][1] >= height_m);
        at.or(parts.last()).map_or(0.0, |part| part.bounds()[1][0])
    };
    let posts = side_posts(&supports.collect::<Vec<_>>(), &half_width, total);
    Elevation {
        posts,
        ..plain(
            match axis {
                ChainAxis::Along => 0,
                ChainAxis::Across => 1,
            },
            parts,
            has_widths,
        )
    }
}

/// Both views of a frame whose directions are known as x and y.
fn frame_axes(part: &FramePart) -> Vec<usize> {
    let is_known = |of| part.along(of).is_some();
    match is_known(Component::X) && is_known(Component::Y) {
        true => vec![0, 1],
        false => vec![0],
    }
}

/// Columns visible from a side: those of the file, if they are in one row; otherwise two at the ends, if the number per row is unknown.
pub(crate) fn columns_seen(columns: Option<&ColumnsPart>) -> usize {
    match columns.map(|columns| columns.count) {
        Some(count @ 1..=3) => count,
        Some(_) | None => 2,
    }
}

/// Openings between columns below a beam.
fn openings([left, right]: [f64; 2], low: f64, height: f64, columns: usize) -> Vec<Vec<[f64; 2]>> {
    let width = right - left;
    let (column, top) = (COLUMN_WIDTH * width, low + (1.0 - BEAM_HEIGHT) * height);
    let gap = |from: f64, to: f64| vec![[from, low], [to, low], [to, top], [from, top]];
    match columns {
        1 => {
            let half = 0.5 * (width - column);
            vec![gap(left, left + half), gap(right - half, right)]
        }
        several => {
            let free = (width - several as f64 * column) / (several - 1) as f64;
            let from = |at: usize| left + column + at as f64 * (free + column);
            (0..several - 1)
                .map(|at| gap(from(at), from(at) + free))
                .collect()
        }
    }
}

fn of_frame(part: &FramePart, axis: usize) -> Elevation {
    let total: f64 = part.storeys.iter().map(|storey| storey.height.value).sum();
    let mut low = 0.0;
    let mut parts = Vec::new();
    for (index, storey) in part.storeys.iter().enumerate() {
        let half = 0.5 * FRAME_WIDTH * total * (1.0 - SET_BACK * index as f64).max(0.4);
        let name = name_or_number(storey.name.as_ref(), index);
        let height = storey.height.value;
        let seen = columns_seen(storey.columns.as_ref());
        parts.push(PartOutline {
            openings_m: openings([-half, half], low, height, seen),
            ..a_box(name, [-half, half], low, height)
        });
        low += height;
    }
    Elevation {
        is_frame: true,
        ..plain(axis, parts, false)
    }
}

fn of_building(part: &BuildingPart, axis: usize) -> Elevation {
    let each = || {
        part.floors
            .iter()
            .flat_map(|floor| std::iter::repeat_n(floor, floor.count))
    };
    let total: f64 = each().map(|floor| floor.height.value).sum();
    let mut low = 0.0;
    let mut has_widths = true;
    let mut parts = Vec::new();
    for (floor, name) in each().zip(part.floor_names()) {
        let corners = floor.outline.as_ref().map(|outline| outline.corners_m());
        has_widths &= corners.is_some();
        let half = 0.5 * FLOOR_WIDTH * total;
        let across = corners.map_or([-half, half], |corners| {
            let along = || corners.iter().map(|corner| corner[axis]);
            [
                along().fold(f64::INFINITY, f64::min),
                along().fold(f64::NEG_INFINITY, f64::max),
            ]
        });
        parts.push(a_box(name, across, low, floor.height.value));
        low += floor.height.value;
    }
    plain(axis, parts, has_widths)
}

fn of_stack(part: &StackPart, stack: &Stack, axis: usize, exaggerate: bool) -> Elevation {
    let blocks = stack.blocks();
    let widths = blocks.iter().map(|block| {
        let [least, most] = block.solid.bounds_m();
        (most[0] - least[0]).min(most[1] - least[1])
    });
    let widest = widths.fold(0.0, f64::max);
    let own = |index: usize| {
        part.blocks
            .get(index)
            .filter(|_| part.blocks.len() == blocks.len())
    };
    let offset_along = |index: usize, axis: usize| {
        let given = own(index).and_then(|block| block.offset.as_ref());
        given.map_or(0.0, |offset| offset[axis].value)
    };
    let tilt_along = |index: usize, axis: usize| {
        let given = own(index).and_then(|block| block.tilt[axis].as_ref());
        given.map_or(0.0, |tilt| tilt.value)
    };
    // one factor for both views
    let most = |along: &dyn Fn(usize, usize) -> f64| {
        let each = (0..blocks.len()).flat_map(|index| [along(index, 0).abs(), along(index, 1).abs()]);
        each.fold(0.0, f64::max)
    };
    let (offsets_times, tilts_times) = match exaggerate {
        true => (
            times(most(&offset_along), OFFSET_SHARE * widest),
            times(most(&tilt_along), SLOPE_DRAWN),
        ),
        false => (1.0, 1.0),
    };
    let (offset, tilt) = (|index| offset_along(index, axis), |index| tilt_along(index, axis));
    // the offset of a stone also displaces the stones on it
    let mut moved = vec![0.0; blocks.len()];
    for index in 0..blocks.len() {
        let below = own(index).and_then(|block| match block.on.first() {
            Some(Body::Block(below)) if *below < index => Some(*below),
            _ => None,
        });
        let foot = |of: usize| blocks[of].solid.bounds_m()[0][2];
        let carried = below.map_or(0.0, |below| {
            moved[below] + (tilts_times - 1.0) * tilt(below) * (foot(index) - foot(below))
        });
        moved[index] = carried + (offsets_times - 1.0) * offset(index);
    }
    let mut parts: Vec<(f64, PartOutline)> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        let foot = block.solid.bounds_m()[0][2];
        let lean = (tilts_times - 1.0) * tilt(index);
        let place = |corner: &[f64; 3]| [corner[axis] + moved[index] + lean * (corner[2] - foot), corner[2]];
        let pieces = block.solid.drawn().into_iter();
        let mut outlines = pieces.map(|piece| hull(piece.vertices_m().iter().map(place).collect()));
        // the eye is before y in the first view, and to the right of x in the second
        let depth = [-block.solid.centroid_m()[1], block.solid.centroid_m()[0]][axis];
        let outline = PartOutline {
            name: block.name.clone(),
            corners_m: outlines.next().unwrap_or_default(),
            further_m: outlines.collect(),
            openings_m: Vec::new(),
        };
        parts.push((depth, outline));
    }
    parts.sort_by(|a, b| a.0.total_cmp(&b.0));
    Elevation {
        axis,
        parts: parts.into_iter().map(|(_, part)| part).collect(),
        posts: SidePosts::default(),
        has_widths: true,
        is_frame: false,
        offsets_times,
        tilts_times,
    }
}

/// The exaggeration 1, 2, 5, 10, … for which a value does not exceed `drawn`.
pub(super) fn times(value: f64, drawn: f64) -> f64 {
    const NICE: [f64; 9] = [500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0];
    let fits = |factor: &f64| value > 0.0 && value * factor <= drawn;
    NICE.into_iter().find(|factor| fits(factor)).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_the_hull_of_a_square_and_points_within_is_the_square() {
        let points = vec![
            [0.5, 0.5],
            [0.0, 0.0],
            [1.0, 0.0],
            [0.0, 1.0],
            [1.0, 1.0],
            [0.5, 0.0],
            [0.0, 0.0],
        ];
        assert_eq!(hull(points), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    }

    #[test]
    fn exact_factors_are_round_and_keep_within_what_is_drawn() {
        assert_eq!(times(1.0 / 177.0, 0.12), 20.0);
        assert_eq!(times(0.05, 0.12), 2.0);
        assert_eq!(times(0.0, 0.12), 1.0);
        assert_eq!(times(0.2, 0.12), 1.0);
        assert_eq!(times(f64::NAN, 0.12), 1.0);
    }
}
