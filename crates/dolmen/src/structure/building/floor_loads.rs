//! A building under static loads on its floors.

use super::building_of_floors::Building;
use super::error::BuildingError;
use dolmen_linalg::{Matrix, solve};

/// A static load on a floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorLoad {
    /// Number of the floor, from 1 at the bottom.
    pub floor: usize,
    /// Force along x and y, N.
    pub force_n: [f64; 2],
    /// Point in plan at which the force acts, m, also beside the floor; `None`: the centre of mass.
    pub at_m: Option<[f64; 2]>,
    /// Torque about the vertical, N m, from x towards y.
    pub torque_n_m: f64,
}

impl Building {
    /// Displacement of all coordinates under static loads: u, v, θ of the centre of mass of each floor, in metres and radians.
    ///
    /// ```text
    /// K q = Σ (F_x, F_y, T + (x − x_c) F_y − (y − y_c) F_x)                                  3N
    /// ```
    /// K includes P-delta if the building has it. Dampers do not resist a static load. The test `building_loads` compares it with closed
    /// forms and with 200 random buildings.
    ///
    /// # Errors
    /// [`BuildingError::Part`] for a floor that does not exist; [`BuildingError::Argument`] for a value that is not a number.
    pub fn under_loads(&self, loads: &[FloorLoad]) -> Result<Vec<f64>, BuildingError> {
        let mut forces = vec![0.0; self.coordinates()];
        for load in loads {
            let index = self.floor_index(load.floor)?;
            let centre = self.floors()[index].centre_m;
            let [x, y] = load.at_m.unwrap_or(centre);
            let [force_x, force_y] = load.force_n;
            let torque = load.torque_n_m + (x - centre[0]) * force_y - (y - centre[1]) * force_x;
            let named = [("force_n", force_x), ("force_n", force_y), ("torque_n_m", torque)];
            for (axis, (argument, given)) in named.into_iter().enumerate() {
                if !given.is_finite() {
                    return Err(BuildingError::Argument {
                        argument,
                        given,
                        allowed: "a number",
                    });
                }
                forces[3 * index + axis] += given;
            }
        }
        let moved = solve(&self.stiffness_matrix(), &Matrix::from_column(&forces))?;
        Ok(moved.column(0).to_vec())
    }
}
