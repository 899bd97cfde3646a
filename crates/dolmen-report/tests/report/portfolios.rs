// SOURCE     docs/score.md.
// GOAL       Tables of designs and of structures are read to the last digit, and faults are refused with line and column; a ranking gives its
//            data.
// TOLERANCE  none.

use dolmen::assess::{Fragility, Known, KnownCapacity, RankedBy};
use dolmen_report::{TextStyle, rank_text};
use dolmen_words::Language;
use dolmen_work::portfolio::{
    Basis, FallsApart, PortfolioAnswer, PortfolioEntry, RowSource, capacity_words, misjudged,
    ranking_columns, read_portfolio, read_portfolio_sheet,
};
use dolmen_work::score::{SCORE_STATES, ScoreDesigns};
use dolmen_work::study::table_csv;
use dolmen_work::told_in;

#[test]
fn exact_designs_are_what_was_written() {
    let shipped = ScoreDesigns::shipped().unwrap();
    assert!(shipped.designs.len() >= 50, "{}", shipped.designs.len());
    let again = ScoreDesigns::read(shipped.csv().as_bytes()).unwrap();
    assert_eq!(again, shipped);
    // no design reaches a state less often than a milder one
    for design in &shipped.designs {
        let thetas: Vec<f64> = design.states.iter().flatten().map(Fragility::theta).collect();
        assert!(
            thetas.windows(2).all(|pair| pair[0] <= 1.001 * pair[1]),
            "{design:?}"
        );
    }
    let mut some = shipped.clone();
    some.designs[0].states[1] = None;
    assert_eq!(ScoreDesigns::read(some.csv().as_bytes()).unwrap(), some);
    assert_eq!(some.of_state(1).len(), some.designs.len() - 1);
}

#[test]
fn refuses_tables_of_designs_with_line_and_column() {
    let shipped = ScoreDesigns::shipped().unwrap().csv();
    let fault = |text: &str| ScoreDesigns::read(text.as_bytes()).unwrap_err().to_string();
    let without = shipped.replacen("theta_ds3_m_s2", "theta", 1);
    assert!(
        fault(&without).contains("no column \"theta_ds3_m_s2\""),
        "{}",
        fault(&without)
    );
    let table = shipped.lines().filter(|line| !line.starts_with('#'));
    let mut lines: Vec<String> = table.map(str::to_owned).collect();
    lines[3] = lines[3].replacen(',', ",x", 1);
    let text = fault(&lines.join("\n"));
    assert!(
        text.starts_with("line 4, body_height_m: \"x") && text.ends_with("is no number"),
        "{text}"
    );
    lines[3] = "3,NaN,0.3,3,0.1,2,1,0.4,1,0.4,1,0.4,1,0.4".to_owned();
    assert!(fault(&lines.join("\n")).contains("line 4, body_height_m: \"NaN\""));
    lines[3] = "3,4,0.3,3,0.1,2,-1,0.4,1,0.4,1,0.4,1,0.4".to_owned();
    assert!(fault(&lines.join("\n")).contains("line 4, theta_ds1_m_s2"));
}

#[test]
fn exact_rows_of_a_table_of_structures() {
    let table = read_portfolio(
        "\u{feff}# a comment\nname,storeys,body_height_m,slenderness_angle,body_slenderness,taper_deg,body_base_height_ratio,project,study,zone_factor_g,soil\n\
         가, 5, 6.0, 0.35, 3.4, 9, 3,,,0.11,S4\nb,,,,,,,../b,shaken,,\n"
            .as_bytes(),
        "list.csv",
    )
    .unwrap();
    let rows = table.rows;
    let RowSource::Factors(factors) = &rows[0].source else {
        panic!("{:?}", rows[0])
    };
    assert_eq!((rows[0].name.as_str(), factors.storeys), ("가", 5));
    assert_eq!((factors.slenderness_angle, factors.body_slenderness), (0.35, 3.4));
    assert!((factors.taper_rad - 9.0_f64.to_radians()).abs() < 1e-15);
    // 2400 years, S = 0.22, S4: F_a 1.36, from the theory page
    let hazard = rows[0].hazard.as_ref().unwrap();
    let [peak, rate] = *hazard.points().last().unwrap();
    assert!((peak - 0.22 * 1.36 * 9.80665).abs() < 1e-9 && (rate - 1.0 / 2400.0).abs() < 1e-15);
    assert_eq!(
        rows[1].source,
        RowSource::Project {
            path: "../b".to_owned(),
            study: Some("shaken".to_owned())
        }
    );
}

