//! One part of a stack above a cut: its tipping and sliding. Symbols as in `stack_limits`.

use super::contact::{Contact, contact, names_below};
use super::half_plane::{HalfPlane, least_on};
use super::loads::{Load, together};
use super::on_soil::OnSoil;
use super::toe::toe;
use super::{Cut, CutLimits, EdgeLimit, LimitKind, Resistance, StackLimits, Standing};
use crate::structure::stack::{Body, Stack, Tie};
use glam::DVec3;
use std::f64::consts::TAU;

/// Number of directions between two neighbouring edges in which a toe of finite strength is computed. Our choice: 5.6° on a square.
const TOES: usize = 16;
/// Distance from the edge, over the size of the contact, below which a point counts as on the edge. Our choice: rounding of
/// coordinates.
const ON_EDGE: f64 = 1e-9;
/// Number of directions of sliding before refinement. Our choice.
const SLIDES: usize = 72;
/// Number of directions in which the resistance to sliding is given. Our choice: the worst direction is at most 1° away, which
/// changes it by 1.5e-4.
const RESISTS: usize = 180;

pub(super) fn limits_of(
    stack: &Stack,
    cut: Cut,
    loads: &[Load],
    options: &StackLimits,
    soil: &OnSoil,
) -> CutLimits {
    let part = Part::of(stack, cut, loads, soil);
    let Part {
        cut,
        load,
        contact,
        normal_force,
        ..
    } = &part;
    let about = load.moment - contact.origin.cross(load.force);
    let resultant = [
        about.dot(contact.axes[1]) / normal_force,
        -about.dot(contact.axes[0]) / normal_force,
    ];
    let above = names_below(stack, cut);
    let mut limits = CutLimits {
        above,
        weight_n: load.mass * (stack.gravity_m_s2() + options.loads.vertical_acceleration_m_s2),
        normal_n: *normal_force,
        centroid_m: load.centroid().into(),
        origin_m: contact.origin.into(),
        axes: contact.axes.map(Into::into),
        depth_m: contact.hull.depth_m(resultant),
        contact: contact.hull.clone(),
        area_m2: contact.area_m2(),
        resultant_m: resultant,
        gravity_margin: 0.0,
        edges: Vec::new(),
        crushed_m: None,
        uplift: None,
        uplift_with_ties: None,
        sliding: None,
        sliding_with_ties: None,
        standing: Standing::Stands,
        tipping: Vec::new(),
        cut: cut.clone(),
    };
    if *normal_force <= 0.0 {
        limits.gravity_margin = f64::NEG_INFINITY;
        limits.standing = Standing::Lifts {
            above: limits.above.clone(),
            pull_n: -normal_force,
        };
        return limits;
    }
    part.tip(&mut limits, part.strength());
    part.slide(&mut limits);
    if !limits.standing.stands() || !soil.standing.stands() {
        limits.edges.clear();
        limits.tipping.clear();
        limits.crushed_m = None;
        (limits.uplift, limits.uplift_with_ties) = (None, None);
        (limits.sliding, limits.sliding_with_ties) = (None, None);
    }
    limits
}

/// The part above one cut, with the data for its limits.
pub(super) struct Part<'a> {
    stack: &'a Stack,
    cut: Cut,
    load: Load,
    contact: Contact,
    normal_force: f64,
    soil: &'a OnSoil,
    gravity: f64,
}

impl<'a> Part<'a> {
    pub(super) fn of(stack: &'a Stack, cut: Cut, loads: &[Load], soil: &'a OnSoil) -> Self {
        let load = together(loads, &cut.blocks);
        let contact = contact(stack, &cut);
        Part {
            stack,
            normal_force: -load.force.dot(contact.axes[2]),
            cut,
            load,
            contact,
            soil,
            gravity: stack.gravity_m_s2(),
        }
    }

