// SOURCE     Small stacks and the shipped gate under noise and El Centro 1940.
// GOAL       A study's table depends only on its inputs: not on threads, shards, or how often the process was killed; a refused run is a row
//            with its reason; capacities follow from the runs.
// TOLERANCE  none: bytes of tables.

use super::verbs::Scratch;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Two stones under noise: 4 heights × 6 motions × 9 scales, and some to refine.
const TWO_STONES: &str = r#"
schema = 1
kind = "stack"
name = "Two stones"
density = 2600
joint = { friction = { value = 0.7, cov = 0.1 } }
blocks = [{ name = "foot", width = 1.0, height = 0.3 }, { name = "stone", width = 0.3, height = 0.9 }]

[study.height]
vary = { "blocks[2].height" = [0.7, 0.9, 1.1, 1.3] }
artificial = { count = 6, duration_s = 20, strong_s = 4 }
scale = { from = 1, to = 9, steps = 9 }
points = 16
refine = 2
expect = [{ input = "blocks[2].height", trend = "falling" }]

[study.drawn]
samples = 3
artificial = { count = 1, duration_s = 3, strong_s = 1, rise_s = 1 }
scale = [4]
points = 4

[study.refused]
vary = { "joint.friction" = [0.5, -1], "blocks[2].height" = [0.9, 60] }
artificial = { count = 1, duration_s = 3, strong_s = 1, rise_s = 1 }
scale = [1]
"#;

fn with(name: &str, text: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    scratch
}

/// All results of a study by name, without the journals.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let named = files.map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), path));
    let results = named.filter(|(name, _)| !name.starts_with("journal"));
    results
        .map(|(name, path)| (name, fs::read(path).unwrap()))
        .collect()
}

fn same(one: &Path, other: &Path) {
    let (one, other) = (results(one), results(other));
    assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
    assert!(one.contains_key("runs.parquet") && one.contains_key("runs.csv"));
    for (name, bytes) in &one {
        assert!(other[name] == *bytes, "{name} differs");
    }
}

pub(super) fn rows(csv: &Path) -> Vec<BTreeMap<String, String>> {
    let text = fs::read_to_string(csv).unwrap();
    let mut lines = text
        .lines()
        .map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let heads = lines.next().unwrap();
    lines
        .map(|cells| heads.iter().cloned().zip(cells).collect())
        .collect()
}

#[test]
fn holds_the_same_bits_on_one_two_four_and_eight_threads() {
    let stones = with("threads", TWO_STONES);
    for threads in [1, 2, 4, 8] {
        let done = stones.dolmen(&format!(
            "study . --study height -o t{threads} --threads {threads}"
        ));
        assert_eq!(done.status, 0, "{}{}", done.stdout, done.stderr);
    }
    let pole = Scratch::with_examples("threads-pole");
    for threads in [1, 2, 4, 8] {
        let done = pole.dolmen(&format!(
            "study examples/naju_flagpole --study growth -o t{threads} --threads {threads}"
        ));
        assert_eq!(done.status, 0, "{}{}", done.stdout, done.stderr);
    }
    for threads in [2, 4, 8] {
        let of = |scratch: &Scratch, threads: usize, study: &str| {
            scratch.path().join(format!("t{threads}/{study}"))
        };
        same(&of(&stones, 1, "height"), &of(&stones, threads, "height"));
        same(&of(&pole, 1, "growth"), &of(&pole, threads, "growth"));
    }
    // samples of a check: the environment sets the number of threads
    let sampled = |threads: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args("check examples/naju_flagpole --samples 300 --sensitivity --json".split(' '))
            .current_dir(pole.path())
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert!(output.status.code().is_some_and(|status| status < 2));
        output.stdout
    };
    let one = sampled("1");
    assert!(one.len() > 1000);
    for threads in ["2", "4", "8"] {
        assert!(sampled(threads) == one, "{threads} threads");
    }
}

