//! Why a fragility curve cannot be fitted, in Korean; the error has its own English text.

use dolmen::assess::FragilityBound;

/// The sentence.
pub(super) fn no_fragility(bound: &FragilityBound) -> String {
    match bound {
        FragilityBound::NoneReached {
            intensity,
            motions,
            probability_most,
        } => format!(
            "지반운동 {motions}개 중 손상상태에 이른 것이 없어 곡선을 구할 수 없다. 세기 {intensity:.4}에서의 확률은 95 % 신뢰도로 {probability_most:.3} 이하이다. 더 강한 지반운동으로 해석한다"
        ),
        FragilityBound::AllReached {
            intensity,
            motions,
            probability_least,
        } => format!(
            "지반운동 {motions}개가 모두 손상상태에 이르러 곡선을 구할 수 없다. 세기 {intensity:.4}에서의 확률은 95 % 신뢰도로 {probability_least:.3} 이상이다. 더 약한 지반운동으로 해석한다"
        ),
        FragilityBound::Separated { survived, reached } if survived == reached => format!(
            "모든 지반운동이 같은 세기 {reached:.4}에서 손상상태에 이른다. 흩어짐이 간격보다 작아 곡선을 구할 수 없다. 지반운동을 늘리거나 간격을 줄인다"
        ),
        FragilityBound::Separated { survived, reached } => format!(
            "세기 {survived:.4}까지는 하나도, {reached:.4}부터는 모두 손상상태에 이른다. 흩어짐이 간격보다 작아 곡선을 구할 수 없다. 그 사이의 간격을 줄인다"
        ),
        FragilityBound::Middle { above, at_most } => {
            let known = match (*above > 0.0, at_most.is_finite()) {
                (true, true) => {
                    format!("내력의 절반이 {above:.4}와 {at_most:.4} 사이에 있다는 것만 알 수 있어")
                }
                (true, false) => format!("내력의 절반이 {above:.4}보다 크다는 것만 알 수 있어"),
                (false, true) => format!("내력의 절반이 {at_most:.4} 이하라는 것만 알 수 있어"),
                (false, false) => "내력의 중앙값을 알 수 없어".to_owned(),
            };
            format!("{known} 곡선을 구할 수 없다. 세기나 지반운동을 늘린다")
        }
    }
}
