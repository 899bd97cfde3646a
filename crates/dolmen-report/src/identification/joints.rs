//! Factors on the springs of a stack's joints from vibration: findings, and the section of every joint.

use super::joint_modes::{self, Modes};
use super::joint_tables;
use super::left_out::left_out;
use crate::document::{Block, Document, Figure, Finding, Tone, table_series};
use crate::figures::joint_factors;
use crate::stack::beside;
use dolmen::blocks::{JointFactor, JointFactorsError};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::FactorsAnswer;
use dolmen_work::told_both;

/// Relative change of a frequency as the stack settles again on the identified springs, from which it is a finding. Our choice: the
/// scatter of a good survey.
const RESETTLED_MOST: f64 = 0.01;

messages! {
    /// Factors on the springs of joints.
    pub(crate) enum Joints in "identification.joints" {
        Of { survey: String, said: Sentence } => {
            en: "Joint stiffness from vibration (survey {survey}): {said}",
            ko: "진동으로 추정한 접합부 강성({survey} 조사): {said}",
        },
        Common { factor: Quantity, modes: Sentence } => {
            en: "all springs of the file times {factor} fit {modes} best.",
            ko: "파일의 모든 접합부 강성을 {factor}배로 하면 {modes}에 가장 잘 맞는다.",
        },
        CommonOfOne { factor: Quantity, modes: Sentence } => {
            en: "all springs of the file times {factor} fit {modes}. One factor fits one mode in any case: this is no evidence that the model is right.",
            ko: "파일의 모든 접합부 강성을 {factor}배로 하면 {modes}에 맞는다. 배율 하나는 모드 하나에 항상 맞출 수 있으므로 모델이 옳다는 근거는 아니다.",
        },
        CommonMisses { factor: Quantity, modes: Sentence, misfit: Quantity } => {
            en: "no one factor for all springs of the file explains {modes}. The best, {factor}, is off by {misfit} standard deviations (root mean square): it is no answer.",
            ko: "파일의 모든 접합부 강성에 한 배율을 곱하여 {modes}을(를) 설명할 수 없다. 가장 가까운 {factor}배도 표준편차의 {misfit}배(평균제곱근) 어긋나므로 답이 아니다.",
        },
        All { joints: usize, beds: Sentence } => {
            en: "the modes determine the factor of each of the {joints} {beds}.",
            ko: "{beds} {joints}개의 배율이 모두 정해진다.",
        },
        Counted { joints: usize, beds: Sentence, determined: usize, bounded: usize, unseen: usize, fixed: usize } => {
            en: "of {joints} {beds} the modes determine {determined}, bound {bounded} and do not see {unseen}; they fix {fixed} of {joints} independent combinations of factors.",
            ko: "{beds} {joints}개 가운데 배율이 정해지는 것 {determined}개, 범위만 한정되는 것 {bounded}개, 이 모드로 알 수 없는 것 {unseen}개이다. 독립적인 배율 조합 {joints}개 중 {fixed}개만 정해진다.",
        },
        NotSought { joints: usize, fixed: usize } => {
            en: "the stack has {joints} beds, too many for ranges of each; the modes fix {fixed} independent combinations of their factors. The table gives the least factors and the energy.",
            ko: "접합면이 {joints}단으로 많아 각각의 범위는 구하지 않았다. 독립적인 배율 조합은 {fixed}개만 정해진다. 표에 최소 배율과 변형에너지를 나타냈다.",
        },
        Unexplained { low: Quantity, high: Quantity, misfit: Quantity } => {
            en: "no factors between {low} and {high} explain the modes within their deviations (off by {misfit} of them, root mean square). Check masses, dimensions, deviations and which mode is which; or a joint lies outside that band.",
            ko: "{low}에서 {high} 사이의 배율로는 계측 모드를 표준편차 안에서 설명할 수 없다(표준편차의 {misfit}배, 제곱평균제곱근). 질량, 치수, 표준편차, 모드의 구분을 확인해야 하며, 이 범위를 벗어난 접합면이 있을 수 있다.",
        },
        Least { joint: Sentence, least: Quantity } => {
            en: "whatever the other joints are, {joint} has at least {least} times its stiffness of the file.",
            ko: "다른 접합면이 어떠하든 {joint} 접합부의 강성은 파일 값의 {least}배 이상이다.",
        },
        Resettled { survey: String, change: Quantity } => {
            en: "Survey {survey}: as the stack settles anew on these springs, joints open or close and a frequency changes by {change}. The factors hold for the joints as they lie on the springs of the file; set the springs found in the file and identify again.",
            ko: "{survey} 조사: 이 강성으로 다시 안착시키면 접합면이 벌어지거나 닫혀 고유진동수가 {change} 달라진다. 배율은 파일의 강성에서의 접촉 상태에 대한 값이므로, 구한 강성을 파일에 넣고 다시 추정해야 한다.",
        },
        NoRest { survey: String, why: Both } => {
            en: "Survey {survey}: on these springs the stack finds no rest: {why}",
            ko: "{survey} 조사: 이 강성에서는 적층 구조가 평형을 찾지 못한다: {why}",
        },
        Head(survey: String) => { en: "Survey {survey}, springs of the joints", ko: "{survey} 조사, 접합부 강성" },
        Band { low: Quantity, high: Quantity } => {
            en: "Least factor: were all other joints rigid, a softer one would put a mode two deviations below its measured frequency; it needs no assumption. Range: 95 %, if every factor lies between {low} and {high}, ten times the common factor each way; it is exact for one frequency of a stack whose sway and twist do not couple, else searched from several starts. Best: where the modes determine it, ± standard deviation.",
            ko: "최소 배율은 다른 접합면이 모두 강체라 해도 이보다 무르면 어떤 모드가 계측 진동수보다 표준편차의 2배 이상 낮아지는 값으로, 가정이 필요 없다. 범위는 모든 배율이 공통 배율의 1/10과 10배인 {low}에서 {high} 사이에 있다고 볼 때의 95 % 범위이다(병진과 비틀림이 연성되지 않고 고유진동수가 하나이면 정확한 값, 그 밖에는 여러 시작점에서 탐색한 값). 최적값은 모드로 정해지는 경우에만 표준편차와 함께 나타냈다.",
        },
        Beds => {
            en: "The stack has many joints: those of one plane share a factor.",
            ko: "접합면이 많으므로 같은 평면의 접합면에는 하나의 배율을 적용하였다.",
        },
        Open(joints: usize) => {
            en: "Joints that are open at rest and have no springs in these modes: {joints}.",
            ko: "정지 상태에서 벌어져 있어 이 모드에 강성이 없는 접합면: {joints}개.",
        },
        Exact => {
            en: "The deviations are of what was measured: masses, dimensions and K_s/K_n are taken as exact; 1 % more mass is 1 % more of every factor.",
            ko: "표준편차는 계측값에서만 비롯한 것이며 질량, 치수, K_s/K_n은 정확하다고 보았다. 질량이 1 % 크면 모든 배율이 1 % 크다.",
        },
        JointWord => { en: "joints", ko: "접합면" },
        BedWord => { en: "beds", ko: "접합면(단)" },
        FigureCaption => { en: "Where the factor of each joint can lie.", ko: "접합면별 배율의 범위." },
        FigureMeaning => {
            en: "Bar: 95 % range in the band; diamond: best; triangle: least whatever the others are; vertical line: common factor.",
            ko: "막대는 95 % 범위, 마름모는 최적값, 삼각형은 다른 접합면과 무관한 최소 배율, 세로선은 공통 배율이다.",
        },
        NoModes => {
            en: "No factors on the springs of the joints are sought: the survey states no frequencies along x, along y or of torsion, and has no records. Measure at least the lowest frequency in each direction.",
            ko: "조사에 x, y, 비틀림 방향의 고유진동수도 기록도 없어 접합부 강성을 추정하지 않았다. 방향마다 최저 고유진동수를 계측해야 한다.",
        },
        NoModesInRecord => {
            en: "No factors on the springs of the joints are sought: the records show no mode along x or y. Give position and direction of the channels, or write the modes into the survey.",
            ko: "기록에서 x 또는 y 방향의 모드를 찾지 못해 접합부 강성을 추정하지 않았다. 채널의 위치와 방향을 주거나 조사에 모드를 적어야 한다.",
        },
        OtherDirections(directions: Vec<String>) => {
            en: "No factors on the springs of the joints are sought: the survey states modes in direction {directions}, but a stack sways along x and y and twists (torsion).",
            ko: "조사의 모드 방향이 {directions}뿐이어서 접합부 강성을 추정하지 않았다. 적층 구조의 모드는 x, y, torsion 방향으로 적어야 한다.",
        },
        AlsoOther(directions: Vec<String>) => {
            en: "Modes in direction {directions} are not used: a stack sways along x and y and twists (torsion).",
            ko: "{directions} 방향의 모드는 쓰지 않았다. 적층 구조의 모드는 x, y, torsion 방향으로 적어야 한다.",
        },
        WhatOneWay { number: usize, stone: String } => {
            en: "No factors on the springs of the joints are sought: side support {number} of '{stone}' has no gap, is not pressed at rest, and none as stiff is opposite it. It pushes in one half of each swing alone, so what was measured is no mode of springs. Give the gap that it has, or the support opposite it; or survey without it.",
            ko: "'{stone}'의 측면 지지 {number}은(는) 간격이 없고 정지 상태에서 눌리지 않으며 맞은편에 같은 강성의 지지가 없어, 진동의 한쪽 반주기에만 닿는다. 계측한 것이 스프링 모델의 모드가 아니므로 접합부 강성을 추정하지 않았다. 실제 간격을 적거나 맞은편 지지를 적거나, 지지를 떼고 계측해야 한다.",
        },
        WhatPaired => {
            en: "No factors on the springs of the joints are found: no measured mode can be assigned to a computed one. Measure the mode shapes, or state the lowest mode of each direction.",
            ko: "어느 계측 모드도 계산 모드와 짝을 지을 수 없어 접합부 강성을 추정하지 않았다. 모드형상을 계측하거나 방향마다 최저 모드를 적어야 한다.",
        },
        WhatMode { frequency: Quantity, quantity: String, given: Quantity } => {
            en: "No factors on the springs of the joints are found: the mode at {frequency} has {quantity} = {given}, which cannot be. Points lie between the ground and the top of the stack, and deviations are 0 or more.",
            ko: "{frequency} 모드의 {quantity} 값 {given}이(가) 잘못되어 접합부 강성을 추정하지 않았다. 측점은 지반과 적층 구조의 꼭대기 사이에 있고 표준편차는 0 이상이어야 한다.",
        },
        WhatElse(why: Both) => {
            en: "No factors on the springs of the joints are found: {why}",
            ko: "접합부 강성을 추정하지 못하였다: {why}",
        },
    }
}

