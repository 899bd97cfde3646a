// SOURCE     Motions that shook a structure although no ground at its foot moved so, and spectra that are for another damping.
// GOAL       The command refuses each with what to do, or the answer says what it rests on.
// TOLERANCE  none: words and exit statuses.

use super::verbs::Scratch;
use std::fs;

const POLE: &str = "schema = 1\nkind = \"chain\"\nname = \"Pole\"\nunits = { force = \"kN\", stiffness = \"kN*m/rad\" }\ndamping_ratio = 0.02\n\
    links = [{ name = \"shaft\", weight = 20, length = 3.0, centroid = 1.5, breadth = 0.6, bed_width = 0.6 }]\njoints = [{ stiffness = 3000 }]\n";

const GATE: &str = "schema = 1\nkind = \"frame\"\nname = \"Gate\"\nunits = { mass = \"t\", stiffness = \"kN/mm\" }\n\
    storeys = [{ name = \"low\", mass = 60, height = 4.2 }]\ndirection.x.stiffness = [4.0]\n\
    [limits]\nstorey_drift = \"2.2 %\"\n";

const TABLE: &str = "[site]\ncode = \"table\"\nperiods_s = [0, 0.1, 0.5, 1, 2]\n\
    accelerations = [0.3, 0.75, 0.75, 0.4, 0.2]\nunit = \"g\"\n";

/// A decaying shake of 0.2 g, in gal, 4 s at 100 Hz, under a head.
fn shake(head: &str) -> String {
    let row = |k: usize| {
        let t = k as f64 / 100.0;
        let a = 200.0 * (-0.5 * t).exp() * (12.0 * t).sin();
        format!("{t:.2},{a:.3},{:.4},{:.5}\n", a / 12.0, a / 144.0)
    };
    format!("{head}\n") + &(0..400).map(row).collect::<String>()
}

#[test]
fn refuses_a_table_spectrum_for_another_damping_of_every_kind() {
    let scratch = Scratch::new("table-damping");
    let says = |text: &str| {
        fs::write(scratch.path().join("p.toml"), text).unwrap();
        scratch.dolmen("check p.toml").words()
    };
    let damped = GATE.replace("[limits]", "direction.x.damping_ratio = 0.02\n[limits]");
    for text in [damped.clone() + TABLE, POLE.to_owned() + TABLE] {
        let said = says(&text);
        assert!(
            said.contains("damping_ratio is 0.02, but the table holds for 0.05"),
            "{said}"
        );
        assert!(said.contains("not decided"), "{said}");
    }
    let own = format!("{damped}{TABLE}damping_ratio = 0.02\n");
    for text in [GATE.to_owned() + TABLE, own] {
        let said = says(&text);
        assert!(
            !said.contains("table holds") && said.contains("capacity/demand"),
            "{said}"
        );
    }
}

#[test]
fn holds_only_the_named_columns_of_a_table_are_read() {
    let scratch = Scratch::new("columns-of-others");
    fs::write(
        scratch.path().join("m.csv"),
        shake("time(s),acc(cm/s2),vel(cm/s),disp(cm)"),
    )
    .unwrap();
    let all = scratch.dolmen("motion m.csv");
    assert!(
        all.stderr.contains("say which columns are accelerations") && !all.stderr.contains("scale ="),
        "{}",
        all.stderr
    );
    for named in ["--columns x=acc(cm/s2)", "--columns x=acc", "--channel acc"] {
        let answer = scratch.dolmen(&format!("motion m.csv {named}"));
        assert_eq!(answer.status, 0, "{named}: {}", answer.stderr);
        assert!(answer.stdout.contains("PGA"), "{}", answer.stdout);
    }
    let plain = shake("time,acc,vel,disp");
    fs::write(scratch.path().join("plain.csv"), plain).unwrap();
    let velocity = scratch.dolmen("motion plain.csv --unit gal --columns x=vel");
    assert!(
        velocity.stderr.contains("velocities, not accelerations"),
        "{}",
        velocity.stderr
    );
}

#[test]
fn refuses_a_vertical_column_as_x_and_says_what_a_cut_took_off() {
    let scratch = Scratch::new("unfit");
    fs::write(scratch.path().join("p.toml"), POLE).unwrap();
    fs::write(
        scratch.path().join("ud.csv"),
        shake("time,UD(gal),EW(gal),NS(gal)"),
    )
    .unwrap();
    let vertical = scratch.dolmen("simulate p.toml --motion-file ud.csv --channel UD");
    assert!(
        vertical.stderr.contains("given as x is vertical"),
        "{}",
        vertical.stderr
    );
    let looked_at = scratch.dolmen("motion ud.csv --channel UD");
    assert_eq!(looked_at.status, 0, "{}", looked_at.stderr);
    let of = |flags: &str| {
        let answer = scratch.dolmen(&format!(
            "simulate p.toml --motion-file ud.csv --channel EW {flags}"
        ));
        answer.words() + &answer.stderr
    };
    assert!(!of("").contains("took off"), "{}", of(""));
    assert!(!of("--scale 0.5 --turn 30").contains("took off"));
    // the sum of the squares beyond 1 s is 34 % of the whole
    let said = of("--keep-first 1");
    assert!(
        said.contains("took off 0 % of the largest acceleration and 34 % of the Arias intensity"),
        "{said}"
    );
}

#[test]
fn holds_a_wrong_step_is_doubted_where_a_motion_is_looked_at() {
    let scratch = Scratch::new("motion-step");
    let rows: Vec<String> = shake("h")
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(1).unwrap().to_owned())
        .collect();
    fs::write(
        scratch.path().join("one.csv"),
        format!("a(gal)\n{}\n", rows.join("\n")),
    )
    .unwrap();
    let right = scratch.dolmen("motion one.csv --sample-step 0.01");
    assert!(!right.stdout.contains("PROBABLY A SLIP"), "{}", right.stdout);
    for step in ["1", "0.0001"] {
        let answer = scratch.dolmen(&format!("motion one.csv --sample-step {step}"));
        assert!(
            answer.stdout.contains("PROBABLY A SLIP"),
            "{step}: {}",
            answer.stdout
        );
    }
}
