//! Bounds of numbers; numbers out of bounds are reported.

use super::error::Fault;
use super::file_number::At;
use super::measure::Bound;
use super::reader::Reader;
use super::written::short;
use super::wrong::{Common, WrongNumber};
use dolmen_words::message::Both;
use std::ops::Range;

impl Reader<'_> {
    /// A coefficient of variation, which must be 0 to 1.
    pub(super) fn cov(&mut self, cov: f64, written: &At<f64>, path: &str) -> Option<f64> {
        if (0.0..=1.0).contains(&cov) {
            return Some(cov);
        }
        let given = short(written.value);
        let fault = Fault::new(
            written.span.clone(),
            path,
            WrongNumber::CovOutsideRange {
                path: path.to_string(),
                given: given.to_string(),
            },
        );
        let (allowed, help): (Both, _) = if path.ends_with(".sd") {
            (WrongNumber::SdRange.into(), WrongNumber::SdUnit)
        } else {
            (Common::ZeroToOne.into(), WrongNumber::CovIsStandardDeviation)
        };
        self.fault(fault.allowed(allowed).help(help));
        None
    }

    /// Checks that a value is finite and within its bound.
    pub(super) fn bounded(
        &mut self,
        value: f64,
        written: &str,
        span: &Range<usize>,
        path: &str,
        bound: Bound,
    ) -> Option<()> {
        let fits = match bound {
            Bound::Positive => value > 0.0,
            Bound::NotNegative => value >= 0.0,
            Bound::Any => true,
        };
        if fits && value.is_finite() {
            return Some(());
        }
        let allowed: Both = match bound {
            Bound::Positive => WrongNumber::AboveZero.into(),
            Bound::NotNegative => Common::ZeroOrMore.into(),
            Bound::Any => WrongNumber::Finite.into(),
        };
        let message = if value.is_nan() {
            WrongNumber::IsNotNumber(path.to_string())
        } else {
            WrongNumber::CannotBe {
                path: path.to_string(),
                written: written.to_string(),
            }
        };
        self.fault(Fault::new(span.clone(), path, message).allowed(allowed));
        None
    }

    /// A plain number in a closed range.
    pub(super) fn within(
        &mut self,
        number: Option<&At<f64>>,
        path: &str,
        least: f64,
        most: f64,
    ) -> Option<f64> {
        let number = number?;
        if (least..=most).contains(&number.value) {
            return Some(number.value);
        }
        let message = WrongNumber::OutsideRange {
            path: path.to_string(),
            number: short(number.value),
        };
        let allowed = WrongNumber::MustBeWithin {
            least: short(least),
            most: short(most),
        };
        self.fault(Fault::new(number.span.clone(), path, message).allowed(allowed));
        None
    }

    /// A whole number in a closed range.
    pub(super) fn count(
        &mut self,
        number: Option<&At<i64>>,
        path: &str,
        least: usize,
        most: usize,
    ) -> Option<usize> {
        let number = number?;
        let count = usize::try_from(number.value)
            .ok()
            .filter(|count| (least..=most).contains(count));
        if count.is_none() {
            let message = WrongNumber::OutsideRange {
                path: path.to_string(),
                number: number.value.to_string(),
            };
            let allowed = WrongNumber::MustBeWithin {
                least: least.to_string(),
                most: most.to_string(),
            };
            self.fault(Fault::new(number.span.clone(), path, message).allowed(allowed));
        }
        count
    }
}
