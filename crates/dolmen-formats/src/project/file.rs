//! The file as it is written: what serde reads and what the JSON schema describes. Every key is optional here, so
//! that one problem does not hide the next; which keys are required stands in the schema, where the check against
//! the schema finds it.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor, value::MapAccessDeserializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// A value and its place in the text.
#[derive(Clone, Debug)]
pub(super) struct At<T> {
    pub(super) span: Range<usize>,
    pub(super) value: T,
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for At<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let spanned = toml::Spanned::<T>::deserialize(deserializer)?;
        Ok(At {
            span: spanned.span(),
            value: spanned.into_inner(),
        })
    }
}

impl<T: JsonSchema> JsonSchema for At<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }

    // Not that of T: schemars would take T inside At<T> for a recursion.
    fn schema_id() -> Cow<'static, str> {
        format!("At<{}>", T::schema_id()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        generator.subschema_for::<T>()
    }
}

/// A Dolmen project file: one structure with its surveys and variants.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Dolmen project")]
pub(super) struct FileRaw {
    /// Version of the file format: 1.
    #[schemars(required)]
    pub(super) schema: Option<At<i64>>,
    /// What the file models.
    #[schemars(required)]
    pub(super) kind: Option<At<KindRaw>>,
    /// Name of the structure: text, or { en = "…", ko = "…" }.
    #[schemars(required)]
    pub(super) name: Option<At<NamesRaw>>,
    /// What it is, in a sentence or two.
    pub(super) description: Option<String>,
    /// Where the numbers come from.
    pub(super) source: Option<String>,
    /// Units of bare numbers; SI where none is given.
    pub(super) units: Option<UnitsRaw>,
    /// Acceleration of gravity that turns weights into masses, m/s² unless units.acceleration says otherwise;
    /// 9.80665 if not given.
    pub(super) gravity: Option<At<QuantityRaw>>,
    /// Paths of values that look like unit slips but are right: ["links[5].weight"].
    pub(super) allow: Option<Vec<At<String>>>,
    /// kind = "chain": the links, lowest first.
    pub(super) links: Option<At<Vec<At<LinkRaw>>>>,
    /// kind = "chain": the joint below each link, lowest first, or "unknown".
    pub(super) joints: Option<At<OrUnknown<JointRaw>>>,
    /// kind = "chain": whether the part at the very top (cap stone, finial) is among the links; "included" if not
    /// given.
    pub(super) cap: Option<At<CapRaw>>,
    /// kind = "frame": the storeys, lowest first.
    pub(super) storeys: Option<At<Vec<At<StoreyRaw>>>>,
    /// kind = "frame": what axial_force of a storey is: "storey", the force in its columns (its own level and all
    /// above), or "level", the load added at its top.
    pub(super) axial: Option<At<AxialRaw>>,
    /// kind = "frame": what the stiffness acts on; "drift" if not given.
    pub(super) convention: Option<At<ConventionRaw>>,
    /// kind = "frame": directions by name; each is a frame of its own with the same storeys.
    pub(super) direction: Option<BTreeMap<String, At<DirectionRaw>>>,
    /// What was measured, by occasion: [survey.2010-05-12].
    pub(super) survey: Option<BTreeMap<String, At<SurveyRaw>>>,
}

/// What a file models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum KindRaw {
    /// Rigid links on rotational springs: flagpole, column of drums.
    Chain,
    /// Rigid storeys on lateral springs with P-delta: gate, pavilion.
    Frame,
    /// Measured but not modelled: records and modes only.
    Survey,
}

#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NamesTable {
    /// English.
    pub(super) en: Option<String>,
    /// Korean.
    pub(super) ko: Option<String>,
}

/// A name in one or two languages.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum NamesRaw {
    One(String),
    Table(NamesTable),
}

/// Units of bare numbers.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct UnitsRaw {
    /// Length, height, centroid, breadth, bed_width, position; default "m".
    pub(super) length: Option<At<String>>,
    /// weight, axial_force; default "N".
    pub(super) force: Option<At<String>>,
    /// mass; default "kg".
    pub(super) mass: Option<At<String>>,
    /// stiffness of joints (default "N*m/rad") or of storeys (default "N/m").
    pub(super) stiffness: Option<At<String>>,
    /// damping of joints; default "N*m*s/rad".
    pub(super) damping: Option<At<String>>,
    /// inertia; default "kg*m2".
    pub(super) inertia: Option<At<String>>,
    /// frequency, frequencies, sampling_rate; default "Hz".
    pub(super) frequency: Option<At<String>>,
    /// gravity; default "m/s2".
    pub(super) acceleration: Option<At<String>>,
}

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum EvidenceRaw {
    /// Measured on this structure.
    Measured,
    /// A test on material or joints of this kind.
    Test,
    /// Published.
    Literature,
    /// Nobody has measured it.
    Assumed,
}

