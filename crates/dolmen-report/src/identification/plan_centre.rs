//! The source of a storey's centre of rigidity, and the consequences if it is unknown.

use super::plan_values::{Units, eccentricity};
use crate::document::{Finding, Tone};
use dolmen::structure::building::{EccentricityFrom, PlanBounds, PlanSolution, ShapeOtherwise};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::PlanAnswer;

messages! {
    /// The centre of rigidity.
    pub(crate) enum Centre in "identification.plan_centre" {
        Stated { k_x: Quantity, k_y: Quantity, k_theta: Quantity, e_x: Quantity, e_y: Quantity } => {
            en: "not determined: 3 frequencies do not tell where the centre of rigidity is. Were it where the file has it ({e_x} along x and {e_y} along y from the centre of mass), k_x would be {k_x}, k_y {k_y}, k_θ {k_theta}.",
            ko: "정해지지 않는다. 고유진동수 3개로는 강성 중심의 위치를 알 수 없다. 강성 중심이 파일의 위치(질량중심에서 x {e_x}, y {e_y})에 있다면 k_x {k_x}, k_y {k_y}, k_θ {k_theta}이다.",
        },
        Between { stated: Sentence, x: Sentence, y: Sentence, theta: Sentence } => {
            en: "{stated} Over all centres on the floor, and over frequencies within 1.96 standard deviations, k_x lies between {x}, k_y between {y}, k_θ between {theta}.",
            ko: "{stated} 바닥 안의 모든 강성 중심과 표준편차 1.96배 이내의 고유진동수에 대하여 k_x는 {x}, k_y는 {y}, k_θ는 {theta} 사이에 있다.",
        },
        BetweenExact { stated: Sentence, x: Sentence, y: Sentence, theta: Sentence } => {
            en: "{stated} Over all centres on the floor, were the frequencies exact (their scatter is not given), k_x lies between {x}, k_y between {y}, k_θ between {theta}.",
            ko: "{stated} 바닥 안의 모든 강성 중심에 대하여, 고유진동수가 정확하다면(산포가 주어지지 않음) k_x는 {x}, k_y는 {y}, k_θ는 {theta} 사이에 있다.",
        },
        Range { least: Quantity, most: Quantity } => { en: "{least} and {most}", ko: "{least}에서 {most}" },
        Needed => {
            en: "The shapes of the modes along x and y give the centre: a record of three horizontal sensors or more on the floor, not all on one line, or twist and sideways of each mode in the file.",
            ko: "x, y 방향 모드의 형상이 있으면 강성 중심이 구해진다. 바닥에서 한 직선 위에 있지 않은 수평 센서 3개 이상의 기록이나, 파일에 적은 각 모드의 twist와 sideways가 필요하다.",
        },
        Followed { said: Sentence, needed: Sentence } => { en: "{said} {needed}", ko: "{said} {needed}" },
        SeveralTwists { solutions: usize } => {
            en: "{solutions} different solutions explain the 3 frequencies and the twists equally well; none is preferred here. How far the floor moves across the direction of each mode, over how far along it (sideways), tells them apart.",
            ko: "서로 다른 해 {solutions}개가 고유진동수 3개와 비틀림비를 똑같이 잘 설명하므로 어느 것도 택하지 않는다. 각 모드에서 그 방향 변위에 대한 직각 방향 변위의 비(sideways)를 계측하면 구별할 수 있다.",
        },
        SeveralShapes { solutions: usize } => {
            en: "{solutions} different solutions explain the 3 frequencies and the shapes (twist and sideways) equally well; none is preferred here. Measure the shapes more closely: longer records, and more sensors near the corners of the floor.",
            ko: "서로 다른 해 {solutions}개가 고유진동수 3개와 모드형상(twist, sideways)을 똑같이 잘 설명하므로 어느 것도 택하지 않는다. 더 긴 기록과 바닥 모서리 쪽의 더 많은 센서로 모드형상을 더 정밀하게 계측해야 한다.",
        },
        Meet { survey: String } => {
            en: "Survey {survey}: two solutions meet within the scatter of these frequencies and twists. The standard deviations given span both; a smaller scatter of twists and frequencies narrows them.",
            ko: "{survey} 조사: 이 고유진동수와 비틀림비의 산포 안에서 두 해가 만난다. 제시한 표준편차는 두 해를 모두 포함한다. 비틀림비와 고유진동수의 산포를 줄이면 좁혀진다.",
        },
        OffFloor { survey: String, sensors: Vec<String>, x: Sentence, y: Sentence } => {
            en: "Survey {survey}: sensors stand outside the floor: {sensors}. Its sides lie between {x} along x and between {y} along y. Positions are in the axes of the file, not from a corner of the plan: check them before all else.",
            ko: "{survey} 조사: 바닥 밖에 놓인 센서가 있다: {sensors}. 바닥의 변은 x {x}, y {y} 사이에 있다. 위치는 평면의 모서리가 아니라 파일의 좌표축에서 잰 값이므로 무엇보다 먼저 위치를 확인해야 한다.",
        },
        FromRecord { survey: String, sensors: usize, unexplained: Quantity } => {
            en: "Survey {survey}: the twists and sideways motions are from its record. Sensors on the floor: {sensors}; share of their shapes that no rigid floor has: {unexplained}.",
            ko: "{survey} 조사: 비틀림비와 직각 방향 변위는 기록에서 구하였다. 바닥의 센서 {sensors}개, 강체 바닥의 운동이 아닌 모드형상의 비율 {unexplained}.",
        },
        ThreeSensors { survey: String } => {
            en: "Survey {survey}: the twists and sideways motions are from the 3 sensors on the floor. Three tell its motion and nothing checks them: one turned round or in a wrong place goes unseen.",
            ko: "{survey} 조사: 비틀림비와 직각 방향 변위는 바닥의 센서 3개에서 구하였다. 3개로는 운동이 정해질 뿐 검증되지 않으므로, 방향이 반대이거나 위치가 틀린 센서를 찾을 수 없다.",
        },
        MoreModes { survey: String, modes: usize } => {
            en: "Survey {survey}: its record shows {modes} modes, and one floor has 3: the lowest 3 are taken. If one of them is not of this floor, every stiffness is wrong.",
            ko: "{survey} 조사: 기록의 모드는 {modes}개이나 바닥 하나의 모드는 3개이므로 가장 낮은 3개를 썼다. 그중에 이 바닥의 모드가 아닌 것이 있으면 모든 강성이 틀리게 된다.",
        },
        NotRigid { unexplained: Quantity } => {
            en: "No stiffness is sought: {unexplained} of the mode shapes of the record is no motion of a rigid floor. Check places, directions, cables and units of the sensors.",
            ko: "기록의 모드형상 중 {unexplained}이(가) 강체 바닥의 운동이 아니므로 강성을 추정하지 않았다. 센서의 위치, 방향, 케이블, 단위를 확인해야 한다.",
        },
        Record => {
            en: "No stiffness is sought: the survey states no modes, and its record does not show how the floor moves. That takes three horizontal sensors or more at the height of the floor, with position and direction, not all on one line. Or write the lowest mode along x, along y and of torsion with its frequency, and of those along x and y twist and sideways: frequencies alone do not tell the centre of rigidity.",
            ko: "조사에 모드가 없고 기록으로 바닥의 운동을 알 수 없어 강성을 추정하지 않았다. 바닥 높이에 위치와 방향이 주어진, 한 직선 위에 있지 않은 수평 센서가 3개 이상 필요하다. 또는 x, y, 비틀림의 최저 모드를 고유진동수와 함께 적고, x, y 방향 모드에는 twist와 sideways를 적어야 한다. 고유진동수만으로는 강성 중심을 알 수 없다.",
        },
        WhyShape { solution: Sentence, frequency: Quantity, assurance: Quantity } => {
            en: "{solution} is not accepted: the floor moves otherwise in its mode at {frequency} than was measured (MAC {assurance}, 1 for the same shape).",
            ko: "{solution}은(는) 제외한다. {frequency} 모드에서 바닥의 움직임이 계측과 다르다(MAC {assurance}, 같으면 1).",
        },
    }
}

