//! The fixed words: verdicts with their thresholds, sources of numbers, names of parts.

use super::fronted::{Fronted, text};
use dolmen::stability::Verdict;
use dolmen::structure::Convention;
use dolmen_project::{Evidence, Project, StoreyStiffnessPart, Structure};
use dolmen_words::{Language, Quantity, printed_name};
use dolmen_work::judgement::{Colour, Judgement, Weight};

pub(crate) fn verdict_word(verdict: Verdict, language: Language) -> &'static str {
    match verdict {
        Verdict::Stable => language.pick("stable", "안정"),
        Verdict::Marginal => language.pick("marginal", "여유 부족"),
        Verdict::Unstable => language.pick("unstable", "불안정"),
        Verdict::Unknown => language.pick("unknown", "판정 불가"),
    }
}

/// The style class of a colour.
pub(crate) fn colour_class(colour: Colour) -> &'static str {
    match colour {
        Colour::Green => "stable",
        Colour::Amber => "marginal",
        Colour::Red => "unstable",
    }
}

/// The sign before a judgement, for readers who cannot see colours.
pub(crate) fn judgement_sign(judgement: &Judgement) -> &'static str {
    let weight = judgement.headline().and_then(|of| of.weight);
    match (judgement.colour(), weight) {
        (Colour::Green, _) => "●",
        (Colour::Amber, Some(Weight::Unknown { .. })) => "?",
        (Colour::Amber, _) => "◆",
        (Colour::Red, _) => "✕",
    }
}

/// The meaning of the words, with their thresholds.
pub(crate) fn thresholds(language: Language) -> String {
    let limit = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
    text(Fronted::Thresholds(limit), language)
}

/// Source of a number.
pub(crate) fn evidence_word(evidence: Option<Evidence>, language: Language) -> &'static str {
    match evidence {
        Some(Evidence::Measured) => language.pick("measured", "실측"),
        Some(Evidence::Test) => language.pick("test", "시험"),
        Some(Evidence::Literature) => language.pick("literature", "문헌"),
        Some(Evidence::Identified) => language.pick("identified", "계측 진동에서 추정"),
        Some(Evidence::Assumed) => language.pick("assumed", "가정"),
        None => language.pick("not stated", "출처 미기재"),
    }
}

/// The convention of the springs of a frame.
pub(crate) fn convention_word(convention: Convention, language: Language) -> &'static str {
    match convention {
        Convention::Drift => language.pick("spring on storey drift", "층간변위에 작용하는 스프링"),
        Convention::Grounded => language.pick(
            "spring on displacement from the ground (as printed)",
            "지반 기준 변위에 작용하는 스프링(논문 표기)",
        ),
    }
}

/// A unit as printed: "N m/rad" is "N·m/rad".
pub(crate) fn unit_text(unit: &str) -> String {
    set(&unit.replace(' ', "·"))
}

/// A value as the file writes it, with the signs of print: "12 kN*m/rad" is "12 kN·m/rad", "kg/m3" is "kg/m³".
pub(crate) fn set(written: &str) -> String {
    let signs: Vec<char> = written.chars().collect();
    let is_power = |at: usize| {
        let ends = signs.get(at + 1).is_none_or(|next| !next.is_alphanumeric());
        let word: String = signs[..at]
            .iter()
            .rev()
            .take_while(|sign| sign.is_alphabetic())
            .collect();
        ends && matches!(word.as_str(), "m" | "mm" | "mc" | "mk" | "s")
    };
    let each = signs.iter().enumerate().map(|(at, sign)| match sign {
        '*' => '·',
        '2' if is_power(at) => '²',
        '3' if is_power(at) => '³',
        '4' if is_power(at) => '⁴',
        other => *other,
    });
    each.collect()
}

