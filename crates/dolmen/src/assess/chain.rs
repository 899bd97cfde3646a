//! The whole check of a chain, and what lowering a centre of mass does.

use super::{AssessError, CentroidEffect, OneStoneCheck};
use crate::stability::{ChainLimits, ChainStability, chain_limits, chain_stability};
use crate::structure::{Chain, NaturalMode, SideSupport};

/// All results for a chain without a time history.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChainCheck {
    /// From weights and lengths alone.
    pub limits: ChainLimits,
    /// With the joints' stiffness; `None` if it is unknown.
    pub stability: Option<ChainStability>,
    /// Natural modes with the joints' stiffness; empty if it is unknown.
    pub modes: Vec<NaturalMode>,
    /// Effect of lowering each centroid.
    pub centroids: Vec<CentroidEffect>,
    /// Check of the shaft as one stone without joints, by [`check_one_stone`](super::check_one_stone); `None` if its
    /// material is unknown.
    pub one_stone: Option<OneStoneCheck>,
    /// The lowest joint and the soil below it; `None` if nothing is known of the soil.
    pub on_soil: Option<JointOnSoil>,
    /// The side supports.
    pub side_supports: Vec<SideSupport>,
    /// The load factor without side supports; `None` if no side support counts, or if the stiffness is unknown.
    pub load_factor_without_supports: Option<f64>,
    /// Results with the masses of the static loads, which move too; `None` without static loads.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub loaded: Option<Box<LoadedChain>>,
    /// Results across the direction of motion; `None` if the chain has the same properties in both directions.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub across: Option<Box<ChainAcross>>,
}

/// A chain with the masses that it carries.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoadedChain {
    /// Lowest natural frequency in the direction of motion, Hz; `None` if the chain falls, or if no stiffness is known.
    pub frequency_hz: Option<f64>,
    /// Lowest natural frequency across it, for a chain with properties in two directions.
    pub frequency_across_hz: Option<f64>,
    /// Least tilt at which a joint reaches its uplift limit, rad; `None` without bed widths or stiffness.
    pub uplift_tilt_rad: Option<f64>,
}

/// A chain across the direction of motion.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChainAcross {
    /// Rocking stiffness of the footing, N m/rad; `None` if nothing is known of the soil.
    pub soil_n_m_rad: Option<f64>,
    /// Stability with the joints' stiffness; `None` if it is unknown.
    pub stability: Option<ChainStability>,
    /// Natural modes; empty if the stiffness is unknown.
    pub modes: Vec<NaturalMode>,
    /// Joint stiffnesses that were not given and were assumed from the sides of the beds, from the bottom.
    pub taken: Vec<StiffnessTaken>,
    /// The side supports in this direction.
    pub side_supports: Vec<SideSupport>,
    /// The load factor without these side supports; `None` as in [`ChainCheck`].
    pub load_factor_without_supports: Option<f64>,
}

/// An assumed stiffness of a joint across the direction of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StiffnessTaken {
    /// The joint, from 1 at the bottom.
    pub joint: usize,
    /// Assumed stiffness, N m/rad.
    pub stiffness_n_m_rad: f64,
    /// Ratio to the stiffness in the direction of motion: (w/b)² of the sides of the bed, at most 1.
    pub of_along: f64,
}

impl ChainCheck {
    /// The least load factor of both directions; `None` if no stiffness is known.
    pub fn load_factor(&self) -> Option<f64> {
        let across = self.across.iter().filter_map(|of| of.stability.as_ref());
        let all = self.stability.iter().chain(across);
        all.map(|of| of.load_factor).min_by(f64::total_cmp)
    }
}

/// The lowest joint in series with the soil that it stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointOnSoil {
    /// Rocking stiffness of the footing on the soil, N m/rad.
    pub soil_n_m_rad: f64,
    /// Stiffness of the joint alone, N m/rad; `None` if it is unknown.
    pub joint_n_m_rad: Option<f64>,
    /// Stiffness of joint and soil in series, N m/rad.
    pub together_n_m_rad: Option<f64>,
}

impl JointOnSoil {
    /// Fraction of the joint's total rotation that occurs in the soil.
    pub fn soil_share(&self) -> Option<f64> {
        Some(self.together_n_m_rad? / self.soil_n_m_rad)
    }
}

