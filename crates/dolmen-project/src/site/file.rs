//! The keys of a site and of ground motions.

use crate::file_number::{At, NumberRaw};
use schemars::JsonSchema;

/// By what a site is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum CodeRaw {
    /// Korea, general seismic design.
    #[serde(rename = "KDS 17 10 00")]
    Kds17,
    /// Korea, buildings.
    #[serde(rename = "KDS 41 17 00")]
    Kds41,
    /// Eurocode 8.
    #[serde(rename = "EN 1998-1")]
    Eurocode8,
    /// Periods and accelerations of its own.
    #[serde(rename = "table")]
    Table,
}

/// Seismic zone of Korea.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum ZoneRaw {
    /// 0.11 g.
    I,
    /// 0.07 g.
    #[serde(rename = "II")]
    Ii,
}

/// Site class of Korea.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[schemars(extend("x-must-be" = "\"S1\" (rock) to \"S5\" (deep and soft)"))]
pub(super) enum SoilRaw {
    /// Rock.
    S1,
    /// Shallow and stiff.
    S2,
    /// Shallow and soft.
    S3,
    /// Deep and stiff.
    S4,
    /// Deep and soft.
    S5,
    /// Needs a study of the site.
    S6,
}

/// Ground type of Eurocode 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum GroundRaw {
    /// Rock.
    A,
    /// Very dense sand, gravel, very stiff clay.
    B,
    /// Dense sand, gravel, stiff clay.
    C,
    /// Loose soil.
    D,
    /// Some metres of C or D on rock.
    E,
}

/// How often the ground shakes: peaks with their return periods.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct HazardRaw {
    /// Peak accelerations of the ground, rising, with their unit: ["0.06 g", "0.11 g"].
    #[schemars(required)]
    pub(super) peaks: Option<At<Vec<At<NumberRaw>>>>,
    /// Their return periods.
    #[schemars(required)]
    pub(super) return_periods_years: Option<At<Vec<f64>>>,
    /// With one peak: k of the power law rate ~ peak^-k.
    pub(super) k: Option<At<f64>>,
}

/// Where the structure stands, and what an earthquake asks for there.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SiteRaw {
    /// Where it stands, degrees north (WGS 84); with longitude_deg. Needs no code: a place alone asks for nothing.
    pub(super) latitude_deg: Option<At<f64>>,
    /// Degrees east.
    pub(super) longitude_deg: Option<At<f64>>,
    /// The code, or "table".
    pub(super) code: Option<At<CodeRaw>>,
    /// KDS: seismic zone; or zone_factor.
    pub(super) zone: Option<At<ZoneRaw>>,
    /// KDS: Z with its unit, "0.11 g"; or zone.
    pub(super) zone_factor: Option<At<NumberRaw>>,
    /// KDS 17 10 00: 50, 100, 200, 500, 1000, 2400 or 4800.
    pub(super) return_period_years: Option<At<i64>>,
    /// KDS: site class.
    pub(super) soil: Option<At<SoilRaw>>,
    /// EN 1998-1: type of the spectrum, 1 or 2.
    pub(super) spectrum_type: Option<At<i64>>,
    /// EN 1998-1: ground type.
    pub(super) ground: Option<At<GroundRaw>>,
    /// EN 1998-1: reference ground acceleration on type A ground, with its unit: "0.2 g".
    pub(super) ground_acceleration: Option<At<NumberRaw>>,
    /// EN 1998-1: importance factor; 1 if not given.
    pub(super) importance_factor: Option<At<f64>>,
    /// Table: periods, s, rising.
    pub(super) periods_s: Option<At<Vec<f64>>>,
    /// Table: spectral accelerations at these periods, in unit.
    pub(super) accelerations: Option<At<Vec<f64>>>,
    /// Table: text file with a column of periods, s, and one of accelerations in unit, instead of both lists.
    pub(super) file: Option<At<String>>,
    /// Table: unit of its accelerations, "g" or "m/s2".
    pub(super) unit: Option<At<String>>,
    /// Table: peak acceleration of the ground with its unit; that of the table at T = 0 if not given.
    pub(super) peak_ground_acceleration: Option<At<NumberRaw>>,
    /// Table: what it is and who made it.
    pub(super) source: Option<At<String>>,
    /// Damping ratio that the spectrum is read at (a table holds for it alone); 0.05 if not given.
    pub(super) damping_ratio: Option<At<NumberRaw>>,
    /// How often the ground shakes, for the risk; KDS: the code's own return periods if not given.
    pub(super) hazard: Option<At<HazardRaw>>,
    /// Vertical over horizontal acceleration of the ground; that of the code if not given.
    pub(super) vertical_ratio: Option<At<NumberRaw>>,
}

