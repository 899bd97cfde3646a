//! Reads `[limits]`.

use super::file::{ImportanceRaw, LimitCodeRaw, LimitsRaw, NonStructuralRaw};
use crate::error::Fault;
use crate::file::KindRaw;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::{Common, WrongLimits};
use dolmen::assess::demand::{DRIFT_RATIO_MOST, DriftLimit, ImportanceClass, NonStructural, SeismicGrade};

const PATH: &str = "limits";

/// The allowable drift; a fault for kinds without storeys.
pub(crate) fn limits(
    reader: &mut Reader,
    raw: Option<&At<LimitsRaw>>,
    kind: Option<KindRaw>,
) -> Option<DriftLimit> {
    let raw = raw?;
    reader.mark(PATH, &raw.span);
    if !matches!(kind, Some(KindRaw::Frame | KindRaw::Building) | None) {
        let message = WrongLimits::LimitsHoldsAllowableDrifts;
        let fault = Fault::new(raw.span.clone(), PATH, message).allowed(Common::NoMeaningHere);
        reader.fault(fault.help(WrongLimits::TakeItOutJoints));
        return None;
    }
    let given = &raw.value;
    match (&given.code, &given.storey_drift) {
        (Some(_), Some(drift)) => {
            let fault = Fault::new(drift.span.clone(), PATH, WrongLimits::LimitsHasBothCode);
            reader.fault(fault.help(Common::KeepOneOfThem));
            None
        }
        (None, None) => {
            if !reader.is_reported("limits.code") && !reader.is_reported("limits.storey_drift") {
                let message = WrongLimits::LimitsHasNeitherCode;
                let fault = Fault::new(raw.span.clone(), PATH, message);
                let help = WrongLimits::WriteCodeKdsWith;
                reader.fault(fault.help(help));
            }
            None
        }
        (None, Some(_)) => own(reader, given),
        (Some(code), None) => of_code(reader, raw, code.value),
    }
}

/// An allowable drift as written.
fn own(reader: &mut Reader, given: &LimitsRaw) -> Option<DriftLimit> {
    const AT: &str = "limits.storey_drift";
    for (key, span) in [
        ("importance", given.importance.as_ref().map(|at| &at.span)),
        ("non_structural", given.non_structural.as_ref().map(|at| &at.span)),
    ] {
        if let Some(span) = span {
            let message = WrongLimits::LimitsGoesWithCode { key: key.to_string() };
            reader.fault(
                Fault::new(span.clone(), &format!("{PATH}.{key}"), message).help(Common::KeepOneOfThem),
            );
            return None;
        }
    }
    let raw = given.storey_drift.as_ref();
    let ratio = reader.plain(raw, AT, Measure::Tilt, Bound::Positive)?;
    if ratio > DRIFT_RATIO_MOST {
        let span = raw.map_or(0..0, |raw| raw.span.clone());
        let message = WrongLimits::IsOfHeight {
            key: AT.to_string(),
            ratio: short(ratio),
        };
        let fault = Fault::new(span, AT, message).allowed(WrongLimits::MustBeAtMost);
        reader.fault(fault.help(WrongLimits::DidYouMeanPer));
        return None;
    }
    let source = given.source.as_ref().map(|source| source.value.clone());
    Some(DriftLimit::Given { ratio, source })
}

fn of_code(reader: &mut Reader, raw: &At<LimitsRaw>, code: LimitCodeRaw) -> Option<DriftLimit> {
    const AT: &str = "limits.importance";
    let given = &raw.value;
    let allowed = match code {
        LimitCodeRaw::Kds41 => WrongLimits::MustBeSpecialI,
        LimitCodeRaw::Eurocode8 => WrongLimits::MustBeIIi,
    };
    let Some(importance) = &given.importance else {
        if !reader.is_reported(AT) {
            let fault = Fault::new(raw.span.clone(), AT, WrongLimits::LimitsHasNoImportance);
            reader.fault(fault.allowed(allowed).help(WrongLimits::WriteImportanceI));
        }
        return None;
    };
    if let (LimitCodeRaw::Kds41, Some(other)) = (code, &given.non_structural) {
        let path = "limits.non_structural";
        let message = WrongLimits::LimitsNonStructuralHas;
        reader.fault(Fault::new(other.span.clone(), path, message).help(Common::TakeItOut));
        return None;
    }
    use ImportanceRaw::{I, Ii, Iii, Iv, Special};
    let limit = match (code, importance.value) {
        (LimitCodeRaw::Kds41, Special) => DriftLimit::Kds41(SeismicGrade::Special),
        (LimitCodeRaw::Kds41, I) => DriftLimit::Kds41(SeismicGrade::First),
        (LimitCodeRaw::Kds41, Ii) => DriftLimit::Kds41(SeismicGrade::Second),
        (LimitCodeRaw::Eurocode8, class @ (I | Ii | Iii | Iv)) => DriftLimit::Eurocode8 {
            importance: match class {
                I => ImportanceClass::First,
                Ii => ImportanceClass::Second,
                Iii => ImportanceClass::Third,
                Special | Iv => ImportanceClass::Fourth,
            },
            non_structural: match given.non_structural.as_ref().map(|of| of.value) {
                Some(NonStructuralRaw::Brittle) | None => NonStructural::Brittle,
                Some(NonStructuralRaw::Ductile) => NonStructural::Ductile,
                Some(NonStructuralRaw::None) => NonStructural::None,
            },
        },
        (LimitCodeRaw::Kds41, Iii | Iv) | (LimitCodeRaw::Eurocode8, Special) => {
            let fault = Fault::new(importance.span.clone(), AT, WrongLimits::ThisClassIsOf);
            reader.fault(fault.allowed(allowed));
            return None;
        }
    };
    Some(limit)
}
