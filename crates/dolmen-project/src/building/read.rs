//! Buildings from what is written: floors with the storeys below them.

use super::file::{FloorRaw, StoreyStiffnessRaw, WallRaw, WatchedRaw};
use super::floor_number::floor_number;
use super::part::{BuildingPart, FloorPart, GyrationPart, StoreyStiffnessPart, WallPart, WatchedPart};
use super::read_damper::dampers;
use super::read_damping::damping;
use super::slips_damper::judge_dampers;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::{At, NumberRaw, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::{countable, heaviness, lengths, missing};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::WrongBuilding;
use crate::wrong::said;
use dolmen::dynamics::{DynamicsError, VibratingBuilding};
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingError, Outline, PDelta, PlanDirection};

/// Most floors of a building. Our choice: none has more than 200.
const FLOORS_MOST: usize = 300;
/// Largest accidental eccentricity over the side of a floor: at its edge it is a half. Codes have 0.05.
const ECCENTRICITY_MOST: f64 = 0.5;

pub(crate) fn building(reader: &mut Reader, raw: &FileRaw, gravity_m_s2: f64) -> Option<BuildingPart> {
    let Some(list) = raw.floors.as_ref() else {
        missing(
            reader,
            "floors",
            WrongBuilding::BuildingNeedsFloors,
            WrongBuilding::FloorsMassSidesHeight,
        );
        return None;
    };
    if !countable(reader, list, "floors") {
        return None;
    }
    reader.mark("floors", &list.span);
    let numbered = list.value.iter().enumerate();
    let floors: Vec<Option<FloorPart>> = numbered
        .map(|(i, raw)| floor(reader, raw, &format!("floors[{}]", i + 1)))
        .collect();
    let floors: Vec<FloorPart> = floors.into_iter().collect::<Option<_>>()?;
    let count: usize = floors.iter().map(|floor| floor.count).sum();
    if count > FLOORS_MOST {
        let fault = Fault::new(
            list.span.clone(),
            "floors",
            WrongBuilding::FloorsHasFloorsIn(count.to_string()),
        );
        reader.fault(fault.allowed(WrongBuilding::MustBeAtMost(FLOORS_MOST.to_string())));
        return None;
    }
    names_apart(reader, &floors, list);
    let before = reader.faults.len();
    let damping = damping(reader, raw.damping.as_ref());
    let dampers = dampers(reader, raw.damper.as_ref(), count);
    let points = points(reader, raw.points.as_ref(), count);
    let accidental_eccentricity = accidental_eccentricity(reader, raw.accidental_eccentricity.as_ref());
    (reader.faults.len() == before).then_some(())?;
    Some(BuildingPart {
        floors,
        p_delta: raw.p_delta.as_ref().is_none_or(|given| given.value),
        accidental_eccentricity,
        damping,
        dampers,
        points,
        gravity_m_s2,
        as_written: None,
    })
}

/// The accidental eccentricity over the side of a floor, if given.
fn accidental_eccentricity(reader: &mut Reader, raw: Option<&At<NumberRaw>>) -> Option<f64> {
    const AT: &str = "accidental_eccentricity";
    let fraction = reader.plain(raw, AT, Measure::Ratio, Bound::NotNegative)?;
    if fraction > ECCENTRICITY_MOST {
        let span = raw.map_or(0..0, |raw| raw.span.clone());
        let fault = Fault::new(span, AT, format!("{AT} = {}", short(fraction)));
        let allowed = WrongBuilding::MustBeAtMost(ECCENTRICITY_MOST.to_string());
        reader.fault(fault.allowed(allowed).help(WrongBuilding::EccentricityOfCodes));
        return None;
    }
    Some(fraction)
}

/// Rejects two floors with one name, or two walls of one storey, which tables could not distinguish.
fn names_apart(reader: &mut Reader, floors: &[FloorPart], list: &At<Vec<At<FloorRaw>>>) {
    let mut refuse = |what: WrongBuilding, path: &str, span, name: &str| {
        let fault = Fault::new(
            span,
            path,
            WrongBuilding::TwoAreNamed {
                what: what.into(),
                name: name.to_string(),
            },
        );
        reader.fault(fault.help(WrongBuilding::GiveEachItsOwn));
    };
    for (i, (floor, raw)) in floors.iter().zip(&list.value).enumerate() {
        let path = format!("floors[{}]", i + 1);
        if let Some(name) = &floor.name
            && floors[..i].iter().any(|other| other.name.as_ref() == Some(name))
        {
            refuse(
                WrongBuilding::Floors,
                &format!("{path}.name"),
                raw.span.clone(),
                name,
            );
        }
        let (StoreyStiffnessPart::Walls(walls), Some(raw)) = (&floor.stiffness, &raw.value.walls) else {
            continue;
        };
        for (k, (wall, raw)) in walls.iter().zip(&raw.value).enumerate() {
            if let Some(name) = &wall.name
                && walls[..k].iter().any(|other| other.name.as_ref() == Some(name))
            {
                let path = format!("{path}.walls[{}].name", k + 1);
                refuse(WrongBuilding::WallsOfOneStorey, &path, raw.span.clone(), name);
            }
        }
    }
}

