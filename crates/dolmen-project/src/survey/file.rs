//! The keys of surveys and their records.

use crate::damage::InModelRaw;
use crate::file_names::NamesRaw;
use crate::file_number::{At, NumberRaw, QuantityRaw};
use crate::file_way::WayRaw;
use dolmen_records::records::{LostSamples, RecordFormat};
use schemars::JsonSchema;
use std::collections::BTreeMap;

/// What was measured on one occasion.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SurveyRaw {
    /// Anything to add.
    pub(super) note: Option<String>,
    /// Where it was published or filed.
    pub(super) source: Option<String>,
    /// Whether nobody measured it: its numbers are made up, and the headline says so; false if not given.
    pub(super) made_up: Option<At<bool>>,
    /// Air temperature, °C.
    pub(super) temperature_c: Option<At<f64>>,
    /// The mark that levels and tilts refer to.
    pub(super) datum: Option<String>,
    /// Tilt by direction: "1/177", a ratio, or text with a unit ("0.3 deg", "5 mm/m").
    pub(super) tilt: Option<BTreeMap<String, At<NumberRaw>>>,
    /// Frequencies by direction, where nothing else of the modes is known: { x = [4.6] }.
    pub(super) frequencies: Option<BTreeMap<String, Vec<At<QuantityRaw>>>>,
    /// Modes by direction, or a file of them: { file = "modes.uff" }, a universal file or a table.
    pub(super) modes: Option<BTreeMap<String, Vec<At<ModeRaw>>>>,
    /// A vibration record to identify modes from.
    pub(super) records: Option<At<RecordsRaw>>,
    /// Several records, one after the other, with some sensors that stayed: instead of records.
    pub(super) setups: Option<Vec<At<RecordsRaw>>>,
    /// How setups are put together; "poser" if not given.
    pub(super) merge: Option<At<MergeRaw>>,
    /// What an inspection found.
    pub(super) inspections: Option<Vec<At<InspectionRaw>>>,
    /// An earthquake that the structure felt, where no record of it stands here: an alarm until a work or an inspection is entered.
    pub(super) earthquake: Option<At<EarthquakeRaw>>,
}

impl SurveyRaw {
    /// Whether it speaks of parts of the structure.
    pub(crate) fn has_inspections(&self) -> bool {
        self.inspections.as_ref().is_some_and(|listed| !listed.is_empty())
    }
}

/// An earthquake that the structure felt.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct EarthquakeRaw {
    /// Largest acceleration that was measured.
    pub(super) peak: Option<At<QuantityRaw>>,
    /// Whether it may have been larger, since a sensor was clipped or the record misses part of the earthquake; false if not given.
    pub(super) at_least: Option<At<bool>>,
    /// Lasting change of a frequency, relative: -0.02 is a fall by 2 %.
    pub(super) changed: Option<At<f64>>,
    /// Its standard deviation.
    pub(super) changed_sd: Option<At<f64>>,
}

/// How bad what was found is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum SeverityRaw {
    /// To be noted.
    Slight,
    /// To be watched or mended.
    Moderate,
    /// To be mended now.
    Severe,
}

/// One thing that an inspection found.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct InspectionRaw {
    /// The part, by its name.
    #[schemars(required)]
    pub(super) part: Option<At<String>>,
    /// What it is: "crack", "spalling", "exfoliation", "open joint", "tilt", "settlement", "loss", "growth" (균열, 박락, 박리, 이격, 기울기, 침하,
    /// 결손, 생물 피복), or other words.
    #[schemars(required)]
    pub(super) what: Option<At<NamesRaw>>,
    /// What tells it from others of its kind at this part, in every inspection alike: "C1".
    pub(super) name: Option<At<String>>,
    /// Its size: the width of a crack or gap, else the largest extent.
    pub(super) size: Option<At<QuantityRaw>>,
    /// The size that must not be reached; that of the latest inspection which gives one counts.
    pub(super) limit: Option<At<QuantityRaw>>,
    /// How bad it is.
    pub(super) severity: Option<At<SeverityRaw>>,
    /// Where it is: x right, y away, z up; the middle of the part if not given.
    pub(super) at: Option<At<Vec<At<QuantityRaw>>>>,
    /// A photograph of it, JPEG or PNG, relative to the project file.
    pub(super) photo: Option<At<String>>,
    /// Anything to add.
    pub(super) note: Option<At<NamesRaw>>,
    /// What it means for the model; nothing if not given.
    pub(super) model: Option<At<InModelRaw>>,
}

