//! The words of all figures: names of axes, titles, legends.

use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence, Template, messages};

/// The words in a language.
pub(crate) fn say(words: impl Into<Sentence>, language: Language) -> String {
    words.into().text(language)
}

messages! {
    /// Heads of the columns of a figure's numbers.
    pub(crate) enum Columns in "figure.column" {
        Axis { axis: Both } => { en: "{axis}", ko: "{axis}" },
        Of { axis: Both, line: Both } => { en: "{axis}: {line}", ko: "{axis}: {line}" },
        Part => { en: "Part", ko: "부재" },
        From => { en: "From", ko: "시작" },
        To => { en: "To", ko: "끝" },
    }
}

messages! {
    /// Names of axes with their units.
    pub(crate) enum Axes in "figure.axis" {
        LoadFactor => { en: "Load factor λ (–)", ko: "하중배율 λ (–)" },
        Samples => { en: "Samples (–)", ko: "표본 수 (–)" },
        FactorAndMargins => { en: "Load factor λ and margins k/k_min (–)", ko: "하중배율 λ 및 여유도 k/k_min (–)" },
        Acceleration => { en: "Acceleration (g)", ko: "가속도 (g)" },
        Displacement => { en: "Displacement (mm)", ko: "변위 (mm)" },
        Rotation => { en: "Rotation (mrad)", ko: "회전 (mrad)" },
        BaseShear => { en: "Base shear (kN)", ko: "밑면전단력 (kN)" },
        Stroke => { en: "Stroke (mm)", ko: "행정 (mm)" },
        Height => { en: "Height (m)", ko: "높이 (m)" },
        RotationalStiffness => { en: "Rotational stiffness", ko: "회전강성" },
        ChangeOfTheLimit => { en: "Change of the limit (%)", ko: "한계값의 변화 (%)" },
        RotationAcrossTheJoint => { en: "Rotation across the joint (mrad)", ko: "접합면 회전각 (mrad)" },
        Moment => { en: "Moment (kN·m)", ko: "모멘트 (kN·m)" },
        Energy => { en: "Energy (kJ)", ko: "에너지 (kJ)" },
        ChangeOfTheFrequency => { en: "Change of the frequency (%)", ko: "고유진동수의 변화 (%)" },
        Period => { en: "Period (s)", ko: "주기 (s)" },
        SpectralAcceleration => { en: "Spectral acceleration (g)", ko: "응답 가속도 (g)" },
        PeakGroundAcceleration => { en: "Peak ground acceleration (g)", ko: "최대지반가속도 (g)" },
        Probability => { en: "Probability", ko: "확률" },
        Drift => { en: "Drift (mm)", ko: "층간변위 (mm)" },
        ForceOfTheStorey => { en: "Force of the storey (kN)", ko: "층 전단력 (kN)" },
        Time => { en: "Time (s)", ko: "시간 (s)" },
        Frequency => { en: "Frequency (Hz)", ko: "진동수 (Hz)" },
        SingularValue => { en: "Singular value (dB)", ko: "특이값 (dB)" },
        ModelOrder => { en: "Model order (–)", ko: "모델 차수 (–)" },
        ShapeComponent => { en: "Shape component (–)", ko: "모드형상 성분 (–)" },
        Velocity => { en: "Velocity (m/s)", ko: "속도 (m/s)" },
        PseudoAcceleration => { en: "Pseudo-acceleration (g)", ko: "의사 가속도 (g)" },
        MedianCapacity => { en: "Peak ground acceleration at which half of the motions reach the state (g)", ko: "입력지진의 절반이 이 상태에 이르는 최대지반가속도 (g)" },
        AccelerationAlongX => { en: "Acceleration along x (g)", ko: "x 방향 가속도 (g)" },
        AccelerationAlongY => { en: "Acceleration along y (g)", ko: "y 방향 가속도 (g)" },
        Opening => { en: "Opening (mm)", ko: "벌어짐 (mm)" },
        Slip => { en: "Slip (mm)", ko: "미끄러짐 (mm)" },
        Yaw => { en: "Yaw (mrad)", ko: "수평 회전 (mrad)" },
        WidthOverHeight => { en: "B/H of what stands on the joint (–)", ko: "접합면 상부의 폭/높이 비 B/H (–)" },
        FirstFall => { en: "First fall: peak ground acceleration (g)", ko: "최초 낙하: 최대지반가속도 (g)" },
        FirstOverturning => { en: "First fall: peak ground acceleration (g)", ko: "최초 전도: 최대지반가속도 (g)" },
        DriftLimit => { en: "Drift limit: peak ground acceleration (g)", ko: "층간변위 한계: 최대지반가속도 (g)" },
        ApparentFrequency => { en: "Apparent frequency (Hz)", ko: "겉보기 진동수 (Hz)" },
        EquivalentDamping => { en: "Equivalent damping (%)", ko: "등가감쇠비 (%)" },
        FrequencyOfTheGround => { en: "Frequency of the ground (Hz)", ko: "지반 진동수 (Hz)" },
        AccelerationOfTheGround => { en: "Acceleration of the ground (g)", ko: "지반 가속도 (g)" },
        AmplitudeAtTheTop => { en: "Amplitude at the top (mm)", ko: "상단 진폭 (mm)" },
        XOfTheDamper => { en: "x of the damper (m)", ko: "제진장치의 x 위치 (m)" },
        YOfTheDamper => { en: "y of the damper (m)", ko: "제진장치의 y 위치 (m)" },
        PlaceOfDamperAcross => { en: "Place of the damper across its direction (m)", ko: "진동 방향에 직각인 제진장치 위치 (m)" },
        OffBy => { en: "Off by (%)", ko: "오차 (%)" },
        LinkRotation => { en: "Rotation (mrad)", ko: "회전각 (mrad)" },
        GroundDisplacement => { en: "Displacement (m)", ko: "변위 (m)" },
        RmsRatio => { en: "RMS over that without a damper", ko: "비제어 대비 RMS 비" },
        GoalRatio => { en: "Goal over that without a damper", ko: "목표값의 비제어 대비 비" },
        FactorOnSprings => { en: "Factor on the springs of the file (–)", ko: "파일의 접합부 강성에 대한 배율 (–)" },
        FirstMotion => { en: "Horizontal acceleration of first motion (g)", ko: "거동 시작 수평가속도 (g)" },
        Logarithmic { name: String } => { en: "{name}, log scale", ko: "{name}, 로그 눈금" },
    }
}

