//! Stiffness of a building's storey in plan from vibration: findings, and the section of every solution.

use super::plan_centre;
use super::plan_values::{Units, eccentricity};
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone, table_series};
use crate::figures::{letter, plan_modes};
use crate::html::words::verdict_word;
use dolmen::stability::Verdict;
use dolmen::structure::building::{
    EccentricityFrom, MovesOtherwise, PlanMode, PlanMotion, PlanSolution, PlanStiffnessError,
};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::PlanAnswer;

/// Amplification of frequency errors in the stiffness above which it is a finding. Our choice: 2 without coupling.
const AMPLIFIED: f64 = 10.0;

messages! {
    /// Stiffness in plan.
    pub(crate) enum Plan in "identification.plan" {
        Of { survey: String, said: Sentence } => {
            en: "Stiffness from vibration (survey {survey}, in plan): {said}",
            ko: "진동으로 추정한 평면 강성({survey} 조사): {said}",
        },
        OneWithCentre { k_x: Quantity, k_y: Quantity, k_theta: Quantity, e_x: Quantity, e_y: Quantity } => {
            en: "one solution explains the 3 frequencies and the twists: k_x {k_x}, k_y {k_y}, k_θ {k_theta} about the centre of rigidity, which lies {e_x} along x and {e_y} along y from the centre of mass.",
            ko: "고유진동수 3개와 비틀림비를 설명하는 해는 하나이다. k_x {k_x}, k_y {k_y}, 강성 중심에 대한 k_θ {k_theta}이고, 편심(질량중심에서 강성 중심까지)은 x {e_x}, y {e_y}이다.",
        },
        Several(solutions: usize) => {
            en: "{solutions} different solutions explain the measured modes equally well; none is preferred here. How each mode moves (x, y or torsion), and the twists of the modes along x and y, tell them apart.",
            ko: "서로 다른 해 {solutions}개가 계측 모드를 똑같이 잘 설명하므로 어느 것도 택하지 않는다. 각 모드의 거동(x, y 또는 비틀림)과 x, y 방향 모드의 비틀림비를 계측하면 구별할 수 있다.",
        },
        SeveralMove(solutions: usize) => {
            en: "{solutions} different solutions explain the measured modes equally well; none is preferred here. The twists of the modes along x and y tell them apart, and give the centre of rigidity.",
            ko: "서로 다른 해 {solutions}개가 계측 모드를 똑같이 잘 설명하므로 어느 것도 택하지 않는다. x, y 방향 모드의 비틀림비를 계측하면 구별할 수 있고 강성 중심도 구해진다.",
        },
        Refused(solutions: usize) => {
            en: "none is accepted. Solutions with the 3 frequencies: {solutions}; in each a mode moves otherwise than it was measured. Check how the modes were told apart, and the masses and centres of the floor.",
            ko: "받아들일 수 있는 해가 없다. 고유진동수 3개를 갖는 해 {solutions}개 모두에서 어떤 모드가 계측과 다르게 움직인다. 모드의 구분과 바닥의 질량, 중심을 확인해야 한다.",
        },
        Impossible => {
            en: "no positive stiffness gives the floor these 3 frequencies with its centre of rigidity where it is. Check the centres and the radius of gyration of the floor.",
            ko: "강성 중심이 주어진 위치에 있을 때 이 고유진동수 3개를 갖는 양의 강성이 없다. 바닥의 중심과 회전반경을 확인해야 한다.",
        },
        Free { modes: usize, free: Vec<Sentence> } => {
            en: "not determined. A floor has 3 modes, and {modes} of them measured leave {free} free; measure the others.",
            ko: "정해지지 않는다. 바닥의 모드는 3개인데 계측 모드 {modes}개로는 {free}이(가) 정해지지 않으므로 나머지를 계측해야 한다.",
        },
        FreeBut { modes: usize, free: Vec<Sentence>, known: Vec<Sentence> } => {
            en: "determined in part, with the centre of rigidity where the file has it: {known}. A floor has 3 modes, and {modes} of them measured leave {free} free; measure the others.",
            ko: "강성 중심이 파일의 위치에 있다면 일부만 정해진다({known}). 바닥의 모드는 3개인데 계측 모드 {modes}개로는 {free}이(가) 정해지지 않으므로 나머지를 계측해야 한다.",
        },
        Known { symbol: Sentence, value: Quantity } => { en: "{symbol} {value}", ko: "{symbol} {value}" },
        Incomplete => {
            en: "Two solutions nearly meet, and not all of the six were reached: one may be missing.",
            ko: "두 해가 거의 만나서 여섯 개의 해를 모두 찾지는 못하였으며 빠진 해가 있을 수 있다.",
        },
        Amplified { survey: String, per_cent: Quantity } => {
            en: "Survey {survey}: a frequency 1 % off moves a stiffness in plan by up to {per_cent}. Sway and twist lie too close for these frequencies to settle it.",
            ko: "{survey} 조사: 고유진동수가 1 % 어긋나면 평면 강성은 최대 {per_cent} 달라진다. 병진과 비틀림이 너무 가까워 이 고유진동수로는 잘 정해지지 않는다.",
        },
        TwistUnused(survey: String) => {
            en: "Survey {survey}: twist is given of one mode only and is not used. With those of both modes along x and y, and all 3 frequencies, the centre of rigidity is found as well.",
            ko: "{survey} 조사: 비틀림비가 한 모드에만 있어 쓰지 않았다. 고유진동수 3개와 x, y 방향 두 모드의 비틀림비가 있으면 강성 중심도 추정한다.",
        },
        Head(survey: String) => { en: "Survey {survey}, in plan", ko: "{survey} 조사, 평면" },
        Measured(modes: Vec<Sentence>) => { en: "Measured: {modes}.", ko: "계측값: {modes}." },
        Mode(frequency: Quantity) => { en: "{frequency} (motion not known)", ko: "{frequency}(거동 미상)" },
        ModeOf { frequency: Quantity, motion: Sentence } => { en: "{frequency} ({motion})", ko: "{frequency}({motion})" },
        ModeTwist { frequency: Quantity, motion: Sentence, twist: Quantity } => {
            en: "{frequency} ({motion}, twist ρθ/u {twist})",
            ko: "{frequency}({motion}, 비틀림비 ρθ/u {twist})",
        },
        AlongX => { en: "along x", ko: "x 방향 병진" },
        AlongY => { en: "along y", ko: "y 방향 병진" },
        Torsion => { en: "torsion", ko: "비틀림" },
        Caption(total: usize) => { en: "Solutions in plan: {total}.", ko: "평면 강성의 해: {total}개." },
        Meaning => {
            en: "k θ is about the centre of rigidity; e is from the centre of mass to it; ± standard deviation. Per 1 %: how much a stiffness moves, most, where each frequency moves by 1 %.",
            ko: "k θ는 강성 중심에 대한 값, e는 질량중심에서 강성 중심까지의 거리이며 ±는 표준편차이다. 1 %당은 각 고유진동수가 1 % 달라질 때 강성이 달라지는 최대량이다.",
        },
        Stated => {
            en: "The centre of rigidity is taken as the file has it.",
            ko: "강성 중심은 파일에 주어진 위치로 보았다.",
        },
        Solution => { en: "Solution", ko: "해" },
        InTheFile => { en: "file", ko: "파일" },
        Verdict => { en: "verdict", ko: "판정" },
        VerdictWord(word: Both) => { en: "{word}", ko: "{word}" },
        NotAccepted => { en: "not accepted", ko: "제외" },
        PerOne => { en: "per 1 %", ko: "1 %당" },
        Why { solution: Sentence, frequency: Quantity, would_be: Sentence, share: Quantity, measured: Sentence } => {
            en: "{solution} is not accepted: its mode at {frequency} would be {would_be} ({share} of its energy), but was measured as {measured}.",
            ko: "{solution}은(는) 제외한다. {frequency} 모드가 {would_be}(에너지의 {share})이어야 하나 계측은 {measured}이다.",
        },
        ShapesCaption => {
            en: "How the floor moves in each mode of solution A, seen from above.",
            ko: "해 A의 모드별 바닥의 움직임(평면).",
        },
        ShapesMeaning => {
            en: "Dashed: at rest. Black dot: centre of mass as it moves; purple cross: centre of rigidity at rest.",
            ko: "점선은 정지 상태, 검은 점은 움직인 질량중심, 보라색 십자는 정지 상태의 강성 중심이다.",
        },
        ModesCaption => { en: "Modes of the accepted solutions.", ko: "받아들인 해의 모드." },
        ModesMeaning => {
            en: "Parts of the energy of the mode along x, along y and in rotation about the centre of mass.",
            ko: "모드 에너지 중 x 방향, y 방향, 질량중심에 대한 회전의 몫.",
        },
        Frequency => { en: "f", ko: "f" },
        Masses => {
            en: "The deviations are of what was measured, linearised, with masses and plan taken as exact; 1 % more mass is 1 % more of every k.",
            ko: "표준편차는 계측값에서만 비롯한 선형화한 값이며 질량과 평면 치수는 정확하다고 보았다. 질량이 1 % 크면 모든 k가 1 % 크다.",
        },
        WhatFloors(floors: usize) => {
            en: "No stiffness is sought from vibration: the building has {floors} floors, and it is found for one floor on one storey only. The check compares the measured frequencies with those of the model.",
            ko: "건물의 층이 {floors}개여서 진동으로 강성을 추정하지 않았다. 추정은 바닥 하나와 그 아래 층 하나인 건물에만 한다. 검토에서 계측 고유진동수와 모델의 값을 비교한다.",
        },
        WhatDampers(dampers: Vec<String>) => {
            en: "No stiffness is sought from vibration: the file puts dampers on the floor ({dampers}), and modes measured with them are not those of the floor alone. Survey with the dampers blocked, and move them into a «[variant]|variant»; the check compares what was measured with the modes of the whole, dampers included.",
            ko: "파일에 감쇠기({dampers})가 있어, 그대로 계측한 모드는 바닥만의 모드가 아니므로 진동으로 강성을 추정하지 않았다. 감쇠기를 고정하고 계측한 뒤 감쇠기를 «[variant]로|대안으로» 옮겨야 한다. 검토에서는 계측값을 감쇠기를 포함한 전체의 모드와 비교한다.",
        },
        WhatTurned => {
            en: "No stiffness is sought from vibration: the walls of the storey are turned from x and y, which makes more unknowns than k_x, k_y and k_θ. Turn the axes of the plan with the walls.",
            ko: "층의 벽이 x, y축에서 돌아가 있어 미지수가 k_x, k_y, k_θ보다 많으므로 진동으로 강성을 추정하지 않았다. 평면의 축을 벽에 맞추어 돌려야 한다.",
        },
        WhatModes(given: usize) => {
            en: "No stiffness is sought: {given} modes are given, but one floor has 3, along x, along y and torsion. Keep the lowest of each in the survey.",
            ko: "모드가 {given}개 주어졌으나 바닥 하나의 모드는 x, y, 비틀림의 3개이므로 강성을 추정하지 않았다. 조사에 각각의 최저 모드만 남겨야 한다.",
        },
        WhatTwice(motion: Sentence) => {
            en: "No stiffness is sought: two modes are {motion}, but one floor has one of each. Keep the lowest in the survey.",
            ko: "{motion} 모드가 둘 주어졌으나 바닥 하나에는 하나뿐이므로 강성을 추정하지 않았다. 조사에 최저 모드만 남겨야 한다.",
        },
        WhatRepeated(frequency: Quantity) => {
            en: "No stiffness is sought: {frequency} stands twice. Where sway and twist couple, two modes never have one frequency: give more digits.",
            ko: "{frequency}이(가) 두 번 주어져 강성을 추정하지 않았다. 병진과 비틀림이 연성되면 두 모드의 고유진동수가 같을 수 없으므로 자릿수를 더 주어야 한다.",
        },
        WhatElse => {
            en: "No stiffness is sought: its equations could not be solved with these numbers. Check masses, centres and frequencies.",
            ko: "주어진 값으로 방정식을 풀 수 없어 강성을 추정하지 않았다. 질량, 중심, 고유진동수를 확인해야 한다.",
        },
    }
}

