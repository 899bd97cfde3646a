//! The pagodas of the designs on softer and stiffer joints, built in.

use super::designs_error::ScoreDesignsError;
use crate::error::WorkError;
use crate::wrong::DesignNeeds;
use dolmen::assess::{SixFactors, StiffnessDesign, StiffnessEffect};

/// Built-in table; data/pagoda_score describes how it was made.
const SHIPPED: &str = include_str!("../../../../data/pagoda_score/stiffness.csv");
/// Columns of factors; then follow the stiffness over that of the designs, and ln θ minus theirs for DS2, DS3, falls.
const FACTORS: usize = 6;
/// Normal stiffness of the joints of the designs, Pa/m; the shear stiffness is 0.4 of it.
pub(super) const DESIGNS_K_N_PA_M: f64 = 1e9;

/// Effect of other joints on the capacity for DS2, DS3 and falls.
///
/// # Errors
/// None for the table as shipped: a test reads it.
pub(super) fn softer_and_stiffer() -> Result<[StiffnessEffect; 3], WorkError> {
    let mut of_state: [Vec<StiffnessDesign>; 3] = Default::default();
    let rows = SHIPPED.lines().enumerate();
    for (line, row) in rows.filter(|(_, row)| row.starts_with(|first: char| first.is_ascii_digit())) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |column: usize| {
            let text = cells.get(column).copied().unwrap_or_default();
            text.parse::<f64>().map_err(|_| ScoreDesignsError::Value {
                line: line + 1,
                column: (column + 1).to_string(),
                given: text.to_owned(),
                wanted: DesignNeeds::Number.into(),
            })
        };
        let factors = SixFactors {
            storeys: number(0)? as u32,
            body_height_m: number(1)?,
            slenderness_angle: number(2)?,
            body_slenderness: number(3)?,
            taper_rad: number(4)?,
            body_base_height_ratio: number(5)?,
        };
        for (state, found) in of_state.iter_mut().enumerate() {
            let column = FACTORS + 1 + state;
            if cells.get(column).is_some_and(|text| !text.is_empty()) {
                found.push(StiffnessDesign {
                    factors,
                    stiffness_ratio: number(FACTORS)?,
                    ln_change: number(column)?,
                });
            }
        }
    }
    let [ds2, ds3, falls] = of_state.map(|designs| StiffnessEffect::train(&designs));
    Ok([ds2?, ds3?, falls?])
}
