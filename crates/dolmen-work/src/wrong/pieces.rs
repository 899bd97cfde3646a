//! Parts of sentences, in both languages.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// The available names.
    pub(crate) enum KnownNames in "work.known" {
        None => { en: "none", ko: "없음" },
        DidYouMean { known: String, near: String } => {
            en: "{known} (did you mean \"{near}\"?)",
            ko: "{known}(\"{near}\"을(를) 쓰려던 것인가?)",
        },
    }
}

messages! {
    /// The place of a cause.
    pub(crate) enum Place in "work.place" {
        AllSetups => { en: "all setups as one", ko: "하나로 합친 측정 배치" },
        OfLog { name: String, file: String } => { en: "log {name}, {file}", ko: "기록 {name}, {file}" },
        OfSurvey(name: String) => { en: "survey {name}", ko: "{name} 조사" },
        StonesOfScan(file: String) => { en: "the stones cut from {file}", ko: "{file}에서 자른 석재" },
        SensorsPlaced => { en: "placing sensors", ko: "센서 배치" },
        SpringsMeasured => {
            en: "springs that would have the measured frequencies of the surveys",
            ko: "조사의 계측 진동수에 맞는 스프링",
        },
        SampleImpossible => {
            en: "a sample of the inputs gives an impossible structure: lower the cov of the input that it names",
            ko: "입력의 표본이 있을 수 없는 구조물이 된다. 아래에 나온 입력의 cov를 낮춘다",
        },
        StrokesUnder(motion: String) => {
            en: "motion.{motion}, under which strokes are judged",
            ko: "행정을 판정하는 motion.{motion}",
        },
        EveryModeCounts { period_s: String, damping_percent: String } => {
            en: "a mode has a period of {period_s} s and {damping_percent} % damping, and every mode counts",
            ko: "주기 {period_s} s, 감쇠 {damping_percent} %인 모드가 있고 모든 모드가 필요하다",
        },
        Chain => { en: "a chain", ko: "체인" },
        Frame => { en: "a frame", ko: "골조" },
    }
}

messages! {
    /// Remarks on a file that is read.
    pub(crate) enum FileRemark in "work.file_remark" {
        ComposedOtherwise { file: String } => {
            en: "the letters of the file's name are composed otherwise on this disk (NFD, as macOS writes Hangul, for NFC, or the reverse): it was read as {file}",
            ko: "디스크에 있는 파일 이름은 글자 조합 방식이 다르다(macOS의 NFD와 NFC). {file}(으)로 보고 읽었다",
        },
    }
}

messages! {
    /// Why a structure is not compared with its site.
    pub(crate) enum NotHeld in "work.not_held" {
        Falls => {
            en: "it does not stand without shaking",
            ko: "지진이 없어도 서 있지 못한다",
        },
        NoGround => {
            en: "the table gives no acceleration of the ground«: begin it at T = 0, or write peak_ground_acceleration»",
            ko: "표에 지반가속도가 없다«. T = 0부터 입력하거나 peak_ground_acceleration을 쓴다»",
        },
    }
}

