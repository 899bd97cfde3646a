//! Factors on the springs of each joint of a stack, from its measured modes.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | c_j | `factor` | factor on K_n and K_s of joint j | – |
//! | x_j | | ln c_j | – |
//! | K_j, M | | stiffness of joint j as drawn, mass | |
//! | B | `band` | largest ratio of any factor to the common factor, in both directions | – |

use super::super::contact_points::ContactRule;
use super::super::error::BlocksError;
use super::error::JointFactorsError;
use super::families::{Family, families};
use super::measured::{Assumed, MeasuredStackMode, check_measured};
use super::model::{Datum, FactorModel, product};
use super::pairing::{Paired, assurance, pair};
use super::ranges::{Ranges, ranges};
use super::result::{CommonFactor, JointFactor, JointFactors, PairedBy, PairedMode, UnusedMode};
use super::sight::fixed_combinations;
use super::unknowns::{Unknowns, multiplied, resettled_stiffness, unknowns};
use crate::structure::stack::Stack;
use dolmen_linalg::LinalgError;

/// Smallest MAC of a shape that leaves no doubt of its mode. Our choice, as for modes of models beside measured ones.
const NO_DOUBT_LEAST: f64 = 0.8;

/// Options of the search for joint factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointFactorsOptions {
    /// Contact points of the joints. Default four per side: exact for faces that stay closed.
    pub contact_rule: ContactRule,
    /// Largest ratio of any factor to the common factor, in both directions; above 1. Default 10, our choice: published values for joints of dressed
    /// stone differ by about this ratio, depending on pressure and on mortar or earth in the joint.
    pub band: f64,
    /// Relative standard deviation assumed for a frequency without one. Default 0.005, as for chains and frames.
    pub frequency_sd_assumed: f64,
    /// Standard deviation assumed for a point of a shape without one, over the largest displacement. Default 0.05, as for chains and frames.
    pub shape_sd_assumed: f64,
    /// Largest number of joints with individual factors: for more joints, all joints of a plane share one factor. Default 24, our choice: a second
    /// of computing.
    pub joints_most: usize,
    /// Largest number of factors with ranges: for more factors, only the common factor, the lower bounds and the energies are computed. Default 24.
    pub ranges_most: usize,
}

impl Default for JointFactorsOptions {
    fn default() -> Self {
        JointFactorsOptions {
            contact_rule: ContactRule::Four,
            band: 10.0,
            frequency_sd_assumed: 0.005,
            shape_sd_assumed: 0.05,
            joints_most: 24,
            ranges_most: 24,
        }
    }
}

