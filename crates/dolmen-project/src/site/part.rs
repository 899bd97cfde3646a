//! The site and the ground motions of a project file.

use dolmen::assess::demand::{Site, SiteDemand, site_demand};
use dolmen::assess::{AssessError, Hazard};
use dolmen::signal::Component;

/// A place on the earth (WGS 84).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Degrees north.
    pub latitude_deg: f64,
    /// Degrees east.
    pub longitude_deg: f64,
}

/// Location of the structure, and the code of its site: `[site]`.
#[derive(Clone, Debug, PartialEq)]
pub struct SitePart {
    /// The code with its numbers, or a table.
    pub site: Site,
    /// Damping ratio ζ of the spectrum.
    pub damping_ratio: f64,
    /// Vertical over horizontal acceleration; `None`: that of the code.
    pub vertical_ratio: Option<f64>,
    /// Rates of ground shaking at the site: from the file, or by the return periods of KDS 17 10 00.
    pub hazard: Option<HazardPart>,
}

/// Annual rates at which peak ground accelerations are exceeded.
#[derive(Clone, Debug, PartialEq)]
pub struct HazardPart {
    /// Intensities in m/s².
    pub curve: Hazard,
    /// Source of the rates.
    pub source: HazardSource,
}

/// Source of a hazard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HazardSource {
    /// The file.
    File,
    /// The return periods of KDS 17 10 00, soil included.
    Kds17,
}

impl SitePart {
    /// Seismic demand at the site.
    ///
    /// # Errors
    /// None for the site of a file that was read: reading has computed the demand once.
    pub fn demand(&self) -> Result<SiteDemand, AssessError> {
        site_demand(&self.site, self.damping_ratio, self.vertical_ratio)
    }
}

/// Source of a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionSource {
    /// Files relative to the project, one for each component; the same file repeated where components are its columns.
    Files(Vec<(Component, String)>),
    /// A built-in motion of the program, by name.
    BuiltIn(String),
}

/// How a motion is scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MotionSize {
    /// All components are multiplied by this factor.
    Scale(f64),
    /// All components are multiplied by one factor, so that the largest horizontal peak has this value, m/s².
    Peak(f64),
}

/// A ground motion: `[motion.NAME]`. The fields are applied in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionPart {
    /// The table's name.
    pub name: String,
    /// Its files, or the name of a built-in motion.
    pub from: MotionSource,
    /// The column or channel of each component's file, by name or number, where the file gives it.
    pub columns: Vec<(Component, String)>,
    /// Direction of x, degrees clockwise from north, for channels that state their direction.
    pub x_azimuth_deg: Option<f64>,
    /// Factor from the numbers to the unit.
    pub factor: Option<f64>,
    /// Response files (RESP), relative to the project: the value of a count of each channel.
    pub responses: Vec<String>,
    /// Whether to ignore the peak stated in a header.
    pub ignores_stated_peak: bool,
    /// Unit of the numbers in the files; `None` where the files state it.
    pub unit: Option<String>,
    /// Time between samples of the files, s; `None` where the files state it.
    pub sample_step_s: Option<f64>,
    /// Whether files of different lengths are cut to the shortest.
    pub cut_to_shortest: bool,
    /// Keep only the first seconds.
    pub keep_first_s: Option<f64>,
    /// Length of the taper to zero at both ends, s.
    pub taper_s: Option<f64>,
    /// Rotation from x towards y, rad.
    pub turn_rad: Option<f64>,
    /// Its scaling; `None`: unchanged.
    pub size: Option<MotionSize>,
    /// The record that it belongs to, where the file states it.
    pub record: Option<String>,
    /// Magnitude of its earthquake, where the file states it.
    pub magnitude: Option<f64>,
    /// Distance of its earthquake, km, where the file states it.
    pub distance_km: Option<f64>,
    /// Its source, in words.
    pub source: Option<String>,
}

impl MotionPart {
    /// Whether two motions belong to one record: they name the same record, share a file, or are the same built-in motion.
    pub fn is_of_one_record(&self, other: &MotionPart) -> bool {
        let is_named = self.record.is_some() && self.record == other.record;
        let shares = match (&self.from, &other.from) {
            (MotionSource::Files(own), MotionSource::Files(others)) => own
                .iter()
                .any(|(_, file)| others.iter().any(|(_, other)| other == file)),
            (MotionSource::BuiltIn(own), MotionSource::BuiltIn(other)) => own == other,
            _ => false,
        };
        is_named || shares
    }
}