/// The files of a motion, one a component.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MotionFilesRaw {
    /// Along x.
    pub(super) x: Option<At<String>>,
    /// Along y.
    pub(super) y: Option<At<String>>,
    /// Upwards.
    pub(super) z: Option<At<String>>,
}

/// The columns or channels of a file that are the components of a motion, by name or number.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MotionColumnsRaw {
    /// Along x.
    pub(super) x: Option<At<MotionColumnRaw>>,
    /// Along y.
    pub(super) y: Option<At<MotionColumnRaw>>,
    /// Upwards.
    pub(super) z: Option<At<MotionColumnRaw>>,
}

/// A column or channel: its name, or its number from 1, the time counted as a spreadsheet does.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "the column's name, or its number from 1"))]
pub(super) enum MotionColumnRaw {
    Number(u32),
    Name(String),
}

impl MotionColumnRaw {
    /// As it would be named.
    pub(super) fn name(&self) -> String {
        match self {
            MotionColumnRaw::Number(number) => number.to_string(),
            MotionColumnRaw::Name(name) => name.clone(),
        }
    }
}

/// What is done with the peak that a header states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum StatedPeakRaw {
    /// Samples of another are refused.
    Check,
    /// It is passed over.
    Ignore,
}

/// What is done where the files of a motion differ in length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum LengthsRaw {
    /// They are refused.
    Same,
    /// All are cut to the shortest: they begin at one time.
    Shortest,
}

/// A motion of the ground for `dolmen simulate --motion NAME`; what is done to it is done in the order of the keys.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionRaw {
    /// Its files, { x = "…", y = "…", z = "…" }; or file, or built_in.
    pub(super) files: Option<At<MotionFilesRaw>>,
    /// The one file that holds all components, with columns or x_azimuth_deg; a file of one channel is x.
    pub(super) file: Option<At<String>>,
    /// Which column or channel of file, or of each of files, is which component, by name or number: { x = "EW", y = "NS", z = "UD" }.
    pub(super) columns: Option<At<MotionColumnsRaw>>,
    /// Instead of columns, where the channels say which way they point: they are turned so that x points this way, degrees from north,
    /// clockwise; 90 is x to the east.
    pub(super) x_azimuth_deg: Option<At<f64>>,
    /// A motion that Dolmen carries with it: "el-centro-1940-ns"; or files.
    pub(super) built_in: Option<At<String>>,
    /// Unit of the numbers in the files where they do not say it: "g", "gal", "m/s2".
    pub(super) unit: Option<At<String>>,
    /// What the numbers are multiplied by to be in the unit: what one count of a recorder is worth. 1 if not given.
    pub(super) factor: Option<At<f64>>,
    /// Files of responses that networks publish beside miniSEED (SEED RESP), of every channel: they stand for unit and factor.
    pub(super) response: Option<Vec<At<String>>>,
    /// What is done with the peak that a header states where it is not that of the samples: "check", it is refused; "ignore". "check" if
    /// not given.
    pub(super) stated_peak: Option<At<StatedPeakRaw>>,
    /// Time between the samples of the files where they do not say it, s.
    pub(super) sample_step_s: Option<At<f64>>,
    /// What is done where the files differ in length: "same", they are refused; "shortest", all are cut to the shortest. "same" if not
    /// given.
    pub(super) lengths: Option<At<LengthsRaw>>,
    /// Keep only the first seconds.
    pub(super) keep_first_s: Option<At<f64>>,
    /// Bring it to zero within so many seconds at both ends.
    pub(super) taper_s: Option<At<f64>>,
    /// Turn it from x towards y, with its unit: "30 deg".
    pub(super) turn: Option<At<NumberRaw>>,
    /// Multiply all components by this factor; or peak.
    pub(super) scale: Option<At<f64>>,
    /// Multiply all components by the one factor that brings the largest horizontal peak to this, "0.3 g"; or scale.
    pub(super) peak: Option<At<NumberRaw>>,
    /// The record that it is part of: motions of one record count as one motion where a study fits a curve. Motions that share a file are of
    /// one record anyway.
    pub(super) record: Option<At<String>>,
    /// Magnitude of its earthquake, 0 to 10: a study tells whether capacities depend on it besides.
    pub(super) magnitude: Option<At<f64>>,
    /// Its distance from the place, km: a study tells whether capacities depend on it besides.
    pub(super) distance_km: Option<At<f64>>,
    /// Where it comes from.
    pub(super) source: Option<String>,
}
