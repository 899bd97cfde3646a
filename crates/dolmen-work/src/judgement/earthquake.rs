//! Earthquake: does the structure meet the demand of the code or the given motion?

use super::colour::Colour;
use crate::building::RowStroke;
use crate::part_limit::{Limited, NotCompared, Part, PartLimit, WhyNotCompared, worst_part};
use crate::state::{Check, State};
use dolmen::assess::DamageState;
use dolmen::stability::stack::DemandVerdict;
use dolmen_words::Language;

/// The fixed words, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Earthquake {
    /// The file has no site, and no motion was given.
    NotAsked,
    /// Its capacity is at least [`DemandVerdict::NEAR_BELOW`] times the demand.
    Above,
    /// Its capacity meets the demand with a small margin.
    Near,
    /// There is a demand without a comparison, or the run has no verdict.
    NotDecided,
    /// Its capacity is below the demand.
    BelowDemand,
}

/// The quantity that decided a word.
#[derive(Clone, Debug, PartialEq)]
pub enum DecidedBy {
    /// Capacity against the demand of the code at the site.
    CodeDemand,
    /// Whether it fell.
    Fall,
    /// The state of damage, 0 to 4.
    DamageState(u8),
    /// The worst state of damage over runs with immeasurably small differences.
    DamageOfRuns {
        /// The state, 0 to 4.
        state: u8,
        /// Number of runs that reached it.
        runs: usize,
        /// Number of runs.
        all: usize,
    },
    /// The drift of a storey relative to the limit of its model.
    Drift,
    /// A tie that broke.
    Strength,
    /// An edge or a corner of a stone that crushes.
    Crushing,
    /// A joint at the edge of its bed.
    BedEdge,
    /// A bed that stood on its edge in a run without a fall: it cannot carry more, whatever the demand.
    StoodOnEdge,
    /// The stroke of a damper relative to its room.
    Room,
    /// No result: there is no limit.
    NoLimit,
    /// No result: no response to the spectrum of the site could be computed.
    NoResponse,
    /// No result: the bed of a joint is unknown.
    BedUnknown,
    /// No result: the stiffness is unknown, at least in one direction.
    StiffnessUnknown,
    /// A side post with a gap may close.
    LoosePost,
    /// No result: a survey contradicts the stiffness; the ratio is valid only if the model is right.
    Contradicted,
    /// No result: supports moved; the comparison and its ratio are for the shape before.
    SupportsMoved,
    /// No result: static loads without mass hold the stones during the shaking.
    HeldByLoads,
    /// No result: a measured tilt that the model lacks takes a part of the allowable drift.
    LeansFurther,
    /// No result: the accidental torsion that is asked for could not be included.
    WithoutTorsion,
    /// No result: columns that alone support it lift off, and the springs of their beds are not valid beyond.
    FeetLiftOff,
    /// No result: feet lift off, and columns and joints have less than the spectrum asks for.
    NoBalance,
    /// No result: its feet lift off where the beds have all of its stiffness, and how beds and joints share it is assumed.
    SplitAssumed,
    /// No result: it does not stand without shaking.
    DoesNotStand,
    /// No result: the run was stopped, or ended without a verdict.
    Unfinished,
}

/// A word, the quantity that decided it, and the demand.
#[derive(Clone, Debug, PartialEq)]
pub struct EarthquakeFinding {
    /// The word.
    pub word: Earthquake,
    /// The deciding result.
    pub decided_by: DecidedBy,
    /// The motion; `None`: the site, or no motion at all.
    pub motion: Option<String>,
    /// The part that decided it; `None` for the whole.
    pub part: Option<String>,
    /// Capacity over demand; `None` if another quantity decided.
    pub ratio: Option<f64>,
}

impl EarthquakeFinding {
    /// A word for the whole structure, without a ratio.
    pub(super) fn new(word: Earthquake, decided_by: DecidedBy, motion: Option<&str>) -> Self {
        EarthquakeFinding {
            word,
            decided_by,
            motion: motion.map(str::to_owned),
            part: None,
            ratio: None,
        }
    }
}

