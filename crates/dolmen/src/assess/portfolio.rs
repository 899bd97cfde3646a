//! Ranks many structures by urgency, with an interval of each rank that reflects the uncertainty of the capacities.

use super::{AssessError, Fragility, Hazard, annual_risk};
use crate::numeric::{Interval, Random, normal_quantile, quantile};

/// Capacity of a structure in one damage state, with its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownCapacity {
    /// θ and β over peak ground acceleration, m/s²; β is the scatter between ground motions.
    pub fragility: Fragility,
    /// Standard deviation of ln θ, the uncertainty of the median; 0 or more.
    pub ln_theta_sd: f64,
    /// Whether θ is a value or a bound.
    pub known: Known,
    /// p₀, the probability that the structure falls under its own weight, –. It then reaches the state without shaking; `fragility` describes the
    /// remaining cases.
    pub falls_alone: f64,
}

/// Period in years for the equivalent rate of structures that fall without shaking.
const RATE_YEARS: f64 = 50.0;

impl KnownCapacity {
    /// Intensity at which the state is reached with probability ½, for θ of the cases that stand under their own weight; 0 if half of the cases fall
    /// without shaking.
    ///
    /// ```text
    /// p₀ + (1 − p₀) Φ(ln(x/θ)/β) = ½
    /// ```
    ///
    /// # Errors
    /// No error occurs for 0 ≤ p₀ ≤ 1.
    pub fn median(&self, theta: f64) -> Result<f64, AssessError> {
        let p0 = self.falls_alone;
        if p0 == 0.0 || p0 >= 0.5 {
            return Ok(if p0 == 0.0 { theta } else { 0.0 });
        }
        let z = normal_quantile((0.5 - p0) / (1.0 - p0))?;
        Ok(theta * (self.fragility.beta() * z).exp())
    }

    /// Constant annual rate, 1/year, that gives the same probability in 50 years, from the rate of the cases that stand under their own weight. Cases
    /// that fall without shaking have no finite rate, so a period is needed.
    ///
    /// ```text
    /// 1 − e^(−50 λ) = p₀ + (1 − p₀)(1 − e^(−50 λ_s))        λ = λ_s − ln(1 − p₀)/50
    /// ```
    pub fn rate_in_50_years(&self, of_standing: f64) -> f64 {
        of_standing - (-self.falls_alone).ln_1p() / RATE_YEARS
    }
}

/// Whether a median is a value or a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// The median was determined.
    Found,
    /// A lower bound: no motion reached the state. Ranked by this value; its interval of ranks has no end on the safe side.
    AtLeast,
    /// An upper bound: every motion reached the state at the weakest shaking. Ranked by this value; its interval of ranks begins with 1.
    AtMost,
}

/// A structure in the ranking.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Capacity in the damage state of the ranking.
    pub capacity: KnownCapacity,
    /// Seismic hazard at the site. If every structure has one, the ranking uses annual rates, otherwise capacities.
    pub hazard: Option<Hazard>,
}

/// Quantity of the ranking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RankedBy {
    /// Annual rate of the damage state, the largest first; needs a hazard for every structure.
    AnnualRate,
    /// θ, the smallest first; used if a structure has no hazard.
    Capacity,
}

/// Rank of one structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Index of the candidate, from 0.
    pub candidate: usize,
    /// Rank; 1 is the most urgent. Equal structures share the rank of the first of them.
    pub rank: usize,
    /// 90 % interval of the rank. A bound may lie anywhere on its open side, for its own rank and for those that it then passes.
    pub rank_interval: Interval,
    /// Annual rate of the damage state, 1/year, including the uncertainty of θ. For a structure that may fall under its own weight: the rate that
    /// gives the same probability in 50 years. `None` without a hazard. From a bound of the capacity, a bound.
    pub annual_rate: Option<f64>,
    /// Fraction of the draws in which the structure is among the most urgent tenth, –. From a bound of the capacity, a bound.
    pub worst_tenth: f64,
}

/// The ranking.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranked {
    /// Quantity of the ranking.
    pub by: RankedBy,
    /// All structures, the most urgent first; equal structures keep their order.
    pub places: Vec<Place>,
}

