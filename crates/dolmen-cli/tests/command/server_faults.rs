// SOURCE     docs/store.md, "For teams".
// GOAL       The command gives the reason why a server refuses and what to do, in both languages and never with a password; names and texts
//            from strangers never act as SQL statements and never lead out of a folder.
// TOLERANCE  none: words, rows and exit statuses.

use super::server_processes::free_port;
use super::servers::{Server, stored};
use super::stores::{content, good, json, project, refused};
use super::verbs::{Answer, Scratch};
use std::fs;
use std::process::Command;

/// Must not appear in any answer.
const SECRET: &str = "s3cr3t";

/// Refused with these English words and those Korean ones, without a password.
fn refused_in_both(scratch: &Scratch, words: &str, english: &str, korean: &str) {
    for (language, why) in [("en", english), ("ko", korean)] {
        let answer = scratch.briefly(&format!("{words} --language {language}"));
        refused(&answer, why);
        assert!(!answer.stderr.contains(SECRET), "{}", answer.stderr);
    }
}

#[test]
fn refuses_addresses_that_cannot_be_read_or_ask_for_encryption() {
    let scratch = Scratch::new("server-address");
    for (at, english, korean) in [
        (
            "kim:s3cr3t/x@localhost/d",
            "cannot be read (password)",
            "읽을 수 없다(password)",
        ),
        (
            "kim:s3cr3t@localhost:x/d",
            "cannot be read (port)",
            "읽을 수 없다(port)",
        ),
        (
            "kim:s3cr3t@localhost/d?sslcert=x",
            "cannot be read (sslcert)",
            "읽을 수 없다(sslcert)",
        ),
        (
            "kim:s3cr3t@localhost/d?sslmode=verify-full",
            "sslmode=verify-full asks for an encrypted connection",
            "암호화된 연결을 요구한다",
        ),
        (
            "kim:s3cr3t@db.example.org/d",
            "db.example.org is another machine",
            "다른 컴퓨터이고 Dolmen은 TLS를 지원하지 않는다",
        ),
    ] {
        for verb in [
            "survey list --store",
            "survey add no-project --store",
            "survey verify --store",
            "survey import",
            "watch --all --store",
            "watch --follow no-folder --store",
        ] {
            let tail = if verb == "survey import" {
                " --store s.db"
            } else {
                ""
            };
            refused_in_both(
                &scratch,
                &format!("{verb} postgresql://{at}{tail}"),
                english,
                korean,
            );
        }
    }
    // an address where none belongs
    for words in [
        "survey verify postgresql://kim:s3cr3t@localhost/d",
        "watch postgresql://kim:s3cr3t@localhost/d",
        "survey add postgresql://kim:s3cr3t@localhost/d --store s.db",
        "check postgres://kim:s3cr3t@localhost/d",
        "survey export -o postgresql://kim:s3cr3t@localhost/d --store s.db",
    ] {
        let answer = scratch.briefly(words);
        assert_eq!(answer.status, 2, "{}", answer.stderr);
        assert!(!answer.stderr.contains(SECRET), "{}", answer.stderr);
    }
}

