//! A building whose centres of mass are displaced: the accidental eccentricity of codes.

use super::building_of_floors::Building;
use super::error::BuildingError;

impl Building {
    /// Side of the bounding box of each floor along an axis (0 x, 1 y), m; `None` if a floor has no outline.
    pub fn sides_m(&self, axis: usize) -> Option<Vec<f64>> {
        let side = |corners: &[[f64; 2]]| {
            let of = corners.iter().map(|corner| corner[axis]);
            let [least, most] = of.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
                [least.min(at), most.max(at)]
            });
            most - least
        };
        let floors = self.floors().iter();
        floors
            .map(|floor| floor.outline.as_ref().map(|outline| side(outline.corners_m())))
            .collect()
    }

    /// The same building with the centre of mass of each floor displaced along an axis (0 x, 1 y) by `by_m`, m, lowest floor first. The weight
    /// acts at the displaced centre, and the radius of gyration about it is the same.
    ///
    /// # Errors
    /// As [`Building::new`]: [`BuildingError::Outside`] if a displaced centre lies beyond its floor, [`BuildingError::Falls`] if the building
    /// does not carry its weight there; [`BuildingError::Count`] unless there is one value for each floor.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::building::{Building, Floor, Outline, PDelta, Storey, StoreyStiffness};
    /// let floor = Floor::uniform(60e3, Outline::rectangle([0.0, 0.0], 20.0, 8.0)?);
    /// let stiffness = StoreyStiffness::at_centre(6e6, 4e6, 90e6, [0.0, 0.0]);
    /// let building = Building::new(vec![floor], vec![Storey { height_m: 4.2, stiffness }], PDelta::LeftOut)?;
    /// assert_eq!(building.sides_m(0), Some(vec![20.0]));
    /// assert_eq!(building.displaced(0, &[1.0])?.floors()[0].centre_m, [1.0, 0.0]);
    /// # Ok::<(), dolmen::structure::building::BuildingError>(())
    /// ```
    pub fn displaced(&self, axis: usize, by_m: &[f64]) -> Result<Building, BuildingError> {
        let mut floors = self.floors().to_vec();
        if by_m.len() != floors.len() {
            return Err(BuildingError::Count {
                storeys: by_m.len(),
                floors: floors.len(),
            });
        }
        for (floor, by_m) in floors.iter_mut().zip(by_m) {
            floor.centre_m[axis] += by_m;
        }
        Building::new(floors, self.storeys().to_vec(), self.p_delta())
    }
}
