//! Ground motions: AT2 with both headers, text in columns, and refusals.

use dolmen::signal::{Component, Processing};
use dolmen_records::motions::{
    ComponentSource, Lengths, MotionFormat, MotionOptions, read_channels, read_columns_as, read_component,
    read_motion, read_oriented,
};
use dolmen_records::records::{Column, Unit};

const G: f64 = 9.80665;
const NEW: &str = "PEER NGA STRONG MOTION DATABASE RECORD\r\nMade Valley, 1/1/2000, Test Array #1, 180\r\n\
    ACCELERATION TIME SERIES IN UNITS OF G\r\nNPTS=      7, DT=   .0100 SEC,     \r\n\
    \x20  .1000000E-01  -.2500000E+00   .3000000E-01   .0000000E+00   .1000000E-02\r\n   .5000000E-02  -.1000000E-03\r\n";
const OLD: &str = "PEER STRONG MOTION DATABASE RECORD. PROCESSING BY PEER\nMADE VALLEY 01/01/00, TEST, 270\n\
    ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=40.0 Hz\n    6    0.0100    NPTS, DT\n\
    \x20 0.1E-01 -0.2E+00 0.3 \n 0 1.0e-3 -4e-2";

fn said(text: &str, options: &MotionOptions) -> String {
    read_component(text.as_bytes(), options).unwrap_err().to_string()
}

fn in_unit(unit: Unit) -> MotionOptions {
    MotionOptions {
        unit: Some(unit),
        ..Default::default()
    }
}

#[test]
fn exact_at2_in_both_headers() {
    let read = read_component(NEW.as_bytes(), &MotionOptions::default()).unwrap();
    assert_eq!(
        (read.format, read.unit, read.time_step_s),
        (MotionFormat::At2, Unit::Gravity, 0.01)
    );
    assert_eq!(read.title, "Made Valley, 1/1/2000, Test Array #1, 180");
    let wanted = [0.01, -0.25, 0.03, 0.0, 0.001, 0.005, -0.0001].map(|a| a * G);
    assert_eq!(read.acceleration_m_s2, wanted);
    let old = read_component(OLD.as_bytes(), &MotionOptions::default()).unwrap();
    assert_eq!(
        old.acceleration_m_s2,
        [0.01, -0.2, 0.3, 0.0, 0.001, -0.04].map(|a| a * G)
    );
    assert_eq!(old.time_step_s, 0.01);
}

#[test]
fn exact_text_in_columns() {
    let wanted = [0.0, 0.1, -0.3].map(|a| a * G);
    let near = |read: &[f64]| read.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-14);
    for text in [
        "time_s,acceleration_g\n0,0\n0.02,0.1\n0.04,-0.3\n",
        "Time (s);acc (g)\n0,00;0\n0,02;0,1\n0,04;-0,3\n",
        "t\ta [cm/s2]\n0.00\t0\n0.02\t98.0665\n0.04\t-294.1995\n",
        "t acceleration_m_s2\n0.00 0\n0.02 0.980665\n0.04 -2.941995\n",
    ] {
        let read = read_component(text.as_bytes(), &MotionOptions::default()).unwrap();
        assert!(
            near(&read.acceleration_m_s2) && read.time_step_s == 0.02,
            "{text} {read:?}"
        );
    }
    let bare = read_component(b"0.00 0\n0.02 0.1\n0.04 -0.3\n", &in_unit(Unit::Gravity)).unwrap();
    assert!(near(&bare.acceleration_m_s2) && bare.time_step_s == 0.02);
    let told = MotionOptions {
        time_step_s: Some(0.02),
        ..in_unit(Unit::Gravity)
    };
    for text in ["0\n0.1\n-0.3\n", "0.00 0\n0.02 0.1\n0.04 -0.3\n"] {
        let read = read_component(text.as_bytes(), &told).unwrap();
        assert!(near(&read.acceleration_m_s2) && read.time_step_s == 0.02);
    }
    let picked = MotionOptions {
        column: Some(Column::Number(3)),
        ..Default::default()
    };
    let read = read_component(b"t,a_g,b_g\n0,1,0\n0.02,1,0.1\n0.04,1,-0.3\n", &picked).unwrap();
    assert!(near(&read.acceleration_m_s2));
}

