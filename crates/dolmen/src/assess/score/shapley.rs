//! Shapley value: the fair contribution of each of a few players to a common result.

/// Largest number of players: every coalition is evaluated once.
const PLAYERS_MOST: usize = 16;

/// Shapley share of each player in the difference between the value of all players and the value of none.
///
/// ```text
/// φ_i = Σ over S without i of |S|! (n − |S| − 1)!/n! · (v(S ∪ i) − v(S))        S as a bit mask; Σ φ_i = v(all) − v(none)
/// ```
///
/// Unlike Sobol's shares of variance, these shares add up, and they are meaningful for dependent players.
///
/// # Limits
/// 2ⁿ values of the coalitions; for more than 16 players nothing is computed, and the result is empty.
///
/// # Source
/// Shapley, L. S. (1953) A value for n-person games. Contributions to the Theory of Games II, 307–317; of variance: Owen, A. B. (2014)
/// SIAM/ASA J. Uncertain. Quantif. 2(1):245–251.
///
/// # Example
/// ```
/// use dolmen::assess::shapley_shares;
/// // one left glove and two right gloves: only a pair has a value
/// let worth = |who: u32| f64::from(u8::from(who & 1 != 0 && who & 6 != 0));
/// let shares = shapley_shares(3, worth);
/// assert!((shares[0] - 2.0 / 3.0).abs() < 1e-15 && (shares[1] - 1.0 / 6.0).abs() < 1e-15);
/// ```
pub fn shapley_shares(players: usize, mut value: impl FnMut(u32) -> f64) -> Vec<f64> {
    if players > PLAYERS_MOST {
        return Vec::new();
    }
    let worth: Vec<f64> = (0..1_u32 << players).map(&mut value).collect();
    let mut weights = vec![1.0 / players.max(1) as f64]; // |S|! (n − |S| − 1)!/n!
    for size in 1..players {
        let before = weights[size - 1];
        weights.push(before * size as f64 / (players - size) as f64);
    }
    let mut shares = vec![0.0; players];
    for (player, share) in shares.iter_mut().enumerate() {
        let bit = 1_usize << player;
        for (coalition, without) in worth.iter().enumerate() {
            if coalition & bit == 0 {
                let weight = weights[coalition.count_ones() as usize];
                *share += weight * (worth[coalition | bit] - without);
            }
        }
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean over all orders, directly from the definition.
    fn over_all_orders(players: usize, worth: &dyn Fn(u32) -> f64) -> Vec<f64> {
        fn orders(rest: &[usize]) -> Vec<Vec<usize>> {
            if rest.is_empty() {
                return vec![Vec::new()];
            }
            let mut all = Vec::new();
            for first in rest {
                let others: Vec<usize> = rest.iter().copied().filter(|other| other != first).collect();
                for mut order in orders(&others) {
                    order.insert(0, *first);
                    all.push(order);
                }
            }
            all
        }
        let all = orders(&(0..players).collect::<Vec<_>>());
        let mut shares = vec![0.0; players];
        for order in &all {
            let mut who = 0;
            for &player in order {
                shares[player] += worth(who | 1 << player) - worth(who);
                who |= 1 << player;
            }
        }
        shares.iter().map(|share| share / all.len() as f64).collect()
    }

    #[test]
    fn exact_shares_are_the_mean_over_all_orders() {
        let worth = |who: u32| (f64::from(who) * 0.7).sin() + f64::from(who.count_ones()).powi(2);
        let (found, exact) = (shapley_shares(5, worth), over_all_orders(5, &worth));
        for (found, exact) in found.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
        let sum: f64 = found.iter().sum();
        assert!((sum - (worth(31) - worth(0))).abs() < 1e-12);
        assert!(shapley_shares(17, |_| 0.0).is_empty() && shapley_shares(0, |_| 1.0).is_empty());
    }
}