/// `links[1].weight` in words, "link 1, weight"; an unknown path stays as it is.
pub(crate) fn path_words(path: &str, language: Language) -> String {
    if let Some(words) = survey_words(path, language) {
        return words;
    }
    if path == "density" {
        return language.pick("density of the stones", "석재 밀도").to_string();
    }
    if path == "damping_ratio" {
        return language
            .pick("damping ratio of the first mode", "1차 모드 감쇠비")
            .to_string();
    }
    if let Some(words) = direction_words(path, language).or_else(|| damper_words(path, language)) {
        return words;
    }
    let Some((part, quantity)) = path.rsplit_once('.') else {
        return path.to_string();
    };
    match (part_words(part, language), quantity_word(quantity, language)) {
        (Some(part), Some(quantity)) => format!("{part} {quantity}"),
        _ => stack_words(path, language).unwrap_or_else(|| path.to_string()),
    }
}

/// The same with the names that the file gives: `blocks[4].width` is "1층탑신 폭", `loads[1].force[3]` "load ‘statue’ force z".
pub(crate) fn input_words(project: &Project, path: &str, language: Language) -> String {
    let words = path_words(path, language);
    let mut named_words = words.clone();
    for (numbered, name) in names(project, path, language) {
        named_words = named_words.replacen(&numbered, &name, 1);
    }
    named_words
}

/// The numbered parts of a path in words, each with its name in the file.
fn names(project: &Project, path: &str, language: Language) -> Vec<(String, String)> {
    let numbered = |part: &str| part_words(part, language);
    let printed = |name: &str| printed_name(name, language).into_owned();
    let mut all = Vec::new();
    let Some((first, rest)) = path.split_once(']') else {
        return all;
    };
    let part = format!("{first}]");
    if let (Some(name), Some(numbered)) = (named(&project.structure, path), numbered(&part)) {
        all.push((numbered, printed(name)));
    }
    let quoted = |words: &str, name: &str| {
        let kind = words
            .trim_end_matches(|sign: char| sign.is_ascii_digit())
            .trim_end();
        format!("{kind} ‘{}’", printed(name))
    };
    let mut quote = |part: &str, name: Option<&str>| {
        if let (Some(name), Some(words)) = (name, stack_words(part, language)) {
            all.push((words.clone(), quoted(&words, name)));
        }
    };
    let at = |part: &str| -> Option<usize> {
        let number: usize = part.split_once('[')?.1.trim_end_matches(']').parse().ok()?;
        number.checked_sub(1)
    };
    let building = match &project.structure {
        Structure::Building(of) => Some(&**of),
        Structure::Chain(_) | Structure::Frame(_) | Structure::Stack(_) | Structure::Survey => None,
    };
    match (first.split('[').next(), at(&part)) {
        (Some("loads"), Some(at)) => {
            let load = project.loads.loads.get(at);
            quote(&part, load.map(|load| load.name.as_str()));
        }
        (Some("points"), Some(at)) => {
            let point = building.and_then(|of| of.points.get(at));
            quote(&part, point.map(|point| point.name.as_str()));
        }
        (Some("floors"), Some(floor)) => {
            let floor = building.and_then(|of| of.floors.get(floor));
            quote(&part, floor.and_then(|floor| floor.name.as_deref()));
            let wall = rest
                .trim_start_matches('.')
                .split('.')
                .next()
                .filter(|of| of.starts_with("walls["));
            if let (Some(wall), Some(StoreyStiffnessPart::Walls(walls))) =
                (wall, floor.map(|of| &of.stiffness))
            {
                let own = at(wall).and_then(|at| walls.get(at));
                quote(wall, own.and_then(|wall| wall.name.as_deref()));
            }
        }
        _ => {}
    }
    all
}

/// The name in the file of the part of a path: of `blocks[4].width`, `links[2].length` or `storeys[1].mass`.
fn named<'a>(structure: &'a Structure, path: &str) -> Option<&'a str> {
    let (kind, rest) = path.split_once('[')?;
    let number: usize = rest.split_once(']')?.0.parse().ok()?;
    let at = number.checked_sub(1)?;
    match (structure, kind) {
        (Structure::Stack(part), "blocks") => Some(part.blocks.get(at)?.name.as_str()),
        (Structure::Chain(part), "links") => part.links.get(at)?.name.as_deref(),
        (Structure::Frame(part), "storeys") => part.storeys.get(at)?.name.as_deref(),
        _ => None,
    }
}

