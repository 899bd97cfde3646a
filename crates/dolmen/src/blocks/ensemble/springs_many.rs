//! Simulates many stacks at once: one run per lane of the machine's vector registers. Each run gives the same bits as if it ran alone.
//!
//! All lanes share the steps of bodies and contacts. Patches and peaks are observed by the code for a single run; the state of the lane is first
//! written to its run. When a run ends, its lane takes the next run.

use super::super::error::BlocksError;
use super::super::history::StackHistory;
use super::batch::Batch;
use super::queue::{Queue, StackRun};
use pulp::{Arch, Simd, WithSimd};

/// Simulates many stacks. `each` receives the index of a run and its result, in the order in which runs end. The result equals that of
/// [`simulate_springs`](crate::blocks::simulate_springs) bit for bit. `progress` receives the index and the simulated time of a run at intervals, and
/// stops that run by returning false.
///
/// Runs of stacks with the same number of blocks are computed side by side, as many as the vector registers hold (8 with AVX-512, 4 with AVX2). Ties,
/// side supports, bonded joints and joints that crush are computed one run after another. Only active runs use memory. To use several threads, give each thread a part
/// of the runs: the results do not depend on the division.
///
/// # Example
/// ```
/// use dolmen::blocks::{Springs, StackRun, simulate_springs, simulate_springs_many};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let stone = |size| Ok::<_, Box<dyn std::error::Error>>(Block {
///     name: "stone".into(),
///     solid: Solid::cuboid(size, 0.2, 0.1)?,
///     density_kg_m3: 2600.0,
/// });
/// let options = Springs { duration_s: Some(0.1), ..Springs::default() };
/// let stacks = [0.2, 0.3, 0.4].map(|size| Stack::new(vec![stone(size)?], JointMaterial::default(), 9.81).map_err(Box::<dyn std::error::Error>::from));
/// let stacks = stacks.into_iter().collect::<Result<Vec<_>, _>>()?;
/// let runs: Vec<StackRun> = stacks.iter().map(|stack| StackRun { stack, motion: None, options: &options }).collect();
/// let mut same = 0;
/// simulate_springs_many(&runs, &mut |_, _| true, &mut |index, history| {
///     same += usize::from(history == simulate_springs(&stacks[index], None, &options, &mut |_| true));
/// });
/// assert_eq!(same, 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate_springs_many(
    runs: &[StackRun<'_>],
    progress: &mut dyn FnMut(usize, f64) -> bool,
    each: &mut dyn FnMut(usize, Result<StackHistory, BlocksError>),
) {
    simulate_on(Arch::new(), runs, progress, each);
}

