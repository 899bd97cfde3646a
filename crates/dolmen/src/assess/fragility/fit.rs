//! Maximum-likelihood fit of a lognormal fragility curve.

use super::curve::Fragility;
use super::fitted_curve::FragilityFit;
use super::likelihood::{Likelihood, likelihood};
use super::observation::{Observation, bound, middle_capacity};
use crate::assess::AssessError;
use crate::numeric::{mean, variance};
use std::collections::BTreeMap;

/// Smallest number of motions for a curve.
pub(super) const MOTIONS_LEAST: usize = 3;
/// Largest number of Newton steps, the step at convergence, and the step that is too large for convergence.
const STEPS_MOST: usize = 200;
const STEP_LEAST: f64 = 1e-13;
const STEP_MOST: f64 = 1e-6;
/// Ratio of the standard error of β to β above which there is no curve, because its steepness is unknown. Our choice.
const BETA_ERROR_MOST: f64 = 3.0;

/// The maximum-likelihood lognormal curve of observations, which may be of different kinds.
///
/// ```text
/// stripe     ln L = k ln Φ(z) + (n − k) ln Φ(−z)
/// at x       ln L = ln φ(z) − ln(β x)                    the state was first reached here
/// above x    ln L = ln Φ(−z)                             censored: not reached up to here
/// between    ln L = ln(Φ(z_high) − Φ(z_low))             z = ln(x/θ)/β
/// below x    ln L = ln Φ(z)
/// errors: the inverse of the observed information
/// ```
///
/// # Errors
/// [`AssessError::TooFewMotions`] for fewer than 3; [`AssessError::NoFragility`] with a bound if none or all reached the state, or if the intensity
/// alone separates them; [`AssessError::FragilityFalls`]; [`AssessError::Observation`].
///
/// # Limits
/// Observations are assumed to be independent. Stripes of the same motions are not fully independent, so their errors are too small; for motions in
/// several directions see [`fit_fragility_of_motions`]. A curve is monotone, but rocking is not: use the first intensity at which a motion reached
/// the state, and report the number of motions that survived a larger one.
///
/// # Source
/// Baker, J. W. (2015) Efficient analytical fragility function fitting using dynamic structural analysis. Earthq. Spectra
/// 31(1):579–599. Differs from the source: censored and bracketed motions, and errors.
///
/// # Example
/// ```
/// use dolmen::assess::{Observation, fit_fragility};
/// let intensity = [0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0];
/// let reached = [0, 0, 0, 4, 6, 13, 12, 16];
/// let stripes: Vec<Observation> = intensity.iter().zip(reached)
///     .map(|(&intensity, reached)| Observation::Stripe { intensity, motions: 40, reached }).collect();
/// let fit = fit_fragility(&stripes)?;
/// assert!((fit.curve.theta() - 1.076116).abs() < 1e-6 && (fit.curve.beta() - 0.429237).abs() < 1e-6);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn fit_fragility(observations: &[Observation]) -> Result<FragilityFit, AssessError> {
    let motions = motions_of(observations);
    let top = LikelihoodMaximum::of(observations, motions)?;
    top.fit(observations, motions, top.likelihood.covariance())
}

