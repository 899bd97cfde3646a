//! Texts of errors: their causes, each with the remedy in the project file or in the command.

use crate::change_fault::ChangeFault;
use crate::error::WorkError;
use crate::portfolio::PortfolioError;
use crate::wrong::of_work;
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::comparisons::ValidationError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::BuildingError;
use dolmen_project::{DamperFault, headed};
use dolmen_records::motions::MotionError;
use dolmen_records::records::RecordError;
use dolmen_words::Language;
use dolmen_words::advice::advice;
use dolmen_words::errors::text_of;
use dolmen_words::message::{Argument, Both};
use dolmen_words::said_by_system;
use std::error::Error;

/// The error of the library inside an error of a higher layer.
fn handed_on<'a>(cause: &'a (dyn Error + 'static)) -> &'a (dyn Error + 'static) {
    let boxed = || cause.downcast_ref::<Box<WorkError>>().map(Box::as_ref); // the cause within a place
    if let Some(work) = cause.downcast_ref::<WorkError>().or_else(boxed) {
        return work.handed_on().map_or(cause, handed_on);
    }
    if let Some(RecordError::Signal(why)) = cause.downcast_ref() {
        return why;
    }
    match cause.downcast_ref() {
        Some(MotionError::Signal(why)) => return why,
        Some(MotionError::Record(why)) => return handed_on(why),
        _ => {}
    }
    match cause.downcast_ref() {
        Some(DamperFault::Tuning(why)) => return why,
        Some(DamperFault::Place { why, .. }) => return why,
        _ => {}
    }
    match cause.downcast_ref() {
        Some(ChangeFault::Assess(why)) => why,
        Some(ChangeFault::Monitoring(why)) => why,
        _ => cause,
    }
}

/// An error and its causes.
fn chain<'e>(fault: &'e (dyn Error + 'static)) -> impl Iterator<Item = &'e (dyn Error + 'static)> {
    let mut next = Some(fault);
    std::iter::from_fn(move || {
        let cause = next?;
        next = cause.source();
        Some(cause)
    })
}

/// An error with its causes in one line, each with the remedy in the project file or in the command; in English.
pub fn told(fault: &(dyn Error + 'static)) -> String {
    told_in(fault, Language::English)
}

/// The same in both languages.
pub fn told_both(fault: &(dyn Error + 'static)) -> Both {
    Both::of(|language| told_in(fault, language))
}

/// The same in one language. Messages of the system, a database or another library keep their own.
pub fn told_in(fault: &(dyn Error + 'static), language: Language) -> String {
    told_by(fault, language, &|_| None)
}

/// The same, including errors of crates above that `others` knows.
pub fn told_by(fault: &(dyn Error + 'static), language: Language, others: Sayable<'_>) -> String {
    let each = chain(fault).map(|cause| {
        let advice =
            advice(handed_on(cause)).map_or_else(String::new, |advice| advice.text(language).to_owned());
        format!("{}{advice}", said(cause, language, others))
    });
    short_numbers(&each.collect::<Vec<_>>().join(": "))
}

/// Errors with texts in both languages.
pub type Sayable<'o> = &'o dyn for<'e> Fn(&'e (dyn Error + 'static)) -> Option<&'e dyn Argument>;

/// The same as printed on a terminal, with "error: " before it.
pub fn complaint(fault: &(dyn Error + 'static), language: Language, others: Sayable<'_>) -> String {
    let text = told_by(fault, language, others);
    let starts = [Language::English, Language::Korean].map(|language| headed("", language));
    match starts
        .iter()
        .any(|start| text.starts_with(start.trim_end_matches([':', ' '])))
    {
        true => text,
        false => headed(&text, language),
    }
}

/// An error without its causes.
fn said(cause: &(dyn Error + 'static), language: Language, others: Sayable<'_>) -> String {
    match others(cause).or_else(|| of_work(cause)) {
        Some(known) => text_of(known, language),
        None => match cause.downcast_ref::<std::io::Error>() {
            Some(system) => said_by_system(system).text(language).to_owned(),
            None => cause.to_string(),
        },
    }
}

/// Writes numbers of more than 15 digits with a power of ten: an error may quote 1e300.
fn short_numbers(text: &str) -> String {
    const DIGITS_MOST: usize = 15;
    const SMALL: f64 = 1e-6;
    const LARGE: f64 = 1e15;
    let mut short = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, number) = rest.split_at(start);
        let is_number = |c: char| c.is_ascii_digit() || c == '.';
        let end = number.find(|c| !is_number(c)).unwrap_or(number.len());
        let (number, after) = number.split_at(end);
        short.push_str(before);
        match number.parse::<f64>() {
            // a date without separators, or a checksum, is not a number
            Ok(value)
                if number.len() > DIGITS_MOST
                    && !(SMALL..LARGE).contains(&value)
                    && !before.ends_with(char::is_alphabetic) =>
            {
                short.push_str(&format!("{value:e}"));
            }
            _ => short.push_str(number),
        }
        rest = after;
    }
    short + rest
}

/// Whether an error, or one of its causes, is a computation that did not converge or finish.
pub fn did_not_converge(fault: &(dyn Error + 'static)) -> bool {
    chain(fault).any(|cause| is_of_no_convergence(handed_on(cause)))
}

fn is_of_no_convergence(cause: &(dyn Error + 'static)) -> bool {
    fn is<E: Error + 'static>(cause: &(dyn Error + 'static), ask: fn(&E) -> bool) -> bool {
        cause.downcast_ref().is_some_and(ask)
    }
    let in_a_row = |fault: &PortfolioError| matches!(fault, PortfolioError::Refused { why, .. } if why.did_not_converge());
    is(cause, StructureError::did_not_converge)
        || is(cause, BuildingError::did_not_converge)
        || is(cause, StabilityError::did_not_converge)
        || is(cause, DynamicsError::did_not_converge)
        || is(cause, BlocksError::did_not_converge)
        || is(cause, DamperError::did_not_converge)
        || is(cause, ModalError::did_not_converge)
        || is(cause, AssessError::did_not_converge)
        || is(cause, ValidationError::did_not_converge)
        || is(cause, in_a_row)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Within as _;
    use dolmen::signal::SignalError;

    #[test]
    fn exact_numbers_of_many_digits_are_short() {
        assert_eq!(short_numbers("0.06646796935220563"), "0.06646796935220563");
        let long = format!("step is {}, but 0.5 s; end_s is {} or 12.", 1e300, 1e-300);
        assert_eq!(
            short_numbers(&long),
            "step is 1e300, but 0.5 s; end_s is 1e-300 or 12."
        );
        assert_eq!(
            short_numbers("record-20090512, 1.25 of 3"),
            "record-20090512, 1.25 of 3"
        );
    }

    #[test]
    fn holds_advice_and_convergence_are_seen_within_a_place() {
        let no_start = RecordError::Signal(SignalError::NoStart { channel: "a".into() });
        let fault = Err::<(), _>(no_start)
            .within(|| "survey one".to_owned())
            .unwrap_err();
        assert_eq!(
            told(&fault),
            "survey one: channel \"a\" does not say when it begins: give its begins, or starts = \"together\" if all began at one instant"
        );
        let no_rest = BlocksError::NoRest {
            iterations: 9,
            residual: 0.1,
            block: "a".into(),
        };
        let fault = Err::<(), _>(no_rest).within(|| "a place".to_owned()).unwrap_err();
        assert!(did_not_converge(&fault));
    }
}