/// Why the modes of a building are refused.
pub(super) fn refused(why: &PlanStiffnessError) -> Plan {
    match why {
        PlanStiffnessError::Modes { given } => Plan::WhatModes(*given),
        PlanStiffnessError::Twice { motion } => Plan::WhatTwice(motion_word(*motion)),
        PlanStiffnessError::Repeated { frequency_hz } => Plan::WhatRepeated(hertz(*frequency_hz, 0.0)),
        PlanStiffnessError::Argument { .. }
        | PlanStiffnessError::Structure(_)
        | PlanStiffnessError::Linalg(_) => Plan::WhatElse,
    }
}

/// Findings of a survey on the storey in plan.
pub(super) fn findings(survey: &str, answer: &PlanAnswer) -> Vec<Finding> {
    let (tone, said, code) = chosen(answer);
    let found = Plan::Of {
        survey: survey.to_owned(),
        said,
    };
    // the reason for a refusal is given before it
    let mut all = Vec::from_iter(plan_centre::off_floor(survey, answer));
    all.push(Finding {
        code,
        ..Finding::key(tone, found)
    });
    all.extend(plan_centre::findings(survey, answer));
    if let Some(one) = the_one(answer)
        && one.amplification > AMPLIFIED
    {
        let per_cent = per_one(one);
        let survey = survey.to_owned();
        all.push(Finding::key(Tone::Warn, Plan::Amplified { survey, per_cent }));
    }
    if !answer.found.complete {
        all.push(Finding::key(Tone::Warn, Plan::Incomplete));
    }
    if answer.twist_unused {
        let survey = survey.to_owned();
        all.push(Finding::new(Tone::Unknown, Plan::TwistUnused(survey)));
    }
    all
}

