//! Findings that restrict the use of the modes of a record: free decays, machines, overtones and deviations from few blocks.

use super::values::{all_hertz, hertz, percent};
use crate::document::{Finding, Tone};
use dolmen::modal::LastingChange;
use dolmen::numeric::student_two_sided_quantile;
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::RecordAnswer;

messages! {
    /// Restrictions on the use of modes.
    pub(crate) enum Cautions in "modal.cautions" {
        FreeDecay { explained: Quantity } => {
            en: "THIS IS A FREE DECAY: modes that die away from the beginning of the record explain {explained} of its motion.« Write method = \"era\" into records.modal: a method for ambient vibration misses modes here, and its deviations do not hold.»",
            ko: "자유감쇠 기록이다. 기록의 처음부터 줄어드는 모드가 운동의 {explained}을(를) 설명한다«. records.modal에 method = \"era\"를 적는다». 상시진동에 쓰는 방법은 이런 기록에서 모드를 놓치며 그 표준편차도 맞지 않는다.",
        },
        FreeDecays { decays: usize, explained: Quantity, from: Quantity, to: Quantity } => {
            en: "FREE DECAYS make up this record, {decays} of them: modes that die away from the beginning of each explain {explained} or more of its motion. The tests for machines and footsteps do not apply to them and were left out; the deviations of an ambient method do not hold.« Cut out one decay (conditioning.cut with from_s = {from} and to_s = {to}) and write method = \"era\" into records.modal, or measure without blows.»",
            ko: "이 기록은 자유감쇠 {decays}개로 이루어져 있다. 각 자유감쇠의 처음부터 줄어드는 모드가 그 운동의 {explained} 이상을 설명한다. 기계와 발걸음의 검정은 이런 기록에 맞지 않아 하지 않았으며, 상시진동 방법의 표준편차도 맞지 않는다.« 자유감쇠 하나를 잘라(conditioning.cut의 from_s = {from}, to_s = {to}) records.modal에 method = \"era\"를 적거나, 타격 없이 측정한다.»",
        },
        OneDecay { explained: Quantity, from: Quantity, to: Quantity } => {
            en: "A FREE DECAY makes up most of this record: modes that die away from its beginning explain {explained} or more of the motion. The tests for machines and footsteps do not apply to it and were left out; the deviations of an ambient method do not hold.« Cut it out (conditioning.cut with from_s = {from} and to_s = {to}) and write method = \"era\" into records.modal.»",
            ko: "이 기록의 대부분은 자유감쇠이다. 그 처음부터 줄어드는 모드가 운동의 {explained} 이상을 설명한다. 기계와 발걸음의 검정은 이런 기록에 맞지 않아 하지 않았으며, 상시진동 방법의 표준편차도 맞지 않는다.« 그 구간을 잘라(conditioning.cut의 from_s = {from}, to_s = {to}) records.modal에 method = \"era\"를 적는다.»",
        },
        FewStrongBlocks { blocks: usize, of: usize, factor: Quantity } => {
            en: "The motion swells: these deviations stand on {blocks} equally strong blocks of time of {of}, so 95 % lie within {factor} times the deviation, not 2.",
            ko: "진동이 한때에 몰려 있어 이 표준편차는 시간 구간 {of}개 중 세기가 같은 유효 구간 {blocks}개에 근거한다. 95 % 구간은 표준편차의 2배가 아니라 {factor}배이다.",
        },
        BetweenHalves { changes: Vec<Sentence> } => {
            en: "THE FREQUENCIES DIFFER between the two halves of the record: {changes}. Chance gives such a difference in fewer than one record of a thousand: the structure changed, or its frequencies follow the size of the motion or the temperature. The modes of the whole record are of no one state and may be missing; identify the halves alone (conditioning.cut).",
            ko: "기록의 앞 절반과 뒤 절반에서 고유진동수가 다르다. {changes}. 우연으로는 기록 천 개 중 하나에도 나타나지 않는 차이이다. 구조물이 변하였거나 고유진동수가 진동의 크기나 온도에 따라 변한다. 기록 전체의 모드는 어느 한 상태의 것이 아니며 빠진 모드가 있을 수 있다. 절반씩 따로 식별한다(conditioning.cut).",
        },
        FromTo { before: Quantity, after: Quantity, change: Quantity } => {
            en: "{before}, then {after} ({change}, ± standard deviation)",
            ko: "{before}에서 {after}(으)로({change}, ± 표준편차)",
        },
        Overtones { overtones: Values, mode: Quantity } => {
            en: "{overtones} are multiples (3 or 5) of the frequency of the mode at {mode}, which follows the size of its swings: a mode that is not linear moves at these too, so they are probably no modes of their own.",
            ko: "{overtones}은(는) 진폭에 따라 변하는 {mode} 모드 진동수의 3배 또는 5배이다. 비선형 모드는 이런 진동수에서도 움직이므로 별개의 모드가 아닐 가능성이 크다.",
        },
        Hum { at: Values } => {
            en: "The motion at {at} does not die away: hum or a machine. It is not listed among the modes.",
            ko: "{at}의 진동은 줄어들지 않는다. 전원 잡음이나 기계 진동이므로 모드 목록에서 제외하였다.",
        },
    }
}

