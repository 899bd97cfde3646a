//! What a building is made of.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of floor i, 1 the lowest | kg |
//! | x_c, y_c | `centre_m` | its centre of mass in plan | m |
//! | ρ_i | `gyration_m` | radius of gyration about it: moment of inertia m ρ² | m |
//! | h_i | `height_m` | height of the storey below it | m |

use super::elements::StoreyStiffness;
use super::error::BuildingError;
use super::outline::Outline;
use super::stability::{StoreyFall, storey_falls};

/// A rigid floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass in plan, m.
    pub centre_m: [f64; 2],
    /// Radius of gyration about the centre of mass, m.
    pub gyration_m: f64,
    /// Outline in plan; `None` if it is not known: then any point counts as on the floor.
    pub outline: Option<Outline>,
}

impl Floor {
    /// A floor whose mass is spread evenly over its outline.
    pub fn uniform(mass_kg: f64, outline: Outline) -> Self {
        Floor {
            mass_kg,
            centre_m: outline.centroid_m(),
            gyration_m: outline.gyration_m(),
            outline: Some(outline),
        }
    }

    /// Moment of inertia about the vertical through the centre of mass, kg·m²: m ρ².
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

/// Whether the weight takes part of the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PDelta {
    /// Left out.
    LeftOut,
    /// The weight of all floors above, carried where their mass is.
    Weights {
        /// Acceleration of gravity, m/s².
        gravity_m_s2: f64,
    },
}

/// Rigid floors on storeys, lowest first, checked: only valid ones exist, and they stand.
///
/// Three coordinates a floor, u, v, θ of its centre of mass, floors from the bottom.
///
/// ```
/// use dolmen::structure::building::{Building, Floor, Outline, PDelta, Storey, StoreyStiffness};
/// // one floor, 10 × 8 m, its walls stiffer on the left
/// let outline = Outline::rectangle([0.0, 0.0], 10.0, 8.0)?;
/// let stiffness = StoreyStiffness::about_point(
///     [[5.208, 0.0, 0.0], [0.0, 3.6456, -5.4684], [0.0, -5.4684, 174.468]], [0.0, 0.0]);
/// let storey = Storey { height_m: 3.0, stiffness };
/// let building = Building::new(vec![Floor::uniform(1.0, outline)], vec![storey], PDelta::LeftOut)?;
/// let modes = building.modes()?;
/// assert!((modes.modes[0].omega_rad_s - 1.847).abs() < 1e-3);
/// let centre = modes.modes[0].centres[0].unwrap();
/// assert!((centre.x_m + 23.38).abs() < 0.01);
/// # Ok::<(), dolmen::structure::building::BuildingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Building {
    floors: Vec<Floor>,
    storeys: Vec<Storey>,
    p_delta: PDelta,
}

impl Building {
    /// Floors and the storey below each, lowest first.
    ///
    /// # Errors
    /// [`BuildingError::Empty`], [`BuildingError::Count`], [`BuildingError::Value`] for a mass, gyration or height that is
    /// not positive or a stiffness that is negative; [`BuildingError::Element`]; [`BuildingError::Asymmetric`];
    /// [`BuildingError::Sways`] and [`BuildingError::Twists`] for a storey that resists too little to be one;
    /// [`BuildingError::Outside`] if a centre of mass lies beyond the box around its floor;
    /// [`BuildingError::Falls`] if P-delta takes all that a storey has.
    pub fn new(floors: Vec<Floor>, storeys: Vec<Storey>, p_delta: PDelta) -> Result<Self, BuildingError> {
        if floors.is_empty() {
            return Err(BuildingError::Empty);
        }
        if floors.len() != storeys.len() {
            return Err(BuildingError::Count {
                storeys: storeys.len(),
                floors: floors.len(),
            });
        }
        for (i, (floor, storey)) in floors.iter().zip(&storeys).enumerate() {
            check_floor(floor, i + 1)?;
            positive("storey", i + 1, "height_m", storey.height_m)?;
            storey.stiffness.check(i + 1)?;
        }
        if let PDelta::Weights { gravity_m_s2 } = p_delta {
            if !(gravity_m_s2 > 0.0 && gravity_m_s2.is_finite()) {
                return Err(BuildingError::Argument {
                    argument: "gravity_m_s2",
                    given: gravity_m_s2,
                    allowed: "a positive number (9.81 on Earth)",
                });
            }
            let falls = storey_falls(&floors, &storeys, gravity_m_s2)?;
            if let Some(first) = StoreyFall::first(&falls)
                && first.load_factor <= 1.0
            {
                return Err(BuildingError::Falls {
                    storey: first.storey,
                    motion: first.motion(),
                    load_factor: first.load_factor,
                });
            }
        }
        Ok(Building {
            floors,
            storeys,
            p_delta,
        })
    }

    /// The floors, lowest first.
    pub fn floors(&self) -> &[Floor] {
        &self.floors
    }

    /// The storeys, lowest first.
    pub fn storeys(&self) -> &[Storey] {
        &self.storeys
    }

    /// Whether the weight takes part of the stiffness.
    pub fn p_delta(&self) -> PDelta {
        self.p_delta
    }

    /// Coordinates: three a floor.
    pub fn coordinates(&self) -> usize {
        3 * self.floors.len()
    }

    /// Height of each floor above the ground, m.
    pub fn floor_heights_m(&self) -> Vec<f64> {
        let heights = self.storeys.iter().scan(0.0, |above, storey| {
            *above += storey.height_m;
            Some(*above)
        });
        heights.collect()
    }

    /// Total mass, kg.
    pub fn mass_kg(&self) -> f64 {
        self.floors.iter().map(|floor| floor.mass_kg).sum()
    }

    /// Centre of all mass in plan, m.
    pub fn centre_of_mass_m(&self) -> [f64; 2] {
        let total = self.mass_kg();
        let first = self.floors[0].centre_m;
        [0, 1].map(|axis| {
            let moment = self
                .floors
                .iter()
                .map(|floor| floor.mass_kg * (floor.centre_m[axis] - first[axis]));
            first[axis] + moment.sum::<f64>() / total
        })
    }
}

fn check_floor(floor: &Floor, number: usize) -> Result<(), BuildingError> {
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
    // the centre of mass of a court or an L may lie off the floor, but never outside its convex hull
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

/// The convex hull of corners.
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
