//! The assignment problem: pairs of rows and columns with the smallest total cost.

use super::NumericError;

/// For each row, a column of its own, such that the sum of the costs is smallest. `cost` holds rows of equal length, with at least as
/// many columns as rows.
///
/// ```text
/// minimise Σ_i cost(i, c(i)) over all c: rows → columns with c(i) ≠ c(j)        cost: rows × columns
/// ```
/// Each row is added along the path of smallest reduced cost (Dijkstra), which keeps all reduced costs at 0 or above: rows² × columns
/// operations.
///
/// # Errors
/// [`NumericError::NotFinite`] for a cost that is not finite; [`NumericError::Count`] for rows of different lengths, or more rows than
/// columns.
///
/// # Source
/// Kuhn (1955) Nav. Res. Logist. Q. 2:83-97; shortest augmenting paths after Jonker & Volgenant (1987) Computing 38:325-340, without
/// their heuristics for the first rows.
///
/// # Example
/// ```
/// use dolmen::numeric::assignment;
/// // the nearest column of the first row is the only good one for the second row
/// assert_eq!(assignment(&[vec![1.0, 2.0], vec![1.0, 9.0]])?, [1, 0]);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn assignment(cost: &[Vec<f64>]) -> Result<Vec<usize>, NumericError> {
    let columns = check(cost)?;
    let mut row_potential = vec![0.0; cost.len()];
    let mut column_potential = vec![0.0; columns];
    let mut row_of: Vec<Option<usize>> = vec![None; columns];
    for start in 0..cost.len() {
        let mut distance = vec![f64::INFINITY; columns];
        let mut before: Vec<Option<usize>> = vec![None; columns];
        let mut reached = vec![false; columns];
        let (mut row, mut last) = (start, None);
        let free = loop {
            let (mut next, mut step) = (0, f64::INFINITY);
            for (j, c) in cost[row].iter().enumerate().filter(|(j, _)| !reached[*j]) {
                let reduced = c - row_potential[row] - column_potential[j];
                if reduced < distance[j] {
                    (distance[j], before[j]) = (reduced, last);
                }
                if distance[j] < step {
                    (next, step) = (j, distance[j]);
                }
            }
            row_potential[start] += step;
            for j in 0..columns {
                match row_of[j] {
                    Some(other) if reached[j] => {
                        row_potential[other] += step;
                        column_potential[j] -= step;
                    }
                    _ => distance[j] -= step,
                }
            }
            reached[next] = true;
            match row_of[next] {
                None => break next,
                Some(other) => (row, last) = (other, Some(next)),
            }
        };
        let mut column = free;
        while let Some(other) = before[column] {
            row_of[column] = row_of[other];
            column = other;
        }
        row_of[column] = Some(start);
    }
    let mut found = vec![0; cost.len()];
    for (column, row) in row_of.iter().enumerate() {
        if let Some(row) = row {
            found[*row] = column;
        }
    }
    Ok(found)
}

/// Checks a cost matrix and returns its number of columns.
fn check(cost: &[Vec<f64>]) -> Result<usize, NumericError> {
    let columns = cost.first().map_or(0, Vec::len);
    let count = |quantity, given: usize, least: usize, most: usize| NumericError::Count {
        quantity,
        given: given as u64,
        least: least as u64,
        most: most as u64,
    };
    if cost.len() > columns {
        return Err(count("rows of cost", cost.len(), 0, columns));
    }
    for row in cost {
        if row.len() != columns {
            return Err(count("columns of a row of cost", row.len(), columns, columns));
        }
        if let Some(at) = row.iter().position(|c| !c.is_finite()) {
            return Err(NumericError::NotFinite {
                quantity: "a row of cost",
                number: at + 1,
                given: row[at],
            });
        }
    }
    Ok(columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// The smallest total over all assignments.
    fn by_trying_all(cost: &[Vec<f64>], taken: &mut Vec<usize>) -> f64 {
        let Some(row) = cost.get(taken.len()) else {
            return 0.0;
        };
        let mut least = f64::INFINITY;
        for (column, own) in row.iter().enumerate() {
            if !taken.contains(&column) {
                taken.push(column);
                least = least.min(own + by_trying_all(cost, taken));
                taken.pop();
            }
        }
        least
    }

    #[test]
    fn agrees_with_trying_all_permutations() {
        let mut random = Random::new(7, 0);
        for trial in 0..300 {
            let (rows, columns) = (1 + trial % 6, 1 + trial % 6 + trial % 3);
            // integers give many equal costs
            let draw = |random: &mut Random| match trial % 2 {
                0 => random.normal(),
                _ => (2.0 * random.normal()).round(),
            };
            let cost: Vec<Vec<f64>> = (0..rows)
                .map(|_| (0..columns).map(|_| draw(&mut random)).collect())
                .collect();
            let found = assignment(&cost).unwrap();
            let total: f64 = found.iter().zip(&cost).map(|(j, row)| row[*j]).sum();
            let least = by_trying_all(&cost, &mut Vec::new());
            assert!((total - least).abs() < 1e-12, "{cost:?}: {total}, least {least}");
            let mut distinct = found.clone();
            distinct.sort_unstable();
            distinct.dedup();
            assert_eq!(distinct.len(), rows, "{found:?}");
        }
    }

    #[test]
    fn agrees_with_scipy_linear_sum_assignment() {
        // scipy 1.17.1, linear_sum_assignment of cost(i, j) = (7 i + 3 j² + i j) mod 13, 8 × 9
        let cost: Vec<Vec<f64>> = (0..8)
            .map(|i| {
                (0..9)
                    .map(|j| f64::from((7 * i + 3 * j * j + i * j) % 13))
                    .collect()
            })
            .collect();
        let found = assignment(&cost).unwrap();
        let total: f64 = found.iter().zip(&cost).map(|(j, row)| row[*j]).sum();
        assert_eq!(total, SCIPY_TOTAL);
    }

    const SCIPY_TOTAL: f64 = 16.0;

    #[test]
    fn refuses_what_has_no_assignment() {
        let message = assignment(&[vec![1.0], vec![2.0]]).unwrap_err().to_string();
        assert_eq!(message, "rows of cost is 2, but must be between 0 and 1");
        let message = assignment(&[vec![1.0, f64::NAN]]).unwrap_err().to_string();
        assert_eq!(
            message,
            "value 2 of a row of cost is NaN, but must be a finite number"
        );
        assert!(assignment(&[vec![1.0, 2.0], vec![2.0]]).is_err());
        assert_eq!(assignment(&[]), Ok(Vec::new()));
    }
}
