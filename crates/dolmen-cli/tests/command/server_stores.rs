// SOURCE     docs/store.md, "For teams".
// GOAL       A store on a PostgreSQL server equals a store in a file: same rows, same answers, in both directions.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::servers::{Server, stored};
use super::stores::{FILE, below, content, good, json, project, refused};
use super::verbs::Scratch;
use serde_json::Value;
use std::fs;
use std::io::Read as _;
use std::process::{Command, Stdio};

/// Every printed answer of a store.
fn answers(scratch: &Scratch, store: &str, structures: &[&str]) -> Vec<String> {
    let mut all: Vec<String> = [
        "survey list --full",
        "survey list --surveys --csv",
        "survey list --json",
        "survey list --geojson",
        "watch --all --full",
        "watch --all --full --language ko",
        "watch --all --csv",
    ]
    .iter()
    .map(|words| {
        let answer = scratch.briefly(&format!("{words} {store}"));
        format!("{words}: {} {}{}", answer.status, answer.stdout, answer.stderr)
    })
    .collect();
    for name in structures {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "show", name, "--full", "--json"])
            .args(store.split_whitespace())
            .current_dir(scratch.path())
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        let mut kept: Value = serde_json::from_slice(&output.stdout).unwrap();
        kept["log"] = Value::Null; // each store has its own
        all.push(kept.to_string());
    }
    all
}

#[test]
fn holds_a_store_goes_to_a_server_and_back_unchanged() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::with_examples("server-back");
    good(scratch.briefly(&format!(
        "survey add examples/palisaden examples/naju_flagpole examples/gate_through_the_seasons examples/flagpole_over_the_years {FILE}"
    )));
    good(scratch.briefly(&format!(
        "survey add examples/pagoda_over_the_years {FILE} --name 석탑"
    )));
    // a database whose collation is not bytewise
    server.sql(
        "postgres",
        "create database back template template0 encoding 'UTF8' locale_provider icu icu_locale 'ko' locale 'C.UTF-8'",
    );
    let store = server.store("back", "postgres");
    let done = json(&scratch, &format!("survey import s.db {store}"));
    assert_eq!(done["structures"], 5, "{done}");
    let own = content(&scratch, FILE);
    assert_eq!(own, content(&scratch, &store));
    let names = [
        "Palisaden, an eight-storey timber building in Ås, Norway",
        "석탑",
        "A gate through the seasons (made up)",
        "A flagpole over the years (made up)",
    ];
    let (file, other) = (answers(&scratch, FILE, &names), answers(&scratch, &store, &names));
    for (own, other) in file.iter().zip(&other) {
        assert_eq!(own, other);
    }
    let again = json(&scratch, &format!("survey import s.db {store}"));
    assert_eq!(
        (again["new_rows"].as_u64(), again["new_files"].as_u64()),
        (Some(0), Some(0)),
        "{again}"
    );
    // back into a file, and into another database with the server's own programs
    good(scratch.briefly(&format!("survey export -o back.db {store}")));
    assert_eq!(own, content(&scratch, "--store back.db"));
    let dump = server.program("pg_dump", &["--format=custom", "back"]);
    fs::write(scratch.path().join("back.dump"), dump).unwrap();
    let restored = server.database("restored");
    server.program(
        "pg_restore",
        &[
            "--dbname=restored",
            &scratch.path().join("back.dump").display().to_string(),
        ],
    );
    assert_eq!(own, content(&scratch, &restored));
    // an exported project equals the stored one, and a file that somebody named by hand stays
    good(scratch.briefly(&format!("survey export 석탑 -o out {store}")));
    let text = |of: &str| fs::read(scratch.path().join(of).join("project.toml")).unwrap();
    assert_eq!(text("examples/pagoda_over_the_years"), text("out"));
    let [before, after] = ["examples/pagoda_over_the_years", "out"].map(|of| {
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["watch", ".", "--full"])
            .current_dir(scratch.path().join(of))
            .output()
            .unwrap();
        (output.status.code(), output.stdout)
    });
    assert_eq!(before, after);
    refused(
        &scratch.briefly(&format!(
            "survey export -o {} {FILE}",
            server.url("back", "postgres")
        )),
        "survey import STORE --store postgresql://",
    );
}

#[test]
fn holds_adding_listing_marking_and_verifying_are_those_of_a_file() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-verbs");
    let store = server.database("verbs");
    for at in [FILE, &store] {
        for (name, year) in [
            ("Gate 100%_sure", 2019),
            ("gate", 2020),
            ("Pagoda", 2021),
            ("석탑", 2022),
        ] {
            let text = format!(
                "schema = 1\nkind = \"survey\"\nname = {{ en = \"{name}\", ko = \"돌탑\" }}\n[site]\nlatitude_deg = 35.79\n\
                 longitude_deg = 129.332\n[survey.2020-05]\n[survey.{year}-11-03]\ntilt.x = \"1/200\"\nfrequencies.x = [2.0]\n"
            );
            fs::write(scratch.path().join("p.toml"), text).unwrap();
            good(scratch.briefly(&format!("survey add p.toml {at} --who kim")));
            let again = json(&scratch, &format!("survey add p.toml {at} --who kim"));
            assert_eq!(again["is_new_state"], false, "{again}");
        }
        good(scratch.briefly(&format!("survey remove gate {at} --why fallen --who lee")));
    }
    for words in [
        "survey list",
        "survey list --removed --csv",
        "survey list 0%_s --csv",
        "survey list --surveys --csv",
        "survey list pAGO --csv",
        "survey show Pagoda",
        "survey show Pogoda",
        "survey show Pagoda --survey x --language ko",
    ] {
        let [file, other] = [FILE, &store].map(|at| {
            let answer = scratch.briefly(&format!("{words} {at}"));
            let plain = |text: &str| -> String {
                let lines = text
                    .lines()
                    .filter(|line| !line.contains("20") || !line.contains(":"));
                lines.map(|line| format!("{line}\n")).collect()
            };
            (answer.status, plain(&answer.stdout), answer.stderr)
        });
        assert_eq!(file, other, "{words}");
    }
    good(scratch.briefly(&format!("survey remove gate {store} --undo")));
    content(&scratch, &store);
}

