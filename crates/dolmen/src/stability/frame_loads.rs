//! A frame under lateral forces: capacity and drift of each storey.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | F_j, V_i | `forces_n`, `shear_n` | force at level j; force on storey i, Σ_{j≥i} F_j | N |
//! | δ, δ_most | `drift_m`, `drift_most_m` | drift of a storey; drift at which it counts as fallen | m |
//! | T(δ) | `restoring_n` | resistance of a storey to a drift, including P-delta | N |
//! | k, k_b | `stiffness_n_m` | stiffness of a storey; contribution of the beds of its columns | N/m |
//! | N, τ | `axial_n`, `tilt` | weight on a storey; its stress-free lean, horizontal over vertical | N, – |

use super::free_columns::{ColumnsBesideJoints, FreeColumns};
use super::{StabilityError, Verdict, frame_stability};
use crate::numeric::{Bracketing, bracketed_root, maximum_between};
use crate::structure::{Convention, Frame, StructureError};
use dolmen_linalg::{Matrix, solve};

/// Number of points of the curve of a storey with columns. Our choice: smooth in print.
const CURVE_POINTS: usize = 60;

/// Lateral forces on a frame, and its resistance in addition to springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramePush<'a> {
    /// F, at each level, lowest first, N.
    pub forces_n: &'a [f64],
    /// Free-standing columns of each storey; `None` for a storey without them.
    pub columns: &'a [Option<FreeColumns>],
    /// τ, horizontal over vertical; with it, the weight acts in the direction of the forces.
    pub tilt: f64,
    /// Drift over height at which a storey has fallen: the limit of small drifts.
    pub drift_ratio_most: f64,
}

/// Limit of a storey's capacity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum StoreyEnd {
    /// The drift at which it counts as fallen, although its resistance may still increase.
    Drift,
    /// Its largest force, beyond which its columns fall.
    Force,
}

/// A point of the curve of force against drift.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StoreyPoint {
    /// δ, m.
    pub drift_m: f64,
    /// T, N.
    pub force_n: f64,
}

/// A storey of a frame under lateral forces.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StoreyUnderLoads {
    /// N, weight on the storey, N.
    pub axial_n: f64,
    /// V, force of the loads on the storey, N, with the sign of their direction.
    pub shear_n: f64,
    /// Lean without the loads, τ + δ/l, horizontal over vertical; `None` if it falls without them.
    pub lean_at_rest: Option<f64>,
    /// Additional drift due to the loads, m; `None` if the storey does not resist them.
    pub drift_m: Option<f64>,
    /// Largest T, minus the effect of the weight in the leaning position, N; `None` if its springs act on displacement.
    pub greatest_n: Option<f64>,
    /// Drift at the largest T, m.
    pub greatest_drift_m: Option<f64>,
    /// δ_most minus the part used by the lean, m.
    pub drift_most_m: f64,
    /// Limit of its capacity.
    pub end: StoreyEnd,
    /// Factor on the loads at which the storey falls, for the given lean; 0 if it falls without them, infinite without loads.
    pub factor: f64,
    /// T against δ; empty if its springs act on displacement, or if the lean uses all of the drift.
    pub curve: Vec<StoreyPoint>,
}

/// A frame under lateral forces.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FrameUnderLoads {
    /// The storeys, lowest first.
    pub storeys: Vec<StoreyUnderLoads>,
    /// The storey with the smallest factor, from 1 at the bottom.
    pub governing_storey: usize,
    /// Smallest factor on the loads at which a storey falls.
    pub factor: f64,
}

impl FrameUnderLoads {
    /// The verdict of all storeys.
    pub fn of(storeys: Vec<StoreyUnderLoads>) -> Self {
        let least = storeys
            .iter()
            .enumerate()
            .min_by(|a, b| a.1.factor.total_cmp(&b.1.factor));
        let (governing_storey, factor) = least.map_or((1, f64::INFINITY), |(i, of)| (i + 1, of.factor));
        FrameUnderLoads {
            storeys,
            governing_storey,
            factor,
        }
    }