#[test]
fn refuses_a_server_that_is_not_there_and_one_that_refuses() {
    let scratch = Scratch::new("server-refused");
    project(&scratch, "a", 1);
    let closed = format!("postgresql://kim:{SECRET}@127.0.0.1:{}/d", free_port());
    refused_in_both(
        &scratch,
        &format!("survey add a --store {closed}"),
        "No server of PostgreSQL answers at postgresql://kim@127.0.0.1",
        "PostgreSQL 서버가 응답하지 않는다",
    );
    refused_in_both(
        &scratch,
        "survey list --store postgresql://kim:s3cr3t@/d?host=/no/such/folder",
        "No server of PostgreSQL answers at postgresql://kim@/d?host=/no/such/folder",
        "PostgreSQL 서버가 응답하지 않는다",
    );
    let Some(server) = Server::shared() else { return };
    refused_in_both(
        &scratch,
        &format!("survey add a {}", server.store("nowhere", "postgres")),
        "The server has no database postgresql://postgres@/nowhere",
        "데이터베이스 postgresql://postgres@/nowhere",
    );
    server.database("refusing");
    server.sql(
        "postgres",
        &format!("create role locked login password '{SECRET}'; grant all on database refusing to locked"),
    );
    let at = server.url("refusing", "locked");
    refused_in_both(
        &scratch,
        &format!("survey add a --store {}", at.replace("locked@", "locked:wr0ng@")),
        "The server refuses postgresql://locked@/refusing",
        "접속을 거부한다",
    );
    refused_in_both(
        &scratch,
        &format!("survey add a --store {at}"),
        "for a password and none is given: set PGPASSWORD",
        "PGPASSWORD를 설정하거나",
    );
    refused_in_both(
        &scratch,
        &format!("survey list --store {}", server.url("refusing", "nobody")),
        "The server refuses postgresql://nobody@/refusing",
        "접속을 거부한다",
    );
    // the password in the address, in the environment, and in a file that only its owner may read
    let run = |set: &dyn Fn(&mut Command)| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_dolmen"));
        command
            .args(["survey", "add", "a", "--without-modes", "--quiet", "--json"])
            .env("HOME", scratch.path())
            .env_remove("PGPASSWORD")
            .env("DOLMEN_STORE", &at)
            .current_dir(scratch.path());
        set(&mut command);
        Answer::of(&command.output().unwrap())
    };
    let with = at.replace("locked@", &format!("locked:{SECRET}@"));
    good(run(&|command| {
        command.env("DOLMEN_STORE", &with);
    }));
    good(run(&|command| {
        command.env("PGPASSWORD", SECRET);
    }));
    let file = scratch.path().join(".pgpass");
    fs::write(&file, format!("localhost:*:refusing:locked:{SECRET}\n")).unwrap();
    let set_mode = |mode: u32| {
        use std::os::unix::fs::PermissionsExt as _;
        fs::set_permissions(&file, fs::Permissions::from_mode(mode)).unwrap();
    };
    set_mode(0o644);
    refused(&run(&|_| ()), "which only you may read");
    set_mode(0o600);
    good(run(&|_| ()));
}

#[test]
fn refuses_what_a_role_may_not_do_and_lets_it_read() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-rights");
    project(&scratch, "a", 1);
    let store = stored(&scratch, server, "rights", "a");
    server.sql(
        "rights",
        "create role stranger login; create role reader login; create role writer login; \
         grant usage on schema dolmen to reader, writer; grant select on all tables in schema dolmen to reader, writer; \
         grant insert on all tables in schema dolmen to writer",
    );
    let of = |role: &str| server.store("rights", role);
    let before = content(&scratch, &store);
    for words in ["survey add a", "survey remove a", "watch --follow a"] {
        refused_in_both(
            &scratch,
            &format!("{words} {}", of("reader")),
            "lacks the right for this",
            "권한이 없거나",
        );
    }
    refused_in_both(
        &scratch,
        &format!("survey list {}", of("stranger")),
        "`grant usage on schema dolmen`",
        "`grant usage on schema dolmen`",
    );
    assert_eq!(before, content(&scratch, &of("reader")));
    good(scratch.briefly(&format!("survey show a {}", of("reader"))));
    good(scratch.briefly(&format!("survey export a -o back {}", of("reader"))));
    // writing needs only the right to add rows
    project(&scratch, "b", 1);
    good(scratch.briefly(&format!("survey add b --without-modes {}", of("writer"))));
    // a role that may not create the store
    server.database("bare");
    refused_in_both(
        &scratch,
        &format!("survey add a {}", server.store("bare", "reader")),
        "lacks the right for this",
        "권한이 없거나",
    );
    refused_in_both(
        &scratch,
        &format!("survey list {}", server.store("bare", "reader")),
        "There is no store in postgresql://reader@/bare",
        "저장소가 없다",
    );
    assert_eq!(
        server.sql(
            "bare",
            "select count(*) from pg_namespace where nspname = 'dolmen'"
        ),
        "0"
    );
    // a read-only server
    server.sql(
        "postgres",
        "alter role writer set default_transaction_read_only = on",
    );
    refused(
        &scratch.briefly(&format!("survey add b {}", of("writer"))),
        "read-only copy",
    );
}