/// Ranks structures by the urgency of an inspection.
///
/// ```text
/// rate = ∫ Φ(ln(x/θ)/√(β² + σ²)) |dλ(x)| − ln(1 − p₀)/50        σ: standard deviation of ln θ; p₀: probability of falling under own weight
/// ranks: in each of `draws` draws, ln θ + σ z with independent normal z, ranked again; 5 to 95 % of the ranks
/// bounds: best rank = rank − number of lower bounds before it, 1 for an upper bound; worst rank = rank + number of upper bounds behind it,
///         the last for a lower bound
/// ```
///
/// # Errors
/// [`AssessError::NothingToRank`] without candidates or for fewer than 20 draws; [`AssessError::Factor`] for a σ that is negative or not a number.
///
/// # Limits
/// The uncertainties of different structures are assumed independent. A common error, such as a friction coefficient that is too high for all of
/// them, changes the rates but not the order.
pub fn rank(candidates: &[Candidate], draws: usize, seed: u64) -> Result<Ranked, AssessError> {
    if candidates.is_empty() || draws < 20 {
        return Err(AssessError::NothingToRank {
            candidates: candidates.len(),
            draws,
        });
    }
    for candidate in candidates {
        let sd = candidate.capacity.ln_theta_sd;
        if !(sd >= 0.0 && sd.is_finite()) {
            return Err(AssessError::Factor {
                factor: "ln_theta_sd",
                given: sd,
                allowed: "0 or more",
            });
        }
        let given = candidate.capacity.falls_alone;
        if !(0.0..=1.0).contains(&given) {
            return Err(AssessError::Factor {
                factor: "falls_alone",
                given,
                allowed: "between 0 and 1",
            });
        }
    }
    let has_all = candidates.iter().all(|candidate| candidate.hazard.is_some());
    let by = if has_all {
        RankedBy::AnnualRate
    } else {
        RankedBy::Capacity
    };
    let mut rates = Vec::with_capacity(candidates.len());
    for Candidate { capacity, hazard } in candidates {
        let whole = capacity.fragility.with_more_dispersion(capacity.ln_theta_sd)?;
        rates.push(
            hazard
                .as_ref()
                .map(|hazard| capacity.rate_in_50_years(annual_risk(hazard, &whole).annual_rate)),
        );
    }
    // a smaller value is more urgent: θ, or the negative rate
    let badness = |theta: f64, rate: Option<f64>| match (by, rate) {
        (RankedBy::AnnualRate, Some(rate)) => 1.0 / rate,
        _ => theta,
    };
    let best = candidates.iter().zip(&rates);
    let own: Vec<f64> = best
        .map(|(Candidate { capacity, .. }, rate)| {
            let median = capacity.median(capacity.fragility.theta())?;
            Ok(badness(median, *rate))
        })
        .collect::<Result<_, AssessError>>()?;
    let order = order_of(&own);
    let mut drawn_ends = vec![[Vec::with_capacity(draws), Vec::with_capacity(draws)]; candidates.len()];
    let worst = candidates.len().div_ceil(10);
    let mut among_worst = vec![0_usize; candidates.len()];
    for draw in 0..draws {
        let mut random = Random::new(seed, draw as u64);
        let mut values = Vec::with_capacity(candidates.len());
        for Candidate { capacity, hazard } in candidates {
            let theta = capacity.fragility.theta() * (capacity.ln_theta_sd * random.normal()).exp();
            let fragility = Fragility::new(theta, capacity.fragility.beta())?;
            let rate = hazard.as_ref().filter(|_| by == RankedBy::AnnualRate);
            values.push(badness(
                capacity.median(theta)?,
                rate.map(|hazard| capacity.rate_in_50_years(annual_risk(hazard, &fragility).annual_rate)),
            ));
        }
        let drawn = order_of(&values);
        let ends = ends_of(&drawn, candidates);
        for (place, (candidate, [best, last])) in drawn.into_iter().zip(ends).enumerate() {
            drawn_ends[candidate][0].push(best as f64);
            drawn_ends[candidate][1].push(last as f64);
            among_worst[candidate] += usize::from(place < worst);
        }
    }
    let mut places: Vec<Place> = Vec::with_capacity(order.len());
    for (place, candidate) in order.into_iter().enumerate() {
        let equal = places.last().filter(|last| own[last.candidate] == own[candidate]);
        let [best, last] = &drawn_ends[candidate];
        places.push(Place {
            candidate,
            rank: equal.map_or(place + 1, |last| last.rank),
            rank_interval: Interval {
                lower: quantile(best, 0.05)?,
                upper: quantile(last, 0.95)?,
            },
            annual_rate: rates[candidate],
            worst_tenth: among_worst[candidate] as f64 / draws as f64,
        });
    }
    Ok(Ranked { by, places })
}

