//! A frame in the report: verdict, storeys, modes, one direction after the other.

use super::finding::{Finding, Tone};
use super::notes::frame_note_words;
use super::table::{Cell, figure, table};
use super::words::convention_word;
use crate::figures::{ShapePanel, frame_sketch, mode_shapes};
use crate::load_factor::load_factor_finding;
use dolmen::assess::FrameCheck;
use dolmen::stability::{FrameStability, Verdict};
use dolmen::structure::Frame;
use dolmen_project::{FramePart, Quantity};
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, prefix, significant};
use dolmen_work::state::DirectionCheck;
use maud::{Markup, html};

pub(super) fn findings(directions: &[DirectionCheck], language: Language) -> Vec<Finding> {
    let mut all = Vec::new();
    for direction in directions {
        let name = &direction.direction;
        let label = language.pick(format!("Direction {name}: "), format!("{name} 방향: "));
        match &direction.check.stability {
            None => {
                let unit = prefix(&direction.check.geometric_n_m, "N/m");
                let needs: Vec<String> = direction
                    .check
                    .geometric_n_m
                    .iter()
                    .map(|k| unit.number(*k, 4))
                    .collect();
                let needs = format!("{} {}", needs.join(", "), unit.unit);
                all.push(Finding::new(
                    Tone::Unknown,
                    language.pick(
                        format!("{label}whether it stands is unknown, the storey stiffness is not given. P-delta takes {needs} from the storeys, lowest first."),
                        format!("{label}층강성이 주어지지 않아 안정 여부는 판정할 수 없다. P-델타 효과가 아래층부터 {needs}을 빼앗는다."),
                    ),
                ));
            }
            Some(stability) => {
                let found = load_factor_finding(stability.load_factor, stability.verdict);
                let words = found.sentence.text(language);
                all.push(Finding::new(found.tone, label.clone() + &words));
                all.extend(weakest(stability, &label, language));
            }
        }
        if let Some(mode) = direction.check.modes.iter().find(|m| m.omega_squared > 0.0) {
            let hertz = significant(mode.frequency_hz, 3);
            all.push(Finding::new(
                Tone::Plain,
                language.pick(
                    format!("{label}the lowest natural frequency on this stiffness is {hertz}\u{202f}Hz."),
                    format!("{label}이 강성에서 최저 고유진동수는 {hertz}\u{202f}Hz이다."),
                ),
            ));
        }
        for note in &direction.check.notes {
            let finding = Finding::new(Tone::Warn, frame_note_words(note, language));
            // A slip in the loads is the same in every direction.
            if !all.contains(&finding) {
                all.push(finding);
            }
        }
    }
    all
}

fn weakest(stability: &FrameStability, label: &str, language: Language) -> Option<Finding> {
    let margins = stability
        .storeys
        .iter()
        .enumerate()
        .filter_map(|(i, s)| Some((i + 1, s.margin?)));
    let (storey, margin) = margins.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let margin_text = beside_one(margin, 3);
    Some(Finding::of(
        Verdict::of_load_factor(margin),
        language.pick(
            format!("{label}storey {storey} has the least margin, {margin_text} times the stiffness at which the frame would just stand."),
            format!("{label}여유가 가장 작은 층은 {storey}층이며, 골조가 안정 한계 강성의 {margin_text}배이다."),
        ),
    ))
}

/// The sections of a frame.
pub(super) fn sections(part: &FramePart, directions: &[DirectionCheck], language: Language) -> Markup {
    let names: Vec<Option<String>> = part.storeys.iter().map(|s| s.name.clone()).collect();
    let frame = part.build(&mut Quantity::nominal).ok();
    html! {
        h2 { (language.pick("Stability", "안정성")) }
        @if let Some(frame) = &frame {
            @let known = directions.iter().find_map(|d| d.check.stability.as_ref());
            (figure(
                &frame_sketch(frame, &names, known.filter(|_| directions.len() == 1), language),
                &language.pick(
                    format!("The frame as modelled. Rigid storeys with P-delta; {}.", convention_word(frame.convention(), language)),
                    format!("해석 모델. P-델타를 고려한 강체 층 모델; {}.", convention_word(frame.convention(), language)),
                ),
            ))
        }
        @for direction in directions {
            h3 { (language.pick(format!("Direction {}", direction.direction), format!("{} 방향", direction.direction))) }
            (storeys(direction, language))
            @if let Some(frame) = &frame {
                (modes(frame, direction, language))
            }
            @if let Some(slipping) = &direction.slipping { (slipping_words(slipping, language)) }
        }
    }
}

