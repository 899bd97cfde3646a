//! Places of the sensors of several setups; sensors at a common place are recognised.

use super::pairing::same_place;
use crate::modal::ModalError;
use crate::signal::Channel;

/// The sensors of all setups so far.
pub(super) struct SensorPlaces {
    pub(super) channels: Vec<Channel>,
    /// Number of setups with each sensor.
    seen: Vec<usize>,
}

/// Index of a channel's place among all places, and whether the channel has the opposite direction.
#[derive(Clone, Copy)]
pub(super) struct ChannelPlace {
    pub(super) place: usize,
    pub(super) sign: f64,
    /// Whether an earlier setup has this place.
    pub(super) known: bool,
}

impl SensorPlaces {
    pub(super) fn of(channels: &[Channel]) -> Self {
        SensorPlaces {
            channels: channels.to_vec(),
            seen: vec![1; channels.len()],
        }
    }

    /// The places that at least this number of setups have.
    pub(super) fn seen_by(&self, setups: usize) -> Vec<usize> {
        (0..self.seen.len()).filter(|&c| self.seen[c] >= setups).collect()
    }

    /// The place of each channel of a setup; new places are added at the end.
    pub(super) fn channel_places(
        &mut self,
        channels: &[Channel],
        number: usize,
        within_m: f64,
    ) -> Result<Vec<ChannelPlace>, ModalError> {
        let before = self.channels.len();
        let mut taken = vec![false; before];
        let mut channel_places = Vec::with_capacity(channels.len());
        for channel in channels {
            let found = (0..before).find_map(|place| {
                let sign = same_place(&self.channels[place], channel, within_m).filter(|_| !taken[place])?;
                Some(ChannelPlace {
                    place,
                    sign,
                    known: true,
                })
            });
            let channel_place = match found {
                Some(channel_place) => {
                    taken[channel_place.place] = true;
                    self.seen[channel_place.place] += 1;
                    channel_place
                }
                None => {
                    self.channels.push(channel.clone());
                    self.seen.push(1);
                    ChannelPlace {
                        place: self.channels.len() - 1,
                        sign: 1.0,
                        known: false,
                    }
                }
            };
            channel_places.push(channel_place);
        }
        if channel_places.iter().any(|channel_place| channel_place.known) {
            Ok(channel_places)
        } else {
            Err(ModalError::NoReference { setup: number + 1 })
        }
    }
}
