//! The method of a study, in words for every result.

use super::answer::StudyAnswer;
use super::kind::StudyKind;
use super::measures::RunMeasures;
use dolmen::assess::DamageThresholds;
use dolmen::blocks::Springs;
use dolmen_project::LawPart;
use dolmen_words::number::trimmed;
use dolmen_words::{Language, Sentence, messages};

/// Default time after the motion for a frame or a chain, s, in a study and a single simulation alike: with a damping ratio of 2 % a motion of 1
/// Hz decays to a tenth. Our choice.
pub const SWING_REST_S: f64 = 20.0;

/// A direction as written: degrees to nine decimals, which radians do not keep to the last digit.
pub(super) fn direction_deg(turn_rad: f64) -> f64 {
    (turn_rad.to_degrees() * 1e9).round() / 1e9
}

impl StudyAnswer {
    /// For a building with rooms of dampers: number of runs with a stroke beyond its room, number of all runs, and the smallest ground peak
    /// of the former, m/s²; `None` without such a run. The runs have no stops.
    pub fn beyond_room(&self) -> Option<(usize, usize, f64)> {
        let known = self.runs.iter().filter_map(|run| match run.measures {
            RunMeasures::Building(of) if !of.stroke_over_room.is_nan() => {
                Some((of.stroke_over_room, run.peak_ground_acceleration_m_s2))
            }
            _ => None,
        });
        let known: Vec<(f64, f64)> = known.collect();
        let beyond: Vec<f64> = known
            .iter()
            .filter(|(share, _)| *share > 1.0)
            .map(|(_, peak)| *peak)
            .collect();
        (!beyond.is_empty()).then(|| {
            let least = beyond.iter().copied().fold(f64::INFINITY, f64::min);
            (beyond.len(), known.len(), least)
        })
    }

    /// Time after the motion, s.
    pub fn rest_s(&self) -> f64 {
        let usual = match self.kind {
            StudyKind::Stack => Springs::default().rest_s,
            StudyKind::Frame | StudyKind::Chain | StudyKind::Building => SWING_REST_S,
        };
        self.study.rest_s.unwrap_or(usual)
    }

    /// "after NAME", for a study after an earlier motion.
    pub fn after_words(&self, language: Language) -> Option<String> {
        let motion = &self.study.after.as_ref()?.motion;
        let motion = motion.clone();
        Some(Sentence::from(Method::After(motion)).text(language))
    }

    /// The contact law of a stack; `None` for other structures.
    pub fn law(&self) -> Option<&'static str> {
        (self.kind == StudyKind::Stack).then_some(match self.study.law {
            LawPart::Springs => "springs",
            LawPart::Rigid => "rigid",
        })
    }

    /// Law, points, rest, refinement, seeds and version.
    pub fn method(&self, language: Language) -> String {
        let said = self.sentences().into_iter();
        let mut words: Vec<String> = said.map(|one| Sentence::from(one).text(language)).collect();
        words.push(format!("Dolmen {}", self.version));
        words.join(", ")
    }

    fn sentences(&self) -> Vec<Method> {
        let study = &self.study;
        let mut said = Vec::new();
        if self.kind == StudyKind::Stack {
            said.push(match study.law {
                LawPart::Springs => Method::SpringsLaw,
                LawPart::Rigid => Method::RigidLaw,
            });
            let points = study.points;
            said.push(Method::Points(points));
            if points == 4 && study.law == LawPart::Springs {
                said.push(Method::TooStiff);
            }
        }
        if self.kind == StudyKind::Building {
            let limits = study.drift_limits.map(|limit| trimmed(100.0 * limit, 4));
            said.push(Method::DriftLimits(limits.join(", ")));
        }
        said.extend(
            study
                .after
                .as_ref()
                .map(|after| Method::After(after.motion.clone())),
        );
        if study.damage != DamageThresholds::default() {
            said.push(Method::OwnDamageStates);
        }
        if study.scan.is_some() {
            let rest = trimmed(self.rest_s(), 3);
            said.push(match (self.kind, study.rest_s) {
                (StudyKind::Building, None) => Method::RestAndPeriods(rest),
                _ => Method::Rest(rest),
            });
            said.push(match study.refine {
                0 => Method::FallToStep,
                halvings => Method::FallToPart(part_of_step(halvings)),
            });
        }
        if study.samples.is_some() {
            let seed = study.seed;
            said.push(Method::SamplesFrom(seed));
        }
        if let Some(made) = &study.artificial {
            let seed = made.seed;
            said.push(Method::NoiseFrom(seed));
        }
        said
    }
}

