// SOURCE     Project files, records and folders from strangers, and mistakes.
// GOAL       Measured files are never replaced, nothing is written or read outside, no run is endless, no error quotes a private file.
// TOLERANCE  none: files, words and exit statuses.

use super::verbs::{Answer, Scratch};
use std::fs;

const SURVEY: &str =
    "schema = 1\nkind = \"survey\"\nname = \"Tower\"\n[survey.one.records]\nfile = \"record.csv\"\n";

/// Two sines and a little noise, 60 s at 50 Hz.
fn record() -> String {
    let mut text = "time,a,b\n".to_owned();
    let mut seed = 1u64;
    for sample in 0..3000 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let noise = (seed >> 40) as f64 / 1e7 - 0.8;
        let t = sample as f64 / 50.0;
        let x = (2.0 * std::f64::consts::TAU * t).sin() + noise;
        text += &format!("{t:.2},{x:.5},{:.5}\n", 0.5 * x + 0.1 * noise);
    }
    text
}

fn tower(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::write(scratch.path().join("project.toml"), SURVEY).unwrap();
    fs::write(scratch.path().join("record.csv"), record()).unwrap();
    scratch
}

pub(super) fn refused(answer: &Answer, why: &str) {
    assert_eq!(answer.status, 2, "{}{}", answer.stdout, answer.stderr);
    assert!(answer.stderr.contains(why), "{}", answer.stderr);
}

#[test]
fn refuses_to_write_over_what_was_measured_even_if_forced() {
    let scratch = tower("measured");
    let before = fs::read(scratch.path().join("record.csv")).unwrap();
    for more in ["", " --force"] {
        refused(
            &scratch.dolmen(&format!("report . -o record.csv{more}")),
            "it is never replaced",
        );
        refused(
            &scratch.dolmen(&format!("report . -o project.toml{more}")),
            "it is never replaced",
        );
    }
    assert_eq!(fs::read(scratch.path().join("record.csv")).unwrap(), before);
    let made = scratch.dolmen("motion --make ricker --period 0.5 --peak 0.3g --convert e.csv");
    assert_eq!(made.status, 0, "{}", made.stderr);
    refused(
        &scratch.dolmen("motion e.csv --convert e.csv --force"),
        "it is never replaced",
    );
    refused(
        &scratch.dolmen("motion y=e.csv --convert ./e.csv"),
        "it is never replaced",
    );
}

#[test]
fn holds_only_files_of_its_own_are_replaced_unless_forced() {
    let scratch = tower("own");
    let at = |name: &str| scratch.path().join(name);
    fs::write(at("mine.html"), "<p>mine</p>").unwrap();
    refused(
        &scratch.dolmen("report . -o mine.html"),
        "Dolmen did not write it",
    );
    assert_eq!(fs::read_to_string(at("mine.html")).unwrap(), "<p>mine</p>");
    assert_eq!(scratch.dolmen("report . -o mine.html --force").status, 0);
    assert_eq!(
        scratch.dolmen("report . -o mine.html --language ko").status,
        0,
        "its own by the mark"
    );

    fs::write(at("empty.html"), "").unwrap();
    assert_eq!(
        scratch.dolmen("report . -o empty.html").status,
        0,
        "nothing is lost"
    );

    let make = |period: &str| {
        scratch.dolmen(&format!(
            "motion --make ricker --period {period} --peak 0.3g --convert e.csv"
        ))
    };
    assert_eq!(make("0.5").status, 0);
    assert_eq!(make("0.6").status, 0, "its own by the list");
    let edited = format!("{}\n", fs::read_to_string(at("e.csv")).unwrap());
    fs::write(at("e.csv"), &edited).unwrap();
    refused(&make("0.7"), "was changed since");
    assert_eq!(fs::read_to_string(at("e.csv")).unwrap(), edited);

    assert_eq!(scratch.dolmen("identify . -o out").status, 0);
    assert_eq!(scratch.dolmen("identify . -o out").status, 0);
    fs::write(at("out/identification.json"), "{}").unwrap();
    refused(&scratch.dolmen("identify . -o out"), "identification-2.json");
    assert_eq!(fs::read_to_string(at("out/identification.json")).unwrap(), "{}");
    assert!(
        fs::read(at("out/identification-2.json")).unwrap().len() > 100,
        "nothing computed is lost"
    );
}

