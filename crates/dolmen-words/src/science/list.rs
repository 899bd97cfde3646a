//! Every error of the library.

use crate::message::Argument;
use crate::sayable;
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::comparisons::ValidationError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::monitoring::MonitoringError;
use dolmen::numeric::NumericError;
use dolmen::signal::SignalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::{BuildingError, PlanStiffnessError};
use dolmen::structure::stack::{SliceError, StackError};
use dolmen::structure::wind::WindError;
use dolmen_linalg::LinalgError;
use std::error::Error;

/// The text of an error of the library in both languages; `None` for any other error.
pub fn of_the_science<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(
        error,
        AssessError,
        BlocksError,
        BuildingError,
        DamperError,
        DynamicsError,
        LinalgError,
        ModalError,
        MonitoringError,
        NumericError,
        PlanStiffnessError,
        SignalError,
        StabilityError,
        SliceError,
        StackError,
        StructureError,
        ValidationError,
        WindError,
    )
}
