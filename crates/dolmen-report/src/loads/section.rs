//! The section of wind and static loads: combinations side by side, and the joints under the worst.

use super::findings::why_not;
use super::words::what;
use super::{on_buildings, on_frames, on_stones};
use crate::document::{Block, Cell, Column, Document, Figure, Table, table_series};
use crate::figures::chain_moments;
use crate::stack::direction;
use dolmen::stability::{ChainUnderLoads, JointUnderLoads, Verdict};
use dolmen::structure::stack::Stack;
use dolmen::structure::wind::{EurocodeTerrain, Kds41Exposure};
use dolmen_project::{FramePart, LoadPart, LoadsPart, WindGiven, WindPart, WindSpeed};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::loads::{ChainCombination, CombinationAnswer, Combined, LoadsAnswer, WindMet};

messages! {
    /// Tables and figures of wind and static loads.
    pub(crate) enum Shown in "loads" {
        Head => { en: "Wind and static loads", ko: "풍하중과 정하중" },
        NotKnown(why: Sentence) => {
            en: "The wind is not compared: {why}.",
            ko: "풍하중을 검토하지 못하였다. {why}.",
        },
        Gust { speed: String, coefficient: String } => {
            en: "The wind: a gust of {speed}, as given; force coefficient {coefficient}.",
            ko: "입력 풍하중: 최대순간풍속 {speed}, 풍력계수 {coefficient}.",
        },
        Pressure { pressure: String, coefficient: String } => {
            en: "The wind: a peak pressure of {pressure}, as given; force coefficient {coefficient}.",
            ko: "입력 풍하중: 최대 풍압 {pressure}, 풍력계수 {coefficient}.",
        },
        Eurocode { speed: String, terrain: String, orography: Quantity, coefficient: String } => {
            en: "The wind: {speed} as the mean of 10 minutes, EN 1991-1-4, terrain {terrain}, c_o {orography}; force coefficient {coefficient}.",
            ko: "입력 풍하중: 10분 평균 풍속 {speed}, EN 1991-1-4, 지형 {terrain}, c_o {orography}, 풍력계수 {coefficient}.",
        },
        Kds41 { speed: String, exposure: String, topography: Quantity, importance: Quantity, coefficient: String } => {
            en: "The wind: {speed} as the mean of 10 minutes, KDS 41 12 00 (its text was not at hand), exposure {exposure}, K_zt {topography}, I_w {importance}; force coefficient {coefficient}.",
            ko: "입력 풍하중: 10분 평균 풍속 {speed}, KDS 41 12 00(기준 원문 미확인), 지표면조도 {exposure}, K_zt {topography}, I_w {importance}, 풍력계수 {coefficient}.",
        },
        Source(source: String) => { en: "Source of the wind: {source}.", ko: "풍하중의 출처: {source}." },
        Listed { name: String, part: usize, what: String } => {
            en: "Static load ‘{name}’ on part {part}: {what}.",
            ko: "정하중 ‘{name}’(부재 {part}): {what}.",
        },
        SizeAndResonance(factor: Quantity) => {
            en: "c_s c_d {factor}, for size and resonance, multiplies the peak pressure.",
            ko: "최대 풍압에 규모·공진을 고려한 c_s c_d {factor}을(를) 곱하였다.",
        },
        GustFactor(factor: Quantity) => {
            en: "The gust factor G_D of {factor} multiplies the pressure of the mean.",
            ko: "평균 풍압에 가스트영향계수 G_D {factor}을(를) 곱하였다.",
        },
        Wind { force: Quantity, moment: Quantity, pressure: Quantity } => {
            en: "It pushes with {force} and a moment of {moment} about the lowest joint; its pressure at the top is {pressure}.",
            ko: "풍하중의 합력은 {force}, 최하단 접합면에 대한 모멘트는 {moment}, 최상단 풍압은 {pressure}이다.",
        },
        OnStone { name: String, stone: String, what: String } => {
            en: "Static load ‘{name}’ on {stone}: {what}.",
            ko: "정하중 ‘{name}’({stone}): {what}.",
        },
        WindOnStack { direction: Sentence, force: Quantity, moment: Quantity, pressure: Quantity } => {
            en: "The worst of eight directions is towards {direction}: it pushes with {force} and a moment of {moment} about the ground; its pressure at the top is {pressure}. The faces and corners of stones that stand along x and y are met so.",
            ko: "여덟 풍향 중 가장 불리한 것은 {direction} 방향이다. 풍하중의 합력은 {force}, 지반에 대한 모멘트는 {moment}, 최상단 풍압은 {pressure}이다. x·y축을 따라 놓인 석재의 면과 모서리에 부는 바람을 검토하였다.",
        },
        WindAtTop(pressure: Quantity) => {
            en: "The pressure of the wind at the top is {pressure}; the worst combination has no wind.",
            ko: "최상단 풍압은 {pressure}이며 가장 불리한 하중조합에는 풍하중이 없다.",
        },
        WindTowards => { en: "wind towards", ko: "풍향" },
        Tilt(tilt: Quantity) => {
            en: "The tilt as surveyed, 1/{tilt}, leans the same way in every combination.",
            ko: "실측 기울기 1/{tilt}을(를) 모든 하중조합에서 같은 방향으로 고려하였다.",
        },
        Combinations => { en: "Combinations.", ko: "하중조합." },
        CombinationsMeaning => {
            en: "“Borne ×” is what wind and static loads can be multiplied by until a joint reaches its limit, the weight as it is.",
            ko: "저항 배수는 자중을 그대로 두고 풍하중과 정하중에 곱하여 어느 접합면이 한계에 이르는 값이다.",
        },
        StackCombinationsMeaning => {
            en: "“Borne ×” is what wind and static loads can be multiplied by until no forces in the joints balance them, the weight as it is: the least of all loads together, of all but what presses downwards, and of the wind alone, without those downward loads that resist it.",
            ko: "저항 배수는 자중을 그대로 두고 풍하중과 정하중에 곱하여 접합력과의 평형이 불가능해지는 값이다. 모든 하중, 아래로 누르는 하중을 제외한 하중, 풍하중에 저항하는 연직하중 없이 풍하중만을 키운 경우 중 최솟값이다.",
        },
        Combination => { en: "Combination", ko: "하중조합" },
        VerdictHead => { en: "verdict", ko: "판정" },
        Weight => { en: "weight ×", ko: "자중 ×" },
        WindTimes => { en: "wind ×", ko: "풍하중 ×" },
        LoadsTimes => { en: "loads ×", ko: "정하중 ×" },
        Factor => { en: "borne ×", ko: "저항 배수" },
        Governs => { en: "joint", ko: "지배 접합면" },
        Stable => { en: "stable", ko: "안정" },
        Marginal => { en: "marginal", ko: "여유 부족" },
        Unstable => { en: "unstable", ko: "불안정" },
        Unknown => { en: "unknown", ko: "판정 불가" },
        Joints(what: Sentence) => { en: "{what}: joints.", ko: "{what}: 접합면별 결과." },
        JointsMeaning => {
            en: "The moment upright is that of the loads alone; in the leaning shape the weight adds to it. The limit is N·b/2, less with a strength of the bed.",
            ko: "연직 상태의 모멘트는 하중만에 의한 값이고, 기울어진 상태에서는 자중에 의한 모멘트가 더해진다. 한계는 N·b/2이며 접합면 강도가 주어지면 그보다 작다.",
        },
        JointsAlong(what: Sentence) => {
            en: "{what}: joints along, direction x.",
            ko: "{what}: 접합면별 결과, 운동 방향(x).",
        },
        JointsAcross(what: Sentence) => {
            en: "{what}: joints across, direction y.",
            ko: "{what}: 접합면별 결과, 직각 방향(y).",
        },
        BothTogether => {
            en: "“Borne ×” of a joint is of both directions together: until the resultant leaves what its bed passes towards that side.",
            ko: "접합면의 저항 배수는 두 방향을 합한 것으로, 합력이 그쪽 밑면의 한계를 벗어날 때까지의 값이다.",
        },
        WindAcross { force: Quantity, moment: Quantity } => {
            en: "Blowing across it pushes with {force} and a moment of {moment} about the lowest joint; from between, with cos φ of the one and sin φ of the other.",
            ko: "직각 방향의 바람은 합력 {force}, 최하단 접합면에 대한 모멘트 {moment}(으)로 민다. 그 사이의 풍향에서는 각각 cos φ배와 sin φ배로 작용한다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Axial => { en: "N", ko: "N" },
        Shear => { en: "shear", ko: "전단력" },
        Upright => { en: "moment upright", ko: "모멘트(연직)" },
        Leaning => { en: "leaning", ko: "모멘트(변형 후)" },
        OfTilt => { en: "of the tilt", ko: "기울기 모멘트" },
        Limit => { en: "limit", ko: "한계" },
        Top(top: Quantity) => {
            en: "The top moves by {top} under these loads.",
            ko: "이 하중에서 최상단의 변위는 {top}이다.",
        },
        Opens => {
            en: "Springs are linear here up to the limit, but a bed begins to open at a third of it and is softer from there: bearing little more than once the load is no proof.",
            ko: "여기서는 한계까지 선형 스프링으로 계산하나, 접합면은 한계의 3분의 1에서 벌어지기 시작하여 강성이 저하된다. 1을 조금 넘는 저항 배수는 안전의 증거가 아니다.",
        },
        Figure => { en: "Moments against what the beds pass.", ko: "작용 모멘트와 접합면 한계." },
        FigureAcross => {
            en: "Moments across against what the beds pass.",
            ko: "직각 방향 작용 모멘트와 접합면 한계.",
        },
        FigureMeaning => {
            en: "Where a line of a moment lies to the right of the limit, the bed stands on its edge.",
            ko: "모멘트 선이 한계선의 오른쪽에 있으면 접합면은 모서리로만 지지된다.",
        },
    }
}

/// Digits in tables.
const DIGITS: usize = 4;

/// The loaded structure.
pub(crate) enum Loaded<'a> {
    /// A chain, with the heights of its joints, m.
    Chain(Vec<f64>),
    /// A stack.
    Stack(&'a Stack),
    /// A frame, with the names of its storeys.
    Frame(Vec<Option<String>>),
    /// A building, with the names of its floors.
    Building(&'a [String]),
}

impl<'a> Loaded<'a> {
    pub(crate) fn of_frame(part: &FramePart) -> Self {
        Loaded::Frame(part.storeys.iter().map(|storey| storey.name.clone()).collect())
    }

    fn stack(&self) -> Option<&'a Stack> {
        match self {
            Loaded::Chain(_) | Loaded::Frame(_) | Loaded::Building(_) => None,
            Loaded::Stack(stack) => Some(stack),
        }
    }
}

/// The section; empty if there are no loads except the weight.
pub(crate) fn sections<'a>(
    given: &LoadsPart,
    answer: Option<&'a LoadsAnswer>,
    of: Loaded<'a>,
) -> Document<'a> {
    let mut document = Document::default();
    let Some(answer) = answer else {
        return document;
    };
    document.heading(Shown::Head);
    let floors = match of {
        Loaded::Building(floors) => Some(floors),
        Loaded::Chain(_) | Loaded::Stack(_) | Loaded::Frame(_) => None,
    };
    // the section on the motion of a building in the wind has its wind
    if let (WindPart::Given(wind), None) = (&given.wind, floors) {
        document.paragraph(as_given(wind));
        if let Some(Ok(met)) = &answer.wind {
            let factor = Quantity::ratio(met.response_factor, 3);
            match &wind.speed {
                WindSpeed::Eurocode { .. } => document.paragraph(Shown::SizeAndResonance(factor)),
                WindSpeed::Kds41 { .. } => document.paragraph(Shown::GustFactor(factor)),
                WindSpeed::Gust(_) | WindSpeed::Pressure(_) => {}
            }
        }
        if let Some(source) = wind.source.clone() {
            document.paragraph(Shown::Source(source));
        }
    }
    for load in &given.loads {
        match floors.and_then(|floors| floors.get(load.part)) {
            Some(floor) => document.paragraph(on_buildings::listed(load, floor)),
            None => document.paragraph(listed(load, of.stack())),
        }
    }
    match &answer.wind {
        Some(Err(why)) => document.note(Shown::NotKnown(why_not(why, of.stack().is_some()))),
        Some(Ok(_)) if !answer.frame_winds.is_empty() => {
            let each = answer.frame_winds.iter();
            each.for_each(|of| document.paragraph(on_frames::wind(of)));
        }
        Some(Ok(met)) => document.paragraph(wind(met, answer)),
        None => {}
    }
    if let Some(met) = &answer.wind_across {
        document.paragraph(Shown::WindAcross {
            force: Quantity::engineering(met.force_n, "N", DIGITS),
            moment: Quantity::engineering(met.moment_n_m, "N·m", DIGITS),
        });
    }
    if answer.tilt_rad > 0.0 {
        document.paragraph(Shown::Tilt(Quantity::ratio(1.0 / answer.tilt_rad, 3)));
    }
    if let Some(worst) = answer.worst() {
        if answer.combinations.len() > 1 || worst.name.is_some() {
            document.put(Block::Table(match floors {
                Some(_) => on_buildings::combinations(answer),
                None => combinations(answer),
            }));
        }
        match (&worst.of, of) {
            (Combined::Chain(chain), Loaded::Chain(heights_m)) => {
                chain_section(&mut document, what(answer, worst), answer, chain, heights_m);
            }
            (Combined::Stack(under), Loaded::Stack(stack)) => {
                on_stones::section(&mut document, what(answer, worst), under, stack, given);
            }
            (Combined::Frame(frame), Loaded::Frame(names)) => {
                on_frames::section(&mut document, &what(answer, worst), frame, &names);
            }
            (Combined::Building(building), Loaded::Building(_)) => {
                on_buildings::section(&mut document, &what(answer, worst), building);
            }
            (Combined::Chain(_) | Combined::Stack(_) | Combined::Frame(_) | Combined::Building(_), _) => {}
        }
    }
    document
}

