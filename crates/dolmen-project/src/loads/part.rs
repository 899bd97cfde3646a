//! Loads on a structure besides its own weight, checked.

use crate::quantity::{Pick, Quantity};
use dolmen::structure::building::FloorLoad;
use dolmen::structure::wind::{
    EurocodeTerrain, EurocodeWind, Kds41Exposure, Kds41Wind, TurbulenceSpectrum, Wind,
};
use dolmen::structure::{AddedMass, Chain};

/// The speed or pressure of a wind, by its definition.
#[derive(Clone, Debug, PartialEq)]
pub enum WindSpeed {
    /// Peak velocity pressure, Pa.
    Pressure(Quantity),
    /// Speed of a gust, m/s.
    Gust(Quantity),
    /// 10-minute mean, m/s, by EN 1991-1-4.
    Eurocode {
        /// Basic speed.
        speed: Quantity,
        /// Terrain.
        terrain: EurocodeTerrain,
        /// c_o.
        orography: f64,
    },
    /// 10-minute mean, m/s, by KDS 41 12 00.
    Kds41 {
        /// Basic speed.
        speed: Quantity,
        /// Exposure.
        exposure: Kds41Exposure,
        /// K_zt.
        topography: f64,
        /// I_w.
        importance: f64,
    },
}

/// An area exposed to the wind.
#[derive(Clone, Debug, PartialEq)]
pub struct WindArea {
    /// The part, from 0 at the bottom.
    pub part: usize,
    /// Area perpendicular to the wind, m².
    pub area: Quantity,
    /// Height of its middle above the ground, m, for an additional area; `None`: it replaces the part's own area.
    pub height: Option<Quantity>,
    /// Its force coefficient; `None`: that of the wind.
    pub force_coefficient: Option<Quantity>,
    /// Of a frame: the direction of wind that meets the area; `None`: all.
    pub direction: Option<usize>,
}

impl WindArea {
    /// Whether it replaces a part's own area, in wind along one of the directions of a frame.
    pub fn replaces(&self, part: usize, direction: usize) -> bool {
        self.part == part && self.height.is_none() && self.is_met(direction)
    }

    /// Whether wind along one of the directions of a frame meets it.
    pub fn is_met(&self, direction: usize) -> bool {
        self.direction.is_none_or(|own| own == direction)
    }
}

/// The wind on a building in time, with limits of its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct WindInTime {
    /// The spectrum; `None`: that of the code.
    pub spectrum: Option<TurbulenceSpectrum>,
    /// Eccentricity of the wind to either side, over the breadth.
    pub eccentricity: f64,
    /// Largest peak acceleration of the top floor, m/s².
    pub acceleration_limit: Option<Quantity>,
    /// Largest drift of a storey over its height.
    pub drift_limit: Option<f64>,
}

/// Eccentricity of the wind over the breadth if the file gives none: that of ASCE 7-10, figure 27.4-8, case 2.
pub const WIND_ECCENTRICITY: f64 = 0.15;

impl Default for WindInTime {
    fn default() -> Self {
        WindInTime {
            spectrum: None,
            eccentricity: WIND_ECCENTRICITY,
            acceleration_limit: None,
            drift_limit: None,
        }
    }
}

/// A wind that the file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct WindGiven {
    /// Its speed or pressure.
    pub speed: WindSpeed,
    /// Density of air, kg/m³, from the file or the code.
    pub air_density_kg_m3: f64,
    /// Force coefficient of the parts.
    pub force_coefficient: Quantity,
    /// Areas besides those of the parts' own widths.
    pub areas: Vec<WindArea>,
    /// The wind on a building in time.
    pub in_time: WindInTime,
    /// Its source, in words.
    pub source: Option<String>,
}

/// Wind in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum WindPart {
    /// The file gives no information.
    NotSaid,
    /// The structure is sheltered from wind.
    Sheltered,
    /// A wind.
    Given(Box<WindGiven>),
}

/// A static load.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadPart {
    /// Its name.
    pub name: String,
    /// The loaded part, from 0 at the bottom.
    pub part: usize,
    /// Height above the ground, m; `None`: the top of the part.
    pub height: Option<Quantity>,
    /// The loaded point of a stack, m; `None`: the middle of the stone in plan, at that height.
    pub position: Option<[Quantity; 3]>,
    /// The loaded point of a floor in plan, m; `None`: its centre of mass.
    pub place: Option<[Quantity; 2]>,
    /// Horizontal force, N: of a chain; of a frame with one direction along it, of a frame with several and of a building along x.
    pub force: Option<Quantity>,
    /// Force across, N: of a chain with two directions; of a frame with several and of a building along y.
    pub force_across: Option<Quantity>,
    /// Force along x, y and upwards, N, of a stack.
    pub components: Option<[Quantity; 3]>,
    /// Additional weight, N.
    pub weight: Option<Quantity>,
    /// Overturning moment, N m.
    pub moment: Option<Quantity>,
    /// Torque about the vertical on a floor, N m, from x towards y.
    pub torque: Option<Quantity>,
}

impl LoadPart {
    /// Whether it applies a force, moment or torque.
    pub fn pushes(&self) -> bool {
        let both = [&self.force, &self.force_across, &self.moment, &self.torque];
        both.into_iter().flatten().any(|of| of.value != 0.0)
    }

