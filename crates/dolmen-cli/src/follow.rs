//! `dolmen watch --follow`: record files that come into a folder become surveys of a structure in a store.

use crate::cli::Watch;
use crate::cli_survey::StoreWhere;
use crate::follow_read::{ReadFile, Reader, name_of, now_s};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::say::say;
use crate::signals;
use crate::survey::Where;
use crate::tools::complain;
use crate::watch_call::{Call, judged};
use crate::wrong::{CommandError, Noted};
use anyhow::{Context as _, Result};
use dolmen::modal::ObservedMode;
use dolmen_folder::{Inbox, Look, move_into, quarantine, quarantined, read, write};
use dolmen_records::{Log, TABLE_BYTES_MOST, read_log};
use dolmen_report::kept::{followed_json, followed_text, metrics_text, quarantined_json, quarantined_text};
use dolmen_store::{Act, Arrived, Arriving, Incoming, Keeper, Kept, Search, Store, StoredFiles};
use dolmen_words::message::Both;
use dolmen_work::follow::{OpenAlarm, Pattern, Taken, Verdict, moment_of, open_alarms, verdict};
use dolmen_work::logs::Logs;
use dolmen_work::sensor_alarms::{SensorFault, SensorFaults};
use dolmen_work::watch::{SURVEYS_LEAST, watch_observed};
use dolmen_work::watched::WatchAnswer;
use dolmen_work::{ChangeFault, Opened, WorkError};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Files a thread that are read before they are stored: enough to keep all at work, few enough that little is lost with the process.
const FILES_A_THREAD: usize = 4;
/// Records of one second that get a name each.
const SAME_SECOND_MOST: usize = 1000;
/// How often a wait looks for a signal.
const SIGNAL_TICK: Duration = Duration::from_millis(100);

/// The state of the structure that records are taken with.
struct State {
    project: String,
    pattern: Pattern,
    files: StoredFiles,
    history: Opened,
    observed: BTreeMap<String, Vec<ObservedMode>>,
    faults: SensorFaults,
    logs: Logs,
}

struct Following<'a> {
    options: &'a Watch,
    at: Where<'a>,
    store: Store,
    keeper: Keeper,
    structure: String,
    quarantine: PathBuf,
    inbox: Inbox,
    state: State,
    known: BTreeSet<String>,
    /// What the history says after the last record.
    answer: Option<WatchAnswer>,
    last_survey_s: Option<f64>,
    /// Temperature of the air over time, as it was when the folder was looked at.
    temperature: Option<Log>,
}

pub(crate) fn follow(folder: &Path, options: &Watch, manner: &Manner) -> Result<Outcome> {
    signals::watch();
    let place = StoreWhere {
        store: options.store.clone(),
        who: None,
        wait: 60.0,
    };
    let at = Where {
        options: &place,
        manner,
    };
    let mut following = Following::begin(folder, options, at)?;
    let every = Duration::from_secs_f64(options.follow.every.min(1e6));
    let rest = Duration::from_secs_f64(options.follow.rest.min(1e6));
    following.judge()?;
    loop {
        let begun = Instant::now();
        match following.round() {
            Ok(growing) if options.follow.once && growing > 0 => {
                pause(begun, rest);
                following.round()?;
                following.say_growing(growing);
                break;
            }
            Err(fault) if options.follow.once => return Err(fault),
            // a store that is busy, a folder that is away: the next round may find it
            Err(fault) => complain(&fault, manner),
            Ok(_) => {}
        }
        if options.follow.once || signals::asked_to_stop() {
            break;
        }
        pause(begun, every);
        if signals::asked_to_stop() {
            break;
        }
    }
    Ok(judged(following.alarms().iter().any(OpenAlarm::is_of_structure)))
}

/// Waits until so long after a moment, or until a signal asks to stop.
fn pause(since: Instant, long: Duration) {
    while since.elapsed() < long && !signals::asked_to_stop() {
        std::thread::sleep(SIGNAL_TICK.min(long.saturating_sub(since.elapsed())));
    }
}

