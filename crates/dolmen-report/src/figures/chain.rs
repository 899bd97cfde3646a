//! Figures of a chain: elevation to scale, limits of its joints, effect of a lower centroid.

use super::axis::Axis;
use super::ink::{
    Anchor, BLACK, BLUE, GREY, LIGHT, Label, Line, ORANGE, STONE, Shape, VERMILLION, verdict_colour,
    verdict_shape,
};
use super::plot::{Key, Plot};
use super::scene::Scene;
use super::side_posts::{DrawnSupport, side_posts};
use super::words::{Axes, Signs, Titles, say};
use dolmen::assess::CentroidEffect;
use dolmen::stability::{ChainLimits, ChainStability, Verdict};
use dolmen::structure::{Chain, Inertia};
use dolmen_words::Language;
use dolmen_words::number::{self, subscript};

/// Height of the drawn chain, px.
const ELEVATION_PX: f64 = 420.0;

/// Smallest drawn width of links, px, so that a slender pole is visible.
const WIDTH_LEAST_PX: f64 = 18.0;

/// Width of the widest link as a fraction of the height, if neither breadth nor bed is given.
const WIDTH_SHARE: f64 = 0.07;

/// The chain in elevation, heights to scale: links with lengths and centres of mass, and a mark at each joint whose
/// colour and shape show the verdict on its margin.
///
/// `names` are those of the links, lowest first; missing ones are numbered. Without `stability` the joints are unknown.
/// Widths are to scale if the links' breadth or bed is given; otherwise only their proportion √(mass/length) is.
pub fn chain_elevation(
    chain: &Chain,
    names: &[Option<String>],
    stability: Option<&ChainStability>,
    language: Language,
) -> String {
    let links = chain.links();
    let total: f64 = links.iter().map(|l| l.length_m).sum();
    let scale = ELEVATION_PX / total;
    let bottom = 26.0 + ELEVATION_PX;
    let mut scene = Scene::new(440.0, bottom + 44.0);
    let axis = 168.0;
    let widths = widths_m(chain, total);
    let masses: Vec<f64> = links.iter().map(|l| l.mass_kg * chain.gravity_m_s2()).collect();
    let weight_unit = number::prefix(&masses, "N");

    ground_and_heights(&mut scene, (total, scale), bottom, language);
    let margin_head = say(Signs::JointMargin, language);
    scene.text([432.0, 10.0], &Label::new(margin_head, Anchor::End).small());

    let half_width = |height_m: f64| {
        let mut top_m = 0.0;
        let at = links.iter().position(|link| {
            top_m += link.length_m;
            top_m >= height_m
        });
        (0.5 * widths[at.unwrap_or(links.len() - 1)]).max(0.5 * WIDTH_LEAST_PX / scale)
    };
    let supports = chain.side_supports().iter().map(|support| DrawnSupport {
        height_m: support.height_m,
        is_tight: support.acts_linearly(),
    });
    let posts = side_posts(&supports.collect::<Vec<_>>(), &half_width, total);
    let px = |at: &[f64; 2]| [axis + at[0] * scale, bottom - at[1] * scale];
    for post in &posts.posts {
        let corners: Vec<[f64; 2]> = post.iter().map(px).collect();
        scene.polygon(&corners, LIGHT, Line::new(GREY, 1.0));
    }
    for wedge in &posts.wedges {
        scene.line(px(&wedge[0]), px(&wedge[1]), Line::new(BLACK, 3.0));
    }

    let mut base_m = 0.0;
    for (i, link) in links.iter().enumerate() {
        let half = (0.5 * widths[i] * scale).max(0.5 * WIDTH_LEAST_PX);
        let (low, high) = (bottom - base_m * scale, bottom - (base_m + link.length_m) * scale);
        let box_line = Line::new(BLACK, 1.2);
        let corners = [
            [axis - half, low],
            [axis + half, low],
            [axis + half, high],
            [axis - half, high],
        ];
        scene.polygon(&corners, STONE, box_line);
        let centre = [axis, low - link.centroid_m * scale];
        scene.circle(centre, 5.0, "#ffffff", Line::new(BLACK, 1.1));
        scene.line(
            [centre[0] - 7.5, centre[1]],
            [centre[0] + 7.5, centre[1]],
            Line::new(BLACK, 1.0),
        );
        scene.line(
            [centre[0], centre[1] - 7.5],
            [centre[0], centre[1] + 7.5],
            Line::new(BLACK, 1.0),
        );
        let name = part_name(names, i, &say(Signs::Link, language));
        let middle = 0.5 * (low + high);
        scene.text(
            [axis + 44.0, middle - 8.0],
            &Label::new(name, Anchor::Start).bold(),
        );
        let facts = format!(
            "L {}{s}m · {}",
            number::significant(link.length_m, 3),
            weight_unit.trimmed(masses[i], 4),
            s = number::NARROW_SPACE
        );
        scene.text(
            [axis + 44.0, middle + 8.0],
            &Label::new(facts, Anchor::Start).small().coloured(GREY),
        );
        let level = JointLevel { axis, half, low };
        joint_margin(&mut scene, i, &level, stability, language);
        base_m += link.length_m;
    }
    let note = if links.iter().all(|l| given_width(l).is_some()) {
        say(Signs::ToScale, language)
    } else {
        say(Signs::HeightsToScaleWidthsSchematic, language)
    };
    scene.text(
        [8.0, bottom + 32.0],
        &Label::new(note, Anchor::Start).small().coloured(GREY),
    );
    scene.svg(say(Titles::ElevationOfTheChainWithItsJoints, language))
}

