//! Divides the equilibrium of a stack into independent pieces.

use super::SwayingForces;
use super::chosen_toes::{ChosenToes, UsedToes};
use super::cuts::{SupportRelation, carries};
use super::limit_programme::{AccelerationSet, Programme, Terms, settings};
use super::limit_pushes::{Column, HeldFriction, Push, ToePush};
use super::limit_region::{Symmetry, candidates, group, is_among, turned};
use super::loads::{Load, together};
use super::mechanism::BodyMotion;
use super::possible_force::{Law, PossibleForce};
use crate::structure::stack::{Body, Stack};
use clarabel::solver::DefaultSettings;
use glam::DVec3;

/// Coefficients (of order 1) below this are rounding and are left out. Our choice.
const ROUNDING: f64 = 1e-13;
/// Relative difference below which positions and loads count as equal. Our choice: the limit changes by no more.
const SAME: f64 = 1e-9;

/// The growing load.
#[derive(Clone, Copy)]
pub(super) enum GrowingLoad<'a> {
    /// Inertia: the mass of each block times an acceleration.
    Shaking,
    /// Given shaking forces on each block.
    Swaying(&'a [SwayingForces]),
    /// Static loads on each block: "along x" is their factor over g, and nothing grows along y.
    Loads(&'a [Load]),
}

/// Two bodies connected by a joint or a tie.
#[derive(Clone, Copy)]
struct Link {
    lower: Option<usize>,
    upper: usize,
}

impl Link {
    fn new(lower: Body, upper: usize) -> Self {
        let lower = match lower {
            Body::Ground => None,
            Body::Block(block) => Some(block),
        };
        Link { lower, upper }
    }
}

/// The six equilibrium equations of a block, or of blocks that move as one: three forces, three moments.
struct Balance {
    load: Load,
    /// Force and moment about the origin under shaking of 1 g along x and along y.
    shaking: [(DVec3, DVec3); 2],
    /// Reference point of its moments.
    about: DVec3,
    /// The total weight that its block carries, N.
    weight: f64,
    blocks: Vec<usize>,
}

/// Transforms the six velocities of a balance in a programme into those of its blocks.
struct VelocityTransform {
    blocks: Vec<usize>,
    about: DVec3,
    weight: f64,
}

/// Connected blocks and forces.
pub(super) struct Piece {
    moves: Vec<VelocityTransform>,
    length: f64,
    /// The force unit of each push, N.
    pub(super) units: Vec<f64>,
    /// The link of each push: the joints, then the ties.
    pub(super) links: Vec<usize>,
    at_rest: Vec<f64>,
    shaking: [Vec<f64>; 2],
    pushes: Vec<Push>,
    symmetries: Vec<Symmetry>,
}

impl Piece {
    pub(super) fn equations(&self) -> usize {
        self.at_rest.len()
    }

    /// Its blocks.
    pub(super) fn blocks(&self) -> impl Iterator<Item = usize> {
        self.moves.iter().flat_map(|moves| moves.blocks.iter().copied())
    }

    /// Loads at rest, six for each balance.
    pub(super) fn at_rest(&self) -> &[f64] {
        &self.at_rest
    }

    /// Possible forces of its joints and ties.
    pub(super) fn pushes(&self) -> &[Push] {
        &self.pushes
    }

    /// Power of the loads of 1 g along x and y in a mechanism: the outward normal of the region of balanced accelerations, where the mechanism
    /// bounds it.
    pub(super) fn shaking_power(&self, velocities: &[f64]) -> [f64; 2] {
        let power = |shaking: &Vec<f64>| shaking.iter().zip(velocities).map(|(load, six)| load * six).sum();
        [power(&self.shaking[0]), power(&self.shaking[1])]
    }

    /// The motions of each block of the stack, from the velocities of a programme.
    pub(super) fn motions(&self, velocities: &[f64], count: usize) -> Vec<Vec<BodyMotion>> {
        let mut motions = vec![Vec::new(); count];
        for (moves, six) in self.moves.iter().zip(velocities.chunks_exact(6)) {
            let motion = BodyMotion {
                velocity: DVec3::new(six[0], six[1], six[2]) / moves.weight,
                spin: DVec3::new(six[3], six[4], six[5]) / (moves.weight * self.length),
                about: moves.about,
            };
            for &block in &moves.blocks {
                motions[block].push(motion);
            }
        }
        motions
    }

    /// Whether joints of finite strength are included.
    pub(super) fn crushes(&self) -> bool {
        self.pushes.iter().any(|push| matches!(push, Push::Toes(_)))
    }

    /// Rotations and mirrors in plan that leave its capacity unchanged.
    pub(super) fn symmetries(&self) -> &[Symmetry] {
        &self.symmetries
    }

    pub(super) fn programme(&self, within: AccelerationSet) -> Programme<'_> {
        self.programme_by(within, settings())
    }

    pub(super) fn programme_by(
        &self,
        within: AccelerationSet,
        settings: DefaultSettings<f64>,
    ) -> Programme<'_> {
        Programme::new(self.terms(within, settings))
    }

    /// The programme that begins with the stress blocks of earlier ones.
    pub(super) fn programme_after(&self, used: &UsedToes, within: AccelerationSet) -> Programme<'_> {
        let chosen = ChosenToes::used(&self.pushes, &self.links, used);
        Programme::with(self.terms(within, settings()), chosen)
    }

    fn terms(&self, within: AccelerationSet, settings: DefaultSettings<f64>) -> Terms<'_> {
        Terms {
            at_rest: &self.at_rest,
            shaking: [&self.shaking[0], &self.shaking[1]],
            pushes: &self.pushes,
            within,
            settings,
        }
    }
}

