//! Errors of surveys, records and setups.

use super::project::{CHAIN, refused};
use dolmen_project::{Survey, parse_project};

fn listed(names: &[&str]) -> Vec<Survey> {
    let table = |name: &&str| format!("[survey.\"{name}\"]\nfrequencies.x = [1.5]\nmade_up = true\n");
    let tables: String = names.iter().map(table).collect();
    parse_project(&format!("{CHAIN}\n{tables}"), "project.toml")
        .unwrap()
        .surveys
}

#[test]
fn holds_surveys_with_a_date_are_read_in_its_order_wherever_the_file_lists_them() {
    let sorted = [
        "2018",
        "2019-04-02",
        "2019-04-02 (2)",
        "2019.10.02",
        "20200105",
        "2021-03",
    ];
    let names = |surveys: &[Survey]| -> Vec<String> { surveys.iter().map(|of| of.name.clone()).collect() };
    let expected = listed(&sorted);
    assert_eq!(names(&expected), sorted);
    for turned in 0..sorted.len() {
        let mut other = sorted;
        other.rotate_left(turned);
        other.reverse();
        assert_eq!(listed(&other), expected, "{other:?}");
    }
    // one without a date keeps its place
    let mixed = listed(&["second", "2021-01-01", "first", "2019-01-01"]);
    assert_eq!(names(&mixed), ["second", "2019-01-01", "first", "2021-01-01"]);
}

#[test]
fn refuses_records_that_cannot_be_read() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a.records]
file = "a.npy"
unit = "kN"
channels = [
  { column = 0, direction = "up" },
  { column = 2, name = "a", position = [1, 2] },
  { column = 2 },
]
conditioning = { band_pass = { low_hz = 20, high_hz = 1 }, decimate_factor = 0 }
"#
    );
    let said = r##"
error: a.npy holds no time stamps
   --> project.toml:13:8
    |
 13 | file = "a.npy"
    |        ^^^^^^^ sampling_rate is missing
    = help: write sampling_rate = "200 Hz" beside it

error: survey.a.records.unit = "kN" is no unit of vibration
   --> project.toml:14:8
    |
 14 | unit = "kN"
    |        ^^^^ unknown unit
    = help: the unit "kN" is not known: write m/s2, cm/s2 (gal), mm/s2, g, mg, %g, m/s, cm/s, mm/s, um/s, m, cm, mm, or "unknown" to keep the numbers as they are

error: survey.a.records.channels[1].column = 0 is outside its range
   --> project.toml:16:14
    |
 16 |   { column = 0, direction = "up" },
    |              ^ must be 1 to 10000

error: survey.a.records.channels[1].direction is not a direction
   --> project.toml:16:29
    |
 16 |   { column = 0, direction = "up" },
    |                             ^^^^ must be "x", "-x", "y", "-y", "z", "-z", or three numbers not all 0

error: survey.a.records.channels[2].position has 2 numbers
   --> project.toml:17:40
    |
 17 |   { column = 2, name = "a", position = [1, 2] },
    |                                        ^^^^^^ must be 3: x right, y away, z up

error: survey.a.records.channels[3].column = 2 is that of channels[2] too
   --> project.toml:18:14
    |
 18 |   { column = 2 },
    |              ^ must differ

error: survey.a.records.conditioning.band_pass: low_hz = 20 is not below high_hz = 1
   --> project.toml:20:30
    |
 20 | conditioning = { band_pass = { low_hz = 20, high_hz = 1 }, decimate_factor = 0 }
    |                              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ nothing would be left