messages! {
    /// Why the structure of a case cannot be run.
    pub(crate) enum CaseRefused in "work.case" {
        JointsUnknown => {
            en: "the joints are unknown: «`dolmen identify`|the identification from vibration» finds stiffness that measured modes allow; write it into the joints, or into a variant« that variants names»",
            ko: "접합부 강성을 알 수 없다. «`dolmen identify`|진동 평가»로 계측 모드에 맞는 강성을 구해 «joints나 variants에 있는|접합부나» 대안에 쓴다",
        },
        FeetLiftOff => {
            en: "columns without ties lift off their stones, which a run follows with one storey and one component alone: the springs of their beds are too stiff beyond",
            ko: "결구 없는 기둥의 주각이 초석에서 들렸는데 이는 단층이고 한 성분일 때만 추적한다. 그 뒤에는 지압면의 강성보다 유연하다",
        },
        Irregular => {
            en: "columns rock so irregularly that shorter steps still change the largest drift",
            ko: "기둥의 거동이 불규칙하여 시간 간격을 줄여도 최대 변위가 달라진다",
        },
        NoDirectionKnown => {
            en: "the stiffness of no direction is known: «`dolmen identify`|the identification from vibration» finds those that frequencies allow",
            ko: "강성을 아는 방향이 없다. «`dolmen identify`|진동 평가»로 진동수에 맞는 강성을 구한다",
        },
        ChooseDirection(directions: String) => {
            en: "the file has the directions {directions}: choose one with direction",
            ko: "파일에 방향 {directions}이(가) 있다. direction으로 하나를 고른다",
        },
        DirectionUnknown(direction: String) => {
            en: "the stiffness of direction \"{direction}\" is unknown, or there is none of this name",
            ko: "방향 \"{direction}\"의 강성을 알 수 없거나 그런 방향이 없다",
        },
        SurveyAlone => { en: "a survey holds no structure", ko: "survey에는 구조물이 없다" },
        DrawnTooFar { input: String, drawn: String } => {
            en: "{input} is drawn as {drawn}, with which there is no such structure: lower its cov",
            ko: "{input}이(가) {drawn}(으)로 추출되었는데 그런 구조물은 있을 수 없다. 그 cov를 낮춘다",
        },
        FallsAlone(load_factor: String) => {
            en: "it falls under its own weight, load factor {load_factor}",
            ko: "자중으로 쓰러진다(하중배율 {load_factor})",
        },
        BedCrushes => {
            en: "a bed crushes under the weight above it alone",
            ko: "접합면이 상부 자중만으로 압괴한다",
        },
        LeansToItsFall => {
            en: "under its own weight it leans, as surveyed, beyond what counts as fallen",
            ko: "조사한 기울기에서 자중으로 붕괴로 보는 한계를 넘어 기운다",
        },
        Falls(verdict: Both) => {
            en: "it does not stand without shaking: {verdict}",
            ko: "흔들지 않아도 서 있지 못한다: {verdict}",
        },
        PressedWithoutMass => {
            en: "static loads without mass press its stones together, so that shaking it says nothing of its capacity: model what weighs on it as a block, or study a variant «with loads = []|without them»",
            ko: "질량 없는 정하중이 석재를 누르고 있어 흔들어도 한계 지반운동을 알 수 없다. 얹힌 것을 블록으로 모델링하거나 «loads = []인|정하중이 없는» 대안을 검토한다",
        },
        SupportsMove => {
            en: "its supports move before the ground shakes, and runs shake it as it stood before: study a variant «with support_movement = []|whose supports do not move»",
            ko: "지점이 먼저 이동하지만 해석은 이동 전의 형상을 흔든다. «support_movement = []인|지점이 이동하지 않는» 대안을 검토한다",
        },
        NoVerdictBefore => {
            en: "the run under the motion before came to no verdict",
            ko: "앞서 작용하는 지반운동의 해석이 판정에 이르지 못했다",
        },
        UndecidedBefore(why: Both) => {
            en: "the run under the motion before came to no verdict: {why}",
            ko: "앞서 작용하는 지반운동의 해석이 판정에 이르지 못했다: {why}",
        },
        MovingBefore { speed_mm_s: String, still_s: String, most_mm_s: String } => {
            en: "{still_s} s after the motion before, a part still moves at {speed_mm_s} mm/s, and at rest it may move at {most_mm_s} mm/s: give the structure its damping",
            ko: "앞서 작용한 지반운동이 끝나고 {still_s} s 뒤에도 {speed_mm_s} mm/s로 움직이는 부분이 있다. 정지 기준은 {most_mm_s} mm/s이다. 구조물의 감쇠를 준다",
        },
        AfterMotion { study: String, motion: String } => {
            en: "study \"{study}\" is of the structure after {motion}, and not as it stands: name one without after",
            ko: "study \"{study}\"은(는) 현 상태가 아니라 {motion} 이후의 구조물에 대한 것이다. after가 없는 study를 지정한다",
        },
        NotDone { study: String, missing: usize } => {
            en: "study \"{study}\" is not done: {missing} scans are missing; run it again",
            ko: "study \"{study}\"이(가) 끝나지 않았다. 조합 {missing}개가 없다. 다시 실행한다",
        },
        SeveralCombinations { study: String, combinations: usize } => {
            en: "study \"{study}\" varies its inputs in {combinations} combinations: name one that varies nothing",
            ko: "study \"{study}\"의 입력 조합이 {combinations}가지이다. 입력을 바꾸지 않는 study를 지정한다",
        },
        NoScan(study: String) => {
            en: "study \"{study}\" has no scan that can be used",
            ko: "study \"{study}\"에 쓸 수 있는 조합이 없다",
        },
    }
}

