//! Steps a linear state through a run.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | s | `state` | s′ = A s + B a | states |
//! | O | `outputs` | output matrix: x = O s | rows × states |
//! | a | `ground` | acceleration of the ground, linear within a step | 2 |

use dolmen_linalg::Matrix;
use pulp::Arch;

/// Acceleration of the ground at both ends of a step, along x and along y, m/s².
pub(crate) type Ground = [[f64; 2]; 2];

/// Number of steps that are multiplied together: the block stays in the cache. Our choice; a multiple of 4.
pub(super) const BLOCK: usize = 128;

/// A linear state with exact steps.
pub(crate) trait Stepping {
    /// O: displacements u, v, θ of the floors, strokes of the dampers.
    fn outputs(&self) -> &Matrix;
    fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground);
    /// r A: rate of the quantity r s, without the immediate contribution of the ground.
    fn rate_row(&self, row: &[f64]) -> Vec<f64>;
    /// r B: immediate contribution of the ground along x and along y to the rate of the quantity r s.
    fn ground_of_row(&self, row: &[f64]) -> [f64; 2];
}

/// Steps the state from rest and computes the outputs block by block. `outputs` is O transposed, states × rows; `see` receives the values
/// of a block (one column for each row of O), its first step and the number of steps. Returns the states at the beginnings of the blocks.
pub(super) fn walk(
    stepping: &impl Stepping,
    outputs: &Matrix,
    steps: usize,
    ground: &dyn Fn(usize) -> Ground,
    see: &mut dyn FnMut(&Matrix, usize, usize),
) -> Vec<Vec<f64>> {
    walk_on(Arch::new(), (stepping, outputs), steps, ground, see)
}

/// As the function above, with vector registers of a given width.
fn walk_on(
    arch: Arch,
    (stepping, outputs): (&impl Stepping, &Matrix),
    steps: usize,
    ground: &dyn Fn(usize) -> Ground,
    see: &mut dyn FnMut(&Matrix, usize, usize),
) -> Vec<Vec<f64>> {
    let count = outputs.rows();
    let mut block = Matrix::zeros(count, BLOCK);
    let mut values = Matrix::zeros(BLOCK, outputs.columns());
    let mut state = vec![0.0; count];
    let mut states = Vec::with_capacity(steps / BLOCK + 1);
    let mut done = 0;
    while done < steps {
        states.push(state.clone());
        let now = BLOCK.min(steps - done);
        // with the widest vector registers of the machine; the operations, and therefore the bits, are the same on every machine
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

/// The states at given steps, distinct and ascending, from those at the beginnings of blocks.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// s′ = A s + B a with as many states as A has rows.
    struct Plain {
        of_state: Vec<Vec<f64>>,
        outputs: Matrix,
    }

    impl Stepping for Plain {
        fn outputs(&self) -> &Matrix {
            &self.outputs
        }

        #[inline(always)]
        fn advance(&self, from: &[f64], to: &mut [f64], ground: Ground) {
            for (row, to) in self.of_state.iter().zip(to) {
                *to = ground[0][0] - 0.3 * ground[1][1];
                for (a, from) in row.iter().zip(from) {
                    *to += a * from;
                }
            }
        }

        fn rate_row(&self, row: &[f64]) -> Vec<f64> {
            row.to_vec()
        }

        fn ground_of_row(&self, _row: &[f64]) -> [f64; 2] {
            [0.0; 2]
        }
    }

    #[test]
    fn holds_a_walk_has_the_same_bits_on_any_vectors() {
        const STATES: usize = 13;
        let number = |i: usize, j: usize| ((7 * i + 11 * j) as f64).sin() / STATES as f64;
        let stepping = Plain {
            of_state: (0..STATES)
                .map(|i| (0..STATES).map(|j| number(i, j)).collect())
                .collect(),
            outputs: Matrix::zeros(1, 1),
        };
        let mut outputs = Matrix::zeros(STATES, 5);
        for (at, value) in outputs.as_mut_slice().iter_mut().enumerate() {
            *value = number(at, 3);
        }
        let ground = |step: usize| [[(0.1 * step as f64).sin(); 2]; 2];
        #[allow(unused_mut, reason = "other machines have one")]
        let mut archs = vec![Arch::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            archs.extend(pulp::x86::V3::try_new().map(Arch::V3));
            archs.extend(pulp::x86::V4::try_new().map(Arch::V4));
        }
        let walked: Vec<_> = archs
            .into_iter()
            .map(|arch| {
                let mut seen: Vec<f64> = Vec::new();
                let states = walk_on(
                    arch,
                    (&stepping, &outputs),
                    300,
                    &ground,
                    &mut |values, _, now| {
                        (0..5).for_each(|column| seen.extend(&values.column(column)[..now]));
                    },
                );
                (states, seen)
            })
            .collect();
        assert!(walked[0].1.len() == 1500 && walked[0].1.iter().any(|value| *value != 0.0));
        assert!(walked.iter().all(|other| *other == walked[0]));
    }
}