#[test]
fn holds_a_killed_study_goes_on_and_ends_with_the_same_bits() {
    let scratch = with("killed", TWO_STONES);
    let whole = scratch.dolmen("study . --study height -o whole --threads 1");
    assert_eq!(whole.status, 0, "{}{}", whole.stdout, whole.stderr);
    let journal = scratch.path().join("cut/height/journal.tsv");
    let lines = || fs::read_to_string(&journal).map_or(0, |text| text.lines().count());
    let runs = fs::read_to_string(scratch.path().join("whole/height/runs.csv"))
        .unwrap()
        .lines()
        .count()
        - 1;
    let mut kept = 0;
    for part in [runs / 4, runs / 2] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args("study . --study height -o cut --threads 1 --full".split(' '))
            .current_dir(scratch.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        while lines() < part && begun.elapsed() < Duration::from_secs(60) {
            sleep(Duration::from_millis(1));
        }
        child.kill().unwrap(); // SIGKILL: no cleanup is possible
        child.wait().unwrap();
        assert!(
            !scratch.path().join("cut/height/runs.csv").exists(),
            "killed too late to tell anything"
        );
        kept = lines() - 1;
        assert!(kept + 1 >= part && kept < runs, "{kept} of {runs}");
        // as after a kill during a write
        let torn = fs::read_to_string(&journal).unwrap() + "3\t2\t0.31";
        fs::write(&journal, torn).unwrap();
    }
    let missing = scratch.dolmen("study missing . --study height -o cut");
    assert_eq!(missing.status, 3, "{}", missing.stdout);
    assert!(
        missing.stdout.contains("missing: blocks[2].height = "),
        "{}",
        missing.stdout
    );
    let resumed = scratch.dolmen("study . --study height -o cut --threads 2");
    assert_eq!(resumed.status, 0, "{}", resumed.stderr);
    assert!(
        resumed
            .stderr
            .contains(&format!("{kept} runs are kept from before")),
        "{}",
        resumed.stderr
    );
    same(
        &scratch.path().join("whole/height"),
        &scratch.path().join("cut/height"),
    );
    assert_eq!(resumed.stdout, whole.stdout);
    // no row is lost or repeated
    let text = fs::read_to_string(&journal).unwrap();
    let mut keys: Vec<String> = text
        .lines()
        .skip(1)
        .map(|line| line.split('\t').take(2).collect::<Vec<_>>().join(" "))
        .collect();
    keys.sort();
    let all = keys.len();
    keys.dedup();
    assert_eq!((keys.len(), all), (runs, runs));
    // the third time there is nothing to do
    let again = scratch.dolmen("study . --study height -o cut");
    assert_eq!(again.stdout, whole.stdout);
    assert_eq!(fs::read_to_string(&journal).unwrap(), text);
    let done = scratch.dolmen("study missing . --study height -o cut");
    assert_eq!(done.status, 0, "{}", done.stdout);
}

