//! Why a flag has no effect, in both languages.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// The purpose of a flag, and the alternative in the file.
    pub(crate) enum FlagWords in "work.flag" {
        Refused { flag: String, reason: Both } => { en: "--{flag} {reason}", ko: "--{flag}: {reason}" },
        IsFor(kinds: Both) => { en: "is for {kinds}", ko: "{kinds}에 쓴다" },
        ThisFile { is_for: Both, kind: String } => {
            en: "{is_for}: this file has a {kind}",
            ko: "{is_for}. 이 파일은 {kind}이다",
        },
        ThisFileAnd { is_for: Both, kind: String, instead: Both } => {
            en: "{is_for}: this file has a {kind}, and {instead}",
            ko: "{is_for}. 이 파일은 {kind}이다. {instead}",
        },
        DrawsLoadFactor => {
            en: "draws the load factor of a chain, frame or building",
            ko: "chain, frame, building의 하중배율을 표본으로 구한다",
        },
        NamesDirection => { en: "names a direction of a frame", ko: "frame의 방향을 지정한다" },
        ActsAfter => {
            en: "is the second of two motions, which acts on what the first left",
            ko: "두 지반운동 중 둘째로, 첫째가 남긴 상태에 작용한다",
        },
        BuildingAsBefore => {
            en: "a building, unlike a chain, frame or stack, is linear here: once at rest it is as it was before the first motion, so simulate the second alone",
            ko: "building은 chain, frame, stack과 달리 여기서 선형이므로 멈춘 뒤에는 첫 지반운동 이전과 같다. 둘째 지반운동만 해석한다",
        },
        BlowsWind => {
            en: "blows the wind of the file on a building in time",
            ko: "파일의 바람을 building에 시간이력으로 작용시킨다",
        },
        DrawsWind => {
            en: "draws histories of the wind on a building",
            ko: "building에 작용하는 바람의 시간이력을 뽑는다",
        },
        LeansChain => { en: "lets a chain lean at the start", ko: "chain을 처음에 기울인다" },
        NotForStackCheck => {
            en: "it cannot draw for a stack yet: its verdict is without shaking; take --sensitivity for what moves it",
            ko: "stack에는 아직 쓸 수 없다. stack의 판정은 지반운동이 없는 상태의 것이다. 무엇이 판정을 바꾸는지는 --sensitivity로 본다",
        },
        NotForStackReport => {
            en: "it cannot draw for a stack yet: its verdict is without shaking",
            ko: "stack에는 아직 쓸 수 없다. stack의 판정은 지반운동이 없는 상태의 것이다",
        },
        ChainInOnePlane => { en: "a chain moves in one plane", ko: "chain은 한 평면에서 움직인다" },
        BuildingInPlan => {
            en: "a building moves in plan, --turn turns the motion",
            ko: "building은 평면에서 움직이며 --turn으로 지반운동을 돌린다",
        },
        BuildingSmall => {
            en: "a building's displacements are small",
            ko: "building의 변위는 작은 것으로 본다",
        },
    }
}
