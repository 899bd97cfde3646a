//! The command `dolmen`: opens the files, calls the library, prints the answer.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "the command prints: it is what prints"
)]

mod at_work;
mod bare;
mod check;
mod cli;
mod cli_follow;
mod cli_language;
mod cli_motion;
mod cli_portfolio;
mod cli_survey;
mod cli_tune;
mod compare;
mod draw;
mod examples;
mod follow;
mod identify;
mod manner;
mod motion;
mod note;
mod outcome;
mod passwords;
mod progress;
mod rank;
mod record;
mod report;
mod request;
mod say;
mod scanned;
mod score;
mod sensors;
mod signals;
mod simulate;
mod study;
mod suite;
mod survey;
mod tools;
mod tune;
mod typed;
mod typed_path;
mod validate;
mod watch;
mod watch_call;
mod wrong;

use clap::{CommandFactory as _, FromArgMatches as _};
use cli::{Cli, Verb};
use note::note;
use outcome::Outcome;
use passwords::without_passwords;
use std::process::ExitCode;
use typed::Typed;

/// Reports that Dolmen itself failed: the place, the version, and that earlier output is safe.
fn say_own_fault(panic: &std::panic::PanicHookInfo<'_>) {
    let place = panic
        .location()
        .map(|at| format!(" at {}:{}", at.file(), at.line()));
    let payload = panic.payload();
    let owned = payload.downcast_ref::<String>().map(String::as_str);
    let what = owned.or_else(|| payload.downcast_ref::<&str>().copied());
    let what = what.unwrap_or("no word of why");
    note!(
        "error: this is a fault of Dolmen, not of your files: \"{what}\"{} (dolmen {}, {} {}). What was written before stays, and a study goes on \
         from there; please report it with the command and the project file",
        place.unwrap_or_default(),
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH
    );
}

/// Reports wrong arguments without passwords, and exits.
fn refuse(fault: &clap::Error) -> ! {
    let said = fault.to_string();
    let plain = without_passwords(&said);
    if plain == said {
        fault.exit();
    }
    note!("{}", plain.trim_end());
    std::process::exit(fault.exit_code());
}

fn main() -> ExitCode {
    std::panic::set_hook(Box::new(say_own_fault));
    signals::make_too_large_files_an_error();
    let command = Cli::command();
    let matches = command
        .clone()
        .try_get_matches()
        .unwrap_or_else(|fault| refuse(&fault));
    let typed = Typed::of(&command, &matches);
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|fault| fault.exit());
    let done = run(&cli, &typed);
    progress::end_silence();
    match done {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Unfinished) => ExitCode::from(tools::NO_CONVERGENCE),
        Ok(Outcome::Judged(status)) => ExitCode::from(status),
        Err(fault) => {
            tools::complain(&fault, &cli.manner);
            ExitCode::from(tools::exit_status(&fault))
        }
    }
}

fn run(cli: &Cli, typed: &Typed) -> anyhow::Result<Outcome> {
    let manner = &cli.manner;
    at_work::speak(manner.language());
    progress::show_work(manner.quiet);
    match &cli.verb {
        Verb::New(options) => examples::run(options, manner),
        Verb::Draw(options) => draw::run(options, manner),
        Verb::Sensors(options) => sensors::run(options, manner),
        Verb::Check(options) => check::run(options, typed, manner),
        Verb::Identify(options) => identify::run(options, manner),
        Verb::Record(options) => record::run(options, manner),
        Verb::Compare(options) => compare::run(options, manner),
        Verb::Watch(options) => watch::run(options, manner),
        Verb::Simulate(options) => simulate::run(options, typed, manner),
        Verb::Study(options) => study::run(options, typed, manner),
        Verb::Tune(options) => tune::run(options, typed, manner),
        Verb::Score(options) => score::run(options, manner),
        Verb::Rank(options) => rank::run(options, manner),
        Verb::Survey(options) => survey::run(options, manner),
        Verb::Motion(options) => motion::run(options, typed, manner),
        Verb::Report(options) => report::run(options, typed, manner),
        Verb::Demo(options) => report::demo(options, manner),
        Verb::Schema => tools::schema(manner),
        Verb::Words { export } => tools::words(export.as_deref(), manner),
        Verb::Validate => validate::run(manner.json),
        Verb::Doctor => validate::doctor(),
        Verb::Explain { code } => tools::explain(code.as_deref(), manner),
        Verb::Completions { shell } => tools::completions(*shell),
        Verb::Man { directory } => tools::man(directory.as_deref(), manner),
    }
}