/// The solution, if only one is accepted.
fn the_one(answer: &PlanAnswer) -> Option<&PlanSolution> {
    let mut accepted = answer.found.accepted();
    accepted.next().filter(|_| accepted.next().is_none())
}

fn chosen(answer: &PlanAnswer) -> (Tone, Sentence, Option<&'static str>) {
    let found = &answer.found;
    if !found.free.is_empty() {
        return (Tone::Warn, free(answer).into(), Some("underdetermined"));
    }
    let is_stated = plan_centre::is_stated(answer);
    if let Some(one) = the_one(answer) {
        if is_stated {
            return (
                Tone::Warn,
                plan_centre::stated(answer, one),
                Some("underdetermined"),
            );
        }
        let units = Units::of(std::iter::once(one.stiffness));
        let [k_x, k_y, k_theta] = [0, 1, 2].map(|at| units.stiffness(one, at));
        let [e_x, e_y] = [0, 1].map(|at| eccentricity(one, at));
        let said = Plan::OneWithCentre {
            k_x,
            k_y,
            k_theta,
            e_x,
            e_y,
        };
        return (Tone::Good, said.into(), None);
    }
    let solutions = found.solutions.len();
    match found.accepted().count() {
        0 if solutions == 0 => (Tone::Bad, Plan::Impossible.into(), Some("no-real-root")),
        0 => (Tone::Bad, Plan::Refused(solutions).into(), Some("no-real-root")),
        solutions => {
            let all_move = answer.modes.iter().all(|mode| mode.motion.is_some());
            let said: Sentence = match (is_stated, all_move) {
                (false, _) if has_shapes(answer) => plan_centre::Centre::SeveralShapes { solutions }.into(),
                (false, _) => plan_centre::Centre::SeveralTwists { solutions }.into(),
                (true, true) => Plan::SeveralMove(solutions).into(),
                (true, false) => Plan::Several(solutions).into(),
            };
            (Tone::Warn, said, Some("indistinguishable"))
        }
    }
}

