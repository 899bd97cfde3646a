//! Makes an arch of voussoirs from its span and rise.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | s, h | `span_m`, `rise_m` | clear span of the inner line at the springing, its rise above the springing | m |
//! | t | `thickness_m` | distance from the inner to the outer line, along the joints | m |
//! | r | `radius` | radius of the inner line | m |
//! | x_c, z_c | `centre` | centre of the circle of the left half, from the middle of the springing line | m |
//! | θ | `angle` | angle of a joint about that centre, from the horizontal on the left | rad |

use super::dimension::{all_positive, refused};
use super::{Block, Solid, StackError};
use std::f64::consts::FRAC_PI_2;

/// Largest number of voussoirs. Our choice: a check of that many takes a second.
const VOUSSOIRS_MOST: u32 = 400;

/// Dimensions of an arch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArchFactors {
    /// Clear span of the inner line at the springing, m.
    pub span_m: f64,
    /// Rise of the inner line above the springing, m. Half the span gives a round arch, less than half a segment of a circle.
    /// More than half gives a pointed arch of two arcs with their centres on the springing line.
    pub rise_m: f64,
    /// Thickness along the joints, m.
    pub thickness_m: f64,
    /// Depth along y, m.
    pub depth_m: f64,
    /// Number of voussoirs, 2 to 400; with an odd number there is a keystone.
    pub voussoirs: u32,
    /// Height of the springing above the ground, m. With 0 the arch stands on the ground, which is allowed only for round and
    /// pointed arches.
    pub springing_height_m: f64,
    /// Width of the abutments at the foot, m, at least the thickness. Not used if the springing height is 0.
    pub abutment_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// The circle of the left half of an arch; the right half is its mirror image.
struct Circles {
    centre: [f64; 2],
    radius: f64,
    thickness: f64,
    /// Angle of the springing and of the crown.
    angles: [f64; 2],
    lift: f64,
}

/// An arch of voussoirs with plane faces, of equal length along the inner line, from left to right. The abutments come last.
///
/// ```text
/// r = (s²/4 + h²) / (2h) if h ≤ s/2, centre at (0, h − r);   r = (s²/4 + h²) / s if more, centre at (r − s/2, 0)
/// joints along the radii; at the crown of a pointed arch upright
/// ```
///
/// # Errors
/// [`StackError::Dimension`] for a dimension out of its range.
///
/// # Limits
/// Faces are plane: for n = 9 the rise between the corners is 5 % below that of the curve. Each abutment is one stone.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{ArchFactors, arch};
/// let made = arch(&ArchFactors {
///     span_m: 1.9, rise_m: 0.95, thickness_m: 0.1, depth_m: 0.3, voussoirs: 9,
///     springing_height_m: 0.0, abutment_m: 0.5, density_kg_m3: 2600.0,
/// })?;
/// assert_eq!((made.len(), made[4].name.as_str()), (9, "keystone"));
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn arch(factors: &ArchFactors) -> Result<Vec<Block>, StackError> {
    let section = section(factors)?;
    let half = 0.5 * factors.depth_m;
    let block = |name: String, corners: &[[f64; 2]]| -> Result<Block, StackError> {
        Ok(Block {
            name,
            solid: prism(corners, [-half, half])?,
            density_kg_m3: factors.density_kg_m3,
        })
    };
    let count = section.voussoirs.len();
    let mut blocks = Vec::new();
    for (index, corners) in section.voussoirs.iter().enumerate() {
        let name = match 2 * index + 1 == count {
            true => "keystone".to_owned(),
            false => format!("voussoir {}", index + 1),
        };
        blocks.push(block(name, corners)?);
    }
    for (name, corners) in &section.abutments {
        blocks.push(block((*name).to_owned(), corners)?);
    }
    Ok(blocks)
}

