//! Makes a barrel vault: an arch with a length along its axis, in courses of stones.

use super::arch::{prism, section};
use super::dimension::{all_positive, refused};
use super::{ArchFactors, Block, Bond, StackError};

/// Largest number of stones. Our choice, as for walls.
const STONES_MOST: f64 = 600.0;
/// Most stones of a course. Our choice.
const STONES_OF_COURSE_MOST: u32 = 100;

/// Dimensions of a barrel vault with its axis along y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VaultFactors {
    /// Clear span of the inner line at the springing, m.
    pub span_m: f64,
    /// Rise of the inner line above the springing, m; as for an [arch](super::arch()).
    pub rise_m: f64,
    /// Thickness along the bed joints, m.
    pub thickness_m: f64,
    /// Length along the axis, m.
    pub length_m: f64,
    /// Number of courses from one springing to the other, 2 to 400: the voussoirs of the section.
    pub voussoirs: u32,
    /// Stones of a course along the axis, 1 to 100. In running bond every second course has one more: it begins and ends with half a stone.
    pub stones: u32,
    /// Bond of the courses.
    pub bond: Bond,
    /// Height of the springing above the ground, m. With 0 the vault stands on the ground, which is allowed only for round and pointed sections.
    pub springing_height_m: f64,
    /// Width of the abutments at the foot, m, at least the thickness. Not used if the springing height is 0.
    pub abutment_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A barrel vault, course by course from left to right, each along y. The abutments come last.
///
/// Names are "course 3 stone 2", both from 1. Bed joints lie in the radial planes of the section, head joints across the axis.
///
/// # Errors
/// [`StackError::Dimension`] for a dimension out of its range, or more than 600 stones.
///
/// # Limits
/// Each abutment is one stone along the whole length. Faces are plane, as those of an [arch](super::arch()).
///
/// # Example
/// ```
/// use dolmen::structure::stack::{Bond, VaultFactors, vault};
/// let made = vault(&VaultFactors {
///     span_m: 1.9, rise_m: 0.95, thickness_m: 0.1, length_m: 1.2, voussoirs: 9, stones: 2, bond: Bond::Running,
///     springing_height_m: 0.0, abutment_m: 0.5, density_kg_m3: 2600.0,
/// })?;
/// assert_eq!((made.len(), made[2].name.as_str()), (5 * 2 + 4 * 3, "course 2 stone 1"));
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn vault(factors: &VaultFactors) -> Result<Vec<Block>, StackError> {
    all_positive(&[("length_m", factors.length_m)])?;
    if !(1..=STONES_OF_COURSE_MOST).contains(&factors.stones) {
        return Err(refused("stones", f64::from(factors.stones), "1 to 100"));
    }
    let section = section(&ArchFactors {
        span_m: factors.span_m,
        rise_m: factors.rise_m,
        thickness_m: factors.thickness_m,
        depth_m: factors.length_m,
        voussoirs: factors.voussoirs,
        springing_height_m: factors.springing_height_m,
        abutment_m: factors.abutment_m,
        density_kg_m3: factors.density_kg_m3,
    })?;
    if factors.stones_along() > STONES_MOST {
        let allowed = "so few that the vault has at most 600 stones";
        return Err(refused("stones", f64::from(factors.stones), allowed));
    }
    let block = |name: String, corners: &[[f64; 2]], ends: [f64; 2]| -> Result<Block, StackError> {
        let sides_y = ends.map(|share| (share - 0.5) * factors.length_m);
        Ok(Block {
            name,
            solid: prism(corners, sides_y)?,
            density_kg_m3: factors.density_kg_m3,
        })
    };
    let mut blocks = Vec::new();
    for (course, corners) in (0..factors.voussoirs).zip(&section.voussoirs) {
        for (stone, ends) in factors.ends(course).into_iter().enumerate() {
            let name = format!("course {} stone {}", course + 1, stone + 1);
            blocks.push(block(name, corners, ends)?);
        }
    }
    for (name, corners) in &section.abutments {
        blocks.push(block((*name).to_owned(), corners, [0.0, 1.0])?);
    }
    Ok(blocks)
}

impl VaultFactors {
    /// Both ends of each stone of a course, as fractions of the length.
    fn ends(&self, course: u32) -> Vec<[f64; 2]> {
        let shift = self.bond.shift(course);
        let inner = (0..=self.stones).map(|joint| (f64::from(joint) - shift) / f64::from(self.stones));
        let mut joints: Vec<f64> = inner.map(|share| share.max(0.0)).collect();
        if shift > 0.0 {
            joints.push(1.0);
        }
        joints.windows(2).map(|ends| [ends[0], ends[1]]).collect()
    }

