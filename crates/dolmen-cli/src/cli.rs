//! Arguments of the command, with the help that clap prints.

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
    /// Draw the structure as entered: names, dimensions, offsets, tilts, sensors; computes nothing
    Draw(Draw),
    /// Where a few sensors observe the modes best and distinguish them, and what they cannot observe
    Sensors(Sensors),
    /// Is the file right, does the structure stand: stability, limits, modes. Milliseconds; arches with a strength take longer
    Check(Check),
    /// Records → modes → stiffness, with its ambiguity stated
    Identify(Identify),
    /// Write a survey's record as Dolmen uses it, as universal file (UFF 58) or CSV for other programs
    Record(Record),
    /// What changed between two surveys, and which changes could have been missed
    Compare(Compare),
    /// The history of a structure: what changed, when, and whether the last surveys are as expected
    Watch(Watch),
    /// A stack, frame, chain or building under a ground motion: rocking, sliding, slipping, swaying, falling
    Simulate(Simulate),
    /// Runs over grids of inputs, samples, motions and increasing shaking; resumable, in shards
    Study(Study),
    /// Dampers of a building: best position and tuning, compared with design rules, and the loss of each
    Tune(Tune),
    /// Six-factor score of a pagoda from simulated ones; without a project, its weights and accuracy
    Score(Score),
    /// Rank structures by how urgently they need attention, with intervals and reasons
    Rank(Rank),
    /// A store of structures with their surveys over years: add, list, show, export, import, verify
    Survey(cli_survey::Survey),
    /// Ground motions: read, measure, spectrum, match to a demand, make, convert
    Motion(GroundMotionVerb),
    /// One self-contained HTML page, in English or Korean
    Report(Report),
    /// The main steps on shipped examples, from the start to the report
    Demo(Demo),
    /// Published | computed | difference, for every source
    Validate,
    /// What a code in a message or report means; without a code, all codes
    Explain {
        /// The code, such as unsafe-criterion
        code: Option<String>,
    },
    /// JSON schema of the project file
    Schema,
    /// Sentences of reports in English and Korean, side by side, for reviewers; a table (CSV)
    Words {
        /// Write the table into this file, for Excel, instead of printing it
        #[arg(long, value_name = "FILE")]
        export: Option<PathBuf>,
    },
    /// Shell completions, to standard output
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// The manual page (roff), to standard output; or one page per verb into a folder
    Man {
        /// Folder for one page per verb
        directory: Option<PathBuf>,
    },
    /// Does this installation work: version, self-checks, writable folders
    Doctor,
}

