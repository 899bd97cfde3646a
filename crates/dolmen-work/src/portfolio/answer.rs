//! A ranked portfolio: the data of each structure, its rank, and the reasons.

use super::state_words::state_words;
use crate::judgement::SevereDamage;
use crate::study::{ALLOWED_DRIFT, CombinationFragility, StudyAnswer};
use crate::wrong::{CaseRefused, NoPlace};
use dolmen::assess::{
    AssessError, Candidate, Factor, Fragility, FragilityBound, Hazard, Known, KnownCapacity, Place, Ranked,
    ScoreModel, SixFactors, Unlike, rank,
};
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_words::number::significant;

/// β for a state that no motion, or every motion, reached: that of rocking blocks over peak acceleration, 0.37 to 0.48 under the far-field
/// set of FEMA P-695 (docs/fragility.md).
const BETA_OF_BOUNDS: f64 = 0.4;

/// A factor that lowers ln θ by less than this, half a per cent, is not a reason. Our choice.
const REASON_LEAST: f64 = 0.005;

/// Source of the capacity of a structure.
#[derive(Clone, Debug, PartialEq)]
pub enum Basis {
    /// Its own study.
    Study {
        /// The study.
        name: String,
        /// The variant of all its runs; `None` for the structure as it is.
        variant: Option<String>,
        /// The values that it sets in place of those of the file: "joint.friction = 0.5".
        set: Vec<String>,
        /// Number of usable scans.
        scans: usize,
        /// Number of scans whose samples fall under their own weight.
        fell_alone: usize,
    },
    /// The six-factor score.
    Score {
        /// Contribution of each factor to ln θ of the state of the ranking, relative to the mean of the designs.
        reasons: [f64; 6],
        /// Factors outside the training range.
        outside: Vec<Factor>,
        /// Differences from the designs other than in its factors.
        unlike: Vec<Unlike>,
    },
}

/// One structure and its data.
#[derive(Clone, Debug, PartialEq)]
pub struct PortfolioEntry {
    /// Its name.
    pub name: String,
    /// Source of its capacity.
    pub basis: Basis,
    /// Each state, the mildest first: DS1 to DS3, falls.
    pub states: [Option<KnownCapacity>; 4],
    /// States of structures of its kind: a frame has no DS2 and DS3.
    pub has: [bool; 4],
    /// Hazard at its site.
    pub hazard: Option<Hazard>,
    /// Whether the hazard comes from the table although the project has its own.
    pub hazard_replaced: bool,
    /// Severe damage of its inspections, which its capacity leaves out.
    pub severe_damage: Vec<SevereDamage>,
}

impl PortfolioEntry {
    /// The factor that lowers the capacity of a scored pagoda most, with its contribution to ln θ (negative).
    pub fn worst_factor(&self) -> Option<(Factor, f64)> {
        let Basis::Score { reasons, .. } = &self.basis else {
            return None;
        };
        let all = Factor::ALL.into_iter().zip(*reasons);
        all.min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|worst| worst.1 < -REASON_LEAST)
    }
}

/// A structure without a rank, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Its name.
    pub name: String,
    /// Reason.
    pub why: Both,
}

/// Results of `dolmen rank`.
#[derive(Clone, Debug, PartialEq)]
pub struct PortfolioAnswer {
    /// The table or folder, as the user named it.
    pub source: String,
    /// The state of the ranking, 0 to 3.
    pub state: usize,
    /// Structures with a rank; the others are in `left_out`.
    pub entries: Vec<PortfolioEntry>,
    /// Their order by the state.
    pub ranked: Ranked,
    /// Ranks by falls alone, by entry; `None` if no falls are known.
    pub by_falls: Vec<Option<usize>>,
    /// Structures without a place.
    pub left_out: Vec<LeftOut>,
    /// Headers of columns that a ranking does not use.
    pub columns_left_out: Vec<String>,
    /// Number of designs behind the score.
    pub designs: usize,
    /// Number of draws for the intervals of ranks.
    pub draws: usize,
    /// Gravity, which converts accelerations to g, m/s².
    pub gravity_m_s2: f64,
}