#[test]
fn exact_components_from_separate_files() {
    let files = [(Component::X, NEW.as_bytes()), (Component::Z, OLD.as_bytes())];
    let refused = read_motion("made", &files, &MotionOptions::default())
        .unwrap_err()
        .to_string();
    assert_eq!(
        refused,
        "the x component has 7 samples, the z 6: if they begin at the same time, cut all to the shortest with \
         lengths = \"shortest\" in [motion.NAME] or --shortest"
    );
    let shortest = MotionOptions {
        lengths: Lengths::Shortest,
        ..Default::default()
    };
    let motion = read_motion("made", &files, &shortest).unwrap();
    assert_eq!((motion.length(), motion.has(Component::Y)), (6, false));
    assert_eq!(motion.component_peak_m_s2(Component::Z), 0.3 * G);
    assert!(matches!(
        motion.history(),
        [
            Processing::Read { .. },
            Processing::Read { .. },
            Processing::Cut { .. }
        ]
    ));
    let coarse = OLD.replace("0.0100", "0.0200");
    let files = [(Component::X, NEW.as_bytes()), (Component::Z, coarse.as_bytes())];
    let refused = read_motion("made", &files, &shortest).unwrap_err().to_string();
    assert!(refused.contains("0.01 s, the z of 0.02 s"), "{refused}");
    let refused = read_motion("made", &[(Component::Y, b"" as &[u8])], &shortest)
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("the y component: the file is empty"),
        "{refused}"
    );
    assert!(
        read_motion("made", &[], &shortest)
            .unwrap_err()
            .to_string()
            .contains("no file")
    );
}

#[test]
fn refuses_a_peak_that_no_earthquake_has() {
    let gal = "0.00 0\n0.02 33.8\n0.04 -12\n";
    let refused = said(gal, &in_unit(Unit::Gravity));
    assert_eq!(
        refused,
        "the peak is 3.380e1 g, but must be 0.001 to 5 g: is the unit cm/s2 or mg instead of g?; if the motion is truly \
         so, bring it into that range with --factor and back with --scale"
    );
    // the dangerous case: strong shaking that would have no effect
    let g = "0.00 0\n0.02 0.32\n0.04 -0.1\n";
    assert!(said(g, &in_unit(Unit::Gal)).contains("is the unit g or m/s2 instead of cm/s2?"));
    assert!(said("0.00 0\n0.02 0\n0.04 0\n", &in_unit(Unit::Gravity)).contains("check the unit g"));
    let allowed = MotionOptions {
        plausible_peak_m_s2: 0.0..=40.0 * G,
        ..in_unit(Unit::Gravity)
    };
    assert!(read_component(gal.as_bytes(), &allowed).is_ok());
}

#[test]
fn refuses_an_at2_that_is_not_whole() {
    let plain = MotionOptions::default();
    let short = NEW.replace("NPTS=      7", "NPTS=   4000");
    assert_eq!(
        said(&short, &plain),
        "the header says 4000 samples, but 7 follow: the file was cut short or edited; download it again"
    );
    assert_eq!(
        said(&NEW.replace(".3000000E-01", "********"), &plain),
        "line 5: \"********\" is not a finite number: correct it, or download the file again"
    );
    assert!(said(&NEW.replace(".3000000E-01", "NaN"), &plain).contains("line 5: \"NaN\""));
    assert!(
        said(&NEW.replace(".0100 SEC", "UNKNOWN"), &plain)
            .starts_with("line 4: \"NPTS=      7, DT=   UNKNOWN")
    );
    assert!(said(&NEW.replace("7, DT", "-7, DT"), &plain).contains("does not give NPTS and DT"));
    assert!(said(&NEW.replace(".0100 SEC", "0 SEC"), &plain).contains("does not give NPTS and DT"));
    let velocity = NEW.replace(
        "ACCELERATION TIME SERIES IN UNITS OF G",
        "VELOCITY TIME SERIES IN UNITS OF CM/S",
    );
    assert!(said(&velocity, &plain).starts_with("line 3: the file holds velocities"));
    let strange = NEW.replace("UNITS OF G", "UNITS OF FURLONGS");
    assert!(said(&strange, &plain).contains("\"FURLONGS\" is not known"));
    assert!(read_component(strange.as_bytes(), &in_unit(Unit::Gravity)).is_ok());
}

#[test]
fn refuses_what_is_not_known_or_contradicts() {
    let bare = "0.00 0\n0.02 0.1\n0.04 -0.3\n";
    let plain = MotionOptions::default();
    assert_eq!(
        said(bare, &plain),
        "the unit of the accelerations is not known: the file does not say it; give unit = g, gal or m/s2"
    );
    assert_eq!(
        said(NEW, &in_unit(Unit::Gal)),
        "unit is \"cm/s2\", but the file says \"g\": correct it, or leave it out"
    );
    assert!(said(bare, &in_unit(Unit::Millimetre)).contains("\"mm\" is not one of acceleration"));
    assert!(said("time,v (cm/s)\n0,0\n0.02,1\n0.04,2.5\n", &plain).contains("not one of acceleration"));
    assert!(
        said("time,a_g,b_g\n0,0,1\n0.02,1,0\n0.04,2.5,1\n", &plain)
            .contains("the file has 2 channels (a_g, b_g): say which is which")
    );
    let step = |step| MotionOptions {
        time_step_s: Some(step),
        ..Default::default()
    };
    assert_eq!(
        said(NEW, &step(0.02)),
        "sample_step_s (--sample-step) is 0.02 s, but the file says 0.01 s: correct it, or leave it out"
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(said(NEW, &step(bad)).contains("positive number of seconds"));
    }
    assert!(said("0\n0.1\n-0.3\n", &in_unit(Unit::Gravity)).contains("time step is not known"));
}

