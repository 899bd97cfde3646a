//! Mass matrix, stiffness matrix and displacement rows of a building.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | M | `mass_matrix` | diagonal: m, m, m ρ² for each floor | kg, kg·m² |
//! | K | `stiffness_matrix` | including P-delta if the building has it | N/m, N/rad, N·m/rad |
//! | q_i | | u, v, θ of the centre of mass of floor i | m, rad |
//! | T_i | | displacement of the reference point per q_i: [1 0 y; 0 1 −x; 0 0 1], with the centre of mass at x, y from that point | – |

use super::building_of_floors::{Building, PDelta};
use super::error::BuildingError;
use super::plan_direction::PlanDirection;
use super::stability::geometric;
use dolmen_linalg::Matrix;

impl Building {
    /// Mass matrix M, diagonal, 3N × 3N.
    pub fn mass_matrix(&self) -> Matrix {
        Matrix::from_diagonal(&self.masses())
    }

    /// The diagonal of M: m, m, m ρ² for each floor.
    pub fn masses(&self) -> Vec<f64> {
        let each = self
            .floors()
            .iter()
            .flat_map(|floor| [floor.mass_kg, floor.mass_kg, floor.inertia_kg_m2()]);
        each.collect()
    }

    /// Stiffness matrix K, symmetric and positive definite, 3N × 3N.
    ///
    /// ```text
    /// K = Σ_s B_sᵀ (k_s − g_s) B_s,   B_s q = T_s q_s − T_(s−1) q_(s−1),   q_0 = 0        3 × 3N
    /// ```
    /// k_s and g_s refer to the drift at a common reference point, the centre of mass of the lowest floor. So the floors are coupled
    /// correctly even if their centres of mass are not above each other.
    ///
    /// # Limits
    /// Floors are rigid. A wall that acts as one cantilever over several storeys is not modelled.
    pub fn stiffness_matrix(&self) -> Matrix {
        let n = self.floors().len();
        let about = self.floors()[0].centre_m;
        let taken = match self.p_delta() {
            PDelta::LeftOut => vec![[[0.0; 3]; 3]; n],
            PDelta::Weights { gravity_m_s2 } => geometric(self.floors(), self.storeys(), about, gravity_m_s2),
        };
        let mut k = Matrix::zeros(3 * n, 3 * n);
        for (s, storey) in self.storeys().iter().enumerate() {
            let elastic = storey.stiffness.matrix_about(about);
            let own: [[f64; 3]; 3] =
                std::array::from_fn(|i| std::array::from_fn(|j| elastic[i][j] - taken[s][i][j]));
            let upper = self.to_reference(s);
            add(&mut k, [s, s], product(&upper, &own, &upper), 1.0);
            if s > 0 {
                let lower = self.to_reference(s - 1);
                add(&mut k, [s - 1, s - 1], product(&lower, &own, &lower), 1.0);
                let across = product(&upper, &own, &lower);
                let transposed = std::array::from_fn(|i| std::array::from_fn(|j| across[j][i]));
                add(&mut k, [s, s - 1], across, -1.0);
                add(&mut k, [s - 1, s], transposed, -1.0);
            }
        }
        k
    }

    /// T_i: displacement of the reference point per coordinate of floor i (index from 0).
    fn to_reference(&self, floor: usize) -> [[f64; 3]; 3] {
        let (about, centre) = (self.floors()[0].centre_m, self.floors()[floor].centre_m);
        let (x, y) = (centre[0] - about[0], centre[1] - about[1]);
        [[1.0, 0.0, y], [0.0, 1.0, -x], [0.0, 0.0, 1.0]]
    }

    /// Row over all coordinates that gives the displacement of a point of a floor along a direction. As a column it is the load of a unit
    /// force at this point.
    ///
    /// ```text
    /// cos α (u − (y − y_c) θ) + sin α (v + (x − x_c) θ)                                      3N values
    /// ```
    ///
    /// # Errors
    /// [`BuildingError::Part`] for a floor that does not exist (numbers from 1 at the bottom); [`BuildingError::Outside`] for a point outside
    /// the outline of the floor; [`BuildingError::Argument`] for a value that is not a number.
    pub fn point_row(
        &self,
        floor: usize,
        x_m: f64,
        y_m: f64,
        direction: PlanDirection,
    ) -> Result<Vec<f64>, BuildingError> {
        let index = self.floor_index(floor)?;
        let [cos, sin] = direction.unit();
        for (argument, given) in [("x_m", x_m), ("y_m", y_m), ("direction", cos)] {
            if !given.is_finite() {
                return Err(BuildingError::Argument {
                    argument,
                    given,
                    allowed: "a number",
                });
            }
        }
        let part = &self.floors()[index];
        if let Some(outline) = &part.outline {
            let beyond_m = outline.beyond_m([x_m, y_m]);
            if beyond_m > 0.0 {
                return Err(BuildingError::Outside {
                    floor,
                    x_m,
                    y_m,
                    beyond_m,
                });
            }
        }
        let mut row = vec![0.0; self.coordinates()];
        row[3 * index] = cos;
        row[3 * index + 1] = sin;
        row[3 * index + 2] = sin * (x_m - part.centre_m[0]) - cos * (y_m - part.centre_m[1]);
        Ok(row)
    }

