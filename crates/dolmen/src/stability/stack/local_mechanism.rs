//! The rigid parts of the mechanism in which a stack begins to move in one direction, and the equivalent oscillator of codes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | α₀ | `multiplier` | horizontal acceleration over gravity at which the mechanism moves | – |
//! | P | `weight_n` | weight of a rigid part, whose blocks move as one body | N |
//! | δ | `moves` | virtual displacement of the centroid of a part along the shaking, over the largest one | – |
//! | v | `velocity` | velocity of a part that slides on a joint, and rises by friction | – |
//! | C | `cohesion_n` | cohesion × area of the joints of a cut | N |
//! | M* | `mass_kg` | participating mass | kg |
//! | e* | `mass_ratio` | participating fraction of the moving mass | – |
//! | d₀* | `overturning_m` | displacement of the oscillator at which its resistance vanishes | m |

use super::StackLoads;
use super::cuts::cuts;
use super::limit_along::{shaken_pieces, unit};
use super::limit_mechanism::named;
use super::limit_options::Holding;
use super::limit_pieces::Piece;
use super::limit_programme::{ACCELERATION_MOST, AccelerationSet, ProgrammeOutcome};
use super::loads::{Load, together};
use super::mechanism::BodyMotion;
use crate::stability::StabilityError;
use crate::structure::stack::{Block, Stack};
use glam::DVec3;

/// Relative difference below which velocities are equal. Our choice: the solver is accurate to 1e-8.
const SAME: f64 = 1e-4;
/// Relative difference below which two mechanisms move at the same acceleration. Our choice: the programme misses by 1e-6 at most.
const SAME_LIMIT: f64 = 2e-6;
/// Largest sine of the inclination of a horizontal axis of rotation, and largest relative motion along the axis. Our choice.
const LEVEL: f64 = 1e-3;

/// Blocks that move as one rigid body in a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPart {
    /// The blocks, ascending.
    pub blocks: Vec<usize>,
    /// P, N.
    pub weight_n: f64,
    /// Its centroid, m.
    pub centroid_m: [f64; 3],
    /// δ of its centroid along the shaking, over the largest of all parts.
    pub moves: f64,
    /// Rise of its centroid, to the same scale.
    pub rises: f64,
}

/// The mechanism in which a stack begins to move in one direction, as rigid parts.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanism {
    /// Unit vector of the inertia forces in plan.
    pub direction: [f64; 2],
    /// α₀.
    pub multiplier: f64,
    /// The moving parts, each identified by its lowest block.
    pub parts: Vec<RigidPart>,
    /// M*, kg.
    pub mass_kg: f64,
    /// e*.
    pub mass_ratio: f64,
    /// Whether a joint slides in the mechanism.
    pub slides: bool,
    /// d₀*, m; `None` unless exactly one part rotates, about a horizontal axis, and no joint slides.
    pub overturning_m: Option<f64>,
}

