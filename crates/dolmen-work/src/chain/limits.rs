//! Joints of a chain against the edges of their beds.

use super::ChainSimulation;
use crate::error::WorkError;
use crate::part_limit::{Limited, Part, PartLimit};
use dolmen::assess::demand::{SiteDemand, chain_moments_by_spectrum};
use dolmen::dynamics::ChainRotations;
use dolmen_project::{ChainPart, Quantity};

/// Names of the links, lowest first.
pub(crate) fn link_names(part: &ChainPart) -> Vec<String> {
    let each = part.links.iter().enumerate();
    each.map(|(i, link)| link.name.clone().unwrap_or_else(|| format!("link {}", i + 1)))
        .collect()
}

fn at_edge(link: String, moment_n_m: f64, most_n_m: f64) -> PartLimit {
    PartLimit {
        part: Part::JointBelow(link),
        direction: None,
        limited: Limited::BedEdge,
        demand: moment_n_m.abs(),
        capacity: most_n_m.is_finite().then_some(most_n_m),
    }
}

/// The elastic moments by the spectrum of the site; empty where the joints are not known, or it falls.
pub(crate) fn by_spectrum(part: &ChainPart, site: &SiteDemand) -> Result<Vec<PartLimit>, WorkError> {
    let Some(stiffness) = part.stiffness_n_m_rad(&mut Quantity::nominal) else {
        return Ok(Vec::new());
    };
    let chain = part.build(&mut Quantity::nominal)?;
    let Some(moments) = chain_moments_by_spectrum(&chain, &stiffness, site)? else {
        return Ok(Vec::new());
    };
    let Some(model) = part.moving(ChainRotations::Small, &mut Quantity::nominal)? else {
        return Ok(Vec::new());
    };
    let each = link_names(part)
        .into_iter()
        .zip(moments)
        .zip(model.moment_most_n_m());
    Ok(each
        .map(|((link, moment), most)| at_edge(link, moment, *most))
        .collect())
}

impl ChainSimulation {
    /// Largest rotation of a link for which the linear equations are kept, rad: beyond, sin and cos differ from them by 0.2 and 0.5 %.
    /// Chosen here, as for storeys.
    pub const SMALL_ROTATION_MOST_RAD: f64 = 0.1;

    /// Each joint against the edge of its bed.
    pub fn parts(&self) -> Vec<PartLimit> {
        let each = self.links.iter().zip(self.model.moment_most_n_m()).enumerate();
        each.map(|(joint, (link, most))| at_edge(link.clone(), self.joint_moment_peak_n_m(joint), *most))
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
