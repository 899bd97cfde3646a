//! Basis and limits of the numbers.

use crate::document::{Block, Document, Equation, Math};
use dolmen_project::{Project, Structure, Survey};
use dolmen_words::{Sentence, messages};

messages! {
    /// Method and limits.
    pub(crate) enum Method in "method" {
        Head => { en: "Method and limits", ko: "방법과 한계" },
        ChainSprings => {
            en: "Rigid links on linear rotational springs, small rotations, static gravity. The chain stands if and only if its stiffness matrix with gravity is positive definite.",
            ko: "강체 부재와 선형 회전 스프링, 미소 회전, 정적 중력을 가정하였다. 중력을 포함한 강성행렬이 양정부호이면 안정하고, 아니면 불안정하다.",
        },
        ChainFactor => {
            en: "λ is the smallest factor on gravity that makes this matrix singular. The margin of a joint is its stiffness over the least one at which the chain stands, the other joints as they are.",
            ko: "λ는 이 행렬이 특이행렬이 되는 최소 중력 배수이다. 접합면의 여유도는 다른 접합면을 그대로 두었을 때 안정을 유지하는 최소 강성에 대한 현재 강성의 비이다.",
        },
        ChainNot => {
            en: "Not covered by λ: earthquake and wind, strength and ageing of stone, slipping, opening of joints, foundations other than the lowest spring, and plan directions other than the one modelled.",
            ko: "λ의 검토 범위 밖: 지진과 바람, 석재의 강도와 노후, 미끄러짐, 접합면의 벌어짐, 최하단 스프링 외의 지반, 모델링하지 않은 방향.",
        },
        FrameSprings => {
            en: "Rigid storeys on linear lateral springs; gravity enters as P-delta. Each direction is a frame of its own; twisting modes are reported and kept out.",
            ko: "강체 층과 선형 횡방향 스프링, 중력은 P-델타 효과로 고려하였다. 각 방향은 독립된 골조이며 비틀림 모드는 보고하되 추정에서 제외하였다.",
        },
        FrameFactor => {
            en: "λ is the smallest factor on all axial forces that makes the stiffness matrix singular.",
            ko: "λ는 강성행렬이 특이행렬이 되는 최소 축력 배수이다.",
        },
        FrameNot => {
            en: "Not covered by λ: friction and its loss under strong shaking, earthquake (where one was simulated, it has a section of its own) and wind, strength and decay of timber. Stiffness from ambient vibration is that of very small motion and falls as motion grows.",
            ko: "λ의 검토 범위 밖: 마찰과 강한 진동에서의 마찰 저하, 지진(시뮬레이션한 경우 별도의 절 참조)과 바람, 목재의 강도와 부후. 상시진동으로 얻은 강성은 극히 작은 진폭의 값이며 진폭이 커지면 감소한다.",
        },
        StackRigid => {
            en: "Rigid stones on joints that bear pressure and friction and, unless a bond is given, no tension. Every edge of every joint is tried for the acceleration at which what stands on it tips or slides; where stones share their load, a limit analysis decides.",
            ko: "부재는 강체이며 접합면은 압축과 마찰에만 저항하고, 부착이 주어지지 않으면 인장에 저항하지 않는다. 모든 접합면의 모든 모서리에 대하여 상부가 전도되거나 미끄러지는 가속도를 구하였다. 하중을 나누어 받는 부재가 있으면 한계해석으로 판정한다.",
        },
        StackShaken => {
            en: "Simulated earthquakes: the same stones on contact springs with Coulomb friction and dashpots, in three dimensions with large turns; the ground is a rigid plane.",
            ko: "지진응답 시뮬레이션: 동일한 부재를 쿨롱 마찰과 감쇠를 가진 접촉 스프링 위에 놓고 큰 회전을 포함하여 3차원으로 해석하였다. 지반은 강체 평면이다.",
        },
        LooseSettle => {
            en: "Loose stones: rigid, with friction and without bond, released where the file has them. They come to rest under their own weight by two laws of contact, springs with dashpots and rigid stones; a motion acts on the stones at rest.",
            ko: "돌무더기: 부재는 강체이며 접촉면은 마찰에 저항하고 부착은 없다. 입력한 자리에서 놓아 자중만으로 안착할 때까지 두 접촉 모델(감쇠를 가진 스프링, 강체 접촉)으로 해석하였다. 지반운동은 안착한 돌에 작용한다.",
        },
        LooseNot => {
            en: "Not covered: cracking and crushing of stone, earth and small stones between the large ones, settlement of the ground.",
            ko: "검토 범위 밖: 석재의 균열과 압괴, 큰 돌 사이의 흙과 잔돌, 지반의 침하.",
        },
        StackNot => {
            en: "Not covered: cracking and crushing of stone, settlement and softness of the ground under shaking, ageing. The thresholds are those of first motion, not of collapse.",
            ko: "검토 범위 밖: 석재의 균열과 압괴, 지진 중 지반의 침하와 변형, 노후. 거동 시작 가속도는 움직이기 시작하는 값이며 붕괴의 값이 아니다.",
        },
        BuildingFloors => {
            en: "Floors are rigid in their plane and rest on linear walls and columns: two displacements and a rotation each. The weight acts where the mass is (P-delta), straight down.",
            ko: "바닥은 면내 강체이고 선형의 벽체와 기둥이 지지하며, 층마다 두 변위와 한 회전을 가진다. 무게는 질량이 있는 위치에서 연직으로 작용한다(P-델타).",
        },
        BuildingFactor => {
            en: "λ is the smallest factor on the weight at which a storey sways or twists without end; storeys fall one by one.",
            ko: "λ는 어느 한 층이 횡변위 또는 비틀림으로 붕괴하는 가장 작은 무게의 배수이다.",
        },
        BuildingNot => {
            en: "Not covered: walls that bend over several storeys as one, floors that are soft in their plane, rocking of the foundation, yielding and cracking, strength.",
            ko: "검토 범위 밖: 여러 층에 걸친 벽체의 휨, 면내로 유연한 바닥, 기초의 회전, 항복과 균열, 강도.",
        },
        SurveyOnly => {
            en: "Only surveys are reported; without a model, stability is not judged.",
            ko: "조사 결과만 보고한다. 해석 모델이 없으므로 안정성은 판단하지 않는다.",
        },
        Singular => {
            en: "S: stiffness of the springs, G: what gravity takes from it; λ is the smallest positive root.",
            ko: "S는 스프링의 강성행렬, G는 중력이 감소시키는 강성행렬이며, λ는 가장 작은 양의 근이다.",
        },
        Vibrates => {
            en: "M: masses, φ: mode shape, ω = 2π f: circular frequency of a mode.",
            ko: "M은 질량행렬, φ는 모드형상, ω = 2π f는 모드의 각진동수이다.",
        },
        StoreySingular => {
            en: "Of each storey; S: its stiffness, G: what gravity takes from it. λ is the smallest positive root of all storeys.",
            ko: "층마다 S는 그 층의 강성행렬, G는 중력이 감소시키는 강성행렬이다. λ는 모든 층의 양의 근 가운데 가장 작은 값이다.",
        },
        BuildingVibrates => {
            en: "K: stiffness, less what gravity takes from it (P-delta); M: masses, φ: mode shape, ω = 2π f: circular frequency of a mode.",
            ko: "K는 중력에 의한 감소(P-델타)를 포함한 강성행렬, M은 질량행렬, φ는 모드형상, ω = 2π f는 모드의 각진동수이다.",
        },
        BuildingVibratesAlone => {
            en: "K: stiffness, without what gravity takes from it: the file leaves P-delta out of modes and responses; M: masses, φ: mode shape, ω = 2π f: circular frequency of a mode.",
            ko: "K는 강성행렬이며 파일에서 P-델타 효과를 제외하였으므로 모드와 응답에 중력에 의한 강성 감소가 없다. M은 질량행렬, φ는 모드형상, ω = 2π f는 모드의 각진동수이다.",
        },
        Margin => {
            en: "m: margin of a joint, k: its stiffness, k_min: the least one at which the chain stands, the other joints as they are.",
            ko: "m은 접합면의 여유도, k는 그 강성, k_min은 다른 접합면을 그대로 두었을 때 안정을 유지하는 최소 강성이다.",
        },
        Tips => {
            en: "a: horizontal acceleration at which one stone on a level bed without bond tips; e is the level distance from its centre of mass to the edge over which it tips, h the height of the centre above that edge, g the acceleration of gravity.",
            ko: "a는 수평 접합면 위에 부착 없이 놓인 부재 하나가 전도되기 시작하는 수평가속도이다. e는 무게중심에서 전도 모서리까지의 수평거리, h는 그 모서리에서 무게중심까지의 높이, g는 중력가속도이다.",
        },
        Slides => { en: "a: horizontal acceleration at which it slides, μ: friction coefficient of the bed.", ko: "a는 미끄러지기 시작하는 수평가속도, μ는 접합면의 마찰계수이다." },
        Likeness => {
            en: "φ, ψ: two mode shapes at the same sensors; 1 where they are alike, 0 where they have nothing in common. H marks the conjugate transpose.",
            ko: "φ와 ψ는 같은 센서에서 얻은 두 모드형상이며, 같으면 1, 공통점이 없으면 0이다. H는 켤레전치를 나타낸다.",
        },
    }
}