fn chain_section<'a>(
    document: &mut Document<'a>,
    what: Sentence,
    answer: &LoadsAnswer,
    chain: &'a ChainCombination,
    heights_m: Vec<f64>,
) {
    let across = chain.across.as_ref().map(|across| &across.under);
    let top = |under: &ChainUnderLoads| under.top_displacement_m;
    let top_m = match across {
        None => {
            let caption = Shown::Joints(what).into();
            document.put(Block::Table(joints(caption, answer, &chain.under)));
            top(&chain.under)
        }
        Some(across) => {
            let along = Shown::JointsAlong(what.clone()).into();
            document.put(Block::Table(joints(along, answer, &chain.under)));
            let caption = Shown::JointsAcross(what).into();
            document.put(Block::Table(joints(caption, answer, across)));
            document.note(Shown::BothTogether);
            top(&chain.under).zip(top(across)).map(|(x, y)| x.hypot(y))
        }
    };
    if let Some(top_m) = top_m {
        document.paragraph(Shown::Top(Quantity::engineering(top_m.abs(), "m", 3)));
    }
    document.note(Shown::Opens);
    let caption = vec![Shown::Figure.into(), Shown::FigureMeaning.into()];
    let heights_across = heights_m.clone();
    let drawn = Figure::drawn(caption, move |language| {
        chain_moments(&chain.under, &heights_m, language)
    });
    let along = joints(Shown::Figure.into(), answer, &chain.under);
    document.charted(drawn.with_series(move || table_series(&along)));
    if let Some(across) = &chain.across {
        let caption = vec![Shown::FigureAcross.into(), Shown::FigureMeaning.into()];
        let drawn = Figure::drawn(caption, move |language| {
            chain_moments(&across.under, &heights_across, language)
        });
        let across = joints(Shown::FigureAcross.into(), answer, &across.under);
        document.charted(drawn.with_series(move || table_series(&across)));
    }
}

