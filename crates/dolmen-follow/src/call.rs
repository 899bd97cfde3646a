//! The program that runs for each alarm.

use crate::wrong::FollowError;
use anyhow::Result;
use dolmen_work::inventory::InventoryLine;
use std::path::Path;
use std::process::{Command, Stdio};

/// What the called program receives in its environment: `DOLMEN_STRUCTURE`, `DOLMEN_SURVEY`, `DOLMEN_ALARMS`, `DOLMEN_TILT_BEYOND`,
/// and for a single alarm `DOLMEN_ALARM_KIND` and `DOLMEN_ALARM_DATE`.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// The structure.
    pub structure: &'a str,
    /// The last survey.
    pub survey: &'a str,
    /// Number of open alarms.
    pub open_alarms: usize,
    /// Tilt, horizontal over vertical, if it exceeds its limit; passed with five decimals, otherwise empty.
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
        Ok(self.attempt(program)?)
    }

    fn attempt(&self, program: &Path) -> Result<(), FollowError> {
        let lean = self.tilt_beyond.map(|lean| format!("{lean:.5}"));
        let mut command = Command::new(program);
        command
            .env("DOLMEN_STRUCTURE", self.structure)
            .env("DOLMEN_SURVEY", self.survey)
            .env("DOLMEN_ALARMS", self.open_alarms.to_string())
            .env("DOLMEN_TILT_BEYOND", lean.unwrap_or_default())
            // those of a call that Dolmen itself runs in are not of this alarm
            .env_remove("DOLMEN_ALARM_KIND")
            .env_remove("DOLMEN_ALARM_DATE")
            .stdin(Stdio::null());
        if let Some([kind, date]) = self.kind {
            command
                .env("DOLMEN_ALARM_KIND", kind)
                .env("DOLMEN_ALARM_DATE", date);
        }
        let shown = program.display().to_string();
        match command.status() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(FollowError::ProgramFailed {
                program: shown,
                structure: self.structure.to_owned(),
                status: status.to_string(),
            }),
            Err(why) => Err(FollowError::NoProgram { program: shown, why }),
        }
    }
}

/// Runs `program` for each structure with an alarm, one after the other; a run that fails does not end the others.
///
/// # Errors
/// All runs that failed.
pub fn call_for_alarming(program: &Path, lines: &[InventoryLine]) -> Result<()> {
    let alarming = lines.iter().filter(|line| line.is_alarming());
    call_each(
        program,
        alarming.filter_map(|line| {
            let history = line.history.as_ref()?;
            Some(Call {
                structure: &line.structure,
                survey: &history.last_survey,
                open_alarms: history.open_alarms,
                tilt_beyond: history.lean_beyond,
                kind: None,
            })
        }),
    )
}

fn call_each<'a>(program: &Path, calls: impl Iterator<Item = Call<'a>>) -> Result<()> {
    let mut faults: Vec<FollowError> = calls.filter_map(|call| call.attempt(program).err()).collect();
    match faults.len() {
        0 => Ok(()),
        1 => Err(faults.remove(0).into()),
        _ => Err(FollowError::CallsFailed {
            each: faults.iter().map(FollowError::sentence).collect(),
        }
        .into()),
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn holds_a_failed_call_does_not_end_the_others() {
        let call = |structure| Call {
            structure,
            survey: "2026-05-01",
            open_alarms: 1,
            tilt_beyond: None,
            kind: None,
        };
        let calls = ["gate", "pole"].map(call).into_iter();
        let said = call_each(Path::new("/bin/false"), calls).unwrap_err().to_string();
        assert!(said.contains("for gate") && said.contains("for pole"), "{said}");
        let alone = call_each(Path::new("/bin/false"), std::iter::once(call("gate")));
        assert!(alone.unwrap_err().to_string().ends_with("for gate"));
        assert!(call_each(Path::new("/bin/true"), std::iter::once(call("gate"))).is_ok());
    }
}
