//! Decimal commas in a file whose cells are separated by commas.

use super::RecordError;
use super::date_text::is_date_cell;
use super::dialect::{Delimiter, Line, unquoted};
use crate::number::parse_cell;

/// Refuses decimal commas in files with comma separators: each number then fills two cells, and a date one or two.
pub(super) fn refuse_decimal_commas(lines: &[Line<'_>], delimiter: Delimiter) -> Result<(), RecordError> {
    let rows = lines.iter().map(|line| delimiter.cells(line.text));
    let rows: Vec<Vec<&[u8]>> = rows.collect();
    let is_number = |cell: &&[u8]| parse_cell(unquoted(cell), b'.').is_some();
    let is_sample = |cell: &&[u8]| is_number(cell) || is_date_cell(cell);
    let is_name = |cell: &&[u8]| !cell.is_empty() && !is_sample(cell);
    let found = rows.windows(2).position(|pair| {
        let (names, samples) = (&pair[0], &pair[1]);
        let doubled = 2 * names.len();
        let fills = samples.len() == doubled || (samples.len() + 1 == doubled && is_date_cell(samples[0]));
        delimiter == Delimiter::Comma
            && names.len() > 1
            && fills
            && names.iter().all(is_name)
            && samples.iter().all(is_sample)
    });
    match found {
        Some(at) => Err(RecordError::DecimalCommas {
            line: lines[at + 1].number,
            found: rows[at + 1].len(),
            expected: rows[at].len(),
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use crate::records::{RecordOptions, read_csv};

    fn refusal(bytes: &[u8]) -> String {
        let options = RecordOptions {
            sampling_rate_hz: Some(100.0),
            ..Default::default()
        };
        read_csv(bytes, &options).unwrap_err().to_string()
    }

    #[test]
    fn refuses_decimal_commas_between_commas() {
        let said = "line 2 holds 6 cells below 3 names: its numbers have decimal commas, and commas separate the cells; save the file with decimal \
                    points, or with semicolons between the cells";
        let dated = "일시,X,Y\n2026-10-14 10:00:00,40,-0,52,0,23\n2026-10-14 10:00:00,41,-0,37,0,47\n";
        assert_eq!(refusal(dated.as_bytes()), said);
        assert_eq!(refusal(b"t,X,Y\n0,00,-0,52,0,23\n0,01,-0,37,0,47\n"), said);
        let titled = format!("Logger,DL-2000\n{dated}");
        assert_eq!(refusal(titled.as_bytes()), said.replace("line 2", "line 3"));
        let whole = "일시,X,Y\n2026-10-14 10:00:00,-0,52,0,23\n2026-10-14 10:00:01,-0,37,0,47\n";
        assert_eq!(refusal(whole.as_bytes()), said.replace("6 cells", "5 cells"));
        assert!(refusal(b"t,X,Y\n0,1,2,3,4\n0,1,2,3,4\n").starts_with("line 2 holds 5 cells, but"));
    }
}
