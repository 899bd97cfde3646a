//! Stiffness of a storey: from its walls and columns in plan, or given directly.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_e, y_e | `x_m`, `y_m` | place of a wall or column in plan | m |
//! | k_1, k_2 | `stiffness_x_n_m`, `stiffness_y_n_m` | stiffness along the axes of the element | N/m |
//! | k_θe | `stiffness_rotation_n_m_rad` | stiffness against rotation of the element itself | N·m/rad |
//! | α | `angle_degrees` | angle of the first axis of the element from x, counterclockwise | ° |
//! | k | `matrix` | stiffness against u, v, θ of a point in plan | N/m, N/rad, N·m/rad |
//! | A, b, c | | blocks of k: 2 × 2 translation, coupling, rotation | |

use super::error::BuildingError;
use dolmen_linalg::{Matrix, symmetric_eigen};

/// Stiffness below this fraction of the largest is zero: rounding leaves 1e-16 of it. Our choice.
const NONE: f64 = 1e-12;
/// Largest difference between two opposite entries, as a fraction of the largest entry. Our choice: files hold 9 digits or more.
const ASYMMETRY_MOST: f64 = 1e-9;

/// A wall, column, core or brace of a storey at a place in plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// x of its place in plan, m.
    pub x_m: f64,
    /// y of its place in plan, m.
    pub y_m: f64,
    /// Stiffness along the first axis of the element, which is x unless it is rotated, N/m.
    pub stiffness_x_n_m: f64,
    /// Stiffness along the second axis of the element, which is y unless it is rotated, N/m.
    pub stiffness_y_n_m: f64,
    /// Stiffness against rotation of the element itself, N·m/rad: 0 for thin walls and columns.
    pub stiffness_rotation_n_m_rad: f64,
    /// Rotation of the axes of the element from x and y, degrees, counterclockwise.
    pub angle_degrees: f64,
}

/// Stiffness of a storey against the drift of the floor above relative to the floor below: u, v at a point, and θ.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyStiffness {
    about_m: [f64; 2],
    matrix: [[f64; 3]; 3],
    /// Scale for the rotational stiffness: the sum over all elements without cancellation, N·m/rad.
    turning_scale: f64,
    elements: Vec<Element>,
}

impl StoreyStiffness {
    /// The stiffness of walls and columns.
    ///
    /// ```text
    /// k = Σ_e A_eᵀ R k_e Rᵀ A_e,   A_e = [1 0 −(y_e − y_O); 0 1 x_e − x_O],   R the rotation by α        3 × 3
    /// ```
    /// O is the mean position of the elements.
    ///
    /// # Errors
    /// [`BuildingError::Element`] for a negative stiffness or a value that is not a number. [`Building::new`](super::Building::new) numbers the
    /// storeys; here the number is 1.
    pub fn of_elements(elements: Vec<Element>) -> Result<Self, BuildingError> {
        for (i, element) in elements.iter().enumerate() {
            let not_negative = [
                ("stiffness_x_n_m", element.stiffness_x_n_m),
                ("stiffness_y_n_m", element.stiffness_y_n_m),
                ("stiffness_rotation_n_m_rad", element.stiffness_rotation_n_m_rad),
            ];
            let numbers = [
                ("x_m", element.x_m),
                ("y_m", element.y_m),
                ("angle_degrees", element.angle_degrees),
            ];
            let refuse = |quantity, given, allowed| {
                Err(BuildingError::Element {
                    storey: 1,
                    element: i + 1,
                    quantity,
                    given,
                    allowed,
                })
            };
            for (quantity, given) in not_negative {
                if !(given >= 0.0 && given.is_finite()) {
                    return refuse(quantity, given, "0 or a positive number");
                }
            }
            for (quantity, given) in numbers {
                if !given.is_finite() {
                    return refuse(quantity, given, "a number");
                }
            }
        }
        let count = elements.len().max(1) as f64;
        let about_m = [
            elements.iter().map(|e| e.x_m).sum::<f64>() / count,
            elements.iter().map(|e| e.y_m).sum::<f64>() / count,
        ];
        let mut matrix = [[0.0; 3]; 3];
        let mut turning_scale = 0.0;
        for element in &elements {
            let (sin, cos) = super::plan_direction::sin_cos_degrees(element.angle_degrees);
            let (k1, k2) = (element.stiffness_x_n_m, element.stiffness_y_n_m);
            let own = [
                [k1 * cos * cos + k2 * sin * sin, (k1 - k2) * sin * cos, 0.0],
                [(k1 - k2) * sin * cos, k1 * sin * sin + k2 * cos * cos, 0.0],
                [0.0, 0.0, element.stiffness_rotation_n_m_rad],
            ];
            let from = [element.x_m - about_m[0], element.y_m - about_m[1]];
            let reach = from[0].hypot(from[1]);
            turning_scale += (k1 + k2) * reach * reach + element.stiffness_rotation_n_m_rad;
            let moved = moved(&own, [-from[0], -from[1]]);
            for (row, add) in matrix.iter_mut().zip(moved) {
                for (entry, add) in row.iter_mut().zip(add) {
                    *entry += add;
                }
            }
        }
        Ok(StoreyStiffness {
            about_m,
            matrix,
            turning_scale,
            elements,
        })
    }