/// The frame while every joint slips, in a sentence.
fn slipping_words(check: &FrameCheck, language: Language) -> Markup {
    let frequencies: Vec<String> = check
        .modes
        .iter()
        .map(|m| significant(m.frequency_hz, 3))
        .collect();
    let frequencies = frequencies.join(", ");
    let factor = check.stability.as_ref().map(|s| s.load_factor);
    let factor = factor.map_or("–".to_owned(), |factor| significant(factor, 3));
    html! {
        p { (language.pick(
            format!("While every joint slips: load factor {factor}, {frequencies}\u{202f}Hz."),
            format!("모든 접합부가 미끄러지는 동안: 하중배율 {factor}, {frequencies}\u{202f}Hz."),
        )) }
    }
}

fn storeys(direction: &DirectionCheck, language: Language) -> Markup {
    let check = &direction.check;
    let given: Vec<f64> = check
        .stability
        .iter()
        .flat_map(|s| s.storeys.iter().map(|x| x.stiffness_n_m))
        .collect();
    let all = [check.geometric_n_m.clone(), given].concat();
    let unit = prefix(&all, "N/m");
    let mut head = vec![
        language.pick("Storey", "층").to_string(),
        format!(
            "{} ({})",
            language.pick("P-delta takes N/l", "P-델타 감소량 N/l"),
            unit.unit
        ),
        language
            .pick(
                "load on the level / weight of its mass",
                "층 하중 / 층 질량의 무게",
            )
            .to_string(),
    ];
    if check.stability.is_some() {
        head.push(format!("k ({})", unit.unit));
        head.push(format!("{} ({})", language.pick("least k", "최소 k"), unit.unit));
        head.push(language.pick("margin", "여유도").into());
    }
    let falls = language.pick("falls", "전도");
    let rows: Vec<Vec<Cell>> = check
        .geometric_n_m
        .iter()
        .enumerate()
        .map(|(i, geometric)| {
            let mut row: Vec<Cell> = vec![
                (i + 1).to_string().into(),
                unit.number(*geometric, 4).into(),
                check
                    .level_load_ratios
                    .get(i)
                    .map_or("–".into(), |r| significant(*r, 3))
                    .into(),
            ];
            if let Some(storey) = check.stability.as_ref().and_then(|s| s.storeys.get(i)) {
                row.push(unit.number(storey.stiffness_n_m, 5).into());
                row.push(
                    storey
                        .stiffness_least_n_m
                        .map_or(Cell::bad(falls), |k| unit.number(k, 5).into()),
                );
                row.push(match storey.margin {
                    Some(margin) if margin > 1.0 => beside_one(margin, 4).into(),
                    Some(margin) => Cell::bad(beside_one(margin, 4)),
                    None => Cell::bad(falls),
                });
            }
            row
        })
        .collect();
    let caption = match &check.stability {
        Some(stability) => {
            let lambda = beside_one(stability.load_factor, 4);
            language.pick(
                format!("Storeys, λ = {lambda}. Least k is where the frame just stands, the other storeys as they are."),
                format!("층별 결과, λ = {lambda}. 최소 k는 다른 층을 그대로 두고 안정 한계 강성이다."),
            )
        }
        None => language
            .pick(
                "Storeys, stiffness unknown. What the loads alone say.",
                "층별 결과, 층강성 미상. 하중만으로 알 수 있는 값이다.",
            )
            .into(),
    };
    table(&caption, 1, &head, &rows)
}

fn modes(frame: &Frame, direction: &DirectionCheck, language: Language) -> Markup {
    if direction.check.modes.is_empty() {
        return html! {};
    }
    let panels: Vec<ShapePanel> = direction
        .check
        .modes
        .iter()
        .enumerate()
        .map(|(i, mode)| ShapePanel {
            title: format!(
                "{} {}",
                language.pick("mode", "모드"),
                number::significant((i + 1) as f64, 1)
            ),
            mode,
            measured: &[],
        })
        .collect();
    figure(
        &mode_shapes(&frame.level_heights_m(), &panels, language),
        language.pick(
            "Natural modes on the given stiffness. Displacement of each level, the largest drawn alike; undamped.",
            "주어진 강성에 대한 고유모드. 각 층의 변위이며 최대값을 같게 그렸다(비감쇠).",
        ),
    )
}
