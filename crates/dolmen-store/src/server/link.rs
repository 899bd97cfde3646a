//! A connection to a server, renewed if it was lost between two transactions.

use super::address::{Address, Host};
use super::columns::{own_row, parameters};
use super::dialect::SCHEMA;
use super::fault::{SessionStage, is_starting, server_fault};
use crate::database::{Access, Value};
use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use postgres::config::SslMode;
use postgres::fallible_iterator::FallibleIterator as _;
use postgres::types::ToSql;
use postgres::{Client, Config, NoTls, Row, Statement};
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// How long a server may take to answer a new connection.
const CONNECT_MOST: Duration = Duration::from_secs(30);
/// Interval of retries while a server is starting.
const AGAIN: Duration = Duration::from_millis(50);
/// After this time without use the connection is checked: the server may have been restarted.
const IDLE: Duration = Duration::from_secs(1);
/// The longest `lock_timeout` that PostgreSQL takes, ms.
const LOCK_MOST_MS: u128 = i32::MAX as u128;
/// The only encoding that can hold every name and note.
const ENCODING: &str = "UTF8";

pub(crate) struct Link {
    address: Address,
    access: Access,
    wait: Duration,
    client: Option<Client>,
    statements: HashMap<String, Statement>,
    in_transaction: bool,
    used: Instant,
}

impl std::fmt::Debug for Link {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(to, "Link({})", self.address.shown())
    }
}

impl Link {
    /// A connection that is opened on first use, with a limit to the wait for other processes.
    pub(crate) fn new(address: &Address, access: Access, wait: Duration) -> Self {
        Link {
            address: address.clone(),
            access,
            wait,
            client: None,
            statements: HashMap::new(),
            in_transaction: false,
            used: Instant::now(),
        }
    }

    /// The address without its password.
    pub(crate) fn shown(&self) -> String {
        self.address.shown()
    }

    fn config(&self) -> Config {
        let of = &self.address;
        let mut config = Config::new();
        match &of.host {
            Host::Name(name) => config.host(name),
            Host::Socket(folder) => config.host(folder.to_string_lossy().as_ref()),
        };
        if let Some(role) = &of.role {
            config.user(role);
        }
        if let Some(password) = &of.password {
            config.password(password);
        }
        if let Some(database) = &of.database {
            config.dbname(database);
        }
        config
            .port(of.port)
            .ssl_mode(SslMode::Disable)
            .application_name("dolmen")
            .connect_timeout(self.wait.clamp(Duration::from_secs(1), CONNECT_MOST))
            .keepalives_idle(CONNECT_MOST)
            .tcp_user_timeout(CONNECT_MOST);
        config
    }

    /// A new connection; waits while a server is starting.
    fn connect(&self) -> Result<Client, StoreError> {
        let until = Instant::now() + self.wait;
        let config = self.config();
        let mut client = loop {
            match config.connect(NoTls) {
                Ok(client) => break client,
                Err(fault) if is_starting(&fault) && Instant::now() < until => std::thread::sleep(AGAIN),
                Err(fault) => return Err(server_fault(&self.shown(), &fault, SessionStage::Connecting)),
            }
        };
        let fault_of = |fault| server_fault(&self.shown(), &fault, SessionStage::Working);
        let row = client
            .query_one("select current_setting('server_encoding')", &[])
            .map_err(fault_of)?;
        let encoding: String = row.try_get(0).map_err(fault_of)?;
        if encoding != ENCODING {
            let shown = self.shown();
            return Err(StoreFault::ServerEncoding { shown, encoding }.into());
        }
        client.batch_execute(&self.settings()).map_err(fault_of)?;
        Ok(client)
    }

    /// Settings of a session: a commit is on disk when it is acknowledged, and the locks of a dead client are released within a minute.
    fn settings(&self) -> String {
        let wait_ms = self.wait.as_millis().clamp(1, LOCK_MOST_MS);
        let mut settings = format!(
            "set search_path = {SCHEMA}, pg_temp; set client_min_messages = warning; set lock_timeout = {wait_ms}; \
             set tcp_keepalives_idle = 30; set tcp_keepalives_interval = 10; set tcp_keepalives_count = 3; \
             select set_config('synchronous_commit', 'on', false) where current_setting('synchronous_commit') = 'off';"
        );
        if self.access == Access::Read {
            settings.push_str(" set default_transaction_read_only = on;");
        }
        settings
    }

