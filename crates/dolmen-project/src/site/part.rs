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

/// Where the structure stands, and by what it is judged: `[site]`.
#[derive(Clone, Debug, PartialEq)]
pub struct SitePart {
    /// The code with its numbers, or a table.
    pub site: Site,
    /// ζ that the spectrum is read at.
    pub damping_ratio: f64,
    /// Vertical over horizontal acceleration; `None`: that of the code.
    pub vertical_ratio: Option<f64>,
    /// How often the ground shakes there: as written, or by the return periods of KDS 17 10 00.
    pub hazard: Option<HazardPart>,
}

/// How often the peak acceleration of the ground is exceeded.
#[derive(Clone, Debug, PartialEq)]
pub struct HazardPart {
    /// Intensities in m/s².
    pub curve: Hazard,
    /// Where it comes from.
    pub source: HazardSource,
}

/// Where a hazard comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HazardSource {
    /// The file.
    File,
    /// The return periods of KDS 17 10 00, soil included.
    Kds17,
}

impl SitePart {
    /// What an earthquake asks for there.
    ///
    /// # Errors
    /// None for the site of a file that was read: it has been asked then.
    pub fn demand(&self) -> Result<SiteDemand, AssessError> {
        site_demand(&self.site, self.damping_ratio, self.vertical_ratio)
    }
}

/// Where a motion comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionSource {
    /// Files, relative to the project, one a component; the same file for several where they are columns of it.
    Files(Vec<(Component, String)>),
    /// One that the program carries with it, by name.
    BuiltIn(String),
}

/// How large a motion is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MotionSize {
    /// All components times this.
    Scale(f64),
    /// All components times the one factor that brings the largest horizontal peak to this, m/s².
    Peak(f64),
}

/// A motion of the ground: `[motion.NAME]`. What is done to it is done in the order of the fields.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionPart {
    /// The table's name.
    pub name: String,
    /// Its files, or what it is called.
    pub from: MotionSource,
    /// The column or channel of each component's file, by name or number, where the file gives it.
    pub columns: Vec<(Component, String)>,
    /// Where x points, degrees from north, clockwise, of channels that say which way they point.
    pub x_azimuth_deg: Option<f64>,
    /// What the numbers are multiplied by to be in the unit.
    pub factor: Option<f64>,
    /// Files of responses (RESP), relative to the project: what a count of each channel is worth.
    pub responses: Vec<String>,
    /// Whether the peak that a header states is passed over.
    pub ignores_stated_peak: bool,
    /// Unit of the numbers in the files; `None` where they say it.
    pub unit: Option<String>,
    /// Between the samples of the files, s; `None` where they say it.
    pub sample_step_s: Option<f64>,
    /// Whether files of different lengths are cut to the shortest.
    pub cut_to_shortest: bool,
    /// Keep only the first seconds.
    pub keep_first_s: Option<f64>,
    /// Bring it to zero within so many seconds at both ends.
    pub taper_s: Option<f64>,
    /// Turn it from x towards y, rad.
    pub turn_rad: Option<f64>,
    /// How large it is made; `None`: as it is.
    pub size: Option<MotionSize>,
    /// The record that it is part of, where the file says it.
    pub record: Option<String>,
    /// Magnitude of its earthquake, where the file says it.
    pub magnitude: Option<f64>,
    /// Distance of its earthquake, km, where the file says it.
    pub distance_km: Option<f64>,
    /// Where it comes from, in words.
    pub source: Option<String>,
}

impl MotionPart {
    /// Whether two motions are of one record: they name the same record, share a file, or are the same motion that Dolmen carries.
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
