//! Notes on the modes of several setups.

use super::values::{all_hertz, fixed, hertz};
use dolmen::modal::{Agreement, MergedMode, PartialMode, ReferenceFault};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{REFERENCES_ALIKE, SetupsAnswer};

messages! {
    /// Remarks on setups.
    pub(crate) enum Remarks in "modal.setup-remarks" {
        OneReference { sensor: String } => {
            en: "One sensor alone, \"{sensor}\", holds the setups together: a mode with a node there is lost or scaled by noise, and no MAC can tell whether the setups show one mode; three references see it.",
            ko: "센서 \"{sensor}\" 하나만이 배치들을 연결한다. 그 위치가 마디인 모드는 놓치거나 잡음으로 척도가 정해지며, 배치들이 같은 모드를 보이는지 MAC로 확인할 수 없다. 기준 센서 세 개가 있으면 알 수 있다.",
        },
        FrequencyDiffers { at: Values } => {
            en: "The setups differ in the frequency of the modes at {at} beyond chance: weather, strength of the motion or moved mass between them.",
            ko: "{at} 모드는 배치 사이의 진동수 차이가 유의하다. 그 사이의 날씨, 진동의 세기, 옮겨진 질량의 영향이다.",
        },
        DampingDiffers { at: Values } => {
            en: "The setups differ in the damping of the modes at {at} beyond chance.",
            ko: "{at} 모드는 배치 사이의 감쇠비 차이가 유의하다.",
        },
        Unlike { at: Values, least: Quantity } => {
            en: "At the references the shapes of the modes at {at} are not alike in all setups (MAC below {least}): the merged shape is not to be trusted, and goes on to no stiffness.",
            ko: "{at} 모드는 기준 센서에서의 형상이 배치마다 같지 않다(MAC {least} 미만). 합성한 모드형상은 신뢰할 수 없으며 강성 추정에 쓰지 않는다.",
        },
        Doubtful { at: Values } => {
            en: "Another pairing is nearly as good: the setups may not show one mode at {at}, which goes on to no stiffness.",
            ko: "다른 짝도 거의 같은 정도로 가능하다. {at}에서 배치들이 같은 모드를 보이는지 확실하지 않으며 강성 추정에 쓰지 않는다.",
        },
        Missing { modes: Vec<Sentence> } => {
            en: "Left out, since not every setup shows them: {modes}.",
            ko: "모든 배치에서 확인되지 않아 제외한 모드: {modes}.",
        },
        ShownBy { frequency: Quantity, setups: Vec<usize> } => {
            en: "{frequency} (setup {setups})",
            ko: "{frequency}(배치 {setups})",
        },
        OtherShapes { modes: Vec<Sentence> } => {
            en: "Left out, since other setups show that frequency with another shape at the references: {modes}: a sensor turned, exchanged or of another gain, or modes that lie close.",
            ko: "다른 배치가 그 진동수에서 기준 센서에 다른 형상을 보여 제외한 모드: {modes}. 센서가 돌아갔거나 바뀌었거나 감도가 다르거나, 모드가 서로 가깝다.",
        },
        UnlikeIn { frequency: Quantity, setups: Vec<usize>, others: Vec<usize> } => {
            en: "{frequency} (setup {setups}, unlike in setup {others})",
            ko: "{frequency}(배치 {setups}, 배치 {others}에서는 다름)",
        },
        Turned { suspects: Sentence, setup: usize, before: usize, modes: usize } => {
            en: "A reference looks turned round in setup {setup}: against the others {suspects} what it does in setup {before} (± standard deviation), alike in {modes} modes; correct its direction or its scale, no shape put together over it is right.",
            ko: "기준 센서 하나가 배치 {setup}에서 반대로 돌아간 것으로 보인다. 다른 기준 센서에 대한 운동이 배치 {before}에 비해 {suspects}이며(± 표준편차) 모드 {modes}개에서 같다. 방향이나 배율을 바로잡아야 하며, 이 센서로 합성한 모드형상은 옳지 않다.",
        },
        OtherGain { suspects: Sentence, setup: usize, before: usize, modes: usize } => {
            en: "A reference has another gain in setup {setup}: against the others {suspects} what it does in setup {before} (± standard deviation), alike in {modes} modes; correct its scale, no shape put together over it is right.",
            ko: "기준 센서 하나의 감도가 배치 {setup}에서 다르다. 다른 기준 센서에 대한 운동이 배치 {before}에 비해 {suspects}이며(± 표준편차) 모드 {modes}개에서 같다. 배율을 바로잡아야 하며, 이 센서로 합성한 모드형상은 옳지 않다.",
        },
        Suspect { name: String, factor: Quantity } => {
            en: "\"{name}\" moves {factor} times",
            ko: "\"{name}\" {factor}배",
        },
        Or { first: Sentence, other: Sentence } => { en: "{first}, or {other}", ko: "{first} 또는 {other}" },
        NotShown { at: Values } => {
            en: "Setups by themselves show modes that the identification of all as one does not: {at}.",
            ko: "배치별 분석에는 있으나 전체를 하나로 분석하면 나타나지 않는 모드: {at}.",
        },
    }
}