    /// Makes sure of a connection: between transactions it replaces a lost one.
    fn ready(&mut self) -> Result<&mut Client, StoreError> {
        let is_idle = self.used.elapsed() > IDLE;
        let has_ended =
            |client: &mut Client| client.is_closed() || (is_idle && client.check_connection().is_err());
        if !self.in_transaction && self.client.as_mut().is_none_or(has_ended) {
            self.statements.clear(); // a new connection has no prepared statements
            self.client = None;
            self.client = Some(self.connect()?);
        }
        self.used = Instant::now();
        self.held()
    }

    /// The open connection.
    fn held(&mut self) -> Result<&mut Client, StoreError> {
        let shown = self.address.shown();
        let gone = || StoreFault::ServerGone { shown }.into();
        self.client.as_mut().ok_or_else(gone)
    }

    /// The fault for an error; drops a connection that is lost.
    fn lost(&mut self, fault: &postgres::Error) -> StoreError {
        let seen = server_fault(&self.shown(), fault, SessionStage::Working);
        if matches!(seen, StoreError::Fault(StoreFault::ServerGone { .. })) {
            self.client = None;
        }
        seen
    }

    fn prepared(&mut self, sql: &str) -> Result<Statement, StoreError> {
        self.ready()?;
        if let Some(statement) = self.statements.get(sql) {
            return Ok(statement.clone());
        }
        let prepared = self.held()?.prepare(sql);
        let statement = prepared.map_err(|fault| self.lost(&fault))?;
        self.statements.insert(sql.to_owned(), statement.clone());
        Ok(statement)
    }

    /// Runs statements without parameters.
    pub(crate) fn batch(&mut self, sql: &str) -> Result<(), StoreError> {
        let done = self.ready()?.batch_execute(sql);
        done.map_err(|fault| self.lost(&fault))
    }

    /// Begins a transaction by these statements.
    pub(crate) fn begin(&mut self, sql: &str) -> Result<(), StoreError> {
        self.ready()?;
        self.in_transaction = true;
        self.batch(sql)
    }

    /// Ends a transaction by "commit" or "rollback".
    pub(crate) fn end(&mut self, sql: &str) -> Result<(), StoreError> {
        let done = self.batch(sql);
        self.in_transaction = false;
        done
    }

    /// Whether a transaction was begun and not ended, as after a panic.
    pub(crate) fn is_in_transaction(&self) -> bool {
        self.in_transaction
    }

    /// Drops the connection, and any transaction on it.
    pub(crate) fn leave(&mut self) {
        self.client = None;
        self.in_transaction = false;
    }

    /// Runs one statement and returns the number of changed rows.
    pub(crate) fn execute(&mut self, sql: &str, values: &[Value]) -> Result<u64, StoreError> {
        let statement = self.prepared(sql)?;
        let values = parameters(&statement, values)?;
        let values: Vec<&(dyn ToSql + Sync)> = values.iter().map(|value| value.as_ref() as _).collect();
        let done = self.held()?.execute(&statement, &values);
        done.map_err(|fault| self.lost(&fault))
    }

    /// Runs one statement with bytes as its last parameter.
    pub(crate) fn execute_with_bytes(
        &mut self,
        sql: &str,
        (hash, position): (&str, i64),
        bytes: &[u8],
    ) -> Result<u64, StoreError> {
        let statement = self.prepared(sql)?;
        let done = self.held()?.execute(&statement, &[&hash, &position, &bytes]);
        done.map_err(|fault| self.lost(&fault))
    }

    /// Passes the rows of a query to a closure one by one, as the server sends them.
    pub(crate) fn rows(
        &mut self,
        sql: &str,
        values: &[Value],
        each: &mut dyn FnMut(&Row) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let statement = self.prepared(sql)?;
        let values = parameters(&statement, values)?;
        let values = values.iter().map(|value| value.as_ref() as &(dyn ToSql + Sync));
        let shown = self.shown();
        let given: Result<(), StoreError> = (|| {
            let fault_of = |fault| server_fault(&shown, &fault, SessionStage::Working);
            let mut rows = self.held()?.query_raw(&statement, values).map_err(fault_of)?;
            while let Some(row) = rows.next().map_err(fault_of)? {
                each(&row)?;
            }
            Ok(())
        })();
        if matches!(given, Err(StoreError::Fault(StoreFault::ServerGone { .. }))) {
            self.client = None;
        }
        given
    }

    /// As [`Link::rows`], with values.
    pub(crate) fn query(
        &mut self,
        sql: &str,
        values: &[Value],
        each: &mut dyn FnMut(Vec<Value>) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        self.rows(sql, values, &mut |row| each(own_row(row)?))
    }
}