/// The wind in the file, and the result of its code.
pub(crate) fn as_given(wind: &WindGiven) -> Shown {
    let coefficient = wind.force_coefficient.written.clone();
    match &wind.speed {
        WindSpeed::Pressure(pressure) => Shown::Pressure {
            pressure: pressure.written.clone(),
            coefficient,
        },
        WindSpeed::Gust(speed) => Shown::Gust {
            speed: speed.written.clone(),
            coefficient,
        },
        WindSpeed::Eurocode {
            speed,
            terrain,
            orography,
        } => Shown::Eurocode {
            speed: speed.written.clone(),
            terrain: match terrain {
                EurocodeTerrain::Zero => "0",
                EurocodeTerrain::I => "I",
                EurocodeTerrain::Ii => "II",
                EurocodeTerrain::Iii => "III",
                EurocodeTerrain::Iv => "IV",
            }
            .to_owned(),
            orography: Quantity::ratio(*orography, 3),
            coefficient,
        },
        WindSpeed::Kds41 {
            speed,
            exposure,
            topography,
            importance,
        } => Shown::Kds41 {
            speed: speed.written.clone(),
            exposure: match exposure {
                Kds41Exposure::A => "A",
                Kds41Exposure::B => "B",
                Kds41Exposure::C => "C",
                Kds41Exposure::D => "D",
            }
            .to_owned(),
            topography: Quantity::ratio(*topography, 3),
            importance: Quantity::ratio(*importance, 3),
            coefficient,
        },
    }
}

