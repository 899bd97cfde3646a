// SOURCE     none but arithmetic: a simulated record with known poles, and the same record without some samples.
// GOAL       Single lost samples that are filled in change the identified values far less than their standard deviations.
// PARAMETERS four floors, pairs 2 % apart, 8 channels × 10 min × 100 Hz, noise 20 dB below; 30 samples lost at random in all channels.
// TOLERANCE  0.01 of the stated standard deviation for half of the 48 frequencies, 0.2 for all but two.

use dolmen::modal::{Identify, ReferenceCase, identify};
use dolmen::numeric::Random;
use dolmen::signal::{Record, fill_lost};

#[test]
fn holds_thirty_single_lost_samples_change_no_frequency() {
    let mut off = Vec::new();
    for seed in 100..106 {
        let whole = ReferenceCase::ClosePairs.made(seed).unwrap().make().unwrap();
        let mut random = Random::new(seed, 1);
        let n = whole.length();
        let mut at: Vec<usize> = (0..30)
            .map(|_| 1 + (random.uniform() * (n - 2) as f64) as usize)
            .collect();
        at.sort_unstable();
        at.dedup();
        let lost: Vec<_> = at.iter().map(|&at| at..at + 1).collect();
        let channels: Vec<Vec<f64>> = (0..whole.channels().len())
            .map(|channel| {
                let mut samples = whole.samples(channel).to_vec();
                at.iter().for_each(|&at| samples[at] = f64::NAN);
                fill_lost(&mut samples, &lost).unwrap();
                samples
            })
            .collect();
        let rate_hz = whole.sampling_rate_hz();
        let filled = Record::new(whole.channels().to_vec(), channels, rate_hz).unwrap();
        let [before, after] =
            [&whole, &filled].map(|record| identify(record, &Identify::default()).unwrap().modes.modes);
        assert_eq!(before.len(), after.len());
        off.extend(before.iter().zip(&after).map(|(before, after)| {
            (after.frequency_hz - before.frequency_hz).abs() / before.frequency_sd_hz.unwrap()
        }));
    }
    off.sort_by(f64::total_cmp);
    // one pole more or less in a cluster changes a weak mode by some tenths; noise of 0.3 % has the same effect on one of these
    let beyond = off.iter().filter(|off| **off > 0.2).count();
    assert!(off[off.len() / 2] < 0.01 && beyond <= 2, "{off:.3?}");
}