#[test]
fn holds_what_was_changed_or_lost_on_a_server_is_named() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-verify");
    project(&scratch, "a", 3);
    let store = stored(&scratch, server, "damaged", "a");
    content(&scratch, &store);
    let hashes = server.sql("damaged", "select hash from dolmen.raw_file order by hash");
    let hashes: Vec<&str> = hashes.lines().collect();
    assert_eq!(hashes.len(), 4);
    server.sql(
        "damaged",
        &format!(
            "update dolmen.raw_piece set bytes = set_byte(bytes, 20, get_byte(bytes, 20) # 1) where hash = '{}'; \
             delete from dolmen.raw_piece where hash = '{}'; delete from dolmen.raw_file where hash = '{1}'",
            hashes[0], hashes[1]
        ),
    );
    let unsound = scratch.briefly(&format!("survey verify --json {store}"));
    assert_eq!(unsound.status, 1, "{}", unsound.stderr);
    let found: Value = serde_json::from_str(&unsound.stdout).unwrap();
    let faults = found["faults"].as_array().unwrap();
    let kinds: Vec<&str> = faults.iter().map(|f| f["fault"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["changed", "missing"]);
    refused(
        &scratch.briefly(&format!("survey export a -o back {store}")),
        "is missing or was changed",
    );
    // adding it again restores what is missing
    good(scratch.briefly(&format!("survey add a {store} --without-modes")));
    let found = json(&scratch, &format!("survey verify {store}"));
    assert_eq!(found["faults"].as_array().unwrap().len(), 1, "{found}");
    // rows changed by another program, a dangling reference, and a column of another type
    server.sql(
        "damaged",
        "set session_replication_role = replica; update dolmen.project_file set path = 'x.csv' where path = 'record-0.csv'; \
         delete from dolmen.survey where name = '1951'; alter table dolmen.mark alter column why type varchar(9)",
    );
    let found = json(&scratch, &format!("survey verify {store}"));
    let all = found["faults"].to_string();
    for part in [
        "\"table\":\"project\"",
        "a row of record refers to one that is not there",
        "the table mark has other columns",
    ] {
        assert!(all.contains(part), "{part}: {all}");
    }
}

#[test]
fn holds_a_large_record_is_kept_in_pieces_and_nothing_larger_is_sent() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-large");
    project(&scratch, "a", 1);
    // 18 MiB of incompressible bytes
    let mut seed = 3;
    let noise: Vec<u8> = (0..18 << 17)
        .flat_map(|_| (below(&mut seed, 1 << 31) * below(&mut seed, 1 << 31)).to_le_bytes())
        .collect();
    fs::write(scratch.path().join("a/record-0.csv"), &noise).unwrap();
    let store = stored(&scratch, server, "large", "a");
    let pieces = server.sql(
        "large",
        "select count(*), max(octet_length(bytes)) from dolmen.raw_piece",
    );
    assert_eq!(pieces, format!("6|{}", 4 << 20));
    content(&scratch, &store);
    good(scratch.briefly(&format!("survey export a -o back {store}")));
    assert!(fs::read(scratch.path().join("back/record-0.csv")).unwrap() == noise);
}

#[cfg(target_os = "linux")]
#[test]
fn holds_memory_stays_flat_however_many_surveys_a_server_lists() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-many");
    fs::write(
        scratch.path().join("p.toml"),
        "schema = 1\nkind = \"survey\"\nname = \"many\"\n[survey.2020]\n",
    )
    .unwrap();
    let store = stored(&scratch, server, "many", "p.toml");
    let most_kib = |rows: usize| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "list", "--surveys", "--json"])
            .args(store.split_whitespace())
            .current_dir(scratch.path())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        // the pipe blocks it, so it runs until the last bytes are read
        let mut out = child.stdout.take().unwrap();
        let (mut bytes, mut buffer, mut most) = (0, [0; 65536], 0.0_f64);
        loop {
            let read = out.read(&mut buffer).unwrap();
            if read == 0 {
                break;
            }
            bytes += read;
            let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
            let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let kib = line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse().ok());
            most = most.max(kib.unwrap_or(0.0));
        }
        assert!(child.wait().unwrap().success() && bytes > rows * 50, "{bytes}");
        most
    };
    let grow = |from: usize, to: usize| {
        server.sql(
            "many",
            &format!(
                "with made as (insert into dolmen.survey (hash, structure, name) select lpad(i::text, 64, '0'), 'many', i::text \
                 from generate_series({from}, {to}) i returning hash, name) \
                 insert into dolmen.project_survey select (select hash from dolmen.project), i, lpad(i::text, 64, '0') \
                 from generate_series({from}, {to}) i; analyze"
            ),
        );
    };
    grow(2, 2_000);
    let few = most_kib(2_000);
    grow(2_001, 60_000);
    let many = most_kib(60_000);
    assert!(
        few > 0.0 && many < few + 4096.0,
        "{few} KiB for 2,000 surveys, {many} KiB for 60,000"
    );
}
