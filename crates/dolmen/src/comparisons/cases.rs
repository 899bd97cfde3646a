//! All cases, source by source.

use super::{
    Case, ValidationError, accidental_torsion, aftershocks, arches, building_motion, choi_2021, chopra_2017,
    columns, crushing, dampers, domes, driven_modes, dry_friction, earthquakes, ferris_tin_loi_2001,
    fragility, free_columns, free_decay, free_walls, gusts, hwang_min_hong, joined, kim_koo_hong_2018,
    local_mechanisms, owen_prieur_2017, park_min_2010, pushed_frames, pyoma2, restitution, rigid_blocks,
    second_methods, setups, sliced_scans, survey_change, tenons, watch, wind,
};
use rayon::prelude::*;

/// Computes the cases of one source.
type Cases = fn() -> Result<Vec<Case>, ValidationError>;

/// All cases, source by source.
///
/// # Errors
/// [`ValidationError`] if a case cannot be computed, which is a fault of this crate.
///
/// # Example
/// ```
/// let cases = dolmen::comparisons::cases()?;
/// assert!(cases.iter().all(|case| case.agrees()));
/// # Ok::<(), dolmen::comparisons::ValidationError>(())
/// ```
pub fn cases() -> Result<Vec<Case>, ValidationError> {
    let sources: &[Cases] = &[
        choi_2021::cases,
        columns::cases,
        free_columns::cases,
        wind::cases,
        pushed_frames::cases,
        gusts::cases,
        park_min_2010::cases,
        kim_koo_hong_2018::cases,
        || Ok(rigid_blocks::cases()),
        arches::cases,
        domes::cases,
        ferris_tin_loi_2001::cases,
        local_mechanisms::cases,
        crushing::cases,
        restitution::cases,
        free_walls::cases,
        sliced_scans::cases,
        dry_friction::cases,
        tenons::cases,
        hwang_min_hong::cases,
        chopra_2017::cases,
        accidental_torsion::cases,
        building_motion::cases,
        dampers::cases,
        fragility::cases,
        aftershocks::cases,
        owen_prieur_2017::cases,
        free_decay::cases,
        driven_modes::cases,
        earthquakes::cases,
        joined::cases,
        pyoma2::cases,
        setups::cases,
        survey_change::cases,
        watch::cases,
        second_methods::cases,
    ];
    let each: Result<Vec<_>, _> = sources.par_iter().map(|source| source()).collect();
    Ok(each?.into_iter().flatten().collect())
}
