//! Sites and ground motions of a project file: their values, and the full text of every message.

use super::project::{refused, with};
use dolmen::assess::demand::{EurocodeGround, EurocodeType, KoreanSite, Site, SiteParameters};
use dolmen::signal::Component;
use dolmen_project::{
    MemoryFiles, MotionSize, MotionSource, Place, Project, SitePart, parse_project, parse_project_with,
};

/// A correct stack without a site.
const STONE: &str = r#"schema = 1
kind = "stack"
name = "Stone"
density = 2600
blocks = [{ name = "stone", width = 0.4, height = 2.0 }]
"#;

const KOREA: &str = r#"[site]
code = "KDS 17 10 00"
zone = "I"
return_period_years = 2400
soil = "S4"
"#;

const EUROCODE: &str = r#"[site]
code = "EN 1998-1"
spectrum_type = 2
ground = "D"
ground_acceleration = "0.981 m/s2"
importance_factor = 1.2
"#;

const TABLE: &str = r#"[site]
code = "table"
source = "Site study"
periods_s = [0, 0.1, 1]
accelerations = [0.1, 0.25, 0.05]
unit = "g"
"#;

fn read(text: &str) -> Project {
    parse_project(text, "project.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn site(table: &str) -> SitePart {
    read(&(STONE.to_owned() + table)).site.unwrap()
}

fn refused_site(table: &str, changes: &[(&str, &str)]) -> String {
    refused(&(STONE.to_owned() + &with(table, changes)))
}

#[test]
fn published_every_number_of_a_korean_site() {
    let demand = site(KOREA).demand().unwrap();
    let SiteParameters::Korea {
        amplification,
        branches,
        effective_acceleration_g,
        ..
    } = demand.parameters
    else {
        panic!()
    };
    assert_eq!(effective_acceleration_g, 0.22);
    assert!((amplification.short_periods - 1.36).abs() < 1e-12);
    assert!((amplification.one_second - 1.96).abs() < 1e-12);
    assert!((branches.plateau_s - 0.57647).abs() < 5e-6);
    // a zone factor with its unit is the same site
    let factor = with(KOREA, &[("zone = \"I\"", "zone_factor = \"0.11 g\"")]);
    let Site::Kds17 { zone_factor_g, .. } = site(&factor).site else {
        panic!()
    };
    assert!((zone_factor_g - 0.11).abs() < 1e-15);
    let buildings = with(
        KOREA,
        &[("17 10 00", "41 17 00"), ("return_period_years = 2400\n", "")],
    );
    let expected = Site::Kds41 {
        zone_factor_g: 0.11,
        soil: KoreanSite::S4,
    };
    assert_eq!(site(&buildings).site, expected);
}

#[test]
fn exact_a_european_site_and_what_is_read_beside_it() {
    let part = site(&(EUROCODE.to_owned() + "damping_ratio = \"3 %\"\nvertical_ratio = 0.4\n"));
    assert_eq!((part.damping_ratio, part.vertical_ratio), (0.03, Some(0.4)));
    let Site::Eurocode8 {
        ground_acceleration_g,
        importance_factor,
        spectrum,
        ground,
    } = part.site
    else {
        panic!()
    };
    assert!((ground_acceleration_g - 0.981 / 9.80665).abs() < 1e-15);
    assert_eq!(importance_factor, 1.2);
    assert_eq!((spectrum, ground), (EurocodeType::Two, EurocodeGround::D));
}

#[test]
fn exact_tables_from_lists_and_from_a_file() {
    let part = site(&(TABLE.to_owned() + "damping_ratio = 0.02\npeak_ground_acceleration = \"0.12 g\"\n"));
    let Site::Table {
        source,
        points,
        damping_ratio,
        peak_ground_acceleration_m_s2,
    } = &part.site
    else {
        panic!()
    };
    assert_eq!((source.as_str(), *damping_ratio), ("Site study", 0.02));
    assert_eq!(peak_ground_acceleration_m_s2.unwrap(), 0.12 * 9.80665);
    assert_eq!(points[1], [0.1, 0.25 * 9.80665]);
    let text = STONE.to_owned() + "[site]\ncode = \"table\"\nfile = \"sp.csv\"\nunit = \"m/s2\"\n";
    let files = |content: &'static str| {
        let files = [("sp.csv".to_owned(), content.as_bytes().to_vec())];
        MemoryFiles { files: files.into() }
    };
    let good = "# study\nperiod_s;sa\n0;1.0\n0.1\t2.5\n2, 0.2\n";
    let project = parse_project_with(&text, "project.toml", &files(good)).unwrap();
    let Some(Site::Table { points, source, .. }) = project.site.map(|part| part.site) else {
        panic!()
    };
    assert_eq!(points, [[0.0, 1.0], [0.1, 2.5], [2.0, 0.2]]);
    assert_eq!(source, "sp.csv");
    let bad = parse_project_with(&text, "project.toml", &files("t,a\n0,1\n0.1,x\n")).unwrap_err();
    let said = "site.file = \"sp.csv\": line 3 is not a period, s, and an acceleration";
    assert_eq!(bad.problems[0].message.english, said);
    let none = refused(&text);
    assert!(
        none.contains("site.file = \"sp.csv\": no files are read here, only the text of the project"),
        "{none}"
    );
}

