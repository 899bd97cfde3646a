// SOURCE     Files of tests/data/records: the same 96 numbers of two channels, written by pyuff 2.5.8, scipy 1.17.1, h5py 3.16.0, wave of Python,
//            ObsPy 1.5.1 and npTDMS 1.13.0 (bench/formats/records.py); a SAF file that hvsrpy 2.1.0 reads as we do.
// GOAL       Every format gives those numbers, with names, rates, units and starts; truncated or changed files are refused.
// TOLERANCE  none if the file contains integers or doubles; otherwise the file's own rounding, as stated for each.

use super::korean_logs::said_of;
use dolmen::signal::{Channel, Quantity};
use dolmen_records::records::{
    Column, Layout, LostSamples, Pick, Reading, RecordFormat, RecordOptions, Unit, read_record,
};
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/records")
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap()
}

/// The two channels as integers.
fn written() -> [Vec<f64>; 2] {
    let text = String::from_utf8(bytes("samples.csv")).unwrap();
    let column = |at: usize| -> Vec<f64> {
        let cells = text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap());
        cells.map(|cell| cell.parse().unwrap()).collect()
    };
    [column(0), column(1)]
}

fn read(name: &str, options: &RecordOptions) -> Reading {
    read_record(&bytes(name), options).unwrap_or_else(|why| panic!("{name}: {why}"))
}

fn refusal(bytes: &[u8], options: &RecordOptions) -> String {
    read_record(bytes, options).unwrap_err().to_string()
}

/// Samples are those written times `factor`, within `share` of the largest.
fn holds(name: &str, reading: &Reading, factor: f64, share: f64) {
    for (j, expected) in written().iter().enumerate() {
        let most = expected.iter().fold(0.0f64, |m, x| m.max(x.abs())) * factor.abs();
        let found = reading.record.samples(j);
        assert_eq!(found.len(), expected.len(), "{name}");
        for (x, y) in found.iter().zip(expected) {
            assert!(
                (x - y * factor).abs() <= share * most,
                "{name}: {x} is not {}",
                y * factor
            );
        }
    }
}

fn scaled(scale: f64) -> RecordOptions {
    RecordOptions {
        scale: Some(scale),
        ..Default::default()
    }
}

#[test]
fn agrees_uff_of_pyuff() {
    // accelerations of a thousandth of the numbers in mm/s2; E13.5 prints 6 digits, single precision has 7
    for (name, share) in [
        ("text_single.uff", 2e-6),
        ("text_double.uff", 1e-11),
        ("binary_double.uff", 1e-15),
        ("binary_single_big.uff", 1e-7),
    ] {
        let reading = read(name, &RecordOptions::default());
        holds(name, &reading, 1e-6, share);
        let channels = reading.record.channels();
        assert_eq!(reading.record.sampling_rate_hz(), 200.0);
        assert_eq!(
            (channels[0].name.as_str(), channels[1].name.as_str()),
            ("3+X", "7-Y")
        );
        assert_eq!(channels[0].position_m, Some([0.0, 0.25, 3.0]), "{name}");
        assert_eq!(channels[1].position_m, Some([1.5, 0.0, 6.0]));
        assert_eq!(channels[1].direction, Some([0.0, -1.0, 0.0]));
        assert_eq!(channels[1].quantity, Quantity::Acceleration);
        assert_eq!(said_of(&reading), ["title \"gate\""]);
    }
}

#[test]
fn agrees_wav_of_scipy_and_of_python() {
    for name in [
        "int16.wav",
        "int24.wav",
        "int32.wav",
        "float32.wav",
        "float64.wav",
    ] {
        // full scale is 32768 of the numbers
        let options = RecordOptions {
            unit: Unit::MilliGravity,
            ..scaled(32.768)
        };
        let reading = read(name, &options);
        holds(name, &reading, 9.80665e-6, 1e-15);
        assert_eq!(
            (reading.record.sampling_rate_hz(), reading.begins_s),
            (200.0, None)
        );
    }
    assert_eq!(
        refusal(&bytes("int16.wav"), &RecordOptions::default()),
        "the numbers of a WAV file are parts of full scale: give scale = what full scale is in the unit (scale = 1 without a unit \
         keeps them as parts)"
    );
}