impl EarthquakeFinding {
    /// The same if a survey contradicts the stiffness: sufficient capacity is then uncertain; insufficient capacity stays insufficient.
    pub(super) fn if_model_were_right(self) -> Self {
        match self.word {
            Earthquake::Above | Earthquake::Near => EarthquakeFinding {
                word: Earthquake::NotDecided,
                decided_by: DecidedBy::Contradicted,
                ..self
            },
            Earthquake::NotAsked | Earthquake::NotDecided | Earthquake::BelowDemand => self,
        }
    }
}

impl EarthquakeFinding {
    /// The same for a stack whose supports moved, if computed for the shape before: sufficient capacity there is uncertain; insufficient
    /// capacity stays insufficient.
    pub(super) fn before_supports_moved(self) -> Self {
        let is_of_code = self.word == Earthquake::BelowDemand && self.decided_by == DecidedBy::CodeDemand;
        let of_before = self.not_known_to_be_enough(DecidedBy::SupportsMoved);
        match is_of_code {
            true => EarthquakeFinding {
                decided_by: DecidedBy::SupportsMoved,
                ..of_before
            },
            false => of_before,
        }
    }

    /// The same for a stack whose joints are pressed together by loads without mass.
    pub(super) fn held_by_loads(self) -> Self {
        self.not_known_to_be_enough(DecidedBy::HeldByLoads)
    }

    /// The same for a building without the accidental torsion that is asked for, which only adds to the demand.
    pub(super) fn without_torsion(self) -> Self {
        self.not_known_to_be_enough(DecidedBy::WithoutTorsion)
    }

    /// The same for storeys that start plumb although they lean, with the share of the allowable drift that their tilt leaves: drift and tilt
    /// add up at worst.
    pub(super) fn with_drift_left(self, left: f64) -> Self {
        let leaning = self
            .ratio
            .map_or(Earthquake::NotDecided, |ratio| Earthquake::of_ratio(ratio * left));
        match leaning > self.word {
            true => self.not_known_to_be_enough(DecidedBy::LeansFurther),
            false => self,
        }
    }

    fn not_known_to_be_enough(self, decided_by: DecidedBy) -> Self {
        match self.word {
            Earthquake::Above | Earthquake::Near => EarthquakeFinding {
                word: Earthquake::NotDecided,
                decided_by,
                ..self
            },
            Earthquake::NotAsked | Earthquake::NotDecided | Earthquake::BelowDemand => self,
        }
    }
}

impl Earthquake {
    /// The worst word of several findings; the word for no demand if there are none.
    pub fn worst(findings: &[EarthquakeFinding]) -> Earthquake {
        let words = findings.iter().map(|finding| finding.word);
        words.max().unwrap_or(Earthquake::NotAsked)
    }

    /// The word for capacity over demand; NaN is not decided.
    pub fn of_ratio(ratio: f64) -> Earthquake {
        Earthquake::of_demand(DemandVerdict::of_ratio(ratio))
    }

    /// The word for a verdict on a demand.
    pub fn of_demand(verdict: DemandVerdict) -> Earthquake {
        match verdict {
            DemandVerdict::Above => Earthquake::Above,
            DemandVerdict::Near => Earthquake::Near,
            DemandVerdict::Below => Earthquake::BelowDemand,
            DemandVerdict::Unknown => Earthquake::NotDecided,
        }
    }

    /// The word for a state of damage: DS3 and worse is below demand, DS2 near it.
    pub fn of_damage(state: DamageState) -> Earthquake {
        match state {
            DamageState::None | DamageState::Begun => Earthquake::Above,
            DamageState::Offset => Earthquake::Near,
            DamageState::Severe | DamageState::Fallen => Earthquake::BelowDemand,
        }
    }

    /// Its colour.
    pub fn colour(self) -> Colour {
        match self {
            Earthquake::NotAsked | Earthquake::Above => Colour::Green,
            Earthquake::Near | Earthquake::NotDecided => Colour::Amber,
            Earthquake::BelowDemand => Colour::Red,
        }
    }

