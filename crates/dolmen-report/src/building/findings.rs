//! Findings of a building's check.

use super::wind_findings::{beyond_room as beyond_room_in_wind, wind_findings};
use super::words::{floor_words, millimetres, of_both, significant, stroke_words};
use crate::document::{Finding, Tone};
use crate::load_factor::{Falls, load_factor_finding};
use crate::text::GROWN;
use dolmen::damper::DamperKind;
use dolmen::stability::Verdict;
use dolmen::structure::building::{StoreyFall, StoreyMotion};
use dolmen_project::strokes_of;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::building::{AccidentalTorsion, BuildingAnswer, BuildingSpectral, StandingBuilding};
use dolmen_work::state::{Check, VariantAnswer};

/// Share of the energy in rotation, in a sway mode, from which a finding reports torsion. Our choice.
const TWISTS: f64 = 0.02;

messages! {
    /// Findings on a building.
    pub(crate) enum Found in "building.findings" {
        FallsTwisting { floor: Sentence, factor: Quantity } => {
            en: "The storey below floor {floor} has the least margin: it would fall by twisting under {factor} times the weight above it.",
            ko: "여유가 가장 작은 층은 {floor} 바닥 아래층이며, 상부 무게의 {factor}배에서 비틀림으로 붕괴한다.",
        },
        FallsSwaying { floor: Sentence, factor: Quantity } => {
            en: "The storey below floor {floor} has the least margin: it would fall by swaying under {factor} times the weight above it.",
            ko: "여유가 가장 작은 층은 {floor} 바닥 아래층이며, 상부 무게의 {factor}배에서 횡변위로 붕괴한다.",
        },
        LowestFrequency { frequency: Quantity } => {
            en: "The lowest natural frequency is {frequency}.",
            ko: "최저 고유진동수는 {frequency}이다.",
        },
        Twists { share: Quantity, mode: usize } => {
            en: "The building twists as it sways: {share} of the energy of mode {mode} is rotation, so that its edges move unequally.",
            ko: "횡변위와 비틀림이 연성되어 있다. {mode}차 모드 에너지의 {share}이(가) 회전이므로 양 끝의 변위가 다르다.",
        },
        NoOutline => {
            en: "No floor has an outline: drifts at the edges, the largest where it twists, are not known.",
            ko: "바닥 외곽선이 없어 비틀림 때 가장 큰 단부 층간변위를 알 수 없다.",
        },
        Drift { ratio: Quantity, floor: Sentence } => {
            en: "By the spectrum of the site the largest elastic drift at an edge is {ratio} of the storey height, below floor {floor}.",
            ko: "부지 스펙트럼에 의한 최대 탄성 층간변위(단부)는 {floor} 바닥 아래에서 층고의 {ratio}이다.",
        },
        DriftDamped { ratio: Quantity, floor: Sentence } => {
            en: "By the spectrum of the site the largest elastic drift at an edge, with the dampers, is {ratio} of the storey height, below floor {floor}.",
            ko: "부지 스펙트럼에 의한 감쇠기를 포함한 최대 탄성 층간변위(단부)는 {floor} 바닥 아래에서 층고의 {ratio}이다.",
        },
        Torsion { code: String, fraction: Quantity, ratio: Quantity, floor: Sentence } => {
            en: "With the accidental torsion of {code}, each centre of mass {fraction} of the side of its floor off its place, it is {ratio}, below floor {floor}.",
            ko: "{code}의 우발비틀림(각 층 질량중심을 바닥 변 길이의 {fraction}만큼 이동)을 고려하면 {floor} 바닥 아래에서 {ratio}이다.",
        },
        TorsionOfFile { fraction: Quantity, ratio: Quantity, floor: Sentence } => {
            en: "With accidental torsion, each centre of mass {fraction} of the side of its floor off its place, it is {ratio}, below floor {floor}.",
            ko: "우발비틀림(각 층 질량중심을 바닥 변 길이의 {fraction}만큼 이동)을 고려하면 {floor} 바닥 아래에서 {ratio}이다.",
        },
        TorsionLeftOut { code: String } => {
            en: "The accidental torsion that {code} requires, 5 % of the side of each floor, is left out: the file «has accidental_eccentricity = 0|sets it to 0».",
            ko: "{code}이(가) 요구하는 우발비틀림(바닥 변 길이의 5 %)을 제외하였다. 파일에 «accidental_eccentricity = 0으로|우발편심이 0으로» 입력되어 있다.",
        },
        TorsionNoOutline => {
            en: "Accidental torsion is not included: it depends on the sides of the floors, and a floor has neither sides nor outline. Give them; without them a sufficient capacity is not decided.",
            ko: "우발비틀림을 고려하지 못했다. 바닥 변의 길이가 필요한데 sides와 outline이 모두 없는 층이 있다. 입력하기 전에는 기준을 만족해도 판정하지 않는다.",
        },
        TorsionRefused { why: Both } => {
            en: "Accidental torsion is not included, so that a sufficient capacity is not decided: {why}",
            ko: "우발비틀림을 고려하지 못해 기준을 만족해도 판정하지 않는다: {why}",
        },
        MoreWithDampers { list: Vec<Sentence> } => {
            en: "With the dampers some of the response to the spectrum is more than without, by these factors: {list}.",
            ko: "감쇠기로 인해 부지 스펙트럼에 대한 응답 일부가 커진다(배수): {list}.",
        },
        Factor { what: Sentence, ratio: Quantity } => { en: "{what} {ratio}", ko: "{what} {ratio}" },
        HardlyMoves { damper: Sentence, mode: usize, share: Quantity } => {
            en: "Damper {damper} hardly moves with mode {mode}, to which it is tuned: its mass is {share} of that mode's. Another mode, place or direction is probably meant.",
            ko: "감쇠기 {damper}은(는) 동조 대상인 {mode}차 모드에서 거의 움직이지 않는다(모드 질량의 {share}). 다른 모드나 위치, 방향을 뜻한 것으로 보인다.",
        },
        BeyondRoom { damper: Sentence, needed: Quantity, has: Quantity } => {
            en: "Damper {damper} is beyond its room under the spectrum of the site: it needs {needed} each way and has {has}.",
            ko: "부지 스펙트럼에서 감쇠기 {damper}의 행정 {needed}이(가) 여유 공간 {has}을(를) 넘는다.",
        },
        RoomNotGiven { damper: Sentence, needed: Quantity } => {
            en: "This holds only if damper {damper} has room to move {needed} each way, and none is given« (`stroke`)».",
            ko: "이 결과는 감쇠기 {damper}이(가) 한쪽으로 {needed} 움직일 공간이 있을 때만 맞으며, 여유 공간«(`stroke`)»이 입력되지 않았다.",
        },
        RoomNotGivenDrift { damper: Sentence, needed: Quantity, ratio: Quantity } => {
            en: "This holds only if damper {damper} has room to move {needed} each way, and none is given« (`stroke`)». Without the dampers the largest drift is {ratio}.",
            ko: "이 결과는 감쇠기 {damper}이(가) 한쪽으로 {needed} 움직일 공간이 있을 때만 맞으며, 여유 공간«(`stroke`)»이 입력되지 않았다. 감쇠기가 없으면 최대 층간변위는 {ratio}이다.",
        },
        NotComputed { why: String } => {
            en: "The response to the spectrum of the site is not computed: {why}",
            ko: "부지 스펙트럼에 대한 응답을 계산하지 않았다: {why}",
        },
        NotComputedDamped { why: String } => {
            en: "The response with the dampers is not computed: {why}",
            ko: "감쇠기를 포함한 스펙트럼 응답을 계산하지 않았다: {why}",
        },
    }
}