impl PortfolioAnswer {
    /// Ranks entries by a state, 0 to 3; entries without it are left out.
    ///
    /// # Errors
    /// [`AssessError::NothingToRank`] if none is left; [`PortfolioAnswer::without_place`] gives the reasons.
    pub fn of(
        source: String,
        state: usize,
        entries: Vec<PortfolioEntry>,
        mut left_out: Vec<LeftOut>,
        draws: usize,
    ) -> Result<Self, AssessError> {
        left_out.extend(Self::without_place(&entries, state));
        let mut kept = entries;
        kept.retain(|entry| entry.states[state].is_some());
        let ranked = rank(&candidates(&kept, state), draws, SEED)?;
        let mut by_falls = vec![None; kept.len()];
        let known: Vec<usize> = (0..kept.len()).filter(|i| kept[*i].states[3].is_some()).collect();
        let falling: Vec<PortfolioEntry> = known.iter().map(|i| kept[*i].clone()).collect();
        if let Ok(found) = rank(&candidates(&falling, 3), DRAWS_LEAST, SEED) {
            for place in found.places {
                by_falls[known[place.candidate]] = Some(place.rank);
            }
        }
        Ok(PortfolioAnswer {
            source,
            state,
            entries: kept,
            ranked,
            by_falls,
            left_out,
            columns_left_out: Vec::new(),
            designs: 0,
            draws,
            gravity_m_s2: GRAVITY_M_S2,
        })
    }

    /// Structures without data for a state, each with the reason.
    pub fn without_place(entries: &[PortfolioEntry], state: usize) -> Vec<LeftOut> {
        let lacking = entries.iter().filter(|entry| entry.states[state].is_none());
        let left_out = lacking.map(|entry| LeftOut {
            name: entry.name.clone(),
            why: why_no_place(entry, state),
        });
        left_out.collect()
    }

    /// Ranks with their structures, the worst first.
    pub fn rows(&self) -> impl Iterator<Item = (&Place, &PortfolioEntry, &KnownCapacity)> {
        self.ranked.places.iter().filter_map(|place| {
            let entry = self.entries.get(place.candidate)?;
            Some((place, entry, entry.states[self.state].as_ref()?))
        })
    }
}

/// Why there are no data for a state, and which data exist.
fn why_no_place(entry: &PortfolioEntry, state: usize) -> Both {
    if let Basis::Study {
        scans, fell_alone, ..
    } = entry.basis
        && fell_alone == scans
    {
        return NoPlace::AllFallAlone.into();
    }
    if entry.has[state] {
        return NoPlace::TooFewMotions.into();
    }
    let known = |language: Language| -> Vec<String> {
        let each = entry.states.iter().enumerate();
        each.filter_map(|(other, known)| {
            let g = known.as_ref()?.fragility.theta() / GRAVITY_M_S2;
            Some(format!(
                "{} ({} g)",
                state_words(other, language),
                significant(g, 2)
            ))
        })
        .collect()
    };
    let known = Both {
        english: known(Language::English).join(" and "),
        korean: known(Language::Korean).join(", "),
    };
    let state = Both::of(|language| state_words(state, language));
    match known.english.is_empty() {
        true => NoPlace::NothingKnown { state },
        false => NoPlace::NoSuchState { state, known },
    }
    .into()
}

/// Gravity, which converts accelerations to g, m/s².
const GRAVITY_M_S2: f64 = 9.81;
/// Seed of the draws, and their smallest number.
const SEED: u64 = 1;
const DRAWS_LEAST: usize = 20;

fn candidates(entries: &[PortfolioEntry], state: usize) -> Vec<Candidate> {
    let known = entries.iter().filter_map(|entry| {
        Some(Candidate {
            capacity: entry.states[state]?,
            hazard: entry.hazard.clone(),
        })
    });
    known.collect()
}

/// A structure ranked by its own study, with one combination of inputs.
///
/// # Errors
/// A sentence with the remedy if the study has several combinations, no usable scan, or something missing.
pub fn of_study(name: String, answer: &StudyAnswer, hazard: Option<Hazard>) -> Result<PortfolioEntry, Both> {
    if let Some(after) = &answer.study.after {
        return Err(CaseRefused::AfterMotion {
            study: answer.study.name.clone(),
            motion: after.motion.clone(),
        }
        .into());
    }
    if !answer.missing.is_empty() {
        return Err(CaseRefused::NotDone {
            study: answer.study.name.clone(),
            missing: answer.missing.len(),
        }
        .into());
    }
    let found = answer.fragilities();
    let [only] = found else {
        let why = match found.len() {
            0 => CaseRefused::NoScan(answer.study.name.clone()),
            combinations => CaseRefused::SeveralCombinations {
                study: answer.study.name.clone(),
                combinations,
            },
        };
        return Err(why.into());
    };
    Ok(PortfolioEntry {
        name,
        basis: Basis::Study {
            name: answer.study.name.clone(),
            variant: answer.study.variants.first().cloned(),
            set: answer.set_shown.clone(),
            scans: only.usable,
            fell_alone: only
                .states
                .iter()
                .map(|state| state.fell_alone)
                .max()
                .unwrap_or(0),
        },
        states: states_of(only),
        has: std::array::from_fn(|state| only.states.iter().any(|own| own.state == state)),
        hazard,
        hazard_replaced: false,
        severe_damage: Vec::new(),
    })
}

