//! Findings of a chain's check.

use super::across::{of_across, of_along};
use crate::document::{Finding, Tone};
use crate::load_factor::{Falls, load_factor_finding};
use dolmen::assess::{CentroidEffect, ChainCheck};
use dolmen::stability::{ChainLimits, ChainStability, Verdict};
use dolmen_project::ChainPart;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// A change of a limit below this share is rounding, not a rise.
pub(super) const RISE_LEAST: f64 = 1e-6;

messages! {
    /// Findings on a chain.
    pub(crate) enum Found in "chain.findings" {
        StiffnessUnknown(equal: Quantity) => {
            en: "Whether it stands is unknown: the stiffness of the joints is not given. If all joints are equal, each needs more than {equal}.",
            ko: "접합부 강성이 주어지지 않아 안정 여부를 판정할 수 없다. 모든 접합면의 강성이 같다면 각각 {equal}보다 커야 한다.",
        },
        FailingJoint(joint: usize) => {
            en: "Seen from the top, joint {joint} is the first that cannot hold what stands on it. No single joint need be at fault: the stiffnesses count together.",
            ko: "위에서부터 볼 때 접합면 {joint}이(가) 상부를 지탱하지 못하는 첫 접합면이다. 한 접합면만의 문제라고 할 수는 없으며 강성은 함께 작용한다.",
        },
        Weakest { joint: usize, below: Sentence, margin: Quantity, may_lose: Quantity } => {
            en: "Joint {joint}{below} has the least margin: {margin} times the stiffness at which the chain would just stand, the others as they are. It may lose {may_lose} of its stiffness before the chain falls.",
            ko: "지배 접합면은 접합면 {joint}{below}이다. 다른 접합면을 그대로 둘 때 안정 한계 강성의 {margin}배이며, 강성이 {may_lose} 저하되면 안정을 잃는다.",
        },
        Below(part: String) => { en: " (below ‘{part}’)", ko: "(‘{part}’ 하부)" },
        Unnamed => { en: "", ko: "" },
        SingleJoint => {
            en: "With a single joint the published critical stiffness and the exact limit are the same.",
            ko: "접합면이 하나이므로 발표된 임계강성과 정확한 한계가 같다.",
        },
        Unsafe(need: Sentence) => {
            en: "The published critical stiffness k_cr is unsafe: it sets each diagonal term of the stiffness matrix to zero; a symmetric matrix with zero diagonal and non-zero off-diagonals is indefinite, so a pole with those stiffnesses falls; {need}.",
            ko: "발표된 임계강성 k_cr은 안전측이 아니다. 강성행렬의 대각항을 모두 0으로 두는데, 대각항이 0이고 비대각항이 0이 아닌 대칭행렬은 음의 강성을 가지므로 그 강성을 가진 당간은 안정하지 않다. {need}.",
        },
        NeedTimes(factor: Quantity) => {
            en: "the joints need {factor} times as much",
            ko: "접합부에는 그 {factor}배의 강성이 필요하다",
        },
        NeedNone => {
            en: "no common factor makes them enough, since one of them is not positive",
            ko: "그중 하나가 양수가 아니므로 어떤 배수로도 충분해지지 않는다",
        },
        BucklingTooLow(factor: Quantity) => {
            en: "The published P·H (buckling of a post on one spring) is not enough either: taken in every joint at once, it must be multiplied by {factor}.",
            ko: "발표된 좌굴 임계강성 P·H도 충분하지 않다. 모든 접합면에 동시에 적용하면 {factor}배가 필요하다.",
        },
        BucklingEnough(factor: Quantity) => {
            en: "The published P·H (buckling of a post on one spring) would be enough here: taken in every joint at once, {factor} of it suffices.",
            ko: "발표된 좌굴 임계강성 P·H는 이 경우 충분하다. 모든 접합면에 동시에 적용하면 그 {factor}배로 충분하다.",
        },
        PassesPublished => {
            en: "Every given stiffness is above the published k_cr, and yet the chain falls.",
            ko: "주어진 강성이 모두 발표된 k_cr보다 크지만 안정하지 않다.",
        },
        NoFrequencies => {
            en: "Natural frequencies are unknown: they need the stiffness of the joints.",
            ko: "고유진동수는 알 수 없다. 접합부 강성이 필요하다.",
        },
        LowestFalls => {
            en: "It does not vibrate in its lowest shape, it falls in it.",
            ko: "최저차 형상에서는 진동하지 않고 안정을 잃는다.",
        },
        LowestMode(frequency: Quantity) => {
            en: "Its lowest natural frequency is {frequency} (undamped, on the stiffness above).",
            ko: "최저 고유진동수는 {frequency}이다(비감쇠, 위의 강성 기준).",
        },
        Lowering { joint: usize, rise: Quantity, link: usize, change: Quantity } => {
            en: "Lowering a centre of mass can only help: no exact limit rises. By the published criterion k_cr of joint {joint} would rise by {rise} when that of link {link} is lowered by {change}: an artefact of that criterion.",
            ko: "무게중심을 낮추면 항상 유리하며 정확한 한계는 어느 것도 커지지 않는다. 발표된 기준으로는 접합면 {joint}의 k_cr이 {rise} 커지는데(부재 {link}의 무게중심을 {change} 낮춘 경우), 이는 그 기준의 오류이다.",
        },
    }
}

