//! What the science says of stacks and motions beside its numbers, in the words of the page: its own sentence in English, one
//! of the same numbers in Korean.

use crate::figures::above_words;
use dolmen::assess::StackNote;
use dolmen::signal::Processing;
use dolmen::stability::stack::Standing;
use dolmen_words::Language;
use dolmen_words::number::{significant, trimmed};

/// Digits of accelerations and distances.
const DIGITS: usize = 3;

pub(super) fn stack_note_words(note: &StackNote, language: Language) -> String {
    let g = |value: f64| format!("{}\u{202f}g", significant(value, DIGITS));
    let korean = match note {
        StackNote::SharedLoad => {
            "여러 부재가 하중을 나누어 지지하므로 접합면별 값은 상한이며, 한계해석으로 판정한다.".to_owned()
        }
        StackNote::AnalysisLower {
            joints_g: Some(joints_g),
            analysis_g,
        } => format!(
            "한계해석의 결과는 {}로 접합면별 값 {}보다 작다. 여러 부재가 함께 움직이거나 비틀리거나 미끄러지며 벌어진다.",
            g(*analysis_g),
            g(*joints_g)
        ),
        StackNote::AnalysisLower { analysis_g, .. } => {
            format!("한계해석만이 한계를 준다: {}.", g(*analysis_g))
        }
        StackNote::AnalysisBetween {
            at_least_g,
            analysis_g,
        } => format!(
            "한계해석에서 모든 방향으로 {}까지는 평형이 확인되었고 한 방향에서 {}에는 평형이 없다. 낮은 값을 사용해야 한다.",
            g(*at_least_g),
            g(*analysis_g)
        ),
        StackNote::CohesionCounted => {
            "점착력은 모든 접합면에서 동시에 전부 작용하는 것으로 보았으나, 실제 부착은 취성으로 하나씩 파괴되므로 불안전 측이다.".to_owned()
        }
        StackNote::TensionLeftOut => "접합면의 인장강도는 모든 한계값에서 제외하였다(안전 측).".to_owned(),
        StackNote::KineticLess { slides_at_g } => format!(
            "운동마찰이 정지마찰보다 작다. 운동마찰로는 {}에서 미끄러진다.",
            g(*slides_at_g)
        ),
        StackNote::AnalysisFalls => {
            "접합면별로는 서 있는 것으로 보이나, 자중과 정적 하중에 평형을 이루는 접합력이 존재하지 않는다."
                .to_owned()
        }
        StackNote::StrengthNotInAnalysis => {
            "한계해석은 압축강도를 고려하지 않는다. 하중을 나누어 지지하는 부재의 저항 가속도는 상한이다."
                .to_owned()
        }
        StackNote::SideSupportsLeftOut => "측면 지지는 모든 한계값에서 제외하였다(안전 측).".to_owned(),
        StackNote::TiesLeftOut => {
            "연결재는 저항 가속도에 포함하지 않았으며(안전 측), 강도까지 작용할 때의 값을 함께 제시한다.".to_owned()
        }
        StackNote::PeriodUnknown => {
            "1차 주기를 알 수 없어 탄성 접합면에 의한 증폭은 비교에 포함되지 않는다.".to_owned()
        }
    };
    language.pick(format!("{}.", capitalised(&note.to_string())), korean)
}

/// With a capital at its beginning.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first: String = letters
        .next()
        .map(|c| c.to_uppercase().collect())
        .unwrap_or_default();
    first + letters.as_str()
}

/// Whether it stands without shaking; no full stop.
pub(super) fn standing_words(standing: &Standing, language: Language) -> String {
    let name = |above: &str| above_words(above, Language::Korean);
    let short = |value: f64| significant(value, DIGITS);
    let korean = match standing {
        Standing::Stands => "자중과 정적 하중에 대하여 서 있다".to_owned(),
        Standing::Leaves { above, distance_m } => {
            format!(
                "{} 위에서 합력이 접합면을 {distance_m:.2}\u{202f}m 벗어난다",
                name(above)
            )
        }
        Standing::Slides {
            above,
            shear_n,
            resistance_n,
        } => format!(
            "{} 위에서 전단력 {}\u{202f}kN이 마찰과 점착력 {}\u{202f}kN을 넘는다",
            name(above),
            short(shear_n / 1e3),
            short(resistance_n / 1e3)
        ),
        Standing::Lifts { above, pull_n } => format!(
            "{} 위의 접합면을 누르는 힘이 없다(인장력 {}\u{202f}kN)",
            name(above),
            short(pull_n / 1e3)
        ),
        Standing::Crushes { above, distance_m } => format!(
            "{} 위에서 합력이 석재 강도가 허용하는 선을 {distance_m:.3}\u{202f}m 벗어난다",
            name(above)
        ),
        Standing::Overloaded {
            above,
            pressure_pa,
            strength_pa,
        } => format!(
            "{} 위의 평균 압력 {}\u{202f}MPa이 압축강도 {}\u{202f}MPa을 넘는다",
            name(above),
            short(pressure_pa / 1e6),
            short(strength_pa / 1e6)
        ),
        Standing::SoilTurns {
            stiffness_n_m_rad,
            least_n_m_rad,
        } => format!(
            "지반의 회전 강성 {}\u{202f}MN·m/rad이 필요한 값 {}\u{202f}MN·m/rad보다 작다",
            short(stiffness_n_m_rad / 1e6),
            short(least_n_m_rad / 1e6)
        ),
    };
    language.pick(standing.to_string(), korean)
}

