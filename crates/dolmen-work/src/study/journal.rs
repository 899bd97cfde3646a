//! The journal of a study: a header, then one line for each finished run; lines are only appended. A killed process leaves at most one
//! incomplete line, the last.

use super::journal_error::JournalError;
use super::kind::StudyKind;
use super::measures::RunMeasures;
use super::run::{Run, RunOutcome};
use crate::error::WorkError;
use crate::fingerprint::fingerprint;
use crate::wrong::JournalDiffers;
use dolmen_words::Language;
use dolmen_words::message::Both;

/// First word of a journal, with the version of its format.
const MAGIC: &str = "dolmen-study-journal-4";

/// Everything that determines the results of a study: journals of different studies do not mix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JournalHeader {
    /// Name of the study.
    pub study: String,
    /// Version of the program.
    pub version: String,
    /// Number of scans of the whole study, over all shards.
    pub jobs: usize,
    /// Index and number of shards, from 1.
    pub shard: (usize, usize),
    /// Fingerprints of the inputs, by name.
    pub inputs: Vec<(String, String)>,
}

impl JournalHeader {
    /// The difference from another header, in words, without shards; `None` if both are of one study.
    pub fn difference(&self, other: &JournalHeader) -> Option<Both> {
        if self.study != other.study {
            return Some(JournalDiffers::OtherStudy(other.study.clone()).into());
        }
        if self.version != other.version {
            return Some(
                JournalDiffers::OtherVersion {
                    other: other.version.to_string(),
                    own: self.version.to_string(),
                }
                .into(),
            );
        }
        let changed: Vec<&str> = self
            .inputs
            .iter()
            .filter(|input| !other.inputs.contains(input))
            .map(|(name, _)| name.as_str())
            .collect();
        let said = Both::of(|language| {
            let each: Vec<String> = changed.iter().map(|name| input_word(name, language)).collect();
            each.join(", ")
        });
        if !changed.is_empty() || self.inputs.len() != other.inputs.len() || self.jobs != other.jobs {
            return Some(JournalDiffers::Changed(said).into());
        }
        None
    }
}

/// Name of an input of a study in journals, in a language.
fn input_word(name: &str, language: Language) -> String {
    let korean = match (name, name.strip_prefix("motion ")) {
        (_, Some(motion)) => format!("지반운동 {motion}"),
        ("the project file", _) => "프로젝트 파일".to_owned(),
        ("inputs of the cases", _) => "조합의 입력값".to_owned(),
        ("the structure as read", _) => "읽어 들인 구조물(계측 기울기 포함)".to_owned(),
        ("samples that fall by themselves", _) => "자중으로 쓰러지는 표본의 계산 방법".to_owned(),
        (other, _) => other.to_owned(),
    };
    language.pick(name.to_owned(), korean)
}

/// Storage for runs as they end, from any thread.
pub trait Journal: Send + Sync {
    /// Stores a run: once this returns it is not lost.
    ///
    /// # Errors
    /// [`WorkError`] if it cannot be written.
    fn append(&self, run: &Run) -> Result<(), WorkError>;
}

/// A journal as read.
#[derive(Clone, Debug)]
pub struct ReadJournal {
    /// Its header.
    pub header: JournalHeader,
    /// Its runs in the order in which they ended.
    pub runs: Vec<Run>,
    /// Number of bytes in complete lines; the rest is an incomplete line of a killed process.
    pub whole_bytes: usize,
}

/// Whether a file with this beginning is the journal of a study, of this version or of another.
pub fn is_journal(start: &[u8]) -> bool {
    let word = MAGIC.trim_end_matches(|c: char| c.is_ascii_digit());
    start.starts_with(word.as_bytes())
}

/// The first line of a journal, with its end.
pub fn header_line(header: &JournalHeader) -> String {
    let (part, of) = header.shard;
    let mut cells = vec![
        MAGIC.to_owned(),
        escaped(&header.study),
        escaped(&header.version),
        header.jobs.to_string(),
        format!("{part}/{of}"),
    ];
    for (name, print) in &header.inputs {
        cells.push(format!("{}={print}", escaped(name)));
    }
    closed(&cells)
}