    /// The fixed word.
    pub fn word(self, language: Language) -> &'static str {
        match self {
            Earthquake::NotAsked => language.pick("not asked", "검토하지 않음"),
            Earthquake::Above => language.pick("above demand", "기준 만족"),
            Earthquake::Near => language.pick("near demand", "기준에 근접"),
            Earthquake::NotDecided => language.pick("not decided", "판정 보류"),
            Earthquake::BelowDemand => language.pick("below demand", "기준 불만족"),
        }
    }
}

impl DecidedBy {
    /// Its key in JSON.
    pub fn key(&self) -> &'static str {
        match self {
            DecidedBy::CodeDemand => "code_demand",
            DecidedBy::Fall => "fall",
            DecidedBy::DamageState(_) => "damage_state",
            DecidedBy::DamageOfRuns { .. } => "damage_of_runs",
            DecidedBy::Drift => "drift",
            DecidedBy::Strength => "strength",
            DecidedBy::Crushing => "crushing",
            DecidedBy::BedEdge => "bed_edge",
            DecidedBy::StoodOnEdge => "stood_on_edge",
            DecidedBy::SupportsMoved => "supports_moved",
            DecidedBy::HeldByLoads => "held_by_loads",
            DecidedBy::LeansFurther => "leans_further",
            DecidedBy::WithoutTorsion => "without_torsion",
            DecidedBy::Room => "room",
            DecidedBy::NoLimit => "no_limit",
            DecidedBy::BedUnknown => "bed_unknown",
            DecidedBy::StiffnessUnknown => "stiffness_unknown",
            DecidedBy::LoosePost => "loose_post",
            DecidedBy::Contradicted => "contradicted",
            DecidedBy::NoResponse => "no_response",
            DecidedBy::FeetLiftOff => "feet_lift_off",
            DecidedBy::NoBalance => "no_balance",
            DecidedBy::SplitAssumed => "split_assumed",
            DecidedBy::DoesNotStand => "does_not_stand",
            DecidedBy::Unfinished => "unfinished",
        }
    }
}

/// Results for the demand of the site on one version of a structure; empty without a site.
pub(super) fn of_site(state: &State) -> Vec<EarthquakeFinding> {
    let Some(demand) = &state.demand else {
        return Vec::new();
    };
    if let Some(stack) = &demand.stack {
        return vec![EarthquakeFinding {
            ratio: stack.least_ratio(),
            ..EarthquakeFinding::new(Earthquake::of_demand(stack.verdict), DecidedBy::CodeDemand, None)
        }];
    }
    let compared = &demand.compared;
    let is_read = demand.refused.is_none() && !matches!(state.check, Check::Building(_));
    if compared.parts.is_empty() && compared.not_compared.is_empty() && !is_read {
        let none = EarthquakeFinding::new(Earthquake::NotDecided, DecidedBy::NoResponse, None);
        return vec![none];
    }
    let mut found: Vec<EarthquakeFinding> = compared.not_compared.iter().map(of_none).collect();
    if found.is_empty() || !compared.parts.is_empty() {
        found.extend(of_parts(&compared.parts, None));
    }
    let in_joints = Earthquake::worst(&found);
    // where the file shares the stiffness there is one answer
    let splits = compared.splits.iter().filter(|of| !of.beds.is_file());
    found.extend(splits.filter_map(|of| {
        split_assumed(
            in_joints,
            Earthquake::worst(&of_parts(std::slice::from_ref(&of.in_beds), None)),
            (&of.in_beds, None),
        )
    }));
    match lacks_torsion(&state.check) {
        true => found
            .into_iter()
            .map(EarthquakeFinding::without_torsion)
            .collect(),
        false => found,
    }
}

/// A frame that meets the demand with all of its stiffness in its joints, and not, or barely, with all of it in the beds of its columns: both
/// are extremes, so that the worse one alone does not make it insufficient.
pub(super) fn split_assumed(
    in_joints: Earthquake,
    in_beds: Earthquake,
    (storey, motion): (&PartLimit, Option<&str>),
) -> Option<EarthquakeFinding> {
    let meets = matches!(in_joints, Earthquake::Above | Earthquake::Near);
    (meets && in_beds > in_joints).then(|| EarthquakeFinding {
        part: Some(storey.part.name().to_owned()),
        ..EarthquakeFinding::new(
            in_beds.min(Earthquake::NotDecided),
            DecidedBy::SplitAssumed,
            motion,
        )
    })
}

