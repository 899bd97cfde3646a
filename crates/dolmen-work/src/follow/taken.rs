//! A record of a watched folder: read with the settings of the project's latest survey, and identified.

use super::when::{RecordTime, record_time};
use crate::air::air_temperature_c;
use crate::error::WorkError;
use crate::identify;
use crate::left_out::without;
use crate::opened::Opened;
use crate::progress::Silent;
use crate::record;
use crate::survey_dates::{date, day_of};
use crate::surveyed::Earthquake;
use dolmen::modal::{Modes, ObservedMode, SensorDoubt};
use dolmen::signal::{Channel, ChannelFault};
use dolmen_project::{LikeSurvey, Survey, survey_like};
use dolmen_records::{FileError, Files, Log};
use dolmen_words::message::Both;
use std::sync::Arc;

/// Folder for records of a watched folder in an exported project.
const FOLDER: &str = "followed";
/// Longest file ending that is kept, in letters.
const ENDING_MOST: usize = 8;

/// The survey whose settings apply to such records.
#[derive(Clone, Debug)]
pub struct Pattern {
    opened: Opened,
    survey: String,
}

/// A file of the watched folder.
#[derive(Clone, Debug)]
pub struct RecordFile<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its bytes.
    pub bytes: &'a [u8],
    /// Time of the last change of the file, s from 1 January 1970 (UTC).
    pub modified_s: f64,
}

/// Results of a record.
#[derive(Debug)]
pub struct Taken {
    /// Its time.
    pub time: RecordTime,
    /// Its length, s.
    pub duration_s: f64,
    /// Faults of its channels.
    pub faults: Vec<ChannelFault>,
    /// Contradictions between its sensors.
    pub doubts: Vec<SensorDoubt>,
    /// Channels left out because of their faults.
    pub left_out: Vec<String>,
    /// The earthquake in it. Its modes are then not stored, because they are not those of an ambient survey.
    pub earthquake: Option<Earthquake>,
    /// Strong shaking in it, perhaps traffic; its modes are those of the rest of the record.
    pub shaking: Option<Earthquake>,
    /// Its modes, or the reason why there are none.
    pub modes: Result<Modes, WorkError>,
    came_as: String,
    ending: Option<String>,
}

/// A survey from a record.
#[derive(Clone, Debug)]
pub struct TakenSurvey {
    /// Its name.
    pub name: String,
    /// Path of its record in the folder of the project.
    pub path: String,
    /// Its table, as text to append to the project file.
    pub own_text: String,
    /// The project with it.
    pub opened: Opened,
}

/// Source of a single file by its name.
struct OneFile<'a> {
    name: &'a str,
    bytes: &'a [u8],
}

impl Files for OneFile<'_> {
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError> {
        let shown = self.name.to_owned();
        match self.bytes.len() as u64 {
            _ if name != self.name => Err(FileError::Absent { shown }),
            bytes if bytes > most_bytes => Err(FileError::TooLarge {
                shown,
                bytes,
                most: most_bytes,
            }),
            _ => Ok(self.bytes.to_vec()),
        }
    }
}

impl Pattern {
    /// The latest survey of a project with its record in one file: by date, otherwise the last in the file.
    ///
    /// # Errors
    /// [`WorkError::NoneToFollow`].
    pub fn of(opened: Opened) -> Result<Self, WorkError> {
        let surveys = opened.project.surveys.iter().enumerate();
        let usable = surveys.filter(|(_, survey)| {
            let records = survey.records.as_ref();
            records.is_some_and(|source| source.stations.is_empty())
        });
        let latest = usable.max_by(|(i, a), (j, b)| {
            let day = |survey: &Survey| date(&survey.name).map_or(f64::NEG_INFINITY, day_of);
            day(a).total_cmp(&day(b)).then(i.cmp(j))
        });
        match latest {
            Some((_, survey)) => Ok(Pattern {
                survey: survey.name.clone(),
                opened,
            }),
            None => Err(WorkError::NoneToFollow),
        }
    }

    /// The survey.
    pub fn survey(&self) -> &str {
        &self.survey
    }

    /// The project from the store.
    pub fn opened(&self) -> &Opened {
        &self.opened
    }

