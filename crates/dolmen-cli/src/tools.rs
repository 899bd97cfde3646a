//! What helps to use the command: explanations, completions, manual pages, and how errors are shown.

use crate::cli::Cli;
use crate::{Outcome, files};
use anyhow::{Context as _, Result, bail};
use clap::CommandFactory as _;
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::BuildingError;
use dolmen::validation::ValidationError;
use dolmen_project::{DamperFault, json_schema};
use dolmen_records::motions::MotionError;
use dolmen_records::records::RecordError;
use dolmen_report::explain::{EXPLANATIONS, explain as look_up, nearest_code};
use dolmen_words::advice::advice;
use dolmen_work::change::ChangeFault;
use dolmen_work::portfolio::PortfolioError;
use serde_json::json;
use std::error::Error;
use std::io::Write as _;
use std::path::Path;

/// Exit status of a computation that did not converge or come to its end; bad input is [`BAD_INPUT`].
pub(crate) const NO_CONVERGENCE: u8 = 3;
/// Exit status of bad input.
const BAD_INPUT: u8 = 2;

/// The error of the science within one of a layer above that hands it on as it is.
fn handed_on<'a>(cause: &'a (dyn Error + 'static)) -> &'a (dyn Error + 'static) {
    match cause.downcast_ref() {
        Some(RecordError::Signal(why)) => return why,
        Some(RecordError::Seismic(why)) => return handed_on(why.as_ref()),
        _ => {}
    }
    match cause.downcast_ref() {
        Some(MotionError::Signal(why)) => return why,
        Some(MotionError::Record(why)) => return handed_on(why),
        _ => {}
    }
    match cause.downcast_ref() {
        Some(DamperFault::Tuning(why)) => return why,
        Some(DamperFault::Place { why, .. }) => return why,
        _ => {}
    }
    match cause.downcast_ref() {
        Some(ChangeFault::Assess(why)) => why,
        _ => cause,
    }
}

/// An error with its causes in one line, each with what can be done in the project file or with the command.
fn told(fault: &anyhow::Error) -> String {
    let each = fault.chain().map(|cause| {
        let advice = advice(handed_on(cause)).unwrap_or_default();
        format!("{cause}{advice}")
    });
    each.collect::<Vec<_>>().join(": ")
}

/// Prints an error with its causes, to standard error.
pub(crate) fn complain(fault: &anyhow::Error) {
    let mut text = told(fault);
    if !text.starts_with("error") {
        text.insert_str(0, "error: ");
    }
    note!("{text}");
}

/// The exit status that an error stands for.
pub(crate) fn exit_status(fault: &anyhow::Error) -> u8 {
    if fault.chain().any(|cause| did_not_converge(handed_on(cause))) {
        NO_CONVERGENCE
    } else {
        BAD_INPUT
    }
}

fn did_not_converge(cause: &(dyn Error + 'static)) -> bool {
    fn is<E: Error + 'static>(cause: &(dyn Error + 'static), ask: fn(&E) -> bool) -> bool {
        cause.downcast_ref().is_some_and(ask)
    }
    let in_a_row = |fault: &PortfolioError| matches!(fault, PortfolioError::Refused { why, .. } if why.did_not_converge());
    is(cause, StructureError::did_not_converge)
        || is(cause, BuildingError::did_not_converge)
        || is(cause, StabilityError::did_not_converge)
        || is(cause, DynamicsError::did_not_converge)
        || is(cause, BlocksError::did_not_converge)
        || is(cause, DamperError::did_not_converge)
        || is(cause, ModalError::did_not_converge)
        || is(cause, AssessError::did_not_converge)
        || is(cause, ValidationError::did_not_converge)
        || is(cause, in_a_row)
}

pub(crate) fn explain(code: Option<&str>, as_json: bool) -> Result<Outcome> {
    let chosen: Vec<_> = match code {
        None => EXPLANATIONS.iter().collect(),
        Some(code) => match look_up(code) {
            Some(found) => vec![found],
            None => {
                let hint = nearest_code(code)
                    .map(|near| format!(" Did you mean {near}?"))
                    .unwrap_or_default();
                bail!("there is no code \"{code}\".{hint} `dolmen explain` lists all codes")
            }
        },
    };
    if as_json {
        let list: Vec<_> = chosen
            .iter()
            .map(|e| json!({ "code": e.code, "title": e.title, "text": e.text }))
            .collect();
        println!("{:#}", json!(list));
    } else if code.is_none() {
        for e in chosen {
            println!("{:20} {}", e.code, e.title);
        }
    } else {
        for e in chosen {
            println!("{}: {}\n\n{}", e.code, e.title, e.text);
        }
    }
    Ok(Outcome::Stands)
}

pub(crate) fn completions(shell: clap_complete::Shell) -> Result<Outcome> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "dolmen", &mut script);
    std::io::stdout().write_all(&script)?;
    Ok(Outcome::Stands)
}

pub(crate) fn schema() -> Result<Outcome> {
    files::say(&format!("{:#}\n", json_schema()))?;
    Ok(Outcome::Stands)
}

pub(crate) fn man(directory: Option<&Path>) -> Result<Outcome> {
    match directory {
        None => clap_mangen::Man::new(Cli::command()).render(&mut std::io::stdout())?,
        Some(directory) => {
            std::fs::create_dir_all(directory)
                .with_context(|| format!("cannot make the folder {}", directory.display()))?;
            clap_mangen::generate_to(Cli::command(), directory)
                .with_context(|| format!("cannot write manual pages into {}", directory.display()))?;
        }
    }
    Ok(Outcome::Stands)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::signal::SignalError;

    #[test]
    fn holds_advice_and_exit_status_see_through_the_layers_above() {
        let no_start = SignalError::NoStart {
            channel: "a x".into(),
        };
        let fault = anyhow::Error::new(RecordError::Signal(no_start)).context("survey one");
        assert_eq!(
            told(&fault),
            "survey one: channel \"a x\" does not say when it begins: give its begins, or starts = \"together\" if all began at one instant"
        );
        assert_eq!(exit_status(&fault), BAD_INPUT);
        let no_rest = BlocksError::NoRest {
            iterations: 9,
            residual: 0.1,
            block: "a".into(),
        };
        assert_eq!(exit_status(&no_rest.into()), NO_CONVERGENCE);
        let bad = AssessError::Scale { given: 0.0 };
        assert_eq!(exit_status(&ChangeFault::Assess(bad).into()), BAD_INPUT);
    }
}
