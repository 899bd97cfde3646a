//! Phrases in errors of the library: quantities, parts and their limits.

use super::phrases_of_stacks::PHRASES_OF_STACKS;

/// A phrase in Korean; an unknown phrase is a key, and stays as it is.
pub(super) fn phrase(english: &str) -> &str {
    let known = PHRASES
        .iter()
        .chain(PHRASES_OF_STACKS)
        .find(|(known, _)| *known == english);
    known.map_or(english, |(_, korean)| korean)
}

const PHRASES: &[(&str, &str)] = &[
    ("below 30° (0.524 rad) in size", "크기가 30°(0.524 rad) 미만"),
    (
        "the start of a run of samples within the series, in order and apart",
        "자료 안에서 순서대로 서로 떨어진 구간의 시작",
    ),
    (
        "1 or more, with a site that sees them",
        "모드를 볼 자리와 함께 1 이상",
    ),
    ("a finite number a mode", "모드마다 유한한 수 하나"),
    ("sites of the list, each once", "목록의 자리, 한 번씩"),
    ("1 to the number of sites", "1에서 자리의 수까지"),
    ("0 (exact) or a positive number", "0(정확한 값) 또는 양수"),
    ("positive", "양수"),
    ("positive and finite", "양의 유한한 수"),
    ("a number", "수"),
    ("0 where both directions rub", "두 방향이 함께 마찰하면 0"),
    ("directions with sliders", "마찰이 변위에 작용하는 방향의 수"),
    ("the second direction", "둘째 방향"),
    ("finite numbers", "유한한 수"),
    ("of finite numbers", "유한한 수로 이루어진 행렬"),
    ("a finite number at every sample", "모든 자료에서 유한한 수"),
    ("a positive number at every period", "모든 주기에서 양수"),
    ("a finite number other than 0", "0이 아닌 유한한 수"),
    (
        "other than 0: leave the shape out",
        "0이 아닌 수(아니면 모드형상을 뺀다)",
    ),
    ("0 or more", "0 이상"),
    (
        "1 or more (infinite for a deviation that is known)",
        "1 이상(표준편차를 알면 무한대)",
    ),
    ("6 or more", "6 이상"),
    ("at least 2", "2 이상"),
    ("at least 4", "4 이상"),
    ("at least 5", "5 이상"),
    ("ascending", "커지는 순서"),
    ("one a point", "점마다 하나"),
    (
        "one that the stiffness of the designs can give",
        "설계안의 강성으로 나올 수 있는 값",
    ),
    (
        "none: the stones must be loose",
        "없음: 접합이 없는 부재여야 한다",
    ),
    ("above 0", "0보다 큰 수"),
    ("above 0 and finite", "0보다 큰 유한한 수"),
    ("above 0 and at most 2", "0보다 크고 2 이하인 수"),
    ("above 0 and at most 3", "0보다 크고 3 이하인 수"),
    ("above 0 and at most 10", "0보다 크고 10 이하인 수"),
    ("above 0 and below 0.5", "0보다 크고 0.5보다 작은 수"),
    ("above 1 and at most 100", "1보다 크고 100 이하인 수"),
    ("at least 0.5 and below 1", "0.5 이상 1 미만인 수"),
    ("0.5 to below 1", "0.5 이상 1 미만인 수"),
    ("0 to 2", "0~2"),
    ("0 to 6", "0~6"),
    ("8 to 1000", "8~1000"),
    ("0 to 0.5 steps", "시간 간격의 0~0.5배"),
    ("between 0 and 0.3", "0과 0.3 사이의 수"),
    ("between 0.0001 and 0.5", "0.0001과 0.5 사이의 수"),
    ("between 0.1 and 10,000", "0.1과 10,000 사이의 수"),
    ("between 0.01 and 1", "0.01과 1 사이의 수"),
    ("between 0 and π/2", "0과 π/2 사이의 수"),
    ("between 0 and 1, both excluded", "0보다 크고 1보다 작은 수"),
    (
        "between 0 and 1, both excluded (0.95 is 95 %)",
        "0과 1 사이(0.95가 95 %)",
    ),
    ("between 0 and 10 (0.1 is 10 %)", "0과 10 사이의 수(0.1이 10 %)"),
    (
        "between 0 and half the sampling rate",
        "0과 샘플링 주파수 절반 사이",
    ),
    ("between 0 and 0.05 per °C", "°C당 0과 0.05 사이의 수"),
    ("within ±0.05 per °C", "°C당 ±0.05 이내의 수"),
    ("less than π/2 to either side", "양쪽으로 π/2보다 작은 수"),
    (
        "less than the rotation of the fall to either side",
        "양쪽으로 전도 회전각보다 작은 수",
    ),
    (
        "finite, and so large that the columns stand",
        "기둥이 서 있을 만큼 큰 유한한 수",
    ),
    ("in (0, 1]", "0보다 크고 1 이하인 수"),
    (
        "0 to 1: the weaker component over the stronger",
        "0~1(약한/강한 성분)",
    ),
    ("0 to 10: is it in percent?", "0~10(퍼센트 단위인가?)"),
    ("0 to 0.9: is it in percent?", "0~0.9(퍼센트 단위인가?)"),
    ("0 to 0.95: is it in percent?", "0~0.95(퍼센트 단위인가?)"),
    ("0.005 to 0.3 (is it in percent?)", "0.005~0.3(퍼센트 단위인가?)"),
    ("0.005 to 0.5: is it in percent?", "0.005~0.5(퍼센트 단위인가?)"),
    (
        "0 or more and below 1: is it in percent?",
        "0 이상 1 미만인 수(퍼센트 단위인가?)",
    ),
    (
        "above 0 and at most 2: is it in g?",
        "0보다 크고 2 이하인 수(g 단위인가?)",
    ),
    (
        "above 0 and at most 0.3, where the table of soils ends: is it in g?",
        "0보다 크고 지반 표의 끝인 0.3 이하인 수(g 단위인가?)",
    ),
    ("0 or a positive number, at most 3", "0 이상 3 이하인 수"),
    (
        "0.05 or more, in g: the code has 0.11 (zone I) and 0.07 (zone II), its map somewhat less",
        "0.05 g 이상(기준은 Ⅰ구역 0.11, Ⅱ구역 0.07이고 지도는 조금 작다)",
    ),
    (
        "above 0 and at most half the duration of the motion",
        "0보다 크고 지반운동 길이의 절반 이하인 수",
    ),
    (
        "above 0 and below half the sampling rate",
        "0보다 크고 샘플링 주파수의 절반보다 작은 수",
    ),
    (
        "above frequency_low_hz and at most half the sampling rate",
        "frequency_low_hz보다 크고 샘플링 주파수의 절반 이하인 수",
    ),
    (
        "at least 0 and below frequency_high_hz",
        "0 이상 frequency_high_hz 미만인 수",
    ),
    (
        "at least 2, and at least the reference channels",
        "2 이상이고 기준 채널 수 이상",
    ),
    (
        "at least 2 and at most half the samples",
        "2 이상이고 자료 수의 절반 이하인 수",
    ),
    ("an even number of at least 2", "2 이상의 짝수"),
    (
        "8 or more: a mode must come back at four orders, 2, 4, 6 and 8",
        "8 이상(모드는 차수 2, 4, 6, 8의 네 번에서 나타나야 한다)",
    ),
    (
        "at most the lines of the spectrum less one, times the reference channels: raise lags or widen the range",
        "(스펙트럼 선의 수 − 1) × 기준 채널 수 이하(lags를 키우거나 범위를 넓힌다)",
    ),
    ("8 to 10 million time steps", "시간 간격 8~1000만 개"),
    (
        "the index of a channel, counted from 0, each once",
        "0부터 센 채널 번호를 한 번씩",
    ),
    ("indices of channels, counted from 0", "0부터 센 채널 번호"),
    ("below the number of channels", "채널 수보다 작은 수"),
    (
        "0 without band_hz: noise makes changes of sign that are no swings",
        "band_hz가 없으면 0(잡음의 부호 변화는 진동이 아니다)",
    ),
    (
        "from a lower to a higher frequency",
        "낮은 진동수에서 높은 진동수의 순서",
    ),
    (
        "above period_least_s by a tenth of it or more",
        "period_least_s보다 10 % 이상 큰 수",
    ),
    ("another than that of the first anchor", "첫 값과 다른 수"),
    ("at least the kinetic one", "동마찰계수 이상"),
    ("at most 4 000 000", "4 000 000 이하"),
    (
        "at most 4 000 000: give end_s, or longer steps",
        "4 000 000 이하(end_s를 주거나 시간 간격을 키운다)",
    ),
    (
        "one step at least, and at most 4 000 000",
        "한 간격 이상 4 000 000 이하",
    ),
    (
        "at most 100 000 s, which is more than a day",
        "하루가 넘는 100 000 s 이하",
    ),
    (
        "at most that of the modes, 3 a floor",
        "모드의 수(바닥마다 3개) 이하",
    ),
    (
        "at most the distance of its farthest corner from its centre of mass",
        "질량중심에서 가장 먼 모서리까지의 거리 이하",
    ),
    ("one of the sites given", "주어진 위치 중 하나"),
    ("one of the modes of the structure", "구조물의 모드 중 하나"),
    (
        "three or more corners of finite coordinates",
        "좌표가 유한한 모서리 셋 이상",
    ),
    (
        "between 0 and 0.5, and 0 where peaks are made small",
        "0과 0.5 사이의 수(피크를 줄일 때는 0)",
    ),
    (
        "between 1 and the degrees of freedom of the structure",
        "1과 구조물의 자유도 사이의 수",
    ),
    (
        "positive and at most 1.5 over the fastest natural frequency in rad/s",
        "양수이고 1.5/(가장 높은 고유진동수, rad/s) 이하",
    ),
    ("0: give every damper in the list", "0(감쇠기는 모두 목록에 준다)"),
    (
        "0 for response spectra, whose modes are those of the building alone: use a time history",
        "응답스펙트럼에서는 0(모드가 건물만의 것이므로 시간이력을 쓴다)",
    ),
    ("1 or 2: x, y or both", "1 또는 2(x, y 또는 둘 다)"),
    (
        "long enough for ten million samples at most in the run",
        "해석에서 자료가 천만 개를 넘지 않을 만큼 긴 간격",
    ),
    (
        "a positive number: give it where no sampled load does",
        "양수(자료로 준 하중이 없으면 입력한다)",
    ),
    ("a number below fall_rad in size", "크기가 fall_rad보다 작은 수"),
    ("sampled with a positive time step", "양의 시간 간격의 자료"),
    ("of a positive frequency", "양의 진동수"),
    ("of finite amplitude and phase", "유한한 진폭과 위상"),
    (
        "of a size whose motion can be followed: look at its unit",
        "운동을 계산할 수 있는 크기(단위를 확인한다)",
    ),
    (
        "left out: the chain falls by itself and has no first mode; give dashpots instead",
        "빈 값(체인이 스스로 쓰러져 1차 모드가 없으므로 감쇠기를 준다)",
    ),
    (
        "so small that mass_per_s + stiffness_s ω² is not negative in the shape in which the frame falls when every slider slips: lower it, raise mass_per_s, or give dashpots",
        "모든 마찰면이 미끄러질 때 골조가 쓰러지는 모양에서 mass_per_s + stiffness_s ω²가 음이 아닐 만큼 작은 값(낮추거나, mass_per_s를 키우거나, 감쇠기를 준다)",
    ),
    ("a positive number (9.81 on Earth)", "양수(지구에서 9.81)"),
    (
        "a positive number: a joint without tension bears nothing else",
        "양수(인장이 없는 접합면은 다른 힘을 받지 못한다)",
    ),
    ("a positive number, or left out", "양수 또는 빈 값"),
    (
        "above 0 and below 1, where the block would fall",
        "0보다 크고 블록이 쓰러지는 1보다 작은 수",
    ),
    (
        "above 0 (infinite for a deviation that is known)",
        "0보다 큰 수(표준편차를 알면 무한대)",
    ),
    ("a positive intensity", "양의 세기"),
    ("below the end of its interval", "구간의 끝보다 작은 값"),
    ("of one motion or more", "지반운동 하나 이상"),
    (
        "no more than its motions that reached the state",
        "손상상태에 이른 지반운동의 수 이하",
    ),
    ("above the one before it", "앞의 값보다 큰 수"),
    (
        "below the one before it: stronger shaking is rarer",
        "앞의 값보다 작은 수(강한 흔들림일수록 드물다)",
    ),
    ("square and not empty", "비어 있지 않은 정사각 행렬"),
    (
        "square and of the size of the mass matrix",
        "질량행렬과 크기가 같은 정사각 행렬",
    ),
    ("symmetric", "대칭"),
    (
        "positive definite: every motion must meet mass and stiffness",
        "양의 정부호(모든 운동에 질량과 강성이 있어야 한다)",
    ),
    ("square, with one row a load", "하중마다 행이 하나인 정사각 행렬"),
    (
        "Hermitian: S_ij the conjugate of S_ji",
        "에르미트 행렬(S_ij는 S_ji의 켤레)",
    ),
    (
        "positive semidefinite: no combination of the loads may have a negative density (look for a coherence above 1)",
        "양의 준정부호(1을 넘는 결맞음이 있는지 확인한다)",
    ),
    ("as many rows as the first", "첫 행렬과 행의 수가 같은 행렬"),
    ("of the same size as the first", "첫 행렬과 크기가 같은 행렬"),
    (
        "at least as tall as wide and not empty",
        "비어 있지 않고 행이 열 이상인 행렬",
    ),
    ("not empty", "비어 있지 않은 행렬"),
    (
        "all of them: something is damped so much that a spectrum has no oscillator like it; lower its damping, or use a time history",
        "모든 모드(감쇠가 너무 커서 스펙트럼으로 나타낼 수 없는 것이 있다. 감쇠를 낮추거나 시간이력을 쓴다)",
    ),
    (
        "at most a million: two of them have become one; change a damper's frequency or damping a little, or use a time history",
        "백만 이하(두 모드가 하나로 겹쳤다. 감쇠기의 진동수나 감쇠를 조금 바꾸거나 시간이력을 쓴다)",
    ),
    (
        "the line through its two anchors gives that; move the anchors to the lowest and highest frequency that matter",
        "두 기준 진동수를 지나는 곡선의 값이다. 기준을 필요한 최저·최고 진동수로 옮긴다",
    ),
    (
        "Caughey's series runs away beyond the modes it is given for; give ratios of more modes, or modal damping",
        "코기(Caughey) 급수는 주어진 모드 밖에서 발산한다. 더 많은 모드의 감쇠비나 모드 감쇠를 준다",
    ),
    ("it moves only in x here", "이 자리에서는 x 방향으로만 움직인다"),
    ("it moves only in y here", "이 자리에서는 y 방향으로만 움직인다"),
    ("its centre lies here", "모드의 중심이 이 자리에 있다"),
    (
        "its acceleration has a density that does not vanish at frequency 0, and displacement divides it by ω⁴: use Clough & Penzien's, which filters slow motion out",
        "가속도의 밀도가 진동수 0에서 0이 아닌데 변위는 ω⁴으로 나눈다. 느린 운동을 거르는 Clough & Penzien 스펙트럼을 쓴다",
    ),
    (
        "such a force has no end of power at high frequencies: give it a corner (low pass)",
        "그런 힘은 높은 진동수에서 에너지가 끝없이 커진다. 저역 필터의 모서리 진동수를 준다",
    ),
    ("the displacement of the ground", "지반 변위"),
    (
        "the acceleration under a white-noise force",
        "백색잡음 힘에 대한 가속도",
    ),
    ("the dampers' tuning and place", "감쇠기의 동조와 위치"),
    ("the dampers' tunings together", "감쇠기들의 동조"),
    ("the damper's place", "감쇠기의 위치"),
    ("a resonance without damping", "감쇠가 없는 공진"),
    ("the damping that stands for head loss", "수두손실의 감쇠"),
    ("side support", "옆 지지"),
    ("pole", "기둥"),
    ("shaft", "돌기둥"),
    ("shafts", "돌기둥"),
    ("frame", "골조"),
    ("chain", "체인"),
    ("storey", "층"),
    ("joints", "접합면"),
    ("joint", "접합면"),
    ("links", "부재"),
    ("link", "부재"),
    ("levels", "레벨"),
    ("level", "레벨"),
    ("floor", "바닥"),
    ("floors", "바닥"),
    ("modes", "모드"),
    ("tie", "타이"),
    ("point", "점"),
    ("element", "부재"),
    ("high-pass", "고역통과"),
    ("low-pass", "저역통과"),
    ("band-pass", "대역통과"),
    ("anti-alias", "에일리어싱 방지"),
    ("spectral", "스펙트럼"),
    ("stiffness", "강성"),
    ("mass", "질량"),
    ("damping", "감쇠"),
    ("weight", "weight(무게)"),
    ("twists", "비틀린다"),
    ("sways", "옆으로 쓰러진다"),
    ("intensity", "세기"),
    ("an intensity", "세기"),
    ("return period", "재현주기"),
    ("a rate", "초과율"),
    ("standard deviation", "표준편차"),
    ("frequency", "진동수"),
    ("the number of points", "점의 수"),
    ("the coefficient of temperature", "온도계수"),
    (
        "the deviation of the coefficient of temperature",
        "온도계수의 표준편차",
    ),
    ("significance", "유의수준"),
    ("power", "검정력"),
    ("probability", "확률"),
    ("number of positive weights", "양의 가중치의 수"),
    ("number of weights", "가중치의 수"),
    (
        "the number of tuned masses of the building itself",
        "건물 자체의 동조질량의 수",
    ),
    ("the number of tuned masses", "동조질량의 수"),
    (
        "the number of modes that swing with the dampers",
        "감쇠기와 함께 움직이는 모드의 수",
    ),
    (
        "the factor by which complex modes cancel",
        "복소 모드가 상쇄되는 배수",
    ),
    ("the number of damping ratios", "감쇠비의 수"),
    ("horizontal components of the motion", "지반운동의 수평 성분 수"),
    (
        "steps of the motion with 10 periods after it",
        "지반운동과 그 뒤 10주기의 간격 수",
    ),
    ("acceleration of the ground over gravity", "지반가속도(g)"),
    ("spectral acceleration", "스펙트럼 가속도"),
    ("height_m of the side support", "옆 지지의 height_m"),
    (
        "height_m of a load above its link's joint",
        "부재의 접합면에서 잰 하중의 height_m",
    ),
    ("depth_m of the foot", "밑동의 depth_m"),
    ("breadth_m of the foot", "밑동의 breadth_m"),
    ("depth_m of the top", "꼭대기의 depth_m"),
    ("breadth_m of the top", "꼭대기의 breadth_m"),
    ("position_m of a force", "힘의 position_m"),
    ("pressure_pa of the wind", "바람의 pressure_pa"),
    ("direction of the wind", "바람의 방향"),
    ("direction of shaking", "흔들림의 방향"),
    ("a point of a cutting plane", "자르는 평면의 점"),
    ("the normal of a cutting plane", "자르는 평면의 법선"),
    ("share of a bed", "접합면의 잃은 비율"),
    ("the side of a bed", "접합면의 방향"),
    ("size_m", "크기(size_m)"),
    ("days", "날짜"),
    ("finite, 0 or more", "0 이상인 유한한 수"),
    ("after the day before it", "앞 날짜보다 뒤"),
    ("a point of a convex hull", "볼록 껍질의 점"),
    ("a vertex of a mesh", "메시의 꼭짓점"),
    ("displacement of a shape point", "모드형상 점의 변위"),
    ("displacement_sd of a shape point", "모드형상 점 변위의 표준편차"),
    ("largest displacement of the shape", "모드형상의 최대 변위"),
    ("mean of a lognormal variable", "로그정규 변수의 평균"),
    ("cov of a lognormal variable", "로그정규 변수의 변동계수"),
    ("degrees of freedom", "자유도"),
    ("taper, in degrees,", "도 단위 체감각"),
    ("taper_rad", "체감각(rad)"),
    ("storeys", "층수"),
    ("body_height_m", "탑신 높이(m)"),
    ("slenderness_angle", "세장각"),
    ("body_slenderness", "몸돌 세장비"),
    ("body_base_height_ratio", "탑신/기단 높이비"),
    (
        "acceleration_m_s2 of the spectrum",
        "스펙트럼의 acceleration_m_s2",
    ),
    ("the ground", "지면"),
];

#[cfg(test)]
#[allow(
    clippy::disallowed_methods,
    reason = "the test reads the source of the science"
)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::{Path, PathBuf};

    fn rust_files(folder: &Path) -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let files = entries.flat_map(|path| match path.is_dir() {
            true => rust_files(&path),
            false => vec![path],
        });
        files
            .filter(|path| path.extension().is_some_and(|end| end == "rs"))
            .collect()
    }

    #[test]
    fn holds_what_errors_of_the_science_allow_is_korean_too() {
        let science = Path::new(env!("CARGO_MANIFEST_DIR")).join("../dolmen/src");
        let mut found = 0;
        for file in rust_files(&science) {
            let text = fs::read_to_string(&file).unwrap();
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            // literals that continue on the next line
            let code: String = code.split("\\\n").map(str::trim_start).collect();
            for rest in code.split(" allowed: \"").skip(1) {
                let english = rest.split('"').next().unwrap_or_default();
                let mut known = PHRASES.iter().chain(PHRASES_OF_STACKS);
                let is_known = known.any(|(known, _)| *known == english);
                assert!(is_known, "{}: \"{english}\" has no Korean", file.display());
                found += 1;
            }
        }
        assert!(found > 50, "{found}");
    }
}