/// Why the modes of a stack give no factors.
pub(super) fn refused(why: &JointFactorsError) -> Joints {
    match why {
        JointFactorsError::NoModes => Joints::NoModes,
        JointFactorsError::NonePaired { .. } => Joints::WhatPaired,
        JointFactorsError::Mode {
            frequency_hz,
            quantity,
            given,
            ..
        } => Joints::WhatMode {
            frequency: joint_modes::hertz(*frequency_hz, 0.0),
            quantity: (*quantity).to_owned(),
            given: Quantity::ratio(*given, 4),
        },
        JointFactorsError::Blocks(why) => Joints::WhatElse(told_both(why)),
        JointFactorsError::Linalg(_) | JointFactorsError::Option { .. } => Joints::WhatElse(told_both(why)),
    }
}

/// Numbers of determined, bounded and undetermined factors.
fn counts(factors: &[JointFactor]) -> [usize; 3] {
    let mut counts = [0; 3];
    for factor in factors {
        let at = match (factor.best, factor.range) {
            (Some(_), _) => 0,
            (None, Some(range)) if !range.is_band() => 1,
            (None, _) => 2,
        };
        counts[at] += 1;
    }
    counts
}

/// Findings of a survey on the joints of a stack.
pub(super) fn findings(survey: &str, answer: &FactorsAnswer) -> Vec<Finding> {
    let of = |said: Sentence| Joints::Of {
        survey: survey.to_owned(),
        said,
    };
    let found = &answer.found;
    let factor = joint_tables::factor(found.common.factor, Some(found.common.relative_sd));
    let modes = Modes::counted(found.modes.len());
    let (common_tone, common) = match answer.common_misses() {
        false if found.modes.len() == 1 => (Tone::Plain, Joints::CommonOfOne { factor, modes }),
        false => (Tone::Good, Joints::Common { factor, modes }),
        true => {
            let misfit = Quantity::ratio(found.common.misfit, 2);
            (
                Tone::Warn,
                Joints::CommonMisses {
                    factor,
                    modes,
                    misfit,
                },
            )
        }
    };
    let (tone, each, code) = by_joint(answer);
    let mut all = vec![
        Finding::key(common_tone, of(common.into())),
        Finding {
            code,
            ..Finding::key(tone, of(each.into()))
        },
    ];
    let held = beside(&answer.beside).into_iter();
    all.extend(held.map(|said| Finding::key(Tone::Warn, of(said.into()))));
    let highest = found
        .factors
        .iter()
        .enumerate()
        .filter_map(|(at, factor)| Some((at, factor.least?)));
    if let Some((at, least)) = highest.max_by(|a, b| a.1.total_cmp(&b.1))
        && found.factors[at].best.is_none()
    {
        let said = Joints::Least {
            joint: joint_tables::name(answer, at),
            least: joint_tables::factor(least, None),
        };
        all.push(Finding::new(Tone::Plain, of(said.into())));
    }
    all.extend(
        found
            .unused
            .iter()
            .map(|unused| Finding::key(Tone::Warn, joint_modes::unused(survey, unused))),
    );
    let survey = survey.to_owned();
    match &found.resettled {
        Ok(change) if *change > RESETTLED_MOST => {
            let change = Quantity::percent(*change, 2);
            all.push(Finding::key(Tone::Warn, Joints::Resettled { survey, change }));
        }
        Ok(_) => {}
        Err(why) => {
            let why = told_both(why);
            all.push(Finding::key(Tone::Warn, Joints::NoRest { survey, why }));
        }
    }
    all
}

