//! A chain in the report: verdict, limits of the joints beside the published ones, modes, centres of mass.

use super::findings::{Finding, Tone};
use super::table::{Cell, figure, table};
use super::words::listed;
use crate::figures::{ShapePanel, centroid_effect, chain_elevation, mode_shapes, stiffness_limits};
use crate::number::{self, prefix, significant};
use crate::project::ChainPart;
use crate::{Language, project::Quantity};
use dolmen::assess::{CentroidEffect, ChainCheck};
use dolmen::stability::{ChainLimits, ChainStability, Verdict};
use dolmen::structure::Chain;
use maud::{Markup, html};

/// A change of a limit below this share is rounding, not a rise.
const RISE_LEAST: f64 = 1e-6;

/// Effects of a lower centre of mass are drawn for at most so many links; the table has them all.
const EFFECTS_DRAWN: usize = 4;

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
    let lambda = significant(load_factor, 4);
    let limit = significant(Verdict::MARGINAL_BELOW, 2);
    match verdict {
        Verdict::Unknown => {
            language.pick("Whether it stands is unknown.".into(), "안정 여부를 판정할 수 없다.".into())
        }
        Verdict::Unstable => language.pick(
            format!("With this stiffness it falls under its own weight: the load factor λ is {lambda}, and standing needs more than 1."),
            format!("이 강성으로는 자중만으로도 넘어진다. 하중계수 λ = {lambda}이며, 서 있으려면 1보다 커야 한다."),
        ),
        Verdict::Marginal => language.pick(
            format!("With this stiffness it stands, but with little margin: it falls at {lambda} times its weight; “stable” needs {limit}."),
            format!("이 강성으로 서 있으나 여유가 적다. 자중의 {lambda}배에서 넘어지며, ‘안정’ 판정에는 {limit}배가 필요하다."),
        ),
        Verdict::Stable => language.pick(
            format!("With this stiffness it stands: it falls at {lambda} times its weight; “stable” needs {limit}."),
            format!("이 강성으로 안정하다. 자중의 {lambda}배에서 넘어지며, ‘안정’ 판정에는 {limit}배가 필요하다."),
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
    let margin_text = significant(margin, 3);
    let may_lose = number::percent(1.0 - 1.0 / margin, 2);
    Some(Finding::of(
        Verdict::of_load_factor(margin),
        language.pick(
            format!(
                "Joint {joint} has the least margin: {margin_text} times the stiffness at which the chain would just \
                 stand, the others as they are. It may lose {may_lose} of its stiffness before the chain falls."
            ),
            format!(
                "여유가 가장 작은 곳은 연결부 {joint}이다. 다른 연결부를 그대로 둘 때 간신히 서 있을 강성의 \
                 {margin_text}배이며, 강성의 {may_lose}를 잃으면 넘어진다."
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
fn why_unsafe(limits: &ChainLimits, language: Language) -> String {
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
             아닌 대칭행렬은 부정부호(indefinite)이므로 그 강성을 가진 당간은 넘어진다. {need}."
        ),
    )
}

fn buckling(limits: &ChainLimits, language: Language) -> Finding {
    let factor = significant(limits.published_buckling_factor, 4);
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
                "주어진 강성이 모두 발표된 k_cr보다 크지만 그래도 넘어진다.",
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
                "최저차 형상에서는 진동하지 않고 넘어진다.",
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

/// The sections of a chain.
pub(super) fn sections(part: &ChainPart, check: &ChainCheck, language: Language) -> Markup {
    let names: Vec<Option<String>> = part.links.iter().map(|l| l.name.clone()).collect();
    let chain = part.build(&mut Quantity::nominal).ok();
    html! {
        h2 { (language.pick("Stability", "안정성")) }
        @if let Some(chain) = &chain {
            (elevation(chain, &names, check, language))
        }
        (figure(
            &stiffness_limits(&check.limits, check.stability.as_ref(), language),
            language.pick(
                "Stiffness limits of each joint. In the tinted part a joint is too soft whatever the others are; the \
                 published k_cr lies in it. Beyond it the joints count together, so that being to its right is not yet \
                 enough.",
                "연결부별 강성 한계. 바탕색 범위에서는 다른 연결부가 어떠하든 강성이 부족하며, 발표된 k_cr은 이 범위 안에 \
                 있다. 그 오른쪽에서는 연결부 강성이 함께 작용하므로 이 범위를 벗어난 것만으로는 충분하지 않다.",
            ),
        ))
        (limits_table(&check.limits, language))
        @if check.limits.published_critical_n_m_rad.len() > 1 {
            div.wrong { p { (why_unsafe(&check.limits, language)) } }
            (factors(&check.limits, language))
        }
        @if let Some(stability) = &check.stability {
            (margins_table(stability, language))
            (dunkerley(stability, language))
        }
        @if !check.modes.is_empty() {
            h2 { (language.pick("Natural modes", "고유진동수와 모드형상")) }
            @if let Some(chain) = &chain {
                (modes(chain, check, language))
            }
        }
        (centroid_section(check, language))
    }
}

fn elevation(chain: &Chain, names: &[Option<String>], check: &ChainCheck, language: Language) -> Markup {
    let svg = chain_elevation(chain, names, check.stability.as_ref(), language);
    let limit = significant(Verdict::MARGINAL_BELOW, 2);
    figure(
        &svg,
        &language.pick(
            format!(
                "The chain in elevation. At each joint its margin, the other joints as they are: ● at least {limit}, \
                 ◆ between 1 and {limit}, ✕ not above 1, ○ unknown."
            ),
            format!(
                "체인 모델의 입면. 각 연결부에는 다른 연결부를 그대로 둔 여유율을 표시하였다: ● {limit} 이상, ◆ 1과 {limit} \
                 사이, ✕ 1 이하, ○ 미상."
            ),
        ),
    )
}

fn limits_table(limits: &ChainLimits, language: Language) -> Markup {
    let all: Vec<f64> = [
        &limits.published_critical_n_m_rad,
        &limits.published_buckling_n_m_rad,
        &limits.necessary_n_m_rad,
    ]
    .into_iter()
    .flatten()
    .copied()
    .collect();
    let unit = prefix(&all, "N·m/rad");
    let decimals = |k: f64| number::fixed(k * unit.factor, 2);
    let head = [
        language.pick("Joint", "연결부").to_string(),
        language.pick("published k_cr", "발표된 k_cr").to_string(),
        language.pick("published P·H", "발표된 P·H").to_string(),
        "P·H / k_cr".to_string(),
        language.pick("exact limit M", "정확한 한계 M").to_string(),
        "M / k_cr".to_string(),
        language.pick("gravity moment G", "중력 모멘트 G").to_string(),
    ];
    let rows: Vec<Vec<Cell>> = (0..limits.necessary_n_m_rad.len())
        .map(|i| {
            let k_cr = limits.published_critical_n_m_rad[i];
            vec![
                (i + 1).to_string().into(),
                Cell::bad(decimals(k_cr)),
                decimals(limits.published_buckling_n_m_rad[i]).into(),
                limits
                    .published_ratio
                    .get(i)
                    .map_or("–".into(), |r| significant(*r, 3))
                    .into(),
                decimals(limits.necessary_n_m_rad[i]).into(),
                significant(limits.necessary_n_m_rad[i] / k_cr, 3).into(),
                decimals(limits.gravity_moment_n_m_rad[i]).into(),
            ]
        })
        .collect();
    let caption = language.pick(
        format!(
            "Limits of the joints, {}, lowest joint first. From weights and lengths alone; M is exact when every other \
             joint is rigid.",
            unit.unit
        ),
        format!("연결부별 한계, {}, 아래에서부터. 무게와 길이만으로 정해지며, M은 다른 연결부가 모두 강체일 때 정확하다.", unit.unit),
    );
    table(&caption, 1, &head, &rows)
}

/// By what the published and the exact limits must be multiplied, and the equal joints.
fn factors(limits: &ChainLimits, language: Language) -> Markup {
    let none = language.pick("none is enough", "어떤 배수로도 부족");
    let k_cr = limits
        .published_critical_factor
        .map_or(none.into(), |f| significant(f, 7));
    let head = [
        language
            .pick("All joints at once", "모든 연결부에 동시에 적용")
            .to_string(),
        language
            .pick("factor needed to stand", "서 있기 위해 필요한 배수")
            .to_string(),
    ];
    let rows: Vec<Vec<Cell>> = vec![
        vec![
            language.pick("published k_cr", "발표된 k_cr").into(),
            Cell::bad(k_cr),
        ],
        vec![
            language
                .pick("exact single-joint limits M", "단일 연결부의 정확한 한계 M")
                .into(),
            significant(limits.necessary_factor, 7).into(),
        ],
        vec![
            language.pick("published P·H", "발표된 P·H").into(),
            significant(limits.published_buckling_factor, 7).into(),
        ],
    ];
    let unit = prefix(&limits.published_eigenvalues_n_m_rad, "N·m/rad");
    let eigenvalues: Vec<String> = limits
        .published_eigenvalues_n_m_rad
        .iter()
        .map(|e| number::fixed(e * unit.factor, 2))
        .collect();
    let eigenvalues = format!("{} {}", eigenvalues.join(", "), unit.unit);
    let equal = number::engineering(limits.equal_joints_n_m_rad, "N·m/rad", 7);
    let caption = language.pick(
        "Factors. By how much a set of stiffnesses must be multiplied, all by the same, before the chain stands.",
        "필요 배수. 강성 전체에 같은 값을 곱하여 서 있게 되는 최소 배수.",
    );
    html! {
        (table(caption, 1, &head, &rows))
        p { (language.pick(
            format!("The stiffness matrix with the published k_cr has the eigenvalues {eigenvalues}: each negative one is a shape in which the chain falls. If all joints are equal, each needs more than {equal}."),
            format!("발표된 k_cr로 만든 강성행렬의 고유값은 {eigenvalues}이다. 음의 고유값마다 넘어지는 형상이 있다. 모든 연결부가 같다면 각각 {equal}보다 커야 한다."),
        )) }
    }
}

fn margins_table(stability: &ChainStability, language: Language) -> Markup {
    let all: Vec<f64> = stability.joints.iter().map(|j| j.stiffness_n_m_rad).collect();
    let unit = prefix(&all, "N·m/rad");
    let beds = stability.joints.iter().any(|j| j.uplift_moment_n_m.is_some());
    let moments: Vec<f64> = stability
        .joints
        .iter()
        .filter_map(|j| j.uplift_moment_n_m)
        .collect();
    let moment_unit = prefix(&moments, "N·m");
    let mut head = vec![
        language.pick("Joint", "연결부").to_string(),
        format!("k ({})", unit.unit),
        format!("{} ({})", language.pick("least k", "최소 k"), unit.unit),
        language.pick("margin", "여유율").to_string(),
        language
            .pick("lean of the link above", "상부 부재의 기울기 증폭")
            .to_string(),
    ];
    if beds {
        head.push(format!(
            "{} ({})",
            language.pick("uplift moment N·b/2", "들림 모멘트 N·b/2"),
            moment_unit.unit
        ));
        head.push(
            language
                .pick("tilt at which it is reached", "도달 기울기")
                .to_string(),
        );
    }
    let falls = language.pick("falls", "전도");
    let rows: Vec<Vec<Cell>> = stability
        .joints
        .iter()
        .enumerate()
        .map(|(i, joint)| {
            let margin = match joint.margin {
                Some(margin) if margin > 1.0 => significant(margin, 5).into(),
                Some(margin) => Cell::bad(significant(margin, 5)),
                None => Cell::bad(falls),
            };
            let mut row = vec![
                Cell::from((i + 1).to_string()),
                unit.number(joint.stiffness_n_m_rad, 5).into(),
                joint
                    .stiffness_least_n_m_rad
                    .map_or(Cell::bad(falls), |k| unit.number(k, 5).into()),
                margin,
                stability
                    .lean_amplification
                    .get(i)
                    .map_or("–".into(), |a| significant(*a, 4))
                    .into(),
            ];
            if beds {
                row.push(
                    joint
                        .uplift_moment_n_m
                        .map_or("–".into(), |m| moment_unit.number(m, 4))
                        .into(),
                );
                row.push(joint.uplift_tilt_rad.map_or("–".into(), tilt_text).into());
            }
            row
        })
        .collect();
    let lambda = significant(stability.load_factor, 5);
    let caption = language.pick(
        format!(
            "Margins of the joints, λ = {lambda}. Least k is where the chain just stands, the other joints as they are; \
             lean is rotation under gravity per unit of an initial common tilt."
        ),
        format!(
            "연결부별 여유, λ = {lambda}. 최소 k는 다른 연결부를 그대로 두고 간신히 서 있는 강성이며, 기울기 증폭은 초기 \
             공통 기울기에 대한 중력 작용 후 회전의 비이다."
        ),
    );
    html! {
        (table(&caption, 1, &head, &rows))
        @if beds {
            p.note { (language.pick(
                "A linear joint spring is no check against overturning: the uplift limit N·b/2 is the largest moment that weight alone lets a bed without tension pass, and the bed begins to open well before.",
                "선형 회전 스프링은 전도 검토를 대신하지 못한다. 들림 한계 N·b/2는 인장을 받지 못하는 밑면이 자중만으로 전달할 수 있는 최대 모멘트이며, 밑면은 그보다 훨씬 전에 벌어지기 시작한다.",
            )) }
        } @else {
            p.note { (language.pick(
                "A linear joint spring is no check against overturning; the width of the beds is not given, so the uplift limit of the joints is unknown.",
                "선형 회전 스프링은 전도 검토를 대신하지 못한다. 밑면 폭이 주어지지 않아 들림 한계는 알 수 없다.",
            )) }
        }
    }
}

/// A tilt as surveys state it: 1/177.
fn tilt_text(tilt_rad: f64) -> String {
    if tilt_rad > 0.0 && tilt_rad.is_finite() {
        format!("1/{}", significant(1.0 / tilt_rad, 3))
    } else {
        number::NOT_A_NUMBER.into()
    }
}

fn dunkerley(stability: &ChainStability, language: Language) -> Markup {
    let (needed, least, most) = (
        significant(stability.stiffness_factor, 4),
        significant(stability.stiffness_factor_least, 4),
        significant(stability.stiffness_factor_most, 4),
    );
    let side = if stability.side_support_counted {
        language.pick(" The side support is counted.", " 측면 지지가 반영되어 있다.")
    } else {
        ""
    };
    html! { p {
        (language.pick(
            format!("All stiffnesses could be multiplied by 1/λ = {needed} and the chain would just stand; by hand, this factor lies between max M/k = {least} and Σ M/k = {most} (Dunkerley)."),
            format!("모든 강성에 1/λ = {needed}을 곱하면 간신히 서 있게 된다. 손계산으로는 이 값이 max M/k = {least}과 Σ M/k = {most} 사이에 있다(Dunkerley)."),
        )) (side)
    } }
}

fn modes(chain: &Chain, check: &ChainCheck, language: Language) -> Markup {
    let mut heights = Vec::new();
    let mut height = 0.0;
    for link in chain.links() {
        height += link.length_m;
        heights.push(height);
    }
    let panels: Vec<ShapePanel> = check
        .modes
        .iter()
        .enumerate()
        .map(|(i, mode)| ShapePanel {
            title: format!("{} {}", language.pick("mode", "모드"), i + 1),
            mode,
            measured: &[],
        })
        .collect();
    let thin = chain
        .links()
        .iter()
        .any(|l| l.inertia == dolmen::structure::Inertia::ThinRod);
    html! {
        (figure(
            &mode_shapes(&heights, &panels, language),
            language.pick(
                "Natural modes. Lateral displacement of each link's top, the largest drawn alike; undamped.",
                "고유모드. 각 부재 상단의 횡변위이며 최대값을 같게 그렸다(비감쇠).",
            ),
        ))
        @if thin {
            p.note { (language.pick(
                "Links without a given moment of inertia or breadth are taken as thin rods; this changes frequencies, not stability.",
                "관성모멘트나 폭이 주어지지 않은 부재는 가는 봉으로 보았다. 이는 진동수에만 영향을 주고 안정성에는 영향이 없다.",
            )) }
        }
    }
}

fn centroid_section(check: &ChainCheck, language: Language) -> Markup {
    if check.centroids.is_empty() {
        return html! {};
    }
    let all: Vec<f64> = check.limits.published_critical_n_m_rad.clone();
    let unit = prefix(&all, "N·m/rad");
    let joints = check.limits.necessary_n_m_rad.len();
    let mut head = vec![language.pick("Link lowered", "낮춘 부재").to_string()];
    head.extend((1..=joints).map(|i| format!("k_cr {i}")));
    let with_load = check.centroids.iter().any(|e| e.load_factor.is_some());
    head.push(format!(
        "{} ({})",
        language.pick("equal joints", "동일 강성"),
        unit.unit
    ));
    if with_load {
        head.push("λ".into());
    }
    let row = |name: String, k_cr: &[f64], equal: f64, load: Option<f64>| {
        let mut row: Vec<Cell> = vec![name.into()];
        for (new, old) in k_cr.iter().zip(&check.limits.published_critical_n_m_rad) {
            let text = number::fixed(new * unit.factor, 2);
            row.push(if new / old - 1.0 > RISE_LEAST {
                Cell::bad(format!("{text} ↑"))
            } else {
                text.into()
            });
        }
        row.push(number::fixed(equal * unit.factor, 2).into());
        if with_load {
            row.push(load.map_or("–".into(), |l| significant(l, 5)).into());
        }
        row
    };
    let none = language.pick("none", "없음").to_string();
    let basis = check.stability.as_ref().map(|s| s.load_factor);
    let limits = &check.limits;
    let mut rows = vec![row(
        none,
        &limits.published_critical_n_m_rad,
        limits.equal_joints_n_m_rad,
        basis,
    )];
    let mut changes: Vec<String> = Vec::new();
    for effect in &check.centroids {
        let change = number::percent(effect.change, 2);
        rows.push(row(
            format!("{} {} ({change})", language.pick("link", "부재"), effect.link),
            &effect.published_critical_n_m_rad,
            effect.equal_joints_n_m_rad,
            effect.load_factor,
        ));
        if !changes.contains(&change) {
            changes.push(change);
        }
    }
    let changes = listed(&changes, language);
    let drawn = drawn_effects(check);
    let caption = language.pick(
        format!(
            "Published k_cr with one centre of mass changed by {changes}, {}. ↑ marks those that rise although lowering can only \
             help; the exact need of equal joints and λ show it.",
            unit.unit
        ),
        format!(
            "무게 중심 하나를 {changes} 바꾼 경우의 발표된 k_cr, {}. 낮추면 항상 유리한데도 커지는 값을 ↑로 표시하였다. 동일 \
             강성의 정확한 한계와 λ는 모두 개선된다.",
            unit.unit
        ),
    );
    html! {
        h2 { (language.pick("What lowering a centre of mass does", "무게 중심을 낮춘 효과")) }
        div.pair { @for effect in drawn {
            (figure(
                &centroid_effect(&check.limits, effect, language),
                &language.pick(
                    format!("Link {} lowered by {}.", effect.link, number::percent(-effect.change, 2)),
                    format!("부재 {}의 무게 중심을 {} 낮춘 경우.", effect.link, number::percent(-effect.change, 2)),
                ),
            ))
        } }
        (table(&caption, 1, &head, &rows))
    }
}

/// Those whose published limits rise most, in the order of the links.
fn drawn_effects(check: &ChainCheck) -> Vec<&CentroidEffect> {
    let rise = |effect: &CentroidEffect| {
        let pairs = effect
            .published_critical_n_m_rad
            .iter()
            .zip(&check.limits.published_critical_n_m_rad);
        pairs
            .map(|(new, old)| new / old - 1.0)
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let mut effects: Vec<&CentroidEffect> = check.centroids.iter().collect();
    effects.sort_by(|a, b| rise(b).total_cmp(&rise(a)));
    effects.truncate(EFFECTS_DRAWN);
    effects.sort_by_key(|e| e.link);
    effects
}