/// "1층탑신" and "폭" for `blocks[4].width`; `None` for paths without a numbered part.
pub(crate) fn part_and_quantity(
    project: &Project,
    path: &str,
    language: Language,
) -> Option<(String, String)> {
    let whole = input_words(project, path, language);
    let (part, _) = path.split_once("].")?;
    let name = match named(&project.structure, path) {
        Some(name) => printed_name(name, language).into_owned(),
        None => part_words(&format!("{part}]"), language)?,
    };
    let quantity = whole.strip_prefix(&name)?.trim_start_matches([' ', ',', ':']);
    (!quantity.is_empty()).then(|| (name, quantity.to_owned()))
}

/// `survey.2009.frequencies.x[1]` and `survey.2009.modes.x[1].frequency`.
fn survey_words(path: &str, language: Language) -> Option<String> {
    let rest = path.strip_prefix("survey.")?;
    let (place, damping) = match rest.strip_suffix(".frequency") {
        Some(place) => (place, false),
        None => match rest.strip_suffix(".damping_ratio") {
            Some(place) => (place, true),
            None => (rest, false),
        },
    };
    let (survey, mode) = place
        .split_once(".frequencies.")
        .or_else(|| place.split_once(".modes."))?;
    let (direction, number) = mode.strip_suffix(']')?.split_once('[')?;
    let quantity = if damping {
        language.pick("damping ratio", "감쇠비")
    } else {
        language.pick("frequency", "고유진동수")
    };
    let survey = printed_name(survey, language);
    Some(language.pick(
        format!("{quantity} {number}, direction {direction} (survey {survey})"),
        format!("{direction} 방향 {quantity} {number} ({survey} 조사)"),
    ))
}

/// `direction.weak.stiffness[1]` and `direction.weak.friction.coefficient` of a frame.
fn direction_words(path: &str, language: Language) -> Option<String> {
    let (direction, rest) = path.strip_prefix("direction.")?.split_once('.')?;
    let (quantity, number) = match rest.split_once('[') {
        Some((quantity, number)) => (quantity, number.strip_suffix(']')),
        None => (rest, None),
    };
    let quantity = match quantity {
        "stiffness" => language.pick("stiffness", "강성"),
        "damping_ratio" => language.pick("damping ratio", "감쇠비"),
        "friction.coefficient" => language.pick("friction coefficient", "마찰계수"),
        "friction.static_coefficient" => language.pick("static friction coefficient", "정지마찰계수"),
        "friction.force" => language.pick("friction force", "마찰력"),
        "friction.slipping_stiffness" => language.pick("stiffness while slipping", "미끄럼 시 강성"),
        _ => return None,
    };
    Some(match number {
        Some(number) => language.pick(
            format!("direction {direction}, storey {number}: {quantity}"),
            format!("{direction} 방향 {number}층 {quantity}"),
        ),
        None => language.pick(
            format!("direction {direction}: {quantity}"),
            format!("{direction} 방향 {quantity}"),
        ),
    })
}

/// `damper.roof.masses[1].share` as "damper roof mass 1 share"; the name is the user's.
fn damper_words(path: &str, language: Language) -> Option<String> {
    let (name, rest) = path.strip_prefix("damper.")?.split_once('.')?;
    let quantity = stack_words(rest, language)?;
    Some(format!(
        "{} {name}, {quantity}",
        language.pick("damper", "감쇠기")
    ))
}

