//! A frame under wind and static loads: findings, and the tables and figure of its storeys.

use super::words::{DIGITS, Found, what};
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone};
use crate::figures::{pushed_series, storey_pushed};
use dolmen::assess::demand::DriftLimit;
use dolmen::stability::{StoreyEnd, Verdict};
use dolmen_project::{Project, Structure};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::loads::{DirectionUnderLoads, FrameCombination, FrameWind, LoadedStorey, LoadsAnswer};

messages! {
    /// The section of a frame under wind and static loads.
    pub(crate) enum OnFrames in "loads.frames" {
        Wind { direction: String, area: Quantity, force: Quantity, pressure: Quantity } => {
            en: "Along direction {direction} the wind meets {area} and pushes with {force}; its pressure at the top is {pressure}. It blows both ways.",
            ko: "{direction} 방향의 바람은 면적 {area}에 합력 {force}(으)로 작용하며 최상단 풍압은 {pressure}이다. 양쪽 풍향을 검토하였다.",
        },
        Slipping { direction: String, stuck: Quantity, slipping: Quantity, force: Quantity, slipping_force: Quantity } => {
            en: "Direction {direction}: the gust slips joints, and with all of them slipping the frame swings at {slipping} in place of {stuck}. The wind at that frequency pushes with {slipping_force} in place of {force}; it acts where joints slip.",
            ko: "{direction} 방향: 돌풍에 접합부가 미끄러진다. 모두 미끄러지면 고유진동수가 {stuck}에서 {slipping}(으)로 낮아지고, 그 진동수의 풍하중 합력은 {force}이(가) 아니라 {slipping_force}이다. 접합부가 미끄러지는 상태에 이 값을 쓴다.",
        },
        Storeys { what: Sentence, direction: String } => {
            en: "{what}: storeys in direction {direction}.",
            ko: "{what}: {direction} 방향 층별 결과.",
        },
        StoreysMeaning => {
            en: "The shear is that of the loads on the storey and all above. It drifts until springs, columns and P-delta hold it; friction of joints holds nothing here. “Borne ×” is what wind and static loads can be multiplied by until the storey falls, the weight and the lean as they are.",
            ko: "전단력은 해당 층과 그 위층에 작용하는 하중의 합이다. 스프링, 기둥, P-델타 효과가 평형을 이룰 때까지 변위하며 접합부 마찰은 저항으로 고려하지 않는다. 저항 배수는 자중과 기울기를 그대로 두고 풍하중과 정하중에 곱하여 층이 붕괴하는 값이다.",
        },
        CombinationsMeaning => {
            en: "“Borne ×” is what wind and static loads can be multiplied by until a storey falls, the weight as it is.",
            ko: "저항 배수는 자중을 그대로 두고 풍하중과 정하중에 곱하여 어느 층이 붕괴하는 값이다.",
        },
        Storey => { en: "Storey", ko: "층" },
        Shear => { en: "shear", ko: "전단력" },
        Axial => { en: "N", ko: "N" },
        Drift => { en: "drift", ko: "층간변위" },
        Lean => { en: "lean", ko: "층간변위각" },
        Greatest => { en: "greatest force", ko: "최대 저항력" },
        FallsAt => { en: "falls at", ko: "붕괴 변위" },
        Borne => { en: "borne ×", ko: "저항 배수" },
        Governs => { en: "storey", ko: "지배 층" },
        Slips => {
            en: "Where joints slip, the storey has the stiffness that slipping leaves; the worse of both states stands here.",
            ko: "미끄러지는 접합부는 미끄러진 뒤의 강성을 쓰며 두 상태 중 불리한 값을 나타냈다.",
        },
        Linear => {
            en: "Joints and walls are linear here up to a drift of 10 % of the height, at which a storey counts as fallen: bearing many times the load proves little where nobody knows what the tenons bear.",
            ko: "여기서는 붕괴로 보는 층고의 10 % 변위까지 접합부와 벽체를 선형으로 계산한다. 장부의 내력을 모르면 저항 배수가 커도 안전의 증거로는 부족하다.",
        },
        Figure { storey: Sentence, direction: String } => {
            en: "What {storey} resists with against drift, direction {direction}.",
            ko: "{direction} 방향 {storey}의 저항력-층간변위 곡선.",
        },
        FigureMeaning => {
            en: "P-delta is in the curve. The level line is what pushes the storey, with what its weight adds by the lean.",
            ko: "곡선에는 P-델타 효과가 포함되어 있다. 수평선은 기울기에 의한 자중의 몫을 포함한 작용 전단력이다.",
        },
    }
}

/// Names of the storeys of a frame, if the file gives them.
fn names_of(project: &Project) -> Vec<Option<String>> {
    match &project.structure {
        Structure::Frame(part) => part.storeys.iter().map(|storey| storey.name.clone()).collect(),
        _ => Vec::new(),
    }
}