/// Factors on the springs of each joint from measured modes.
///
/// K, and therefore every ω², is linear in the factors on the springs, K(c) = Σ c_j K_j, at the rest position of the stack as drawn:
///
/// ```text
/// d ln ω²/d ln c_j = c_j φᵀ K_j φ / (ω² φᵀ M φ)     the fraction of the mode's strain energy in joint j; over all j the sum is 1
/// common factor:   least squares of (ln f − ln f_measured)/σ and of the shapes, all c_j equal
/// lower bound:     frequencies increase with every c_j, so c_j is at least the value that gives f_measured (1 − 2σ) with all others rigid
/// range:           c_j for which factors of the other joints between common/B and common·B exist that explain every mode within 95 %
/// ```
///
/// # Errors
/// [`JointFactorsError`] for invalid numbers, if no mode can be paired, or if the stack does not come to rest.
///
/// # Limits
/// Small motion about the rest position as drawn: closed joints stay closed. `resettled` gives the change of the frequencies when the stack settles
/// again on the new springs. K_s/K_n does not change, and masses are taken as exact. The ranges from several modes are searched from several starts,
/// without proof; those from one frequency, and the least factors, are exact.
///
/// # Example
/// ```
/// use dolmen::blocks::{JointFactorsOptions, MeasuredStackMode, StackMotion, joint_factors};
/// use dolmen::structure::{MeasuredMode, stack::JointMaterial};
/// let stack = dolmen::comparisons::p10(JointMaterial::default(), 9.81)?;
/// let mode = MeasuredMode { frequency_hz: 6.0, frequency_sd_hz: 0.06, frequency_changes_hz: vec![], shape: vec![] };
/// let measured = [MeasuredStackMode { motion: StackMotion::X, mode }];
/// let found = joint_factors(&stack, &measured, &JointFactorsOptions::default())?;
/// assert!((found.common.factor - (6.0_f64 / 4.7043).powi(2)).abs() < 1e-3);
/// assert!((found.common.relative_sd - 0.02).abs() < 1e-9); // twice that of the frequency
/// assert_eq!(found.fixed_combinations, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn joint_factors(
    stack: &Stack,
    measured: &[MeasuredStackMode],
    options: &JointFactorsOptions,
) -> Result<JointFactors, JointFactorsError> {
    check_measured(measured, stack.height_m())?;
    check_options(options)?;
    let unknowns = unknowns(stack, options.contact_rule, options.joints_most)?;
    let families = families(&unknowns)?;
    let PairedModel {
        model,
        paired,
        unused,
    } = paired_model((stack, measured), &unknowns, families, options)?;
    if model.data.is_empty() {
        return Err(JointFactorsError::NonePaired { unused });
    }
    let failed = || {
        JointFactorsError::Linalg(LinalgError::NoConvergence {
            what: "modes of a stack",
        })
    };
    let common = model.common().ok_or_else(failed)?;
    let half_band = options.band.ln();
    let found = match model.unknowns <= options.ranges_most {
        true => Some(ranges(&model, common.factor.ln(), half_band).ok_or_else(failed)?),
        false => None,
    };
    let singular_values = model.singular_values(&vec![common.factor.ln(); model.unknowns])?;
    let best = found.as_ref().filter(|found| found.explains);
    let mut modes = paired_modes(&model, &common, best).ok_or_else(failed)?;
    for (mode, of) in modes.iter_mut().zip(&paired) {
        (mode.number, mode.paired_by) = (of.number + 1, of.by);
        (mode.is_sd_assumed, mode.drawn_hz) = (of.is_sd_assumed, of.drawn_hz);
        mode.assurance = mode.assurance.or(of.assurance);
    }
    let springs = match best {
        Some(best) => best.best.iter().map(|x| x.exp()).collect(),
        None => vec![common.factor; model.unknowns],
    };
    Ok(JointFactors {
        of: unknowns.of,
        factors: each_factor(&model, &unknowns, &common, found.as_ref()),
        resettled: resettled(stack, options, &unknowns, &model, &springs),
        open_joints: unknowns.open_joints,
        modes,
        unused,
        band: [common.factor / options.band, common.factor * options.band],
        fixed_combinations: fixed_combinations(&singular_values, half_band),
        singular_values,
        best_misfit: found
            .as_ref()
            .map(|found| (found.squares / model.data_count() as f64).sqrt()),
        explains: found.as_ref().map(|found| found.explains),
        common,
    })
}

/// The families of modes with the measured data, the basis of each pairing, and the modes without a pair.
struct PairedModel {
    model: FactorModel,
    paired: Vec<Paired>,
    unused: Vec<UnusedMode>,
}

/// Pairs the measured modes at the springs as drawn. If shapes leave doubt there, because modes change shape and order as springs change, the modes
/// without doubt give springs first, and all are paired again at these.
fn paired_model(
    (stack, measured): (&Stack, &[MeasuredStackMode]),
    unknowns: &Unknowns,
    families: Vec<Family>,
    options: &JointFactorsOptions,
) -> Result<PairedModel, LinalgError> {
    let assumed = Assumed {
        frequency_sd: options.frequency_sd_assumed,
        shape_sd: options.shape_sd_assumed,
    };
    let count = unknowns.groups.len();
    let drawn = vec![1.0; count];
    let pair_at = |families: &[Family], factors: &[f64]| {
        pair(stack, &unknowns.mass, families, (measured, &assumed), factors)
    };
    let model = |families, data| FactorModel {
        families,
        data,
        unknowns: count,
    };
    let is_clear = |of: &Paired| of.assurance.is_none_or(|assurance| assurance >= NO_DOUBT_LEAST);
    let first = pair_at(&families, &drawn)?;
    if first.unused.is_empty() && first.paired.iter().all(is_clear) {
        return Ok(PairedModel {
            model: model(families, first.data),
            paired: first.paired,
            unused: first.unused,
        });
    }
    let clear = first.data.into_iter().zip(&first.paired);
    let clear: Vec<Datum> = clear
        .filter_map(|(datum, of)| is_clear(of).then_some(datum))
        .collect();
    let clear = model(families, clear);
    let springs = springs_of(&clear, options);
    let families = clear.families;
    let again = springs.map(|springs| pair_at(&families, &springs)).transpose()?;
    let found = match again.filter(|again| again.paired.iter().all(is_clear)) {
        Some(again) if again.paired.len() > clear.data.len() => again,
        _ => pair_at(&families, &drawn)?,
    };
    Ok(PairedModel {
        model: model(families, found.data),
        paired: found.paired,
        unused: found.unused,
    })
}

