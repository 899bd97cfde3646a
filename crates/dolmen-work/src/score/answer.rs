//! The score of one pagoda, and the quality of the score.

use super::designs::ScoreDesigns;
use crate::judgement::SevereDamage;
use dolmen::assess::{
    AssessError, FactorEffect, FactorShares, HeldOut, PagodaScore, SixFactors, Unlike, factor_shares,
    held_out,
};
use dolmen::numeric::Interval;
use dolmen_project::Names;

/// Number of parts of a cross-validation. Our choice.
const PARTS: usize = 5;
/// Number of random halves for the intervals of the weights, and their seed. Our choice.
const HALVES: usize = 100;
const SEED: u64 = 1;

/// The score in one state.
#[derive(Clone, Debug, PartialEq)]
pub struct StateScore {
    /// The state, 0 to 3.
    pub state: usize,
    /// Number of designs with a curve for it.
    pub designs: usize,
    /// The score.
    pub score: PagodaScore,
    /// 90 % interval of θ, m/s².
    pub interval_m_s2: Interval,
}

/// The score of one pagoda.
#[derive(Clone, Debug)]
pub struct ScoreAnswer {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// Its factors.
    pub factors: SixFactors,
    /// The training range of each factor.
    pub trained: [Interval; 6],
    /// Differences from the designs other than in its factors; empty unless allowed.
    pub unlike: Vec<Unlike>,
    /// Severe damage of its inspections, which the score does not know.
    pub severe_damage: Vec<SevereDamage>,
    /// Number of designs in the table.
    pub designs: usize,
    /// The score for each state that has one.
    pub states: Vec<StateScore>,
    /// Gravity, which converts accelerations to g, m/s².
    pub gravity_m_s2: f64,
}

impl ScoreAnswer {
    /// The states of a pagoda from a table of designs.
    ///
    /// # Errors
    /// [`AssessError::OutsideTraining`] unless `outside_too`; [`AssessError::TooFewDesigns`] if no state has enough designs.
    pub fn states_of(
        designs: &ScoreDesigns,
        factors: &SixFactors,
        outside_too: bool,
    ) -> Result<([Interval; 6], Vec<StateScore>), AssessError> {
        let mut found = Vec::new();
        let mut trained = Err(AssessError::TooFewDesigns { given: 0, least: 28 });
        for state in 0..4 {
            let model = match designs.model(state) {
                Ok(model) => model,
                Err(why) => {
                    trained = trained.or(Err(why));
                    continue;
                }
            };
            trained = Ok(*model.trained_range());
            let score = model.score(factors, outside_too)?;
            found.push(StateScore {
                state,
                designs: model.designs().len(),
                interval_m_s2: score.capacity_interval_m_s2(0.9)?,
                score,
            });
        }
        Ok((trained?, found))
    }
}

/// Differences from the designs, in words.
pub fn unlike_words(unlike: &[Unlike]) -> String {
    let words: Vec<String> = unlike.iter().map(Unlike::to_string).collect();
    words.join("; ")
}

/// The quality of the score for one state.
#[derive(Clone, Debug)]
pub struct ScoreQuality {
    /// The state, 0 to 3.
    pub state: usize,
    /// Number of designs with a curve.
    pub designs: usize,
    /// Weights of the factors.
    pub shares: FactorShares,
    /// Effect of each factor alone on the median design.
    pub effects: Vec<FactorEffect>,
    /// The order of designs in a cross-validation.
    pub held_out: HeldOut,
    /// Correlation of λ with tan α in the designs.
    pub slenderness_correlation: f64,
}

impl ScoreQuality {
    /// The quality for a state of a table.
    ///
    /// # Errors
    /// [`AssessError::TooFewDesigns`].
    pub fn of(designs: &ScoreDesigns, state: usize) -> Result<Self, AssessError> {
        let own = designs.of_state(state);
        let pairs = own
            .iter()
            .map(|design| [design.factors.slenderness_angle, design.factors.body_slenderness]);
        Ok(ScoreQuality {
            state,
            designs: own.len(),
            shares: factor_shares(&own, HALVES, SEED)?,
            effects: designs.model(state)?.effects(&designs.factors())?,
            held_out: held_out(&own, PARTS)?,
            slenderness_correlation: correlation(&pairs.collect::<Vec<_>>()),
        })
    }
}

/// Pearson's coefficient.
fn correlation(pairs: &[[f64; 2]]) -> f64 {
    let n = pairs.len() as f64;
    let mean = |axis: usize| pairs.iter().map(|pair| pair[axis]).sum::<f64>() / n;
    let [a, b] = [mean(0), mean(1)];
    let sum = |of: fn(f64, f64) -> f64| pairs.iter().map(|pair| of(pair[0] - a, pair[1] - b)).sum::<f64>();
    sum(|x, y| x * y) / (sum(|x, _| x * x) * sum(|_, y| y * y)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::assess::{EffectVerdict, Factor};

    /// Signs from Fig. 19 of Kim, Koo and Hong (2018), for falls under one motion: more storeys, a more slender body and more taper are
    /// worse, larger size is better. For the base see docs/score.md.
    #[test]
    fn published_signs_of_the_factors_that_the_table_confirms() {
        let designs = ScoreDesigns::shipped().unwrap();
        assert_eq!(designs.designs.len(), 150);
        let verdict = |state: usize, factor: Factor| {
            let effects = designs.model(state).unwrap().effects(&designs.factors()).unwrap();
            effects.iter().find(|one| one.factor == factor).unwrap().verdict
        };
        for (state, factor) in [
            (2, Factor::Storeys),
            (2, Factor::BodyHeight),
            (3, Factor::BodyHeight),
            (3, Factor::BodySlenderness),
            (1, Factor::Taper),
            (2, Factor::Taper),
        ] {
            assert_eq!(verdict(state, factor), EffectVerdict::Holds, "{state} {factor:?}");
        }
    }
}