#[test]
fn refuses_what_the_code_has_no_numbers_for() {
    let said = r#"
error: site.soil: site class S6 is site-specific: the code gives no factors for it; have the site studied and give its spectrum as a table
   --> project.toml:10:8
    |
 10 | soil = "S6"
    |        ^^^^
"#;
    assert_eq!(refused_site(KOREA, &[("S4", "S6")]).trim(), said.trim());
    let years = refused_site(KOREA, &[("2400", "475")]);
    let said = "site.return_period_years: return_period_years is 475, but the code has 50, 100, 200, 500, 1000, 2400 and 4800: \
                take the next longer, for 2475 years 2400";
    assert!(years.contains(said), "{years}");
    let large = refused_site(KOREA, &[("zone = \"I\"", "zone_factor = \"11 m/s2\"")]);
    assert!(
        large.contains("site.zone_factor: effective_acceleration_g is"),
        "{large}"
    );
    let percent = refused_site(&(KOREA.to_owned() + "damping_ratio = 5\n"), &[]);
    let said = "site.damping_ratio: damping_ratio is 5, but must be 0.005 to 0.3 (is it in percent?)";
    assert!(percent.contains(said), "{percent}");
}

#[test]
fn refuses_bare_accelerations_and_keys_of_another_code() {
    let bare = refused_site(KOREA, &[("zone = \"I\"", "zone_factor = 0.11")]);
    let said = r#"
error: site.zone_factor = 0.11 has no unit
  --> project.toml:8:15
   |
 8 | zone_factor = 0.11
   |               ^^^^ must be an acceleration with its unit
   = help: write "0.11 g" or "0.11 m/s2"
"#;
    assert_eq!(bare.trim(), said.trim());
    let cases = [
        (
            refused_site(KOREA, &[("soil = \"S4\"", "ground = \"C\"")]),
            [
                "site.ground has no meaning with code = \"KDS 17 10 00\"",
                "site has no \"soil\"",
            ],
        ),
        (
            refused_site(EUROCODE, &[("importance_factor = 1.2", "zone = \"I\"")]),
            [
                "site.zone has no meaning with code = \"EN 1998-1\"",
                "KDS 41 17 00",
            ],
        ),
        (
            refused_site(EUROCODE, &[("1.2", "12")]),
            ["site.importance_factor: importance_factor is 12", "at most 3"],
        ),
        (
            refused_site(
                KOREA,
                &[("zone = \"I\"", "zone = \"I\"\nzone_factor = \"0.11 g\"")],
            ),
            ["site has both zone and zone_factor", "keep one of them"],
        ),
        (
            refused_site(KOREA, &[("zone = \"I\"\n", "")]),
            ["site has no \"zone\"", "zone_factor = \"0.11 g\""],
        ),
        (
            refused_site(TABLE, &[("unit = \"g\"\n", "")]),
            ["site has no \"unit\"", "the unit of its accelerations"],
        ),
        (
            refused_site(TABLE, &[("unit = \"g\"", "unit = \"mm\"")]),
            ["site.unit = \"mm\" is no unit of acceleration", "\"gal\""],
        ),
        (
            refused_site(TABLE, &[("0.1, 1]", "0.1]")]),
            [
                "site.accelerations has 3 numbers, but site.periods_s 2",
                "one a period",
            ],
        ),
        (
            refused_site(TABLE, &[("0.1, 1]", "0.1, 0.1]")]),
            [
                "site.periods_s: row 3 of the spectrum is missing or refused",
                "rising",
            ],
        ),
    ];
    for (answer, said) in cases {
        for said in said {
            assert!(answer.contains(said), "{said}: {answer}");
        }
    }
}