/// The line of a run, with its end. A reason that Korean says otherwise stands there in both languages.
pub fn run_line(run: &Run) -> String {
    let numbers: Vec<String> = run.measures.values().iter().map(f64::to_string).collect();
    let mut cells = vec![
        run.job.to_string(),
        run.scale.to_string(),
        run.peak_ground_acceleration_m_s2.to_string(),
        run.peak_ground_velocity_m_s.to_string(),
        run.outcome.word().to_owned(),
        run.damage_state.to_string(),
        joint_words(&run.joint_states),
        run.at_s.to_string(),
        escaped(&run.part),
        escaped(&run.gave_way),
        numbers.join(","),
        escaped(&run.why.english),
    ];
    if run.why.korean != run.why.english {
        cells.push(escaped(&run.why.korean));
    }
    closed(&cells)
}

/// Reads a journal; an incomplete last line is ignored.
///
/// # Errors
/// [`JournalError`] without a header, or with a damaged line before the last.
pub fn read_journal(text: &str, kind: StudyKind) -> Result<ReadJournal, JournalError> {
    let mut lines = text.split_inclusive('\n').enumerate();
    let first = lines.next().and_then(|(_, line)| opened(line));
    let header = first.as_deref().and_then(header_of).ok_or(JournalError::Header)?;
    let mut whole_bytes = text.find('\n').map_or(text.len(), |at| at + 1);
    let mut runs = Vec::new();
    for (number, line) in lines {
        let run = opened(line).and_then(|cells| run_of(&cells, kind));
        match run {
            Some(run) => {
                runs.push(run);
                whole_bytes += line.len();
            }
            None if whole_bytes + line.len() == text.len() => break,
            None => return Err(JournalError::Line { line: number + 1 }),
        }
    }
    Ok(ReadJournal {
        header,
        runs,
        whole_bytes,
    })
}

fn header_of(cells: &[String]) -> Option<JournalHeader> {
    let [magic, study, version, jobs, shard, inputs @ ..] = cells else {
        return None;
    };
    let (part, of) = shard.split_once('/')?;
    let inputs: Option<Vec<(String, String)>> = inputs
        .iter()
        .map(|cell| {
            let (name, print) = cell.rsplit_once('=')?;
            Some((plain(name), print.to_owned()))
        })
        .collect();
    (magic == MAGIC).then_some(())?;
    Some(JournalHeader {
        study: plain(study),
        version: plain(version),
        jobs: jobs.parse().ok()?,
        shard: (part.parse().ok()?, of.parse().ok()?),
        inputs: inputs?,
    })
}

fn run_of(cells: &[String], kind: StudyKind) -> Option<Run> {
    let [
        job,
        scale,
        peak,
        velocity,
        outcome,
        damage,
        joints,
        at,
        part,
        gave_way,
        numbers,
        english,
        korean @ ..,
    ] = cells
    else {
        return None;
    };
    let korean = match korean {
        [] => english,
        [korean] => korean,
        _ => return None,
    };
    let number = |text: &str| text.parse::<f64>().ok();
    let measures: Option<Vec<f64>> = match numbers.as_str() {
        "" => Some(Vec::new()),
        numbers => numbers.split(',').map(number).collect(),
    };
    let measures = RunMeasures::of_values(kind, &measures?)?;
    Some(Run {
        job: job.parse().ok()?,
        scale: number(scale)?,
        peak_ground_acceleration_m_s2: number(peak)?,
        peak_ground_velocity_m_s: number(velocity)?,
        outcome: RunOutcome::of_word(outcome)?,
        damage_state: damage.parse().ok()?,
        joint_states: joint_states(joints)?,
        at_s: number(at)?,
        part: plain(part),
        gave_way: plain(gave_way),
        measures,
        why: Both {
            english: plain(english),
            korean: plain(korean),
        },
    })
}

/// States of joints as a text, one number each.
pub(super) fn joint_words(states: &[u8]) -> String {
    let words: Vec<String> = states.iter().map(u8::to_string).collect();
    words.join(" ")
}

fn joint_states(text: &str) -> Option<Vec<u8>> {
    text.split_ascii_whitespace()
        .map(|word| word.parse().ok().filter(|state| *state <= 4))
        .collect()
}

/// Cells as a line with a mark of completeness.
fn closed(cells: &[String]) -> String {
    let line = cells.join("\t");
    let print = fingerprint(line.as_bytes());
    format!("{line}\t{}\n", &print[16..])
}