/// A number, or text with a unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NumberRaw {
    Number(f64),
    Text(String),
}

/// A quantity: a bare number, text with a unit, or a table.
#[derive(Debug)]
pub(super) enum QuantityRaw {
    Plain(NumberRaw),
    Table(Box<QuantityTable>),
}

/// A number with what is known of it.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct QuantityTable {
    /// The number, bare or as text with its unit.
    #[schemars(required)]
    pub(super) value: Option<At<NumberRaw>>,
    /// Unit of a bare value.
    pub(super) unit: Option<At<String>>,
    /// Coefficient of variation, standard deviation / mean, 0 to 1.
    pub(super) cov: Option<At<f64>>,
    /// Standard deviation instead of cov, in the unit of value.
    pub(super) sd: Option<At<f64>>,
    /// Where it comes from.
    pub(super) source: Option<EvidenceRaw>,
    /// Where cov or sd comes from, if not from the same source.
    pub(super) cov_source: Option<EvidenceRaw>,
    /// Anything to add.
    pub(super) note: Option<String>,
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = NumberRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or text with a unit")
    }

    fn visit_i64<E>(self, number: i64) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<NumberRaw, E> {
        Ok(NumberRaw::Text(text.to_owned()))
    }
}

impl<'de> Deserialize<'de> for NumberRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

impl JsonSchema for NumberRaw {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [{ "type": "number" }, { "type": "string" }],
            "x-must-be": "a number, or text with its unit (\"38.95 kN\")",
        })
    }
}

struct QuantityVisitor;

impl<'de> Visitor<'de> for QuantityVisitor {
    type Value = QuantityRaw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, text with a unit, or a table with value")
    }

    fn visit_i64<E>(self, number: i64) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Number(number as f64)))
    }

    fn visit_f64<E>(self, number: f64) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Number(number)))
    }

    fn visit_str<E>(self, text: &str) -> Result<QuantityRaw, E> {
        Ok(QuantityRaw::Plain(NumberRaw::Text(text.to_owned())))
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<QuantityRaw, M::Error> {
        let table = QuantityTable::deserialize(MapAccessDeserializer::new(map))?;
        Ok(QuantityRaw::Table(Box::new(table)))
    }
}

impl<'de> Deserialize<'de> for QuantityRaw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(QuantityVisitor)
    }
}

impl JsonSchema for QuantityRaw {
    fn schema_name() -> Cow<'static, str> {
        "Quantity".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<QuantityTable>();
        json_schema!({
            "anyOf": [{ "type": "number" }, { "type": "string" }, table],
            "x-must-be":
                "a number, text with its unit (\"38.95 kN\"), or a table { value = …, cov = …, source = … }",
        })
    }
}

/// A list, or "unknown".
#[derive(Debug)]
pub(super) enum OrUnknown<T> {
    Unknown,
    Known(Vec<At<T>>),
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for OrUnknown<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ListVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for ListVisitor<T> {
            type Value = OrUnknown<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list, or \"unknown\"")
            }

            fn visit_str<E>(self, _: &str) -> Result<OrUnknown<T>, E> {
                Ok(OrUnknown::Unknown)
            }

            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<OrUnknown<T>, A::Error> {
                let mut all = Vec::new();
                while let Some(one) = list.next_element()? {
                    all.push(one);
                }
                Ok(OrUnknown::Known(all))
            }
        }
        deserializer.deserialize_any(ListVisitor(std::marker::PhantomData))
    }
}

impl<T: JsonSchema> JsonSchema for OrUnknown<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{}OrUnknown", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let items = generator.subschema_for::<T>();
        json_schema!({
            "anyOf": [{ "const": "unknown" }, { "type": "array", "items": items }],
            "x-must-be": "a list, lowest first, or \"unknown\"",
        })
    }
}

/// One rigid link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LinkRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Weight, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Mass; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Length from joint to joint.
    #[schemars(required)]
    pub(super) length: Option<At<QuantityRaw>>,
    /// Height of the centre of mass above the link's lower joint.
    #[schemars(required)]
    pub(super) centroid: Option<At<QuantityRaw>>,
    /// Moment of inertia about the centre of mass; that of a thin rod if neither it nor breadth is given.
    pub(super) inertia: Option<At<QuantityRaw>>,
    /// Breadth in the direction of motion: the inertia is then that of a box.
    pub(super) breadth: Option<At<QuantityRaw>>,
    /// Width of the bed below it in the direction of motion: for the uplift limit of its lower joint.
    pub(super) bed_width: Option<At<QuantityRaw>>,
}

