//! Sentences on wind and static loads.

use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::loads::{CombinationAnswer, LoadsAnswer};

/// Digits of a factor in a sentence.
pub(super) const DIGITS: usize = 3;

messages! {
    /// Findings on wind and static loads.
    pub(crate) enum Found in "loads.findings" {
        NoWind => {
            en: "Wind is not in the file: the verdict is on weight alone, and a storm may exceed the resistance of the beds.",
            ko: "풍하중을 입력하지 않아 자중만으로 판정하였다. 강풍 시 하중이 접합면의 저항을 넘을 수 있다.",
        },
        NoWindOnFrame => {
            en: "Wind is not in the file: the verdict is on weight alone, and a storm on roof and walls may exceed the resistance of the storeys.",
            ko: "풍하중을 입력하지 않아 자중만으로 판정하였다. 강풍 시 지붕과 벽체가 받는 하중이 층의 저항을 넘을 수 있다.",
        },
        Everything => { en: "Wind and static loads as they are", ko: "주어진 풍하중·정하중" },
        Wind => { en: "The wind of the file", ko: "입력한 풍하중" },
        Loads => { en: "The static loads of the file", ko: "입력한 정하중" },
        Combination(name: String) => { en: "Combination {name}", ko: "하중조합 {name}" },
        Overturns { what: Sentence, joint: usize, moment: Quantity, limit: Quantity, factor: Quantity } => {
            en: "{what}: the bed of joint {joint} does not bear it. The moment there is {moment}, and {limit} is the most that the bed passes; {factor} times the load is borne.",
            ko: "{what}: 접합면 {joint}이(가) 견디지 못한다. 작용 모멘트는 {moment}, 접합면이 전달할 수 있는 한계는 {limit}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        Bears { what: Sentence, joint: usize, moment: Quantity, limit: Quantity, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. Joint {joint} governs, with a moment of {moment} against {limit} that its bed passes; beds begin to open at a third of that.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. 지배 접합면은 접합면 {joint}이고 작용 모멘트 {moment}, 접합면 한계 {limit}이다. 접합면은 한계의 3분의 1에서 벌어지기 시작한다.",
        },
        OverturnsBoth { what: Sentence, joint: usize, along: Sentence, across: Sentence, factor: Quantity } => {
            en: "{what}: the bed of joint {joint} does not bear it. The moment there is {along} along and {across} across; {factor} times the load is borne.",
            ko: "{what}: 접합면 {joint}이(가) 견디지 못한다. 작용 모멘트는 운동 방향 {along}, 직각 방향 {across}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        BearsBoth { what: Sentence, joint: usize, along: Sentence, across: Sentence, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. Joint {joint} governs, with a moment of {along} along and {across} across; beds begin to open at a third of that, towards their corners at a sixth.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. 지배 접합면은 접합면 {joint}이고 작용 모멘트는 운동 방향 {along}, 직각 방향 {across}이다. 접합면은 한계의 3분의 1, 모서리 쪽으로는 6분의 1에서 벌어지기 시작한다.",
        },
        OfLimit { moment: Quantity, limit: Quantity } => { en: "{moment} of {limit}", ko: "{moment}(한계 {limit})" },
        Blowing { said: Sentence, towards: Sentence } => {
            en: "{said} The worst wind blows towards {towards}.",
            ko: "{said} 가장 불리한 풍향은 {towards} 방향이다.",
        },
        WindInNone => {
            en: "Wind is in the file, but no combination has a factor on it: it was not counted.« Write wind = 1 into [combination.NAME].»",
            ko: "파일에 풍하중이 있으나 어느 하중조합에도 계수가 없어 고려하지 않았다.« [combination.이름]에 wind = 1을 쓴다.»",
        },
        BeforeMoved => {
            en: "That is of the shape in the file, before its supports moved: of wind, and of more load than there is, nothing is known of the shape after it, so the verdict under loads is “unknown” at best.",
            ko: "이는 지점이 이동하기 전, 파일에 입력한 형상의 값이다. 이동 후의 형상이 바람이나 지금보다 큰 하중을 받을 때의 안정은 알 수 없으므로 하중에 대한 판정은 ‘판정 불가’보다 나을 수 없다.",
        },
        LoadsInNoneOfStack => {
            en: "No combination of the file counts its static loads; whether the stack stands without wind is judged with them all the same.",
            ko: "파일의 하중조합 가운데 정하중을 포함하는 것이 없다. 다만 바람이 없을 때의 안정 판정에는 정하중이 포함되어 있다.",
        },
        LoadsInNone => {
            en: "Static loads are in the file, but no combination has a factor on them: they were not counted.« Write loads = 1 into [combination.NAME].»",
            ko: "파일에 정하중이 있으나 어느 하중조합에도 계수가 없어 고려하지 않았다.« [combination.이름]에 loads = 1을 쓴다.»",
        },
        Heavy { what: Sentence, factor: Quantity, stable: Quantity } => {
            en: "{what}: it falls at {factor} times what it weighs with its loads; “stable” needs {stable}.",
            ko: "{what}: 하중의 무게를 포함한 자중의 {factor}배에서 안정을 잃으며 ‘안정’ 판정에는 {stable}배가 필요하다.",
        },
        Carried { weight: Quantity, factor: Quantity, frequency: Quantity } => {
            en: "The load factor and the frequencies above are without what the static loads weigh ({weight}); with it the load factor is {factor} and the lowest frequency {frequency}.",
            ko: "위의 하중배율과 고유진동수에는 정하중의 중량({weight})이 포함되지 않았다. 포함하면 하중배율은 {factor}, 최저 고유진동수는 {frequency}이다.",
        },
        CarriedFalls { weight: Quantity, factor: Quantity } => {
            en: "The load factor and the frequencies above are without what the static loads weigh ({weight}); with it the load factor is {factor}.",
            ko: "위의 하중배율과 고유진동수에는 정하중의 중량({weight})이 포함되지 않았다. 포함하면 하중배율은 {factor}이다.",
        },
        NothingPushes(what: Sentence) => {
            en: "{what}: nothing pushes from the side, so that the weight alone was judged.",
            ko: "{what}: 수평으로 작용하는 하중이 없어 자중만을 판정하였다.",
        },
        Falls(what: Sentence) => {
            en: "{what}: it falls under the weight of this combination alone.",
            ko: "{what}: 이 하중조합의 자중만으로도 안정을 유지하지 못한다.",
        },
        AtLeast { what: Sentence, joint: usize, moment: Quantity } => {
            en: "{what}: whether it is borne is unknown. Joint {joint} passes {moment} at the least, without what the weight adds as it leans; that needs the stiffness of the joints and the widths of their beds, and not all of these are given.",
            ko: "{what}: 저항 여부를 판정할 수 없다. 접합면 {joint}의 모멘트는 최소 {moment}이며 기울어짐에 따른 자중의 증가분은 포함되지 않았다. 접합부 강성과 접합면 폭이 모두 있어야 한다.",
        },
        FrameFalls { what: Sentence, direction: String, storey: Sentence, force: Quantity, most: Quantity, factor: Quantity } => {
            en: "{what}: {storey} does not bear it in direction {direction}. {force} pushes it, and {most} is the most that it resists with; {factor} times the load is borne.",
            ko: "{what}: {direction} 방향에서 {storey}이(가) 견디지 못한다. 작용 전단력은 {force}, 최대 저항력은 {most}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        FrameFallsByDrift { what: Sentence, direction: String, storey: Sentence, force: Quantity, most: Quantity, factor: Quantity } => {
            en: "{what}: {storey} does not bear it in direction {direction}. {force} pushes it, and at a drift of {most} it counts as fallen; {factor} times the load is borne.",
            ko: "{what}: {direction} 방향에서 {storey}이(가) 견디지 못한다. 작용 전단력은 {force}, 붕괴로 보는 층간변위는 {most}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        FrameBears { what: Sentence, direction: String, storey: Sentence, force: Quantity, drift: Quantity, share: Quantity, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. In direction {direction} {storey} governs: {force} makes it drift by {drift}, {share} of its height.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. {direction} 방향의 {storey}이(가) 지배하며 전단력 {force}에 의한 층간변위는 {drift}(층고의 {share})이다.",
        },
        StoreyNumber(number: usize) => { en: "storey {number}", ko: "{number}층" },
        StoreyName(name: String) => { en: "‘{name}’", ko: "‘{name}’" },
        FrameUnknown { what: Sentence, directions: String } => {
            en: "{what}: whether it is borne is unknown, the storey stiffness is not given (direction {directions}).",
            ko: "{what}: 층강성이 주어지지 않아 저항 여부를 판정할 수 없다({directions} 방향).",
        },
        FrameCarries(weight: Quantity) => {
            en: "Load factor, margins and frequencies hold what the static loads weigh, {weight}.",
            ko: "하중배율, 여유, 고유진동수에는 정하중의 중량 {weight}이(가) 포함되어 있다.",
        },
        DriftsBeyond { what: Sentence, direction: String, storey: Sentence, lean: Quantity, allowed: Quantity } => {
            en: "{what}: {storey} leans by {lean} of its height in direction {direction}, and {allowed} is allowed.",
            ko: "{what}: {direction} 방향 {storey}의 층간변위각이 {lean}(으)로 허용값 {allowed}을(를) 넘는다.",
        },
        DriftsWithin { what: Sentence, direction: String, storey: Sentence, lean: Quantity, allowed: Quantity } => {
            en: "{what}: {storey} leans by {lean} of its height in direction {direction}; {allowed} is allowed.",
            ko: "{what}: {direction} 방향 {storey}의 층간변위각은 {lean}이며 허용값은 {allowed}이다.",
        },
        StackFalls { what: Sentence, factor: Quantity } => {
            en: "{what}: the stones do not bear it; {factor} times the load is borne.",
            ko: "{what}: 석재가 견디지 못한다. 하중의 {factor}배에서 한계에 이른다.",
        },
        StackBears { what: Sentence, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다.",
        },
        MovesInWind { what: Sentence, joints: Sentence, direction: Sentence } => {
            en: "{what}: at its limit {joints}, the wind blowing towards {direction}.",
            ko: "{what}: 한계에서 {joints}이며 풍향은 {direction} 방향이다.",
        },
        Moves { what: Sentence, joints: Sentence } => {
            en: "{what}: at its limit {joints}.",
            ko: "{what}: 한계에서 {joints}이다.",
        },
        Towards { what: Sentence, direction: Sentence } => {
            en: "{what}: the worst wind blows towards {direction}.",
            ko: "{what}: 가장 불리한 풍향은 {direction} 방향이다.",
        },
        NoMechanism { what: Sentence } => {
            en: "{what}: what moves at its limit was not found.",
            ko: "{what}: 한계에서의 거동은 찾지 못하였다.",
        },
        NothingMoves(what: Sentence) => {
            en: "{what}: nothing that it asks moves a stone, at ten times the weight of the whole either.",
            ko: "{what}: 전체 자중의 10배에 이르도록 하중을 키워도 움직이는 석재가 없다.",
        },
        Slides => {
            en: "Stones slide there while others share their load. The limit analysis lets sliding joints rise, which real ones do not: the factor is an upper bound.",
            ko: "이때 하중을 나누어 지지하는 석재가 미끄러진다. 한계해석은 미끄러지는 접합면이 들리는 것으로 가정하나 실제는 그렇지 않으므로 저항 배수는 상한값이다.",
        },
        EdgesCrush(uncrushed: Quantity) => {
            en: "Edges of stones crush on the way there; if none did, the factor would be {uncrushed}.",
            ko: "그 전에 석재 모서리가 압괴한다. 압괴하지 않는다면 저항 배수는 {uncrushed}이다.",
        },
        EdgesCrushAlone => {
            en: "Edges of stones crush on the way there; if none did, nothing would move.",
            ko: "그 전에 석재 모서리가 압괴한다. 압괴하지 않는다면 움직이지 않는다.",
        },
        FootingTurns(rigid: Quantity) => {
            en: "The footing turns on its soil and lifts off; on rigid ground the factor would be {rigid}.",
            ko: "기초가 지반 위에서 회전하며 들린다. 강체 지반이라면 저항 배수는 {rigid}이다.",
        },
        FootingTurnsAlone => {
            en: "The footing turns on its soil and lifts off; on rigid ground nothing would move.",
            ko: "기초가 지반 위에서 회전하며 들린다. 강체 지반이라면 움직이지 않는다.",
        },
        SlidesSmooth(dilating: Quantity) => {
            en: "Upright joints slide there, and count without friction. Friction that lets them rise, which real ones do not, would give {dilating}: an upper bound.",
            ko: "이때 연직 접합면이 미끄러지므로 그 마찰을 뺀 값이다. 미끄러지며 벌어지는 것으로 보면 저항 배수는 {dilating}(상한값)이다.",
        },
        NotKnown(why: Sentence) => {
            en: "The wind is not compared: {why}.",
            ko: "풍하중을 검토하지 못하였다. {why}.",
        },
        NoResonanceOfKds(frequency: Quantity) => {
            en: "Its lowest frequency is {frequency}, and the gust factor of KDS 41 12 00 used here is for stiff structures, above 1 Hz: the resonant part comes on top, and what it bears above is without it.« Use code = \"EN 1991-1-4\", whose Annex B has it, or give the gust of a wind study.»",
            ko: "1차 고유진동수가 {frequency}이며, 여기에 쓴 KDS 41 12 00의 가스트영향계수는 1 Hz를 넘는 강체 구조물용이다. 공진 성분이 더해지며, 위의 저항 배수는 이를 제외한 값이다.« 부속서 B가 있는 code = \"EN 1991-1-4\"를 쓰거나 풍동실험·풍하중 평가의 돌풍 값을 입력한다.»",
        },
        NoResonance(frequency: Quantity) => {
            en: "At {frequency} gusts make it swing, and a gust as given does not hold that: what it bears above is without resonance.« Give the 10-minute mean with code = \"EN 1991-1-4\" and the damping ratio.»",
            ko: "고유진동수가 {frequency}이므로 돌풍에 공진할 수 있으나, 주어진 돌풍 값에는 공진 효과가 없다. 위의 저항 배수는 공진을 제외한 값이다.« 10분 평균 풍속을 code = \"EN 1991-1-4\" 및 감쇠비와 함께 입력해야 한다.»",
        },
    }
}

/// A combination by its name, or the kinds of load.
pub(super) fn what(answer: &LoadsAnswer, combination: &CombinationAnswer) -> Sentence {
    match (&combination.name, answer.has_wind, answer.has_loads) {
        (Some(name), _, _) => Found::Combination(name.clone()),
        (None, true, true) => Found::Everything,
        (None, true, false) => Found::Wind,
        (None, false, _) => Found::Loads,
    }
    .into()
}
