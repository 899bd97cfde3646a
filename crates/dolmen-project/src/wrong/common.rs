//! Sentences of several chapters.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Sentences of several chapters.
    pub(crate) enum Common in "project.error.common" {
        IsEmpty(path: String) => { en: "{path} is empty", ko: "{path}이(가) 비어 있다" },
        ZeroToOne => { en: "must be 0 to 1", ko: "0~1이어야 한다" },
        KeepOneOfThem => { en: "keep one of them", ko: "둘 중 하나만 남긴다" },
        StoreyHeight { path: String, written: String, least: String, most: String } => {
            en: "{path} = {written}, but storeys are {least} to {most} m high",
            ko: "{path} = {written}인데, 층고는 {least}~{most} m이다",
        },
        StiffnessUnit => { en: "is it in N/mm, kN/mm or kN/m?", ko: "단위가 N/mm, kN/mm, kN/m 중 어느 것인가?" },
        DidYouMean(near: String) => { en: "did you mean \"{near}\"?", ko: "\"{near}\"을(를) 쓰려던 것인가?" },
        NoMeaningHere => { en: "has no meaning here", ko: "여기에는 쓸 수 없다" },
        AndMore { some: String, count: usize } => { en: "{some} and {count} more", ko: "{some} 외 {count}개" },
        TakeItOut => { en: "take it out", ko: "삭제한다" },
        HasNumbers { path: String, count: String } => {
            en: "{path} has {count} numbers",
            ko: "{path}에 수가 {count}개 있다",
        },
        UnknownUnit => { en: "unknown unit", ko: "알 수 없는 단위" },
        UseUnitSuchAs(example: Both) => {
            en: "use a unit such as {example}",
            ko: "{example}와(과) 같은 단위를 쓴다",
        },
        MustBeTilt => {
            en: "must be a ratio, or text such as \"1/177\", \"0.32 deg\", \"5.65 mm/m\"",
            ko: "비율 또는 \"1/177\", \"0.32 deg\", \"5.65 mm/m\"와 같은 문자열이어야 한다",
        },
        ZeroOrMore => { en: "must be 0 or above", ko: "0 이상이어야 한다" },
        HasBothScaleAnd(path: String) => {
            en: "{path} has both scale and peak",
            ko: "{path}에 scale과 peak가 모두 있다",
        },
        TakeItOutOr(others: Both) => {
            en: "take it out, or write {others}",
            ko: "삭제하거나 {others}(으)로 쓴다",
        },
        IsItPerCent(percent: String) => { en: "did you mean \"{percent} %\"?", ko: "\"{percent} %\"인가?" },
        Acceleration => { en: "an acceleration", ko: "가속도" },
    }
}