error: survey.a.records.conditioning.decimate_factor = 0 is outside its range
   --> project.toml:20:78
    |
 20 | conditioning = { band_pass = { low_hz = 20, high_hz = 1 }, decimate_factor = 0 }
    |                                                                              ^ must be 1 to 1000
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_coefficient_of_temperature_that_is_not_clear() {
    let with = |lines: &str| refused(&format!("{CHAIN}\n[change]\n{lines}\n"));
    let said = with("temperature_coefficient_per_c = -0.001");
    assert!(
        said.contains(
            "change.temperature_coefficient_per_c stands without change.temperature_coefficient_sd_per_c"
        ) && said.contains("needs both"),
        "{said}"
    );
    let said = with("temperature_coefficient_per_c = -0.1\ntemperature_coefficient_sd_per_c = 0.0");
    assert!(said.contains("must be -0.05 to 0.05"), "{said}");
    let said = with("temperature = \"fitted\"\ntemperature_coefficient_per_c = -0.001");
    assert!(
        said.contains("are both given") && said.contains("keep one of them"),
        "{said}"
    );
    let said = with("temperature = \"guessed\"");
    assert!(said.contains("fitted"), "{said}");
    let said = with("frequency_within = 0.9");
    assert!(said.contains("must be 0.001 to 0.6"), "{said}");
}

#[test]
fn refuses_setups_whose_sensors_cannot_be_told_apart() {
    let setup = |channels: &str| {
        format!(
            "\n[[survey.a.setups]]\nfile = \"a.npy\"\nsampling_rate = \"100 Hz\"\nchannels = [{channels}]\n"
        )
    };
    let named = setup("{ column = 1, name = \"top\" }, { column = 2, name = \"below\" }");
    let said = refused(&format!("{CHAIN}{named}"));
    assert!(
        said.contains("survey.a.setups holds one record") && said.contains("needs two or more"),
        "{said}"
    );
    let said = refused(&format!("{CHAIN}{named}{}", setup("{ column = 1 }")));
    assert!(
        said.contains("survey.a.setups[2].channels do not tell which sensors stayed")
            && said.contains("each needs a name, or position and direction"),
        "{said}"
    );
    let records = "\n[survey.a.records]\nfile = \"b.npy\"\nsampling_rate = \"100 Hz\"\n";
    let said = refused(&format!("{CHAIN}{records}{named}{named}"));
    assert!(
        said.contains("survey.a.setups and records are both given"),
        "{said}"
    );
}

#[test]
fn refuses_a_way_to_put_setups_together_where_there_are_none() {
    let said = refused(&format!("{CHAIN}\n[survey.a]\nmerge = \"preger\"\n"));
    assert!(
        said.contains("survey.a.merge has no setups to put together")
            && said.contains("list the records as setups"),
        "{said}"
    );
    let said = refused(&format!("{CHAIN}\n[survey.a]\nmerge = \"both\"\n"));
    assert!(said.contains("poser") && said.contains("preger"), "{said}");
}

#[test]
fn exact_an_angular_frequency_becomes_hertz_and_keeps_its_text() {
    let of = |unit: &str, given: &str| {
        let units = match unit {
            "" => String::new(),
            unit => format!("units = {{ frequency = \"{unit}\" }}\n"),
        };
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Tower\"\n{units}[survey.2020-01-01]\nfrequencies.x = [{given}]\n"
        );
        let project = parse_project(&text, "project.toml").unwrap();
        project.surveys[0].modes["x"][0].frequency.clone()
    };
    let tau = std::f64::consts::TAU;
    for (unit, given, hertz, written) in [
        ("", "\"1.356 rad/s\"", 1.356 / tau, "1.356 rad/s"),
        ("", "\"77.69 deg/s\"", 77.69 / 360.0, "77.69 deg/s"),
        (
            "",
            "{ value = \"1.356 rad/s\", sd = 0.01356 }",
            1.356 / tau,
            "1.356 rad/s",
        ),
        ("rad/s", "1.356", 1.356 / tau, "1.356 rad/s"),
    ] {
        let read = of(unit, given);
        assert!(
            (read.value / hertz - 1.0).abs() < 1e-14,
            "{given}: {}",
            read.value
        );
        assert_eq!(read.written, written);
        let (unit, size) = read.written_unit().unwrap();
        let back: f64 = written.split(' ').next().unwrap().parse().unwrap();
        assert!((read.value / size / back - 1.0).abs() < 1e-14, "{unit}");
    }
    let of_sd = of("", "{ value = \"1.356 rad/s\", sd = 0.01356 }");
    assert!((of_sd.cov.unwrap() - 0.01).abs() < 1e-14);
}
