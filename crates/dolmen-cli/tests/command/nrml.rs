// SOURCE     OpenQuake engine manual, "Fragility models"; mean and standard deviation of a lognormal: Johnson, Kotz, Balakrishnan (1994), ch. 14.
// GOAL       NRML has the same fragility curves as fragility.csv, in OpenQuake's units; directions of one record do not count as more motions.
// TOLERANCE  1e-12: the same numbers by another formula, to rounding.

use super::verbs::Scratch;
use std::collections::BTreeMap;
use std::fs;

const STONE: &str = r#"
schema = 1
kind = "stack"
name = "A stone & its foot"
density = 2600
joint = { friction = 0.7 }
blocks = [{ name = "foot", width = 1.0, height = 0.3 }, { name = "stone", width = 0.3, height = 0.9 }]
"#;

/// Attributes of an element within a line.
fn attributes(line: &str) -> BTreeMap<String, String> {
    let mut rest = line;
    let mut found = BTreeMap::new();
    while let Some((before, after)) = rest.split_once("=\"") {
        let name = before.rsplit([' ', '<']).next().unwrap().to_owned();
        let (value, after) = after.split_once('"').unwrap();
        found.insert(name, value.to_owned());
        rest = after;
    }
    found
}

fn rows(text: &str) -> Vec<BTreeMap<String, String>> {
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells = heads.iter().zip(line.split(','));
        cells
            .map(|(head, cell)| ((*head).to_owned(), cell.to_owned()))
            .collect()
    };
    lines.map(row).collect()
}

#[test]
fn exact_curves_in_nrml_are_those_of_the_table() {
    let scratch = Scratch::new("nrml");
    let study = "[study.two]\nvary = { \"blocks[2].height\" = [0.7, 1.1] }\nartificial = { count = 5, duration_s = 12, strong_s = 4 }\n\
                 scale = { from = 1, to = 8, steps = 6 }\npoints = 4\n";
    fs::write(scratch.path().join("project.toml"), format!("{STONE}{study}")).unwrap();
    let answer = scratch.dolmen("study . -o out");
    assert_eq!(answer.status, 0, "{}", answer.stderr);
    let out = scratch.path().join("out/two");
    let table = rows(&fs::read_to_string(out.join("fragility.csv")).unwrap());
    for (imt, theta, beta, per_si) in [
        ("PGA", "theta_pga_m_s2", "beta_pga", 1.0 / 9.80665),
        ("PGV", "theta_pgv_m_s", "beta_pgv", 100.0),
        ("SA_0.5", "theta_sa_0.5_s_m_s2", "beta_sa_0.5_s", 1.0 / 9.80665),
    ] {
        let text = fs::read_to_string(out.join(format!("fragility_{imt}.xml"))).unwrap();
        assert!(
            text.contains("A stone &amp; its foot") && text.contains("nrml/0.5"),
            "{text}"
        );
        let states = text
            .split("<limitStates>")
            .nth(1)
            .unwrap()
            .split('<')
            .next()
            .unwrap();
        let states: Vec<&str> = states.split(' ').collect();
        let mut functions = 0;
        let mut at = 0;
        for line in text.lines() {
            let given = attributes(line);
            if line.starts_with("<fragilityFunction") {
                functions += 1;
                at = 0;
                assert_eq!(given["id"], format!("two-{functions}"));
                assert_eq!(
                    (given["format"].as_str(), given["shape"].as_str()),
                    ("continuous", "logncdf")
                );
            } else if line.starts_with("<imls") {
                assert_eq!(given["imt"], imt.replace("SA_0.5", "SA(0.5)"));
                let [least, most] = ["minIML", "maxIML"].map(|key| given[key].parse::<f64>().unwrap());
                assert!(0.0 < least && least < most && given["noDamageLimit"] == given["minIML"]);
            } else if line.starts_with("<params") {
                assert_eq!(given["ls"], states[at]);
                at += 1;
                let row = table
                    .iter()
                    .find(|row| row["combination"] == functions.to_string() && row["state"] == given["ls"])
                    .unwrap();
                let [mean, deviation] = ["mean", "stddev"].map(|key| given[key].parse::<f64>().unwrap());
                let [theta, beta] = [theta, beta].map(|key| row[key].parse::<f64>().unwrap());
                // back from the moments: σ² = ln(1 + (s/m)²), median m/√(1 + (s/m)²)
                let ratio = 1.0 + (deviation / mean).powi(2);
                assert!((ratio.ln().sqrt() / beta - 1.0).abs() < 1e-12, "{line} {row:?}");
                assert!(
                    (mean / ratio.sqrt() / (theta * per_si) - 1.0).abs() < 1e-12,
                    "{line} {row:?}"
                );
            }
        }
        assert_eq!(functions, 2, "{text}");
        assert_eq!(at, states.len());
        for element in ["nrml", "fragilityModel", "fragilityFunction"] {
            let count = |mark: String| text.matches(&mark).count();
            assert_eq!(count(format!("<{element} ")), count(format!("</{element}>")));
        }
    }
}

#[test]
fn holds_directions_of_one_record_are_no_more_motions() {
    let scratch = Scratch::new("one-record");
    let mut station = "time,EW(gal),NS(gal)\n".to_owned();
    for k in 0..600 {
        let t = 0.01 * f64::from(k);
        let swell = (-(t - 2.0) * (t - 2.0)).exp();
        station += &format!(
            "{t:.2},{},{}\n",
            300.0 * swell * (9.0 * t).sin(),
            250.0 * swell * (7.0 * t).cos()
        );
    }
    for file in ["station.csv", "copy.csv"] {
        fs::write(scratch.path().join(file), &station).unwrap();
    }
    let count = |north: &str, record: &str, out: &str| {
        let text = format!(
            "{STONE}[motion.east]\nfile = \"station.csv\"\ncolumns = {{ x = \"EW\" }}\n{record}\n\
             [motion.north]\nfile = \"{north}\"\ncolumns = {{ x = \"NS\" }}\n{record}\n\
             [motion.other]\nbuilt_in = \"el-centro-1940-ns\"\nkeep_first_s = 8\n\
             [study.s]\nmotions = [\"east\", \"north\", \"other\"]\nscale = [1, 2]\npoints = 4\n"
        );
        fs::write(scratch.path().join("project.toml"), text).unwrap();
        let answer = scratch.dolmen(&format!("study . -o {out}"));
        assert_eq!(answer.status, 0, "{}", answer.stderr);
        let table = rows(&fs::read_to_string(scratch.path().join(out).join("s/fragility.csv")).unwrap());
        assert_eq!(table[0]["scans"], "3");
        table[0]["motions"].clone()
    };
    assert_eq!(count("station.csv", "", "file"), "2");
    assert_eq!(count("copy.csv", "", "files"), "3");
    assert_eq!(count("copy.csv", "record = \"one\"", "named"), "2");
}
