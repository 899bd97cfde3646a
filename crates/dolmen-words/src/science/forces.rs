//! Errors of stability and of blocks in motion, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::blocks::BlocksError;
use dolmen::stability::StabilityError;

korean_of! {
    StabilityError {
        StabilityError::Option { option, given, allowed } => "{option}이(가) {given}인데 {allowed}이어야 한다", option = phrase(option), allowed = phrase(allowed);
        StabilityError::VerticalAcceleration { given, gravity_m_s2 } => "vertical_acceleration_m_s2가 {given}인데 −{gravity_m_s2}보다 커야 한다. 그 이하이면 무게가 없어 접합면이 아무것도 전달하지 못한다";
        StabilityError::Direction { quantity, given } => "{quantity}이(가) {given:?}인데 유한한 수 두 개이고 모두 0이 아니어야 한다", quantity = phrase(quantity);
        StabilityError::Block { quantity, given, count } => "{quantity}에 블록 {given}이(가) 있는데 블록은 0부터 {count}개이다", quantity = phrase(quantity);
        StabilityError::Pressure { residual, iterations } => "접합면의 압력을 {iterations}번 반복해도 {residual:e}보다 정확히 구하지 못했다";
        StabilityError::ConicProgramme { reason } => "한계해석의 원추계획 문제를 풀지 못했다: {reason}";
        StabilityError::Indeterminate => "접합면의 힘이 평형만으로 정해지지 않는다. 블록 하나가 여러 접합면 위에 있거나 다른 블록 옆에 있다. 블록마다 하나 위에 놓인 구조를 준다";
    }
    handed on StabilityError::Structure(why) => why;
    handed on StabilityError::Linalg(why) => why;
    handed on StabilityError::Numeric(why) => why;
}

korean_of! {
    BlocksError {
        BlocksError::Option { option, given, allowed } => "{option}이(가) {given}인데 {allowed}이어야 한다", option = phrase(option), allowed = phrase(allowed);
        BlocksError::StepTooLarge { given, most } => "time_step_s가 {given:.3e}인데 가장 강한 접합면에서는 {most:.3e} 이하이어야 한다. 낮추거나, 삭제하거나, 접합면의 강성을 낮춘다";
        BlocksError::NoRest { iterations, residual, block } => "자중에서 평형을 찾지 못했다. {iterations}번 반복한 뒤에도 무게의 {residual:.2e}배인 힘이 남아 있으며 '{block}'에서 가장 크다";
        BlocksError::Topples { factor, block } => "정지 상태에서 자중과 정하중으로 스프링 위에서 전도된다. '{block}'이(가) 가장 많이 움직인다. 모든 접합면의 normal_stiffness와 shear_stiffness가 지금의 {factor:.3}배 이상이어야 한다. 키우거나 계측 진동수로 보정한다";
        BlocksError::TopplesOnSoil { factor, block } => "정지 상태에서 자중과 정하중으로 지반 위에서 전도된다. '{block}'이(가) 가장 많이 움직인다. 지반과 접합면의 강성이 함께 지금의 {factor:.3}배 이상이어야 한다. 지반의 전단탄성계수와 하중과 그 높이를 확인한다";
        BlocksError::NotAPile { block, reason } => "'{block}'은(는) 미끄러짐 모델로 해석할 수 없다: {reason}. 스프링 접촉 모델이나 강체 접촉 모델을 쓴다", reason = phrase(reason);
        BlocksError::NoSliding { at_s } => "미끄러짐 모델이 {at_s} s에서 가속도를 찾지 못했다. 블록의 질량이나 마찰계수가 서로 너무 다르다. 강체 접촉 모델을 쓴다";
        BlocksError::SpringsOnly { what, quantity, given } => "{what}의 {quantity}이(가) {given:.4e}인데, 압축과 마찰과 벌어짐만 있는 강체 접촉 모델에서는 0이어야 한다. 0으로 하거나 삭제하거나 스프링 접촉 모델로 해석한다", quantity = phrase(quantity);
        BlocksError::TooLong { what, count, most } => "해석에 {what} {count:.3e}이(가) 필요한데 따로 요청하지 않으면 {most:.0e}까지만 계산한다", what = phrase(what);
    }
    handed on BlocksError::Stack(why) => why;
    handed on BlocksError::Linalg(why) => why;
}
