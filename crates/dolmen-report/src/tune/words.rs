//! Words for dampers compared with the rule and the optimum.

use crate::building::direction_words;
use dolmen::damper::{Choice, Goal};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{RowStroke, TogetherChoice, TuneLoad};

/// A ratio above 1 by no more than this counts as 1: it is rounding.
pub(super) const ROUNDING: f64 = 1e-12;

messages! {
    /// Choices, loads, goals.
    pub(crate) enum Words in "tune.words" {
        Given => { en: "as in the file", ko: "입력한 감쇠기" },
        Rule { mode: usize } => {
            en: "the rule: farthest from the centre of mode {mode}",
            ko: "규칙: {mode}차 모드 중심에서 가장 먼 곳",
        },
        TunedBest => { en: "where it is, tuned best", ko: "입력 위치, 최적 동조" },
        PlacedBest => { en: "placed best, tuned as in the file", ko: "최적 위치, 입력한 동조" },
        Best => { en: "placed and tuned best", ko: "최적 위치와 동조" },
        Without => { en: "none", ko: "없음" },
        AllGiven => { en: "all as in the file", ko: "입력한 전체" },
        Only { damper: String } => { en: "{damper} alone", ko: "{damper}만" },
        AllBut { damper: String } => { en: "all but {damper}", ko: "{damper} 제외" },
        AllTunedBest => {
            en: "all where they are, tuned best together",
            ko: "위치 유지, 동시 최적 동조",
        },
        AllBest => { en: "placed and tuned best together", ko: "위치와 동조 동시 최적" },
        BestShared => { en: "the same, their mass shared anew", ko: "위치, 동조와 질량 배분 최적" },
        Force => {
            en: "white-noise force, the same on every floor, at its centre of mass",
            ko: "각 층 질량중심에 동일하게 작용하는 백색잡음 하중",
        },
        Wind { corner: Quantity } => {
            en: "force of gusts (low pass at {corner}), the same on every floor, at its centre of mass",
            ko: "각 층 질량중심에 동일하게 작용하는 풍하중형 하중(저역통과 {corner})",
        },
        Gusts => {
            en: "the turbulent wind of the file on every floor",
            ko: "각 층에 작용하는 파일의 변동풍",
        },
        Base => { en: "white-noise acceleration of the base", ko: "백색잡음 지반가속도" },
        Ground { soil: Quantity } => {
            en: "acceleration of the ground after Clough & Penzien, soil at {soil}",
            ko: "Clough–Penzien 지반가속도(지반 진동수 {soil})",
        },
        LargestRms => {
            en: "the largest standard deviation of the points",
            ko: "관측점 표준편차의 최댓값",
        },
        MeanSquare => {
            en: "the root of the mean variance of the points",
            ko: "관측점 분산의 평균의 제곱근",
        },
        LargestPeak => {
            en: "the largest amplitude of the points under a harmonic load of that place and direction, of any frequency alike (its spectrum is not in this goal)",
            ko: "같은 위치와 방향의 조화하중에 대한 관측점 진폭의 최댓값(모든 진동수를 동등하게 보며 하중의 스펙트럼은 반영하지 않음)",
        },
        Motion { motion: String } => { en: "motion {motion}", ko: "{motion}" },
        Site => { en: "the spectrum of the site", ko: "부지 스펙트럼" },
        PointAlong { point: String, direction: Sentence } => {
            en: "{point} ({direction})",
            ko: "{point} ({direction})",
        },
        PointRatio { point: Sentence, ratio: Quantity } => { en: "{point} {ratio}", ko: "{point} {ratio}" },
    }
}

/// A choice; `mode` from 1.
pub(super) fn choice_words(choice: Choice, mode: usize) -> Sentence {
    match choice {
        Choice::Given => Words::Given,
        Choice::Rule => Words::Rule { mode },
        Choice::TunedBest => Words::TunedBest,
        Choice::PlacedBest => Words::PlacedBest,
        Choice::Best => Words::Best,
    }
    .into()
}

/// A choice of all dampers.
pub(super) fn together_words(choice: &TogetherChoice) -> Sentence {
    match choice {
        TogetherChoice::Without => Words::Without,
        TogetherChoice::Given => Words::AllGiven,
        TogetherChoice::Only(damper) => Words::Only {
            damper: damper.clone(),
        },
        TogetherChoice::AllBut(damper) => Words::AllBut {
            damper: damper.clone(),
        },
        TogetherChoice::TunedBest => Words::AllTunedBest,
        TogetherChoice::Best => Words::AllBest,
        TogetherChoice::BestShared => Words::BestShared,
    }
    .into()
}

/// The load.
pub(super) fn load_words(load: TuneLoad) -> Sentence {
    let hertz = |hz: f64| Quantity::new(hz, Unit::si("Hz"), Digits::Trimmed(6));
    match load {
        TuneLoad::Force => Words::Force,
        TuneLoad::Wind { corner_hz } => Words::Wind {
            corner: hertz(corner_hz),
        },
        TuneLoad::Gusts => Words::Gusts,
        TuneLoad::Base => Words::Base,
        TuneLoad::Ground { ground_hz } => Words::Ground {
            soil: hertz(ground_hz),
        },
    }
    .into()
}

/// The minimised quantity.
pub(super) fn goal_words(goal: Goal) -> Sentence {
    match goal {
        Goal::LargestRms => Words::LargestRms,
        Goal::MeanSquare => Words::MeanSquare,
        Goal::LargestPeak => Words::LargestPeak,
    }
    .into()
}

/// The motion behind a damper's stroke.
pub(super) fn under_words(stroke: &RowStroke) -> Sentence {
    match &stroke.motion {
        Some(motion) => Words::Motion {
            motion: motion.clone(),
        },
        None => Words::Site,
    }
    .into()
}

/// A point with a direction in degrees from x.
pub(super) fn point_along(point: &str, degrees: f64) -> Sentence {
    Words::PointAlong {
        point: point.to_owned(),
        direction: direction_words(degrees),
    }
    .into()
}

/// "left end 1.0430".
pub(super) fn point_ratio(point: impl Into<Sentence>, ratio: f64, decimals: usize) -> Sentence {
    Words::PointRatio {
        point: point.into(),
        ratio: of_none(ratio, decimals),
    }
    .into()
}

/// A motion or goal relative to that without a damper.
pub(super) fn of_none(ratio: f64, decimals: usize) -> Quantity {
    Quantity::new(ratio, Unit::ratio(), Digits::Fixed(decimals))
}

/// The requested fraction of a stroke.
pub(super) fn part(most: f64) -> Quantity {
    Quantity::new(most, Unit::ratio(), Digits::Trimmed(6))
}
