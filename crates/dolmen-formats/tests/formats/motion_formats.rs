// SOURCE     tests/data/motions: El Centro 1940 NS, its first 240 samples in millionths of g, written by ObsPy 1.5.1 in each encoding
//            (bench/formats/make.py). tests/data/peers.csv: what ObsPy 1.5.1 and gmprocess 2.8.0 read from measured files.
// GOAL       Every format of motions is told from its content and read to the bit; what is damaged is refused.
// TOLERANCE  none for integers; the last bits of a sum of doubles otherwise.

use dolmen::signal::{Component, Processing};
use dolmen_formats::motions::{
    ComponentReading, MotionError, MotionFormat, MotionOptions, Orientation, StatedPeak, read_channels,
    read_component, read_motion, read_oriented,
};
use dolmen_formats::records::Unit;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/motions")
}

fn written(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap()
}

/// Numbers kept as the file prints them.
fn as_printed() -> MotionOptions {
    MotionOptions {
        unit: Some(Unit::MetrePerSecondSquared),
        plausible_peak_m_s2: 0.0..=f64::MAX,
        ..Default::default()
    }
}

fn said(bytes: &[u8], options: &MotionOptions) -> String {
    read_channels(bytes, options).unwrap_err().to_string()
}

/// The first 240 samples of El Centro 1940 NS in millionths of g.
fn millionths() -> Vec<f64> {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let g = text
        .lines()
        .skip(1)
        .take(240)
        .map(|line| line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    g.map(|g| (g * 1e6).round_ties_even()).collect()
}

#[test]
fn agrees_with_obspy_in_every_encoding() {
    let wanted = millionths();
    for name in [
        "steim1_big.mseed",
        "steim1_little.mseed",
        "steim2_big.mseed",
        "steim2_little.mseed",
        "int32_big.mseed",
        "int32_little.mseed",
        "float32_big.mseed",
        "float32_little.mseed",
        "float64_big.mseed",
        "float64_little.mseed",
        "big.sac",
        "little.sac",
        "text.sac",
    ] {
        let read = read_component(&written(name), &as_printed()).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(read.acceleration_m_s2, wanted, "{name}");
        assert_eq!(
            (read.time_step_s, read.orientation),
            (0.02, Some(Orientation::Horizontal { azimuth_deg: 0.0 })),
            "{name}"
        );
        // 19 May 1940 04:36:41.25 UTC, by Python's datetime
        assert!(
            (read.begins_s.unwrap() + 934_744_998.75).abs() < 1e-4,
            "{name}: {:?}",
            read.begins_s
        );
        assert_eq!(
            read.name,
            if name.ends_with("mseed") {
                "US.ELC..HNN"
            } else {
                "US.ELC.HNN"
            }
        );
    }
    let short = read_component(&written("int16_big.mseed"), &as_printed()).unwrap();
    let thousandths: Vec<f64> = wanted.iter().map(|a| (a / 1e3).round_ties_even()).collect();
    assert_eq!(short.acceleration_m_s2, thousandths);
}

#[test]
fn exact_counts_become_accelerations_by_a_factor() {
    let told = MotionOptions {
        unit: Some(Unit::Gravity),
        factor: 1e-6,
        ..Default::default()
    };
    let motion = read_motion(
        "El Centro",
        &[(Component::X, &written("steim2_big.mseed"))],
        &told,
    )
    .unwrap();
    assert!((motion.component_peak_m_s2(Component::X) / 9.80665 - 0.31882).abs() < 1e-12);
    assert!(motion.history().contains(&Processing::Scaled { factor: 1e-6 }));
    let refused = said(&written("steim2_big.mseed"), &MotionOptions::default());
    assert!(
        refused.starts_with("the unit of the accelerations is not known"),
        "{refused}"
    );
    let counts = MotionOptions {
        unit: Some(Unit::Gravity),
        ..Default::default()
    };
    assert!(said(&written("steim2_big.mseed"), &counts).starts_with("the peak is 3.188e5 g"));
}

#[test]
fn exact_channels_are_named_and_turned() {
    let bytes = written("two_channels.mseed");
    let refused = read_component(&bytes, &as_printed()).unwrap_err().to_string();
    assert_eq!(
        refused,
        "the file has 2 channels (US.ELC..HNN, US.ELC..HNE): name one, or give its number"
    );
    for name in ["us.elc..hne", "2"] {
        let named = MotionOptions {
            channel: Some(name.to_owned()),
            ..as_printed()
        };
        assert_eq!(read_component(&bytes, &named).unwrap().name, "US.ELC..HNE");
    }
    let north = millionths();
    let east: Vec<f64> = north.iter().map(|a| (-a / 2.0).floor()).collect(); // as numpy divides
    let motion = read_oriented("", &[&bytes], 90.0, &as_printed()).unwrap();
    assert_eq!(motion.acceleration_m_s2(Component::X), east);
    assert_eq!(motion.acceleration_m_s2(Component::Y), north);
    let turned = read_oriented("", &[&bytes], 30.0, &as_printed()).unwrap();
    let (sin, cos) = 30f64.to_radians().sin_cos();
    for (i, (x, y)) in turned
        .acceleration_m_s2(Component::X)
        .iter()
        .zip(turned.acceleration_m_s2(Component::Y))
        .enumerate()
    {
        assert!(
            (x - (north[i] * cos + east[i] * sin)).abs() < 1e-9
                && (y - (north[i] * sin - east[i] * cos)).abs() < 1e-9
        );
    }
    let refused = read_oriented("", &[&written("little.sac")], 0.0, &as_printed())
        .unwrap_err()
        .to_string();
    assert!(
        refused.starts_with("there are 1 horizontal and 0 vertical channels"),
        "{refused}"
    );
    let twice = read_oriented(
        "",
        &[&written("little.sac"), &written("big.sac")],
        0.0,
        &as_printed(),
    )
    .unwrap_err();
    assert!(
        twice
            .to_string()
            .contains("point to 0° and 0°, less than 30° apart")
    );
}

/// The header is that of AKT013, 11 August 1996 03:12; the numbers are made.
fn knet(direction: &str, peak: &str, numbers: &str) -> String {
    format!(
        "Origin Time       1996/08/11 03:12:00\nLat.              38.920\nLong.             140.630\nDepth. (km)       7\n\
         Mag.              5.9\nStation Code      AKT013\nStation Lat.      39.6069\nStation Long.     140.3213\n\
         Station Height(m) 34\nRecord Time       1996/08/11 03:12:39\nSampling Freq(Hz) 4Hz\nDuration Time(s)  2\n\
         Dir.              {direction}\nScale Factor      2000(gal)/8388608\nMax. Acc. (gal)   {peak}\n\
         Last Correction   1996/08/11 03:00:00\nMemo.             \n{numbers}\n"
    )
}

const KNET: &str = "  -18205   -17995   -17836   -17940   -18086   -18136   -18047 \n  -17988";

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

fn tiny() -> MotionOptions {
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

/// The headers are those of AK.BMR, Point MacKenzie 2018, and of a demonstration file of USGS, shortened; the numbers are made.
fn cosmos(units: &str, azimuth: &str) -> String {
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

/// The header is that of China Lake, 5 July 2019, and of Willow Creek, 13 February 2012; the numbers are made.
fn csmip(version: u8) -> String {
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

/// COSMOS that another program wrote: its peak contradicts its samples, which are a hundred times too large.
fn written_cosmos() -> MotionOptions {
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
    assert!(
        said(text, &MotionOptions::default())
            .contains("2 columns of numbers (x_m_s2, y_g): name the one to read as channel")
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
        read_component(one, &channel("1")).unwrap().acceleration_m_s2,
        [0.0, 0.1, -0.2]
    );
}

fn esm(units: &str) -> String {
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
    // so AFAD's service writes it
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
fn refuses_what_was_cut_at_any_byte() {
    let texts = [
        knet("E-W", "0.046", KNET),
        cosmos("cm/sec2(04)", "340"),
        csmip(1),
        csmip(2),
        esm("cm/s^2"),
    ];
    let mut files: Vec<(String, Vec<u8>)> = texts
        .into_iter()
        .map(|text| ("text".to_owned(), text.into_bytes()))
        .collect();
    for file in std::fs::read_dir(folder()).unwrap() {
        let path = file.unwrap().path();
        files.push((path.display().to_string(), std::fs::read(path).unwrap()));
    }
    let told = as_printed();
    for (name, whole) in files {
        let options = match name.as_str() {
            "text" => tiny(),
            name if name.ends_with("v1c") => written_cosmos(),
            _ => told.clone(),
        };
        let all = read_channels(&whole, &options).unwrap_or_else(|e| panic!("{name}: {e}"));
        let step = (whole.len() / 700).max(1);
        for length in (0..whole.len()).step_by(step) {
            match read_channels(&whole[..length], &options) {
                Err(_) => {}
                // what is left is whole by itself: entire records, entire channels, the last line end, velocities after it
                Ok(part) => assert!(
                    is_beginning(&part, &all),
                    "{name} cut at {length} of {}",
                    whole.len()
                ),
            }
        }
    }
}

/// Whether each channel of `part` is the whole of one of `all`, or its beginning in entire miniSEED records.
fn is_beginning(part: &[ComponentReading], all: &[ComponentReading]) -> bool {
    part.iter().zip(all).all(|(part, all)| {
        let (short, long) = (&part.acceleration_m_s2, &all.acceleration_m_s2);
        let equal = short.len() == long.len() || part.format == MotionFormat::MiniSeed;
        equal && long.starts_with(&short[..short.len() - 1])
    })
}

#[test]
fn refuses_damaged_miniseed_and_sac() {
    let whole = written("steim2_big.mseed");
    let mut damaged = whole.clone();
    damaged[100] ^= 1; // one difference
    assert!(said(&damaged, &as_printed()).contains("the last sample unpacked is not the one"));
    let mut gap = whole.clone();
    gap[512 + 26] += 1; // the second record one second later
    let refused = said(&gap, &as_printed());
    assert!(refused.contains("there is a gap or an overlap"), "{refused}");
    let mut coded = whole.clone();
    coded[52] = 30;
    assert!(matches!(
        read_channels(&coded, &as_printed()),
        Err(MotionError::Encoding { encoding: 30, .. })
    ));
    let sac = written("little.sac");
    assert!(
        said(&sac[..900], &as_printed()).starts_with("the sac file has 900 bytes, but its header says 1592")
    );
    let mut uneven = sac.clone();
    uneven[4 * 105] = 0;
    assert!(said(&uneven, &as_printed()).contains("LEVEN must be 1"));
    let mut velocity = sac.clone();
    velocity[4 * 86] = 7;
    velocity[4 * 86 + 1..4 * 87].fill(0);
    assert!(said(&velocity, &as_printed()).contains("the file holds velocities"));
}

// Measured files of other packages, which scripts/data --formats fetches (scripts/test does, if they are not there): none of them may
// be given on with this repository. A test that compares nothing would hold nothing, so it fails without them.
#[test]
fn agrees_with_obspy_and_gmprocess_on_measured_files() {
    let cache = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cache/formats");
    let mut compared = 0;
    let mut before = String::new();
    let mut channel = 0;
    for line in include_str!("../data/peers.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        channel = if cells[0] == before { channel + 1 } else { 0 };
        before = cells[0].to_owned();
        let bytes = std::fs::read(cache.join(cells[0]))
            .unwrap_or_else(|_| panic!("{} is not there: run scripts/data --formats first", cells[0]));
        let is_text = cells[0].ends_with(".v1") || cells[0].ends_with(".RAW") || cells[0].ends_with(".knet");
        let options = if is_text { tiny() } else { as_printed() };
        let read = read_channels(&bytes, &options).unwrap_or_else(|e| panic!("{}: {e}", cells[0]));
        holds_numbers(&read[channel], &cells);
        compared += 1;
    }
    assert_eq!(compared, 38);
}

fn holds_numbers(read: &ComponentReading, cells: &[&str]) {
    let number = |at: usize| cells[at].parse::<f64>().unwrap();
    let n = number(3);
    // K-NET: ObsPy gives the counts, 2000 gal / 8388608 each, with their mean; CSMIP: gmprocess gives cm/s²
    let (scale, mean) = match read.format {
        MotionFormat::KNet => (20.0 / 8388608.0, number(7) / n),
        MotionFormat::Csmip => (0.01, 0.0),
        _ => (1.0, 0.0),
    };
    let a = &read.acceleration_m_s2;
    assert_eq!(a.len() as f64, n, "{cells:?}");
    assert!(
        (1.0 / read.time_step_s / number(4) - 1.0).abs() < 1e-6,
        "{cells:?}: {}",
        read.time_step_s
    );
    let peak = a.iter().fold(0.0, |peak, a| f64::max(peak, a.abs()));
    // ObsPy reads the text of SAC as 32-bit numbers, Dolmen as it is printed
    let within = if read.format == MotionFormat::SacText {
        1e-7
    } else {
        1e-9
    } * peak;
    let near = |got: f64, wanted: f64| {
        assert!(
            (got - scale * wanted).abs() <= within,
            "{cells:?}: {got} {}",
            scale * wanted
        );
    };
    near(a[0], number(5) - mean);
    near(a[a.len() - 1], number(6) - mean);
    near(a.iter().sum::<f64>() / n, number(7) / n - mean);
    if read.format != MotionFormat::KNet {
        near(peak, number(8));
    }
    if read.format == MotionFormat::Csmip && matches!(read.orientation, Some(Orientation::Horizontal { .. }))
    {
        assert_eq!(
            read.orientation,
            Some(Orientation::Horizontal {
                azimuth_deg: number(2).rem_euclid(360.0)
            })
        );
    }
}
