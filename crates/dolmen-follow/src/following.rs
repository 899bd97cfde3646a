//! Looks at a folder repeatedly: reads, stores and judges new files.

use crate::call::Call;
use crate::clock::{now_s, now_us};
use crate::listener::{FollowedRecord, Listener, Quarantined};
use crate::options::Follow;
use crate::read::{ReadFile, Reader, name_of};
use crate::state::{State, only_structure};
use crate::wrong::{FollowError, store_failure};
use anyhow::{Context as _, Result};
use dolmen_folder::{Inbox, Look, move_into, quarantine, quarantined, read, write};
use dolmen_records::{Log, TABLE_BYTES_MOST, read_log};
use dolmen_report::kept::metrics_text;
use dolmen_store::{Act, Arrived, Arriving, Incoming, Keeper, Kept, Store};
use dolmen_words::message::Both;
use dolmen_work::follow::{OpenAlarm, Taken, Verdict, moment_of, open_alarms, sensor_change, verdict};
use dolmen_work::sensor_alarms::SensorFault;
use dolmen_work::watch::{SURVEYS_LEAST, watch_observed};
use dolmen_work::watched::WatchAnswer;
use dolmen_work::{ChangeFault, WorkError};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Files that each thread reads before they are stored: enough to keep all threads busy, few enough that little is lost if the
/// process dies.
const FILES_A_THREAD: usize = 4;
/// Largest number of records of the same second that get distinct names.
const SAME_SECOND_MOST: usize = 1000;
/// Interval at which a wait checks whether to stop.
const STOP_TICK: Duration = Duration::from_millis(100);

struct Following<'a> {
    options: &'a Follow,
    listener: &'a dyn Listener,
    store: Store,
    keeper: Keeper,
    structure: String,
    quarantine: PathBuf,
    inbox: Inbox,
    state: State,
    /// Hashes of the structure's records, each with its original file name.
    known: BTreeMap<String, String>,
    /// Number of records from watched folders that `state` includes.
    arrivals: u64,
    /// The history after the last record.
    answer: Option<WatchAnswer>,
    last_survey_s: Option<f64>,
    /// Log of the air temperature, read at the last look at the folder.
    temperature: Option<Log>,
}

/// Processes new record files in a folder until the listener asks to stop, or once. Returns whether the structure alarms at the end.
///
/// # Errors
/// If the folder, the store or the structure does not exist. With [`Follow::once`], any fault; otherwise faults go to the listener and
/// are retried.
pub fn follow(options: &Follow, listener: &dyn Listener) -> Result<bool> {
    let mut following = Following::begin(options, listener)?;
    following.judge()?;
    loop {
        let begun = Instant::now();
        match following.round() {
            Ok(growing) if options.once && growing > 0 => {
                pause(begun, options.rest, listener);
                following.round()?;
                listener.still_written(growing);
                break;
            }
            Err(fault) if options.once => return Err(fault),
            // the store may be busy or the folder away: try again in the next round
            Err(fault) => listener.complain(&fault),
            Ok(_) => {}
        }
        if options.once || listener.is_asked_to_stop() {
            break;
        }
        pause(begun, options.every, listener);
        if listener.is_asked_to_stop() {
            break;
        }
    }
    Ok(following.alarms().iter().any(OpenAlarm::is_of_structure))
}

/// Waits until `long` after `since`, or until the listener asks to stop.
fn pause(since: Instant, long: Duration, listener: &dyn Listener) {
    while since.elapsed() < long && !listener.is_asked_to_stop() {
        std::thread::sleep(STOP_TICK.min(long.saturating_sub(since.elapsed())));
    }
}