impl<'a> Following<'a> {
    fn begin(folder: &Path, options: &'a Watch, at: Where<'a>) -> Result<Self> {
        let of = &options.follow;
        let rest = Duration::from_secs_f64(of.rest.min(1e6));
        let mut inbox = Inbox::new(folder, rest)?;
        drop(at.open()?); // a store that is not there is not made
        let place = at.file();
        for beside in ["", "-wal", "-shm", "-journal"] {
            inbox = inbox.passing_over(Path::new(&format!("{place}{beside}")));
        }
        for path in of.metrics.iter().chain(&of.temperature) {
            inbox = inbox.passing_over(path);
        }
        let mut store = at.open_to_write()?;
        let structure = match &of.structure {
            Some(name) => name.clone(),
            None => only_structure(&mut store, &at)?,
        };
        let keeper = store.keeper().map_err(|fault| at.told(fault))?;
        let state = State::of(&mut store, &structure, &at)?;
        let known = store.records(&structure).map_err(|fault| at.told(fault))?;
        if !at.manner.quiet {
            let said = Noted::Following {
                folder: folder.display().to_string(),
                structure: structure.clone(),
                survey: state.pattern.survey().to_owned(),
            };
            note!("{}", said.text(at.manner));
        }
        let names = state
            .history
            .project
            .surveys
            .iter()
            .map(|survey| survey.name.as_str());
        let last_survey_s = names.filter_map(moment_of).max_by(f64::total_cmp);
        Ok(Following {
            options,
            quarantine: of.quarantine.clone().unwrap_or_else(|| folder.join("quarantine")),
            at,
            store,
            keeper,
            structure,
            inbox,
            state,
            known,
            answer: None,
            last_survey_s,
            temperature: None,
        })
    }

    /// Takes what is there; how many files are not at rest yet.
    fn round(&mut self) -> Result<usize> {
        let project = self.store.state(&self.structure);
        if project.map_err(|fault| self.at.told(fault))? != self.state.project {
            self.state = State::of(&mut self.store, &self.structure, &self.at)?;
            self.judge()?;
        }
        self.temperature = self.read_temperature()?;
        let mut lying = self.inbox.look()?;
        // the oldest first, so that a backlog is judged as it came
        lying
            .at_rest
            .sort_by(|a, b| a.1.modified.cmp(&b.1.modified).then(a.0.cmp(&b.0)));
        let together = FILES_A_THREAD * rayon::current_num_threads();
        for some in lying.at_rest.chunks(together) {
            if signals::asked_to_stop() {
                break;
            }
            self.take(some)?;
        }
        self.write_metrics()?;
        Ok(lying.growing)
    }

    fn read_temperature(&self) -> Result<Option<Log>> {
        let Some(path) = &self.options.follow.temperature else {
            return Ok(None);
        };
        let bytes = read(path, self.at.manner.access().most(TABLE_BYTES_MOST))?;
        let column = self.options.follow.temperature_column.as_deref();
        let context = || path.display().to_string();
        Ok(Some(read_log(&bytes, column).with_context(context)?))
    }

    /// Reads and identifies files together, then stores them one by one, judges the history and says what it says of each.
    fn take(&mut self, some: &[(PathBuf, Look)]) -> Result<()> {
        let reader = Reader {
            access: self.at.manner.access(),
            pattern: &self.state.pattern,
            files: &self.state.files,
            known: &self.known,
            keeper: &self.keeper,
        };
        let each = some.par_iter().map(|(path, look)| reader.read(path, *look));
        let read: Vec<ReadFile> = each.collect();
        let mut records = Vec::new();
        for (of, file) in some.iter().zip(read) {
            match file {
                ReadFile::Later => {}
                ReadFile::Known => self.put_away(of),
                ReadFile::Unreadable(why) => {
                    if let Err(fault) = self.quarantine(&of.0, &why) {
                        self.leave(of, &fault);
                    }
                }
                ReadFile::NotKept(fault) => return Err(self.at.told(fault)),
                ReadFile::Record(found) => records.push((of, *found)),
            }
        }
        records.sort_by(|(a, (one, _)), (b, (other, _))| {
            one.time.name.cmp(&other.time.name).then(a.0.cmp(&b.0))
        });
        let mut stored = Vec::new();
        for (of, (taken, kept)) in records {
            if let Some(survey) = self.store(&of.0, &taken, kept)? {
                stored.push((of, survey, taken));
            } else {
                self.put_away(of);
            }
        }
        if stored.is_empty() {
            return Ok(());
        }
        self.judge()?;
        for (of, survey, taken) in stored {
            self.say_record(&survey, &of.0, &taken)?;
            self.put_away(of);
        }
        self.call()
    }