/// The pushes of a piece, in order.
#[derive(Default)]
struct PiecePushes {
    pushes: Vec<Push>,
    units: Vec<f64>,
    links: Vec<usize>,
    /// The link of the last push, if it is a toe.
    toes_of: Option<usize>,
    /// The link of the last push, if it is held friction.
    held_of: Option<usize>,
}

impl PiecePushes {
    /// Adds a possible force; `column` gives the equilibrium terms of a unit force along an axis.
    fn add(&mut self, act: &PossibleForce, unit: f64, column: impl Fn(DVec3) -> Column) {
        let [normal, first_way, second_way] = act.axes;
        let (mut toes_of, mut held_of) = (None, None);
        let push = match act.law {
            Law::Friction(0.0) => Push::Normal(column(normal)),
            Law::Friction(mu) => {
                Push::Cone([column(normal), column(first_way * mu), column(second_way * mu)])
            }
            Law::Toe { friction, capacity_n } => {
                let toe = ToePush {
                    parts: [normal, first_way * friction, second_way * friction].map(column),
                    share: unit / capacity_n,
                };
                // the toes of a joint are consecutive
                let is_next = self.toes_of == Some(act.link);
                if let Some(Push::Toes(toes)) = self.pushes.last_mut().filter(|_| is_next) {
                    toes.push(toe);
                    return;
                }
                toes_of = Some(act.link);
                Push::Toes(vec![toe])
            }
            Law::Shear(strength) => Push::Disc([column(first_way), column(second_way)], strength / unit),
            Law::Held(strength) => {
                let point = [column(first_way), column(second_way)];
                held_of = Some(act.link);
                let is_next = self.held_of == held_of;
                if let Some(Push::Held(held)) = self.pushes.last_mut().filter(|_| is_next) {
                    held.points.push(point);
                    held.strength += strength / unit;
                    return;
                }
                Push::Held(HeldFriction {
                    strength: strength / unit,
                    points: vec![point],
                })
            }
            Law::Pull(strength) => Push::Pull(column(-normal), strength / unit),
        };
        (self.toes_of, self.held_of) = (toes_of, held_of);
        self.pushes.push(push);
        self.units.push(unit);
        self.links.push(act.link);
    }
}

/// Balances that include a possible force, with its sign in each.
type Incidence = Vec<(usize, f64)>;

