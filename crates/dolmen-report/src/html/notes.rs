//! What the science says beside its numbers, in the words of the page: its own sentence in English, one of the same
//! numbers in Korean.

use dolmen::assess::FrameNote;
use dolmen::structure::{LeftOut, Misfit, OfSpring, Proportion, Spring, StiffnessNote, Thoroughness};
use dolmen_words::Language;

pub(super) fn frame_note_words(note: &FrameNote, language: Language) -> String {
    let korean = match note {
        FrameNote::NoAxialForce => {
            "축력이 주어지지 않아 P-델타 효과를 고려하지 않았으며, 안정성은 판정할 수 없다.".into()
        }
        FrameNote::LevelLoad { level, ratio } => format!(
            "제{level}층 바닥이 층에 더하는 하중이 그 질량에 의한 자중의 {ratio:.2}배이다. 기재한 축력에 상부 하중이 이미 누적되어 있다면 층별 하중이 아니라 층 축력(storey)으로 입력해야 한다. 두 번 누적하면 P-델타 효과가 과대평가된다."
        ),
    };
    language.pick(note.to_string(), korean)
}

pub(super) fn stiffness_note_words(note: &StiffnessNote, language: Language) -> String {
    language.pick(note.to_string(), korean(note))
}

fn spring_word(spring: Spring) -> &'static str {
    match spring {
        Spring::Joint => "접합부 강성",
        Spring::Storey => "층강성",
    }
}

/// "접합면 3", "3층".
fn numbered(spring: Spring, number: usize) -> String {
    match spring {
        Spring::Joint => format!("접합면 {number}"),
        Spring::Storey => format!("{number}층"),
    }
}

fn proportion_word(proportion: Proportion) -> &'static str {
    match proportion {
        Proportion::WeightMoment => "각 접합면 상부의 자중 모멘트",
        Proportion::MassMomentOverHeight => {
            "각 층 상부의 질량 모멘트를 층고로 나눈 값(거의 직선인 1차 모드형상)"
        }
        Proportion::MassAbove => "각 층 상부의 질량",
    }
}

fn misfit_words(misfit: Misfit) -> String {
    match misfit {
        Misfit::Relative(share) => format!("{:.2}\u{202f}%(평균제곱근)", 100.0 * share),
        Misfit::Deviations(count) => format!("표준편차의 {count:.1}배(평균제곱근)"),
    }
}

fn each(springs: &[OfSpring], words: impl Fn(&OfSpring) -> String) -> String {
    springs.iter().map(words).collect::<Vec<_>>().join(", ")
}

