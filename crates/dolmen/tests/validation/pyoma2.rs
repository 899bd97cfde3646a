// SOURCE     pyOMA2 1.4.3, functions build_hank (methods "cov" and "dat"), SSI_fast, SSI_poles; run by
//            bench/ssi_cov/agrees.py, which prints the tables below; and pLSCF, rmfd2ac on the same half spectra.
// GOAL       The same poles at every order from the same samples, windows and settings. For "dat", sums of products that
//            follow from each other replace the QR of all stacked samples there.
//
//    600 samples, 3 channels: two resonators under white force + white noise
//
// PARAMETERS 20 Hz, 8 block rows, orders 2 to 12; references: all channels, and the first and the third.
// PUBLISHED  order, frequency (Hz), damping ratio.
// TOLERANCE  1e-6 relative, 1e-6 of damping: rounding of both programs, amplified by the smallest singular values.

use dolmen::modal::{ModalError, Plscf, Pole, Ssi, Subspace, plscf, ssi_cov, ssi_data};
use dolmen::signal::{Channel, Record};

type Table = &'static [(usize, f64, f64)];

const SAMPLES: usize = 600;
const BLOCK_ROWS: usize = 8;
const COV: Table = &[
    (2, 0.8649595858, 0.0621326347),
    (4, 0.8681857151, 0.0601409210),
    (4, 2.0953126394, 0.0217298431),
    (6, 0.8700095085, 0.0603987041),
    (6, 1.9060329324, 0.0517307236),
    (6, 2.0521985379, 0.0202791134),
    (8, 0.8702923954, 0.0606219298),
    (8, 1.9434498847, -0.0717306325),
    (8, 1.9747915965, 0.5488955327),
    (8, 2.0707655565, 0.0333531755),
    (10, 0.8712152715, 0.0564300992),
    (10, 1.9148869592, 0.0039574473),
    (10, 2.0560205650, 0.0172707345),
    (10, 3.8467994257, 0.2227898323),
    (12, 0.8719417232, 0.0563333749),
    (12, 2.0919145066, 0.0309501358),
    (12, 2.1234928191, -0.0984251704),
    (12, 2.3038660014, 0.3552198105),
    (12, 6.1538883275, 0.1458861266),
    (12, 9.0964636373, 0.0773592046),
];
const COV_OF_TWO: Table = &[
    (2, 0.8615040061, 0.0658548479),
    (4, 0.8689324098, 0.0606250607),
    (4, 2.0877336770, 0.0187157940),
    (6, 0.8729939351, 0.0591206974),
    (6, 1.9751776853, 0.0696447582),
    (6, 2.0536206879, 0.0187940017),
    (8, 0.8689157339, 0.0566529281),
    (8, 2.0061107258, 0.2237433023),
    (8, 2.0838457109, 0.0188485298),
    (10, 0.8709322678, 0.0542835489),
    (10, 1.7042975531, 0.1203582735),
    (10, 2.0817462280, 0.0174349810),
    (10, 3.6186326818, 0.2954719462),
    (12, 0.8732729954, 0.0543850700),
    (12, 2.0697354178, 0.0260042347),
    (12, 2.2017474202, -0.1575415683),
    (12, 2.8343628916, 0.2223505623),
    (12, 7.9980450516, 0.0439547937),
];
const DAT: Table = &[
    (2, 0.8665380086, 0.0628131297),
    (4, 0.8656694391, 0.0593492704),
    (4, 2.0969485012, 0.0219254712),
    (6, 0.8709048630, 0.0575340361),
    (6, 1.6395991709, 0.0260241659),
    (6, 2.0824045667, 0.0268107611),
    (8, 0.5446629581, 0.9418042906),
    (8, 0.8607979023, 0.0618551152),
    (8, 2.0876562375, 0.0189056195),
    (8, 3.7948064684, 0.4079928293),
    (10, 0.8649978606, 0.0615735806),
    (10, 2.0522079098, 0.6540770181),
    (10, 2.0860466785, 0.0196931167),
    (10, 8.0240752734, 0.3257584482),
    (12, 0.8863483865, 0.0331727204),
    (12, 1.1297268996, 0.1186037339),
    (12, 2.0844040702, 0.0273774048),
    (12, 3.1291287778, 0.0774263051),
    (12, 7.2440247882, 0.1273937260),
    (12, 9.0583282789, 0.0811799114),
];
const DAT_OF_TWO: Table = &[
    (2, 0.8648621986, 0.0626711269),
    (4, 0.8655048870, 0.0597475524),
    (4, 2.0955376112, 0.0214915023),
    (6, 0.8701740056, 0.0588751528),
    (6, 2.0501987638, 0.0154642015),
    (6, 2.0844983644, 0.1084011486),
    (8, 0.8687850058, 0.0571018426),
    (8, 2.0763858446, 0.0232559744),
    (8, 2.2409162577, 0.1959515922),
    (10, 0.8684875978, 0.0545959994),
    (10, 2.0751475810, 0.0235361702),
    (10, 3.2508085079, 0.3858661381),
    (10, 8.2994635343, 0.0980342083),
    (12, 0.8720130146, 0.0531403545),
    (12, 2.0688613387, 0.0300048123),
    (12, 2.1144741278, -0.0431333801),
    (12, 3.0261352005, 0.1571268536),
    (12, 7.8502051416, 0.0355849667),
];