/// The findings, the most important first.
pub(crate) fn findings(answer: &BuildingAnswer) -> Vec<Finding> {
    let factor = answer.load_factor();
    let verdict = Verdict::of_load_factor(factor);
    let mut all = vec![load_factor_finding(factor, verdict, Falls::BySway)];
    all.extend(first_storey(answer, verdict));
    if let Some(standing) = &answer.stands {
        all.extend(lowest_frequency(standing));
        all.extend(twisting(standing));
        if let Some(spectral) = &standing.spectral {
            all.push(drift(answer, standing, spectral));
            all.extend(torsion(answer, standing));
            all.extend(room_not_given(answer, standing, spectral));
        }
        all.extend(hardly_moves(standing));
        all.extend(more_with_dampers(standing).map(|said| Finding::key(Tone::Warn, said)));
        all.extend(beyond_room(standing));
        all.extend(refused(standing).map(|said| Finding::key(Tone::Unknown, said)));
        all.extend(wind_findings(answer, standing));
    }
    all
}

/// Notes on the variants.
pub(crate) fn variant_findings(variants: &[VariantAnswer]) -> Vec<Finding> {
    let states = variants.iter().map(|variant| &variant.state.check);
    let standing = states.filter_map(|check| match check {
        Check::Building(answer) => answer.stands.as_deref(),
        Check::Chain(_) | Check::Frame(_) | Check::Stack(_) => None,
    });
    standing
        .flat_map(|standing| {
            let in_wind = beyond_room_in_wind(standing);
            beyond_room(standing).into_iter().chain(in_wind)
        })
        .collect()
}

