//! Makes a spherical dome, or two opposite slices of one, of rings of stones with plane faces.
//!
//! Every bed and every head joint lies in a plane through the centre of the sphere, so stones share them exactly: a stone is the part of a
//! pyramid with its apex in the centre between two parallel planes, its inner and its outer face.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | s, h | `span_m`, `rise_m` | clear diameter at the springing, rise of the inner sphere above it | m |
//! | t | `thickness_m` | thickness, along the joints | m |
//! | r | `radii` | radius of the corners of the inner and of the outer face | m |
//! | n, m | `rings`, `stones` | number of rings, number of stones in a ring | – |
//! | θ_k | `angles` | angle of bed k from the vertical axis, lowest first | rad |
//! | η | `half_turn` | half the angle of a stone in plan, π/m | rad |

use super::dome_factors::{DomeFactors, DomePart, check};
use super::{Block, Bond, Solid, StackError};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Angle within which the springing is level, rad.
const LEVEL: f64 = 1e-9;

/// The sphere and the joints on it.
struct Joints {
    radii: [f64; 2],
    angles: Vec<f64>,
    half_turn: f64,
    centre_m: f64,
}

/// A dome: the drum, if any, then rings from the lowest, then the keystone, unless there is an oculus.
///
/// ```text
/// r = (s²/4 + h²) / (2h),  r + t;   θ_0 at the springing, equal steps to θ_n at the oculus, or to half a step from the axis
/// V = ⅓ ((r+t)³ − r³) sin η cos η (sin θ_k + sin θ_k+1) sin(θ_k − θ_k+1)      of a stone that is not shifted
/// ```
///
/// Names are "ring 2 stone 3" and "drum stone 3", both from 1, and "keystone", whose m sides continue the joints of the top ring.
///
/// In running bond every second ring is turned by half a stone. A stone then lies on the plane beds of two stones and has five sides; its inner and
/// outer face keep their planes, so that their edges alternate by r (1 − cos η) from ring to ring, and as much less of a bed bears.
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range.
///
/// # Limits
/// Faces are plane. The rise is at most half the span. The keystone of two slices is a rectangle as wide as they are, about twice as heavy as the tips
/// of both.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{Bond, DomeFactors, DomePart, dome};
/// let made = dome(&DomeFactors {
///     span_m: 4.0, rise_m: 2.0, thickness_m: 0.3, rings: 5, stones: 8, part: DomePart::Whole(Bond::Straight), oculus_m: None,
///     drum_height_m: 0.0, drum_thickness_m: 0.6, density_kg_m3: 2600.0,
/// })?;
/// assert_eq!((made.len(), made[40].name.as_str()), (41, "keystone"));
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn dome(factors: &DomeFactors) -> Result<Vec<Block>, StackError> {
    check(factors)?;
    let joints = Joints::of(factors);
    let bond = match factors.part {
        DomePart::Whole(bond) => bond,
        DomePart::Lune => Bond::Straight,
    };
    let stones: Vec<u32> = match factors.part {
        DomePart::Whole(_) => (0..factors.stones).collect(),
        DomePart::Lune => vec![0, factors.stones / 2],
    };
    let turn = |stone: u32, shift: f64| TAU * (f64::from(stone) + shift) / f64::from(factors.stones);
    let block = |name: String, points: &[[f64; 3]]| -> Result<Block, StackError> {
        Ok(Block {
            name,
            solid: Solid::convex(points)?,
            density_kg_m3: factors.density_kg_m3,
        })
    };
    let mut blocks = Vec::new();
    if factors.drum_height_m > 0.0 {
        let points = joints.drum_stone(factors);
        // the lowest ring breaks joint with the drum, too
        for stone in &stones {
            let turned = turned(&points, turn(*stone, bond.shift(1)));
            blocks.push(block(format!("drum stone {}", stone + 1), &turned)?);
        }
    }
    let has_level_springing = (joints.angles[0] - FRAC_PI_2).abs() < LEVEL;
    for ring in 0..factors.rings {
        let is_shifted = bond == Bond::Running && !(ring == 0 && has_level_springing);
        let points = joints.stone(ring as usize, is_shifted);
        for stone in &stones {
            let name = format!("ring {} stone {}", ring + 1, stone + 1);
            blocks.push(block(name, &turned(&points, turn(*stone, bond.shift(ring))))?);
        }
    }
    if factors.oculus_m.is_none() {
        let top = joints.top_edges();
        let shift = bond.shift(factors.rings - 1);
        let points: Vec<[f64; 3]> = (stones.iter())
            .flat_map(|stone| turned(&top, turn(*stone, shift)))
            .collect();
        blocks.push(block("keystone".to_owned(), &points)?);
    }
    Ok(blocks)
}

