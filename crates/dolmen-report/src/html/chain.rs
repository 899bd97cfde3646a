//! A chain in the report: limits of the joints beside the published ones, margins, modes.

use super::chain_centroids;
use super::chain_findings::why_unsafe;
use super::table::{Cell, figure, table};
use crate::figures::{ShapePanel, chain_elevation, mode_shapes, stiffness_limits};
use dolmen::assess::ChainCheck;
use dolmen::stability::{ChainLimits, ChainStability, Verdict};
use dolmen::structure::Chain;
use dolmen_project::ChainPart;
use dolmen_project::Quantity;
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, prefix, significant};
use maud::{Markup, html};

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
        (chain_centroids::section(check, language))
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
            .pick("factor needed to stand", "안정에 필요한 배수")
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
        "필요 배수. 강성 전체에 같은 값을 곱하여 안정하게 되는 최소 배수.",
    );
    html! {
        (table(caption, 1, &head, &rows))
        p { (language.pick(
            format!("The stiffness matrix with the published k_cr has the eigenvalues {eigenvalues}: each negative one is a shape in which the chain falls. If all joints are equal, each needs more than {equal}."),
            format!("발표된 k_cr로 만든 강성행렬의 고유값은 {eigenvalues}이다. 음의 고유값마다 전도되는 형상이 있다. 모든 연결부가 같다면 각각 {equal}보다 커야 한다."),
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
        language.pick("lean of the link", "기울기 증폭").to_string(),
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
                Some(margin) if margin > 1.0 => beside_one(margin, 5).into(),
                Some(margin) => Cell::bad(beside_one(margin, 5)),
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
    let lambda = beside_one(stability.load_factor, 5);
    let caption = language.pick(
        format!(
            "Margins of the joints, λ = {lambda}. Least k is where the chain just stands, the other joints as they are; \
             lean is rotation under gravity per unit of an initial common tilt."
        ),
        format!(
            "연결부별 여유, λ = {lambda}. 최소 k는 다른 연결부를 그대로 두고 안정 한계 강성이며, 기울기 증폭은 초기 \
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
        beside_one(stability.stiffness_factor, 4),
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
            format!("모든 강성에 1/λ = {needed}을 곱하면 안정 한계에 이른다. 손계산으로는 이 값이 max M/k = {least}과 Σ M/k = {most} 사이에 있다(Dunkerley)."),
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
