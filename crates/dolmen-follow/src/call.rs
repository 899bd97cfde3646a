//! The program that runs for each alarm.

use crate::wrong::FollowError;
use anyhow::Result;
use dolmen_work::inventory::InventoryLine;
use std::path::Path;
use std::process::{Command, Stdio};

/// Environment variables of the program.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// The structure.
    pub structure: &'a str,
    /// The last survey.
    pub survey: &'a str,
    /// Number of open alarms.
    pub open_alarms: usize,
    /// The tilt, if it exceeds its limit.
    pub tilt_beyond: Option<f64>,
    /// For a single alarm: its kind, and the day that confirmed it.
    pub kind: Option<[&'a str; 2]>,
}

impl Call<'_> {
    /// Runs the program without a shell and waits for its end.
    ///
    /// # Errors
    /// If it cannot be run, or its exit status is not 0.
    pub fn run(&self, program: &Path) -> Result<()> {
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
            Ok(status) => FollowError::ProgramFailed {
                program: shown,
                structure: self.structure.to_owned(),
                status: status.to_string(),
            },
            Err(why) => FollowError::NoProgram { program: shown, why },
        };
        Err(fault.into())
    }
}

/// Runs `program` for each structure with an alarm, one after the other.
///
/// # Errors
/// The first run that failed.
pub fn call_for_alarming(program: &Path, lines: &[InventoryLine]) -> Result<()> {
    for line in lines.iter().filter(|line| line.is_alarming()) {
        let Some(history) = &line.history else { continue };
        Call {
            structure: &line.structure,
            survey: &history.last_survey,
            open_alarms: history.open_alarms,
            tilt_beyond: history.lean_beyond,
            kind: None,
        }
        .run(program)?;
    }
    Ok(())
}