/// Points rotated about the vertical axis.
fn turned(points: &[[f64; 3]], angle: f64) -> Vec<[f64; 3]> {
    let (sin, cos) = angle.sin_cos();
    let turn = |[x, y, z]: &[f64; 3]| [cos * x - sin * y, sin * x + cos * y, *z];
    points.iter().map(turn).collect()
}

impl Joints {
    fn of(factors: &DomeFactors) -> Self {
        let (half, rise) = (0.5 * factors.span_m, factors.rise_m);
        let inner = (half * half + rise * rise) / (2.0 * rise);
        let springing = half.atan2(inner - rise);
        let rings = f64::from(factors.rings);
        let step = match factors.oculus_m {
            Some(oculus) => (springing - (0.5 * oculus / inner).asin()) / rings,
            None => springing / (rings + 0.5),
        };
        Joints {
            radii: [inner, inner + factors.thickness_m],
            angles: (0..=factors.rings)
                .map(|bed| springing - f64::from(bed) * step)
                .collect(),
            half_turn: 0.5 * TAU / f64::from(factors.stones),
            centre_m: factors.drum_height_m - (inner - rise),
        }
    }

    /// Direction from the centre, at an angle from the axis and one in plan.
    fn direction(angle: f64, in_plan: f64) -> [f64; 3] {
        let (sin, cos) = angle.sin_cos();
        [sin * in_plan.cos(), sin * in_plan.sin(), cos]
    }

    /// Middle of the inner edge of a bed, at radius 1, in the middle plane of a stone: distance from the axis, height above the centre.
    fn edge(&self, bed: usize) -> [f64; 2] {
        let (sin, cos) = self.angles[bed].sin_cos();
        [sin * self.half_turn.cos(), cos]
    }

    /// Corners of a stone of a ring, its middle plane along x.
    fn stone(&self, ring: usize, is_on_two: bool) -> Vec<[f64; 3]> {
        let eta = self.half_turn;
        let [low, high] = [self.angles[ring], self.angles[ring + 1]];
        let mut directions = vec![Self::direction(high, -eta), Self::direction(high, eta)];
        if is_on_two {
            // head joints end in the middle of the beds below, which meet in the middle of this stone
            let middle = (low.sin() * eta.cos()).atan2(low.cos());
            directions
                .extend([(middle, -eta), (low, 0.0), (middle, eta)].map(|(a, p)| Self::direction(a, p)));
        } else {
            directions.extend([-eta, eta].map(|in_plan| Self::direction(low, in_plan)));
        }
        // the plane through the edges of both beds, at radius 1: x n_x + z n_z = c
        let [[x, z], [x_high, z_high]] = [self.edge(ring), self.edge(ring + 1)];
        let [n_x, n_z] = [z_high - z, x - x_high];
        let c = n_x * x + n_z * z;
        let at = |radius: f64, [u, v, w]: [f64; 3]| {
            let reach = radius * c / (n_x * u + n_z * w);
            [reach * u, reach * v, self.centre_m + reach * w]
        };
        let each = |radius| directions.iter().map(move |direction| at(radius, *direction));
        self.radii.into_iter().flat_map(each).collect()
    }

    /// Corners of the top bed of a stone of the top ring.
    fn top_edges(&self) -> Vec<[f64; 3]> {
        let top = self.angles.last().copied().unwrap_or_default();
        let at = |radius: f64, in_plan: f64| {
            let [u, v, w] = Self::direction(top, in_plan);
            [radius * u, radius * v, self.centre_m + radius * w]
        };
        let each = |radius| [-self.half_turn, self.half_turn].map(|in_plan| at(radius, in_plan));
        self.radii.into_iter().flat_map(each).collect()
    }

