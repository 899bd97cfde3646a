//! The lean measured by a survey, applied to a whole stack.

use super::vectors::{centroid, cross, minus, unit_normal};
use dolmen::structure::stack::{BED_GAP_M, Block, Placement};

/// Least downward component of the unit normal of a base face, the cosine of 8°.
const LEVEL: f64 = 0.99;

/// The measured lean of a whole stack, beds included, about the foot of its lowest stone.
#[derive(Clone, Debug, PartialEq)]
pub struct SurveyedLean {
    /// The survey.
    pub survey: String,
    /// Horizontal / vertical towards x and y.
    pub slope: [f64; 2],
    /// The text of the file: "x 1/177, y 1/540".
    pub written: String,
}

/// A rotation of everything about the foot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    slope: [f64; 2],
    foot_m: [f64; 3],
}

impl SurveyedLean {
    /// The rotation of upright blocks.
    pub(super) fn turn(&self, blocks: &[Block]) -> Option<Turn> {
        let slope = self.slope;
        only_foot(blocks).map(|foot_m| Turn { slope, foot_m })
    }
}

impl Turn {
    pub(super) fn block(&self, block: Block) -> Block {
        let to_foot = Placement {
            position_m: self.foot_m.map(|part| -part),
            ..Placement::default()
        };
        let leaning = Placement {
            tilt: self.slope,
            position_m: self.foot_m,
            ..Placement::default()
        };
        let solid = block.solid.placed(&to_foot).placed(&leaning);
        Block { solid, ..block }
    }

    pub(super) fn point(&self, at_m: [f64; 3]) -> [f64; 3] {
        let turned = self.turned(minus(at_m, self.foot_m));
        plus(turned, self.foot_m)
    }

    /// A vector, rotated by the shortest rotation from the vertical to the leaning axis.
    pub(super) fn turned(&self, vector: [f64; 3]) -> [f64; 3] {
        let [x, y] = self.slope;
        let size = (x * x + y * y + 1.0).sqrt();
        let about = [-y / size, x / size, 0.0];
        let once = cross(about, vector);
        let twice = cross(about, once).map(|part| part / (1.0 + 1.0 / size));
        plus(plus(vector, once), twice)
    }
}

fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// The middle of the base of the only block that stands on the ground.
pub(super) fn only_foot(blocks: &[Block]) -> Option<[f64; 3]> {
    let mut feet = blocks
        .iter()
        .filter(|block| block.solid.bounds_m()[0][2] <= BED_GAP_M);
    let foot = feet.next().filter(|_| feet.next().is_none())?;
    let solid = &foot.solid;
    let corners = |face: &Vec<usize>| -> Vec<[f64; 3]> {
        face.iter().map(|&vertex| solid.vertices_m()[vertex]).collect()
    };
    let faces = solid.faces().iter().map(corners);
    let bases = faces.filter(|corners| unit_normal(corners)[2] <= -LEVEL);
    bases
        .map(|base| centroid(&base))
        .min_by(|a, b| a[2].total_cmp(&b[2]))
}
