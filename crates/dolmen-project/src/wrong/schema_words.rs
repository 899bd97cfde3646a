//! What keys mean, and what values may be: the words of the schema, with their Korean.

use dolmen_words::message::Both;
use dolmen_words::{Template, messages};

messages! {
    /// What the needed keys of structures mean.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum Meaning in "project.meaning" {
        Version => { en: "Version of the file format: 1.", ko: "파일 형식의 버전이다. 1" },
        Kind => { en: "What the file models.", ko: "파일이 다루는 구조의 종류" },
        Named => {
            en: "Name of the structure: text, or {{ en = \"…\", ko = \"…\" }}.",
            ko: "구조물의 이름. 문자열 또는 {{ en = \"…\", ko = \"…\" }}",
        },
        Value => { en: "The number, bare or as text with its unit.", ko: "수 또는 단위를 붙인 문자열" },
        JointToJoint => { en: "Length from joint to joint.", ko: "접합부 사이의 길이" },
        Centroid => {
            en: "Height of the centre of mass above the link's lower joint.",
            ko: "부재 하단 접합부에서 잰 무게중심 높이",
        },
        RotationalStiffness => { en: "Rotational stiffness.", ko: "회전강성" },
        YoungsModulus => { en: "Young's modulus: a stress.", ko: "탄성계수(응력 단위)" },
        PoissonsRatio => { en: "Poisson's ratio, 0 to 0.5.", ko: "푸아송비, 0~0.5" },
        LinkDensity => {
            en: "Density: with the weight of a link it gives its volume.",
            ko: "밀도. 부재의 무게로 부피를 구한다",
        },
        SoilModulus => {
            en: "Shear modulus: density times the square of the shear wave velocity.",
            ko: "전단탄성계수. 밀도와 전단파속도 제곱의 곱",
        },
        ColumnHeight => { en: "Column height.", ko: "기둥 높이" },
        LateralStiffness => {
            en: "Lateral stiffness of each storey, lowest first, \"unknown\", or \"identified\" from the modes of a survey.",
            ko: "각 층의 횡강성을 아래에서부터, \"unknown\", 또는 조사의 모드에서 구하는 \"identified\"",
        },
        UniqueName => { en: "What people call it; unique in the stack.", ko: "부재의 이름. 서로 달라야 한다" },
        AlongX => { en: "Along x.", ko: "x 방향의 크기" },
        Upwards => { en: "Upwards.", ko: "높이" },
        FloorCentre => {
            en: "The centre of its floor, [x, y, z] from the centre of the block's base, along the block's own sides.",
            ko: "바닥의 중심. 부재 밑면 중심에서 부재의 변을 따라 잰 [x, y, z]",
        },
        Storeys => { en: "Storeys, 1 to 13.", ko: "층수. 1~13" },
        BodyHeight => { en: "Height of all storeys, without the base.", ko: "기단을 뺀 전체 층의 높이" },
        Span => { en: "Clear span of the inner line at the springing.", ko: "홍예 안쪽의 순경간" },
        RingThickness => { en: "Thickness of the ring, along the joints.", ko: "접합면을 따라 잰 홍예의 두께" },
        AlongY => { en: "Along y.", ko: "y 방향의 크기" },
        Voussoirs => {
            en: "Number of voussoirs, 2 to 400; an odd number has a keystone.",
            ko: "홍예석의 수. 2~400, 홀수이면 이맛돌이 있다",
        },
        Courses => { en: "Number of courses, 1 to 100.", ko: "켜의 수. 1~100" },
        CourseHeight => { en: "Height of a course.", ko: "한 켜의 높이" },
        StoneLength => { en: "Length of a whole stone.", ko: "온장 석재의 길이" },
        OneBlock => { en: "One block, or \"ground\".", ko: "한쪽 부재 또는 \"ground\"" },
        OtherBlock => { en: "The other block.", ko: "다른 쪽 부재" },
        Differs => { en: "What differs in it.", ko: "달라지는 물성" },
        Crosses => {
            en: "Where it crosses the joint: [x, y, z], z up from the ground.",
            ko: "접합면을 지나는 점 [x, y, z]. z는 지반에서 위로 잰다",
        },
        TieStiffness => {
            en: "Stiffness across its axis, a force per length.",
            ko: "축에 직각인 방향의 강성(단위길이당 힘)",
        },
        TieStrength => { en: "Shear at which it breaks, a force.", ko: "파단 전단력" },
        Block => { en: "The block.", ko: "부재" },
        Meets => {
            en: "Point of the block that meets it: [x, y, z], z up from the ground.",
            ko: "부재가 닿는 점 [x, y, z]. z는 지반에서 위로 잰다",
        },
        MeetsAlong => { en: "Direction in which the block must move to meet it.", ko: "부재가 움직여 닿는 방향" },
        OnceMet => { en: "Stiffness once met, a force per length.", ko: "닿은 뒤의 강성(단위길이당 힘)" },
        StoreyBelow => { en: "Height of the storey below it.", ko: "아래층의 층고" },
        InPlan => { en: "Its place in plan.", ko: "평면상 위치" },
        Rigidity => {
            en: "Centre of rigidity in plan, [x, y]; of a matrix the point that it is about.",
            ko: "평면상 강성중심 [x, y]. matrix이면 그 기준점",
        },
        TheFrequency => { en: "The frequency.", ko: "진동수" },
        DampingThere => { en: "The damping ratio there.", ko: "그 진동수의 감쇠비" },
        DamperKind => {
            en: "\"tmd\", \"tlcd\", \"tlcmd\" or \"link\".",
            ko: "\"tmd\", \"tlcd\", \"tlcmd\" 또는 \"link\"",
        },
        ItsFloor => { en: "Its floor, from 1 at the bottom.", ko: "설치한 층. 최하층이 1" },
        InPlanXY => { en: "Its place in plan, [x, y].", ko: "평면상 위치 [x, y]" },
        Way => {
            en: "\"x\", \"y\", or an angle from x (\"30 deg\").",
            ko: "\"x\", \"y\" 또는 x축에서 잰 각도(\"30 deg\")",
        },
        Share => { en: "Its part of the damper's mass.", ko: "감쇠기 질량 중의 비율" },
        Called => { en: "What it is called.", ko: "이름" },
    }
}