/// As [`fit_fragility`], for several observations per motion: in other directions, or with other samples of uncertain inputs. `motions` holds the
/// index of the motion of each observation. Results of one motion are correlated, so the standard errors come from the differences between motions.
///
/// ```text
/// V = A⁻¹ (Σ g gᵀ) A⁻¹,   g the sum of the gradients of one motion, A the observed information; never below A⁻¹ for ln θ
/// ```
///
/// # Errors
/// As [`fit_fragility`], [`AssessError::TooFewMotions`] for fewer than 3 different motions or a list of another length.
///
/// # Source
/// Liang, K.-Y. and Zeger, S. L. (1986) Longitudinal data analysis using generalized linear models. Biometrika 73(1):13–22.
pub fn fit_fragility_of_motions(
    observations: &[Observation],
    motions: &[usize],
) -> Result<FragilityFit, AssessError> {
    let mut by_motion: BTreeMap<usize, Vec<Observation>> = BTreeMap::new();
    for (motion, observation) in motions.iter().zip(observations) {
        by_motion.entry(*motion).or_default().push(*observation);
    }
    let different = if motions.len() == observations.len() {
        by_motion.len()
    } else {
        0
    };
    let top = LikelihoodMaximum::of(observations, different)?;
    let own = top.likelihood.covariance();
    let independent = top.fit(observations, different, own)?;
    if by_motion.len() == observations.len() {
        return Ok(independent);
    }
    let mut spread = [0.0; 3];
    for one in by_motion.values() {
        let [a, c] = likelihood(one, top.middle, top.at).gradient;
        spread[0] += a * a;
        spread[1] += a * c;
        spread[2] += c * c;
    }
    let [aa, ac, cc] = own;
    let [saa, sac, scc] = spread;
    let mixed = [
        [aa * saa + ac * sac, aa * sac + ac * scc],
        [ac * saa + cc * sac, ac * sac + cc * scc],
    ];
    let between = [
        mixed[0][0] * aa + mixed[0][1] * ac,
        mixed[0][0] * ac + mixed[0][1] * cc,
        mixed[1][0] * ac + mixed[1][1] * cc,
    ];
    let of_motions = top.fit(observations, different, between)?;
    Ok(match of_motions.ln_theta_error > independent.ln_theta_error {
        true => of_motions,
        false => independent,
    })
}

#[derive(Clone, Copy, Debug)]
struct LikelihoodMaximum {
    /// Midpoint of the logarithms of the intensities.
    middle: f64,
    at: [f64; 2],
    likelihood: Likelihood,
}

impl LikelihoodMaximum {
    fn of(observations: &[Observation], motions: usize) -> Result<Self, AssessError> {
        for (i, observation) in observations.iter().enumerate() {
            observation.check(i + 1)?;
        }
        if motions < MOTIONS_LEAST {
            return Err(AssessError::TooFewMotions { given: motions });
        }
        if let Some(bound) = bound(observations) {
            return Err(AssessError::NoFragility(bound.of_motions(motions)));
        }
        let logs = observations.iter().flat_map(|o| o.intensities().map(f64::ln));
        let logs: Vec<f64> = logs.collect();
        let middle = mean(&logs)?;
        let likelihood = |at: [f64; 2]| likelihood(observations, middle, at);
        let mut at = [1.0 / variance(&logs)?.sqrt().max(1e-3), 0.0];
        let mut here = likelihood(at);
        let mut left = f64::INFINITY; // Newton step relative to the current value
        for _ in 0..STEPS_MOST {
            let step = here.newton();
            // halved until the likelihood rises: it is concave, so the iteration ends at its maximum
            let mut part = 1.0;
            let (next, there) = loop {
                let next = [at[0] + part * step[0], at[1] + part * step[1]];
                let there = likelihood(next);
                if there.value >= here.value || part < 1e-12 {
                    break (next, there);
                }
                part *= 0.5;
            };
            left = (step[0] / at[0]).abs() + step[1].abs() / (1.0 + at[1].abs());
            (at, here) = (next, there);
            if part * left <= STEP_LEAST {
                break;
            }
        }
        if at[0] <= 0.0 {
            return Err(AssessError::FragilityFalls);
        }
        if left.is_nan() || left > STEP_MOST {
            return Err(AssessError::NoFragility(middle_capacity(observations)));
        }
        Ok(LikelihoodMaximum {
            middle,
            at,
            likelihood: here,
        })
    }