    /// All resistances of the part to tipping and sliding, without ties.
    pub(super) fn resists(&self) -> Vec<Resistance> {
        let (mut all, strength) = (Vec::new(), self.strength());
        for outward in self.outwards(strength.is_some()) {
            // a contact beyond its capacity has no resistance
            let (pivot, crushed) = match self.pivot(outward, strength) {
                Some(pivot) => (pivot, false),
                None => (self.contact.hull.moments().centroid_m, true),
            };
            let (p, axis) = (
                self.contact.at(pivot),
                self.contact.axes[2].cross(self.contact.along(outward)),
            );
            // axis · (M − p × F)
            all.push(Resistance {
                kind: LimitKind::Uplift,
                force: p.cross(axis).into(),
                moment: axis.into(),
                reserve: if crushed {
                    0.0
                } else {
                    self.about(pivot, outward, false).reserve
                },
            });
        }
        let (mu, cohesion) = self.friction();
        for k in 0..RESISTS {
            let angle = TAU * k as f64 / RESISTS as f64;
            let way = self.contact.along([angle.cos(), angle.sin()]);
            all.push(Resistance {
                kind: LimitKind::Sliding,
                force: (way + self.contact.axes[2] * mu).into(),
                moment: [0.0; 3],
                reserve: self
                    .sliding_on_soil(self.slides_along(angle, mu, cohesion))
                    .reserve,
            });
        }
        if self.is_whole() {
            all.extend(self.soil.resists());
        }
        all
    }

    /// Whether this is the whole stack.
    fn is_whole(&self) -> bool {
        self.cut.blocks.len() == self.stack.blocks().len()
    }

    /// Rotation about the line through `pivot` perpendicular to `outward`, both in the plane.
    fn about(&self, pivot: [f64; 2], outward: [f64; 2], ties: bool) -> HalfPlane {
        let p = self.contact.at(pivot);
        let axis = self.contact.axes[2].cross(self.contact.along(outward));
        let lever = axis.cross(self.load.centroid() - p) * self.load.mass;
        let mut reserve = -axis.dot(self.load.moment - p.cross(self.load.force));
        if ties {
            reserve += self.pull_of_ties(p, axis);
        }
        let of_loads = axis.cross(self.load.pressed_first - p * self.load.pressed_n);
        let rigid = HalfPlane {
            lever: [lever.x, lever.y],
            reserve,
        };
        self.soil.half_plane(rigid, [of_loads.x, of_loads.y])
    }

    /// Moment of all ties of the cut that the rotation stretches, each at its strength.
    fn pull_of_ties(&self, pivot: DVec3, axis: DVec3) -> f64 {
        let mut moment = 0.0;
        for tie in self.ties() {
            if tie.axial_stiffness_n_m > 0.0 {
                let along = DVec3::from(tie.axis).normalize();
                let up = along * along.dot(self.contact.axes[2]).signum();
                let lift = axis.cross(DVec3::from(tie.position_m) - pivot).dot(up);
                if lift > 0.0 {
                    moment += tie.tension_strength_n * lift;
                }
            }
        }
        moment
    }

    /// Ties between the part above and the rest.
    fn ties(&self) -> impl Iterator<Item = &Tie> {
        let within = |body: Body| matches!(body, Body::Block(block) if self.cut.blocks.contains(&block));
        self.stack
            .ties()
            .iter()
            .filter(move |tie| within(tie.lower) != within(Body::Block(tie.upper)))
    }

    /// Outward directions of the tipping axes: one for each edge, and with finite strength many between the edges.
    fn outwards(&self, many: bool) -> Vec<[f64; 2]> {
        let corners = &self.contact.hull.corners_m;
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let angles: Vec<f64> = edges.map(|(a, b)| (a[0] - b[0]).atan2(b[1] - a[1])).collect();
        let mut outwards = Vec::new();
        for (&angle, &next) in angles.iter().zip(angles.iter().cycle().skip(1)) {
            let turn = (next - angle).rem_euclid(TAU);
            let between = if many { TOES } else { 1 };
            for step in 0..between {
                let at = angle + turn * step as f64 / between as f64;
                outwards.push([at.cos(), at.sin()]);
            }
        }
        if !many {
            // normals of the edges themselves, free of the rounding of angles
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            outwards = edges
                .map(|(a, b)| {
                    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
                    [(b[1] - a[1]) / length, (a[0] - b[0]) / length]
                })
                .collect();
        }
        outwards
    }

    /// Point of the axis of tipping in a direction of the plane; `None` if the contact cannot carry the force.
    fn pivot(&self, outward: [f64; 2], strength: Option<f64>) -> Option<[f64; 2]> {
        if let Some(strength) = strength {
            return toe(&self.contact.patches, outward, self.normal_force / strength);
        }
        // the middle of the outermost edge
        let along = |corner: &[f64; 2]| corner[0] * outward[0] + corner[1] * outward[1];
        let corners = &self.contact.hull.corners_m;
        let most = corners.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        let near = 1e-9 * self.contact.hull.size_m();
        let outermost: Vec<_> = corners
            .iter()
            .filter(|corner| along(corner) >= most - near)
            .collect();
        let sum = outermost
            .iter()
            .fold([0.0; 2], |sum, corner| [sum[0] + corner[0], sum[1] + corner[1]]);
        let count = outermost.len() as f64;
        Some([sum[0] / count, sum[1] / count])
    }

