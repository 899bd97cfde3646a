//! The address of a server, as a user writes it: postgresql://ROLE:PASSWORD@HOST:PORT/DATABASE?host=/FOLDER&sslmode=disable.
//!
//! No output shows a password: neither [`Address::shown`] nor the error of an address that cannot be read.

use dolmen_work::kept::StoreFault;
use std::fmt;
use std::net::IpAddr;
use std::path::{Path, PathBuf};

/// The port of PostgreSQL.
const PORT: u16 = 5432;
/// Folder of the socket on Debian and others.
const SOCKET_FOLDER: &str = "/var/run/postgresql";

/// A database of a server.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Address {
    pub(crate) role: Option<String>,
    pub(crate) password: Option<String>,
    pub(crate) host: Host,
    pub(crate) port: u16,
    pub(crate) database: Option<String>,
}

/// Endpoint of the server.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Host {
    /// A socket in this folder.
    Socket(PathBuf),
    /// A machine.
    Name(String),
}

impl Host {
    fn of(text: &str) -> Self {
        match text.starts_with('/') {
            true => Host::Socket(text.into()),
            false => Host::Name(text.to_owned()),
        }
    }

    /// The endpoint of an address without a host, as in psql.
    fn default() -> Self {
        match Path::new(SOCKET_FOLDER).is_dir() {
            true => Host::Socket(SOCKET_FOLDER.into()),
            false => Host::Name("localhost".to_owned()),
        }
    }
}

impl fmt::Debug for Address {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Address({})", self.shown())
    }
}

fn unreadable(part: &str) -> StoreFault {
    StoreFault::ServerUrl {
        part: part.to_owned(),
    }
}

/// Decodes %xx in a text; `part` names the text in errors.
fn decoded(text: &str, part: &str) -> Result<String, StoreFault> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut digit = || rest.next().and_then(|digit| char::from(digit).to_digit(16));
        match (digit(), digit()) {
            (Some(high), Some(low)) => bytes.push((high * 16 + low) as u8),
            _ => return Err(unreadable(part)),
        }
    }
    let text = String::from_utf8(bytes).map_err(|_| unreadable(part))?;
    match text.contains('\0') {
        true => Err(unreadable(part)),
        false => Ok(text),
    }
}

fn port(text: &str) -> Result<u16, StoreFault> {
    match text.parse() {
        Ok(0) | Err(_) => Err(unreadable("port")),
        Ok(port) => Ok(port),
    }
}

/// The text, unless it is empty.
fn given(text: String) -> Option<String> {
    (!text.is_empty()).then_some(text)
}

impl Address {
    /// Parses the part after "postgresql://".
    pub(crate) fn of(after_scheme: &str) -> Result<Self, StoreFault> {
        let (before, parameters) = match after_scheme.split_once('?') {
            Some((before, parameters)) => (before, parameters),
            None => (after_scheme, ""),
        };
        let (authority, database) = before.split_once('/').unwrap_or((before, ""));
        // an @ after the host belongs to a password with a / or ? in it
        if parameters.contains('@') || database.contains('@') || after_scheme.contains('#') {
            return Err(unreadable("password"));
        }
        let (role, host) = match authority.rsplit_once('@') {
            Some((role, host)) => (role, host),
            None => ("", authority),
        };
        let (role, password) = role.split_once(':').unwrap_or((role, ""));
        let (host, at) = match host.strip_prefix('[').and_then(|host| host.split_once(']')) {
            Some((host, "")) => (host, ""),
            Some((host, at)) => (host, at.strip_prefix(':').ok_or_else(|| unreadable("host"))?),
            None => host.split_once(':').unwrap_or((host, "")),
        };
        let host = decoded(host, "host")?;
        let mut address = Address {
            role: given(decoded(role, "role")?),
            password: given(decoded(password, "password")?),
            host: if host.is_empty() {
                Host::default()
            } else {
                Host::of(&host)
            },
            port: if at.is_empty() { PORT } else { port(at)? },
            database: given(decoded(database, "database")?),
        };
        let mut encryption = None;
        for parameter in parameters.split('&').filter(|parameter| !parameter.is_empty()) {
            let (key, value) = parameter.split_once('=').unwrap_or((parameter, ""));
            let is_word = key.bytes().all(|sign| sign.is_ascii_lowercase() || sign == b'_');
            if !is_word {
                return Err(unreadable("?"));
            }
            let value = decoded(value, key)?;
            match key {
                "host" => address.host = Host::of(&value),
                "port" => address.port = port(&value)?,
                "user" => address.role = given(value),
                "password" => address.password = given(value),
                "dbname" => address.database = given(value),
                "sslmode" => encryption = Some(value),
                "application_name" | "connect_timeout" => {} // ours are the name of this program and --wait
                other => return Err(unreadable(other)),
            }
        }
        address.refuse_unsafe(encryption.as_deref())?;
        Ok(address)
    }

