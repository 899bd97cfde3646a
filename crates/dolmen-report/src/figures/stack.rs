//! The stack as a picture: as drawn, and after a simulated motion with its joints coloured by their motion.

use super::ink::{Anchor, BLUE, GREY, Label, Line, ORANGE, TEXT, VERMILLION};
use super::scene::Scene;
use super::stack_view::{Camera, DrawnDisplacement, Placed, bounds, painted, placed};
use super::words::{Signs, Titles, say};
use dolmen::blocks::{JointHistory, Outcome, StackHistory};
use dolmen::structure::stack::{Body, Joint, Stack};
use dolmen_words::Language;
use dolmen_words::number;
use dolmen_work::stack::StackSimulation;

/// Width and height of the area for one view of a stack, px.
pub(super) const VIEW_PX: [f64; 2] = [270.0, 420.0];
/// Room for the heads above the views, px.
pub(super) const TOP_PX: f64 = 34.0;
/// Width of a column of names, px.
pub(super) const NAMES_PX: f64 = 128.0;
/// Smallest distance between rows of names, px.
const ROW_PX: f64 = 16.5;
/// First position of names, and of joint numbers, px.
pub(super) const FIRST_NAME_PX: f64 = 16.0;
const FIRST_JOINT_PX: f64 = 34.0;
/// Stacks with more blocks or joints are drawn without names, which would be illegible.
const NAMED_MOST: usize = 25;
/// Residual displacements are enlarged so that the largest is this fraction of the height. Our choice.
const SHOWN_SHARE: f64 = 0.06;
/// Displacements below this are not enlarged: rounding of the run. m.
const MOVED_LEAST_M: f64 = 1e-7;
/// Slip or opening from which a joint has the second, third, fourth colour, m. Our choice: the resolution of survey methods.
const CLASSES_M: [f64; 3] = [1e-4, 1e-3, 1e-2];
/// Colours of these joints.
const COLOURS: [&str; 4] = ["#9aa0a6", BLUE, ORANGE, VERMILLION];

/// From metres in the picture to px.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    camera: Camera,
    pub(super) scale: f64,
    /// Position of the bottom centre of the drawing, px and m.
    pub(super) foot: [f64; 2],
    middle_m: [f64; 2],
}

impl Frame {
    fn px(&self, at: [f64; 2]) -> [f64; 2] {
        [
            self.foot[0] + self.scale * (at[0] - self.middle_m[0]),
            self.foot[1] - self.scale * (at[1] - self.middle_m[1]),
        ]
    }

    fn of(&self, at: [f64; 3]) -> [f64; 2] {
        self.px(self.camera.flat(at))
    }
}

/// A patch of ground around the stack, or below loose stones.
fn ground(stack: &Stack) -> [[f64; 3]; 4] {
    let feet = stack.joints().iter().filter(|joint| joint.lower == Body::Ground);
    let loose = stack.blocks().iter().filter(|_| stack.joints().is_empty());
    let below = loose.flat_map(|block| block.solid.bounds_m());
    let [low, high] = bounds(feet.flat_map(corners).chain(below).map(|at| [at[0], at[1]]));
    let room = 0.22 * (high[0] - low[0]).max(high[1] - low[1]);
    let (from, to) = ([low[0] - room, low[1] - room], [high[0] + room, high[1] + room]);
    [
        [from[0], from[1], 0.0],
        [to[0], from[1], 0.0],
        [to[0], to[1], 0.0],
        [from[0], to[1], 0.0],
    ]
}

/// Corners of a joint's patch as drawn, m.
fn corners(joint: &Joint) -> Vec<[f64; 3]> {
    let [first, second, _] = joint.axes;
    let at = |c: &[f64; 2]| std::array::from_fn(|i| joint.origin_m[i] + first[i] * c[0] + second[i] * c[1]);
    joint.patch.corners_m.iter().map(at).collect()
}