    /// Verdict from the smallest factor.
    pub fn verdict(&self) -> Verdict {
        match self.factor {
            f64::INFINITY => Verdict::Stable,
            factor => Verdict::of_load_factor(factor),
        }
    }
}

/// Capacity of each storey of a frame under forces at its levels, in equilibrium in the leaning position.
///
/// ```text
/// V_i + N_i τ = T_i(δ_i)                                              drift, without ties: each storey by itself
/// T = (k − N/l) δ                                                     without free columns
/// T = V_c(δ) + (k − k_b) δ,  k_b of the beds, at most k               with free columns; V_c includes P-delta
/// factor = (max T − N τ)/|V|,   0 ≤ δ ≤ δ_most − τ l
/// K Y = F,   factor = (δ_most − |lean| l)/|δ|                         springs on displacement, and ties
/// ```
///
/// `stiffness_n_m` is the stiffness of whole storeys at small drift, including the beds of free columns; 0 if only columns resist. For rigid stones,
/// and if the given beds would be stiffer than the storey, the whole stiffness is attributed to beds: the resistance of joints at large drift is
/// then neglected.
///
/// # Errors
/// [`StabilityError::Structure`] unless there is one stiffness, one force and one entry of columns per storey; [`StabilityError::Option`] for a tilt
/// or force that is not finite.
///
/// # Limits
/// Joints and walls are linear up to δ_most; friction is left out. With ties, and with springs on displacement, columns only limit the capacity of a
/// storey, by their fall.
///
/// # Example
/// ```
/// use dolmen::stability::{FramePush, frame_under_loads};
/// use dolmen::structure::{Convention, Frame, Storey};
/// let storey = Storey { mass_kg: 30e3, height_m: 4.0, axial_n: 300e3 };
/// let gate = Frame::new(vec![storey], Convention::Drift)?;
/// let push = FramePush { forces_n: &[20e3], columns: &[None], tilt: 0.0, drift_ratio_most: 0.1 };
/// let found = frame_under_loads(&gate, &[875e3], &push)?; // less N/l = 75 kN/m
/// assert!((found.storeys[0].drift_m.unwrap_or(0.0) - 0.025).abs() < 1e-15);
/// assert!((found.factor - 800e3 * 0.4 / 20e3).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn frame_under_loads(
    frame: &Frame,
    stiffness_n_m: &[f64],
    push: &FramePush<'_>,
) -> Result<FrameUnderLoads, StabilityError> {
    fits(frame, stiffness_n_m, push)?;
    let storeys = match frame.convention() {
        Convention::Drift if frame.ties().is_empty() => each_by_itself(frame, stiffness_n_m, push)?,
        Convention::Drift | Convention::Grounded => together(frame, stiffness_n_m, push)?,
    };
    Ok(FrameUnderLoads::of(storeys))
}

fn fits(frame: &Frame, stiffness_n_m: &[f64], push: &FramePush<'_>) -> Result<(), StabilityError> {
    frame.elastic_matrix(stiffness_n_m)?;
    let needed = frame.storeys().len();
    for (quantity, given) in [("forces_n", push.forces_n.len()), ("columns", push.columns.len())] {
        if given != needed {
            return Err(StabilityError::Structure(StructureError::Count {
                quantity,
                given,
                kind: "frame",
                needed,
                parts: "storeys",
            }));
        }
    }
    let each = push.forces_n.iter().map(|force| ("forces_n", *force));
    for (option, given) in each.chain([("tilt", push.tilt)]) {
        if !given.is_finite() {
            return Err(StabilityError::Option {
                option,
                given,
                allowed: "finite numbers",
            });
        }
    }
    let most = push.drift_ratio_most;
    if !(most > 0.0 && most < 1.0) {
        return Err(StabilityError::Option {
            option: "drift_ratio_most",
            given: most,
            allowed: "above 0 and below 1",
        });
    }
    Ok(())
}

/// V, from the top down.
fn shears(forces_n: &[f64]) -> Vec<f64> {
    let mut above_n = 0.0;
    let mut shears: Vec<f64> = forces_n
        .iter()
        .rev()
        .map(|force| {
            above_n += force;
            above_n
        })
        .collect();
    shears.reverse();
    shears
}

