//! Subjects of notes: tones, machines at modes, channels with a delayed clock.

use super::Kurtosis;

/// A peak of the spectrum caused by a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// Frequency of the peak, Hz.
    pub frequency_hz: f64,
    /// Width 3 dB below the top, Hz.
    pub width_hz: f64,
    /// Kurtosis of the amplitude; `None` if the record is too short.
    pub kurtosis: Option<Kurtosis>,
}

/// A machine that runs at the frequency of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToneOnMode {
    /// Frequency of the machine, Hz.
    pub frequency_hz: f64,
    /// The mode or peak at this frequency, Hz.
    pub mode_hz: f64,
    /// Power of the machine over that of the mode, –.
    pub strength: f64,
}

impl std::fmt::Display for ToneOnMode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ToneOnMode {
            frequency_hz,
            mode_hz,
            strength,
        } = self;
        write!(
            f,
            "{frequency_hz:.4} Hz ({strength:.2} of the power of the mode at {mode_hz:.3} Hz)"
        )
    }
}

impl std::fmt::Display for Tone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3} Hz (width {:.3} Hz", self.frequency_hz, self.width_hz)?;
        if let Some(k) = self.kurtosis {
            write!(f, ", {k}")?;
        }
        write!(f, ")")
    }
}

impl std::fmt::Display for Kurtosis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "kurtosis {:.2}", self.kurtosis)?;
        if self.share < 1.0 {
            let percent = 100.0 * self.share;
            write!(f, " in the {percent:.0} % of the record in which it runs")?;
        }
        Ok(())
    }
}

/// A channel whose clock has a constant delay.
#[derive(Clone, Debug, PartialEq)]
pub struct LateClock {
    /// Name of the channel.
    pub channel: String,
    /// Delay relative to the channels that agree with each other, s; negative if it is early.
    pub delay_s: f64,
    /// Standard deviation of the delay, s.
    pub sd_s: f64,
    /// The next larger delay that also explains the phases, s, if there is one.
    pub or_s: Option<f64>,
    /// Number of modes whose phases show the delay.
    pub modes: usize,
}

impl std::fmt::Display for LateClock {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let LateClock {
            channel, sd_s, modes, ..
        } = self;
        write!(
            f,
            "\"{channel}\" by {:+.4} ± {sd_s:.4} s, from {modes} modes",
            self.delay_s
        )?;
        match self.or_s {
            Some(or_s) => write!(f, " ({or_s:+.4} s would explain them too)"),
            None => Ok(()),
        }
    }
}

/// Quantity of the components of a mode shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeQuantity {
    /// Displacements.
    Displacement,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
}

impl ShapeQuantity {
    /// All quantities, in the order of differentiation.
    pub(crate) const ALL: [ShapeQuantity; 3] = [
        ShapeQuantity::Displacement,
        ShapeQuantity::Velocity,
        ShapeQuantity::Acceleration,
    ];

    /// Number of differentiations of the displacement.
    pub(crate) fn order(self) -> i32 {
        match self {
            ShapeQuantity::Displacement => 0,
            ShapeQuantity::Velocity => 1,
            ShapeQuantity::Acceleration => 2,
        }
    }
}

impl std::fmt::Display for ShapeQuantity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ShapeQuantity::Displacement => "displacement",
            ShapeQuantity::Velocity => "velocity",
            ShapeQuantity::Acceleration => "acceleration",
        })
    }
}

/// "1.234, 2.345".
pub(super) fn list(f: &mut std::fmt::Formatter<'_>, frequency_hz: &[f64]) -> std::fmt::Result {
    for (i, frequency_hz) in frequency_hz.iter().enumerate() {
        let comma = if i > 0 { ", " } else { "" };
        write!(f, "{comma}{frequency_hz:.3}")?;
    }
    Ok(())
}

/// The frequencies of modes, each with its damping ratio.
pub(super) fn frequencies(modes: &[[f64; 2]]) -> String {
    let each: Vec<String> = modes.iter().map(|[hz, _]| format!("{hz:.3}")).collect();
    each.join(", ")
}
