//! SQLite: one file, write-ahead log, every commit on disk before it is acknowledged.

use crate::database::{Access, Database, Kind, Value, all};
use crate::error::StoreError;
use crate::schema_files::FILES;
use dolmen_work::kept::StoreFault;
use rusqlite::ffi::{ErrorCode, SQLITE_IOERR_SHMSIZE};
use rusqlite::types::{Value as SqlValue, ValueRef};
use rusqlite::{Connection, OpenFlags, params_from_iter};
use std::borrow::Cow;
use std::path::Path;
use std::time::{Duration, Instant};

/// "dolm": files with another number belong to other programs.
const APPLICATION: i64 = 0x646F_6C6D;

pub(crate) struct Sqlite(Connection);

impl Sqlite {
    /// Opens the file, with a limit to the wait for other processes.
    pub(crate) fn open(path: &Path, access: Access, wait: Duration) -> Result<Self, StoreError> {
        let shown = path.display().to_string();
        let is_there = path.exists();
        if is_there && !path.is_file() {
            return Err(StoreFault::NotAFile { shown }.into());
        }
        if !is_there && access == Access::Read {
            return Err(StoreFault::NoStore { shown }.into());
        }
        let flags = OpenFlags::SQLITE_OPEN_NO_MUTEX;
        let opened = match access {
            Access::Write => {
                let flags = flags | OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE;
                Connection::open_with_flags(path, flags)
            }
            Access::Read => Connection::open_with_flags(path, flags | OpenFlags::SQLITE_OPEN_READ_ONLY),
        };
        let mut opened = Sqlite(opened.map_err(sqlite_fault)?);
        opened.0.busy_timeout(wait).map_err(sqlite_fault)?;
        if access == Access::Write && opened.0.is_readonly("main").map_err(sqlite_fault)? {
            return Err(StoreFault::ReadOnly.into());
        }
        let known = opened.whole("pragma application_id");
        let known = match (known, access) {
            // a store on a read-only medium has no log file, and nobody changes it
            (Err(StoreError::Fault(StoreFault::Unopenable | StoreFault::ReadOnly)), Access::Read) => {
                opened = Sqlite::still(path, flags)?;
                opened.whole("pragma application_id")?
            }
            (known, _) => known?,
        };
        // the number is read again: another process may have filled the file since the first look
        let is_filled = known == 0 && (opened.schema()? != 0 || opened.has_tables()?);
        let known = match is_filled {
            true => opened.whole("pragma application_id")?,
            false => known,
        };
        if known != APPLICATION && (known != 0 || is_filled) {
            return Err(StoreFault::Foreign { shown }.into());
        }
        if known != APPLICATION && access == Access::Read {
            return Err(StoreFault::Foreign { shown }.into());
        }
        if access == Access::Write {
            opened.keep_log(wait)?;
            opened.pragma("pragma synchronous = full")?;
            if known != APPLICATION {
                opened.pragma(&format!("pragma application_id = {APPLICATION}"))?;
            }
        }
        opened.pragma("pragma foreign_keys = on")?;
        // a hostile file cannot run anything: neither functions in its schema nor code in its cells
        opened.pragma("pragma trusted_schema = off")?;
        opened.pragma("pragma cell_size_check = on")?;
        Ok(opened)
    }

    /// Opens a file that nobody can change during reading.
    fn still(path: &Path, flags: OpenFlags) -> Result<Self, StoreError> {
        let escaped: String = path
            .display()
            .to_string()
            .bytes()
            .map(|byte| match byte {
                b'/' | b'-' | b'_' | b'.' | b'~' => char::from(byte).to_string(),
                byte if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
                byte => format!("%{byte:02X}"),
            })
            .collect();
        let flags = flags | OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI;
        let opened = Connection::open_with_flags(format!("file:{escaped}?immutable=1"), flags);
        Ok(Sqlite(opened.map_err(sqlite_fault)?))
    }

    fn whole(&self, sql: &str) -> Result<i64, StoreError> {
        self.0.query_row(sql, [], |row| row.get(0)).map_err(sqlite_fault)
    }

    fn has_tables(&self) -> Result<bool, StoreError> {
        Ok(self.whole("select count(*) from sqlite_schema")? > 0)
    }

    /// Switches to the write-ahead log. While another process creates the same file, SQLite refuses this at once, without waiting.
    fn keep_log(&mut self, wait: Duration) -> Result<(), StoreError> {
        const AGAIN: Duration = Duration::from_millis(10);
        let until = Instant::now() + wait;
        loop {
            match self.pragma("pragma journal_mode = wal") {
                Err(StoreError::Fault(StoreFault::Locked)) if Instant::now() < until => {
                    std::thread::sleep(AGAIN)
                }
                done => return done,
            }
        }
    }

    /// Runs a pragma that may return rows.
    fn pragma(&mut self, sql: &str) -> Result<(), StoreError> {
        let mut statement = self.0.prepare(sql).map_err(sqlite_fault)?;
        let mut rows = statement.query([]).map_err(sqlite_fault)?;
        while rows.next().map_err(sqlite_fault)?.is_some() {}
        Ok(())
    }
}