/// The factors of all springs, if the modes determine each of them; `None` otherwise.
fn springs_of(model: &FactorModel, options: &JointFactorsOptions) -> Option<Vec<f64>> {
    if model.data.is_empty() || model.data_count() < model.unknowns || model.unknowns > options.ranges_most {
        return None;
    }
    let common = model.common()?;
    let found = ranges(model, common.factor.ln(), options.band.ln())?;
    let is_known = found.explains && found.determined.iter().all(Option::is_some);
    is_known.then(|| found.best.iter().map(|x| x.exp()).collect())
}

fn check_options(options: &JointFactorsOptions) -> Result<(), JointFactorsError> {
    for (option, given, least, allowed) in [
        ("band", options.band, 1.0, "above 1"),
        (
            "frequency_sd_assumed",
            options.frequency_sd_assumed,
            0.0,
            "a positive number",
        ),
        (
            "shape_sd_assumed",
            options.shape_sd_assumed,
            0.0,
            "a positive number",
        ),
    ] {
        if !(given > least && given.is_finite()) {
            return Err(JointFactorsError::Option {
                option,
                given,
                allowed,
            });
        }
    }
    Ok(())
}

fn each_factor(
    model: &FactorModel,
    unknowns: &Unknowns,
    common: &CommonFactor,
    found: Option<&Ranges>,
) -> Vec<JointFactor> {
    let n = model.unknowns;
    let mut known = vec![vec![1.0; n], vec![common.factor; n]];
    known.extend(found.map(|found| found.best.iter().map(|x| x.exp()).collect()));
    let each = unknowns.groups.iter().enumerate().map(|(j, group)| {
        let least = model.least(j, common.factor, &known);
        let determined = found.and_then(|found| found.determined[j]);
        JointFactor {
            joints: group.joints.clone(),
            least: least.as_ref().map(|least| least.factor),
            least_from: least.map(|least| least.datum),
            range: found.and_then(|found| found.ranges.get(j).copied()),
            best: determined.map(|[best, _]| best),
            relative_sd: determined.map(|[_, sd]| sd),
        }
    });
    each.collect()
}

/// The modes that are used; `None` if one of them has no frequency.
fn paired_modes(
    model: &FactorModel,
    common: &CommonFactor,
    found: Option<&Ranges>,
) -> Option<Vec<PairedMode>> {
    let factors = vec![common.factor; model.unknowns];
    let shares = model.energy_shares(&factors)?;
    let modes = model.modes(&factors)?;
    let best: Option<Vec<f64>> = found.map(|found| found.best.iter().map(|x| x.exp()).collect());
    let each = model.data.iter().zip(shares).map(|(datum, energy_shares)| {
        let shape = datum.shape.as_ref();
        let modes = modes[datum.family].as_ref()?;
        let computed = modes.vectors.column(model.order(datum, modes)?);
        let best_hz = match &best {
            Some(best) => Some(model.frequency_hz(datum, best)?),
            None => None,
        };
        Some(PairedMode {
            motion: datum.motion,
            number: 0,
            paired_by: PairedBy::Order,
            measured_hz: datum.frequency_hz,
            measured_sd_hz: datum.relative_sd * datum.frequency_hz,
            is_sd_assumed: false,
            shape_points: shape.map_or(0, |shape| shape.displacement.len()),
            drawn_hz: 0.0,
            common_hz: model.frequency_hz(datum, &factors)?,
            best_hz,
            assurance: shape.map(|shape| assurance(&shape.rows.times(computed), &shape.displacement)),
            energy_shares,
        })
    });
    each.collect()
}

/// Largest relative change of a frequency if the stack settles again on these springs, by Rayleigh's quotient of the mode.
fn resettled(
    stack: &Stack,
    options: &JointFactorsOptions,
    unknowns: &Unknowns,
    model: &FactorModel,
    factors: &[f64],
) -> Result<f64, BlocksError> {
    let anew = multiplied(stack, &unknowns.groups, factors)?;
    let stiffness = resettled_stiffness(&anew, options.contact_rule)?;
    let mut most = 0.0_f64;
    for datum in &model.data {
        let family = &model.families[datum.family];
        let modes = family.modes(factors)?;
        let Some(order) = model.order(datum, &modes) else {
            continue;
        };
        let mode = family.displacements(modes.vectors.column(order));
        let quotient = product(&mode, &stiffness.times(&mode)) / modes.values[order];
        most = most.max((quotient.max(0.0).sqrt() - 1.0).abs());
    }
    Ok(most)
}
