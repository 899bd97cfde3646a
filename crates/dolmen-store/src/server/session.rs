//! The interface of a database, for PostgreSQL.

use super::address::Address;
use super::dialect::{SCHEMA, files};
use super::link::Link;
use crate::database::{Access, Database, Kind, Value, all};
use crate::error::StoreError;
use dolmen_work::kept::StoreFault;
use std::borrow::Cow;
use std::time::Duration;

/// "dolmen": writers hold this lock of the database, so that times and names are assigned one after the other.
const LOCK: i64 = 0x646F_6C6D_656E;
/// Largest number of rows without their partner that an error lists, for each table.
const ROWS_MOST: i64 = 20;

#[derive(Debug)]
pub(crate) struct Session(Link);

impl Session {
    /// Opens the database, with a limit to the wait for other processes.
    pub(crate) fn open(address: &Address, access: Access, wait: Duration) -> Result<Self, StoreError> {
        let mut opened = Session(Link::new(address, access, wait));
        let shown = opened.0.shown();
        if opened.is_there("schema_number")? {
            if access == Access::Write && !opened.may_write()? {
                return Err(StoreFault::ServerRights { shown }.into());
            }
            return Ok(opened);
        }
        let sql = "select exists (select 1 from pg_class c join pg_namespace n on n.oid = c.relnamespace where n.nspname = $1)";
        let others = all(&mut opened, sql, &[Value::Text(SCHEMA.to_owned())])?;
        // another process may have created it meanwhile
        if others == [[Value::Whole(1)]] && !opened.is_there("schema_number")? {
            return Err(StoreFault::ServerForeign { shown }.into());
        }
        match access {
            Access::Read if !opened.is_there("schema_number")? => {
                Err(StoreFault::ServerEmpty { shown }.into())
            }
            _ => Ok(opened),
        }
    }

    fn is_there(&mut self, table: &str) -> Result<bool, StoreError> {
        let named = Value::Text(format!("{SCHEMA}.{table}"));
        let found = all(self, "select to_regclass($1::text) is not null", &[named])?;
        Ok(found == [[Value::Whole(1)]])
    }

    /// Whether the role may add rows, and the server accepts them.
    fn may_write(&mut self) -> Result<bool, StoreError> {
        let sql = "select has_table_privilege('log', 'insert') and current_setting('transaction_read_only') = 'off'";
        Ok(all(self, sql, &[])? == [[Value::Whole(1)]])
    }
}

impl Database for Session {
    fn execute(&mut self, sql: &str, values: &[Value]) -> Result<u64, StoreError> {
        self.0.execute(sql, values)
    }

    fn query(
        &mut self,
        sql: &str,
        values: &[Value],
        each: &mut dyn FnMut(Vec<Value>) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        self.0.query(sql, values, each)
    }

    fn batch(&mut self, sql: &str) -> Result<(), StoreError> {
        self.0.batch(sql)
    }

    fn begin(&mut self) -> Result<(), StoreError> {
        self.0
            .begin(&format!("begin; select pg_advisory_xact_lock({LOCK})"))
    }

    fn begin_reading(&mut self) -> Result<(), StoreError> {
        self.0.begin("begin isolation level repeatable read read only")
    }

    fn commit(&mut self) -> Result<(), StoreError> {
        self.0.end("commit")
    }

    fn rollback(&mut self) -> Result<(), StoreError> {
        self.0.end("rollback")
    }

    fn schema(&mut self) -> Result<i64, StoreError> {
        if !self.is_there("schema_number")? {
            return Ok(0);
        }
        match all(self, "select number from schema_number", &[])?
            .first()
            .map(Vec::as_slice)
        {
            Some([Value::Whole(number)]) => Ok(*number),
            _ => Ok(0),
        }
    }

    fn set_schema(&mut self, number: i64) -> Result<(), StoreError> {
        let sql = "insert into schema_number (only_row, number) values (1, $1) on conflict (only_row) do update set number = excluded.number";
        self.execute(sql, &[Value::Whole(number)]).map(|_| ())
    }

    /// Rows that refer to a missing row: a server refuses them, unless this check was switched off.
    fn faults(&mut self) -> Result<Vec<String>, StoreError> {
        let sql = "select quote_ident(c.relname), quote_ident(a.attname), quote_ident(p.relname), quote_ident(b.attname) \
             from pg_constraint k join pg_class c on c.oid = k.conrelid join pg_class p on p.oid = k.confrelid \
             join pg_attribute a on a.attrelid = c.oid and a.attnum = k.conkey[1] \
             join pg_attribute b on b.attrelid = p.oid and b.attnum = k.confkey[1] \
             join pg_namespace n on n.oid = c.relnamespace where k.contype = 'f' and n.nspname = $1 order by 1, 2";
        let mut faults = Vec::new();
        for row in all(self, sql, &[Value::Text(SCHEMA.to_owned())])? {
            let Ok(
                [
                    Value::Text(table),
                    Value::Text(column),
                    Value::Text(other),
                    Value::Text(key),
                ],
            ) = <[Value; 4]>::try_from(row)
            else {
                continue;
            };
            let sql = format!(
                "select 1 from {table} own where own.{column} is not null \
                 and not exists (select 1 from {other} other where other.{key} = own.{column}) limit {ROWS_MOST}"
            );
            for _ in all(self, &sql, &[])? {
                faults.push(format!("a row of {table} refers to one that is not there"));
            }
        }
        Ok(faults)
    }

    fn columns(&mut self, table: &str) -> Result<Vec<(String, Kind)>, StoreError> {
        let sql = "select a.attname::text, format_type(a.atttypid, a.atttypmod), coalesce(c.collname::text, '') from pg_attribute a \
             left join pg_collation c on c.oid = a.attcollation \
             where a.attrelid = to_regclass($1::text) and a.attnum > 0 and not a.attisdropped order by a.attnum";
        let rows = all(self, sql, &[Value::Text(format!("{SCHEMA}.{table}"))])?;
        let column = |row: Vec<Value>| match <[Value; 3]>::try_from(row) {
            Ok([Value::Text(name), Value::Text(of), Value::Text(collation)]) => {
                match (of.as_str(), collation.as_str()) {
                    ("bigint", _) => Some((name, Kind::Whole)),
                    ("double precision", _) => Some((name, Kind::Number)),
                    ("text", "C") => Some((name, Kind::Text)),
                    _ => Some((format!("{name} {of}"), Kind::Text)),
                }
            }
            _ => None,
        };
        Ok(rows.into_iter().filter_map(column).collect())
    }

    fn schema_files(&self) -> Vec<Cow<'static, str>> {
        let mut files = files();
        if let Some(first) = files.first_mut() {
            first
                .to_mut()
                .insert_str(0, &format!("create schema if not exists {SCHEMA};\n"));
        }
        files
    }

    fn settle(&mut self) -> Result<(), StoreError> {
        Ok(()) // every commit is on disk
    }
}
