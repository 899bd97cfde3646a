//! A building under a combination: the drift of each storey by its parts.

use dolmen::stability::Verdict;

/// A building under a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingCombination {
    /// Factor on the drifts under the spectrum of the site.
    pub earthquake: f64,
    /// Factor on the weight of the combination at which a storey falls.
    pub weight_factor: f64,
    /// Each floor, lowest first, with the storey below it; empty if the building falls.
    pub storeys: Vec<StoreyCombined>,
    /// The motion that counts but could not be computed.
    pub unknown: Option<UnknownMotion>,
    /// The drift limit that holds for it, over the height of the storey.
    pub drift_limit: Option<f64>,
}

/// A motion that could not be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum UnknownMotion {
    /// That in the wind.
    Wind,
    /// That under the spectrum of the site.
    Earthquake,
}

/// A floor and the storey below it under a combination. Drifts are those at the worst corner of the floor above, along x and along y.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct StoreyCombined {
    /// The floor above it.
    pub floor: String,
    /// Its height, m.
    pub height_m: f64,
    /// Whether the drifts are those of the centre of mass, because the outline is unknown.
    pub at_centre: bool,
    /// Displacement of the centre of mass of the floor under the static loads, m.
    pub displacement_m: [f64; 2],
    /// Its rotation under the static loads, rad.
    pub rotation_rad: f64,
    /// Drift by the static loads, m.
    pub loads_m: [f64; 2],
    /// Peak drift in the wind along that axis, m.
    pub wind_m: [f64; 2],
    /// Drift under the spectrum of the site, m.
    pub earthquake_m: [f64; 2],
}

impl StoreyCombined {
    /// Sum of the three, over the height: wind and earthquake come from either side.
    pub fn drift_ratios(&self) -> [f64; 2] {
        [0, 1].map(|axis| (self.loads_m[axis] + self.wind_m[axis] + self.earthquake_m[axis]) / self.height_m)
    }
}

/// The largest drift of a storey over its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestCombined<'a> {
    /// The storey.
    pub storey: &'a StoreyCombined,
    /// Along x, 0, or y, 1.
    pub axis: usize,
    /// The drift over its height.
    pub ratio: f64,
}

impl BuildingCombination {
    /// The largest drift of all storeys; `None` if the building falls.
    pub fn largest(&self) -> Option<LargestCombined<'_>> {
        let each = self.storeys.iter().flat_map(|storey| {
            let pairs = storey.drift_ratios().into_iter().enumerate();
            pairs.map(move |(axis, ratio)| LargestCombined { storey, axis, ratio })
        });
        each.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// Limit over drift; `None` without a limit, without drift, and if the building falls.
    pub fn drift_margin(&self) -> Option<f64> {
        let largest = self.largest().filter(|of| of.ratio > 0.0)?;
        Some(self.drift_limit? / largest.ratio)
    }

    /// Verdict from the factor on the weight.
    pub fn verdict(&self) -> Verdict {
        Verdict::of_load_factor(self.weight_factor)
    }
}
