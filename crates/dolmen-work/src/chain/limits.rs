//! Joints of a chain against the edges of their beds.

use super::ChainSimulation;
use super::loads::AtRest;
use crate::error::WorkError;
use crate::part_limit::{Compared, Limited, NotCompared, Part, PartLimit, WhyNotCompared};
use dolmen::assess::demand::{SiteDemand, chain_moments_by_spectrum};
use dolmen::dynamics::ChainRotations;
use dolmen::stability::JointHold;
use dolmen_project::{ChainPart, Quantity};

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
    }
}

/// The elastic moments by the spectrum of the site, against what the tilt as surveyed and static loads leave of each bed. A joint that is
/// held has no limit.
pub(crate) fn by_spectrum(
    part: &ChainPart,
    at_rest: &AtRest,
    site: &SiteDemand,
    damping_ratio: f64,
) -> Result<Compared, WorkError> {
    let none = |why| Compared {
        parts: Vec::new(),
        not_compared: vec![NotCompared { direction: None, why }],
    };
    let Some(stiffness) = part.stiffness_n_m_rad(&mut Quantity::nominal) else {
        return Ok(none(WhyNotCompared::StiffnessUnknown));
    };
    let Some(moments) = chain_moments_by_spectrum(&at_rest.chain, &stiffness, site, damping_ratio)? else {
        return Ok(none(WhyNotCompared::Falls));
    };
    let each = link_names(part)
        .into_iter()
        .zip(moments)
        .zip(at_rest.under.joints.iter().zip(&at_rest.holds));
    let limited = each.filter(|(_, (_, hold))| **hold != JointHold::Held);
    let parts = limited.map(|((link, moment), (joint, _))| {
        // which way the loads push and the structure leans is not known to be the same, nor to be another
        let loads_n_m = joint.moment_n_m.unwrap_or(joint.rigid_moment_n_m);
        let taken_n_m = joint.tilt_moment_n_m.abs() + loads_n_m.abs();
        at_edge(link, moment, joint.limit_n_m, taken_n_m)
    });
    Ok(Compared {
        parts: parts.collect(),
        not_compared: Vec::new(),
    })
}

impl ChainSimulation {
    /// Largest rotation of a link for which the linear equations are kept, rad: beyond, sin and cos differ from them by 0.2 and 0.5 %.
    /// Chosen here, as for storeys.
    pub const SMALL_ROTATION_MOST_RAD: f64 = 0.1;

    /// Each joint against the edge of its bed.
    pub fn parts(&self) -> Vec<PartLimit> {
        let each = self.links.iter().zip(self.model.moment_most_n_m()).enumerate();
        each.map(|(joint, (link, most))| {
            let most = most.is_finite().then_some(*most);
            at_edge(link.clone(), self.joint_moment_peak_n_m(joint), most, 0.0)
        })
        .collect()
    }

    /// The link that rotated beyond what the linear equations can tell of, and by how much, rad; `None` for equations of large rotations.
    pub fn beyond_small_rotations(&self) -> Option<(usize, f64)> {
        if self.model.rotations() == ChainRotations::Large {
            return None;
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
