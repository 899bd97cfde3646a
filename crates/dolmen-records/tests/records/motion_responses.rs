// SOURCE     Files in the form in which the Korea Meteorological Administration publishes events (NECIS): miniSEED in counts, named
//            NET.STA.CHA.YEAR.DAY.HH.MM.SS, and SEED RESP of each channel. Made-up numbers, files written by ObsPy 1.5.1 (Steim 2).
// GOAL       Accelerations are counts divided by the sensitivity in the channel's own response at the time of the record.
// REFERENCE  ObsPy 1.5.1: read_inventory(RESP), Stream.remove_sensitivity().
// TOLERANCE  1e-15 m/s²: one rounding of a quotient.

use dolmen::signal::Component;
use dolmen_records::motions::{MotionError, MotionOptions, read_channels, read_motion, responses};
use std::path::Path;

fn file(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/responses");
    std::fs::read(folder.join(name)).unwrap()
}

fn of_channel(channel: &str) -> Vec<u8> {
    file(&format!("KS.ADOA.{channel}.2023.146.11.39.54"))
}

fn response() -> String {
    String::from_utf8(file("RESP.KS.ADOA")).unwrap()
}

fn told(text: &str) -> MotionOptions {
    MotionOptions {
        responses: responses(text).unwrap(),
        ..MotionOptions::default()
    }
}

#[test]
fn agrees_counts_over_the_sensitivity_of_each_channel() {
    let files = ["HGE", "HGN", "HGZ"].map(of_channel);
    let sources: Vec<(Component, &[u8])> = Component::ALL
        .into_iter()
        .zip(files.iter().map(Vec::as_slice))
        .collect();
    let motion = read_motion("ADOA", &sources, &told(&response())).unwrap();
    // the first sample, the largest modulus and its index, by ObsPy
    let by_obspy = [
        (0.00143175, 0.042907942449409285, 12),
        (0.07768979, 0.09122401308105582, 5),
        (0.12853958, 0.128539578981953, 0),
    ];
    for (component, (first, peak, at)) in Component::ALL.into_iter().zip(by_obspy) {
        let found = motion.acceleration_m_s2(component);
        assert!((found[0] - first).abs() < 5e-9, "{component:?}: {}", found[0]);
        assert!(
            (found[at].abs() - peak).abs() < 1e-15,
            "{component:?}: {}",
            found[at]
        );
        assert_eq!(found.len(), 400);
    }
}

#[test]
fn refuses_what_the_responses_do_not_say() {
    let counts = of_channel("HGE");
    let refused = |options: &MotionOptions| read_channels(&counts, options).unwrap_err().to_string();
    assert!(matches!(
        read_channels(&counts, &MotionOptions::default()),
        Err(MotionError::NoUnit)
    ));
    let other = told(&response().replace("HGE", "BGE"));
    assert!(
        refused(&other).starts_with("no response is of the channel KS.ADOA..HGE"),
        "{}",
        refused(&other)
    );
    let late = told(&response().replace("2015,001,00:00:00", "2024,001,00:00:00"));
    assert!(
        refused(&late).contains("at the time of the record"),
        "{}",
        refused(&late)
    );
    let velocity = told(&response().replace("M/S**2 -", "M/S -"));
    assert!(
        refused(&velocity).contains("velocities, not accelerations"),
        "{}",
        refused(&velocity)
    );
    let twice = MotionOptions {
        factor: 2.0,
        ..told(&response())
    };
    assert!(
        refused(&twice).contains("a response is given too"),
        "{}",
        refused(&twice)
    );
}
