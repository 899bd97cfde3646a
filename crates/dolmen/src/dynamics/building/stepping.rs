//! A linear state walked through the steps of a run.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | s | `state` | s′ = A s + B a | states |
//! | O | `outputs` | what is wanted of it: x = O s | rows × states |
//! | a | `ground` | acceleration of the ground, straight within a step | 2 |

use super::history::Ground;
use dolmen_linalg::Matrix;

/// Steps that are multiplied together: the block stays in the cache. Our choice.
pub(super) const BLOCK: usize = 128;

/// A state that is stepped exactly.
pub(crate) trait Stepping {
    /// O: displacements u, v, θ of the floors, strokes of the dampers.
    fn outputs(&self) -> &Matrix;
    /// The state after a step.
    fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground);
    /// r A: the row that gives the rate of what r gives, but for what the ground adds at once.
    fn rate_row(&self, row: &[f64]) -> Vec<f64>;
    /// r B: what the ground along x and along y adds at once to the rate of what r gives.
    fn ground_of_row(&self, row: &[f64]) -> [f64; 2];
}

/// What was walked through.
pub(super) struct Walked {
    /// The first rows of O s: a column for each step, the first at rest.
    pub(super) values: Matrix,
    /// The other rows of O s, each in time.
    pub(super) others: Vec<Vec<f64>>,
    /// The state at the beginning of each block.
    pub(super) states: Vec<Vec<f64>>,
}

/// Steps the state from rest and turns it into what is wanted, block by block: the first `own` rows of `outputs`, and the others.
pub(super) fn walk(
    stepping: &impl Stepping,
    (outputs, own): (&Matrix, usize),
    steps: usize,
    ground: &dyn Fn(usize) -> Ground,
) -> Walked {
    let (rows, count) = (outputs.rows(), outputs.columns());
    let mut values = Matrix::zeros(own, steps + 1);
    let mut others: Vec<Vec<f64>> = (own..rows).map(|_| Vec::with_capacity(steps + 1)).collect();
    others.iter_mut().for_each(|other| other.push(0.0));
    let mut block = Matrix::zeros(count, BLOCK);
    let mut state = vec![0.0; count];
    let mut states = Vec::with_capacity(steps / BLOCK + 1);
    let mut done = 0;
    while done < steps {
        states.push(state.clone());
        let now = BLOCK.min(steps - done);
        for i in 0..now {
            let (before, rest) = block.as_mut_slice().split_at_mut(i * count);
            let from = if i == 0 {
                &state[..]
            } else {
                &before[(i - 1) * count..]
            };
            stepping.advance(from, &mut rest[..count], ground(done + i));
        }
        state.copy_from_slice(block.column(now - 1));
        let moved = outputs * &block;
        for (i, column) in moved.as_slice().chunks_exact(rows).take(now).enumerate() {
            values.column_mut(done + 1 + i).copy_from_slice(&column[..own]);
            for (other, value) in others.iter_mut().zip(&column[own..]) {
                other.push(*value);
            }
        }
        done += now;
    }
    Walked {
        values,
        others,
        states,
    }
}

/// The states at given steps, ascending and each once, from those at the beginnings of blocks.
pub(super) fn states_at(
    stepping: &impl Stepping,
    states: &[Vec<f64>],
    steps: &[usize],
    ground: &dyn Fn(usize) -> Ground,
) -> Vec<Vec<f64>> {
    let mut found = Vec::with_capacity(steps.len());
    let (mut at, mut state) = (0, states.first().cloned().unwrap_or_default());
    let mut next = state.clone();
    for &step in steps {
        let block = (step / BLOCK).min(states.len().saturating_sub(1));
        if block * BLOCK > at {
            (at, state) = (block * BLOCK, states[block].clone());
        }
        while at < step {
            stepping.advance(&state, &mut next, ground(at));
            std::mem::swap(&mut state, &mut next);
            at += 1;
        }
        found.push(state.clone());
    }
    found
}