    /// Corners of a stone of the drum, its middle plane along x.
    fn drum_stone(&self, factors: &DomeFactors) -> Vec<[f64; 3]> {
        let [x, z] = self.edge(0);
        let [inner, outer] = self.radii.map(|radius| [radius * x, self.centre_m + radius * z]);
        let back = (0.5 * factors.span_m + factors.drum_thickness_m) * self.half_turn.cos();
        let section = [[inner[0], 0.0], [back, 0.0], [back, outer[1]], outer, inner];
        let slope = self.half_turn.tan();
        let both = |[x, z]: [f64; 2]| [[x, -slope * x, z], [x, slope * x, z]];
        section.into_iter().flat_map(both).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Body, JointMaterial, Stack};
    use super::*;
    use crate::numeric::Random;

    const USUAL: DomeFactors = DomeFactors {
        span_m: 4.0,
        rise_m: 2.0,
        thickness_m: 0.4,
        rings: 4,
        stones: 12,
        part: DomePart::Whole(Bond::Straight),
        oculus_m: Some(1.0),
        drum_height_m: 0.0,
        drum_thickness_m: 0.8,
        density_kg_m3: 2600.0,
    };
    const PARTS: [DomePart; 3] = [
        DomePart::Whole(Bond::Straight),
        DomePart::Whole(Bond::Running),
        DomePart::Lune,
    ];

    /// Volume of all stones from the formulas, without shifts: pyramids between both radii, and prisms of the drum.
    fn volume_m3(factors: &DomeFactors) -> f64 {
        let joints = Joints::of(factors);
        let [r, outer] = joints.radii;
        let (sin, cos) = joints.half_turn.sin_cos();
        let cubes = (outer.powi(3) - r.powi(3)) / 3.0;
        let (stones, keystones) = match factors.part {
            DomePart::Whole(_) => (f64::from(factors.stones), f64::from(factors.stones)),
            DomePart::Lune => (2.0, 4.0),
        };
        let rings: f64 = joints
            .angles
            .windows(2)
            .map(|of| (of[0].sin() + of[1].sin()) * (of[0] - of[1]).sin())
            .sum();
        let mut volume = stones * cubes * sin * cos * rings;
        if factors.oculus_m.is_none() {
            let top = joints.angles[joints.angles.len() - 1];
            volume += keystones * cubes * sin * cos * top.sin().powi(2) * top.cos();
        }
        if factors.drum_height_m > 0.0 {
            // a prismatoid that widens with the distance x from the axis: ∫ 2 x tan η z dx, z from the springing to the shoulder
            let [x, z] = joints.edge(0);
            let [from, to] = [r * x, outer * x];
            let back = (0.5 * factors.span_m + factors.drum_thickness_m) * cos;
            let shoulder = joints.centre_m + outer * z;
            let squares = |a: f64, b: f64| b * b - a * a;
            let slope = z / x;
            let sloped =
                joints.centre_m * squares(from, to) + slope * 2.0 / 3.0 * (to.powi(3) - from.powi(3));
            volume += stones * (sin / cos) * (sloped + shoulder * squares(to, back));
        }
        volume
    }

    #[test]
    fn exact_stones_share_their_joints_and_fill_the_dome() {
        let stack = Stack::new(dome(&USUAL).unwrap(), JointMaterial::default(), 9.81).unwrap();
        // heads, beds, the ground
        assert_eq!(stack.joints().len(), 48 + 36 + 12);
        for joint in stack.joints() {
            let axis = joint.axes[2];
            let through: f64 = (0..3).map(|k| axis[k] * joint.origin_m[k]).sum();
            assert!(through.abs() < 1e-9, "a joint off the centre: {through}");
        }
        let known = volume_m3(&USUAL);
        let shell =
            2.0 / 3.0 * std::f64::consts::PI * (2.4_f64.powi(3) - 8.0) * (1.0 - 0.25_f64.powi(2)).sqrt();
        assert!(known < shell && known > 0.9 * shell, "{known} {shell}");
    }