#[test]
fn refuses_stores_of_later_versions_other_programs_and_encodings() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-later");
    project(&scratch, "a", 1);
    let store = stored(&scratch, server, "later", "a");
    server.sql("later", "update dolmen.schema_number set number = 99");
    for words in ["survey list", "survey add a", "watch --all"] {
        refused_in_both(
            &scratch,
            &format!("{words} {store}"),
            "later version of Dolmen made this store (schema 99",
            "더 새로운 버전의 Dolmen이 만든 저장소이다(스키마 99",
        );
    }
    // a writer updates an earlier schema; a reader may not
    server.sql(
        "later",
        "alter table dolmen.mode drop column is_accepted; update dolmen.schema_number set number = 2; create role old login; \
         grant usage on schema dolmen to old; grant select on all tables in schema dolmen to old",
    );
    refused(
        &scratch.briefly(&format!("survey list {}", server.store("later", "old"))),
        "lacks the right for this",
    );
    good(scratch.briefly(&format!("survey list {store}")));
    content(&scratch, &store);
    let foreign = server.database("foreign_schema");
    server.sql(
        "foreign_schema",
        "create schema dolmen; create table dolmen.stones (x text)",
    );
    refused_in_both(
        &scratch,
        &format!("survey add a {foreign}"),
        "holds tables of another program",
        "다른 프로그램의 테이블",
    );
    // tables of other programs are left alone
    let beside = server.database("beside");
    server.sql(
        "beside",
        "create table structure (x text); insert into structure values ('theirs')",
    );
    good(scratch.briefly(&format!("survey add a --without-modes {beside}")));
    assert_eq!(server.sql("beside", "select x from public.structure"), "theirs");
    assert_eq!(server.sql("beside", "select name from dolmen.structure"), "a");
    server.sql(
        "postgres",
        "create database latin template template0 encoding 'LATIN1' locale 'C'",
    );
    refused_in_both(
        &scratch,
        &format!("survey add a {}", server.store("latin", "postgres")),
        "keeps text as LATIN1",
        "문자 인코딩은 LATIN1",
    );
}

#[test]
fn refuses_names_and_texts_of_strangers_as_statements_and_ways_out() {
    let Some(server) = Server::shared() else { return };
    let scratch = Scratch::new("server-hostile");
    let store = server.database("hostile");
    let hostile = [
        "x'); drop table dolmen.structure cascade; --",
        "\"; drop schema dolmen cascade; --",
        "$1",
        "\\'; select pg_sleep(9); --",
        "../../../etc/passwd",
        "%00",
        "a/b",
        "-o",
        "한글 '이름' \u{1f5ff}",
    ];
    let url = store.strip_prefix("--store ").unwrap();
    for (at, name) in hostile.iter().enumerate() {
        let quoted = format!("'''{name}'''");
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = {{ en = {quoted} }}\n[survey.{:?}]\nnote = {quoted}\nsource = \"one\\ntwo\\t'\\\\'\"\n\
             records = {{ file = \"record.csv\", sampling_rate = \"50 Hz\" }}\n",
            format!("2020 {}", name.replace('\\', "/"))
        );
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        fs::write(scratch.path().join("record.csv"), format!("x\n{at}\n")).unwrap();
        good(scratch.briefly(&format!("survey add p.toml {store} --without-modes")));
        let output = Command::new(env!("CARGO_BIN_EXE_dolmen"))
            .args(["survey", "export", "--store", url, "-o"])
            .arg(format!("back{at}"))
            .args(["--", name])
            .current_dir(scratch.path())
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{name}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(scratch.path().join(format!("back{at}/record.csv")).is_file());
    }
    content(&scratch, &store);
    let listed = json(&scratch, &format!("survey list {store}"));
    let mut names: Vec<&str> = listed["structures"]
        .as_array()
        .unwrap()
        .iter()
        .map(|of| of["name"].as_str().unwrap())
        .collect();
    let mut given = hostile.to_vec();
    names.sort_unstable();
    given.sort_unstable();
    assert_eq!(names, given);
    assert_eq!(
        server.sql(
            "hostile",
            "select count(distinct source), min(source) = E'one\\ntwo\\t''\\\\''' from dolmen.survey"
        ),
        "1|t"
    );
    // a zero byte, which SQLite allows and PostgreSQL does not
    fs::write(
        scratch.path().join("p.toml"),
        "schema = 1\nkind = \"survey\"\nname = \"zero\"\n[survey.2020]\n",
    )
    .unwrap();
    good(scratch.briefly("survey add p.toml --store zero.db"));
    let other = rusqlite::Connection::open(scratch.path().join("zero.db")).unwrap();
    other.execute("update survey set note = ?1", ["a\0b"]).unwrap();
    drop(other);
    let before = content(&scratch, &store);
    refused_in_both(
        &scratch,
        &format!("survey import zero.db {store}"),
        "\"a?b\" holds a zero byte (NUL)",
        "NUL 바이트",
    );
    assert_eq!(before, content(&scratch, &store));
    // a foreign database names a file outside: nothing is written there
    server.sql(
        "hostile",
        "update dolmen.project_file set path = '../evil.csv' where project = (select project from dolmen.adoption where structure = 'a/b')",
    );
    refused(
        &scratch.briefly(&format!("survey export a/b -o out {store}")),
        "cannot be kept",
    );
    assert!(!scratch.path().join("out").exists() && !scratch.path().join("evil.csv").exists());
}