    /// Refuses a connection that should be encrypted.
    fn refuse_unsafe(&self, mode: Option<&str>) -> Result<(), StoreFault> {
        let name = match &self.host {
            Host::Socket(_) => None,
            Host::Name(name) if name.contains(',') || name.chars().any(char::is_control) => {
                return Err(unreadable("host"));
            }
            Host::Name(name) => Some(name),
        };
        let is_near = |name: &str| {
            name == "localhost" || name.parse::<IpAddr>().is_ok_and(|number| number.is_loopback())
        };
        match (mode, name) {
            (Some("disable" | "allow" | "prefer"), _) => Ok(()),
            (Some(mode @ ("require" | "verify-ca" | "verify-full")), _) => Err(StoreFault::ServerTls {
                mode: mode.to_owned(),
            }),
            (Some(_), _) => Err(unreadable("sslmode")),
            (None, Some(name)) if !is_near(name) => Err(StoreFault::ServerClear { host: name.clone() }),
            (None, _) => Ok(()),
        }
    }

    /// The address without its password.
    pub(crate) fn shown(&self) -> String {
        let role = self
            .role
            .as_ref()
            .map(|role| format!("{role}@"))
            .unwrap_or_default();
        let port = match self.port {
            PORT => String::new(),
            port => format!(":{port}"),
        };
        let database = self.database.as_deref().unwrap_or_default();
        let shown = match &self.host {
            Host::Name(name) if name.contains(':') => format!("{role}[{name}]{port}/{database}"),
            Host::Name(name) => format!("{role}{name}{port}/{database}"),
            Host::Socket(folder) => format!("{role}{port}/{database}?host={}", folder.display()),
        };
        let plain = shown
            .chars()
            .map(|sign| if sign.is_control() { '?' } else { sign });
        format!("postgresql://{}", plain.collect::<String>())
    }

    /// The password for this address in a file such as ~/.pgpass, with lines HOST:PORT:DATABASE:ROLE:PASSWORD, where * matches anything.
    pub(crate) fn password_in(&self, text: &str) -> Option<String> {
        let port = self.port.to_string();
        let host = match &self.host {
            Host::Name(name) => name.as_str(),
            Host::Socket(_) => "localhost",
        };
        let own = [
            host,
            &port,
            self.database.as_deref().unwrap_or_default(),
            self.role.as_deref().unwrap_or_default(),
        ];
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        lines.map(fields).find_map(|fields| {
            let [line @ .., password] = fields.as_slice() else {
                return None;
            };
            let is_own =
                line.len() == own.len() && line.iter().zip(own).all(|(of, own)| of == "*" || of == own);
            is_own.then(|| password.clone())
        })
    }
}