messages! {
    /// What a reader who cannot see a figure is told.
    pub(crate) enum Titles in "figure.title" {
        DistributionOfTheLoadFactor => { en: "Distribution of the load factor", ko: "하중배율의 분포" },
        VariantsCompared => { en: "Variants compared", ko: "대안 비교" },
        PlanModes => { en: "How the floor moves in each mode", ko: "모드별 바닥의 움직임" },
        PlanWithTheCentresOfTheModes => { en: "Plan with the centres of the modes", ko: "모드 중심을 표시한 평면도" },
        AccelerationOfTheGround => { en: "Acceleration of the ground", ko: "지반 가속도" },
        RotationOfTheTopFloor => { en: "Rotation of the top floor", ko: "최상층의 회전" },
        BaseShear => { en: "Base shear", ko: "밑면전단력" },
        TravelOfTheDampers => { en: "Travel of the dampers", ko: "제진장치의 행정" },
        ElevationOfTheChainWithItsJoints => { en: "Elevation of the chain with its joints", ko: "접합면을 표시한 입면도" },
        MomentsOfTheJoints => { en: "Moments of the joints and what the beds pass", ko: "접합면 모멘트와 한계" },
        StiffnessLimitsOfEachJoint => { en: "Stiffness limits of each joint", ko: "접합면별 강성 한계" },
        EffectOfALowerCentreOfMass => { en: "Effect of a lower centre of mass", ko: "무게 중심을 낮춘 효과" },
        RotationOfTheLinksFromTheVertical => { en: "Rotation of the links from the vertical", ko: "각 부재의 연직 기준 회전각" },
        MomentAgainstRotation => { en: "Moment against rotation", ko: "모멘트-회전각 이력곡선" },
        WhereTheEnergyWent => { en: "Where the energy went", ko: "에너지 수지" },
        YearsOfAStructure => { en: "A structure over the years", ko: "여러 해에 걸친 구조물의 변화" },
        WhatChangedBetweenTwoSurveys => { en: "What changed between two surveys", ko: "두 조사 사이의 변화" },
        DesignSpectrum => { en: "Design spectrum", ko: "설계 응답 스펙트럼" },
        Fragility => { en: "Fragility", ko: "취약도" },
        SketchOfTheFrame => { en: "Sketch of the frame", ko: "골조 모식도" },
        DisplacementAtTheTopOfEachStorey => { en: "Displacement at the top of each storey", ko: "각 층 상단의 변위" },
        ForceOfColumns => { en: "Force of free-standing columns against drift", ko: "자립 기둥의 복원력-층간변위 곡선" },
        ForceAgainstDrift => { en: "Force against drift", ko: "층 전단력-층간변위 이력곡선" },
        StabilisationDiagram => { en: "Stabilisation diagram", ko: "안정화 선도" },
        ModeShapesInPlan => { en: "Mode shapes in plan", ko: "평면상의 모드형상" },
        ModeShapesByChannel => { en: "Mode shapes by channel", ko: "채널별 모드형상" },
        VelocityOfTheGround => { en: "Velocity of the ground", ko: "지반 속도" },
        DisplacementOfTheGround => { en: "Displacement of the ground", ko: "지반 변위" },
        ModeShapesMoving => { en: "Mode shapes, moving", ko: "움직이는 모드형상" },
        StructuresRanked => { en: "Structures ranked", ko: "구조물 순위" },
        ModeShapesWithFrequencies => { en: "Mode shapes with frequencies", ko: "모드형상과 고유진동수" },
        TheStack => { en: "The stack", ko: "적층 구조" },
        TheStackAfterTheMotion => { en: "The stack after the motion", ko: "지반운동 이후의 적층 구조" },
        LimitsByDirection => { en: "Limits by direction", ko: "방향별 한계" },
        DisplacementOfTheHighestStone => { en: "Displacement of the highest stone", ko: "최상부 부재의 변위" },
        OpeningOfTheJoints => { en: "Opening of the joints", ko: "접합면의 벌어짐" },
        SlipOfTheJoints => { en: "Slip of the joints", ko: "접합면의 미끄러짐" },
        YawOfTheJoints => { en: "Yaw of the joints", ko: "접합면의 수평 회전" },
        FactorsOfTheJoints => { en: "Factors on the springs of the joints", ko: "접합면별 강성 배율" },
        WhatGovernsEachJoint => { en: "What governs each joint", ko: "접합면별 지배 거동" },
        CapacityOfEachJoint => { en: "Capacity of each joint", ko: "접합면별 저항 가속도" },
        CapacityAgainstAnInput => { en: "Capacity against an input", ko: "입력변수에 따른 내진성능" },
        WhatFellAndWhatSurvived => { en: "What fell and what survived", ko: "낙하 발생과 미발생" },
        MotionByPlace => { en: "Motion of the points against the place of the damper", ko: "제진장치 위치에 따른 관측점의 RMS" },
        DamperByPlace => { en: "What a damper does at each place of the floor, tuned best there", ko: "평면 위치별 제어 효과(위치마다 최적 동조)" },
        WhatBeingOutOfTuneCosts => { en: "What being out of tune costs", ko: "동조 오차에 따른 제어 효과" },
        WhenJointsOpen => { en: "When the joint below each link was open", ko: "부재 아래 접합면이 벌어진 시각" },
        WhenJointsTurned => { en: "When the joint below each link turned against its friction", ko: "부재 아래 접합면이 마찰을 이기고 회전한 시각" },
        WhenEachStoreySlipped => { en: "When each storey slipped", ko: "층별 미끄러짐 시각" },
        SingularValues => { en: "Singular values of the spectral matrix", ko: "스펙트럼 행렬의 특이값" },
        TopFloorAlong { axis: String } => { en: "Displacement of the top floor along {axis}", ko: "최상층의 {axis} 방향 변위" },
        DisplacementOfPoint { name: String } => { en: "Displacement of point {name}", ko: "{name} 지점의 변위" },
        AccelerationOfPoint { name: String } => { en: "Acceleration of point {name}, with that of the ground", ko: "{name} 지점의 절대가속도와 지반 가속도" },
        ResponseSpectrum { percent: String } => { en: "Response spectrum, damping {percent} %", ko: "응답 스펙트럼, 감쇠비 {percent} %" },
        SlippingShare => { en: "Share of the time in which a storey slips", ko: "미끄러짐 시간 비율" },
        MovingShare => { en: "Share of the time in which a joint is open or slips", ko: "접합면 벌어짐·미끄러짐 시간 비율" },
    }
}