#[test]
fn exact_motions_are_read_in_the_order_of_the_file() {
    let text = STONE.to_owned()
        + "[motion.late]\nbuilt_in = \"el-centro-1940-ns\"\nscale = -2\n\
           [motion.early]\nfiles = { x = \"a.at2\", z = \"c.csv\" }\nunit = \"gal\"\nsample_step_s = 0.01\nkeep_first_s = 20\n\
           taper_s = 0.1\nturn = \"30 deg\"\npeak = \"0.3 g\"\nsource = \"PEER\"\n";
    let motions = read(&text).motions;
    assert_eq!(motions[0].name, "late");
    assert_eq!(motions[0].from, MotionSource::BuiltIn("el-centro-1940-ns".into()));
    assert_eq!(motions[0].size, Some(MotionSize::Scale(-2.0)));
    let early = &motions[1];
    let files = vec![(Component::X, "a.at2".into()), (Component::Z, "c.csv".into())];
    assert_eq!(early.from, MotionSource::Files(files));
    assert_eq!(
        (early.unit.as_deref(), early.source.as_deref()),
        (Some("gal"), Some("PEER"))
    );
    let times = (early.sample_step_s, early.keep_first_s, early.taper_s);
    assert_eq!(times, (Some(0.01), Some(20.0), Some(0.1)));
    assert!((early.turn_rad.unwrap() - std::f64::consts::FRAC_PI_6).abs() < 1e-15);
    assert_eq!(early.size, Some(MotionSize::Peak(0.3 * 9.80665)));
}

#[test]
fn exact_a_motion_of_columns_has_one_file_for_all() {
    let text = STONE.to_owned()
        + "[motion.station]\nfile = \"s.csv\"\ncolumns = { x = \"EW\", z = \"3\" }\nstated_peak = \"ignore\"\nfactor = 2\n\
           [motion.turned]\nfile = \"s.csv\"\nx_azimuth_deg = 90\n";
    let motions = read(&text).motions;
    let both = [Component::X, Component::Z].map(|of| (of, "s.csv".to_owned()));
    assert_eq!(motions[0].from, MotionSource::Files(both.to_vec()));
    let columns = [(Component::X, "EW".to_owned()), (Component::Z, "3".to_owned())];
    assert_eq!(motions[0].columns, columns);
    assert!(motions[0].ignores_stated_peak && motions[0].factor == Some(2.0));
    assert_eq!(
        motions[1].from,
        MotionSource::Files(vec![(Component::X, "s.csv".to_owned())])
    );
    assert_eq!(motions[1].x_azimuth_deg, Some(90.0));
}