#[test]
fn refuses_a_journal_that_is_none_even_to_restart() {
    let scratch = Scratch::new("journal");
    fs::write(scratch.path().join("project.toml"), STUDIED.replace("NAME", "s")).unwrap();
    fs::create_dir_all(scratch.path().join("studies/s")).unwrap();
    fs::write(scratch.path().join("studies/s/journal.tsv"), "my notes\n").unwrap();
    refused(
        &scratch.dolmen("study . --restart"),
        "is no journal of a study, and stays",
    );
    assert_eq!(
        fs::read_to_string(scratch.path().join("studies/s/journal.tsv")).unwrap(),
        "my notes\n"
    );
}

/// A block with a study.
const STUDIED: &str = "schema = 1\nkind = \"stack\"\nname = \"Block\"\n\
    units = { length = \"mm\" }\ndensity = 2600\n\
    joint = { friction = 0.5, normal_stiffness = \"1e9 Pa/m\", shear_stiffness = \"4e8 Pa/m\", damping_ratio = 0.3 }\n\
    blocks = [{ name = \"stone\", width = 600, depth = 400, height = 1000 }]\n\
    [study.\"NAME\"]\nartificial = { count = 1 }\npeak = { from = \"0.05 g\", to = \"0.1 g\", steps = 2 }\n";

#[test]
fn holds_names_of_parts_do_not_become_paths() {
    let scratch = Scratch::new("names");
    let inner = scratch.path().join("inner");
    fs::create_dir_all(&inner).unwrap();
    let outside = scratch.path().join("abs");
    for name in [
        "../../x",
        &outside.display().to_string(),
        "con",
        "a/../../b",
        "..",
    ] {
        fs::write(inner.join("project.toml"), STUDIED.replace("NAME", name)).unwrap();
        let answer = scratch.dolmen("study inner -o inner/results");
        assert!(answer.status == 0, "{name}: {}{}", answer.stdout, answer.stderr);
    }
    let names = |folder: &std::path::Path| -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> = entries
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    };
    assert_eq!(names(scratch.path()), ["inner"], "nothing beside the folder");
    assert_eq!(names(&inner), ["project.toml", "results"]);
    let results = names(&inner.join("results"));
    assert!(
        results.len() == 5 && results.contains(&"%63on".to_owned()),
        "{results:?}"
    );
}

