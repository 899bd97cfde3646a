// SOURCE     docs/earthquakes.md; made records whose truth is known (`dolmen::modal::MadeEarthquake`).
// GOAL       Records with two earthquakes, with samples lost in one, with a saturated sensor, or with lorries instead: the answer says so, marks
//            lower bounds as such, and does not report a sensor as faulty because the ground moved.
// TOLERANCE  2.5 s on arrivals; words.

use super::followed::{FOLLOW, HEAD, RECORDS, STORE, made_record, put};
use super::stores::{good, json};
use super::verbs::Scratch;
use dolmen::modal::MadeEarthquake;
use dolmen::numeric::Random;
use std::fs;

/// Ground, floor and roof, m/s², at 100 Hz.
type Samples = Vec<Vec<f64>>;

fn shock(seed: u64, peak_m_s2: f64, softened: [f64; 2]) -> Samples {
    let made = MadeEarthquake {
        seed,
        duration_s: 200.0,
        arrival_s: 80.0,
        peak_m_s2,
        softened,
        ..MadeEarthquake::default()
    };
    let record = made.make().unwrap();
    (0..3).map(|c| record.samples(c).to_vec()).collect()
}

/// A project with one survey of this record, without the rows in `lost`.
fn survey(name: &str, samples: &Samples, lost: std::ops::Range<usize>) -> Scratch {
    let scratch = Scratch::new(name);
    let rows = (0..samples[0].len()).filter(|t| !lost.contains(t));
    let row = |t: usize| {
        let each: Vec<String> = samples.iter().map(|own| format!("{:.6}", own[t])).collect();
        format!("{:.2},{}\n", t as f64 / 100.0, each.join(","))
    };
    let text = "time (s),G,F,R\n".to_owned() + &rows.map(row).collect::<String>();
    fs::write(scratch.path().join("record.csv"), text).unwrap();
    let project = r#"schema = 1
kind = "survey"
name = "Gate"
[survey.2026-05-01.records]
file = "record.csv"
unit = "m/s2"
channels = [
  { column = "G", name = "G", position = [0, 0, 0], direction = "x" },
  { column = "F", name = "F", position = [0, 0, 3], direction = "x" },
  { column = "R", name = "R", position = [0, 0, 6], direction = "x" },
]
"#;
    fs::write(scratch.path().join("project.toml"), project).unwrap();
    scratch
}

/// Blows at these times on three sensors of a mast, m/s², at 100 Hz: modes at 1.85, 7.2 and 17.4 Hz, all times `times`.
fn blows(seed: u64, at_s: &[f64], duration_s: f64, times: f64) -> Samples {
    const MODES: [(f64, f64, [f64; 3]); 3] = [
        (1.85, 0.006, [0.18, 0.53, 1.0]),
        (7.2, 0.008, [-0.62, -0.47, 1.0]),
        (17.4, 0.011, [0.69, -0.62, 1.0]),
    ];
    let mut random = Random::new(seed, 0);
    let mut sample = |c: usize, t: f64| -> f64 {
        let each = MODES.iter().flat_map(|(hz, zeta, shape)| {
            let omega = std::f64::consts::TAU * hz * times;
            let since = at_s.iter().map(move |at| t - at).filter(|since| *since >= 0.0);
            since.map(move |t| shape[c] * (-zeta * omega * t).exp() * (omega * t).sin())
        });
        each.sum::<f64>() + 1e-3 * random.normal()
    };
    (0..3)
        .map(|c| {
            (0..(100.0 * duration_s) as usize)
                .map(|t| sample(c, t as f64 / 100.0))
                .collect()
        })
        .collect()
}

fn of_record(scratch: &Scratch) -> serde_json::Value {
    json(scratch, "identify project.toml")["surveys"][0]["records"].clone()
}

#[test]
fn holds_every_earthquake_of_a_record_is_told_with_what_it_left() {
    let (first, second) = (shock(1, 2.0, [0.85, 1.0]), shock(2, 1.2, [0.7, 0.9]));
    let samples = first
        .into_iter()
        .zip(second)
        .map(|(a, b)| [a, b].concat())
        .collect();
    let scratch = survey("two-shocks", &samples, 0..0);
    let said = good(scratch.briefly("identify project.toml")).stdout;
    let plain = said.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        "EARTHQUAKES: the record holds 2",
        "Earthquake 1: 80",
        "It left no change beyond chance",
        "Earthquake 2: 280",
        "It CHANGED 2.",
        "LASTING CHANGE: 2.",
        "in all, from the part 0 s to 79",
    ] {
        assert!(plain.contains(words), "{words}: {plain}");
    }
    for words in ["SLIP", "fault"] {
        assert!(!plain.contains(words), "{words}: {plain}");
    }
    let of = &of_record(&scratch)["earthquake"];
    let events = of["events"].as_array().unwrap();
    let arrivals: Vec<f64> = events
        .iter()
        .map(|of| of["arrival_s"].as_f64().unwrap())
        .collect();
    assert!(
        arrivals.len() == 2 && (arrivals[0] - 80.0).abs() < 2.5 && (arrivals[1] - 280.0).abs() < 2.5,
        "{arrivals:?}"
    );
    assert_eq!(of["parts"].as_array().unwrap().len(), 3);
    assert_eq!(
        (&of["changes"][0]["beyond_chance"], &of["modes_of"]),
        (&true.into(), &"after".into())
    );
}

