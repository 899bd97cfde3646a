//! Accidental torsion: response of a building to a design spectrum with its centres of mass displaced.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | e_x, e_y | `by_m` | displacement of the centre of mass of a floor along x and along y | m |
//! | r_x | | response to shaking along x, with the centres displaced along y by ± e_y | m |
//! | r_y | | response to shaking along y, with the centres displaced along x by ± e_x | m |

use super::{AttachedDamper, DamperError, damped_spectral_analysis};
use crate::dynamics::{
    DirectionalCombination, DynamicsError, ModalCombination, VibratingBuilding, spectral_analysis,
};
use crate::structure::building::BuildingDamping;

/// Signs of the displacement along x and along y.
const SIGNS: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

/// A building with its damping and its dampers.
#[derive(Clone, Copy, Debug)]
pub struct DisplacedBuilding<'a> {
    /// The building, without tuned masses.
    pub vibrating: &'a VibratingBuilding,
    /// Damping of its modes, given anew to the modes of the displaced building.
    pub damping: &'a BuildingDamping,
    /// Its dampers, which stay at their places.
    pub dampers: &'a [AttachedDamper],
}

/// Largest responses for one combination of signs.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplacedCase {
    /// Sign of the displacement along x, under shaking along y, and of that along y, under shaking along x.
    pub signs: [f64; 2],
    /// Largest drift of each storey at an edge of its floor along x and y, m.
    pub edge_drift_m: Vec<[f64; 2]>,
    /// Largest stroke of each damper, m, then of the liquids of columns on springs.
    pub strokes_m: Vec<f64>,
}

/// The largest responses with the centre of mass of each floor displaced by ± `by_m` across the shaking: modes by CQC, shaking along x and
/// along y by the square root of the sum of squares.
///
/// ```text
/// r = √(r_x² + r_y²)        for each of the four combinations of the signs of e_x and e_y, which are the same on every floor
/// ```
/// `acceleration_m_s2(period_s, damping_ratio)` gives S_a along x and along y.
///
/// # Errors
/// [`DynamicsError`] if a displaced centre lies beyond its floor, or the building does not carry its weight there; as
/// [`spectral_analysis`] and [`damped_spectral_analysis`]. Errors of the spectrum are passed on.
///
/// # Limits
/// All floors must have an outline; floors without one have no edge and are left out. The amplification A_x of ASCE 7-16, 12.8.4.3, is not
/// applied: 12.9.1.5 does not require it where the displacement is in the dynamic model.
///
/// # Source
/// EN 1998-1:2004, 4.3.2 (1)P and 4.3.3.5.1 (2).
pub fn displaced_responses<E: From<DynamicsError> + From<DamperError>>(
    of: &DisplacedBuilding<'_>,
    by_m: &[[f64; 2]],
    acceleration_m_s2: impl Fn(f64, f64) -> Result<[f64; 2], E>,
) -> Result<Vec<DisplacedCase>, E> {
    let shaken = |axis: usize, sign: f64| -> Result<ShakenAlong, E> {
        // the displacement is across the shaking
        let across = 1 - axis;
        let by_m: Vec<f64> = by_m.iter().map(|by| sign * by[across]).collect();
        let displaced = of.vibrating.building().displaced(across, &by_m);
        let building = displaced.map_err(DynamicsError::from)?;
        let vibrating = VibratingBuilding::new(building, of.damping, Vec::new())?;
        ShakenAlong::new(&vibrating, of.dampers, axis, &acceleration_m_s2)
    };
    let along_x = [shaken(0, 1.0)?, shaken(0, -1.0)?];
    let along_y = [shaken(1, 1.0)?, shaken(1, -1.0)?];
    let of_sign = |sign: f64| usize::from(sign < 0.0);
    let case = |signs: [f64; 2]| {
        let (by_x, by_y) = (&along_x[of_sign(signs[1])], &along_y[of_sign(signs[0])]);
        let storeys = by_x.edges_m.iter().zip(&by_y.edges_m);
        let strokes = by_x.strokes_m.iter().zip(&by_y.strokes_m);
        DisplacedCase {
            signs,
            edge_drift_m: storeys
                .map(|(x, y)| {
                    let [front, back, left, right] = [0, 1, 2, 3].map(|edge| x[edge].hypot(y[edge]));
                    [front.max(back), left.max(right)]
                })
                .collect(),
            strokes_m: strokes.map(|(x, y)| x.hypot(*y)).collect(),
        }
    };
    Ok(SIGNS.map(case).to_vec())
}

/// Largest responses to shaking along one axis.
struct ShakenAlong {
    /// Drift of each storey at the edges of its floor: along x at two, along y at two, m.
    edges_m: Vec<[f64; 4]>,
    strokes_m: Vec<f64>,
}