    /// Stores a record as a survey; its name, or none where a survey has this record already.
    fn store(&mut self, path: &Path, taken: &Taken, kept: Kept) -> Result<Option<String>> {
        let who = self.at.who();
        let hash = kept.hash.clone();
        let faults: Vec<(String, SensorFault)> = taken.faults.iter().map(SensorFault::of).collect();
        let temperature_c = self.temperature.as_ref().and_then(|log| taken.temperature_c(log));
        for number in 1..=SAME_SECOND_MOST {
            let survey = self
                .state
                .pattern
                .survey_of(taken, number, temperature_c, &self.state.files)?;
            let modes = taken.modes.as_ref().ok().cloned();
            let arriving = Arriving {
                incoming: Incoming {
                    structure: &self.structure,
                    project: &survey.opened.project,
                    text: &survey.opened.text,
                    text_kept: kept.clone(),
                    files: BTreeMap::from([(survey.path.clone(), kept.clone())]),
                    modes: modes
                        .map(|modes| (survey.name.clone(), modes))
                        .into_iter()
                        .collect(),
                    faults: BTreeMap::from([(survey.name.clone(), faults.clone())]),
                },
                survey: &survey.name,
                own_text: &survey.own_text,
                came_as: &name_of(path),
            };
            let act = Act {
                who: &who,
                now_us: crate::survey::now_us(),
            };
            let arrived = self.store.arrive(&arriving, &act);
            match arrived.map_err(|fault| self.at.told(fault))? {
                Arrived::Stored => {
                    self.known.insert(hash);
                    survey.put_into(&mut self.state.history);
                    self.state.faults.insert(survey.name.clone(), faults);
                    if let Some(observed) = taken.observed() {
                        self.state.observed.insert(survey.name.clone(), observed);
                    }
                    let at_s = taken.time.at_s;
                    self.last_survey_s = Some(self.last_survey_s.map_or(at_s, |last| last.max(at_s)));
                    return Ok(Some(survey.name));
                }
                Arrived::There => {
                    self.known.insert(hash);
                    return Ok(None);
                }
                Arrived::NameTaken => {}
            }
        }
        Err(CommandError::TooManyOfOneSecond {
            survey: taken.time.name.clone(),
            most: SAME_SECOND_MOST,
        }
        .into())
    }

    /// What the history says now.
    fn judge(&mut self) -> Result<()> {
        self.answer = match watch_observed(
            &self.state.history,
            &self.state.observed,
            &self.state.faults,
            &self.state.logs,
        ) {
            Ok(answer) => Some(answer),
            Err(WorkError::Change(why)) if matches!(*why, ChangeFault::TooFewToWatch { .. }) => None,
            Err(why) => return Err(why.into()),
        };
        Ok(())
    }

    fn alarms(&self) -> Vec<OpenAlarm> {
        self.answer.as_ref().map(open_alarms).unwrap_or_default()
    }

    fn say_record(&self, survey: &str, path: &Path, taken: &Taken) -> Result<()> {
        let verdict = match &self.answer {
            Some(answer) => verdict(answer, survey),
            None => Verdict::TooFew {
                given: self.state.days_with_modes(),
                least: SURVEYS_LEAST,
            },
        };
        let (manner, file) = (self.at.manner, name_of(path));
        let open = self
            .alarms()
            .iter()
            .filter(|alarm| alarm.is_of_structure())
            .count();
        let judged = (&verdict, open);
        match manner.json {
            true => say(&format!("{}\n", followed_json(survey, &file, taken, judged))),
            false => say(&followed_text(survey, &file, taken, judged, manner.language())),
        }
    }

    /// Done with a file that is in the store.
    fn put_away(&mut self, of: &(PathBuf, Look)) {
        match &self.options.follow.taken {
            Some(folder) => {
                if let Err(fault) = move_into(folder, &of.0) {
                    self.leave(of, &fault);
                }
            }
            None => self.inbox.set_done(&of.0, of.1),
        }
    }