/// Division of a stack: its links, and for each block the blocks that it carries.
struct Division {
    /// The joints, then the ties.
    links: Vec<Link>,
    /// For each block: the block and all blocks that stand on it, ascending.
    groups: Vec<Vec<usize>>,
    /// For each block: the joint that alone links its group to the rest, if there is one.
    alone: Vec<Option<usize>>,
}

impl Division {
    fn new(stack: &Stack, ties: bool, blocks: usize) -> Self {
        let mut links: Vec<Link> = stack
            .joints()
            .iter()
            .map(|joint| Link::new(joint.lower, joint.upper))
            .collect();
        if ties {
            links.extend(stack.ties().iter().map(|tie| Link::new(tie.lower, tie.upper)));
        }
        let carriers = SupportRelation::of(stack);
        let groups: Vec<Vec<usize>> = (0..blocks).map(|block| carriers.carried(vec![block])).collect();
        let alone = (0..blocks)
            .map(|block| alone(stack, &links, block, &groups[block]))
            .collect();
        Division { links, groups, alone }
    }

    /// The balances that include the forces of a link.
    fn ends(&self, link: usize) -> Incidence {
        let Link { lower, upper } = self.links[link];
        let single = self.alone[upper] == Some(link);
        let both = [(Some(upper), 1.0), (lower.filter(|_| !single), -1.0)];
        let taken = both.into_iter().filter_map(|(block, sign)| Some((block?, sign)));
        taken
            .filter(|&(block, _)| single || self.alone[block].is_none())
            .collect()
    }

    /// The piece of each block, identified by its first block; links connect pieces.
    fn piece_of(&self) -> Vec<usize> {
        let mut piece_of: Vec<usize> = (0..self.groups.len()).collect();
        for link in 0..self.links.len() {
            if let [(a, _), (b, _)] = self.ends(link)[..] {
                let (kept, gone) = (piece_of[a], piece_of[b]);
                for piece in &mut piece_of {
                    if *piece == gone {
                        *piece = kept;
                    }
                }
            }
        }
        piece_of
    }

    /// The blocks whose loads are included in the balance of a block.
    fn balanced_with(&self, block: usize) -> Vec<usize> {
        if self.alone[block].is_some() {
            return self.groups[block].clone();
        }
        let mut blocks = vec![block];
        let stands_alone_on_it =
            |above: &usize| self.alone[*above].is_some_and(|link| self.links[link].lower == Some(block));
        let on_it = (0..self.groups.len()).filter(stands_alone_on_it);
        blocks.extend(on_it.flat_map(|above| &self.groups[above]));
        blocks
    }
}

/// Divides a stack into pieces.
///
/// ```text
/// a joint that alone links all it carries to the rest: its forces balance the sum of what it carries    [6 equations]
/// all other blocks, each with the loads that such joints transfer to it; linked blocks form one piece    [6 per block]
/// ```
///
/// Together they are equivalent to the balance of every block.
pub(super) fn pieces(
    stack: &Stack,
    loads: &[Load],
    acts: &[PossibleForce],
    growing: GrowingLoad<'_>,
    ties: bool,
) -> Vec<Piece> {
    let division = Division::new(stack, ties, loads.len());
    let piece_of = division.piece_of();
    let mut acts_of: Vec<Vec<&PossibleForce>> = vec![Vec::new(); loads.len()];
    for act in acts {
        if let Some(&(first, _)) = division.ends(act.link).first() {
            acts_of[piece_of[first]].push(act);
        }
    }
    let whole = BalancedStack {
        balances: balances(&division, loads, growing, stack.gravity_m_s2()),
        scale: Scale {
            length: stack.height_m(),
        },
        division,
        growing,
    };
    let blocks_of = |piece: usize| -> Vec<usize> {
        let blocks = (0..loads.len()).filter(|&block| piece_of[block] == piece);
        blocks.collect()
    };
    (0..loads.len())
        .map(|piece| (blocks_of(piece), &acts_of[piece]))
        .filter(|(blocks, _)| !blocks.is_empty())
        .map(|(blocks, acts)| whole.piece(&blocks, acts))
        .collect()
}

