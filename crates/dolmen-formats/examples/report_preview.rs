//! Writes the reports of hand-made projects, to look at.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a throw-away example")]

use dolmen::assess::{check_chain, check_frame};
use dolmen::structure::*;
use dolmen_formats::Language;
use dolmen_formats::answer::*;
use dolmen_formats::project::*;
use dolmen_formats::report::*;
use std::collections::BTreeMap;

fn q(path: String, value: f64, unit: &'static str, written: String, source: Option<Evidence>) -> Quantity {
    Quantity {
        value,
        unit,
        cov: (source == Some(Evidence::Assumed)).then_some(0.3),
        cov_source: None,
        source,
        note: None,
        path,
        written,
    }
}

fn naju(k: Option<[f64; 5]>) -> Project {
    let w = [38.95, 15.13, 6.78, 4.51, 2.93];
    let len = [3.68, 2.61, 1.63, 1.54, 1.37];
    let c = [1.64, 1.18, 0.78, 0.69, 0.66];
    let lit = Some(Evidence::Literature);
    let links = (0..5)
        .map(|i| LinkPart {
            name: Some(
                [
                    "1단 간주석",
                    "2단 간주석",
                    "3단 간주석",
                    "4단 간주석",
                    "5단 간주석",
                ][i]
                    .into(),
            ),
            heaviness: Heaviness::Weight(q(
                format!("links[{}].weight", i + 1),
                w[i] * 1e3,
                "N",
                format!("{} kN", w[i]),
                lit,
            )),
            length: q(
                format!("links[{}].length", i + 1),
                len[i],
                "m",
                format!("{} m", len[i]),
                lit,
            ),
            centroid: q(
                format!("links[{}].centroid", i + 1),
                c[i],
                "m",
                format!("{} m", c[i]),
                lit,
            ),
            inertia: None,
            breadth: None,
            bed_width: None,
        })
        .collect();
    let joints = k.map(|k| {
        (0..5)
            .map(|i| JointPart {
                stiffness: q(
                    format!("joints[{}].stiffness", i + 1),
                    k[i] * 1e3,
                    "N m/rad",
                    format!("{} kN*m/rad", k[i]),
                    Some(Evidence::Assumed),
                ),
                damping: None,
            })
            .collect()
    });
    Project {
        schema: 1,
        name: Names {
            en: Some("Naju stone flagpole <Treasure 49>".into()),
            ko: Some("나주 석당간 (보물 제49호)".into()),
        },
        description: Some("Five stones held by iron rings, between two posts; restored in the 2000s.".into()),
        source: Some("Choi (2021), Table 1".into()),
        gravity_m_s2: 9.81,
        structure: Structure::Chain(ChainPart {
            links,
            joints,
            cap: Cap::LeftOut,
            gravity_m_s2: 9.81,
        }),
        surveys: vec![Survey {
            name: "2010-05-12".into(),
            note: Some("after restoration".into()),
            source: Some("KISS (2011)".into()),
            temperature_c: None,
            datum: None,
            tilt: BTreeMap::from([
                (
                    "x".into(),
                    Tilt {
                        ratio: 1.0 / 177.0,
                        written: "1/177".into(),
                    },
                ),
                (
                    "y".into(),
                    Tilt {
                        ratio: 1.0 / 540.0,
                        written: "1/540".into(),
                    },
                ),
            ]),
            modes: BTreeMap::new(),
            records: None,
        }],
        variants: vec![],
        warnings: vec![Warning {
            kind: WarningKind::CapLeftOut,
            line: 12,
            path: "cap".into(),
            message: "the cap stone is left out: unconservative".into(),
        }],
    }
}

fn state(project: &Project) -> State {
    let check = match &project.structure {
        Structure::Chain(part) => {
            let chain = part.build(&mut Quantity::nominal).unwrap();
            let k = part.stiffness_n_m_rad(&mut Quantity::nominal);
            Check::Chain(Box::new(check_chain(&chain, k.as_deref()).unwrap()))
        }
        Structure::Frame(part) => Check::Frame(
            part.directions
                .iter()
                .map(|d| {
                    let frame = part.build(&mut Quantity::nominal).unwrap();
                    let k = part.stiffness_n_m(&d.name, &mut Quantity::nominal);
                    DirectionCheck {
                        direction: d.name.clone(),
                        check: check_frame(&frame, k.as_deref()).unwrap(),
                    }
                })
                .collect(),
        ),
        Structure::Survey => unreachable!(),
    };
    State { check, sampled: None }
}