messages! {
    /// Why the run of a study came to no verdict.
    pub(crate) enum RunEnded in "work.ended" {
        NotAtRest { longer: String } => {
            en: "it had not come to rest {longer} s after the time to rest",
            ko: "정지 대기 시간이 지나고 {longer}초 뒤에도 정지하지 않았다",
        },
        NoSolution { left: String } => {
            en: "no solution of the contact law was found: {left} m/s are left",
            ko: "접촉 조건의 해를 구하지 못하였다. 잔차 {left} m/s",
        },
        LeaningFurther => {
            en: "a link was leaning further and further out when the run ended",
            ko: "해석이 끝날 때 부재의 기울기가 계속 커지고 있었다",
        },
    }
}

messages! {
    /// Properties of a file that runs under ground motion include or leave out.
    pub(crate) enum OfRuns in "work.runs" {
        LoosenedLeftOut(stones: Vec<String>) => {
            en: "rigid joints have no stiffness, so that the loss of stiffness in the beds below {stones} changes nothing in the runs",
            ko: "강체 접촉 해석에는 접합면 강성이 없어 {stones} 하부 접합면의 강성 저하가 결과에 나타나지 않는다",
        },
        WindLeftOut => {
            en: "the wind of the file does not act in the runs: «`dolmen check`|the check of stability» judges it",
            ko: "해석에 파일의 바람을 반영하지 않았다. «`dolmen check`|안정성 검토»에서 판정한다",
        },
        ForcesLeftOut => {
            en: "forces and moments of static loads do not act in the runs: «`dolmen check`|the check of stability» judges them",
            ko: "해석에 정하중의 힘과 모멘트를 반영하지 않았다. «`dolmen check`|안정성 검토»에서 판정한다",
        },
        ColumnsLeftOut => {
            en: "storeys keep their stiffness where the feet of their free-standing columns lift off: how beds and joints share it is assumed, and «`dolmen simulate`|a simulation in time» says how far that matters in a frame of one storey",
            ko: "자립 기둥의 주각이 들린 뒤에도 층강성을 그대로 두었다. 지압면과 접합부의 강성 분담은 가정이며, 단층 골조에서 그 영향은 «`dolmen simulate`|지진응답 검토»에 나온다",
        },
        VerticalLeftOut { percent: String } => {
            en: "vertical components of the motions, up to {percent} % of their horizontal peak, do not act in the runs",
            ko: "해석에 지반운동의 연직 성분(수평 최대의 {percent} % 이하)을 반영하지 않았다",
        },
        AcrossOfDirection { motions: Vec<String>, direction: String, acts: String, left_out: String } => {
            en: "of {motions} only component {acts} acts, in direction {direction}; component {left_out} does not. A study without `direction` shakes both, if the file says which lies along x and which along y",
            ko: "{motions}의 {acts} 성분만 {direction} 방향에 작용하고 {left_out} 성분은 작용하지 않는다. 파일에 x·y 방향(along)을 적고 study에서 direction을 빼면 두 방향을 함께 흔든다",
        },
        AcrossOfPlane { motions: Vec<String> } => {
            en: "of {motions} only component x acts, in the plane of the chain; component y does not. A chain with widths and stiffness in both directions is shaken by both",
            ko: "{motions}의 x 성분만 체인의 평면에 작용하고 y 성분은 작용하지 않는다. 두 방향의 너비와 강성을 주면 두 성분을 모두 작용시킨다",
        },
        LimitsDiffer => {
            en: "the allowable drift« of [limits]» differs between the combinations, so that no scan is compared with it«: write a study for each»",
            ko: "조합마다 «[limits]의 »허용 층간변위가 달라 허용값과 비교하지 않았다«. 허용값마다 study를 따로 쓴다»",
        },
        HazardsDiffer => {
            en: "the hazard of the site differs between the combinations, so that there are no rates: write a study for each",
            ko: "조합마다 부지의 재해도가 달라 초과율을 구하지 않았다. 부지 조건마다 study를 따로 쓴다",
        },
        DirectionLeftOut(direction: String) => {
            en: "the stiffness of direction {direction} is not known: nothing of it is in the runs, the states and their rates",
            ko: "{direction} 방향의 강성을 알 수 없어 해석과 손상상태, 초과율에 이 방향을 반영하지 않았다",
        },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "the runs start plumb: the tilt of survey {survey} ({tilt}) is not in them, and what leans gives way to less",
            ko: "해석은 연직 상태에서 시작하며 {survey} 조사의 실측 기울기({tilt})를 반영하지 않았다. 기울어진 구조물의 한계 지반운동은 더 작다",
        },
        Leans { survey: String, tilt: String } => {
            en: "the runs start leaning as survey {survey} found it ({tilt})",
            ko: "해석은 {survey} 조사의 실측 기울기({tilt})에서 시작한다",
        },
        LoadsAct => {
            en: "static loads act in the runs as forces without mass",
            ko: "정하중은 질량 없는 힘으로 해석에 작용한다",
        },
        LoadsMove => {
            en: "what hangs on it as static loads moves with it, with its mass",
            ko: "매달린 정하중은 그 질량과 함께 움직인다",
        },
        MapAccuracy => {
            en: "drifts and rotations of the map at points called steady are those of the steady state to 1e-4 of their value where viscous damping is 5 % or more, to 2 % at 2 %, and to 10 % at 1 %; with less, the free vibration from the start is still in them near a natural frequency, and they can be off by a third",
            ko: "조화 지반운동에서 정상상태로 표시된 계산점의 층간변위와 회전은 점성감쇠가 5 % 이상이면 상대오차 1e-4, 2 %이면 2 %, 1 %이면 10 % 이내이다. 감쇠가 그보다 작으면 고유진동수 부근에서 처음의 자유진동이 남아 3분의 1까지 다를 수 있다",
        },
        SidePosts(posts: usize) => {
            en: "side supports hold it in the runs: {posts}",
            ko: "해석에 측면 지지를 고려하였다: {posts}개",
        },
        OnlyIn { some: Both, said: Both } => {
            en: "in the runs of {some} only: {said}",
            ko: "{some}의 해석만: {said}",
        },
        OfVariants { variants: Vec<String> } => { en: "variant {variants}", ko: "대안 {variants}" },
        OfValues { input: String, values: Vec<String> } => { en: "{input} = {values}", ko: "{input} = {values}" },
        OfCombinations { some: usize, all: usize } => {
            en: "{some} of {all} combinations",
            ko: "조합 {all}개 중 {some}개",
        },
    }
}

