//! Errors of assessments, surveys and validation, in Korean.

use super::fragility::no_fragility;
use super::phrase::phrase;
use crate::errors::korean_of;
use crate::number::trimmed;
use dolmen::assess::AssessError;
use dolmen::comparisons::ValidationError;
use dolmen::monitoring::MonitoringError;

korean_of! {
    AssessError {
        AssessError::NothingToCompare { survey } => "{survey} 조사에 모드가 없어 비교할 것이 없다";
        AssessError::TemperatureFit { surveys, least, spread_c, spread_least_c } => "온도가 있는 조사가 {surveys}개이고 온도 차가 {spread_c} °C인데, 계수를 구하려면 {least}개와 {spread_least_c} °C가 필요하다. 다른 계절에 계측하거나 계수를 입력한다";
        AssessError::Factor { factor, given, allowed } => "{factor}이(가) {given}인데 {allowed}이어야 한다", factor = phrase(factor), given = trimmed(*given, 4), allowed = phrase(allowed);
        AssessError::OutsideTraining { factor, given, least, most } => "{factor}이(가) {given}인데 점수는 {least}~{most}에서 학습되었다. 이 석탑을 해석하거나, 범위 밖의 값임을 표시하는 외삽을 허용한다", factor = phrase(factor), given = trimmed(*given, 4), least = trimmed(*least, 4), most = trimmed(*most, 4);
        AssessError::NothingToRank { candidates, draws } => "구조물이 {candidates}개, 추출이 {draws}번인데 순위를 매기려면 구조물 1개, 추출 20번 이상이어야 한다";
        AssessError::TooFewDesigns { given, least } => "설계가 {given}개인데 점수에는 {least}개 이상이 필요하다. 더 해석한다";
        AssessError::SiteSpecific => "지반분류 S6은 부지 고유의 지반이라 기준에 계수가 없다. 부지를 조사해 그 스펙트럼을 표로 입력한다";
        AssessError::ReturnPeriod { given } => "return_period_years가 {given}인데 기준에는 50, 100, 200, 500, 1000, 2400, 4800년이 있다. 그다음으로 긴 것을 쓰고, 2475년이면 2400을 쓴다";
        AssessError::SpectrumTable { row } => "스펙트럼의 {row}행이 없거나 쓸 수 없다. period_s(커지는 순서)와 음이 아닌 acceleration_m_s2를 두 행 이상 준다";
        AssessError::OutsideTable { period_s, least_s, most_s } => "주기 {period} s가 표의 범위 {least_s}~{most_s} s를 벗어난다. 표를 넓힌다", period = (period_s * 1e4).round() / 1e4;
        AssessError::TableDamping { given, of_table } => "damping_ratio가 {given}인데 표는 {of_table}의 값이다. 그 감쇠비의 표를 준다";
        AssessError::Scale { given } => "scale이 {given}인데 양수이어야 한다";
        AssessError::Trend { given } => "추세의 값이 {given}이다. 결과가 없는 해석을 뺀다";
        AssessError::FragilityParameter { parameter, given } => "취약도 곡선의 {parameter}이(가) {given}인데 양수이어야 한다", parameter = phrase(parameter);
        AssessError::Observation { number, given, allowed } => "관측 {number}의 값이 {given}인데 {allowed}이어야 한다", allowed = phrase(allowed);
        AssessError::TooFewForSufficiency { given, least } => "지반운동 척도의 충분성을 판단하기에는 지반운동 {given}개가 너무 적다. {least}개 이상을 준다";
        AssessError::CapacitiesOpen { without, scans } => "증분해석 {scans}건 중 {without}건은 손상상태가 시작된 크기의 위아래를 알 수 없으며, 이는 가장 강하거나 약한 경우이다. 더 작거나 큰 지반운동까지 해석한다";
        AssessError::SameForEveryMotion { value } => "모든 지반운동에서 값이 {value}(으)로 같아 그에 따른 변화를 알 수 없다. 서로 다른 지진의 지반운동을 준다";
        AssessError::TooFewMotions { given } => "취약도 곡선에는 지반운동 {given}개가 너무 적다. 3개 이상, 순위를 매기려면 22개 이상을 준다";
        AssessError::NoFragility(bound) => "{why}", why = no_fragility(bound);
        AssessError::FragilityFalls => "지반운동이 세져도 손상상태에 더 자주 이르지 않아 관측값을 지나며 커지는 취약도 곡선이 없다. 세기 지표가 맞는가?";
        AssessError::Hazard { what, given, allowed } => "재해도의 {what}이(가) {given}인데 {allowed}이어야 한다", what = phrase(what), allowed = phrase(allowed);
    }
    handed on AssessError::Structure(why) => why;
    handed on AssessError::Stability(why) => why;
    handed on AssessError::Stack(why) => why;
    handed on AssessError::Numeric(why) => why;
    handed on AssessError::Modal(why) => why;
    handed on AssessError::Linalg(why) => why;
}

korean_of! {
    MonitoringError {
        MonitoringError::Option { option, given, allowed } => "{option}이(가) {given}인데 {allowed}이어야 한다", option = phrase(option), allowed = phrase(allowed);
        MonitoringError::Order { survey, day } => "{survey} 조사의 날짜({day}일)가 앞 조사보다 뒤가 아니다. 조사마다 다른 날짜를 순서대로 준다";
        MonitoringError::TooFewSurveys { given, least } => "조사가 {given}회이다. 변화 이력을 분석하려면 {least}회 이상 있어야 한다. 조사가 2회이면 두 조사를 비교한다";
    }
    handed on MonitoringError::Numeric(why) => why;
    handed on MonitoringError::Modal(why) => why;
}

korean_of! {
    ValidationError {
    }
    handed on ValidationError::Structure(why) => why;
    handed on ValidationError::Stack(why) => why;
    handed on ValidationError::Slice(why) => why;
    handed on ValidationError::Building(why) => why;
    handed on ValidationError::Plan(why) => why;
    handed on ValidationError::Stability(why) => why;
    handed on ValidationError::Wind(why) => why;
    handed on ValidationError::Blocks(why) => why;
    handed on ValidationError::Dynamics(why) => why;
    handed on ValidationError::Signal(why) => why;
    handed on ValidationError::Modal(why) => why;
    handed on ValidationError::Monitoring(why) => why;
    handed on ValidationError::Damper(why) => why;
    handed on ValidationError::Assess(why) => why;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Language, Sentence};

    #[test]
    fn exact_numbers_of_a_refused_factor_have_four_digits_and_its_name_is_korean() {
        let why = AssessError::OutsideTraining {
            factor: "slenderness_angle",
            given: 4.1894499314465445,
            least: 0.20416212657654595,
            most: 0.45686259777113364,
        };
        let said = Sentence::of_argument(&why).text(Language::Korean);
        assert!(
            said.starts_with("세장각이 4.189인데 점수는 0.2042~0.4569에서 학습되었다."),
            "{said}"
        );
    }
}