    fn stones_along(&self) -> f64 {
        let longer = match self.bond {
            Bond::Running => self.voussoirs / 2,
            Bond::Straight => 0,
        };
        f64::from(self.voussoirs) * f64::from(self.stones) + f64::from(longer)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Body, JointMaterial, Stack};
    use super::*;
    use crate::numeric::Random;

    const USUAL: VaultFactors = VaultFactors {
        span_m: 3.0,
        rise_m: 1.5,
        thickness_m: 0.45,
        length_m: 2.4,
        voussoirs: 9,
        stones: 3,
        bond: Bond::Running,
        springing_height_m: 0.0,
        abutment_m: 0.9,
        density_kg_m3: 2600.0,
    };

    #[test]
    fn exact_courses_fill_the_barrel_and_break_joint() {
        // a voussoir lies between two chords of the same angle: ½ (R² − r²) sin π/n
        let area = 9.0 * 0.5 * (1.95_f64.powi(2) - 1.5 * 1.5) * (std::f64::consts::PI / 9.0).sin();
        for (bond, stones, joints) in [
            // joints: heads, beds between courses, and those on the ground; a bed of 3 on 4 stones has 6 overlaps
            (Bond::Running, 5 * 3 + 4 * 4, (5 * 2 + 4 * 3) + 8 * 6 + 6),
            (Bond::Straight, 9 * 3, 9 * 2 + 8 * 3 + 6),
        ] {
            let made = vault(&VaultFactors { bond, ..USUAL }).unwrap();
            assert_eq!(made.len(), stones);
            let volume: f64 = made.iter().map(|block| block.solid.volume_m3()).sum();
            assert!((volume / (2.4 * area) - 1.0).abs() < 1e-12, "{bond:?}: {volume}");
            let stack = Stack::new(made, JointMaterial::default(), 9.81).unwrap();
            assert_eq!(stack.joints().len(), joints, "{bond:?}");
            let grounded = stack.joints().iter().filter(|joint| joint.lower == Body::Ground);
            assert_eq!(grounded.count(), 6);
        }
    }

    #[test]
    fn holds_any_factors_make_the_whole_barrel_or_are_refused() {
        let mut random = Random::new(7, 0);
        let mut made_some = 0;
        for _ in 0..200 {
            let mut of = |least: f64, most: f64| least + (most - least) * random.uniform();
            let factors = VaultFactors {
                span_m: of(0.2, 9.0),
                rise_m: of(-0.1, 6.0),
                thickness_m: of(-0.05, 1.0),
                length_m: of(0.1, 20.0),
                voussoirs: of(1.0, 40.0) as u32,
                stones: of(0.0, 12.0) as u32,
                bond: if of(0.0, 1.0) < 0.5 {
                    Bond::Running
                } else {
                    Bond::Straight
                },
                springing_height_m: of(-0.2, 3.0).max(-0.05),
                abutment_m: of(0.1, 4.0),
                density_kg_m3: 2600.0,
            };
            let Ok(made) = vault(&factors) else { continue };
            made_some += 1;
            let arch = super::super::arch(&ArchFactors {
                span_m: factors.span_m,
                rise_m: factors.rise_m,
                thickness_m: factors.thickness_m,
                depth_m: factors.length_m,
                voussoirs: factors.voussoirs,
                springing_height_m: factors.springing_height_m,
                abutment_m: factors.abutment_m,
                density_kg_m3: factors.density_kg_m3,
            })
            .unwrap();
            let sum = |blocks: &[Block]| -> f64 { blocks.iter().map(|of| of.solid.volume_m3()).sum() };
            assert!((sum(&made) / sum(&arch) - 1.0).abs() < 1e-9, "{factors:?}");
        }
        assert!(made_some > 50, "{made_some}");
    }

    #[test]
    fn refuses_what_is_no_vault() {
        for (factors, said) in [
            (VaultFactors { stones: 0, ..USUAL }, "1 to 100"),
            (VaultFactors { stones: 90, ..USUAL }, "600 stones"),
            (
                VaultFactors {
                    length_m: f64::NAN,
                    ..USUAL
                },
                "length_m",
            ),
            (VaultFactors { rise_m: 0.5, ..USUAL }, "needs abutments"),
        ] {
            let fault = vault(&factors).unwrap_err().to_string();
            assert!(fault.contains(said), "{said}: {fault}");
        }
    }
}
