//! Walls of Ferris & Tin-Loi (2001), International Journal of Mechanical Sciences 43: Coulomb friction with and without dilation.
//!
//! Courses and numbers: Bouckaert, Godio & Pacheco de Almeida (2024), 18th World Conference on Earthquake Engineering, and its published files.

use super::{Case, ValidationError};
use crate::stability::stack::{
    LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus, Shaking, limit_analysis,
    limit_analysis_undilated,
};
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const SOURCE: &str = "Ferris & Tin-Loi (2001)";
const NOTE: &str = "Dry walls of blocks of 0.4 × 0.175 m (and halves), friction 0.65, shaken in their plane; walls 3 to 6 have openings. Published to three \
                    digits. The horizontal acceleration at which the wall begins to move.";
const NOTE_OF_WALL_6: &str =
    "As for the other walls. Published to three digits as 0.347; another program, HybriDFEM, gives 0.348.";
const FRICTION: f64 = 0.65;
const LENGTH_M: f64 = 0.4;
const HEIGHT_M: f64 = 0.175;
/// Depth of the blocks, m: it does not matter in the plane.
const DEPTH_M: f64 = 1.0;

/// A wall: its courses from below, each its blocks from left to right; and its limits with and without dilation, over gravity.
struct Wall {
    name: &'static str,
    /// Lengths of the blocks in halves of a block; negative for an opening.
    courses: Vec<&'static [i8]>,
    dilating_g: f64,
    /// `None` if its rounds take too long for this page.
    undilated_g: Option<f64>,
}

fn walls() -> [Wall; 6] {
    let fives: [&[i8]; 2] = [&[1, 2, 2, 2, 2, 1], &[2, 2, 2, 2, 2]];
    let repeated = |count: usize| fives.iter().copied().cycle().take(count).collect();
    let window = |full: [&'static [i8]; 2], open: [&'static [i8]; 2]| {
        let [a, b] = full;
        let [c, d] = open;
        vec![a, b, a, c, d, c, d, c, a, b, a]
    };
    let fives_open: [&[i8]; 2] = [&[2, -2, 2, -2, 2], &[1, 1, -2, 1, 1, -2, 1, 1]];
    let threes = window([&[1, 2, 2, 1], &[2, 2, 2]], [&[2, -2, 2], &[1, 1, -2, 1, 1]]);
    let two_storeys = threes.iter().chain(&threes[3..]).copied().collect();
    let (a, b): (&[i8], &[i8]) = (&[1, 2, 2, 2, 2, 2, 2, 1], &[2; 7]);
    let (c, d): (&[i8], &[i8]) = (&[1, 2, -2, 2, 2, -2, 2, 1], &[2, 1, -2, 1, 2, 1, -2, 1, 2]);
    let sevens = vec![a, b, a, b, c, d, c, d, c, b, a, b, c, d, c, d, c, b, a, b, a];
    let wall = |name, courses, dilating_g, undilated_g| Wall {
        name,
        courses,
        dilating_g,
        undilated_g,
    };
    let fours = window(
        [&[2, 2, 2, 2], &[1, 2, 2, 2, 1]],
        [&[1, 2, -2, 2, 1], &[2, 1, -2, 1, 2]],
    );
    [
        wall("1", repeated(6), 0.643, Some(0.640)),
        wall("2", repeated(10), 0.580, Some(0.563)),
        wall("3", fours, 0.404, Some(0.356)),
        wall("4", window(fives, fives_open), 0.332, Some(0.264)),
        wall("5", two_storeys, 0.240, Some(0.215)),
        wall("6", sevens, 0.347, None),
    ]
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    for wall in walls() {
        let stack = wall.stack()?;
        let options = LimitAnalysis {
            shaking: Shaking::Along([1.0, 0.0]),
            ..LimitAnalysis::default()
        };
        let mut add = |how: &str, published, analysis: &LimitAnalysisResult| {
            let is_largest = wall.undilated_g.is_none();
            cases.push(Case {
                source: SOURCE,
                what: format!("wall {}, friction that {how}", wall.name),
                unit: "g",
                published,
                computed: limit_g(analysis),
                tolerance: if is_largest { 1.0e-3 } else { 6e-4 },
                corrected: None,
                note: if is_largest { NOTE_OF_WALL_6 } else { NOTE },
            });
        };
        add("dilates", wall.dilating_g, &limit_analysis(&stack, &options)?);
        if let Some(published) = wall.undilated_g {
            let found = limit_analysis_undilated(&stack, &options)?.analysis;
            add("does not dilate", published, &found);
        }
    }
    Ok(cases)
}

impl Wall {
    fn stack(&self) -> Result<Stack, ValidationError> {
        let mut blocks = Vec::new();
        for (course, lengths) in self.courses.iter().enumerate() {
            let mut left_m = 0.0;
            for &halves in *lengths {
                let length_m = 0.5 * LENGTH_M * f64::from(halves.abs());
                if halves > 0 {
                    blocks.push(Block {
                        name: format!("stone {}", blocks.len() + 1),
                        solid: Solid::cuboid(length_m, DEPTH_M, HEIGHT_M)?.placed(&Placement {
                            position_m: [left_m + 0.5 * length_m, 0.0, HEIGHT_M * course as f64],
                            ..Placement::default()
                        }),
                        density_kg_m3: 1000.0,
                    });
                }
                left_m += length_m;
            }
        }
        Ok(Stack::new(blocks, JointMaterial::with_friction(FRICTION), 9.81)?)
    }
}

fn limit_g(analysis: &LimitAnalysisResult) -> f64 {
    match analysis.status {
        LimitAnalysisStatus::Limited(threshold) => threshold.acceleration_g,
        LimitAnalysisStatus::DoesNotStand | LimitAnalysisStatus::Unlimited => f64::NAN,
    }
}