messages! {
    /// What the needed keys of sites, loads, studies, surveys and reports mean.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum OtherMeaning in "project.meaning.other" {
        Peaks => {
            en: "Peak accelerations of the ground, rising, with their unit: [\"0.06 g\", \"0.11 g\"].",
            ko: "지반의 최대가속도를 작은 값부터 단위와 함께: [\"0.06 g\", \"0.11 g\"]",
        },
        ReturnPeriods => { en: "Their return periods.", ko: "재현주기" },
        ForceCoefficient => {
            en: "Force coefficient of the parts: square prism 2.0, octagon 1.3 to 1.45, circle 0.7 to 1.2.",
            ko: "부재의 풍력계수. 정사각기둥 2.0, 팔각기둥 1.3~1.45, 원기둥 0.7~1.2",
        },
        PartNamed => { en: "The part, by its name or as \"links[2]\".", ko: "부재의 이름 또는 \"links[2]\"" },
        Area => {
            en: "Area across the wind, m2 where it is a bare number. Without height it takes the place of the part's own area, spread along it.",
            ko: "바람에 직각인 면적. 단위 없는 수는 m2이다. height가 없으면 부재의 면적을 대신하여 부재를 따라 고르게 작용한다",
        },
        What => { en: "What it is.", ko: "무엇인지" },
        ActsOn => {
            en: "The part that it acts on, by its name or as \"links[2]\".",
            ko: "하중을 받는 부재의 이름 또는 \"links[2]\"",
        },
        HowMany => { en: "How many, 1 to 1000.", ko: "개수. 1~1000" },
        First => { en: "The first.", ko: "첫 값" },
        Last => { en: "The last.", ko: "마지막 값" },
        BothCounted => { en: "How many, both counted.", ko: "양끝을 포함한 개수" },
        VariedPath => { en: "Path of a varied input.", ko: "변화시키는 입력의 경로" },
        Trend => { en: "Which way the capacity goes as it grows.", ko: "그 값이 커질 때 내력이 변하는 방향" },
        Frequencies => {
            en: "Frequencies, a list or {{ from, to, steps }}.",
            ko: "진동수. 목록 또는 {{ from, to, steps }}",
        },
        Amplitudes => {
            en: "Amplitudes of the acceleration, with their unit, a list or {{ from, to, steps }}.",
            ko: "가속도 진폭을 단위와 함께. 목록 또는 {{ from, to, steps }}",
        },
        Frequency => { en: "Frequency.", ko: "진동수" },
        PointHeight => { en: "Height above the ground (lowest joint).", ko: "지반(가장 아래 접합부)에서 잰 높이" },
        Displacement => {
            en: "Displacement, any scale that all points of the mode share.",
            ko: "모드의 변위. 모든 점에 같은 배율이면 된다",
        },
        File => { en: "Path relative to the project file.", ko: "프로젝트 파일에서 본 상대 경로" },
        Column => { en: "Its column.", ko: "열" },
        FromS => { en: "From, s after the first sample.", ko: "시작. 첫 표본 이후의 초" },
        ToS => { en: "To, s after the first sample.", ko: "끝. 첫 표본 이후의 초" },
        LowerCorner => { en: "Lower corner, Hz.", ko: "하한 차단 주파수(Hz)" },
        UpperCorner => { en: "Upper corner, Hz.", ko: "상한 차단 주파수(Hz)" },
        Corner => { en: "Corner, Hz.", ko: "차단 주파수(Hz)" },
        PartByName => { en: "The part, by its name.", ko: "부재의 이름" },
        Damage => {
            en: "What it is: \"crack\", \"spalling\", \"exfoliation\", \"open joint\", \"tilt\", \"settlement\", \"loss\", \"growth\" (균열, 박락, 박리, 이격, 기울기, 침하, 결손, 생물 피복), or other words.",
            ko: "손상의 종류. \"crack\", \"spalling\", \"exfoliation\", \"open joint\", \"tilt\", \"settlement\", \"loss\", \"growth\"(균열, 박락, 박리, 이격, 기울기, 침하, 결손, 생물 피복) 또는 다른 말",
        },
        Name => { en: "Name.", ko: "이름" },
        Photo => { en: "JPEG or PNG, relative to the project file.", ko: "JPEG 또는 PNG. 프로젝트 파일에서 본 상대 경로" },
        Method => { en: "\"ultrasonic\" or \"rebound\".", ko: "\"ultrasonic\" 또는 \"rebound\"" },
        Sensor => { en: "What it is: \"accelerometer\".", ko: "센서의 종류: \"accelerometer\"" },
        Grade => {
            en: "\"A\" to \"F\" of the Korean periodic inspection, or a word of the scale given.",
            ko: "정기점검의 \"A\"~\"F\" 또는 주어진 등급 체계의 등급",
        },
        Why => { en: "Why.", ko: "이유" },
        When => {
            en: "When: \"2018\", \"2018-05\" or \"2018-05-10\".",
            ko: "시기: \"2018\", \"2018-05\" 또는 \"2018-05-10\"",
        },
        Repairs => {
            en: "Repairs begin a new level; repairs and inspections answer alarms.",
            ko: "보수는 새 기준을 시작하고, 보수와 점검은 경보에 대한 조치가 된다",
        },
    }
}