/// As [`simulate_springs_many`], with the vector registers of a given machine.
fn simulate_on(
    arch: Arch,
    runs: &[StackRun<'_>],
    progress: &mut dyn FnMut(usize, f64) -> bool,
    each: &mut dyn FnMut(usize, Result<StackHistory, BlocksError>),
) {
    let mut sizes: Vec<usize> = runs.iter().map(|run| run.stack.blocks().len()).collect();
    sizes.sort_unstable();
    sizes.dedup();
    for size in sizes {
        let of_size = |(_, run): &(usize, StackRun<'_>)| run.stack.blocks().len() == size;
        let waiting = runs.iter().copied().enumerate().filter(of_size).collect();
        arch.dispatch(Queue {
            waiting,
            again: Vec::new(),
            settled: None,
            progress: &mut *progress,
            each: &mut *each,
        });
    }
}

impl WithSimd for Queue<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        if let Some(first) = self.next() {
            Batch::new(simd, first).drive(&mut self);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{AfterFall, ContactRule, Outcome, Springs, Start, simulate_springs};
    use crate::signal::{Component, GroundMotion};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

    fn archs() -> Vec<Arch> {
        #[allow(unused_mut, reason = "other machines have one")]
        let mut archs = vec![Arch::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            archs.extend(pulp::x86::V3::try_new().map(Arch::V3));
            archs.extend(pulp::x86::V4::try_new().map(Arch::V4));
        }
        archs
    }

    fn pile(sizes: &[[f64; 3]], friction: f64, turn: f64) -> Stack {
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, &[x, y, height])| {
            let place = Placement {
                position_m: [0.01 * i as f64, 0.0, z],
                yaw_rad: turn * i as f64,
                ..Placement::default()
            };
            z += height;
            Block {
                name: format!("stone {}", i + 1),
                solid: Solid::cuboid(x, y, height).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        let material = JointMaterial {
            friction_kinetic: 0.8 * friction,
            ..JointMaterial::with_friction(friction)
        };
        Stack::new(blocks.collect(), material, 9.81).unwrap()
    }

    fn shaking(peak_m_s2: f64, seed: f64) -> GroundMotion {
        let wave = |frequency: f64| -> Vec<f64> {
            let sample = |i: u32| {
                let t = 0.01 * f64::from(i);
                peak_m_s2 * (frequency * t).sin() * (0.7 * (seed + 1.3 * frequency) * t).cos()
            };
            (0..200).map(sample).collect()
        };
        let series = [(Component::X, 9.0), (Component::Y, 13.0), (Component::Z, 31.0)];
        let series = series.map(|(component, frequency)| (component, wave(frequency)));
        GroundMotion::new("waves", 0.01, series.to_vec()).unwrap()
    }

    #[test]
    fn holds_each_run_has_the_bits_it_has_alone_on_any_vectors() {
        let stacks = [
            pile(&[[0.5, 0.4, 0.3], [0.3, 0.3, 0.5]], 0.6, 0.0),
            pile(&[[0.5, 0.4, 0.3], [0.6, 0.5, 0.1], [0.2, 0.2, 0.6]], 0.5, 0.3),
            pile(&[[0.4, 0.4, 0.3], [0.4, 0.4, 0.3], [0.4, 0.4, 0.3]], 0.15, 0.1),
        ];
        let options = [
            Springs {
                rest_s: 0.5,
                ..Springs::default()
            },
            Springs {
                contact_rule: ContactRule::Corners,
                after_fall: AfterFall::Continue,
                rest_s: 0.2,
                output_step_s: 0.03,
                starts: vec![Start {
                    spin_rad_s: [0.0, 0.0, 2.0],
                    velocity_m_s: [0.1, 0.0, 0.3],
                    ..Start::of(1)
                }],
                ..Springs::default()
            },
        ];
        let motions: Vec<GroundMotion> = (0..7_u8)
            .map(|i| shaking(1.0 + 1.5 * f64::from(i), 0.37 * f64::from(i)))
            .collect();
        let mut runs = Vec::new();
        for stack in &stacks {
            for options in &options {
                for motion in &motions {
                    runs.push(StackRun {
                        stack,
                        motion: Some(motion),
                        options,
                    });
                }
            }
        }
        let alone: Vec<_> = runs
            .iter()
            .map(|run| simulate_springs(run.stack, run.motion, run.options, &mut |_| true))
            .collect();
        let count = |wanted: fn(&Outcome) -> bool| {
            alone
                .iter()
                .filter(|h| h.as_ref().is_ok_and(|h| wanted(&h.outcome)))
                .count()
        };
        assert!(count(|o| matches!(o, Outcome::Fell { .. })) > 3);
        assert!(count(|o| matches!(o, Outcome::Uplifted { .. })) > 3);
        for arch in archs() {
            let mut seen = vec![false; runs.len()];
            simulate_on(arch, &runs, &mut |_, _| true, &mut |index, history| {
                assert!(!std::mem::replace(&mut seen[index], true), "{index} came twice");
                if history != alone[index] {
                    let (a, b) = (history.as_ref().unwrap(), alone[index].as_ref().unwrap());
                    let first = a.poses.iter().zip(&b.poses).position(|(a, b)| a != b);
                    panic!(
                        "{arch:?} {index}: {:?} {:?} from pose {first:?}",
                        a.outcome, b.outcome
                    );
                }
            });
            assert!(seen.iter().all(|seen| *seen));
        }
    }

    #[test]
    fn holds_what_cannot_run_says_so_and_the_rest_runs() {
        let good = pile(&[[0.5, 0.4, 0.3], [0.3, 0.3, 0.5]], 0.6, 0.0);
        let short = Springs {
            duration_s: Some(0.05),
            ..Springs::default()
        };
        let wrong = Springs {
            time_step_s: Some(1.0),
            ..short.clone()
        };
        let run = |options| StackRun {
            stack: &good,
            motion: None,
            options,
        };
        let mut results = Vec::new();
        let runs = [run(&wrong), run(&short), run(&wrong), run(&short)];
        simulate_springs_many(&runs, &mut |_, _| true, &mut |index, result| {
            results.push((index, result.is_ok()));
        });
        results.sort_unstable();
        assert_eq!(results, [(0, false), (1, true), (2, false), (3, true)]);
    }

    #[test]
    fn holds_a_run_that_is_stopped_says_so_and_the_others_go_on() {
        let stack = pile(&[[0.5, 0.4, 0.3], [0.3, 0.3, 0.5]], 0.6, 0.0);
        let options = Springs {
            duration_s: Some(0.05),
            ..Springs::default()
        };
        let run = StackRun {
            stack: &stack,
            motion: None,
            options: &options,
        };
        let mut outcomes = vec![None; 20];
        let mut progress = |index, time_s| index != 3 || time_s < 0.02;
        simulate_springs_many(&[run; 20], &mut progress, &mut |index, result| {
            outcomes[index] = Some(result.unwrap().outcome);
        });
        for (index, outcome) in outcomes.iter().enumerate() {
            match (index, outcome) {
                (3, Some(Outcome::Stopped { at_s })) => assert!((0.02..0.03).contains(at_s)),
                (_, Some(Outcome::Stood)) if index != 3 => {}
                (_, other) => panic!("{index}: {other:?}"),
            }
        }
    }
}