impl ShakenAlong {
    fn new<E: From<DynamicsError> + From<DamperError>>(
        vibrating: &VibratingBuilding,
        dampers: &[AttachedDamper],
        axis: usize,
        acceleration_m_s2: &impl Fn(f64, f64) -> Result<[f64; 2], E>,
    ) -> Result<Self, E> {
        let alone = [DirectionalCombination::XAlone, DirectionalCombination::YAlone][axis];
        if dampers.is_empty() {
            let analysis = spectral_analysis(vibrating, acceleration_m_s2)?;
            let largest = |row: &[f64]| analysis.largest(row, ModalCombination::Cqc, alone);
            return Ok(ShakenAlong {
                edges_m: edges_m(vibrating, &largest)?,
                strokes_m: Vec::new(),
            });
        }
        let analysis = damped_spectral_analysis(vibrating, dampers, acceleration_m_s2)?;
        Ok(ShakenAlong {
            edges_m: edges_m(vibrating, &|row| analysis.largest(row, alone))?,
            strokes_m: analysis.largest_strokes_m(alone),
        })
    }
}

fn edges_m(
    vibrating: &VibratingBuilding,
    largest: &dyn Fn(&[f64]) -> f64,
) -> Result<Vec<[f64; 4]>, DynamicsError> {
    let building = vibrating.building();
    let mut all = Vec::with_capacity(building.storeys().len());
    for storey in 1..=building.storeys().len() {
        let rows = building.edge_drift_rows(storey)?;
        all.extend(rows.map(|rows| rows.map(|row| largest(&row))));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known::STANDARD_GRAVITY_M_S2;
    use crate::known::displaced_centre::DisplacedFloor;
    use crate::structure::Building;
    use crate::structure::building::{Floor, Outline, PDelta, Storey, StoreyStiffness};

    const MASS_KG: f64 = 60e3;
    const STIFFNESS: [f64; 3] = [6e6, 4e6, 90e6];

    fn vibrating(p_delta: PDelta) -> VibratingBuilding {
        let floor = Floor::uniform(MASS_KG, Outline::rectangle([0.0, 0.0], 20.0, 8.0).unwrap());
        let [x, y, rotation] = STIFFNESS;
        let storey = Storey {
            height_m: 4.2,
            stiffness: StoreyStiffness::at_centre(x, y, rotation, [0.0, 0.0]),
        };
        let building = Building::new(vec![floor], vec![storey], p_delta).unwrap();
        VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap()
    }

    fn responses(by_m: [f64; 2]) -> Vec<DisplacedCase> {
        let vibrating = vibrating(PDelta::Weights {
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
        });
        let of = DisplacedBuilding {
            vibrating: &vibrating,
            damping: &BuildingDamping::Modal(vec![0.05]),
            dampers: &[],
        };
        let falling = |period_s: f64, _| Ok::<_, DamperError>([2.2725 / period_s; 2]);
        displaced_responses(&of, &[by_m], falling).unwrap()
    }

    /// One floor of 20 × 8 m under S_a = 2.2725/T m/s²: two coupled modes for each direction of shaking, combined by hand.
    #[test]
    fn exact_edge_drifts_of_a_displaced_floor() {
        let weight = MASS_KG * STANDARD_GRAVITY_M_S2 / 4.2;
        let floor = DisplacedFloor {
            mass_kg: MASS_KG,
            gyration_m: ((20.0_f64.powi(2) + 8.0_f64.powi(2)) / 12.0).sqrt(),
            stiffness: [STIFFNESS[0], STIFFNESS[1], STIFFNESS[2]],
            weight_over_height_n_m: weight,
            damping_ratio: 0.05,
            acceleration_times_period_m_s: 2.2725,
        };
        let by_hand = floor.edge_drifts_m([1.0, 0.4], [10.0, 4.0]);
        for case in responses([1.0, 0.4]) {
            for axis in [0, 1] {
                let drift_m = case.edge_drift_m[0][axis];
                assert!(
                    (drift_m / by_hand[axis] - 1.0).abs() < 1e-10,
                    "{:?} axis {axis}: {drift_m} is not {}",
                    case.signs,
                    by_hand[axis]
                );
            }
        }
    }

    #[test]
    fn holds_no_displacement_changes_nothing_and_the_building_itself_stays() {
        let none = responses([0.0; 2]);
        assert!(
            none.windows(2)
                .all(|pair| pair[0].edge_drift_m == pair[1].edge_drift_m)
        );
        let floor = DisplacedFloor {
            mass_kg: MASS_KG,
            gyration_m: 1.0,
            stiffness: STIFFNESS,
            weight_over_height_n_m: MASS_KG * STANDARD_GRAVITY_M_S2 / 4.2,
            damping_ratio: 0.05,
            acceleration_times_period_m_s: 2.2725,
        };
        // without coupling the gyration does not matter
        let by_hand = floor.edge_drifts_m([0.0; 2], [10.0, 4.0]);
        for axis in [0, 1] {
            assert!((none[0].edge_drift_m[0][axis] / by_hand[axis] - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn refuses_a_centre_beyond_its_floor() {
        let vibrating = vibrating(PDelta::LeftOut);
        let of = DisplacedBuilding {
            vibrating: &vibrating,
            damping: &BuildingDamping::Modal(vec![0.05]),
            dampers: &[],
        };
        let flat = |_, _| Ok::<_, DamperError>([1.0; 2]);
        let why = displaced_responses(&of, &[[10.5, 0.0]], flat).unwrap_err();
        assert!(why.to_string().contains("0.5"), "{why}");
    }
}