messages! {
    /// How a study was run.
    pub enum Method in "study.method" {
        SpringsLaw => { en: "springs law", ko: "스프링 접촉 모델" },
        RigidLaw => { en: "rigid law", ko: "강체 접촉 모델" },
        Points(points: u32) => { en: "{points} contact points a joint", ko: "접합면당 접촉점 {points}개" },
        TooStiff => {
            en: "which make joints three times as stiff in rocking as faces are: capacities come out too large",
            ko: "접합면의 회전강성이 약 3배로 커져 내력이 크게 산정됨",
        },
        DriftLimits(limits: String) => {
            en: "drift limits {limits} % of the storey's height",
            ko: "층간변위 한계 층고의 {limits} %",
        },
        After(motion: String) => { en: "after {motion}", ko: "{motion} 이후" },
        OwnDamageStates => { en: "damage states of its own", ko: "손상상태 기준 별도 지정" },
        RestAndPeriods(rest: String) => {
            en: "{rest} s and at least ten periods after the motion",
            ko: "지반운동 종료 후 {rest}초, 최소 10주기",
        },
        Rest(rest: String) => { en: "{rest} s after the motion", ko: "지반운동 종료 후 {rest}초" },
        FallToStep => { en: "first fall to the whole of a step", ko: "최초 붕괴는 한 단계까지" },
        FallToPart(part: String) => { en: "first fall to {part} of a step", ko: "최초 붕괴는 단계의 {part}까지" },
        SamplesFrom(seed: u64) => { en: "samples from seed {seed}", ko: "표본 난수 초깃값 {seed}" },
        NoiseFrom(seed: u64) => { en: "noise from seed {seed}", ko: "인공 지반운동 난수 초깃값 {seed}" },
    }
}

/// The fraction of a step of the scan after this many halvings.
pub fn part_of_step(halvings: u32) -> String {
    match halvings {
        0 => "the whole".to_owned(),
        n => format!("1/{}", 1_u64 << n.min(63)),
    }
}

/// An input in words, with its path; in English, and for inputs without words, the path alone.
pub fn input_words(path: &str, language: Language) -> String {
    const WORDS: [(&str, &str); 16] = [
        ("joint.friction", "접합면 마찰계수"),
        ("joint.normal_stiffness", "접합면 수직강성"),
        ("joint.shear_stiffness", "접합면 전단강성"),
        ("joint.damping_ratio", "접합면 감쇠비"),
        ("joint.restitution", "접합면 수직 반발계수"),
        ("joint.normal_restitution", "접합면 수직 반발계수"),
        ("joint.rocking_restitution", "접합면 로킹 반발계수"),
        ("density", "밀도"),
        ("pagoda.storeys", "탑 층수"),
        ("pagoda.body_height", "탑신 높이"),
        ("height", "높이"),
        ("width", "폭"),
        ("depth", "깊이"),
        ("diameter", "지름"),
        ("weight", "무게"),
        ("tilt", "기울기"),
    ];
    let words_of = |name: &str| {
        WORDS
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, words)| *words)
    };
    if language == Language::English {
        return path.to_owned();
    }
    let of_stone = || {
        let (number, rest) = path.strip_prefix("blocks[")?.split_once("].")?;
        Some(format!("부재 {number} {}", words_of(rest)?))
    };
    match words_of(path).map(str::to_owned).or_else(of_stone) {
        Some(words) => format!("{words}, {path}"),
        None => path.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_inputs_have_words_beside_their_path() {
        let korean = |path| input_words(path, Language::Korean);
        assert_eq!(korean("joint.friction"), "접합면 마찰계수, joint.friction");
        assert_eq!(korean("blocks[2].height"), "부재 2 높이, blocks[2].height");
        assert_eq!(korean("links[1].sway"), "links[1].sway");
        assert_eq!(input_words("density", Language::English), "density");
    }
}
