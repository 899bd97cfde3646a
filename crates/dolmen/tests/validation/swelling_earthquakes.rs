//! Distant earthquakes, which grow over seconds, distinguished from lorries, gusts and storms.
//!
//! SOURCE      envelopes: Saragoni & Hart (1974) Earthquake Eng. Struct. Dyn. 2:249-267; Jennings, Housner & Tsai (1968); colour of the ground: Kanai-Tajimi
//! GOAL        None with a sufficient level is missed; the number of trains and gusts classified as earthquakes does not grow
//! PARAMETERS  two storeys of 2.5 and 6.5 Hz above a ground whose shaking grows for 3 to 15 s, to 60 to 150 times the noise of the ground
//! PUBLISHED   nothing
//! TOLERANCE   counts by binomial chance

use dolmen::modal::{Identify, Losses, MadeEarthquake, earthquake_in, strong_motion};
use dolmen::numeric::Random;
use dolmen::signal::{Channel, Quantity, Record};

fn log_between(random: &mut Random, low: f64, high: f64) -> f64 {
    low * (high / low).powf(random.uniform())
}

/// Noise filtered by an oscillator of the ground with damping ratios of 0.3 to 0.6.
fn coloured(random: &mut Random, samples: usize) -> Vec<f64> {
    let (hz, zeta) = (log_between(random, 0.8, 5.0), 0.3 + 0.3 * random.uniform());
    let (w, h) = (std::f64::consts::TAU * hz, 1e-3);
    let (mut x, mut v) = (0.0, 0.0);
    let mut ground = Vec::with_capacity(samples);
    for i in 0..samples * 10 {
        let white = random.normal();
        v += h * (white - 2.0 * zeta * w * v - w * w * x);
        x += h * v;
        if i % 10 == 0 {
            ground.push(w * w * x + 2.0 * zeta * w * v);
        }
    }
    ground
}

/// The envelope of a distant earthquake at this time after its arrival.
fn envelope(kind: u64, [rise_s, plateau_s, fall_s]: [f64; 3], t: f64) -> f64 {
    match kind % 2 {
        0 => {
            // a power times an exponential, with its peak at the rise, falling to 5 % at the end
            let end_s = rise_s + plateau_s + 3.0 * fall_s;
            let u = end_s / rise_s;
            let b = 0.05_f64.ln() / (1.0 + u.ln() - u);
            (t / rise_s * (1.0 - t / rise_s).exp()).powf(b)
        }
        _ => match t {
            t if t < rise_s => (t / rise_s).powi(2),
            t if t < rise_s + plateau_s => 1.0,
            t => (-(t - rise_s - plateau_s) / fall_s).exp(),
        },
    }
}

fn swelling(seed: u64, [low, high]: [f64; 2]) -> MadeEarthquake {
    let random = &mut Random::new(seed, 78);
    let rise_s = log_between(random, 3.0, 15.0);
    let shape = [
        rise_s,
        log_between(random, 2.0, 20.0),
        log_between(random, 4.0, 20.0),
    ];
    let noise_m_s2 = log_between(random, 3e-4, 3e-3);
    let over = log_between(random, low, high);
    let ground = coloured(random, 14_000);
    let ground_m_s2 = ground.iter().enumerate();
    let ground_m_s2 = ground_m_s2
        .map(|(i, x)| x * envelope(seed, shape, i as f64 / 100.0))
        .collect();
    let made = MadeEarthquake {
        seed,
        duration_s: 240.0,
        arrival_s: 70.0,
        noise_m_s2,
        ground_m_s2,
        softened: [0.9, 1.0],
        ..MadeEarthquake::default()
    };
    let still = MadeEarthquake {
        peak_m_s2: 0.0,
        ..made.clone()
    };
    let still = still.make().unwrap();
    let noise =
        |c: usize| (still.samples(c).iter().map(|x| x * x).sum::<f64>() / still.length() as f64).sqrt();
    // the ground has the smallest ratio of peak to noise
    MadeEarthquake {
        peak_m_s2: over * noise(0),
        ..made
    }
}

/// A train near a structure: it grows within seconds and passes; all channels move together at 8 to 30 Hz.
fn train(seed: u64) -> Record {
    let random = &mut Random::new(seed, 79);
    let shape = [
        log_between(random, 2.0, 8.0),
        log_between(random, 5.0, 25.0),
        log_between(random, 1.0, 3.0),
    ];
    let (low_hz, peak) = (log_between(random, 8.0, 18.0), log_between(random, 0.02, 0.2));
    let tones: Vec<[f64; 2]> = (0..60)
        .map(|_| {
            [
                low_hz * (1.0 + 0.8 * random.uniform()),
                std::f64::consts::TAU * random.uniform(),
            ]
        })
        .collect();
    let made = MadeEarthquake {
        seed,
        duration_s: 240.0,
        noise_m_s2: log_between(random, 3e-4, 1.5e-3),
        peak_m_s2: 0.0,
        ..MadeEarthquake::default()
    };
    let still = made.make().unwrap();
    let of = |t: f64| {
        let at = t - 80.0;
        let sum: f64 = tones
            .iter()
            .map(|[hz, phase]| (std::f64::consts::TAU * hz * t + phase).sin())
            .sum();
        if at < 0.0 {
            0.0
        } else {
            peak * sum / 18.0 * envelope(1, shape, at)
        }
    };
    let shares = [0.6, 0.8, 1.0].map(|share: f64| share * (0.8 + 0.4 * random.uniform()));
    let samples = (0..3).map(|c| {
        let each = still.samples(c).iter().enumerate();
        each.map(|(i, x)| x + shares[c] * of(i as f64 / 100.0)).collect()
    });
    Record::new(still.channels().to_vec(), samples.collect(), 100.0).unwrap()
}

