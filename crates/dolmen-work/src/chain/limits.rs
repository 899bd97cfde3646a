//! Moments in the joints of a chain compared with the limits of their beds.

use super::ChainSimulation;
use super::loads::AtRest;
use crate::error::WorkError;
use crate::part_limit::{Compared, Limited, NotCompared, Part, PartLimit, WhyNotCompared};
use dolmen::assess::demand::{SiteDemand, chain_moments_by_spectrum};
use dolmen::dynamics::ChainRotations;
use dolmen::stability::{BedEdge, JointHold};
use dolmen::structure::Chain;
use dolmen_project::{ChainPart, ChainSupportPart, Quantity};

/// Names of the links, lowest first.
pub(crate) fn link_names(part: &ChainPart) -> Vec<String> {
    let each = part.links.iter().enumerate();
    each.map(|(i, link)| link.name.clone().unwrap_or_else(|| format!("link {}", i + 1)))
        .collect()
}

fn at_edge(link: String, moment_n_m: f64, most_n_m: Option<f64>, taken_n_m: f64) -> PartLimit {
    PartLimit {
        part: Part::JointBelow(link),
        direction: None,
        limited: Limited::BedEdge,
        demand: moment_n_m.abs(),
        capacity: most_n_m.map(|most| (most - taken_n_m).max(0.0)),
        taken: taken_n_m,
        lean: [0.0; 2],
    }
}

