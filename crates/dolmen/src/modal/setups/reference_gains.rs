//! Checks the reference sensors of several setups against each other: a sensor may have another gain or sign in one setup.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | a, b | `a`, `b` | shape of a mode at the common sensors, in the earlier and in this setup | references × 1 |
//! | α | `scale` | factor on the shape of this setup | - |
//! | g | `factor` | additional factor on one sensor, in all modes | - |
//! | v | `variance` | variance of αb − a | references × 1 |

use super::pairing::{ObservedMode, Pairing, pair_modes, same_place};
use crate::modal::{ModalError, Mode, Modes};
use dolmen_linalg::Complex64;

/// Additional standard deviation of a component, relative to the largest of its mode, for weather and close modes. Our choice.
const BESIDE: f64 = 0.03;
/// Assumed standard deviation if none is given. Our choice.
const NOT_STATED: f64 = 0.05;
/// Smallest change of a factor in a note; it must also exceed four standard deviations. Our choice: far above differences between
/// sensors of one kind.
const CHANGE_LEAST: f64 = 0.15;
const DEVIATIONS: f64 = 4.0;
/// Factor by which the factor of one sensor must reduce the unexplained variance, compared with no factor and with a factor of any other
/// sensor.
const EXPLAINS: f64 = 4.0;
const TOLD_APART: f64 = 2.0;
/// Fewest modes that must show the fault.
const MODES_LEAST: usize = 2;
/// Number of rounds of least squares for α and g in turn.
const ROUNDS: usize = 30;

/// A reference sensor whose gain or sign differs between two setups.
#[derive(Clone, Debug, PartialEq)]
pub struct ReferenceFault {
    /// The setup at fault and the setup of comparison, from 0; with only two setups either may be at fault.
    pub setups: [usize; 2],
    /// The sensors that explain the difference, the best first: one, or several that cannot be distinguished.
    pub suspects: Vec<SuspectReference>,
    /// Number of modes that show the fault.
    pub modes: usize,
}

/// A sensor that explains the difference between two setups if it alone is at fault.
#[derive(Clone, Debug, PartialEq)]
pub struct SuspectReference {
    /// Its name.
    pub channel: String,
    /// Ratio of its measured to its expected displacement in the first setup; negative if it was reversed.
    pub factor: f64,
    /// Standard deviation of the factor.
    pub factor_sd: f64,
}

impl ReferenceFault {
    /// Whether its best suspect was reversed.
    pub fn is_turned(&self) -> bool {
        self.suspects.first().is_some_and(|of| of.factor < 0.0)
    }

    /// The same with the other setup at fault.
    fn of_the_other_setup(&self) -> Self {
        let turned_about = |of: &SuspectReference| SuspectReference {
            channel: of.channel.clone(),
            factor: of.factor.recip(),
            factor_sd: of.factor_sd / of.factor.powi(2),
        };
        let [at, before] = self.setups;
        ReferenceFault {
            setups: [before, at],
            suspects: self.suspects.iter().map(turned_about).collect(),
            modes: self.modes,
        }
    }
}

impl std::fmt::Display for ReferenceFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let moves = |of: &SuspectReference| {
            format!(
                "\"{}\" moves {:.2} ± {:.2} times (standard deviation)",
                of.channel, of.factor, of.factor_sd
            )
        };
        let moves: Vec<String> = self.suspects.iter().map(moves).collect();
        let [at, before] = self.setups.map(|s| s + 1);
        let (fault, correct) = match self.is_turned() {
            true => ("a reference looks turned round", "direction or its scale"),
            false => ("a reference has another gain", "scale"),
        };
        write!(
            f,
            "{fault} in setup {at}: against the others {} what it does in setup {before}, alike in {} modes; correct its {correct}, no \
             shape put together over it is right",
            moves.join(", or "),
            self.modes
        )
    }
}

/// A mode of two setups, at their common sensors.
struct Shared {
    a: Vec<Complex64>,
    b: Vec<Complex64>,
    variance: Vec<f64>,
}

