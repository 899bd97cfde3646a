//! Arguments of `dolmen motion`, and those of every verb that takes a motion.

use crate::cli_language::{column, pair, positive, zone};
use clap::{Args, ValueEnum};
use dolmen::signal::Component;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("to_demand").args(["matched", "suite"]).multiple(true))]
pub(crate) struct GroundMotionVerb {
    /// Files of acceleration (AT2, COSMOS, CSMIP, K-NET, ESM, SAC, miniSEED, CSV), one per component: x, y, z in this order,
    /// or named as in y=FILE; the same as --motion-file
    #[arg(conflicts_with_all = ["motion_file", "name"])]
    pub(crate) files: Vec<String>,
    #[command(flatten)]
    pub(crate) motion: Motion,
    /// Compute the response spectrum, 200 periods from 0.02 to 4 s
    #[arg(long)]
    pub(crate) spectrum: bool,
    /// Damping ratio of spectra
    #[arg(long, value_name = "RATIO", default_value_t = 0.05)]
    pub(crate) damping: f64,
    /// Match the first component, or with --suite each motion, to a demand spectrum by wavelets: KDS 17 10 00 of --zone, --years
    /// and --site, or Eurocode 8 of --ground-acceleration and --site
    #[arg(long = "match", requires = "site")]
    pub(crate) matched: bool,
    /// Site of the demand: S1 to S5 (KDS), A to E (Eurocode 8)
    #[arg(long, default_value = "", requires = "to_demand")]
    pub(crate) site: String,
    /// Seismic zone of KDS 17 10 00: 1 (I) or 2 (II)
    #[arg(long, default_value_t = 1, value_parser = zone, requires = "to_demand", conflicts_with = "ground_acceleration")]
    pub(crate) zone: u8,
    /// Return period of KDS 17 10 00, years
    #[arg(
        long,
        default_value_t = 2400,
        requires = "to_demand",
        conflicts_with = "ground_acceleration"
    )]
    pub(crate) years: u32,
    /// Design ground acceleration on rock of Eurocode 8, g
    #[arg(long, value_name = "G", requires = "to_demand")]
    pub(crate) ground_acceleration: Option<f64>,
    /// Type of the spectrum of Eurocode 8: 1 or 2
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=2), requires = "ground_acceleration")]
    pub(crate) spectrum_type: u8,
    /// Periods over which a spectrum is matched, or the mean of a suite follows it, s [default: 0.1,3]
    #[arg(long, value_name = "S,S", value_parser = pair, requires = "to_demand", conflicts_with = "t1")]
    pub(crate) range: Option<[f64; 2]>,
    /// The same for a structure with this period, s: 0.2 to 2 times the period
    #[arg(long, value_name = "S", value_parser = positive, requires = "to_demand")]
    pub(crate) t1: Option<f64>,
    /// Choose this many records from the folder --from, each with a scale factor, so that their mean spectrum follows the demand of --site
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=200), requires_all = ["from", "site"],
        conflicts_with_all = ["files", "motion_file", "name", "make", "convert", "spectrum", "columns", "channel", "x_azimuth", "scale", "peak", "turn"])]
    pub(crate) suite: Option<u16>,
    /// With --suite: the folder of the records, in any format that Dolmen reads; each horizontal channel counts as one record
    #[arg(long, value_name = "DIR", requires = "suite")]
    pub(crate) from: Option<PathBuf>,
    /// With --suite: smallest and largest scale factor of a record [default: 0.25,4]
    #[arg(long, value_name = "LEAST,MOST", value_parser = pair, requires = "suite")]
    pub(crate) factors: Option<[f64; 2]>,
    /// With --suite: most motions from one earthquake, and from one station, if the files name them [default: 2]
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=200), requires = "suite")]
    pub(crate) alike: Option<u16>,
    /// Make a motion instead of reading one, with peak --peak and step --sample-step (default 0.01 s)
    #[arg(long, value_enum, conflicts_with_all = ["files", "motion_file", "name"])]
    pub(crate) make: Option<Shape>,
    /// Period of a pulse, s
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    pub(crate) period: f64,
    /// Number of half cycles of a near-fault pulse, above 1
    #[arg(long, default_value_t = 1.5)]
    pub(crate) gamma: f64,
    /// Phase of a near-fault pulse, degrees
    #[arg(
        long,
        value_name = "DEG",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    pub(crate) phase: f64,
    /// Duration of noise, s
    #[arg(long, value_name = "S", default_value_t = 20.0)]
    pub(crate) duration: f64,
    /// Seed of noise: the same seed gives the same bits
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Write the motion into this file: .csv (all components) or .at2 (one)
    #[arg(long, value_name = "FILE")]
    pub(crate) convert: Option<PathBuf>,
    /// Write figures (SVG), spectrum (CSV) and result (JSON) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// Shapes of made motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Shape {
    /// Half a sine wave; a velocity remains
    HalfSine,
    /// One sine wave; a displacement remains
    Sine,
    /// One cosine wave; nothing remains
    Cosine,
    /// Ricker wavelet, even
    Ricker,
    /// Ricker wavelet, odd
    RickerOdd,
    /// Near-fault pulse of Mavroeidis and Papageorgiou
    NearFault,
    /// Seeded noise of firm ground (Clough and Penzien) with an envelope
    Noise,
}