/// One list in CSV, in CP949 and as a workbook of two sheets with remarks gives the same rows.
#[test]
fn agrees_korean_lists_of_every_format() {
    let csv = "번호,이름,층수,탑신 높이 (m),몸돌 세장비,체감각 (도),탑신/기단 높이비,지진구역,지반,종류,위도,경도,비고\n\
               1,가리 석탑,5,5.1,4.7,7,2,I,S3,석탑,35.8,129.2,\n2,나리 석탑,3,3.9,3.1,6.5,2.4,0.11,S2,석탑,35.9,129.3,보수함\n";
    let mut book = rust_xlsxwriter::Workbook::new();
    let sheet = book.add_worksheet();
    for (row, line) in (0..).zip(csv.lines()) {
        for (column, cell) in (0..).zip(line.split(',').filter(|cell| !cell.is_empty())) {
            match cell.parse::<f64>() {
                Ok(number) => sheet.write_number(row, column, number).unwrap(),
                Err(_) => sheet.write_string(row, column, cell).unwrap(),
            };
        }
    }
    book.add_worksheet();
    let xlsx = book.save_to_buffer().unwrap();
    let plain = "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio,zone_factor_g,soil\n\
                 가리 석탑,5,5.1,4.7,7,2,0.11,S3\n나리 석탑,3,3.9,3.1,6.5,2.4,0.11,S2\n";
    let bare = read_portfolio(plain.as_bytes(), "list.csv").unwrap();
    // of Python 3.11: the first columns of both rows
    let cp949 = b"\xc0\xcc\xb8\xa7,\xc3\xfe\xbc\xf6,\xc5\xbe\xbd\xc5 \xb3\xf4\xc0\xcc (m),\xb8\xf6\xb5\xb9 \xbc\xbc\xc0\xe5\xba\xf1,\xc3\xbc\xb0\xa8\xb0\xa2 (\xb5\xb5),\xc5\xbe\xbd\xc5/\xb1\xe2\xb4\xdc \xb3\xf4\xc0\xcc\xba\xf1,\xc1\xf6\xc1\xf8\xb1\xb8\xbf\xaa,\xc1\xf6\xb9\xdd\n\xb0\xa1\xb8\xae \xbc\xae\xc5\xbe,5,5.1,4.7,7,2,I,S3\n\xb3\xaa\xb8\xae \xbc\xae\xc5\xbe,3,3.9,3.1,6.5,2.4,0.11,S2\n";
    let read = read_portfolio(cp949, "목록.csv").unwrap();
    assert_eq!(read.rows, bare.rows);
    for (bytes, file) in [(csv.as_bytes(), "목록.csv"), (&*xlsx, "목록.xlsx")] {
        let read = read_portfolio(bytes, file).unwrap();
        assert_eq!(read.rows, bare.rows, "{file}");
        assert_eq!(read.left_out, ["번호", "종류", "위도", "경도", "비고"], "{file}");
    }
    assert!(bare.left_out.is_empty());
    // a second sheet with content: one must be named
    book.worksheet_from_index(1)
        .unwrap()
        .write_string(0, 0, "사진")
        .unwrap();
    let two = book.save_to_buffer().unwrap();
    let read = read_portfolio_sheet(&two, "목록.xlsx", Some("Sheet1")).unwrap();
    assert_eq!(read.rows, bare.rows);
    let refused = |bytes: &[u8], file, sheet| {
        let why = read_portfolio_sheet(bytes, file, sheet).unwrap_err();
        told_in(&why, Language::Korean)
    };
    assert!(refused(&two, "목록.xlsx", None).contains("시트가 여럿이다(Sheet1, Sheet2)"));
    assert!(
        refused(&two, "목록.xlsx", Some("목록")).contains("시트 \"목록\"이 없다. 있는 시트: Sheet1, Sheet2")
    );
    assert!(refused(csv.as_bytes(), "목록.csv", Some("목록")).contains("이 표는 텍스트이므로 뺀다"));
}