/// `blocks[5].openings[1].position[2]` as "block 5 opening 1 position y", segment by segment.
fn stack_words(path: &str, language: Language) -> Option<String> {
    let each = path.split('.').map(|segment| {
        let (name, numbers) = segment.split_once('[').unwrap_or((segment, ""));
        let axis = |number: &str| match number {
            "1" => Some("x"),
            "2" => Some("y"),
            "3" => Some("z"),
            _ => None,
        };
        let number = numbers.trim_end_matches(']');
        Some(match name {
            "blocks" => format!("{} {number}", language.pick("block", "블록")),
            "openings" => format!("{} {number}", language.pick("opening", "개구부")),
            "contacts" => format!("{} {number}", language.pick("contact", "접촉면")),
            "ties" => format!("{} {number}", language.pick("tie", "연결재")),
            "links" => format!("{} {number}", language.pick("link", "부재")),
            "joints" => format!("{} {number}", language.pick("joint", "접합면")),
            "storeys" => format!("{} {number}", language.pick("storey", "층")),
            "loads" => format!("{} {number}", language.pick("load", "하중")),
            "masses" => format!("{} {number}", language.pick("mass", "질량")),
            "ratios" => format!("{} {number}", language.pick("ratio", "감쇠비")),
            "columns" => language.pick("columns:", "기둥").to_owned(),
            "wind" => language.pick("wind:", "바람").to_owned(),
            "combination" => language.pick("combination", "하중조합").to_owned(),
            "areas" | "surfaces" | "parts" if path.starts_with("wind") => {
                format!("{} {number}", language.pick("surface", "수풍면"))
            }
            "floors" => format!("{} {number}", language.pick("floor", "바닥")),
            "walls" => format!("{} {number}", language.pick("wall", "벽체")),
            "damping" if path.starts_with("damping.") => language.pick("damping", "모드").to_owned(),
            "ratio" => language.pick("ratio", "감쇠비").to_owned(),
            "stiffness_x" => language.pick("stiffness x", "강성 x").to_owned(),
            "stiffness_y" => language.pick("stiffness y", "강성 y").to_owned(),
            "rotation" if path.starts_with("floors") => language.pick("against turning", "회전").to_owned(),
            "centre" => format!("{} {}", language.pick("centre", "중심"), axis(number)?),
            "place" => format!("{} {}", language.pick("place", "위치"), axis(number)?),
            "side_supports" => format!("{} {number}", language.pick("side support", "측면 지지")),
            "support_movement" => {
                format!("{} {number}", language.pick("support movement", "지점 변위"))
            }
            "pagoda" => language.pick("pagoda:", "석탑").to_owned(),
            "arch" => language.pick("arch:", "아치").to_owned(),
            "wall" => language.pick("wall:", "벽체").to_owned(),
            "tower" => language.pick("tower:", "탑").to_owned(),
            "trilithon" => language.pick("trilithon:", "삼석문").to_owned(),
            "vault" => language.pick("vault:", "볼트").to_owned(),
            "dome" => language.pick("dome:", "돔").to_owned(),
            "joint" => language.pick("joint", "접합면").to_owned(),
            "tilt" => language.pick("tilt", "기울기").to_owned(),
            "x" | "y" | "z" => name.to_owned(),
            "position" => format!("{} {}", language.pick("position", "위치"), axis(number)?),
            "force" if !number.is_empty() => {
                format!("{} {}", quantity_word("force", language)?, axis(number)?)
            }
            "at" => format!("{} {}", language.pick("place", "위치"), axis(number)?),
            "offset" => format!("{} {}", language.pick("offset", "편심"), axis(number)?),
            "points" if path.starts_with("points") => format!("{} {number}", language.pick("point", "점")),
            "points" => {
                let (point, coordinate) = number.split_once("][")?;
                format!("{} {point} {}", language.pick("point", "점"), axis(coordinate)?)
            }
            other => quantity_word(other, language)?.to_owned(),
        })
    });
    Some(each.collect::<Option<Vec<_>>>()?.join(" "))
}