#[test]
fn agrees_mat_of_scipy() {
    for name in ["plain.mat", "compressed.mat"] {
        let reading = read(name, &RecordOptions::default());
        holds(name, &reading, 1e-3, 1e-15);
        assert_eq!(reading.record.channels()[1].name, "acc(:,2)");
        assert_eq!(reading.record.sampling_rate_hz(), 200.0);
        assert_eq!(
            said_of(&reading),
            ["variables not read: note (text), other"],
            "{name}"
        );
    }
    let reading = read("vectors.mat", &RecordOptions::default());
    holds("vectors.mat", &reading, 1.0, 0.0);
    assert_eq!(reading.record.channels()[0].name, "roof");
    assert_eq!(reading.record.sampling_rate_hz(), 200.0);
    let wide = RecordOptions {
        sampling_rate_hz: Some(200.0),
        ..Default::default()
    };
    let reading = read("wide.mat", &wide);
    holds("wide.mat", &reading, 1e-3, 1e-7); // single precision
    assert_eq!(reading.record.channels()[1].name, "data(2,:)");
    assert_eq!(
        refusal(&bytes("wide.mat"), &RecordOptions::default()),
        "the sampling rate is not known: the mat file does not say it; give sampling_rate"
    );
    let other = RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    };
    assert_eq!(
        refusal(&bytes("plain.mat"), &other),
        "sampling_rate is 100, but the file says 200: correct it, or leave it out"
    );
}

#[test]
fn agrees_mat_7_3_of_h5py() {
    for name in ["hdf5_plain.mat", "hdf5_packed.mat"] {
        let reading = read(name, &RecordOptions::default());
        holds(name, &reading, 1e-3, 1e-15);
        assert_eq!(reading.record.channels()[1].name, "acc(:,2)");
        assert_eq!(reading.record.sampling_rate_hz(), 200.0);
        assert_eq!(
            said_of(&reading),
            [
                "variables not read: gate (struct or object), none (empty), note (text or cell), wave (complex or struct), \
                 other"
            ],
            "{name}"
        );
    }
    // headers and links of HDF5 1.8, chunks beyond the matrix, integers of 16 and 32 bits
    let reading = read("hdf5_newer.mat", &RecordOptions::default());
    let mut names: Vec<&str> = reading
        .record
        .channels()
        .iter()
        .map(|c| c.name.as_str())
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["floor", "roof"]);
    let options = RecordOptions {
        picks: ["roof", "floor"]
            .map(|name| Pick {
                column: Column::Named(name.to_owned()),
                channel: Channel::named(name),
                scale: None,
            })
            .to_vec(),
        ..Default::default()
    };
    holds("hdf5_newer.mat", &read("hdf5_newer.mat", &options), 1.0, 0.0);
    let wide = RecordOptions {
        sampling_rate_hz: Some(200.0),
        ..Default::default()
    };
    // single precision, big end first, channels along the rows
    let reading = read("hdf5_big.mat", &wide);
    holds("hdf5_big.mat", &reading, 1e-3, 1e-7);
    assert_eq!(reading.record.channels()[1].name, "data(2,:)");
    assert!(refusal(&bytes("hdf5_other.mat"), &wide).starts_with(
        "the mat file holds an HDF5 layout that MATLAB does not write, which is not read: save it again"
    ));
    let mut empty = b"MATLAB 7.3 MAT-file, Platform: GLNXA64".to_vec();
    empty.resize(600, b' ');
    let fault = refusal(&empty, &wide);
    assert!(
        fault.contains("there is no HDF5 behind MATLAB's header"),
        "{fault}"
    );
}