fn floor(reader: &mut Reader, raw: &At<FloorRaw>, path: &str) -> Option<FloorPart> {
    let floor = &raw.value;
    reader.mark(path, &raw.span);
    let before = reader.faults.len();
    let count = match &floor.count {
        None => Some(1),
        Some(given) => reader.count(Some(given), &format!("{path}.count"), 1, FLOORS_MOST),
    };
    let heaviness = heaviness(
        reader,
        floor.weight.as_ref(),
        floor.mass.as_ref(),
        path,
        &raw.span,
    );
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, Bound::Positive)
    };
    let height = of(&floor.height, "height", Measure::Length);
    let gyration = of(&floor.gyration, "gyration", Measure::Length);
    let inertia = of(&floor.inertia, "inertia", Measure::Inertia);
    let centre = floor
        .centre
        .as_ref()
        .map(|raw| lengths(reader, raw, &format!("{path}.centre"), "[x, y]"));
    let outline = outline(reader, floor, path);
    let stiffness = stiffness(reader, raw, path);
    let gyration = match (gyration, inertia) {
        (Some(radius), None) => GyrationPart::Radius(radius),
        (None, Some(inertia)) => GyrationPart::Inertia(inertia),
        (None, None) => GyrationPart::OfArea,
        (Some(radius), Some(_)) => {
            let fault = Fault::new(
                reader.place(&radius.path),
                path,
                WrongBuilding::HasBothGyrationAnd(path.to_string()),
            );
            reader.fault(fault.help(WrongBuilding::KeepOneOfThem));
            return None;
        }
    };
    if matches!(outline, Some(None)) {
        for (key, is_missing, what) in [
            ("centre", centre.is_none(), WrongBuilding::ItsCentreOfMass),
            (
                "gyration",
                gyration == GyrationPart::OfArea,
                WrongBuilding::ItsRadiusOfGyration,
            ),
        ] {
            if is_missing {
                let message = WrongBuilding::HasNeitherSidesNor {
                    path: path.to_string(),
                    what: what.into(),
                };
                let fault = Fault::new(raw.span.clone(), &format!("{path}.{key}"), message);
                reader.fault(fault.help(WrongBuilding::GiveSidesXY(key.to_string())));
            }
        }
    }
    (reader.faults.len() == before).then_some(())?;
    Some(FloorPart {
        name: floor.name.clone(),
        count: count?,
        heaviness: heaviness?,
        outline: outline?,
        centre: match centre {
            None => None,
            Some(centre) => Some(Box::new(centre?)),
        },
        gyration,
        height: height?,
        stiffness: stiffness?,
    })
}

/// The outline; `Some(None)` if none is given.
fn outline(reader: &mut Reader, floor: &FloorRaw, path: &str) -> Option<Option<Outline>> {
    let (span, key, outline) = match (&floor.sides, &floor.outline) {
        (None, None) => return Some(None),
        (Some(sides), None) => {
            let key = format!("{path}.sides");
            let [x, y]: [Quantity; 2] = lengths(reader, sides, &key, WrongBuilding::AlongXAlongY)?;
            (&sides.span, key, Outline::rectangle([0.0, 0.0], x.value, y.value))
        }
        (None, Some(corners)) => {
            let key = format!("{path}.outline");
            let mut all = Vec::with_capacity(corners.value.len());
            for (i, corner) in corners.value.iter().enumerate() {
                let [x, y]: [Quantity; 2] = lengths(reader, corner, &format!("{key}[{}]", i + 1), "[x, y]")?;
                all.push([x.value, y.value]);
            }
            (&corners.span, key, Outline::new(all))
        }
        (Some(_), Some(corners)) => {
            let fault = Fault::new(
                corners.span.clone(),
                path,
                WrongBuilding::HasBothSidesAnd(path.to_string()),
            );
            reader.fault(fault.help(WrongBuilding::KeepOneOfThemSides));
            return None;
        }
    };
    reader.mark(&key, span);
    match outline {
        Ok(outline) => Some(Some(outline)),
        Err(why) => {
            let message = format!("{key}: {why}");
            reader.fault(Fault::new(span.clone(), &key, message));
            None
        }
    }
}

