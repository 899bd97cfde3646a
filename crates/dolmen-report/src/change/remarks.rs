//! Modes without a partner, and doubtful pairs.

use super::quantities::frequencies;
use dolmen::assess::{ModeChange, SurveyChange};
use dolmen::modal::ObservedMode;
use dolmen_words::{Values, messages};

messages! {
    /// Remarks on the pairing of modes.
    pub(crate) enum Remarks in "change.remarks" {
        Untested { untested: usize, all: usize } => {
            en: "{untested} of {all} paired frequencies have no standard deviation in one survey or the other: whether they changed cannot be said.",
            ko: "짝지은 고유진동수 {all}개 중 {untested}개는 한쪽 조사의 표준편차를 알 수 없어 변화 여부를 판단할 수 없다.",
        },
        Undecided { undecided: usize, all: usize } => {
            en: "{undecided} of {all} paired frequencies are not tested: the temperature of one of the two surveys is not known, or too few others were as cold.",
            ko: "짝지은 고유진동수 {all}개 중 {undecided}개는 검정하지 않았다. 두 조사 중 하나의 기온을 알 수 없거나 그만큼 추운 조사가 너무 적다.",
        },
        LostFirst => {
            en: "A mode that is not found again may have moved further than pairs may lie apart« (frequency_within)», or was not shaken.",
            ko: "다시 확인되지 않은 모드는 짝으로 볼 수 있는 범위«(frequency_within)»를 넘어 이동하였거나 가진되지 않았을 수 있다.",
        },
        Lost(all: Values) => {
            en: "Not found again: {all}. Such a mode may have moved further than pairs may lie apart« (frequency_within)», or was not shaken.",
            ko: "다시 확인되지 않은 모드: {all}. 짝으로 볼 수 있는 범위«(frequency_within)»를 넘어 이동하였거나 가진되지 않았을 수 있다.",
        },
        New(all: Values) => { en: "New: {all}.", ko: "새로 나타난 모드: {all}." },
        ByFrequency(all: Values) => {
            en: "Paired by frequency alone, since fewer than two sensors are in both surveys: {all}.",
            ko: "두 조사에 공통인 센서가 두 개 미만이어서 진동수만으로 짝지은 모드: {all}.",
        },
        AcceptedBefore(all: Values) => {
            en: "Accepted by the user in the survey before, where no test found them: {all}.",
            ko: "이전 조사에서 판정 기준으로 찾지 못하여 사용자가 채택한 모드: {all}.",
        },
        AcceptedAfter(all: Values) => {
            en: "Accepted by the user in the survey after, where no test found them: {all}.",
            ko: "이후 조사에서 판정 기준으로 찾지 못하여 사용자가 채택한 모드: {all}.",
        },
        Doubtful(all: Values) => {
            en: "Another pairing is nearly as good: {all} may not be the same mode in both surveys.",
            ko: "다른 짝도 거의 같은 정도로 가능하다: {all} 모드는 두 조사에서 같은 모드가 아닐 수 있다.",
        },
    }
}

/// The remarks that apply.
pub(super) fn remarks(change: &SurveyChange) -> Vec<Remarks> {
    let mut said = Vec::new();
    let all = change.modes.len();
    let undecided = change.modes.iter().filter(|mode| mode.is_undecided).count();
    if undecided > 0 && undecided < all {
        said.push(Remarks::Undecided { undecided, all });
    }
    let untested = all - change.tested() - undecided;
    if untested > 0 && untested < all {
        said.push(Remarks::Untested { untested, all });
    }
    // not repeated if the findings mention it
    let said_first = |mode: &ObservedMode| change.not_compared.iter().any(|lost| lost.from == *mode);
    let others: Vec<ObservedMode> = change.lost.iter().filter(|m| !said_first(m)).cloned().collect();
    match (others.is_empty(), change.lost.is_empty()) {
        (false, _) => said.push(Remarks::Lost(frequencies(&others))),
        (true, false) => said.push(Remarks::LostFirst),
        (true, true) => {}
    }
    if !change.new.is_empty() {
        said.push(Remarks::New(frequencies(&change.new)));
    }
    let by_frequency = paired(change, |mode| mode.pair.assurance.is_none());
    said.extend(by_frequency.map(Remarks::ByFrequency));
    let doubtful = paired(change, |mode| mode.pair.doubtful());
    said.extend(doubtful.map(Remarks::Doubtful));
    let before = change.modes.iter().map(|mode| &mode.from).chain(&change.lost);
    said.extend(accepted(before).map(Remarks::AcceptedBefore));
    let after = change.modes.iter().map(|mode| &mode.to).chain(&change.new);
    said.extend(accepted(after).map(Remarks::AcceptedAfter));
    said
}

/// Frequencies of accepted modes; `None` if there are none.
fn accepted<'a>(modes: impl Iterator<Item = &'a ObservedMode>) -> Option<Values> {
    let all: Vec<ObservedMode> = modes.filter(|mode| mode.accepted).cloned().collect();
    (!all.is_empty()).then(|| frequencies(&all))
}

/// Earlier frequencies of the pairs of a kind; `None` if there are none.
fn paired(change: &SurveyChange, is_of_kind: impl Fn(&ModeChange) -> bool) -> Option<Values> {
    let modes = change.modes.iter().filter(|mode| is_of_kind(mode));
    let modes: Vec<ObservedMode> = modes.map(|mode| mode.from.clone()).collect();
    (!modes.is_empty()).then(|| frequencies(&modes))
}