fn first_storey(answer: &BuildingAnswer, verdict: Verdict) -> Option<Finding> {
    let first = StoreyFall::first(&answer.falls)?;
    let floor = floor_words(&answer.floors[first.storey - 1]);
    let factor = Quantity::beside_one(first.load_factor, 3);
    let said = match first.motion() {
        StoreyMotion::Twists => Found::FallsTwisting { floor, factor },
        StoreyMotion::Sways => Found::FallsSwaying { floor, factor },
    };
    Some(Finding::new(Tone::of(verdict), said))
}

fn lowest_frequency(standing: &StandingBuilding) -> Option<Finding> {
    let first = standing.modes.modes.first()?;
    let frequency = significant(first.frequency_hz, Unit::si("Hz"), 3);
    Some(Finding::new(Tone::Plain, Found::LowestFrequency { frequency }))
}

fn twisting(standing: &StandingBuilding) -> Option<Finding> {
    let mut lowest = standing.modes.modes.iter().take(3).enumerate();
    let (j, mode) = lowest.find(|(_, mode)| (TWISTS..0.5).contains(&mode.energy_shares[2]))?;
    let said = Found::Twists {
        share: Quantity::percent(mode.energy_shares[2], 2),
        mode: j + 1,
    };
    Some(Finding::key(Tone::Warn, said))
}

fn drift(answer: &BuildingAnswer, standing: &StandingBuilding, spectral: &BuildingSpectral) -> Finding {
    let damped = standing.damped.as_ref();
    let drifts = damped.map_or(&spectral.edge_drift_m, |damped| &damped.edge_drift_m);
    let Some((storey, ratio)) = worst(answer, drifts) else {
        return Finding::key(Tone::Warn, Found::NoOutline);
    };
    let floor = floor_words(&answer.floors[storey]);
    let ratio = Quantity::percent(ratio, 3);
    let said = match damped {
        Some(_) => Found::DriftDamped { ratio, floor },
        None => Found::Drift { ratio, floor },
    };
    Finding::key(Tone::Plain, said)
}

/// Accidental torsion: its drift, or why it is not included.
fn torsion(answer: &BuildingAnswer, standing: &StandingBuilding) -> Option<Finding> {
    let (tone, said) = match &standing.accidental {
        AccidentalTorsion::Included(of) => {
            let drifts = standing
                .judged_drift_m()?
                .into_iter()
                .map(Some)
                .collect::<Vec<_>>();
            let (storey, ratio) = worst(answer, &drifts)?;
            let fraction = Quantity::new(of.fraction, Unit::percent(), Digits::Trimmed(2));
            let ratio = Quantity::percent(ratio, 3);
            let floor = floor_words(&answer.floors[storey]);
            let said = match of.code {
                Some(code) => Found::Torsion {
                    code: code.name().to_owned(),
                    fraction,
                    ratio,
                    floor,
                },
                None => Found::TorsionOfFile {
                    fraction,
                    ratio,
                    floor,
                },
            };
            (Tone::Plain, said)
        }
        AccidentalTorsion::LeftOut { code } => {
            let code = (*code)?.name().to_owned();
            (Tone::Warn, Found::TorsionLeftOut { code })
        }
        AccidentalTorsion::NoOutline { .. } => (Tone::Unknown, Found::TorsionNoOutline),
        AccidentalTorsion::Refused { why, .. } => (Tone::Unknown, Found::TorsionRefused { why: why.clone() }),
        AccidentalTorsion::NotAsked => return None,
    };
    Some(Finding::key(tone, said))
}