/// The mechanism in which a stack begins to move under inertia forces in one direction; `None` if it does not stand, or if nothing moves it.
///
/// ```text
/// velocities of the blocks: from the mechanism of the limit analysis
/// part    all blocks whose velocities are those of one rigid body
/// M* = (Σ P δ)² / (g Σ P δ²)          e* = (Σ P δ)² / (Σ P · Σ P δ²) = g M* / Σ P
/// d₀*     one part that rotates about a horizontal axis: displacement of its centroid until it stands above the axis
/// ```
///
/// Weights are summed over rigid parts, each at its own centroid. Summed by course, a wall that tips as one part would have e* → 3/4.
///
/// # Errors
/// [`StabilityError`] for a direction without length, and a programme that the solver could not solve.
///
/// # Limits
/// As for [`limit_analysis`](super::limit_analysis()): friction is associated, so sliding parts also rise; stone is infinitely strong;
/// cohesion resists sliding; ties and side supports resist nothing. If several mechanisms move at the same acceleration, the part above a cut
/// that slides as one body is taken, the lowest of them: its e* is 1, so no other has a smaller a₀*. Where none of them slides as one body,
/// the result may be a mixture of several, with more parts than each and an e* that another one exceeds. d₀* is not computed for several parts that move relative to each other, nor for a stack with
/// static loads. Static loads enter α₀, but have no mass in M* and e*.
///
/// # Example
/// ```
/// use dolmen::stability::stack::local_mechanism;
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let wall = Block { name: "wall".into(), solid: Solid::cuboid(0.4, 2.0, 4.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![wall], JointMaterial::default(), 9.81)?;
/// let found = local_mechanism(&stack, [1.0, 0.0])?.ok_or("nothing moves")?;
/// assert!((found.multiplier - 0.1).abs() < 1e-7 && (found.mass_ratio - 1.0).abs() < 1e-12);
/// assert!((found.overturning_m.ok_or("no axis")? - 0.2).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Circolare 7/2019 to NTC 2018, C8.7.1.2.1: definitions of α₀, M* and e*.
pub fn local_mechanism(stack: &Stack, direction: [f64; 2]) -> Result<Option<LocalMechanism>, StabilityError> {
    let mut found = local_mechanisms(stack, &[direction])?;
    found.pop().unwrap_or(Ok(None))
}

/// The mechanisms in several directions, as in [`local_mechanism`]; opposite directions share the proof that the stack stands.
///
/// # Errors
/// [`StabilityError`] for a direction of zero length. The result of a single direction is an error if the solver did not solve its
/// programme.
pub fn local_mechanisms(
    stack: &Stack,
    directions: &[[f64; 2]],
) -> Result<Vec<Result<Option<LocalMechanism>, StabilityError>>, StabilityError> {
    let ways = directions
        .iter()
        .map(|&direction| unit(direction))
        .collect::<Result<Vec<_>, _>>()?;
    let loads = StackLoads::default().on_blocks(stack)?;
    let pieces = shaken_pieces(stack, &loads, Holding::Cohesion);
    let limits: Vec<_> = ways.iter().map(|&way| Limit::of(&pieces, way)).collect();
    let each = ways.iter().zip(&limits).map(|(&way, limit)| {
        let limit = limit.as_ref().map_err(Clone::clone)?;
        let Some(limit) = limit else { return Ok(None) };
        let back = way.map(|part| -part);
        let stands_back = match ways.iter().position(|other| *other == back) {
            Some(opposite) => limits[opposite].as_ref().map_err(Clone::clone)?.is_some(),
            None => Limit::of(&pieces, back)?.is_some(),
        };
        let moving = limit.moving.as_ref().filter(|_| stands_back);
        let Some((piece, velocities)) = moving else {
            return Ok(None);
        };
        let motions = pieces[*piece].motions(velocities, stack.blocks().len());
        let Some(mechanism) = named(stack, &motions) else {
            return Ok(None);
        };
        let mut joints = mechanism.joints.iter();
        let slides = joints.any(|joint| joint.motion.slides());
        let found = of_parts(stack, &motions, way, limit.multiplier, slides);
        let is_divided = found.as_ref().is_none_or(|of| of.mass_ratio < 1.0 - SAME);
        let one = is_divided.then(|| slides_as_one(stack, &loads, way, limit.multiplier));
        Ok(one.flatten().or(found))
    });
    Ok(each.collect())
}

/// Largest balanced shaking along one direction.
struct Limit {
    multiplier: f64,
    /// The piece that moves first, and its velocities; `None` if nothing moves.
    moving: Option<(usize, Vec<f64>)>,
}

impl Limit {
    /// `None` if the limit is not positive.
    fn of(pieces: &[Piece], way: [f64; 2]) -> Result<Option<Self>, StabilityError> {
        let mut limit = Limit {
            multiplier: ACCELERATION_MOST * (1.0 - 1e-6),
            moving: None,
        };
        for (index, piece) in pieces.iter().enumerate() {
            let mut programme = piece.programme(AccelerationSet::Line(way));
            match programme.support(way)? {
                ProgrammeOutcome::Reaches(support) if support.bound > 0.0 => {
                    if support.bound < limit.multiplier {
                        limit.multiplier = support.bound;
                        limit.moving = Some((index, programme.velocities().to_vec()));
                    }
                }
                _ => return Ok(None),
            }
        }
        Ok(Some(limit))
    }
}

/// The part above the lowest cut that slides as one body at a multiplier; `None` if each needs more.
///
/// ```text
/// v = t + μ n        t unit vector of the joint along the shaking, n its normal: no joint of the cut is penetrated
/// α = (C − F · v) / (m g v · u)        F load at rest of the part, u direction of the shaking
/// ```
fn slides_as_one(stack: &Stack, loads: &[Load], way: [f64; 2], multiplier: f64) -> Option<LocalMechanism> {
    let towards = DVec3::new(way[0], way[1], 0.0);
    for cut in cuts(stack).cuts {
        let joints = || cut.joints.iter().map(|&joint| &stack.joints()[joint]);
        let normal = DVec3::from(stack.joints()[*cut.joints.first()?].axes[2]);
        let is_even = joints().all(|joint| normal.dot(DVec3::from(joint.axes[2])) > 1.0 - LEVEL * LEVEL);
        let Some(along) = (towards - normal * normal.dot(towards)).try_normalize() else {
            continue;
        };
        let mu = joints()
            .map(|joint| joint.material.friction_static)
            .fold(0.0, f64::max);
        let areas = joints().map(|joint| joint.material.cohesion_pa * joint.patch.moments().area_m2);
        let cohesion_n: f64 = areas.sum();
        let load = together(loads, &cut.blocks);
        let velocity = along + normal * mu;
        let work = load.mass * stack.gravity_m_s2() * velocity.dot(towards);
        let needed = (cohesion_n - load.force.dot(velocity)) / work;
        if is_even && work > 0.0 && needed <= multiplier * (1.0 + SAME_LIMIT) {
            let mut motions: Vec<Vec<BodyMotion>> = vec![Vec::new(); stack.blocks().len()];
            for &block in &cut.blocks {
                motions[block].push(BodyMotion {
                    velocity,
                    spin: DVec3::ZERO,
                    about: DVec3::ZERO,
                });
            }
            return of_parts(stack, &motions, way, multiplier, true);
        }
    }
    None
}

/// Velocity at a point of a block with several motions.
fn velocity(motions: &[BodyMotion], point: DVec3) -> DVec3 {
    motions.iter().map(|motion| motion.at(point)).sum()
}

fn of_parts(
    stack: &Stack,
    motions: &[Vec<BodyMotion>],
    way: [f64; 2],
    multiplier: f64,
    slides: bool,
) -> Option<LocalMechanism> {
    let corners = |block: &Block| -> Vec<DVec3> {
        let vertices = block.solid.vertices_m().iter();
        vertices.map(|vertex| DVec3::from(*vertex)).collect()
    };
    let blocks = stack.blocks();
    let speeds: Vec<f64> = blocks
        .iter()
        .zip(motions)
        .map(|(block, motions)| {
            let each = corners(block)
                .into_iter()
                .map(|corner| velocity(motions, corner).length());
            each.fold(0.0, f64::max)
        })
        .collect();
    let most = speeds.iter().copied().fold(0.0, f64::max);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, block) in blocks
        .iter()
        .enumerate()
        .filter(|(i, _)| speeds[*i] > SAME * most)
    {
        let is_one = |group: &Vec<usize>| {
            let mut both = corners(block).into_iter().chain(corners(&blocks[group[0]]));
            both.all(|corner| {
                let apart = velocity(&motions[index], corner) - velocity(&motions[group[0]], corner);
                apart.length() <= SAME * most
            })
        };
        match groups.iter().position(is_one) {
            Some(group) => groups[group].push(index),
            None => groups.push(vec![index]),
        }
    }
    let gravity = stack.gravity_m_s2();
    let towards = DVec3::new(way[0], way[1], 0.0);
    let mut parts: Vec<RigidPart> = groups
        .into_iter()
        .map(|group| {
            let mass: f64 = group.iter().map(|&block| blocks[block].mass_kg()).sum();
            let centroid = group
                .iter()
                .map(|&block| DVec3::from(blocks[block].solid.centroid_m()) * blocks[block].mass_kg())
                .sum::<DVec3>()
                / mass;
            let moves = velocity(&motions[group[0]], centroid);
            RigidPart {
                blocks: group,
                weight_n: mass * gravity,
                centroid_m: centroid.into(),
                moves: moves.dot(towards),
                rises: moves.z,
            }
        })
        .collect();
    let largest = parts
        .iter()
        .fold(0.0_f64, |most, part| most.max(part.moves.abs()));
    if largest <= 0.0 {
        return None;
    }
    for part in &mut parts {
        part.moves /= largest;
        part.rises /= largest;
    }
    let sum = |of: &dyn Fn(&RigidPart) -> f64| parts.iter().map(of).sum::<f64>();
    let first = sum(&|part| part.weight_n * part.moves);
    let second = sum(&|part| part.weight_n * part.moves * part.moves);
    let overturning_m = match &parts[..] {
        // with static loads, a part whose centroid stands above the axis may still be stable
        [part] if !slides && stack.static_loads().is_empty() => {
            overturning(&motions[part.blocks[0]], part.centroid_m.into(), towards)
        }
        _ => None,
    };
    Some(LocalMechanism {
        direction: way,
        multiplier,
        mass_kg: first * first / (gravity * second),
        mass_ratio: first * first / (sum(&|part| part.weight_n) * second),
        slides,
        overturning_m,
        parts,
    })
}

