//! What can be typed, with the help that clap prints.

use crate::cli_follow::Follow;
use crate::cli_language::{day, positive};
use crate::cli_motion::{GroundMotionVerb, Motion};
use crate::cli_portfolio::{Rank, Score};
use crate::cli_survey;
use crate::cli_tune::Tune;
use crate::manner::Manner;
use clap::builder::TypedValueParser as _;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// From field vibration records and a page of dimensions to modes, stiffness, stability and a report, for
/// stacked-stone and timber heritage.
#[derive(Debug, Parser)]
#[command(name = "dolmen", version, max_term_width = 110, propagate_version = true)]
#[command(
    after_help = "Exit status of check, simulate and report: 1 where the judgement is red (unstable, below demand, fallen, beyond its room, \
                        damage state 3), else 0. Of watch: 1 where an alarm is open or a tilt or crack is beyond its limit. Other verbs: 0 when done, whatever they found. Of all: 2 bad input, 3 a computation did not \
                        converge, ended undecided or was stopped.\nStart with `dolmen demo`, or `dolmen new flagpole DIR` and `dolmen check DIR`."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) verb: Verb,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Start a project from an example
    New(New),
    /// The structure as entered: names, dimensions, offsets, tilts, sensors; nothing is computed
    Draw(Draw),
    /// Where a few sensors see the modes best and tell them apart, and what they leave unseen
    Sensors(Sensors),
    /// Is the file right, does it stand: stability, limits, modes. Milliseconds
    Check(Check),
    /// Records → modes → stiffness, with its ambiguity stated
    Identify(Identify),
    /// The record of a survey as it is used → universal file (UFF 58) or CSV, for other programs
    Record(Record),
    /// What changed from one survey to another, and what could have been missed
    Compare(Compare),
    /// The record of a structure over the years: what changed, when, and whether the last surveys are as they should be
    Watch(Watch),
    /// A stack, frame, chain or building under a ground motion: rocking, sliding, slipping, swaying, falling
    Simulate(Simulate),
    /// Runs over grids of inputs, samples, motions and growing shaking; resumable, in shards
    Study(Study),
    /// Dampers of a building: where they serve best and how tuned, beside the rules and what each costs
    Tune(Tune),
    /// Six-factor score of a pagoda against simulated ones; without a project, its weights and what it is worth
    Score(Score),
    /// Many structures in the order in which they should be looked at, with intervals and reasons
    Rank(Rank),
    /// A store of structures with their surveys over years: add, list, show, export, import, verify
    Survey(cli_survey::Survey),
    /// Ground motions: read, measure, spectrum, match to a demand, make, convert
    Motion(GroundMotionVerb),
    /// One self-contained HTML page, in English or Korean
    Report(Report),
    /// The main job on the shipped examples, start to report
    Demo(Demo),
    /// Published | computed | difference, for every source
    Validate,
    /// What a code in a message or report means; all codes without one
    Explain {
        /// The code, such as unsafe-criterion
        code: Option<String>,
    },
    /// JSON schema of the project file
    Schema,
    /// Sentences of reports in English and Korean, side by side, for who reviews them; a table (CSV)
    Words {
        /// Write it into this file, for Excel, instead of printing it
        #[arg(long, value_name = "FILE")]
        export: Option<PathBuf>,
    },
    /// Completions for a shell, to standard output
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// The manual page (roff), to standard output, or one page a verb into a folder
    Man {
        /// Folder for one page a verb
        directory: Option<PathBuf>,
    },
    /// Does this installation work: version, self-checks, writable folders
    Doctor,
}

#[derive(Debug, Args)]
pub(crate) struct New {
    /// What kind of structure
    pub(crate) kind: Kind,
    /// Folder to make; it must not exist or be empty
    pub(crate) directory: PathBuf,
    /// A short file of placeholders instead of the copy of an example: no survey, variant or source of another structure
    #[arg(long, conflicts_with = "scan")]
    pub(crate) bare: bool,
    #[command(flatten)]
    pub(crate) of_scan: OfScan,
}

