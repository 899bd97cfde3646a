//! What was read: echoed before any result.

use dolmen::structure::Convention;
use dolmen::structure::stack::Body;
use dolmen_project::{Axial, Pick, Project, Quantity, Structure};
use dolmen_words::number::counted;
use std::fmt::Write as _;

/// Name, file, kind and size of what was read.
pub fn heading_text(project: &Project, file: &str) -> String {
    let mut out = String::new();
    let (en, ko) = (project.name.english(), project.name.korean());
    let both = if en == ko {
        en.to_owned()
    } else {
        format!("{en} ({ko})")
    };
    let _ = writeln!(out, "{both}\n  {file}: {}", size(project));
    if let Some(source) = &project.source {
        let _ = writeln!(out, "  source: {source}");
    }
    out
}

fn size(project: &Project) -> String {
    let pick: Pick<'_> = &mut Quantity::nominal;
    let gravity = project.gravity_m_s2;
    match &project.structure {
        Structure::Chain(chain) => {
            let height: f64 = chain.links.iter().map(|link| pick(&link.length)).sum();
            let mass: f64 = chain
                .links
                .iter()
                .map(|link| link.heaviness.mass_kg(gravity, pick))
                .sum();
            let (n, weight) = (chain.links.len(), mass * gravity / 1e3);
            format!(
                "chain of {}, {height:.2} m high, {weight:.2} kN, g {gravity} m/s2",
                counted(n, "link", "links")
            )
        }
        Structure::Frame(frame) => {
            let height: f64 = frame.storeys.iter().map(|storey| pick(&storey.height)).sum();
            let mass: f64 = frame
                .storeys
                .iter()
                .map(|storey| storey.heaviness.mass_kg(gravity, pick))
                .sum();
            let axial = match frame.axial {
                Axial::Storey => "axial force given a storey",
                Axial::Level => "axial force given a level",
                Axial::FromMasses => "axial force from the masses",
            };
            let (n, mass) = (frame.storeys.len(), mass / 1e3);
            format!(
                "frame of {}, {height:.2} m high, {mass:.1} t, {axial}",
                counted(n, "storey", "storeys")
            )
        }
        Structure::Stack(part) => match part.build(pick) {
            Ok(stack) => {
                let (blocks, joints) = (stack.blocks().len(), stack.joints().len());
                let (height, mass) = (stack.height_m(), stack.mass_kg() / 1e3);
                let on_ground = stack.joints().iter().filter(|joint| joint.lower == Body::Ground);
                let feet = on_ground.count();
                format!(
                    "stack of {}, {height:.3} m high, {mass:.2} t, {} ({feet} on the ground), g {gravity} m/s2",
                    counted(blocks, "block", "blocks"),
                    counted(joints, "joint", "joints")
                )
            }
            Err(fault) => format!("stack that cannot be: {fault}"),
        },
        Structure::Building(part) => match part.floors_and_storeys(pick) {
            Ok((floors, storeys)) => {
                let height: f64 = storeys.iter().map(|storey| storey.height_m).sum();
                let mass: f64 = floors.iter().map(|floor| floor.mass_kg).sum();
                let n = floors.len();
                let p_delta = if part.p_delta {
                    "P-delta from the masses"
                } else {
                    "P-delta left out"
                };
                format!(
                    "building of {}, {height:.2} m high, {:.1} t, {p_delta}",
                    counted(n, "floor", "floors"),
                    mass / 1e3
                )
            }
            Err(fault) => format!("building that cannot be: {fault}"),
        },
        Structure::Survey => "measured, not modelled".to_owned(),
    }
}

/// The stones that a pagoda's factors make, as blocks to copy; nothing for other structures.
pub(super) fn made_stones_text(project: &Project) -> String {
    let Structure::Stack(part) = &project.structure else {
        return String::new();
    };
    let density = part.density.as_ref().map_or(f64::NAN, |density| density.value);
    let made = part
        .pagoda
        .as_ref()
        .map(|factors| factors.made(density, &mut Quantity::nominal));
    let Some(Ok(made)) = made else {
        return String::new();
    };
    let mut out = format!(
        "\nStones that the factors make (slenderness_angle {:.4}, body_slenderness {:.4}), to 0.1 mm, as blocks to copy in the place of \
         pagoda\nblocks = [\n",
        made.slenderness_angle, made.body_slenderness
    );
    for block in &made.blocks {
        let [low, high] = block.solid.bounds_m();
        let _ = writeln!(
            out,
            "  {{ name = \"{}\", width = \"{:.4} m\", height = \"{:.4} m\" }},",
            block.name,
            high[0] - low[0],
            high[2] - low[2]
        );
    }
    out + "]\n"
}

/// How a convention is named in text.
pub(super) fn convention_words(convention: Convention) -> &'static str {
    match convention {
        Convention::Drift => "drift (spring between levels)",
        Convention::Grounded => "grounded (spring to the ground, as eq. 7 is printed)",
    }
}

/// What every result carries along: assumptions and omissions, a line each.
pub fn warnings_text(project: &Project) -> String {
    let mut out = String::new();
    for warning in &project.warnings {
        let _ = writeln!(out, "note: line {}: {}", warning.line, warning.message);
    }
    out
}
