// SOURCE     docs/watch.md, "What a logger reads"; the example pagoda_with_a_logger, whose README gives the true values.
// GOAL       A logged tilt or crack is watched from its file to the words: trend, limit, shift, faults of file and sensor.
// TOLERANCE  the 95 % interval of each answer contains the true value; words and exit statuses exactly.

use super::stores::json;
use super::verbs::Scratch;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;

fn log<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let all = answer["logs"].as_array().unwrap();
    all.iter().find(|log| log["name"] == name).unwrap()
}

fn holds(log: &Value, truth: f64) {
    let [found, sd] = ["per_year", "sd_per_year"].map(|key| log[key].as_f64().unwrap());
    assert!((found - truth).abs() <= 1.96 * sd, "{found} ± {sd}, {truth}");
}

#[test]
fn holds_the_truth_of_the_example_in_its_intervals() {
    let scratch = Scratch::with_examples("logs-example");
    let answer = json(&scratch, "watch examples/pagoda_with_a_logger");
    let [x, y, crack] = ["tilt_x", "tilt_y", "crack"].map(|name| log(&answer, name));
    holds(x, 0.45e-3);
    holds(y, 0.0);
    holds(crack, 0.11e-3);
    let told = |log: &Value| log["beyond_chance"].as_bool().unwrap();
    assert!(told(x) && !told(y) && told(crack));
    let shift = &x["shifts"][0];
    let [by, sd] = ["shift", "sd"].map(|key| shift[key].as_f64().unwrap());
    assert!((by - 0.55e-3).abs() <= 1.96 * sd, "{by} {sd}");
    // 1/150 less 1/280, the shift, and the growth of three years
    let left = (1.0 / 150.0 - 1.0 / 280.0 - 0.55e-3) / 0.45e-3 - 3.09;
    let years = |key: &str| x[key].as_f64().unwrap();
    assert!(
        years("years_to_limit_earliest") < left && left < years("years_to_limit_latest"),
        "{left} {x}"
    );
    assert_eq!(x["readings_of_wrong_clock"], 3);
    assert_eq!(x["days_of_spikes"], serde_json::json!(["2023-10-28"]));
    assert_eq!(answer["temperatures_of_log"], 3);
    let answer = scratch.briefly("watch examples/pagoda_with_a_logger");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(
        answer.words().contains("tilt along y: no trend"),
        "{}",
        answer.stdout
    );
    assert!(
        answer.stdout.lines().all(|line| line.chars().count() <= 80),
        "{}",
        answer.stdout
    );
}

/// A reading at noon of each day from 2023-01-01.
fn days(count: usize, value: impl Fn(f64) -> f64) -> String {
    let mut text = "Time,Tilt\n".to_owned();
    for day in 0..count {
        let (year, of_year) = (2023 + day / 360, day % 360);
        // twelve months of thirty days, February shortened: dates that every reader accepts
        let (month, of_month) = (1 + of_year / 30, 1 + of_year % 30);
        if month == 2 && of_month > 28 {
            continue;
        }
        writeln!(
            text,
            "{year}-{month:02}-{of_month:02} 12:00,{:.5}",
            value(day as f64)
        )
        .unwrap();
    }
    text
}

/// A project with one tilt log.
fn tilt(scratch: &Scratch, rows: &str, keys: &str) {
    let head = "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n";
    let table = "[watch.log.top]\nfile = \"top.csv\"\nkind = \"tilt\"\ndirection = \"x\"\nunit = \"mm/m\"\n";
    fs::write(scratch.path().join("pole.toml"), format!("{head}{table}{keys}")).unwrap();
    fs::write(scratch.path().join("top.csv"), rows).unwrap();
}

/// Deterministic noise: bounded, and different on neighbouring days.
fn noise(day: f64) -> f64 {
    0.05 * ((day * 12.9898).sin() * 43_758.547).fract()
}