/// The joint below a link.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct JointRaw {
    /// Rotational stiffness.
    #[schemars(required)]
    pub(super) stiffness: Option<At<QuantityRaw>>,
    /// Rotational dashpot.
    pub(super) damping: Option<At<QuantityRaw>>,
    /// Width of the bed in the direction of motion; the same as bed_width of the link above it.
    pub(super) bed_width: Option<At<QuantityRaw>>,
}

/// Whether the part at the very top is among the links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
pub(super) enum CapRaw {
    /// There is none, or it is among the links.
    #[serde(rename = "included")]
    Included,
    /// It is left out: unconservative, and every result says so.
    #[serde(rename = "left out")]
    LeftOut,
}

/// One storey.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StoreyRaw {
    /// What people call it.
    pub(super) name: Option<String>,
    /// Mass at its top; or weight.
    pub(super) mass: Option<At<QuantityRaw>>,
    /// Weight at its top, a force; or mass.
    pub(super) weight: Option<At<QuantityRaw>>,
    /// Column height.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Axial force as axial says; from the masses if none is given; 0 leaves P-delta out.
    pub(super) axial_force: Option<At<QuantityRaw>>,
}

/// What axial_force is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum AxialRaw {
    /// The force in the columns of the storey: its own level and all above.
    Storey,
    /// The load added at its top.
    Level,
}

/// What the stiffness acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ConventionRaw {
    /// The storey drift.
    Drift,
    /// The displacement relative to the ground.
    Grounded,
}

/// One horizontal direction of a frame.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct DirectionRaw {
    /// Lateral stiffness of each storey, lowest first, or "unknown".
    #[schemars(required)]
    pub(super) stiffness: Option<At<OrUnknown<QuantityRaw>>>,
}

/// What was measured on one occasion.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SurveyRaw {
    /// Anything to add.
    pub(super) note: Option<String>,
    /// Where it was published or filed.
    pub(super) source: Option<String>,
    /// Air temperature, °C.
    pub(super) temperature_c: Option<At<f64>>,
    /// The mark that levels and tilts refer to.
    pub(super) datum: Option<String>,
    /// Tilt by direction: "1/177", a ratio, or text with a unit ("0.3 deg", "5 mm/m").
    pub(super) tilt: Option<BTreeMap<String, At<NumberRaw>>>,
    /// Frequencies by direction, where nothing else of the modes is known: { x = [4.6] }.
    pub(super) frequencies: Option<BTreeMap<String, Vec<At<QuantityRaw>>>>,
    /// Modes by direction.
    pub(super) modes: Option<BTreeMap<String, Vec<At<ModeRaw>>>>,
    /// A vibration record to identify modes from.
    pub(super) records: Option<At<RecordsRaw>>,
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

/// Format of a record file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum RecordFormatRaw {
    /// Text columns.
    Csv,
    /// NumPy array of two dimensions.
    Npy,
}

/// A column: its name in the header, or its number from 1.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "the column's name, or its number from 1"))]
pub(super) enum ColumnRaw {
    Number(i64),
    Name(String),
}

/// A direction: "x", "-y", "z", or a vector.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" or three numbers"))]
pub(super) enum WayRaw {
    Axis(String),
    Vector(Vec<f64>),
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

/// How modes are identified; what is not given is chosen from the record.
#[derive(Debug, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ModalRaw {
    /// Lowest frequency of interest, Hz.
    pub(super) frequency_low_hz: Option<At<f64>>,
    /// Highest frequency of interest, Hz.
    pub(super) frequency_high_hz: Option<At<f64>>,
    /// Largest model order.
    pub(super) order_most: Option<At<i64>>,
    /// Block rows of the Hankel matrix.
    pub(super) block_rows: Option<At<i64>>,
    /// How many modes to report, lowest first.
    pub(super) modes_wanted: Option<At<i64>>,
}

/// A record file.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RecordsRaw {
    /// Path relative to the project file.
    #[schemars(required)]
    pub(super) file: Option<At<String>>,
    /// Format; from the file name's ending if not given.
    pub(super) format: Option<At<RecordFormatRaw>>,
    /// Samples a second; from the time column if not given.
    pub(super) sampling_rate: Option<At<QuantityRaw>>,
    /// Unit of the samples: "m/s2", "g", "gal", "mm/s", "mm".
    pub(super) unit: Option<At<String>>,
    /// What separates columns, one character; found from the file if not given.
    pub(super) delimiter: Option<At<String>>,
    /// The column of time stamps.
    pub(super) time_column: Option<At<ColumnRaw>>,
    /// The channels; every column but the time if not given.
    pub(super) channels: Option<Vec<At<ChannelRaw>>>,
    /// What is done to the record before it is used.
    pub(super) conditioning: Option<ConditioningRaw>,
    /// How modes are identified.
    pub(super) modal: Option<ModalRaw>,
}