fn balances(division: &Division, loads: &[Load], growing: GrowingLoad<'_>, gravity: f64) -> Vec<Balance> {
    let balance = |block: usize| {
        let blocks = division.balanced_with(block);
        let load = together(loads, &blocks);
        Balance {
            shaking: [DVec3::X, DVec3::Y].map(|axis| match growing {
                GrowingLoad::Shaking => {
                    let force = axis * (load.mass * gravity);
                    (force, load.centroid().cross(force))
                }
                GrowingLoad::Swaying(swaying) => swayed(&blocks, axis, loads, swaying),
                GrowingLoad::Loads(all) if axis == DVec3::X => {
                    let sum = together(all, &blocks);
                    (sum.force, sum.moment)
                }
                GrowingLoad::Loads(_) => (DVec3::ZERO, DVec3::ZERO),
            }),
            load,
            about: loads[block].centroid(),
            weight: together(loads, &division.groups[block]).mass * gravity,
            blocks,
        }
    };
    (0..loads.len()).map(balance).collect()
}

/// A stack with the balances of its blocks.
struct BalancedStack<'a> {
    division: Division,
    balances: Vec<Balance>,
    scale: Scale,
    growing: GrowingLoad<'a>,
}

impl BalancedStack<'_> {
    /// The piece of these blocks (ascending) with these possible forces.
    fn piece(&self, blocks: &[usize], acts: &[&PossibleForce]) -> Piece {
        let scale = &self.scale;
        let mut own = Vec::new();
        let mut gathered = PiecePushes::default();
        for &act in acts {
            let ends = self.division.ends(act.link);
            let Some(&(first, _)) = ends.first() else {
                continue;
            };
            let unit = self.balances[first].weight;
            gathered.add(act, unit, |way| self.column(blocks, act, &ends, way * unit));
            own.push((act, ends));
        }
        let balances: Vec<&Balance> = blocks.iter().map(|&block| &self.balances[block]).collect();
        let mut made = Piece {
            moves: balances
                .iter()
                .map(|balance| VelocityTransform {
                    blocks: balance.blocks.clone(),
                    about: balance.about,
                    weight: balance.weight,
                })
                .collect(),
            length: scale.length,
            units: gathered.units,
            links: gathered.links,
            at_rest: Vec::new(),
            shaking: [Vec::new(), Vec::new()],
            // mirror symmetries hold only under equal shaking forces
            symmetries: match self.growing {
                GrowingLoad::Shaking => symmetries(blocks, &balances, &own, scale),
                GrowingLoad::Swaying(_) | GrowingLoad::Loads(_) => group(&[]),
            },
            pushes: gathered.pushes,
        };
        for balance in balances {
            let load = &balance.load;
            made.at_rest.extend(scale.six(balance, load.force, load.moment));
            for (&(force, moment), shaking) in balance.shaking.iter().zip(&mut made.shaking) {
                shaking.extend(scale.six(balance, force, moment));
            }
        }
        made
    }

    /// Contribution of a force at the point of `act` to the balances of a piece.
    fn column(&self, blocks: &[usize], act: &PossibleForce, ends: &Incidence, force: DVec3) -> Column {
        let mut column = Column::new();
        for &(block, sign) in ends {
            if let Ok(at) = blocks.binary_search(&block) {
                let push = force * sign;
                let six = self.scale.six(&self.balances[block], push, act.at.cross(push));
                let parts = six.into_iter().enumerate();
                let parts = parts.filter(|(_, part)| part.abs() > ROUNDING);
                column.extend(parts.map(|(row, part)| (6 * at + row, part)));
            }
        }
        column
    }
}

/// Force and moment about the origin of the shaking forces on these blocks along an axis.
fn swayed(blocks: &[usize], axis: DVec3, loads: &[Load], swaying: &[SwayingForces]) -> (DVec3, DVec3) {
    let which = usize::from(axis == DVec3::Y);
    let turns = DVec3::Z.cross(axis);
    let mut sum = (DVec3::ZERO, DVec3::ZERO);
    for &block in blocks {
        let force = axis * swaying[block].force_n[which];
        sum.0 += force;
        sum.1 += loads[block].centroid().cross(force) + turns * swaying[block].moment_n_m[which];
    }
    sum
}