/// A storey by its name or number, from 0.
fn storey_words(names: &[Option<String>], storey: usize) -> Sentence {
    match names.get(storey).cloned().flatten() {
        Some(name) => Found::StoreyName(name),
        None => Found::StoreyNumber(storey + 1),
    }
    .into()
}

/// The capacity of a frame under a combination.
pub(super) fn borne(project: &Project, what: Sentence, frame: &FrameCombination) -> Option<Finding> {
    let verdict = frame.verdict();
    let tone = Tone::of(verdict);
    let stable = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
    let Some((direction, storey, of)) = frame.governing() else {
        return Some(unknown(what, frame));
    };
    let by_loads = frame.factor().map_or(Verdict::Unknown, |factor| match factor {
        f64::INFINITY => Verdict::Stable,
        factor => Verdict::of_load_factor(factor),
    });
    if by_loads != Verdict::Unstable && !frame.unknown.is_empty() && verdict != Verdict::Unstable {
        return Some(unknown(what, frame));
    }
    if of.under.factor == 0.0 {
        return Some(Finding::key(tone, Found::Falls(what)));
    }
    let weighs_too_much = matches!(frame.weight_verdict(), Verdict::Marginal | Verdict::Unstable);
    if let (true, Verdict::Stable, Some(factor)) = (weighs_too_much, by_loads, frame.weight_factor) {
        let factor = Quantity::beside_one(factor, DIGITS);
        return Some(Finding::key(tone, Found::Heavy { what, factor, stable }));
    }
    if of.under.factor == f64::INFINITY {
        return Some(Finding::key(Tone::Plain, Found::NothingPushes(what)));
    }
    let (direction, storey) = (
        direction.direction.clone(),
        storey_words(&names_of(project), storey),
    );
    let force = Quantity::engineering(of.under.shear_n.abs(), "N", DIGITS);
    let factor = Quantity::beside_one(of.under.factor, DIGITS);
    let drift_m = |m: f64| Quantity::engineering(m, "m", DIGITS);
    let said = match (of.under.drift_m, of.under.end, of.under.greatest_n) {
        (Some(drift), _, _) => Found::FrameBears {
            what,
            direction,
            storey,
            force,
            drift: drift_m(drift),
            share: Quantity::percent(drift / of.height_m, DIGITS),
            factor,
            stable,
        },
        (None, StoreyEnd::Force, Some(most)) => Found::FrameFalls {
            what,
            direction,
            storey,
            force,
            most: Quantity::engineering(most, "N", DIGITS),
            factor,
        },
        (None, _, _) => Found::FrameFallsByDrift {
            what,
            direction,
            storey,
            force,
            most: drift_m(of.under.drift_most_m),
            factor,
        },
    };
    Some(Finding::key(tone, said))
}

fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(DIGITS))
}

fn unknown(what: Sentence, frame: &FrameCombination) -> Finding {
    let directions = frame.unknown.join(", ");
    Finding::key(Tone::Unknown, Found::FrameUnknown { what, directions })
}

/// The largest lean of all combinations, compared with a drift limit that the file gives as a number.
pub(super) fn drifts(project: &Project, answer: &LoadsAnswer) -> Option<Finding> {
    let Some(limit @ DriftLimit::Given { .. }) = &project.drift_limit else {
        return None;
    };
    let allowed = limit.ratio();
    let each = answer.combinations.iter().flat_map(|combination| {
        let directions = combination
            .frame()
            .into_iter()
            .flat_map(|frame| &frame.directions);
        directions.flat_map(move |direction| {
            let storeys = direction.storeys.iter().enumerate();
            storeys.filter_map(move |(i, storey)| Some((storey.lean()?, combination, direction, i)))
        })
    });
    let pushed = each.filter(|(_, _, direction, i)| direction.storeys[*i].under.shear_n != 0.0);
    let (lean, combination, direction, storey) = pushed.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let (what, direction) = (what(answer, combination), direction.direction.clone());
    let storey = storey_words(&names_of(project), storey);
    let is_beyond = lean > allowed;
    let lean = Quantity::percent(lean, DIGITS);
    let allowed = Quantity::percent(allowed, DIGITS);
    Some(match is_beyond {
        true => Finding::key(
            Tone::Bad,
            Found::DriftsBeyond {
                what,
                direction,
                storey,
                lean,
                allowed,
            },
        ),
        false => Finding::key(
            Tone::Good,
            Found::DriftsWithin {
                what,
                direction,
                storey,
                lean,
                allowed,
            },
        ),
    })
}

