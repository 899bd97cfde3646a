// SOURCE     workbooks written by rust_xlsxwriter, beside the same table as text.
// GOAL       A record or log in a workbook is read as the same table in CSV, dates of cells included.
// TOLERANCE  the same samples, rate and times.

use dolmen::signal::Channel;
use dolmen_records::records::{Column, Pick, RecordError, RecordFormat, RecordOptions, Unit, read_record};
use dolmen_records::{LogError, SheetError, read_log};
use rust_xlsxwriter::{ExcelDateTime, Format, Workbook};

const STEP_MS: u32 = 10;

fn sample(row: u32, column: u32) -> f64 {
    f64::from((row * 7 + column * 3) % 13) / 8.0 - 0.75
}

/// 300 rows from 14:30, with seconds or dates as times, below this many empty rows.
fn book(has_dates: bool, above: u32) -> Workbook {
    let mut book = Workbook::new();
    book.add_worksheet().set_name("empty").unwrap();
    let sheet = book.add_worksheet().set_name("기록").unwrap();
    let stamp = Format::new().set_num_format("yyyy-mm-dd hh:mm:ss.000");
    for (column, name) in (0..).zip([if has_dates { "일시" } else { "Time (s)" }, "top", "base"]) {
        sheet.write_string(above, column, name).unwrap();
    }
    for row in 0..300 {
        let at = row * STEP_MS;
        let line = above + 1 + row;
        if has_dates {
            let second = u8::try_from(at / 1000).unwrap();
            let when = ExcelDateTime::from_ymd(2026, 4, 2)
                .unwrap()
                .and_hms_milli(14, 30, second, u16::try_from(at % 1000).unwrap())
                .unwrap();
            sheet.write_datetime_with_format(line, 0, &when, &stamp).unwrap();
        } else {
            sheet.write_number(line, 0, f64::from(at) / 1000.0).unwrap();
        }
        for column in 0..2 {
            sheet
                .write_number(line, 1 + u16::try_from(column).unwrap(), sample(row, column))
                .unwrap();
        }
    }
    book
}

/// Columns are selected if there are dates too, as in a project file.
fn options(has_dates: bool) -> RecordOptions {
    let picks = ["top", "base"].map(|name| Pick {
        column: Column::Named(name.to_owned()),
        channel: Channel::named(name),
        scale: None,
    });
    RecordOptions {
        unit: Unit::MetrePerSecondSquared,
        sampling_rate_hz: has_dates.then_some(100.0),
        picks: if has_dates { picks.to_vec() } else { Vec::new() },
        ..Default::default()
    }
}

#[test]
fn agrees_a_workbook_is_read_as_the_table_that_it_holds() {
    for (has_dates, above) in [(false, 0), (true, 0), (false, 3)] {
        let bytes = book(has_dates, above).save_to_buffer().unwrap();
        for format in [None, Some(RecordFormat::Xlsx)] {
            let given = RecordOptions {
                format,
                ..options(has_dates)
            };
            let record = read_record(&bytes, &given).unwrap().record;
            assert!((record.sampling_rate_hz() - 100.0).abs() < 1e-9);
            let names: Vec<&str> = record
                .channels()
                .iter()
                .map(|channel| channel.name.as_str())
                .collect();
            assert_eq!(names[names.len() - 2..], ["top", "base"]);
            for (column, at) in (0..2).zip(names.len() - 2..) {
                let expected: Vec<f64> = (0..300).map(|row| sample(row, column)).collect();
                assert_eq!(record.samples(at), expected, "{has_dates} {above}");
            }
        }
    }
}

#[test]
fn refuses_a_workbook_by_its_sheet_and_cell_and_what_is_none() {
    let mut two = book(false, 0);
    two.add_worksheet()
        .set_name("notes")
        .unwrap()
        .write_string(0, 0, "x")
        .unwrap();
    let told = |bytes: &[u8], format| {
        let given = RecordOptions {
            format,
            ..options(false)
        };
        read_record(bytes, &given).unwrap_err()
    };
    let of_two = told(&two.save_to_buffer().unwrap(), None);
    assert!(
        of_two.to_string().contains("several sheets (기록, notes)"),
        "{of_two}"
    );
    let mut odd = book(false, 2);
    odd.worksheet_from_index(1)
        .unwrap()
        .write_string(8, 1, "over")
        .unwrap();
    let odd = told(&odd.save_to_buffer().unwrap(), None).to_string();
    assert!(odd.contains("line 9") && odd.contains("over"), "{odd}");
    let mut sums = book(false, 0);
    sums.worksheet_from_index(1)
        .unwrap()
        .write_formula(5, 2, "=B6*2")
        .unwrap();
    let sums = told(&sums.save_to_buffer().unwrap(), None);
    let formula = SheetError::Formula { place: "C6".into() };
    assert_eq!(sums, RecordError::Workbook { why: formula });
    let zip = told(b"PK\x03\x04 and nothing", None).to_string();
    assert!(zip.contains("cannot be read as a table"), "{zip}");
    let text = told(b"a,b\n1,2\n3,4\n", Some(RecordFormat::Xlsx)).to_string();
    assert!(
        text.contains("not of the format xlsx: it begins like text"),
        "{text}"
    );
    let wav = told(&book(false, 0).save_to_buffer().unwrap(), Some(RecordFormat::Wav)).to_string();
    assert!(wav.contains("it begins like a workbook or a ZIP"), "{wav}");
}

#[test]
fn agrees_a_log_in_a_workbook() {
    let bytes = book(true, 2).save_to_buffer().unwrap();
    let log = read_log(&bytes, Some("base")).unwrap();
    assert_eq!(log.times_s[0], 1_775_140_200.0); // 2026-04-02 14:30 by `date -u`
    assert_eq!(log.values.len(), 300);
    assert!((log.times_s[299] - log.times_s[0] - 2.99).abs() < 1e-6);
    let mut empty = Workbook::new();
    let nothing = read_log(&empty.save_to_buffer().unwrap(), None).unwrap_err();
    assert_eq!(nothing, LogError::Workbook(SheetError::NoRows));
}