/// The mirrors and turns in plan that map a piece onto itself.
fn symmetries(
    blocks: &[usize],
    balances: &[&Balance],
    acts: &[(&PossibleForce, Incidence)],
    scale: &Scale,
) -> Vec<Symmetry> {
    let loads: Vec<Load> = balances.iter().map(|balance| balance.load).collect();
    let middle = together(&loads, &(0..loads.len()).collect::<Vec<_>>()).centroid();
    let holds = |symmetry: &Symmetry| {
        let way = |vector: DVec3| {
            let [x, y] = turned(symmetry, [vector.x, vector.y]);
            DVec3::new(x, y, vector.z)
        };
        // a mirror reverses moments, a turn does not
        let handed = symmetry[0][0] * symmetry[1][1] - symmetry[0][1] * symmetry[1][0];
        let place = |point: DVec3| middle + way(point - middle);
        let near = |a: DVec3, b: DVec3, unit: f64| (a - b).abs().max_element() <= SAME * unit;
        // images of the blocks
        let mut image = Vec::with_capacity(balances.len());
        for from in balances {
            let own = |balance: &Balance| balance.load.moment - balance.about.cross(balance.load.force);
            let to = balances.iter().position(|to| {
                near(place(from.about), to.about, scale.length)
                    && near(place(from.load.centroid()), to.load.centroid(), scale.length)
                    && (from.load.mass - to.load.mass).abs() <= SAME * from.load.mass
                    && (from.weight - to.weight).abs() <= SAME * from.weight
                    && near(way(from.load.force), to.load.force, from.weight)
                    && near(way(own(from)) * handed, own(to), from.weight * scale.length)
            });
            match to {
                Some(to) => image.push(blocks[to]),
                None => return false,
            }
        }
        let image = |block: usize| blocks.binary_search(&block).ok().map(|at| image[at]);
        // a joint may list its two blocks in the other order: then its normal and the signs of its ends are reversed
        let is_image = |from: &(&PossibleForce, Incidence), to: &(&PossibleForce, Incidence), order: f64| {
            let same_ends = from.1.len() == to.1.len()
                && from.1.iter().all(|&(block, sign)| {
                    image(block).is_some_and(|block| to.1.contains(&(block, order * sign)))
                });
            same_ends && from.0.law.is_like(to.0.law) && near(way(from.0.axes[0]) * order, to.0.axes[0], 1.0)
        };
        let has_image = |from: &(&PossibleForce, Incidence)| {
            let at = place(from.0.at);
            let mut there = acts.iter().filter(|to| near(at, to.0.at, scale.length));
            there.any(|to| is_image(from, to, 1.0) || is_image(from, to, -1.0))
        };
        acts.iter().all(has_image)
    };
    let offsets: Vec<DVec3> = balances.iter().map(|balance| balance.about - middle).collect();
    let (mut generators, mut all) = (Vec::new(), group(&[]));
    for candidate in candidates(&offsets, SAME * scale.length) {
        if !is_among(&all, &candidate) && holds(&candidate) {
            generators.push(candidate);
            all = group(&generators);
        }
    }
    all
}

/// The joint below a block, if nothing else connects the blocks above to the rest.
fn alone(stack: &Stack, links: &[Link], block: usize, group: &[usize]) -> Option<usize> {
    let within = |block: usize| group.binary_search(&block).is_ok();
    let mut crossing =
        (0..links.len()).filter(|&link| within(links[link].upper) != links[link].lower.is_some_and(within));
    let only = crossing.next().filter(|_| crossing.next().is_none())?;
    let joint = stack.joints().get(only)?;
    (joint.upper == block && carries(joint)).then_some(only)
}

/// Scales forces and moments to order 1.
struct Scale {
    length: f64,
}

impl Scale {
    /// Force divided by the weight; moment (given about the origin) about the point of the balance, divided by weight and length.
    fn six(&self, balance: &Balance, force: DVec3, moment: DVec3) -> [f64; 6] {
        let moment = (moment - balance.about.cross(force)) / (balance.weight * self.length);
        let force = force / balance.weight;
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }
}
