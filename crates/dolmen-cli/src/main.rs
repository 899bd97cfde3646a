//! The command `dolmen`: opens the files, calls the science, prints the answer.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "the command prints: it is what prints"
)]

mod check;
mod cli;
mod cli_language;
mod cli_portfolio;
mod cli_tune;
mod compare;
mod examples;
mod files;
mod identify;
mod motion;
mod note;
mod open;
mod outcome;
mod progress;
mod rank;
mod report;
mod request;
mod score;
mod simulate;
mod study;
mod study_folder;
mod tools;
mod tune;
mod typed;
mod validate;

use clap::{CommandFactory as _, FromArgMatches as _};
use cli::{Cli, Verb};
use outcome::Outcome;
use std::process::ExitCode;
use typed::Typed;

fn main() -> ExitCode {
    let command = Cli::command();
    let matches = command.clone().get_matches();
    let typed = Typed::of(&command, &matches);
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|fault| fault.exit());
    match run(&cli, &typed) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Unfinished) => ExitCode::from(tools::NO_CONVERGENCE),
        Ok(Outcome::Judged(status)) => ExitCode::from(status),
        Err(fault) => {
            tools::complain(&fault);
            ExitCode::from(tools::exit_status(&fault))
        }
    }
}

fn run(cli: &Cli, typed: &Typed) -> anyhow::Result<Outcome> {
    match &cli.verb {
        Verb::New(options) => examples::run(options, cli.quiet),
        Verb::Check(options) => check::run(options, typed, cli.json),
        Verb::Identify(options) => identify::run(options, cli.json, cli.quiet),
        Verb::Compare(options) => compare::run(options, cli.json, cli.quiet),
        Verb::Simulate(options) => simulate::run(options, typed, cli.json, cli.quiet),
        Verb::Study(options) => study::run(options, typed, cli.json, cli.quiet),
        Verb::Tune(options) => tune::run(options, typed, cli.json, cli.quiet),
        Verb::Score(options) => score::run(options, cli.json, cli.quiet),
        Verb::Rank(options) => rank::run(options, cli.json, cli.quiet),
        Verb::Motion(options) => motion::run(options, cli.json, cli.quiet),
        Verb::Report(options) => report::run(options, typed, cli.quiet),
        Verb::Demo(options) => report::demo(options, cli.quiet),
        Verb::Schema => tools::schema(),
        Verb::Validate => validate::run(cli.json),
        Verb::Doctor => validate::doctor(),
        Verb::Explain { code } => tools::explain(code.as_deref(), cli.json),
        Verb::Completions { shell } => tools::completions(*shell),
        Verb::Man { directory } => tools::man(directory.as_deref()),
    }
}