fn part_words(part: &str, language: Language) -> Option<String> {
    let whole = match part {
        "joint" => Some(language.pick("all joints:", "모든 접합면")),
        "soil" => Some(language.pick("soil:", "지반")),
        "stone" => Some(language.pick("stone:", "석재")),
        _ => None,
    };
    if let Some(whole) = whole {
        return Some(whole.to_owned());
    }
    let (kind, number) = part.split_once('[')?;
    let number = number.strip_suffix(']')?;
    let kind = match kind {
        "links" => language.pick("link", "부재"),
        "joints" => language.pick("joint", "접합면"),
        "storeys" => language.pick("storey", "층"),
        "blocks" => language.pick("block", "블록"),
        _ => return None,
    };
    number
        .bytes()
        .all(|b| b.is_ascii_digit())
        .then(|| format!("{kind} {number}"))
}

fn quantity_word(quantity: &str, language: Language) -> Option<&'static str> {
    Some(match quantity {
        "weight" => language.pick("weight", "무게"),
        "mass" => language.pick("mass", "질량"),
        "length" => language.pick("length", "길이"),
        "centroid" => language.pick("height of centre of mass", "무게중심 높이"),
        "inertia" => language.pick("moment of inertia", "질량 관성모멘트"),
        "breadth" => language.pick("breadth", "폭"),
        "bed_width" => language.pick("bed width", "접합면 폭"),
        "stiffness" => language.pick("stiffness", "강성"),
        "friction_moment" => language.pick("moment of friction", "마찰 모멘트"),
        "static_friction_moment" => language.pick("static moment of friction", "정지마찰 모멘트"),
        "damping" => language.pick("damping", "감쇠"),
        "height" => language.pick("height", "높이"),
        "axial_force" => language.pick("axial force", "축력"),
        "width" => language.pick("width", "폭"),
        "depth" => language.pick("depth", "깊이"),
        "post_width" => language.pick("width of a post", "기둥돌 폭"),
        "post_height" => language.pick("height of a post", "기둥돌 높이"),
        "lintel_height" => language.pick("height of the lintel", "인방돌 높이"),
        "overhang" => language.pick("overhang of the lintel", "인방돌 내민 길이"),
        "oculus" => language.pick("width of the oculus", "천창 지름"),
        "drum_height" => language.pick("height of the drum", "드럼 높이"),
        "top_width" => language.pick("width at the top", "윗면 폭"),
        "top_depth" => language.pick("depth at the top", "윗면 깊이"),
        "diameter" => language.pick("diameter", "지름"),
        "top_diameter" => language.pick("diameter at the top", "윗면 지름"),
        "density" => language.pick("density", "밀도"),
        "rotation" => language.pick("turn about the vertical", "비틀림각(연직축 회전)"),
        "friction" => language.pick("friction coefficient", "마찰계수"),
        "friction_kinetic" => language.pick("kinetic friction coefficient", "운동마찰계수"),
        "cohesion" => language.pick("cohesion", "점착력"),
        "tension" => language.pick("tensile strength of the bond", "부착 인장강도"),
        "normal_stiffness" => language.pick("normal stiffness", "수직 강성"),
        "shear_stiffness" => language.pick("shear stiffness", "전단 강성"),
        "restitution" | "normal_restitution" => language.pick("restitution of falls", "수직 반발계수"),
        "rocking_restitution" => language.pick("restitution of rocking", "로킹 반발계수"),
        "damping_ratio" => language.pick("damping ratio", "감쇠비"),
        "body_height" => language.pick("height of all storeys", "탑신 높이"),
        "body_slenderness" => language.pick("body slenderness", "탑신 세장비"),
        "slenderness_angle" => language.pick("slenderness angle", "세장각"),
        "taper" => language.pick("taper", "체감각"),
        "body_base_height_ratio" => language.pick("body height / base height", "탑신/기단 높이비"),
        "span" => language.pick("span", "경간"),
        "rise" => language.pick("rise", "라이즈"),
        "thickness" => language.pick("thickness", "두께"),
        "springing_height" => language.pick("height of the springing", "기공점 높이"),
        "abutment" => language.pick("width of the abutments", "교대 폭"),
        "course_height" => language.pick("height of a course", "켜 높이"),
        "stone_length" => language.pick("length of a stone", "부재 길이"),
        "gap" => language.pick("gap", "유격"),
        "elastic_modulus" => language.pick("Young's modulus", "탄성계수"),
        "shear_modulus" => language.pick("shear modulus", "전단탄성계수"),
        "poisson_ratio" => language.pick("Poisson's ratio", "푸아송비"),
        "along" => language.pick("side along the motion", "진동 방향 변"),
        "across" => language.pick("side across the motion", "직각 방향 변"),
        "axial_stiffness" => language.pick("axial stiffness", "축강성"),
        "tension_strength" => language.pick("tensile strength", "인장강도"),
        "strength" => language.pick("compressive strength", "압축강도"),
        "inertia_across" => language.pick("moment of inertia across", "직각 방향 관성모멘트"),
        "stiffness_across" => language.pick("stiffness across", "직각 방향 강성"),
        "bed_depth" => language.pick("bed depth", "밑면 깊이"),
        "bed_stiffness" => language.pick("bed stiffness", "밑면 강성"),
        "force" => language.pick("force", "힘"),
        "moment" => language.pick("moment", "모멘트"),
        "torque" => language.pick("torque", "비틀림 모멘트"),
        "acceleration_limit" => {
            language.pick("allowed acceleration of the top floor", "최상층 가속도 허용값")
        }
        "speed" => language.pick("speed", "풍속"),
        "pressure" => language.pick("pressure", "풍압"),
        "force_coefficient" => language.pick("force coefficient", "풍력계수"),
        "area" => language.pick("area", "면적"),
        "gyration" => language.pick("radius of gyration", "회전반경"),
        "stroke" => language.pick("room each way", "여유 공간"),
        "liquid_stroke" => language.pick("room of the liquid each way", "액체의 여유 공간"),
        "mass_ratio" => language.pick("mass ratio", "질량비"),
        "frequency" => language.pick("frequency", "진동수"),
        "frequency_ratio" => language.pick("frequency ratio", "진동수비"),
        "length_ratio" => language.pick("length ratio", "길이비"),
        "liquid_share" => language.pick("share of the liquid", "액체의 비율"),
        "liquid_frequency" => language.pick("frequency of the liquid", "액체의 진동수"),
        "liquid_damping_ratio" => language.pick("damping ratio of the liquid", "액체의 감쇠비"),
        "share" => language.pick("share", "비율"),
        "coefficient" => language.pick("coefficient", "감쇠계수"),
        "shear_strength" => language.pick("shear strength", "전단강도"),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_stones_are_called_by_their_names() {
        let text = "schema = 1\nkind = \"stack\"\nname = \"T\"\ndensity = 2600\njoint = { friction = 0.7 }\n\
                    blocks = [{ name = \"기단\", width = 1, height = 1 }, { name = \"1층탑신\", width = 0.8, height = 1.2 }]\n";
        let project = dolmen_project::parse_project(text, "p.toml").unwrap();
        let of = |path| input_words(&project, path, Language::Korean);
        assert_eq!(of("blocks[2].width"), "1층탑신 폭");
        assert_eq!(of("blocks[9].width"), "블록 9 폭");
        assert_eq!(of("density"), "석재 밀도");
        assert_eq!(of("trilithon.post_height"), "삼석문 기둥돌 높이");
        assert_eq!(of("dome.oculus"), "돔 천창 지름");
        assert_eq!(
            input_words(&project, "blocks[1].tilt.x", Language::English),
            "기단 tilt x"
        );
    }

    #[test]
    fn exact_loads_walls_and_points_are_called_by_their_names_and_axes() {
        let text = "schema = 1\nkind = \"building\"\nname = \"H\"\nunits = { mass = \"t\", stiffness = \"kN/mm\" }\n\
                    floors = [{ mass = 100, sides = [8, 6], height = 3, walls = [\n\
                    { name = \"left\", x = -4, y = 0, stiffness_x = 10, stiffness_y = 10 }, { x = 4, y = 0, stiffness_x = 10, stiffness_y = 10 }] }]\n\
                    points = [{ name = \"right edge\", floor = 1, place = [4, 0] }]\n\
                    loads = [{ name = \"crane\", at = \"1\", force = [\"60 kN\", 0], torque = \"900 kN*m\" }]\n";
        let project = dolmen_project::parse_project(text, "p.toml").unwrap();
        for (path, english, korean) in [
            ("loads[1].force[1]", "load ‘crane’ force x", "하중 ‘crane’ 힘 x"),
            (
                "loads[1].torque",
                "load ‘crane’ torque",
                "하중 ‘crane’ 비틀림 모멘트",
            ),
            (
                "points[1].place[2]",
                "point ‘right edge’ place y",
                "점 ‘right edge’ 위치 y",
            ),
            (
                "floors[1].walls[1].stiffness_x",
                "floor 1 wall ‘left’ stiffness x",
                "바닥 1 벽체 ‘left’ 강성 x",
            ),
            (
                "floors[1].walls[2].stiffness_x",
                "floor 1 wall 2 stiffness x",
                "바닥 1 벽체 2 강성 x",
            ),
            (
                "wind.acceleration_limit",
                "wind: allowed acceleration of the top floor",
                "바람 최상층 가속도 허용값",
            ),
        ] {
            assert_eq!(input_words(&project, path, Language::English), english);
            assert_eq!(input_words(&project, path, Language::Korean), korean);
        }
    }

    #[test]
    fn exact_powers_of_units_are_raised_and_other_numbers_are_not() {
        for (written, shown) in [
            ("0.5 m2", "0.5 m²"),
            ("7 kg/m3", "7 kg/m³"),
            ("2 kg*m2", "2 kg·m²"),
            ("9 m/s2", "9 m/s²"),
            ("12.3 mm4", "12.3 mm⁴"),
            ("EN 1991-1-4", "EN 1991-1-4"),
            ("12 kN*m/rad", "12 kN·m/rad"),
        ] {
            assert_eq!(set(written), shown);
        }
    }

    #[test]
    fn exact_paths_of_stacks_have_words() {
        for (path, english, korean) in [
            ("blocks[5].width", "block 5 width", "블록 5 폭"),
            (
                "blocks[5].openings[1].position[2]",
                "block 5 opening 1 position y",
                "블록 5 개구부 1 위치 y",
            ),
            ("blocks[2].points[3][1]", "block 2 point 3 x", "블록 2 점 3 x"),
            ("blocks[2].tilt.x", "block 2 tilt x", "블록 2 기울기 x"),
            (
                "blocks[2].joint.friction",
                "block 2 joint friction coefficient",
                "블록 2 접합면 마찰계수",
            ),
            ("pagoda.taper", "pagoda: taper", "석탑 체감각"),
            (
                "direction.weak.stiffness[2]",
                "direction weak, storey 2: stiffness",
                "weak 방향 2층 강성",
            ),
            (
                "direction.x.friction.coefficient",
                "direction x: friction coefficient",
                "x 방향 마찰계수",
            ),
            (
                "joints[1].strength",
                "joint 1 compressive strength",
                "접합면 1 압축강도",
            ),
            ("loads[2].moment", "load 2 moment", "하중 2 모멘트"),
            (
                "storeys[1].columns.bed_stiffness",
                "storey 1 columns: bed stiffness",
                "층 1 기둥 밑면 강성",
            ),
            (
                "wind.force_coefficient",
                "wind: force coefficient",
                "바람 풍력계수",
            ),
            (
                "damper.roof.masses[1].share",
                "damper roof, mass 1 share",
                "감쇠기 roof, 질량 1 비율",
            ),
            ("nothing.known[1]", "nothing.known[1]", "nothing.known[1]"),
        ] {
            assert_eq!(path_words(path, Language::English), english);
            assert_eq!(path_words(path, Language::Korean), korean);
        }
    }
}