/// How setups are put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum MergeRaw {
    /// Each is identified by itself, then modes are paired and scaled.
    Poser,
    /// All are identified as one, from correlations brought to one shaking.
    Preger,
}

/// How the plan moves in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ModeKindRaw {
    /// Every point of a level moves the same way.
    Translation,
    /// The plan twists: reported, but kept out of fits in one direction.
    Torsion,
}

/// How two surveys are compared.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChangeRaw {
    /// Relative change of every frequency per °C: -0.001 is a fall of 0.1 % per °C.
    pub(super) temperature_coefficient_per_c: Option<At<f64>>,
    /// Its standard deviation; 0 if it is known exactly.
    pub(super) temperature_coefficient_sd_per_c: Option<At<f64>>,
    /// "fitted": a coefficient for each mode from the surveys before the later one, four at least, with temperatures.
    pub(super) temperature: Option<At<TemperatureRaw>>,
    /// Largest relative difference of two frequencies that are taken for one mode; 0.15 if not given.
    pub(super) frequency_within: Option<At<f64>>,
}

/// Where the effect of temperature comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum TemperatureRaw {
    /// A line of least squares through earlier surveys.
    Fitted,
}

/// One mode.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ModeRaw {
    /// Frequency.
    #[schemars(required)]
    pub(super) frequency: Option<At<QuantityRaw>>,
    /// Damping ratio: 0.02 is 2 %.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// "translation" if not given.
    pub(super) kind: Option<ModeKindRaw>,
    /// Of a building, along x or y: rotation of the floor times its radius of gyration over the displacement of its centre of mass.
    pub(super) twist: Option<At<f64>>,
    /// Standard deviation of twist; 0 if not given.
    pub(super) twist_sd: Option<At<f64>>,
    /// Of a building, beside twist: displacement of the centre of mass across the direction of the mode over that along it.
    pub(super) sideways: Option<At<f64>>,
    /// Measured points of the shape.
    pub(super) shape: Option<Vec<At<ShapeRaw>>>,
}

/// One measured point of a mode shape.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ShapeRaw {
    /// Height above the ground (lowest joint).
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Displacement, any scale that all points of the mode share.
    #[schemars(required)]
    pub(super) displacement: Option<At<f64>>,
    /// Standard deviation of the displacement, same scale; 0 if not given.
    pub(super) sd: Option<At<f64>>,
}

/// What is known of the times at which stations begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum StartsRaw {
    /// Each file says it, or begins does.
    Stated,
    /// All begin at one instant.
    Together,
}

/// A column: its name in the header, or its number from 1.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "the column's name, or its number from 1"))]
pub(super) enum ColumnRaw {
    Number(i64),
    Name(String),
}

/// One channel of a record.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ChannelRaw {
    /// Its column.
    #[schemars(required)]
    pub(super) column: Option<At<ColumnRaw>>,
    /// Its name; that of the column if not given.
    pub(super) name: Option<At<String>>,
    /// Place of the sensor: x right, y away, z up.
    pub(super) position: Option<At<Vec<At<QuantityRaw>>>>,
    /// Positive direction of the sensor.
    pub(super) direction: Option<At<WayRaw>>,
    /// What its numbers are multiplied by to be in the unit; that of the record if not given.
    pub(super) scale: Option<At<f64>>,
    /// true reads it but leaves it out (a dead or loose sensor).
    pub(super) leave_out: Option<bool>,
}