/// Whether the shapes of both modes along x and y were measured.
fn has_shapes(answer: &PlanAnswer) -> bool {
    let sways = |mode: &&PlanMode| matches!(mode.motion, Some(PlanMotion::X | PlanMotion::Y));
    answer.modes.iter().filter(sways).all(|mode| mode.shape.is_some())
}

fn free(answer: &PlanAnswer) -> Plan {
    let found = &answer.found;
    let modes = answer.modes.len();
    let free = found.free.iter().map(|motion| symbol(*motion)).collect();
    let known = found.singles.iter().map(|single| {
        let value = Quantity {
            sd_si: single.stiffness_sd,
            ..Quantity::new(
                single.stiffness,
                Unit::of(&[single.stiffness], unit_si(single.motion)),
                Digits::Significant(4),
            )
        };
        let symbol = symbol(single.motion);
        Plan::Known { symbol, value }.into()
    });
    let known: Vec<Sentence> = known.collect();
    match known.is_empty() {
        true => Plan::Free { modes, free },
        false => Plan::FreeBut { modes, free, known },
    }
}

/// Every solution, why some are not accepted, and the modes of accepted ones.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: &str, answer: &'a PlanAnswer) {
    document.subheading(Plan::Head(survey.to_owned()));
    document.paragraph(Plan::Measured(answer.modes.iter().map(mode_words).collect()));
    let found = &answer.found;
    if found.solutions.is_empty() {
        document.paragraph(chosen(answer).1);
        return;
    }
    document.put(Block::Table(table(answer)));
    for (at, one) in found.solutions.iter().enumerate() {
        if let Some(why) = &one.moves_otherwise {
            document.note(why_not(at, why));
        } else if let Some(why) = &one.shape_otherwise {
            document.note(plan_centre::why_shape(Sentence::of_symbol(&letter(at)), why));
        }
    }
    if let Some(one) = found.accepted().next() {
        let drawn = Figure::drawn(
            vec![Plan::ShapesCaption.into(), Plan::ShapesMeaning.into()],
            move |language| plan_modes(answer, one, language),
        );
        document.charted(drawn.with_series(move || table_series(&modes_table(answer))));
        document.put(Block::Table(modes_table(answer)));
    }
    if found.solutions.iter().any(|one| one.stiffness_sd.is_some()) {
        document.note(Plan::Masses);
    }
}