#[derive(Debug, Args)]
pub(crate) struct OfScan {
    /// Cut this closed mesh of a whole pagoda (OBJ, STL, PLY) into its stones, instead of copying an example
    #[arg(long, value_name = "FILE", requires = "beds")]
    pub(crate) scan: Option<PathBuf>,
    /// Heights of its beds, m in the coordinates of the file, lowest first: 0.35,1.05
    #[arg(
        long,
        value_name = "METRES",
        value_delimiter = ',',
        requires = "scan",
        allow_negative_numbers = true
    )]
    pub(crate) beds: Vec<f64>,
    /// Unit of the file; recognised by its height without it, and stated
    #[arg(long, value_enum, requires = "scan")]
    pub(crate) unit: Option<ScanUnit>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ScanUnit {
    /// Metres
    M,
    /// Centimetres
    Cm,
    /// Millimetres
    Mm,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Stone flagpole: a chain of links on rotational joints
    #[value(alias = "chain")]
    Flagpole,
    /// Timber gate: a frame of rigid storeys
    #[value(alias = "frame")]
    Gate,
    /// Stone pagoda: a stack of blocks
    #[value(alias = "stack")]
    Pagoda,
    /// Stone arch: voussoirs on abutments
    Arch,
    /// Stone wall: courses in running bond
    Wall,
    /// Stone tower: courses, square or round, solid or hollow
    Tower,
    /// Trilithon: two posts and a lintel
    Trilithon,
    /// Building that twists: rigid floors on walls
    Building,
    /// Measured only: vibration records without a model
    Survey,
}

#[derive(Debug, Args)]
pub(crate) struct Draw {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Write the drawing into this file, .svg or .png, instead of standard output (SVG)
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Sensors {
    /// Project file with a structure, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Sensors that record at once; 4, or as many as there are places, without it
    #[arg(long, short = 'n', value_name = "N")]
    pub(crate) count: Option<usize>,
    /// Axes of each sensor: 1, 2 (both horizontal) or 3
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) axes: usize,
    /// How high a sensor may stand, m above the ground: what a ladder reaches
    #[arg(long, value_name = "METRES", value_parser = positive)]
    pub(crate) up_to: Option<f64>,
    /// How many modes they shall tell apart, the lowest; as many as channels, 3 to 6, without it
    #[arg(long, value_name = "N")]
    pub(crate) modes: Option<usize>,
    /// Record so many times, with the sensors moved on
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) setups: usize,
    /// Sensors that stay where they are in all setups
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) references: usize,
    /// Write the drawing (SVG), the plan (JSON) and the lines for a survey (TOML) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Check {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Draw the inputs that carry a cov this many times, and say how probable each verdict is
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) samples: Option<u32>,
    /// Seed of the samples: the same seed gives the same bits
    #[arg(long, default_value_t = 1, requires = "samples")]
    pub(crate) seed: u64,
    /// Say what one per cent of each input does to the load factor
    #[arg(long)]
    pub(crate) sensitivity: bool,
    /// A check answers all variants: refused, with what to do
    #[arg(long, value_name = "NAME", hide = true)]
    pub(crate) variant: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Identify {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Only this survey; all without it
    #[arg(long, value_name = "NAME")]
    pub(crate) survey: Option<String>,
    /// Write the stiffness into the project file where one survey determines it, with its standard deviation; all else stays as it is
    #[arg(long)]
    pub(crate) write: bool,
    /// Write the figures (SVG, PNG), the moving shapes (glTF), the modes (CSV, UFF) and the result (JSON) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Record {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// The survey; without it the only one with a record
    #[arg(long, value_name = "NAME")]
    pub(crate) survey: Option<String>,
    /// The setup of the survey, from 1
    #[arg(long, value_name = "N")]
    pub(crate) setup: Option<usize>,
    /// Write the samples of a universal file as doubles (58b), exact to the last bit, instead of as text
    #[arg(long)]
    pub(crate) binary: bool,
    /// The file: .uff, .unv or .csv
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,
}

