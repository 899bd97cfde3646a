//! What the numbers rest on, and what they leave out.

use dolmen_project::Structure;
use dolmen_words::Language;

/// What the numbers of a kind of structure rest on, and what they leave out.
pub(crate) fn method(structure: &Structure, language: Language) -> Vec<&'static str> {
    match structure {
        Structure::Chain(_) => vec![
            language.pick(
                "Rigid links on linear rotational springs, small rotations, static gravity. The chain stands if and only if its stiffness matrix with gravity is positive definite.",
                "강체 부재와 선형 회전 스프링, 미소 회전, 정적 중력을 가정하였다. 중력을 포함한 강성행렬이 양정부호일 때, 그리고 그때에만 안정하다.",
            ),
            language.pick(
                "λ is the smallest factor on gravity that makes this matrix singular. The margin of a joint is its stiffness over the least one at which the chain stands, the other joints as they are.",
                "λ는 이 행렬을 특이하게 만드는 가장 작은 중력 배수이다. 접합면의 여유도는 다른 접합면을 그대로 두었을 때 안정을 유지하는 최소 강성에 대한 현재 강성의 비이다.",
            ),
            language.pick(
                "Not covered by λ: earthquake and wind, strength and ageing of stone, slipping, opening of joints, foundations other than the lowest spring, and plan directions other than the one modelled.",
                "λ의 검토 범위 밖: 지진과 바람, 석재의 강도와 노후, 미끄러짐, 접합면의 벌어짐, 최하단 스프링 외의 지반, 모델링하지 않은 방향.",
            ),
        ],
        Structure::Frame(_) => vec![
            language.pick(
                "Rigid storeys on linear lateral springs; gravity enters as P-delta. Each direction is a frame of its own; twisting modes are reported and kept out.",
                "강체 층과 선형 횡방향 스프링, 중력은 P-델타 효과로 고려하였다. 각 방향은 독립된 골조이며 비틀림모드는 보고하되 추정에서 제외하였다.",
            ),
            language.pick(
                "λ is the smallest factor on all axial forces that makes the stiffness matrix singular.",
                "λ는 강성행렬을 특이하게 만드는 가장 작은 축력 배수이다.",
            ),
            language.pick(
                "Not covered by λ: friction and its loss under strong shaking, earthquake (where one was simulated, it has a section of its own) and wind, strength and decay of timber. Stiffness from ambient vibration is that of very small motion and falls as motion grows.",
                "λ의 검토 범위 밖: 마찰과 강한 진동에서의 마찰 저하, 지진(시뮬레이션한 경우 별도의 절 참조)과 바람, 목재의 강도와 부후. 상시진동으로 얻은 강성은 극히 작은 진폭의 값이며 진폭이 커지면 감소한다.",
            ),
        ],
        Structure::Stack(_) => vec![
            language.pick(
                "Rigid stones on joints that bear pressure and friction and, unless a bond is given, no tension. Every edge of every joint is tried for the acceleration at which what stands on it tips or slides; where stones share their load, a limit analysis decides.",
                "부재는 강체이며 접합면은 압축과 마찰에만 저항하고, 부착이 주어지지 않으면 인장에 저항하지 않는다. 모든 접합면의 모든 모서리에 대하여 상부가 전도되거나 미끄러지는 가속도를 구하였다. 하중을 나누어 받는 부재가 있으면 한계해석으로 판정한다.",
            ),
            language.pick(
                "Simulated earthquakes: the same stones on contact springs with Coulomb friction and dashpots, in three dimensions with large turns; the ground is a rigid plane.",
                "지진응답 시뮬레이션: 동일한 부재를 쿨롱 마찰과 감쇠를 가진 접촉 스프링 위에 놓고 큰 회전을 포함하여 3차원으로 해석하였다. 지반은 강체 평면이다.",
            ),
            language.pick(
                "Not covered: cracking and crushing of stone, settlement and softness of the ground under shaking, ageing. The thresholds are those of first motion, not of collapse.",
                "검토 범위 밖: 석재의 균열과 압괴, 지진 중 지반의 침하와 변형, 노후. 한계 가속도는 최초 거동의 값이며 붕괴의 값이 아니다.",
            ),
        ],
        Structure::Building(_) => vec![
            language.pick(
                "Floors are rigid in their plane and rest on linear walls and columns: two displacements and a rotation each. The weight acts where the mass is (P-delta), straight down.",
                "바닥은 면내 강체이고 선형의 벽체와 기둥이 지지하며, 층마다 두 변위와 한 회전을 가진다. 무게는 질량이 있는 위치에서 연직으로 작용한다(P-델타).",
            ),
            language.pick(
                "λ is the smallest factor on the weight at which a storey sways or twists without end; storeys fall one by one.",
                "λ는 어느 한 층이 횡변위 또는 비틀림으로 무너지는 가장 작은 무게의 배수이다.",
            ),
            language.pick(
                "Not covered: walls that bend over several storeys as one, floors that are soft in their plane, rocking of the foundation, yielding and cracking, strength.",
                "검토 범위 밖: 여러 층에 걸친 벽체의 휨, 면내로 유연한 바닥, 기초의 회전, 항복과 균열, 강도.",
            ),
        ],
        Structure::Survey => vec![language.pick(
            "Only what was measured is reported; no model was made, so that nothing is said about stability.",
            "계측 결과만 보고한다. 해석 모델이 없으므로 안정성은 판단하지 않는다.",
        )],
    }
}