    #[test]
    fn exact_a_turned_ring_lies_on_two_stones_each() {
        let running = DomeFactors {
            part: DomePart::Whole(Bond::Running),
            ..USUAL
        };
        let stack = Stack::new(dome(&running).unwrap(), JointMaterial::default(), 9.81).unwrap();
        for stone in 12..48 {
            let below = stack.joints().iter().filter(|joint| {
                joint.upper == stone
                    && matches!(joint.lower, Body::Block(lower) if lower / 12 + 1 == stone / 12)
            });
            assert_eq!(below.count(), 2, "{stone}");
        }
        // the pyramid of a turned stone, corner by corner
        let joints = Joints::of(&running);
        let points = joints.stone(2, true);
        let at = |i: usize| glam::DVec3::from(points[i]);
        // around the face: both corners above, then those below from the second to the first
        let around = [0, 1, 4, 3, 2];
        let fan: f64 = (1..4)
            .map(|k| at(around[0]).dot(at(around[k]).cross(at(around[k + 1]))) / 6.0)
            .sum();
        let known = fan.abs() * ((2.4_f64 / 2.0).powi(3) - 1.0);
        let found = Solid::convex(&points).unwrap().volume_m3();
        assert!((found / known - 1.0).abs() < 1e-9, "{found} {known}");
    }

    #[test]
    fn holds_any_factors_make_the_whole_dome_or_are_refused() {
        let mut random = Random::new(11, 0);
        let mut made_some = 0;
        for turn in 0..300 {
            let mut of = |least: f64, most: f64| least + (most - least) * random.uniform();
            let span_m = of(0.2, 9.0);
            let factors = DomeFactors {
                span_m,
                rise_m: if of(0.0, 1.0) < 0.4 {
                    0.5 * span_m
                } else {
                    of(0.05, 0.6) * span_m
                },
                thickness_m: of(-0.01, 0.3) * span_m,
                rings: of(0.0, 12.0) as u32,
                stones: of(5.0, 30.0) as u32,
                part: PARTS[turn % 3],
                oculus_m: (of(0.0, 1.0) < 0.5).then_some(of(-0.1, 1.1) * span_m),
                drum_height_m: of(-0.2, 3.0).max(-0.02),
                drum_thickness_m: of(0.1, 0.6) * span_m,
                density_kg_m3: 2600.0,
            };
            let Ok(made) = dome(&factors) else { continue };
            made_some += 1;
            let volume: f64 = made.iter().map(|block| block.solid.volume_m3()).sum();
            let known = volume_m3(&factors);
            // turned stones end on plane beds, which bulge above the edges of the rings
            let (least, most) = match factors.part {
                DomePart::Whole(Bond::Running) => (0.9, 1.1),
                DomePart::Whole(Bond::Straight) | DomePart::Lune => (1.0 - 1e-9, 1.0 + 1e-9),
            };
            assert!(
                (least..most).contains(&(volume / known)),
                "{volume} {known} {factors:?}"
            );
        }
        assert!(made_some > 60, "{made_some}");
    }

    #[test]
    fn refuses_what_is_no_dome() {
        for (factors, said) in [
            (DomeFactors { rise_m: 2.1, ..USUAL }, "half the span"),
            (DomeFactors { rise_m: 1.0, ..USUAL }, "needs a drum"),
            (
                DomeFactors {
                    oculus_m: Some(4.0),
                    ..USUAL
                },
                "below the span",
            ),
            (DomeFactors { rings: 0, ..USUAL }, "1 to 40"),
            (DomeFactors { stones: 5, ..USUAL }, "6 to 48"),
            (
                DomeFactors {
                    rings: 40,
                    stones: 16,
                    ..USUAL
                },
                "600 stones",
            ),
            (
                DomeFactors {
                    stones: 9,
                    part: DomePart::Lune,
                    ..USUAL
                },
                "even for a lune",
            ),
            (
                DomeFactors {
                    thickness_m: 0.1,
                    part: DomePart::Whole(Bond::Running),
                    ..USUAL
                },
                "more stones",
            ),
            (
                DomeFactors {
                    drum_height_m: 1.0,
                    drum_thickness_m: 0.3,
                    ..USUAL
                },
                "thickness of the dome",
            ),
            (
                DomeFactors {
                    drum_height_m: f64::NAN,
                    ..USUAL
                },
                "drum_height_m",
            ),
            (
                DomeFactors {
                    span_m: f64::INFINITY,
                    ..USUAL
                },
                "span_m",
            ),
        ] {
            let fault = dome(&factors).unwrap_err().to_string();
            assert!(fault.contains(said), "{said}: {fault}");
        }
    }
}
