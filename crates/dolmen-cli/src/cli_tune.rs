//! Arguments of `dolmen tune`.

use crate::cli_language::positive;
use clap::builder::TypedValueParser as _;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct Tune {
    /// Project file of a building with dampers, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Only this damper, [damper.NAME]; all without it
    #[arg(long, value_name = "NAME")]
    pub(crate) damper: Option<String>,
    /// Dampers of this variant; without it those of the file, or of all its variants if the file itself has none
    #[arg(long, value_name = "NAME")]
    pub(crate) variant: Option<String>,
    /// What acts, at random
    #[arg(long, value_enum, default_value_t = TuneLoad::Force)]
    pub(crate) load: TuneLoad,
    /// Corner of the force of gusts, Hz
    #[arg(long, value_name = "HZ", default_value_t = 0.05, value_parser = positive)]
    pub(crate) corner: f64,
    /// Frequency of the soil under --load ground, Hz
    #[arg(long, value_name = "HZ", default_value_t = 2.5, value_parser = positive)]
    pub(crate) ground: f64,
    /// Direction of the load, degrees from x counter-clockwise; that of the damper without it
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub(crate) load_direction: Option<f64>,
    /// What is made small, of the points of the file or else the corners of the damper's floor
    #[arg(long, value_enum, default_value_t = TuneGoal::LargestRms)]
    pub(crate) goal: TuneGoal,
    /// Places of the map along each side of the floor
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u16).range(2..=400).map(usize::from))]
    pub(crate) map: usize,
    /// What is designed keeps its stroke's standard deviation to this part of that of the damper as in the file
    #[arg(long, value_name = "RATIO", value_parser = positive)]
    pub(crate) stroke_most: Option<f64>,
    /// What is designed is the best for frequencies off by so much either way, 0.1 for 10 %
    #[arg(long, value_name = "RATIO", default_value_t = 0.0, value_parser = below_half)]
    pub(crate) off: f64,
    /// With several dampers: also share the sum of their masses anew
    #[arg(long)]
    pub(crate) share_mass: bool,
    /// Write results (JSON) and figures (SVG) into this folder, one below it a damper
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// 0 or more, below one half.
fn below_half(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..0.5).contains(&value) => Ok(value),
        _ => Err("must be 0 or more, below 0.5".to_owned()),
    }
}

/// Random loads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TuneLoad {
    /// White-noise force, the same on every floor
    Force,
    /// The same with a corner: gusts
    Wind,
    /// The turbulent wind of the file, along x or y
    Gusts,
    /// White-noise acceleration of the base
    Base,
    /// Acceleration of the ground after Clough and Penzien
    Ground,
}

/// What is made small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TuneGoal {
    /// The largest standard deviation of all points
    LargestRms,
    /// The root of the mean of their variances
    MeanSquare,
    /// The largest amplitude of any point under a harmonic load
    LargestPeak,
}