    /// The curve, with errors from the covariance (aa, ac, cc) of its slope and offset.
    fn fit(
        &self,
        observations: &[Observation],
        motions: usize,
        [aa, ac, cc]: [f64; 3],
    ) -> Result<FragilityFit, AssessError> {
        let [slope, offset] = self.at;
        let beta = 1.0 / slope;
        // d ln θ = (dc − (c/a) da)/a, dβ = −da/a²
        let ratio = offset / slope;
        let ln_theta = (cc - 2.0 * ratio * ac + ratio * ratio * aa) / (slope * slope);
        let both = (ratio * aa - ac) / (slope * slope * slope);
        let (ln_theta_error, beta_error) = (ln_theta.sqrt(), aa.sqrt() / (slope * slope));
        let is_known = ln_theta_error.is_finite() && beta_error <= BETA_ERROR_MOST * beta;
        if !is_known {
            return Err(AssessError::NoFragility(middle_capacity(observations)));
        }
        let jacobian: f64 = observations
            .iter()
            .map(|o| match o {
                Observation::At(x) => x.ln(),
                _ => 0.0,
            })
            .sum();
        Ok(FragilityFit {
            curve: Fragility::new((self.middle + offset * beta).exp(), beta)?,
            ln_theta_error,
            beta_error,
            covariance: both,
            log_likelihood: Some(self.likelihood.value - jacobian),
            motions,
            reached: observations.iter().map(Observation::reached).sum(),
            observations: observations.iter().map(Observation::motions).sum(),
            of_samples: None,
        })
    }
}

