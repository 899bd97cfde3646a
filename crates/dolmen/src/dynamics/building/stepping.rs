//! A linear state walked through the steps of a run.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | s | `state` | s′ = A s + B a | states |
//! | O | `outputs` | what is wanted of it: x = O s | rows × states |
//! | a | `ground` | acceleration of the ground, straight within a step | 2 |

use dolmen_linalg::Matrix;
use pulp::Arch;

/// Acceleration of the ground at both ends of a step, along x and along y, m/s².
pub(crate) type Ground = [[f64; 2]; 2];

/// Steps that are multiplied together: the block stays in the cache. Our choice; a multiple of 4.
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

/// Steps the state from rest and turns it into what is wanted, block by block: `outputs` is O turned, states × rows, and `see` gets the
/// values of a block, a column a row of O, its first step and how many there are. The states at the beginnings of the blocks are given back.
pub(super) fn walk(
    stepping: &impl Stepping,
    outputs: &Matrix,
    steps: usize,
    ground: &dyn Fn(usize) -> Ground,
    see: &mut dyn FnMut(&Matrix, usize, usize),
) -> Vec<Vec<f64>> {
    let arch = Arch::new();
    let count = outputs.rows();
    let mut block = Matrix::zeros(count, BLOCK);
    let mut values = Matrix::zeros(BLOCK, outputs.columns());
    let mut state = vec![0.0; count];
    let mut states = Vec::with_capacity(steps / BLOCK + 1);
    let mut done = 0;
    while done < steps {
        states.push(state.clone());
        let now = BLOCK.min(steps - done);
        // in the widest vectors of the machine; the same operations, and so the same bits, on any
        arch.dispatch(
            #[inline(always)]
            || {
                for i in 0..now {
                    let (before, rest) = block.as_mut_slice().split_at_mut(i * count);
                    let from = if i == 0 {
                        &state[..]
                    } else {
                        &before[(i - 1) * count..]
                    };
                    stepping.advance(from, &mut rest[..count], ground(done + i));
                }
            },
        );
        state.copy_from_slice(block.column(now - 1));
        block.transpose_times_into(outputs, &mut values);
        see(&values, done + 1, now);
        done += now;
    }
    states
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
