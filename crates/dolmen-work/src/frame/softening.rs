//! Storeys whose columns soften where their feet lift off, while joints and walls hold the storey as well.
//!
//! A frequency measures the sum of beds and joints. Where the file gives `bed_stiffness`, the beds have it and the joints the rest, so that the
//! frequency is the measured one. Where it does not, or gives beds stiffer than the storey, two extremes bound what they share.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k, k_b, k_j | – | stiffness of the storey, of the beds of its columns, of joints and walls: k = k_b + k_j | N/m |
//! | u, T(u) | `drift_m`, `force_n` | drift, and the force of columns and joints at it, P-delta included | m, N |
//! | N, h | `axial_n`, `height_m` | weight on the columns, their height | N, m |
//! | S_d | – | displacement of the spectrum at a stiffness | m |

use crate::error::WorkError;
use dolmen::assess::demand::{DRIFT_RATIO_MOST, SiteDemand, frame_drifts_by_spectrum};
use dolmen::stability::ColumnsBesideJoints;
use dolmen::structure::{Convention, Frame};
use dolmen_project::{DirectionPart, FramePart, Pick};

/// Relative change of the drift at which the iteration ends.
const CHANGE_MOST: f64 = 1e-6;
/// Largest number of iterations; each brings the drift nearer by a constant factor.
const ITERATIONS_MOST: usize = 500;

/// Origin of the stiffness of the beds in a storey that joints hold as well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BedsFrom {
    /// The file: its `bed_stiffness`; joints have the rest of the stiffness of the storey.
    File,
    /// The file gives none: all of the stiffness of the storey, the one extreme.
    Storey,
    /// The file gives beds stiffer than the whole storey, which cannot be: all of the stiffness of the storey.
    StoreyTooStiff {
        /// Stiffness of the storey, N/m.
        storey_n_m: f64,
        /// Stiffness that the beds given would have alone, N/m.
        beds_n_m: f64,
    },
}

impl BedsFrom {
    /// Whether the file says how beds and joints share the stiffness.
    pub fn is_file(self) -> bool {
        matches!(self, BedsFrom::File)
    }
}

/// Reason why the motion of a storey with columns and joints is that of its springs alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhySpringsAlone {
    /// The frame has several storeys.
    SeveralStoreys,
    /// Joints rub or have slack.
    JointsOfTheirOwn,
}

/// A storey with columns and joints that moves on its springs alone, and the drift from which it softens.
#[derive(Clone, Debug, PartialEq)]
pub struct UnfollowedStorey {
    /// Its place, 0 the lowest.
    pub storey: usize,
    /// Its name.
    pub name: String,
    /// Drift ratio at which feet lift off.
    pub uplift: f64,
    /// Its largest drift ratio.
    pub drift: f64,
    /// Origin of the stiffness of its beds.
    pub beds: BedsFrom,
    /// Why it is not followed.
    pub why: WhySpringsAlone,
}

impl UnfollowedStorey {
    /// Whether feet lift off in it.
    pub fn lifts_off(&self) -> bool {
        self.drift > self.uplift
    }
}

/// Columns and joints of a storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Softening {
    pub(super) held: ColumnsBesideJoints,
    pub(super) beds: BedsFrom,
}

/// Columns and joints of a storey in a direction; `None` where it has no columns, where its stiffness is unknown, and where columns alone
/// support it.
pub(super) fn softening(
    (part, frame): (&FramePart, &Frame),
    direction: &DirectionPart,
    storey: usize,
    pick: Pick<'_>,
) -> Result<Option<Softening>, WorkError> {
    let is_alone = direction
        .stiffness
        .as_ref()
        .is_some_and(|all| all.get(storey).is_some_and(|given| given.value == 0.0));
    let is_grounded = frame.storeys().len() > 1 && frame.convention() == Convention::Grounded;
    let stiffness = part.stiffness_n_m(&direction.name, pick);
    let given = part.storeys.get(storey).and_then(|given| given.columns.as_ref());
    let (Some(stiffness), Some(given), false) = (stiffness, given, is_alone || is_grounded) else {
        return Ok(None);
    };
    let columns = given.build(&frame.storeys()[storey], pick)?;
    let storey_n_m = stiffness[storey];
    Ok(Some(Softening {
        held: ColumnsBesideJoints::sharing(&columns, storey_n_m),
        beds: match columns.bed_stiffness_n_m() {
            None => BedsFrom::Storey,
            Some(beds_n_m) if beds_n_m > storey_n_m => BedsFrom::StoreyTooStiff { storey_n_m, beds_n_m },
            Some(_) => BedsFrom::File,
        },
    }))
}

