//! Errors of modal identification, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::modal::ModalError;

korean_of! {
    ModalError {
        ModalError::Order { given, block_rows, channels, most } => "order_most가 {given}인데 블록 행 {block_rows}개, 채널 {channels}개이면 {most}까지이다. block_rows를 키우거나 order_most를 낮춘다";
        ModalError::Rank { given, rank } => "order_most가 {given}인데 상관행렬의 계수(rank)가 계산 정밀도로 {rank}이다. 기록에 잡음이 거의 없다. order_most를 {rank} 이하로 낮춘다";
        ModalError::Dependent { decimation } => "decimation이 {decimation}인데 기록에 잡음이 거의 없다. 과거 자료 하나가 나머지의 조합에 가까워 QR에 자료가 그대로 필요하다. decimation을 1로 하거나 block_rows를 낮추거나 ssi_cov를 쓴다";
        ModalError::ModesWanted { given, order_most, most } => "modes_wanted가 {given}인데 차수 {order_most}의 모델에는 모드가 {most}개까지 있다. order_most를 키우거나 개수를 줄인다";
        ModalError::ModesMissing { given, found, found_hz } => "modes_wanted가 {given}인데 안정한 모드를 {found}개만 찾았다({found_hz} Hz). 더 오래 기록하거나, 빠진 모드가 움직이는 곳에 센서를 두거나, {found}개로 한다", found_hz = listed_hz(found_hz);
        ModalError::NoModeAt { given_hz, within_hz, found_hz } => "{given_hz} Hz(± {within_hz} Hz)에서 모드를 찾지 못했다. 찾은 모드: {found_hz} Hz. 다른 모드로 대신하지 않는다", within_hz = format!("{within_hz:.3}"), found_hz = listed_hz(found_hz);
        ModalError::BlockRows { given, least, frequency_hz, sampling_rate_hz } => "block_rows가 {given}인데 찾는 가장 낮은 모드({frequency_hz:.3} Hz)에는 초당 {sampling_rate_hz}개의 자료에서 {least} 이상이 필요하다. block_rows를 키우거나, 솎거나, frequency_low_hz를 높인다";
        ModalError::TooShort { samples, lags, blocks, needed } => "기록의 자료가 {samples}개인데 시간 블록 {blocks}개에서 지연 {lags}개의 상관에는 {needed}개가 필요하다. 더 오래 기록하거나 block_rows를 낮춘다";
        ModalError::Option { option, given, allowed } => "{option}이(가) {given}인데 {allowed}이어야 한다", option = phrase(option), allowed = phrase(allowed);
        ModalError::NoPeakLeft { at_hz } => "스펙트럼의 피크({at_hz} Hz)가 모두 기계 진동이거나 구조물이 조용한 동안에는 나타나지 않는 것이다. 기계와 발걸음 없이 구조물이 고르게 진동하는 구간만 식별한다. 그래도 찾으려면 block_rows와 진동수 범위를 입력한다", at_hz = listed_hz(at_hz);
        ModalError::NoPeak { prominence_db, low_hz, high_hz } => "{low_hz}~{high_hz} Hz의 스펙트럼에 주변보다 {prominence_db} dB 높은 피크가 없다. 기록에 잡음뿐일 수 있다. 당겼다 놓거나 타격한 뒤의 자유진동이면 method = \"era\"로 한다. 그 밖의 기록에서 그래도 찾으려면 block_rows와 진동수 범위를 입력한다";
        ModalError::AcceptedOfDecay { given_hz } => "자유감쇠(era)의 모드는 판정 기준으로 제외되지 않으므로 {given_hz} Hz를 채택할 수 없다. 뺀다";
        ModalError::PickedTwice { given_hz, found_hz } => "pick_hz {given_hz}은(는) {found_hz:.4} Hz의 모드인데 다른 선택이 이미 그 모드를 가리킨다. 하나를 뺀다";
        ModalError::MadeMode { mode, frequency_hz, damping_ratio, nyquist_hz } => "만든 기록의 모드 {mode}은(는) 진동수 {frequency_hz} Hz, 감쇠비 {damping_ratio}인데, 0~{nyquist_hz} Hz와 0~1 사이이고 채널마다 유한한 모드형상 값이 하나씩 있어야 한다";
        ModalError::Compared { what, given } => "비교할 모드의 {what}이(가) {given}인데 양의 유한한 수이어야 한다. 계측 조사의 값을 고친다", what = phrase(what);
        ModalError::DecayTooShort { samples, least } => "감쇠 기록의 자료가 {samples}개인데 {least}개가 필요하다. 더 높은 주파수로 기록하거나 진동이 없어질 때까지 기록한다";
        ModalError::NoDecay { order, samples } => "기록에 모드처럼 감쇠하는 진동이 없다(자료 {samples}개의 차수 {order} 모델). 마지막 힘이 끝난 뒤부터 시작하도록 자르거나 더 세게 친다";
        ModalError::SeveralBlows { times_s } => "첫 자료에서 {times} s에 진동이 갑자기 커진다. 타격이거나 놓은 순간이다. 자유감쇠에는 없어야 하므로, 각 타격 뒤에 시작해 다음 타격 전에 끝나는 부분으로 기록을 나눈다", times = listed_s(times_s);
        ModalError::ClippedDecay { channel, until_s, whole_from_s } => "채널 \"{channel}\"이(가) 첫 자료에서 {until_s:.3} s까지 포화되어 있다. 포화된 감쇠는 모양이 달라진다. 그 채널을 빼거나 {whole_from_s:.3} s부터 시작한다";
        ModalError::FewSwings { extrema, needed } => "감쇠 기록에 뚜렷한 극값이 {extrema}개인데 값 하나에 {needed}개가 필요하다. 더 세게 치거나, extrema를 낮추거나, 잡음을 줄인다";
        ModalError::Setups { given } => "측정 배치가 {given}개인데 합치려면 2개 이상이어야 한다";
        ModalError::NoReference { setup } => "측정 배치 {setup}에 앞의 배치와 공통인 센서가 없다. 하나 이상(되도록 셋)은 같은 자리에 있어야 한다(이름이 같거나 위치와 방향이 같은 센서)";
        ModalError::NoCommonReference { setups } => "측정 배치 {setups}개 모두에 있는 센서가 없다. 하나로 분석하려면 처음부터 끝까지 그대로인 센서가 하나(되도록 셋) 필요하다";
        ModalError::SetupRate { setup, given_hz, first_hz } => "측정 배치 {setup}의 자료는 초당 {given_hz}개, 첫 배치는 {first_hz}개이다. 하나로 분석하려면 주파수가 같아야 한다";
        ModalError::Inputs { method, inputs, channels } => "방법이 {method}이고 채널 {channels}개 중 입력이 {inputs}개이다. 입력은 okid에만 쓰며, okid에는 입력 채널과 입력이 아닌 채널이 하나 이상씩 필요하다";
        ModalError::InputsAlike { share } => "입력 채널이 하나처럼 움직인다. 함께하지 않는 운동이 {share}뿐이어서 각각의 영향을 구별할 수 없다. 입력을 하나만 남긴다", share = format!("{share:.3}");
        ModalError::InputsSine { frequency_hz, share } => "모든 입력의 파워 중 {share} %가 한 진동수 {frequency} Hz에 있다. 정현파는 그 진동수의 응답만 보여 주며 모드를 보여 주지 않는다. 가진기의 진동수를 모드 범위에서 천천히 바꾸거나 불규칙하게 가진한다. 또는 inputs를 삭제하고 가진기가 멈춘 시간을 쓴다", share = format!("{:.1}", 100.0 * share), frequency = format!("{frequency_hz:.3}");
        ModalError::InputsUnrelated { share } => "어느 모드에서도 입력을 따르는 운동이 {share} % 이하로, 우연보다 크지 않다. 입력 채널이 연결되어 있고 같은 기록, 같은 시계의 것인지 확인한다. 입력이 없으면 inputs를 삭제하며, 그때의 모드는 구조물과 지반이 함께 움직이는 모드이다", share = format!("{:.0}", 100.0 * share);
        ModalError::NoObserver => "채널이 입력을 따르는 방식이 구조물이 지반을 따르는 방식이 아니다. 구조물이 움직여서만 입력이 움직이거나, 입력을 그대로 옮긴 채널이 있을 수 있다";
    }
    handed on ModalError::Numeric(why) => why;
    handed on ModalError::Record(why) => why;
    handed on ModalError::Linalg(why) => why;
    handed on ModalError::Channel(why) => why;
}

fn listed_hz(frequencies_hz: &[f64]) -> String {
    let all: Vec<String> = frequencies_hz.iter().map(|hz| format!("{hz:.3}")).collect();
    all.join(", ")
}

fn listed_s(times_s: &[f64]) -> String {
    let all: Vec<String> = times_s.iter().map(|time_s| format!("{time_s:.2}")).collect();
    all.join(", ")
}
