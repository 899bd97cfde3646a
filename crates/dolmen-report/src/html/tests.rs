//! Whole pages: escaping, language, self-containment, and that their statements follow from the values.

use super::{Imprint, html};
use dolmen::assess::{check_chain, check_frame};
use dolmen::modal::{Identify, LateClock, Note, ReferenceCase, identify};
use dolmen::signal::ChannelFault;
use dolmen::structure::{Choice, Convention, StiffnessSolution, StiffnessSolutions};
use dolmen_project::{Project, Quantity, Structure, parse_project};
use dolmen_words::Language;
use dolmen_words::number::with_sd;
use dolmen_work::answer::{Answer, CheckAnswer, IdentifyAnswer, ProjectReport};
use dolmen_work::record_seen::RecordSeen;
use dolmen_work::state::{Check, DirectionCheck, State};
use dolmen_work::surveyed::{RecordAnswer, StiffnessAnswer, SurveyAnswer};
use std::sync::Arc;

const POLE: &str = r#"
schema = 1
kind = "chain"
name = { en = "Pole <script> & 'co'", ko = "석당간 \"한글\"" }
units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
cap = "left out"
links = [
  { weight = 38.95, length = 3.68, centroid = 1.64 },
  { weight = 15.13, length = 2.61, centroid = 1.18 },
  { weight = 6.78, length = 1.63, centroid = 0.78 },
  { weight = 4.51, length = 1.54, centroid = 0.69 },
  { weight = 2.93, length = 1.37, centroid = 0.66 },
]
"#;

const GATE: &str = r#"
schema = 1
kind = "frame"
name = { en = "Gate", ko = "문루" }
units = { length = "m", force = "kN", mass = "t", stiffness = "kN/mm" }
axial = "storey"
storeys = [
  { mass = 290, height = 5.84, axial_force = 5919 },
  { mass = 314, height = 7.69, axial_force = 3077 },
]
"#;

pub(crate) fn pole(joints: &str) -> ProjectReport {
    let text = POLE.replace("links = [", &format!("joints = {joints}\nlinks = ["));
    let project = parse_project(&text, "dolmen.toml").unwrap();
    let Structure::Chain(part) = &project.structure else {
        panic!("not a chain");
    };
    let k = part.stiffness_n_m_rad(&mut Quantity::nominal);
    let check = check_chain(&part.build(&mut Quantity::nominal).unwrap(), k.as_deref()).unwrap();
    answer(project, Check::Chain(Box::new(check)))
}

/// Two solutions of the gate's inverse problem, without a choice.
pub(crate) fn gate() -> ProjectReport {
    let project = parse_project(GATE, "dolmen.toml").unwrap();
    let Structure::Frame(part) = &project.structure else {
        panic!("not a frame");
    };
    let frame = part.build(&mut Quantity::nominal).unwrap();
    let solution = |k: [f64; 2]| StiffnessSolution {
        stiffness: k.to_vec(),
        stiffness_sd: None,
        stiffness_range: None,
        stiffness_bounds: None,
        modes: frame.natural_modes(&k).unwrap(),
        misfit: 0.0,
        stands: true,
    };
    let stiffness = StiffnessAnswer {
        direction: "weak".into(),
        convention: Some(Convention::Drift),
        frequencies_hz: vec![1.1, 4.2],
        with_shapes: false,
        solutions: StiffnessSolutions {
            solutions: vec![solution([32.65e6, 96.14e6]), solution([185.18e6, 16.85e6])],
            choice: Choice::Indistinguishable,
            visibility: None,
            starts: 1,
            notes: vec![],
        },
        load_factors: vec![Some(32.2), Some(182.7)],
        peaks_below_hz: Vec::new(),
        doubted: None,
        other_choices: Vec::new(),
        beside_file: None,
    };
    let checks = part.directions.iter().map(|d| DirectionCheck {
        lean: None,
        direction: d.name.clone(),
        check: check_frame(&frame, None).unwrap(),
        slipping: None,
        columns: Vec::new(),
        tenons: None,
    });
    let check = Check::Frame(checks.collect());
    let survey = SurveyAnswer {
        shape_doubt: None,
        columns: Vec::new(),
        exchanged_directions: None,
        plan: None,
        factors: None,
        model: None,
        without_stiffness: None,
        setups: None,
        records: None,
        name: "2009".into(),
        stiffness: vec![stiffness],
    };
    report(project, Some(check), vec![survey])
}

