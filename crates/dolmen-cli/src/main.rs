//! The command `dolmen`: opens the files, calls the science, prints the answer.

/// Prints a line to standard error; a reader that has gone (`2>&1 | head`) is no fault.
macro_rules! note {
    ($($said:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($said)*);
    }};
}

mod building;
mod check;
mod cli;
mod cli_portfolio;
mod cli_tune;
mod compare;
mod demand;
mod files;
mod identify;
mod motion;
mod motion_verb;
mod new;
mod open;
mod rank;
mod report;
mod score;
mod simulate;
mod simulate_building;
mod simulate_chain;
mod simulate_frame;
mod stack_frequencies;
mod study;
mod tools;
mod tune;
mod tune_room;
mod tune_together;
mod validate;

use clap::Parser as _;
use cli::{Cli, Verb};
use std::process::ExitCode;

/// How a run ended, other than by an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// Nothing is unstable.
    Stands,
    /// A verdict is "unstable" or "below demand", or a stone fell.
    Falls,
    /// A simulation was stopped or diverged: there is no verdict.
    Unfinished,
    /// What could be done was; the rest was named with its error, whose exit status this is.
    Partial(u8),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(&cli) {
        Ok(Outcome::Stands) => ExitCode::SUCCESS,
        Ok(Outcome::Falls) => ExitCode::from(1),
        Ok(Outcome::Unfinished) => ExitCode::from(tools::NO_CONVERGENCE),
        Ok(Outcome::Partial(status)) => ExitCode::from(status),
        Err(fault) => {
            tools::complain(&fault);
            ExitCode::from(tools::exit_status(&fault))
        }
    }
}

fn run(cli: &Cli) -> anyhow::Result<Outcome> {
    match &cli.verb {
        Verb::New(options) => new::run(options, cli.quiet),
        Verb::Check(options) => check::run(options, cli.json),
        Verb::Identify(options) => identify::run(options, cli.json, cli.quiet),
        Verb::Compare(options) => compare::run(options, cli.json, cli.quiet),
        Verb::Simulate(options) => simulate::run(options, cli.json, cli.quiet),
        Verb::Study(options) => study::run(options, cli.json, cli.quiet),
        Verb::Tune(options) => tune::run(options, cli.json, cli.quiet),
        Verb::Score(options) => score::run(options, cli.json, cli.quiet),
        Verb::Rank(options) => rank::run(options, cli.json, cli.quiet),
        Verb::Motion(options) => motion_verb::run(options, cli.json, cli.quiet),
        Verb::Report(options) => report::run(options, cli.quiet),
        Verb::Demo(options) => report::demo(options, cli.quiet),
        Verb::Schema => tools::schema(),
        Verb::Validate => validate::run(cli.json),
        Verb::Doctor => validate::doctor(),
        Verb::Explain { code } => tools::explain(code.as_deref(), cli.json),
        Verb::Completions { shell } => tools::completions(*shell),
        Verb::Man { directory } => tools::man(directory.as_deref()),
    }
}