#[derive(Debug, Args)]
pub(crate) struct Compare {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// The survey before; the first whose name begins with a date without it
    #[arg(long, value_name = "SURVEY")]
    pub(crate) from: Option<String>,
    /// The survey after; the last whose name begins with a date without it
    #[arg(long, value_name = "SURVEY")]
    pub(crate) to: Option<String>,
    /// Write the figure (SVG) and the result (JSON) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Watch {
    /// Project file with three surveys or more, or a folder that holds project.toml
    #[arg(required_unless_present = "from_store", conflicts_with = "from_store")]
    pub(crate) project: Option<PathBuf>,
    /// Every structure of a store, a line each, the worst first
    #[arg(long, group = "from_store")]
    pub(crate) all: bool,
    /// The store: a file, or postgresql://ROLE@HOST/DATABASE; else DOLMEN_STORE
    #[arg(
        long,
        value_name = "FILE|URL",
        requires = "from_store",
        conflicts_with = "project"
    )]
    pub(crate) store: Option<String>,
    /// With --all: a table (CSV)
    #[arg(long, requires = "all", conflicts_with_all = ["project", "follow"])]
    pub(crate) csv: bool,
    /// Write the figure (SVG) and the result (JSON) into this folder
    #[arg(long, short, value_name = "DIR", conflicts_with = "from_store")]
    pub(crate) output: Option<PathBuf>,
    /// Run this program, without a shell, for each structure with an open alarm or a tilt beyond its limit, with --follow once for each such alarm; what is
    /// wrong is in DOLMEN_… of its environment
    #[arg(long, value_name = "PROGRAM")]
    pub(crate) on_alarm: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) follow: Follow,
}

#[derive(Debug, Args)]
pub(crate) struct Simulate {
    /// Project file of a stack, frame, chain or building, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    #[command(flatten)]
    pub(crate) motion: Motion,
    /// A second motion, of the file or carried by Dolmen, that acts on what the first left, when that has come to rest: an aftershock
    #[arg(long, value_name = "NAME")]
    pub(crate) then: Option<String>,
    /// Simulate this variant of the file instead of the structure as it is
    #[arg(long, value_name = "NAME")]
    pub(crate) variant: Option<String>,
    /// Direction of a frame; without it, each whose stiffness is known
    #[arg(long, value_name = "NAME")]
    pub(crate) direction: Option<String>,
    /// Let the whole chain lean at the start by this angle, "1e-4 rad" or "0.5 deg"; no motion is needed then
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) push: Option<String>,
    /// How far the equations of a chain go: up to its fall, or the linear ones of small rotations
    #[arg(long, value_enum, default_value_t = Rotations::Large)]
    pub(crate) rotations: Rotations,
    /// What acts between the stones of a stack: springs and dashpots, rigid contact that neither gives nor overlaps, or both; without it
    /// springs, and rigid contact beside them where the file does not say that normal_stiffness was measured
    #[arg(long, value_enum)]
    pub(crate) law: Option<Law>,
    /// Blow the wind of the file on a building in time, along x and along y, instead of shaking its ground
    #[arg(long)]
    pub(crate) wind: bool,
    /// Seed of the first history of the wind, 1 without it; those after it count on. The same seed gives the same bits
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Run a stack so often in all, each time but the first with differences that nobody can measure: friction by 2 %, edges of beds by 1 mm,
    /// the motion by 0.5 %; without it 8 times where one run shows damage that they may make worse and that takes seconds, else once. Of a
    /// building the histories of its wind, 10 without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub(crate) repeats: Option<u16>,
    /// Contact points of a joint of a stack: 16 is exact in rocking and 3 % off in twisting; 4 is faster and too stiff in both
    #[arg(long, value_enum, default_value_t = Points::P16)]
    pub(crate) points: Points,
    /// Time step, s, of springs if two laws are run; the longest stable one times 0.9 without it, with --law rigid 1e-3, and 2e-4 where friction_kinetic is below friction; of a building that of the histories, in the wind 0.02 or a 32nd of its period
    #[arg(long, value_name = "S", value_parser = positive)]
    pub(crate) step: Option<f64>,
    /// Length of the run, s; without it the motion and 2 s more for a stack, then until it rests, 20 s more for a frame or chain, 60 s for a
    /// push alone; for a building 20 s more, and ten periods of its slowest mode or damper at least; in the wind 600
    #[arg(long, value_name = "S", value_parser = positive)]
    pub(crate) duration: Option<f64>,
    /// Time between samples of the histories, s
    #[arg(long, value_name = "S", default_value_t = 0.01, value_parser = positive)]
    pub(crate) output_step: f64,
    /// Go on when a stone has fallen, for a film
    #[arg(long)]
    pub(crate) to_the_end: bool,
    /// Write histories (CSV), result (JSON), figures (SVG), film (glTF) and exports into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// The law of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Law {
    /// Springs, dashpots, friction
    Springs,
    /// Unilateral contact, friction, restitution
    Rigid,
    /// Each, however long rigid contact takes
    Both,
    /// Springs, and beside them the sliding model of a pile, whose blocks slide and twist but do not rock
    Sliding,
}

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub(crate) struct Study {
    #[command(subcommand)]
    pub(crate) action: Option<StudyAction>,
    #[command(flatten)]
    pub(crate) place: StudyWhere,
    /// Run only the k-th of N parts, to be put together by `dolmen study merge`
    #[arg(long, value_name = "k/N")]
    pub(crate) shard: Option<String>,
    /// Threads; all cores without it. The results are the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..).map(usize::from))]
    pub(crate) threads: Option<usize>,
    /// Throw away what was done before instead of going on from there
    #[arg(long)]
    pub(crate) restart: bool,
}

