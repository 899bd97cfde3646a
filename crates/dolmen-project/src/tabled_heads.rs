//! Heads of the columns of tables of parts, by the keys of the lists.

use super::measure::Measure;

/// A column: its key, other names of its head, and its measure.
pub(super) type Column = (&'static str, &'static [&'static str], Option<Measure>);

const BLOCKS: &[Column] = &[
    ("name", &["이름", "부재", "부재명"], None),
    ("shape", &["형상"], None),
    ("width", &["폭", "너비"], Some(Measure::Length)),
    ("depth", &["깊이", "두께"], Some(Measure::Length)),
    ("height", &["높이"], Some(Measure::Length)),
    ("top_width", &["상부 폭", "상부폭"], Some(Measure::Length)),
    ("top_depth", &["상부 깊이", "상부깊이"], Some(Measure::Length)),
    ("diameter", &["지름", "직경"], Some(Measure::Length)),
    ("top_diameter", &["상부 지름", "상부지름"], Some(Measure::Length)),
    ("sides", &["변 수", "변수"], None),
    ("density", &["밀도"], Some(Measure::Density)),
];
const LINKS: &[Column] = &[
    ("name", &["이름", "부재", "부재명"], None),
    ("weight", &["무게", "중량"], Some(Measure::Force)),
    ("mass", &["질량"], Some(Measure::Mass)),
    ("length", &["길이", "높이"], Some(Measure::Length)),
    ("centroid", &["무게중심", "무게중심 높이"], Some(Measure::Length)),
    ("breadth", &["폭", "너비"], Some(Measure::Length)),
    ("bed_width", &["접합면 폭", "접합면폭"], Some(Measure::Length)),
];
const STOREYS: &[Column] = &[
    ("name", &["이름", "층"], None),
    ("weight", &["무게", "중량"], Some(Measure::Force)),
    ("mass", &["질량"], Some(Measure::Mass)),
    ("height", &["높이", "층고"], Some(Measure::Length)),
    ("axial_force", &["축력"], Some(Measure::Force)),
];
/// Keys of parts that tables do not take: without a fault the model would miss such a column.
pub(super) const ELSEWHERE: [&str; 24] = [
    "tilt",
    "lean",
    "offset",
    "friction",
    "stiffness",
    "strength",
    "cohesion",
    "tension",
    "damping",
    "damping ratio",
    "at",
    "x",
    "y",
    "z",
    "columns",
    "기울기",
    "이동",
    "이동량",
    "마찰",
    "마찰계수",
    "강성",
    "강도",
    "감쇠비",
    "좌표",
];
pub(super) const LISTS: [(&str, &[Column]); 3] = [("blocks", BLOCKS), ("links", LINKS), ("storeys", STOREYS)];