const PLSCF: Table = &[
    (6, 0.8703675697, 0.0489512737),
    (6, 2.0913297279, 0.0228518915),
    (9, 0.8719064583, 0.0497655969),
    (9, 2.0902298573, 0.0233576547),
];
const PLSCF_OF_TWO: Table = &[
    (4, 0.8678128457, 0.0488188597),
    (4, 2.0911721727, 0.0229335595),
    (6, 0.8672270888, 0.0485850258),
    (6, 2.0875571757, 0.0226227504),
];

/// The record of agrees.py, in the same order of sums.
fn record() -> Record {
    let mut state: u32 = 2021;
    let resonators = [(1.90, -0.97), (1.55, -0.96)]; // x_t = a x_(t-1) + b x_(t-2) + u
    let shapes = [[1.0, 0.6, -0.3], [-0.5, 1.0, 0.8]];
    let mut past = [[0.0; 2]; 2];
    let mut rows = Vec::new();
    for t in 0..2 * SAMPLES {
        let draws = [(); 5].map(|()| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state) / 4_294_967_296.0 - 0.5
        });
        for (((a, b), p), u) in resonators.iter().zip(&mut past).zip(draws) {
            *p = [a * p[0] + b * p[1] + u, p[0]];
        }
        if t >= SAMPLES {
            rows.push(
                [0, 1, 2].map(|c| shapes[0][c] * past[0][0] + shapes[1][c] * past[1][0] + draws[2 + c]),
            );
        }
    }
    let channel = |c: usize| {
        let mean = rows.iter().map(|row| row[c]).sum::<f64>() / SAMPLES as f64;
        rows.iter().map(|row| row[c] - mean).collect()
    };
    let names = ["a", "b", "c"].map(Channel::named).to_vec();
    Record::new(names, (0..3).map(channel).collect(), 20.0).unwrap()
}

fn options(references: &[usize]) -> Ssi {
    Ssi {
        block_rows: BLOCK_ROWS,
        order_most: 12,
        time_blocks: 2,
        references: references.to_vec(),
        ..Default::default()
    }
}

fn compare(found: &[Pole], published: Table) {
    assert_eq!(found.len(), published.len());
    for (pole, &(order, frequency_hz, damping_ratio)) in found.iter().zip(published) {
        assert_eq!(pole.order, order);
        assert!(
            (pole.frequency_hz / frequency_hz - 1.0).abs() < 1e-6,
            "{pole:?}, {frequency_hz}"
        );
        assert!(
            (pole.damping_ratio - damping_ratio).abs() < 1e-6,
            "{pole:?}, {damping_ratio}"
        );
    }
}

#[test]
fn agrees_with_pyoma2_on_every_pole_of_every_order() {
    type Ours = fn(&Record, &Ssi) -> Result<Subspace, ModalError>;
    let cases: [(Ours, &[usize], Table); 4] = [
        (ssi_cov, &[], COV),
        (ssi_cov, &[0, 2], COV_OF_TWO),
        (ssi_data, &[], DAT),
        (ssi_data, &[0, 2], DAT_OF_TWO),
    ];
    for (ours, references, published) in cases {
        compare(&ours(&record(), &options(references)).unwrap().poles, published);
    }
}

#[test]
fn agrees_with_pyoma2_on_every_pole_of_plscf() {
    for (references, published) in [(&[][..], PLSCF), (&[0, 2], PLSCF_OF_TWO)] {
        let options = Plscf {
            lags: 59,
            order_most: 3 * if references.is_empty() {
                3
            } else {
                references.len()
            },
            time_blocks: 2,
            references: references.to_vec(),
            ..Plscf::default()
        };
        compare(&plscf(&record(), &options).unwrap().poles, published);
    }
}

#[test]
fn holds_a_record_without_noise_is_decomposed_by_its_samples() {
    // a channel that repeats another one two samples later to 1e-9: the past is linearly dependent, and its sums of products
    // have lost all digits of the remainder
    let y = record();
    let echo: Vec<f64> = (0..SAMPLES)
        .map(|t| y.samples(0)[t.saturating_sub(2)] + 1e-9 * y.samples(2)[t])
        .collect();
    let names = ["a", "b"].map(Channel::named).to_vec();
    let nearly = Record::new(names, vec![y.samples(0).to_vec(), echo], 20.0).unwrap();
    let found = ssi_data(&nearly, &options(&[])).unwrap();
    let alone = Record::new(vec![Channel::named("a")], vec![y.samples(0).to_vec()], 20.0).unwrap();
    let alone = ssi_data(
        &alone,
        &Ssi {
            order_most: 6,
            ..options(&[])
        },
    )
    .unwrap();
    let first = |s: &Subspace, order: usize| {
        let mut at = s
            .poles
            .iter()
            .filter(|p| p.order == order && p.damping_ratio > 0.0);
        at.next().map(|p| p.frequency_hz).unwrap()
    };
    assert!((first(&found, 4) / first(&alone, 4) - 1.0).abs() < 0.02);
    let twice: Vec<f64> = (0..SAMPLES)
        .map(|t| y.samples(0)[t] + 1e-9 * y.samples(2)[t])
        .collect();
    let names = ["a", "b"].map(Channel::named).to_vec();
    let decimated = ssi_data(
        &Record::new(names, vec![y.samples(0).to_vec(), twice], 20.0).unwrap(),
        &Ssi {
            decimation: 2,
            block_rows: 4,
            order_most: 4,
            ..options(&[])
        },
    );
    let fault = decimated.map(|s| s.poles).unwrap_err().to_string();
    assert!(
        fault.starts_with("decimation is 2, but the record holds almost no noise"),
        "{fault}"
    );
}