fn listed(load: &LoadPart, stack: Option<&Stack>) -> Shown {
    let values = [&load.force, &load.force_across, &load.weight, &load.moment];
    let mut written: Vec<String> = values
        .into_iter()
        .flatten()
        .map(|value| value.written.clone())
        .collect();
    let components = load.components.iter().flatten().zip(["x", "y", "z"]);
    let acting = components.filter(|(value, _)| value.value != 0.0);
    written.extend(acting.map(|(value, axis)| format!("{axis} {}", value.written)));
    let (name, what) = (load.name.clone(), written.join(", "));
    match stack.and_then(|stack| stack.blocks().get(load.part)) {
        Some(stone) => Shown::OnStone {
            name,
            stone: stone.name.clone(),
            what,
        },
        None => Shown::Listed {
            name,
            part: load.part + 1,
            what,
        },
    }
}

fn wind(met: &WindMet, answer: &LoadsAnswer) -> Shown {
    let force = Quantity::engineering(met.force_n, "N", DIGITS);
    let moment = Quantity::engineering(met.moment_n_m, "N·m", DIGITS);
    let pressure = Quantity::engineering(met.pressure_at_top_pa, "Pa", DIGITS);
    let under = answer.worst().and_then(CombinationAnswer::stack);
    match under.and_then(|under| under.wind_to) {
        Some(to) => Shown::WindOnStack {
            direction: direction(to),
            force,
            moment,
            pressure,
        },
        None if under.is_some() => Shown::WindAtTop(pressure),
        None => Shown::Wind {
            force,
            moment,
            pressure,
        },
    }
}

