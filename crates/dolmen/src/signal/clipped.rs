//! Shares of samples at which clipped channels stay at the ends of their range.

use super::faults::ChannelFault;

/// A channel that stays at an end of its range for a part of the record.
#[derive(Clone, Debug, PartialEq)]
pub struct ClippedChannel {
    /// Name of the channel.
    pub channel: String,
    /// Share of the samples at each end of the range, 0 to 1; the second is 0 if it is clipped at one end only.
    pub shares: [f64; 2],
}

/// The clipped channels among the faults of a record with this number of samples.
pub fn clipped_channels(faults: &[ChannelFault], length: usize) -> Vec<ClippedChannel> {
    let mut all: Vec<ClippedChannel> = Vec::new();
    for fault in faults {
        let ChannelFault::Clipped { channel, samples, .. } = fault else {
            continue;
        };
        let share = *samples as f64 / length as f64;
        match all.iter_mut().find(|of| of.channel == *channel) {
            Some(of) => of.shares[1] = share,
            None => all.push(ClippedChannel {
                channel: channel.clone(),
                shares: [share, 0.0],
            }),
        }
    }
    all
}