/// Relative change of each centre of mass for this table: 20 % lower, as in Table 3 of Choi (2021).
pub const CENTROID_CHANGE: f64 = -0.2;

/// All results for a chain without a time history: limits from weights and lengths, the effect of lowering
/// each centre of mass by 20 % and, if the joints' stiffness is known, stability and natural modes.
///
/// # Errors
/// [`AssessError::Stability`] if the stiffnesses do not fit the chain.
///
/// # Example
/// ```
/// use dolmen::{assess::check_chain, structure::{Chain, Inertia, Link}};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 2.0,
///     centroid_m: 1.0,
///     inertia: Inertia::ThinRod,
///     bed_width_m: None,
/// };
/// let check = check_chain(&Chain::new(vec![link], 9.81)?, None)?;
/// assert!(check.stability.is_none() && check.modes.is_empty());
/// assert_eq!(check.limits.necessary_n_m_rad, [9810.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_chain(chain: &Chain, stiffness_n_m_rad: Option<&[f64]>) -> Result<ChainCheck, AssessError> {
    let (stability, modes) = match stiffness_n_m_rad {
        None => (None, Vec::new()),
        Some(k) => (Some(chain_stability(chain, k)?), chain.natural_modes(k)?),
    };
    let each = 1..=chain.links().len();
    Ok(ChainCheck {
        limits: chain_limits(chain)?,
        stability,
        modes,
        centroids: each
            .map(|link| centroid_effect(chain, link, CENTROID_CHANGE, stiffness_n_m_rad))
            .collect::<Result<_, _>>()?,
        one_stone: None,
        on_soil: None,
        side_supports: chain.side_supports().to_vec(),
        load_factor_without_supports: without_supports(chain, stiffness_n_m_rad)?,
        across: None,
        loaded: None,
    })
}

/// Checks the chain across the direction of motion only.
///
/// # Errors
/// As [`check_chain`].
pub fn check_chain_across(
    chain: &Chain,
    stiffness_n_m_rad: Option<&[f64]>,
    taken: Vec<StiffnessTaken>,
) -> Result<ChainAcross, AssessError> {
    let (stability, modes) = match stiffness_n_m_rad {
        None => (None, Vec::new()),
        Some(k) => (Some(chain_stability(chain, k)?), chain.natural_modes(k)?),
    };
    Ok(ChainAcross {
        soil_n_m_rad: None,
        stability,
        modes,
        taken,
        side_supports: chain.side_supports().to_vec(),
        load_factor_without_supports: without_supports(chain, stiffness_n_m_rad)?,
    })
}

fn without_supports(chain: &Chain, stiffness_n_m_rad: Option<&[f64]>) -> Result<Option<f64>, AssessError> {
    Ok(match stiffness_n_m_rad {
        Some(k) if chain.side_supports().iter().any(SideSupport::acts_linearly) => {
            Some(chain_stability(&chain.without_side_supports(), k)?.load_factor)
        }
        _ => None,
    })
}

/// Effect of moving the centre of mass of one link, by the published criterion and exactly.
///
/// ```text
/// ∂K/∂l_i = −w_i e_i e_iᵀ        so lowering a centre of mass can only help
/// ```
///
/// # Input
/// * `link` -- from 1 at the bottom
/// * `change` -- relative change of the height of its centre of mass: −0.2 is 20 % lower
///
/// # Errors
/// [`AssessError::Structure`] if there is no such link, or if the centre of mass would be outside it.
///
/// # Source
/// Choi (2021), Table 3. Differs from the source: there some k_cr rise, and Choi concludes that lowering a centre of mass
/// can require more stiffness. This is an artefact of the published criterion: no exact limit rises.
pub fn centroid_effect(
    chain: &Chain,
    link: usize,
    change: f64,
    stiffness_n_m_rad: Option<&[f64]>,
) -> Result<CentroidEffect, AssessError> {
    let changed = chain.with_centroid_changed(link, change)?;
    let limits = chain_limits(&changed)?;
    let stability = stiffness_n_m_rad
        .map(|k| chain_stability(&changed, k))
        .transpose()?;
    Ok(CentroidEffect {
        link,
        change,
        published_critical_n_m_rad: limits.published_critical_n_m_rad,
        necessary_n_m_rad: limits.necessary_n_m_rad,
        equal_joints_n_m_rad: limits.equal_joints_n_m_rad,
        load_factor: stability.map(|stability| stability.load_factor),
    })
}