/// Displacement of the centroid of a part along the shaking, as the part rotates about a horizontal axis until the centroid stands above it.
fn overturning(motions: &[BodyMotion], centroid: DVec3, towards: DVec3) -> Option<f64> {
    let spin: DVec3 = motions.iter().map(|motion| motion.spin).sum();
    let axis = spin.try_normalize()?;
    let moves = velocity(motions, centroid);
    if axis.z.abs() > LEVEL || moves.dot(axis).abs() > LEVEL * moves.length() {
        return None;
    }
    // v = ω × r, with r from the axis
    let arm = moves.cross(spin) / spin.length_squared();
    let across = axis.cross(DVec3::Z);
    let (level, moves_across) = (arm.dot(across), towards.dot(across));
    let way = -level * moves_across;
    (way > 0.0).then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{JointMaterial, Placement, Solid};

    /// A wall of courses, 2.4 m long and 0.8 m thick, each of two stones.
    fn wall(courses: usize) -> Stack {
        let mut blocks = Vec::new();
        for course in 0..courses {
            // the joints of a course stand over stones
            let cut = if course % 2 == 0 { 1.0 } else { 1.4 };
            for (length, middle) in [(cut, 0.5 * cut - 1.2), (2.4 - cut, 0.5 * cut)] {
                let place = Placement {
                    position_m: [middle, 0.0, 0.25 * course as f64],
                    ..Placement::default()
                };
                blocks.push(Block {
                    name: format!("stone {}", blocks.len() + 1),
                    solid: Solid::cuboid(length, 0.8, 0.25).unwrap().placed(&place),
                    density_kg_m3: 2600.0,
                });
            }
        }
        Stack::new(blocks, JointMaterial::with_friction(0.6), 9.81).unwrap()
    }

    #[test]
    fn exact_of_courses_that_slide_at_the_same_acceleration_the_whole_wall_is_taken() {
        let wall = wall(4);
        let mass: f64 = wall.blocks().iter().map(Block::mass_kg).sum();
        for found in local_mechanisms(&wall, &[[1.0, 0.0], [-1.0, 0.0]]).unwrap() {
            let found = found.unwrap().unwrap();
            assert!((found.multiplier - 0.6).abs() < 1e-6, "{found:?}");
            assert!((found.mass_ratio - 1.0).abs() < 1e-12, "{found:?}");
            assert!((found.mass_kg / mass - 1.0).abs() < 1e-12 && found.slides);
        }
    }
}
