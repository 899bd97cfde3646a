//! Parts of a code that were not checked against its text.

use dolmen::assess::demand::{SiteDemand, Unverified};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits of a code's own numbers.
const DIGITS: usize = 6;

messages! {
    /// Parts of a code that were not compared with its text.
    pub(crate) enum NotHeld in "demand.unverified" {
        All(all: Vec<Sentence>) => {
            en: "Of the code these are not held against its text: {all}.",
            ko: "기준 원문과 대조하지 않은 값: {all}.",
        },
        Edition(year: Quantity) => { en: "the year {year} of the edition", ko: "기준의 판({year}년)" },
        RiskFactor { years: Quantity, factor: Quantity } => {
            en: "the risk factor {factor} of {years} years",
            ko: "재현주기 {years}년의 위험도계수 {factor}",
        },
        VerticalRatio(ratio: Quantity) => { en: "the vertical ratio {ratio}", ko: "수직/수평 가속도비 {ratio}" },
        DampingFactor(damping: Quantity) => {
            en: "the factor of other damping than {damping}",
            ko: "감쇠비 {damping} 이외의 감쇠보정계수",
        },
        DampingAtShortPeriods => {
            en: "the factor of damping between T = 0 and T_0",
            ko: "T = 0과 T_0 사이의 감쇠보정계수",
        },
        LongPeriods(period: Quantity) => {
            en: "{period} as the beginning of the 1/T² branch",
            ko: "1/T² 구간이 시작되는 주기 {period}",
        },
        Shape => { en: "the shape of the spectrum between its numbers", ko: "스펙트럼의 구간별 형상" },
    }
}

/// The sentence that names all of them; `None` if there are none.
pub(super) fn unverified(site: &SiteDemand) -> Option<Sentence> {
    let all: Vec<Sentence> = site.spectrum.unverified.iter().map(one).collect();
    (!all.is_empty()).then(|| NotHeld::All(all).into())
}

fn one(what: &Unverified) -> Sentence {
    let number = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Trimmed(DIGITS));
    match what {
        Unverified::Edition { year } => NotHeld::Edition(number(f64::from(*year))),
        Unverified::RiskFactor {
            return_period_years,
            factor,
        } => NotHeld::RiskFactor {
            years: number(f64::from(*return_period_years)),
            factor: number(*factor),
        },
        Unverified::VerticalRatio { ratio } => NotHeld::VerticalRatio(number(*ratio)),
        Unverified::DampingFactor => {
            NotHeld::DampingFactor(Quantity::new(0.05, Unit::percent(), Digits::Trimmed(DIGITS)))
        }
        Unverified::DampingAtShortPeriods => NotHeld::DampingAtShortPeriods,
        Unverified::LongPeriods { displacement_s } => NotHeld::LongPeriods(Quantity::new(
            *displacement_s,
            Unit::si("s"),
            Digits::Trimmed(DIGITS),
        )),
        Unverified::Shape => NotHeld::Shape,
    }
    .into()
}
