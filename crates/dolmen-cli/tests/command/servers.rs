//! PostgreSQL servers for the tests, each in its own folder; they stop with the tests and leave nothing behind.

use super::stores::good;
use super::verbs::Scratch;
use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::{Mutex, OnceLock};

/// System user that may run a server, and superuser of its databases.
const USER: &str = "postgres";

/// A server that listens on a socket in its folder.
pub(crate) struct Server {
    programs: PathBuf,
    folder: PathBuf,
    port: u16,
    keeper: Mutex<Option<(Child, ChildStdin)>>,
}

/// Folder of the server programs; on Debian it is not in the PATH.
fn programs() -> Option<PathBuf> {
    let debian = fs::read_dir("/usr/lib/postgresql")
        .into_iter()
        .flatten()
        .flatten();
    let debian = debian.map(|entry| entry.path().join("bin")).max();
    let told = Command::new("pg_config").arg("--bindir").output().ok();
    let told = told.map(|said| PathBuf::from(String::from_utf8_lossy(&said.stdout).trim()));
    [debian, told]
        .into_iter()
        .flatten()
        .find(|folder| folder.join("initdb").is_file())
}

fn is_root() -> bool {
    let told = Command::new("id").arg("-u").output().unwrap();
    told.stdout.trim_ascii() == b"0"
}

/// A server refuses to run as root.
fn as_user(program: &Path) -> Command {
    if !is_root() {
        return Command::new(program);
    }
    let mut command = Command::new("runuser");
    command.args(["-u", USER, "--"]).arg(program);
    command
}

/// Creates and starts a server; stops and removes it when its standard input closes, as happens whenever the tests end.
const KEEPER: &str = r#"
trap '' INT TERM HUP
"$1/initdb" --no-sync -A trust -U postgres -E UTF8 --locale C -D "$2/data" >"$2/made" 2>&1 || { cat "$2/made" >&2; exit 1; }
cat >>"$2/data/postgresql.conf" <<END
listen_addresses = '$3'
port = $4
unix_socket_directories = '$2'
fsync = off
shared_buffers = 16MB
max_connections = 40
END
{ echo 'local all locked scram-sha-256'; echo 'host all all 127.0.0.1/32 scram-sha-256'; grep -v '^host' "$2/data/pg_hba.conf"; } >"$2/hba"
cp "$2/hba" "$2/data/pg_hba.conf"
"$1/pg_ctl" -D "$2/data" -l "$2/log" -w start >/dev/null || { cat "$2/log" >&2; exit 1; }
echo ready
cat >/dev/null
"$1/pg_ctl" -D "$2/data" -m immediate stop >/dev/null 2>&1
rm -rf "$2"
"#;

impl Server {
    /// A new server on a socket, and on 127.0.0.1 if `port` gives a port; `None` if PostgreSQL is not installed.
    pub(crate) fn start(name: &str, port: Option<u16>) -> Option<Self> {
        let Some(programs) = programs() else {
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED: PostgreSQL is not installed here (apt-get install postgresql), so stores on a server are not tried"
            );
            return None;
        };
        let folder = std::env::temp_dir().join(format!("dolmen-pg-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        if is_root() {
            let owned = Command::new("chown").arg(USER).arg(&folder).status().unwrap();
            assert!(owned.success());
        }
        let (listen, port) = match port {
            Some(port) => ("127.0.0.1", port),
            None => ("", 5432),
        };
        let mut child = as_user(Path::new("/bin/sh"))
            .args(["-c", KEEPER, "keeper"])
            .args([&programs, &folder])
            .args([listen, &port.to_string()])
            .current_dir(&folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let stdin = child.stdin.take().unwrap();
        let mut said = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut said)
            .unwrap();
        assert_eq!(said, "ready\n", "the server did not start");
        Some(Server {
            programs,
            folder,
            port,
            keeper: Mutex::new(Some((child, stdin))),
        })
    }

    /// The server that all tests of this binary share.
    pub(crate) fn shared() -> Option<&'static Server> {
        static SHARED: OnceLock<Option<Server>> = OnceLock::new();
        SHARED.get_or_init(|| Server::start("shared", None)).as_ref()
    }

    /// The port of its socket and of 127.0.0.1.
    pub(crate) fn port(&self) -> u16 {
        self.port
    }

    /// The folder of its socket.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Runs statements as the owner; returns the result, one line per row.
    pub(crate) fn sql(&self, database: &str, statements: &str) -> String {
        let output = Command::new(self.programs.join("psql"))
            .args([
                "-X",
                "-q",
                "-A",
                "-t",
                "-v",
                "ON_ERROR_STOP=1",
                "-U",
                USER,
                "-d",
                database,
                "-h",
            ])
            .arg(&self.folder)
            .args(["-p", &self.port.to_string(), "-c", statements])
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{statements}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }

    /// Creates an empty database; returns the arguments that name the store in it.
    pub(crate) fn database(&self, name: &str) -> String {
        self.sql(USER, &format!("create database {name}"));
        self.store(name, USER)
    }

    /// The arguments that name the store of a database, for a role.
    pub(crate) fn store(&self, database: &str, role: &str) -> String {
        format!("--store {}", self.url(database, role))
    }

    pub(crate) fn url(&self, database: &str, role: &str) -> String {
        format!("postgresql://{role}@/{database}?host={}", self.folder.display())
    }

    /// Runs one of its programs on a database.
    pub(crate) fn program(&self, name: &str, words: &[&str]) -> Vec<u8> {
        let output = Command::new(self.programs.join(name))
            .args(["-U", USER, "-h"])
            .arg(&self.folder)
            .args(words)
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        output.stdout
    }

    /// Runs `pg_ctl` with these arguments, to stop or restart the server.
    pub(crate) fn control(&self, words: &[&str]) {
        let done = as_user(&self.programs.join("pg_ctl"))
            .arg("-D")
            .arg(self.folder.join("data"))
            .args(words)
            .arg("-l")
            .arg(self.folder.join("log"))
            .current_dir(&self.folder)
            .stdout(Stdio::null())
            .status()
            .unwrap();
        assert!(done.success(), "{words:?}");
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        if let Some((mut child, stdin)) = self.keeper.lock().unwrap().take() {
            drop(stdin);
            let _ = child.wait();
        }
    }
}

/// Stores a project in its own database on the shared server.
pub(crate) fn stored(scratch: &Scratch, server: &Server, database: &str, project: &str) -> String {
    let store = server.database(database);
    good(scratch.briefly(&format!("survey add {project} --without-modes {store}")));
    store
}
