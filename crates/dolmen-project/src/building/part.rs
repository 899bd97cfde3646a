//! The building of a project file, and the building of the library that it makes.

use super::built_damper::BuiltDamper;
use super::damper::{DamperFault, DamperPart, HostBuilding};
use crate::heaviness::Heaviness;
use crate::quantity::{Pick, Quantity};
use dolmen::dynamics::{DynamicsError, VibratingBuilding};
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingDamping, BuildingError, DampingAnchor, Element, Floor, Outline, PDelta, Storey, StoreyStiffness,
};

/// A wall or column, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct WallPart {
    /// Name, if given.
    pub name: Option<String>,
    /// Place in plan, m.
    pub x: Quantity,
    /// Place in plan, m.
    pub y: Quantity,
    /// Stiffness along its first axis, N/m.
    pub stiffness_x: Option<Quantity>,
    /// Stiffness along its second axis, N/m.
    pub stiffness_y: Option<Quantity>,
    /// Its own torsional stiffness, N m/rad.
    pub stiffness_rotation: Option<Quantity>,
    /// Angle of its first axis from x, rad.
    pub angle: Option<Quantity>,
}

/// Stiffness of a storey, from the file.
#[derive(Clone, Debug, PartialEq)]
pub enum StoreyStiffnessPart {
    /// Walls and columns in plan.
    Walls(Vec<WallPart>),
    /// Stiffness of the whole storey, about its centre of rigidity.
    Whole {
        /// Along x, N/m.
        x: Box<Quantity>,
        /// Along y, N/m.
        y: Box<Quantity>,
        /// Torsional stiffness, N m/rad.
        rotation: Box<Quantity>,
        /// Centre of rigidity, m.
        centre: Box<[Quantity; 2]>,
    },
    /// A stiffness matrix about a point.
    Matrix {
        /// Matrix for u, v, θ of the point, SI.
        matrix: [[f64; 3]; 3],
        /// The point, m.
        centre: Box<[Quantity; 2]>,
    },
}

/// The radius of gyration of a floor, from the file.
#[derive(Clone, Debug, PartialEq)]
pub enum GyrationPart {
    /// The radius of gyration of the area.
    OfArea,
    /// Radius, m.
    Radius(Quantity),
    /// Moment of inertia, kg m².
    Inertia(Quantity),
}

/// Equal floors, with the storeys below them.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorPart {
    /// Name, if given.
    pub name: Option<String>,
    /// Number of floors.
    pub count: usize,
    /// Mass or weight.
    pub heaviness: Heaviness,
    /// Outline, if given.
    pub outline: Option<Outline>,
    /// Centre of mass, m; `None`: the centroid of the area.
    pub centre: Option<Box<[Quantity; 2]>>,
    /// Gyration.
    pub gyration: GyrationPart,
    /// Height of the storey below, m.
    pub height: Quantity,
    /// Stiffness of the storey below.
    pub stiffness: StoreyStiffnessPart,
}

/// Damping of the modes, from the file.
#[derive(Clone, Debug, PartialEq)]
pub enum DampingPart {
    /// Ratios, lowest mode first; the last holds for all further modes.
    Modal(Vec<Quantity>),
    /// Two frequencies, Hz, with their ratios.
    Rayleigh(Box<[[Quantity; 2]; 2]>),
    /// Caughey's series.
    Caughey(Vec<Quantity>),
}

/// A point whose motion is reported.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedPart {
    /// Name.
    pub name: String,
    /// Floor, from 1.
    pub floor: usize,
    /// Place, m.
    pub place: Box<[Quantity; 2]>,
}

/// Floors, lowest first, with damping, dampers and points.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingPart {
    /// The floors.
    pub floors: Vec<FloorPart>,
    /// Whether the weight reduces the stiffness (P-delta).
    pub p_delta: bool,
    /// Accidental eccentricity over the side of a floor, if given; 0 leaves accidental torsion out.
    pub accidental_eccentricity: Option<f64>,
    /// Damping of the modes, if given.
    pub damping: Option<DampingPart>,
    /// Dampers in the order of the file.
    pub dampers: Vec<DamperPart>,
    /// Points in the order of the file.
    pub points: Vec<WatchedPart>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
    /// The building from reading, which needs its modes.
    pub(super) as_written: Option<VibratingBuilding>,
}

impl BuildingPart {
    /// The building with the file's own values and its damping, without its dampers; `None` if it falls under its own weight.
    pub fn as_written(&self) -> Option<&VibratingBuilding> {
        self.as_written.as_ref()
    }

