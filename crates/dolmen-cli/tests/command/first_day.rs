// SOURCE     a new user's first day: logs of Korean spreadsheets, flags without effect, numbers with commas, closed pipes.
// GOAL       Contradictions are refused with the fix; nothing is ignored silently; answers and errors are in the requested language.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fmt::Write as _;
use std::fs;
use std::process::{Command, Stdio};

const TOWER: &str = "schema = 1\nkind = \"stack\"\nname = \"Tower\"\ndensity = 2600\njoint = { friction = 0.7 }\nblocks = [\n  \
                     { name = \"a\", width = 1, height = 1 },\n  { name = \"b\", width = 0.8, height = 1.2 },\n]\n";

/// "측정시각,1층 가속도(gal),2층 가속도(gal)\r\n" as Python 3.11 encodes it in "cp949".
const NAMES: &[u8] = b"\xc3\xf8\xc1\xa4\xbd\xc3\xb0\xa2,1\xc3\xfe \xb0\xa1\xbc\xd3\xb5\xb5(gal),2\xc3\xfe \xb0\xa1\xbc\xd3\xb5\xb5(gal)\r\n";

#[test]
fn refuses_a_rate_that_the_times_of_a_korean_spreadsheet_contradict() {
    let scratch = Scratch::new("first-day-log");
    let mut log = NAMES.to_vec();
    // noise of a linear congruential generator
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / 1e6
    };
    // a mode of 5.07 Hz: each sample follows from the two before
    let mut swing = [0.0, 0.0];
    for i in 0..6000 {
        swing = [1.88 * swing[0] - 0.98 * swing[1] + noise() - noise(), swing[0]];
        let [first, second] = [1.0, 0.5].map(|share| share * swing[0] + noise() - noise());
        log.extend(b"2026-04-02 \xbf\xc0\xc0\xfc 9:");
        let clock = format!("30:{:02}.{:02}0", i / 100 % 60, i % 100);
        log.extend(format!("{clock},{first:.4},{second:.4}\r\n").as_bytes());
    }
    fs::write(scratch.path().join("log.csv"), log).unwrap();
    let columns = "channels = [{ column = \"1층 가속도(gal)\" }, { column = \"2층 가속도(gal)\" }]\n";
    let survey = |rate: &str| {
        format!(
            "schema = 1\nkind = \"survey\"\nname = \"L\"\n[survey.one.records]\nfile = \"log.csv\"\nunit = \"gal\"\nsampling_rate = \"{rate}\"\n{columns}"
        )
    };
    fs::write(scratch.path().join("l.toml"), survey("200 Hz")).unwrap();
    let refused = scratch.briefly("identify l.toml --language ko");
    assert!(
        refused.status == 2
            && refused
                .stderr
                .contains("sampling_rate는 200인데, \"측정시각\" 열은 2026-04-02 오전 9:30:00.000에서"),
        "{}",
        refused.stderr
    );
    fs::write(scratch.path().join("l.toml"), survey("100 Hz")).unwrap();
    let read = scratch.dolmen("identify l.toml --language ko");
    assert!(
        read.status == 0 && read.words().contains("텍스트가 CP949(EUC-KR)이므로"),
        "{}{}",
        read.stdout,
        read.stderr
    );
}

#[test]
fn refuses_flags_that_would_have_no_effect_and_says_what_they_are_for() {
    let scratch = Scratch::new("first-day-flags");
    fs::write(scratch.path().join("p.toml"), TOWER).unwrap();
    let carried = "is no file: Dolmen carries it";
    for (words, said) in [
        ("simulate p.toml --motion el-centro-1940-ns --unit gal", carried),
        ("simulate p.toml --motion el-centro-1940-ns --channel 7", carried),
        (
            "simulate p.toml --motion el-centro-1940-ns --sample-step 5",
            carried,
        ),
        (
            "report p.toml --motion el-centro-1940-ns --factor 2 -o r.html",
            carried,
        ),
        (
            "report p.toml --unit gal -o r.html",
            "but none is given: add --motion",
        ),
        ("motion --motion el-centro-1940-ns --x-azimuth 30", carried),
        (
            "motion --make ricker --peak 0.1g --unit gal",
            "--make makes one without a file",
        ),
        (
            "motion --make ricker --peak 0.1g --gamma 2",
            "--gamma would have no effect: it shapes a near-fault pulse",
        ),
        (
            "motion --make noise --peak 0.1g --period 2",
            "--period would have no effect",
        ),
        (
            "motion --motion el-centro-1940-ns --damping 0.02",
            "--damping would have no effect",
        ),
        (
            "motion --motion el-centro-1940-ns --seed 3",
            "--seed would have no effect: it is for noise",
        ),
        ("motion a.csv --motion el-centro-1940-ns", "cannot be used with"),
        ("check p.toml --seed 5", "--samples"),
    ] {
        let answer = scratch.briefly(words);
        assert!(
            answer.status == 2 && answer.stderr.contains(said),
            "{words}: {}{}",
            answer.stdout,
            answer.stderr
        );
        assert_eq!(answer.stdout, "", "{words}");
    }
}

