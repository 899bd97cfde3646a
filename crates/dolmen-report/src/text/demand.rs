//! What an earthquake asks for, as text.

use super::Table;
use dolmen::assess::demand::{
    EurocodeGround, EurocodeType, ModalRatio, ShakenDirection, SiteDemand, SiteParameters, StackDemandCheck,
    StackDemandRow,
};
pub(crate) use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::stability::stack::{Comparison, DemandVerdict, LimitKind, Threshold};
use dolmen_words::number::trimmed;
use dolmen_work::state::{DemandAnswer, SpectralAt};
use std::fmt::Write as _;

/// Digits of the numbers that a code gives on its way.
const DIGITS: usize = 6;

/// The site, its numbers, and what they ask of the structure.
pub(super) fn demand_text(answer: &DemandAnswer) -> String {
    let site = &answer.site;
    let head = match (&answer.stack, &answer.refused) {
        (Some(stack), _) => stack.verdict.words(),
        (None, Some(_)) => "unknown",
        (None, None) => "no verdict",
    };
    let mut out = format!(
        "\nDEMAND {head}: {}, damping {} % [demand]\n",
        site.spectrum.source,
        trimmed(100.0 * site.damping_ratio, 4)
    );
    out += &site_text(site);
    if let Some(why) = &answer.refused {
        let _ = writeln!(out, "  not compared: {why}");
    }
    match &answer.stack {
        Some(stack) => out += &stack_text(stack, site),
        None => out += &spectral_text(&answer.spectral, answer.refused.is_none()),
    }
    if !site.spectrum.unverified.is_empty() {
        let all: Vec<String> = site.spectrum.unverified.iter().map(ToString::to_string).collect();
        let _ = writeln!(
            out,
            "  note: not held against the text of the code: {}",
            all.join("; ")
        );
    }
    out
}

fn in_g(acceleration_m_s2: f64) -> f64 {
    acceleration_m_s2 / STANDARD_GRAVITY_M_S2
}

/// The numbers between the site and its spectrum, and the acceleration of the ground.
fn site_text(site: &SiteDemand) -> String {
    let short = |value: f64| trimmed(value, DIGITS);
    let mut out = match &site.parameters {
        SiteParameters::Korea {
            zone_factor_g,
            return_period_years,
            risk_factor,
            effective_acceleration_g,
            soil,
            amplification,
            design,
            branches,
        } => format!(
            "  Z {} g, {return_period_years} years: I {}, S = Z I = {} g; {soil:?}: Fa {}, Fv {}\n  T0 {} s, Ts {} s, TL {} s; \
             {}plateau {} g\n",
            short(*zone_factor_g),
            short(*risk_factor),
            short(*effective_acceleration_g),
            short(amplification.short_periods),
            short(amplification.one_second),
            short(branches.rise_s),
            short(branches.plateau_s),
            short(branches.displacement_s),
            design.map_or_else(String::new, |design| format!(
                "S_DS {} g, S_D1 {} g of KDS 41 17 00; ",
                short(design.short_period_g),
                short(design.one_second_g)
            )),
            short(in_g(branches.plateau_m_s2)),
        ),
        SiteParameters::Eurocode {
            ground_acceleration_g,
            importance_factor,
            spectrum,
            ground,
            soil_factor,
            branches,
        } => format!(
            "  a_gR {} g, importance factor {}, type {}, ground {}: S {}\n  TB {} s, TC {} s, TD {} s; plateau {} g\n",
            short(*ground_acceleration_g),
            short(*importance_factor),
            type_word(*spectrum),
            ground_word(*ground),
            short(*soil_factor),
            short(branches.rise_s),
            short(branches.plateau_s),
            short(branches.displacement_s),
            short(in_g(branches.plateau_m_s2)),
        ),
        SiteParameters::Table {
            rows,
            least_s,
            most_s,
        } => format!(
            "  table of {rows} rows, {} to {} s, straight between them\n",
            short(*least_s),
            short(*most_s)
        ),
    };
    let vertical = match &site.vertical {
        Some(vertical) => {
            let doubt = if vertical.verified { "" } else { ", unverified" };
            format!("vertical over horizontal {}{doubt}", short(vertical.ratio))
        }
        None => "no vertical shaking is given, so none is counted".to_owned(),
    };
    let _ = match site.peak_ground_acceleration_m_s2 {
        Some(peak) => writeln!(out, "  peak of the ground {} g; {vertical}", short(in_g(peak))),
        None => writeln!(out, "  peak of the ground not given; {vertical}"),
    };
    out
}

/// "1", "2".
pub(crate) fn type_word(kind: EurocodeType) -> &'static str {
    match kind {
        EurocodeType::One => "1",
        EurocodeType::Two => "2",
    }
}