#[test]
fn refuses_motions_that_cannot_be() {
    let of = |keys: &str| refused(&format!("{STONE}[motion.a]\n{keys}\n"));
    let cases = [
        ("", "motion.a has neither files, nor file, nor built_in"),
        ("files = {}", "motion.a.files is empty"),
        (
            "files = { x = \"a\" }\nbuilt_in = \"b\"",
            "motion.a has both files and built_in",
        ),
        ("built_in = \"b\"\npeak = 0.3", "motion.a.peak = 0.3 has no unit"),
        (
            "built_in = \"b\"\npeak = \"0.3 g\"\nscale = 2",
            "motion.a has both scale and peak",
        ),
        ("built_in = \"b\"\nscale = 0", "motion.a.scale = 0 cannot be"),
        ("built_in = \"b\"\nturn = 30", "write \"30 deg\" or \"30 rad\""),
        ("built_in = \"b\"\ntaper_s = -1", "must be 1e-6 to 100000"),
        (
            "files = { x = \"a\" }\nunit = \"mm\"",
            "motion.a.unit = \"mm\" is no unit of acceleration",
        ),
        ("files = { w = \"a\" }", "motion.a.files has no key \"w\""),
        (
            "files = { x = \"a\" }\nfile = \"b\"",
            "motion.a has both files and file",
        ),
        ("file = \"b\"\ncolumns = {}", "motion.a.columns names no column"),
        (
            "file = \"b\"\ncolumns = { x = \"EW\" }\nx_azimuth_deg = 90",
            "motion.a.columns stands beside x_azimuth_deg",
        ),
        (
            "files = { x = \"a\" }\ncolumns = { y = \"NS\" }",
            "motion.a.columns names a column for y, but files has no y",
        ),
        (
            "built_in = \"b\"\ncolumns = { x = \"EW\" }",
            "but \"b\" is in none",
        ),
        ("file = \"b\"\nfactor = 0", "motion.a.factor = 0 cannot be"),
    ];
    for (keys, said) in cases {
        let answer = of(keys);
        assert!(answer.contains(said), "{said}: {answer}");
        assert_eq!(answer.matches("error:").count(), 1, "{answer}");
    }
    let survey = "schema = 1\nkind = \"survey\"\nname = \"n\"\n[motion.a]\nbuilt_in = \"b\"\n";
    let answer = refused(survey);
    assert!(
        answer.contains("\"motion\" moves a structure, but this file has kind = \"survey\""),
        "{answer}"
    );
}

#[test]
fn holds_chains_and_frames_have_motions_too() {
    let chain = "schema = 1\nkind = \"chain\"\nname = \"n\"\njoints = \"unknown\"\n\
                 links = [{ weight = \"20 kN\", length = 2.0, centroid = 0.9 }]\n";
    let frame = "schema = 1\nkind = \"frame\"\nname = \"n\"\nstoreys = [{ mass = \"60 t\", height = 4.2 }]\n";
    for text in [chain, frame] {
        let project = read(&format!("{text}[motion.a]\nbuilt_in = \"el-centro-1940-ns\"\n"));
        assert_eq!(project.motions[0].name, "a");
    }
}

#[test]
fn holds_a_variant_changes_the_site_alone() {
    let text = STONE.to_owned() + KOREA + "[variant.rock.site]\nsoil = \"S1\"\n";
    let project = read(&text);
    let soil = |part: &Option<SitePart>| match part.as_ref().unwrap().site {
        Site::Kds17 { soil, .. } => soil,
        _ => panic!(),
    };
    assert_eq!(soil(&project.site), KoreanSite::S4);
    assert_eq!(soil(&project.variants[0].project.site), KoreanSite::S1);
}

#[test]
fn exact_a_place_stands_with_a_code_or_alone() {
    const PLACE: &str = "latitude_deg = 35.79\nlongitude_deg = 129.332\n";
    let expected = Place {
        latitude_deg: 35.79,
        longitude_deg: 129.332,
    };
    let alone = read(&format!("{STONE}[site]\n{PLACE}"));
    assert_eq!((alone.place, alone.site), (Some(expected), None));
    let both = read(&format!("{STONE}{KOREA}{PLACE}"));
    assert_eq!((both.place, both.site.is_some()), (Some(expected), true));
    assert_eq!(read(STONE).place, None);
}

#[test]
fn refuses_half_a_place_and_one_that_is_not_on_earth() {
    let said = refused(&format!("{STONE}[site]\nlatitude_deg = 35.79\n"));
    assert!(said.contains("site.latitude_deg stands alone"), "{said}");
    assert!(said.contains("give longitude_deg as well"), "{said}");
    let said = refused(&format!(
        "{STONE}[site]\nlatitude_deg = 129.332\nlongitude_deg = 35.79\n"
    ));
    assert!(
        said.contains("site.latitude_deg = 129.332 is outside its range")
            && said.contains("must be -90 to 90"),
        "{said}"
    );
    let said = refused(&format!(
        "{STONE}[site]\nsoil = \"S4\"\nlatitude_deg = 1\nlongitude_deg = 2\n"
    ));
    assert!(said.contains("site lacks code"), "{said}");
}