/// Whether accidental torsion is asked for and missing in the response of a building.
fn lacks_torsion(check: &Check) -> bool {
    match check {
        Check::Building(answer) => {
            let standing = answer.stands.as_ref();
            standing.is_some_and(|standing| standing.accidental.is_missing())
        }
        Check::Chain(_) | Check::Frame(_) | Check::Stack(_) => false,
    }
}

/// A direction without a comparison: not decided, whatever the others are.
fn of_none(of: &NotCompared) -> EarthquakeFinding {
    let decided_by = match of.why {
        WhyNotCompared::StiffnessUnknown => DecidedBy::StiffnessUnknown,
        WhyNotCompared::LoosePost => DecidedBy::LoosePost,
        WhyNotCompared::FeetLiftOff => DecidedBy::FeetLiftOff,
        WhyNotCompared::NoBalance => DecidedBy::NoBalance,
        WhyNotCompared::NoSpectrum => DecidedBy::NoResponse,
        WhyNotCompared::Falls | WhyNotCompared::FallsSlipping => DecidedBy::DoesNotStand,
    };
    EarthquakeFinding {
        part: of.direction.clone(),
        ..EarthquakeFinding::new(Earthquake::NotDecided, decided_by, None)
    }
}

/// Parts compared with their limits: the worst storey, the worst joint, every damper; a joint with an unknown bed; without any comparison, the
/// reason.
pub(super) fn of_parts(parts: &[PartLimit], motion: Option<&str>) -> Vec<EarthquakeFinding> {
    let dampers = parts.iter().filter(|part| part.limited == Limited::Room);
    let worst = [Limited::Drift, Limited::BedEdge].map(|limited| worst_part(parts, limited));
    let compared = worst.into_iter().flatten().chain(dampers);
    let compared = compared.filter(|part| part.capacity.is_some() || part.falls());
    let mut found: Vec<EarthquakeFinding> = compared.map(|part| of_part(part, motion)).collect();
    let is_bed = |part: &&PartLimit| part.limited == Limited::BedEdge;
    if let Some(unknown) = parts.iter().filter(is_bed).find(|part| part.capacity.is_none()) {
        found.push(EarthquakeFinding {
            part: Some(unknown.part.name().to_owned()),
            ..EarthquakeFinding::new(Earthquake::NotDecided, DecidedBy::BedUnknown, motion)
        });
    }
    // storeys without a limit stay undecided even if a damper has a room
    let drifts = || parts.iter().filter(|part| part.limited == Limited::Drift);
    let is_unlimited =
        drifts().next().is_some() && drifts().all(|part| part.capacity.is_none() && !part.falls());
    if found.is_empty() || is_unlimited {
        found.push(EarthquakeFinding::new(
            Earthquake::NotDecided,
            DecidedBy::NoLimit,
            motion,
        ));
    }
    found
}

fn of_part(part: &PartLimit, motion: Option<&str>) -> EarthquakeFinding {
    let decided_by = match part.limited {
        Limited::Drift => DecidedBy::Drift,
        Limited::BedEdge => DecidedBy::BedEdge,
        Limited::Room => DecidedBy::Room,
    };
    EarthquakeFinding {
        part: Some(part.part.name().to_owned()),
        ratio: part.ratio(),
        ..EarthquakeFinding::new(Earthquake::of_demand(part.verdict()), decided_by, motion)
    }
}