/// In the format of a Korean network: one file, columns in any order, the unit in the header.
const STATION: &str = "UD(gal),time,NS (cm/s^2),EW[gal]\n0,0,0,0\n-5,0.01,20,30\n4,0.02,-10,-7\n";

#[test]
fn exact_components_from_columns_of_one_file() {
    for text in [
        STATION.to_owned(),
        STATION.replace(
            "UD(gal),time,NS (cm/s^2),EW[gal]",
            "상하(gal),시간,남북(gal),동서(gal)",
        ),
        STATION.replace(
            "UD(gal),time,NS (cm/s^2),EW[gal]",
            "HNZ (gal),time,HNN (gal),HNE (gal)",
        ),
    ] {
        let names: Vec<String> = read_channels(text.as_bytes(), &MotionOptions::default())
            .unwrap()
            .into_iter()
            .map(|channel| channel.name)
            .collect();
        let bare = |at: usize| names[at].split(['(', '[']).next().unwrap().trim().to_lowercase();
        let [up, north, east] = [bare(0), bare(1), bare(2)];
        let source = |component, channel| ComponentSource {
            component,
            bytes: text.as_bytes(),
            channel: Some(channel),
        };
        let sources = [
            source(Component::X, east.as_str()),
            source(Component::Y, &north),
            source(Component::Z, &up),
        ];
        let motion = read_columns_as("station", &sources, &MotionOptions::default()).unwrap();
        let turned = read_oriented("station", &[text.as_bytes()], 90.0, &MotionOptions::default()).unwrap();
        for motion in [motion, turned] {
            for (component, gal) in [
                (Component::X, [0.0, 30.0, -7.0]),
                (Component::Y, [0.0, 20.0, -10.0]),
                (Component::Z, [0.0, -5.0, 4.0]),
            ] {
                assert_eq!(
                    motion.acceleration_m_s2(component),
                    gal.map(|a| a * 0.01),
                    "{text} {component}"
                );
            }
            assert_eq!(motion.time_step_s(), 0.01);
        }
    }
}

#[test]
fn refuses_columns_that_are_not_there_are_meant_twice_or_contradict() {
    let of = |text: &str, channel: &str, options: MotionOptions| {
        let told = MotionOptions {
            channel: Some(channel.to_owned()),
            ..options
        };
        said(text, &told)
    };
    let plain = MotionOptions::default();
    let missing = of(STATION, "Z", plain.clone());
    assert!(
        missing.contains("\"Z\"") && missing.contains("EW[gal]"),
        "{missing}"
    );
    let twice = of(&STATION.replace("UD(gal)", "EW (gal)"), "EW", plain.clone());
    assert!(
        twice.contains("2 channels (EW (gal), EW[gal]): say which is which"),
        "{twice}"
    );
    assert_eq!(
        of(STATION, "EW", in_unit(Unit::Gravity)),
        "unit is \"g\", but the file says \"cm/s2\": correct it, or leave it out"
    );
    let differ = read_channels(STATION.replace("UD(gal)", "UD(g)").as_bytes(), &plain)
        .unwrap_err()
        .to_string();
    assert!(differ.contains("UD(g)"), "{differ}");
    let bare = read_channels(b"time,EW,NS\n0,0,0\n0.01,1,2\n0.02,-2,1\n", &plain)
        .unwrap_err()
        .to_string();
    assert!(
        bare.starts_with("column \"EW\": the unit of the accelerations is not known"),
        "{bare}"
    );
    let as_xy = |x, y| {
        let source = |component, channel| ComponentSource {
            component,
            bytes: STATION.as_bytes(),
            channel: Some(channel),
        };
        let sources = [source(Component::X, x), source(Component::Y, y)];
        read_columns_as("station", &sources, &MotionOptions::default())
            .unwrap_err()
            .to_string()
    };
    let vertical = as_xy("EW", "UD");
    assert!(
        vertical.contains("is vertical by its name, but is given as y"),
        "{vertical}"
    );
    let both = as_xy("EW", "EW");
    assert!(both.contains("is given as x and as y"), "{both}");
    let x = read_oriented(
        "",
        &[b"time,x_m_s2,y_m_s2\n0,0,0\n0.01,1,2\n0.02,-2,1\n"],
        90.0,
        &plain,
    )
    .unwrap_err()
    .to_string();
    assert!(x.contains("x_m_s2"), "{x}");
}