/// Number of different motions: the single ones and those of the largest stripe, because all stripes use the same motions.
fn motions_of(observations: &[Observation]) -> usize {
    let (mut single, mut stripe) = (0, 0);
    for observation in observations {
        match observation {
            Observation::Stripe { motions, .. } => stripe = stripe.max(*motions),
            _ => single += 1,
        }
    }
    single + stripe
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assess::{
        FragilityBound, bootstrap_fragility, bootstrap_fragility_of_motions, fit_fragility_by_moments,
        motions_needed,
    };
    use crate::numeric::{Interval, Random, ln_normal_density};

    fn stripes(reached: &[usize]) -> Vec<Observation> {
        const INTENSITY: [f64; 8] = [0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0];
        let each = INTENSITY.iter().zip(reached);
        each.map(|(&intensity, &reached)| Observation::Stripe {
            intensity,
            motions: 40,
            reached,
        })
        .collect()
    }

    const BAKER: [usize; 8] = [0, 0, 0, 4, 6, 13, 12, 16];

    #[test]
    fn published_fit_of_baker_with_its_errors() {
        let fit = fit_fragility(&stripes(&BAKER)).unwrap();
        assert!((fit.curve.theta() - 1.076_116).abs() < 5e-7, "{fit:?}");
        assert!((fit.curve.beta() - 0.429_237).abs() < 5e-7, "{fit:?}");
        assert!((fit.ln_theta_error - 0.0717).abs() < 5e-5, "{fit:?}");
        assert!((fit.beta_error - 0.0839).abs() < 5e-5, "{fit:?}");
        assert_eq!((fit.motions, fit.reached, fit.observations), (40, 51, 320));
        let capacities = [0.31, 0.36, 0.42, 0.44, 0.47, 0.52, 0.55, 0.58, 0.66, 0.83];
        let fit = fit_fragility_by_moments(&capacities).unwrap();
        assert!((fit.curve.theta() - 0.494_866).abs() < 5e-7, "{fit:?}");
        assert!((fit.curve.beta() - 0.289_162).abs() < 5e-7, "{fit:?}");
    }

    #[test]
    fn exact_where_all_capacities_are_known() {
        // the most likely β of n known capacities is that of moments times √((n − 1)/n), with errors β/√n and β/√(2 n)
        let capacities = [0.31, 0.36, 0.42, 0.44, 0.47, 0.52, 0.55, 0.58, 0.66, 0.83];
        let moments = fit_fragility_by_moments(&capacities).unwrap();
        let fit = fit_fragility(&capacities.map(Observation::At)).unwrap();
        let beta = moments.curve.beta() * 0.9_f64.sqrt();
        assert!((fit.curve.theta() / moments.curve.theta() - 1.0).abs() < 1e-12);
        assert!((fit.curve.beta() / beta - 1.0).abs() < 1e-12);
        assert!((fit.ln_theta_error / (beta / 10.0_f64.sqrt()) - 1.0).abs() < 1e-10);
        assert!((fit.beta_error / (beta / 20.0_f64.sqrt()) - 1.0).abs() < 1e-10);
        assert!(fit.covariance.abs() < 1e-12);
        let density = |x: &f64| {
            let z = (x / fit.curve.theta()).ln() / fit.curve.beta();
            ln_normal_density(z) - (x * fit.curve.beta()).ln()
        };
        let value: f64 = capacities.iter().map(density).sum();
        assert!((fit.log_likelihood.unwrap() - value).abs() < 1e-12);
    }

    #[test]
    fn holds_every_kind_of_observation_has_its_derivatives() {
        let mixed = [
            Observation::At(0.5),
            Observation::Above(0.7),
            Observation::Below(0.4),
            Observation::Between(0.45, 0.6),
            Observation::Between(0.9, 1.4),
            stripes(&BAKER)[4],
        ];
        let at = [2.1, 0.3];
        let h = 1e-5;
        let of = |da: f64, dc: f64| likelihood(&mixed, -0.5, [at[0] + da * h, at[1] + dc * h]);
        let here = of(0.0, 0.0);
        for (direction, [da, dc]) in [[1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
            let (up, down) = (of(da, dc), of(-da, -dc));
            let slope = (up.value - down.value) / (2.0 * h);
            assert!((slope - here.gradient[direction]).abs() < 1e-8, "{direction}");
            for other in 0..2 {
                let curve = (up.gradient[other] - down.gradient[other]) / (2.0 * h);
                let wanted = here.curvature[direction + other];
                assert!(
                    (curve - wanted).abs() < 1e-7,
                    "{direction} {other}: {curve} {wanted}"
                );
            }
        }
    }

    #[test]
    fn holds_the_intervals_hold_the_truth_as_often_as_they_say() {
        // 2000 trials of 8 stripes of 40 motions each, from θ = 0.7, β = 0.4
        let truth = Fragility::new(0.7, 0.4).unwrap();
        let (mut theta, mut beta, mut probability) = (0, 0, 0);
        const TRIALS: u64 = 2000;
        for trial in 0..TRIALS {
            let mut random = Random::new(11, trial);
            let mut drawn = stripes(&[0; 8]);
            for observation in &mut drawn {
                if let Observation::Stripe {
                    intensity,
                    motions,
                    reached,
                } = observation
                {
                    let p = truth.probability(*intensity);
                    *reached = (0..*motions).filter(|_| random.uniform() < p).count();
                }
            }
            let fit = fit_fragility(&drawn).unwrap();
            let holds = |interval: Interval, value: f64| {
                usize::from(interval.lower <= value && value <= interval.upper)
            };
            theta += holds(fit.theta_interval(0.95).unwrap(), 0.7);
            beta += holds(fit.beta_interval(0.95).unwrap(), 0.4);
            let at = fit.probability_interval(0.5, 0.95).unwrap();
            probability += holds(at, truth.probability(0.5));
        }
        for (what, count) in [("theta", theta), ("beta", beta), ("probability", probability)] {
            let share = count as f64 / TRIALS as f64;
            assert!((0.93..=0.97).contains(&share), "{what}: {share}");
        }
    }

    #[test]
    fn holds_intervals_of_few_motions_hold_the_truth_too() {
        // capacities of 5 motions, all known: Student's and the χ² interval are exact
        let (mut theta, mut beta) = (0, 0);
        const TRIALS: u64 = 4000;
        for trial in 0..TRIALS {
            let mut random = Random::new(17, trial);
            let drawn: Vec<Observation> = (0..5)
                .map(|_| Observation::At(0.7 * (0.4 * random.normal()).exp()))
                .collect();
            let fit = fit_fragility(&drawn).unwrap();
            let holds = |interval: Interval, value: f64| {
                usize::from(interval.lower <= value && value <= interval.upper)
            };
            theta += holds(fit.theta_interval(0.95).unwrap(), 0.7);
            beta += holds(fit.beta_interval(0.95).unwrap(), 0.4);
        }
        for (what, count) in [("theta", theta), ("beta", beta)] {
            let share = f64::from(count as u32) / TRIALS as f64;
            assert!((0.94..=0.96).contains(&share), "{what}: {share}"); // ± three standard deviations
        }
    }

    #[test]
    fn holds_directions_of_one_motion_do_not_count_as_motions() {
        // 12 motions with a standard deviation of 0.38, in 8 directions with 0.15 more each, known to steps of a tenth
        let mut held = [0, 0];
        const TRIALS: u64 = 400;
        for trial in 0..TRIALS {
            let mut random = Random::new(29, trial);
            let (mut drawn, mut motions) = (Vec::new(), Vec::new());
            for motion in 0..12 {
                let own = 0.38 * random.normal();
                for _ in 0..8 {
                    let capacity = 0.7 * (own + 0.15 * random.normal()).exp();
                    let low = 0.1 * 1.1_f64.powf((capacity / 0.1).ln().div_euclid(1.1_f64.ln()));
                    drawn.push(Observation::Between(low, 1.1 * low));
                    motions.push(motion);
                }
            }
            let together = fit_fragility_of_motions(&drawn, &motions).unwrap();
            let apart = fit_fragility(&drawn).unwrap();
            assert_eq!((together.motions, apart.motions), (12, 96));
            for (held, fit) in held.iter_mut().zip([together, apart]) {
                let interval = fit.theta_interval(0.95).unwrap();
                *held += usize::from(interval.lower <= 0.7 && 0.7 <= interval.upper);
            }
        }
        let [together, apart] = held.map(|count| f64::from(count as u32) / TRIALS as f64);
        assert!((0.915..=0.985).contains(&together), "{together}");
        assert!(apart < 0.7, "{apart}"); // the share with independent observations
        let one = [Observation::At(0.3), Observation::At(0.4), Observation::At(0.5)];
        assert_eq!(
            fit_fragility_of_motions(&one, &[0, 0, 1]),
            Err(AssessError::TooFewMotions { given: 2 })
        );
        assert_eq!(fit_fragility_of_motions(&one, &[4, 0, 1]), fit_fragility(&one));
        // 5 motions × 60 samples, none fell: 1 − 0.05^(1/5), not with 300
        let motions: Vec<usize> = (0..300).map(|i| i % 5).collect();
        let none = fit_fragility_of_motions(&[Observation::Above(0.4); 300], &motions).unwrap_err();
        let AssessError::NoFragility(FragilityBound::NoneReached { probability_most, .. }) = none else {
            panic!("{none}");
        };
        assert!(
            (probability_most - 0.450_719_7).abs() < 1e-6,
            "{probability_most}"
        );
    }

    #[test]
    fn holds_censored_scans_find_what_made_them() {
        // 4000 capacities, known to a step of the scan and not beyond its end
        let mut random = Random::new(5, 0);
        let grid: Vec<f64> = (0..9).map(|i| 0.2 * 1.25_f64.powi(i)).collect();
        let drawn: Vec<Observation> = (0..4000)
            .map(|_| {
                let capacity = 0.7 * (0.4 * random.normal()).exp();
                match grid.iter().position(|x| capacity <= *x) {
                    Some(0) => Observation::Below(grid[0]),
                    Some(i) => Observation::Between(grid[i - 1], grid[i]),
                    None => Observation::Above(grid[8]),
                }
            })
            .collect();
        let fit = fit_fragility(&drawn).unwrap();
        assert!(
            (fit.curve.theta() / 0.7).ln().abs() < 3.0 * fit.ln_theta_error,
            "{fit:?}"
        );
        assert!((fit.curve.beta() - 0.4).abs() < 3.0 * fit.beta_error, "{fit:?}");
        assert!(fit.ln_theta_error < 0.009 && fit.beta_error < 0.009, "{fit:?}");
    }

    #[test]
    fn holds_bands_of_resamples_are_as_wide_as_the_errors() {
        let band = bootstrap_fragility(&stripes(&BAKER), 400, 1).unwrap();
        let fit = fit_fragility(&stripes(&BAKER)).unwrap();
        assert_eq!(band.curves.len() + band.without_curve, 400);
        let (boot, wald) = (
            band.theta(0.95).unwrap().unwrap(),
            fit.theta_interval(0.95).unwrap(),
        );
        let ratio = (boot.upper / boot.lower).ln() / (wald.upper / wald.lower).ln();
        assert!((0.85..1.2).contains(&ratio), "{ratio}");
        assert_eq!(band, bootstrap_fragility(&stripes(&BAKER), 400, 1).unwrap());
    }

    /// For 30 motions in 6 directions, the bands have the width of the errors between motions, not of 180 independent observations.
    #[test]
    fn holds_bands_draw_motions_and_not_their_directions() {
        let mut random = Random::new(31, 0);
        let (mut seen, mut motions) = (Vec::new(), Vec::new());
        for motion in 0..30 {
            let own = 0.38 * random.normal();
            for _ in 0..6 {
                seen.push(Observation::At(0.7 * (own + 0.1 * random.normal()).exp()));
                motions.push(motion);
            }
        }
        let width = |interval: Interval| (interval.upper / interval.lower).ln();
        let fit = fit_fragility_of_motions(&seen, &motions).unwrap();
        let wald = width(fit.theta_interval(0.95).unwrap());
        let band = bootstrap_fragility_of_motions(&seen, &motions, 400, 1).unwrap();
        let of_motions = width(band.theta(0.95).unwrap().unwrap());
        assert!((0.8..1.15).contains(&(of_motions / wald)), "{of_motions} {wald}");
        let apart = bootstrap_fragility(&seen, 400, 1).unwrap();
        let of_each = width(apart.theta(0.95).unwrap().unwrap());
        assert!(of_each < 0.6 * of_motions, "{of_each} {of_motions}");
    }

    #[test]
    fn refuses_what_has_no_curve_with_what_it_says_all_the_same() {
        let said = |observations: &[Observation]| fit_fragility(observations).unwrap_err().to_string();
        assert!(said(&[Observation::At(0.3), Observation::At(0.4)]).starts_with("2 motions are too few"));
        let none = said(&stripes(&[0; 8]));
        assert!(
            none.contains("at an intensity of 1.0000 is at most 0.072"),
            "{none}"
        );
        let all = said(&stripes(&[40; 8]));
        assert!(
            all.contains("at an intensity of 0.2000 is at least 0.928"),
            "{all}"
        );
        let apart = said(&stripes(&[0, 0, 0, 40, 40, 40, 40, 40]));
        assert!(
            apart.contains("up to an intensity of 0.4000 and everything from 0.6000 on"),
            "{apart}"
        );
        let falling = said(&stripes(&[9, 8, 8, 7, 6, 5, 4, 3]));
        assert!(
            falling.starts_with("the state is reached no more often"),
            "{falling}"
        );
        assert!(said(&[Observation::At(-0.3); 3]).contains("observation 1 has -0.3"));
        assert!(fit_fragility_by_moments(&[0.4; 5]).is_err());
        assert_eq!(motions_needed(0.4, 0.1).unwrap(), 16);
    }
}