/// Cells of a complete line.
fn opened(line: &str) -> Option<Vec<String>> {
    let (line, print) = line.strip_suffix('\n')?.rsplit_once('\t')?;
    (fingerprint(line.as_bytes())[16..] == *print).then(|| line.split('\t').map(str::to_owned).collect())
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\")
        .replace('\t', "\\t")
        .replace('\n', "\\n")
        .replace('\r', "\\r")
}

fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        out.push(match (letter, letter == '\\') {
            (_, true) => match letters.next() {
                Some('t') => '\t',
                Some('n') => '\n',
                Some('r') => '\r',
                other => other.unwrap_or('\\'),
            },
            (letter, false) => letter,
        });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(job: usize, scale: f64) -> Run {
        Run {
            job,
            scale,
            peak_ground_acceleration_m_s2: 0.1 + 0.2,
            peak_ground_velocity_m_s: 1.0 / 3.0,
            outcome: RunOutcome::Fell,
            damage_state: 4,
            joint_states: vec![0, 4, 3],
            at_s: f64::NAN,
            part: "stone\t\"1\"\\n".to_owned(),
            gave_way: "a\nb\\".to_owned(),
            measures: {
                let values: Vec<f64> = (0..10).map(|n| f64::from(n).exp() * 1e-7).collect();
                RunMeasures::of_values(StudyKind::Stack, &values).unwrap()
            },
            why: Both {
                english: "no room".to_owned(),
                korean: "여유\t없음".to_owned(),
            },
        }
    }

    fn header() -> JournalHeader {
        JournalHeader {
            study: "a b".to_owned(),
            version: "0.1.0".to_owned(),
            jobs: 7,
            shard: (1, 2),
            inputs: vec![
                ("project".to_owned(), fingerprint(b"x")),
                ("motion a=b".to_owned(), fingerprint(b"y")),
            ],
        }
    }

    #[test]
    fn exact_what_is_written_is_read_to_the_last_bit() {
        let runs = [run(0, 0.1), run(3, 1e-300), run(6, 2.0 / 3.0)];
        let text = header_line(&header()) + &runs.iter().map(run_line).collect::<String>();
        let read = read_journal(&text, StudyKind::Stack).unwrap();
        assert_eq!(read.header, header());
        assert_eq!(read.whole_bytes, text.len());
        assert!(
            read.runs.iter().zip(&runs).all(|(a, b)| a.is_same(b)),
            "{:?}",
            read.runs
        );
    }

    #[test]
    fn holds_a_journal_torn_anywhere_loses_no_whole_line() {
        let runs = [run(0, 0.1), run(1, 0.2), run(2, 0.3)];
        let lines: Vec<String> = runs.iter().map(run_line).collect();
        let head = header_line(&header());
        let text = head.clone() + &lines.concat();
        for end in head.len()..text.len() {
            let torn = String::from_utf8_lossy(&text.as_bytes()[..end]);
            let read = read_journal(&torn, StudyKind::Stack).unwrap();
            let whole = lines
                .iter()
                .scan(head.len(), |at, line| {
                    *at += line.len();
                    Some(*at)
                })
                .filter(|at| *at <= end)
                .count();
            assert_eq!(read.runs.len(), whole, "{end}");
            assert!(read.whole_bytes <= end);
        }
        assert_eq!(
            read_journal(&text[..head.len() - 1], StudyKind::Stack).unwrap_err(),
            JournalError::Header
        );
    }

    #[test]
    fn refuses_a_changed_line_and_names_what_differs() {
        let text = header_line(&header()) + &run_line(&run(0, 0.1)) + &run_line(&run(1, 0.2));
        let changed = text.replacen("\t0.1\t", "\t0.3\t", 1);
        let refused = read_journal(&changed, StudyKind::Stack).unwrap_err();
        assert_eq!(refused, JournalError::Line { line: 2 });
        let mut other = header();
        other.shard = (2, 2);
        assert_eq!(header().difference(&other), None);
        other.inputs[1].1 = fingerprint(b"z");
        assert_eq!(
            header().difference(&other).unwrap(),
            JournalDiffers::Changed(Both {
                english: "motion a=b".to_owned(),
                korean: "지반운동 a=b".to_owned(),
            })
            .into()
        );
    }
}