    /// A file that cannot be moved stays where it is, and does not hold up the others.
    fn leave(&mut self, (path, look): &(PathBuf, Look), fault: &anyhow::Error) {
        complain(fault, self.at.manner);
        self.inbox.set_done(path, *look);
    }

    fn quarantine(&mut self, path: &Path, why: &Both) -> Result<()> {
        let manner = self.at.manner;
        let text = why.text(manner.language()).to_owned() + "\n";
        let place = quarantine(&self.quarantine, path, &text)?;
        let (file, place) = (
            name_of(path),
            self.quarantine.join(name_of(&place)).display().to_string(),
        );
        match manner.json {
            true => say(&format!("{}\n", quarantined_json(&file, &place, why))),
            false => say(&quarantined_text(&file, &place, why, manner.language())),
        }
    }

    /// Runs the program of `--on-alarm` for each alarm that it was not run for; where it fails, it is run again after the next record.
    fn call(&mut self) -> Result<()> {
        let (Some(program), Some(answer)) = (&self.options.on_alarm, &self.answer) else {
            return Ok(());
        };
        let alarms = open_alarms(answer);
        let tilt_beyond = answer.lean_beyond();
        let who = self.at.who();
        for alarm in &alarms {
            let is_called = self.store.is_called(&self.structure, &alarm.key);
            if is_called.map_err(|fault| self.at.told(fault))? {
                continue;
            }
            let call = Call {
                structure: &self.structure,
                survey: answer.surveys.last().map_or("", |last| &last.name),
                open_alarms: answer.open_alarms(),
                tilt_beyond,
                kind: Some([alarm.sort.word(), &alarm.date]),
            };
            if let Err(fault) = call.run(program) {
                complain(&fault, self.at.manner);
                continue;
            }
            let act = Act {
                who: &who,
                now_us: crate::survey::now_us(),
            };
            let called = self.store.set_called(&self.structure, &alarm.key, &act);
            called.map_err(|fault| self.at.told(fault))?;
        }
        Ok(())
    }

    fn write_metrics(&self) -> Result<()> {
        let Some(path) = &self.options.follow.metrics else {
            return Ok(());
        };
        let counts = (self.last_survey_s, quarantined(&self.quarantine), now_s());
        let text = metrics_text(&self.structure, self.answer.as_ref(), &self.alarms(), counts);
        write(path, text.as_bytes())
    }

    fn say_growing(&self, files: usize) {
        if !self.at.manner.quiet {
            note!("{}", Noted::StillWritten { files }.text(self.at.manner));
        }
    }
}

impl State {
    fn of(store: &mut Store, structure: &str, at: &Where<'_>) -> Result<Self> {
        let told = |fault| at.told(fault);
        let project = store.state(structure).map_err(told)?;
        let exported = store.export(structure).map_err(told)?;
        let files = store.files(&exported);
        let read = |bytes: &[u8]| {
            let text = String::from_utf8_lossy(bytes).into_owned();
            Opened::read(text, structure.to_owned(), &files)
        };
        let pattern = Pattern::of(read(exported.text.get(..exported.own_bytes).unwrap_or_default())?)?;
        let history = read(&exported.text)?;
        Ok(State {
            logs: Logs::read(&history.project, &files)?,
            project,
            pattern,
            history,
            observed: store.observed(structure).map_err(told)?,
            faults: store.faults(structure).map_err(told)?,
            files,
        })
    }

    fn days_with_modes(&self) -> usize {
        let days: BTreeSet<&str> = self
            .observed
            .iter()
            .filter(|(_, modes)| !modes.is_empty())
            .map(|(name, _)| dolmen_work::day_of_a_record(name).unwrap_or(name))
            .collect();
        days.len()
    }
}

/// The structure of a store that has one.
fn only_structure(store: &mut Store, at: &Where<'_>) -> Result<String> {
    let mut names = Vec::new();
    let all = store.structures(&Search::default(), &mut |row| {
        names.push(row.name);
        Ok(())
    });
    all.map_err(|fault| at.told(fault))?;
    match <[String; 1]>::try_from(names) {
        Ok([name]) => Ok(name),
        Err(names) => Err(CommandError::WhichStructure {
            count: names.len(),
            first: names.into_iter().take(5).collect(),
        }
        .into()),
    }
}