/// A stretch of time.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CutRaw {
    /// From, s after the first sample.
    #[schemars(required)]
    pub(super) from_s: Option<At<f64>>,
    /// To, s after the first sample.
    #[schemars(required)]
    pub(super) to_s: Option<At<f64>>,
}

/// Zero-phase band-pass.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct BandPassRaw {
    /// Lower corner, Hz.
    #[schemars(required)]
    pub(super) low_hz: Option<At<f64>>,
    /// Upper corner, Hz.
    #[schemars(required)]
    pub(super) high_hz: Option<At<f64>>,
    /// Order of one pass, 1 to 10; 4 if not given.
    pub(super) order: Option<At<i64>>,
}

/// Zero-phase low-pass.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LowPassRaw {
    /// Corner, Hz.
    #[schemars(required)]
    pub(super) corner_hz: Option<At<f64>>,
    /// Order of one pass, 1 to 10; 4 if not given.
    pub(super) order: Option<At<i64>>,
}

/// What is done to a record before it is used, in the order of these keys.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ConditioningRaw {
    /// Keep only this time.
    pub(super) cut: Option<At<CutRaw>>,
    /// Remove a polynomial of this degree: 0 mean, 1 line.
    pub(super) detrend_degree: Option<At<i64>>,
    /// Band-pass.
    pub(super) band_pass: Option<At<BandPassRaw>>,
    /// Low-pass.
    pub(super) low_pass: Option<At<LowPassRaw>>,
    /// Keep each such sample after an anti-alias filter.
    pub(super) decimate_factor: Option<At<i64>>,
}

/// How modes are found in a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(super) enum MethodRaw {
    /// Peaks of the spectrum, without damping.
    Fdd,
    /// Peaks of the spectrum, damping from the singular values about each.
    Efdd,
    /// Peaks of the spectrum, damping from the spectrum along each shape.
    Fsdd,
    /// Covariance-driven subspace method.
    SsiCov,
    /// Data-driven subspace method.
    SsiData,
    /// Covariance-driven subspace method, its modes fitted to the Fourier lines about them.
    Bayoma,
    /// Poly-reference least squares on half spectra.
    Plscf,
    /// Free decay: the record begins when the last force has ended.
    Era,
    /// Observer/Kalman filter identification with the channels of `inputs` as what drives the others: the modes on a base that is held.
    Okid,
}

/// What becomes of a mode that looks like a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum HarmonicsRaw {
    /// It stays and is named.
    Flag,
    /// It is left out and named.
    Remove,
}

/// Whether a record is looked through for an earthquake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum EarthquakeChoiceRaw {
    /// It is, and where it holds one, modes are those of the part after it or before it.
    Sought,
    /// It is not: the record is ambient vibration whatever it looks like.
    None,
}

/// How modes are identified; what is not given is chosen from the record.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ModalRaw {
    /// Lowest frequency of interest, Hz.
    pub(super) frequency_low_hz: Option<At<f64>>,
    /// Highest frequency of interest, Hz.
    pub(super) frequency_high_hz: Option<At<f64>>,
    /// Least damping ratio of a mode; if not given, as little as the record can show: 0.0005 to 0.002. What is damped less is left out.
    pub(super) damping_least: Option<At<f64>>,
    /// Largest damping ratio of a mode; 0.15 if not given.
    pub(super) damping_most: Option<At<f64>>,
    /// Largest model order.
    pub(super) order_most: Option<At<i64>>,
    /// Block rows of the Hankel matrix.
    pub(super) block_rows: Option<At<i64>>,
    /// How many modes to report, lowest first.
    pub(super) modes_wanted: Option<At<i64>>,
    /// The method; "ssi-cov" if not given.
    pub(super) method: Option<MethodRaw>,
    /// Reference channels of the subspace methods, by name; all if not given.
    pub(super) references: Option<Vec<At<String>>>,
    /// Channels that drive the others, by name: the ground, a shaker. The method is then "okid".
    pub(super) inputs: Option<Vec<At<String>>>,
    /// Frequencies at which modes are picked by hand, Hz; all modes if not given.
    pub(super) pick_hz: Option<Vec<At<f64>>>,
    /// Frequencies of modes that the user insists on, Hz: what stands within 3 % of each and the tests refused becomes a mode, marked as accepted.
    pub(super) accept: Option<Vec<At<f64>>>,
    /// Modes that look like machines: "flag" if not given.
    pub(super) harmonics: Option<HarmonicsRaw>,
    /// Whether an earthquake is sought in the record: "sought" if not given.
    pub(super) earthquake: Option<EarthquakeChoiceRaw>,
    /// The channel whose spectrogram is drawn, by name; the one that moves most in the range if not given.
    pub(super) spectrogram: Option<At<String>>,
}