#[derive(Debug, Args)]
pub(crate) struct New {
    /// Kind of structure
    pub(crate) kind: Kind,
    /// Folder to create; it must not exist or be empty
    pub(crate) directory: PathBuf,
    /// A short file of placeholders instead of a copy of an example: without surveys, variants or sources of another structure
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
    /// Heights of its bed joints, m in the coordinates of the file, lowest first: 0.35,1.05
    #[arg(
        long,
        value_name = "METRES",
        value_delimiter = ',',
        requires = "scan",
        allow_negative_numbers = true
    )]
    pub(crate) beds: Vec<f64>,
    /// Heights where the section steps within one stone (a moulding, a corbel), m: 0.82,0.90
    #[arg(
        long,
        value_name = "METRES",
        value_delimiter = ',',
        requires = "scan",
        allow_negative_numbers = true
    )]
    pub(crate) allow: Vec<f64>,
    /// Unit of the file; by default inferred from its height, and reported
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
    /// Barrel vault: courses of stones in bond
    Vault,
    /// Dome: rings of stones, with or without an oculus
    Dome,
    /// Building with torsion: rigid floors on walls
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
    /// Number of sensors that record at once [default: 4, or the number of possible places]
    #[arg(long, short = 'n', value_name = "N")]
    pub(crate) count: Option<usize>,
    /// Axes of each sensor: 1, 2 (both horizontal) or 3, at most those along which the model moves
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) axes: usize,
    /// Greatest height of a sensor, m above the ground, such as the reach of a ladder
    #[arg(long, value_name = "METRES", value_parser = positive)]
    pub(crate) up_to: Option<f64>,
    /// Number of lowest modes to distinguish [default: the number of channels, from 3 to 6]
    #[arg(long, value_name = "N")]
    pub(crate) modes: Option<usize>,
    /// Number of recordings, between which the sensors are moved
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) setups: usize,
    /// Number of sensors that stay in place in all setups
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
    /// Draw the inputs with a cov this many times, and give the probability of each verdict
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) samples: Option<u32>,
    /// Seed of the samples: the same seed gives the same bits
    #[arg(long, default_value_t = 1, requires = "samples")]
    pub(crate) seed: u64,
    /// Give the effect of one per cent of each input on the load factor
    #[arg(long)]
    pub(crate) sensitivity: bool,
    /// Not accepted: a check answers all variants
    #[arg(long, value_name = "NAME", hide = true)]
    pub(crate) variant: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Identify {
    /// Project file, or a folder that holds project.toml
    pub(crate) project: PathBuf,
    /// Only this survey; by default all
    #[arg(long, value_name = "NAME")]
    pub(crate) survey: Option<String>,
    /// Write the stiffness with its standard deviation into the project file, if one survey determines it; the rest of the file stays as it is
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
    /// The survey; by default the only one with a record
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
    /// The earlier survey; by default the first whose name begins with a date
    #[arg(long, value_name = "SURVEY")]
    pub(crate) from: Option<String>,
    /// The later survey; by default the last whose name begins with a date
    #[arg(long, value_name = "SURVEY")]
    pub(crate) to: Option<String>,
    /// Write the figure (SVG) and the result (JSON) into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct Watch {
    /// Project file with at least three surveys, or a folder that holds project.toml
    #[arg(required_unless_present = "from_store", conflicts_with = "from_store")]
    pub(crate) project: Option<PathBuf>,
    /// Every structure of a store, one line each, the worst first
    #[arg(long, group = "from_store")]
    pub(crate) all: bool,
    /// The store: a file, or postgresql://ROLE@HOST/DATABASE [default: DOLMEN_STORE]
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
    /// Run this program, without a shell, for each structure with an open alarm or a tilt beyond its limit, or with --follow once for each
    /// such alarm; DOLMEN_… variables in its environment give the details
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
    /// A second motion, of the file or built in, after the first has come to rest: an aftershock, which acts on the structure as the
    /// first left it
    #[arg(long, value_name = "NAME")]
    pub(crate) then: Option<String>,
    /// Simulate this variant of the file instead of the structure as it is
    #[arg(long, value_name = "NAME")]
    pub(crate) variant: Option<String>,
    /// Direction of a frame; by default each direction with known stiffness
    #[arg(long, value_name = "NAME")]
    pub(crate) direction: Option<String>,
    /// Initial lean of the whole chain, "1e-4 rad" or "0.5 deg"; then no motion is needed
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) push: Option<String>,
    /// Equations of a chain: for large rotations up to a fall, or linear for small rotations
    #[arg(long, value_enum, default_value_t = Rotations::Large)]
    pub(crate) rotations: Rotations,
    /// Contact between the stones of a stack: springs and dashpots, rigid contact without overlap, or both; by default springs, and also
    /// rigid contact unless the file says that normal_stiffness was measured
    #[arg(long, value_enum)]
    pub(crate) law: Option<Law>,
    /// Simulate a building under the wind of the file, along x and along y, instead of a ground motion
    #[arg(long)]
    pub(crate) wind: bool,
    /// Seed of the first wind history [default: 1]; the others use the next numbers. The same seed gives the same bits
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Number of runs of a stack; each but the first has changes too small to measure: friction by 2 %, edges of beds by 1 mm, the motion
    /// by 0.5 %. By default 8 if one run shows damage that they may increase and takes seconds, otherwise 1. For a building, the number of
    /// wind histories, by default 10
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub(crate) repeats: Option<u16>,
    /// Contact points per joint of a stack: 16 is exact in rocking and 3 % off in torsion; 4 is faster and too stiff in both
    #[arg(long, value_enum, default_value_t = Points::P16)]
    pub(crate) points: Points,
    /// Time step, s: for two contact laws, that of the springs; by default 0.9 times the longest stable step, with --law rigid 1e-3, or
    /// 2e-4 if friction_kinetic is below friction; for a building, that of the histories, in the wind 0.02 or 1/32 of its period
    #[arg(long, value_name = "S", value_parser = positive)]
    pub(crate) step: Option<f64>,
    /// Length of the run, s; by default, for a stack the motion and 2 s more, then until it rests; for a frame or chain 20 s more, or 60 s
    /// for a push alone; for a building 20 s more, and at least ten periods of its slowest mode or damper; in the wind 600
    #[arg(long, value_name = "S", value_parser = positive)]
    pub(crate) duration: Option<f64>,
    /// Time between samples of the histories, s
    #[arg(long, value_name = "S", default_value_t = 0.01, value_parser = positive)]
    pub(crate) output_step: f64,
    /// Continue after a stone has fallen, for an animation
    #[arg(long)]
    pub(crate) to_the_end: bool,
    /// Write histories (CSV), result (JSON), figures (SVG), animation (glTF) and exports into this folder
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// The contact law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Law {
    /// Springs, dashpots, friction
    Springs,
    /// Unilateral contact, friction, restitution
    Rigid,
    /// Both, however long rigid contact takes
    Both,
    /// Springs, and also the sliding model of a pile, whose blocks slide and twist but do not rock
    Sliding,
}

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub(crate) struct Study {
    #[command(subcommand)]
    pub(crate) action: Option<StudyAction>,
    #[command(flatten)]
    pub(crate) place: StudyWhere,
    /// Run only part k of N; `dolmen study merge` joins the parts
    #[arg(long, value_name = "k/N")]
    pub(crate) shard: Option<String>,
    /// Number of threads, by default all cores. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..).map(usize::from))]
    pub(crate) threads: Option<usize>,
    /// Discard earlier runs instead of continuing from them
    #[arg(long)]
    pub(crate) restart: bool,
}