#[cfg(unix)]
#[test]
fn holds_ctrl_c_keeps_what_is_done() {
    let scratch = with("interrupted", TWO_STONES);
    let journal = scratch.path().join("cut/height/journal.tsv");
    let child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args("study . --study height -o cut --threads 1 --full".split(' '))
        .current_dir(scratch.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    while fs::read_to_string(&journal).map_or(0, |text| text.lines().count()) < 20 {
        assert!(begun.elapsed() < Duration::from_secs(60));
        sleep(Duration::from_millis(1));
    }
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(sent.success());
    let ended = child.wait_with_output().unwrap();
    let stdout = String::from_utf8_lossy(&ended.stdout);
    assert_eq!(ended.status.code(), Some(3), "{stdout}");
    assert!(stdout.contains("Not finished"), "{stdout}");
    // the answer reports unfinished runs once, and does not count them as unusable
    assert!(
        stdout.contains("not finished") && !stdout.contains("cannot be used"),
        "{stdout}"
    );
    let whole = scratch.dolmen("study . --study height -o whole");
    let resumed = scratch.dolmen("study . --study height -o cut");
    assert_eq!((whole.status, resumed.status), (0, 0));
    same(
        &scratch.path().join("whole/height"),
        &scratch.path().join("cut/height"),
    );
}

#[test]
fn holds_shards_merged_are_one_run_and_a_missing_one_is_named() {
    let scratch = with("shards", TWO_STONES);
    let study = |words: &str| scratch.dolmen(&format!("study {words} --study height"));
    assert_eq!(study(". -o whole").status, 0);
    assert_eq!(study(". -o one --shard 1/3").status, 0);
    assert_eq!(study(". -o two --shard 2/3 --threads 1").status, 0);
    let part = study("merge . -o one --from two");
    assert_eq!(part.status, 3, "{}", part.stdout);
    assert!(
        part.words().contains("Not finished: 8 of 24 scans are missing"),
        "{}",
        part.stdout
    );
    let missing = study("missing . -o one --from two");
    assert!(
        missing.stdout.contains("16 of 24 scans are done"),
        "{}",
        missing.stdout
    );
    // merged in two steps, the first stays, and a study in that folder goes on from both
    assert_eq!(study("merge . -o steps --from one").status, 3);
    let second = study("merge . -o steps --from two");
    assert!(
        second.words().contains("Not finished: 8 of 24 scans are missing"),
        "{}",
        second.stdout
    );
    let ended = study(". -o steps");
    assert_eq!(ended.status, 0, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains("are kept from before"), "{}", ended.stderr);
    same(
        &scratch.path().join("whole/height"),
        &scratch.path().join("steps/height"),
    );
    assert_eq!(study(". -o one --shard 3/3").status, 0);
    let merged = study("merge . -o one --from two");
    assert_eq!(merged.status, 0, "{}{}", merged.stdout, merged.stderr);
    same(
        &scratch.path().join("whole/height"),
        &scratch.path().join("one/height"),
    );
    for wrong in ["0/2", "3/2", "half"] {
        let refused = study(&format!(". -o wrong --shard {wrong}"));
        assert_eq!(refused.status, 2);
        assert!(refused.stderr.contains("k/N"), "{}", refused.stderr);
    }
}

#[test]
fn holds_capacities_follow_from_the_runs() {
    let scratch = with("capacities", TWO_STONES);
    assert_eq!(scratch.dolmen("study . --study height -o out").status, 0);
    let folder = scratch.path().join("out/height");
    let (runs, capacities) = (
        rows(&folder.join("runs.csv")),
        rows(&folder.join("capacities.csv")),
    );
    assert_eq!(capacities.len(), 24);
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap_or(f64::INFINITY);
    for capacity in &capacities {
        let same_scan =
            |run: &&BTreeMap<String, String>| ["case", "motion"].iter().all(|k| run[*k] == capacity[*k]);
        let own: Vec<_> = runs.iter().filter(same_scan).collect();
        let fell: Vec<f64> = own
            .iter()
            .filter(|run| run["outcome"] == "fell")
            .map(|run| number(run, "scale"))
            .collect();
        let first = fell.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!(number(capacity, "first_fall_scale"), first);
        let above = own
            .iter()
            .filter(|run| run["outcome"] != "fell" && number(run, "scale") > first)
            .count();
        assert_eq!(capacity["survived_above"], above.to_string());
        let refined = own
            .iter()
            .filter(|run| number(run, "scale").fract() != 0.0)
            .count();
        assert_eq!(refined, if first.is_finite() { 2 } else { 0 });
        assert!(
            own.iter()
                .all(|run| (run["outcome"] == "fell") == (run["damage_state"] == "4"))
        );
    }
    // a more slender stone falls sooner: the trend is printed
    let printed = scratch.dolmen("study . --study height -o out");
    assert!(
        printed
            .words()
            .contains("blocks[2].height: the capacity falls with it: holds (τ = −"),
        "{}",
        printed.stdout
    );
    let json = scratch.dolmen("study . --study height -o out --json");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(value["trends"][0]["verdict"], "holds");
    assert_eq!(value["inputs"][0]["column"], "blocks_2_height_m");
    assert_eq!(value["runs"], runs.len());
    for figure in ["capacity-blocks_2_height_m.svg", "survived-blocks_2_height_m.svg"] {
        assert!(
            fs::read_to_string(folder.join(figure))
                .unwrap()
                .starts_with("<svg"),
            "{figure}"
        );
    }
}

#[test]
fn holds_samples_depend_on_the_seed_and_their_number_alone() {
    let scratch = with("drawn", TWO_STONES);
    assert_eq!(scratch.dolmen("study . --study drawn -o three").status, 0);
    let more = TWO_STONES.replace("samples = 3", "samples = 5");
    fs::write(scratch.path().join("project.toml"), &more).unwrap();
    assert_eq!(scratch.dolmen("study . --study drawn -o five").status, 0);
    let of = |folder: &str| rows(&scratch.path().join(folder).join("drawn/runs.csv"));
    let (three, five) = (of("three"), of("five"));
    assert_eq!(three[..], five[..3]);
    let frictions: Vec<f64> = five
        .iter()
        .map(|row| row["drawn_joint_friction"].parse().unwrap())
        .collect();
    assert!(
        frictions.windows(2).all(|pair| pair[0] != pair[1]),
        "{frictions:?}"
    );
    assert!(
        frictions.iter().all(|value| (0.4..1.1).contains(value)),
        "{frictions:?}"
    );
    fs::write(
        scratch.path().join("project.toml"),
        more.replace("samples = 5", "samples = 5\nseed = 2"),
    )
    .unwrap();
    assert_eq!(scratch.dolmen("study . --study drawn -o other").status, 0);
    assert_ne!(of("other"), five);
}

#[test]
fn holds_a_refused_run_is_a_row_with_its_reason() {
    let scratch = with("refused", TWO_STONES);
    let answer = scratch.dolmen("study . --study refused -o out");
    assert_eq!(answer.status, 3, "{}{}", answer.stdout, answer.stderr);
    for said in [
        "1 stood",
        "3 refused",
        "joint.friction = -1 cannot be, must be 0 or above",
        "3 of 4 scans cannot be used and are in no quantile and no trend",
        "Scan 2 (joint.friction = 0.5, blocks[2].height = 60 m): its inputs were refused",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    let text = fs::read_to_string(scratch.path().join("out/refused/runs.csv")).unwrap();
    assert_eq!(
        text.lines().filter(|line| line.contains(",refused,")).count(),
        3,
        "{text}"
    );
    assert!(scratch.dolmen("study missing . --study refused -o out").status == 0);
    let level = |value: &str| {
        let found = |line: &&str| line.contains(value) && line.contains("unusable");
        let line = answer.stdout.lines().find(found);
        line.unwrap().split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert!(
        level("joint.friction = -1").contains("-1 0 of 2 – unusable – –"),
        "{}",
        level("joint.friction = -1")
    );
    let capacities = rows(&scratch.path().join("out/refused/capacities.csv"));
    let verdicts: Vec<&str> = capacities.iter().map(|row| row["verdict"].as_str()).collect();
    assert_eq!(verdicts, ["beyond", "refused", "refused", "refused"]);
    assert!(capacities.iter().all(|row| row["first_fall_m_s2"].is_empty()));
    // if all inputs are refused, the answer gives only the reason; later studies still run
    let text = TWO_STONES.replace("[0.5, -1]", "[-1, -2]")
        + "\n[study.last]\nmotions = [\"el-centro-1940-ns\"]\nscale = [0.1]\npoints = 4\n";
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let both = scratch.dolmen("study . --study refused --study last -o both");
    assert_eq!(both.status, 2, "{}", both.stdout);
    assert!(both.stderr.contains("must be 0 or above"), "{}", both.stderr);
    assert!(both.stdout.contains("Study: last"), "{}", both.stdout);
}

#[test]
fn holds_results_say_how_they_were_computed_and_few_scans_have_no_tails() {
    let scratch = with("method", TWO_STONES);
    let answer = scratch.dolmen("study . --study drawn -o out");
    assert_eq!(answer.status, 0, "{}{}", answer.stdout, answer.stderr);
    let method = format!(
        "springs law, 4 contact points a joint, which make joints three times as stiff in rocking as faces are: capacities come out too large, 2 s after the motion, first fall to 1/8 of a step, samples from seed 1, noise from seed 1, \
         Dolmen {}",
        env!("CARGO_PKG_VERSION")
    );
    let note = "normal_stiffness 1e9 Pa/m";
    let figure = fs::read_to_string(scratch.path().join("out/drawn/capacity-all.svg")).unwrap();
    // its lines wrap
    let figure: Vec<&str> = figure
        .split(['<', '>'])
        .filter(|part| !part.contains("text"))
        .collect();
    let figure = figure.concat().split_whitespace().collect::<Vec<_>>().join(" ");
    for said in [
        method.as_str(),
        note,
        "5 % and 95 % are said of 20 scans and more",
    ] {
        assert!(answer.words().contains(said), "{said}: {}", answer.stdout);
    }
    for said in ["4 contact points a joint", note, "Dolmen"] {
        assert!(figure.contains(said), "{said}: {figure}");
    }
    let json = scratch.dolmen("study . --study drawn -o out --json");
    let value: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(value["law"], "springs");
    assert_eq!(value["contact_points_a_joint"], 4);
    assert_eq!((&value["rest_s"], &value["halvings"]), (&2.0.into(), &3.into()));
    assert_eq!(value["version"], env!("CARGO_PKG_VERSION"));
    assert!(value["notes"][0].as_str().unwrap().contains(note));
    let level = &value["levels"][0];
    assert_eq!((&level["scans"], &level["scans_usable"]), (&3.into(), &3.into()));
    assert!(level["first_fall_q05_m_s2"].is_null() && level["first_fall_q05_above_m_s2"].is_null());
    assert!(level["first_fall_median_m_s2"].is_number() || level["first_fall_median_above_m_s2"].is_number());
}

#[test]
fn refuses_what_is_no_study_and_journals_of_another() {
    let scratch = with("wrong", TWO_STONES);
    let refused = |words: &str, said: &str| {
        let answer = scratch.dolmen(words);
        assert_eq!(answer.status, 2, "{words}: {}{}", answer.stdout, answer.stderr);
        assert!(answer.stderr.contains(said), "{words}: {}", answer.stderr);
    };
    refused(
        "study . --study none",
        "there is no study \"none\": the file has height, drawn, refused",
    );
    refused("study merge . --study drawn -o empty", "there is no journal in");
    assert_eq!(scratch.dolmen("study . --study drawn -o out").status, 0);
    let file = scratch.path().join("project.toml");
    fs::write(
        &file,
        TWO_STONES
            .replace("# ", "")
            .replace("0.9 }]", "0.9 }] # a remark"),
    )
    .unwrap();
    assert_eq!(
        scratch.dolmen("study . --study drawn -o out").status,
        0,
        "a remark changes nothing"
    );
    fs::write(&file, TWO_STONES.replace("density = 2600", "density = 2500")).unwrap();
    refused(
        "study . --study drawn -o out",
        "changed since then: the project file",
    );
    assert_eq!(scratch.dolmen("study . --study drawn -o out --restart").status, 0);
    let journal = fs::File::open(scratch.path().join("out/drawn/journal.tsv")).unwrap();
    journal.try_lock().unwrap();
    refused("study . --study drawn -o out", "is in use");
    drop(journal);
    refused(
        "study merge . --study drawn -o out --from nowhere",
        "--from nowhere has no journal",
    );
    for (from, to, said) in [
        ("scale = [4]", "scale = [4, 3]", "does not rise"),
        (
            "scale = [4]",
            "scale = [4]\npeak = [\"1 g\"]",
            "has both scale and peak",
        ),
        ("scale = [4]", "", "says not how the shaking grows"),
        ("samples = 3", "samples = 0", "must be 1 to"),
        (
            "points = 4\n\n[study.refused]",
            "points = 5\n\n[study.refused]",
            "must be 4, 9, 16 or 36",
        ),
        (
            "samples = 3",
            "vary = { \"blocks[3].height\" = [1] }",
            "blocks has no element \"3\"",
        ),
        (
            "samples = 3",
            "vary = { \"blocks[2].heigth\" = [1] }",
            "did you mean \"height\"?",
        ),
        ("samples = 3", "vary = { \"density\" = 3 }", "is one value"),
        (
            "samples = 3",
            "vary = { \"density\" = { from = 1, to = \"2 t/m3\", steps = 2 } }",
            "same unit",
        ),
        (
            "samples = 3",
            "motions = [\"none\"]",
            "there is no motion \"none\"",
        ),
        (
            "samples = 3",
            "expect = [{ input = \"density\", trend = \"rising\" }]",
            "is not varied",
        ),
        ("samples = 3", "expekt = 1", "did you mean \"expect\"?"),
        (
            "samples = 3",
            "set = { \"blocks[2].height\" = 0.9 }\nvary = { \"blocks[2].height\" = [1] }",
            "set and vary has blocks[2].height twice",
        ),
        (
            "samples = 3",
            "vary = { \"blocks[2].height\" = [1, 2, 1] }",
            "vary.blocks[2].height has 1 twice",
        ),
        (
            "samples = 3",
            "motions = [\"el-centro-1940-ns\", \"el-centro-1940-ns\"]",
            "has el-centro-1940-ns twice",
        ),
        (
            "samples = 3",
            "directions = [\"45 deg\", \"45 deg\"]",
            "has 45 deg twice",
        ),
        (
            "friction = { value = 0.7, cov = 0.1 }",
            "friction = 0.7",
            "no input has a cov",
        ),
        ("scale = [4]", "peak = [\"100 g\"]", "must be 10 g or below"),
        ("samples = 3", "direction = \"x\"", "direction is for frames"),
    ] {
        let changed = TWO_STONES.replace(from, to);
        assert_ne!(changed, TWO_STONES, "{from}");
        fs::write(&file, changed).unwrap();
        let _ = fs::remove_dir_all(scratch.path().join("fresh"));
        refused("study . --study drawn -o fresh", said);
    }
}
