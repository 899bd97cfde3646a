// SOURCE     Our own sentences.
// GOAL       Errors about a record, a motion, a mesh, a table or a flag are in Korean, without an English sentence.
// TOLERANCE  Keys, file names, values, units and commands stay as they are. Errors of other libraries are in English; none occurs here.

use super::english::english_in;
use super::verbs::Scratch;
use std::fmt::Write as _;
use std::fs;

/// A file of a folder with its bytes.
type Bytes = Vec<u8>;

fn rows(count: usize, row: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for i in 0..count {
        let _ = writeln!(text, "{}", row(i));
    }
    text
}

fn npy(header: &str, values: usize) -> Bytes {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(std::iter::repeat_n(0_u8, 8 * values));
    bytes
}

/// A survey with one record: its file, and its keys in the project.
fn of_record(file: &str, more: &str) -> String {
    format!(
        "schema = 1\nkind = \"survey\"\nname = {{ ko = \"조사\" }}\n[survey.one.records]\nfile = \"{file}\"\n{more}\n"
    )
}

/// Records that cannot be read.
fn broken_records() -> Vec<(&'static str, Bytes, &'static str)> {
    let text = |text: &str| text.as_bytes().to_vec();
    let rate = "sampling_rate = \"100 Hz\"";
    let table = rows(50, |i| format!("{:.2},{}", i as f64 / 100.0, i % 7));
    let header = |shape: &str, kind: &str| {
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n")
    };
    vec![
        ("empty.csv", Vec::new(), rate),
        ("names.csv", text("time,x\n"), rate),
        ("utf16.csv", b"\xff\xfet\0i\0m\0e\0".to_vec(), rate),
        ("letter.csv", text("Dear Ann,\nthe gate\nis open\n"), rate),
        (
            "word.csv",
            text(&format!("time,x\n{table}0.50,abc\n0.51,1\n")),
            "",
        ),
        ("hole.csv", text(&format!("time,x\n{table}0.50,\n0.51,1\n")), ""),
        ("nan.csv", text(&format!("time,x\n{table}0.50,nan\n0.51,1\n")), ""),
        (
            "ragged.csv",
            text(&format!("time,x\n{table}0.50,1,2\n0.51,1\n")),
            "",
        ),
        ("jump.csv", text(&format!("time,x\n{table}0.70,1\n0.71,1\n")), ""),
        (
            "norate.csv",
            text(&rows(50, |i| format!("{},{}", i * i % 11, i % 7))),
            "",
        ),
        (
            "rate.csv",
            text(&format!("time,x\n{table}")),
            "sampling_rate = \"200 Hz\"",
        ),
        (
            "column.csv",
            text(&format!("time,x\n{table}")),
            "channels = [{ column = \"y\", name = \"y\" }]",
        ),
        (
            "number.csv",
            text(&format!("time,x\n{table}")),
            "channels = [{ column = 7, name = \"y\" }]",
        ),
        ("rises.csv", text(&format!("a,b\n{table}")), rate),
        ("none.npy", npy("nothing", 0), rate),
        ("short.npy", npy(&header("(99,)", "<f8"), 3), rate),
        ("type.npy", npy(&header("(3,)", "<c16"), 6), rate),
        ("axes.npy", npy(&header("(1, 1, 3)", "<f8"), 3), rate),
        ("norate.npy", npy(&header("(50,)", "<f8"), 50), ""),
        ("cut.wav", b"RIFF\xff\xff\0\0WAVEfmt ".to_vec(), rate),
        ("cut.mat", b"MATLAB 5.0 MAT-file".to_vec(), rate),
        (
            "open.saf",
            text("SESAME ASCII data format (saf) v. 1\nSAMP_FREQ = x\n"),
            rate,
        ),
        ("cut.uff", text("    -1\n    58\n"), rate),
        (
            "format.csv",
            text(&format!("time,x\n{table}")),
            "format = \"tdms\"",
        ),
    ]
}

/// Files of ground motions that cannot be read.
fn broken_motions() -> Vec<(&'static str, Bytes, &'static str)> {
    let text = |text: &str| text.as_bytes().to_vec();
    let at2 = |head: &str, unit: &str| {
        format!("A\nB\nACCELERATION TIME SERIES IN UNITS OF {unit}\n{head}\n 1 2 3\n")
    };
    let table = rows(50, |i| format!("{:.2},{}", i as f64 / 100.0, i % 7));
    vec![
        ("head.at2", text(&at2("4000 points", "G")), ""),
        ("count.at2", text(&at2("NPTS= 4000, DT= .0100 SEC", "G")), ""),
        (
            "velocity.at2",
            text("A\nB\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 3, DT= .0100 SEC\n 1 2 3\n"),
            "",
        ),
        ("unit.csv", text(&format!("time,x\n{table}")), ""),
        ("peak.csv", text(&format!("time,x\n{table}")), "--unit km/s2"),
        ("large.csv", text(&format!("time,x\n{table}")), "--unit g"),
        (
            "columns.csv",
            text(&format!(
                "time,x,y\n{}",
                rows(50, |i| format!("{:.2},1,{i}", i as f64 / 100.0))
            )),
            "--unit gal",
        ),
        (
            "channel.csv",
            text(&format!("time,x\n{table}")),
            "--unit gal --channel z",
        ),
        (
            "knet.ns",
            text("Origin Time       2024/01/01 16:10:00\nLat.  37\n"),
            "",
        ),
    ]
}