messages! {
    /// What a value must be, where its type alone does not say it.
    #[allow(dead_code, reason = "they are looked up by their English")]
    pub(crate) enum Needed in "project.needed" {
        DirectionOrVector => {
            en: "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" or three numbers",
            ko: "\"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\" 또는 세 수",
        },
        KoreanSoil => {
            en: "\"S1\" (rock) to \"S5\" (deep and soft)",
            ko: "\"S1\"(암반)~\"S5\"(깊고 연약한 지반)",
        },
        NumbersOrRange => {
            en: "a list of numbers, or {{ from = …, to = …, steps = … }}",
            ko: "수의 목록 또는 {{ from = …, to = …, steps = … }}",
        },
        ListOrUnknown => {
            en: "a list, lowest first, \"unknown\", \"identified\" or {{ source = \"identified\", survey = … }}",
            ko: "아래에서부터 쓴 목록, \"unknown\", \"identified\" 또는 {{ source = \"identified\", survey = … }}",
        },
        NumberOrText => {
            en: "a number, or text with its unit (\"38.95 kN\")",
            ko: "수 또는 단위를 붙인 문자열(\"38.95 kN\")",
        },
        NumberTextOrTable => {
            en: "a number, text with its unit (\"38.95 kN\"), or a table {{ value = …, cov = …, source = … }}",
            ko: "수, 단위를 붙인 문자열(\"38.95 kN\") 또는 표 {{ value = …, cov = …, source = … }}",
        },
        TableOfPaths => {
            en: "a table of paths: {{ \"joint.friction\" = … }}",
            ko: "경로의 표 {{ \"joint.friction\" = … }}",
        },
        WindOrSheltered => {
            en: "a table {{ speed = …, means = \"gust\", force_coefficient = … }}, or \"sheltered\"",
            ko: "표 {{ speed = …, means = \"gust\", force_coefficient = … }} 또는 \"sheltered\"",
        },
        ColumnNameOrNumber => { en: "the column's name, or its number from 1", ko: "열의 이름 또는 1부터 센 번호" },
        BlockNames => {
            en: "the name of a block, a list of names, or \"ground\"",
            ko: "부재의 이름, 이름의 목록 또는 \"ground\"",
        },
    }
}

/// Words of the schema in both languages; English alone where there is no Korean.
pub(crate) fn of_schema(english: &str) -> Both {
    let known = [Meaning::TEMPLATES, OtherMeaning::TEMPLATES, Needed::TEMPLATES];
    let plain = |template: &str| template.replace("{{", "{").replace("}}", "}");
    let found = known
        .into_iter()
        .flatten()
        .find(|known: &&Template| plain(known.english) == english);
    Both {
        english: english.to_owned(),
        korean: found.map_or_else(|| english.to_owned(), |known| plain(known.korean)),
    }
}