/// The only reference sensor of the setups, if there is just one.
fn only_reference(setups: &SetupsAnswer) -> Option<String> {
    let (references, channels) = match &setups.joint {
        Some(joint) => (&joint.references, &joint.modes.channels),
        None => (&setups.merged.references, &setups.merged.modes.channels),
    };
    match references[..] {
        [one] => channels.get(one).map(|channel| channel.name.clone()),
        _ => None,
    }
}

/// Frequencies of the modes with a property; `None` if there are none.
fn modes_at(setups: &SetupsAnswer, which: impl Fn(&MergedMode) -> bool) -> Option<Values> {
    let merged = &setups.merged;
    let both = merged.modes.modes.iter().zip(&merged.merged);
    let all = both
        .filter(|(_, of)| which(of))
        .map(|(mode, _)| mode.frequency_hz);
    let all: Vec<f64> = all.collect();
    (!all.is_empty()).then(|| all_hertz(&all))
}

/// The remarks on several setups.
pub(crate) fn setup_remarks(setups: &SetupsAnswer) -> Vec<Sentence> {
    let at = |which: &dyn Fn(&MergedMode) -> bool| modes_at(setups, which);
    let mut said: Vec<Remarks> = Vec::new();
    said.extend(only_reference(setups).map(|sensor| Remarks::OneReference { sensor }));
    said.extend(at(&|of| of.frequency.differs()).map(|at| Remarks::FrequencyDiffers { at }));
    let damping = |of: &MergedMode| of.damping.as_ref().is_some_and(Agreement::differs);
    said.extend(at(&damping).map(|at| Remarks::DampingDiffers { at }));
    let unlike = |of: &MergedMode| {
        let mut all = of.reference_assurance.iter().flatten();
        all.any(|mac| *mac < REFERENCES_ALIKE)
    };
    let least = Quantity::new(REFERENCES_ALIKE, Unit::ratio(), Digits::Trimmed(3));
    said.extend(at(&unlike).map(|at| Remarks::Unlike { at, least }));
    said.extend(at(&|of| of.doubtful).map(|at| Remarks::Doubtful { at }));
    said.extend(left_out(&setups.merged.partial));
    said.extend(setups.merged.reference_faults.iter().map(fault_words));
    if let Some(joint) = &setups.joint
        && let Ok(lost_hz) = joint.not_shown_hz(&setups.merged)
        && !lost_hz.is_empty()
    {
        let at = all_hertz(&lost_hz);
        said.push(Remarks::NotShown { at });
    }
    said.into_iter().map(Sentence::from).collect()
}

/// Reasons why joined shapes are wrong: references with another gain, and modes that differ between setups.
pub(super) fn setup_faults(setups: &SetupsAnswer) -> Vec<Sentence> {
    let merged = &setups.merged;
    let faults = merged.reference_faults.iter().map(fault_words);
    let left_out = left_out(&merged.partial).into_iter();
    let unlike = left_out.filter(|said| matches!(said, Remarks::OtherShapes { .. }));
    faults.chain(unlike).map(Sentence::from).collect()
}

fn counted_from_one(setups: &[usize]) -> Vec<usize> {
    setups.iter().map(|setup| setup + 1).collect()
}

/// Modes that not every setup shows, and those that differ between setups.
fn left_out(partial: &[PartialMode]) -> Vec<Remarks> {
    let (missing, unlike): (Vec<&PartialMode>, Vec<&PartialMode>) =
        partial.iter().partition(|mode| mode.unlike_in.is_empty());
    let shown_by = |mode: &PartialMode| {
        Remarks::ShownBy {
            frequency: hertz(mode.frequency_hz),
            setups: counted_from_one(&mode.setups),
        }
        .into()
    };
    let unlike_in = |mode: &PartialMode| {
        Remarks::UnlikeIn {
            frequency: hertz(mode.frequency_hz),
            setups: counted_from_one(&mode.setups),
            others: counted_from_one(&mode.unlike_in),
        }
        .into()
    };
    let mut said = Vec::new();
    if !missing.is_empty() {
        let modes = missing.into_iter().map(shown_by).collect();
        said.push(Remarks::Missing { modes });
    }
    if !unlike.is_empty() {
        let modes = unlike.into_iter().map(unlike_in).collect();
        said.push(Remarks::OtherShapes { modes });
    }
    said
}

fn fault_words(fault: &ReferenceFault) -> Remarks {
    let each = fault.suspects.iter().map(|of| {
        let factor = Quantity {
            sd_si: Some(of.factor_sd),
            ..fixed(of.factor, 2)
        };
        let name = of.channel.clone();
        Sentence::from(Remarks::Suspect { name, factor })
    });
    let each = each.reduce(|first, other| Remarks::Or { first, other }.into());
    let suspects = each.unwrap_or_else(|| Sentence::of_symbol(""));
    let [setup, before] = fault.setups.map(|setup| setup + 1);
    let modes = fault.modes;
    match fault.is_turned() {
        true => Remarks::Turned {
            suspects,
            setup,
            before,
            modes,
        },
        false => Remarks::OtherGain {
            suspects,
            setup,
            before,
            modes,
        },
    }
}
