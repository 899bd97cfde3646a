// SOURCE     Files in the formats of K-NET, COSMOS, CSMIP and ESM: headers of real files with made-up numbers; a COSMOS file from
//            gmprocess 2.8.0.
// GOAL       Channels, units and offsets are read to the bit; damaged files are refused.
// TOLERANCE  none for integers; the last bits of a sum of doubles otherwise.

use super::motion_formats::{millionths, said, written};
use dolmen::signal::Component;
use dolmen_records::motions::{
    MotionFormat, MotionOptions, Orientation, ReadFor, StatedPeak, read_channels, read_component,
    read_motion, read_oriented,
};
use dolmen_records::records::Unit;

/// The header is that of AKT013, 11 August 1996 03:12; the numbers are made up.
pub(super) fn knet(direction: &str, peak: &str, numbers: &str) -> String {
    format!(
        "Origin Time       1996/08/11 03:12:00\nLat.              38.920\nLong.             140.630\nDepth. (km)       7\n\
         Mag.              5.9\nStation Code      AKT013\nStation Lat.      39.6069\nStation Long.     140.3213\n\
         Station Height(m) 34\nRecord Time       1996/08/11 03:12:39\nSampling Freq(Hz) 4Hz\nDuration Time(s)  2\n\
         Dir.              {direction}\nScale Factor      2000(gal)/8388608\nMax. Acc. (gal)   {peak}\n\
         Last Correction   1996/08/11 03:00:00\nMemo.             \n{numbers}\n"
    )
}

pub(super) const KNET: &str = "  -18205   -17995   -17836   -17940   -18086   -18136   -18047 \n  -17988";

#[test]
fn exact_knet_without_its_offset() {
    let read = &read_channels(knet("E-W", "0.046", KNET).as_bytes(), &tiny()).unwrap()[0];
    let counts = [
        -18205.0, -17995.0, -17836.0, -17940.0, -18086.0, -18136.0, -18047.0, -17988.0,
    ];
    let mean = counts.iter().sum::<f64>() / 8.0;
    for (a, count) in read.acceleration_m_s2.iter().zip(counts) {
        assert!((a - (count - mean) * 2000.0 / 8388608.0 / 100.0).abs() < 1e-15);
    }
    assert!((read.mean_subtracted_m_s2.unwrap() - mean * 20.0 / 8388608.0).abs() < 1e-15);
    assert_eq!(
        (read.format, read.time_step_s, read.name.as_str()),
        (MotionFormat::KNet, 0.25, "AKT013 E-W")
    );
    // 1996/08/11 03:12:39 in Japan, 15 s late: 10 August, 18:12:24 UTC, by the rule of ObsPy 1.5.1
    assert_eq!(read.begins_s, Some(839_700_744.0));
    assert_eq!(
        read.orientation,
        Some(Orientation::Horizontal { azimuth_deg: 90.0 })
    );
    let borehole = &read_channels(knet("3", "0.046", KNET).as_bytes(), &tiny()).unwrap()[0];
    assert_eq!(
        (borehole.name.as_str(), borehole.orientation),
        ("AKT013 U-D borehole", Some(Orientation::Up))
    );
}

pub(super) fn tiny() -> MotionOptions {
    MotionOptions {
        plausible_peak_m_s2: 0.0..=100.0,
        ..Default::default()
    }
}

#[test]
fn refuses_knet_that_is_not_whole() {
    let plain = tiny();
    let refused = said(knet("E-W", "4.383", KNET).as_bytes(), &plain);
    assert!(refused.starts_with("channel \"AKT013 E-W\": the header says that the peak is 4.383 cm/s2, but that of the samples is 0.04"), "{refused}");
    let ignore = MotionOptions {
        stated_peak: StatedPeak::Ignore,
        ..tiny()
    };
    assert!(read_channels(knet("E-W", "4.383", KNET).as_bytes(), &ignore).is_ok());
    let cut = knet("E-W", "0.046", "-18205 -17995");
    assert!(said(cut.as_bytes(), &plain).starts_with("the header says 8 samples, but 2 follow"));
    let scale = knet("E-W", "0.046", KNET).replace("2000(gal)", "2000(cm)");
    assert!(
        said(scale.as_bytes(), &plain).starts_with("line 14: \"2000(cm)/8388608\" is not a scale such as")
    );
    let other = knet("E-W", "0.046", KNET);
    let (north, east) = (knet("N-S", "0.046", KNET), other.replace("03:12:39", "03:12:41"));
    let refused = read_oriented("", &[north.as_bytes(), east.as_bytes()], 90.0, &plain)
        .unwrap_err()
        .to_string();
    assert_eq!(
        refused,
        "the y component begins 2 s after the x: cut both to one time before"
    );
}