messages! {
    /// Legends of the factors on the springs of joints.
    pub(crate) enum Factors in "figure.factors" {
        Common => { en: "common factor", ko: "공통 배율" },
        Range => { en: "range (95 %)", ko: "범위 (95 %)" },
        NotSeen => { en: "not seen", ko: "알 수 없음" },
        Least => { en: "least", ko: "최소" },
        Best => { en: "best", ko: "최적" },
    }
}

messages! {
    /// Legends and words in the figures of a structure.
    pub(crate) enum Signs in "figure.sign" {
        ColumnsAlone => { en: "columns", ko: "기둥" },
        SpringsBeside => { en: "joints and walls, linear", ko: "접합부·벽체(선형)" },
        ColumnsAndSprings => { en: "both", ko: "합계" },
        FeetLiftOff => { en: "feet lift off", ko: "주각 들림 시작" },
        GreatestForce => { en: "greatest force", ko: "최대 복원력" },
        ColumnsFall => { en: "columns fall", ko: "기둥 전도" },
        Nominal => { en: "nominal", ko: "기준값" },
        FactorOneFalls => { en: "λ = 1: falls", ko: "λ = 1: 전도" },
        BelowItMarginal => { en: "below it marginal", ko: "미만이면 여유 부족" },
        Samples => { en: "samples", ko: "표본" },
        Interval => { en: "interval", ko: "신뢰구간" },
        Unknown => { en: "unknown", ko: "판정 불가" },
        StiffnessUnknown => { en: "unknown", ko: "미상" },
        FactorByVerdict => { en: "λ (coloured by verdict)", ko: "λ (판정별 색)" },
        MarginsOfJointsOrStoreys => { en: "margins of joints or storeys", ko: "접합면·층의 여유도" },
        OneFalls => { en: "1: falls", ko: "1: 전도" },
        CentreOfMass => { en: "centre of mass", ko: "질량 중심" },
        CentreOfRigidity => { en: "centre of rigidity", ko: "강성 중심" },
        NoCentre => { en: "no centre: it does not turn", ko: "중심 없음: 비틀림이 없다" },
        Damper => { en: "damper", ko: "제진장치" },
        WithDampers => { en: "with dampers", ko: "제진장치 있음" },
        WithoutDampers => { en: "without dampers", ko: "제진장치 없음" },
        TopFloor => { en: "top floor", ko: "최상층" },
        JointMargin => { en: "joint: margin k/k_min", ko: "접합면: 여유도 k/k_min" },
        Link => { en: "link", ko: "부재" },
        Falls => { en: "falls", ko: "전도" },
        ToScale => { en: "⊕ centre of mass; heights and widths to scale", ko: "⊕ 무게 중심; 높이와 폭은 축척에 맞음" },
        HeightsToScaleWidthsSchematic => { en: "⊕ centre of mass; heights to scale, widths schematic", ko: "⊕ 무게 중심; 높이는 축척에 맞고 폭은 모식도" },
        Joint => { en: "joint", ko: "접합면" },
        Open => { en: "open", ko: "벌어짐" },
        Turns => { en: "turns", ko: "회전" },
        PutIn => { en: "put in", ko: "입력" },
        TakenByDashpots => { en: "taken by dashpots", ko: "점성 소산" },
        MovingSpringsAndWeight => { en: "moving, in springs and weight", ko: "운동·탄성·위치" },
        TakenByFriction => { en: "taken by friction", ko: "마찰 소산" },
        BeginsToMove => { en: "begins to move", ko: "거동 시작" },
        Storey => { en: "storey", ko: "층" },
        AxialForce => { en: "axial force", ko: "축력" },
        Margin => { en: "margin k/k_min", ko: "여유도 k/k_min" },
        HeightsToScale => { en: "heights to scale", ko: "높이는 축척에 맞음" },
        MovingAndInSprings => { en: "moving and in springs", ko: "운동·탄성" },
        Slips => { en: "slips", ko: "미끄러짐" },
        AtTheEndTrueScale => { en: "at the end, true scale", ko: "종료 시점, 실제 축척" },
        PeakOpeningAndSlip => { en: "peak opening and slip, mm", ko: "최대 벌어짐·미끄러짐 (mm)" },
        LargerOfBoth => { en: "joints, larger of both:", ko: "접합면 (둘 중 큰 값):" },
        Rocks => { en: "rocks", ko: "로킹" },
        Slides => { en: "slides", ko: "미끄러짐" },
        FirstOfAll => { en: "first of all", ko: "최초 거동" },
        RocksOnSlope => { en: "rocks: a/g = B/H", ko: "로킹: a/g = B/H" },
        SlidesOnLevel => { en: "slides: a/g = μ", ko: "미끄러짐: a/g = μ" },
        TopFloorWallsBelowIt => { en: "top floor, walls below it", ko: "최상층 바닥과 그 아래 벽체" },
        FallsWhateverTheOthersAre => { en: "falls whatever the other joints are", ko: "다른 접합면과 무관하게 전도" },
        LeastStiffness => { en: "least k, other joints as given", ko: "최소 k (다른 접합면은 주어진 값)" },
        BedLimit => { en: "limit of the bed", ko: "접합면 한계" },
        MomentUpright => { en: "moment upright", ko: "모멘트(연직)" },
        MomentLeaning => { en: "moment leaning, with the tilt", ko: "모멘트(변형 후, 기울기 포함)" },
        GivenStiffness => { en: "given k", ko: "주어진 강성 k" },
        PublishedLimit => { en: "published k_cr", ko: "발표된 k_cr" },
        ExactLimit => { en: "exact limit M", ko: "정확한 한계 M" },
        Demand => { en: "demand of the site", ko: "부지의 설계 요구" },
        ModeOfNumber { number: usize } => { en: "mode {number}", ko: "{number}차 모드" },
        Floor { floor: usize } => { en: "floor {floor}", ko: "{floor}층" },
        DemandAtDamping { percent: String } => { en: "demand of the site, {percent} % damping", ko: "부지의 설계 요구, 감쇠비 {percent} %" },
        DisplacementsEnlarged { times: String } => { en: "residual displacements × {times}", ko: "잔류 변위 {times}배 확대" },
        OpeningAndSlip { opening: String, slip: String } => { en: "opening {opening}, slip {slip}", ko: "벌어짐 {opening}, 미끄러짐 {slip}" },
        Ground => { en: "the ground", ko: "지반" },
        PublishedLimitUnsafe => { en: "published k_cr (unsafe)", ko: "발표된 임계강성 k_cr (불안전측)" },
        ExactLimitOthersRigid => { en: "exact limit M, other joints rigid", ko: "정확한 한계 M (다른 접합면 강체)" },
        PublishedBuckling => { en: "published P·H", ko: "발표된 좌굴 임계강성 P·H" },
    }
}