/// The best and the worst rank of each candidate of an order, if bounds lie anywhere on their open side.
fn ends_of(order: &[usize], candidates: &[Candidate]) -> Vec<[usize; 2]> {
    let known = |candidate: &usize| candidates[*candidate].capacity.known;
    let count = |of: &[usize], bound: Known| of.iter().filter(|other| known(other) == bound).count();
    let ends = order.iter().enumerate().map(|(place, own)| {
        let (before, behind) = (&order[..place], &order[place + 1..]);
        let best = match known(own) {
            Known::AtMost => 1,
            Known::Found | Known::AtLeast => place + 1 - count(before, Known::AtLeast),
        };
        let last = match known(own) {
            Known::AtLeast => order.len(),
            Known::Found | Known::AtMost => place + 1 + count(behind, Known::AtMost),
        };
        [best, last]
    });
    ends.collect()
}

/// Indices in ascending order of value; equal values keep their order.
fn order_of(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(theta: f64, beta: f64, sd: f64, hazard: Option<Hazard>) -> Candidate {
        let capacity = KnownCapacity {
            fragility: Fragility::new(theta, beta).unwrap(),
            ln_theta_sd: sd,
            known: Known::Found,
            falls_alone: 0.0,
        };
        Candidate { capacity, hazard }
    }

    /// A structure that falls under its own weight in one sample of seven, compared with the same structure without such samples.
    #[test]
    fn exact_what_falls_without_shaking_moves_median_rate_and_place() {
        let hazard = Hazard::through(1.0, 500.0, 2.0).unwrap();
        let alone = |share: f64, theta: f64, hazard: Option<Hazard>| {
            let mut one = candidate(theta, 0.4, 0.0, hazard);
            one.capacity.falls_alone = share;
            one
        };
        let p0 = 1.0 / 7.0;
        let found = rank(
            &[
                candidate(2.0, 0.4, 0.0, Some(hazard.clone())),
                alone(p0, 3.0, Some(hazard.clone())),
            ],
            20,
            1,
        )
        .unwrap();
        let worst = &found.places[0];
        assert_eq!(worst.candidate, 1);
        let standing = 3.0_f64.powi(-2) / 500.0 * (2.0 * 0.16_f64).exp();
        let in_50_years = p0 + (1.0 - p0) * -(-50.0 * standing).exp_m1();
        let rate = worst.annual_rate.unwrap();
        assert!((-(-50.0 * rate).exp_m1() / in_50_years - 1.0).abs() < 1e-12);
        // without a hazard: p0 + (1 − p0) Φ(z) = ½, Φ(z) = 5/12, z = −.210428 (tables)
        let median = alone(p0, 3.0, None).capacity.median(3.0).unwrap();
        assert!(
            (median / (3.0 * (-0.4 * 0.210_428_f64).exp()) - 1.0).abs() < 1e-6,
            "{median}"
        );
        assert_eq!(alone(0.5, 3.0, None).capacity.median(3.0), Ok(0.0));
        let found = rank(&[candidate(2.9, 0.4, 0.0, None), alone(p0, 3.0, None)], 20, 1).unwrap();
        assert_eq!(found.places[0].candidate, 1);
        assert!(rank(&[alone(1.1, 3.0, None)], 20, 1).is_err());
    }

    #[test]
    fn exact_order_and_rates_of_power_laws() {
        // λ = k0 θ^−k exp(k²(β² + σ²)/2), theory of Cornell
        let hazard = |rate| Hazard::through(1.0, rate, 2.0).unwrap();
        let all = [
            candidate(3.0, 0.4, 0.1, Some(hazard(500.0))),
            candidate(2.0, 0.4, 0.1, Some(hazard(5000.0))),
            candidate(2.5, 0.4, 0.3, Some(hazard(500.0))),
        ];
        let found = rank(&all, 400, 1).unwrap();
        assert_eq!(found.by, RankedBy::AnnualRate);
        let order: Vec<usize> = found.places.iter().map(|place| place.candidate).collect();
        assert_eq!(order, [2, 0, 1]);
        for (place, (theta, sd, period)) in
            found
                .places
                .iter()
                .zip([(2.5, 0.3, 500.0), (3.0, 0.1, 500.0), (2.0, 0.1, 5000.0_f64)])
        {
            let (theta, sd): (f64, f64) = (theta, sd);
            let exact = theta.powi(-2) / period * (2.0 * (0.16 + sd * sd)).exp();
            let rate = place.annual_rate.unwrap();
            assert!((rate / exact - 1.0).abs() < 1e-9, "{rate} {exact}");
        }
        // one structure has no hazard: all are ranked by capacity
        let mut some = all;
        some[0].hazard = None;
        let found = rank(&some, 20, 1).unwrap();
        assert_eq!(found.by, RankedBy::Capacity);
        let order: Vec<usize> = found.places.iter().map(|place| place.candidate).collect();
        assert_eq!(order, [1, 2, 0]);
    }

    #[test]
    fn exact_equal_structures_share_their_rank() {
        let thetas = [2.0, 1.0, 2.0, 3.0];
        let found = rank(&thetas.map(|theta| candidate(theta, 0.4, 0.1, None)), 20, 1).unwrap();
        let ranks: Vec<[usize; 2]> = found.places.iter().map(|of| [of.candidate, of.rank]).collect();
        assert_eq!(ranks, [[1, 1], [0, 2], [2, 2], [3, 4]]);
    }

    /// For two structures, the probability that the better one is drawn as the worse one is Φ(−Δ ln θ/√(σ₁² + σ₂²)).
    #[test]
    fn exact_chance_of_changing_places() {
        let all = [candidate(1.0, 0.4, 0.3, None), candidate(1.2, 0.4, 0.4, None)];
        let found = rank(&all, 4000, 3).unwrap();
        let swapped = 0.357_6; // Φ(−ln 1.2/.5), tables
        assert!((found.places[1].worst_tenth - swapped).abs() < 0.02, "{found:?}");
        assert!((found.places[0].worst_tenth + found.places[1].worst_tenth - 1.0).abs() < 1e-12);
        assert_eq!(
            found.places[0].rank_interval,
            Interval {
                lower: 1.0,
                upper: 2.0
            }
        );
        let sure = [candidate(1.0, 0.4, 0.0, None), candidate(1.2, 0.4, 0.0, None)];
        let found = rank(&sure, 20, 3).unwrap();
        assert_eq!(
            found.places[0].rank_interval,
            Interval {
                lower: 1.0,
                upper: 1.0
            }
        );
        assert_eq!(found.places[0].candidate, 0);
    }

    /// By hand: B 1, C 2, A < 3 at 3, D > 4 at 4. A may be anywhere up to its place, D anywhere from its place on, B and C may be passed by A.
    #[test]
    fn exact_the_place_of_a_bound_is_open_on_its_side() {
        let of = |theta: f64, known: Known| {
            let mut one = candidate(theta, 0.4, 0.0, None);
            one.capacity.known = known;
            one
        };
        let all = [
            of(3.0, Known::AtMost),
            of(1.0, Known::Found),
            of(2.0, Known::Found),
            of(4.0, Known::AtLeast),
            of(5.0, Known::Found),
        ];
        let found = rank(&all, 20, 3).unwrap();
        let each = found.places.iter().map(|place| {
            let of = place.rank_interval;
            (place.candidate, [of.lower, of.upper])
        });
        let by_hand = [
            (1, [1.0, 2.0]),
            (2, [2.0, 3.0]),
            (0, [1.0, 3.0]),
            (3, [4.0, 5.0]),
            (4, [4.0, 5.0]),
        ];
        assert_eq!(each.collect::<Vec<_>>(), by_hand);
    }

    #[test]
    fn refuses_nothing_and_deviations_that_cannot_be() {
        assert!(matches!(
            rank(&[], 100, 1),
            Err(AssessError::NothingToRank { candidates: 0, .. })
        ));
        let bad = [candidate(1.0, 0.4, f64::NAN, None)];
        assert!(
            rank(&bad, 100, 1)
                .unwrap_err()
                .to_string()
                .starts_with("ln_theta_sd is NaN")
        );
    }
}