/// Text for a single solution with the centre of rigidity of the file: it is not an answer.
pub(super) fn stated(answer: &PlanAnswer, one: &PlanSolution) -> Sentence {
    let units = Units::of(std::iter::once(one.stiffness));
    let [k_x, k_y, k_theta] = [0, 1, 2].map(|at| units.stiffness(one, at));
    let [e_x, e_y] = [0, 1].map(|at| eccentricity(one, at));
    let stated = Centre::Stated {
        k_x,
        k_y,
        k_theta,
        e_x,
        e_y,
    };
    let said: Sentence = match &answer.bounds {
        None => stated.into(),
        Some(bounds) => {
            let [x, y, theta] = [0, 1, 2].map(|at| range(bounds, &units, at));
            let stated = stated.into();
            match bounds.with_scatter {
                true => Centre::Between { stated, x, y, theta }.into(),
                false => Centre::BetweenExact { stated, x, y, theta }.into(),
            }
        }
    };
    let needed = Centre::Needed.into();
    Centre::Followed { said, needed }.into()
}

fn range(bounds: &PlanBounds, units: &Units, at: usize) -> Sentence {
    let end = |value: f64| Quantity::new(value, units.unit(at), Digits::Significant(3));
    let [least, most] = bounds.stiffness[at].map(end);
    Centre::Range { least, most }.into()
}