messages! {
    /// What the ground does, in the figures of a stack.
    pub(crate) enum Shaken in "figure.shaking" {
        Site { peak: String } => { en: "peak that the site demands: {peak}", ko: "부지의 설계 최대지반가속도: {peak}" },
        WithVertical { peak: String } => { en: "the same with its vertical shaking: {peak}", ko: "수직 지진동을 함께 고려: {peak}" },
        ByModes { peak: String } => { en: "on elastic joints, weakest joint: {peak}", ko: "탄성 접합면의 증폭 고려(최약 접합면): {peak}" },
        BeyondTheAxis { level: String } => { en: "Beyond the axis, {level}", ko: "축 범위 밖, {level}" },
        Motion { peak: String } => { en: "peak of the motion that was run: {peak}", ko: "해석한 지반운동의 최댓값: {peak}" },
    }
}

messages! {
    /// Legends and words in the figures of measured modes.
    pub(crate) enum Modal in "figure.modes" {
        Mode => { en: "mode", ko: "모드" },
        SingularValue => { en: "singular value", ko: "특이값" },
        StablePole => { en: "stable pole", ko: "안정 극점" },
        DampingOrShapeChanges => { en: "damping or shape changes", ko: "감쇠비·모드형상 변동" },
        FrequencyChanges => { en: "frequency changes", ko: "진동수 변동" },
        ImpossiblePole => { en: "damping, complexity or scatter impossible", ko: "감쇠비·복소성·산포 부적합" },
        FirstSingularValue => { en: "first singular value (dB, own scale)", ko: "첫째 특이값 (dB, 별도 축척)" },
        PlanSensorsOver => { en: "plan, sensors over", ko: "평면, 센서 범위" },
        ChosenMode => { en: "chosen mode ± sd", ko: "선정된 모드 ± 표준편차" },
        NegativeModeFalls => { en: "falls (ω² ≤ 0)", ko: "전도 (ω² ≤ 0)" },
        ChangedBeyondChance => { en: "changed beyond chance", ko: "유의한 변화" },
        NoChangeShown => { en: "no change shown", ko: "변화가 확인되지 않음" },
        SmallerChangesMissed => { en: "smaller changes could be missed", ko: "놓칠 수 있는 작은 변화" },
    }
}