fn stiffness(reader: &mut Reader, raw: &At<FloorRaw>, path: &str) -> Option<StoreyStiffnessPart> {
    match (&raw.value.walls, &raw.value.stiffness) {
        (Some(walls), None) => {
            let path = format!("{path}.walls");
            if !countable(reader, walls, &path) {
                return None;
            }
            reader.mark(&path, &walls.span);
            let numbered = walls.value.iter().enumerate();
            let all: Vec<Option<WallPart>> = numbered
                .map(|(i, raw)| wall(reader, raw, &format!("{path}[{}]", i + 1)))
                .collect();
            Some(StoreyStiffnessPart::Walls(
                all.into_iter().collect::<Option<_>>()?,
            ))
        }
        (None, Some(whole)) => whole_storey(reader, whole, &format!("{path}.stiffness")),
        (Some(_), Some(whole)) => {
            let fault = Fault::new(
                whole.span.clone(),
                path,
                WrongBuilding::HasBothWallsAnd(path.to_string()),
            );
            reader.fault(fault.help(WrongBuilding::KeepOneOfThemStiffness));
            None
        }
        (None, None) => {
            let walls = format!("{path}.walls");
            if !reader.is_reported(&walls) && !reader.is_reported(&format!("{path}.stiffness")) {
                let message = WrongBuilding::HasNeitherWallsNor(path.to_string());
                let fault = Fault::new(raw.span.clone(), &walls, message);
                reader.fault(fault.help(WrongBuilding::GiveWallsXY));
            }
            None
        }
    }
}

fn wall(reader: &mut Reader, raw: &At<WallRaw>, path: &str) -> Option<WallPart> {
    reader.mark(path, &raw.span);
    let before = reader.faults.len();
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let wall = &raw.value;
    let (x, y) = (
        of(&wall.x, "x", Measure::Length, Bound::Any),
        of(&wall.y, "y", Measure::Length, Bound::Any),
    );
    let not_negative = Bound::NotNegative;
    let stiffness_x = of(
        &wall.stiffness_x,
        "stiffness_x",
        Measure::StoreyStiffness,
        not_negative,
    );
    let stiffness_y = of(
        &wall.stiffness_y,
        "stiffness_y",
        Measure::StoreyStiffness,
        not_negative,
    );
    let stiffness_rotation = of(
        &wall.stiffness_rotation,
        "stiffness_rotation",
        Measure::JointStiffness,
        not_negative,
    );
    let angle = of(&wall.angle, "angle", Measure::Angle, Bound::Any);
    if stiffness_x.is_none() && stiffness_y.is_none() && reader.faults.len() == before {
        let key = format!("{path}.stiffness_x");
        let message = WrongBuilding::HasNeitherStiffnessX(path.to_string());
        let fault = Fault::new(raw.span.clone(), &key, message);
        reader.fault(fault.help(WrongBuilding::GiveLateralStiffnessOf));
    }
    (reader.faults.len() == before).then_some(())?;
    Some(WallPart {
        name: wall.name.clone(),
        x: x?,
        y: y?,
        stiffness_x,
        stiffness_y,
        stiffness_rotation,
        angle,
    })
}

fn whole_storey(
    reader: &mut Reader,
    raw: &At<StoreyStiffnessRaw>,
    path: &str,
) -> Option<StoreyStiffnessPart> {
    reader.mark(path, &raw.span);
    let given = &raw.value;
    if let Some(centre) = &given.centre {
        reader.mark(&format!("{path}.centre"), &centre.span);
    }
    let centre = given
        .centre
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &format!("{path}.centre"), "[x, y]"));
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, Bound::Positive)
    };
    let whole = [
        of(&given.x, "x", Measure::StoreyStiffness),
        of(&given.y, "y", Measure::StoreyStiffness),
        of(&given.rotation, "rotation", Measure::JointStiffness),
    ];
    if let Some(matrix) = &given.matrix {
        if let Some(extra) = whole.iter().flatten().next() {
            let message = WrongBuilding::HasBothMatrixAnd {
                path: path.to_string(),
                other: extra.path.rsplit('.').next().unwrap_or("").to_string(),
            };
            let fault = Fault::new(matrix.span.clone(), path, message);
            reader.fault(fault.help(WrongBuilding::KeepOneOfThemMatrix));
            return None;
        }
        let rows: Option<Vec<[f64; 3]>> = matrix
            .value
            .iter()
            .map(|row| <[f64; 3]>::try_from(row.as_slice()).ok())
            .collect();
        let Some(matrix) = rows.and_then(|rows| <[[f64; 3]; 3]>::try_from(rows).ok()) else {
            let fault = Fault::new(
                matrix.span.clone(),
                &format!("{path}.matrix"),
                WrongBuilding::MatrixIsNot(path.to_string()),
            );
            reader.fault(fault.allowed(WrongBuilding::MustBeThreeRows));
            return None;
        };
        return Some(StoreyStiffnessPart::Matrix {
            matrix,
            centre: Box::new(centre?),
        });
    }
    for (found, (written, key)) in
        whole
            .iter()
            .zip([(&given.x, "x"), (&given.y, "y"), (&given.rotation, "rotation")])
    {
        if found.is_none() && written.is_none() {
            let key = format!("{path}.{key}");
            let message = WrongBuilding::IsMissing(key.to_string());
            let fault = Fault::new(raw.span.clone(), &key, message);
            reader.fault(fault.help(WrongBuilding::StoreyResistsAlongX));
        }
    }
    let [x, y, rotation] = whole;
    Some(StoreyStiffnessPart::Whole {
        x: Box::new(x?),
        y: Box::new(y?),
        rotation: Box::new(rotation?),
        centre: Box::new(centre?),
    })
}