#[test]
fn holds_a_log_at_its_limit_ends_with_one_and_one_without_zero_says_so() {
    let scratch = Scratch::new("logs-limit");
    tilt(
        &scratch,
        &days(1080, |day| 3.0 + 0.004 * day + noise(day)),
        "limit = \"7 mm/m\"\n",
    );
    let answer = scratch.briefly("watch pole.toml");
    assert_eq!(answer.status, 1, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer.words().contains("beyond its limit of 7.00 mm/m"),
        "{}",
        answer.stdout
    );
    tilt(
        &scratch,
        &days(1080, |day| 3.0 + 0.004 * day + noise(day)),
        "[watch]\ntilt_limit = \"1/200\"\n",
    );
    let answer = scratch.dolmen("watch pole.toml");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    assert!(
        answer.words().contains("held against no limit"),
        "{}",
        answer.stdout
    );
    assert!(
        answer.words().contains("a year, beyond chance"),
        "{}",
        answer.stdout
    );
}

#[test]
fn holds_newest_days_that_differ_are_no_good_news() {
    let scratch = Scratch::new("logs-newest");
    let last = 1080 - 1;
    for count in [0, 1, 2, 5] {
        let moved = |day: f64| f64::from(u8::from(day > f64::from(last - count)));
        let rows = days(1080, |day| 2.5 + 4.0 * moved(day) + noise(day));
        tilt(&scratch, &rows, "limit = \"10 mm/m\"\n");
        let answer = scratch.briefly("watch pole.toml");
        assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
        let words = answer.words();
        let good = words.contains("● top: no trend");
        if count == 0 {
            assert!(good && !words.contains("newest readings"), "{words}");
            continue;
        }
        let said = format!("(days: {count}, since 2025-12-{:02}) stand", 31 - count);
        assert!(!good && words.contains(&said), "{words}");
        let off = json(&scratch, "watch pole.toml")["logs"][0].clone();
        let [by, now] = [&off["last_off"]["off"], &off["now"]].map(|of| of.as_f64().unwrap());
        assert!(
            (by - 4e-3).abs() < 0.1e-3 && (now - 6.5e-3).abs() < 0.1e-3,
            "{off}"
        );
        // the reading of the last day alone reaches a limit of 6 mm/m
        tilt(&scratch, &rows, "limit = \"6 mm/m\"\n");
        assert_eq!(scratch.briefly("watch pole.toml").status, 1);
    }
}

#[test]
fn holds_what_cannot_be_told_is_not_told() {
    let scratch = Scratch::new("logs-short");
    tilt(&scratch, &days(400, noise), "");
    let said = scratch.briefly("watch pole.toml").words();
    assert!(
        said.contains("1.1 years of readings do not tell a trend from the season"),
        "{said}"
    );
    // it fell by 2 mm/m within a day, and the file gives no reason
    tilt(
        &scratch,
        &days(1080, |day| noise(day) - if day < 500.0 { 0.0 } else { 2.0 }),
        "",
    );
    let said = scratch.dolmen("watch pole.toml").words();
    assert!(
        said.contains("it jumped by −2.0") && said.contains("no work says why"),
        "{said}"
    );
    tilt(
        &scratch,
        &days(1080, |day| if day < 900.0 { noise(day) } else { 0.7 }),
        "",
    );
    let said = scratch.dolmen("watch pole.toml").words();
    assert!(said.contains("SENSOR: top reads one value since"), "{said}");
}

