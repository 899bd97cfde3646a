//! Findings on a load factor, with the same words for chains, frames and buildings.

use crate::document::{Finding, Tone};
use dolmen::stability::Verdict;
use dolmen_words::{Quantity, messages};

messages! {
    /// Whether it stands, by its load factor.
    pub(crate) enum LoadFactor in "load-factor" {
        Unknown => { en: "Whether it stands is unknown.", ko: "안정 여부를 판정할 수 없다." },
        Unstable { factor: Quantity } => {
            en: "With this stiffness it falls under its own weight: the load factor λ is {factor}, and standing needs more than 1.",
            ko: "이 강성으로는 자중만으로도 안정을 유지하지 못한다. 하중배율 λ = {factor}이며, 안정하려면 1보다 커야 한다.",
        },
        Marginal { factor: Quantity, limit: Quantity } => {
            en: "With this stiffness it stands, but with little margin: it falls at {factor} times its weight; “stable” needs {limit}.",
            ko: "이 강성으로 안정하나 여유가 부족하다. 자중의 {factor}배에서 안정을 잃으며, ‘안정’ 판정에는 {limit}배가 필요하다.",
        },
        Stable { factor: Quantity, limit: Quantity } => {
            en: "With this stiffness it stands: it falls at {factor} times its weight; “stable” needs {limit}.",
            ko: "이 강성으로 안정하다. 자중의 {factor}배에서 안정을 잃으며, ‘안정’ 판정에는 {limit}배가 필요하다.",
        },
        UnstableSways { factor: Quantity } => {
            en: "With this stiffness it falls under its own weight: the load factor λ is {factor}, and standing needs more than 1.",
            ko: "이 강성으로는 자중만으로도 횡변위로 붕괴한다. 하중배율 λ = {factor}이며, 안정하려면 1보다 커야 한다.",
        },
        MarginalSways { factor: Quantity, limit: Quantity } => {
            en: "With this stiffness it stands, but with little margin: it falls at {factor} times its weight; “stable” needs {limit}.",
            ko: "이 강성으로 안정하나 여유가 부족하다. 하중이 자중의 {factor}배가 되면 횡변위로 붕괴하며, ‘안정’ 판정에는 {limit}배가 필요하다.",
        },
        StableSways { factor: Quantity, limit: Quantity } => {
            en: "With this stiffness it stands: it falls at {factor} times its weight; “stable” needs {limit}.",
            ko: "이 강성으로 안정하다. 하중이 자중의 {factor}배가 되면 횡변위로 붕괴하며, ‘안정’ 판정에는 {limit}배가 필요하다.",
        },
    }
}

/// How it falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Falls {
    /// It overturns, like a chain.
    Over,
    /// Its storeys sway down.
    BySway,
}

/// "It stands: …".
pub(crate) fn load_factor_finding(load_factor: f64, verdict: Verdict, falls: Falls) -> Finding {
    let factor = Quantity::beside_one(load_factor, 4);
    let limit = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
    let said = match (verdict, falls) {
        (Verdict::Unknown, _) => LoadFactor::Unknown,
        (Verdict::Unstable, Falls::Over) => LoadFactor::Unstable { factor },
        (Verdict::Marginal, Falls::Over) => LoadFactor::Marginal { factor, limit },
        (Verdict::Stable, Falls::Over) => LoadFactor::Stable { factor, limit },
        (Verdict::Unstable, Falls::BySway) => LoadFactor::UnstableSways { factor },
        (Verdict::Marginal, Falls::BySway) => LoadFactor::MarginalSways { factor, limit },
        (Verdict::Stable, Falls::BySway) => LoadFactor::StableSways { factor, limit },
    };
    Finding::key(Tone::of(verdict), said).with_code("load-factor")
}
