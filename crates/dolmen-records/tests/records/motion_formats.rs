// SOURCE     tests/data/motions: El Centro 1940 NS, its first 240 samples in millionths of g, written by ObsPy 1.5.1 in each encoding
//            (bench/formats/make.py). tests/data/peers.csv: what ObsPy 1.5.1 and gmprocess 2.8.0 read from measured files.
// GOAL       Dolmen identifies every format of motions from its content and reads it to the bit; damaged files are refused.
// TOLERANCE  none for integers; the last bits of a sum of doubles otherwise.

use super::motion_networks::{KNET, cosmos, csmip, esm, knet, tiny, written_cosmos};
use dolmen::signal::{Component, Processing};
use dolmen_records::motions::{
    ComponentReading, MotionError, MotionFormat, MotionOptions, Orientation, SeismicError, read_channels,
    read_component, read_motion, read_oriented,
};
use dolmen_records::records::Unit;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/motions")
}

pub(super) fn written(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap()
}

/// Numbers kept as the file prints them.
fn as_printed() -> MotionOptions {
    MotionOptions {
        unit: Some(Unit::MetrePerSecondSquared),
        plausible_peak_m_s2: 0.0..=f64::MAX,
        ..Default::default()
    }
}

pub(super) fn said(bytes: &[u8], options: &MotionOptions) -> String {
    read_channels(bytes, options).unwrap_err().to_string()
}

/// The first 240 samples of El Centro 1940 NS in millionths of g.
pub(super) fn millionths() -> Vec<f64> {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let g = text
        .lines()
        .skip(1)
        .take(240)
        .map(|line| line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    g.map(|g| (g * 1e6).round_ties_even()).collect()
}

#[test]
fn agrees_with_obspy_in_every_encoding() {
    let wanted = millionths();
    for name in [
        "steim1_big.mseed",
        "steim1_little.mseed",
        "steim2_big.mseed",
        "steim2_little.mseed",
        "int32_big.mseed",
        "int32_little.mseed",
        "float32_big.mseed",
        "float32_little.mseed",
        "float64_big.mseed",
        "float64_little.mseed",
        "big.sac",
        "little.sac",
        "text.sac",
    ] {
        let read = read_component(&written(name), &as_printed()).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(read.acceleration_m_s2, wanted, "{name}");
        assert_eq!(
            (read.time_step_s, read.orientation),
            (0.02, Some(Orientation::Horizontal { azimuth_deg: 0.0 })),
            "{name}"
        );
        // 19 May 1940 04:36:41.25 UTC, by Python's datetime
        assert!(
            (read.begins_s.unwrap() + 934_744_998.75).abs() < 1e-4,
            "{name}: {:?}",
            read.begins_s
        );
        assert_eq!(
            read.name,
            if name.ends_with("mseed") {
                "US.ELC..HNN"
            } else {
                "US.ELC.HNN"
            }
        );
    }
    let short = read_component(&written("int16_big.mseed"), &as_printed()).unwrap();
    let thousandths: Vec<f64> = wanted.iter().map(|a| (a / 1e3).round_ties_even()).collect();
    assert_eq!(short.acceleration_m_s2, thousandths);
}

#[test]
fn exact_counts_become_accelerations_by_a_factor() {
    let told = MotionOptions {
        unit: Some(Unit::Gravity),
        factor: 1e-6,
        ..Default::default()
    };
    let motion = read_motion(
        "El Centro",
        &[(Component::X, &written("steim2_big.mseed"))],
        &told,
    )
    .unwrap();
    assert!((motion.component_peak_m_s2(Component::X) / 9.80665 - 0.31882).abs() < 1e-12);
    assert!(motion.history().contains(&Processing::Scaled { factor: 1e-6 }));
    let refused = said(&written("steim2_big.mseed"), &MotionOptions::default());
    assert!(
        refused.starts_with("the unit of the accelerations is not known"),
        "{refused}"
    );
    let counts = MotionOptions {
        unit: Some(Unit::Gravity),
        ..Default::default()
    };
    assert!(said(&written("steim2_big.mseed"), &counts).starts_with("the peak is 3.188e5 g"));
}

#[test]
fn exact_channels_are_named_and_turned() {
    let bytes = written("two_channels.mseed");
    let refused = read_component(&bytes, &as_printed()).unwrap_err().to_string();
    let named = "the file has 2 channels (US.ELC..HNN, US.ELC..HNE): say which is which by name or number, columns = {";
    assert!(refused.starts_with(named), "{refused}");
    for name in ["us.elc..hne", "2"] {
        let named = MotionOptions {
            channel: Some(name.to_owned()),
            ..as_printed()
        };
        assert_eq!(read_component(&bytes, &named).unwrap().name, "US.ELC..HNE");
    }
    let north = millionths();
    let east: Vec<f64> = north.iter().map(|a| (-a / 2.0).floor()).collect(); // as numpy divides
    let motion = read_oriented("", &[&bytes], 90.0, &as_printed()).unwrap();
    assert_eq!(motion.acceleration_m_s2(Component::X), east);
    assert_eq!(motion.acceleration_m_s2(Component::Y), north);
    let turned = read_oriented("", &[&bytes], 30.0, &as_printed()).unwrap();
    let (sin, cos) = 30f64.to_radians().sin_cos();
    for (i, (x, y)) in turned
        .acceleration_m_s2(Component::X)
        .iter()
        .zip(turned.acceleration_m_s2(Component::Y))
        .enumerate()
    {
        assert!(
            (x - (north[i] * cos + east[i] * sin)).abs() < 1e-9
                && (y - (north[i] * sin - east[i] * cos)).abs() < 1e-9
        );
    }
    let refused = read_oriented("", &[&written("little.sac")], 0.0, &as_printed())
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("there are 1 horizontal and 0 vertical channels"),
        "{refused}"
    );
    let twice = read_oriented(
        "",
        &[&written("little.sac"), &written("big.sac")],
        0.0,
        &as_printed(),
    )
    .unwrap_err();
    assert!(
        twice
            .to_string()
            .contains("point to 0° and 0°, less than 30° apart")
    );
}