fn table(answer: &PlanAnswer) -> Table {
    let all = &answer.found.solutions;
    let written = &answer.written;
    let units = Units::of(all.iter().map(|one| one.stiffness).chain([written.stiffness]));
    let metre = Unit::si("m");
    let of_symbol = |head: &str, unit: &Unit| Column::numbers(Sentence::of_symbol(head), unit.clone());
    let mut rows: Vec<Vec<Cell>> = Vec::with_capacity(all.len() + 1);
    for (at, (one, factor)) in all.iter().zip(&answer.load_factors).enumerate() {
        let mut row = vec![Cell::words(Sentence::of_symbol(&letter(at)))];
        row.push(Cell::words(match one.is_accepted() {
            false => Plan::NotAccepted,
            true => {
                let verdict = Verdict::of_load_factor(*factor);
                Plan::VerdictWord(Both::of(|language| verdict_word(verdict, language)))
            }
        }));
        let quantity = Quantity::beside_one(*factor, 4);
        row.push(match *factor > 1.0 {
            true => Cell::number(quantity),
            false => Cell::Bad(quantity),
        });
        row.extend([0, 1, 2].map(|at| Cell::number(units.stiffness(one, at))));
        row.extend([0, 1].map(|at| Cell::number(eccentricity(one, at))));
        row.push(Cell::number(per_one(one)));
        rows.push(row);
    }
    let mut row = vec![
        Cell::words(Plan::InTheFile),
        Cell::words(Sentence::of_symbol("")),
        Cell::Number(None),
    ];
    row.extend([0, 1, 2].map(|at| {
        let unit = units.unit(at);
        Cell::number(Quantity::new(written.stiffness[at], unit, Digits::Significant(4)))
    }));
    row.extend(
        written
            .eccentricity_m
            .map(|e| Cell::number(Quantity::new(e, Unit::si("m"), Digits::Fixed(3)))),
    );
    row.push(Cell::Number(None));
    rows.push(row);
    let mut caption = vec![Plan::Caption(all.len()).into(), Plan::Meaning.into()];
    if answer.found.eccentricity_from == EccentricityFrom::Stated {
        caption.push(Plan::Stated.into());
    }
    Table {
        caption,
        columns: vec![
            Column::words(Plan::Solution),
            Column::words(Plan::Verdict),
            Column::numbers(Sentence::of_symbol("λ"), Unit::ratio()),
            of_symbol("k x", &units.unit(0)),
            of_symbol("k y", &units.unit(1)),
            of_symbol("k θ", &units.unit(2)),
            of_symbol("e x", &metre),
            of_symbol("e y", &metre),
            Column::numbers(Plan::PerOne, Unit::percent()),
        ],
        rows,
    }
}