    /// The project with a survey under its own settings, and the text of that survey.
    fn with(&self, settings: &LikeSurvey<'_>, files: &dyn Files) -> Result<(Opened, String), WorkError> {
        let own = survey_like(&self.opened.text, &self.survey, settings);
        let own = own.ok_or(WorkError::NoneToFollow)?;
        let text = self.opened.text.clone() + &own;
        let opened = Opened::read(text, self.opened.file.clone(), files)?;
        Ok((opened, own))
    }

    /// Reads a record with the settings of the survey and identifies its modes; `rest` gives the other files of the project, and `now_s` the
    /// clock, s from 1970.
    ///
    /// # Errors
    /// If the record cannot be read with these settings. A record without modes is not an error.
    pub fn take(&self, file: &RecordFile<'_>, rest: &dyn Files, now_s: f64) -> Result<Taken, WorkError> {
        const UNNAMED: &str = "arriving";
        let came_as = plain(file.name);
        let with = |ending: Option<&str>| {
            let own = LikeSurvey {
                name: UNNAMED,
                file: &path_of(UNNAMED, ending),
                note: &note_of(&came_as),
                temperature_c: None,
                left_out: &[],
                earthquake: None,
            };
            self.with(&own, rest)
        };
        // a file without a known ending is read in the format of the survey's record
        let own = ending(file.name);
        let (opened, ending) = match with(own.as_deref()) {
            Ok((opened, _)) => (opened, own),
            Err(why) => match with(self.ending().as_deref()) {
                Ok((opened, _)) => (opened, self.ending()),
                Err(_) => return Err(why),
            },
        };
        let source = survey(&opened, UNNAMED).and_then(|survey| survey.records.clone());
        let mut source = source.ok_or(WorkError::NoneToFollow)?;
        came_as.clone_into(&mut source.file);
        let files = OneFile {
            name: &came_as,
            bytes: file.bytes,
        };
        let read = record::record_to_identify(&source, &files)?;
        let time = record_time(read.begins_s, file.name, file.modified_s, now_s);
        let duration_s = read.samples as f64 / read.sampling_rate_hz;
        let faults = read.faults.clone();
        let mut found = identify::of_opened(&source, read, &Silent);
        let mut left_out = Vec::new();
        // a failing sensor must not stop the others
        while let Some(failed) = found.as_ref().err().and_then(|why| without(why, &mut source)) {
            left_out.extend(failed);
            found = identify::of_opened(&source, record::record_to_identify(&source, &files)?, &Silent);
        }
        let (modes, doubts, earthquake) = match found {
            Ok((answer, _)) => {
                let mut modes = answer.analysis.modes;
                let is_one = answer.earthquake.as_ref().is_some_and(Earthquake::is_one);
                if is_one || answer.earthquake.as_ref().is_some_and(Earthquake::is_shaken) {
                    modes.modes.clear();
                }
                (Ok(modes), answer.doubts, answer.earthquake)
            }
            Err(why) => (Err(why), Vec::new(), None),
        };
        let (earthquake, shaking) = match earthquake {
            Some(of) if !of.is_one() => (None, Some(of)),
            of => (of, None),
        };
        Ok(Taken {
            time,
            duration_s,
            faults,
            doubts,
            left_out,
            earthquake,
            shaking,
            modes,
            came_as,
            ending,
        })
    }

    /// The ending of the record of the survey.
    fn ending(&self) -> Option<String> {
        let source = survey(&self.opened, &self.survey)?.records.as_ref()?;
        ending(&source.file)
    }

    /// The survey made from a record: named by its time, with a number after it if the name exists.
    ///
    /// # Errors
    /// The project cannot be read with it.
    pub fn survey_of(
        &self,
        taken: &Taken,
        number: usize,
        temperature_c: Option<f64>,
        rest: &dyn Files,
    ) -> Result<TakenSurvey, WorkError> {
        let name = match number {
            0 | 1 => taken.time.name.clone(),
            number => format!("{} ({number})", taken.time.name),
        };
        let path = path_of(&name, taken.ending.as_deref());
        let own = LikeSurvey {
            name: &name,
            file: &path,
            note: &note_of(&taken.came_as),
            temperature_c,
            left_out: &taken.left_out,
            earthquake: taken.earthquake.as_ref().map(Earthquake::part),
        };
        let (opened, own_text) = self.with(&own, rest)?;
        Ok(TakenSurvey {
            name,
            path,
            own_text,
            opened,
        })
    }
}

fn note_of(came_as: &str) -> String {
    format!("came as {came_as}")
}