/// The elastic moments under the spectrum of the site, compared with the part of each bed's limit that the surveyed tilt and static loads leave.
/// A held joint has no limit.
pub(crate) fn by_spectrum(
    part: &ChainPart,
    at_rest: &[AtRest],
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Compared, WorkError> {
    let is_loose = |support: &ChainSupportPart| support.gap.is_some();
    if part.side_supports.iter().any(is_loose) {
        let why = WhyNotCompared::LoosePost;
        return Ok(Compared {
            not_compared: vec![NotCompared { direction: None, why }],
            ..Compared::default()
        });
    }
    match at_rest {
        [along, across] => by_spectrum_all_round(part, [along, across], site, damping_ratio),
        [along, ..] => along_alone(part, along, site, damping_ratio),
        [] => Ok(Compared::default()),
    }
}

/// The moments in the joints under the spectrum of the site, from the springs. With dry friction, also those of the chain with every joint
/// stuck, which moves with the ground; the larger counts. `None` if it falls.
fn moments_of(
    part: &ChainPart,
    (chain, stiffness): (&Chain, &[f64]),
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Option<Vec<f64>>, WorkError> {
    let Some(mut moments) = chain_moments_by_spectrum(chain, stiffness, site, damping_ratio)? else {
        return Ok(None);
    };
    if let Some(peak_m_s2) = site.peak_ground_acceleration_m_s2.filter(|_| rubs(part)) {
        let heights_m = chain.joint_heights_m();
        let links = || chain.links().iter().zip(&heights_m);
        for (i, moment) in moments.iter_mut().enumerate() {
            let above = links().skip(i);
            let stuck: f64 = above
                .map(|(link, foot_m)| link.mass_kg * (foot_m + link.centroid_m - heights_m[i]))
                .sum();
            *moment = moment.abs().max(stuck * peak_m_s2);
        }
    }
    Ok(Some(moments))
}

fn rubs(part: &ChainPart) -> bool {
    part.joints.iter().flatten().any(|joint| joint.friction.is_some())
}

/// Fraction of the weight on a bed that remains under the vertical acceleration of the site, which acts fully at the time of the worst moment,
/// as for a stack; 1 without a vertical acceleration.
fn left_of_weight(chain: &Chain, site: &SiteDemand) -> f64 {
    let peak_m_s2 = site.peak_ground_acceleration_m_s2.unwrap_or(0.0);
    let vertical_m_s2 = site.vertical.map_or(0.0, |vertical| vertical.ratio * peak_m_s2);
    (1.0 - vertical_m_s2 / chain.gravity_m_s2()).max(0.0)
}

fn along_alone(
    part: &ChainPart,
    at_rest: &AtRest,
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Compared, WorkError> {
    let none = |why| Compared {
        not_compared: vec![NotCompared { direction: None, why }],
        ..Compared::default()
    };
    let Some(stiffness) = part.stiffness_n_m_rad(&mut Quantity::nominal) else {
        return Ok(none(WhyNotCompared::StiffnessUnknown));
    };
    let Some(moments) = moments_of(part, (&at_rest.chain, &stiffness), site, damping_ratio)? else {
        return Ok(none(WhyNotCompared::Falls));
    };
    let left = left_of_weight(&at_rest.chain, site);
    let each = link_names(part)
        .into_iter()
        .zip(moments)
        .zip(at_rest.under.joints.iter().zip(&at_rest.holds));
    let limited = each.filter(|(_, (_, hold))| **hold != JointHold::Held);
    let parts = limited.map(|((link, moment), (joint, _))| {
        // it is unknown whether the loads and the lean act in the same direction
        let loads_n_m = joint.moment_n_m.unwrap_or(joint.rigid_moment_n_m);
        let taken_n_m = joint.tilt_moment_n_m.abs() + loads_n_m.abs();
        at_edge(link, moment, joint.limit_n_m.map(|most| left * most), taken_n_m)
    });
    Ok(Compared {
        parts: parts.collect(),
        rubs: rubs(part),
        ..Compared::default()
    })
}

/// The same for a chain with two directions: the ground moves along x, along y, and for each bed in the worst direction between.
fn by_spectrum_all_round(
    part: &ChainPart,
    at_rest: [&AtRest; 2],
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Compared, WorkError> {
    let mut moments = Vec::new();
    for of in at_rest {
        let direction = Some(of.axis.name().to_owned());
        let not_compared = |why| NotCompared { direction, why };
        let not_compared = match part.stiffness_towards(of.axis, &mut Quantity::nominal) {
            None => not_compared(WhyNotCompared::StiffnessUnknown),
            Some(stiffness) => match moments_of(part, (&of.chain, &stiffness), site, damping_ratio)? {
                None => not_compared(WhyNotCompared::Falls),
                Some(found) => {
                    moments.push(found);
                    continue;
                }
            },
        };
        return Ok(Compared {
            not_compared: vec![not_compared],
            ..Compared::default()
        });
    }
    let taken = |axis: usize, joint: usize| {
        let of = &at_rest[axis].under.joints[joint];
        of.tilt_moment_n_m.abs() + of.moment_n_m.unwrap_or(of.rigid_moment_n_m).abs()
    };
    let mut parts = Vec::new();
    for (joint, link) in link_names(part).into_iter().enumerate() {
        let hold = at_rest[0].holds[joint];
        if hold == JointHold::Held {
            continue;
        }
        let there = [taken(0, joint), taken(1, joint)];
        let asked = [moments[0][joint].abs(), moments[1][joint].abs()];
        let normal_n = left_of_weight(&at_rest[0].chain, site) * at_rest[0].under.joints[joint].axial_n;
        let towards = |[along, across]: [f64; 2]| {
            let growing = [along * asked[0], across * asked[1]];
            let left = |bed: BedEdge| bed.reach(normal_n, there, growing);
            PartLimit {
                demand: growing[0].hypot(growing[1]),
                capacity: match hold {
                    JointHold::Bed(bed) => Some(left(bed) * growing[0].hypot(growing[1])),
                    JointHold::Held | JointHold::Unknown => None,
                },
                taken: (along * there[0]).hypot(across * there[1]),
                lean: [0.0; 2],
                ..at_edge(link.clone(), 0.0, None, 0.0)
            }
        };
        let named = |limit: PartLimit, name: &str| PartLimit {
            direction: Some(name.to_owned()),
            ..limit
        };
        let sides = [named(towards([1.0, 0.0]), "x"), named(towards([0.0, 1.0]), "y")];
        let ratio = |of: &PartLimit| of.ratio().unwrap_or(f64::INFINITY);
        let of_sides = sides.iter().map(ratio).fold(f64::INFINITY, f64::min);
        let between = (1..DEGREES).map(|degrees| {
            let angle = f64::from(degrees).to_radians();
            towards([angle.cos(), angle.sin()])
        });
        let worst = between.min_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        parts.extend(sides);
        parts.extend(
            worst
                .filter(|worst| ratio(worst) < of_sides * (1.0 - ROUNDING))
                .map(|worst| named(worst, "x+y")),
        );
    }
    Ok(Compared {
        parts,
        rubs: rubs(part),
        ..Compared::default()
    })
}

/// Directions of the ground between x and y, one for each degree: beds are symmetric about their axes. Our choice.
const DEGREES: u32 = 90;
/// A direction between is reported only if it is worse than both sides by this factor. Our choice.
const ROUNDING: f64 = 1e-6;

impl ChainSimulation {
    /// Largest rotation of a link for which the linear equations are valid, rad: beyond it, sin and cos differ from them by 0.2 and
    /// 0.5 %. Our choice, as for storeys.
    pub const SMALL_ROTATION_MOST_RAD: f64 = 0.1;

    /// Each joint compared with the edge of its bed.
    pub fn parts(&self) -> Vec<PartLimit> {
        let each = self.links.iter().zip(self.model.moment_most_n_m()).enumerate();
        each.map(|(joint, (link, most))| {
            let most = most.is_finite().then_some(*most);
            PartLimit {
                direction: self.direction.map(|axis| axis.name().to_owned()),
                ..at_edge(link.clone(), self.joint_moment_peak_n_m(joint), most, 0.0)
            }
        })
        .collect()
    }

    /// The link whose rotation is beyond the validity of the linear equations, and its rotation, rad; `None` for equations of large rotations.
    pub fn beyond_small_rotations(&self) -> Option<(usize, f64)> {
        if self.model.rotations() == ChainRotations::Large {
            return None;
        }
        // by both directions together
        if let Some(of) = self
            .together
            .filter(|of| of.lean_rad > Self::SMALL_ROTATION_MOST_RAD)
        {
            return Some((of.link, of.lean_rad));
        }
        let peaks = self
            .history
            .rotation_peaks
            .iter()
            .map(|peak| peak.rotation_rad.abs());
        let largest = peaks.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        (largest.1 > Self::SMALL_ROTATION_MOST_RAD).then_some(largest)
    }
}