/// Sensors whose gain or sign differs between setups, at most one for each pair of setups.
///
/// ```text
/// minimise Σ_modes Σ_c |α g_c b_c − a_c|²/v_c      g = 1 but of one sensor; v = |α|² sd(b)² + sd(a)² + (0.03 max|a|)²
/// ```
/// The modes are paired by frequency alone, because a reversed sensor changes every shape.
///
/// # Errors
/// As [`pair_modes`].
pub(super) fn reference_faults(
    setups: &[Modes],
    pairing: &Pairing,
) -> Result<Vec<ReferenceFault>, ModalError> {
    let mut found: Vec<ReferenceFault> = Vec::new();
    for later in 1..setups.len() {
        for before in 0..later {
            found.extend(of_two(setups, [later, before], pairing)?);
        }
    }
    // the setup that takes part in most faults of a sensor is at fault
    let mut named: Vec<ReferenceFault> = Vec::new();
    let alike = |a: &ReferenceFault, b: &ReferenceFault| {
        let has = |of: &SuspectReference| b.suspects.iter().any(|other| other.channel == of.channel);
        a.suspects.len() == b.suspects.len() && a.suspects.iter().all(has)
    };
    for fault in &found {
        let same: Vec<&ReferenceFault> = found.iter().filter(|o| alike(o, fault)).collect();
        let count = |setup: usize| same.iter().filter(|o| o.setups.contains(&setup)).count();
        let [later, before] = fault.setups;
        let told = if count(before) > count(later) {
            fault.of_the_other_setup()
        } else {
            fault.clone()
        };
        if !named
            .iter()
            .any(|o| alike(o, &told) && o.setups[0] == told.setups[0])
        {
            named.push(told);
        }
    }
    Ok(named)
}

fn of_two(
    setups: &[Modes],
    [later, before]: [usize; 2],
    pairing: &Pairing,
) -> Result<Option<ReferenceFault>, ModalError> {
    let (of_b, of_a) = (&setups[later], &setups[before]);
    let shared: Vec<(usize, usize, f64)> = of_a
        .channels
        .iter()
        .enumerate()
        .filter_map(|(i, a)| {
            let at = |(j, b)| same_place(a, b, pairing.place_within_m).map(|sign| (i, j, sign));
            of_b.channels.iter().enumerate().find_map(at)
        })
        .collect();
    if shared.len() < 2 {
        return Ok(None);
    }
    let bare = |modes: &Modes| -> Vec<ObservedMode> {
        modes
            .modes
            .iter()
            .map(|mode| ObservedMode::of(mode, &[], 0))
            .collect()
    };
    let pairs = pair_modes(&bare(of_a), &bare(of_b), pairing)?.pairs;
    let modes: Vec<Shared> = pairs
        .iter()
        .map(|pair| Shared::of(&of_a.modes[pair.first], &of_b.modes[pair.second], &shared))
        .collect();
    if modes.len() < MODES_LEAST {
        return Ok(None);
    }
    let unexplained = left(&modes, &vec![1.0; shared.len()]);
    let mut fits: Vec<(usize, Fit)> = (0..shared.len()).map(|c| (c, fit(&modes, c))).collect();
    fits.sort_by(|a, b| a.1.left.total_cmp(&b.1.left));
    let (_, best) = &fits[0];
    let freedom = (modes.len() * (shared.len() - 1)) as f64 - 1.0;
    let widened = (best.left / freedom.max(1.0)).max(1.0).sqrt();
    let sd = best.sd * widened;
    let is_fault = best.factor.is_finite()
        && (best.factor - 1.0).abs() > CHANGE_LEAST.max(DEVIATIONS * sd)
        && unexplained > EXPLAINS * best.left.max(freedom.max(1.0));
    if !is_fault {
        return Ok(None);
    }
    let alike = fits
        .iter()
        .filter(|(_, fit)| fit.left < TOLD_APART * best.left.max(freedom.max(1.0)));
    let suspects = alike.map(|(c, fit)| SuspectReference {
        channel: of_b.channels[shared[*c].1].name.clone(),
        factor: fit.factor.recip(), // what it shows over what it should
        factor_sd: fit.sd * widened / fit.factor.powi(2),
    });
    Ok(Some(ReferenceFault {
        setups: [later, before],
        suspects: suspects.collect(),
        modes: modes.len(),
    }))
}

