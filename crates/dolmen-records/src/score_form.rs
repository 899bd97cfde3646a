//! The filled form of the six-factor score: a sheet with keys in its first column and values in the next.

use crate::sheet_error::SheetError;
use crate::sheet_limits::{refuse_bomb, refuse_far};
use calamine::{Data, Reader as _, Xlsx};
use std::io::Cursor;

/// Required factors.
const NEEDED: [FormFactor; 4] = [
    FormFactor::Storeys,
    FormFactor::BodyHeight,
    FormFactor::Taper,
    FormFactor::BodyBaseHeightRatio,
];
/// One of these is enough.
const EITHER: [FormFactor; 2] = [FormFactor::BodySlenderness, FormFactor::SlendernessAngle];
/// The column of the values, from 0.
const VALUES: usize = 3;
/// Largest number of rows of a sheet of the form. Our choice: it has some thirty, and notes may follow.
const ROWS_MOST: usize = 1000;

/// Why a form cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ScoreFormError {
    /// The file is not a workbook.
    NoWorkbook(String),
    /// The file is larger than a form.
    Sheet(SheetError),
    /// No sheet has the rows of the form.
    NoForm,
    /// A value is missing.
    Missing {
        /// The key of the row.
        key: &'static str,
    },
    /// Two values that determine each other.
    Both,
    /// A value that is not a number.
    NoNumber {
        /// The key of the row.
        key: &'static str,
        /// The content found there.
        given: String,
    },
    /// The number of storeys is not an integer.
    NotWhole {
        /// The content found there.
        given: String,
    },
}

/// A factor of the form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormFactor {
    /// Number of storeys.
    Storeys,
    /// Height of all storeys, m.
    BodyHeight,
    /// Taper, degrees.
    Taper,
    /// Body height / base height.
    BodyBaseHeightRatio,
    /// Height / width of the body.
    BodySlenderness,
    /// Slenderness angle of the body.
    SlendernessAngle,
}

impl FormFactor {
    /// Its key, in the form and in a project file.
    pub fn key(self) -> &'static str {
        match self {
            FormFactor::Storeys => "storeys",
            FormFactor::BodyHeight => "body_height",
            FormFactor::Taper => "taper",
            FormFactor::BodyBaseHeightRatio => "body_base_height_ratio",
            FormFactor::BodySlenderness => "body_slenderness",
            FormFactor::SlendernessAngle => "slenderness_angle",
        }
    }
}

/// A filled form.
#[derive(Clone, Debug, PartialEq)]
pub struct ScoreForm {
    /// The name of the pagoda, if given.
    pub name: Option<String>,
    /// Factors with their values, in the units of the form: m, degrees.
    pub factors: Vec<(FormFactor, f64)>,
}

/// Reads a filled form from the bytes of a workbook.
///
/// # Errors
/// [`ScoreFormError`].
pub fn read_score_form(bytes: &[u8]) -> Result<ScoreForm, ScoreFormError> {
    match refuse_bomb(bytes) {
        Err(SheetError::Unreadable { why }) => return Err(ScoreFormError::NoWorkbook(why)),
        others => others.map_err(ScoreFormError::Sheet)?,
    }
    let mut book =
        Xlsx::new(Cursor::new(bytes)).map_err(|why| ScoreFormError::NoWorkbook(why.to_string()))?;
    for sheet in book.sheet_names() {
        refuse_far(&mut book, &sheet, ROWS_MOST).map_err(ScoreFormError::Sheet)?;
        let range = book
            .worksheet_range(&sheet)
            .map_err(|why| ScoreFormError::NoWorkbook(why.to_string()))?;
        let rows: Vec<(String, &Data)> = range
            .rows()
            .filter_map(|row| Some((row.first()?.to_string(), row.get(VALUES)?)))
            .collect();
        if rows.iter().any(|(key, _)| key == "storeys") {
            return filled(&rows);
        }
    }
    Err(ScoreFormError::NoForm)
}

fn filled(rows: &[(String, &Data)]) -> Result<ScoreForm, ScoreFormError> {
    let given = |key: &str| {
        let row = rows.iter().find(|(of, _)| of == key)?;
        let text = row.1.to_string().trim().to_owned();
        (!text.is_empty() && text != "–").then_some((row.1, text))
    };
    let mut factors = Vec::new();
    for factor in NEEDED.into_iter().chain(EITHER) {
        let key = factor.key();
        let Some((cell, text)) = given(key) else {
            match EITHER.contains(&factor) {
                true => continue,
                false => return Err(ScoreFormError::Missing { key }),
            }
        };
        let value = match cell {
            Data::Float(value) => Some(*value),
            Data::Int(value) => Some(*value as f64),
            Data::String(_) => text.replace(',', ".").parse().ok(),
            _ => None,
        };
        match value.filter(|value: &f64| value.is_finite()) {
            Some(value) if factor == FormFactor::Storeys && value.fract() != 0.0 => {
                return Err(ScoreFormError::NotWhole { given: text });
            }
            Some(value) => factors.push((factor, value)),
            None => return Err(ScoreFormError::NoNumber { key, given: text }),
        }
    }
    match EITHER.map(|either| factors.iter().any(|(of, _)| *of == either)) {
        [true, true] => return Err(ScoreFormError::Both),
        [false, false] => return Err(ScoreFormError::Missing { key: EITHER[0].key() }),
        _ => {}
    }
    Ok(ScoreForm {
        name: given("name").map(|(_, text)| text),
        factors,
    })
}

impl ScoreForm {
    /// The text of a project file with these values, and with the friction, the joints and the density of the score's designs.
    pub fn project_text(&self) -> String {
        let name = self.name.as_deref().unwrap_or("Pagoda of the form");
        let safe: String = name
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        let name = safe.replace('\\', "\\\\").replace('"', "\\\"");
        let written = |(factor, value): &(FormFactor, f64)| {
            let value = match factor {
                FormFactor::Storeys => format!("{value:.0}"),
                FormFactor::BodyHeight => format!("\"{value} m\""),
                FormFactor::Taper => format!("\"{value} deg\""),
                FormFactor::BodyBaseHeightRatio
                | FormFactor::BodySlenderness
                | FormFactor::SlendernessAngle => format!("{value:?}"),
            };
            format!("{} = {value}", factor.key())
        };
        let factors: Vec<String> = self.factors.iter().map(written).collect();
        format!(
            "schema = 1\nkind = \"stack\"\nname = \"{name}\"\ndensity = 2600\n\
             joint = {{ friction = 0.6, normal_stiffness = 1e9, shear_stiffness = 4e8 }}\npagoda = {{ {} }}\n",
            factors.join(", ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_a_form_with_a_cell_far_from_it_and_one_of_a_million_rows() {
        let told = |row: u32, column: u16| {
            let mut book = rust_xlsxwriter::Workbook::new();
            let sheet = book.add_worksheet();
            sheet.write_string(0, 0, "storeys").unwrap();
            sheet.write_number(row, column, 3.0).unwrap();
            read_score_form(&book.save_to_buffer().unwrap())
        };
        for (row, column) in [(1_048_575, 16_383), (1000, 0), (3, 256)] {
            let (rows, columns) = (row as usize + 1, usize::from(column) + 1);
            let far = SheetError::TooMany {
                rows,
                columns,
                rows_most: ROWS_MOST,
            };
            assert_eq!(told(row, column), Err(ScoreFormError::Sheet(far)));
        }
        assert_eq!(told(999, 3), Err(ScoreFormError::Missing { key: "storeys" }));
    }
}