/// Corners of a joint's patch with the body below it at its present position.
fn corners_now(joint: &Joint, blocks: &[Placed]) -> Vec<[f64; 3]> {
    let drawn = corners(joint);
    match joint.lower {
        Body::Ground => drawn,
        Body::Block(lower) => drawn.into_iter().map(|at| blocks[lower].now(at)).collect(),
    }
}

/// One view: ground, blocks from far to near, joints along the edges towards the eye.
pub(super) fn view(
    scene: &mut Scene,
    stack: &Stack,
    blocks: &[Placed],
    colours: &[&'static str],
    frame: &Frame,
) {
    let patch = ground(stack).map(|at| frame.of(at));
    scene.polygon(&patch, "#e9ece4", Line::new("#b9c0b0", 0.8));
    // a joint is drawn on the farther of its two stones, so that the nearer one hides what lies behind it
    let is_above = |joint: &Joint| frame.camera.sees(joint.axes[2]);
    let farther = |joint: &Joint| match is_above(joint) {
        true => joint.lower,
        false => Body::Block(joint.upper),
    };
    let on = |scene: &mut Scene, body: Body| {
        for (joint, colour) in stack
            .joints()
            .iter()
            .zip(colours)
            .filter(|(joint, _)| farther(joint) == body)
        {
            let outline: Vec<[f64; 2]> = corners_now(joint, blocks)
                .into_iter()
                .map(|at| frame.of(at))
                .collect();
            let edges = outline.iter().zip(outline.iter().cycle().skip(1));
            // counterclockwise in the picture, whose y is down: an edge that runs to the right faces the eye; from below to the left
            let is_near = |from: &[f64; 2], to: &[f64; 2]| (to[0] > from[0]) == is_above(joint);
            for (from, to) in edges.filter(|(from, to)| is_near(from, to)) {
                scene.line(*from, *to, Line::new(colour, 5.0));
            }
        }
    };
    on(scene, Body::Ground);
    for number in painted(blocks, &frame.camera) {
        for (outline, light) in blocks[number].seen(&frame.camera) {
            let points: Vec<[f64; 2]> = outline.into_iter().map(|at| frame.px(at)).collect();
            scene.polygon(&points, &stone(light), Line::new("#5b564d", 0.7));
        }
        on(scene, Body::Block(number));
    }
}

/// The colour of stone in this light, 0 to 1.
fn stone(light: f64) -> String {
    let (dark, bright) = ([128.0, 121.0, 110.0], [250.0, 247.0, 240.0]);
    let part = |i: usize| (dark[i] + light * (bright[i] - dark[i])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", part(0), part(1), part(2))
}

/// Bounds of the drawing, m in the picture.
pub(super) fn extent(stack: &Stack, all: &[&[Placed]], camera: &Camera) -> [[f64; 2]; 2] {
    let corners = all
        .iter()
        .flat_map(|blocks| blocks.iter())
        .flat_map(|block| &block.corners);
    bounds(corners.copied().chain(ground(stack)).map(|at| camera.flat(at)))
}

/// The frame that fits these bounds into the view with its upper left corner at `corner`.
pub(super) fn frame(extent: [[f64; 2]; 2], corner: [f64; 2], camera: Camera) -> Frame {
    let [low, high] = extent;
    let size = [high[0] - low[0], high[1] - low[1]];
    let scale = (VIEW_PX[0] / size[0]).min(VIEW_PX[1] / size[1]);
    Frame {
        camera,
        scale,
        foot: [corner[0] + 0.5 * VIEW_PX[0], corner[1] + scale * size[1]],
        middle_m: [0.5 * (low[0] + high[0]), low[1]],
    }
}

/// Heights for rows near the wanted heights, in order from above, no two closer than a row.
fn spread(wanted: &[f64], least: f64, most: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    let mut places = vec![0.0; wanted.len()];
    let mut next = least;
    for &row in &order {
        places[row] = wanted[row].max(next);
        next = places[row] + ROW_PX;
    }
    let mut last = most;
    for &row in order.iter().rev() {
        places[row] = f64::min(places[row], last);
        last = places[row] - ROW_PX;
    }
    places
}

/// Number of names in the figure.
pub(super) fn named(count: usize) -> usize {
    if count > NAMED_MOST { 0 } else { count }
}

/// Position of the last row: next to the foot of the view, or below it if needed.
pub(super) fn last_row(rows: usize, first: f64, foot: f64) -> f64 {
    (foot + 10.0).max(first + ROW_PX * rows.saturating_sub(1) as f64)
}

/// Names of the blocks left of a view.
pub(super) fn names(scene: &mut Scene, stack: &Stack, blocks: &[Placed], frame: &Frame, column: f64) {
    if blocks.len() > NAMED_MOST {
        return;
    }
    let points: Vec<[f64; 2]> = blocks
        .iter()
        .map(|block| {
            let outline: Vec<[f64; 2]> = block.corners.iter().map(|at| frame.of(*at)).collect();
            let [low, high] = bounds(outline.iter().copied());
            let side = outline
                .iter()
                .filter(|p| p[0] <= low[0] + 0.02 * (high[0] - low[0]));
            let heights: Vec<f64> = side.map(|p| p[1]).collect();
            [low[0], heights.iter().sum::<f64>() / heights.len().max(1) as f64]
        })
        .collect();
    let wanted: Vec<f64> = points.iter().map(|p| p[1]).collect();
    let rows = spread(
        &wanted,
        FIRST_NAME_PX,
        last_row(wanted.len(), FIRST_NAME_PX, frame.foot[1]),
    );
    for ((point, row), block) in points.iter().zip(&rows).zip(stack.blocks()) {
        let end = [column + 8.0, *row];
        scene.path(
            &[[point[0] - 2.0, point[1]], [column + 18.0, *row], end],
            Line::new("#c3c7cb", 0.8),
        );
        scene.text(
            [column + 4.0, *row],
            &Label::new(&block.name, Anchor::End).small(),
        );
    }
}

/// A bar of a round length.
pub(super) fn scale_bar(scene: &mut Scene, at: [f64; 2], scale: f64) {
    let rough = 80.0 / scale;
    let power = 10f64.powf(rough.log10().floor());
    let length = [5.0, 2.0, 1.0]
        .map(|n| n * power)
        .into_iter()
        .find(|l| *l <= rough)
        .unwrap_or(power);
    let end = [at[0] + scale * length, at[1]];
    scene.line(at, end, Line::new(TEXT, 2.0));
    for x in [at[0], end[0]] {
        scene.line([x, at[1] - 4.0], [x, at[1] + 4.0], Line::new(TEXT, 1.2));
    }
    let words = format!("{}{}m", number::trimmed(length, 2), number::NARROW_SPACE);
    scene.text([end[0] + 8.0, at[1]], &Label::new(words, Anchor::Start).small());
}

/// Arrows along x, y, z.
pub(super) fn axes(scene: &mut Scene, at: [f64; 2], camera: &Camera) {
    for (name, way) in [
        ("x", [1.0, 0.0, 0.0]),
        ("y", [0.0, 1.0, 0.0]),
        ("z", [0.0, 0.0, 1.0]),
    ] {
        let [right, up] = camera.flat(way);
        let tip = [at[0] + 26.0 * right, at[1] - 26.0 * up];
        scene.arrow(at, tip, 7.0, Line::new(GREY, 1.2));
        let beyond = [at[0] + 35.0 * right, at[1] - 35.0 * up];
        scene.text(beyond, &Label::new(name, Anchor::Middle).small().coloured(GREY));
    }
}

/// A stack as in its file, seen from the right, the front and above, with the names of its blocks.
pub fn stack_view(stack: &Stack, language: Language) -> String {
    let camera = Camera::new();
    let blocks = placed(stack, None);
    let frame = frame(
        extent(stack, &[&blocks], &camera),
        [NAMES_PX + 24.0, 22.0],
        camera,
    );
    let foot = frame.foot[1];
    let rows = named(blocks.len());
    let height = (foot + 56.0).max(last_row(rows, FIRST_NAME_PX, foot) + 14.0);
    let mut scene = Scene::new(NAMES_PX + VIEW_PX[0] + 90.0, height);
    view(
        &mut scene,
        stack,
        &blocks,
        &vec!["#7c766b"; stack.joints().len()],
        &frame,
    );
    names(&mut scene, stack, &blocks, &frame, NAMES_PX);
    scale_bar(&mut scene, [NAMES_PX + 110.0, foot + 30.0], frame.scale);
    axes(&mut scene, [NAMES_PX + 40.0, foot + 36.0], &camera);
    scene.svg(say(Titles::TheStack, language))
}

/// A round factor to enlarge residual displacements; `None` if there are none, or if they are already large.
fn enlarged(simulation: &StackSimulation, rest: &[Placed], end: &[Placed]) -> Option<f64> {
    let pairs = rest
        .iter()
        .zip(end)
        .flat_map(|(a, b)| a.corners.iter().zip(&b.corners));
    let most = pairs
        .map(|(a, b)| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt())
        .fold(0.0, f64::max);
    if most < MOVED_LEAST_M {
        return None;
    }
    let wanted = SHOWN_SHARE * simulation.stack.height_m() / most;
    let power = 10f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0]
        .map(|n| n * power)
        .into_iter()
        .find(|n| *n <= wanted)?;
    (round >= 2.0).then_some(round)
}

fn class(joint: &JointHistory) -> usize {
    let most = joint.peak_opening_m.max(joint.peak_slip_m);
    CLASSES_M.iter().filter(|least| most >= **least).count()
}

/// A stack at the end of a simulation: at true scale, and next to it with its displacements enlarged by a stated factor. The
/// colour of a joint is the larger of its peak opening and slip; both are listed.
pub fn stack_after(simulation: &StackSimulation, language: Language) -> String {
    let (stack, history) = (&simulation.stack, &simulation.history);
    let camera = Camera::new();
    let samples = simulation.samples();
    let moved = |times: f64| DrawnDisplacement {
        rest: simulation.poses(0),
        now: simulation.poses(samples.saturating_sub(1)),
        times,
    };
    let rest = placed(stack, None);
    let end = placed(stack, Some(moved(1.0)));
    let fell = matches!(history.outcome, Outcome::Fell { .. });
    let times = if fell {
        None
    } else {
        enlarged(simulation, &rest, &end)
    };
    let large = times.map(|times| placed(stack, Some(moved(times))));
    let mut drawn: Vec<&[Placed]> = vec![&end];
    drawn.extend(large.as_deref());
    let extent = extent(stack, &drawn, &camera);
    let colours: Vec<&str> = history.joints.iter().map(|joint| COLOURS[class(joint)]).collect();
    let views = drawn.len() as f64;
    let right = NAMES_PX + 24.0 + views * (VIEW_PX[0] + 14.0);
    let left = NAMES_PX + 24.0;
    let foot = frame(extent, [left, TOP_PX], camera).foot[1];
    let (names_end, joints_end) = (
        last_row(named(rest.len()), FIRST_NAME_PX, foot),
        last_row(named(history.joints.len()), FIRST_JOINT_PX, foot),
    );
    let legend_at = (foot + 58.0).max(names_end.max(joints_end) + 24.0);
    let mut scene = Scene::new(right + 232.0, legend_at + 14.0);
    let heads = [
        say(Signs::AtTheEndTrueScale, language),
        times.map_or(String::new(), |times| {
            let times = number::trimmed(times, 3);
            say(Signs::DisplacementsEnlarged(times), language)
        }),
    ];
    let mut last = None;
    for (number, blocks) in drawn.iter().enumerate() {
        let corner = [left + number as f64 * (VIEW_PX[0] + 14.0), TOP_PX];
        let frame = frame(extent, corner, camera);
        scene.text(
            [corner[0] + 0.5 * VIEW_PX[0], 14.0],
            &Label::new(&heads[number], Anchor::Middle).bold(),
        );
        view(&mut scene, stack, blocks, &colours, &frame);
        if number == 0 {
            names(&mut scene, stack, blocks, &frame, NAMES_PX);
            scale_bar(&mut scene, [NAMES_PX + 110.0, foot + 24.0], frame.scale);
            axes(&mut scene, [NAMES_PX + 40.0, foot + 34.0], &camera);
        }
        last = Some((blocks, frame));
    }
    if let Some((blocks, frame)) = last {
        joint_column(
            &mut scene,
            stack,
            &history.joints,
            blocks,
            &frame,
            right,
            language,
        );
    }
    legend(&mut scene, [left, legend_at], language);
    scene.svg(say(Titles::TheStackAfterTheMotion, language))
}

/// Peak opening and slip of each joint, right of a view.
fn joint_column(
    scene: &mut Scene,
    stack: &Stack,
    joints: &[JointHistory],
    blocks: &[Placed],
    frame: &Frame,
    column: f64,
    language: Language,
) {
    if joints.len() > NAMED_MOST {
        return;
    }
    let points: Vec<[f64; 2]> = stack
        .joints()
        .iter()
        .map(|joint| {
            let outline = corners_now(joint, blocks).into_iter().map(|at| frame.of(at));
            outline.max_by(|a, b| a[0].total_cmp(&b[0])).unwrap_or_default()
        })
        .collect();
    let wanted: Vec<f64> = points.iter().map(|p| p[1]).collect();
    let rows = spread(
        &wanted,
        FIRST_JOINT_PX,
        last_row(wanted.len(), FIRST_JOINT_PX, frame.foot[1]),
    );
    let head = say(Signs::PeakOpeningAndSlip, language);
    scene.text(
        [column + 20.0, 14.0],
        &Label::new(head, Anchor::Start).small().coloured(GREY),
    );
    for ((point, row), joint) in points.iter().zip(&rows).zip(joints) {
        scene.path(
            &[[point[0] + 3.0, point[1]], [column, *row], [column + 8.0, *row]],
            Line::new("#c3c7cb", 0.8),
        );
        let colour = COLOURS[class(joint)];
        let chip = [[8.0, -5.0], [18.0, -5.0], [18.0, 5.0], [8.0, 5.0]].map(|p| [column + p[0], row + p[1]]);
        scene.polygon(&chip, colour, Line::new(colour, 0.5));
        let (opening, slip) = (millimetres(joint.peak_opening_m), millimetres(joint.peak_slip_m));
        let words = say(Signs::OpeningAndSlip { opening, slip }, language);
        scene.text([column + 25.0, *row], &Label::new(words, Anchor::Start).small());
    }
}

fn millimetres(value_m: f64) -> String {
    let value = 1e3 * value_m;
    if value < 0.01 {
        "< 0.01".to_owned()
    } else {
        number::trimmed(value, 3)
    }
}

/// The meaning of the joint colours.
fn legend(scene: &mut Scene, at: [f64; 2], language: Language) {
    let head = say(Signs::LargerOfBoth, language);
    let label = Label::new(head, Anchor::Start).small();
    let mut x = at[0] + label.width() + 14.0;
    scene.text(at, &label);
    let least = number::trimmed(1e3 * StackHistory::UPLIFT_LEAST_M, 2);
    let words = [
        format!("< {least} mm"),
        format!("{least}–1 mm"),
        "1–10 mm".to_owned(),
        "≥ 10 mm".to_owned(),
    ];
    for (colour, text) in COLOURS.into_iter().zip(words) {
        scene.line([x, at[1]], [x + 20.0, at[1]], Line::new(colour, 5.0));
        let label = Label::new(text, Anchor::Start).small();
        scene.text([x + 26.0, at[1]], &label);
        x += 26.0 + label.width() + 18.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_rows_that_crowd_are_spread_and_stay_within() {
        assert_eq!(spread(&[10.0, 100.0], 0.0, 200.0), [10.0, 100.0]);
        let rows = spread(&[198.0, 199.0, 197.0], 0.0, 200.0);
        assert_eq!(rows, [200.0 - ROW_PX, 200.0, 200.0 - 2.0 * ROW_PX]);
    }
}