#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Motion of the ground")]
pub(crate) struct Motion {
    /// A motion of the project file ([motion.NAME]); or a built-in one along x: el-centro-1940-ns; or the ground recorded in a survey,
    /// survey:NAME, whose channels above the ground are then compared with the answer
    #[arg(
        long = "motion",
        id = "name",
        value_name = "NAME",
        conflicts_with = "motion_file"
    )]
    pub(crate) motion: Option<String>,
    /// Files of acceleration (AT2, COSMOS, CSMIP, K-NET, ESM, SAC, miniSEED, CSV), one per component: x, y, z in this order,
    /// or named as in y=FILE
    #[arg(long, value_name = "FILE", num_args = 1..=3)]
    pub(crate) motion_file: Vec<String>,
    /// Unit of the numbers, if the files do not give it: g, gal, m/s2
    #[arg(long, value_name = "UNIT")]
    pub(crate) unit: Option<String>,
    /// Time between samples, if the files do not give it, s
    #[arg(long, value_name = "S")]
    pub(crate) sample_step: Option<f64>,
    /// The channel to read from a file with several, by name or number
    #[arg(long, value_name = "NAME", conflicts_with = "x_azimuth")]
    pub(crate) channel: Option<String>,
    /// Columns or channels for x, y and z, by name or number: x=EW,y=NS,z=UD; in one file, or one in each file
    #[arg(long, value_name = "x=NAME,…", value_delimiter = ',', value_parser = column, conflicts_with_all = ["channel", "x_azimuth"])]
    pub(crate) columns: Vec<(Component, String)>,
    /// Factor that converts the numbers to the unit: the value of one count of a recorder
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub(crate) factor: f64,
    /// Instrument responses that networks publish with miniSEED (SEED RESP), for every channel; they replace --unit and --factor
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["unit", "factor"])]
    pub(crate) response: Vec<String>,
    /// Cut components that begin at the same time to the length of the shortest
    #[arg(long)]
    pub(crate) shortest: bool,
    /// Ignore a peak stated in the header that differs from that of the samples
    #[arg(long)]
    pub(crate) ignore_stated_peak: bool,
    /// Rotate channels with a stated orientation so that x points this way, degrees from north, clockwise: 90 is east
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) x_azimuth: Option<f64>,
    /// Subtract the polynomial of this degree that fits the acceleration best: 0 subtracts the mean
    #[arg(long, value_name = "DEGREE")]
    pub(crate) baseline: Option<usize>,
    /// Remove frequencies below this one, Hz (Butterworth of order 4, zero phase)
    #[arg(long, value_name = "HZ")]
    pub(crate) high_pass: Option<f64>,
    /// Keep only the first seconds of the motion, s
    #[arg(long, value_name = "S")]
    pub(crate) keep_first: Option<f64>,
    /// Taper the motion to zero over this time at both ends, s
    #[arg(long, value_name = "S")]
    pub(crate) taper: Option<f64>,
    /// Rotate the motion by this angle, degrees from x towards y
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) turn: Option<f64>,
    /// Multiply all components by this factor, on top of the scale or peak of the project file
    #[arg(
        long,
        value_name = "FACTOR",
        conflicts_with = "peak",
        allow_negative_numbers = true
    )]
    pub(crate) scale: Option<f64>,
    /// Scale all components so that the largest horizontal peak becomes this: "0.3 g"
    #[arg(long, value_name = "ACCELERATION")]
    pub(crate) peak: Option<String>,
}
