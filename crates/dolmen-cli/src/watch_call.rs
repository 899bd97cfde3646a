//! What follows an alarm: the program of `--on-alarm`, and the exit status.

use crate::outcome::Outcome;
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen_work::judgement::{Colour, Verb, exit_status};
use std::path::Path;
use std::process::{Command, Stdio};

/// What the program finds in its environment.
pub(crate) struct Call<'a> {
    pub(crate) structure: &'a str,
    /// The last survey.
    pub(crate) survey: &'a str,
    pub(crate) open_alarms: usize,
    pub(crate) tilt_beyond: Option<f64>,
    /// Of one alarm: of what sort, and the day that confirmed it.
    pub(crate) kind: Option<[&'a str; 2]>,
}

impl Call<'_> {
    /// Runs it, without a shell, to its end.
    pub(crate) fn run(&self, program: &Path) -> Result<()> {
        let lean = self.tilt_beyond.map(|lean| format!("{lean:.5}"));
        let mut command = Command::new(program);
        command
            .env("DOLMEN_STRUCTURE", self.structure)
            .env("DOLMEN_SURVEY", self.survey)
            .env("DOLMEN_ALARMS", self.open_alarms.to_string())
            .env("DOLMEN_TILT_BEYOND", lean.unwrap_or_default())
            .stdin(Stdio::null());
        if let Some([kind, date]) = self.kind {
            command
                .env("DOLMEN_ALARM_KIND", kind)
                .env("DOLMEN_ALARM_DATE", date);
        }
        let shown = program.display().to_string();
        let fault = match command.status() {
            Ok(status) if status.success() => return Ok(()),
            Ok(status) => CommandError::ProgramFailed {
                program: shown,
                structure: self.structure.to_owned(),
                status: status.to_string(),
            },
            Err(why) => CommandError::NoProgram { program: shown, why },
        };
        Err(fault.into())
    }
}

/// How a watch ends that found an alarm, or none.
pub(crate) fn judged(is_alarming: bool) -> Outcome {
    let colour = if is_alarming { Colour::Red } else { Colour::Green };
    Outcome::Judged(exit_status(Verb::Watch, colour, true))
}