    /// Row over all coordinates that gives the rotation of a floor.
    ///
    /// # Errors
    /// [`BuildingError::Part`] for a floor that does not exist (numbers from 1 at the bottom).
    pub fn rotation_row(&self, floor: usize) -> Result<Vec<f64>, BuildingError> {
        let index = self.floor_index(floor)?;
        let mut row = vec![0.0; self.coordinates()];
        row[3 * index + 2] = 1.0;
        Ok(row)
    }

    /// All coordinates when the building moves as a rigid body by a unit displacement along a direction.
    pub fn ground_column(&self, direction: PlanDirection) -> Vec<f64> {
        let [cos, sin] = direction.unit();
        [cos, sin, 0.0].repeat(self.floors().len())
    }

    /// All coordinates when the building rotates as a rigid body by a unit angle about a point in plan.
    pub fn turn_column(&self, about_m: [f64; 2]) -> Vec<f64> {
        let each = self.floors().iter().flat_map(|floor| {
            [
                -(floor.centre_m[1] - about_m[1]),
                floor.centre_m[0] - about_m[0],
                1.0,
            ]
        });
        each.collect()
    }

    /// Rows of the drift of a storey at the edges of the floor above: along x at the smallest and largest y, along y at the smallest and
    /// largest x. The largest drift along x or y on the floor is always at one of these edges. `None` if the outline is unknown.
    ///
    /// # Errors
    /// [`BuildingError::Part`] for a storey that does not exist (numbers from 1 at the bottom).
    pub fn edge_drift_rows(&self, storey: usize) -> Result<Option<[Vec<f64>; 4]>, BuildingError> {
        let index = self.floor_index(storey)?;
        let upper = &self.floors()[index];
        let Some(outline) = &upper.outline else {
            return Ok(None);
        };
        let extent = |axis: usize| {
            let all = outline.corners_m().iter().map(|corner| corner[axis]);
            all.fold([upper.centre_m[axis]; 2], |[least, most], at| {
                [least.min(at), most.max(at)]
            })
        };
        let row = |axis: usize, at: f64| {
            let mut row = vec![0.0; self.coordinates()];
            let mut add = |floor: usize, sign: f64| {
                let centre = self.floors()[floor].centre_m;
                row[3 * floor + axis] = sign;
                // u − (y − y_c) θ and v + (x − x_c) θ
                let arm = at - centre[1 - axis];
                row[3 * floor + 2] = if axis == 0 { -sign * arm } else { sign * arm };
            };
            add(index, 1.0);
            if index > 0 {
                add(index - 1, -1.0);
            }
            row
        };
        let ([left, right], [front, back]) = (extent(0), extent(1));
        Ok(Some([row(0, front), row(0, back), row(1, left), row(1, right)]))
    }

    /// Rows of the forces in the walls and columns of the lowest storey: shear along x and y, and torque about the vertical axis through the
    /// centre of the total mass. They depend only on the three coordinates of the lowest floor.
    ///
    /// With P-delta the walls carry more than the ground reaction, because the weight leans: k_1 drift instead of (k_1 − g_1) drift.
    pub fn base_rows(&self) -> [Vec<f64>; 3] {
        let (from, about) = (self.floors()[0].centre_m, self.centre_of_mass_m());
        let k = self.storeys()[0].stiffness.matrix_about(from);
        let (x, y) = (from[0] - about[0], from[1] - about[1]);
        let torque = [0, 1, 2].map(|j| k[2][j] + x * k[1][j] - y * k[0][j]);
        [k[0], k[1], torque].map(|own| {
            let mut row = own.to_vec();
            row.resize(self.coordinates(), 0.0);
            row
        })
    }

    pub(super) fn floor_index(&self, floor: usize) -> Result<usize, BuildingError> {
        if (1..=self.floors().len()).contains(&floor) {
            return Ok(floor - 1);
        }
        Err(BuildingError::Part {
            part: "floor",
            given: floor,
            most: self.floors().len(),
        })
    }
}

/// aᵀ k b.
fn product(a: &[[f64; 3]; 3], k: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let times = |i: usize, j: usize| (0..3).map(|l| k[i][l] * b[l][j]).sum::<f64>();
    let kb: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| times(i, j)));
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|l| a[l][i] * kb[l][j]).sum()))
}

fn add(k: &mut Matrix, [row, column]: [usize; 2], block: [[f64; 3]; 3], sign: f64) {
    for (i, values) in block.iter().enumerate() {
        for (j, value) in values.iter().enumerate() {
            k[(3 * row + i, 3 * column + j)] += sign * value;
        }
    }
}