fn survey<'a>(opened: &'a Opened, name: &str) -> Option<&'a Survey> {
    opened.project.surveys.iter().find(|survey| survey.name == name)
}

impl TakenSurvey {
    /// Adds it to the project of a history.
    pub fn put_into(&self, history: &mut Opened) {
        if let Some(own) = survey(&self.opened, &self.name) {
            Arc::make_mut(&mut history.project).surveys.push(own.clone());
        }
    }
}

impl Taken {
    /// The air temperature during the record, from a log, °C to a tenth: the mean over its time, or over its day if only the day is known,
    /// otherwise the nearest reading within an hour; `None` without a plausible reading.
    pub fn temperature_c(&self, log: &Log) -> Option<f64> {
        let is_moment = self.time.name.contains('T');
        air_temperature_c(log, self.time.at_s, is_moment.then_some(self.duration_s))
    }

    /// Its modes in the form in which a store returns them.
    pub fn observed(&self) -> Option<Vec<ObservedMode>> {
        let mut all = ObservedMode::all(self.modes.as_ref().ok()?, 0);
        for point in all.iter_mut().flat_map(|mode| &mut mode.shape) {
            point.channel = Channel::named(point.channel.name.clone());
        }
        Some(all)
    }

    /// Why there are no modes, in both languages.
    pub fn without_modes(&self) -> Option<Both> {
        self.modes.as_ref().err().map(|why| crate::told::told_both(why))
    }
}

/// Removes control characters and line breaks from a name.
fn plain(name: &str) -> String {
    const MOST: usize = 120;
    let steers = |sign: char| {
        sign.is_control()
            || matches!(sign, '\u{200e}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let signs = name.chars().map(|sign| if steers(sign) { '?' } else { sign });
    signs.take(MOST).collect()
}

/// The ending of a file name, if it is a plain one.
fn ending(name: &str) -> Option<String> {
    let (stem, ending) = name.rsplit_once('.')?;
    let is_plain = ending.len() <= ENDING_MOST && ending.bytes().all(|sign| sign.is_ascii_alphanumeric());
    (!stem.is_empty() && !ending.is_empty() && is_plain).then(|| ending.to_ascii_lowercase())
}

fn path_of(survey: &str, ending: Option<&str>) -> String {
    let stem: String = survey
        .chars()
        .filter(|sign| !matches!(sign, '(' | ')'))
        .map(|sign| if matches!(sign, ':' | ' ') { '-' } else { sign })
        .collect();
    match ending {
        Some(ending) => format!("{FOLDER}/{stem}.{ending}"),
        None => format!("{FOLDER}/{stem}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_records::NoFiles;

    #[test]
    fn holds_the_latest_survey_with_one_record_is_the_pattern() {
        let head = "schema = 1\nkind = \"survey\"\nname = \"Gate\"\n";
        let of = |rest: &str| {
            let opened = Opened::read(head.to_owned() + rest, "p".to_owned(), &NoFiles).unwrap();
            Pattern::of(opened).map(|pattern| pattern.survey)
        };
        let record = "records = { file = \"a.csv\", sampling_rate = \"100 Hz\" }\n";
        let three = format!(
            "[survey.2020-05]\n{record}[survey.2019]\n{record}[survey.first]\n{record}[survey.2024]\nfrequencies.x = [2.0]\n"
        );
        assert_eq!(of(&three).unwrap(), "2020-05");
        assert_eq!(
            of(&format!("[survey.a]\n{record}[survey.b]\n{record}")).unwrap(),
            "b"
        );
        assert!(matches!(
            of("[survey.2024]\nfrequencies.x = [2.0]\n"),
            Err(WorkError::NoneToFollow)
        ));
    }

    #[test]
    fn holds_names_of_strangers_make_no_path() {
        for (name, ending_of) in [
            ("a.csv", Some("csv")),
            ("../../etc/passwd", None),
            ("a.c/sv", None),
            ("x.$(reboot)", None),
            (".csv", None),
            ("a.verylongending", None),
            ("A.MSEED", Some("mseed")),
        ] {
            assert_eq!(ending(name).as_deref(), ending_of, "{name}");
        }
        assert_eq!(
            path_of("2026-11-25T10:00:00 (2)", Some("csv")),
            "followed/2026-11-25T10-00-00-2.csv"
        );
        assert_eq!(plain("a\nb\u{202e}c\u{1b}[0m"), "a?b?c?[0m");
    }
}