/// A file of a record that lies in several.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StationRaw {
    /// Path relative to the project file.
    #[schemars(required)]
    pub(super) file: Option<At<String>>,
    /// Format; from the file name's ending if not given.
    pub(super) format: Option<At<RecordFormat>>,
    /// The first sample, where the file does not say it: "2024-06-05T10:00:00.25", or seconds in a clock that all stations share.
    pub(super) begins: Option<At<NumberRaw>>,
    /// Samples a second; from the file if not given.
    pub(super) sampling_rate: Option<At<QuantityRaw>>,
    /// Unit of the samples: "m/s2", "g", "gal", "mm/s", "mm".
    pub(super) unit: Option<At<String>>,
    /// What the numbers are multiplied by to be in the unit.
    pub(super) scale: Option<At<f64>>,
    /// What separates columns, one character; found from the file if not given.
    pub(super) delimiter: Option<At<String>>,
    /// The column of time stamps.
    pub(super) time_column: Option<At<ColumnRaw>>,
    /// What becomes of it if it lost samples: "fill" (short gaps are filled in, then as "longest"; if not given), "longest" (the longest whole span is used, with a warning) or "refuse".
    pub(super) lost_samples: Option<At<LostSamples>>,
    /// The channels; all of the file if not given.
    pub(super) channels: Option<Vec<At<ChannelRaw>>>,
}

/// A record file, or several that make one record.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RecordsRaw {
    /// Path relative to the project file.
    pub(super) file: Option<At<String>>,
    /// Several files that make one record, instead of file.
    pub(super) stations: Option<Vec<At<StationRaw>>>,
    /// What is known of the times at which stations begin; "stated" if not given.
    pub(super) starts: Option<At<StartsRaw>>,
    /// Format; from the file name's ending if not given.
    pub(super) format: Option<At<RecordFormat>>,
    /// Samples a second; from the time column if not given.
    pub(super) sampling_rate: Option<At<QuantityRaw>>,
    /// Unit of the samples: "m/s2", "g", "gal", "mm/s", "mm".
    pub(super) unit: Option<At<String>>,
    /// What the numbers are multiplied by to be in the unit: what a count is worth, or full scale of a WAV file.
    pub(super) scale: Option<At<f64>>,
    /// What separates columns, one character; found from the file if not given.
    pub(super) delimiter: Option<At<String>>,
    /// The column of time stamps.
    pub(super) time_column: Option<At<ColumnRaw>>,
    /// What becomes of it if it lost samples: "fill" (short gaps are filled in, then as "longest"; if not given), "longest" (the longest whole span is used, with a warning) or "refuse".
    pub(super) lost_samples: Option<At<LostSamples>>,
    /// The channels; every column but the time if not given.
    pub(super) channels: Option<Vec<At<ChannelRaw>>>,
    /// What is done to the record before it is used.
    pub(super) conditioning: Option<ConditioningRaw>,
    /// How modes are identified.
    pub(super) modal: Option<ModalRaw>,
}