/// The section on the basis and limits of a project's numbers.
pub(crate) fn method(project: &Project) -> Document<'static> {
    let mut document = Document::default();
    document.heading(Method::Head);
    let points = sentences(&project.structure).into_iter().map(Sentence::from);
    document.put(Block::List(points.collect()));
    for (formula, meaning) in formulas(project) {
        document.put(Block::Equation(Equation {
            formula,
            meaning: meaning.into(),
        }));
    }
    document
}

fn sentences(structure: &Structure) -> Vec<Method> {
    match structure {
        Structure::Chain(_) => vec![Method::ChainSprings, Method::ChainFactor, Method::ChainNot],
        Structure::Frame(_) => vec![Method::FrameSprings, Method::FrameFactor, Method::FrameNot],
        Structure::Stack(part) if part.is_loose => vec![Method::LooseSettle, Method::LooseNot],
        Structure::Stack(_) => vec![Method::StackRigid, Method::StackShaken, Method::StackNot],
        Structure::Building(_) => vec![
            Method::BuildingFloors,
            Method::BuildingFactor,
            Method::BuildingNot,
        ],
        Structure::Survey => vec![Method::SurveyOnly],
    }
}

fn formulas(project: &Project) -> Vec<(Vec<Math>, Method)> {
    let mut all = match &project.structure {
        Structure::Chain(_) => vec![
            (singular(), Method::Singular),
            (vibrates(less_gravity()), Method::Vibrates),
            (margin(), Method::Margin),
        ],
        Structure::Frame(_) => vec![
            (singular(), Method::Singular),
            (vibrates(less_gravity()), Method::Vibrates),
        ],
        Structure::Building(part) => vec![
            (singular(), Method::StoreySingular),
            (
                vibrates(Math::Matrix("K")),
                match part.p_delta {
                    true => Method::BuildingVibrates,
                    false => Method::BuildingVibratesAlone,
                },
            ),
        ],
        Structure::Stack(part) if part.is_loose => Vec::new(),
        Structure::Stack(_) => vec![(tips(), Method::Tips), (slides(), Method::Slides)],
        Structure::Survey => Vec::new(),
    };
    let has_shapes = |survey: &Survey| survey.records.is_some() || !survey.setups.is_empty();
    if project.surveys.iter().any(has_shapes) {
        all.push((likeness(), Method::Likeness));
    }
    all
}

