//! Any bytes are a filled form of the score or an error; what a form says is a project file that is read or refused.

use dolmen_project::parse_project;
use dolmen_records::read_score_form;

pub(super) fn run(bytes: &[u8]) {
    if let Ok(form) = read_score_form(bytes) {
        assert!(form.factors.iter().all(|(_, value)| value.is_finite()));
        if let Err(error) = parse_project(&form.project_text(), "form.xlsx") {
            // never the text that we wrote around the numbers
            assert!(!error.problems.is_empty(), "{error}");
        }
    }
}
