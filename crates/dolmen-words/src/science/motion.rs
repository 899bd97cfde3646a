//! Errors of dynamics and dampers, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;

korean_of! {
    DamperError {
        DamperError::MassRatio { given, most } => "mass_ratio가 {given}인데 0보다 크고 {most} 이하이어야 한다. 감쇠기 질량을 동조 모드의 모드질량(감쇠기 위치의 모드형상을 1로 한 값)으로 나눈 값이다";
        DamperError::Argument { argument, given, allowed } => "{argument}이(가) {given}인데 {allowed}이어야 한다", argument = phrase(argument), allowed = phrase(allowed);
        DamperError::Row { damper, given, needed } => "감쇠기 {damper}: 행의 값이 {given}개인데 유한한 수 {needed}개이어야 한다";
        DamperError::NoSite { damper } => "감쇠기 {damper}이(가) 위치 목록에 없는 바닥에 이어져 있다. 목록에 넣는다";
        DamperError::Unmoved { damper } => "감쇠기 {damper}: 행의 값이 모두 0이어서 움직이지 않는다";
        DamperError::OutsideFloor { x_m, y_m, beyond_m } => "x = {x_m} m, y = {y_m} m의 감쇠기가 바닥에서 {beyond_m:.3} m 벗어나 있다. 외곽선 안으로 옮긴다";
        DamperError::ModeStill { mode, x_m, y_m, direction_degrees, only } => "모드 {mode}이(가) x = {x_m} m, y = {y_m} m의 감쇠기를 {direction_degrees}° 방향으로 움직이지 않는다: {only}. 감쇠기를 돌리거나 옮기거나 다른 모드에 동조시킨다", only = phrase(only);
        DamperError::NoPoints => "점이 없다. 움직임을 줄일 곳을 하나 이상 지정한다";
        DamperError::Still { point } => "점 {point}은(는) 하중에 움직이지 않는다. 빼거나 그 점에 하중이 작용하게 한다";
        DamperError::TooManyFrequencies { intervals } => "진동수 적분에 구간이 {intervals}개보다 많이 필요하다. relative_tolerance를 키우거나 모드의 감쇠를 키운다";
        DamperError::NoMap => "위치의 지도는 표준편차로 그린다. 목표를 최댓값이나 제곱평균으로 한다";
        DamperError::NoOptimum { what, iterations } => "{what}의 최적값을 {iterations}번 안에 찾지 못했다. 다른 동조값에서 시작한다", what = phrase(what);
    }
    handed on DamperError::Dynamics(why) => why;
    handed on DamperError::Wind(why) => why;
    handed on DamperError::Linalg(why) => why;
}

korean_of! {
    DynamicsError {
        DynamicsError::Argument { argument, given, allowed } => "{argument}이(가) {given}인데 {allowed}이어야 한다", argument = phrase(argument), allowed = phrase(allowed);
        DynamicsError::Storey { storey, argument, given, allowed } => "{storey}층: {argument}이(가) {given}인데 {allowed}이어야 한다", argument = phrase(argument), allowed = phrase(allowed);
        DynamicsError::Count { argument, given, needed } => "{argument}의 항목이 {given}개인데 골조의 층은 {needed}개이다. 층마다 하나를 준다", argument = phrase(argument);
        DynamicsError::NoState { at_s, tried } => "{at_s} s에서 {tried}번 시도해도 고착과 미끄러짐의 상태를 찾지 못했다. 한 층의 마찰이 다른 층보다 너무 작거나 골조의 값들이 서로 너무 다르다";
        DynamicsError::NotConverged { step_s, change, most } => "시간 간격을 {step_s} s로 줄여도 최대 층간변위가 {change}만큼 바뀐다. 허용은 {most}이다. output_step_s를 줄이거나 마찰이 거의 0인 층이 있는지 확인한다";
        DynamicsError::TenonsRubBothWays { directions } => "접합부가 두 방향에서 함께 마찰할 때는 유격이 있는 장부를 둘 수 없는데 두 방향 중 {directions}개에 있다. 한 방향씩 흔들거나 한쪽의 장부 또는 마찰을 뺀다";
        DynamicsError::TooManyEvents { at_s, events } => "{at_s} s에서 1e-9 s 안에 고착과 미끄러짐이 {events}번 바뀌었다. 거의 0인 마찰력이 있는지 확인한다";
        DynamicsError::NoSwing { displacement_m } => "골조를 {displacement_m} m에서 놓을 수 없다. 모든 마찰면이 고착되어도 지금 상태로 쓰러진다. 먼저 강성을 입력한다";
        DynamicsError::SwingFalls { displacement_m, storey, at_s } => "{displacement_m} m에서 놓으면 {at_s} s에 골조의 {storey}층이 작은 층간변위 이론의 범위를 넘어 기운다. 더 작은 변위로 하거나 마찰면이 미끄러지는 동안 서 있는지 확인한다";
        DynamicsError::ChainPart { part, number, argument, given, allowed } => "{part} {number}: {argument}이(가) {given}인데 {allowed}이어야 한다", part = phrase(part), argument = phrase(argument), allowed = phrase(allowed);
        DynamicsError::ChainCount { argument, given, needed } => "{argument}의 항목이 {given}개인데 체인의 부재는 {needed}개이다. 부재마다 하나를 준다", argument = phrase(argument);
        DynamicsError::NoBedWidth { joint } => "접합면 {joint}이(가) 가장자리에서 벌어지는데 부재 {joint}에 bed_width_m이 없다. 입력하거나 접합면을 고정한다";
        DynamicsError::NoJointState { at_s, tried } => "{at_s} s에서 {tried}번 시도해도 접합면의 고착과 회전 상태를 찾지 못했다. 한 접합면의 마찰이 다른 것보다 너무 작거나 체인의 값들이 서로 너무 다르다";
        DynamicsError::StepTooShort { at_s, step_s } => "체인의 운동이 {at_s} s에서 더 나아가지 못한다. 남은 시간 간격이 {step_s} s이다. 다른 것보다 자릿수가 여럿 큰 감쇠나 스프링이 있는지 확인한다";
        DynamicsError::Matrix { matrix, needed } => "{matrix} 행렬은 {needed}이어야 한다", needed = phrase(needed), matrix = phrase(matrix);
        DynamicsError::Entries { argument, given, needed } => "{argument}의 항목이 {given}개인데 {needed}개가 필요하다", argument = phrase(argument);
        DynamicsError::Unbounded { quantity, why } => "{quantity}의 표준편차가 없다: {why}", why = phrase(why), quantity = phrase(quantity);
        DynamicsError::NotRational => "표로 준 스펙트럼은 여과된 백색잡음이 아니다. 진동수 적분을 쓴다";
        DynamicsError::Unstable => "운동이 정상상태에 이르지 않는다. 감쇠가 없는 모드가 있다. 모드마다 감쇠를 준다";
        DynamicsError::Integral { intervals } => "진동수 적분에 구간이 {intervals}개보다 많이 필요하다. relative_tolerance나 intervals_most를 키우거나 모드의 감쇠를 키운다";
    }
    handed on DynamicsError::Building(why) => why;
    handed on DynamicsError::Columns(why) => why;
    handed on DynamicsError::Structure(why) => why;
    handed on DynamicsError::Wind(why) => why;
    handed on DynamicsError::Linalg(why) => why;
}
