//! Second poles of one mode in a record of free decays.

use crate::modal::indicators::assurance;
use crate::modal::{Mode, Modes};

/// Least likeness of the shapes of a mode and of its second pole. Our choice: the false poles of made records with one blow have 0.97 to 0.98.
const ALIKE: f64 = 0.9;

/// Removes second poles of the modes of decays: after a blow each mode is one exponential, so a pole with the shape of another mode is part of it
/// if no decay has a mode within a half-power band of its frequency.
///
/// # Limits
/// One channel has no shapes, so nothing is removed.
pub(crate) fn leave_out_copies(modes: &mut Modes, of_decays: &[Mode]) {
    if modes.channels.len() < 2 {
        return;
    }
    let is_in_decay = |mode: &Mode| {
        let is_here = |own: &Mode| {
            let band_hz = own.damping_ratio.unwrap_or(0.0) * own.frequency_hz;
            (mode.frequency_hz - own.frequency_hz).abs() <= band_hz
        };
        of_decays.iter().any(is_here)
    };
    let (shown, others): (Vec<Mode>, Vec<Mode>) = modes.modes.drain(..).partition(is_in_decay);
    let is_own = |mode: &Mode| shown.iter().all(|of| assurance(&of.shape, &mode.shape) < ALIKE);
    let own = others.into_iter().filter(is_own).collect::<Vec<Mode>>();
    modes.modes = shown;
    modes.modes.extend(own);
    modes
        .modes
        .sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Method;
    use crate::signal::Channel;

    fn mode(frequency_hz: f64, shape: [f64; 3]) -> Mode {
        Mode::made(frequency_hz, 0.011, &shape)
    }

    #[test]
    fn holds_a_second_pole_is_left_out_and_a_mode_of_its_own_is_not() {
        let third = mode(30.84, [0.69, -0.62, 1.0]);
        let found = vec![
            mode(1.85, [0.18, 0.53, 1.0]),
            mode(8.0, [0.3, 0.8, -1.0]), // a torsion that the blow did not excite
            mode(29.09, [0.77, -0.44, 1.0]),
            mode(30.95, [0.69, -0.62, 1.0]),
        ];
        let left = |channels: usize| {
            let mut modes = Modes {
                modes: found.clone(),
                channels: vec![Channel::named("a"); channels],
                method: Method::SsiCov,
                duration_s: 60.0,
                history: Vec::new(),
            };
            leave_out_copies(&mut modes, &[found[0].clone(), third.clone()]);
            let all: Vec<f64> = modes.modes.iter().map(|mode| mode.frequency_hz).collect();
            all
        };
        assert_eq!(left(3), [1.85, 8.0, 30.95]);
        assert_eq!(left(1), [1.85, 8.0, 29.09, 30.95]);
    }
}
