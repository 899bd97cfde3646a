//! What is wrong with a channel, in Korean.

use crate::errors::korean_of;
use dolmen::signal::ChannelFault;

korean_of! {
    ChannelFault {
        ChannelFault::Constant { channel, value } => "채널 \"{channel}\"에 신호가 없다. 모든 자료가 {value}이다. 제외하고 케이블을 점검한다";
        ChannelFault::Faint { channel, deviation, typical } => "채널 \"{channel}\"에 신호가 없거나 단위가 다르다. 표준편차가 {deviation:.3e}인데 같은 종류 채널의 중앙값은 {typical:.3e}이다. 제외하거나 단위를 바로잡는다";
        ChannelFault::Stuck { channel, value, from_s, to_s } => "채널 \"{channel}\"의 값이 {from_s:.2} s부터 {to_s:.2} s까지 {value}에 멈춰 있다. 케이블 이탈이나 기록 중단이므로 그 구간을 자르거나 채널을 제외한다";
        ChannelFault::Faded { channel, factor, from_s, to_s } => "채널 \"{channel}\"의 세기가 다른 채널에 대해 기록 중 {factor:.0}배 변한다({from_s:.0} s부터 {to_s:.0} s까지 최소). 접촉 불량이므로 그 구간을 자르거나 채널을 제외한다";
        ChannelFault::Loose { channel, factor, share, times, first_s } => "채널 \"{channel}\"의 빠른 성분이 {factor:.1}배 커졌다가 되돌아가기를 {times}회 반복한다(기록의 {share:.0} %, 첫 시각 {first_s:.0} s). 다른 채널에는 그런 변화가 없다. 센서 고정이나 케이블 접촉이 불량하므로 점검한다", share = 100.0 * share;
        ChannelFault::Alike { channel, other, correlation } => "채널 \"{channel}\"와(과) \"{other}\"의 신호가 거의 같다(증분의 상관계수 {correlation:.6}). 한 케이블이 두 입력에 연결되었거나 두 센서가 같은 위치에 있다";
        ChannelFault::Drifts { channel, rise } => "채널 \"{channel}\"의 표류가 기록 전체에서 운동의 {rise:.0}배이다. 그대로 두면 낮은 모드와 감쇠비가 틀리므로 먼저 직선 추세를 제거한다";
        ChannelFault::Spikes { channel, count, first_s } => "채널 \"{channel}\"에 주변보다 25배 이상 튀는 자료가 {count}개 있다(첫 위치 {first_s:.2} s). 잡음이 되어 감쇠비가 틀리므로 케이블을 점검한다";
        ChannelFault::Clipped { channel, value, samples, first_s } => "채널 \"{channel}\"이(가) 포화되었다. 자료 {samples}개가 정확히 {value}에 머물며 처음은 {first_s:.2} s이다. 범위 안의 구간만 쓰거나 채널을 제외한다";
        ChannelFault::Duplicated { channel, other, factor } => "채널 \"{channel}\"와(과) \"{other}\"의 신호가 같다(배율 {factor:.6}). 한 케이블이 두 입력에 연결되었거나 같은 열이 중복되었으므로 하나를 제외한다";
    }
}