    /// Height above the joint below the loaded link of a chain, m: the top of the link if the file gives none.
    pub fn above_joint_m(&self, chain: &Chain, pick: Pick<'_>) -> f64 {
        let length_m = chain.links()[self.part].length_m;
        self.height.as_ref().map_or(length_m, |height| {
            (pick(height) - chain.joint_heights_m()[self.part]).clamp(0.0, length_m)
        })
    }

    /// The load on a floor of a building.
    pub fn on_floor(&self, pick: Pick<'_>) -> FloorLoad {
        let mut number = |of: &Option<Quantity>| of.as_ref().map_or(0.0, &mut *pick);
        FloorLoad {
            floor: self.part + 1,
            force_n: [number(&self.force), number(&self.force_across)],
            torque_n_m: number(&self.torque),
            at_m: self
                .place
                .as_ref()
                .map(|place| [pick(&place[0]), pick(&place[1])]),
        }
    }
}

/// Factors of a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinationPart {
    /// The table's name; `None`: unit factors, where the file has no combination.
    pub name: Option<String>,
    /// Factor of the weight of the structure.
    pub weight: f64,
    /// Factor of the wind.
    pub wind: f64,
    /// Factor of the static loads.
    pub loads: f64,
    /// On the earthquake of the site, for a building; 0 for others.
    pub earthquake: f64,
}

/// All loads besides the weight of the parts.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadsPart {
    /// Wind.
    pub wind: WindPart,
    /// Static loads in the order of the file.
    pub loads: Vec<LoadPart>,
    /// Combinations in the order of the file; one with unit factors where the file has none.
    pub combinations: Vec<CombinationPart>,
}

impl WindSpeed {
    /// The number in the file.
    pub fn quantity(&self) -> &Quantity {
        match self {
            WindSpeed::Pressure(quantity) | WindSpeed::Gust(quantity) => quantity,
            WindSpeed::Eurocode { speed, .. } | WindSpeed::Kds41 { speed, .. } => speed,
        }
    }
}

impl WindGiven {
    /// The wind of the library.
    pub fn build(&self, pick: Pick<'_>) -> Wind {
        let air_density_kg_m3 = self.air_density_kg_m3;
        match &self.speed {
            WindSpeed::Pressure(pressure) => Wind::Pressure(pick(pressure)),
            WindSpeed::Gust(speed) => Wind::Gust {
                speed_m_s: pick(speed),
                air_density_kg_m3,
            },
            WindSpeed::Eurocode {
                speed,
                terrain,
                orography,
            } => Wind::Eurocode(EurocodeWind {
                basic_speed_m_s: pick(speed),
                terrain: *terrain,
                orography: *orography,
                air_density_kg_m3,
            }),
            WindSpeed::Kds41 {
                speed,
                exposure,
                topography,
                importance,
            } => Wind::Kds41(Kds41Wind {
                basic_speed_m_s: pick(speed),
                exposure: *exposure,
                topography: *topography,
                importance: *importance,
                air_density_kg_m3,
            }),
        }
    }

    fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend([self.speed.quantity(), &self.force_coefficient]);
        all.extend(&self.in_time.acceleration_limit);
        for area in &self.areas {
            all.push(&area.area);
            all.extend(area.height.iter().chain(&area.force_coefficient));
        }
    }
}

impl LoadsPart {
    /// The loads of a file without any.
    pub fn none() -> Self {
        LoadsPart {
            wind: WindPart::NotSaid,
            loads: Vec::new(),
            combinations: Vec::new(),
        }
    }

    /// The wind, if one is given.
    pub fn wind(&self) -> Option<&WindGiven> {
        match &self.wind {
            WindPart::Given(wind) => Some(wind),
            WindPart::NotSaid | WindPart::Sheltered => None,
        }
    }

    /// Whether there is any load besides the weight.
    pub fn is_empty(&self) -> bool {
        self.wind().is_none() && self.loads.is_empty()
    }

    /// Total weight of the static loads, N.
    pub fn weight_n(&self, pick: Pick<'_>) -> f64 {
        let weights = self.loads.iter().filter_map(|load| load.weight.as_ref());
        weights.map(pick).sum()
    }

    /// The masses of loads on a chain; forces and moments have none.
    pub fn added_masses(&self, chain: &Chain, pick: Pick<'_>) -> Vec<AddedMass> {
        let heavy = self
            .loads
            .iter()
            .filter_map(|load| Some((load, load.weight.as_ref()?)));
        let each = heavy.map(|(load, weight)| AddedMass {
            link: load.part,
            height_m: load.above_joint_m(chain, pick),
            mass_kg: pick(weight) / chain.gravity_m_s2(),
        });
        each.collect()
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        if let WindPart::Given(wind) = &self.wind {
            wind.inputs(all);
        }
        for load in &self.loads {
            all.extend(
                load.height
                    .iter()
                    .chain(&load.force)
                    .chain(&load.force_across)
                    .chain(&load.weight)
                    .chain(&load.moment)
                    .chain(&load.torque)
                    .chain(load.place.iter().flatten())
                    .chain(load.position.iter().flatten())
                    .chain(load.components.iter().flatten()),
            );
        }
    }
}