#[test]
fn agrees_gcf_of_obspy() {
    let a = &written()[0];
    for (name, value) in [
        (
            "int8.gcf",
            &(|x: f64| (x / 2000.0).floor()) as &dyn Fn(f64) -> f64,
        ),
        ("int16.gcf", &|x| x),
        ("int32.gcf", &|x| 4000.0 * x),
    ] {
        let reading = read(name, &RecordOptions::default());
        let expected: Vec<f64> = a.iter().map(|x| value(*x)).collect();
        assert_eq!(reading.record.samples(0), expected, "{name}");
        assert_eq!(reading.record.channels()[0].name, "AB12Z2");
        // 2024-06-05T10:00:00 by datetime.timestamp of Python, UTC
        assert_eq!(
            (reading.record.sampling_rate_hz(), reading.begins_s),
            (100.0, Some(1_717_581_600.0))
        );
    }
    let fast = read("fast.gcf", &RecordOptions::default());
    assert_eq!(
        (fast.record.sampling_rate_hz(), fast.begins_s),
        (1000.0, Some(1_717_581_600.25))
    );
    assert_eq!(said_of(&fast), ["begins 2024-06-05 10:00:00.250 UTC"]);
    let unit = RecordOptions {
        unit: Unit::MetrePerSecond,
        ..Default::default()
    };
    assert_eq!(
        refusal(&bytes("int16.gcf"), &unit),
        "channel \"AB12Z2\": unit is \"m/s\", but the gcf file says that its numbers are in \"counts\": give scale = what one of them \
         is worth in m/s (1 if they are in m/s already), or leave unit out"
    );
    let mut changed = bytes("int16.gcf");
    changed[40] ^= 1; // a difference: the last sample reveals it
    assert!(
        refusal(
            &changed,
            &RecordOptions {
                format: Some(RecordFormat::Gcf),
                ..Default::default()
            }
        )
        .contains("states")
    );
}

/// The second record of three begins a second late.
#[test]
fn exact_longest_span_of_a_miniseed_file_with_a_gap() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/motions/steim2_big.mseed");
    let whole = std::fs::read(path).unwrap();
    let all = read_record(&whole, &RecordOptions::default()).unwrap().record;
    let mut gap = whole.clone();
    gap[512 + 26] += 1;
    gap[1024 + 26] += 1;
    let read = read_record(&gap, &RecordOptions::default()).unwrap().record;
    let samples = |block: usize| {
        usize::from(u16::from_be_bytes([
            whole[block * 512 + 30],
            whole[block * 512 + 31],
        ]))
    };
    let (first, rest) = (samples(0), samples(1) + samples(2));
    assert_eq!(first + rest, all.length());
    let used = if rest > first {
        first..all.length()
    } else {
        0..first
    };
    assert_eq!(read.samples(0), &all.samples(0)[used]);
    let said = read.history()[1].to_string();
    assert!(said.starts_with("samples are lost: 1.000 s after "), "{said}");
}

#[test]
fn exact_gcf_blocks_follow_one_another() {
    let block = bytes("fast.gcf");
    let mut later = block.clone();
    // 96 samples at 1000 Hz do not last one second: the second block begins too late
    later[8..12].copy_from_slice(&(u32::from_be_bytes(block[8..12].try_into().unwrap()) + 1).to_be_bytes());
    let refused = refusal(&[block.clone(), later].concat(), &RecordOptions::default());
    assert_eq!(
        refused,
        "channel AB12Z0: a block begins 1 s after the first, but the samples before it end at 0.096 s: there is a gap or an \
         overlap; cut the file there"
    );
    // one that begins a quarter of a second later leaves a gap of 0.154 s: the longest whole span is the first block, or the record is refused
    let mut early = block.clone();
    early[14] &= 7;
    let broken = [early, block.clone()].concat();
    let reading = read_record(&broken, &RecordOptions::default()).unwrap();
    assert_eq!(
        (reading.record.length(), reading.begins_s),
        (96, Some(1_717_581_600.0))
    );
    assert_eq!(
        reading.record.history()[1].to_string(),
        "samples are lost: 0.154 s after 0.095 s (AB12Z0); only the longest whole span is used, 0.000 to 0.095 s: 0.095 of 0.345 s"
    );
    let whole = RecordOptions {
        lost_samples: LostSamples::Refuse,
        ..Default::default()
    };
    assert!(refusal(&broken, &whole).contains("there is a gap or an overlap"));
    let mut other = block.clone();
    other[7] = other[7].wrapping_add(1); // another stream, a quarter of a second earlier
    other[14] &= 7;
    let both = read_record(&[block, other].concat(), &RecordOptions::default());
    assert!(
        both.unwrap_err()
            .to_string()
            .contains("they have no time in common")
    );
}

