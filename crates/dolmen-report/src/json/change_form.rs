//! The form of a change, as JSON.

use dolmen::monitoring::ChangeForm;

/// "step", "slope".
pub(super) fn form(of: ChangeForm) -> &'static str {
    match of {
        ChangeForm::Step => "step",
        ChangeForm::Slope => "slope",
    }
}
