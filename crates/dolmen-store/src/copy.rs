//! Copies everything from another store that is not in this one.

use crate::database::{Database, Value, transaction};
use crate::error::StoreError;
use crate::incoming::refuse_name;
use crate::rows::{LogRow, TABLES, Table, insert};
use crate::store::{Act, Store};
use dolmen_work::kept::{Imported, StoreFault};
use std::collections::BTreeSet;

/// Tables whose rows begin a group, and the tables whose rows belong to them, with the column that refers to the first.
const HEADS: [(&str, &str, &[&str]); 3] = [
    (
        "survey",
        "survey",
        &[
            "environment",
            "tilt",
            "stated_mode",
            "stated_shape",
            "record",
            "channel",
        ],
    ),
    ("project", "project", &["project_file", "project_survey"]),
    ("analysis", "analysis", &["mode", "mode_point", "earthquake"]),
];
/// All tables, each after those that it refers to. The log is not copied.
const ORDER: [&str; 14] = [
    "raw",
    "structure",
    "survey",
    "arrival",
    "channel_fault",
    "stated_earthquake",
    "inspection_item",
    "made_up",
    "settings",
    "analysis",
    "survey_analysis",
    "project",
    "adoption",
    "mark",
];

impl Store {
    /// Copies everything from another store in one transaction. Raw files go first, so they are on disk before a row names them.
    ///
    /// # Errors
    /// If a raw file of the other store is missing or changed, or nothing can be written.
    pub fn import(&mut self, from: &mut Store, act: &Act<'_>) -> Result<Imported, StoreError> {
        refuse_name("who", act.who)?;
        from.database.begin_reading()?;
        let done = self.take_over(from, act);
        let _ = from.database.rollback(); // a reading transaction: nothing to undo
        done
    }

    fn take_over(&mut self, from: &mut Store, act: &Act<'_>) -> Result<Imported, StoreError> {
        let mut done = Imported {
            structures: 0,
            new_rows: 0,
            new_files: 0,
        };
        let (raw, from_raw) = (&self.raw, &from.raw);
        from.database
            .query("select hash, bytes from raw order by hash", &[], &mut |row| {
                if let [Value::Text(hash), Value::Whole(bytes)] = row.as_slice() {
                    let kept = raw.keep(&from_raw.read(hash, u64::try_from(*bytes).unwrap_or(0))?)?;
                    if kept.hash != *hash {
                        return Err(StoreFault::Raw { hash: hash.clone() }.into());
                    }
                    done.new_files += usize::from(kept.is_new);
                }
                Ok(())
            })?;
        let other = from.database.as_mut();
        transaction(self.database.as_mut(), |own| {
            for name in ORDER {
                let Some(table) = TABLES.iter().find(|table| table.name == name) else {
                    continue;
                };
                let mut new = BTreeSet::new();
                let sql = format!(
                    "select {} from {} order by {}",
                    table.names(),
                    table.name,
                    table.key
                );
                other.query(&sql, &[], &mut |row| {
                    done.structures += usize::from(table.name == "structure");
                    if table.insert(own, &row)? {
                        done.new_rows += 1;
                        if let Some(Value::Text(name)) = row.first() {
                            new.insert(name.clone());
                        }
                    }
                    Ok(())
                })?;
                let head = HEADS.iter().find(|(head, ..)| *head == name);
                if let Some((_, column, parts)) = head {
                    let parts = parts
                        .iter()
                        .filter_map(|part| TABLES.iter().find(|t| t.name == *part));
                    for part in parts {
                        done.new_rows += copy_parts(other, own, part, column, &new)?;
                    }
                }
            }
            insert(
                own,
                &LogRow {
                    at_us: act.now_us,
                    who: act.who.to_owned(),
                    verb: "import".to_owned(),
                    subject: String::new(),
                    detail: format!(
                        "{} structures, {} rows new, {} files new",
                        done.structures, done.new_rows, done.new_files
                    ),
                },
            )?;
            Ok(())
        })?;
        self.database.settle()?;
        Ok(done)
    }
}

/// Rows of a table that belong to one of the new first rows.
fn copy_parts(
    other: &mut dyn Database,
    own: &mut dyn Database,
    part: &Table,
    column: &str,
    new: &BTreeSet<String>,
) -> Result<usize, StoreError> {
    let at = part.columns.iter().position(|(name, _)| *name == column);
    let mut rows = 0;
    let sql = format!("select {} from {} order by {}", part.names(), part.name, part.key);
    other.query(&sql, &[], &mut |row| {
        let head = at.and_then(|at| row.get(at));
        if matches!(head, Some(Value::Text(name)) if new.contains(name)) {
            rows += usize::from(part.insert(own, &row)?);
        }
        Ok(())
    })?;
    Ok(rows)
}