#[derive(Debug, Subcommand)]
pub(crate) enum StudyAction {
    /// Join the journals of shards: tables, figures and results as from one run
    Merge {
        #[command(flatten)]
        place: StudyWhere,
        /// Further folders with journals of shards
        #[arg(long, value_name = "DIR", num_args = 1..)]
        from: Vec<PathBuf>,
    },
    /// List the scans that are not done yet
    Missing {
        #[command(flatten)]
        place: StudyWhere,
        /// Further folders with journals of shards
        #[arg(long, value_name = "DIR", num_args = 1..)]
        from: Vec<PathBuf>,
    },
}

#[derive(Debug, Args)]
pub(crate) struct StudyWhere {
    /// Project file, or a folder that holds project.toml
    #[arg(required = true)]
    pub(crate) project: Option<PathBuf>,
    /// Only this study, [study.NAME]; by default all
    #[arg(long, value_name = "NAME")]
    pub(crate) study: Vec<String>,
    /// Folder of the results, with a subfolder for each study; by default studies/ beside the project file
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}

/// Equations of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Rotations {
    /// Any rotation, up to the fall
    Large,
    /// Linear, for any size of rotation
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
    /// Output file: a page (.html), a document to print (.pdf, if built in) or to edit (.docx, .hwpx), or a workbook of its tables for
    /// Excel (.xlsx); may be repeated
    #[arg(long, short, value_name = "FILE", default_value = "report.html")]
    pub(crate) output: Vec<PathBuf>,
    /// Also write each figure of the report into this folder: SVG, PNG, and its numbers as CSV
    #[arg(long, value_name = "DIR")]
    pub(crate) figures: Option<PathBuf>,
    /// Draw the inputs with a cov this many times
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = clap::value_parser!(u32).range(0..=10_000_000))]
    pub(crate) samples: u32,
    /// Seed of the samples
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    #[command(flatten)]
    pub(crate) motion: Motion,
    /// Date to print on the page, such as 2026-05-12; by default none
    #[arg(long, value_name = "DAY", value_parser = day)]
    pub(crate) date: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct Demo {
    /// Folder to create for the examples and the report
    #[arg(default_value = "dolmen-demo")]
    pub(crate) directory: PathBuf,
}