fn verdict_word(verdict: Verdict) -> Shown {
    match verdict {
        Verdict::Stable => Shown::Stable,
        Verdict::Marginal => Shown::Marginal,
        Verdict::Unstable => Shown::Unstable,
        Verdict::Unknown => Shown::Unknown,
    }
}

fn combinations(answer: &LoadsAnswer) -> Table {
    let row = |of: &CombinationAnswer| {
        let verdict = of.verdict();
        let word = Sentence::from(verdict_word(verdict));
        let factor = of.factor().map(|factor| Quantity::beside_one(factor, DIGITS));
        vec![
            Cell::words(what(answer, of)),
            match verdict {
                Verdict::Unstable => Cell::BadWords(word),
                _ => Cell::Words(word),
            },
            Cell::number(Quantity::ratio(of.weight, 3)),
            Cell::number(Quantity::ratio(of.wind, 3)),
            Cell::number(Quantity::ratio(of.loads, 3)),
            match (verdict, factor) {
                (Verdict::Unstable, Some(factor)) => Cell::Bad(factor),
                (_, factor) => Cell::Number(factor),
            },
            match &of.of {
                Combined::Chain(chain) => Cell::Number(
                    chain
                        .under
                        .governing_joint
                        .map(|joint| Quantity::new(joint as f64, Unit::ratio(), Digits::Fixed(0))),
                ),
                Combined::Frame(frame) => on_frames::governs(frame),
                Combined::Building(_) => Cell::Number(None),
                Combined::Stack(under) => {
                    Cell::words(under.wind_to.map_or_else(|| Sentence::of_symbol("–"), direction))
                }
            },
        ]
    };
    let of_stack = answer.combinations.iter().any(|of| of.stack().is_some());
    let of_frame = answer.combinations.iter().any(|of| of.frame().is_some());
    let numbers = |head: Sentence| Column::numbers(head, Unit::ratio());
    let (meaning, last): (Sentence, Column) = match (of_stack, of_frame) {
        (true, _) => (
            Shown::StackCombinationsMeaning.into(),
            Column::words(Shown::WindTowards),
        ),
        (_, true) => (
            on_frames::OnFrames::CombinationsMeaning.into(),
            numbers(on_frames::OnFrames::Governs.into()),
        ),
        _ => (Shown::CombinationsMeaning.into(), numbers(Shown::Governs.into())),
    };
    Table {
        caption: vec![Shown::Combinations.into(), meaning],
        columns: vec![
            Column::words(Shown::Combination),
            Column::words(Shown::VerdictHead),
            Column::numbers(Shown::Weight, Unit::ratio()),
            Column::numbers(Shown::WindTimes, Unit::ratio()),
            Column::numbers(Shown::LoadsTimes, Unit::ratio()),
            Column::numbers(Shown::Factor, Unit::ratio()),
            last,
        ],
        rows: answer.combinations.iter().map(row).collect(),
    }
}