/// A step of what was done to a motion or record.
pub(super) fn processing_words(step: &Processing, language: Language) -> String {
    let short = |value: f64| trimmed(value, 6);
    let korean = match step {
        Processing::Read { format, unit } if unit.is_empty() => format!("{format} 파일, 단위 없음"),
        Processing::Read { format, unit } => format!("{format} 파일, 단위 {unit}"),
        Processing::LeftOut { channels } => format!("제외한 채널 {}", channels.join(", ")),
        Processing::Cut { from_s, to_s } => format!("{}–{}\u{202f}s 구간", short(*from_s), short(*to_s)),
        Processing::Detrend { degree: 0 } => "평균 제거".to_owned(),
        Processing::Detrend { degree: 1 } => "선형 추세 제거".to_owned(),
        Processing::Detrend { degree } => format!("{degree}차 다항식 추세 제거"),
        Processing::LowPass { corner_hz, order } => {
            format!(
                "저역 통과 {}\u{202f}Hz, {order}차 버터워스, 영위상",
                short(*corner_hz)
            )
        }
        Processing::BandPass {
            low_hz,
            high_hz,
            order,
        } => format!(
            "대역 통과 {}–{}\u{202f}Hz, {order}차 버터워스, 영위상",
            short(*low_hz),
            short(*high_hz)
        ),
        Processing::Scaled { factor } => format!("{}배", short(*factor)),
        Processing::Tapered { each_end_s } => {
            format!("양 끝 {}\u{202f}s 반코사인 테이퍼", short(*each_end_s))
        }
        Processing::Rotated { angle_rad } => {
            format!("x에서 y로 {}° 회전", short(angle_rad.to_degrees()))
        }
        Processing::Decimate { factor } => format!("1/{factor} 재표본화"),
        // no Korean sentence yet
        Processing::HighPass { .. }
        | Processing::Matched { .. }
        | Processing::ChannelScaled { .. }
        | Processing::Interpolated { .. }
        | Processing::Resampled { .. }
        | Processing::OffsetsLeft { .. }
        | Processing::LongestSpan { .. }
        | Processing::CommonTime { .. } => step.to_string(),
    };
    language.pick(step.to_string(), korean)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two English words one after the other.
    fn english_in(text: &str) -> bool {
        let words: Vec<bool> = text
            .split(' ')
            .map(|word| word.len() > 1 && word.bytes().all(|b| b.is_ascii_lowercase()))
            .collect();
        words.windows(2).any(|pair| pair[0] && pair[1])
    }

    #[test]
    fn holds_no_english_sentence_stands_in_korean_notes_of_stacks() {
        let above = "'body 1'".to_owned();
        let notes = [
            StackNote::SharedLoad,
            StackNote::AnalysisLower {
                joints_g: Some(0.6),
                analysis_g: 0.2,
            },
            StackNote::AnalysisLower {
                joints_g: None,
                analysis_g: 0.2,
            },
            StackNote::AnalysisFalls,
            StackNote::AnalysisBetween {
                at_least_g: 0.19,
                analysis_g: 0.2,
            },
            StackNote::CohesionCounted,
            StackNote::TensionLeftOut,
            StackNote::KineticLess { slides_at_g: 0.4 },
            StackNote::StrengthNotInAnalysis,
            StackNote::SideSupportsLeftOut,
            StackNote::TiesLeftOut,
            StackNote::PeriodUnknown,
        ];
        let standings = [
            Standing::Stands,
            Standing::Leaves {
                above: above.clone(),
                distance_m: 0.12,
            },
            Standing::Slides {
                above: above.clone(),
                shear_n: 2e3,
                resistance_n: 1e3,
            },
            Standing::Lifts {
                above: above.clone(),
                pull_n: 1e3,
            },
            Standing::Crushes {
                above: above.clone(),
                distance_m: 0.01,
            },
            Standing::Overloaded {
                above,
                pressure_pa: 2e6,
                strength_pa: 1e6,
            },
            Standing::SoilTurns {
                stiffness_n_m_rad: 1e6,
                least_n_m_rad: 2e6,
            },
        ];
        let steps = [
            Processing::Read {
                format: "csv".into(),
                unit: String::new(),
            },
            Processing::Read {
                format: "at2".into(),
                unit: "g".into(),
            },
            Processing::LeftOut {
                channels: vec!["ch3".into()],
            },
            Processing::Cut {
                from_s: 0.0,
                to_s: 30.0,
            },
            Processing::Detrend { degree: 0 },
            Processing::Detrend { degree: 1 },
            Processing::Detrend { degree: 2 },
            Processing::LowPass {
                corner_hz: 20.0,
                order: 4,
            },
            Processing::BandPass {
                low_hz: 0.1,
                high_hz: 20.0,
                order: 4,
            },
            Processing::Scaled { factor: 0.94 },
            Processing::Tapered { each_end_s: 0.1 },
            Processing::Rotated { angle_rad: 0.5 },
            Processing::Decimate { factor: 4 },
        ];
        let all = notes
            .iter()
            .map(|note| (note.to_string(), stack_note_words(note, Language::Korean)))
            .chain(
                standings
                    .iter()
                    .map(|s| (s.to_string(), standing_words(s, Language::Korean))),
            )
            .chain(
                steps
                    .iter()
                    .map(|s| (s.to_string(), processing_words(s, Language::Korean))),
            );
        for (english, korean) in all {
            assert!(!english_in(&korean) && korean != english, "{korean}");
            assert!(korean.chars().any(|c| ('가'..='힣').contains(&c)), "{korean}");
        }
        let said = standing_words(&standings[1], Language::Korean);
        assert_eq!(said, "body 1 위에서 합력이 접합면을 0.12\u{202f}m 벗어난다");
    }
}