#[test]
fn holds_an_earthquake_in_which_samples_are_lost_is_told_from_both_sides_of_them() {
    let scratch = survey("lost-in-it", &shock(1, 2.0, [0.7, 0.9]), 8400..9200);
    let plain = good(scratch.briefly("identify project.toml")).words();
    for words in [
        "largest acceleration at least",
        "samples were lost in it",
        "LASTING CHANGE: 2.",
        "samples are lost, 8 s (after 83.99 s): what lies on either side is used, each by itself",
    ] {
        assert!(plain.contains(words), "{words}: {plain}");
    }
    let of = &of_record(&scratch)["earthquake"];
    assert!((of["arrival_s"].as_f64().unwrap() - 80.0).abs() < 2.5, "{of}");
    assert!(of["before"]["modes"]["modes"].is_array() && of["after"]["modes"]["modes"].is_array());
    assert!(
        of["channels"]
            .as_array()
            .unwrap()
            .iter()
            .all(|of| of["peak_at_least"] == "lost_samples")
    );
    // an ambient record with the same loss is used as before
    let ambient = survey("lost-in-none", &shock(1, 0.0, [1.0, 1.0]), 8400..9200);
    let plain = good(ambient.briefly("identify project.toml")).words();
    assert!(plain.contains("only the longest whole span is used"), "{plain}");
}

#[test]
fn holds_the_peak_of_a_clipped_sensor_is_at_least() {
    let mut samples = shock(1, 2.0, [0.7, 0.9]);
    let half = 0.5 * samples[2].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    samples[2].iter_mut().for_each(|x| *x = x.clamp(-half, half));
    let scratch = survey("clipped-in-it", &samples, 0..0);
    let plain = good(scratch.briefly("identify project.toml")).words();
    for words in ["largest acceleration at least", "R reached the end of the range"] {
        assert!(plain.contains(words), "{words}: {plain}");
    }
    let of = &of_record(&scratch)["earthquake"]["channels"];
    let at_least = |c: usize| of[c]["peak_at_least"].as_str();
    assert_eq!([0, 1, 2].map(at_least), [None, None, Some("clipped")], "{of}");
    let watched = json(&scratch, "watch project.toml");
    assert_eq!(
        watched["earthquakes"][0]["peak_at_least"], true,
        "{}",
        watched["earthquakes"]
    );
}

/// Three passing lorries, 6 to 18 Hz on the ground, and two floors above that move only in the wind.
fn lorries() -> Samples {
    let still = MadeEarthquake {
        seed: 5,
        duration_s: 200.0,
        peak_m_s2: 0.0,
        noise_m_s2: 5e-4,
        ..MadeEarthquake::default()
    };
    let still = still.make().unwrap();
    let mut samples: Samples = (0..3).map(|c| still.samples(c).to_vec()).collect();
    let mut random = Random::new(11, 4);
    let tones: Vec<[f64; 2]> = (0..60)
        .map(|_| [6.0 + 12.0 * random.uniform(), 6.3 * random.uniform()])
        .collect();
    for t in 0..samples[0].len() {
        let at = t as f64 / 100.0;
        let passes = |middle: f64, length: f64| 1.0 / (1.0 + ((at - middle) / length).powi(2));
        let envelope = passes(60.0, 1.2) + passes(110.0, 1.0) + passes(150.0, 1.5);
        let sum: f64 = tones
            .iter()
            .map(|[hz, phase]| (std::f64::consts::TAU * hz * at + phase).sin())
            .sum();
        for (own, share) in samples.iter_mut().zip([0.6, 0.8, 1.0]) {
            own[t] += 0.2 * share * envelope * sum / 18.0;
        }
    }
    samples
}

#[test]
fn holds_a_lorry_close_by_is_strong_shaking_and_no_alarm() {
    let scratch = survey("lorries", &lorries(), 0..0);
    let plain = good(scratch.briefly("identify project.toml")).words();
    assert!(
        plain.contains("STRONG SHAKING")
            && plain.contains("traffic close by, a gust or")
            && !plain.contains("EARTHQUAKE"),
        "{plain}"
    );
    let of = &of_record(&scratch)["earthquake"];
    assert!(
        of["events"]
            .as_array()
            .unwrap()
            .iter()
            .all(|of| of["taken_for"] == "earthquake_or_traffic"),
        "{of}"
    );
}