impl<'a> Following<'a> {
    fn begin(of: &'a Follow, listener: &'a dyn Listener) -> Result<Self> {
        let mut inbox = Inbox::new(&of.folder, of.rest)?;
        drop(Store::open(&of.store, of.wait).map_err(store_failure)?); // the store must exist
        for path in of.store.own_files() {
            inbox = inbox.passing_over(&path);
        }
        for path in of.metrics.iter().chain(&of.temperature) {
            inbox = inbox.passing_over(path);
        }
        let mut store = Store::open_to_write(&of.store, of.wait, now_us()).map_err(store_failure)?;
        let structure = match &of.structure {
            Some(name) => name.clone(),
            None => only_structure(&mut store)?,
        };
        let keeper = store.keeper().map_err(store_failure)?;
        let arrivals = store.arrivals(&structure).map_err(store_failure)?;
        let state = State::of(&mut store, &structure)?;
        let known = store.records(&structure).map_err(store_failure)?;
        listener.begins(&of.folder, &structure, state.pattern.survey());
        let names = state
            .history
            .project
            .surveys
            .iter()
            .map(|survey| survey.name.as_str());
        let last_survey_s = names.filter_map(moment_of).max_by(f64::total_cmp);
        Ok(Following {
            options: of,
            listener,
            quarantine: of
                .quarantine
                .clone()
                .unwrap_or_else(|| of.folder.join("quarantine")),
            store,
            keeper,
            structure,
            inbox,
            state,
            known,
            arrivals,
            answer: None,
            last_survey_s,
            temperature: None,
        })
    }

    /// Processes the existing files; returns the number of files that are still being written.
    fn round(&mut self) -> Result<usize> {
        let project = self.store.state(&self.structure).map_err(store_failure)?;
        let arrivals = self.store.arrivals(&self.structure).map_err(store_failure)?;
        // another process stored some, or our own transaction succeeded but its reply was lost
        if project != self.state.project || arrivals != self.arrivals {
            self.arrivals = arrivals;
            self.state = State::of(&mut self.store, &self.structure)?;
            self.judge()?;
        }
        self.temperature = self.read_temperature()?;
        let mut lying = self.inbox.look()?;
        // the oldest first, so that a backlog is judged in order
        lying
            .at_rest
            .sort_by(|a, b| a.1.modified.cmp(&b.1.modified).then(a.0.cmp(&b.0)));
        let together = FILES_A_THREAD * rayon::current_num_threads();
        for some in lying.at_rest.chunks(together) {
            if self.listener.is_asked_to_stop() {
                break;
            }
            self.take(some)?;
        }
        self.write_metrics()?;
        Ok(lying.growing)
    }

    fn read_temperature(&self) -> Result<Option<Log>> {
        let Some(path) = &self.options.temperature else {
            return Ok(None);
        };
        let bytes = read(path, self.options.access.most(TABLE_BYTES_MOST))?;
        let column = self.options.temperature_column.as_deref();
        let context = || path.display().to_string();
        Ok(Some(read_log(&bytes, column).with_context(context)?))
    }