fn answer(project: Project, check: Check) -> ProjectReport {
    report(project, Some(check), Vec::new())
}

fn report(project: Project, check: Option<Check>, surveys: Vec<SurveyAnswer>) -> ProjectReport {
    let state = check.map(|check| State {
        check,
        loads: None,
        tilts: vec![],
        contradictions: vec![],
        spring_fits: vec![],
        demand: None,
        sampled: None,
    });
    let (file, project) = ("dolmen.toml".to_owned(), Arc::new(project));
    let checked = CheckAnswer {
        file: file.clone(),
        project: project.clone(),
        state,
        variants: vec![],
        sensitivities: vec![],
        sensitivity_of: Default::default(),
        unreadable_motions: vec![],
    };
    let identified = IdentifyAnswer {
        file: file.clone(),
        project: project.clone(),
        surveys,
    };
    ProjectReport {
        file,
        project,
        answers: vec![
            Answer::Check(Box::new(checked)),
            Answer::Identify(Box::new(identified)),
        ],
        left_out: Vec::new(),
        photos: Default::default(),
        fingerprint: String::new(),
        files: Vec::new(),
    }
}

fn page(answers: &[ProjectReport], language: Language) -> String {
    let imprint = Imprint {
        program: "dolmen 0.1.0".into(),
        date: None,
    };
    html(answers, &[], language, &imprint)
}

/// k in kN·m/rad of five equal joints.
fn equal(k: f64) -> String {
    let joints: Vec<String> = (0..5).map(|_| format!("{{ stiffness = {k} }}")).collect();
    format!("[{}]", joints.join(", "))
}

/// Every visible number of a page, sorted.
fn numbers(page: &str) -> Vec<String> {
    let body = page.split_once("<body>").map_or(page, |(_, body)| body);
    let mut text = String::new();
    let mut tag = false;
    for c in body.chars() {
        match c {
            '<' => tag = true,
            '>' => {
                tag = false;
                text.push(' ');
            }
            _ if !tag => text.push(c),
            _ => {}
        }
    }
    // "&#39;" is an apostrophe
    let text = text.replace("&#39;", "'");
    let mut all: Vec<String> = text
        .split(|c: char| !c.is_ascii_digit() && c != '.' && c != '\u{202f}')
        .map(|n| n.trim_matches(|c| c == '.' || c == '\u{202f}').to_string())
        // "zero" is a word in English, a numeral in Korean
        .filter(|n| n.starts_with(|c: char| c.is_ascii_digit()) && n != "0")
        .collect();
    all.sort();
    all
}

/// Checks that tags are nested and attributes quoted.
fn assert_nests(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    for piece in svg.split('<').skip(1) {
        let (tag, _) = piece.split_once('>').expect("a tag ends");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "{svg}");
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
    }
    assert!(open.is_empty(), "{open:?}");
}

fn figures(page: &str) -> Vec<&str> {
    page.split("<svg")
        .skip(1)
        .map(|rest| rest.split("</svg>").next().unwrap())
        .collect()
}

#[test]
fn holds_names_are_escaped_and_hangul_survives() {
    let page = page(&[pole("\"unknown\"")], Language::English);
    assert!(page.contains("Pole &lt;script&gt; &amp; "), "{}", &page[..3000]);
    assert!(!page.contains("<script"));
    assert!(page.contains("석당간") && page.contains("한글"));
}