/// A gust on a tower with all sensors on it: coloured forces on both floors grow within 3 to 20 s to 3 to 30 times the previous wind.
fn gust(seed: u64) -> Record {
    let random = &mut Random::new(seed, 80);
    let shape = [
        log_between(random, 3.0, 20.0),
        log_between(random, 2.0, 30.0),
        log_between(random, 3.0, 20.0),
    ];
    let (over, scale) = (log_between(random, 3.0, 30.0), log_between(random, 3e-3, 3e-2));
    let rate_hz = 400.0;
    let steps = (240.0 * rate_hz) as usize;
    let zeta = log_between(random, 0.005, 0.03);
    let first_hz = log_between(random, 0.8, 4.0);
    let modes = [
        [first_hz, 0.45, 1.0],
        [first_hz * (2.6 + random.uniform()), 1.0, -0.5],
    ];
    let mut samples = vec![vec![0.0; steps / 4]; 2];
    for [hz, low, high] in modes {
        let (w, h) = (std::f64::consts::TAU * hz, 1.0 / rate_hz);
        let (mut x, mut v, mut wind) = (0.0, 0.0, 0.0);
        let mut own = vec![0.0; steps / 4];
        for step in 0..steps {
            let at = step as f64 / rate_hz - 80.0;
            let strength = 1.0
                + if at < 0.0 {
                    0.0
                } else {
                    over * envelope(1, shape, at)
                };
            wind += h * std::f64::consts::TAU * 0.3 * (random.normal() - wind);
            let a = strength * wind - 2.0 * zeta * w * v - w * w * x;
            v += h * a;
            x += h * v;
            if step % 4 == 0 {
                own[step / 4] = a;
            }
        }
        let square = own[..6000].iter().map(|x| x * x).sum::<f64>() / 6000.0;
        let share = if hz > first_hz { 0.3 } else { 1.0 } * scale / square.sqrt();
        for (c, part) in [low, high].into_iter().enumerate() {
            for (sum, x) in samples[c].iter_mut().zip(&own) {
                *sum += part * share * x;
            }
        }
    }
    for x in samples.iter_mut().flatten() {
        *x += 0.05 * scale * random.normal();
    }
    let channels = ["low", "high"].map(|name| Channel {
        quantity: Quantity::Acceleration,
        ..Channel::named(name)
    });
    Record::new(channels.to_vec(), samples, 100.0).unwrap()
}

/// Number of these seeds with a detected earthquake.
fn taken(seeds: std::ops::Range<u64>, made: impl Fn(u64) -> Record) -> usize {
    seeds
        .filter(|seed| earthquake_in(&made(*seed), &[]).is_some())
        .count()
}

/// Number of these seeds with a certain earthquake, once the modes at rest are known.
fn sure(seeds: std::ops::Range<u64>, made: impl Fn(u64) -> Record) -> usize {
    let found = |seed: u64| strong_motion(&made(seed), &Identify::default(), &Losses::default());
    seeds
        .filter(|seed| found(*seed).is_some_and(|of| of.is_sure()))
        .count()
}

/// The record without the sensor on the ground.
fn above(record: &Record) -> Record {
    let samples = (1..3).map(|c| record.samples(c).to_vec());
    Record::new(
        record.channels()[1..].to_vec(),
        samples.collect(),
        record.sampling_rate_hz(),
    )
    .unwrap()
}

#[test]
fn holds_hardly_any_swelling_earthquake_is_missed() {
    const RUNS: u64 = 60; // seeds 0 to 199 chose the bounds; these did not
    let found = taken(2000..2000 + RUNS, |seed| {
        swelling(seed, [60.0, 150.0]).make().unwrap()
    });
    assert!(found + 2 >= RUNS as usize, "{found}");
}

#[test]
fn holds_sensors_that_all_stand_on_the_structure_see_that_the_ground_carries_it() {
    const RUNS: u64 = 20;
    let whole = |seed: u64| swelling(seed, [60.0, 150.0]).make().unwrap();
    let found = taken(2000..2000 + RUNS, |seed| above(&whole(seed)));
    let beyond_doubt = sure(2000..2000 + RUNS, |seed| above(&whole(seed)));
    assert!(
        beyond_doubt + 1 >= found && found + 6 >= RUNS as usize,
        "{beyond_doubt} of {found}"
    );
}

#[test]
fn regress_how_many_trains_and_gusts_are_taken_for_one() {
    const RUNS: u64 = 40;
    let found = [sure(1000..1000 + RUNS, train), sure(1000..1000 + RUNS, gust)];
    assert!(found[0] == 0 && found[1] <= 1, "{found:?}");
}