    /// Reads and identifies files in parallel, then stores them one by one, judges the history and reports each result.
    fn take(&mut self, some: &[(PathBuf, Look)]) -> Result<()> {
        let reader = Reader {
            access: self.options.access,
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
                ReadFile::Known(hash) => {
                    let name = name_of(&of.0);
                    if let Some(known_as) = self.known.get(&hash).filter(|own| **own != name) {
                        self.listener.again(&name, known_as);
                    }
                    self.put_away(of);
                }
                ReadFile::Unreadable(why) => {
                    if let Err(fault) = self.quarantine(&of.0, &why) {
                        self.leave(of, &fault);
                    }
                }
                ReadFile::NotKept(fault) => return Err(store_failure(fault)),
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

    /// Stores a record as a survey; returns its name, or `None` if a survey already has this record.
    fn store(&mut self, path: &Path, taken: &Taken, kept: Kept) -> Result<Option<String>> {
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
                    earthquakes: BTreeMap::new(), // its own table states it
                },
                survey: &survey.name,
                own_text: &survey.own_text,
                came_as: &name_of(path),
            };
            let act = Act {
                who: &self.options.who,
                now_us: now_us(),
            };
            let arrived = self.store.arrive(&arriving, &act);
            match arrived.map_err(store_failure)? {
                Arrived::Stored => {
                    self.known.insert(hash, name_of(path));
                    self.arrivals += 1;
                    survey.put_into(&mut self.state.history);
                    self.state.observed.faults.insert(survey.name.clone(), faults);
                    if let Some(observed) = taken.observed() {
                        self.state.observed.modes.insert(survey.name.clone(), observed);
                    }
                    let at_s = taken.time.at_s;
                    self.last_survey_s = Some(self.last_survey_s.map_or(at_s, |last| last.max(at_s)));
                    return Ok(Some(survey.name));
                }
                Arrived::There => {
                    let name = name_of(path);
                    let known_as = self.known.entry(hash).or_insert_with(|| name.clone());
                    if *known_as != name {
                        self.listener.again(&name, known_as);
                    }
                    return Ok(None);
                }
                Arrived::NameTaken => {}
            }
        }
        Err(FollowError::TooManyOfOneSecond {
            survey: taken.time.name.clone(),
            most: SAME_SECOND_MOST,
        }
        .into())
    }

    /// Judges the history again.
    fn judge(&mut self) -> Result<()> {
        self.answer = match watch_observed(&self.state.history, &self.state.observed, &self.state.logs) {
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
        let days = self.state.days_with_modes();
        let verdict = match &self.answer {
            _ if taken.earthquake.is_some() => Verdict::Earthquake,
            Some(answer) if days >= SURVEYS_LEAST => verdict(answer, survey),
            _ => Verdict::TooFew {
                given: days,
                least: SURVEYS_LEAST,
            },
        };
        // in a backlog, a survey is judged without the later records
        let day = dolmen_work::day_of_a_record(survey);
        let is_known = |alarm: &&OpenAlarm| day.is_none_or(|day| alarm.date.as_str() <= day);
        let alarms = self.alarms();
        let of_structure = alarms.iter().filter(|alarm| alarm.is_of_structure());
        let open = of_structure.filter(is_known).count();
        self.listener.record(&FollowedRecord {
            survey,
            file: &name_of(path),
            taken,
            verdict: &verdict,
            open_alarms: open,
            sensors: self
                .answer
                .as_ref()
                .and_then(|answer| sensor_change(answer, survey)),
        })
    }

    /// Finishes a file that is in the store: moves it or marks it as done.
    fn put_away(&mut self, of: &(PathBuf, Look)) {
        match &self.options.taken {
            Some(folder) => {
                if let Err(fault) = move_into(folder, &of.0) {
                    self.leave(of, &fault);
                }
            }
            None => self.inbox.set_done(&of.0, of.1),
        }
    }

    /// Reports a file that cannot be moved and skips it, so that others are processed.
    fn leave(&mut self, (path, look): &(PathBuf, Look), fault: &anyhow::Error) {
        self.listener.complain(fault);
        self.inbox.set_done(path, *look);
    }

    fn quarantine(&mut self, path: &Path, why: &Both) -> Result<()> {
        let text = self.listener.text_of(why) + "\n";
        let place = quarantine(&self.quarantine, path, &text)?;
        self.listener.quarantined(&Quarantined {
            file: &name_of(path),
            place: &self.quarantine.join(name_of(&place)).display().to_string(),
            why,
        })
    }

    /// Runs the program of `--on-alarm` for each alarm that was not called yet; a failed call is repeated after the next record.
    fn call(&mut self) -> Result<()> {
        let (Some(program), Some(answer)) = (&self.options.on_alarm, &self.answer) else {
            return Ok(());
        };
        let alarms = open_alarms(answer);
        let tilt_beyond = answer.lean_beyond();
        for alarm in &alarms {
            let is_called = self.store.is_called(&self.structure, &alarm.key);
            if is_called.map_err(store_failure)? {
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
                self.listener.complain(&fault);
                continue;
            }
            let act = Act {
                who: &self.options.who,
                now_us: now_us(),
            };
            let called = self.store.set_called(&self.structure, &alarm.key, &act);
            called.map_err(store_failure)?;
        }
        Ok(())
    }

    fn write_metrics(&self) -> Result<()> {
        let Some(path) = &self.options.metrics else {
            return Ok(());
        };
        let counts = (self.last_survey_s, quarantined(&self.quarantine), now_s());
        let text = metrics_text(&self.structure, self.answer.as_ref(), &self.alarms(), counts);
        write(path, text.as_bytes())
    }
}
