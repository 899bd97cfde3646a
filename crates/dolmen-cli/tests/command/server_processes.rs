// SOURCE     docs/store.md, "For teams".
// GOAL       Acknowledged data are stored exactly once, whatever happens to processes and to the server.
// TOLERANCE  none: bytes, rows, words and exit statuses.

use super::followed::{gate_in, kill_follow_at_random_moments, made_record, names_in, put};
use super::servers::Server;
use super::store_processes::{
    acknowledged, acknowledged_of, adding, four_at_once, kill_at_random_moments, moments,
};
use super::stores::{content, good, json, project};
use super::verbs::Scratch;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn holds_a_killed_add_to_a_server_loses_nothing_and_stores_nothing_twice() {
    let Some(server) = Server::shared() else { return };
    kill_at_random_moments(
        &Scratch::new("server-kill"),
        &server.database("kill"),
        moments(20),
    );
}

#[test]
fn holds_a_killed_follow_into_a_server_loses_nothing_and_stores_nothing_twice() {
    let Some(server) = Server::shared() else { return };
    kill_follow_at_random_moments(
        &Scratch::new("server-follow-kill"),
        &server.database("follow_kill"),
        moments(20),
    );
}

#[test]
fn holds_four_processes_write_to_a_server_at_once_and_one_is_killed() {
    let Some(server) = Server::shared() else { return };
    four_at_once(&Scratch::new("server-four"), &server.database("four"));
}

#[test]
fn holds_four_processes_that_add_the_same_store_it_once() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-same");
    let store = server.database("same");
    let names: Vec<String> = (0..4).map(|at| format!("p{at}")).collect();
    names.iter().for_each(|name| project(&scratch, name, 2));
    let children: Vec<Child> = (0..4).map(|_| adding(scratch.path(), &store, &names)).collect();
    for child in children {
        let output = child.wait_with_output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(acknowledged(&output.stdout), names, "{said}");
    }
    content(&scratch, &store);
    let counts = server.sql(
        "same",
        "select (select count(*) from dolmen.structure), (select count(*) from dolmen.project), (select count(*) from dolmen.survey), \
         (select count(*) from dolmen.adoption), (select count(*) from dolmen.raw), (select count(*) from dolmen.raw_file)",
    );
    assert_eq!(counts, "4|4|8|4|12|12");
}

#[test]
fn refuses_to_write_while_another_process_does_and_reads_on() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-locked");
    project(&scratch, "a", 1);
    let store = super::servers::stored(&scratch, server, "locked_store", "a");
    // another process holds the writers' lock
    let mut other = Command::new("psql")
        .args(["-X", "-q", "-U", "postgres", "-d", "locked_store", "-h"])
        .arg(server.folder())
        .args([
            "-c",
            "begin; select pg_advisory_xact_lock(110429723256174); select pg_sleep(30)",
        ])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let held = "select count(*) from pg_locks where locktype = 'advisory' and granted and database = (select oid from pg_database where \
                datname = 'locked_store')";
    while server.sql("locked_store", held) == "0" {
        std::thread::sleep(Duration::from_millis(20));
    }
    project(&scratch, "b", 1);
    super::stores::refused(
        &scratch.briefly(&format!("survey add b {store} --without-modes --wait 0.2")),
        "Another process is writing",
    );
    good(scratch.briefly(&format!("survey list {store}")));
    other.kill().unwrap();
    other.wait().unwrap();
    server.sql(
        "postgres",
        "select pg_terminate_backend(pid) from pg_stat_activity where datname = 'locked_store'",
    );
    good(scratch.briefly(&format!("survey add b {store} --without-modes")));
    content(&scratch, &store);
}

/// A port that is free now.
pub(super) fn free_port() -> u16 {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    listener.local_addr().unwrap().port()
}

fn wait_for(what: &str, mut is_so: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < Duration::from_secs(60), "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn holds_a_follow_goes_on_when_the_server_was_restarted() {
    const FILES: usize = 6;
    let Some(server) = Server::start("restart", Some(free_port())) else {
        return;
    };
    let scratch = Scratch::new("server-restart");
    let port = server.port();
    server.sql("postgres", "create role kim login password 's3cr@t'");
    server.sql("postgres", "create database gate owner kim");
    // over TCP, with a password
    let store = format!("--store postgresql://kim:s3cr%40t@127.0.0.1:{port}/gate");
    gate_in(&scratch, &store);
    let child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args([
            "watch", "--follow", "in", "--every", "0.1", "--rest", "0.2", "--json",
        ])
        .args(["--taken", "done"])
        .args(store.split_whitespace())
        .current_dir(scratch.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let there = |from: usize, to: usize| {
        (from..to).all(|at| {
            scratch
                .path()
                .join(format!("done/2026-03-{:02}.csv", at + 1))
                .exists()
        })
    };
    for at in 0..FILES {
        let name = format!("in/2026-03-{:02}.csv", at + 1);
        put(&scratch.path().join(name), made_record(2.0, 6000, at as u64 + 2));
        if at == 1 {
            wait_for("the first records", || there(0, 1));
            server.control(&["-m", "immediate", "restart"]);
        }
        if at == 3 {
            // it stays down for some rounds
            server.control(&["-m", "immediate", "stop"]);
            std::thread::sleep(Duration::from_millis(600));
            server.control(&["-w", "start"]);
        }
    }
    wait_for("all records", || there(0, FILES));
    let sent = Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status()
        .unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(!said.contains("panicked") && !said.contains("s3cr"), "{said}");
    assert!(
        said.contains("ended while it was used") || said.contains("No server of PostgreSQL answers"),
        "{said}"
    );
    content(&scratch, &store);
    let kept = names_in(&scratch, &store);
    assert_eq!(kept.len(), FILES + 1, "{kept:?}");
    for name in acknowledged_of(&output.stdout, "survey") {
        assert_eq!(kept.iter().filter(|of| **of == name).count(), 1, "{name}");
    }
    let days = json(&scratch, &format!("watch --all {store}"));
    assert_eq!(days["structures"][0]["history"]["surveys"], FILES + 1);
}

#[test]
fn holds_two_that_follow_for_one_structure_see_what_the_other_stored() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-two");
    let store = server.database("two");
    gate_in(&scratch, &store);
    std::fs::create_dir_all(scratch.path().join("other")).unwrap();
    let child = Command::new(env!("CARGO_BIN_EXE_dolmen"))
        .args([
            "watch", "--follow", "in", "--every", "0.1", "--rest", "0.2", "--json", "--taken", "done",
        ])
        .args(store.split_whitespace())
        .current_dir(scratch.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    for day in 2..=3 {
        let name = format!("other/2026-01-{day:02}.csv");
        put(&scratch.path().join(name), made_record(2.0, 6000, day));
    }
    let other = scratch.briefly(&format!("watch --follow other {store} --once --quiet"));
    assert_eq!(other.status, 0, "{}{}", other.stdout, other.stderr);
    put(
        &scratch.path().join("in/2026-01-04.csv"),
        made_record(2.0, 6000, 20),
    );
    wait_for("the record", || {
        scratch.path().join("done/2026-01-04.csv").exists()
    });
    Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status()
        .unwrap();
    let output = child.wait_with_output().unwrap();
    // with only the surveys known at its start there would be two days with modes: too few
    let last: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&last["survey"], &last["verdict"]),
        (&"2026-01-04".into(), &"training".into()),
        "{last}"
    );
    content(&scratch, &store);
}