fn gate() -> Project {
    let lit = Some(Evidence::Literature);
    let storey = |i: usize, m: f64, h: f64, n: f64| StoreyPart {
        name: None,
        heaviness: Heaviness::Mass(q(
            format!("storeys[{i}].mass"),
            m * 1e3,
            "kg",
            format!("{m} t"),
            lit,
        )),
        height: q(format!("storeys[{i}].height"), h, "m", format!("{h} m"), lit),
        axial_force: Some(q(
            format!("storeys[{i}].axial_force"),
            n * 1e3,
            "N",
            format!("{n} kN"),
            lit,
        )),
    };
    Project {
        schema: 1,
        name: Names {
            en: Some("Heunginjimun gate".into()),
            ko: Some("흥인지문".into()),
        },
        description: None,
        source: Some("Park & Min (2010)".into()),
        gravity_m_s2: 9.81,
        structure: Structure::Frame(FramePart {
            storeys: vec![storey(1, 290.0, 5.84, 5919.0), storey(2, 314.0, 7.69, 3077.0)],
            axial: Axial::Storey,
            convention: Convention::Drift,
            directions: vec![
                DirectionPart {
                    name: "weak".into(),
                    stiffness: Some(vec![
                        q(
                            "stiffness.weak[1]".into(),
                            32.65e6,
                            "N/m",
                            "32.65 kN/mm".into(),
                            Some(Evidence::Assumed),
                        ),
                        q(
                            "stiffness.weak[2]".into(),
                            96.14e6,
                            "N/m",
                            "96.14 kN/mm".into(),
                            Some(Evidence::Assumed),
                        ),
                    ]),
                },
                DirectionPart {
                    name: "strong".into(),
                    stiffness: None,
                },
            ],
            gravity_m_s2: 9.81,
        }),
        surveys: vec![],
        variants: vec![],
        warnings: vec![],
    }
}

fn roots() -> Vec<SurveyAnswer> {
    let frame = match &gate().structure {
        Structure::Frame(p) => p.build(&mut Quantity::nominal).unwrap(),
        _ => unreachable!(),
    };
    let solution = |k: [f64; 2]| StiffnessSolution {
        stiffness: k.to_vec(),
        stiffness_sd: Some(vec![0.03 * k[0], 0.05 * k[1]]),
        modes: frame.natural_modes(&k).unwrap(),
        misfit: 1e-9,
        stiffness_range: None,
        stands: true,
    };
    vec![SurveyAnswer {
        records: None,
        name: "2009".into(),
        stiffness: vec![StiffnessAnswer {
            direction: "weak".into(),
            convention: Some(Convention::Drift),
            frequencies_hz: vec![1.1, 4.2],
            with_shapes: false,
            solutions: StiffnessSolutions {
                solutions: vec![solution([32.65e6, 96.14e6]), solution([185.18e6, 16.85e6])],
                choice: Choice::Indistinguishable,
                visibility: Some(Visibility {
                    singular_values: vec![1.0, 0.3],
                    seen: vec![1.0, 1.0],
                    free_directions: 0,
                }),
                starts: 1,
                notes: vec![],
            },
        }],
    }]
}

fn main() {
    let out = std::env::args().nth(1).unwrap();
    let k = [761.9, 216.1, 66.5, 22.3, 4.13];
    let mut project = naju(Some(k));
    let repaired = naju(Some(k.map(|k| 2.0 * k)));
    let title = Some(Names {
        en: Some("rings renewed".into()),
        ko: Some("띠쇠 교체".into()),
    });
    let after = VariantAnswer {
        name: "repaired".into(),
        title: title.clone(),
        state: state(&repaired),
    };
    project.variants = vec![Variant {
        name: "repaired".into(),
        title,
        project: repaired,
    }];
    let load_factors: Vec<f64> = (0..2000)
        .map(|i| {
            let u = (i as f64 + 0.5) / 2000.0;
            1.0034 * (0.25 * (u / (1.0 - u)).ln() / 1.7).exp()
        })
        .collect();
    let count = load_factors.iter().filter(|l| **l <= 1.0).count();
    let unstable = dolmen::assess::Probability {
        count,
        samples: 2000,
        estimate: count as f64 / 2000.0,
        lower: 0.47,
        upper: 0.515,
        confidence: 0.95,
        seed: 1,
    };
    let sensitivities = vec![
        dolmen::assess::Sensitivity {
            input: "links[1].centroid".into(),
            value: 1.64,
            elasticity: -0.31,
            cov: None,
        },
        dolmen::assess::Sensitivity {
            input: "joints[1].stiffness".into(),
            value: 761.9e3,
            elasticity: 0.25,
            cov: Some(0.3),
        },
    ];
    let base = |project: Project| Answer {
        file: "dolmen.toml".into(),
        state: Some(state(&project)),
        project,
        variants: vec![],
        surveys: vec![],
        sensitivities: vec![],
    };
    let mut full = Answer {
        variants: vec![after],
        sensitivities,
        ..base(project)
    };
    full.state.as_mut().unwrap().sampled = Some(Sampled {
        unstable,
        load_factors,
        inputs: (1..6).map(|i| format!("joints[{i}].stiffness")).collect(),
    });
    let gate = Answer {
        surveys: roots(),
        ..base(gate())
    };
    let unknown = base(naju(None));
    let imprint = Imprint {
        program: "dolmen 0.1.0".into(),
        date: Some("2026-11-21".into()),
    };
    for language in [Language::English, Language::Korean] {
        let code = language.code();
        let write = |name: &str, answers: &[Answer]| {
            std::fs::write(
                format!("{out}/{name}_{code}.html"),
                html(answers, language, &imprint),
            )
            .unwrap()
        };
        write("naju", std::slice::from_ref(&full));
        write("gate", std::slice::from_ref(&gate));
        write("many", &[unknown.clone(), gate.clone()]);
    }
}
