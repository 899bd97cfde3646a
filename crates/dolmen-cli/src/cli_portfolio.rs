//! Arguments of the verbs that score and rank structures.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct Score {
    /// Project file of a stack with the six factors of a pagoda, or a filled form (.xlsx); without it, print the weights of the factors
    /// and how accurate the score is
    pub(crate) project: Option<PathBuf>,
    /// Designs to train on (CSV), instead of the built-in ones
    #[arg(long, value_name = "FILE")]
    pub(crate) designs: Option<PathBuf>,
    /// Survey of the project whose measured frequency tells the stiffness of the joints: the probabilities of DS2, DS3 and falls with and
    /// without it
    #[arg(long, value_name = "SURVEY", requires = "project", conflicts_with_all = ["designs", "train"])]
    pub(crate) given: Option<String>,
    /// Also for factors outside the range trained; the answer marks them
    #[arg(long)]
    pub(crate) extrapolate: bool,
    /// Write the form that is filled at a pagoda: a workbook (.xlsx), which is read back, or a page to print (.html)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["project", "designs", "extrapolate", "given", "train", "output"])]
    pub(crate) sheet: Option<PathBuf>,
    /// Make designs from this study of the project, and write them to -o
    #[arg(long, value_name = "STUDY", requires_all = ["project", "output"])]
    pub(crate) train: Option<String>,
    /// Folder that `dolmen study -o` wrote the study to; by default studies beside the project file
    #[arg(long, value_name = "DIR", requires = "train")]
    pub(crate) from: Option<PathBuf>,
    /// File for the designs of --train (CSV)
    #[arg(long, short, value_name = "FILE", requires = "train")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Rank {
    /// Table of structures (XLSX, ODS, CSV), or a folder of project folders
    pub(crate) source: PathBuf,
    /// Sheet of a workbook that has several (XLSX, ODS)
    #[arg(long, value_name = "NAME")]
    pub(crate) sheet: Option<String>,
    /// Damage state to rank by
    #[arg(long, value_enum, default_value_t = State::Ds3)]
    pub(crate) state: State,
    /// Designs to train the score on (CSV), instead of the built-in ones
    #[arg(long, value_name = "FILE")]
    pub(crate) designs: Option<PathBuf>,
    /// Also rank pagodas with factors outside the trained range; the answer marks them
    #[arg(long)]
    pub(crate) extrapolate: bool,
    /// Number of random draws of the unknown inputs, for the intervals of the ranks
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u16).range(20..=10_000))]
    pub(crate) draws: u16,
    /// Write the ranking (CSV, JSON), a figure (SVG) and a page (HTML) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum State {
    /// A joint opens or slips
    Ds1,
    /// An offset remains
    Ds2,
    /// A large offset remains, or a joint rocked far
    Ds3,
    /// A stone falls
    Falls,
}
