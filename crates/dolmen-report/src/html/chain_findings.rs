//! What a chain's check says in plain words.

use super::finding::{Finding, Tone};
use dolmen::assess::{CentroidEffect, ChainCheck};
use dolmen::stability::{ChainLimits, ChainStability, Verdict};
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, significant};

/// A change of a limit below this share is rounding, not a rise.
pub(super) const RISE_LEAST: f64 = 1e-6;

pub(super) fn findings(check: &ChainCheck, language: Language) -> Vec<Finding> {
    let mut all = vec![stands(check, language)];
    all.extend(check.stability.as_ref().and_then(|s| weakest(s, language)));
    all.push(published(&check.limits, language));
    all.push(buckling(&check.limits, language));
    all.extend(passes_published(check, language));
    all.push(lowest_mode(check, language));
    all.extend(centroids(check, language));
    all
}

/// Verdict and load factor; what is needed if the joints are unknown.
fn stands(check: &ChainCheck, language: Language) -> Finding {
    let Some(stability) = &check.stability else {
        let equal = number::engineering(check.limits.equal_joints_n_m_rad, "N·m/rad", 4);
        return Finding::new(
            Tone::Unknown,
            language.pick(
                format!(
                    "Whether it stands is unknown: the stiffness of the joints is not given. If all joints are equal, \
                     each needs more than {equal}."
                ),
                format!(
                    "연결부 강성이 주어지지 않아 안정 여부는 판정할 수 없다. 모든 연결부의 강성이 같다면 각각 {equal}보다 \
                     커야 한다."
                ),
            ),
        );
    };
    Finding::of(
        stability.verdict,
        load_factor_words(stability.load_factor, stability.verdict, language),
    )
}

/// "It stands: …", the same words for chains and frames.
pub(super) fn load_factor_words(load_factor: f64, verdict: Verdict, language: Language) -> String {
    let lambda = beside_one(load_factor, 4);
    let limit = significant(Verdict::MARGINAL_BELOW, 2);
    match verdict {
        Verdict::Unknown => {
            language.pick("Whether it stands is unknown.".into(), "안정 여부를 판정할 수 없다.".into())
        }
        Verdict::Unstable => language.pick(
            format!("With this stiffness it falls under its own weight: the load factor λ is {lambda}, and standing needs more than 1."),
            format!("이 강성으로는 자중만으로도 전도된다. 하중계수 λ = {lambda}이며, 안정하려면 1보다 커야 한다."),
        ),
        Verdict::Marginal => language.pick(
            format!("With this stiffness it stands, but with little margin: it falls at {lambda} times its weight; “stable” needs {limit}."),
            format!("이 강성으로 안정하나 여유가 적다. 자중의 {lambda}배에서 전도되며, ‘안정’ 판정에는 {limit}배가 필요하다."),
        ),
        Verdict::Stable => language.pick(
            format!("With this stiffness it stands: it falls at {lambda} times its weight; “stable” needs {limit}."),
            format!("이 강성으로 안정하다. 자중의 {lambda}배에서 전도되며, ‘안정’ 판정에는 {limit}배가 필요하다."),
        ),
    }
}

fn weakest(stability: &ChainStability, language: Language) -> Option<Finding> {
    if let Some(joint) = stability.failing_joint {
        return Some(Finding::new(
            Tone::Bad,
            language.pick(
                format!(
                    "Seen from the top, joint {joint} is the first that cannot hold what stands on it. No single joint \
                     need be at fault: the stiffnesses count together."
                ),
                format!(
                    "위에서부터 볼 때 연결부 {joint}이(가) 상부를 지탱하지 못하는 첫 연결부이다. 한 연결부만의 문제라고 할 \
                     수는 없으며 강성은 함께 작용한다."
                ),
            ),
        ));
    }
    let margins = stability
        .joints
        .iter()
        .enumerate()
        .filter_map(|(i, j)| Some((i + 1, j.margin?)));
    let (joint, margin) = margins.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let margin_text = beside_one(margin, 3);
    let may_lose = number::percent(1.0 - 1.0 / margin, 2);
    Some(Finding::of(
        Verdict::of_load_factor(margin),
        language.pick(
            format!(
                "Joint {joint} has the least margin: {margin_text} times the stiffness at which the chain would just \
                 stand, the others as they are. It may lose {may_lose} of its stiffness before the chain falls."
            ),
            format!(
                "여유가 가장 작은 곳은 연결부 {joint}이다. 다른 연결부를 그대로 둘 때 안정 한계 강성의 \
                 {margin_text}배이며, 강성이 {may_lose} 저하되면 전도된다."
            ),
        ),
    ))
}

/// The published criterion, and why it is unsafe.
fn published(limits: &ChainLimits, language: Language) -> Finding {
    let least = limits
        .published_eigenvalues_n_m_rad
        .first()
        .copied()
        .unwrap_or(0.0);
    if limits.published_critical_n_m_rad.len() < 2 || least >= 0.0 {
        return Finding::new(
            Tone::Plain,
            language.pick(
                "With a single joint the published critical stiffness and the exact limit are the same.",
                "연결부가 하나이므로 발표된 임계 강성과 정확한 한계가 같다.",
            ),
        );
    }
    Finding::new(Tone::Bad, why_unsafe(limits, language))
}