#[test]
fn refuses_two_slendernesses_more_than_a_tenth_from_those_of_one_pagoda() {
    let row = |angle: String| {
        let table = format!(
            "name,storeys,body_height_m,slenderness_angle,body_slenderness,taper_deg,body_base_height_ratio\na,5,6,{angle},3.4,9,3\n"
        );
        read_portfolio(table.as_bytes(), "list.csv").map(|table| table.rows[0].source.clone())
    };
    let factors = |angle: &str| match row(angle.to_owned()).unwrap() {
        RowSource::Factors(factors) => factors,
        other => panic!("{other:?}"),
    };
    let made = factors("").slenderness_angle; // as from the slenderness of the body
    for (times, is_one) in [(0.89, false), (0.92, true), (1.08, true), (1.12, false)] {
        let found = row((times * made).to_string());
        assert_eq!(found.is_ok(), is_one, "{times}: {found:?}");
    }
    let why = row((1.12 * made).to_string()).unwrap_err().to_string();
    assert!(why.contains("are not of one pagoda"), "{why}");
}

#[test]
fn refuses_tables_of_structures_with_line_and_what_to_do() {
    let head =
        "name,storeys,body_height_m,body_slenderness,taper_deg,body_base_height_ratio,zone_factor_g,soil\n";
    let fault = |rows: &str| {
        read_portfolio(format!("{head}{rows}").as_bytes(), "list.csv")
            .unwrap_err()
            .to_string()
    };
    for (rows, says) in [
        (
            "a,5,6,3,9,x,,\n",
            "line 2 (a): body_base_height_ratio is \"x\", but must be a number",
        ),
        ("a,5,6,-3,9,2,,\n", "line 2 (a): body_slenderness is \"-3\""),
        (
            "a,5.5,6,3,9,2,,\n",
            "line 2 (a): storeys is \"5.5\", but must be a whole number",
        ),
        (
            "a,5,6,3,57,2,,\n",
            "line 2 (a): taper_deg is \"57\", but must be below 40, in degrees",
        ),
        ("a,5,6,,9,2,,\n", "fill body_slenderness/slenderness_angle"),
        (",5,6,3,9,2,,\n", "the structure has no name"),
        ("a,5,6,3,9,2,0.11,\n", "zone_factor_g and soil belong together"),
        ("a,5,6,3,9,2,0.11,S9\n", "soil is \"S9\", but must be S1 to S5"),
        (
            "a,5,6,3,9,2,0.11,S6\n",
            "line 2 (a): site class S6 is site-specific",
        ),
        (
            "a,5,6,3,9,2,,\nb,5,6,3,9,2,,\na,5,6,3,9,2,,\n",
            "lines 2 and 4 are both \"a\"",
        ),
        ("a,5,6\n", "fill body_slenderness/slenderness_angle, taper_deg"),
        ("a,5,6,3,9,2,0.11,S2,7\n", "more cells than the table has heads"),
        (
            "a,5,6,3,9,2,11,S2\n",
            "line 2 (a): zone_factor_g is \"11\", but must be above 0 and at most 0.15, in g",
        ),
        (
            "a,5,\"6,2\",3,9,2,,\n",
            "body_height_m is \"6,2\", but must be a number, with a decimal point: 6.2",
        ),
        (
            "a,5,\"3,900\",3,9,2,,\n",
            "3.900 if it is a decimal sign, 3900 if it separates thousands",
        ),
    ] {
        let found = fault(rows);
        assert!(found.contains(says), "{rows}: {found}");
    }
    // errors name a head as typed, and its key if the key was typed
    let korean = "이름,층수,탑신 높이 (m),몸돌 세장비,체감각 (도),탑신/기단 높이비\n가,5,x,3,9,2\n";
    let why = read_portfolio(korean.as_bytes(), "목록.csv").unwrap_err();
    assert_eq!(
        told_in(&why, Language::Korean),
        "2행(가): 탑신 높이 (m)이 \"x\"인데 열의 단위로 0 이상인 수이어야 한다"
    );
    assert!(
        told_in(&why, Language::English).contains("탑신 높이 (m) (body_height_m) is \"x\""),
        "{why}"
    );
    let why = read_portfolio(format!("{head}a,5,6,,9,x,,\n").as_bytes(), "list.csv").unwrap_err();
    let said = told_in(&why, Language::Korean);
    assert!(
        said.contains("탑신/기단 높이비(body_base_height_ratio)"),
        "{said}"
    );
    // one row that is wrong does not cost the others
    let some = read_portfolio(
        format!("{head}a,5,6,3,9,2,,\nb,5,6,3,57,2,,\n").as_bytes(),
        "list.csv",
    )
    .unwrap();
    assert_eq!((some.rows.len(), some.refused.len()), (1, 1));
    assert_eq!(some.refused[0].0, "b");
    assert!(
        read_portfolio(b"storeys\n5\n", "list.csv")
            .unwrap_err()
            .to_string()
            .starts_with("the table has no column \"name\"")
    );
    assert!(
        read_portfolio("name,body height (mm)\na,5\n".as_bytes(), "list.csv")
            .unwrap_err()
            .to_string()
            .starts_with("column \"body height (mm)\" is misspelt or in another unit")
    );
}

