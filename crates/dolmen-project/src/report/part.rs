//! The report's own contents, read.

use crate::names::Names;
use crate::quantity::Quantity;

/// The contents that the engineer gives for a report: `[report]`. Missing ones are left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReportPart {
    /// Title of the report.
    pub title: Option<Names>,
    /// Number of the document.
    pub number: Option<Names>,
    /// The client.
    pub client: Option<Names>,
    /// The organisation that writes it.
    pub organisation: Option<Names>,
    /// Address of the organisation.
    pub address: Option<Names>,
    /// "2026-11-23".
    pub date: Option<String>,
    /// Participants.
    pub authors: Vec<Author>,
    /// Its purpose.
    pub purpose: Option<Names>,
    /// Where the structure stands.
    pub location: Option<Location>,
    /// Photographs.
    pub photos: Vec<PhotoPart>,
    /// Drawings.
    pub drawings: Vec<PhotoPart>,
    /// Tests of material.
    pub material_tests: Vec<MaterialTest>,
    /// Sensors.
    pub sensors: Vec<SensorPart>,
    /// The opinion, one paragraph each.
    pub opinion: Vec<Names>,
    /// A point each.
    pub recommendations: Vec<Names>,
    /// A point each.
    pub maintenance: Vec<Names>,
    /// The grade.
    pub grade: Option<Grade>,
}

/// A participant.
#[derive(Clone, Debug, PartialEq)]
pub struct Author {
    /// Name.
    pub name: Names,
    /// Role.
    pub role: Option<Names>,
    /// Qualification and number.
    pub licence: Option<Names>,
}

/// Where the structure stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Location {
    /// Address.
    pub address: Option<Names>,
    /// Latitude and longitude, degrees.
    pub degrees: Option<[f64; 2]>,
}

/// A photograph or drawing, not yet read.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotoPart {
    /// Relative to the project file.
    pub file: String,
    /// Its caption.
    pub caption: Option<Names>,
    /// The part in the picture.
    pub of: Option<String>,
    /// Its path in the project file: `report.photos[2].file`.
    pub path: String,
}

/// Test method of a material, with the reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MaterialMethod {
    /// Velocity of ultrasonic pulses, m/s.
    Ultrasonic(Option<f64>),
    /// Mean rebound number.
    Rebound(Option<f64>),
}

/// One test of material.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialTest {
    /// The method, and the reading.
    pub method: MaterialMethod,
    /// The part.
    pub part: Option<String>,
    /// "2026-04-02".
    pub date: Option<String>,
    /// Compressive strength, Pa.
    pub strength: Option<Quantity>,
    /// A note.
    pub note: Option<Names>,
}

/// A sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorPart {
    /// Description of the sensor.
    pub name: Names,
    /// Maker and model.
    pub model: Option<Names>,
    /// Serial number.
    pub serial: Option<Names>,
    /// Day of its calibration.
    pub calibrated: Option<String>,
    /// Number of the certificate.
    pub certificate: Option<Names>,
}

/// A grade of the Korean periodic inspection of heritage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PeriodicGrade {
    /// Good.
    A,
    /// Minor repair.
    B,
    /// Observe.
    C,
    /// Detailed diagnosis.
    D,
    /// Repair.
    E,
    /// Immediate action.
    F,
}

impl PeriodicGrade {
    /// The grade of a letter, "A" to "F".
    pub(super) fn of_letter(letter: &str) -> Option<Self> {
        match letter {
            "A" => Some(PeriodicGrade::A),
            "B" => Some(PeriodicGrade::B),
            "C" => Some(PeriodicGrade::C),
            "D" => Some(PeriodicGrade::D),
            "E" => Some(PeriodicGrade::E),
            "F" => Some(PeriodicGrade::F),
            _ => None,
        }
    }
}

/// The scale of a grade.
#[derive(Clone, Debug, PartialEq)]
pub enum GradeScale {
    /// The six words of the Korean periodic inspection of heritage, A to F.
    Periodic(PeriodicGrade),
    /// A different scale.
    Other(Names),
}

/// A grade that the engineer gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Grade {
    /// "C".
    pub value: Names,
    /// Its scale.
    pub scale: GradeScale,
    /// Reason.
    pub reason: Names,
}

impl ReportPart {
    /// The photographs, then the drawings.
    pub fn images(&self) -> impl Iterator<Item = &PhotoPart> {
        self.photos.iter().chain(&self.drawings)
    }
}