messages! {
    /// Legends and words in the figures of studies, rankings and tuning.
    pub(crate) enum Studied in "figure.study" {
        CurvesBandsDots => { en: "Lines: lognormal curves of largest likelihood; bands: 90 % of resampled motions; dots: share of the scans that had reached the state by then", ko: "실선: 최우추정 대수정규 곡선, 띠: 지진동 재표집의 90 %, 점: 그때까지 해당 상태에 이른 해석의 비율" },
        NoBand => { en: "No band: more than a tenth of the resampled motions allow no curve", ko: "띠 없음: 재표집의 1/10 넘게 곡선을 정할 수 없음" },
        Bound => { en: "a bound: it lies further out", ko: "한계값: 실제는 그 바깥" },
        NinetyPercentLines => { en: "Lines: 90 % of what is not known of the median", ko: "선: 중앙값의 90 % 불확실 구간" },
        Variant => { en: "variant", ko: "대안" },
        NothingIsVaried => { en: "nothing is varied", ko: "변수 없음" },
        OneScan => { en: "one scan", ko: "해석 1건" },
        Median => { en: "median", ko: "중앙값" },
        FiveToNinetyFive => { en: "5 to 95 %", ko: "5–95 %" },
        NothingMoved => { en: "nothing moved", ko: "움직임 없음" },
        Fell => { en: "fell", ko: "낙하" },
        NoJointMoved => { en: "no joint moved", ko: "접합면 움직임 없음" },
        JointsOpenedOrSlipped => { en: "joints opened or slipped", ko: "접합면 벌어짐·미끄러짐" },
        FellOver => { en: "fell", ko: "전도" },
        Stuck => { en: "stuck", ko: "고착" },
        Slipped => { en: "slipped", ko: "미끄러짐" },
        BeyondTheDriftLimit => { en: "beyond the drift limit", ko: "층간변위 한계 초과" },
        BelowEveryLimit => { en: "below every limit", ko: "모든 한계 이내" },
        LimitsOneAndTwo => { en: "limits 1, 2", ko: "한계 1, 2 초과" },
        LimitThree => { en: "limit 3", ko: "한계 3 초과" },
        LimitFour => { en: "limit 4", ko: "한계 4 초과" },
        NoResult => { en: "no result", ko: "결과 없음" },
        NotSteady => { en: "not steady", ko: "정상상태에 이르지 않음" },
        MedianWithSpread => { en: "median; 16 % and 84 %", ko: "중앙값, 16 %와 84 %" },
        Release => { en: "release", ko: "자유진동" },
        TunedAsInTheFile => { en: "tuned as in the file", ko: "입력한 동조" },
        TunedBestAtEachPlace => { en: "tuned best at each place", ko: "위치마다 최적 동조" },
        AsInTheFile => { en: "as in the file", ko: "입력한 위치" },
        TheRule => { en: "the rule", ko: "논문의 규칙" },
        PlacedAndTunedBest => { en: "placed and tuned best", ko: "최적 위치와 동조" },
        AsInTheFileDamper => { en: "as in the file", ko: "입력한 제진장치" },
        FrequencyOff => { en: "frequency off", ko: "진동수 오차" },
        DampingOff => { en: "damping off", ko: "감쇠 오차" },
        Unusable => { en: "unusable: somewhere here", ko: "사용 불가: 이 범위" },
        NotReached => { en: "not up to the largest tried", ko: "최대 입력까지 낙하 없음" },
        OwnStudy { state: String } => { en: "{state}, own study", ko: "{state}, 개별 해석" },
        OfScore { state: String } => { en: "{state}, score", ko: "{state}, 점수" },
        NotDrawn { later: usize, without: usize } => { en: "Not drawn: {later} of later places, {without} without a place", ko: "그림에 없는 구조물: 뒤 순위 {later}기, 순위 없음 {without}기" },
        CentreOfMode { number: usize } => { en: "centre of mode {number}", ko: "{number}차 모드 중심" },
        CentreOffTheFloor { number: usize, x: String } => { en: "centre of mode {number}: x = {x} m, off the floor", ko: "{number}차 모드 중심: x = {x} m (평면 밖)" },
        WhiteStuck => { en: "white: stuck", ko: "흰색: 고착" },
        SlipsUpToFive => { en: "slips, up to 5 %", ko: "미끄러짐 5 % 이하" },
        AtDriftLimit => { en: "drift limit", ko: "층간변위 한계" },
        WhiteClosed => { en: "white: closed and stuck", ko: "흰색: 닫힘·고착" },
        MovesUpToFive => { en: "opens or slips, up to 5 %", ko: "벌어짐·미끄러짐 5 % 이하" },
    }
}

