//! Measurements of one occasion.

use super::inspection::Inspection;
use super::records::RecordSource;
use crate::quantity::{Pick, Quantity};
use dolmen::structure::building::Twist;
use dolmen::structure::{MeasuredMode, ShapePoint};
use std::collections::BTreeMap;

/// A ratio of horizontal to vertical, as surveys state tilt.
#[derive(Clone, Debug, PartialEq)]
pub struct Tilt {
    /// Horizontal / vertical.
    pub ratio: f64,
    /// As written: "1/177".
    pub written: String,
}

/// How the plan moves in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// Every point of a level moves the same way.
    Translation,
    /// The plan twists: reported, but not used in fits of a frame or chain in one direction.
    Torsion,
}

/// One mode that the file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct SurveyMode {
    /// Frequency, Hz.
    pub frequency: Quantity,
    /// Damping ratio.
    pub damping_ratio: Option<Quantity>,
    /// Measured points of the shape; empty if only the frequency is known.
    pub shape: Vec<ShapePoint>,
    /// Translation or torsion.
    pub kind: ModeKind,
    /// Of a building: ρθ of the floor over the displacement of its centre of mass along the direction.
    pub twist: Option<Twist>,
    /// Of a building: displacement of the centre of mass across the direction over that along it.
    pub sideways: Option<f64>,
}

impl SurveyMode {
    /// The mode in the form for the identification of stiffness.
    pub fn measured(&self, pick: Pick<'_>) -> MeasuredMode {
        MeasuredMode {
            frequency_hz: pick(&self.frequency),
            frequency_sd_hz: self.frequency.standard_deviation(),
            frequency_changes_hz: Vec::new(),
            shape: self.shape.clone(),
        }
    }
}

/// How two surveys are compared: `[change]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChangePart {
    /// Effect of temperature.
    pub temperature: TemperaturePart,
    /// Largest relative difference of two frequencies that count as one mode; `None` leaves the choice to the method.
    pub frequency_within: Option<f64>,
}

/// Effect of temperature on frequencies, by the file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TemperaturePart {
    /// Nothing.
    #[default]
    Unknown,
    /// One coefficient for all modes.
    Coefficient {
        /// Relative change of every frequency per °C.
        per_c: f64,
        /// Its standard deviation.
        sd_per_c: f64,
    },
    /// A coefficient for each mode, from earlier surveys.
    Fitted,
}

/// One survey: `[survey.NAME]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// The table's name, often the date: "2010-05-12".
    pub name: String,
    /// Anything the author added.
    pub note: Option<String>,
    /// Its publication or archive.
    pub source: Option<String>,
    /// Whether its values are made up: its frequencies count as assumed, and headlines say so.
    pub is_made_up: bool,
    /// Air temperature, °C.
    pub temperature_c: Option<f64>,
    /// The mark that levels and tilts refer to.
    pub datum: Option<String>,
    /// Tilt by direction.
    pub tilt: BTreeMap<String, Tilt>,
    /// Modes by direction ("x", "weak"), as the file lists them.
    pub modes: BTreeMap<String, Vec<SurveyMode>>,
    /// Vibration records to identify modes from.
    pub records: Option<RecordSource>,
    /// Several records with some common sensors, to be merged; empty if there are none.
    pub setups: Vec<RecordSource>,
    /// How to merge them.
    pub merge: Merge,
    /// Damage found by an inspection, in the order of the file.
    pub inspections: Vec<Inspection>,
    /// An earthquake that the structure felt.
    pub earthquake: Option<EarthquakePart>,
}

/// An earthquake as given in a survey.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EarthquakePart {
    /// Largest measured acceleration, m/s².
    pub peak_m_s2: Option<f64>,
    /// Whether the true peak may be larger: a sensor reached the end of its range, or the record misses part of the earthquake.
    pub is_at_least: bool,
    /// Lasting change of a frequency, relative.
    pub changed: Option<f64>,
    /// Its standard deviation.
    pub changed_sd: Option<f64>,
}

/// How to merge several setups.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Merge {
    /// Each is identified separately, then modes are paired and scaled.
    #[default]
    Poser,
    /// Besides, all are identified together, from correlations scaled to a common shaking.
    Preger,
}

impl Survey {
    /// Its source; for made-up values it says so wherever it is quoted.
    pub fn filed_as(&self) -> Option<String> {
        match (self.is_made_up, &self.source) {
            (true, Some(source)) => Some(format!("made up, not measured: {source}")),
            (true, None) => Some("made up, not measured".to_owned()),
            (false, source) => source.clone(),
        }
    }

    /// Its tilt from all directions, horizontal / vertical; 0 without a tilt.
    pub fn tilt_together(&self) -> f64 {
        let squares = self.tilt.values().map(|tilt| tilt.ratio * tilt.ratio);
        squares.sum::<f64>().sqrt()
    }

    /// Translation modes of one direction, for the identification of stiffness; torsion is excluded.
    pub fn measured_modes(&self, direction: &str, pick: Pick<'_>) -> Vec<MeasuredMode> {
        let modes = self.modes.get(direction).into_iter().flatten();
        let translation = modes.filter(|mode| mode.kind == ModeKind::Translation);
        translation.map(|mode| mode.measured(pick)).collect()
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for mode in self.modes.values().flatten() {
            all.push(&mode.frequency);
            all.extend(&mode.damping_ratio);
        }
    }
}