/// The stroke of a damper of a comparison compared with its room.
pub(super) fn of_row(row: &RowStroke) -> EarthquakeFinding {
    let part = PartLimit {
        part: Part::Damper(row.damper.clone()),
        direction: None,
        limited: Limited::Room,
        demand: row.stroke_m.abs(),
        capacity: Some(row.room_m),
        taken: 0.0,
        lean: [0.0; 2],
    };
    of_part(&part, row.motion.as_deref())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_words_and_colours_follow_capacity_over_demand_and_damage() {
        for (ratio, words, colour) in [
            (0.999, "below demand", Colour::Red),
            (1.0, "near demand", Colour::Amber),
            (1.249, "near demand", Colour::Amber),
            (1.25, "above demand", Colour::Green),
            (f64::INFINITY, "above demand", Colour::Green),
            (f64::NAN, "not decided", Colour::Amber),
        ] {
            let found = Earthquake::of_ratio(ratio);
            assert_eq!(found.word(Language::English), words, "{ratio}");
            assert_eq!(found.colour(), colour, "{ratio}");
        }
        for (state, colour) in [
            (DamageState::None, Colour::Green),
            (DamageState::Begun, Colour::Green),
            (DamageState::Offset, Colour::Amber),
            (DamageState::Severe, Colour::Red),
            (DamageState::Fallen, Colour::Red),
        ] {
            assert_eq!(Earthquake::of_damage(state).colour(), colour, "{state:?}");
        }
    }

    #[test]
    fn holds_what_is_not_known_of_one_part_is_not_decided_by_another() {
        let joint = |name: &str, demand: f64, capacity: Option<f64>| PartLimit {
            part: Part::JointBelow(name.into()),
            direction: None,
            limited: Limited::BedEdge,
            demand,
            capacity,
            taken: 0.0,
            lean: [0.0; 2],
        };
        let strong = joint("strong", 1.0, Some(4.0));
        let weak = joint("weak", 1.0, Some(0.5));
        let unknown = joint("unknown", 1.0, None);
        let word = |parts: &[PartLimit]| Earthquake::worst(&of_parts(parts, None));
        assert_eq!(word(std::slice::from_ref(&strong)), Earthquake::Above);
        assert_eq!(word(&[strong.clone(), unknown.clone()]), Earthquake::NotDecided);
        assert_eq!(word(&[strong, unknown, weak]), Earthquake::BelowDemand);
    }

    #[test]
    fn holds_a_damper_with_room_does_not_decide_for_storeys_without_a_limit() {
        let part = |part, limited, demand, capacity| PartLimit {
            part,
            direction: None,
            limited,
            demand,
            capacity,
            taken: 0.0,
            lean: [0.0; 2],
        };
        let damper = |stroke_m| part(Part::Damper("tank".into()), Limited::Room, stroke_m, Some(0.2));
        let roof = |allowed| part(Part::BelowFloor("roof".into()), Limited::Drift, 0.0139, allowed);
        let word = |parts: &[PartLimit]| Earthquake::worst(&of_parts(parts, None));
        assert_eq!(word(&[roof(None), damper(0.0)]), Earthquake::NotDecided);
        assert_eq!(word(&[roof(None), damper(0.3)]), Earthquake::BelowDemand);
        assert_eq!(word(&[roof(Some(0.02)), damper(0.0)]), Earthquake::Above);
    }

    #[test]
    fn holds_a_stroke_is_held_against_its_room_as_capacity_against_demand() {
        for (stroke_m, word) in [
            (0.1, Earthquake::Above),
            (-0.09, Earthquake::Near),
            (0.1001, Earthquake::BelowDemand),
            (f64::NAN, Earthquake::NotDecided),
        ] {
            let room_m = if stroke_m == 0.1 { 0.125 } else { 0.1 };
            let found = of_row(&RowStroke {
                row: 0,
                motion: Some("el-centro".into()),
                damper: "tank".into(),
                stroke_m,
                room_m,
            });
            assert_eq!(found.word, word, "{stroke_m}");
        }
    }

    #[test]
    fn holds_the_worst_finding_decides() {
        let of = |word| EarthquakeFinding::new(word, DecidedBy::Fall, None);
        use Earthquake::{Above, BelowDemand, Near, NotAsked, NotDecided};
        for (words, worst) in [
            (vec![], NotAsked),
            (vec![Above, Near], Near),
            (vec![NotDecided, Near, Above], NotDecided),
            (vec![NotDecided, BelowDemand, Above], BelowDemand),
        ] {
            let findings: Vec<_> = words.into_iter().map(of).collect();
            assert_eq!(Earthquake::worst(&findings), worst, "{findings:?}");
        }
    }
}
