//! Events between two surveys, and changes that a fitted temperature line hides.

use super::notes::note;
use crate::document::{Finding, Tone};
use dolmen::assess::{ChangeNote, SurveyChange};
use dolmen_project::WorkKind;
use dolmen_words::{Sentence, messages};
use dolmen_work::answer::CompareAnswer;
use dolmen_work::events_between::EventBetween;

messages! {
    /// Events between two surveys.
    pub(crate) enum Befell in "change.between" {
        Between { from: String, to: String, each: Vec<Sentence> } => {
            en: "Between the surveys {from} and {to} the file has: {each}. What changed may be of these; «`dolmen watch`|the review of all surveys» gives each its own change.",
            ko: "{from} 조사와 {to} 조사 사이에 다음이 있었다: {each}. 변화는 그 영향일 수 있다. 각각의 영향은 «`dolmen watch`|장기 변화 검토»로 본다.",
        },
        Repair { date: String, what: String } => { en: "a repair on {date} ({what})", ko: "{date} 보수({what})" },
        Sensors { date: String, what: String } => {
            en: "work on the sensors on {date} ({what}), which changes shapes",
            ko: "{date} 센서 작업({what}, 모드형상이 바뀐다)",
        },
        Event { date: String, what: String } => { en: "an event on {date} ({what})", ko: "{date} 사건({what})" },
        Earthquake { survey: String } => {
            en: "an earthquake in the record of {survey}",
            ko: "{survey} 조사 기록의 지진",
        },
        FittedThrough { surveys: usize } => {
            en: "What temperature does was fitted through {surveys} earlier surveys as if the structure had not changed between them: a change within those years is in that line, and not shown here. «`dolmen watch`|The review of all surveys» finds both together.",
            ko: "기온의 영향은 이전 조사 {surveys}회에서 그동안 구조물이 변하지 않은 것으로 보고 추정하였다. 그 기간의 변화는 이 추정에 섞여 여기에 나타나지 않는다. «`dolmen watch`|장기 변화 검토»는 기온의 영향과 변화를 함께 추정한다.",
        },
    }
}

/// Works and earthquakes between the two surveys.
pub(super) fn between(answer: &CompareAnswer) -> Option<Finding> {
    let each: Vec<Sentence> = answer.between().into_iter().map(said).collect();
    let (from, to) = (answer.from.clone(), answer.to.clone());
    (!each.is_empty()).then(|| Finding::key(Tone::Warn, Befell::Between { from, to, each }))
}

fn said(of: EventBetween) -> Sentence {
    match of {
        EventBetween::Earthquake(survey) => Befell::Earthquake { survey },
        EventBetween::Work(work) => {
            let date = work.date;
            let what = work.what.unwrap_or_else(|| "–".to_owned());
            match work.kind {
                WorkKind::Repair | WorkKind::Inspection => Befell::Repair { date, what },
                WorkKind::Sensors => Befell::Sensors { date, what },
                WorkKind::Event => Befell::Event { date, what },
            }
        }
    }
    .into()
}

/// Finding that a temperature line was fitted through possible changes, and where it does not fit.
pub(super) fn fitted_through(change: &SurveyChange) -> Vec<Finding> {
    let surveys = change
        .modes
        .iter()
        .filter_map(|mode| Some(mode.fitted.as_ref()?.surveys));
    let Some(surveys) = surveys.max() else {
        return Vec::new();
    };
    let scatters = change.notes.iter().filter(|of| is_of_line(of));
    let scatters = scatters.map(|of| Finding::key(Tone::Warn, note(of)));
    let said = Finding::key(Tone::Unknown, Befell::FittedThrough { surveys });
    scatters.chain([said]).collect()
}

/// Whether a note says that the earlier surveys are off their line.
pub(super) fn is_of_line(note: &ChangeNote) -> bool {
    matches!(note, ChangeNote::LineScatters { .. })
}