/// "A" to "E".
pub(crate) fn ground_word(ground: EurocodeGround) -> &'static str {
    match ground {
        EurocodeGround::A => "A",
        EurocodeGround::B => "B",
        EurocodeGround::C => "C",
        EurocodeGround::D => "D",
        EurocodeGround::E => "E",
    }
}

fn stack_text(stack: &StackDemandCheck, site: &SiteDemand) -> String {
    let heads = [
        "shaken along",
        "moves at, g",
        "less vertical, g",
        "ground, g",
        "ratio",
        "as rigid blocks",
        "T1, s",
        "S_a, g",
        "S_a alike",
        "by modes",
        "on elastic joints",
    ];
    let mut table = Table::new(&heads, 1);
    for row in &stack.rows {
        table.row(cells(row, site));
    }
    let near = DemandVerdict::NEAR_BELOW;
    let mut out = table.text();
    let _ = writeln!(
        out,
        "  ratio: what is left with {} g of vertical acceleration, over the demand. above demand: at least {near}; near: 1 to \
         {near}; below: less\n  than 1. \"Below\" means that something tips or slides, not that the stack falls: how far it goes \
         needs a time history.",
        trimmed(in_g(stack.vertical_acceleration_m_s2), 4)
    );
    let most = stack
        .rows
        .iter()
        .filter_map(|row| Some((row.by_modes.as_ref()?, row.amplification?)));
    if let Some((by_modes, amplification)) = most.min_by(|a, b| a.0.ratio.total_cmp(&b.0.ratio)) {
        let _ = writeln!(
            out,
            "  on elastic joints by the forces of all modes on what is above each joint: {}; in the first mode one\n  stone feels {amplification:.2} S_a. \
             \"S_a alike\", as published, lets all stones feel S_a; it is not on the safe side and decides nothing. A corner of an\n  elastic joint opens \
             before the joint tips, of a rectangle at a third: `dolmen simulate` says by how much",
            first_words(by_modes)
        );
    }
    if stack.rows.iter().any(|row| row.by_modes.is_none()) {
        out += "  note: the modes, or what the spectrum asks at their periods, are not known, or nothing is left to compare with: on elastic joints unknown\n";
    }
    out
}

/// What gives way first.
fn first_words(by_modes: &ModalRatio) -> String {
    match &by_modes.first {
        Some((LimitKind::Uplift, above)) => format!("what stands on {above} tips first"),
        Some((LimitKind::Sliding, above)) => format!("what stands on {above} slides first"),
        None => "stones that share their load move first, with the largest forces on all at once".to_owned(),
    }
}

fn cells(row: &StackDemandRow, site: &SiteDemand) -> Vec<String> {
    let direction = match row.direction {
        ShakenDirection::X => "x",
        ShakenDirection::Y => "y",
        ShakenDirection::Any => "any",
    };
    let at = |threshold: &Option<Threshold>| {
        threshold.as_ref().map_or("-".to_owned(), |t| {
            format!("{:.4}", t.acceleration_m_s2 / STANDARD_GRAVITY_M_S2)
        })
    };
    let ratio = |comparison: &Comparison| {
        comparison
            .ratio
            .map_or("-".to_owned(), |ratio| format!("{ratio:.3}"))
    };
    let peak = site.peak_ground_acceleration_m_s2;
    let mut cells = vec![
        direction.to_owned(),
        at(&row.capacity),
        at(&row.capacity_with_vertical),
        peak.map_or("-".to_owned(), |peak| format!("{:.4}", in_g(peak))),
        ratio(&row.comparison.rigid),
        row.comparison.rigid.verdict.words().to_owned(),
    ];
    match (&row.comparison.elastic, row.period_s) {
        (Some(elastic), Some(period_s)) => cells.extend([
            format!("{period_s:.4}"),
            format!("{:.4}", in_g(elastic.demand_m_s2)),
            ratio(elastic),
        ]),
        _ => cells.extend(["-", "-", "-"].map(str::to_owned)),
    }
    match &row.by_modes {
        Some(by_modes) => cells.extend([
            format!("{:.3}", by_modes.ratio),
            by_modes.verdict.words().to_owned(),
        ]),
        None => cells.extend(["-", "unknown"].map(str::to_owned)),
    }
    cells
}

/// What the spectrum asks of a structure whose capacity against shaking is not computed.
fn spectral_text(spectral: &[SpectralAt], with_note: bool) -> String {
    let mut out = String::new();
    if !spectral.is_empty() {
        let mut table = Table::new(&["direction", "T1, s", "damping, %", "S_a, g"], 1);
        for at in spectral {
            table.row(vec![
                at.direction.clone(),
                format!("{:.4}", at.period_s),
                trimmed(100.0 * at.damping_ratio, 4),
                format!("{:.4}", in_g(at.acceleration_m_s2)),
            ]);
        }
        out += &table.text();
    }
    if with_note {
        out += "  note: what acceleration this structure bears is not computed; S_a is for the engineer's own check\n";
    }
    out
}
