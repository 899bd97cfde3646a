//! Brings a database to the schema of this version: numbered files of SQL, each run once.

use crate::database::{Database, Value, transaction};
use crate::error::StoreError;
use crate::inspection_rows::fill;
use crate::raw::RawFiles;
use crate::schema_files::OF_INSPECTIONS;
use dolmen_work::kept::StoreFault;
use std::sync::Arc;

/// Whether the schema is that of this version; a later one is an error.
pub(crate) fn is_current(database: &mut dyn Database) -> Result<bool, StoreError> {
    let (found, known) = (database.schema()?, database.schema_files().len());
    let found = usize::try_from(found).unwrap_or(usize::MAX);
    if found > known {
        return Err(StoreFault::Later { found, known }.into());
    }
    Ok(found == known)
}

/// Runs the missing schema files, and fills their tables from the stored texts, in one transaction.
pub(crate) fn migrate(
    database: &mut dyn Database,
    now_us: i64,
    raw: &Arc<dyn RawFiles>,
) -> Result<(), StoreError> {
    if is_current(database)? {
        return Ok(());
    }
    transaction(database, |database| {
        // another process may have done this while this one waited for the lock
        let done = usize::try_from(database.schema()?).unwrap_or(0);
        for (number, file) in database.schema_files().into_iter().enumerate().skip(done) {
            database.batch(&file)?;
            database.set_schema(number as i64 + 1)?;
        }
        if (1..OF_INSPECTIONS).contains(&done) {
            fill(database, raw)?;
        }
        let only = "insert into store (only_row, made_us) values (1, $1) on conflict do nothing";
        database.execute(only, &[Value::Whole(now_us)]).map(|_| ())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::{Access, all};
    use crate::raw_folder::no_files;
    use crate::sqlite::Sqlite;
    use std::time::Duration;

    #[test]
    fn holds_a_store_of_the_first_schema_is_brought_to_this_one_and_keeps_its_rows() {
        let file = std::env::temp_dir().join(format!("dolmen-schema-{}.db", std::process::id()));
        let mut database = Sqlite::open(&file, Access::Write, Duration::ZERO).unwrap();
        let first = database.schema_files()[0].clone();
        database.batch(&first).unwrap();
        database.set_schema(1).unwrap();
        database
            .batch("insert into structure values ('Gate', 7, 'kim')")
            .unwrap();
        assert!(!is_current(&mut database).unwrap());
        migrate(&mut database, 0, &no_files()).unwrap();
        assert!(is_current(&mut database).unwrap());
        let kept = all(&mut database, "select name from structure", &[]).unwrap();
        assert_eq!(kept, [[Value::Text("Gate".to_owned())]]);
        assert!(!database.columns("arrival").unwrap().is_empty());
        drop(database);
        let _ = std::fs::remove_file(&file);
    }
}
