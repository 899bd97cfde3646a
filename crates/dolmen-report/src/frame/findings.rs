//! Findings of a frame's check.

use super::columns;
use super::notes::load_note;
use super::tenons;
use crate::document::{Finding, Tone};
use crate::load_factor::{Falls, load_factor_finding};
use dolmen::assess::{FrameCheck, FrameNote};
use dolmen::stability::{FrameStability, Verdict};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::state::DirectionCheck;

messages! {
    /// Findings on a frame.
    pub(crate) enum Found in "frame.findings" {
        OfDirection { direction: String, said: Sentence } => {
            en: "Direction {direction}: {said}",
            ko: "{direction} 방향: {said}",
        },
        OfDirections { directions: Vec<String>, said: Sentence } => {
            en: "Directions {directions}: {said}",
            ko: "{directions} 방향: {said}",
        },
        StiffnessUnknown(needs: Values) => {
            en: "whether it stands is unknown, the storey stiffness is not given. P-delta takes {needs} from the storeys, lowest first.",
            ko: "층강성이 주어지지 않아 안정 여부를 판정할 수 없다. P-델타 효과가 아래층부터 강성을 {needs}만큼 감소시킨다.",
        },
        Weakest { storey: usize, margin: Quantity } => {
            en: "storey {storey} has the least margin, {margin} times the stiffness at which the frame would just stand.",
            ko: "여유가 가장 작은 층은 {storey}층이며, 그 강성은 골조가 안정을 유지하는 한계 강성의 {margin}배이다.",
        },
        Slipping(factor: Quantity) => {
            en: "once its joints slip it falls at {factor} times its weight, which decides: in an earthquake they may.",
            ko: "접합부가 미끄러지면 자중의 {factor}배에서 안정을 잃으며, 이 값으로 판정한다. 지진 시에는 미끄러질 수 있다.",
        },
        LowestFalls => {
            en: "it does not vibrate in its lowest shape, it falls in it.",
            ko: "최저차 형상에서는 진동하지 않고 안정을 잃는다.",
        },
        LowestMode(frequency: Quantity) => {
            en: "the lowest natural frequency on this stiffness is {frequency}.",
            ko: "이 강성에서 최저 고유진동수는 {frequency}이다.",
        },
    }
}

/// The findings, one direction after the other; what all directions share of their columns is said once.
pub(crate) fn findings(directions: &[DirectionCheck]) -> Vec<Finding> {
    let mut all: Vec<Finding> = Vec::new();
    for (at, direction) in directions.iter().enumerate() {
        let columns = on_columns(direction);
        let (shared, own): (Vec<Finding>, Vec<Finding>) = columns.into_iter().partition(|found| {
            directions.len() > 1 && directions.iter().all(|other| on_columns(other).contains(found))
        });
        let own = of_direction(&direction.check)
            .into_iter()
            .chain(slipping(direction))
            .chain(tenons(direction))
            .chain(own)
            .map(|found| Finding {
                sentence: Found::OfDirection {
                    direction: direction.direction.clone(),
                    said: found.sentence,
                }
                .into(),
                ..found
            });
        all.extend(own);
        let shared = shared.into_iter().filter(|_| at == 0);
        all.extend(shared.map(|found| {
            Finding {
                sentence: Found::OfDirections {
                    directions: directions.iter().map(|of| of.direction.clone()).collect(),
                    said: found.sentence,
                }
                .into(),
                ..found
            }
        }));
        for finding in direction.check.notes.iter().map(load_finding) {
            // a mistake in the loads is the same in every direction
            if !all.contains(&finding) {
                all.push(finding);
            }
        }
    }
    all
}

/// Findings on the columns of a direction.
fn on_columns(direction: &DirectionCheck) -> Vec<Finding> {
    direction.columns.iter().flat_map(columns::findings).collect()
}

fn of_direction(check: &FrameCheck) -> Vec<Finding> {
    let mut all = vec![match &check.stability {
        None => Finding::key(
            Tone::Unknown,
            Found::StiffnessUnknown(needs(&check.geometric_n_m)),
        ),
        Some(stability) => load_factor_finding(stability.load_factor, stability.verdict, Falls::BySway),
    }];
    all.extend(check.stability.as_ref().and_then(weakest));
    all.extend(lowest_mode(check));
    all
}

/// The load factor while every joint slips, if it determines the verdict.
fn slipping(direction: &DirectionCheck) -> Option<Finding> {
    let stuck = direction.check.stability.as_ref()?;
    let slipping = direction.slipping.as_ref()?.stability.as_ref()?;
    let factor = Quantity::beside_one(slipping.load_factor, 4);
    let decides = slipping.load_factor < stuck.load_factor && slipping.verdict != Verdict::Stable;
    decides.then(|| Finding::key(Tone::of(slipping.verdict), Found::Slipping(factor)))
}

/// Finding that it depends on the stiffness within the slack of its tenons.
fn tenons(direction: &DirectionCheck) -> Option<Finding> {
    let lowest = direction
        .check
        .modes
        .first()
        .filter(|mode| mode.omega_squared > 0.0);
    tenons::finding(direction.tenons.as_ref()?, lowest.map(|mode| mode.frequency_hz))
}

fn needs(geometric_n_m: &[f64]) -> Values {
    let unit = Unit::of(geometric_n_m, "N/m");
    let need = |k: &f64| Quantity::new(*k, unit.clone(), Digits::Significant(4));
    Values(geometric_n_m.iter().map(need).collect())
}

fn weakest(stability: &FrameStability) -> Option<Finding> {
    let storeys = stability.storeys.iter().enumerate();
    let margins = storeys.filter_map(|(i, storey)| Some((i + 1, storey.margin?)));
    // a storey without a load has an infinite margin
    let finite = margins.filter(|(_, margin)| margin.is_finite());
    let (storey, margin) = finite.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let found = Found::Weakest {
        storey,
        margin: Quantity::beside_one(margin, 3),
    };
    Some(Finding::key(Tone::of(Verdict::of_load_factor(margin)), found))
}

fn lowest_mode(check: &FrameCheck) -> Option<Finding> {
    let mode = check.modes.first()?;
    if mode.omega_squared <= 0.0 {
        return Some(Finding::new(Tone::Bad, Found::LowestFalls));
    }
    let found = Found::LowestMode(Quantity::new(
        mode.frequency_hz,
        Unit::si("Hz"),
        Digits::Significant(3),
    ));
    Some(Finding::new(Tone::Plain, found))
}

fn load_finding(note: &FrameNote) -> Finding {
    // the reason why there are no results, or why they are not those of the weight
    Finding::key(Tone::Warn, load_note(note))
}