#[test]
fn holds_a_page_needs_nothing_from_outside() {
    for language in [Language::English, Language::Korean] {
        let page = page(&[pole(&equal(400.0)), gate()], language);
        let links = page.replace("http://www.w3.org/2000/svg", "");
        for outside in ["http:", "https:", "src=", "url(", "@import", "<link"] {
            assert!(!links.contains(outside), "{outside}");
        }
        assert!(page.len() < 1_000_000, "{} bytes", page.len());
    }
}

#[test]
fn holds_every_figure_nests_and_names_its_units() {
    for (language, height, stiffness) in [
        (Language::English, "Height (m)", "Rotational stiffness (kN·m/rad)"),
        (Language::Korean, "높이 (m)", "회전강성 (kN·m/rad)"),
    ] {
        let page = page(&[pole(&equal(400.0)), gate()], language);
        let all = figures(&page);
        assert!(all.len() >= 6, "{} figures", all.len());
        for svg in &all {
            assert_nests(&format!("<svg{svg}</svg>"));
        }
        for name in [height, stiffness, "Hz"] {
            assert!(all.iter().any(|svg| svg.contains(name)), "{name}");
        }
    }
}

#[test]
fn published_sentence_stands_beside_the_factor_of_the_values() {
    let page = page(&[pole("\"unknown\"")], Language::English);
    // 4.735605 by the theory of the chain, three digits here.
    assert!(
        page.contains(
            "indefinite, so a pole with those stiffnesses falls; the joints need 4.74 times as much"
        )
    );
    for exact in ["4.736", "2.477", "1.027", "292.0", "128.64", "253.83", "739.69"] {
        assert!(page.contains(exact), "{exact}");
    }
}

#[test]
fn holds_verdict_words_follow_the_load_factor() {
    // Equal joints of 291.9841 kN·m/rad are just stable
    for (k, class, english, korean) in [
        (280.0, "verdict unstable", "unstable", "불안정"),
        (400.0, "verdict marginal", "marginal", "여유 부족"),
        // stable, but amber: the cap stone is not in the model
        (500.0, "verdict marginal", "stable", "안정"),
    ] {
        let answer = pole(&equal(k));
        for (language, word) in [(Language::English, english), (Language::Korean, korean)] {
            let page = page(std::slice::from_ref(&answer), language);
            let banner = page.split(class).nth(1).unwrap_or_else(|| panic!("{k}: {class}"));
            let said = banner.split("</div>").next().unwrap_or_default();
            let said = said.split(" · ").next().unwrap_or_default();
            assert!(said.ends_with(&format!(" {word}")), "{k}: {said}");
        }
    }
    let unknown = page(&[pole("\"unknown\"")], Language::English);
    assert!(
        unknown.contains("Whether it stands is unknown")
            && unknown.contains("verdict marginal\"><div class=\"word\">? Own weight: unknown")
    );
    assert!(!unknown.contains("λ ="), "no load factor was computed");
}

#[test]
fn holds_both_languages_have_the_same_numbers() {
    for answers in [
        vec![pole("\"unknown\"")],
        vec![pole(&equal(280.0))],
        vec![pole(&equal(400.0))],
        vec![gate()],
    ] {
        assert_eq!(
            numbers(&page(&answers, Language::English)),
            numbers(&page(&answers, Language::Korean))
        );
    }
}

#[test]
fn holds_roots_that_cannot_be_told_apart_are_all_shown_and_none_is_chosen() {
    let page = page(&[gate()], Language::English);
    assert!(page.contains("2 different solutions") && page.contains("none is preferred"));
    for number in ["32.65", "96.14", "185.2", "16.85"] {
        assert!(page.contains(number), "{number}");
    }
}

#[test]
fn holds_the_same_answer_gives_the_same_page() {
    let answers = [pole(&equal(400.0)), gate()];
    assert_eq!(page(&answers, Language::Korean), page(&answers, Language::Korean));
}