/// Fields of a line between colons; a backslash escapes the next character.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut signs = line.chars();
    while let Some(sign) = signs.next() {
        match (sign, fields.len(), fields.last_mut()) {
            (':', 1..=4, _) => fields.push(String::new()),
            ('\\', _, Some(last)) => last.extend(signs.next()),
            (_, _, Some(last)) => last.push(sign),
            _ => {}
        }
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    fn good(text: &str) -> Address {
        Address::of(text).unwrap_or_else(|fault| panic!("{text}: {fault:?}"))
    }

    #[test]
    fn exact_parts_of_an_address() {
        let whole = good("kim:p%40s%2Fs%25@localhost:5433/heritage%20x");
        assert_eq!(whole.role.as_deref(), Some("kim"));
        assert_eq!(whole.password.as_deref(), Some("p@s/s%"));
        assert_eq!((&whole.host, whole.port), (&Host::Name("localhost".into()), 5433));
        assert_eq!(whole.database.as_deref(), Some("heritage x"));
        assert_eq!(whole.shown(), "postgresql://kim@localhost:5433/heritage x");
        assert!(!format!("{whole:?}").contains("p@s"));
        // an @ in a password that was not escaped
        assert_eq!(good("kim:p@s@localhost/d").password.as_deref(), Some("p@s"));
        let socket = good("/heritage?host=%2Ftmp%2Fs&user=kim&password=x&port=5434");
        assert_eq!(socket.host, Host::Socket("/tmp/s".into()));
        assert_eq!((socket.port, socket.password.as_deref()), (5434, Some("x")));
        assert_eq!(socket.shown(), "postgresql://kim@:5434/heritage?host=/tmp/s");
        assert_eq!(good("%2Ftmp/d").host, Host::Socket("/tmp".into()));
        assert_eq!(good("[::1]:5433/d").host, Host::Name("::1".into()));
        assert_eq!(good("[::1]/d").shown(), "postgresql://[::1]/d");
        assert_eq!((good("127.0.0.1/d").port, good("/").database), (5432, None));
    }

    #[test]
    fn refuses_what_cannot_be_read_and_says_no_password() {
        for (text, part) in [
            ("kim:secret/word@h/d", "password"),
            ("kim:secret?word@h/d", "password"),
            ("kim:secret#word@h/d", "password"),
            ("kim:secret%zz@localhost/d", "password"),
            ("kim:secret%00@localhost/d", "password"),
            ("localhost:0/d", "port"),
            ("localhost:secret/d", "port"),
            ("localhost/d?port=secret", "port"),
            ("one,two/d?sslmode=disable", "host"),
            ("localhost/d?sslrootcert=secret", "sslrootcert"),
            ("localhost/d?secret word=1", "?"),
            ("localhost/d?sslmode=secret", "sslmode"),
        ] {
            let fault = Address::of(text).unwrap_err();
            assert_eq!(fault, unreadable(part), "{text}");
        }
    }

    #[test]
    fn refuses_what_should_be_encrypted_and_is_not() {
        for mode in ["require", "verify-ca", "verify-full"] {
            for host in ["localhost", "db.example.org", ""] {
                let fault = Address::of(&format!("kim@{host}/d?sslmode={mode}")).unwrap_err();
                assert_eq!(fault, StoreFault::ServerTls { mode: mode.into() });
            }
        }
        for host in ["db.example.org", "10.0.0.7", "localhost.evil.org"] {
            let fault = Address::of(&format!("kim:secret@{host}/d")).unwrap_err();
            assert_eq!(fault, StoreFault::ServerClear { host: host.into() });
            good(&format!("kim:secret@{host}/d?sslmode=disable"));
        }
        for host in ["localhost", "127.0.0.5", "[::1]", "%2Ftmp"] {
            good(&format!("kim@{host}/d"));
        }
    }

    #[test]
    fn exact_passwords_of_a_file() {
        let file = "# of the office\nlocalhost:5432:other:kim:no\nlocalhost:*:her\\:itage:kim:p\\\\a:ss\n*:*:*:*:any\n";
        let of = |text: &str| good(text).password_in(file);
        assert_eq!(of("kim@localhost/her:itage").as_deref(), Some("p\\a:ss"));
        assert_eq!(of("kim@%2Ftmp/her:itage").as_deref(), Some("p\\a:ss"));
        assert_eq!(of("lee@localhost/her:itage").as_deref(), Some("any"));
        assert_eq!(good("kim@localhost/d").password_in("localhost:5432:d:kim"), None);
        assert_eq!(good("kim@localhost/d").password_in(""), None);
    }
}