fn by_joint(answer: &FactorsAnswer) -> (Tone, Joints, Option<&'static str>) {
    let found = &answer.found;
    let (joints, fixed) = (found.factors.len(), found.fixed_combinations);
    let beds = match answer.is_of_beds() {
        true => Joints::BedWord,
        false => Joints::JointWord,
    };
    let [determined, bounded, unseen] = counts(&found.factors);
    match found.explains {
        None => (
            Tone::Warn,
            Joints::NotSought { joints, fixed },
            Some("joints-unseen"),
        ),
        Some(false) => {
            let [low, high] = band(answer);
            let misfit = Quantity::ratio(found.best_misfit.unwrap_or(f64::NAN), 2);
            (
                Tone::Warn,
                Joints::Unexplained { low, high, misfit },
                Some("joints-unseen"),
            )
        }
        Some(true) if determined == joints => (
            Tone::Good,
            Joints::All {
                joints,
                beds: beds.into(),
            },
            None,
        ),
        Some(true) => (
            Tone::Warn,
            Joints::Counted {
                joints,
                beds: beds.into(),
                determined,
                bounded,
                unseen,
                fixed,
            },
            Some("joints-unseen"),
        ),
    }
}

fn band(answer: &FactorsAnswer) -> [Quantity; 2] {
    answer
        .found
        .band
        .map(|end| Quantity::new(end, Unit::ratio(), Digits::Significant(3)))
}

/// The input modes, every joint, and the basis of the numbers.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: &str, answer: &'a FactorsAnswer) {
    let found = &answer.found;
    document.subheading(Joints::Head(survey.to_owned()));
    document.put(Block::Table(joint_modes::table(answer)));
    document.put(Block::Table(joint_tables::factors(answer)));
    let [low, high] = band(answer);
    document.note(Joints::Band { low, high });
    let drawn = Figure::drawn(
        vec![Joints::FigureCaption.into(), Joints::FigureMeaning.into()],
        move |language| joint_factors(answer, language),
    );
    document.charted(drawn.with_series(move || table_series(&joint_tables::factors(answer))));
    document.put(Block::Table(joint_tables::energy(answer)));
    if answer.is_of_beds() {
        document.note(Joints::Beds);
    }
    if !found.open_joints.is_empty() {
        document.note(Joints::Open(found.open_joints.len()));
    }
    for said in joint_modes::notes(answer) {
        document.note(said);
    }
    for why in &answer.left_out {
        document.note(left_out(why));
    }
    if !answer.other_directions.is_empty() {
        document.note(Joints::AlsoOther(answer.other_directions.clone()));
    }
    document.note(Joints::Exact);
}