#[test]
fn agrees_tdms_of_nptdms() {
    let reading = read("two_segments.tdms", &RecordOptions::default());
    let [a, b] = written();
    let found: Vec<f64> = a.iter().map(|x| x * 1e-3 * 1e-3 * 9.80665).collect();
    for (x, y) in reading.record.samples(0).iter().zip(&found) {
        assert!((x - y).abs() < 1e-15);
    }
    assert_eq!(reading.record.samples(1), b);
    let channels = reading.record.channels();
    assert_eq!(
        (channels[0].quantity, channels[1].quantity),
        (Quantity::Acceleration, Quantity::Unknown)
    );
    assert_eq!((channels[0].name.as_str(), channels[1].name.as_str()), ("a", "b"));
    assert_eq!(
        (reading.record.sampling_rate_hz(), reading.begins_s),
        (200.0, Some(1_717_581_600.25))
    );
    assert_eq!(
        reading.record.history()[0].to_string(),
        "read from tdms, unit mg and not given"
    );
    // without the scale of the sensor, a voltage is not an acceleration
    let pick = |scale| RecordOptions {
        unit: Unit::MetrePerSecondSquared,
        picks: vec![Pick {
            column: Column::Named("b".into()),
            channel: Channel::named("roof"),
            scale,
        }],
        ..Default::default()
    };
    assert!(
        refusal(&bytes("two_segments.tdms"), &pick(None))
            .contains("that its numbers are in \"V\": give scale")
    );
    let roof = read("two_segments.tdms", &pick(Some(0.5)));
    assert_eq!(roof.record.samples(0)[5], 0.5 * b[5]);
    let milli = RecordOptions {
        unit: Unit::Gravity,
        ..Default::default()
    };
    assert_eq!(
        refusal(&bytes("two_segments.tdms"), &milli),
        "channel \"a\": unit is \"g\", but the file says \"mg\": correct it, or leave it out"
    );
}

#[test]
fn agrees_saf_with_hvsrpy() {
    let reading = read("three.saf", &RecordOptions::default());
    let [a, b] = written();
    assert_eq!(
        (reading.record.samples(0), reading.record.samples(1)),
        (&a[..], &b[..])
    );
    let names: Vec<&str> = reading
        .record
        .channels()
        .iter()
        .map(|c| c.name.as_str())
        .collect();
    assert_eq!(names, ["V", "N", "E"]);
    assert_eq!(
        (reading.record.sampling_rate_hz(), reading.begins_s),
        (200.0, Some(1_717_581_600.25))
    );
    assert_eq!(
        said_of(&reading),
        [
            "begins 2024-06-05 10:00:00.250 by its clock (time zone not said)",
            "station GATE"
        ]
    );
    let text = String::from_utf8(bytes("three.saf")).unwrap();
    assert_eq!(
        refusal(
            text.replace("NDAT = 96", "NDAT = 97").as_bytes(),
            &RecordOptions::default()
        ),
        "the header of the saf file says 97 samples, but 96 follow: it was cut or edited; copy it again"
    );
    assert_eq!(
        refusal(
            text.replace("CH2_ID", "CH3_ID").as_bytes(),
            &RecordOptions::default()
        ),
        "line 9: \"E\" is not the next channel: CH0_ID, CH1_ID, … in order: the saf file was cut or edited; copy it again"
    );
}