/// The headers are those of AK.BMR, Point MacKenzie 2018, and of a demonstration file of USGS, shortened; the numbers are made up.
pub(super) fn cosmos(units: &str, azimuth: &str) -> String {
    let mut integers: Vec<String> = vec!["    -999".to_owned(); 100];
    integers[53] = format!("{azimuth:>8}");
    let mut reals: Vec<String> = vec!["    -999.000000".to_owned(); 100];
    reals[61] = "       5.000000".to_owned();
    reals[63] = "     -61.962000".to_owned();
    let rows =
        |cells: &[String], n: usize| cells.chunks(n).map(|row| row.concat() + "\n").collect::<String>();
    format!(
        "Corrected acceleration    (Format v01.20 with 13 text lines)\nRecord of Point MacKenzie Earthquake\nHypocenter\nOrigin\n\
         Statn No: 37-000011 Code:AK-BMR     UAF  Bremner River, AK, USA\n6\n7\n8\n9\n10\n11\n12\n13\n\
         \x20100 Integer-header values follow on  10 lines, Format= (10I8)\n{}\
         \x20100 Real-header values follow on  20 lines, Format= (5F15.6)\n{}\
         \x20  1 Comment line(s) follow, each starting with a \"|\":\n| nothing\n\
         \x20      5 acceleration pts, approx   0 secs, units={units},Format=(3F10.5)\n\
         \x20 -1.00000  20.50000 -61.96200\n   3.00000   0.00001\nEnd-of-data for Chan  1 acceleration\n\
         \x20      2 velocity pts,     approx   0 secs, units=cm/sec(05),Format=(3F10.5)\n   1.00000   2.00000\nEnd-of-data for Chan  1 velocity\n",
        rows(&integers, 10),
        rows(&reals, 5),
    )
}

#[test]
fn exact_cosmos_of_several_channels() {
    let text = cosmos("cm/sec2(04)", "340") + &cosmos("cm/sec2(04)", "400");
    let read = read_channels(text.as_bytes(), &MotionOptions::default()).unwrap();
    assert_eq!(read.len(), 2);
    let wanted = [-1.0, 20.5, -61.962, 3.0, 0.00001].map(|a| a * 0.01);
    assert_eq!(read[0].acceleration_m_s2, wanted);
    assert_eq!((read[0].time_step_s, read[0].unit), (0.005, Unit::Gal));
    assert_eq!(
        read[0].orientation,
        Some(Orientation::Horizontal { azimuth_deg: 340.0 })
    );
    assert_eq!(read[1].orientation, Some(Orientation::Up));
    assert!(read[0].title.contains("Bremner River"), "{}", read[0].title);
    let plain = MotionOptions::default();
    let whole = cosmos("cm/sec2(04)", "340");
    assert!(said(cosmos("counts(50)", "340").as_bytes(), &plain).contains("raw counts of the recorder (V0)"));
    assert!(
        said(
            whole
                .replace("20.50000 -61.96200\n", "20.50000 -51.96200\n")
                .as_bytes(),
            &plain
        )
        .contains("the header says that the peak is 61.962")
    );
    assert!(
        said(whole.replace("       5 acc", "       6 acc").as_bytes(), &plain)
            .starts_with("the header says 6 samples, but 5 follow")
    );
    assert!(
        said(whole.replace("       5 acc", "       4 acc").as_bytes(), &plain)
            .starts_with("the header says 4 samples, but 5 follow")
    );
    assert!(
        said(whole.replace("units=cm", "units=furlong").as_bytes(), &plain)
            .contains("the unit \"furlong/sec2\" is not known")
    );
}

/// The header is that of China Lake, 5 July 2019, and of Willow Creek, 13 February 2012; the numbers are made up.
pub(super) fn csmip(version: u8) -> String {
    let head = "Uncorrected Accelerogram Data             Processed: 07/06/19, CGS  ciclc--f    \n\
                Station Id. CLC     35.816N, 117.598W    Q330    s/n 4323  (3 Chns of  3 at Sta)\nChan  1:  90 Deg\n";
    if version == 1 {
        format!(
            "{head}     3 Accelerogram points at 100 pts/sec in units of g.       Format: (2f9.6)  \n -.000011 -.500000\n  .344250\n/&\n"
        )
    } else {
        format!(
            "Corrected accelerogram   89146-L2500-12044.02\n{head}     3 points of accel data equally spaced at  .005 sec, in cm/sec2. (2f10.6)    \n\
             \x20 -.00001077.280340\n   .000001\n     1 points of veloc data equally spaced at  .005 sec, in cm/sec. (2f10.6)    \n   .100000\n"
        )
    }
}