#[test]
fn holds_a_record_with_a_lorry_that_comes_is_a_survey_and_no_alarm() {
    let scratch = Scratch::new("lorry-followed");
    let folder = |name: &str| scratch.path().join(name);
    for name in ["p", "in"] {
        fs::create_dir_all(folder(name)).unwrap();
    }
    fs::write(folder("p/1.csv"), made_record(2.0, 6000, 1)).unwrap();
    let text = format!("{HEAD}[survey.2026-01-01.records]\nfile = \"1.csv\"\n{RECORDS}");
    fs::write(folder("p/project.toml"), text).unwrap();
    good(scratch.briefly(&format!("survey add p {STORE}")));
    let made = made_record(2.0, 20_000, 14);
    let mut lines = made.lines();
    let mut shaken = lines.next().unwrap().to_owned() + "\n";
    let mut random = Random::new(12, 4);
    let tones: Vec<[f64; 2]> = (0..60)
        .map(|_| [9.0 + 8.0 * random.uniform(), 6.3 * random.uniform()])
        .collect();
    for (row, line) in lines.enumerate() {
        let t = row as f64 / 100.0;
        let sum: f64 = tones
            .iter()
            .map(|[hz, phase]| (std::f64::consts::TAU * hz * t + phase).sin())
            .sum();
        let moved = sum / (1.0 + ((t - 90.0) / 1.5).powi(2));
        let each = line
            .split(',')
            .map(|number| format!("{:.4}", 0.002 * number.parse::<f64>().unwrap() + moved));
        shaken += &(each.collect::<Vec<_>>().join(",") + "\n");
    }
    put(&folder("in/2026-01-14.csv"), shaken);
    let followed = scratch.briefly(FOLLOW);
    assert_eq!(followed.status, 0, "{}{}", followed.stdout, followed.stderr);
    let plain = followed.words();
    assert!(
        plain.contains("strong shaking, ") && !plain.contains("EARTHQUAKE"),
        "{plain}"
    );
}

#[test]
fn holds_a_blow_is_a_free_decay_and_no_earthquake() {
    for (name, at_s) in [("one-blow", &[3.0][..]), ("blows", &[3.0, 24.0, 43.0])] {
        let scratch = survey(name, &blows(1, at_s, 60.0, 1.0), 0..0);
        let plain = good(scratch.briefly("identify project.toml")).words();
        assert!(
            plain.contains("FREE DECAY") && !plain.contains("EARTHQUAKE"),
            "{plain}"
        );
        let korean = good(scratch.briefly("identify project.toml --language ko")).words();
        assert!(
            korean.contains("자유감쇠") && !korean.contains("지진"),
            "{korean}"
        );
        let record = of_record(&scratch);
        assert!(record["earthquake"].is_null(), "{record}");
        let spans = record["free_decays"]["spans_s"].as_array().unwrap();
        assert_eq!(spans.len(), at_s.len(), "{spans:?}");
        let modes = record["modes"]["modes"].as_array().unwrap();
        let near = |hz: f64| {
            modes
                .iter()
                .filter(|of| (of["frequency_hz"].as_f64().unwrap() / hz - 1.0).abs() < 0.01)
                .count()
        };
        assert_eq!([1.85, 7.2, 17.4].map(near), [1, 1, 1], "{modes:?}");
        assert_eq!(modes.len(), 3, "{modes:?}");
    }
}

#[test]
fn holds_a_change_between_records_of_blows_is_not_sure() {
    let scratch = survey("blows-compared", &blows(1, &[3.0, 24.0, 43.0], 60.0, 1.0), 0..0);
    fs::rename(
        scratch.path().join("record.csv"),
        scratch.path().join("before.csv"),
    )
    .unwrap();
    let later = survey("blows-later", &blows(2, &[5.0, 22.0, 41.0], 60.0, 0.97), 0..0);
    fs::copy(later.path().join("record.csv"), scratch.path().join("after.csv")).unwrap();
    let project = fs::read_to_string(scratch.path().join("project.toml")).unwrap();
    let at = project.find("[survey").unwrap();
    let of = |date: &str, file: &str| {
        let own = project[at..]
            .replace("2026-05-01", date)
            .replace("record.csv", file);
        format!("[survey.{date}]\ntemperature_c = 15\n{own}")
    };
    let both = format!(
        "{}{}{}",
        &project[..at],
        of("2020-05-01", "before.csv"),
        of("2026-05-02", "after.csv")
    );
    fs::write(scratch.path().join("project.toml"), both).unwrap();
    let plain = good(scratch.briefly("compare project.toml")).words();
    assert!(
        plain.contains("changed beyond chance")
            && plain.contains("NOT SURE, since the record of survey 2020-05-01"),
        "{plain}"
    );
    let korean = good(scratch.briefly("compare project.toml --language ko")).words();
    assert!(
        korean.contains("확실하지 않다. 2020-05-01 조사의 기록은 타격 뒤의 자유감쇠"),
        "{korean}"
    );
}