#[test]
fn exact_seismic_files_are_records_too() {
    let motions = folder().join("../motions");
    let sac = std::fs::read(motions.join("little.sac")).unwrap();
    let counts = std::fs::read(motions.join("two_channels.mseed")).unwrap();
    let reading = read_record(&sac, &RecordOptions::default()).unwrap();
    assert_eq!(
        (reading.record.length(), reading.record.sampling_rate_hz()),
        (240, 50.0)
    );
    let Layout::Channels(layout) = &reading.layout else {
        panic!()
    };
    assert_eq!(layout.format, RecordFormat::Sac);
    let reading = read_record(&counts, &RecordOptions::default()).unwrap();
    assert_eq!(reading.record.channels().len(), 2);
    let unit = RecordOptions {
        unit: Unit::MetrePerSecond,
        ..Default::default()
    };
    assert!(refusal(&counts, &unit).contains("that its numbers are in \"counts\""));
    let csv = RecordOptions {
        format: Some(RecordFormat::Csv),
        ..Default::default()
    };
    assert!(
        refusal(&counts, &csv)
            .starts_with("the file is not of the format csv: it begins like a miniseed file; correct format")
    );
    // IDEP = 7, velocities: an acceleration would be a mistake
    let mut velocities = sac.clone();
    velocities[4 * 86..4 * 87].copy_from_slice(&7i32.to_le_bytes());
    let wrong = RecordOptions {
        unit: Unit::Gal,
        ..Default::default()
    };
    assert!(refusal(&velocities, &wrong).contains("the file says \"velocities\""));
    assert!(read_record(&velocities, &unit).is_ok());
}

#[test]
fn refuses_a_ramp_and_looks_twice_at_texts() {
    let saf = "SESAME ASCII data format (saf) v. 1\nSAMP_FREQ = 10\nCH0_ID = T\nCH1_ID = V\n####\n0.1 5\n0.2 -3\n0.3 4\n";
    let said = refusal(saf.as_bytes(), &RecordOptions::default());
    assert!(
        said.starts_with("column \"T\" rises by 0.1 from each line to the next, as time stamps"),
        "{said}"
    );
    // numbers of one column, the first −1: no universal file
    let rate = RecordOptions {
        sampling_rate_hz: Some(10.0),
        ..Default::default()
    };
    let reading = read_record(b"-1\n5\n3\n", &rate).unwrap();
    assert_eq!(reading.record.samples(0), [-1.0, 5.0, 3.0]);
}

/// Every file of the folder except the table.
fn files() -> Vec<(String, Vec<u8>)> {
    let listed = std::fs::read_dir(folder()).unwrap();
    let mut names: Vec<String> = listed
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect();
    // files that are refused as a whole have nothing to compare
    names.retain(|name| !name.ends_with(".csv") && name != "hdf5_other.mat");
    names.sort();
    names
        .into_iter()
        .map(|name| (name.clone(), bytes(&name)))
        .collect()
}

fn options_for(name: &str) -> RecordOptions {
    let ending = name.rsplit('.').next().unwrap();
    RecordOptions {
        format: RecordFormat::of_ending(ending),
        sampling_rate_hz: ending.eq("mat").then_some(200.0),
        ..scaled(1.0)
    }
}

#[test]
fn refuses_every_file_cut_at_every_byte() {
    for (name, bytes) in files() {
        let options = options_for(&name);
        let whole = read_record(&bytes, &options).unwrap().record;
        for end in 0..bytes.len() {
            let cut = read_record(&bytes[..end], &options);
            if let Ok(cut) = cut {
                // the cut part had no sample, or the cut is undetectable: SAF within its last number, TDMS between two segments
                let same = cut.record.samples(0) == whole.samples(0);
                let unseen = (name == "three.saf" && end + 8 > bytes.len())
                    || (name.ends_with(".tdms") && bytes[end..].starts_with(b"TDSm"));
                assert!(same || unseen, "{name} cut at {end} is read as another record");
            }
        }
    }
}

#[test]
fn holds_every_changed_byte_is_read_or_refused_without_more_memory() {
    for (name, bytes) in files() {
        let options = options_for(&name);
        let whole = read_record(&bytes, &options).unwrap().record;
        for at in 0..bytes.len() {
            for change in [0x01, 0x80, 0xFF] {
                let mut changed = bytes.clone();
                changed[at] ^= change;
                if let Ok(reading) = read_record(&changed, &options) {
                    // zlib checks its packed contents: no change of samples is undetected
                    let packed = ["compressed.mat", "vectors.mat"].contains(&name.as_str()) && at >= 136;
                    assert!(
                        !packed || reading.record.samples(0) == whole.samples(0),
                        "{name}: byte {at} was changed, and is read"
                    );
                    let numbers = reading.record.length() * reading.record.channels().len();
                    assert!(
                        numbers < 8 * bytes.len(),
                        "{name}: {numbers} numbers of {} bytes",
                        bytes.len()
                    );
                }
            }
        }
    }
}
