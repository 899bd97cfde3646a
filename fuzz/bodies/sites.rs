//! Any bytes are a list of structures to rank, each with a name of its own, or an error.

use dolmen_work::portfolio::read_portfolio;
use std::collections::BTreeSet;

pub(super) fn run(bytes: &[u8]) {
    if let Ok(table) = read_portfolio(bytes, "list.csv") {
        let names: BTreeSet<&str> = table.rows.iter().map(|row| row.name.as_str()).collect();
        assert_eq!(names.len(), table.rows.len());
    }
}
