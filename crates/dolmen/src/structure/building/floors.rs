//! Floors and storeys of a building.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of floor i; i = 1 is the lowest | kg |
//! | x_c, y_c | `centre_m` | centre of mass of the floor in plan | m |
//! | ρ_i | `gyration_m` | radius of gyration about the centre of mass: moment of inertia m ρ² | m |
//! | h_i | `height_m` | height of the storey below the floor | m |

use super::elements::StoreyStiffness;
use super::error::BuildingError;
use super::outline::Outline;

/// A rigid floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass in plan, m.
    pub centre_m: [f64; 2],
    /// Radius of gyration about the centre of mass, m.
    pub gyration_m: f64,
    /// Outline in plan; `None` if unknown: then any point is on the floor.
    pub outline: Option<Outline>,
}

impl Floor {
    /// A floor whose mass is uniform over its outline.
    pub fn uniform(mass_kg: f64, outline: Outline) -> Self {
        Floor {
            mass_kg,
            centre_m: outline.centroid_m(),
            gyration_m: outline.gyration_m(),
            outline: Some(outline),
        }
    }

    /// Moment of inertia about the vertical axis through the centre of mass, kg·m²: m ρ².
    pub fn inertia_kg_m2(&self) -> f64 {
        self.mass_kg * self.gyration_m * self.gyration_m
    }
}

/// The storey below a floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Storey {
    /// Height, m.
    pub height_m: f64,
    /// Stiffness against the drift of the floor above relative to the floor below.
    pub stiffness: StoreyStiffness,
}

pub(super) fn check_floor(floor: &Floor, number: usize) -> Result<(), BuildingError> {
    positive("floor", number, "mass_kg", floor.mass_kg)?;
    positive("floor", number, "gyration_m", floor.gyration_m)?;
    for (axis, quantity) in ["centre_x_m", "centre_y_m"].into_iter().enumerate() {
        let given = floor.centre_m[axis];
        if !given.is_finite() {
            return Err(BuildingError::Value {
                part: "floor",
                number,
                quantity,
                given,
                allowed: "a number",
            });
        }
    }
    let Some(outline) = &floor.outline else {
        return Ok(());
    };
    // the centre of mass of an L-shaped floor, or of one with a court, may be off the floor, but never outside
    // its convex hull
    let hull = hull(outline.corners_m())?;
    let beyond_m = hull.beyond_m(floor.centre_m);
    if beyond_m > 0.0 {
        return Err(BuildingError::Outside {
            floor: number,
            x_m: floor.centre_m[0],
            y_m: floor.centre_m[1],
            beyond_m,
        });
    }
    let farthest = outline
        .corners_m()
        .iter()
        .map(|corner| (corner[0] - floor.centre_m[0]).hypot(corner[1] - floor.centre_m[1]));
    if floor.gyration_m > farthest.fold(0.0, f64::max) {
        return Err(BuildingError::Value {
            part: "floor",
            number,
            quantity: "gyration_m",
            given: floor.gyration_m,
            allowed: "at most the distance of its farthest corner from its centre of mass",
        });
    }
    Ok(())
}

fn hull(corners: &[[f64; 2]]) -> Result<Outline, BuildingError> {
    Outline::new(crate::structure::stack::Polygon::hull(corners.to_vec()).corners_m)
}

pub(super) fn positive(
    part: &'static str,
    number: usize,
    quantity: &'static str,
    given: f64,
) -> Result<(), BuildingError> {
    if given > 0.0 && given.is_finite() {
        return Ok(());
    }
    Err(BuildingError::Value {
        part,
        number,
        quantity,
        given,
        allowed: "a positive number",
    })
}
