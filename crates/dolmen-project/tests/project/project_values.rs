//! Errors of values and probable slips of unit: the full text of every message.

use super::project::{CHAIN, chain_with, frame_with, refused};

#[test]
fn refuses_text_in_a_number() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = "long""#)]);
    let said = r##"
error: links[2].length = "long" is text, not a number
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = "long", centroid = 1.18 },
   |                              ^^^^^^ must be a number, or text with a unit such as m or mm
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_number_in_quotes_without_unit() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = "2.61""#)]);
    let said = r##"
error: links[2].length = "2.61" is text without a unit
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = "2.61", centroid = 1.18 },
   |                              ^^^^^^ must be a number, or text with a unit such as m or mm
   = help: write 2.61 without quotes, or with its unit: "2.61 m"
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_decimal_comma() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = "2,61 m""#)]);
    let said = r##"
error: links[2].length = "2,61 m" holds a comma
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = "2,61 m", centroid = 1.18 },
   |                              ^^^^^^^^ unclear number
   = help: write decimals with a point and no thousands separator
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_centroid_above_the_top() {
    let text = chain_with(&[(r#"centroid = 1.18"#, r#"centroid = 5.2"#)]);
    let said = r##"
error: links[2].centroid = 5.2 m lies above the link's top
  --> project.toml:7:47
   |
 7 |   { weight = 15.13, length = 2.61, centroid = 5.2 },
   |                                               ^^^ must be 0 to 2.61 m, the link's own length
   = help: centroid is measured from the link's lower joint, not from the ground
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_unit_of_another_dimension() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = "2.61 kN""#)]);
    let said = r##"
error: links[2].length needs a length, but "kN" is a force
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = "2.61 kN", centroid = 1.18 },
   |                              ^^^^^^^^^ wrong kind of unit
   = help: use a unit such as m or mm
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_mass_given_as_weight() {
    let text = chain_with(&[(r#"weight = 15.13"#, r#"weight = "1.54 t""#)]);
    let said = r##"
error: links[2].weight needs a force, but "t" is a mass
  --> project.toml:7:14
   |
 7 |   { weight = "1.54 t", length = 2.61, centroid = 1.18 },
   |              ^^^^^^^^ wrong kind of unit
   = help: write mass instead of weight in links[2]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_unit_it_does_not_know() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = "2.61 metre""#)]);
    let said = r##"
error: links[2].length: "metre" is not a known unit
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = "2.61 metre", centroid = 1.18 },
   |                              ^^^^^^^^^^^^ unknown unit
   = help: did you mean "m"?
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_bare_unit_of_another_dimension_alone() {
    let text = chain_with(&[(r#"force = "kN""#, r#"force = "t""#)]);
    let said = r##"
error: units.force needs a force, but "t" is a mass
  --> project.toml:4:19
   |
 4 | units = { force = "t" }
   |                   ^^^ wrong kind of unit
   = help: use a unit such as kN
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_both_weight_and_mass() {
    let text = chain_with(&[(r#"weight = 15.13"#, r#"weight = 15.13, mass = 1500"#)]);
    let said = r##"
error: links[2] has both weight and mass
  --> project.toml:7:14
   |
 7 |   { weight = 15.13, mass = 1500, length = 2.61, centroid = 1.18 },
   |              ^^^^^ must be one of them
   = help: take one out: weight = mass × gravity
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_neither_weight_nor_mass() {
    let text = chain_with(&[(r#"weight = 15.13, "#, r#""#)]);
    let said = r##"
error: links[2] has neither weight nor mass
  --> project.toml:7:3
   |
 7 |   { length = 2.61, centroid = 1.18 },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: give weight = … (a force) or mass = …
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_negative_length() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = -2.61"#)]);
    let said = r##"
error: links[2].length = -2.61 m cannot be
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = -2.61, centroid = 1.18 },
   |                              ^^^^^ must be above 0
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_nan() {
    let text = chain_with(&[(r#"length = 2.61"#, r#"length = nan"#)]);
    let said = r##"
error: links[2].length is not a number
  --> project.toml:7:30
   |
 7 |   { weight = 15.13, length = nan, centroid = 1.18 },
   |                              ^^^ must be above 0
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_cov_in_per_cent() {
    let text = chain_with(&[(r#"weight = 15.13"#, r#"weight = { value = 15.13, cov = 5 }"#)]);
    let said = r##"
error: links[2].weight.cov = 5 is outside its range
  --> project.toml:7:37
   |
 7 |   { weight = { value = 15.13, cov = 5 }, length = 2.61, centroid = 1.18 },
   |                                     ^ must be 0 to 1
   = help: cov is standard deviation / mean: 5 % is 0.05
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_evidence_word_it_does_not_know() {
    let text = chain_with(&[(
        r#"weight = 15.13"#,
        r#"weight = { value = 15.13, source = "guess" }"#,
    )]);
    let said = r##"
error: links[2].weight.source = "guess" is not known
  --> project.toml:7:40
   |
 7 |   { weight = { value = 15.13, source = "guess" }, length = 2.61, centroid = 1.18 },
   |                                        ^^^^^^^ must be "measured", "test", "literature", "identified" or "assumed"
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_quantity_without_value() {
    let text = chain_with(&[(r#"weight = 15.13"#, r#"weight = { cov = 0.05 }"#)]);
    let said = r##"
error: links[2].weight has no "value", but needs it
  --> project.toml:7:14
   |
 7 |   { weight = { cov = 0.05 }, length = 2.61, centroid = 1.18 },
   |              ^^^^^^^^^^^^^^
   = help: write value = …: the number, bare or as text with its unit
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_text_behind_hangul_with_the_caret_in_place() {
    let text = chain_with(&[(
        r#"{ weight = 15.13,"#,
        r#"{ name = "둘째 돌", weight = "열다섯","#,
    )]);
    let said = r##"
error: links[2].weight = "열다섯" is text, not a number
  --> project.toml:7:29
   |
 7 |   { name = "둘째 돌", weight = "열다섯", length = 2.61, centroid = 1.18 },
   |                                ^^^^^^^^ must be a number, or text with a unit such as kN
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_weight_1000_times_too_heavy() {
    let text = chain_with(&[(r#"15.13"#, r#"15130"#)]);
    let said = r##"
error: links[2].weight = 15130 kN, 388 × the link below
  --> project.toml:7:14
   |
 7 |   { weight = 15130, length = 2.61, centroid = 1.18 },
   |              ^^^^^ probably a slip
   = help: did you mean N? If it is right, write allow = ["links[2].weight"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_weight_1000_times_too_light() {
    let text = chain_with(&[(r#"15.13"#, r#"0.01513"#)]);
    let said = r##"
error: links[2].weight = 0.01513 kN, 1/2570 of the link below
  --> project.toml:7:14
   |
 7 |   { weight = 0.01513, length = 2.61, centroid = 1.18 },
   |              ^^^^^^^ probably a slip
   = help: did you mean MN? If it is right, write allow = ["links[2].weight"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_every_weight_1000_times_too_heavy() {
    let text = chain_with(&[
        (r#"38.95"#, r#"38950"#),
        (r#"15.13"#, r#"15130"#),
        (r#"6.78"#, r#"6780"#),
    ]);
    let said = r##"
error: units.force = "kN": with all their weights in kN the links would, as stone, be 17.7 m wide under a height of 7.92 m
  --> project.toml:4:19
   |
 4 | units = { force = "kN" }
   |                   ^^^^ probably a slip
   = help: did you mean N? If it is right, write allow = ["units.force"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_length_in_mm() {
    let text = chain_with(&[(r#"3.68,"#, r#"3680,"#)]);
    let said = r##"
error: links[1].length = 3680 m, 1410 × the link above
  --> project.toml:6:30
   |
 6 |   { weight = 38.95, length = 3680, centroid = 1.64 },
   |                              ^^^^ probably a slip
   = help: did you mean mm? If it is right, write allow = ["links[1].length"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_joint_1000_times_too_weak() {
    let text = chain_with(&[(
        r#""unknown""#,
        r#"[ { stiffness = "1500 kN*m/rad" }, { stiffness = "0.4 kN*m/rad" }, { stiffness = "90 kN*m/rad" } ]"#,
    )]);
    let said = r##"
error: joints[2].stiffness = 0.4 kN*m/rad is 1/232 × the weight times height above the joint, 92898.4 N m/rad
   --> project.toml:10:59
    |
 10 | joints = [ { stiffness = "1500 kN*m/rad" }, { stiffness = "0.4 kN*m/rad" }, { stiffness = "90 kN*m/rad" } ]
    |                                                           ^^^^^^^^^^^^^^ probably a slip
    = help: a joint that keeps a chain upright has about 1 × that or more; is it in N m/rad, kN m/rad or kN m/deg? If it is right, write allow = ["joints[2].stiffness"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_masses_in_kg() {
    let text = frame_with(&[(r#" mass = "t","#, r#""#)]);
    let said = r##"
error: storeys[1].mass = 290 kg is outside 1 t to 20 000 t, the range expected for a storey
  --> project.toml:7:12
   |
 7 |   { mass = 290, height = 5.84, axial_force = 5919 },
   |            ^^^ probably a slip
   = help: did you mean t? If it is right, write allow = ["storeys[1].mass"]

error: storeys[2].mass = 314 kg is outside 1 t to 20 000 t, the range expected for a storey
  --> project.toml:8:12
   |
 8 |   { mass = 314, height = 7.69, axial_force = 3077 },
   |            ^^^ probably a slip
   = help: did you mean t? If it is right, write allow = ["storeys[2].mass"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_height_in_mm() {
    let text = frame_with(&[(r#"5.84"#, r#"5840"#)]);
    let said = r##"
error: storeys[1].height = 5840 m, but storeys are 0.1 to 50 m high
  --> project.toml:7:26
   |
 7 |   { mass = 290, height = 5840, axial_force = 5919 },
   |                          ^^^^ probably a slip
   = help: did you mean mm? If it is right, write allow = ["storeys[1].height"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_axial_forces_read_the_wrong_way() {
    let text = frame_with(&[(r#""storey""#, r#""level""#)]);
    let said = r##"
error: axial = "level", but the axial forces are the weights of the masses only if they are read as "storey"
  --> project.toml:5:9
   |
 5 | axial = "level"
   |         ^^^^^^^ probably a slip
   = help: did you mean axial = "storey"? If it is right, write allow = ["axial"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_axial_forces_of_unsaid_meaning() {
    let text = frame_with(&[(
        r#"axial = "storey"
"#,
        r#""#,
    )]);
    let said = r##"
error: axial_force is given without axial, which says what the force is
  --> project.toml:1:1
   |
 1 | schema = 1
   | ^
   = help: write axial = "storey" if it is the force in the storey's columns (its own level and all above), axial = "level" if it is the load added at its top
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_axial_force_in_mn() {
    let text = frame_with(&[(r#"axial_force = 3077"#, r#"axial_force = "3077 MN""#)]);
    let said = r##"
error: storeys[2].axial_force = 3077 MN: the storey's columns would carry 999 × the weight of the masses above, 3079.29 kN
  --> project.toml:8:46
   |
 8 |   { mass = 314, height = 7.69, axial_force = "3077 MN" },
   |                                              ^^^^^^^^^ probably a slip
   = help: did you mean kN? If it is right, write allow = ["storeys[2].axial_force"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_axial_force_for_some_storeys() {
    let text = frame_with(&[(r#", axial_force = 3077"#, r#""#)]);
    let said = r##"
error: storeys[2] has no axial_force, but another storey has
  --> project.toml:8:3
   |
 8 |   { mass = 314, height = 7.69 },
   |   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: give all of them, or none: they then follow from the masses
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_stiffness_1000_times_too_low() {
    let text = frame_with(&[(r#"32.65"#, r#"0.03265"#)]);
    let said = r##"
error: direction.weak.stiffness[1] = 0.03265 kN/mm: the storey alone would sway at 0.0534 Hz, outside 0.2 to 60 Hz expected for a storey
   --> project.toml:10:29
    |
 10 | direction.weak.stiffness = [0.03265, 96.14]
    |                             ^^^^^^^ probably a slip
    = help: is it in N/mm, kN/mm or kN/m? If it is right, write allow = ["direction.weak.stiffness[1]"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_stiffness_of_a_joint_in_a_frame() {
    let text = frame_with(&[(r#""kN/mm""#, r#""kN*m/rad""#)]);
    let said = r##"
error: units.stiffness needs a force per length (lateral stiffness), but "kN*m/rad" is a moment (or rotational stiffness)
  --> project.toml:4:49
   |
 4 | units = { force = "kN", mass = "t", stiffness = "kN*m/rad" }
   |                                                 ^^^^^^^^^^ wrong kind of unit
   = help: use a unit such as kN/mm
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_frequency_in_khz() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a]
frequencies = { x = [0.0011] }
"#
    );
    let said = r##"
error: survey.a.frequencies.x[1] = 0.0011 Hz, but structures sway at 0.05 to 200 Hz
   --> project.toml:13:22
    |
 13 | frequencies = { x = [0.0011] }
    |                      ^^^^^^ probably a slip
    = help: did you mean kHz? If it is right, write allow = ["survey.a.frequencies.x[1]"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_damping_ratio_in_per_cent() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a]
modes.x = [ { frequency = 1.1, damping_ratio = 2 } ]
"#
    );
    let said = r##"
error: survey.a.modes.x[1].damping_ratio = 2, but structures have 0.005 to 0.1
   --> project.toml:13:48
    |
 13 | modes.x = [ { frequency = 1.1, damping_ratio = 2 } ]
    |                                                ^ probably a slip
    = help: did you mean "2 %"? If it is right, write allow = ["survey.a.modes.x[1].damping_ratio"]
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_frequencies_that_do_not_ascend() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a]
frequencies = { x = [4.9, 4.6] }
"#
    );
    let said = r##"
error: survey.a.frequencies.x[2] = 4.6 Hz does not lie above the mode before it
   --> project.toml:13:27
    |
 13 | frequencies = { x = [4.9, 4.6] }
    |                           ^^^ must be above 4.9 Hz
    = help: list the modes of a direction in ascending order, each once
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_axial_forces_that_grow_upwards() {
    let text = frame_with(&[(r#"5919"#, r#"1300"#)]);
    let said = r##"
error: storey 1: its axial force is 1300000 N, less than the 3077000 N of the storey above it, but a storey carries its own level and all above: if these are the loads of the levels alone, sum them from the top first
  --> project.toml:7:46
   |
 7 |   { mass = 290, height = 5.84, axial_force = 1300 },
   |                                              ^^^^
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_a_tilt_upside_down() {
    let text = format!(
        "{CHAIN}\n{}",
        r#"[survey.a]
tilt = { x = 177 }
"#
    );
    let said = r##"
error: survey.a.tilt.x = 177 would have fallen
   --> project.toml:13:14
    |
 13 | tilt = { x = 177 }
    |              ^^^ must be within ±0.25
    = help: tilt is horizontal / vertical: "1/177", 0.00565, "0.32 deg" or "5.65 mm/m"
"##;
    assert_eq!(refused(&text), said.trim_start_matches('\n'));
}

#[test]
fn refuses_an_acceleration_in_quotes_with_units_that_are_allowed() {
    let site = "[site]\ncode = \"KDS 17 10 00\"\nzone_factor = \"0.11\"\nreturn_period_years = 1000\nsoil = \"S2\"\n";
    let text = chain_with(&[]) + site;
    let said = refused(&text);
    assert!(said.contains("help: write \"0.11 g\" or \"0.11 m/s2\""), "{said}");
    let bare = refused(&text.replace("\"0.11\"", "0.11"));
    assert!(bare.contains("help: write \"0.11 g\" or \"0.11 m/s2\""), "{bare}");
}
