//! Notes on the modes of a record.

use super::clipped::from_clipping_words;
use super::clocks::{Clocks, drifting, late};
use super::faults::fault_words;
use super::refused::refused_words;
use super::steady::{in_spells_words, on_mode_words, steady_words, tone_words, wander_words};
use super::values::{all_hertz, fixed, hertz, percent, plain};
use dolmen::modal::{Note, ShapeQuantity};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};

/// Largest number of footstep lines that an answer lists; one walk gives twenty.
const SPELLS_SHOWN: usize = 5;

messages! {
    /// Notes on modes.
    pub(crate) enum Notes in "modal.notes" {
        UsedAllTheSame { fault: Sentence } => {
            en: "{fault} It was used all the same.",
            ko: "{fault} 그대로 사용하였다.",
        },
        LeftOut { fault: Sentence } => {
            en: "{fault} It was left out of the modes.",
            ko: "{fault} 모드 식별에서 제외하였다.",
        },
        BlockRowsBounded { taken: usize, wished: usize } => {
            en: "{taken} block rows instead of {wished}, to keep the matrices in bounds: modes that lie close together are told apart less well.",
            ko: "행렬 크기를 제한하기 위해 블록 행을 {wished}개 대신 {taken}개로 하였다. 서로 가까운 모드의 구별이 어려워진다.",
        },
        FewBlocks { blocks: usize, accuracy: Quantity } => {
            en: "The record is short: standard deviations come from {blocks} blocks of time, and are themselves known to ± {accuracy}.",
            ko: "기록이 짧아 표준편차를 시간 블록 {blocks}개에서 산정하였으며, 표준편차 자체의 정확도는 ± {accuracy}이다.",
        },
        Tones { tones: Vec<Sentence> } => {
            en: "The spectrum has lines of one phase for the whole record, or too steady for random forces, at {tones}: machines.",
            ko: "{tones}에 기록 전체에서 위상이 일정하거나 세기가 너무 일정한 스펙트럼 선이 있다. 기계 진동이다.",
        },
        Narrow { least: Quantity, peaks: Vec<Sentence>, first: Quantity } => {
            en: "The spectrum has peaks narrower than a mode with a damping ratio of {least}, or steadier than modes are, at {peaks}: machines that run for a part of the time, or modes damped less than that«; damping_least in the modal options of the survey admits them, and accept = [{first}] the one at that frequency».",
            ko: "{peaks}에 감쇠비 {least}인 모드보다 폭이 좁거나 모드보다 세기가 일정한 스펙트럼 피크가 있다. 일부 시간만 가동한 기계 진동이거나 감쇠가 그보다 작은 모드이다.« 모드라면 조사의 modal 항목에서 damping_least로 하한을 낮추거나 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        TonesOnModes { tones: Vec<Sentence> } => {
            en: "Machines run on modes, at {tones}: their sines keep one phase for the whole record or half of it; the damping ratio of such a mode comes out too low (none is given where by more than its interval), and its shape is the machine's too: measure while the machine rests.",
            ko: "모드의 진동수에서 기계가 가동한다({tones}). 기록 전체 또는 절반에서 위상이 일정한 정현파가 있어 그 모드의 감쇠비는 실제보다 작고(그 차이가 신뢰구간보다 크면 제시하지 않는다) 모드형상에는 기계의 영향이 섞인다. 기계가 멈춘 동안 다시 계측한다.",
        },
        HarmonicsRemoved { steady: Vec<Sentence> } => {
            en: "The motion at {steady} is too steady for random forces (3 is random, 1.5 a sine): machines, left out.",
            ko: "{steady}의 운동은 불규칙 외력에 의한 것으로 보기에는 세기가 너무 일정하다(불규칙 3, 정현파 1.5). 기계 진동이며 모드에서 제외하였다.",
        },
        Harmonics { steady: Vec<Sentence> } => {
            en: "The motion at {steady} is too steady for random forces (3 is random, 1.5 a sine): machines, not to be trusted as modes.",
            ko: "{steady}의 운동은 불규칙 외력에 의한 것으로 보기에는 세기가 너무 일정하다(불규칙 3, 정현파 1.5). 기계 진동이며 모드로 신뢰할 수 없다.",
        },
        WanderingRemoved { machines: Vec<Sentence>, first: Quantity } => {
            en: "Left out, since random forces change the strength and the phase of a motion alike (0 ± its standard deviation; 1 strength alone, −1 phase alone): {machines}. A machine whose speed or strength wanders.« If you know one to be a mode, accept = [{first}] in the modal table of the record takes it.»",
            ko: "불규칙 외력은 운동의 세기와 위상을 똑같이 바꾸는데(0 ± 표준편차, 세기만 변하면 1, 위상만 변하면 −1) 그렇지 않아 모드에서 제외하였다: {machines}. 회전수나 세기가 변하는 기계의 진동이다.« 모드임이 확실하면 기록의 modal 항목에 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        Wandering { machines: Vec<Sentence> } => {
            en: "Random forces change the strength and the phase of a motion alike (0 ± its standard deviation; 1 strength alone, −1 phase alone), but not at {machines}: a machine whose speed or strength wanders, not to be trusted as a mode; or a stiffness that follows the motion. Measure again while machines rest.",
            ko: "불규칙 외력은 운동의 세기와 위상을 똑같이 바꾸는데(0 ± 표준편차, 세기만 변하면 1, 위상만 변하면 −1) 다음은 그렇지 않다: {machines}. 회전수나 세기가 변하는 기계의 진동이면 모드로 신뢰할 수 없다. 강성이 진폭에 따라 변하여도 이렇게 나타난다. 기계가 멈춘 동안 다시 계측한다.",
        },
        InSpells { modes: Vec<Sentence>, first: Quantity } => {
            en: "Left out, since nothing stands there while the structure is quiet: {modes}. Footsteps, other blows that follow each other, or a machine that ran for a while; in gusts perhaps a mode that noise hides in calm.« If you know one to be a mode, accept = [{first}] in the modal table of the record takes it.»",
            ko: "구조물이 조용한 동안에는 나타나지 않아 모드에서 제외하였다: {modes}. 발걸음처럼 잇따르는 충격이나 잠시 가동한 기계의 진동이다. 돌풍에서는 약할 때 잡음에 가려지는 모드일 수도 있다.« 모드임이 확실하면 기록의 modal 항목에 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        InSpellsAndMore { modes: Vec<Sentence>, more: usize, first: Quantity } => {
            en: "Left out, since nothing stands there while the structure is quiet: {modes}, and {more} more. Footsteps, other blows that follow each other, or a machine that ran for a while; in gusts perhaps a mode that noise hides in calm.« If you know one to be a mode, accept = [{first}] in the modal table of the record takes it.»",
            ko: "구조물이 조용한 동안에는 나타나지 않아 모드에서 제외하였다: {modes} 외 {more}개. 발걸음처럼 잇따르는 충격이나 잠시 가동한 기계의 진동이다. 돌풍에서는 약할 때 잡음에 가려지는 모드일 수도 있다.« 모드임이 확실하면 기록의 modal 항목에 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        Comb { fundamental: Quantity, at: Values, first: Quantity } => {
            en: "Left out, since they are steadier than modes and lie at multiples of one frequency, {fundamental}: {at}. Steps that never pause, a bell or an engine; a mode among them is hidden. Measure again without them.« If you know one to be a mode, accept = [{first}] in the modal table of the record takes it.»",
            ko: "모드보다 세기가 일정하고 한 진동수 {fundamental}의 배수에 있어 모드에서 제외하였다: {at}. 쉬지 않는 발걸음, 종, 엔진의 진동이며, 그 사이의 모드는 가려진다. 이런 진동이 없을 때 다시 계측한다.« 모드임이 확실하면 기록의 modal 항목에 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        Clipping { modes: Vec<Sentence>, first: Quantity } => {
            en: "Left out, since the clipping of a channel makes them: {modes}. A clipped signal also contains sums and differences of the frequencies of the structure, and no other channel shows these.« If you know one to be a mode, accept = [{first}] in the modal table of the record takes it.»",
            ko: "채널의 포화가 만든 것이므로 모드에서 제외하였다: {modes}. 포화된 신호에는 구조물 진동수의 합과 차도 나타나며, 다른 채널에는 없다.« 모드임이 확실하면 기록의 modal 항목에 accept = [{first}]처럼 진동수를 지정한다.»",
        },
        NoDamping { at: Values } => {
            en: "No damping ratio is given for the peaks at {at}: another mode cuts their sides, they decay too fast to fit, or what decays has another frequency than the peak; the subspace methods tell close modes apart.",
            ko: "{at} 피크의 감쇠비는 제시하지 않는다. 다른 모드가 피크의 옆을 자르거나, 감쇠가 너무 빠르거나, 감쇠하는 진동수가 피크와 다르다. 가까운 모드는 부분공간법으로 구별한다.",
        },
        LightModes { at: Values } => {
            en: "The modes at {at} are damped less than 0.2 %: few structures but steel and single stones are, and a machine whose speed wanders looks the same. Measure again while machines rest.",
            ko: "{at} 모드의 감쇠비가 0.2 %보다 작다. 강재나 단일 석재가 아니면 드물고, 회전수가 변하는 기계의 진동도 이와 같이 보인다. 기계가 멈춘 동안 다시 계측한다.",
        },
        ClosePairs { pairs: Vec<Sentence> } => {
            en: "The modes at {pairs} lie closer than their bandwidths: the plane of their two shapes is known better than each shape in it.",
            ko: "{pairs}의 모드는 대역폭보다 가까이 있다. 각 모드형상보다 두 형상이 이루는 평면이 더 정확하다.",
        },
        Pair { low: Quantity, high: Quantity } => { en: "{low}–{high}", ko: "{low}–{high}" },
        FilteredAbove { passed: Quantity, asked: Quantity } => {
            en: "Modes are sought up to {passed}, not to «frequency_high_hz = {asked}|{asked} as asked»: above it the filter cuts with which the record was brought to its rate«; lower decimate_factor to see more».",
            ko: "모드는 «frequency_high_hz = {asked}이(가)|요구한 {asked}이(가)» 아니라 {passed}까지 탐색하였다. 그 위는 샘플링 주파수를 낮출 때 쓴 필터가 «자르므로, 더 높은 모드를 보려면 decimate_factor를 줄여야 한다|자른다».",
        },
        Blends { blends: Vec<Sentence> } => {
            en: "Left out, since low orders alone show it and it is damped far above the modes: {blends}: several modes that this record does not tell apart; a longer record or more sensors may.",
            ko: "{blends}: 낮은 차수에서만 나타나고 감쇠비가 다른 모드보다 훨씬 크므로 제외하였다. 이 기록으로는 구별되지 않는 여러 모드가 합쳐진 것이며, 기록이 더 길거나 센서가 더 많으면 구별될 수 있다.",
        },
        InValleys { blends: Vec<Sentence> } => {
            en: "Left out, since the spectrum has a valley there between two peaks: {blends}: two modes in one. More block rows« (block_rows)» or more sensors may tell them apart.",
            ko: "{blends}: 스펙트럼의 두 봉우리 사이 골에 있으므로 제외하였다. 두 모드가 하나로 합쳐진 것이며, «block_rows를|블록 행을» 늘리거나 센서를 더하면 구별될 수 있다.",
        },
        Blend { frequency: Quantity, damping: Quantity } => {
            en: "{frequency} (damping {damping})",
            ko: "{frequency}(감쇠비 {damping})",
        },
        FromPeaks { at: Values } => {
            en: "No stable pole shows the modes at {at}: a mode was fitted to the lines of the spectrum there, and fits; the shape of one that was only a peak has no deviation.",
            ko: "{at} 모드는 안정 극점에는 나타나지 않으나, 그 주변의 푸리에 선에 모드를 적합하여 얻었고 잘 맞는다. 스펙트럼 피크뿐이던 모드의 모드형상에는 표준편차가 없다.",
        },
        NotFitted { at: Values } => {
            en: "The modes at {at} are those of ssi-cov, not fitted further: the spectrum about them is not that of these modes alone under even forces (another mode, a machine, a stiffness that follows the motion), or has too few lines.",
            ko: "{at} 모드는 ssi-cov의 값 그대로이다. 주변 스펙트럼이 고른 힘을 받는 이 모드들만의 것과 다르거나(다른 모드, 기계, 진폭에 따라 변하는 강성), 푸리에 선이 너무 적다.",
        },
        HiddenPairs { at: Values } => {
            en: "Two singular values of the spectrum rise at {at}, where one mode was found: it may be two that lie close, and then its frequency, damping and shape are of both; ssi-cov and ssi-data tell close modes apart.",
            ko: "{at}에서 스펙트럼의 특이값 두 개가 함께 솟지만 모드는 하나만 찾았다. 가까운 두 모드일 수 있으며, 그렇다면 진동수, 감쇠비, 모드형상은 둘이 섞인 것이다. ssi-cov와 ssi-data가 가까운 모드를 구별한다.",
        },
        PeaksWithoutMode { peaks: Vec<Sentence>, first: Quantity } => {
            en: "The spectrum has peaks that are no modes, each with the test that refused it: {peaks}.« If you know one to be a mode, accept = [{first}] (its frequency, Hz) in the modal table of the record takes it, marked as accepted by you.»",
            ko: "스펙트럼에 모드로 보지 않은 피크가 있다. 괄호 안은 그 이유이다: {peaks}. «모드임이 확실하면 기록의 modal 항목에 accept = [{first}](진동수, Hz)를 쓴다. 사용자가 채택한 모드로 표시된다.»",
        },
        PeaksUnsaid { peaks: Vec<Sentence> } => {
            en: "The spectrum has peaks that are no modes: {peaks}.",
            ko: "스펙트럼에 모드로 보지 않은 피크가 있다: {peaks}.",
        },
        Accepted { modes: Vec<Sentence> } => {
            en: "Accepted by the user, not found by the tests; in brackets what refused each: {modes}.",
            ko: "사용자가 채택한 모드로, 판정 기준으로 찾은 것이 아니다. 괄호 안은 기준에서 제외된 이유이다: {modes}.",
        },
        AcceptedAlready { at: Values } => {
            en: "The modes at {at} were found anyway: they need no accept.",
            ko: "{at} 모드는 판정 기준으로도 찾았으므로 accept가 필요하지 않다.",
        },
        NothingToAccept { asked: Quantity, within: Quantity } => {
            en: "«accept = [{asked}] takes nothing|The mode asked for at {asked} is not taken»: within {within} no mode, no peak of the spectrum and no group of poles stands there.« Correct it, or leave it out.»",
            ko: "«accept = [{asked}]에|지정한 {asked} Hz에» 해당하는 것이 없다. ± {within} 안에 모드도 스펙트럼 피크도 극점군도 없다.« 값을 고치거나 뺀다.»",
        },
        NothingToAcceptBut { asked: Quantity, within: Quantity, nearest: Values } => {
            en: "«accept = [{asked}] takes nothing|The mode asked for at {asked} is not taken»: within {within} no mode, no peak of the spectrum and no group of poles stands there; the nearest are at {nearest}.« Correct it, or leave it out.»",
            ko: "«accept = [{asked}]에|지정한 {asked} Hz에» 해당하는 것이 없다. ± {within} 안에 모드도 스펙트럼 피크도 극점군도 없다. 가장 가까운 것은 {nearest}이다.« 값을 고치거나 뺀다.»",
        },
        NotPicked { at: Values } => {
            en: "Modes that were found and not picked: {at}.",
            ko: "찾았으나 직접 선택하지 않은 모드: {at}.",
        },
        OneQuantity { quantity: Sentence } => {
            en: "The channels measure different quantities: every shape is given as {quantity}, brought there at its mode's own frequency.",
            ko: "채널마다 계측한 물리량이 다르므로 모드형상은 각 모드의 진동수에서 {quantity}(으)로 환산하였다.",
        },
        Acceleration => { en: "acceleration", ko: "가속도" },
        Velocity => { en: "velocity", ko: "속도" },
        Displacement => { en: "displacement", ko: "변위" },
        QuarterTurn { channels: Vec<String>, at: Values } => {
            en: "{channels}: a quarter turn (90°) off the other channels at every mode seen ({at}): they measure another quantity, as a geophone (velocity) beside accelerometers does. A clock that is late turns high modes more than low ones, and this is none. They are left out of the shapes; give the record of each its unit (as a station of its own where one file holds both), and they are in them.",
            ko: "{channels}: 보이는 모든 모드({at})에서 다른 채널과 위상이 90° 다르다. 가속도계 옆의 속도계(지오폰)처럼 다른 물리량을 재는 채널이다. 시계가 늦으면 높은 모드일수록 위상이 더 돌아가므로 시계 문제가 아니다. 이 채널은 모드형상에서 제외하였다. 각 기록에 unit을 주면(한 파일에 섞여 있으면 별도의 측점으로 나누어) 포함된다.",
        },
        EitherTurned { channels: Vec<String>, others: Vec<String>, at: Values } => {
            en: "{channels} and {others} are a quarter turn (90°) apart at every mode seen ({at}): one half measures another quantity, as geophones (velocity) beside accelerometers do. As many channels agree with one as with the other, so the phases cannot tell which. No channel is left out, and frequencies and damping stay; the shapes take the first for the different half: if it is the other, the size and sign of one half against the other are wrong. Give the record of each its unit (as a station of its own where one file holds both).",
            ko: "{channels}와(과) {others}은(는) 보이는 모든 모드({at})에서 위상이 서로 90° 다르다. 가속도계 옆의 속도계(지오폰)처럼 한쪽이 다른 물리량을 잰다. 서로 맞는 채널의 수가 같아 위상으로는 어느 쪽인지 알 수 없다. 제외한 채널은 없으며 진동수와 감쇠비는 유효하다. 모드형상은 앞의 채널이 다른 물리량을 잰 것으로 보고 구하였으므로, 뒤의 채널이라면 두 쪽 사이의 크기와 부호가 틀린다. 각 기록에 unit을 준다(한 파일에 섞여 있으면 별도의 측점으로 나눈다).",
        },
        StandsStill { channel: String, share: Quantity } => {
            en: "\"{channel}\" moves by less than {share} of the largest in every mode: it stands on firm ground, is not connected, or is in another unit than the others (g read as gal is 981 times too small, m/s² as mm/s² 1000 times, g as m/s² 9.81 times).",
            ko: "채널 \"{channel}\"은(는) 모든 모드에서 최대 성분의 {share} 미만으로 움직인다. 단단한 지반 위에 있거나 연결되지 않았거나, 다른 채널과 단위가 다르다(g를 gal로 읽으면 981배, m/s²를 mm/s²로 읽으면 1000배, g를 m/s²로 읽으면 9.81배 작다).",
        },
        PhaseOff { channel: String, by: Vec<Sentence> } => {
            en: "The phase of \"{channel}\" is off a shape's 0 or 180° by {by}: its clock or filter differs from the others', and its sign is not known in any mode; or modes lie close together.",
            ko: "채널 \"{channel}\"의 위상이 0° 또는 180°에서 벗어난다({by}). 시계나 필터가 다른 채널과 다르며 어느 모드에서도 부호를 알 수 없다. 또는 모드가 서로 가깝다.",
        },
        Angle { angle: Quantity, frequency: Quantity } => {
            en: "{angle} at {frequency}",
            ko: "{frequency}에서 {angle}",
        },
        FewCycles { frequency: Quantity, floor: Quantity } => {
            en: "The mode at {frequency} was seen for so few cycles that its damping ratio cannot be known better than ± {floor}.",
            ko: "{frequency} 모드는 관측 주기 수가 적어 감쇠비를 ± {floor}보다 정확히 알 수 없다.",
        },
    }
}