fn korean(note: &StiffnessNote) -> String {
    match note {
        StiffnessNote::RatioBelowLeast { ratio, ratio_least } => format!(
            "이 두 고유진동수를 갖는 강성은 없다. 진동수비 r = f2/f1은 {ratio:.4}, r + 1/r은 {:.4}이나, 층간 스프링으로 된 2층 골조에서는 r + 1/r ≥ 2√(1 + m2/m1) = {:.4}, 즉 비가 {ratio_least:.4} 이상이어야 한다. 질량과, 두 모드가 모두 비틀림 없이 이 방향으로 움직이는지 확인해야 한다.",
            ratio + 1.0 / ratio,
            ratio_least + 1.0 / ratio_least
        ),
        StiffnessNote::DifferenceBelowLeast {
            difference_rad2_s2,
            difference_least_rad2_s2,
        } => format!(
            "이 두 고유진동수를 갖는 강성은 없다. ω2² − ω1²은 {difference_rad2_s2:.4} (rad/s)²이나, P-델타로 연성된 지반 기준 스프링의 2층 골조에서는 2 (N2/l2)/√(m1 m2) = {difference_least_rad2_s2:.4} 이상이어야 한다."
        ),
        StiffnessNote::NoneReal {
            frequencies,
            solutions_complex,
        } => format!(
            "고유진동수 {frequencies}개를 갖는 강성은 없다. 복소수 해 {solutions_complex}개 가운데 양의 실수 해가 없다. 질량과, 모든 모드가 비틀림 없이 이 방향으로 움직이는지 확인해야 한다."
        ),
        StiffnessNote::NotAllSeparated { separated, expected } => format!(
            "복소수 해 {expected}개 중 {separated}개만 분리되었다. 일부가 거의 겹쳐 있어, 제시된 해 외에 실수 해가 누락되었을 수 있다."
        ),
        StiffnessNote::NoneExplains {
            spring,
            starts,
            modes,
            misfit,
        } => format!(
            "시작점 {starts}개에서 탐색하였으나 모드 {modes}개를 설명하는 {}은 찾지 못하였다. 가장 가까운 해의 오차는 {}이다. 모드가 한 방향의 최저차부터 빠짐없이 주어졌는지와 질량을 확인해야 한다.",
            spring_word(*spring),
            misfit_words(*misfit)
        ),
        StiffnessNote::NoneStands { spring } => {
            format!("구조물이 안정한 {}을 찾지 못하였다.", spring_word(*spring))
        }
        StiffnessNote::FitLeavesFree { spring } => format!(
            "최적해에서 일부 {}이 정해지지 않는다. 어느 값 이상에서는 강성이 커져도 자료가 변하지 않는다. 제시된 해는 똑같이 잘 맞는 여러 해 중 하나이다.",
            spring_word(*spring)
        ),
        StiffnessNote::TooFewData {
            spring,
            springs,
            frequencies,
            with_shapes,
            independent,
            proportion,
        } => format!(
            "고유진동수 {frequencies}개{}에서 얻는 독립된 자료는 {independent}개인데 {}은 {springs}개이므로 정할 수 없다. 제시된 해는 자료에 맞는 해 중 {}에 비례하는 강성에 가장 가까운 것으로, 가정이며 계측 결과가 아니다. 더 많은 모드 또는 여러 높이의 모드형상을 계측해야 한다.",
            if *with_shapes {
                "와 모드형상 측점"
            } else {
                ""
            },
            spring_word(*spring),
            proportion_word(*proportion)
        ),
        StiffnessNote::SeveralExplain {
            spring,
            sets,
            thoroughness,
            with_shapes,
        } => {
            let how = match thoroughness {
                Thoroughness::All { solutions_complex } => {
                    format!(
                        "복소수 해 {solutions_complex}개를 모두 추적하였으므로 정확히 이 고유진동수에 대해서는 다른 해가 없다"
                    )
                }
                Thoroughness::Searched { starts } => {
                    format!("시작점 {starts}개에서 찾았으며 다른 해가 더 있을 수 있다")
                }
            };
            let advice = if *with_shapes {
                "이 자료로는 구별할 수 없으므로 더 많은 높이 또는 더 많은 모드의 형상을 계측해야 한다."
            } else {
                "고유진동수만으로는 구별할 수 없으므로 모드형상도 계측해야 하며, 센서는 각 접합면이나 층 가까이에 두는 것이 가장 좋다."
            };
            format!(
                "{} 조합 {sets}개가 자료를 똑같이 잘 설명하며 모두 안정하다({how}). {advice}",
                spring_word(*spring)
            )
        }
        StiffnessNote::OneWithoutProof { spring, starts } => format!(
            "시작점 {starts}개에서 {} 조합을 하나만 찾았으나, 고유진동수만으로는 해가 여럿인 경우가 많으므로 유일하다는 증명은 아니다.",
            spring_word(*spring)
        ),
        StiffnessNote::OddCount { spring } => format!(
            "해의 수가 홀수이나, {}과 같은 수의 고유진동수가 주어지면 해의 수는 짝수이므로 찾지 못한 해가 적어도 하나 더 있다. 시작점 수(starts)를 늘려야 한다.",
            spring_word(*spring)
        ),
        StiffnessNote::ListCut { found, listed } => {
            format!("해 {found}개를 찾았으며 처음 {listed}개만 제시한다.")
        }
        StiffnessNote::OneShapePoint { mode } => {
            format!("모드 {mode}의 형상은 측점이 하나뿐이다. 크기 기준이 임의이므로 정보가 없어 제외하였다.")
        }
        StiffnessNote::DeviationsAssumed { frequency, shape } => format!(
            "표준편차가 없는 자료에는 고유진동수의 {}\u{202f}%, 모드별 최대 변위의 {}\u{202f}%를 표준편차로 가정하였다.",
            100.0 * frequency,
            100.0 * shape
        ),
        StiffnessNote::NoInterval { misfit } => format!(
            "최적해의 오차는 {}이다. 모드의 표준편차가 없으므로 강성의 구간은 제시할 수 없다.",
            misfit_words(*misfit)
        ),
        StiffnessNote::FreeDirection { spring, components } => format!(
            "미결정 방향: ln k를 {}의 비율로 변화시켜도 모든 자료가 (1차 근사에서) 변하지 않는다.",
            each(components, |c| format!(
                "{} {:+.2}",
                numbered(*spring, c.number),
                c.value
            ))
        ),
        StiffnessNote::WideIntervals { spring, relative_sd } => format!(
            "일부 강성은 자릿수 정도만 정해진다(표준편차: {}).",
            each(relative_sd, |c| format!(
                "{} {:.0}\u{202f}%",
                numbered(*spring, c.number),
                100.0 * c.value
            ))
        ),
        StiffnessNote::Unseen { spring, numbers } => {
            let all: Vec<String> = numbers.iter().map(|n| numbered(*spring, *n)).collect();
            format!(
                "센서로 거의 파악되지 않는 강성: {}. 이 강성이 변해도 자료는 거의 변하지 않는다.",
                all.join(", ")
            )
        }
        StiffnessNote::SolutionsMeet { spring } => format!(
            "중근 부근이다. {} 조합 두 개가 여기서 만나거나 고유진동수의 산포만으로 서로 바뀔 만큼 가까우므로 선형 구간은 존재하지 않는다. 모드형상을 계측해야 한다.",
            spring_word(*spring)
        ),
        StiffnessNote::ShapeOff { mode, difference } => format!(
            "표준편차 없이 주어진 {mode}차 모드형상의 오차는 최대 변위의 {:.1} %까지 이른다.",
            100.0 * difference
        ),
        StiffnessNote::RangeIncomplete { solutions } => {
            let all: Vec<String> = solutions.iter().map(|n| n.to_string()).collect();
            format!(
                "해 {}의 범위는 완전하지 않다. 그 범위 안의 일부 고유진동수에서는 해가 없다.",
                all.join(", ")
            )
        }
        StiffnessNote::ThinRods => {
            "주어지지 않은 관성모멘트는 가는 봉의 값으로 보았다. 이는 작은 값이므로 강성도 작게 추정된다."
                .into()
        }
        StiffnessNote::SideSupportTaken => {
            "측면 지지는 모델에 포함되며, 그 강성은 주어진 값으로 보았다.".into()
        }
        StiffnessNote::SideSupportWithGap => {
            "측면 지지는 유격이 있어 제외하였다. 진동하는 동안 지지에 닿지 않는 것으로 본다.".into()
        }
        StiffnessNote::NoAxialForce => {
            "축력이 주어지지 않아 P-델타 효과를 고려하지 않았으므로 강성이 작게 추정된다.".into()
        }
        StiffnessNote::TiesTaken => "연결재는 모델에 포함되며, 그 강성은 주어진 값으로 보았다.".into(),
        StiffnessNote::LeftOut(why) => left_out(why),
        StiffnessNote::Twists { frequency_hz } => {
            format!("{frequency_hz}\u{202f}Hz 모드는 평면 비틀림 모드이므로 강성 추정에서 제외하였다.")
        }
        StiffnessNote::TakenAsLowest { modes, direction } => format!(
            "사용한 모드 {modes}개를 {direction} 방향의 최저차부터 빠짐없이 찾은 것으로 보았다. 누락된 모드가 있으면 모든 강성이 틀리게 된다."
        ),
    }
}

