//! Sites of sensors, and their motion.

use dolmen::structure::stack::{Solid, Stack};

/// Distance below which two points are the same, m: rounding of coordinates.
const ROUNDING_M: f64 = 1e-9;
/// Distance to another stone below which a place is not free, m.
const FREE_M: f64 = 0.03;
/// A sensor on a side of a stone is at the point where a line from the centroid in this direction leaves it.
const WAYS: [(Side, [f64; 2]); 4] = [
    (Side::Right, [1.0, 0.0]),
    (Side::Left, [-1.0, 0.0]),
    (Side::Back, [0.0, 1.0]),
    (Side::Front, [0.0, -1.0]),
];

/// A side of a part, seen from the front: x to the right, y away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Its top, in the middle.
    Top,
    /// Towards x.
    Right,
    /// Against x.
    Left,
    /// Towards y.
    Back,
    /// Against y.
    Front,
    /// A corner of a floor, from 0.
    Corner(usize),
}

/// The axis of a sensor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Upwards.
    Z,
    /// In the plane of the model.
    InPlane,
    /// Along a direction of the file.
    Named(String),
}

impl Axis {
    /// As written in the file; `None` for the plane of a model.
    pub fn key(&self) -> Option<&str> {
        match self {
            Axis::X => Some("x"),
            Axis::Y => Some("y"),
            Axis::Z => Some("z"),
            Axis::InPlane => None,
            Axis::Named(name) => Some(name),
        }
    }
}

/// A place for a sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// The part.
    pub part: String,
    /// The side.
    pub side: Side,
    /// x, y, z, m.
    pub position_m: [f64; 3],
    /// Its axes.
    pub axes: Vec<Axis>,
    /// The lowest point of the structure, m.
    pub(super) ground_m: f64,
}

/// A place with all its possible axes, and the displacement along each in each mode.
pub(super) struct CandidatePlace {
    pub(super) part: String,
    pub(super) side: Side,
    pub(super) position_m: [f64; 3],
    pub(super) channels: Vec<(Axis, Vec<f64>)>,
}

/// Sensors with the given number of axes at the places: with one axis each direction is a site, with two both horizontal ones together.
pub(super) fn sites(candidates: Vec<CandidatePlace>, axes: usize) -> (Vec<Site>, Vec<Vec<Vec<f64>>>) {
    let ground_m = candidates
        .iter()
        .map(|candidate| candidate.position_m[2])
        .fold(f64::INFINITY, f64::min)
        .min(0.0);
    let (mut sites, mut rows) = (Vec::new(), Vec::new());
    for candidate in candidates {
        let groups: Vec<Vec<(Axis, Vec<f64>)>> = match axes {
            1 => candidate
                .channels
                .into_iter()
                .map(|channel| vec![channel])
                .collect(),
            2 => vec![
                candidate
                    .channels
                    .into_iter()
                    .filter(|(axis, _)| *axis != Axis::Z)
                    .collect(),
            ],
            _ => vec![candidate.channels],
        };
        for group in groups {
            let (axes, channels) = group.into_iter().unzip();
            sites.push(Site {
                part: candidate.part.clone(),
                side: candidate.side,
                position_m: candidate.position_m,
                axes,
                ground_m,
            });
            rows.push(channels);
        }
    }
    (sites, rows)
}

/// The free sides of every stone, and the tops that carry nothing.
pub(super) fn free_sides(stack: &Stack) -> Vec<(usize, Side, [f64; 3])> {
    let solids: Vec<&Solid> = stack.blocks().iter().map(|block| &block.solid).collect();
    let mut free = Vec::new();
    for (number, solid) in solids.iter().enumerate() {
        let centre = solid.centroid_m();
        let upwards = (Side::Top, [0.0, 0.0, 1.0]);
        let ways = WAYS.iter().map(|(side, way)| (*side, [way[0], way[1], 0.0]));
        for (side, way) in ways.chain([upwards]) {
            let Some(length) = leaves_after(solid, way) else {
                continue;
            };
            let at = |length: f64| std::array::from_fn(|i| centre[i] + length * way[i]);
            let before: [f64; 3] = at(length + FREE_M);
            let is_taken = solids
                .iter()
                .enumerate()
                .any(|(other, solid)| other != number && holds(solid, before));
            if !is_taken {
                free.push((number, side, at(length)));
            }
        }
    }
    free
}

/// The planes of a convex solid: a point of each and its outward direction.
fn planes(solid: &Solid) -> impl Iterator<Item = ([f64; 3], [f64; 3])> + '_ {
    let centre = solid.centroid_m();
    solid.faces().iter().map(move |face| {
        let corner = |at: usize| solid.vertices_m()[face[at % face.len()]];
        // Newell's normal: valid for any flat polygon
        let along = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let edge = |at: usize| {
                let (a, b) = (corner(at), corner(at + 1));
                (a[j] - b[j]) * (a[k] + b[k])
            };
            (0..face.len()).map(edge).sum::<f64>()
        };
        let normal: [f64; 3] = std::array::from_fn(along);
        let point = corner(0);
        let outward: f64 = (0..3).map(|i| normal[i] * (point[i] - centre[i])).sum();
        (point, normal.map(|part| if outward < 0.0 { -part } else { part }))
    })
}

/// Length of a line from the centroid inside the solid.
fn leaves_after(solid: &Solid, way: [f64; 3]) -> Option<f64> {
    let centre = solid.centroid_m();
    let lengths = planes(solid).filter_map(|(point, normal)| {
        let along: f64 = (0..3).map(|i| normal[i] * way[i]).sum();
        let off: f64 = (0..3).map(|i| normal[i] * (point[i] - centre[i])).sum();
        (along > 0.0).then(|| off / along)
    });
    lengths.min_by(f64::total_cmp).filter(|length| length.is_finite())
}

/// Whether a point is inside, or on the surface within rounding: it may lie where two stones meet.
fn holds(solid: &Solid, at: [f64; 3]) -> bool {
    let [least, most] = solid.bounds_m();
    let in_bounds = (0..3).all(|i| at[i] >= least[i] - ROUNDING_M && at[i] <= most[i] + ROUNDING_M);
    in_bounds
        && planes(solid).all(|(point, normal)| {
            let beyond: f64 = (0..3).map(|i| normal[i] * (at[i] - point[i])).sum();
            let length = normal.iter().map(|part| part * part).sum::<f64>().sqrt();
            beyond <= ROUNDING_M * length
        })
}