/// The sentence that says why the published criterion and the right one differ.
pub(super) fn why_unsafe(limits: &ChainLimits, language: Language) -> String {
    let need = match limits.published_critical_factor {
        Some(factor) => {
            let factor = significant(factor, 3);
            language.pick(
                format!("the joints need {factor} times as much"),
                format!("연결부에는 그 {factor}배가 필요하다"),
            )
        }
        None => language.pick(
            "no common factor makes them enough, since one of them is not positive".into(),
            "그중 하나가 양수가 아니므로 어떤 배수로도 충분해지지 않는다".into(),
        ),
    };
    language.pick(
        format!(
            "The published critical stiffness k_cr is unsafe: it sets each diagonal term of the stiffness matrix to \
             zero; a symmetric matrix with zero diagonal and non-zero off-diagonals is indefinite, so a pole with \
             those stiffnesses falls; {need}."
        ),
        format!(
            "발표된 임계 강성 k_cr은 불안전측이다. 강성행렬의 대각항을 모두 0으로 두는데, 대각항이 0이고 비대각항이 0이 \
             아닌 대칭행렬은 부정부호(indefinite)이므로 그 강성을 가진 당간은 전도된다. {need}."
        ),
    )
}

fn buckling(limits: &ChainLimits, language: Language) -> Finding {
    let factor = beside_one(limits.published_buckling_factor, 4);
    if limits.published_buckling_factor > 1.0 {
        Finding::new(
            Tone::Bad,
            language.pick(
                format!("The published P·H (buckling of a post on one spring) is not enough either: taken in every joint at once, it must be multiplied by {factor}."),
                format!("발표된 좌굴 임계강성 P·H도 충분하지 않다. 모든 연결부에 동시에 적용하면 {factor}배가 필요하다."),
            ),
        )
    } else {
        Finding::new(
            Tone::Plain,
            language.pick(
                format!("The published P·H (buckling of a post on one spring) would be enough here: taken in every joint at once, {factor} of it suffices."),
                format!("발표된 좌굴 임계강성 P·H는 이 경우 충분하다. 모든 연결부에 동시에 적용하면 그 {factor}배로 족하다."),
            ),
        )
    }
}

/// A chain that the published criterion lets pass and that falls all the same.
fn passes_published(check: &ChainCheck, language: Language) -> Option<Finding> {
    let stability = check.stability.as_ref()?;
    let limits = &check.limits.published_critical_n_m_rad;
    let passes = stability
        .joints
        .iter()
        .zip(limits)
        .all(|(j, k_cr)| j.stiffness_n_m_rad >= *k_cr);
    (passes && stability.verdict == Verdict::Unstable).then(|| {
        Finding::new(
            Tone::Bad,
            language.pick(
                "Every given stiffness is above the published k_cr, and yet the chain falls.",
                "주어진 강성이 모두 발표된 k_cr보다 크지만 그래도 전도된다.",
            ),
        )
    })
}

fn lowest_mode(check: &ChainCheck, language: Language) -> Finding {
    match check.modes.first() {
        None => Finding::new(
            Tone::Unknown,
            language.pick(
                "Natural frequencies are unknown: they need the stiffness of the joints.",
                "고유진동수는 알 수 없다. 연결부 강성이 필요하다.",
            ),
        ),
        Some(mode) if mode.omega_squared <= 0.0 => Finding::new(
            Tone::Bad,
            language.pick(
                "It does not vibrate in its lowest shape, it falls in it.",
                "최저차 형상에서는 진동하지 않고 전도된다.",
            ),
        ),
        Some(mode) => {
            let hertz = significant(mode.frequency_hz, 3);
            Finding::new(
                Tone::Plain,
                language.pick(
                    format!("Its lowest natural frequency is {hertz}\u{202f}Hz (undamped, on the stiffness above)."),
                    format!("최저 고유진동수는 {hertz}\u{202f}Hz이다(비감쇠, 위의 강성 기준)."),
                ),
            )
        }
    }
}

/// Where the published criterion says that a lower centre of mass asks for more stiffness.
fn centroids(check: &ChainCheck, language: Language) -> Option<Finding> {
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
    let (link, joint, rise, change) = check
        .centroids
        .iter()
        .filter(|e| e.change < 0.0)
        .filter_map(largest)
        .max_by(|a, b| a.2.total_cmp(&b.2))?;
    let exact_rises = check.centroids.iter().filter(|e| e.change < 0.0).any(|e| {
        let mut pairs = e.necessary_n_m_rad.iter().zip(&limits.necessary_n_m_rad);
        pairs.any(|(new, old)| new / old - 1.0 > RISE_LEAST)
    });
    if exact_rises {
        return None;
    }
    let (rise, change) = (number::percent(rise, 2), number::percent(-change, 2));
    Some(Finding::new(
        Tone::Plain,
        language.pick(
            format!(
                "Lowering a centre of mass can only help: no exact limit rises. By the published criterion k_cr of \
                 joint {joint} would rise by {rise} when that of link {link} is lowered by {change}: an artefact of \
                 that criterion."
            ),
            format!(
                "무게 중심을 낮추면 항상 유리하며 정확한 한계는 어느 것도 커지지 않는다. 발표된 기준으로는 연결부 \
                 {joint}의 k_cr이 {rise} 커지는데(부재 {link}의 무게 중심을 {change} 낮춘 경우), 이는 그 기준의 오류이다."
            ),
        ),
    ))
}