    /// The stiffness from its values along x and y and against rotation about the centre of rigidity.
    pub fn at_centre(
        stiffness_x_n_m: f64,
        stiffness_y_n_m: f64,
        stiffness_rotation_n_m_rad: f64,
        centre_of_rigidity_m: [f64; 2],
    ) -> Self {
        let diagonal = [stiffness_x_n_m, stiffness_y_n_m, stiffness_rotation_n_m_rad];
        let entry = |i: usize, j: usize| if i == j { diagonal[i] } else { 0.0 };
        StoreyStiffness {
            about_m: centre_of_rigidity_m,
            matrix: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
            turning_scale: stiffness_rotation_n_m_rad.abs(),
            elements: Vec::new(),
        }
    }

    /// The stiffness from its matrix against u, v, θ of a point of the plan.
    pub fn about_point(matrix: [[f64; 3]; 3], point_m: [f64; 2]) -> Self {
        StoreyStiffness {
            about_m: point_m,
            turning_scale: matrix[2][2].abs(),
            matrix,
            elements: Vec::new(),
        }
    }

    /// The walls and columns; empty if the stiffness was given directly.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The matrix against u, v, θ of another point of the plan.
    pub fn matrix_about(&self, point_m: [f64; 2]) -> [[f64; 3]; 3] {
        moved(
            &self.matrix,
            [point_m[0] - self.about_m[0], point_m[1] - self.about_m[1]],
        )
    }

    /// The point about which sway and twist are uncoupled, m; `None` if some direction of sway has no stiffness.
    ///
    /// ```text
    /// k about O = [A b; bᵀ c]:   [y_R − y_O, −(x_R − x_O)] = −A⁻¹ b
    /// ```
    pub fn centre_of_rigidity_m(&self) -> Option<[f64; 2]> {
        let k = &self.matrix;
        let determinant = k[0][0] * k[1][1] - k[0][1] * k[1][0];
        let largest = k[0][0].abs().max(k[1][1].abs());
        if determinant.is_nan() || determinant <= NONE * largest * largest {
            return None;
        }
        let first = -(k[1][1] * k[0][2] - k[0][1] * k[1][2]) / determinant;
        let second = -(k[0][0] * k[1][2] - k[1][0] * k[0][2]) / determinant;
        Some([self.about_m[0] - second, self.about_m[1] + first])
    }

    /// Refuses a matrix that no springs can produce.
    pub(super) fn check(&self, storey: usize) -> Result<(), BuildingError> {
        let k = &self.matrix;
        for row in 0..3 {
            for column in 0..3 {
                let given = k[row][column];
                if !given.is_finite() {
                    return Err(BuildingError::Value {
                        part: "storey",
                        number: storey,
                        quantity: "stiffness",
                        given,
                        allowed: "a number",
                    });
                }
                let scale = (k[row][row].abs() * k[column][column].abs())
                    .sqrt()
                    .max(f64::MIN_POSITIVE);
                if (given - k[column][row]).abs() > ASYMMETRY_MOST * scale {
                    return Err(BuildingError::Asymmetric {
                        storey,
                        row: row + 1,
                        column: column + 1,
                        upper: given,
                        lower: k[column][row],
                    });
                }
            }
        }
        for (row, quantity) in ["stiffness_x_n_m", "stiffness_y_n_m", "stiffness_rotation_n_m_rad"]
            .into_iter()
            .enumerate()
        {
            let rounding = if row == 2 { NONE * self.turning_scale } else { 0.0 };
            if k[row][row] < -rounding {
                return Err(BuildingError::Value {
                    part: "storey",
                    number: storey,
                    quantity,
                    given: k[row][row],
                    allowed: "a positive number",
                });
            }
        }
        let sway = symmetric_eigen(&Matrix::from_fn(2, 2, |i, j| k[i][j]))?;
        if sway.values[0] <= NONE * sway.values[1] || sway.values[1] <= 0.0 {
            let weak = sway.vectors.column(0);
            let degrees = weak[1].atan2(weak[0]).to_degrees();
            return Err(BuildingError::Sways {
                storey,
                direction_degrees: (degrees + 180.0) % 180.0,
                stiffness_n_m: sway.values[0],
            });
        }
        let Some(centre) = self.centre_of_rigidity_m() else {
            return Err(BuildingError::Sways {
                storey,
                direction_degrees: 0.0,
                stiffness_n_m: sway.values[0],
            });
        };
        let about_centre = self.matrix_about(centre)[2][2];
        if about_centre <= NONE * self.turning_scale.max(k[2][2].abs()) || about_centre <= 0.0 {
            return Err(BuildingError::Twists {
                storey,
                x_m: centre[0],
                y_m: centre[1],
                stiffness_n_m_rad: about_centre,
            });
        }
        Ok(())
    }
}

