//! Explanations, completions, manual pages, and the display of errors.

use crate::cli::Cli;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::passwords::without_passwords;
use crate::say::{say, say_json};
use crate::wrong::{CommandError, of_command};
use anyhow::Result;
use clap::{Command, CommandFactory as _};
use clap_mangen::Man;
use dolmen_folder::Outputs;
use dolmen_project::json_schema;
use dolmen_report::as_json;
use dolmen_report::explain::{
    EXPLANATIONS, explain as look_up, explained_text, explanation_in, nearest_code,
};
use dolmen_report::files::NamedFile;
use dolmen_report::sentences::sentences_csv;
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_work::{complaint, did_not_converge, told_by};
use std::path::Path;

/// Exit status of a computation that did not converge or finish.
pub(crate) const NO_CONVERGENCE: u8 = 3;
/// Exit status of bad input.
const BAD_INPUT: u8 = 2;

/// Prints an error with its causes, to standard error.
pub(crate) fn complain(fault: &anyhow::Error, manner: &Manner) {
    let said = complaint(fault.as_ref(), manner.language(), &of_command);
    note!("{}", without_passwords(&said));
}

/// An error with its causes, in a language.
pub(crate) fn told(fault: &(dyn std::error::Error + 'static), language: Language) -> String {
    told_by(fault, language, &of_command)
}

/// An error with its causes, in both languages.
pub(crate) fn told_both(fault: &(dyn std::error::Error + 'static)) -> Both {
    Both::of(|language| told(fault, language))
}

/// The exit status of an error.
pub(crate) fn exit_status(fault: &anyhow::Error) -> u8 {
    if did_not_converge(fault.as_ref()) {
        NO_CONVERGENCE
    } else {
        BAD_INPUT
    }
}

pub(crate) fn explain(code: Option<&str>, manner: &Manner) -> Result<Outcome> {
    let chosen: Vec<_> = match code {
        None => EXPLANATIONS.iter().collect(),
        Some(code) => match look_up(code) {
            Some(found) => vec![found],
            None => {
                let near = nearest_code(code).map(str::to_owned);
                let code = code.to_owned();
                return Err(CommandError::NoCode { code, near }.into());
            }
        },
    };
    if manner.json {
        let list: Vec<_> = chosen
            .iter()
            .map(|e| as_json!({ "code": e.code, "title": e.title, "text": e.text }))
            .collect();
        say_json(&as_json!(list))?;
    } else {
        let language = manner.language();
        let told = chosen.iter().filter_map(|e| explanation_in(e.code, language));
        let lines = told.map(|e| match code {
            None => format!("{:20} {}\n", e.code, e.title),
            Some(_) => explained_text(e, manner.style()),
        });
        say(&lines.collect::<String>())?;
    }
    Ok(Outcome::Done)
}

pub(crate) fn completions(shell: clap_complete::Shell) -> Result<Outcome> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "dolmen", &mut script);
    say(&String::from_utf8_lossy(&script))?;
    Ok(Outcome::Done)
}

pub(crate) fn schema(manner: &Manner) -> Result<Outcome> {
    say(&format!("{:#}\n", json_schema(manner.language())))?;
    Ok(Outcome::Done)
}

pub(crate) fn words(file: Option<&Path>, manner: &Manner) -> Result<Outcome> {
    match file {
        None => say(&sentences_csv())?,
        Some(file) => Outputs::new(manner.access()).file(file, sentences_csv().as_bytes())?,
    }
    Ok(Outcome::Done)
}

pub(crate) fn man(directory: Option<&Path>, manner: &Manner) -> Result<Outcome> {
    match directory {
        None => {
            let mut page = Vec::new();
            Man::new(Cli::command()).render(&mut page)?;
            say(&String::from_utf8_lossy(&page))?;
        }
        Some(directory) => {
            let mut pages = Vec::new();
            let mut command = Cli::command().disable_help_subcommand(true);
            command.build();
            man_pages(&command, &mut pages)?;
            Outputs::new(manner.access()).folder(directory, &pages)?;
        }
    }
    Ok(Outcome::Done)
}

/// The manual page of a verb and its subcommands.
fn man_pages(command: &Command, pages: &mut Vec<NamedFile>) -> Result<()> {
    let (page, mut bytes) = (Man::new(command.clone()), Vec::new());
    page.render(&mut bytes)?;
    pages.push(NamedFile::new(&page.get_filename(), bytes));
    command
        .get_subcommands()
        .try_for_each(|verb| man_pages(verb, pages))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::assess::AssessError;
    use dolmen::blocks::BlocksError;
    use dolmen::signal::SignalError;
    use dolmen_records::records::RecordError;
    use dolmen_work::{ChangeFault, WorkError, told};

    #[test]
    fn holds_advice_and_exit_status_see_through_the_layers_above() {
        let no_start = SignalError::NoStart {
            channel: "a x".into(),
        };
        let fault = anyhow::Error::new(RecordError::Signal(no_start)).context("survey one");
        assert_eq!(
            told(fault.as_ref()),
            "survey one: channel \"a x\" does not say when it begins: give its begins, or starts = \"together\" if all began at one instant"
        );
        assert_eq!(exit_status(&fault), BAD_INPUT);
        let no_rest = BlocksError::NoRest {
            iterations: 9,
            residual: 0.1,
            block: "a".into(),
        };
        assert_eq!(exit_status(&WorkError::from(no_rest).into()), NO_CONVERGENCE);
        let bad = AssessError::Scale { given: 0.0 };
        assert_eq!(
            exit_status(&WorkError::from(ChangeFault::Assess(bad)).into()),
            BAD_INPUT
        );
    }
}