#[test]
fn refuses_a_bare_number_with_a_comma_and_says_how_it_is_written() {
    let scratch = Scratch::new("first-day-commas");
    for (written, english, korean) in [
        ("0,95", "a decimal comma? Write 0.95", "수 0,95에 쉼표가 있다"),
        (
            "1,200",
            "write 1200 if it separates thousands, 1.200 if it is a decimal sign",
            "천 단위 구분이면 1200, 소수점이면 1.200으로 쓴다",
        ),
        (
            "1,200.5",
            "no thousands separator: write 1200.5",
            "천 단위 구분 기호를 쓰지 않는다",
        ),
    ] {
        fs::write(
            scratch.path().join("p.toml"),
            TOWER.replace("height = 1 }", &format!("height = {written} }}")),
        )
        .unwrap();
        let answer = scratch.briefly("check p.toml");
        assert!(
            answer.status == 2 && answer.stderr.contains(english),
            "{}",
            answer.stderr
        );
        assert!(
            answer
                .stderr
                .contains(&format!("the number {written} holds a comma")),
            "{}",
            answer.stderr
        );
        assert!(answer.stderr.contains("p.toml:7:37"), "{}", answer.stderr);
        let answer = scratch.briefly("check p.toml --language ko");
        assert!(answer.stderr.contains(korean), "{}", answer.stderr);
    }
}

/// A closed pipe ends each verb with long output silently.
#[cfg(unix)]
#[test]
fn holds_a_closed_pipe_is_no_fault_of_any_verb() {
    let scratch = Scratch::new("first-day-pipes");
    for words in [
        "explain",
        "explain underdetermined",
        "explain --json",
        "doctor",
        "man",
        "completions bash",
        "schema",
        "words",
        "new pagoda made",
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(words.split_whitespace())
            .current_dir(scratch.path())
            .stdout(Stdio::from(writer))
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{words}: {said}");
    }
}

#[test]
fn holds_notes_and_errors_of_a_site_are_in_korean() {
    let scratch = Scratch::new("first-day-korean");
    let made = scratch.briefly("new pagoda made --language ko");
    assert!(
        made.stdout
            .starts_with("made/project.toml은 예제 three_storey_pagoda의 사본이다.\n다음: "),
        "{}",
        made.stdout
    );
    let site = |soil: &str, years: u32| {
        format!(
            "{TOWER}[site]\ncode = \"kds 17 10 00\"\nzone = \"I\"\nsoil = \"{soil}\"\nreturn_period_years = {years}\n"
        )
    };
    for (soil, years, korean, english) in [
        (
            "S6",
            1000,
            "지반분류 S6은 부지 고유의 지반이라",
            "site class S6 is site-specific",
        ),
        (
            "S2",
            475,
            "return_period_years가 475인데 기준에는",
            "return_period_years is 475, but the code has",
        ),
        (
            "SB",
            1000,
            "\"S1\"(암반)~\"S5\"(깊고 연약한 지반)",
            "must be \"S1\" (rock) to \"S5\" (deep and soft)",
        ),
    ] {
        fs::write(scratch.path().join("p.toml"), site(soil, years)).unwrap();
        for (language, said) in [("ko", korean), ("en", english)] {
            let answer = scratch.briefly(&format!("check p.toml --language {language}"));
            assert!(
                answer.status == 2 && answer.stderr.contains(said),
                "{}",
                answer.stderr
            );
        }
    }
}

#[test]
fn exact_a_warning_names_the_line_of_its_value_and_the_unit_as_written() {
    let scratch = Scratch::new("first-day-lines");
    // a model that leans as surveyed would be refused
    let mut text = TOWER.replacen("schema = 1\n", "schema = 1\nas_surveyed = \"none\"\n", 1);
    writeln!(
        text,
        "[survey.2026-03-10]\ntilt = {{ x = \"6.2 deg\", y = 0.108 }}"
    )
    .unwrap();
    fs::write(scratch.path().join("p.toml"), text).unwrap();
    let said = scratch.briefly("check p.toml").words();
    assert!(
        said.contains("line 12: survey.2026-03-10.tilt.x = \"6.2 deg\" is a tilt of 6.20°, more than towers at their end lean"),
        "{said}"
    );
    assert!(
        said.contains("line 12: survey.2026-03-10.tilt.y is a tilt of 6.16°: is it in degrees?"),
        "{said}"
    );
}