/// δ_most minus the part used by the lean, m; 0 where the lean uses all of it.
fn drift_most_m(
    height_m: f64,
    columns: Option<&FreeColumns>,
    push: &FramePush<'_>,
) -> Result<f64, StabilityError> {
    let standing = columns.map(FreeColumns::standing).transpose()?.flatten();
    let most_m = push.drift_ratio_most * height_m;
    let most_m = standing.map_or(most_m, |standing| standing.falls.drift_m.min(most_m));
    Ok((most_m - push.tilt.abs() * height_m).max(0.0))
}

fn each_by_itself(
    frame: &Frame,
    stiffness_n_m: &[f64],
    push: &FramePush<'_>,
) -> Result<Vec<StoreyUnderLoads>, StabilityError> {
    let mut all = Vec::with_capacity(stiffness_n_m.len());
    let shears = shears(push.forces_n);
    for (i, storey) in frame.storeys().iter().enumerate() {
        let columns = push.columns[i].as_ref();
        let law = StoreyLaw::new(stiffness_n_m[i], storey.axial_n / storey.height_m, columns);
        let most_m = drift_most_m(storey.height_m, columns, push)?;
        let reach = law.reach(most_m)?;
        let pushed_n = storey.axial_n * push.tilt.abs();
        let shear_n = shears[i];
        let at_rest = law.drift_at(pushed_n, &reach)?;
        let loaded = law.drift_at(pushed_n + shear_n.abs(), &reach)?;
        all.push(StoreyUnderLoads {
            axial_n: storey.axial_n,
            shear_n,
            lean_at_rest: at_rest.map(|drift_m| push.tilt.abs() + drift_m / storey.height_m),
            drift_m: loaded.zip(at_rest).map(|(loaded, at_rest)| loaded - at_rest),
            greatest_n: Some(reach.greatest.force_n),
            greatest_drift_m: Some(reach.greatest.drift_m),
            drift_most_m: most_m,
            end: reach.end,
            factor: match at_rest {
                None => 0.0,
                Some(_) if shear_n == 0.0 => f64::INFINITY,
                Some(_) => (reach.greatest.force_n - pushed_n) / shear_n.abs(),
            },
            curve: law.curve(&reach),
        });
    }
    Ok(all)
}

/// For springs on displacement, and for ties: all storeys together.
fn together(
    frame: &Frame,
    stiffness_n_m: &[f64],
    push: &FramePush<'_>,
) -> Result<Vec<StoreyUnderLoads>, StabilityError> {
    let stands = frame_stability(frame, stiffness_n_m)?.load_factor > 1.0;
    let k = frame.stiffness_matrix(stiffness_n_m)?;
    let drifts = |forces: &[f64]| -> Result<Vec<f64>, StabilityError> {
        let right = Matrix::from_fn(forces.len(), 1, |i, _| forces[i]);
        let y = solve(&k, &right)?;
        let below = |i: usize| i.checked_sub(1).map_or(0.0, |below| y[(below, 0)]);
        Ok((0..forces.len()).map(|i| y[(i, 0)] - below(i)).collect())
    };
    let none = || vec![0.0; push.forces_n.len()];
    let (loaded, leaning) = match stands {
        true => (
            drifts(push.forces_n)?,
            drifts(&frame.lean_forces_n(push.tilt.abs()))?,
        ),
        false => (none(), none()),
    };
    let shears = shears(push.forces_n);
    let mut all = Vec::with_capacity(shears.len());
    for (i, storey) in frame.storeys().iter().enumerate() {
        let most_m = drift_most_m(storey.height_m, push.columns[i].as_ref(), push)?;
        let left_m = most_m - leaning[i].abs();
        let stands = stands && left_m > 0.0;
        let factor = match stands {
            false => 0.0,
            true => left_m / loaded[i].abs(), // infinite if the storey does not move
        };
        all.push(StoreyUnderLoads {
            axial_n: storey.axial_n,
            shear_n: shears[i],
            lean_at_rest: stands.then(|| push.tilt.abs() + leaning[i].abs() / storey.height_m),
            drift_m: (factor > 1.0).then(|| loaded[i].abs()),
            greatest_n: None,
            greatest_drift_m: None,
            drift_most_m: most_m,
            end: StoreyEnd::Drift,
            factor,
            curve: Vec::new(),
        });
    }
    Ok(all)
}