/// Position of a joint, px: the axis of the chain, half the width of the link above it, its level.
struct JointLevel {
    axis: f64,
    half: f64,
    low: f64,
}

/// Ground, and the scale of heights at the left.
fn ground_and_heights(scene: &mut Scene, (total, scale): (f64, f64), bottom: f64, language: Language) {
    let top = bottom - ELEVATION_PX;
    let ground = Line::new(GREY, 1.5);
    scene.line([64.0, bottom], [272.0, bottom], ground);
    for i in 0..13 {
        let x = 64.0 + 16.0 * f64::from(i);
        scene.line([x + 8.0, bottom], [x, bottom + 7.0], Line::new(GREY, 0.8));
    }
    let heights = Axis::linear("", 0.0, total, 5);
    for tick in &heights.ticks {
        let y = bottom - tick.at * scale;
        scene.line([46.0, y], [52.0, y], Line::new(GREY, 1.0));
        scene.text([42.0, y], &Label::new(&tick.text, Anchor::End).small());
    }
    scene.line([52.0, bottom], [52.0, top], Line::new(GREY, 1.0));
    scene.text(
        [8.0, 10.0],
        &Label::new(say(Axes::Height, language), Anchor::Start).small(),
    );
}

/// The mark of a joint and the text of its margin.
fn joint_margin(
    scene: &mut Scene,
    i: usize,
    &JointLevel { axis, half, low }: &JointLevel,
    stability: Option<&ChainStability>,
    language: Language,
) {
    let joint = stability.and_then(|s| s.joints.get(i));
    let margin = joint.and_then(|j| j.margin);
    let verdict = match (joint, margin) {
        (None, _) => Verdict::Unknown,
        (Some(_), None) => Verdict::Unstable,
        (Some(_), Some(margin)) => Verdict::of_load_factor(margin),
    };
    let words = match (joint, margin) {
        (None, _) => say(Signs::StiffnessUnknown, language),
        (Some(_), None) => say(Signs::Falls, language),
        (Some(_), Some(margin)) => number::beside_one(margin, 3),
    };
    scene.line([axis + half + 12.0, low], [330.0, low], Line::new(LIGHT, 1.0));
    scene.marker([axis, low], verdict_shape(verdict), 6.0, verdict_colour(verdict));
    let label = Label::new(format!("k{}   {words}", subscript(i + 1)), Anchor::Start);
    scene.marker([342.0, low], verdict_shape(verdict), 5.0, verdict_colour(verdict));
    scene.text([356.0, low], &label.bold());
}