/// A simulated record of two floors, 1.1 and 4.2 Hz, as a survey without a model.
pub(crate) fn survey() -> ProjectReport {
    let record = ReferenceCase::ShearChain.made(11).unwrap().make().unwrap();
    let analysis = identify(&record, &Identify::default()).unwrap();
    let seen = RecordSeen::of(&record, record.duration_s(), (&analysis, None), true).unwrap();
    let text = "schema = 1\nkind = \"survey\"\nname = { en = \"Tower\", ko = \"탑\" }\n\
                [survey.now.records]\nfile = \"r.csv\"\nsampling_rate = \"100 Hz\"\n";
    let survey = SurveyAnswer {
        shape_doubt: None,
        columns: Vec::new(),
        exchanged_directions: None,
        plan: None,
        factors: None,
        without_stiffness: None,
        model: None,
        name: "now".into(),
        setups: None,
        records: Some(RecordAnswer {
            earthquake: None,
            file: "r.csv".into(),
            channels: 2,
            samples: record.length(),
            sampling_rate_hz: record.sampling_rate_hz(),
            unit: String::new(),
            remarks: vec![],
            unread_stamps: vec![],
            clock_doubts: vec![],
            faults: vec![],
            doubts: vec![],
            analysis,
            seen,
        }),
        stiffness: vec![],
    };
    let project = parse_project(text, "project.toml").unwrap();
    report(project, None, vec![survey])
}

#[test]
fn holds_modes_of_a_record_stand_with_their_deviations_and_nothing_is_said_of_stability() {
    let answer = survey();
    let modes = &answer.surveys()[0].records.as_ref().unwrap().analysis.modes.modes;
    assert_eq!(modes.len(), 2);
    let english = page(std::slice::from_ref(&answer), Language::English);
    for mode in modes {
        let text = with_sd(mode.frequency_hz, mode.frequency_sd_hz.unwrap());
        assert!(
            english.matches(&text).count() >= 2,
            "{text} in the findings and in the table"
        );
    }
    assert!(!english.contains("class=\"verdict") && !english.contains("λ ="));
    for svg in figures(&english) {
        assert_nests(&format!("<svg{svg}</svg>"));
    }
    for name in ["Frequency (Hz)", "Singular value (dB)", "Model order (–)"] {
        assert!(english.contains(name), "{name}");
    }
    assert_eq!(numbers(&english), numbers(&page(&[answer], Language::Korean)));
}

#[test]
fn holds_one_fault_is_one_and_notes_of_a_record_are_in_the_language_of_the_page() {
    let mut answer = survey();
    let Some(Answer::Identify(identified)) = answer.answers.get_mut(1) else {
        panic!("the surveys stand second")
    };
    let record = identified.surveys[0].records.as_mut().unwrap();
    record.faults = vec![ChannelFault::Drifts {
        channel: "made 1".into(),
        rise: 12.0,
    }];
    record.analysis.notes = vec![Note::LateClocks {
        late: vec![LateClock {
            channel: "made 2".into(),
            delay_s: 0.12,
            sd_s: 0.001,
            or_s: None,
            modes: 2,
        }],
    }];
    let english = page(std::slice::from_ref(&answer), Language::English);
    assert!(
        english.contains("made 1") && english.contains("drifts by"),
        "{english}"
    );
    assert!(
        english.contains("2 channels of")
            && english.contains("late by 0.1200 ± 0.0010\u{202f}s (modes that tell it: 2)")
    );
    let korean = page(&[answer], Language::Korean);
    assert!(korean.contains("0.1200 ± 0.0010") && korean.contains("begins에 늦은 만큼 더하거나"));
    assert!(!korean.contains("[영문]"));
}

#[test]
fn holds_a_page_may_load_nothing_and_needs_nothing() {
    for language in [Language::English, Language::Korean] {
        let page = page(&[pole("\"unknown\""), gate()], language);
        let policy = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">";
        assert_eq!(page.matches(policy).count(), 1);
        for needs in [
            "<script",
            " onclick=",
            "src=\"",
            "url(http",
            "@import",
            "<iframe",
            "<form",
        ] {
            assert!(!page.contains(needs), "{needs}");
        }
    }
}