/// T of a storey.
enum StoreyLaw {
    /// k − N/l, N/m.
    Springs(f64),
    /// Free-standing columns, and joints.
    Columns(ColumnsBesideJoints),
}

/// Limits of a storey's drift.
struct PushLimit {
    /// Drift, or rotation of columns, rad, at the end.
    end_at: f64,
    /// Position of the greatest force.
    greatest_at: f64,
    greatest: StoreyPoint,
    end: StoreyEnd,
}

impl StoreyLaw {
    fn new(stiffness_n_m: f64, geometric_n_m: f64, columns: Option<&FreeColumns>) -> Self {
        let Some(columns) = columns else {
            return StoreyLaw::Springs(stiffness_n_m - geometric_n_m);
        };
        StoreyLaw::Columns(ColumnsBesideJoints::sharing(columns, stiffness_n_m))
    }

    /// Force at a drift, or at a rotation of the columns.
    fn at(&self, place: f64) -> StoreyPoint {
        match self {
            StoreyLaw::Springs(net_n_m) => StoreyPoint {
                drift_m: place,
                force_n: net_n_m * place,
            },
            StoreyLaw::Columns(held) => {
                let of = held.at(place);
                StoreyPoint {
                    drift_m: of.drift_m,
                    force_n: of.force_n,
                }
            }
        }
    }

    fn reach(&self, most_m: f64) -> Result<PushLimit, StabilityError> {
        let (end_at, greatest_at) = match self {
            StoreyLaw::Springs(net_n_m) => (most_m, if *net_n_m > 0.0 { most_m } else { 0.0 }),
            StoreyLaw::Columns(held) => {
                let end_rad = held.columns.rotation_at_rad(most_m)?;
                let top_rad = maximum_between(&|rotation| self.at(rotation).force_n, 0.0, end_rad);
                let candidates = [0.0, top_rad, end_rad];
                let force = |rotation: &f64| self.at(*rotation).force_n;
                let best = candidates
                    .into_iter()
                    .max_by(|a, b| force(a).total_cmp(&force(b)));
                (end_rad, best.unwrap_or(0.0))
            }
        };
        Ok(PushLimit {
            end_at,
            greatest_at,
            greatest: self.at(greatest_at),
            end: match greatest_at < end_at {
                true => StoreyEnd::Force,
                false => StoreyEnd::Drift,
            },
        })
    }

    /// The drift at which its resistance equals a force; `None` without one.
    fn drift_at(&self, force_n: f64, reach: &PushLimit) -> Result<Option<f64>, StabilityError> {
        if force_n > reach.greatest.force_n || (reach.greatest_at == 0.0 && self.at(0.0).force_n <= 0.0) {
            return Ok(None);
        }
        if force_n <= self.at(0.0).force_n {
            return Ok(Some(0.0));
        }
        Ok(Some(match self {
            StoreyLaw::Springs(net_n_m) => force_n / net_n_m,
            StoreyLaw::Columns(_) => {
                let off = |rotation: f64| self.at(rotation).force_n - force_n;
                let at = bracketed_root(off, 0.0, reach.greatest_at, &Bracketing::default())?;
                self.at(at).drift_m
            }
        }))
    }

    fn curve(&self, reach: &PushLimit) -> Vec<StoreyPoint> {
        if reach.end_at <= 0.0 {
            return Vec::new();
        }
        let share = |i: usize, all: usize| i as f64 / (all - 1) as f64;
        match self {
            StoreyLaw::Springs(_) => [0.0, reach.end_at].map(|drift_m| self.at(drift_m)).to_vec(),
            // squared: the curvature is largest where the feet lift off
            StoreyLaw::Columns(_) => (0..CURVE_POINTS)
                .map(|i| self.at(share(i, CURVE_POINTS).powi(2) * reach.end_at))
                .collect(),
        }
    }
}