messages! {
    /// The difference between a journal and its study.
    pub(crate) enum JournalDiffers in "work.journal" {
        OtherStudy(study: String) => { en: "it is of the study \"{study}\"", ko: "study \"{study}\"의 것이다" },
        OtherVersion { other: String, own: String } => {
            en: "it was made by Dolmen {other}, this is {own}",
            ko: "Dolmen {other}에서 만들었는데 지금은 {own}이다",
        },
        Changed(inputs: Both) => { en: "changed since then: {inputs}", ko: "그 뒤에 바뀐 입력: {inputs}" },
    }
}

messages! {
    /// Missing values in a row of a table of structures.
    pub(crate) enum RowLacks in "portfolio.lacks" {
        Factors => {
            en: "it has neither a project nor its factors: fill storeys, body_height_m, taper_deg, body_base_height_ratio, and body_slenderness or slenderness_angle or both",
            ko: "프로젝트(project)도 여섯 인자도 없다. 층수(storeys), 탑신 높이(body_height_m), 체감각(taper_deg), 탑신/기단 높이비(body_base_height_ratio)와 몸돌 세장비(body_slenderness)나 세장각(slenderness_angle) 또는 둘 다를 채운다",
        },
        Columns(columns: Both) => {
            en: "it has neither a project nor all of its factors: fill {columns}",
            ko: "프로젝트(project)도 없고 여섯 인자도 모두 있지 않다. {columns}을(를) 채운다",
        },
        Name => {
            en: "the structure has no name: fill the column name",
            ko: "구조물의 이름이 없다. 이름(name) 열을 채운다",
        },
        Heads => {
            en: "it has more cells than the table has heads: name every column in the first row",
            ko: "열 이름보다 셀이 많다. 첫 행에 모든 열의 이름을 쓴다",
        },
        ZoneAndSoil => {
            en: "zone_factor_g and soil belong together: fill both or neither",
            ko: "지역계수(zone_factor_g)와 지반(soil)은 함께 쓴다. 둘 다 채우거나 둘 다 비운다",
        },
    }
}

