//! Arguments of motions: those of `dolmen motion`, and those of every verb that takes one.

use crate::cli_language::{column, pair, positive, zone};
use clap::{Args, ValueEnum};
use dolmen::signal::Component;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("to_demand").args(["matched", "suite"]).multiple(true))]
pub(crate) struct GroundMotionVerb {
    /// Files of acceleration (AT2, COSMOS, CSMIP, K-NET, ESM, SAC, miniSEED, CSV), one a component: x, y, z in this order, or
    /// named as in y=FILE; --motion-file says the same
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
    /// Periods over which a spectrum is matched or the mean of a suite follows it, s: 0.1,3 if not given
    #[arg(long, value_name = "S,S", value_parser = pair, requires = "to_demand", conflicts_with = "t1")]
    pub(crate) range: Option<[f64; 2]>,
    /// The same for a structure of this period, s: 0.2 to 2 times it
    #[arg(long, value_name = "S", value_parser = positive, requires = "to_demand")]
    pub(crate) t1: Option<f64>,
    /// Choose so many records of the folder --from, each times a factor, so that their mean spectrum follows the demand of --site
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=200), requires_all = ["from", "site"],
        conflicts_with_all = ["files", "motion_file", "name", "make", "convert", "spectrum", "columns", "channel", "x_azimuth", "scale", "peak", "turn"])]
    pub(crate) suite: Option<u16>,
    /// With --suite: the folder of the records, every format that is read; each horizontal channel is one
    #[arg(long, value_name = "DIR", requires = "suite")]
    pub(crate) from: Option<PathBuf>,
    /// With --suite: smallest and largest factor on a record, 0.25,4 if not given
    #[arg(long, value_name = "LEAST,MOST", value_parser = pair, requires = "suite")]
    pub(crate) factors: Option<[f64; 2]>,
    /// With --suite: most motions of one earthquake, and of one station, where files say them; 2 if not given
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=200), requires = "suite")]
    pub(crate) alike: Option<u16>,
    /// Make a motion instead of reading one; its peak is --peak, its step --sample-step (0.01 s without)
    #[arg(long, value_enum, conflicts_with_all = ["files", "motion_file", "name"])]
    pub(crate) make: Option<Shape>,
    /// Period of a pulse, s
    #[arg(long, value_name = "S", default_value_t = 1.0, allow_negative_numbers = true)]
    pub(crate) period: f64,
    /// Half cycles of a near-fault pulse, above 1
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
    /// Length of noise, s
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

/// Motions that can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Shape {
    /// Half a sine: leaves a velocity
    HalfSine,
    /// One sine: leaves a displacement
    Sine,
    /// One cosine: leaves nothing
    Cosine,
    /// Ricker's wavelet, even
    Ricker,
    /// Ricker's wavelet, odd
    RickerOdd,
    /// Mavroeidis and Papageorgiou's pulse of near faults
    NearFault,
    /// Seeded noise of firm ground (Clough and Penzien) under an envelope
    Noise,
}

#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Motion of the ground")]
pub(crate) struct Motion {
    /// A motion of the project file ([motion.NAME]), or one that Dolmen carries with it, along x: el-centro-1940-ns; or the ground that a survey measured, survey:NAME: its channels above it are set beside the answer
    #[arg(
        long = "motion",
        id = "name",
        value_name = "NAME",
        conflicts_with = "motion_file"
    )]
    pub(crate) motion: Option<String>,
    /// Files of acceleration (AT2, COSMOS, CSMIP, K-NET, ESM, SAC, miniSEED, CSV), one a component: x, y, z in this order, or
    /// named as in y=FILE
    #[arg(long, value_name = "FILE", num_args = 1..=3)]
    pub(crate) motion_file: Vec<String>,
    /// Unit of the numbers in the files where they do not say it: g, gal, m/s2
    #[arg(long, value_name = "UNIT")]
    pub(crate) unit: Option<String>,
    /// Time between the samples of the files where they do not say it, s
    #[arg(long, value_name = "S")]
    pub(crate) sample_step: Option<f64>,
    /// The channel to read of a file of several, by name or number
    #[arg(long, value_name = "NAME", conflicts_with = "x_azimuth")]
    pub(crate) channel: Option<String>,
    /// The columns or channels that are x, y and z, by name or number: x=EW,y=NS,z=UD; of one file, or of each its own
    #[arg(long, value_name = "x=NAME,…", value_delimiter = ',', value_parser = column, conflicts_with_all = ["channel", "x_azimuth"])]
    pub(crate) columns: Vec<(Component, String)>,
    /// What the numbers are multiplied by to be in the unit: what one count of a recorder is worth
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub(crate) factor: f64,
    /// Responses that networks publish beside miniSEED (SEED RESP), of every channel: they stand for --unit and --factor
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["unit", "factor"])]
    pub(crate) response: Vec<String>,
    /// Cut components that begin at one time to the shortest
    #[arg(long)]
    pub(crate) shortest: bool,
    /// Pass over the peak that a header states where it is not that of the samples
    #[arg(long)]
    pub(crate) ignore_stated_peak: bool,
    /// Turn channels that say which way they point so that x points this way, degrees from north, clockwise: 90 is x to the east
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) x_azimuth: Option<f64>,
    /// Take off the polynomial of this degree that fits the acceleration best: 0 the mean
    #[arg(long, value_name = "DEGREE")]
    pub(crate) baseline: Option<usize>,
    /// Take off what lies below this frequency, Hz (Butterworth of order 4, zero phase)
    #[arg(long, value_name = "HZ")]
    pub(crate) high_pass: Option<f64>,
    /// Keep only the first seconds of the motion
    #[arg(long, value_name = "S")]
    pub(crate) keep_first: Option<f64>,
    /// Bring the motion to zero within so many seconds at both ends
    #[arg(long, value_name = "S")]
    pub(crate) taper: Option<f64>,
    /// Turn the motion by so many degrees from x towards y
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) turn: Option<f64>,
    /// Multiply all components by this factor
    #[arg(
        long,
        value_name = "FACTOR",
        conflicts_with = "peak",
        allow_negative_numbers = true
    )]
    pub(crate) scale: Option<f64>,
    /// Multiply all components by the one factor that brings the largest horizontal peak to this: "0.3 g"
    #[arg(long, value_name = "ACCELERATION")]
    pub(crate) peak: Option<String>,
}