fn points(reader: &mut Reader, raw: Option<&At<Vec<At<WatchedRaw>>>>, floors: usize) -> Vec<WatchedPart> {
    let mut all: Vec<WatchedPart> = Vec::new();
    for (i, raw) in raw.into_iter().flat_map(|list| &list.value).enumerate() {
        let path = format!("points[{}]", i + 1);
        reader.mark(&path, &raw.span);
        let floor = floor_number(reader, raw.value.floor.as_ref(), &format!("{path}.floor"), floors);
        let place = raw
            .value
            .place
            .as_ref()
            .and_then(|raw| lengths(reader, raw, &format!("{path}.place"), "[x, y]"));
        let Some(name) = &raw.value.name else { continue };
        if all.iter().any(|other| other.name == name.value) {
            let message = WrongBuilding::TwoPointsAreNamed(name.value.to_string());
            let fault = Fault::new(name.span.clone(), &format!("{path}.name"), message);
            reader.fault(fault.help(WrongBuilding::GiveEachItsOwn));
        }
        if let (Some(floor), Some([x, y])) = (floor, &place)
            && let Some(other) = all.iter().find(|other| {
                let [u, v] = &*other.place;
                other.floor == floor && u.value == x.value && v.value == y.value
            })
        {
            let message = WrongBuilding::PointIsWhereIs {
                name: name.value.to_string(),
                other: other.name.to_string(),
            };
            reader.slip(&path, message, WrongBuilding::IsItsPlaceRight);
        }
        if let (Some(floor), Some(place)) = (floor, place) {
            all.push(WatchedPart {
                name: name.value.clone(),
                floor,
                place: Box::new(place),
            });
        }
    }
    all
}

/// Further faults that the library finds, at the line that causes them. A building that falls under its
/// weight is a verdict, not a fault of the file.
pub(crate) fn buildable(reader: &mut Reader, part: &mut BuildingPart) {
    let pick = &mut Quantity::nominal;
    let (built, stands) = match part.build(pick) {
        // its dampers are checked in any case
        Err(BuildingError::Falls { .. }) => {
            let parts = part.floors_and_storeys(pick);
            let elastic = parts.and_then(|(floors, storeys)| Building::new(floors, storeys, PDelta::LeftOut));
            (elastic, false)
        }
        built => (built, true),
    };
    let building = match built {
        Ok(building) => building,
        Err(why) => {
            let path = match &why {
                BuildingError::Element { storey, element, .. } => {
                    format!("floors[{}].walls[{element}]", part.part_of_floor(*storey))
                }
                BuildingError::Value { number, .. } => format!("floors[{}]", part.part_of_floor(*number)),
                BuildingError::Asymmetric { storey, .. }
                | BuildingError::Sways { storey, .. }
                | BuildingError::Twists { storey, .. } => format!("floors[{}]", part.part_of_floor(*storey)),
                BuildingError::Outside { floor, .. } => format!("floors[{}]", part.part_of_floor(*floor)),
                _ => "floors".to_owned(),
            };
            reader.fault(Fault::new(reader.place(&path), &path, said(&why)));
            return;
        }
    };
    for (i, point) in part.points.iter().enumerate() {
        let [x, y] = [point.place[0].value, point.place[1].value];
        if let Err(why) = building.point_row(point.floor, x, y, PlanDirection::X) {
            let path = format!("points[{}]", i + 1);
            reader.fault(Fault::new(reader.place(&path), &path, format!("{path}: {why}")));
        }
    }
    let vibrating = match VibratingBuilding::new(building, &part.damping(pick), Vec::new()) {
        Ok(vibrating) => vibrating,
        Err(DynamicsError::Building(why @ BuildingError::Linalg(_))) => {
            reader.fault(Fault::new(reader.place("floors"), "floors", said(&why)));
            return;
        }
        Err(why) => {
            let message = WrongBuilding::Damping(said(&why));
            reader.fault(Fault::new(reader.place("damping"), "damping", message));
            return; // dampers are tuned to damped modes
        }
    };
    judge_dampers(reader, part, &vibrating);
    part.as_written = stands.then_some(vibrating);
}