messages! {
    /// Allowed values in a table of structures.
    pub(crate) enum RowNeeds in "portfolio.needs" {
        Number => { en: "a number, 0 or more, in the unit of the column", ko: "열의 단위로 0 이상인 수" },
        DecimalPoint(number: String) => { en: "a number, with a decimal point: {number}", ko: "소수점(.)을 쓴 수({number})" },
        CommaOfEither { decimal: String, thousands: String } => {
            en: "a number without a comma: {decimal} if it is a decimal sign, {thousands} if it separates thousands",
            ko: "쉼표 없는 수(쉼표가 소수점이면 {decimal}, 천 단위 구분이면 {thousands})",
        },
        ZoneFactor => {
            en: "above 0 and at most 0.15, in g: KDS 17 10 00 has 0.11 in zone I and 0.07 in zone II",
            ko: "g 단위로 0보다 크고 0.15 이하(KDS 17 10 00의 지역계수: 지진구역 I 0.11, II 0.07)",
        },
        WholeNumber => { en: "a whole number", ko: "정수" },
        BodyHeight => { en: "at most 100, in m: is it in mm?", ko: "m 단위로 100 이하(mm 값이 아닌가?)" },
        Slenderness => {
            en: "at most 15, height over width: is a decimal point missing, 2.9 for 29?",
            ko: "높이/폭의 비로 15 이하(2.9를 29로 쓴 것처럼 소수점이 빠지지 않았는가?)",
        },
        Taper => { en: "below 40, in degrees", ko: "40보다 작은 각도(도)" },
        Soil => { en: "S1 to S5 of KDS 17 10 00", ko: "KDS 17 10 00의 S1~S5" },
    }
}

messages! {
    /// Allowed values in a table of designs.
    pub(crate) enum DesignNeeds in "score-designs.needs" {
        Number => { en: "number", ko: "수" },
        WholeNumber => { en: "whole number", ko: "정수" },
        PositiveWithBeta => { en: "positive number with a positive β", ko: "β가 양수인 양수" },
    }
}

messages! {
    /// Why a structure has no place in a ranking.
    pub(crate) enum NoPlace in "portfolio.no-place" {
        AllFallAlone => {
            en: "every sample of it falls under its own weight: it has no capacity against shaking",
            ko: "모든 표본이 자중으로 쓰러지므로 지진에 대한 내력이 없다",
        },
        TooFewMotions => {
            en: "nothing is known of this state: too few motions that can be used",
            ko: "쓸 수 있는 지반운동이 너무 적어 이 손상상태의 내력을 알 수 없다",
        },
        NothingKnown { state: Both } => {
            en: "a structure of its kind has no {state}; known of it: nothing. Rank such structures with --state falls",
            ko: "이 종류의 구조물에는 손상상태 ‘{state}’이(가) 없고 알려진 내력도 없다. 이런 구조물은 --state falls로 순위를 매긴다",
        },
        NoSuchState { state: Both, known: Both } => {
            en: "a structure of its kind has no {state}; known of it: {known}. Rank such structures with --state falls",
            ko: "이 종류의 구조물에는 손상상태 ‘{state}’이(가) 없다. 알려진 내력: {known}. 이런 구조물은 --state falls로 순위를 매긴다",
        },
    }
}
