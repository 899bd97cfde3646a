//! The data of figures that have no table.

use super::elevation::elevations;
use super::history_series::{column, loop_series};
use super::words::{Axes, Columns, Modal};
use crate::document::Series;
use dolmen::modal::{During, ModalAnalysis, Modes, Stability, StrongMotion, assurance};
use dolmen::structure::stack::{Solid, Stack};
use dolmen::structure::{Chain, Frame};
use dolmen_project::{Project, Structure};
use dolmen_words::Sentence;
use std::iter::once;

/// Deviations of a 95 % interval.
const HALF_95: f64 = 1.96;

fn symbol(text: &str) -> Sentence {
    Sentence::of_symbol(text)
}

/// Corners of every part, view by view, at true scale.
pub(crate) fn outline_series(structure: &Structure) -> Vec<Series> {
    let views = elevations(structure, false);
    let mut rows: Vec<(usize, String, [f64; 2])> = Vec::new();
    for view in &views {
        for part in &view.parts {
            rows.extend(
                part.corners_m
                    .iter()
                    .map(|at| (view.axis, part.name.clone(), *at)),
            );
        }
    }
    let parts = rows.iter().map(|(_, name, _)| symbol(name));
    let mut all = vec![Series::words(Columns::Part, parts)];
    if views.len() > 1 {
        let across = rows.iter().map(|(axis, ..)| symbol(["y", "x"][*axis % 2]));
        all.push(Series::words(Columns::View, across));
    }
    for (axis, name) in ["x, y", "z"].into_iter().enumerate() {
        all.push(Series::numbers(
            symbol(name),
            "m",
            rows.iter().map(|(.., at)| at[axis]),
        ));
    }
    all
}

/// The structure as entered, of a project.
pub(crate) fn drawing_series(project: &Project) -> Vec<Series> {
    outline_series(&project.structure)
}

/// Mass and centre of every stone.
pub(crate) fn stone_series(stack: &Stack) -> Vec<Series> {
    let blocks = || stack.blocks().iter();
    let mut all = vec![
        Series::words(Columns::Part, blocks().map(|block| symbol(&block.name))),
        Series::numbers(Columns::Mass, "kg", blocks().map(|block| block.mass_kg())),
    ];
    all.extend(centres(stack));
    all
}

fn centres(stack: &Stack) -> impl Iterator<Item = Series> {
    let heads = [Columns::CentreX, Columns::CentreY, Columns::CentreZ];
    heads.into_iter().enumerate().map(|(axis, head)| {
        let at = stack.blocks().iter().map(|block| block.solid.centroid_m()[axis]);
        Series::numbers(head, "m", at)
    })
}

/// The same, and the positions of the stones on moved supports.
pub(crate) fn moved_series(stack: &Stack, moved: &[Solid]) -> Vec<Series> {
    let mut all = stone_series(stack);
    let heads = [Columns::CentreX, Columns::CentreY, Columns::CentreZ];
    all.extend(heads.into_iter().enumerate().map(|(axis, head)| {
        let axis_words = head.into();
        let at = moved.iter().map(|solid| solid.centroid_m()[axis]);
        Series::numbers(Columns::MovedTo(axis_words), "m", at)
    }));
    all
}

/// The links of a chain, lowest first.
pub(crate) fn chain_series(chain: &Chain, names: &[Option<String>]) -> Vec<Series> {
    let links = || chain.links().iter();
    let name = |at: usize| {
        names
            .get(at)
            .and_then(Clone::clone)
            .unwrap_or_else(|| (at + 1).to_string())
    };
    let width = links().map(|link| link.bed_width_m.unwrap_or(f64::NAN));
    vec![
        Series::words(
            Columns::Part,
            (0..chain.links().len()).map(|at| symbol(&name(at))),
        ),
        Series::numbers(Columns::LowerJoint, "m", chain.joint_heights_m()),
        Series::numbers(Columns::Length, "m", links().map(|link| link.length_m)),
        Series::numbers(Columns::Mass, "kg", links().map(|link| link.mass_kg)),
        Series::numbers(Columns::BedWidth, "m", width),
    ]
}

