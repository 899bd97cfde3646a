//! What a free decay contains besides modes: motion that does not decay, and overtones of a mode that is not linear.

use super::mode_decay::{ModeDecay, Overtone};
use crate::modal::{Mode, assurance};
use std::f64::consts::TAU;

/// Fewest cycles of a machine, and the largest logarithm of the fall of its amplitude over the record. Even a stone damped by 0.1 % falls by 0.3 in 50
/// cycles. Our choice.
const CYCLES_LEAST: f64 = 50.0;
const FALL_MOST: f64 = 0.2;
/// Number of standard deviations.
const DEVIATIONS: f64 = 2.0;
/// Multiples of the frequency at which a joint that softens in both directions alike moves too.
const MULTIPLES: [usize; 2] = [3, 5];
/// Least relative range of a frequency that depends on the amplitude, and its margin on either side. Our choice.
const RANGE_LEAST: f64 = 0.005;
const BESIDE: f64 = 0.01;
/// Least MAC of a mode and its overtone. Our choice.
const ALIKE: f64 = 0.9;

/// Whether the motion does not decay: its damping ratio is zero within two standard deviations, and its amplitude falls by less than a fifth over
/// 50 cycles or more.
///
/// ```text
/// |ζ| ≤ 2 sd,   2π N (|ζ| + 2 sd) < 0.2,   N ≥ 50 cycles
/// ```
pub(super) fn is_machine(mode: &Mode) -> bool {
    mode.damping_ratio
        .zip(mode.damping_ratio_sd)
        .is_some_and(|(zeta, sd)| {
            let most = zeta.abs() + DEVIATIONS * sd;
            let is_zero = zeta.abs() <= DEVIATIONS * sd;
            is_zero && mode.cycles >= CYCLES_LEAST && TAU * mode.cycles * most < FALL_MOST
        })
}

/// For each mode the stronger mode of which it may be an overtone.
pub(super) fn overtones(decays: &[ModeDecay], modes: &[Mode], energy: &[f64]) -> Vec<Option<Overtone>> {
    let ranges: Vec<Option<[f64; 2]>> = decays.iter().map(range_hz).collect();
    let of = |at: usize| {
        let mode = &modes[at];
        let stronger = (0..at).filter(|of| energy[*of] > energy[at]);
        let alike = stronger.filter(|of| assurance(&modes[*of].shape, &mode.shape) >= ALIKE);
        alike
            .filter_map(|of| {
                let [low_hz, high_hz] = ranges[of]?;
                let is_in = |times: &usize| {
                    let own_hz = mode.frequency_hz / *times as f64;
                    (low_hz * (1.0 - BESIDE)..=high_hz * (1.0 + BESIDE)).contains(&own_hz)
                };
                let times = MULTIPLES.into_iter().find(is_in)?;
                Some(Overtone {
                    of_hz: modes[of].frequency_hz,
                    times,
                })
            })
            .next()
    };
    (0..modes.len()).map(of).collect()
}

/// Least and largest frequency of a mode that depends on the amplitude, Hz.
fn range_hz(decay: &ModeDecay) -> Option<[f64; 2]> {
    let swings = decay.swings.iter().map(|of| of.frequency_hz);
    let all = swings.chain(decay.poles_hz.iter().copied());
    let [low, high] = all.fold([decay.frequency_hz; 2], |[low, high], hz| {
        [low.min(hz), high.max(hz)]
    });
    let is_bent = decay.poles_hz.len() > 1 || decay.damping_follows;
    (is_bent || high - low > RANGE_LEAST * decay.frequency_hz).then_some([low, high])
}

#[cfg(test)]
mod tests {
    use super::is_machine;
    use crate::modal::{Identify, Method, ModalAnalysis, Mode, identify};
    use crate::numeric::Random;
    use crate::signal::{Channel, Record};
    use std::f64::consts::{PI, TAU};

    fn found(channels: usize, samples: usize, y: impl Fn(usize, f64) -> f64) -> ModalAnalysis {
        let mut random = Random::new(7, 0);
        let mut of = |c: usize| {
            (0..samples)
                .map(|i| y(c, 0.01 * i as f64) + 1e-3 * random.normal())
                .collect()
        };
        let samples = (0..channels).map(&mut of).collect();
        let channels = (0..channels).map(|c| Channel::named(format!("c{c}"))).collect();
        let record = Record::new(channels, samples, 100.0).unwrap();
        let options = Identify {
            method: Method::Era,
            ..Identify::default()
        };
        identify(&record, &options).unwrap()
    }

    fn decay(frequency_hz: f64, zeta: f64, t: f64) -> f64 {
        let omega = TAU * frequency_hz;
        (-zeta * omega * t).exp() * (omega * t).cos()
    }

    #[test]
    fn exact_hum_does_not_decay_and_a_steel_wire_does() {
        let mode = |zeta: f64, sd: f64, cycles: f64| Mode {
            damping_ratio_sd: Some(sd),
            cycles,
            ..Mode::made(12.3, zeta, &[])
        };
        assert!(is_machine(&mode(5e-8, 3.4e-7, 492.0)));
        // damped by 0.02 %: its amplitude falls by 46 %
        assert!(!is_machine(&mode(2e-4, 1e-6, 492.0)));
        // by 0.002 %, which is 20 deviations
        assert!(!is_machine(&mode(2e-5, 1e-6, 492.0)));
        // not known well enough, or not observed long enough
        assert!(!is_machine(&mode(1e-4, 1e-4, 492.0)));
        assert!(!is_machine(&mode(1e-5, 1e-4, 30.0)));
    }

    #[test]
    fn holds_a_softening_joint_has_overtones_and_linear_modes_have_none() {
        // one degree of freedom whose stiffness falls by up to 10 % with its amplitude, by Runge and Kutta of second order
        let (omega, fine) = (TAU * 2.4, 16);
        let rate = |x: f64, v: f64| {
            let softened = 1.0 - 0.1 * x.abs() / (0.2 + x.abs());
            -omega * omega * x * softened - 2.0 * 0.018 * omega * v
        };
        let step = 0.01 / f64::from(fine);
        let (mut x, mut v, mut measured) = (1.0, 0.0, Vec::new());
        for k in 0..4000 * fine {
            let a = rate(x, v);
            if k % fine == 0 {
                measured.push(a / (omega * omega));
            }
            let (xm, vm) = (x + 0.5 * step * v, v + 0.5 * step * a);
            (x, v) = (x + step * vm, v + step * rate(xm, vm));
        }
        let soft = found(1, 4000, |_, t| measured[(100.0 * t).round() as usize])
            .decay
            .unwrap();
        let above = soft.modes.iter().filter(|of| of.frequency_hz > 5.0);
        let times: Vec<Option<usize>> = above.map(|of| of.overtone.map(|of| of.times)).collect();
        assert!(times.contains(&Some(3)), "{times:?} {soft:?}");
        assert!(times.iter().all(Option::is_some), "{times:?} {soft:?}");
        let linear = found(1, 4000, |_, t| {
            decay(2.4, 0.018, t) + 0.05 * decay(7.2, 0.01, t + 0.1 * PI)
        });
        let linear = linear.decay.unwrap();
        assert_eq!(linear.modes.len(), 2);
        assert!(linear.modes.iter().all(|of| of.overtone.is_none()), "{linear:?}");
    }
}
