//! Records from NPY: every type and order, every refusal with its message.

use dolmen::signal::Channel;
use dolmen_records::records::{Axis, Column, Layout, Pick, RecordOptions, read_npy, read_record};

/// An NPY file as from numpy: the header ends with a line end at a multiple of 64 bytes.
fn npy(version: u8, literal: &str, values: &[u8]) -> Vec<u8> {
    let prefix = if version == 1 { 10 } else { 12 };
    let length = (prefix + literal.len() + 1).next_multiple_of(64) - prefix;
    let mut bytes = b"\x93NUMPY".to_vec();
    bytes.extend([version, 0]);
    if version == 1 {
        bytes.extend((length as u16).to_le_bytes());
    } else {
        bytes.extend((length as u32).to_le_bytes());
    }
    bytes.extend(format!("{literal:<width$}\n", width = length - 1).bytes());
    bytes.extend(values);
    bytes
}

fn header(descr: &str, fortran: &str, shape: &str) -> String {
    format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}")
}

fn at_100_hz() -> RecordOptions {
    RecordOptions {
        sampling_rate_hz: Some(100.0),
        ..Default::default()
    }
}

fn refusal(bytes: &[u8]) -> String {
    read_npy(bytes, &at_100_hz()).unwrap_err().to_string()
}

/// 1, 2, 3, -4 in the first channel, ten times that in the second, time running slowest.
const ROWS: [i16; 8] = [1, 10, 2, 20, 3, 30, -4, -40];