/// The sentence of a note.
pub(super) fn note_words(note: &Note) -> Sentence {
    match note {
        Note::Channel(fault) => Notes::UsedAllTheSame {
            fault: fault_words(fault),
        },
        Note::LeftOut(fault) => Notes::LeftOut {
            fault: fault_words(fault),
        },
        Note::BlockRowsBounded { wished, taken } => Notes::BlockRowsBounded {
            taken: *taken,
            wished: *wished,
        },
        Note::FewBlocks { time_blocks } => Notes::FewBlocks {
            blocks: *time_blocks,
            accuracy: percent(1.0 / (2.0 * (*time_blocks as f64 - 1.0)).sqrt(), 0),
        },
        Note::Tones { tones } => Notes::Tones {
            tones: tones.iter().map(tone_words).collect(),
        },
        Note::Narrow {
            peaks,
            damping_ratio_least,
        } => Notes::Narrow {
            least: percent(*damping_ratio_least, 2),
            peaks: peaks.iter().map(tone_words).collect(),
            first: first_of(peaks.first().map(|of| of.frequency_hz)),
        },
        Note::TonesOnModes { tones } => Notes::TonesOnModes {
            tones: tones.iter().map(on_mode_words).collect(),
        },
        Note::Harmonics { steady, removed } => {
            let steady = steady.iter().map(steady_words).collect();
            match removed {
                true => Notes::HarmonicsRemoved { steady },
                false => Notes::Harmonics { steady },
            }
        }
        Note::Wandering {
            machines,
            removed: true,
        } => Notes::WanderingRemoved {
            machines: machines.iter().map(wander_words).collect(),
            first: first_of(machines.first().map(|of| of.frequency_hz)),
        },
        Note::Wandering { machines, .. } => Notes::Wandering {
            machines: machines.iter().map(wander_words).collect(),
        },
        Note::InSpells { modes } if modes.len() > SPELLS_SHOWN => {
            let mut strongest = modes.clone();
            strongest.sort_by(|a, b| b.stands_out.total_cmp(&a.stands_out));
            Notes::InSpellsAndMore {
                first: first_of(strongest.first().map(|of| of.frequency_hz)),
                modes: strongest[..SPELLS_SHOWN].iter().map(in_spells_words).collect(),
                more: modes.len() - SPELLS_SHOWN,
            }
        }
        Note::InSpells { modes } => Notes::InSpells {
            modes: modes.iter().map(in_spells_words).collect(),
            first: first_of(modes.first().map(|of| of.frequency_hz)),
        },
        Note::Comb {
            fundamental_hz,
            frequency_hz,
        } => Notes::Comb {
            fundamental: hertz(*fundamental_hz),
            at: all_hertz(frequency_hz),
            first: first_of(frequency_hz.first().copied()),
        },
        Note::Clipping { modes } => Notes::Clipping {
            modes: modes.iter().map(from_clipping_words).collect(),
            first: first_of(modes.first().map(|of| of.frequency_hz)),
        },
        Note::NoDamping { frequency_hz } => Notes::NoDamping {
            at: all_hertz(frequency_hz),
        },
        Note::LightModes { frequency_hz } => Notes::LightModes {
            at: all_hertz(frequency_hz),
        },
        Note::ClosePairs { pairs } => Notes::ClosePairs {
            pairs: pairs.iter().map(pair_words).collect(),
        },
        Note::FilteredAbove { asked_hz, passed_hz } => Notes::FilteredAbove {
            passed: hertz(*passed_hz),
            asked: hertz(*asked_hz),
        },
        Note::InValleys { blends } => Notes::InValleys {
            blends: blends.iter().map(blend_words).collect(),
        },
        Note::Blends { blends } => Notes::Blends {
            blends: blends.iter().map(blend_words).collect(),
        },
        Note::FromPeaks { frequency_hz } => Notes::FromPeaks {
            at: all_hertz(frequency_hz),
        },
        Note::NotFitted { frequency_hz } => Notes::NotFitted {
            at: all_hertz(frequency_hz),
        },
        Note::HiddenPairs { frequency_hz } => Notes::HiddenPairs {
            at: all_hertz(frequency_hz),
        },
        // peaks of jointly identified setups have no complete shape
        Note::PeaksWithoutMode { peaks } if peaks.iter().all(|of| of.refusal.is_none()) => {
            Notes::PeaksUnsaid {
                peaks: peaks.iter().map(refused_words).collect(),
            }
        }
        Note::PeaksWithoutMode { peaks } => Notes::PeaksWithoutMode {
            peaks: peaks.iter().map(refused_words).collect(),
            first: first_of(peaks.first().map(|of| of.frequency_hz)),
        },
        Note::Accepted { modes } => Notes::Accepted {
            modes: modes.iter().map(refused_words).collect(),
        },
        Note::AcceptedAlready { frequency_hz } => Notes::AcceptedAlready {
            at: all_hertz(frequency_hz),
        },
        Note::NothingToAccept {
            asked_hz,
            within_hz,
            nearest_hz,
        } => {
            let (asked, within) = (plain(*asked_hz), hertz(*within_hz));
            match nearest_hz.is_empty() {
                true => Notes::NothingToAccept { asked, within },
                false => Notes::NothingToAcceptBut {
                    asked,
                    within,
                    nearest: all_hertz(nearest_hz),
                },
            }
        }
        Note::NotPicked { frequency_hz } => Notes::NotPicked {
            at: all_hertz(frequency_hz),
        },
        Note::OneQuantity { quantity } => Notes::OneQuantity {
            quantity: quantity_word(*quantity),
        },
        Note::QuarterTurn {
            channels,
            frequency_hz,
        } => Notes::QuarterTurn {
            channels: channels.clone(),
            at: all_hertz(frequency_hz),
        },
        Note::EitherTurned {
            channels,
            others,
            frequency_hz,
        } => Notes::EitherTurned {
            channels: channels.clone(),
            others: others.clone(),
            at: all_hertz(frequency_hz),
        },
        Note::StandsStill { channel, share } => Notes::StandsStill {
            channel: channel.clone(),
            share: percent(share.max(0.001), 1),
        },
        Note::PhaseOff {
            channel,
            degrees_at_hz,
        } => Notes::PhaseOff {
            channel: channel.clone(),
            by: degrees_at_hz.iter().map(angle_words).collect(),
        },
        Note::ClockDrift {
            drifting: all,
            others,
            turn_degrees,
            frequency_hz,
            sampling_rate_hz,
        } => {
            let each = drifting(all, *sampling_rate_hz);
            let (frequency, turn) = (hertz(*frequency_hz), degrees(*turn_degrees));
            let said = match others.as_slice() {
                [] => Clocks::Drift {
                    each,
                    frequency,
                    turn,
                },
                others => Clocks::EitherDrift {
                    each,
                    others: others.to_vec(),
                    frequency,
                    turn,
                },
            };
            return said.into();
        }
        Note::LateClocks { late: all } => return Clocks::Late { each: late(all) }.into(),
        Note::EitherLate { late: all, others } => {
            let said = Clocks::EitherLate {
                each: late(all),
                others: others.clone(),
            };
            return said.into();
        }
        Note::FewCycles {
            frequency_hz,
            damping_floor,
        } => Notes::FewCycles {
            frequency: hertz(*frequency_hz),
            floor: percent(*damping_floor, 0),
        },
    }
    .into()
}