#[derive(Debug, Subcommand)]
pub(crate) enum StudyAction {
    /// Put the journals of shards together: tables, figures and results as of one run
    Merge {
        #[command(flatten)]
        place: StudyWhere,
        /// Folders with journals of shards, beside that of the results
        #[arg(long, value_name = "DIR", num_args = 1..)]
        from: Vec<PathBuf>,
    },
    /// Which scans are not done yet
    Missing {
        #[command(flatten)]
        place: StudyWhere,
        /// Folders with journals of shards, beside that of the results
        #[arg(long, value_name = "DIR", num_args = 1..)]
        from: Vec<PathBuf>,
    },
}

#[derive(Debug, Args)]
pub(crate) struct StudyWhere {
    /// Project file, or a folder that holds project.toml
    #[arg(required = true)]
    pub(crate) project: Option<PathBuf>,
    /// Only this study, [study.NAME]; all without it
    #[arg(long, value_name = "NAME")]
    pub(crate) study: Vec<String>,
    /// Folder of the results, one below it a study; studies/ beside the project file without it
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// How far the equations of a chain go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Rotations {
    /// Any rotation, up to the fall
    Large,
    /// Linear, whatever size is reached
    Small,
}

/// Contact points of a quadrilateral joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Points {
    /// Corners only
    #[value(name = "4")]
    P4,
    /// 3 × 3
    #[value(name = "9")]
    P9,
    /// 4 × 4
    #[value(name = "16")]
    P16,
    /// 6 × 6
    #[value(name = "36")]
    P36,
}

#[derive(Debug, Args)]
pub(crate) struct Report {
    /// Project files, or folders that hold project.toml: one report for all of them
    #[arg(required = true)]
    pub(crate) projects: Vec<PathBuf>,
    /// Where to write it: a page (.html), a document to print (.pdf, where built in) or to edit (.docx, .hwpx), or a workbook of its tables for
    /// Excel (.xlsx); may be given for each
    #[arg(long, short, value_name = "FILE", default_value = "report.html")]
    pub(crate) output: Vec<PathBuf>,
    /// Also write each figure of the report into this folder: SVG, PNG, and its numbers as CSV
    #[arg(long, value_name = "DIR")]
    pub(crate) figures: Option<PathBuf>,
    /// Draw the inputs that carry a cov this many times
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = clap::value_parser!(u32).range(0..=10_000_000))]
    pub(crate) samples: u32,
    /// Seed of the samples
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    #[command(flatten)]
    pub(crate) motion: Motion,
    /// Date to print on the page, such as 2026-05-12; none without it
    #[arg(long, value_name = "DAY", value_parser = day)]
    pub(crate) date: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Demo {
    /// Folder to make for the examples and the report
    #[arg(default_value = "dolmen-demo")]
    pub(crate) directory: PathBuf,
}