/// Meshes that cannot be read.
fn broken_meshes() -> Vec<(&'static str, Bytes)> {
    let text = |text: &str| text.as_bytes().to_vec();
    vec![
        ("none.obj", text("hello\n")),
        ("cloud.obj", text("v 0 0 0\nv 1 0 0\nv 0 1 0\n")),
        ("vertex.obj", text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")),
        ("two.obj", text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n")),
        ("word.obj", text("v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n")),
        (
            "hole.obj",
            text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"),
        ),
        (
            "head.ply",
            text("ply\nformat ascii 1.0\nelement vertex x\nend_header\n"),
        ),
        (
            "cut.stl",
            text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
        ),
    ]
}

/// Commands that ask for something missing, or something that the kind does not have.
const ASKED: [&str; 26] = [
    "check nowhere.toml",
    "check examples",
    "check examples/naju_flagpole --push",
    "simulate examples/naju_flagpole --motion el-centro-1999 --variant wedged",
    "simulate examples/naju_flagpole --motion el-centro-1940-ns --variant wegded",
    "simulate examples/naju_flagpole --motion el-centro-1940-ns",
    "simulate examples/naju_flagpole --variant wedged",
    "simulate examples/naju_flagpole --variant wedged --push 1",
    "simulate examples/naju_flagpole --motion-file nowhere.at2 --variant wedged",
    "simulate examples/naju_flagpole --motion el-centro-1940-ns --variant wedged --law rigid",
    "simulate examples/naju_flagpole --motion el-centro-1940-ns --variant wedged --peak 0.3",
    "simulate examples/heunginjimun_gate --motion el-centro-1940-ns --direction z",
    "simulate examples/palisaden --motion el-centro-1940-ns",
    "check examples/piled_blocks --samples 9",
    "compare examples/palisaden",
    "compare examples/gate_through_the_seasons --from 1900 --to 2000",
    "watch examples/palisaden",
    "study run examples/naju_flagpole --study none",
    "study run examples/palisaden",
    "tune examples/naju_flagpole",
    "tune examples/twisting_floor --damper none",
    "score examples/piled_blocks",
    "rank examples/naju_flagpole",
    "draw examples/palisaden",
    "draw examples/naju_flagpole -o pole.jpg",
    "explain no-such-code",
];

/// English words in the error, or that it is not Korean at all.
fn fault_of(asked: &str, stderr: &str) -> Option<String> {
    let said: Vec<&str> = stderr.lines().filter(|line| !line.contains(" | ")).collect();
    let said = said.join(" ");
    let is_korean = said.chars().any(|sign| ('가'..='힣').contains(&sign));
    match english_in(&said) {
        Some(words) => Some(format!("{asked}: {words}: {stderr}")),
        None if !is_korean => Some(format!("{asked}: not Korean: {stderr}")),
        None => None,
    }
}

#[test]
fn holds_what_is_wrong_with_an_input_is_told_in_korean_without_an_english_sentence() {
    let scratch = Scratch::with_examples("korean_inputs");
    let mut asked = Vec::new();
    for (number, (file, bytes, more)) in broken_records().into_iter().enumerate() {
        fs::write(scratch.path().join(file), bytes).unwrap();
        let project = format!("record{number}.toml");
        fs::write(scratch.path().join(&project), of_record(file, more)).unwrap();
        asked.push((file, format!("identify {project}")));
    }
    for (file, bytes, flags) in broken_motions() {
        fs::write(scratch.path().join(file), bytes).unwrap();
        asked.push((file, format!("motion {file} {flags}")));
    }
    for (number, (file, bytes)) in broken_meshes().into_iter().enumerate() {
        fs::write(scratch.path().join(file), bytes).unwrap();
        let project = format!("mesh{number}.toml");
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = {{ ko = \"탑\" }}\njoint = {{ friction = 0.6, normal_stiffness = \"1 GPa/m\", shear_stiffness = \"1 GPa/m\" }}\n\
             blocks = [{{ name = \"돌\", shape = \"mesh\", file = \"{file}\", unit = \"m\", density = 2600 }}]\n"
        );
        fs::write(scratch.path().join(&project), text).unwrap();
        asked.push((file, format!("check {project}")));
    }
    asked.extend(ASKED.map(|words| ("", words.to_owned())));
    assert!(asked.len() > 60);
    let mut found = Vec::new();
    for (file, words) in &asked {
        let answer = scratch.dolmen(&format!("{words} --language ko"));
        if answer.stderr.contains("Usage:") {
            continue; // clap's errors are English
        }
        if answer.status != 2 {
            found.push(format!(
                "{words} ({file}): status {}: {}",
                answer.status, answer.stderr
            ));
        }
        found.extend(fault_of(&format!("{words} ({file})"), &answer.stderr));
    }
    assert!(
        found.is_empty(),
        "{} of {}\n{}",
        found.len(),
        asked.len(),
        found.join("\n")
    );
}
