// SOURCE     every source of `dolmen::comparisons`.
// GOAL       Its published and computed values, computed once for all tests.

use dolmen::comparisons::{Case, cases};
use std::sync::LazyLock;

static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases().unwrap());

/// The cases of one source, each of which agrees.
#[track_caller]
pub(crate) fn of(source: &str) -> Vec<&'static Case> {
    let cases: Vec<&Case> = CASES.iter().filter(|case| case.source == source).collect();
    for case in &cases {
        assert!(
            case.agrees(),
            "{}: {} against {}",
            case.what,
            case.computed,
            case.published
        );
    }
    cases
}