    /// Floors and storeys, one each, lowest first.
    ///
    /// # Errors
    /// None for the values of the file, which are checked on reading; [`BuildingError`] if a picked value is impossible.
    pub fn floors_and_storeys(&self, pick: Pick<'_>) -> Result<(Vec<Floor>, Vec<Storey>), BuildingError> {
        let (mut floors, mut storeys) = (Vec::new(), Vec::new());
        for part in &self.floors {
            let mass_kg = part.heaviness.mass_kg(self.gravity_m_s2, pick);
            let area = part.outline.as_ref();
            let centre_m = match &part.centre {
                Some(centre) => [pick(&centre[0]), pick(&centre[1])],
                None => area.map_or([0.0; 2], Outline::centroid_m),
            };
            let gyration_m = match &part.gyration {
                GyrationPart::Radius(radius) => pick(radius),
                GyrationPart::Inertia(inertia) => (pick(inertia) / mass_kg).sqrt(),
                GyrationPart::OfArea => area.map_or(f64::NAN, Outline::gyration_m),
            };
            let floor = Floor {
                mass_kg,
                centre_m,
                gyration_m,
                outline: part.outline.clone(),
            };
            let stiffness = part.stiffness.build(storeys.len() + 1, pick)?;
            let storey = Storey {
                height_m: pick(&part.height),
                stiffness,
            };
            for _ in 0..part.count {
                floors.push(floor.clone());
                storeys.push(storey.clone());
            }
        }
        Ok((floors, storeys))
    }

    /// The building, each input with the value that `pick` chooses.
    ///
    /// # Errors
    /// As [`Building::new`]: with the file's own values only [`BuildingError::Falls`].
    pub fn build(&self, pick: Pick<'_>) -> Result<Building, BuildingError> {
        let (floors, storeys) = self.floors_and_storeys(pick)?;
        let p_delta = match self.p_delta {
            true => PDelta::Weights {
                gravity_m_s2: self.gravity_m_s2,
            },
            false => PDelta::LeftOut,
        };
        Building::new(floors, storeys, p_delta)
    }

    /// As [`BuildingPart::vibrating`], its P-delta that of the weight times this factor.
    ///
    /// # Errors
    /// As [`BuildingPart::vibrating`].
    pub fn vibrating_under(&self, weight: f64, pick: Pick<'_>) -> Result<VibratingBuilding, DynamicsError> {
        let (floors, storeys) = self.floors_and_storeys(pick)?;
        let p_delta = match self.p_delta {
            true => PDelta::Weights {
                gravity_m_s2: self.gravity_m_s2 * weight,
            },
            false => PDelta::LeftOut,
        };
        let building = Building::new(floors, storeys, p_delta)?;
        VibratingBuilding::new(building, &self.damping(pick), Vec::new())
    }

    /// The building with its damping, without its dampers.
    ///
    /// # Errors
    /// As [`BuildingPart::build`] and [`VibratingBuilding::new`].
    pub fn vibrating(&self, pick: Pick<'_>) -> Result<VibratingBuilding, DynamicsError> {
        VibratingBuilding::new(self.build(pick)?, &self.damping(pick), Vec::new())
    }

    /// Its damping; 5 % in every mode if the file gives none.
    pub fn damping(&self, pick: Pick<'_>) -> BuildingDamping {
        const DEFAULT: f64 = 0.05; // what the spectra of codes are for
        match &self.damping {
            None => BuildingDamping::Modal(vec![DEFAULT]),
            Some(DampingPart::Modal(ratios)) => BuildingDamping::Modal(ratios.iter().map(pick).collect()),
            Some(DampingPart::Caughey(ratios)) => BuildingDamping::Caughey(ratios.iter().map(pick).collect()),
            Some(DampingPart::Rayleigh(anchors)) => {
                let mut anchor = |[frequency, ratio]: &[Quantity; 2]| DampingAnchor {
                    frequency_hz: pick(frequency),
                    damping_ratio: pick(ratio),
                };
                BuildingDamping::Rayleigh([anchor(&anchors[0]), anchor(&anchors[1])])
            }
        }
    }

    /// The dampers with every number that follows from the modes.
    ///
    /// # Errors
    /// [`DamperFault`] for a damper whose mode does not move at its place, that is too heavy, or that is not on its floor.
    pub fn dampers(
        &self,
        building: &VibratingBuilding,
        pick: Pick<'_>,
    ) -> Result<Vec<BuiltDamper>, DamperFault> {
        let host = HostBuilding {
            vibrating: building,
            gravity_m_s2: self.gravity_m_s2,
        };
        let mut built = Vec::with_capacity(self.dampers.len());
        for part in &self.dampers {
            built.extend(part.build(&host, pick)?);
        }
        Ok(built)
    }