/// Finding that sensors stand outside the sides of the floor.
pub(super) fn off_floor(survey: &str, answer: &PlanAnswer) -> Option<Finding> {
    let sides = answer.sides_m().filter(|_| !answer.off_floor.is_empty())?;
    let [x, y] = sides.map(|[least, most]| {
        let [least, most] = [least, most].map(|m| Quantity::new(m, Unit::si("m"), Digits::Fixed(2)));
        Centre::Range { least, most }.into()
    });
    let said = Centre::OffFloor {
        survey: survey.to_owned(),
        sensors: answer.off_floor.clone(),
        x,
        y,
    };
    Some(Finding::key(Tone::Warn, said))
}

/// The source of the twists, and notes on it.
pub(super) fn findings(survey: &str, answer: &PlanAnswer) -> Vec<Finding> {
    let survey = survey.to_owned();
    let mut all = Vec::new();
    if answer.found.accepted().any(|one| one.roots_meet) {
        let survey = survey.clone();
        all.push(Finding::key(Tone::Warn, Centre::Meet { survey }));
    }
    let Some(from) = answer.from_record else {
        return all;
    };
    if from.modes_found > 3 {
        let (survey, modes) = (survey.clone(), from.modes_found);
        all.push(Finding::key(Tone::Warn, Centre::MoreModes { survey, modes }));
    }
    all.push(match from.sensors {
        3 => Finding::key(Tone::Unknown, Centre::ThreeSensors { survey }),
        sensors => Finding::new(
            Tone::Plain,
            Centre::FromRecord {
                survey,
                sensors,
                unexplained: Quantity::percent(from.unexplained, 2),
            },
        ),
    });
    all
}

/// Whether the result depends on the centre of rigidity of the file.
pub(super) fn is_stated(answer: &PlanAnswer) -> bool {
    answer.found.eccentricity_from == EccentricityFrom::Stated
}

pub(super) fn why_shape(solution: Sentence, why: &ShapeOtherwise) -> Centre {
    Centre::WhyShape {
        solution,
        frequency: Quantity::new(why.frequency_hz, Unit::si("Hz"), Digits::Trimmed(5)),
        assurance: Quantity::new(why.assurance, Unit::ratio(), Digits::Fixed(2)),
    }
}