/// det(S − λ G) = 0
fn singular() -> Vec<Math> {
    let inside = vec![
        Math::Matrix("S"),
        Math::Sign("−"),
        Math::Symbol("λ"),
        Math::Matrix("G"),
    ];
    vec![
        Math::Word("det"),
        Math::round(inside),
        Math::Sign("="),
        Math::Word("0"),
    ]
}

/// (S − G)
fn less_gravity() -> Math {
    Math::round(vec![Math::Matrix("S"), Math::Sign("−"), Math::Matrix("G")])
}

/// (S − G) φ = ω² M φ
fn vibrates(stiffness: Math) -> Vec<Math> {
    vec![
        stiffness,
        Math::Matrix("φ"),
        Math::Sign("="),
        Math::Symbol("ω").power(Math::Word("2")),
        Math::Matrix("M"),
        Math::Matrix("φ"),
    ]
}

/// m = k/k_min
fn margin() -> Vec<Math> {
    let least = Math::Symbol("k").index(Math::Word("min"));
    vec![
        Math::Symbol("m"),
        Math::Sign("="),
        Math::Fraction(vec![Math::Symbol("k")], vec![least]),
    ]
}

/// a = g e/h
fn tips() -> Vec<Math> {
    vec![
        Math::Symbol("a"),
        Math::Sign("="),
        Math::Symbol("g"),
        Math::Fraction(vec![Math::Symbol("e")], vec![Math::Symbol("h")]),
    ]
}

/// a = μ g
fn slides() -> Vec<Math> {
    vec![
        Math::Symbol("a"),
        Math::Sign("="),
        Math::Symbol("μ"),
        Math::Symbol("g"),
    ]
}

/// MAC = |φᴴ ψ|²/((φᴴ φ) (ψᴴ ψ))
fn likeness() -> Vec<Math> {
    let across = |left: &'static str, right: &'static str| {
        vec![Math::Matrix(left).power(Math::Word("H")), Math::Matrix(right)]
    };
    let squared = Math::Fenced(["|", "|"], across("φ", "ψ")).power(Math::Word("2"));
    vec![
        Math::Word("MAC"),
        Math::Sign("="),
        Math::Fraction(
            vec![squared],
            vec![Math::round(across("φ", "φ")), Math::round(across("ψ", "ψ"))],
        ),
    ]
}
