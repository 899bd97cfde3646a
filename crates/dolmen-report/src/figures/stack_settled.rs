//! Loose stones as drawn, and where they came to rest by each law.

use super::ink::{Anchor, Label};
use super::scene::Scene;
use super::stack::{
    FIRST_NAME_PX, NAMES_PX, TOP_PX, VIEW_PX, axes, extent, frame, last_row, named, names, scale_bar, view,
};
use super::stack_view::{Camera, DrawnDisplacement, Placed, placed};
use super::words::{Signs, Titles, say};
use dolmen::blocks::{ContactLaw, LooseEnding, LooseStones, Pose};
use dolmen_words::{Language, number};
use dolmen_work::stack::SettledSimulation;

/// The largest displacement is enlarged to about this fraction of the height. Our choice.
const SHOWN_SHARE: f64 = 0.05;
/// Room between two views, and for the second row of a head, px.
const BETWEEN_PX: f64 = 14.0;

/// One view with its head.
struct View {
    head: String,
    blocks: Vec<Placed>,
}

/// The stones as drawn, then at rest by each law: at true scale if a stone left its place, else with their displacements enlarged by one
/// factor for all laws.
pub(crate) fn stack_settled(of: &SettledSimulation, language: Language) -> String {
    let camera = Camera::new();
    let times = enlarged(of);
    let mut views = vec![View {
        head: say(Signs::AsDrawn, language),
        blocks: placed(&of.drawn, None),
    }];
    for run in &of.runs {
        let law = match run.law {
            ContactLaw::Springs(_) => Signs::AtRestBySprings,
            ContactLaw::Rigid(_) => Signs::AtRestAsRigid,
        };
        let [first, last] = ends(&run.settled);
        let moved = DrawnDisplacement {
            rest: first,
            now: last,
            times,
        };
        views.push(View {
            head: say(law, language),
            blocks: placed(&of.drawn, Some(moved)),
        });
    }
    let drawn: Vec<&[Placed]> = views.iter().map(|view| view.blocks.as_slice()).collect();
    let extent = extent(&of.drawn, &drawn, &camera);
    let left = NAMES_PX + 24.0;
    let foot = frame(extent, [left, TOP_PX + BETWEEN_PX], camera).foot[1];
    let rows = named(of.drawn.blocks().len());
    let height = (foot + 56.0).max(last_row(rows, FIRST_NAME_PX, foot) + 14.0);
    let width = left + views.len() as f64 * (VIEW_PX[0] + BETWEEN_PX);
    let mut scene = Scene::new(width, height);
    for (number, each) in views.iter().enumerate() {
        let corner = [
            left + number as f64 * (VIEW_PX[0] + BETWEEN_PX),
            TOP_PX + BETWEEN_PX,
        ];
        let frame = frame(extent, corner, camera);
        let middle = corner[0] + 0.5 * VIEW_PX[0];
        scene.text([middle, 14.0], &Label::new(&each.head, Anchor::Middle).bold());
        if number > 0 && times > 1.0 {
            let times = number::trimmed(times, 3);
            let scale = say(Signs::DisplacementsEnlarged(times), language);
            scene.text([middle, 28.0], &Label::new(scale, Anchor::Middle).small());
        }
        view(&mut scene, &of.drawn, &each.blocks, &[], &frame);
        if number == 0 {
            names(&mut scene, &of.drawn, &each.blocks, &frame, NAMES_PX);
            scale_bar(&mut scene, [NAMES_PX + 110.0, foot + 30.0], frame.scale);
            axes(&mut scene, [NAMES_PX + 40.0, foot + 36.0], &camera);
        }
    }
    scene.svg(say(Titles::StonesAtRest, language))
}

/// Poses of all stones at the begin and at the end of a run.
fn ends(stones: &LooseStones) -> [&[Pose]; 2] {
    let (blocks, poses) = (stones.history.blocks, &stones.history.poses);
    let last = poses.len().saturating_sub(blocks);
    [
        poses.get(..blocks).unwrap_or(&[]),
        poses.get(last..).unwrap_or(&[]),
    ]
}

/// A round factor for small displacements; 1 if a stone left its place, or for large ones.
fn enlarged(of: &SettledSimulation) -> f64 {
    let fell = |ending: LooseEnding| ending != LooseEnding::Stood;
    if of.runs.iter().any(|run| fell(run.settled.ending)) {
        return 1.0;
    }
    let stones = of.runs.iter().flat_map(|run| &run.settled.stones);
    let most_m = stones.map(|stone| stone.moved_m).fold(0.0, f64::max);
    let wanted = SHOWN_SHARE * of.drawn.height_m() / most_m;
    if !wanted.is_finite() || wanted < 2.0 {
        return 1.0;
    }
    let power = 10f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0].map(|n| n * power);
    round.into_iter().find(|n| *n <= wanted).unwrap_or(1.0)
}
