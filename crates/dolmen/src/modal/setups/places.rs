//! Where the sensors of several setups stand, and which are one.

use super::pairing::same_place;
use crate::modal::ModalError;
use crate::signal::Channel;

/// The sensors of all setups so far.
pub(super) struct Places {
    pub(super) channels: Vec<Channel>,
    /// Setups that have each.
    seen: Vec<usize>,
}

/// Where a channel of a setup stands among all places, and whether it points the other way.
#[derive(Clone, Copy)]
pub(super) struct Seat {
    pub(super) place: usize,
    pub(super) sign: f64,
    /// Whether a setup before has it.
    pub(super) known: bool,
}

impl Places {
    pub(super) fn of(channels: &[Channel]) -> Self {
        Places {
            channels: channels.to_vec(),
            seen: vec![1; channels.len()],
        }
    }

    /// The places that so many setups have.
    pub(super) fn seen_by(&self, setups: usize) -> Vec<usize> {
        (0..self.seen.len()).filter(|&c| self.seen[c] >= setups).collect()
    }

    /// A place for each channel of a setup, new ones at the end.
    pub(super) fn seats(
        &mut self,
        channels: &[Channel],
        number: usize,
        within_m: f64,
    ) -> Result<Vec<Seat>, ModalError> {
        let before = self.channels.len();
        let mut taken = vec![false; before];
        let mut seats = Vec::with_capacity(channels.len());
        for channel in channels {
            let found = (0..before).find_map(|place| {
                let sign = same_place(&self.channels[place], channel, within_m).filter(|_| !taken[place])?;
                Some(Seat {
                    place,
                    sign,
                    known: true,
                })
            });
            let seat = match found {
                Some(seat) => {
                    taken[seat.place] = true;
                    self.seen[seat.place] += 1;
                    seat
                }
                None => {
                    self.channels.push(channel.clone());
                    self.seen.push(1);
                    Seat {
                        place: self.channels.len() - 1,
                        sign: 1.0,
                        known: false,
                    }
                }
            };
            seats.push(seat);
        }
        if seats.iter().any(|seat| seat.known) {
            Ok(seats)
        } else {
            Err(ModalError::NoReference { setup: number + 1 })
        }
    }
}