/// The number that `accept` takes.
fn first_of(frequency_hz: Option<f64>) -> Quantity {
    plain(frequency_hz.map_or(0.0, |hz| (hz * 1e3).round() / 1e3))
}

fn degrees(angle: f64) -> Quantity {
    Quantity {
        unit: Unit::si("°"),
        digits: Digits::Fixed(0),
        ..fixed(angle, 0)
    }
}

fn pair_words([low, high]: &[f64; 2]) -> Sentence {
    Notes::Pair {
        low: hertz(*low),
        high: hertz(*high),
    }
    .into()
}

fn blend_words([frequency_hz, damping_ratio]: &[f64; 2]) -> Sentence {
    Notes::Blend {
        frequency: hertz(*frequency_hz),
        damping: percent(*damping_ratio, 1),
    }
    .into()
}

fn angle_words([angle, frequency_hz]: &[f64; 2]) -> Sentence {
    Notes::Angle {
        angle: degrees(*angle),
        frequency: hertz(*frequency_hz),
    }
    .into()
}

fn quantity_word(quantity: ShapeQuantity) -> Sentence {
    match quantity {
        ShapeQuantity::Acceleration => Notes::Acceleration,
        ShapeQuantity::Velocity => Notes::Velocity,
        ShapeQuantity::Displacement => Notes::Displacement,
    }
    .into()
}