#[test]
fn refuses_what_was_cut_at_any_byte() {
    let texts = [
        knet("E-W", "0.046", KNET),
        cosmos("cm/sec2(04)", "340"),
        csmip(1),
        csmip(2),
        esm("cm/s^2"),
    ];
    let mut files: Vec<(String, Vec<u8>)> = texts
        .into_iter()
        .map(|text| ("text".to_owned(), text.into_bytes()))
        .collect();
    for file in std::fs::read_dir(folder()).unwrap() {
        let path = file.unwrap().path();
        files.push((path.display().to_string(), std::fs::read(path).unwrap()));
    }
    let told = as_printed();
    for (name, whole) in files {
        let options = match name.as_str() {
            "text" => tiny(),
            name if name.ends_with("v1c") => written_cosmos(),
            _ => told.clone(),
        };
        let all = read_channels(&whole, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
        let step = (whole.len() / 700).max(1);
        for length in (0..whole.len()).step_by(step) {
            match read_channels(&whole[..length], &options) {
                Err(_) => {}
                // the remaining part is valid on its own: complete records, complete channels, the last line end, velocities after it
                Ok(part) => assert!(
                    is_beginning(&part, &all),
                    "{name} cut at {length} of {}",
                    whole.len()
                ),
            }
        }
    }
}

/// Whether each channel of `part` is the whole of one of `all`, or its beginning in entire miniSEED records.
fn is_beginning(part: &[ComponentReading], all: &[ComponentReading]) -> bool {
    part.iter().zip(all).all(|(part, all)| {
        let (short, long) = (&part.acceleration_m_s2, &all.acceleration_m_s2);
        let equal = short.len() == long.len() || part.format == MotionFormat::MiniSeed;
        equal && long.starts_with(&short[..short.len() - 1])
    })
}

#[test]
fn refuses_damaged_miniseed_and_sac() {
    let whole = written("steim2_big.mseed");
    let mut damaged = whole.clone();
    damaged[100] ^= 1; // one difference
    assert!(said(&damaged, &as_printed()).contains("the last sample unpacked is not the one"));
    let mut gap = whole.clone();
    gap[512 + 26] += 1; // the second record one second later
    let refused = said(&gap, &as_printed());
    assert!(refused.contains("there is a gap or an overlap"), "{refused}");
    let mut coded = whole.clone();
    coded[52] = 30;
    assert!(matches!(
        read_channels(&coded, &as_printed()),
        Err(MotionError::Seismic(SeismicError::Encoding { encoding: 30, .. }))
    ));
    let sac = written("little.sac");
    assert!(
        said(&sac[..900], &as_printed()).starts_with("the sac file has 900 bytes, but its header says 1592")
    );
    let mut uneven = sac.clone();
    uneven[4 * 105] = 0;
    assert!(said(&uneven, &as_printed()).contains("LEVEN must be 1"));
    let mut velocity = sac.clone();
    velocity[4 * 86] = 7;
    velocity[4 * 86 + 1..4 * 87].fill(0);
    assert!(said(&velocity, &as_printed()).contains("the file holds velocities"));
}

// Measured files of other packages, which scripts/data --formats downloads (scripts/test does so if they are missing): this
// repository may not redistribute them. Without them the test would compare nothing, so it fails.
#[test]
fn agrees_with_obspy_and_gmprocess_on_measured_files() {
    let cache = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cache/formats");
    let mut compared = 0;
    let mut before = String::new();
    let mut channel = 0;
    for line in include_str!("../data/peers.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        channel = if cells[0] == before { channel + 1 } else { 0 };
        before = cells[0].to_owned();
        let bytes = std::fs::read(cache.join(cells[0]))
            .unwrap_or_else(|_| panic!("{} is not there: run scripts/data --formats first", cells[0]));
        let is_text = cells[0].ends_with(".v1") || cells[0].ends_with(".RAW") || cells[0].ends_with(".knet");
        let options = if is_text { tiny() } else { as_printed() };
        let read = read_channels(&bytes, &options).unwrap_or_else(|e| panic!("{}: {e}", cells[0]));
        holds_numbers(&read[channel], &cells);
        compared += 1;
    }
    assert_eq!(compared, 38);
}

fn holds_numbers(read: &ComponentReading, cells: &[&str]) {
    let number = |at: usize| cells[at].parse::<f64>().unwrap();
    let n = number(3);
    // K-NET: ObsPy gives the counts, 2000 gal / 8388608 each, with their mean; CSMIP: gmprocess gives cm/s²
    let (scale, mean) = match read.format {
        MotionFormat::KNet => (20.0 / 8388608.0, number(7) / n),
        MotionFormat::Csmip => (0.01, 0.0),
        _ => (1.0, 0.0),
    };
    let a = &read.acceleration_m_s2;
    assert_eq!(a.len() as f64, n, "{cells:?}");
    assert!(
        (1.0 / read.time_step_s / number(4) - 1.0).abs() < 1e-6,
        "{cells:?}: {}",
        read.time_step_s
    );
    let peak = a.iter().fold(0.0, |peak, a| f64::max(peak, a.abs()));
    // ObsPy reads SAC text as 32-bit numbers, Dolmen with all printed digits
    let within = if read.format == MotionFormat::SacText {
        1e-7
    } else {
        1e-9
    } * peak;
    let near = |got: f64, wanted: f64| {
        assert!(
            (got - scale * wanted).abs() <= within,
            "{cells:?}: {got} {}",
            scale * wanted
        );
    };
    near(a[0], number(5) - mean);
    near(a[a.len() - 1], number(6) - mean);
    near(a.iter().sum::<f64>() / n, number(7) / n - mean);
    if read.format != MotionFormat::KNet {
        near(peak, number(8));
    }
    if read.format == MotionFormat::Csmip && matches!(read.orientation, Some(Orientation::Horizontal { .. }))
    {
        assert_eq!(
            read.orientation,
            Some(Orientation::Horizontal {
                azimuth_deg: number(2).rem_euclid(360.0)
            })
        );
    }
}
