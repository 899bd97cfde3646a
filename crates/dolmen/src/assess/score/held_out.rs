//! Tests how well a score ranks pagodas that were not in its training data.

use super::factors::Factor;
use super::kriging::Kriging;
use super::model::{TrainedDesign, coordinates};
use crate::assess::{AssessError, trend};

/// Fraction of the designs with the lowest capacities that the score must find.
const WORST: f64 = 0.2;

/// Agreement of the ranking by predicted capacities with that by simulated ones.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ranking {
    /// Kendall's τ of predicted and simulated capacity, −1 to 1.
    pub kendall_tau: f64,
    /// Fraction of the worst fifth that is also in the predicted worst fifth, –.
    pub worst_fifth_found: f64,
}

/// Ranking of held-out designs by the score, compared with simpler scores.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HeldOut {
    /// Number of parts of the designs; each part is predicted from the others.
    pub parts: usize,
    /// Ranking by the score.
    pub score: Ranking,
    /// Ranking by the sum of the standardised factors, with the published directions and equal weights.
    pub equal_weights: Ranking,
    /// Ranking by tan α alone.
    pub slenderness_angle: Ranking,
}

/// Ranks designs by a score that was trained on the others: every `parts`-th design is held out in turn.
///
/// # Errors
/// [`AssessError::TooFewDesigns`] if a part is empty, or the others are too few; [`AssessError::Factor`].
pub fn held_out(designs: &[TrainedDesign], parts: usize) -> Result<HeldOut, AssessError> {
    if parts < 2 || designs.len() < 10 * parts {
        return Err(AssessError::TooFewDesigns {
            given: designs.len(),
            least: 10 * parts.max(2),
        });
    }
    let (x, y) = coordinates(designs)?;
    let mut predicted = vec![0.0; y.len()];
    for part in 0..parts {
        let others = || (0..y.len()).filter(|i| i % parts != part);
        let own_x: Vec<[f64; 6]> = others().map(|i| x[i]).collect();
        let own_y: Vec<f64> = others().map(|i| y[i]).collect();
        let surface = Kriging::fit(&own_x, &own_y)?;
        for i in (0..y.len()).filter(|i| i % parts == part) {
            predicted[i] = surface.value(&x[i]);
        }
    }
    let count = y.len() as f64;
    let column = |axis: usize| -> Vec<f64> {
        let middle = x.iter().map(|place| place[axis]).sum::<f64>() / count;
        let squares = x.iter().map(|place| (place[axis] - middle).powi(2));
        let spread = (squares.sum::<f64>() / count).sqrt();
        let over = if spread > 0.0 { spread } else { 1.0 };
        x.iter().map(|place| (place[axis] - middle) / over).collect()
    };
    let mut equal = vec![0.0; y.len()];
    for (axis, factor) in Factor::ALL.into_iter().enumerate() {
        for (sum, z) in equal.iter_mut().zip(column(axis)) {
            *sum += factor.published_direction() * z;
        }
    }
    Ok(HeldOut {
        parts,
        score: ranking(&predicted, &y)?,
        equal_weights: ranking(&equal, &y)?,
        slenderness_angle: ranking(&column(2), &y)?,
    })
}

fn ranking(predicted: &[f64], simulated: &[f64]) -> Result<Ranking, AssessError> {
    let points: Vec<(f64, f64)> = predicted.iter().copied().zip(simulated.iter().copied()).collect();
    let worst = |values: &[f64]| {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        order.truncate(((WORST * values.len() as f64).round() as usize).max(1));
        order
    };
    let (found, true_ones) = (worst(predicted), worst(simulated));
    let hits = true_ones.iter().filter(|design| found.contains(design)).count();
    Ok(Ranking {
        kendall_tau: trend(&[vec![points]])?.tau,
        worst_fifth_found: hits as f64 / true_ones.len() as f64,
    })
}

#[cfg(test)]
mod tests {
    use super::super::factors::SixFactors;
    use super::*;
    use crate::assess::Fragility;
    use crate::numeric::Random;

    fn designs(count: usize, noise: f64) -> Vec<TrainedDesign> {
        let mut random = Random::new(6, 0);
        (0..count)
            .map(|_| {
                let mut u = || 0.5 + random.uniform();
                let factors = SixFactors {
                    storeys: 3,
                    body_height_m: 4.0 * u(),
                    slenderness_angle: 0.3 * u(),
                    body_slenderness: 3.0 * u(),
                    taper_rad: 0.1 * u(),
                    body_base_height_ratio: 2.0 * u(),
                };
                // the height counts twice as much as α; the other factors have no effect
                let ln = 2.0 * factors.body_height_m.ln()
                    + factors.slenderness_angle.ln()
                    + noise * random.normal();
                let fragility = Fragility::new(ln.exp(), 0.4).unwrap();
                TrainedDesign { factors, fragility }
            })
            .collect()
    }

    #[test]
    fn exact_order_where_nothing_is_left_to_chance() {
        let found = held_out(&designs(100, 0.0), 5).unwrap();
        assert!(found.score.kendall_tau > 0.995, "{found:?}");
        assert_eq!(found.score.worst_fifth_found, 1.0);
        assert!(
            found.equal_weights.kendall_tau < 0.7 && found.slenderness_angle.kendall_tau < 0.6,
            "{found:?}"
        );
        assert!(found.slenderness_angle.kendall_tau > 0.1);
    }

    #[test]
    fn holds_chance_alone_ranks_nothing() {
        // 200 designs of pure noise: the standard deviation of τ is √(2(2n+5)/(9n(n−1))) = .047
        let found = held_out(&designs(200, 40.0), 5).unwrap();
        assert!(found.score.kendall_tau.abs() < 3.0 * 0.048, "{found:?}");
        assert!(matches!(
            held_out(&designs(30, 0.0), 5),
            Err(AssessError::TooFewDesigns { given: 30, least: 50 })
        ));
    }

    /// Compares with models that were trained without the part of each design.
    #[test]
    fn agrees_with_models_trained_without_the_part() {
        use super::super::model::ScoreModel;
        let all = designs(60, 2.0);
        let mut predicted = vec![0.0; 60];
        for part in 0..5 {
            let others: Vec<TrainedDesign> = (0..60)
                .filter(|i| i % 5 != part)
                .map(|i| all[i].clone())
                .collect();
            let model = ScoreModel::train(&others, None).unwrap();
            for i in (0..60).filter(|i| i % 5 == part) {
                predicted[i] = model.score(&all[i].factors, true).unwrap().capacity_m_s2.ln();
            }
        }
        let simulated: Vec<f64> = all.iter().map(|one| one.fragility.theta().ln()).collect();
        let wanted = ranking(&predicted, &simulated).unwrap();
        let found = held_out(&all, 5).unwrap().score;
        assert!(
            (found.kendall_tau - wanted.kendall_tau).abs() < 1e-12,
            "{found:?} {wanted:?}"
        );
        assert_eq!(found.worst_fifth_found, wanted.worst_fifth_found);
    }
}