/// Moves the reference point of a matrix against u, v, θ by `by`: u_O = u + by_y θ, v_O = v − by_x θ.
pub(super) fn moved(k: &[[f64; 3]; 3], by: [f64; 2]) -> [[f64; 3]; 3] {
    let t = [by[1], -by[0]];
    let coupling = [0, 1].map(|i| k[i][2] + k[i][0] * t[0] + k[i][1] * t[1]);
    let rotation = k[2][2] + t[0] * (k[0][2] + coupling[0]) + t[1] * (k[1][2] + coupling[1]);
    [
        [k[0][0], k[0][1], coupling[0]],
        [k[1][0], k[1][1], coupling[1]],
        [coupling[0], coupling[1], rotation],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(x_m: f64, y_m: f64, along_n_m: f64, angle_degrees: f64) -> Element {
        Element {
            x_m,
            y_m,
            stiffness_x_n_m: along_n_m,
            stiffness_y_n_m: 0.0,
            stiffness_rotation_n_m_rad: 0.0,
            angle_degrees,
        }
    }

    #[test]
    fn exact_four_walls_by_hand() {
        // two walls along x at y = ±4 with stiffness 3; two along y, at x = −5 with 6 and at x = 5 with 2
        let walls = vec![
            wall(0.0, -4.0, 3.0, 0.0),
            wall(0.0, 4.0, 3.0, 0.0),
            wall(-5.0, 0.0, 6.0, 90.0),
            wall(5.0, 0.0, 2.0, 90.0),
        ];
        let storey = StoreyStiffness::of_elements(walls).unwrap();
        let k = storey.matrix_about([0.0, 0.0]);
        let expected = [
            [6.0, 0.0, 0.0],
            [0.0, 8.0, -20.0],
            [0.0, -20.0, 6.0 * 16.0 + 8.0 * 25.0],
        ];
        assert_eq!(k, expected);
        assert_eq!(storey.centre_of_rigidity_m(), Some([-2.5, 0.0]));
        let about = storey.matrix_about([-2.5, 0.0]);
        assert!((about[2][2] - (296.0 - 50.0)).abs() < 1e-12 && about[1][2] == 0.0);
        assert_eq!(storey.check(1), Ok(()));
    }

    #[test]
    fn exact_an_inclined_wall_pushes_along_itself_only() {
        let storey = StoreyStiffness::of_elements(vec![wall(2.0, 1.0, 5.0, 30.0)]).unwrap();
        let k = storey.matrix_about([0.0, 0.0]);
        // row of its elongation: cos α, sin α, x sin α − y cos α
        let (s, c) = (0.5, 0.75_f64.sqrt());
        let row = [c, s, 2.0 * s - c];
        for i in 0..3 {
            for j in 0..3 {
                assert!((k[i][j] - 5.0 * row[i] * row[j]).abs() < 1e-14);
            }
        }
        let refused = storey.check(3).unwrap_err().to_string();
        assert!(
            refused.contains("storey 3 does not resist sway toward 120.0 degrees"),
            "{refused}"
        );
    }

    #[test]
    fn refuses_walls_that_meet_in_one_point() {
        let radial = (0..3).map(|i| {
            let degrees = 120.0 * f64::from(i);
            let (s, c) = degrees.to_radians().sin_cos();
            wall(1.0 + 4.0 * c, 2.0 + 4.0 * s, 7.0, degrees)
        });
        let storey = StoreyStiffness::of_elements(radial.collect()).unwrap();
        let refused = storey.check(2).unwrap_err().to_string();
        assert!(refused.contains("storey 2 does not resist twisting"), "{refused}");
        assert!(refused.contains("(1.000, 2.000)"), "{refused}");
        let negative = StoreyStiffness::of_elements(vec![wall(0.0, 0.0, -1.0, 0.0)]).unwrap_err();
        assert!(
            negative.to_string().contains("stiffness_x_n_m is -1"),
            "{negative}"
        );
        let mut matrix = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
        matrix[0][2] = 0.1;
        let refused = StoreyStiffness::about_point(matrix, [0.0; 2])
            .check(1)
            .unwrap_err();
        assert!(refused.to_string().contains("row 1, column 3"), "{refused}");
        let refused = StoreyStiffness::at_centre(2.0, -3.0, 1.0, [0.0; 2])
            .check(4)
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            "storey 4: stiffness_y_n_m is -3, but must be a positive number"
        );
    }
}