fn states_of(found: &CombinationFragility) -> [Option<KnownCapacity>; 4] {
    let mut states = [None; 4];
    // the allowable drift of a file is no damage state
    for state in found.states.iter().filter(|own| own.state != ALLOWED_DRIFT) {
        let of_standing = match &state.by_acceleration {
            Ok(fit) => Some(KnownCapacity {
                fragility: fit.curve,
                ln_theta_sd: fit.ln_theta_deviation(),
                known: Known::Found,
                falls_alone: 0.0,
            }),
            Err(AssessError::NoFragility(bound)) => of_bound(bound),
            Err(_) => None,
        };
        // the allowable drift of a file is no damage state, and lists compare those alone
        if let Some(own) = states.get_mut(state.state) {
            *own = of_standing.map(|known| KnownCapacity {
                falls_alone: state.share_alone(),
                ..known
            });
        }
    }
    states
}

fn of_bound(bound: &FragilityBound) -> Option<KnownCapacity> {
    let (theta, ln_theta_sd, known) = match bound {
        FragilityBound::NoneReached { intensity, .. } => (*intensity, 0.0, Known::AtLeast),
        FragilityBound::AllReached { intensity, .. } => (*intensity, 0.0, Known::AtMost),
        FragilityBound::Middle { above, at_most } if at_most.is_finite() && *above > 0.0 => {
            let width = (at_most / above).ln();
            ((above * at_most).sqrt(), width / 12.0_f64.sqrt(), Known::Found)
        }
        FragilityBound::Middle { above, .. } if *above > 0.0 => (*above, 0.0, Known::AtLeast),
        FragilityBound::Middle { at_most, .. } => (*at_most, 0.0, Known::AtMost),
        // anywhere between the two, in logarithms
        FragilityBound::Separated { survived, reached } => {
            let width = if *survived > 0.0 {
                (reached / survived).ln()
            } else {
                0.0
            };
            ((survived * reached).sqrt(), width / 12.0_f64.sqrt(), Known::Found)
        }
    };
    Some(KnownCapacity {
        fragility: Fragility::new(theta, BETA_OF_BOUNDS).ok()?,
        ln_theta_sd,
        known,
        falls_alone: 0.0,
    })
}

/// A pagoda ranked by its six factors: `models` of the states, the mildest first; `unlike` lists its other differences from the designs.
///
/// # Errors
/// Those of [`ScoreModel::score`].
pub fn of_score(
    name: String,
    (factors, unlike): (&SixFactors, &[Unlike]),
    models: &[Option<ScoreModel>; 4],
    state: usize,
    outside_too: bool,
    hazard: Option<Hazard>,
) -> Result<PortfolioEntry, AssessError> {
    let mut states = [None; 4];
    let mut reasons = [0.0; 6];
    let mut outside = Vec::new();
    for (index, model) in models.iter().enumerate() {
        let Some(model) = model else { continue };
        let score = model.score(factors, outside_too)?;
        if index == state {
            reasons = score.reasons;
            outside = score.outside.iter().map(|one| one.factor).collect();
        }
        states[index] = Some(KnownCapacity {
            fragility: Fragility::new(score.capacity_m_s2, score.beta)?,
            ln_theta_sd: score.ln_capacity_sd,
            known: Known::Found,
            falls_alone: 0.0,
        });
    }
    Ok(PortfolioEntry {
        name,
        basis: Basis::Score {
            reasons,
            outside,
            unlike: unlike.to_vec(),
        },
        states,
        has: [true; 4],
        hazard,
        hazard_replaced: false,
        severe_damage: Vec::new(),
    })
}
