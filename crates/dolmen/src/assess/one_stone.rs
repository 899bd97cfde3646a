//! Compares a chain with the single stone that it would be without joints (Choi 2021, Fig. 8).

use super::AssessError;
use crate::structure::{BeamTheory, Chain, Jointing, NaturalMode, Pole, Shaft, Stone, StructureError};

/// Frequencies of the pole as a single stone, and with its joints and flexible stones.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OneStoneCheck {
    /// The links as shafts, lowest first.
    pub shafts: Vec<Shaft>,
    /// Frequencies without joints, in bending only, Hz, ascending; empty if the pole falls.
    pub bernoulli_euler_hz: Vec<f64>,
    /// Frequencies without joints, with shear and rotary inertia, Hz; empty if the pole falls.
    pub timoshenko_hz: Vec<f64>,
    /// Frequencies with joints, and with bending and shear of the stones, Hz; empty if the joints are unknown, or if the pole
    /// falls.
    pub jointed_hz: Vec<f64>,
    /// Frequency of the chain of rigid links over that of the single stone by Timoshenko, mode by mode; empty under the same
    /// conditions.
    pub ratios: Vec<f64>,
    /// Largest relative change of a frequency in the last refinement.
    pub changed: f64,
}

/// Largest number of compared modes. Our choice: with rigid links, higher modes are meaningless for a pole.
const MODES_MOST: usize = 5;

/// Compares a chain with a monolithic pole clamped at its foot: the reduction of its frequencies by the joints, and the effect of
/// bending links.
///
/// # Input
/// * `modes` -- of the chain on these joints; empty if the joints are unknown
///
/// # Errors
/// [`AssessError::Structure`]: see [`Pole::of_chain`] and [`Pole::frequencies`].
pub fn check_one_stone(
    chain: &Chain,
    stone: Stone,
    stiffness_n_m_rad: Option<&[f64]>,
    modes: &[NaturalMode],
) -> Result<OneStoneCheck, AssessError> {
    let pole = Pole::of_chain(chain, stone)?;
    let count = chain.links().len().min(MODES_MOST);
    let mut changed = 0.0_f64;
    let mut frequencies = |theory, jointing| -> Result<Vec<f64>, StructureError> {
        let found = pole.frequencies(theory, jointing, count)?;
        Ok(found.map_or_else(Vec::new, |found| {
            changed = changed.max(found.changed);
            found.frequencies_hz
        }))
    };
    let bernoulli_euler_hz = frequencies(BeamTheory::BernoulliEuler, Jointing::OneStone)?;
    let timoshenko_hz = frequencies(BeamTheory::Timoshenko, Jointing::OneStone)?;
    let jointed_hz = match stiffness_n_m_rad {
        None => Vec::new(),
        Some(springs) => frequencies(BeamTheory::Timoshenko, Jointing::Springs(springs))?,
    };
    let stands = modes.iter().all(|mode| mode.omega_squared > 0.0);
    let pairs = modes.iter().zip(&timoshenko_hz);
    Ok(OneStoneCheck {
        shafts: pole.shafts().to_vec(),
        ratios: match stands {
            true => pairs.map(|(mode, whole)| mode.frequency_hz / whole).collect(),
            false => Vec::new(),
        },
        bernoulli_euler_hz,
        timoshenko_hz,
        jointed_hz,
        changed,
    })
}