/// Cross section of an arch or a vault, x and z, m.
pub(super) struct ArchSection {
    /// Corners of each voussoir, from left to right.
    pub(super) voussoirs: Vec<[[f64; 2]; 4]>,
    /// Names and corners of the abutments; none if the arch stands on the ground.
    pub(super) abutments: Vec<(&'static str, [[f64; 2]; 5])>,
}

/// The cross section of an arch.
///
/// # Errors
/// [`StackError::Dimension`] for a dimension out of its range.
pub(super) fn section(factors: &ArchFactors) -> Result<ArchSection, StackError> {
    check(factors)?;
    let circles = circles(factors);
    let count = factors.voussoirs;
    let voussoir = |index: u32| {
        let [start, end] = [index, index + 1].map(|joint| circles.joint(f64::from(joint) / f64::from(count)));
        [start[0], start[1], end[1], end[0]]
    };
    let abutment = |(name, share, side): (&'static str, f64, f64)| {
        let [inner, outer] = circles.joint(share);
        let back = side * (0.5 * factors.span_m + factors.abutment_m);
        (
            name,
            [[inner[0], 0.0], [back, 0.0], [back, outer[1]], outer, inner],
        )
    };
    let sides: &[(&'static str, f64, f64)] = match factors.springing_height_m > 0.0 {
        true => &[("left abutment", 0.0, -1.0), ("right abutment", 1.0, 1.0)],
        false => &[],
    };
    Ok(ArchSection {
        voussoirs: (0..count).map(voussoir).collect(),
        abutments: sides.iter().copied().map(abutment).collect(),
    })
}

/// The prism of a polygon in the plane x, z between two values of y.
pub(super) fn prism(corners: &[[f64; 2]], sides_y: [f64; 2]) -> Result<Solid, StackError> {
    let each = sides_y
        .iter()
        .flat_map(|y| corners.iter().map(move |[x, z]| [*x, *y, *z]));
    Solid::convex(&each.collect::<Vec<_>>())
}

fn check(factors: &ArchFactors) -> Result<(), StackError> {
    all_positive(&[
        ("span_m", factors.span_m),
        ("rise_m", factors.rise_m),
        ("thickness_m", factors.thickness_m),
        ("depth_m", factors.depth_m),
        ("abutment_m", factors.abutment_m),
        ("density_kg_m3", factors.density_kg_m3),
    ])?;
    if !(2..=VOUSSOIRS_MOST).contains(&factors.voussoirs) {
        return Err(refused("voussoirs", f64::from(factors.voussoirs), "2 to 400"));
    }
    let lift = factors.springing_height_m;
    if !(lift >= 0.0 && lift.is_finite()) {
        return Err(refused("springing_height_m", lift, "0 or a positive number"));
    }
    let segmental = factors.rise_m < (0.5 - 1e-9) * factors.span_m;
    if segmental && lift == 0.0 {
        let allowed =
            "positive for a rise below half the span: such an arch pushes outwards and needs abutments";
        return Err(refused("springing_height_m", lift, allowed));
    }
    if lift > 0.0 && factors.abutment_m < factors.thickness_m {
        return Err(refused(
            "abutment_m",
            factors.abutment_m,
            "the thickness of the arch or more",
        ));
    }
    Ok(())
}

fn circles(factors: &ArchFactors) -> Circles {
    let (half, rise) = (0.5 * factors.span_m, factors.rise_m);
    let squares = half * half + rise * rise;
    let (centre, radius) = match rise <= half {
        true => ([0.0, rise - squares / (2.0 * rise)], squares / (2.0 * rise)),
        false => ([squares / (2.0 * half) - half, 0.0], squares / (2.0 * half)),
    };
    Circles {
        centre,
        radius,
        thickness: factors.thickness_m,
        angles: [
            (-centre[1] / radius).asin(),
            match rise <= half {
                true => FRAC_PI_2,
                false => (centre[0] / radius).acos(),
            },
        ],
        lift: factors.springing_height_m,
    }
}

impl Circles {
    /// Inner and outer end of the joint at a fraction of the arch, from the left springing to the right.
    fn joint(&self, share: f64) -> [[f64; 2]; 2] {
        let [first, crown] = self.angles;
        let left = share.min(1.0 - share);
        let outer = self.radius + self.thickness;
        let ends = if left >= 0.5 * (1.0 - 1e-12) {
            // vertical, from the inner to the outer line
            [self.radius, outer].map(|radius| {
                [
                    0.0,
                    (radius * radius - self.centre[0].powi(2)).sqrt() + self.centre[1],
                ]
            })
        } else {
            let angle = first + 2.0 * left * (crown - first);
            let (sin, cos) = angle.sin_cos();
            [self.radius, outer].map(|radius| [self.centre[0] - radius * cos, self.centre[1] + radius * sin])
        };
        let side = if share > 0.5 { -1.0 } else { 1.0 };
        ends.map(|[x, z]| [side * x, z + self.lift])
    }
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Stack};
    use super::*;

    fn factors(rise_m: f64, voussoirs: u32, springing_height_m: f64) -> ArchFactors {
        ArchFactors {
            span_m: 3.0,
            rise_m,
            thickness_m: 0.45,
            depth_m: 1.0,
            voussoirs,
            springing_height_m,
            abutment_m: 1.0,
            density_kg_m3: 2500.0,
        }
    }

    #[test]
    fn exact_round_arch_has_the_area_of_its_polygons() {
        // each voussoir lies between two chords of the same angle: ½ (R² − r²) sin π/n
        let blocks = arch(&factors(1.5, 15, 0.0)).unwrap();
        let known = 0.5 * (1.95_f64.powi(2) - 1.5 * 1.5) * (std::f64::consts::PI / 15.0).sin();
        assert_eq!((blocks.len(), blocks[7].name.as_str()), (15, "keystone"));
        for block in &blocks {
            assert!((block.solid.volume_m3() - known).abs() < 1e-12, "{}", block.name);
        }
        let [low, high] = blocks[7].solid.bounds_m();
        assert!((low[0] + high[0]).abs() < 1e-12);
    }

    #[test]
    fn holds_arches_of_every_rise_join_stone_to_stone() {
        // n voussoirs and two abutments: n + 1 joints of the arch, and one joint of each abutment with the ground
        for (rise, lift) in [
            (0.5, 1.0),
            (1.0, 0.3),
            (1.5, 0.0),
            (1.5, 2.0),
            (2.2, 0.0),
            (2.6, 1.0),
        ] {
            for count in [6, 7, 24, 51] {
                let blocks = arch(&factors(rise, count, lift)).unwrap();
                let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
                let expected = count as usize + if lift > 0.0 { 3 } else { 1 };
                assert_eq!(stack.joints().len(), expected, "{rise} {lift} {count}");
                // the inner line has the required rise at a joint of the crown
                let crown = stack.blocks()[count as usize / 2].solid.vertices_m();
                let near = crown.iter().filter(|v| v[0].abs() < 1e-9).map(|v| v[2]);
                let least = near.fold(f64::INFINITY, f64::min);
                assert!(
                    count % 2 == 1 || (least - rise - lift).abs() < 1e-9,
                    "{rise} {count}: {least}"
                );
            }
        }
    }

    #[test]
    fn refuses_what_is_no_arch() {
        let flat = arch(&factors(0.5, 9, 0.0)).unwrap_err();
        assert!(flat.to_string().contains("needs abutments"), "{flat}");
        let none = arch(&factors(1.5, 1, 0.0)).unwrap_err();
        assert!(none.to_string().contains("2 to 400"), "{none}");
        let narrow = ArchFactors {
            abutment_m: 0.4,
            ..factors(1.5, 9, 1.0)
        };
        assert!(arch(&narrow).is_err());
    }
}