impl Shared {
    fn of(before: &Mode, later: &Mode, shared: &[(usize, usize, f64)]) -> Self {
        let sd = |mode: &Mode, c: usize| {
            let stated = mode.shape_sd.as_ref().and_then(|sd| sd.get(c)).copied();
            stated.filter(|sd| sd.is_finite()).unwrap_or(NOT_STATED)
        };
        let a: Vec<Complex64> = shared.iter().map(|(i, ..)| before.shape[*i]).collect();
        let b: Vec<Complex64> = shared
            .iter()
            .map(|(_, j, sign)| later.shape[*j] * *sign)
            .collect();
        let size = |z: &[Complex64]| z.iter().map(|z| z.norm_sqr()).sum::<f64>();
        let ratio = size(&a) / size(&b).max(f64::MIN_POSITIVE);
        let most = a.iter().map(|z| z.norm()).fold(0.0, f64::max);
        let variance = shared
            .iter()
            .map(|(i, j, _)| sd(before, *i).powi(2) + ratio * sd(later, *j).powi(2) + (BESIDE * most).powi(2))
            .collect();
        Shared { a, b, variance }
    }

    /// α by least squares without the sensor `without`, and its variance.
    fn scale(&self, factors: &[f64], without: Option<usize>) -> (Complex64, f64) {
        let (mut inner, mut power) = (Complex64::ZERO, f64::MIN_POSITIVE);
        for c in (0..self.a.len()).filter(|c| Some(*c) != without) {
            let b = factors[c] * self.b[c];
            inner += b.conj() * self.a[c] / self.variance[c];
            power += b.norm_sqr() / self.variance[c];
        }
        (inner / power, 1.0 / power)
    }
}

/// Relative variance that remains with these factors.
fn left(modes: &[Shared], factors: &[f64]) -> f64 {
    let of = |mode: &Shared| -> f64 {
        let (scale, _) = mode.scale(factors, None);
        let each = (0..mode.a.len()).map(|c| {
            let apart = scale * factors[c] * mode.b[c] - mode.a[c];
            apart.norm_sqr() / mode.variance[c]
        });
        each.sum()
    };
    modes.iter().map(of).sum()
}

/// The factor of a single sensor that reduces the variance most.
struct Fit {
    factor: f64,
    sd: f64,
    left: f64,
}

fn fit(modes: &[Shared], channel: usize) -> Fit {
    let mut factors = vec![1.0; modes[0].a.len()];
    let mut sd = f64::INFINITY;
    for round in 0..ROUNDS {
        let without = (round == 0).then_some(channel);
        let (mut inner, mut power, mut known) = (0.0, f64::MIN_POSITIVE, 0.0);
        for mode in modes {
            let (scale, _) = mode.scale(&factors, without);
            let b = scale * mode.b[channel];
            inner += (b.conj() * mode.a[channel]).re / mode.variance[channel];
            power += b.norm_sqr() / mode.variance[channel];
            let (scale, scale_variance) = mode.scale(&factors, Some(channel));
            let b = factors[channel] * mode.b[channel];
            let variance = mode.variance[channel] + scale_variance * b.norm_sqr();
            known += (scale * mode.b[channel]).norm_sqr() / variance;
        }
        factors[channel] = inner / power;
        sd = known.max(f64::MIN_POSITIVE).sqrt().recip();
    }
    Fit {
        factor: factors[channel],
        sd,
        left: left(modes, &factors),
    }
}
