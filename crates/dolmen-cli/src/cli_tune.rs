//! Arguments of `dolmen tune`.

use crate::cli_language::positive;
use clap::builder::TypedValueParser as _;
use clap::{Args, ValueEnum};
use dolmen_work::building::TuneFloors;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct Tune {
    /// Project file of a building with dampers, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Only this damper, [damper.NAME]; by default all
    #[arg(long, value_name = "NAME")]
    pub(crate) damper: Option<String>,
    /// Dampers of this variant; by default those of the file, or of all its variants if the file itself has none
    #[arg(long, value_name = "NAME")]
    pub(crate) variant: Option<String>,
    /// The random load
    #[arg(long, value_enum, default_value_t = TuneLoad::Force)]
    pub(crate) load: TuneLoad,
    /// Corner frequency of the gust force, Hz
    #[arg(long, value_name = "HZ", default_value_t = 0.05, value_parser = positive)]
    pub(crate) corner: f64,
    /// Frequency of the soil under --load ground, Hz
    #[arg(long, value_name = "HZ", default_value_t = 2.5, value_parser = positive)]
    pub(crate) ground: f64,
    /// Direction of the load, degrees from x counter-clockwise; by default that of the damper
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) load_direction: Option<f64>,
    /// The quantity to minimise, over the points of the file or, if it has none, the corners of the damper's floor
    #[arg(long, value_enum, default_value_t = TuneGoal::LargestRms)]
    pub(crate) goal: TuneGoal,
    /// Floors to compare for each damper: all, or from one to another; by default only its own is searched
    #[arg(long, value_name = "all|FROM-TO", value_parser = floors)]
    pub(crate) floors: Option<TuneFloors>,
    /// Number of positions on the map along each side of the floor
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u16).range(2..=400).map(usize::from))]
    pub(crate) map: usize,
    /// Limit the standard deviation of the stroke to this fraction of that of the damper in the file
    #[arg(long, value_name = "RATIO", value_parser = positive)]
    pub(crate) stroke_most: Option<f64>,
    /// Design for frequencies that may differ by this much either way, 0.1 for 10 %
    #[arg(long, value_name = "RATIO", default_value_t = 0.0, value_parser = below_half)]
    pub(crate) off: f64,
    /// With several dampers: also redistribute the sum of their masses
    #[arg(long)]
    pub(crate) share_mass: bool,
    /// Write results (JSON) and figures (SVG) into this folder, in a subfolder for each damper
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// Parses a number of at least 0 and below one half.
fn below_half(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..0.5).contains(&value) => Ok(value),
        _ => Err("must be 0 or more, below 0.5".to_owned()),
    }
}

/// Parses all, FROM-TO or one floor.
fn floors(text: &str) -> Result<TuneFloors, String> {
    let trimmed = text.trim();
    if trimmed == "all" {
        return Ok(TuneFloors::All);
    }
    let (from, to) = trimmed.split_once('-').unwrap_or((trimmed, trimmed));
    match (from.trim().parse(), to.trim().parse()) {
        (Ok(from), Ok(to)) => Ok(TuneFloors::Range { from, to }),
        _ => Err("must be all, or the numbers of two floors, such as 3-12".to_owned()),
    }
}

/// Random loads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TuneLoad {
    /// White-noise force, the same on every floor
    Force,
    /// White-noise force filtered at the corner frequency: gusts
    Wind,
    /// The turbulent wind of the file, along x or y
    Gusts,
    /// White-noise acceleration of the base
    Base,
    /// Acceleration of the ground after Clough and Penzien
    Ground,
}

/// The quantity to minimise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TuneGoal {
    /// The largest standard deviation of all points
    LargestRms,
    /// The root of the mean variance of all points
    MeanSquare,
    /// The largest amplitude of any point under a harmonic load
    LargestPeak,
}
