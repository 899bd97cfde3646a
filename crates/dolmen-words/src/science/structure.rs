//! Errors of chains, frames and buildings, and of wind, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::structure::StructureError;
use dolmen::structure::building::{BuildingError, PlanStiffnessError};
use dolmen::structure::wind::WindError;

korean_of! {
    StructureError {
        StructureError::Empty { kind, parts } => "{kind}에 {parts}이(가) 하나 이상 있어야 한다", kind = phrase(kind), parts = phrase(parts);
        StructureError::NotPositive { part, number, quantity, given } => "{part} {number}: {quantity}이(가) {given}인데 양수이어야 한다", part = phrase(part), quantity = phrase(quantity);
        StructureError::Centroid { link, centroid_m, length_m } => "부재 {link}: centroid_m이 {centroid_m}인데 0과 부재 길이 length_m {length_m} 사이이어야 한다";
        StructureError::Count { quantity, given, kind, needed, parts } => "{quantity}에 값이 {given}개인데 {kind}의 {parts}은(는) {needed}개이다", kind = phrase(kind), parts = phrase(parts), quantity = phrase(quantity);
        StructureError::Gravity { given } => "gravity_m_s2가 {given}인데 양수이어야 한다(지구에서 9.81)";
        StructureError::Negative { part, number, quantity, given } => "{part} {number}: {quantity}이(가) {given}인데 0 이상이어야 한다", part = phrase(part), quantity = phrase(quantity);
        StructureError::Part { part, given, most } => "{part} {given}을(를) 지정했는데 아래에서부터 1~{most}번이 있다", part = phrase(part);
        StructureError::Height { quantity, given, top_m } => "{quantity}이(가) {given}인데 구조물 위(0~꼭대기 {top_m:.3} m)이어야 한다", quantity = phrase(quantity);
        StructureError::AxialOrder { storey, given, above } => "{storey}층: 축력이 {given} N으로 위층의 {above} N보다 작다. 한 층은 그 층과 위의 모든 층을 받친다. 층마다의 하중이면 위에서부터 더한다";
        StructureError::Tie { tie, lower, upper, most } => "타이 {tie}이(가) 레벨 {lower}와(과) {upper}을(를) 잇는데, 0(지반)~{most}의 서로 다른 두 레벨을 이어야 한다";
        StructureError::ModesMissing => "계측된 모드가 없는데 강성을 구하려면 하나 이상 필요하다";
        StructureError::ModesMost { given, most, parts } => "계측된 모드가 {given}개인데 {parts}이(가) {most}개인 구조물의 모드는 {most}개뿐이다. 낮은 것부터 {most}개를 준다", parts = phrase(parts);
        StructureError::FrequencyOrder { mode, given, before } => "모드 {mode}: frequency_hz가 {given}으로 앞 모드의 {before}보다 크지 않다. 모드를 낮은 것부터 한 번씩 준다";
        StructureError::Option { option, given, allowed } => "{option}이(가) {given}인데 {allowed}이어야 한다", option = phrase(option), allowed = phrase(allowed);
        StructureError::Mode { mode, quantity, given, allowed } => "모드 {mode}: {quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        StructureError::Frequencies { given, needed } => "frequencies_hz에 값이 {given}개인데 {needed}개 층의 강성은 {needed}개로 정해진다. 더 많을 수 없고, 적으면 해가 연속으로 남는다";
        StructureError::Storeys { given, most } => "골조의 층이 {given}개인데 모든 근은 {most}개 층까지만 찾는다. 모드형상을 입력한다";
        StructureError::Invisible { storey, extension, largest } => "{storey}층이 이 모드형상에서 움직이지 않아({largest} 중 {extension}) 강성을 알 수 없다. 다른 모드를 주거나 둘 이상 준다";
    }
    handed on StructureError::Linalg(why) => why;
}