#[test]
fn holds_the_name_of_a_damper_does_not_become_a_path() {
    let scratch = Scratch::new("damper");
    let text = include_str!("../../../../examples/several_dampers/project.toml");
    fs::create_dir_all(scratch.path().join("inner")).unwrap();
    let file = scratch.path().join("inner/project.toml");
    fs::write(&file, text.replace("damper.tank", "damper.\"../../x\"")).unwrap();
    let answer = scratch.dolmen("tune inner -o inner/out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    assert!(scratch.path().join("inner/out/%2E.%2F..%2Fx/tune.json").is_file());
    assert_eq!(
        fs::read_dir(scratch.path()).unwrap().count(),
        1,
        "nothing beside the folder"
    );
}

#[test]
fn refuses_files_outside_the_folder_of_the_project() {
    let scratch = Scratch::new("outside");
    let inner = scratch.path().join("inner");
    fs::create_dir_all(&inner).unwrap();
    fs::write(scratch.path().join("private.csv"), record()).unwrap();
    let absolute = scratch.path().join("private.csv").display().to_string();
    let mut names = vec![
        "../private.csv".to_owned(),
        absolute,
        "x/../../private.csv".to_owned(),
        "..\\private.csv".to_owned(),
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(scratch.path().join("private.csv"), inner.join("link.csv")).unwrap();
        names.push("link.csv".to_owned());
    }
    for name in &names {
        fs::write(
            inner.join("project.toml"),
            SURVEY.replace("record.csv", &name.replace('\\', "\\\\")),
        )
        .unwrap();
        for verb in ["identify inner", "report inner -o page.html"] {
            let answer = scratch.dolmen(verb);
            assert!(
                answer.stderr.contains("lies outside the folder of the project")
                    || answer.stdout.contains("page.html"),
                "{name}: {}",
                answer.stderr
            );
            assert!(
                !answer.stderr.contains("time,a,b") && answer.status != 1,
                "{}",
                answer.stderr
            );
        }
        let page = fs::read_to_string(scratch.path().join("page.html")).unwrap_or_default();
        assert!(!page.contains("time,a,b"), "{name}");
    }
    fs::write(
        inner.join("project.toml"),
        SURVEY.replace("record.csv", "../private.csv"),
    )
    .unwrap();
    let allowed = scratch.dolmen("identify inner --allow-outside");
    assert_eq!(allowed.status, 0, "{}", allowed.stderr);
    // the same for meshes, tables of a site and motions
    let mesh = "schema = 1\nkind = \"stack\"\nname = \"a\"\nblocks = [{ name = \"b\", shape = \"mesh\", file = \"../private.csv\", density = \"2600 kg/m3\" }]\n";
    fs::write(inner.join("project.toml"), mesh).unwrap();
    refused(
        &scratch.dolmen("check inner"),
        "lies outside the folder of the project",
    );
    let motion = STUDIED
        .replace("NAME", "s")
        .replace("artificial = { count = 1 }", "motions = [\"m\"]");
    let motion = format!("{motion}[motion.m]\nfiles = {{ x = \"../private.csv\" }}\nunit = \"g\"\n");
    fs::write(inner.join("project.toml"), motion).unwrap();
    refused(
        &scratch.dolmen("study inner"),
        "lies outside the folder of the project",
    );
    refused(
        &scratch.dolmen("simulate inner --motion m"),
        "lies outside the folder of the project",
    );
    fs::write(scratch.path().join("list.csv"), "name,project\na,../inner\n").unwrap();
    let ranked = scratch.dolmen("rank list.csv");
    assert!(
        ranked.status == 2 || ranked.stdout.contains("outside the folder"),
        "{}{}",
        ranked.stdout,
        ranked.stderr
    );
}

#[cfg(unix)]
#[test]
fn refuses_what_never_ends() {
    let scratch = Scratch::new("endless");
    for verb in [
        "check /dev/zero",
        "motion /dev/zero",
        "identify /dev/zero",
        "rank /dev/zero",
        "report /dev/zero",
    ] {
        refused(
            &scratch.dolmen(verb),
            "is a device, but only regular files are read",
        );
    }
    fs::write(scratch.path().join("large.toml"), vec![b'#'; 5 << 20]).unwrap();
    refused(&scratch.dolmen("check large.toml"), "at most 4194304 are read");
    refused(&scratch.dolmen("check large.toml --largest-file 6MB"), "error");
}

#[test]
fn holds_a_line_of_thousands_of_faults_is_told_in_a_page() {
    let scratch = Scratch::new("faults");
    let links = "{ weigth = 1, lenght = 2 }, ".repeat(8000);
    let text =
        format!("schema = 1\nkind = \"chain\"\nname = \"a\"\nlinks = [{links}]\njoints = \"unknown\"\n");
    fs::write(scratch.path().join("project.toml"), text).unwrap();
    let answer = scratch.dolmen("check .");
    refused(&answer, "problems more");
    assert!(answer.stderr.len() < 20_000, "{} bytes", answer.stderr.len());
    let widest = answer.stderr.lines().map(|line| line.chars().count()).max();
    assert!(widest.is_some_and(|width| width < 1200), "{widest:?}");
}

/// An archive with these parts; the last is followed by zeros_mib MiB of zeros.
fn packed(parts: &[(&str, &str)], zeros_mib: usize) -> Vec<u8> {
    use std::io::Write as _;
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let zeros = vec![0; 1 << 20];
    for (at, (name, text)) in parts.iter().enumerate() {
        archive
            .start_file(*name, zip::write::SimpleFileOptions::default())
            .unwrap();
        archive.write_all(text.as_bytes()).unwrap();
        if at + 1 == parts.len() {
            (0..zeros_mib).for_each(|_| archive.write_all(&zeros).unwrap());
        }
    }
    archive.finish().unwrap().into_inner()
}

#[test]
fn refuses_bombs_of_every_packed_format() {
    let scratch = Scratch::new("bombs");
    let bomb = packed(&[("a.npy", "\u{7f}NUMPY")], 130);
    assert!(bomb.len() < 1 << 20);
    let mut gzip = vec![0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3];
    gzip.extend_from_slice(&bomb[40..]);
    // NPZ, gz, zip and Parquet are not read as records, whether recognised by name or by content
    for (name, bytes, why) in [
        ("r.npz", &bomb, "write format = one of"),
        ("r.zip", &bomb, "write format = one of"),
        ("r.npy", &bomb, "this is no NPY file"),
        ("r.csv", &bomb, "the workbook unpacks to more than 16 MiB"),
        ("r.xlsx", &bomb, "the workbook unpacks to more than 16 MiB"),
        ("r.csv.gz", &gzip, "write format = one of"),
        (
            "r.parquet",
            &b"PAR1\x15\x04\x15PAR1".to_vec(),
            "write format = one of",
        ),
    ] {
        fs::write(scratch.path().join(name), bytes).unwrap();
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"x\"\n[survey.\"2024-05-01\".records]\nfile = \"{name}\"\nsampling_rate = \"100 Hz\"\n"
        );
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        refused(&scratch.dolmen("identify ."), why);
    }
    // tables of parts, and the form of the score
    let ods = |row: &str| {
        let text = format!(
            "<?xml version=\"1.0\"?><office:document-content xmlns:office=\"urn:oasis:names:tc:opendocument:xmlns:office:1.0\" \
             xmlns:table=\"urn:oasis:names:tc:opendocument:xmlns:table:1.0\" xmlns:text=\"urn:oasis:names:tc:opendocument:xmlns:text:1.0\">\
             <office:body><office:spreadsheet><table:table table:name=\"a\">{row}</table:table></office:spreadsheet></office:body>\
             </office:document-content>"
        );
        let manifest = "<?xml version=\"1.0\"?><manifest:manifest xmlns:manifest=\"urn:oasis:names:tc:opendocument:xmlns:manifest:1.0\"/>";
        packed(
            &[
                ("mimetype", "application/vnd.oasis.opendocument.spreadsheet"),
                ("META-INF/manifest.xml", manifest),
                ("content.xml", &text),
            ],
            0,
        )
    };
    let repeated = |rows: usize, columns: usize| {
        ods(&format!(
            "<table:table-row table:number-rows-repeated=\"{rows}\"><table:table-cell table:number-columns-repeated=\"{columns}\" \
             office:value-type=\"float\" office:value=\"1\"><text:p>1</text:p></table:table-cell></table:table-row>"
        ))
    };
    let many = "<table:table table:name=\"b\"><table:table-row table:number-rows-repeated=\"9000\"><table:table-cell \
                table:number-columns-repeated=\"200\" office:value-type=\"float\" office:value=\"1\"/></table:table-row></table:table>";
    for (name, bytes, why) in [
        (
            "t.ods",
            packed(&[("content.xml", "<a/>")], 130),
            "unpacks to more than 16 MiB",
        ),
        ("t.xlsx", bomb.clone(), "unpacks to more than 16 MiB"),
        (
            "t.ods",
            repeated(20_000, 1000),
            "has 20000 rows and 1000 columns, but at most 10000 and 256 are read",
        ),
        ("t.ods", repeated(1_048_576, 1), "has 1048576 rows and 1 columns"),
        (
            "t.ods",
            repeated(1, 4_000_000_000),
            "has 1 rows and 4000000000 columns",
        ),
        (
            "t.ods",
            ods(&format!(
                "</table:table>{many}{many}<table:table table:name=\"c\">"
            )),
            "has 9000 rows and 200 columns",
        ),
    ] {
        fs::write(scratch.path().join(name), bytes).unwrap();
        let text = format!(
            "schema = 1\nkind = \"stack\"\nname = \"x\"\ndensity = 2600\n\
             joint = {{ friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }}\nblocks = {{ file = \"{name}\" }}\n"
        );
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        refused(&scratch.dolmen("check ."), why);
    }
    fs::write(scratch.path().join("form.xlsx"), &bomb).unwrap();
    refused(&scratch.dolmen("score form.xlsx"), "unpacks to more than 16 MiB");
}