fn left_out(why: &LeftOut) -> String {
    match why {
        LeftOut::OtherDirection { frequency_hz, share } => format!(
            "{frequency_hz:.3}\u{202f}Hz 모드는 제외하였다. 이 방향의 운동 성분이 {:.0}\u{202f}%에 불과하다({:.0}\u{202f}% 필요).",
            100.0 * share,
            100.0 * LeftOut::SHARE_LEAST
        ),
        LeftOut::Twists {
            frequency_hz,
            height_m,
            difference,
        } => format!(
            "{frequency_hz:.3}\u{202f}Hz 모드는 제외하였다. 높이 {height_m:.2}\u{202f}m의 센서들이 최대 변위의 {:.0}\u{202f}%만큼 서로 달라 비틀림 모드로 본다.",
            100.0 * difference
        ),
        LeftOut::Doubtful { frequency_hz, above } => format!(
            "{frequency_hz:.3}\u{202f}Hz의 모드는 제외하였다. 측정 배치들이 같은 모드를 보인다고 단정할 수 없다. 가장 낮은 모드부터 세어 맞추므로 그 위의 모드 {above}개도 제외하였다."
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind of note, with numbers.
    fn every() -> Vec<StiffnessNote> {
        let (spring, misfit) = (Spring::Joint, Misfit::Deviations(4.2));
        let components = vec![OfSpring {
            number: 3,
            value: 0.7,
        }];
        let proportion = Proportion::MassMomentOverHeight;
        let thoroughness = Thoroughness::All {
            solutions_complex: 120,
        };
        let left_out = [
            LeftOut::OtherDirection {
                frequency_hz: 1.5,
                share: 0.2,
            },
            LeftOut::Twists {
                frequency_hz: 2.5,
                height_m: 3.0,
                difference: 0.4,
            },
            LeftOut::Doubtful {
                frequency_hz: 3.5,
                above: 1,
            },
        ];
        let mut all = vec![
            StiffnessNote::RatioBelowLeast {
                ratio: 1.8,
                ratio_least: 2.5,
            },
            StiffnessNote::DifferenceBelowLeast {
                difference_rad2_s2: 1.0,
                difference_least_rad2_s2: 2.0,
            },
            StiffnessNote::NoneReal {
                frequencies: 3,
                solutions_complex: 6,
            },
            StiffnessNote::NotAllSeparated {
                separated: 5,
                expected: 6,
            },
            StiffnessNote::NoneExplains {
                spring,
                starts: 20,
                modes: 3,
                misfit,
            },
            StiffnessNote::NoneStands { spring },
            StiffnessNote::FitLeavesFree { spring },
            StiffnessNote::TooFewData {
                spring,
                springs: 5,
                frequencies: 2,
                with_shapes: true,
                independent: 2,
                proportion,
            },
            StiffnessNote::SeveralExplain {
                spring,
                sets: 40,
                thoroughness,
                with_shapes: false,
            },
            StiffnessNote::OneWithoutProof { spring, starts: 20 },
            StiffnessNote::OddCount { spring },
            StiffnessNote::ListCut {
                found: 120,
                listed: 40,
            },
            StiffnessNote::OneShapePoint { mode: 2 },
            StiffnessNote::DeviationsAssumed {
                frequency: 0.01,
                shape: 0.05,
            },
            StiffnessNote::NoInterval { misfit },
            StiffnessNote::FreeDirection {
                spring,
                components: components.clone(),
            },
            StiffnessNote::WideIntervals {
                spring,
                relative_sd: components,
            },
            StiffnessNote::Unseen {
                spring,
                numbers: vec![3],
            },
            StiffnessNote::SolutionsMeet { spring },
            StiffnessNote::ShapeOff {
                mode: 1,
                difference: 0.05,
            },
            StiffnessNote::RangeIncomplete {
                solutions: vec![1, 2],
            },
            StiffnessNote::ThinRods,
            StiffnessNote::SideSupportTaken,
            StiffnessNote::SideSupportWithGap,
            StiffnessNote::NoAxialForce,
            StiffnessNote::TiesTaken,
            StiffnessNote::Twists { frequency_hz: 3.5 },
            StiffnessNote::TakenAsLowest {
                modes: 2,
                direction: "x".into(),
            },
        ];
        all.extend(left_out.map(StiffnessNote::LeftOut));
        all
    }

    /// Two English words one after the other.
    fn english_in(text: &str) -> bool {
        let words: Vec<bool> = text
            .split(' ')
            .map(|word| word.len() > 1 && word.bytes().all(|b| b.is_ascii_lowercase()))
            .collect();
        words.windows(2).any(|pair| pair[0] && pair[1])
    }

    #[test]
    fn holds_no_english_sentence_stands_in_korean_notes() {
        let frame = [
            FrameNote::NoAxialForce,
            FrameNote::LevelLoad { level: 1, ratio: 2.1 },
        ];
        let frame = frame.iter().map(|note| frame_note_words(note, Language::Korean));
        let all = every();
        let all = all
            .iter()
            .map(|note| stiffness_note_words(note, Language::Korean));
        for said in frame.chain(all) {
            assert!(!english_in(&said), "{said}");
        }
        assert!(english_in(&stiffness_note_words(
            &StiffnessNote::ThinRods,
            Language::English
        )));
    }
}