korean_of! {
    BuildingError {
        BuildingError::Empty => "건물에 층이 하나 이상 있어야 한다";
        BuildingError::Count { storeys, floors } => "층이 {storeys}개, 바닥이 {floors}개이다. 바닥마다 층 하나를 아래에서부터 준다";
        BuildingError::Value { part, number, quantity, given, allowed } => "{part} {number}: {quantity}이(가) {given}인데 {allowed}이어야 한다", part = phrase(part), quantity = phrase(quantity), allowed = phrase(allowed);
        BuildingError::Element { storey, element, quantity, given, allowed } => "{storey}층 부재 {element}: {quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        BuildingError::Asymmetric { storey, row, column, upper, lower } => "{storey}층: 강성행렬의 {row}행 {column}열이 {upper}인데 대각선 건너편은 {lower}이다. 스프링이면 두 값이 같다";
        BuildingError::Sways { storey, direction_degrees, stiffness_n_m } => "{storey}층이 x에서 {direction_degrees:.1}도 방향의 횡변위에 저항하지 못한다. 그 방향의 강성이 {stiffness_n_m} N/m이다. 저항하는 벽체나 기둥을 입력한다";
        BuildingError::Twists { storey, x_m, y_m, stiffness_n_m_rad } => "{storey}층이 비틀림에 저항하지 못한다. 강성중심 ({x_m:.3}, {y_m:.3}) m에 대한 강성이 {stiffness_n_m_rad} N·m/rad이다. 벽체가 모두 그 점을 향하거나 스프링의 행렬이 아니다";
        BuildingError::Falls { storey, motion, load_factor } => "건물이 쓰러진다. {storey}층이 위 무게의 {load_factor:.4}배에서 {motion}(P-델타). 더 강한 벽체, 더 작은 무게 또는 더 낮은 층고가 필요하다", motion = phrase(motion);
        BuildingError::Outline { why } => "외곽선이 올바르지 않다: {why}. 모서리를 순서대로 한 번씩 준다", why = phrase(why);
        BuildingError::Outside { floor, x_m, y_m, beyond_m } => "점 ({x_m}, {y_m}) m이 바닥 {floor}의 외곽선에서 {beyond_m:.3} m 벗어나 있다. 바닥 위의 점을 준다";
        BuildingError::Part { part, given, most } => "{part} {given}을(를) 지정했는데 1~{most}번이 있다", part = phrase(part);
        BuildingError::Argument { argument, given, allowed } => "{argument}이(가) {given}인데 {allowed}이어야 한다", argument = phrase(argument), allowed = phrase(allowed);
        BuildingError::Damping { mode, frequency_hz, damping_ratio, why } => "{frequency_hz:.4} Hz인 모드 {mode}의 감쇠비가 {damping_ratio:.5}이(가) 된다: {why}", why = phrase(why);
    }
    handed on BuildingError::Linalg(why) => why;
}

korean_of! {
    PlanStiffnessError {
        PlanStiffnessError::Argument { quantity, given, allowed } => "{quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        PlanStiffnessError::Modes { given } => "계측된 모드가 {given}개인데 한 바닥의 모드는 x 방향, y 방향, 비틀림의 3개이다";
        PlanStiffnessError::Twice { motion } => "같은 운동({motion:?})의 모드가 둘 계측되었는데 한 바닥에는 하나씩이다";
        PlanStiffnessError::Repeated { frequency_hz } => "{frequency_hz} Hz가 두 번 계측되었다. 횡변위와 비틀림이 연성되면 같은 진동수에서 모드형상이 정해지지 않는다";
    }
    handed on PlanStiffnessError::Structure(why) => why;
    handed on PlanStiffnessError::Linalg(why) => why;
}

korean_of! {
    WindError {
        WindError::NotPositive { quantity, given } => "{quantity}이(가) {given}인데 양수이어야 한다", quantity = phrase(quantity);
        WindError::Height { given, most_m } => "꼭대기가 {given} m인데 기준의 풍속 분포는 {most_m} m까지이다";
        WindError::FrequencyUnknown => "기준에 필요한 최저 고유진동수를 알 수 없다. 접합부 강성이 없다";
        WindError::DampingUnknown { frequency_hz } => "최저 고유진동수가 {frequency_hz:.3} Hz이어서 공진을 고려해야 하는데 감쇠비가 없다";
        WindError::NotAMean => "돌풍이나 압력으로 주어졌는데 난류는 기준에 따른 10분 평균 풍속에 대한 값이다";
    }
}