fn sql_value(value: &Value) -> SqlValue {
    match value {
        Value::Null => SqlValue::Null,
        Value::Whole(whole) => SqlValue::Integer(*whole),
        Value::Number(number) => SqlValue::Real(*number),
        Value::Text(text) => SqlValue::Text(text.clone()),
    }
}

fn own_value(value: ValueRef<'_>) -> Result<Value, StoreError> {
    let not_text = || {
        let why = "text that is not UTF-8".to_owned();
        StoreError::from(StoreFault::Damaged { why })
    };
    Ok(match value {
        ValueRef::Null => Value::Null,
        ValueRef::Integer(whole) => Value::Whole(whole),
        ValueRef::Real(number) => Value::Number(number),
        ValueRef::Text(bytes) => Value::Text(std::str::from_utf8(bytes).map_err(|_| not_text())?.to_owned()),
        ValueRef::Blob(_) => return Err(not_text()),
    })
}

impl Database for Sqlite {
    fn execute(&mut self, sql: &str, values: &[Value]) -> Result<u64, StoreError> {
        let values = params_from_iter(values.iter().map(sql_value));
        let changed = self.0.execute(sql, values).map_err(sqlite_fault)?;
        Ok(changed as u64)
    }

    fn query(
        &mut self,
        sql: &str,
        values: &[Value],
        each: &mut dyn FnMut(Vec<Value>) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let mut statement = self.0.prepare(sql).map_err(sqlite_fault)?;
        let columns = statement.column_count();
        let values = params_from_iter(values.iter().map(sql_value));
        let mut rows = statement.query(values).map_err(sqlite_fault)?;
        while let Some(row) = rows.next().map_err(sqlite_fault)? {
            let value = |at: usize| own_value(row.get_ref(at).map_err(sqlite_fault)?);
            each((0..columns).map(value).collect::<Result<_, _>>()?)?;
        }
        Ok(())
    }

    fn batch(&mut self, sql: &str) -> Result<(), StoreError> {
        self.0.execute_batch(sql).map_err(sqlite_fault)
    }

    fn begin(&mut self) -> Result<(), StoreError> {
        self.batch("begin immediate")
    }

    fn begin_reading(&mut self) -> Result<(), StoreError> {
        self.batch("begin")
    }

    fn schema(&mut self) -> Result<i64, StoreError> {
        self.whole("pragma user_version")
    }

    fn set_schema(&mut self, number: i64) -> Result<(), StoreError> {
        self.pragma(&format!("pragma user_version = {number}"))
    }

    fn faults(&mut self) -> Result<Vec<String>, StoreError> {
        let mut faults = Vec::new();
        for row in all(self, "pragma integrity_check", &[])? {
            match row.as_slice() {
                [Value::Text(said)] if said == "ok" => {}
                row => faults.push(format!("{row:?}")),
            }
        }
        for row in all(self, "pragma foreign_key_check", &[])? {
            if let Some(Value::Text(table)) = row.first() {
                faults.push(format!("a row of {table} refers to one that is not there"));
            }
        }
        Ok(faults)
    }

    fn columns(&mut self, table: &str) -> Result<Vec<(String, Kind)>, StoreError> {
        let sql = "select name, type from pragma_table_info($1) order by cid";
        let rows = all(self, sql, &[Value::Text(table.to_owned())])?;
        let column = |row: Vec<Value>| match <[Value; 2]>::try_from(row) {
            Ok([Value::Text(name), Value::Text(of)]) => match of.to_lowercase().as_str() {
                "integer" => Some((name, Kind::Whole)),
                "real" => Some((name, Kind::Number)),
                "text" => Some((name, Kind::Text)),
                _ => Some((format!("{name} {of}"), Kind::Text)),
            },
            _ => None,
        };
        Ok(rows.into_iter().filter_map(column).collect())
    }

    fn schema_files(&self) -> Vec<Cow<'static, str>> {
        FILES.map(Cow::Borrowed).to_vec()
    }

    fn settle(&mut self) -> Result<(), StoreError> {
        self.pragma("pragma wal_checkpoint(truncate)")
    }
}

/// Turns an error of SQLite into a fault for the user.
fn sqlite_fault(fault: rusqlite::Error) -> StoreError {
    let why = fault.to_string();
    let code = match &fault {
        // the index of the log cannot grow
        rusqlite::Error::SqliteFailure(code, _) if code.extended_code == SQLITE_IOERR_SHMSIZE => {
            Some(ErrorCode::DiskFull)
        }
        rusqlite::Error::SqliteFailure(code, _) => Some(code.code),
        _ => None,
    };
    match code {
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => StoreFault::Locked,
        Some(ErrorCode::ReadOnly) => StoreFault::ReadOnly,
        Some(ErrorCode::DiskFull) => StoreFault::DiskFull,
        Some(ErrorCode::CannotOpen | ErrorCode::PermissionDenied) => StoreFault::Unopenable,
        Some(ErrorCode::DatabaseCorrupt) => StoreFault::Damaged { why },
        Some(ErrorCode::NotADatabase) => StoreFault::NotADatabase,
        _ => StoreFault::Failed { why },
    }
    .into()
}