    fn tip(&self, limits: &mut CutLimits, strength: Option<f64>) {
        let middle = self.contact.hull.moments().centroid_m;
        let (mut inside, mut margin) = (f64::INFINITY, f64::INFINITY);
        let (mut tangents, mut with_ties, mut pivots) = (Vec::new(), Vec::new(), Vec::new());
        let mut best_direction = [1.0, 0.0];
        for outward in self.outwards(strength.is_some()) {
            let Some(pivot) = self.pivot(outward, strength) else {
                limits.gravity_margin = 0.0;
                limits.standing = Standing::Overloaded {
                    above: limits.above.clone(),
                    pressure_pa: self.normal_force / self.contact.area_m2(),
                    strength_pa: strength.unwrap_or(f64::INFINITY),
                };
                return;
            };
            let beyond =
                |from: [f64; 2]| (pivot[0] - from[0]) * outward[0] + (pivot[1] - from[1]) * outward[1];
            let distance = beyond(limits.resultant_m);
            inside = inside.min(distance);
            margin = margin.min(distance / beyond(middle));
            let half_plane = self.about(pivot, outward, false);
            let soonest = tangents
                .iter()
                .map(HalfPlane::distance)
                .fold(f64::INFINITY, f64::min);
            if half_plane.distance() < soonest {
                best_direction = outward;
            }
            tangents.push(half_plane);
            pivots.push(pivot);
            with_ties.push(self.about(pivot, outward, true));
            let axis = self.contact.axes[2].cross(self.contact.along(outward));
            let at = self.contact.at(pivot);
            limits.edges.push(EdgeLimit {
                pivot_m: at.into(),
                axis: axis.into(),
                distance_m: distance,
                height_m: self.load.centroid().z - at.z,
                uplift: half_plane.threshold(self.gravity),
            });
        }
        limits.gravity_margin = margin;
        // a resultant exactly on the edge counts as not standing, independent of rounding
        let edge = ON_EDGE * self.contact.hull.size_m();
        if limits.depth_m <= edge {
            limits.standing = Standing::Leaves {
                above: limits.above.clone(),
                distance_m: (-limits.depth_m).max(0.0),
            };
        } else if inside <= edge {
            limits.standing = Standing::Crushes {
                above: limits.above.clone(),
                distance_m: (-inside).max(0.0),
            };
        }
        if !limits.standing.stands() {
            limits.gravity_margin = limits.gravity_margin.min(0.0);
        }
        limits.tipping = tangents.clone();
        if strength.is_some() {
            // chords between pivots lie inside the limit of the strength: conservative in every direction
            limits.tipping = self.chords(&pivots);
            tangents.extend(self.refined(best_direction, strength));
        }
        if self.is_whole() {
            let overturns = self.soil.overturns(self.load.mass);
            limits.tipping.extend(overturns);
            tangents.extend(overturns);
            with_ties.extend(overturns);
        }
        let soonest = |all: &[HalfPlane]| {
            let least = all.iter().copied().reduce(|best, other| {
                if other.distance() < best.distance() {
                    other
                } else {
                    best
                }
            });
            least.map(|half_plane| half_plane.threshold(self.gravity))
        };
        limits.crushed_m = strength.and_then(|_| {
            let pivot = self.pivot(best_direction, strength)?;
            let along = |point: [f64; 2]| point[0] * best_direction[0] + point[1] * best_direction[1];
            let corners = self.contact.hull.corners_m.iter();
            let edge = corners
                .map(|&corner| along(corner))
                .fold(f64::NEG_INFINITY, f64::max);
            Some(edge - along(pivot))
        });
        limits.uplift = soonest(&tangents);
        limits.uplift_with_ties = soonest(&with_ties);
    }