/// Stiffness limits of every joint on a logarithmic axis: the published critical stiffness k_cr, the published P·H, the
/// exact limit M with all other joints rigid, and the given stiffness. Below M the chain falls for any other joints;
/// that side is tinted, and the figure shows that k_cr lies in it.
pub fn stiffness_limits(
    limits: &ChainLimits,
    stability: Option<&ChainStability>,
    language: Language,
) -> String {
    let given: Vec<f64> = stability
        .iter()
        .flat_map(|s| s.joints.iter().map(|j| j.stiffness_n_m_rad))
        .collect();
    let least: Vec<f64> = stability
        .iter()
        .flat_map(|s| s.joints.iter().filter_map(|j| j.stiffness_least_n_m_rad))
        .collect();
    let all: Vec<f64> = [
        &limits.published_critical_n_m_rad,
        &limits.published_buckling_n_m_rad,
        &limits.necessary_n_m_rad,
        &given,
        &least,
    ]
    .into_iter()
    .flatten()
    .copied()
    .collect();
    let unit = number::prefix(&all, "N·m/rad");
    let scaled: Vec<f64> = all.iter().map(|k| k * unit.factor).collect();
    let name = say(Axes::RotationalStiffness, language);
    let x = Axis::logarithmic(format!("{name} ({})", unit.unit), &scaled, language);
    let count = limits.necessary_n_m_rad.len();
    let rows: Vec<String> = (1..=count)
        .map(|i| format!("{} {i}", say(Signs::Joint, language)))
        .collect();
    let size = [680.0, 96.0 + 46.0 * count as f64];
    let mut plot = Plot::new(size, x, Axis::rows(&rows));
    let from = plot.x.from;
    for i in 0..count {
        let row = i as f64;
        let at = |k: f64, shift: f64| [k * unit.factor, row + shift];
        let necessary = limits.necessary_n_m_rad[i];
        plot.block([from, row - 0.36], at(necessary, 0.36), VERMILLION, 0.13);
        plot.line(vec![[from, row], [plot.x.to, row]], Line::new(LIGHT, 1.0));
        plot.sized_dot(at(necessary, 0.0), Shape::Bar, 7.0, BLACK);
        plot.sized_dot(
            at(limits.published_critical_n_m_rad[i], 0.0),
            Shape::Triangle,
            5.0,
            VERMILLION,
        );
        plot.sized_dot(
            at(limits.published_buckling_n_m_rad[i], 0.0),
            Shape::Square,
            4.2,
            ORANGE,
        );
        let Some(joint) = stability.and_then(|s| s.joints.get(i)) else {
            continue;
        };
        if let Some(least) = joint.stiffness_least_n_m_rad {
            plot.sized_dot(at(least, -0.17), Shape::Ring, 4.5, BLUE);
        }
        plot.sized_dot(at(joint.stiffness_n_m_rad, -0.17), Shape::Circle, 5.0, BLUE);
    }
    let keys = [
        (Shape::Triangle, VERMILLION, Signs::PublishedLimitUnsafe),
        (Shape::Bar, BLACK, Signs::ExactLimitOthersRigid),
        (Shape::Square, ORANGE, Signs::PublishedBuckling),
    ];
    for (shape, colour, words) in keys {
        plot.key(Key::Dot(shape, colour), say(words, language));
    }
    let falls = say(Signs::FallsWhateverTheOthersAre, language);
    plot.key(Key::Block(VERMILLION, 0.13), falls);
    if stability.is_some() {
        plot.key(
            Key::Dot(Shape::Circle, BLUE),
            say(Signs::GivenStiffness, language),
        );
        if !least.is_empty() {
            let words = say(Signs::LeastStiffness, language);
            plot.key(Key::Dot(Shape::Ring, BLUE), words);
        }
    }
    plot.svg(say(Titles::StiffnessLimitsOfEachJoint, language))
}

/// Effect of lowering one centroid on each joint: change of the published k_cr compared with that of the exact limit
/// M, per cent. A published limit that rises is an artefact of its criterion.
pub fn centroid_effect(limits: &ChainLimits, effect: &CentroidEffect, language: Language) -> String {
    let change = |new: &[f64], old: &[f64]| -> Vec<f64> {
        new.iter()
            .zip(old)
            .map(|(new, old)| 100.0 * (new / old - 1.0))
            .collect()
    };
    let published = change(
        &effect.published_critical_n_m_rad,
        &limits.published_critical_n_m_rad,
    );
    let exact = change(&effect.necessary_n_m_rad, &limits.necessary_n_m_rad);
    let mut all = [published.clone(), exact.clone()].concat();
    all.push(0.0);
    let name = say(Axes::ChangeOfTheLimit, language);
    let x = Axis::around(name, &all, 6);
    let rows: Vec<String> = (1..=exact.len())
        .map(|i| format!("{} {i}", say(Signs::Joint, language)))
        .collect();
    let mut plot = Plot::new([345.0, 92.0 + 30.0 * exact.len() as f64], x, Axis::rows(&rows));
    plot.upright(0.0, Line::new(BLACK, 1.2));
    for i in 0..exact.len() {
        let row = i as f64;
        plot.line(vec![[exact[i], row], [published[i], row]], Line::new(GREY, 1.2));
        plot.dot([exact[i], row], Shape::Circle, BLUE);
        plot.dot([published[i], row], Shape::Triangle, VERMILLION);
    }
    plot.key(
        Key::Dot(Shape::Triangle, VERMILLION),
        say(Signs::PublishedLimit, language),
    );
    plot.key(Key::Dot(Shape::Circle, BLUE), say(Signs::ExactLimit, language));
    plot.svg(say(Titles::EffectOfALowerCentreOfMass, language))
}

/// The name of a part, or its kind and number.
pub(crate) fn part_name(names: &[Option<String>], index: usize, kind: &str) -> String {
    match names.get(index) {
        Some(Some(name)) => name.clone(),
        _ => format!("{kind} {}", index + 1),
    }
}

fn given_width(link: &dolmen::structure::Link) -> Option<f64> {
    match link.inertia {
        Inertia::Box { breadth_m } => Some(breadth_m),
        _ => link.bed_width_m,
    }
}

fn widths_m(chain: &Chain, total_m: f64) -> Vec<f64> {
    let slender = |l: &dolmen::structure::Link| (l.mass_kg / l.length_m).sqrt();
    let most = chain.links().iter().map(slender).fold(0.0, f64::max);
    chain
        .links()
        .iter()
        .map(|l| given_width(l).unwrap_or(WIDTH_SHARE * total_m * slender(l) / most))
        .collect()
}