messages! {
    /// Axes of what grows with the shaking in a study.
    pub(crate) enum Growth in "figure.growth" {
        RockingRatio => { en: "Rocking of a joint over its slenderness angle (–)", ko: "접합면 로킹각 / 세장각 (–)" },
        ResidualSlip => { en: "Residual slip (% of the width of the joint)", ko: "잔류 미끄러짐 (접합면 폭의 %)" },
        PeakDrift => { en: "Largest drift (mm)", ko: "최대 층간변위 (mm)" },
        SlippingTime => { en: "Time in which a storey slips (%)", ko: "미끄러짐 시간 비율 (%)" },
        ResidualDrift => { en: "Residual drift (mm)", ko: "잔류 층간변위 (mm)" },
        TopDisplacement => { en: "Displacement of the top (mm)", ko: "최상단 변위 (mm)" },
        JointRotation => { en: "Largest rotation across a joint (mrad)", ko: "접합면 최대 회전각 (mrad)" },
        OpenTime => { en: "Time in which a joint is open (%)", ko: "접합면 벌어짐 시간 비율 (%)" },
        DriftRatio => { en: "Largest drift (% of the height)", ko: "최대 층간변위 (층고의 %)" },
        Stroke => { en: "Stroke of the dampers (mm)", ko: "제진장치 행정 (mm)" },
    }
}

/// The words of figures as they are written.
pub(crate) const TEMPLATES: [&[Template]; 9] = [
    Factors::TEMPLATES,
    Columns::TEMPLATES,
    Axes::TEMPLATES,
    Titles::TEMPLATES,
    Signs::TEMPLATES,
    Shaken::TEMPLATES,
    Modal::TEMPLATES,
    Studied::TEMPLATES,
    Growth::TEMPLATES,
];