/// The storey with the largest drift at an edge, and that drift over its height.
fn worst(answer: &BuildingAnswer, drifts: &[Option<[f64; 2]>]) -> Option<(usize, f64)> {
    let storeys = answer.elastic.storeys().iter().zip(drifts).enumerate();
    storeys
        .filter_map(|(i, (storey, drift))| drift.map(|[x, y]| (i, x.max(y) / storey.height_m)))
        .reduce(|most, own| if own.1 > most.1 { own } else { most })
}

/// The damper with the longest stroke of those without a given room, on which the response with the dampers depends.
fn room_not_given(
    answer: &BuildingAnswer,
    standing: &StandingBuilding,
    spectral: &BuildingSpectral,
) -> Option<Finding> {
    let strokes = strokes_of(&standing.dampers);
    let judged_m = standing.judged_strokes_m();
    let each = strokes.iter().zip(&judged_m).enumerate();
    let is_viscous = |k: usize| {
        let damper = standing.dampers.get(k);
        damper.is_some_and(|damper| matches!(damper.kind, DamperKind::Viscous { .. }))
    };
    let (_, (stroke, needed_m)) = each
        .filter(|(k, (stroke, _))| stroke.room_m.is_none() && !is_viscous(*k))
        .max_by(|a, b| a.1.1.total_cmp(b.1.1))?;
    let (damper, needed) = (
        stroke_words(&stroke.name),
        significant(*needed_m, millimetres(), 3),
    );
    let said = match worst(answer, &spectral.edge_drift_m) {
        Some((_, ratio)) => Found::RoomNotGivenDrift {
            damper,
            needed,
            ratio: Quantity::percent(ratio, 3),
        },
        None => Found::RoomNotGiven { damper, needed },
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Share of a modal mass below which dampers are not built. Our choice: they have half a per cent and more.
const MASS_RATIO_LEAST: f64 = 2e-3;

/// Dampers whose mode hardly moves in their direction.
fn hardly_moves(standing: &StandingBuilding) -> Vec<Finding> {
    let each = standing.dampers.iter().filter_map(|of| {
        let tuned = of.tuned_to.filter(|tuned| tuned.mass_ratio < MASS_RATIO_LEAST)?;
        let said = Found::HardlyMoves {
            damper: stroke_words(&of.name),
            mode: tuned.mode,
            share: Quantity::percent(tuned.mass_ratio, 2),
        };
        Some(Finding::key(Tone::Warn, said))
    });
    each.collect()
}

/// Responses that the dampers increase under the spectrum of the site.
pub(super) fn more_with_dampers(standing: &StandingBuilding) -> Option<Found> {
    let against = standing.against_without();
    let more = against.iter().filter(|of| of.ratio > GROWN).map(|of| {
        let factor = Found::Factor {
            what: of_both(&of.what),
            ratio: Quantity::ratio(of.ratio, 4),
        };
        factor.into()
    });
    let list: Vec<Sentence> = more.collect();
    (!list.is_empty()).then_some(Found::MoreWithDampers { list })
}

/// Dampers that need more room under the spectrum of the site than they have.
fn beyond_room(standing: &StandingBuilding) -> Vec<Finding> {
    let each = beyond_room_said(standing).into_iter();
    each.map(|said| Finding::key(Tone::Bad, said)).collect()
}

/// The same as sentences.
pub(super) fn beyond_room_said(standing: &StandingBuilding) -> Vec<Found> {
    let each = standing.beyond_room().into_iter();
    each.map(|of| Found::BeyondRoom {
        damper: stroke_words(&of.name),
        needed: significant(of.stroke_m, millimetres(), 4),
        has: significant(of.room_m, millimetres(), 4),
    })
    .collect()
}

/// Results that could not be computed, and why: without the dampers, otherwise with them.
pub(super) fn refused(standing: &StandingBuilding) -> Option<Found> {
    let without = standing.spectral_refused.clone();
    let with = standing.damped_refused.clone();
    without
        .map(|why| Found::NotComputed { why })
        .or_else(|| with.map(|why| Found::NotComputedDamped { why }))
}