/// Why the softening of a direction is not followed; `None` if it is.
pub(super) fn why_springs_alone(part: &FramePart, direction: &DirectionPart) -> Option<WhySpringsAlone> {
    match (part.storeys.len(), &direction.friction, &direction.tenons) {
        (1, None, None) => None,
        (1, ..) => Some(WhySpringsAlone::JointsOfTheirOwn),
        _ => Some(WhySpringsAlone::SeveralStoreys),
    }
}

/// The storeys of a direction that move on their springs alone, with their largest drifts.
pub(super) fn unfollowed(
    (part, frame): (&FramePart, &Frame),
    direction: &DirectionPart,
    (names, drifts_m): (&[String], &[f64]),
    pick: Pick<'_>,
) -> Result<Vec<UnfollowedStorey>, WorkError> {
    let Some(why) = why_springs_alone(part, direction) else {
        return Ok(Vec::new());
    };
    let mut all = Vec::new();
    for (storey, (name, drift_m)) in names.iter().zip(drifts_m).enumerate() {
        let found = softening((part, frame), direction, storey, pick)?;
        let lifts = found.and_then(|of| Some((of.held.columns.uplift()?, of.beds)));
        let Some((uplift, beds)) = lifts else { continue };
        let height_m = frame.storeys()[storey].height_m;
        all.push(UnfollowedStorey {
            storey,
            name: name.clone(),
            uplift: uplift.drift_m / height_m,
            drift: drift_m.abs() / height_m,
            beds,
            why,
        });
    }
    Ok(all)
}

/// The drift of a storey by the spectrum where feet lift off. Ratios are over the height of the storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SoftenedDrift {
    pub(super) uplift: f64,
    /// `None` where the spectrum asks for more than columns and joints have.
    pub(super) drift: Option<f64>,
    pub(super) softening: Softening,
}

/// The drift of a frame of one storey by the spectrum with the force of its columns at any drift; `None` where it has no columns beside joints,
/// where joints rub or have slack, and where no foot lifts off.
///
/// ```text
/// u = S_d(T(u)/u + N/h), from the drift of the linear storey upwards
/// ```
/// The secant stiffness with the damping of the linear storey: on the safe side, since rocking adds damping.
pub(super) fn by_spectrum(
    (part, frame): (&FramePart, &Frame),
    direction: &DirectionPart,
    (site, damping_ratio): (&SiteDemand, f64),
    linear_m: f64,
    pick: Pick<'_>,
) -> Result<Option<SoftenedDrift>, WorkError> {
    if why_springs_alone(part, direction).is_some() {
        return Ok(None);
    }
    let Some(softening) = softening((part, frame), direction, 0, pick)? else {
        return Ok(None);
    };
    let height_m = softening.held.columns.height_m();
    let falls = softening.held.falls(DRIFT_RATIO_MOST * height_m)?;
    let uplift = softening.held.columns.uplift().filter(|of| of.drift_m < linear_m);
    let Some((uplift, falls)) = uplift.zip(falls) else {
        return Ok(None);
    };
    let drift_m = by_secant(
        (&softening.held, frame),
        (site, damping_ratio),
        [linear_m, falls.drift_m],
    )?;
    Ok(Some(SoftenedDrift {
        uplift: uplift.drift_m / height_m,
        drift: drift_m.map(|drift_m| drift_m / height_m),
        softening,
    }))
}

/// The drift at which the spectrum at its secant stiffness asks for no more; `None` where it is not below that of the fall.
fn by_secant(
    (held, frame): (&ColumnsBesideJoints, &Frame),
    (site, damping_ratio): (&SiteDemand, f64),
    [linear_m, falls_m]: [f64; 2],
) -> Result<Option<f64>, WorkError> {
    let weight_n_m = held.columns.axial_n() / held.columns.height_m();
    let mut drift_m = linear_m;
    for _ in 0..ITERATIONS_MOST {
        if drift_m >= falls_m {
            return Ok(None);
        }
        let force_n = held.at(held.columns.rotation_at_rad(drift_m)?).force_n;
        let secant_n_m = force_n / drift_m + weight_n_m;
        // a period beyond the spectrum: its drift is not known, and larger
        let found = frame_drifts_by_spectrum(frame, &[secant_n_m], site, damping_ratio);
        let Some(asked_m) = found.ok().flatten().and_then(|all| all.first().copied()) else {
            return Ok(None);
        };
        if (asked_m - drift_m).abs() <= CHANGE_MOST * drift_m {
            return Ok(Some(asked_m));
        }
        drift_m = asked_m;
    }
    Ok(None)
}
