//! What makes "no change" no good news: surveys left out, stated deviations that the surveys contradict, disturbances that last, and steps that are
//! not seen.

use super::numbers::{hertz, percent, plain};
use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, messages};
use dolmen_work::watched::WatchAnswer;

/// Number of surveys that a finding names.
const NAMED_MOST: usize = 4;

messages! {
    /// Doubts about a history.
    pub(crate) enum Doubted in "watch.doubts" {
        Undated { count: usize, of: usize, names: Vec<String> } => {
            en: "LEFT OUT: {count} of {of} surveys, as their names begin with no date ({names}). Nothing below is about them: begin each name with its date, 2024-06-05.",
            ko: "제외한 조사: 이름이 날짜로 시작하지 않는 {of}회 중 {count}회({names}). 아래 결과에는 포함하지 않았다. 이름을 2024-06-05처럼 날짜로 시작한다.",
        },
        UndatedMore { count: usize, of: usize, names: Vec<String>, more: usize } => {
            en: "LEFT OUT: {count} of {of} surveys, as their names begin with no date ({names} and {more} more). Nothing below is about them: begin each name with its date, 2024-06-05.",
            ko: "제외한 조사: 이름이 날짜로 시작하지 않는 {of}회 중 {count}회({names} 외 {more}회). 아래 결과에는 포함하지 않았다. 이름을 2024-06-05처럼 날짜로 시작한다.",
        },
        StatedTooLarge { frequency: Quantity, stated: Quantity, scatter: Quantity, times: Quantity } => {
            en: "The stated standard deviation of {frequency} is {stated}, {times} times what its surveys scatter from one to the next ({scatter}): is it per cent, or a bandwidth? While it stands, most changes are hidden.",
            ko: "{frequency} 모드의 표준편차는 {stated}(으)로 적혀 있으나 연속한 조사 사이의 산포는 {scatter}이며 그 {times}배이다. 백분율이나 대역폭을 적은 것이 아닌가? 이 값으로는 대부분의 변화가 드러나지 않는다.",
        },
        Lasting { frequency: Quantity, correlation: Quantity } => {
            en: "What disturbs {frequency} lasts so long (correlation {correlation} from survey to survey, the end of what can be told) that the stated probabilities of false alarms and false changes do not hold: expect several times as many.",
            ko: "{frequency} 모드의 변동이 오래 지속되어(연속한 조사 사이의 상관계수 {correlation}, 추정할 수 있는 상한) 제시한 오경보와 잘못된 변화의 확률이 성립하지 않는다. 그 몇 배로 보아야 한다.",
        },
    }
}

/// Surveys left out because their names begin with no date.
pub(super) fn undated(answer: &WatchAnswer) -> Option<Finding> {
    let all = answer.undated();
    let (count, more) = (all.len(), all.len().saturating_sub(NAMED_MOST));
    let of = answer.surveys.len() + answer.left_out.len();
    let names: Vec<String> = all.into_iter().take(NAMED_MOST).map(str::to_owned).collect();
    let said = match (count, more) {
        (0, _) => return None,
        (_, 0) => Doubted::Undated { count, of, names },
        _ => Doubted::UndatedMore {
            count,
            of,
            names,
            more,
        },
    };
    Some(Finding::key(Tone::Warn, said))
}

/// The mode whose stated deviations the surveys contradict most, and one whose disturbance lasts.
pub(super) fn doubts(answer: &WatchAnswer) -> Vec<Finding> {
    let stated = answer.stated_too_large().map(|of| Doubted::StatedTooLarge {
        frequency: hertz(of.frequency_hz),
        stated: percent(of.stated, 2),
        scatter: percent(of.scatter, 2),
        times: plain(of.stated / of.scatter, 0),
    });
    let lasting = answer.lasting().and_then(|mode| {
        let said = Doubted::Lasting {
            frequency: hertz(mode.track.frequency_hz),
            correlation: plain(mode.weather.as_ref()?.disturbance.correlation, 2),
        };
        Some(Finding::key(Tone::Unknown, said))
    });
    let stated = stated.into_iter().map(|said| Finding::key(Tone::Warn, said));
    stated.chain(lasting).collect()
}

/// Whether these keep "no alarm" and "no change" from being good news.
pub(super) fn are_there(answer: &WatchAnswer) -> bool {
    !answer.undated().is_empty() || answer.stated_too_large().is_some() || answer.sees_little()
}