    /// Number, from 1, of the part of the file that floor `floor` (from 1) comes from.
    pub fn part_of_floor(&self, floor: usize) -> usize {
        let mut last = 0;
        for (i, part) in self.floors.iter().enumerate() {
            last += part.count;
            if floor <= last {
                return i + 1;
            }
        }
        self.floors.len()
    }

    /// Names of all floors, lowest first: those of the file, or numbers.
    pub fn floor_names(&self) -> Vec<String> {
        let mut names = Vec::new();
        for part in &self.floors {
            for _ in 0..part.count {
                let number = (names.len() + 1).to_string();
                names.push(match &part.name {
                    Some(name) if part.count == 1 => name.clone(),
                    _ => number,
                });
            }
        }
        names
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for floor in &self.floors {
            all.extend([floor.heaviness.quantity(), &floor.height]);
            all.extend(floor.centre.iter().flat_map(|centre| centre.iter()));
            match &floor.gyration {
                GyrationPart::Radius(given) | GyrationPart::Inertia(given) => all.push(given),
                GyrationPart::OfArea => {}
            }
            match &floor.stiffness {
                StoreyStiffnessPart::Walls(walls) => {
                    for wall in walls {
                        all.extend([&wall.x, &wall.y]);
                        let rest = [
                            &wall.stiffness_x,
                            &wall.stiffness_y,
                            &wall.stiffness_rotation,
                            &wall.angle,
                        ];
                        all.extend(rest.into_iter().flatten());
                    }
                }
                StoreyStiffnessPart::Whole {
                    x,
                    y,
                    rotation,
                    centre,
                } => {
                    all.extend([&**x, y, rotation]);
                    all.extend(centre.iter());
                }
                StoreyStiffnessPart::Matrix { centre, .. } => all.extend(centre.iter()),
            }
        }
        match &self.damping {
            None => {}
            Some(DampingPart::Modal(ratios) | DampingPart::Caughey(ratios)) => all.extend(ratios),
            Some(DampingPart::Rayleigh(anchors)) => all.extend(anchors.iter().flatten()),
        }
        for damper in &self.dampers {
            damper.inputs(all);
        }
        all.extend(self.points.iter().flat_map(|point| point.place.iter()));
    }
}

impl StoreyStiffnessPart {
    fn build(&self, storey: usize, pick: Pick<'_>) -> Result<StoreyStiffness, BuildingError> {
        let of_storey = |why| match why {
            BuildingError::Element {
                element,
                quantity,
                given,
                allowed,
                ..
            } => BuildingError::Element {
                storey,
                element,
                quantity,
                given,
                allowed,
            },
            other => other,
        };
        Ok(match self {
            StoreyStiffnessPart::Walls(walls) => {
                let mut elements = Vec::with_capacity(walls.len());
                for wall in walls {
                    let mut or_none = |given: &Option<Quantity>| given.as_ref().map_or(0.0, &mut *pick);
                    elements.push(Element {
                        stiffness_x_n_m: or_none(&wall.stiffness_x),
                        stiffness_y_n_m: or_none(&wall.stiffness_y),
                        stiffness_rotation_n_m_rad: or_none(&wall.stiffness_rotation),
                        angle_degrees: degrees(or_none(&wall.angle)),
                        x_m: pick(&wall.x),
                        y_m: pick(&wall.y),
                    });
                }
                StoreyStiffness::of_elements(elements).map_err(of_storey)?
            }
            StoreyStiffnessPart::Whole {
                x,
                y,
                rotation,
                centre,
            } => {
                let centre = [pick(&centre[0]), pick(&centre[1])];
                StoreyStiffness::at_centre(pick(x), pick(y), pick(rotation), centre)
            }
            StoreyStiffnessPart::Matrix { matrix, centre } => {
                StoreyStiffness::about_point(*matrix, [pick(&centre[0]), pick(&centre[1])])
            }
        })
    }
}

/// Degrees; whole numbers are exact.
fn degrees(angle_rad: f64) -> f64 {
    let degrees = angle_rad.to_degrees();
    let whole = degrees.round();
    if (degrees - whole).abs() < 1e-12 * whole.abs() {
        whole
    } else {
        degrees
    }
}
