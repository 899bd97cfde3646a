// SOURCE     tests/data/modes/modes_pyuff.uff, written by pyuff 2.5.8 (bench/formats/records.py): three normal modes and one complex eigenvalue.
// GOAL       Modes of another program are read with their frequencies, damping ratios, places and shapes.
// TOLERANCE  2e-5: the six digits of the format.

use dolmen_records::records::read_modes_uff;
use std::f64::consts::TAU;

fn written() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/modes/modes_pyuff.uff");
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn agrees_modes_of_pyuff() {
    let read = read_modes_uff(written().as_bytes()).unwrap();
    assert_eq!(read.lengths_a_metre, Some(1.0));
    assert_eq!(read.places[&13], [0.0, 0.0, 9.0]);
    let expected = [(2.125, 0.0125), (2.75, 0.02), (6.5, 0.03), (9.25, 0.015)];
    assert_eq!(read.modes.len(), expected.len());
    for (mode, (frequency_hz, damping_ratio)) in read.modes.iter().zip(expected) {
        assert!((mode.frequency_hz / frequency_hz - 1.0).abs() < 2e-5);
        assert!((mode.damping_ratio.unwrap() / damping_ratio - 1.0).abs() < 2e-5);
    }
    assert_eq!(read.modes[0].displacements[&12], [[0.7, 0.0], [0.0; 2], [0.0; 2]]);
    assert_eq!(read.modes[1].displacements[&13][1], [1.0, 0.0]);
    let [re, im] = read.modes[3].displacements[&12][0];
    assert!((re - -0.9 * 0.3_f64.cos()).abs() < 2e-5 && (im - -0.9 * 0.3_f64.sin()).abs() < 2e-5);
}

#[test]
fn exact_hysteretic_damping_conjugates_and_no_damping() {
    let hysteretic = written().replace("1.25000e-02  0.00000e+00", "0.00000e+00  2.50000e-02");
    assert_eq!(
        read_modes_uff(hysteretic.as_bytes()).unwrap().modes[0].damping_ratio,
        Some(0.0125)
    );
    let undamped = written().replace("1.25000e-02", "0.00000e+00");
    assert_eq!(
        read_modes_uff(undamped.as_bytes()).unwrap().modes[0].damping_ratio,
        None
    );
    // the conjugate mode together with others, then alone
    let below = written().replace("  5.81129e+01", " -5.81129e+01");
    assert_eq!(read_modes_uff(below.as_bytes()).unwrap().modes.len(), 3);
    let alone = below[below.find("    -1\n    55").unwrap()..].replace(
        "         1         2         2         8",
        "         1         3         2         8",
    );
    let alone = alone.rsplit("    -1\n    -1\n").next().unwrap();
    let read = read_modes_uff(format!("    -1\n{alone}").as_bytes()).unwrap();
    assert!((TAU * read.modes[0].frequency_hz / 58.1195 - 1.0).abs() < 2e-5);
}

#[test]
fn refuses_what_is_no_mode() {
    let text = written();
    for (from, to, why) in [
        (
            "2.12500e+00",
            "0.00000e+00",
            "a frequency above 0 with a damping ratio",
        ),
        (
            "2.12500e+00",
            "2.125   e+00",
            "the frequency (Hz) or the complex eigenvalue",
        ),
        ("1.25000e-02", "1.25000e+02", "at least 0 and below 1"),
        ("-8.71792e-01", " 8.71792e-01", "at least 0 and below 1"),
        (
            "2         8         2         3",
            "1         8         2         1",
            "vectors with three or six values a node",
        ),
        (
            "3.50000e-01  0.00000e+00  0.00000e+00",
            "3.50000e-01  0.0000x",
            "the values of a node",
        ),
        ("   164 ", "    18 ", "dataset 18 or 2420"),
        (
            "         2         2         8",
            "         5         2         8",
            "",
        ),
    ] {
        let wrong = text.replace(from, to);
        assert_ne!(wrong, text, "{from}");
        match (read_modes_uff(wrong.as_bytes()), why) {
            (Ok(read), "") => assert_eq!(read.modes.len(), 1),
            (Err(said), why) => assert!(!why.is_empty() && said.to_string().contains(why), "{said}"),
            (Ok(_), why) => panic!("{why} is read"),
        }
    }
    let cut = &text[..text.len() - 200];
    let said = read_modes_uff(cut.as_bytes()).unwrap_err().to_string();
    assert!(
        said.contains("ends before") || said.contains("the values of a node"),
        "{said}"
    );
    let without = &text[..text.find("    55").unwrap() - 7];
    let said = read_modes_uff(without.as_bytes()).unwrap_err().to_string();
    assert!(
        said.contains("holds no modes") || said.contains("no modes"),
        "{said}"
    );
    for bytes in [b"".as_slice(), b"mode,frequency\n1,2\n", b"\x89PNG\r\n"] {
        assert!(read_modes_uff(bytes).is_err());
    }
}
