//! Cells of a ranking, in English and Korean.

use super::answer::{Basis, PortfolioEntry};
use crate::study::YEARS;
use dolmen::assess::{Factor, Known, KnownCapacity, Unlike, UnlikeQuantity};
use dolmen_words::message::Both;
use dolmen_words::number::significant;
use dolmen_words::{Language, Sentence, messages};

/// Name of a factor, with its unit.
pub fn factor_words(factor: Factor, language: Language) -> &'static str {
    match factor {
        Factor::Storeys => language.pick("storeys", "층수"),
        Factor::BodyHeight => language.pick("body height, m", "탑신 높이 (m)"),
        Factor::SlendernessAngle => language.pick("tan α", "세장각 tan α"),
        Factor::BodySlenderness => language.pick("body slenderness λ", "탑신 세장비 λ"),
        Factor::Taper => language.pick("taper φ, deg", "체감도 φ (°)"),
        Factor::BodyBaseHeightRatio => language.pick("body/base height", "탑신/기단 높이비"),
    }
}

/// Probability within [`YEARS`] of an event with a given annual rate.
pub fn probability_in_years(annual_rate: f64) -> f64 {
    -(-annual_rate * YEARS).exp_m1()
}

/// Source of a capacity, as a word for tables.
pub fn known_word(known: Known) -> &'static str {
    match known {
        Known::Found => "found",
        Known::AtLeast => "at_least",
        Known::AtMost => "at_most",
    }
}

/// Source of a capacity, with the variant or the set values of its study.
pub fn basis_words(entry: &PortfolioEntry, language: Language) -> String {
    let basis = plain_basis_words(entry, language);
    let Basis::Study { variant, set, .. } = &entry.basis else {
        return basis;
    };
    let version: Vec<String> = variant.iter().chain(set).cloned().collect();
    match version.is_empty() {
        true => basis,
        false => text(
            BasisSaid::OfVersion {
                basis: Both::from(basis),
                version,
            },
            language,
        ),
    }
}

fn plain_basis_words(entry: &PortfolioEntry, language: Language) -> String {
    match &entry.basis {
        Basis::Study {
            name,
            scans,
            fell_alone: 0,
            ..
        } => text(
            BasisSaid::Study {
                name: name.clone(),
                scans: *scans,
            },
            language,
        ),
        Basis::Study {
            name,
            scans,
            fell_alone,
            ..
        } => {
            let fell = BasisSaid::FellAlone {
                name: name.clone(),
                scans: *scans,
                share: significant(100.0 * *fell_alone as f64 / *scans as f64, 2),
            };
            text(fell, language)
        }
        Basis::Score { outside, unlike, .. } if outside.is_empty() && unlike.is_empty() => {
            text(BasisSaid::Score, language)
        }
        Basis::Score { outside, unlike, .. } => {
            let why = Both::of(|language| {
                let names = outside
                    .iter()
                    .map(|factor| factor_words(*factor, language).to_owned());
                let names = names.chain(unlike.iter().map(|one| unlike_words(one, language)));
                names.collect::<Vec<String>>().join("; ")
            });
            text(BasisSaid::Extrapolated { why }, language)
        }
    }
}

messages! {
    /// What a capacity rests on.
    pub enum BasisSaid in "rank.basis" {
        Study { name: String, scans: usize } => { en: "study {name}, {scans} scans", ko: "해석 {name}, 증분해석 {scans}건" },
        FellAlone { name: String, scans: usize, share: String } => {
            en: "study {name}, {scans} scans, {share} % FALL BY THEMSELVES",
            ko: "해석 {name}, 증분해석 {scans}건 중 {share} %는 자중으로 붕괴",
        },
        OfVersion { basis: Both, version: Vec<String> } => { en: "{basis}, of {version}", ko: "{basis}({version})" },
        Score => { en: "score", ko: "점수" },
        Extrapolated { why: Both } => { en: "score, EXTRAPOLATED: {why}", ko: "점수(학습 범위 밖: {why})" },
    }
}

fn text(message: BasisSaid, language: Language) -> String {
    Sentence::from(message).text(language)
}

/// The median over all scans in g, including those that fall under their own weight, with the sign of a bound.
pub fn capacity_words(capacity: &KnownCapacity, gravity_m_s2: f64) -> String {
    let theta = capacity.fragility.theta();
    let g = significant(capacity.median(theta).unwrap_or(theta) / gravity_m_s2, 2);
    match capacity.known {
        Known::Found => g,
        Known::AtLeast => format!("> {g}"),
        Known::AtMost => format!("< {g}"),
    }
}

/// The factor that lowers the capacity most, and its contribution.
pub fn reason_words(entry: &PortfolioEntry, language: Language) -> String {
    match entry.worst_factor() {
        Some((factor, share)) => {
            let percent = 100.0 * share.exp_m1();
            let percent = format!("{percent:+.0}").replace('-', "−");
            format!("{}: {percent} %", factor_words(factor, language))
        }
        None => "–".to_owned(),
    }
}

/// Differences of a pagoda from the designs of the score other than in its factors.
pub fn unlike_words(unlike: &Unlike, language: Language) -> String {
    let korean = match unlike {
        Unlike::Quantity {
            quantity,
            given,
            trained,
        } => format!("{} {given}(학습값 {trained})", quantity_korean(*quantity)),
        Unlike::Bonds => "접합면이 부착됨(학습 조건: 부착 없음)".to_owned(),
        Unlike::Ties => "촉 또는 은장이 있음(학습 조건: 없음)".to_owned(),
        Unlike::SideSupports => "측면 지지가 있음(학습 조건: 없음)".to_owned(),
        Unlike::Loads => "정하중이 작용함(학습 조건: 없음)".to_owned(),
        Unlike::SupportsMove => "지점이 이동함(학습 조건: 지점 고정)".to_owned(),
        Unlike::Crushes { strength_pa } => format!(
            "모서리가 {:.3} MPa에서 압괴됨(학습 조건: 압괴 없음)",
            strength_pa / 1e6
        ),
        Unlike::Damage { count } => format!("점검에서 손상 {count}건 발견(학습 조건: 손상 없음)"),
        Unlike::Leans { slope } => format!("기울기 1/{:.0}(학습 조건: 연직)", 1.0 / slope),
        Unlike::Frequency {
            measured_hz,
            computed_hz,
        } => format!("실측 고유진동수 {measured_hz:.2} Hz(학습 조건의 탑: {computed_hz:.2} Hz)"),
    };
    language.pick(unlike.to_string(), korean)
}

/// Korean name of an [`Unlike::Quantity`].
fn quantity_korean(quantity: UnlikeQuantity) -> &'static str {
    match quantity {
        UnlikeQuantity::Friction => "마찰계수",
        UnlikeQuantity::KineticFriction => "동마찰계수",
        UnlikeQuantity::NormalStiffness => "접합면 수직강성 (Pa/m)",
        UnlikeQuantity::ShearStiffness => "접합면 전단강성 (Pa/m)",
        UnlikeQuantity::DampingRatio => "접합면 감쇠비",
        UnlikeQuantity::Density => "밀도 (kg/m³)",
    }
}