    /// Lines through neighbouring pivots.
    fn chords(&self, pivots: &[[f64; 2]]) -> Vec<HalfPlane> {
        let pairs = pivots.iter().zip(pivots.iter().cycle().skip(1));
        pairs
            .filter_map(|(&a, &b)| {
                let length = (b[0] - a[0]).hypot(b[1] - a[1]);
                let apart = length > 1e-12 * self.contact.hull.size_m();
                apart.then(|| self.about(a, [(b[1] - a[1]) / length, (a[0] - b[0]) / length], false))
            })
            .collect()
    }

    /// The worst direction near a given one, because finite strength rounds the corners of the contact.
    fn refined(&self, near: [f64; 2], strength: Option<f64>) -> Option<HalfPlane> {
        let angle = near[1].atan2(near[0]);
        let at = |angle: f64| {
            let outward = [angle.cos(), angle.sin()];
            let pivot = self.pivot(outward, strength)?;
            Some(self.about(pivot, outward, false))
        };
        let width = 0.5 * std::f64::consts::PI / TOES as f64;
        let best = least_on(angle - width, angle + width, |angle| {
            at(angle).map_or(f64::INFINITY, |half_plane| half_plane.distance())
        });
        at(best)
    }

    fn slide(&self, limits: &mut CutLimits) {
        let (mu, cohesion) = self.friction();
        let normal = self.contact.axes[2];
        let along = self.load.force + normal * self.normal_force;
        let (shear, resistance) = (along.length(), mu * self.normal_force + cohesion);
        let left = if resistance > 0.0 {
            1.0 - shear / resistance
        } else {
            0.0
        };
        limits.gravity_margin = limits.gravity_margin.min(left);
        if left <= 0.0 && limits.standing.stands() {
            limits.standing = Standing::Slides {
                above: limits.above.clone(),
                shear_n: shear,
                resistance_n: resistance,
            };
        }
        let tied: f64 = self.ties().map(|tie| tie.shear_strength_n).sum();
        limits.sliding = Some(self.sliding(mu, cohesion).threshold(self.gravity));
        limits.sliding_with_ties = Some(self.sliding(mu, cohesion + tied).threshold(self.gravity));
    }

    /// Smallest compressive strength of its joints, Pa; `None` if none crushes.
    fn strength(&self) -> Option<f64> {
        let joints = self.cut.joints.iter().map(|&joint| &self.stack.joints()[joint]);
        let given = joints.filter_map(|joint| joint.material.compressive_strength_pa);
        given.reduce(f64::min)
    }

    /// Smallest friction coefficient of its joints, and the sum of cohesion × area, N.
    fn friction(&self) -> (f64, f64) {
        let joints = self.cut.joints.iter().map(|&joint| &self.stack.joints()[joint]);
        let (mut mu, mut cohesion) = (f64::INFINITY, 0.0);
        for joint in joints {
            mu = mu.min(joint.material.friction_static);
            cohesion += joint.material.cohesion_pa * joint.patch.moments().area_m2;
        }
        (mu, cohesion)
    }

    /// Limit of sliding in one direction of the plane, on rigid ground.
    fn slides_along(&self, angle: f64, mu: f64, bond: f64) -> HalfPlane {
        let way = self.contact.along([angle.cos(), angle.sin()]);
        let lever = (way + self.contact.axes[2] * mu) * self.load.mass;
        HalfPlane {
            lever: [lever.x, lever.y],
            reserve: mu * self.normal_force + bond - way.dot(self.load.force),
        }
    }

    /// A limit of sliding on the soil.
    fn sliding_on_soil(&self, rigid: HalfPlane) -> HalfPlane {
        // the lever holds the mass of the part
        let of_loads = rigid
            .lever
            .map(|part| part * self.load.pressed_n / self.load.mass);
        self.soil.half_plane(rigid, of_loads)
    }

    /// The smallest limit of sliding over all directions.
    fn sliding(&self, mu: f64, bond: f64) -> HalfPlane {
        let at = |angle: f64| self.slides_along(angle, mu, bond);
        let step = TAU / SLIDES as f64;
        let mut best = (0.0, at(0.0).distance());
        for k in 1..SLIDES {
            let angle = step * k as f64;
            let distance = at(angle).distance();
            if distance < best.1 * (1.0 - 1e-12) {
                best = (angle, distance);
            }
        }
        let fine = least_on(best.0 - step, best.0 + step, |angle| at(angle).distance());
        let least = match at(fine).distance() < best.1 * (1.0 - 1e-12) {
            true => at(fine),
            false => at(best.0),
        };
        self.sliding_on_soil(least)
    }
}
