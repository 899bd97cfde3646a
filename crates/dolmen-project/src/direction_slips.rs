//! Directions of surveys that the structure does not have, with a similar name of a direction that it has: X for x, 비틀림 for torsion, bo for boo.

use super::content::Structure;
use super::reader::Reader;
use super::survey::Survey;
use super::wrong::{Common, WrongSurvey};
use dolmen_words::nearest;

/// Words for the direction torsion.
const TORSION: [&str; 7] = [
    "비틀림",
    "회전",
    "twist",
    "rotation",
    "rotational",
    "torsional",
    "theta",
];

pub(super) fn judge_directions(reader: &mut Reader, structure: Option<&Structure>, surveys: &[Survey]) {
    let known: Vec<&str> = match structure {
        Some(Structure::Building(_) | Structure::Stack(_)) => vec!["x", "y", "torsion"],
        // directions that only a survey names have no stiffness
        Some(Structure::Frame(part)) => {
            let given = part.directions.iter().filter(|of| of.stiffness.is_some());
            given.map(|of| of.name.as_str()).collect()
        }
        Some(Structure::Chain(_) | Structure::Survey) | None => return,
    };
    for survey in surveys {
        let modes = survey.modes.iter().map(|(name, modes)| {
            let first = modes.first().map(|mode| mode.frequency.path.clone());
            (
                name,
                first.unwrap_or_else(|| format!("survey.{}.frequencies.{name}", survey.name)),
            )
        });
        let tilts = survey
            .tilt
            .keys()
            .map(|name| (name, format!("survey.{}.tilt.{name}", survey.name)));
        for (name, path) in modes.chain(tilts) {
            let Some(near) = meant(name, &known) else { continue };
            let message = WrongSurvey::NoSuchDirection {
                path: path.clone(),
                name: name.clone(),
                known: known.join(", "),
            };
            let near = near.to_owned();
            reader.slip(&path, message, Common::DidYouMean(near));
        }
    }
}

/// The direction that an unknown name was probably intended for.
fn meant<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    if known.contains(&name) {
        return None;
    }
    let lower = name.to_lowercase();
    let same = known.iter().find(|of| of.to_lowercase() == lower).copied();
    let torsion = || {
        known
            .iter()
            .find(|of| **of == "torsion" && TORSION.contains(&lower.as_str()))
            .copied()
    };
    let alike = || nearest(&lower, known.iter().copied().filter(|of| of.len() > 1));
    same.or_else(torsion).or_else(alike)
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn holds_which_direction_is_meant() {
        let building = ["x", "y", "torsion"];
        for (name, near) in [
            ("X", Some("x")),
            ("비틀림", Some("torsion")),
            ("x", None),
            ("weak", None),
            ("z", None),
        ] {
            assert_eq!(meant(name, &building), near, "{name}");
        }
        let frame = ["boo", "do"];
        for (name, near) in [
            ("BOO", Some("boo")),
            ("bo", Some("boo")),
            ("do", None),
            ("ew", None),
        ] {
            assert_eq!(meant(name, &frame), near, "{name}");
        }
    }
}
