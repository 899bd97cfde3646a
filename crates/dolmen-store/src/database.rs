//! The interface of a database for a store: statements with parameters, in SQL that all databases share.

use crate::error::StoreError;
use std::borrow::Cow;

/// A value of a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    /// No value.
    Null,
    /// A whole number.
    Whole(i64),
    /// A number.
    Number(f64),
    /// Text.
    Text(String),
}

/// Type of the content of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A whole number.
    Whole,
    /// A number.
    Number,
    /// Text.
    Text,
}

/// Mode in which a database is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Access {
    /// For reading; it must exist.
    Read,
    /// For writing; it is created if it does not exist.
    Write,
}

/// A database. Parameters of a statement are `$1`, `$2`…, in the order of their first use.
pub(crate) trait Database: Send {
    /// Runs one statement and returns the number of changed rows.
    fn execute(&mut self, sql: &str, values: &[Value]) -> Result<u64, StoreError>;

    /// Passes the rows of a query to a closure one by one, without collecting them.
    fn query(
        &mut self,
        sql: &str,
        values: &[Value],
        each: &mut dyn FnMut(Vec<Value>) -> Result<(), StoreError>,
    ) -> Result<(), StoreError>;

    /// Runs a file of statements without parameters.
    fn batch(&mut self, sql: &str) -> Result<(), StoreError>;

    /// Begins a writing transaction: one process at a time, others wait.
    fn begin(&mut self) -> Result<(), StoreError>;

    /// Commits a transaction: all of it is on disk when this returns.
    fn commit(&mut self) -> Result<(), StoreError> {
        self.batch("commit")
    }

    /// Rolls a transaction back.
    fn rollback(&mut self) -> Result<(), StoreError> {
        self.batch("rollback")
    }

    /// Begins a reading transaction: until [`Database::rollback`], all reads show the data of one moment, even if others
    /// write.
    fn begin_reading(&mut self) -> Result<(), StoreError>;

    /// The number of the last schema file that was run; 0 for an empty database.
    fn schema(&mut self) -> Result<i64, StoreError>;

    /// Records that schema file `number` was run, within the transaction.
    fn set_schema(&mut self, number: i64) -> Result<(), StoreError>;

    /// The faults that the database itself finds in its pages, indices and references.
    fn faults(&mut self) -> Result<Vec<String>, StoreError>;

    /// The columns of a table with their kinds, in order.
    fn columns(&mut self, table: &str) -> Result<Vec<(String, Kind)>, StoreError>;

    /// The schema files of this database; the first has number 1.
    fn schema_files(&self) -> Vec<Cow<'static, str>>;

    /// Writes everything to disk and clears the write-ahead log, as far as possible.
    fn settle(&mut self) -> Result<(), StoreError>;
}

/// All rows of a query.
pub(crate) fn all(
    database: &mut dyn Database,
    sql: &str,
    values: &[Value],
) -> Result<Vec<Vec<Value>>, StoreError> {
    let mut rows = Vec::new();
    database.query(sql, values, &mut |row| {
        rows.push(row);
        Ok(())
    })?;
    Ok(rows)
}

/// Runs `work` as one transaction: all of it takes effect, or nothing.
pub(crate) fn transaction<T>(
    database: &mut dyn Database,
    work: impl FnOnce(&mut dyn Database) -> Result<T, StoreError>,
) -> Result<T, StoreError> {
    let done = database.begin().and_then(|()| work(database));
    match done.and_then(|done| database.commit().map(|()| done)) {
        Ok(done) => Ok(done),
        Err(fault) => {
            let _ = database.rollback(); // the first fault is the one to report
            Err(fault)
        }
    }
}

/// Conversion from and to column values.
pub(crate) trait Field: Sized {
    const KIND: Kind;
    fn value(&self) -> Value;
    fn of(value: Value) -> Option<Self>;
}

impl Field for String {
    const KIND: Kind = Kind::Text;
    fn value(&self) -> Value {
        Value::Text(self.clone())
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }
}

impl Field for i64 {
    const KIND: Kind = Kind::Whole;
    fn value(&self) -> Value {
        Value::Whole(*self)
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Whole(whole) => Some(whole),
            _ => None,
        }
    }
}

impl Field for f64 {
    const KIND: Kind = Kind::Number;
    fn value(&self) -> Value {
        Value::Number(*self)
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Number(number) => Some(number),
            _ => None,
        }
    }
}

impl Field for bool {
    const KIND: Kind = Kind::Whole;
    fn value(&self) -> Value {
        Value::Whole(i64::from(*self))
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Whole(whole) => Some(whole != 0),
            _ => None,
        }
    }
}

impl<T: Field> Field for Option<T> {
    const KIND: Kind = T::KIND;
    fn value(&self) -> Value {
        self.as_ref().map_or(Value::Null, Field::value)
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Null => Some(None),
            value => T::of(value).map(Some),
        }
    }
}