#[test]
fn holds_a_log_that_fell_silent_is_no_good_news() {
    let scratch = Scratch::new("logs-silent");
    let second =
        "[watch.log.foot]\nfile = \"foot.csv\"\nkind = \"tilt\"\ndirection = \"y\"\nunit = \"mm/m\"\n";
    let found = |last: usize| {
        tilt(&scratch, &days(1080, noise), second);
        fs::write(scratch.path().join("foot.csv"), days(last, noise)).unwrap();
        let answer = json(&scratch, "watch pole.toml");
        let silent = log(&answer, "foot")["silent_since"].as_str().map(str::to_owned);
        (silent, scratch.briefly("watch pole.toml"))
    };
    let (silent, brief) = found(1000);
    assert!(silent.is_some());
    let said = brief.words();
    assert!(
        said.contains("SENSOR: foot has no reading after") && said.contains("81 days before the newest"),
        "{said}"
    );
    assert!(!said.contains("● foot"), "{said}");
    let korean = scratch.briefly("watch pole.toml --language ko").words();
    assert!(korean.contains("이후 측정값이 없다"), "{korean}");
    // a gap of one week is accepted
    let (silent, brief) = found(1073);
    assert_eq!(silent, None);
    assert!(!brief.words().contains("SENSOR"), "{}", brief.stdout);
}

#[test]
fn refuses_units_that_contradict_the_file_and_keys_that_say_nothing() {
    let scratch = Scratch::with_examples("logs-wrong");
    let path = scratch.path().join("examples/pagoda_with_a_logger/project.toml");
    let good = fs::read_to_string(&path).unwrap();
    for (from, to, said) in [
        (
            "unit = \"deg\"",
            "unit = \"mrad\"",
            "the file says that the readings are in \"Deg\"",
        ),
        (
            "column = \"Tilt_X_Avg\"",
            "column = \"Tilt\"",
            "the log has no column \"Tilt\", but Tilt_X_Avg",
        ),
        ("column = \"Tilt_X_Avg\"\n", "", "the log has several columns"),
        ("direction = \"x\"\n", "", "direction is missing"),
        (
            "kind = \"temperature\"",
            "kind = \"temperature\"\nzero = \"1 mm\"",
            "zero says nothing of a log of this kind",
        ),
        ("limit = \"2 mm\"", "limit = \"2\"", "limit"),
        (
            "limit = \"2 mm\"",
            "limit = \"2000 mm\"",
            "beyond what can be meant",
        ),
        (
            "logger.dat\"\ncolumn = \"Crack",
            "crack.dat\"\ncolumn = \"Crack",
            "crack.dat",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        fs::write(&path, good.replacen(from, to, 1)).unwrap();
        let answer = scratch.dolmen("watch examples/pagoda_with_a_logger");
        assert_eq!(answer.status, 2, "{to}: {}", answer.stdout);
        let told: String = answer.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(told.contains(said), "{to}: {told}");
    }
}

#[test]
fn holds_logs_are_kept_in_the_store_watched_there_and_reported() {
    let scratch = Scratch::with_examples("logs-stored");
    let done = scratch.dolmen("survey add examples/pagoda_with_a_logger --name pagoda --store s.db");
    assert_eq!(done.status, 0, "{}", done.stderr);
    fs::remove_file(scratch.path().join("examples/pagoda_with_a_logger/logger.dat")).unwrap();
    let answer = json(&scratch, "watch --all --store s.db");
    let tilt = &answer["structures"][0]["history"]["tilt"];
    assert_eq!(
        (tilt["direction"].as_str(), tilt["limit"].as_f64()),
        (Some("x"), Some(1.0 / 150.0))
    );
    let done = scratch.dolmen("survey export pagoda -o back --store s.db");
    assert_eq!(done.status, 0, "{}", done.stderr);
    let report = scratch.dolmen("report back -o back/report.html");
    assert_eq!(report.status, 0, "{}", report.stderr);
    let page = fs::read_to_string(scratch.path().join("back/report.html")).unwrap();
    assert!(page.contains("tilt along y: no trend"));
    let report = scratch.dolmen("report back -o back/ko.html --language ko");
    assert_eq!(report.status, 0, "{}", report.stderr);
    assert!(
        fs::read_to_string(scratch.path().join("back/ko.html"))
            .unwrap()
            .contains("y 방향 기울기: 경향 없음")
    );
}