/// The wind along each direction, and the storeys of each under the worst combination; the curve of the governing storey.
pub(super) fn section<'a>(
    document: &mut Document<'a>,
    what: &Sentence,
    frame: &'a FrameCombination,
    names: &[Option<String>],
) {
    for direction in &frame.directions {
        document.put(Block::Table(storeys(what, direction, names)));
    }
    let all = || frame.directions.iter().flat_map(|direction| &direction.storeys);
    if all().any(|storey| storey.slips) {
        document.note(OnFrames::Slips);
    }
    if all().any(|storey| storey.under.end == StoreyEnd::Drift) {
        document.note(OnFrames::Linear);
    }
    let Some((direction, storey, of)) = frame.governing() else {
        return;
    };
    if of.under.curve.is_empty() || of.under.shear_n == 0.0 {
        return;
    }
    let caption = vec![
        OnFrames::Figure {
            storey: storey_words(names, storey),
            direction: direction.direction.clone(),
        }
        .into(),
        OnFrames::FigureMeaning.into(),
    ];
    let drawn = Figure::drawn(caption, move |language| storey_pushed(of, language));
    document.charted(drawn.with_series(move || pushed_series(of)));
}

/// The wind along a direction.
pub(super) fn wind(of: &FrameWind) -> OnFrames {
    let met = &of.met;
    OnFrames::Wind {
        direction: of.direction.clone(),
        area: Quantity::new(
            met.links.iter().map(|storey| storey.area_m2).sum(),
            Unit::si("m²"),
            Digits::Significant(DIGITS),
        ),
        force: Quantity::engineering(met.force_n, "N", DIGITS + 1),
        pressure: Quantity::engineering(met.pressure_at_top_pa, "Pa", DIGITS + 1),
    }
}

/// The wind along each direction whose joints a gust slips.
pub(super) fn slipping(answer: &LoadsAnswer) -> Vec<Finding> {
    let each = answer.frame_winds.iter().filter_map(|of| {
        let slipping = &of.slipping.as_ref()?.met;
        let said = OnFrames::Slipping {
            direction: of.direction.clone(),
            stuck: hertz(of.met.frequency_hz?),
            slipping: hertz(slipping.frequency_hz?),
            force: Quantity::engineering(of.met.force_n, "N", DIGITS + 1),
            slipping_force: Quantity::engineering(slipping.force_n, "N", DIGITS + 1),
        };
        Some(Finding::key(Tone::Plain, said))
    });
    each.collect()
}

/// The governing storey of a combination, in a table.
pub(super) fn governs(frame: &FrameCombination) -> Cell {
    let number = frame.governing().map(|(_, storey, _)| storey + 1);
    Cell::Number(number.map(|storey| Quantity::new(storey as f64, Unit::ratio(), Digits::Fixed(0))))
}

fn storeys(what: &Sentence, direction: &DirectionUnderLoads, names: &[Option<String>]) -> Table {
    let all = &direction.storeys;
    let largest = |of: &dyn Fn(&LoadedStorey) -> Option<f64>| {
        let values = all.iter().filter_map(of).map(f64::abs);
        values.fold(0.0, f64::max)
    };
    let shear = Unit::of(&[largest(&|of| Some(of.under.shear_n))], "N");
    let axial = Unit::of(&[largest(&|of| Some(of.under.axial_n))], "N");
    let most = Unit::of(&[largest(&|of| of.under.greatest_n)], "N");
    let length = Unit::of(
        &[largest(&|of| {
            Some(of.under.drift_m.unwrap_or(of.under.drift_most_m))
        })],
        "m",
    );
    let number =
        |value: f64, unit: &Unit| Quantity::new(value, unit.clone(), Digits::Significant(DIGITS + 1));
    let row = |(i, of): (usize, &LoadedStorey)| {
        let under = &of.under;
        let factor = Some(under.factor).filter(|factor| factor.is_finite());
        vec![
            Cell::words(storey_words(names, i)),
            Cell::number(number(under.axial_n, &axial)),
            Cell::number(number(under.shear_n.abs(), &shear)),
            Cell::Number(under.drift_m.map(|m| number(m, &length))),
            Cell::Number(of.lean().map(|lean| Quantity::percent(lean, DIGITS))),
            Cell::Number(under.greatest_n.map(|force| number(force, &most))),
            Cell::number(number(under.drift_most_m, &length)),
            match factor.map(|factor| (factor, Quantity::beside_one(factor, DIGITS + 1))) {
                Some((factor, shown)) if factor <= 1.0 => Cell::Bad(shown),
                Some((_, shown)) => Cell::number(shown),
                None => Cell::Number(None),
            },
        ]
    };
    Table {
        caption: vec![
            OnFrames::Storeys {
                what: what.clone(),
                direction: direction.direction.clone(),
            }
            .into(),
            OnFrames::StoreysMeaning.into(),
        ],
        columns: vec![
            Column::words(OnFrames::Storey),
            Column::numbers(OnFrames::Axial, axial.clone()),
            Column::numbers(OnFrames::Shear, shear.clone()),
            Column::numbers(OnFrames::Drift, length.clone()),
            Column::numbers(OnFrames::Lean, Unit::percent()),
            Column::numbers(OnFrames::Greatest, most.clone()),
            Column::numbers(OnFrames::FallsAt, length.clone()),
            Column::numbers(OnFrames::Borne, Unit::ratio()),
        ],
        rows: all.iter().enumerate().map(row).collect(),
    }
}