#[test]
fn exact_csmip_of_both_versions() {
    let first = &read_channels(csmip(1).as_bytes(), &MotionOptions::default()).unwrap()[0];
    assert_eq!(
        (first.format, first.name.as_str(), first.time_step_s),
        (MotionFormat::Csmip, "Chan 1", 0.01)
    );
    assert_eq!(
        first.acceleration_m_s2,
        [-0.000011, -0.5, 0.34425].map(|a| a * 9.80665)
    );
    assert_eq!(
        first.orientation,
        Some(Orientation::Horizontal { azimuth_deg: 90.0 })
    );
    let second = read_channels(csmip(2).as_bytes(), &MotionOptions::default()).unwrap();
    assert_eq!((second.len(), second[0].time_step_s), (1, 0.005));
    assert_eq!(
        second[0].acceleration_m_s2,
        [-0.00001, 77.28034, 0.000001].map(|a| a * 0.01)
    );
    let cut = csmip(1).replace("  .344250\n/&\n", "");
    assert!(
        said(cut.as_bytes(), &MotionOptions::default())
            .starts_with("the header says 3 samples, but 2 follow")
    );
}

/// A COSMOS file from another program, whose peak contradicts its samples: they are a hundred times too large.
pub(super) fn written_cosmos() -> MotionOptions {
    MotionOptions {
        stated_peak: StatedPeak::Ignore,
        plausible_peak_m_s2: 0.0..=f64::MAX,
        ..Default::default()
    }
}

#[test]
fn agrees_with_the_cosmos_of_gmprocess() {
    let bytes = written("one_channel.v1c");
    let read = read_component(&bytes, &written_cosmos()).unwrap();
    let counts = millionths();
    let mean = counts.iter().sum::<f64>() / counts.len() as f64;
    assert_eq!(read.acceleration_m_s2.len(), counts.len());
    for (found, count) in read.acceleration_m_s2.iter().zip(&counts) {
        // seven digits are printed
        assert!(
            (found - (count - mean)).abs() <= 5.1e-7 * found.abs(),
            "{found} {count}"
        );
    }
    assert_eq!(
        (read.format, read.time_step_s, read.orientation),
        (
            MotionFormat::Cosmos,
            0.02,
            Some(Orientation::Horizontal { azimuth_deg: 180.0 })
        )
    );
    let refused = MotionOptions {
        stated_peak: StatedPeak::Check,
        ..written_cosmos()
    };
    assert!(
        said(&bytes, &refused).contains("the header says that the peak is 318820 cm/s2"),
        "{}",
        said(&bytes, &refused)
    );
}

#[test]
fn exact_a_channel_is_also_a_column_by_its_name() {
    let text = b"time_s,x_m_s2,y_g\n0,0,0\n0.02,0.1,0.1\n0.04,-0.2,0.3\n";
    let refused = read_component(text, &MotionOptions::default())
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("the file has 2 channels (x_m_s2, y_g): say which is which"),
        "{refused}"
    );
    let each = read_channels(text, &MotionOptions::default()).unwrap();
    assert_eq!(
        each[1].acceleration_m_s2[2],
        0.3 * 9.80665,
        "each in the unit of its own name"
    );
    let channel = |name: &str| MotionOptions {
        channel: Some(name.to_owned()),
        ..Default::default()
    };
    let read = |name: &str| read_component(text, &channel(name)).unwrap().acceleration_m_s2;
    assert_eq!(read("x_m_s2"), [0.0, 0.1, -0.2]);
    assert_eq!(read("y_g"), [0.0, 0.1, 0.3].map(|a| a * 9.80665));
    assert!(said(text, &channel("z")).contains('z'));
    let one = b"time_s,x_m_s2\n0,0\n0.02,0.1\n0.04,-0.2\n";
    assert_eq!(
        read_component(one, &channel("2")).unwrap().acceleration_m_s2,
        [0.0, 0.1, -0.2]
    );
}

pub(super) fn esm(units: &str) -> String {
    format!(
        "EVENT_NAME: GREECE\nEVENT_DATE_YYYYMMDD: 20190728\nNETWORK: HI\nSTATION_CODE: ARS1\nSTATION_NAME: Town Hall,Argos\n\
         LATE/NORMAL_TRIGGERED: NT\nDATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20190728_160919.870\nSAMPLING_INTERVAL_S: 0.005000\n\
         NDATA: 4\nSTREAM: HNE\nUNITS: {units}\nPGA_CM/S^2: -3.300022\nDATA_TYPE: ACCELERATION\nUSER5: \n0.000000\n-0.000001\n\
         -3.300022\n1.2\n"
    )
}