/// The findings that restrict the use of the modes of a record.
pub(super) fn cautions(record: &RecordAnswer) -> Vec<Finding> {
    let mut all: Vec<Finding> = few_strong_blocks(record).into_iter().collect();
    all.extend(not_modes(record));
    all.extend(free_decays(record));
    all.extend(between_halves(record));
    all
}

/// Frequencies that differ between the halves of the record.
fn between_halves(record: &RecordAnswer) -> Option<Finding> {
    let of = |change: &LastingChange| {
        let ratio = Quantity {
            sd_si: change.ratio_sd,
            ..Quantity::new(change.ratio, Unit::percent(), Digits::Significant(3))
        };
        let said = Cautions::FromTo {
            before: hertz(change.before_hz),
            after: hertz(change.after_hz),
            change: ratio,
        };
        Sentence::from(said)
    };
    let changes: Vec<Sentence> = record.analysis.between_halves.iter().map(of).collect();
    (!changes.is_empty()).then(|| Finding::key(Tone::Warn, Cautions::BetweenHalves { changes }))
}

/// A record of free decays that was read as ambient vibration, and how to declare its longest decay.
fn free_decays(record: &RecordAnswer) -> Option<Finding> {
    let found = record.analysis.free_decays.as_ref()?;
    // "or more" holds of what is rounded down
    let explained = percent((100.0 * found.explained).floor().min(99.0) / 100.0, 0);
    let length_s = |span: &&[f64; 2]| span[1] - span[0];
    let longest = found
        .spans_s
        .iter()
        .max_by(|a, b| length_s(a).total_cmp(&length_s(b)))?;
    let is_whole = longest[0] == 0.0 && found.spans_s.len() == 1;
    let seconds = |at_s: f64| Quantity::new(at_s, Unit::ratio(), Digits::Fixed(2));
    let [from, to] = longest.map(seconds);
    let said = match found.spans_s.len() {
        1 if is_whole => Cautions::FreeDecay { explained },
        1 => Cautions::OneDecay { explained, from, to },
        decays => Cautions::FreeDecays {
            decays,
            explained,
            from,
            to,
        },
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Deviations that stand on so few equally strong blocks of time that two of them do not hold 95 %.
fn few_strong_blocks(record: &RecordAnswer) -> Option<Finding> {
    const FEW: usize = 6; // chosen here: 95 % then lie within 2.57 deviations
    let settings = &record.analysis.settings;
    let blocks = settings.time_blocks_effective;
    let has_sd = record
        .analysis
        .modes
        .modes
        .iter()
        .any(|mode| mode.frequency_sd_hz.is_some());
    if !(2..=FEW).contains(&blocks) || blocks >= settings.time_blocks || !has_sd {
        return None;
    }
    let factor = student_two_sided_quantile(0.05, (blocks - 1) as f64).ok()?;
    let said = Cautions::FewStrongBlocks {
        blocks,
        of: settings.time_blocks,
        factor: Quantity::new(factor, Unit::ratio(), Digits::Significant(2)),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Motion of a free decay that is probably no mode: machines, and overtones of modes that are not linear.
fn not_modes(record: &RecordAnswer) -> Vec<Finding> {
    let Some(decay) = &record.analysis.decay else {
        return Vec::new();
    };
    let at = &decay.machines_hz;
    let hum = (!at.is_empty()).then(|| Cautions::Hum { at: all_hertz(at) });
    let overtones = decay.modes.iter().filter_map(|mode| {
        let own = decay.modes.iter().filter(|of| {
            of.overtone
                .is_some_and(|overtone| overtone.of_hz == mode.frequency_hz)
        });
        let own: Vec<f64> = own.map(|of| of.frequency_hz).collect();
        (!own.is_empty()).then(|| Cautions::Overtones {
            overtones: all_hertz(&own),
            mode: hertz(mode.frequency_hz),
        })
    });
    let said = hum.into_iter().chain(overtones);
    said.map(|said| Finding::key(Tone::Warn, said)).collect()
}