fn modes_table(answer: &PlanAnswer) -> Table {
    let share = |share: f64| Cell::number(Quantity::new(share, Unit::percent(), Digits::Fixed(1)));
    let mut rows = Vec::new();
    for (at, one) in answer.found.solutions.iter().enumerate() {
        if !one.is_accepted() {
            continue;
        }
        for (mode, shares) in answer.modes.iter().zip(one.energy_shares()) {
            let mut row = vec![
                Cell::words(Sentence::of_symbol(&letter(at))),
                Cell::number(Quantity::new(
                    mode.frequency_hz,
                    Unit::si("Hz"),
                    Digits::Significant(4),
                )),
            ];
            row.extend(shares.map(share));
            rows.push(row);
        }
    }
    let percent = |head: &str| Column::numbers(Sentence::of_symbol(head), Unit::percent());
    Table {
        caption: vec![Plan::ModesCaption.into(), Plan::ModesMeaning.into()],
        columns: vec![
            Column::words(Plan::Solution),
            Column::numbers(Plan::Frequency, Unit::si("Hz")),
            percent("x"),
            percent("y"),
            percent("θ"),
        ],
        rows,
    }
}

fn why_not(at: usize, why: &MovesOtherwise) -> Plan {
    Plan::Why {
        solution: Sentence::of_symbol(&letter(at)),
        frequency: hertz(why.frequency_hz, 0.0),
        would_be: motion_word(why.would_be),
        share: Quantity::new(why.share, Unit::percent(), Digits::Fixed(0)),
        measured: motion_word(why.measured),
    }
}

fn mode_words(mode: &PlanMode) -> Sentence {
    let frequency = hertz(mode.frequency_hz, mode.frequency_sd_hz);
    match (mode.motion, mode.twist) {
        (None, _) => Plan::Mode(frequency),
        (Some(motion), None) => Plan::ModeOf {
            frequency,
            motion: motion_word(motion),
        },
        (Some(motion), Some(twist)) => Plan::ModeTwist {
            frequency,
            motion: motion_word(motion),
            twist: Quantity {
                sd_si: Some(twist.sd).filter(|sd| *sd > 0.0),
                ..Quantity::new(twist.ratio, Unit::ratio(), Digits::Significant(3))
            },
        },
    }
    .into()
}

fn motion_word(motion: PlanMotion) -> Sentence {
    match motion {
        PlanMotion::X => Plan::AlongX,
        PlanMotion::Y => Plan::AlongY,
        PlanMotion::Torsion => Plan::Torsion,
    }
    .into()
}

fn symbol(motion: PlanMotion) -> Sentence {
    Sentence::of_symbol(match motion {
        PlanMotion::X => "k_x",
        PlanMotion::Y => "k_y",
        PlanMotion::Torsion => "k_θ",
    })
}

fn unit_si(motion: PlanMotion) -> &'static str {
    match motion {
        PlanMotion::X | PlanMotion::Y => "N/m",
        PlanMotion::Torsion => "N·m/rad",
    }
}

/// Error of a stiffness for an error of 1 % in the frequencies.
fn per_one(one: &PlanSolution) -> Quantity {
    Quantity::new(0.01 * one.amplification, Unit::percent(), Digits::Significant(2))
}

fn hertz(frequency_hz: f64, sd_hz: f64) -> Quantity {
    Quantity {
        sd_si: Some(sd_hz).filter(|sd| *sd > 0.0),
        ..Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Trimmed(5))
    }
}