fn joints(caption: Sentence, answer: &LoadsAnswer, under: &ChainUnderLoads) -> Table {
    let all = &under.joints;
    let largest = |value: fn(&JointUnderLoads) -> f64| -> f64 {
        all.iter().map(value).map(f64::abs).fold(0.0, f64::max)
    };
    let newton = Unit::of(&[largest(|joint| joint.axial_n)], "N");
    let moment = Unit::of(
        &[largest(|joint| {
            joint.moment_n_m.unwrap_or(joint.rigid_moment_n_m)
        })],
        "N·m",
    );
    let has_tilt = answer.tilt_rad > 0.0;
    let number = |value: f64, unit: &Unit| Quantity::new(value, unit.clone(), Digits::Significant(DIGITS));
    let row = |(i, joint): (usize, &JointUnderLoads)| {
        let cell = |value: Option<f64>| Cell::Number(value.map(|value| number(value, &moment)));
        let mut row = vec![
            Cell::words(Shown::Number(i + 1)),
            Cell::number(number(joint.axial_n, &newton)),
            Cell::number(number(joint.shear_n, &newton)),
            cell(Some(joint.rigid_moment_n_m)),
            cell(joint.moment_n_m),
        ];
        if has_tilt {
            row.push(cell(Some(joint.tilt_moment_n_m)));
        }
        row.push(cell(joint.limit_n_m));
        let factor = joint.factor.filter(|factor| factor.is_finite());
        row.push(
            match factor.map(|factor| (factor, Quantity::beside_one(factor, DIGITS))) {
                Some((factor, shown)) if factor <= 1.0 => Cell::Bad(shown),
                Some((_, shown)) => Cell::number(shown),
                None => Cell::Number(None),
            },
        );
        row
    };
    let mut columns = vec![
        Column::words(Shown::Joint),
        Column::numbers(Shown::Axial, newton.clone()),
        Column::numbers(Shown::Shear, newton.clone()),
        Column::numbers(Shown::Upright, moment.clone()),
        Column::numbers(Shown::Leaning, moment.clone()),
    ];
    if has_tilt {
        columns.push(Column::numbers(Shown::OfTilt, moment.clone()));
    }
    columns.push(Column::numbers(Shown::Limit, moment.clone()));
    columns.push(Column::numbers(Shown::Factor, Unit::ratio()));
    Table {
        caption: vec![caption, Shown::JointsMeaning.into()],
        columns,
        rows: all.iter().enumerate().map(row).collect(),
    }
}