/// The storeys of a frame, lowest first.
pub(crate) fn frame_series(frame: &Frame, names: &[Option<String>]) -> Vec<Series> {
    let storeys = || frame.storeys().iter();
    let name = |at: usize| {
        names
            .get(at)
            .and_then(Clone::clone)
            .unwrap_or_else(|| (at + 1).to_string())
    };
    vec![
        Series::words(
            Columns::Storey,
            (0..frame.storeys().len()).map(|at| symbol(&name(at))),
        ),
        Series::numbers(Columns::Height, "m", storeys().map(|storey| storey.height_m)),
        Series::numbers(Columns::Mass, "kg", storeys().map(|storey| storey.mass_kg)),
        Series::numbers(Columns::AxialForce, "N", storeys().map(|storey| storey.axial_n)),
    ]
}

/// All singular values of all lines.
pub(crate) fn singular_series(analysis: &ModalAnalysis) -> Vec<Series> {
    let spectrum = &analysis.spectrum;
    let count = spectrum.singular_values.iter().map(Vec::len).max().unwrap_or(0);
    let decibel = |value: f64| {
        if value > 0.0 {
            10.0 * value.log10()
        } else {
            f64::NAN
        }
    };
    let mut all = vec![column(&Axes::Frequency, None, spectrum.frequency_hz.clone())];
    for rank in 0..count {
        let values = spectrum.singular_values.iter();
        let values = values.map(|of| of.get(rank).map_or(f64::NAN, |value| decibel(*value)));
        let number = (rank + 1).to_string();
        all.push(column(
            &Axes::SingularValue,
            Some([&number, &number]),
            values.collect(),
        ));
    }
    all
}

/// The poles of a stabilisation diagram.
pub(crate) fn pole_series(analysis: &ModalAnalysis) -> Vec<Series> {
    let poles = || analysis.stabilization.poles.iter();
    let class = |of: Stability| match of {
        Stability::Stable => Sentence::from(Modal::StablePole),
        Stability::DampingMoved | Stability::ShapeMoved => Modal::DampingOrShapeChanges.into(),
        Stability::FrequencyMoved => Modal::FrequencyChanges.into(),
        Stability::Damping | Stability::Complex | Stability::Scattered => Modal::ImpossiblePole.into(),
        Stability::OutOfRange => symbol("–"),
    };
    vec![
        Series::numbers(Columns::Order, "", poles().map(|of| of.pole.order as f64)),
        Series::numbers(Columns::Frequency, "Hz", poles().map(|of| of.pole.frequency_hz)),
        Series::numbers(Columns::Damping, "", poles().map(|of| of.pole.damping_ratio)),
        Series::words(Columns::Pole, poles().map(|of| class(of.stability))),
    ]
}

/// MAC of every two modes.
pub(crate) fn likeness_series(modes: &Modes) -> Vec<Series> {
    let all = &modes.modes;
    let first = Series::numbers(Columns::Frequency, "Hz", all.iter().map(|mode| mode.frequency_hz));
    let beside = all.iter().enumerate().map(|(at, mode)| {
        let values = all.iter().map(|other| assurance(&mode.shape, &other.shape));
        Series::numbers(Columns::Nth(at + 1), "", values)
    });
    once(first).chain(beside).collect()
}

/// Lowest frequency of each part of a record, and of each window of an earthquake, with its interval.
pub(crate) fn through_series(found: &StrongMotion) -> Vec<Series> {
    let mut rows: Vec<[f64; 4]> = Vec::new();
    let half = |sd: Option<f64>| sd.map_or(f64::NAN, |sd| HALF_95 * sd);
    for (part, of) in found.quiet.iter().zip(super::earthquakes::lowest_of_parts(found)) {
        if let Some((hz, sd)) = of {
            rows.push([part.span_s[0], part.span_s[1], hz, half(sd)]);
        }
    }
    for event in &found.events {
        match &event.during {
            During::Driven(of) => rows.extend(of.analysis.modes.modes.first().map(|mode| {
                let [from, to] = of.span_s;
                [from, to, mode.frequency_hz, half(mode.frequency_sd_hz)]
            })),
            During::Tracked(track) => rows.extend(
                track
                    .points
                    .iter()
                    .map(|of| [of.at_s, of.at_s, of.frequency_hz, HALF_95 * of.frequency_sd_hz]),
            ),
            During::Unknown => {}
        }
    }
    let column = |at: usize| rows.iter().map(move |row| row[at]);
    vec![
        Series::numbers(Columns::From, "s", column(0)),
        Series::numbers(Columns::To, "s", column(1)),
        Series::numbers(Columns::Frequency, "Hz", column(2)),
        Series::numbers(Columns::Half95, "Hz", column(3)),
    ]
}

/// Two columns for one line.
pub(crate) fn line_series(names: [Axes; 2], values: [Vec<f64>; 2]) -> Vec<Series> {
    loop_series(names, values)
}