#[test]
fn exact_every_type_and_byte_order() {
    let values = |f: &dyn Fn(i16) -> Vec<u8>| ROWS.iter().flat_map(|v| f(*v)).collect::<Vec<u8>>();
    for (descr, bytes) in [
        ("<f8", values(&|v| f64::from(v).to_le_bytes().to_vec())),
        (">f8", values(&|v| f64::from(v).to_be_bytes().to_vec())),
        ("<f4", values(&|v| f32::from(v).to_le_bytes().to_vec())),
        (">f4", values(&|v| f32::from(v).to_be_bytes().to_vec())),
        ("<i2", values(&|v| v.to_le_bytes().to_vec())),
        (">i2", values(&|v| v.to_be_bytes().to_vec())),
        ("<i4", values(&|v| i32::from(v).to_le_bytes().to_vec())),
        (">i4", values(&|v| i32::from(v).to_be_bytes().to_vec())),
        ("<i8", values(&|v| i64::from(v).to_le_bytes().to_vec())),
        (">i8", values(&|v| i64::from(v).to_be_bytes().to_vec())),
    ] {
        for version in [1, 2, 3] {
            let file = npy(version, &header(descr, "False", "(4, 2)"), &bytes);
            let reading = read_record(&file, &at_100_hz()).unwrap();
            assert_eq!(reading.record.samples(0), [1.0, 2.0, 3.0, -4.0], "{descr}");
            assert_eq!(reading.record.samples(1), [10.0, 20.0, 30.0, -40.0], "{descr}");
        }
    }
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

#[test]
fn exact_every_order_and_shape() {
    let slow = doubles(&ROWS.map(f64::from));
    let fast = doubles(&[1.0, 2.0, 3.0, -4.0, 10.0, 20.0, 30.0, -40.0]);
    for (fortran, shape, values, axis) in [
        ("False", "(4, 2)", &slow, Axis::First),
        ("True", "(4, 2)", &fast, Axis::First),
        ("False", "(2, 4)", &fast, Axis::Second),
        ("True", "(2, 4)", &slow, Axis::Second),
    ] {
        let file = npy(1, &header("<f8", fortran, shape), values);
        let reading = read_npy(&file, &at_100_hz()).unwrap();
        assert_eq!(
            reading.record.samples(0),
            [1.0, 2.0, 3.0, -4.0],
            "{shape} {fortran}"
        );
        assert_eq!(reading.record.samples(1), [10.0, 20.0, 30.0, -40.0]);
        let Layout::Npy(layout) = reading.layout else {
            panic!()
        };
        assert_eq!(layout.time_axis, axis);
    }
    let file = npy(1, &header("<f8", "False", "(8,)"), &fast);
    assert_eq!(read_npy(&file, &at_100_hz()).unwrap().record.length(), 8);
}

#[test]
fn exact_longer_than_one_block() {
    let (length, channels) = (1300, 3);
    let value = |i: usize, c: usize| (i * 10 + c) as f64;
    let rows: Vec<f64> = (0..length * channels)
        .map(|k| value(k / channels, k % channels))
        .collect();
    let file = npy(1, &header("<f8", "False", "(1300, 3)"), &doubles(&rows));
    let pick = |n: usize| Pick {
        scale: None,
        column: Column::Number(n),
        channel: Channel::named(format!("column {n}")),
    };
    let options = RecordOptions {
        picks: vec![pick(3), pick(1)],
        ..at_100_hz()
    };
    let record = read_npy(&file, &options).unwrap().record;
    for i in 0..length {
        assert_eq!(
            (record.samples(0)[i], record.samples(1)[i]),
            (value(i, 2), value(i, 0))
        );
    }
    assert_eq!(record.channels()[0].name, "column 3");
}

#[test]
fn refuses_what_is_no_array_of_samples() {
    let values = doubles(&ROWS.map(f64::from));
    assert_eq!(
        refusal(b"time,a\n"),
        "this is no NPY file: it does not begin with \\x93NUMPY"
    );
    assert_eq!(
        refusal(&npy(1, &header("<c16", "False", "(4, 2)"), &values)),
        "the NPY file holds values of type \"<c16\", but f4, f8, i2, i4 and i8 can be read: save array.astype(\"f8\")"
    );
    assert!(
        refusal(&npy(
            1,
            "{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (8,), }",
            &values
        ))
        .starts_with("the NPY file holds values of type \"[('a', '<f8')]\"")
    );
    assert_eq!(
        refusal(&npy(1, &header("<f8", "False", "(2, 2, 2)"), &values)),
        "the array of the NPY file has shape [2, 2, 2], but must have 1 axis (samples) or 2 (samples and channels): save \
         one setup a file"
    );
    assert_eq!(
        refusal(&npy(1, &header("<f8", "False", "(5, 2)"), &values)),
        "the NPY file ends too early: its shape is [5, 2], but it holds 8 values; copy it again"
    );
    assert_eq!(
        refusal(&npy(1, &header("<f8", "False", "(3, 2)"), &values)),
        "the NPY file goes on for 16 bytes after the last value of its shape [3, 2]: it is damaged or holds several \
         arrays; save one array a file"
    );
    assert_eq!(
        refusal(&npy(4, &header("<f8", "False", "(4, 2)"), &values)),
        "the NPY file is of version 4, but versions 1 to 3 can be read: save it again with numpy.save"
    );
    assert!(
        refusal(&npy(1, "{'descr': '<f8', 'shape': (4, 2)}", &values))
            .starts_with("the header of the NPY file")
    );
    let overflowing = format!("({}, {})", usize::MAX, 3);
    assert!(refusal(&npy(1, &header("<f8", "False", &overflowing), &values)).contains("ends too early"));
    assert_eq!(
        refusal(&npy(1, &header("<f8", "False", "(0, 2)"), &[])),
        "the record has 0 channels of 2 samples, but must have at least 1 of 2"
    );
}

#[test]
fn refuses_without_a_rate_by_name_and_with_nan() {
    let file = npy(
        1,
        &header("<f8", "False", "(4, 2)"),
        &doubles(&ROWS.map(f64::from)),
    );
    assert_eq!(
        read_npy(&file, &RecordOptions::default())
            .unwrap_err()
            .to_string(),
        "the sampling rate is not known: an NPY file cannot hold it; give sampling_rate"
    );
    let pick = |column| RecordOptions {
        picks: vec![Pick {
            scale: None,
            column,
            channel: Channel::named("x"),
        }],
        ..at_100_hz()
    };
    assert_eq!(
        read_npy(&file, &pick(Column::Named("roof".into())))
            .unwrap_err()
            .to_string(),
        "column \"roof\" is asked for by name, but an NPY file has no names: ask for it by its number, 1 to 2"
    );
    assert_eq!(
        read_npy(&file, &pick(Column::Number(0))).unwrap_err().to_string(),
        "there is no column 0: the file has columns 1 to 2"
    );
    let mut values = ROWS.map(f64::from);
    values[5] = f64::NAN;
    assert_eq!(
        refusal(&npy(1, &header("<f8", "False", "(4, 2)"), &doubles(&values))),
        "channel \"ch2\" holds NaN at sample 2 (t = 0.02 s): cut the record before or after it, or leave the channel out"
    );
}

#[test]
fn holds_a_file_cut_anywhere_is_refused() {
    let file = npy(
        1,
        &header("<f8", "False", "(4, 2)"),
        &doubles(&ROWS.map(f64::from)),
    );
    for end in 0..file.len() {
        assert!(read_npy(&file[..end], &at_100_hz()).is_err(), "cut at {end}");
        assert!(read_record(&file[..end], &at_100_hz()).is_err(), "cut at {end}");
    }
}