/// The findings, the most important first.
pub(crate) fn findings(part: &ChainPart, check: &ChainCheck) -> Vec<Finding> {
    let mut all = match &check.across {
        Some(_) if check.stability.is_some() => Vec::new(),
        _ => vec![stands(check)],
    };
    all.extend(super::across::findings(check));
    let weakest = |stability: &ChainStability| weakest(part, stability);
    let along = check.stability.as_ref().and_then(weakest);
    all.extend(along.map(|finding| of_along(check, finding)));
    let across = check.across.as_ref().and_then(|across| across.stability.as_ref());
    all.extend(across.and_then(weakest).map(of_across));
    all.extend(passes_published(check));
    all.push(of_along(check, lowest_mode(check)));
    all.extend(check.on_soil.as_ref().map(super::soil::finding));
    all.extend(super::side_supports::findings(check));
    all.extend(super::one_stone::finding(check));
    // published criteria decide nothing: they are mentioned only where a user might use them instead of the stiffness
    if check.stability.is_none() {
        all.push(published(&check.limits));
        all.push(buckling(&check.limits));
        all.extend(centroids(check));
    }
    all
}

/// Verdict and load factor; the required stiffness if the joints are unknown.
fn stands(check: &ChainCheck) -> Finding {
    match &check.stability {
        None => Finding::key(
            Tone::Unknown,
            Found::StiffnessUnknown(Quantity::engineering(
                check.limits.equal_joints_n_m_rad,
                "N·m/rad",
                4,
            )),
        )
        .with_code("joints-unknown"),
        Some(stability) => load_factor_finding(stability.load_factor, stability.verdict, Falls::Over),
    }
}

fn weakest(part: &ChainPart, stability: &ChainStability) -> Option<Finding> {
    if let Some(joint) = stability.failing_joint {
        return Some(Finding::key(Tone::Bad, Found::FailingJoint(joint)));
    }
    let joints = stability.joints.iter().enumerate();
    let margins = joints.filter_map(|(i, joint)| Some((i + 1, joint.margin?)));
    let (joint, margin) = margins.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let name = part.links.get(joint - 1).and_then(|link| link.name.clone());
    let found = Found::Weakest {
        joint,
        below: name.map_or(Found::Unnamed, Found::Below).into(),
        margin: Quantity::beside_one(margin, 3),
        may_lose: Quantity::percent(1.0 - 1.0 / margin, 2),
    };
    Some(Finding::key(Tone::of(Verdict::of_load_factor(margin)), found))
}

/// The published criterion, and why it is unsafe.
fn published(limits: &ChainLimits) -> Finding {
    let least = limits.published_eigenvalues_n_m_rad.first();
    match limits.published_critical_n_m_rad.len() < 2 || least.copied().unwrap_or(0.0) >= 0.0 {
        true => Finding::new(Tone::Plain, Found::SingleJoint),
        false => Finding::new(Tone::Plain, why_unsafe(limits)).with_code("unsafe-criterion"),
    }
}

/// The sentence on why the published criterion and the exact one differ.
pub(super) fn why_unsafe(limits: &ChainLimits) -> Sentence {
    let need = match limits.published_critical_factor {
        Some(factor) => Found::NeedTimes(Quantity::ratio(factor, 3)),
        None => Found::NeedNone,
    };
    Found::Unsafe(need.into()).into()
}

fn buckling(limits: &ChainLimits) -> Finding {
    let factor = Quantity::beside_one(limits.published_buckling_factor, 4);
    match limits.published_buckling_factor > 1.0 {
        true => Finding::new(Tone::Plain, Found::BucklingTooLow(factor)),
        false => Finding::new(Tone::Plain, Found::BucklingEnough(factor)),
    }
}

/// A chain that satisfies the published criterion but falls.
fn passes_published(check: &ChainCheck) -> Option<Finding> {
    let stability = check.stability.as_ref()?;
    let limits = &check.limits.published_critical_n_m_rad;
    let mut pairs = stability.joints.iter().zip(limits);
    let passes = pairs.all(|(joint, k_cr)| joint.stiffness_n_m_rad >= *k_cr);
    (passes && stability.verdict == Verdict::Unstable)
        .then(|| Finding::new(Tone::Bad, Found::PassesPublished))
}

fn lowest_mode(check: &ChainCheck) -> Finding {
    match check.modes.first() {
        None => Finding::new(Tone::Unknown, Found::NoFrequencies),
        Some(mode) if mode.omega_squared <= 0.0 => Finding::new(Tone::Bad, Found::LowestFalls),
        Some(mode) => Finding::new(
            Tone::Plain,
            Found::LowestMode(Quantity::new(
                mode.frequency_hz,
                Unit::si("Hz"),
                Digits::Significant(3),
            )),
        ),
    }
}

/// Cases in which the published criterion requires more stiffness for a lower centre of mass.
fn centroids(check: &ChainCheck) -> Option<Finding> {
    let limits = &check.limits;
    let largest = |effect: &CentroidEffect| -> Option<(usize, usize, f64, f64)> {
        let pairs = effect
            .published_critical_n_m_rad
            .iter()
            .zip(&limits.published_critical_n_m_rad);
        let rises = pairs.enumerate().map(|(i, (new, old))| (i, new / old - 1.0));
        let (joint, rise) = rises.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (rise > RISE_LEAST).then_some((effect.link, joint + 1, rise, effect.change))
    };
    let lowered = || check.centroids.iter().filter(|effect| effect.change < 0.0);
    let (link, joint, rise, change) = lowered().filter_map(largest).max_by(|a, b| a.2.total_cmp(&b.2))?;
    let exact_rises = lowered().any(|effect| {
        let mut pairs = effect.necessary_n_m_rad.iter().zip(&limits.necessary_n_m_rad);
        pairs.any(|(new, old)| new / old - 1.0 > RISE_LEAST)
    });
    let found = Found::Lowering {
        joint,
        rise: Quantity::percent(rise, 2),
        link,
        change: Quantity::percent(-change, 2),
    };
    (!exact_rises).then(|| Finding::new(Tone::Plain, found))
}