#[test]
fn exact_a_workbook_holds_the_same_station() {
    let mut book = rust_xlsxwriter::Workbook::new();
    let sheet = book.add_worksheet();
    for (row, line) in STATION.lines().enumerate() {
        for (column, cell) in line.split(',').enumerate() {
            let (row, column) = (u32::try_from(row).unwrap(), u16::try_from(column).unwrap());
            match cell.parse::<f64>() {
                Ok(number) => sheet.write_number(row, column, number).unwrap(),
                Err(_) => sheet.write_string(row, column, cell).unwrap(),
            };
        }
    }
    let bytes = book.save_to_buffer().unwrap();
    let plain = MotionOptions::default();
    assert_eq!(
        read_channels(&bytes, &plain).unwrap(),
        read_channels(STATION.as_bytes(), &plain).unwrap()
    );
    // Excel adds empty sheets
    let second = book.add_worksheet();
    second.write_number(0, 0, 1.0).unwrap();
    let refused = read_channels(&book.save_to_buffer().unwrap(), &plain)
        .unwrap_err()
        .to_string();
    assert!(refused.contains("Sheet1, Sheet2"), "{refused}");
}

#[test]
fn refuses_codes_for_missing_values_with_their_line() {
    let table = |code: &str| {
        let row = |k: usize| {
            let a = 200.0 * (k as f64 / 5.0).sin();
            match k == 30 {
                true => format!("{:.2},{code}\n", k as f64 / 100.0),
                false => format!("{:.2},{a:.3}\n", k as f64 / 100.0),
            }
        };
        "time(s),a(gal)\n".to_owned() + &(0..200).map(row).collect::<String>()
    };
    let plain = MotionOptions::default();
    assert!(read_component(table("-55.883").as_bytes(), &plain).is_ok());
    let code = read_component(table("-999").as_bytes(), &plain)
        .unwrap_err()
        .to_string();
    assert!(
        code.starts_with("line 32: the sample at 0.3 s is -999, a code for a missing value"),
        "{code}"
    );
    let spike = read_component(table("850.25").as_bytes(), &plain)
        .unwrap_err()
        .to_string();
    assert!(
        spike.starts_with("line 32: the sample at 0.3 s is 850.25, alone beyond all others"),
        "{spike}"
    );
}

#[test]
fn refuses_columns_of_velocity_and_displacement() {
    let text = b"time,acc,vel,disp\n0,0,0,0\n0.01,10,1,0.1\n0.02,-20,2,0.2\n";
    let of = |name: &str| {
        let options = MotionOptions {
            channel: Some(name.to_owned()),
            ..in_unit(Unit::Gal)
        };
        read_component(text, &options).map_err(|error| error.to_string())
    };
    assert!(of("acc").is_ok());
    assert!(of("vel").unwrap_err().contains("velocities, not accelerations"));
    assert!(
        of("disp")
            .unwrap_err()
            .contains("displacements, not accelerations")
    );
    let text = b"time(s),acc(cm/s2),vel(cm/s),disp(cm)\n0,0,0,0\n0.01,10,1,0.1\n0.02,-20,2,0.2\n";
    let differ = read_channels(text, &MotionOptions::default())
        .unwrap_err()
        .to_string();
    assert!(differ.contains("say which columns are accelerations"), "{differ}");
}

/// Stamps that scatter or are rounded name the key of a motion, and with it the motion is read.
#[test]
fn holds_a_given_step_reads_stamps_that_scatter() {
    let with = |stamps: &dyn Fn(usize) -> f64, decimals: usize| {
        let lines = (0..200).map(|i| format!("{:.decimals$},{}\n", stamps(i), (i as f64 * 0.7).sin()));
        format!("time,a (gal)\n{}", lines.collect::<String>())
    };
    let step = MotionOptions {
        time_step_s: Some(0.01),
        ..Default::default()
    };
    // one stamp is missing, and stamps that scatter by a tenth of a step
    let missing = with(&|i| 0.01 * (i + usize::from(i > 99)) as f64, 2);
    let scattered = with(&|i| 0.01 * i as f64 + 0.001 * (i % 2) as f64, 4);
    for text in [missing, scattered] {
        let fault = said(&text, &MotionOptions::default());
        assert!(fault.contains("sample_step_s (--sample-step)"), "{fault}");
        assert!(!fault.contains("sampling_rate"), "{fault}");
        let read = read_component(text.as_bytes(), &step).unwrap();
        assert_eq!((read.time_step_s, read.acceleration_m_s2.len()), (0.01, 200));
    }
    // but not with another step in the mean
    let two_steps = with(&|i| 0.01 * (i + i.saturating_sub(100)) as f64, 2);
    let fault = said(&two_steps, &step);
    assert!(
        fault.contains("sample_step_s (--sample-step) is 0.01 s, but the file says 0.014"),
        "{fault}"
    );
}
