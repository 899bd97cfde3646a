//! Errors of records and motions, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::signal::SignalError;

korean_of! {
    SignalError {
        SignalError::Empty { channels, samples } => "기록의 채널이 {channels}개, 자료가 {samples}개인데 채널 1개, 자료 2개 이상이어야 한다";
        SignalError::Ragged { channel, samples, first } => "채널 \"{channel}\"의 자료는 {samples}개인데 첫 채널은 {first}개이다. 한 기록의 채널은 모두 같은 시각에 잰 것이어야 한다";
        SignalError::SamplingRate { given } => "sampling_rate_hz가 {given}인데 양수이어야 한다";
        SignalError::NotFinite { channel, sample, time_s, value } => "채널 \"{channel}\"의 {sample}번 자료(t = {time_s} s)가 {value}이다. 그 앞이나 뒤에서 기록을 자르거나 그 채널을 뺀다";
        SignalError::TooLarge { channel, sample, time_s, value, most } => "채널 \"{channel}\"의 {sample}번 자료(t = {time_s} s)가 {value}인데 {most}을(를) 넘는 자료는 쓸 수 없다. 기록계의 범위 초과 표시인가? 잘라 내거나 그 채널을 뺀다";
        SignalError::ChannelCount { channels, series } => "채널 설명은 {channels}개인데 자료는 {series}열이다. 자료마다 설명 하나를 준다";
        SignalError::SameName { name, first, second } => "채널 {first}와(과) {second}(1부터)의 이름이 모두 \"{name}\"이다. 서로 다른 이름을 붙인다";
        SignalError::UnknownChannel { given, names } => "채널 \"{given}\"이(가) 없다. 기록의 채널: {names}", names = names.join(", ");
        SignalError::NothingLeft { channels } => "채널 {channels}개를 모두 빼게 되어 있는데 하나는 남아야 한다";
        SignalError::NoStart { channel } => "채널 \"{channel}\"의 시작 시각이 없다";
        SignalError::NoCommonTime { ends, begins, apart_s } => "채널 \"{ends}\"이(가) 채널 \"{begins}\"의 시작보다 {apart_s:.3} s 먼저 끝난다(필터에 필요한 끝부분 포함). 공통된 시간이 없다. 시계가 맞는가?";
        SignalError::Cut { from_s, to_s, least_s, duration_s } => "{from_s} s에서 {to_s} s까지 자를 수 없다. 앞에서 뒤로 자료 2개({least_s} s) 이상, 기록 범위 0~{duration_s} s 안이어야 한다";
        SignalError::Corner { argument, given, nyquist_hz } => "{argument}이(가) {given} Hz인데 0보다 크고 나이퀴스트 진동수 {nyquist_hz} Hz(샘플링 주파수의 절반)보다 작아야 한다. 낮추거나 필터를 뺀다", argument = phrase(argument);
        SignalError::Band { low_hz, high_hz } => "low_hz는 {low_hz} Hz, high_hz는 {high_hz} Hz인데 low_hz가 더 작아야 한다. 서로 바꾼다";
        SignalError::FilterOrder { given, most } => "order가 {given}인데 1~{most}이어야 한다. 보통 4를 쓴다";
        SignalError::TooShortForFilter { filter, duration_s, ringing_s } => "기록이 {duration_s} s인데 {filter} 필터의 영향이 양 끝에서 {ringing_s:.3} s까지 남는다. 더 긴 기록을 쓰거나 모서리 진동수를 0 Hz에서 멀리 잡는다", filter = phrase(filter);
        SignalError::Factor { given, most, length } => "솎음 배수가 {given}인데 2~{most}이어야 한다(자료 {length}개에서 2개 이상 남아야 한다). 솎지 않거나 배수를 낮춘다";
        SignalError::SegmentLength { given, least, most } => "segment_length가 {given}인데 {least}~{most}개(기록의 길이)이어야 한다";
        SignalError::TimeStep { given, least, most } => "time_step_s가 {given}인데 {least}~{most}이어야 한다. 초 단위인가?";
        SignalError::NoCommonStep { first_s, second_s, most } => "두 지반운동의 시간 간격이 {first_s} s와 {second_s} s인데 둘을 {most}등분 이하로 나누는 공통 간격이 없다. 하나를 {first_s} s 간격 등으로 다시 샘플링한다";
        SignalError::Argument { argument, given, allowed } => "{argument}이(가) {given}인데 {allowed}이어야 한다", argument = phrase(argument), allowed = phrase(allowed);
        SignalError::NoMotion { component, peak_m_s2 } => "{component} 성분의 최대값이 {peak_m_s2} m/s²이어서 배율로 키울 수 없다. 움직이는 성분을 지정한다", component = phrase(component);
        SignalError::Period { given, least_s, most_s } => "주기 {given} s는 쓸 수 없다. 이 시간 간격의 지반운동으로는 {least_s}~{most_s} s까지 알 수 있다";
        SignalError::SuiteAlike { wanted, usable, most } => "기록 {usable}개에서 지반운동 {wanted}개를 고를 수 없다. 한 지진, 관측소, 기록에서 고를 수 있는 수를 지키면 {most}개뿐이다. 기록을 더 주거나 수를 줄인다";
        SignalError::SuiteFactors { wanted, usable, least, most } => "기록 {usable}개에서 지반운동 {wanted}개를 고를 수 없다. 어느 조합이든 {least}~{most} 범위를 벗어나는 배율이 있다. 더 강하거나 약한 기록을 주거나 배율의 범위를 넓힌다";
        SignalError::Match { why } => "기선이나 웨이블릿을 찾을 수 없다: {why}. 더 긴 지반운동을 쓴다";
    }
    handed on SignalError::Numeric(why) => why;
}