/// Three structures whose ranking by DS3 is the reverse of that by falls.
fn answer() -> PortfolioAnswer {
    let known = |theta: f64, known| {
        Some(KnownCapacity {
            fragility: Fragility::new(theta, 0.4).unwrap(),
            ln_theta_sd: 0.1,
            known,
            falls_alone: 0.0,
        })
    };
    let entry = |name: &str, ds3: f64, falls: f64, how| PortfolioEntry {
        name: name.to_owned(),
        basis: Basis::Score {
            reasons: [0.1, 0.0, -0.3, 0.0, -0.1, 0.0],
            outside: Vec::new(),
            unlike: Vec::new(),
        },
        states: [None, None, known(ds3, Known::Found), known(falls, how)],
        has: [true; 4],
        hazard: None,
        hazard_replaced: false,
        severe_damage: Vec::new(),
    };
    let entries = vec![
        entry("a", 9.0, 9.5, Known::Found),
        entry("b", 3.0, 20.0, Known::AtLeast),
        entry("c", 6.0, 12.0, Known::Found),
    ];
    PortfolioAnswer::of("list.csv".to_owned(), 2, entries, Vec::new(), 100).unwrap()
}

#[test]
fn holds_what_falls_alone_would_miss_is_said() {
    let answer = answer();
    assert_eq!(answer.ranked.by, RankedBy::Capacity);
    let names: Vec<&str> = answer.rows().map(|(_, entry, _)| entry.name.as_str()).collect();
    assert_eq!(names, ["b", "c", "a"]);
    assert_eq!(answer.by_falls, [Some(1), Some(3), Some(2)]);
    let found = misjudged(&answer);
    let wanted = FallsApart {
        name: "b",
        rank: 1,
        by_falls: 3,
    };
    assert_eq!(found, [wanted]);
    let text = rank_text(&answer, TextStyle::plain());
    let said = "b: place 1 by DS3, but 3 by falls alone: it is damaged long before anything falls";
    assert!(text.contains(said) && text.contains("tan α: −26 %"), "{text}");
    let falls = answer.entries[1].states[3].unwrap();
    assert_eq!(capacity_words(&falls, 9.81), "> 2.0");
    let table = table_csv(&ranking_columns(&answer));
    let mut lines = table.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row: Vec<&str> = lines.next().unwrap().split(',').collect();
    let of = |column: &str| row[head.iter().position(|name| *name == column).unwrap()];
    assert_eq!((of("name"), of("place"), of("theta_ds3_m_s2")), ("b", "1", "3"));
    assert_eq!(
        (of("known_falls"), of("theta_ds1_m_s2"), of("annual_rate")),
        ("at_least", "", "")
    );
    assert_eq!(SCORE_STATES.len(), 4);
    // the answer names a structure with an unknown state instead of dropping it
    let mut entries = answer.entries.clone();
    entries[2].states[2] = None;
    let again = PortfolioAnswer::of("list.csv".to_owned(), 2, entries, Vec::new(), 100).unwrap();
    assert_eq!((again.entries.len(), again.left_out[0].name.as_str()), (2, "c"));
    let text = rank_text(&again, TextStyle::plain());
    assert!(
        text.contains("Without a place, look at these yourself: 1 (c)\n"),
        "{text}"
    );
    assert!(text.contains("  - c: nothing is known"), "{text}");
}
