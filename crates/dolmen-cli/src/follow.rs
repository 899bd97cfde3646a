//! `dolmen watch --follow`: turns record files in a folder into surveys of a structure in a store.

use crate::cli::Watch;
use crate::cli_survey::StoreWhere;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::say::say;
use crate::signals;
use crate::survey::StoreAccess;
use crate::tools::complain;
use crate::watch_call::judged;
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_follow::{Follow, FollowedRecord, Listener, Quarantined};
use dolmen_report::kept::{JudgedRecord, followed_json, followed_text, quarantined_json, quarantined_text};
use dolmen_words::message::Both;
use std::path::Path;
use std::time::Duration;

pub(crate) fn follow(folder: &Path, options: &Watch, manner: &Manner) -> Result<Outcome> {
    signals::watch();
    let place = StoreWhere {
        store: options.store.clone(),
        who: None,
        wait: 60.0,
    };
    let at = StoreAccess {
        options: &place,
        manner,
    };
    let of = &options.follow;
    let seconds = |given: f64| Duration::from_secs_f64(given.min(1e6));
    let following = Follow {
        folder: folder.to_owned(),
        store: at.place()?,
        wait: at.wait(),
        who: at.who(),
        access: manner.access(),
        structure: of.structure.clone(),
        once: of.once,
        every: seconds(of.every),
        rest: seconds(of.rest),
        taken: of.taken.clone(),
        quarantine: of.quarantine.clone(),
        temperature: of.temperature.clone(),
        temperature_column: of.temperature_column.clone(),
        metrics: of.metrics.clone(),
        on_alarm: options.on_alarm.clone(),
    };
    dolmen_follow::follow(&following, &OnTerminal { manner }).map(judged)
}

/// Prints the result of each file to the terminal, one line each.
struct OnTerminal<'a> {
    manner: &'a Manner,
}

impl Listener for OnTerminal<'_> {
    fn is_asked_to_stop(&self) -> bool {
        signals::asked_to_stop()
    }

    fn text_of(&self, why: &Both) -> String {
        why.text(self.manner.language()).to_owned()
    }

    fn begins(&self, folder: &Path, structure: &str, survey: &str) {
        if !self.manner.quiet {
            let said = Noted::Following {
                folder: folder.display().to_string(),
                structure: structure.to_owned(),
                survey: survey.to_owned(),
            };
            note!("{}", said.text(self.manner));
        }
    }

    fn record(&self, of: &FollowedRecord<'_>) -> Result<()> {
        let judged = JudgedRecord {
            verdict: of.verdict,
            open_alarms: of.open_alarms,
            sensors: of.sensors,
        };
        match self.manner.json {
            true => say(&format!(
                "{}\n",
                followed_json(of.survey, of.file, of.taken, &judged)
            )),
            false => say(&followed_text(
                of.survey,
                of.file,
                of.taken,
                &judged,
                self.manner.language(),
            )),
        }
    }

    fn again(&self, file: &str, known_as: &str) {
        if !self.manner.quiet {
            let said = Noted::CameAgain {
                file: file.to_owned(),
                known_as: known_as.to_owned(),
            };
            note!("{}", said.text(self.manner));
        }
    }

    fn quarantined(&self, of: &Quarantined<'_>) -> Result<()> {
        match self.manner.json {
            true => say(&format!("{}\n", quarantined_json(of.file, of.place, of.why))),
            false => say(&quarantined_text(
                of.file,
                of.place,
                of.why,
                self.manner.language(),
            )),
        }
    }

    fn complain(&self, fault: &anyhow::Error) {
        complain(fault, self.manner);
    }

    fn still_written(&self, files: usize) {
        if !self.manner.quiet {
            note!("{}", Noted::StillWritten(files).text(self.manner));
        }
    }
}