#[test]
fn exact_esm() {
    let read = &read_channels(esm("cm/s^2").as_bytes(), &MotionOptions::default()).unwrap()[0];
    assert_eq!(
        read.acceleration_m_s2,
        [0.0, -0.000001, -3.300022, 1.2].map(|a| a * 0.01)
    );
    assert_eq!(
        (read.format, read.name.as_str(), read.time_step_s),
        (MotionFormat::Esm, "HI.ARS1.HNE", 0.005)
    );
    assert_eq!(read.begins_s, Some(1_564_330_159.870));
    let plain = MotionOptions::default();
    // AFAD's service writes this form
    let small = esm("cm/s^2").replace("TYPE: ACCELERATION", "TYPE: Acceleration");
    assert_eq!(read_channels(small.as_bytes(), &plain).unwrap()[0], *read);
    assert!(said(esm("cm/s").as_bytes(), &plain).contains("the unit \"cm/s\" is not known"));
    assert!(
        said(esm("cm/s^2").replace("NDATA: 4", "NDATA: 5").as_bytes(), &plain)
            .contains("says 5 samples, but 4 follow")
    );
    assert!(
        said(
            esm("cm/s^2")
                .replace("TYPE: ACCELERATION", "TYPE: Velocity")
                .as_bytes(),
            &plain
        )
        .contains("holds velocities")
    );
    assert!(
        said(
            esm("cm/s^2").replace("-3.300022\n1.2", "-9.3\n1.2").as_bytes(),
            &plain
        )
        .contains("the peak is 3.300022")
    );
}

#[test]
fn refuses_to_shake_with_vertical_and_borehole_records() {
    let shaking = MotionOptions {
        read_for: ReadFor::Shaking,
        ..tiny()
    };
    let said = |component, direction: &str, options: &MotionOptions| {
        let file = knet(direction, "0.046", KNET);
        read_motion("", &[(component, file.as_bytes())], options).map_err(|error| error.to_string())
    };
    for (component, direction, words) in [
        (Component::X, "U-D", "given as x is vertical"),
        (Component::Y, "6", "given as y is vertical"),
        (Component::X, "1", "given as x is from a borehole"),
        (Component::Z, "3", "given as z is from a borehole"),
    ] {
        let refused = said(component, direction, &shaking).unwrap_err();
        assert!(refused.contains(words), "{direction}: {refused}");
        assert!(said(component, direction, &tiny()).is_ok(), "{direction}"); // to look at
    }
    for (component, direction) in [
        (Component::X, "E-W"),
        (Component::X, "4"),
        (Component::Z, "U-D"),
        (Component::Z, "6"),
    ] {
        assert!(said(component, direction, &shaking).is_ok(), "{direction}");
    }
}

#[test]
fn refuses_components_of_different_stations_or_earthquakes() {
    let east = knet("E-W", "0.046", KNET);
    let north = knet("N-S", "0.046", KNET);
    let pair = |north: &str| {
        let files = [(Component::X, east.as_bytes()), (Component::Y, north.as_bytes())];
        read_motion("", &files, &tiny()).map_err(|error| error.to_string())
    };
    assert!(pair(&north).is_ok());
    let station = pair(&north.replace("AKT013", "AOM004")).unwrap_err();
    assert!(
        station.contains("the x component is of \"AKT013\", the y of \"AOM004\""),
        "{station}"
    );
    let later = north.replace(
        "Origin Time       1996/08/11 03:12:00",
        "Origin Time       1996/08/11 03:11:50",
    );
    let event = pair(&later).unwrap_err();
    assert!(event.contains("one station and one earthquake"), "{event}");
    let peer = |title: &str| format!("PEER\n{title}\nUNITS OF G\nNPTS= 2, DT= .01 SEC\n0.1 -0.3\n");
    let [first, second, up, other] = [
        "Northridge-01, 1/17/1994, Beverly Hills, 90",
        "Northridge-01, 1/17/1994, Beverly Hills, 180",
        "Northridge-01, 1/17/1994, Beverly Hills, UP (USC, 90014)",
        "IMPERIAL VALLEY 5/19/40 0439, EL CENTRO ARRAY #9, 180",
    ]
    .map(peer);
    let combined = |second: &str| {
        let files = [
            (Component::X, first.as_bytes()),
            (Component::Y, second.as_bytes()),
        ];
        read_motion("", &files, &MotionOptions::default()).map_err(|error| error.to_string())
    };
    assert!(combined(&second).is_ok() && combined(&up).is_ok());
    let event = combined(&other).unwrap_err();
    assert!(
        event.contains("of \"Northridge-01\", the y of \"IMPERIAL VALLEY 5/19/40 0439\""),
        "{event}"
    );
}
