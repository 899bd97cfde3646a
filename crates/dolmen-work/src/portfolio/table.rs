//! The table of a portfolio (XLSX, ODS, CSV), one row for each structure.

use super::heads::{Head, head, joined, said, text};
use crate::wrong::{RowLacks, RowNeeds};
use dolmen::assess::demand::{KoreanSite, KoreanZone};
use dolmen::assess::{AssessError, Hazard, SixFactors};
use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness};
use dolmen_records::{SheetCell, SheetError, SheetValue, read_sheet};
use dolmen_words::message::Both;

/// Largest ratio, either way, of a given tan α to that of the pagoda that λ implies: real eaves and bodies differ. Beyond it the score, trained
/// where both agree, gives wrong reasons. Our choice.
const SLENDERNESS_APART_MOST: f64 = 1.1;

/// Columns of the factors of a pagoda; one of each group is required.
const NEEDED: [&[&str]; 5] = [
    &["storeys"],
    &["body_height_m"],
    &["body_slenderness", "slenderness_angle"],
    &["taper_deg"],
    &["body_base_height_ratio"],
];
/// Height of the body over its width above which a decimal point is probably missing. Our choice: pagodas have 1.5 to 6.
const BODY_SLENDERNESS_MOST: f64 = 15.0;
/// Largest zone factor, g. Our choice: zone I has 0.11, and at 0.15 the 2400-year motion reaches 0.3 g, where the soil table of the code ends.
const ZONE_FACTOR_MOST_G: f64 = 0.15;
/// Largest height of the body of a stone pagoda, m; a larger number is probably in mm.
const BODY_MOST_M: f64 = 100.0;

/// Why a table of structures is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum PortfolioError {
    /// The file is no table.
    Table(SheetError),
    /// A workbook has several sheets, but none was named.
    SeveralSheets {
        /// Their names.
        known: String,
    },
    /// A sheet was named for a table of text.
    NoSheets {
        /// Its name.
        sheet: String,
    },
    /// The table has no column `name`.
    NoName,
    /// A column that is misspelt, or in another unit.
    Column {
        /// Name of the column.
        column: String,
    },
    /// Two columns for one quantity.
    ColumnTwice {
        /// The quantity.
        column: Both,
    },
    /// A value is missing.
    Missing {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// The missing value, and what to do.
        what: Both,
    },
    /// A value cannot be read.
    Value {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// Column.
        column: Box<Both>,
        /// Content of the cell.
        given: String,
        /// Allowed values.
        allowed: Both,
    },
    /// Impossible factors of a pagoda, or a site that is not in the code.
    Refused {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// The error of the library.
        why: Box<AssessError>,
    },
    /// Two numbers that contradict each other.
    TwoPagodas {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// tan α as given.
        slenderness_angle: f64,
        /// λ as given.
        body_slenderness: f64,
        /// tan α of the pagoda that λ implies.
        made: f64,
    },
    /// Two rows with the same name.
    Twice {
        /// The name.
        name: String,
        /// Line of the first row.
        first: usize,
        /// Line of the second row.
        second: usize,
    },
}

/// Source of the capacity of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum RowSource {
    /// The six factors: the score.
    Factors(SixFactors),
    /// A project file, relative to the table: a study of it, or the factors of its pagoda.
    Project {
        /// The file or its folder.
        path: String,
        /// The study; `None`: the only one.
        study: Option<String>,
    },
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct PortfolioRow {
    /// Line in the file, from 1.
    pub line: usize,
    /// Name of the structure.
    pub name: String,
    /// Source of its capacity.
    pub source: RowSource,
    /// Hazard at its site, by the zone and soil of KDS 17 10 00; intensities in m/s².
    pub hazard: Option<Hazard>,
}

/// A table: its rows, and the faults of others.
#[derive(Clone, Debug, PartialEq)]
pub struct PortfolioTable {
    /// Usable rows.
    pub rows: Vec<PortfolioRow>,
    /// Faulty rows, each with its structure.
    pub refused: Vec<(String, PortfolioError)>,
    /// Headers of columns that a ranking does not use.
    pub left_out: Vec<String>,
}

/// Reads a table of structures by the ending of its file: XLSX, ODS, or CSV in UTF-8 or as Korean spreadsheets save it (CP949). Lines that begin
/// with # are comments.
///
/// # Errors
/// [`PortfolioError`] for the table: not a table, misspelt columns, two rows with the same name; or of its first row if no row is valid.
pub fn read_portfolio(bytes: &[u8], file: &str) -> Result<PortfolioTable, PortfolioError> {
    read_portfolio_sheet(bytes, file, None)
}

/// The same from the named sheet of a workbook.
///
/// # Errors
/// As [`read_portfolio`].
pub fn read_portfolio_sheet(
    bytes: &[u8],
    file: &str,
    sheet: Option<&str>,
) -> Result<PortfolioTable, PortfolioError> {
    let cells = read_sheet(bytes, file, sheet).map_err(|why| match (why, sheet) {
        (SheetError::SeveralSheets { known }, _) => PortfolioError::SeveralSheets { known },
        (SheetError::NoSheets, Some(sheet)) => PortfolioError::NoSheets {
            sheet: sheet.to_owned(),
        },
        (why, _) => PortfolioError::Table(why),
    })?;
    let is_comment =
        |row: &&Vec<SheetCell>| row.first().is_some_and(|cell| text(&cell.value).starts_with('#'));
    let mut cells = cells.iter().filter(|row| !is_comment(row));
    let header: &[SheetCell] = cells.next().map_or(&[], Vec::as_slice);
    let (columns, left_out) = columns(header)?;
    let heads: Vec<(&str, String)> = (columns.iter().zip(header))
        .filter_map(|(column, cell)| Some(((*column)?, text(&cell.value))))
        .collect();
    if !columns.contains(&Some("name")) {
        return Err(PortfolioError::NoName);
    }
    // Excel in some countries separates by semicolons, and writes decimals with a comma
    let has_decimal_commas = is_by_semicolons(bytes);
    let mut rows: Vec<PortfolioRow> = Vec::new();
    let mut refused: Vec<(String, PortfolioError)> = Vec::new();
    for row in cells {
        let values: Vec<(&str, String)> = (columns.iter().zip(row))
            .filter_map(|(column, cell)| Some(((*column)?, text(&cell.value))))
            .filter(|(_, value)| !value.is_empty())
            .collect();
        let Some(first) = row.first() else { continue };
        if row.iter().all(|cell| cell.value == SheetValue::Empty) {
            continue;
        }
        let of = |column: &str| {
            let found = values.iter().find(|(known, _)| *known == column);
            found.map(|(_, value)| value.as_str())
        };
        let digits: String = first.place.chars().filter(char::is_ascii_digit).collect();
        let line = digits.parse().unwrap_or(0);
        let given = Cells {
            line,
            name: of("name").unwrap_or_default().to_owned(),
            has_decimal_commas,
            of: &of,
            heads: &heads,
        };
        if row.len() > columns.len()
            && row[columns.len()..]
                .iter()
                .any(|cell| cell.value != SheetValue::Empty)
        {
            let why = given.missing(RowLacks::Heads);
            refused.push((given.shown_name(), why));
            continue;
        }
        match given.row() {
            Ok(row) => rows.push(row),
            Err(why) => refused.push((given.shown_name(), why)),
        }
    }
    refuse_twice(&rows)?;
    match refused.first() {
        Some((_, why)) if rows.is_empty() => Err(why.clone()),
        _ => Ok(PortfolioTable {
            rows,
            refused,
            left_out,
        }),
    }
}

/// The column of each header, and the headers of columns that are left out.
fn columns(header: &[SheetCell]) -> Result<(Vec<Option<&'static str>>, Vec<String>), PortfolioError> {
    let (mut columns, mut left_out) = (Vec::new(), Vec::new());
    for cell in header {
        let written = text(&cell.value);
        let column = match head(&written) {
            _ if written.is_empty() => None,
            Head::Of(column) if columns.contains(&Some(column)) => {
                return Err(PortfolioError::ColumnTwice {
                    column: said(column, Some(&written)),
                });
            }
            Head::Of(column) => Some(column),
            Head::Doubtful => return Err(PortfolioError::Column { column: written }),
            Head::LeftOut => {
                left_out.push(written);
                None
            }
        };
        columns.push(column);
    }
    Ok((columns, left_out))
}

/// Whether the first line of a text that is no comment is separated by semicolons.
fn is_by_semicolons(bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let first = lines.find(|line| !line.starts_with(b"#")).unwrap_or_default();
    !bytes.starts_with(b"PK") && first.contains(&b';') && !first.contains(&b',')
}

fn refuse_twice(rows: &[PortfolioRow]) -> Result<(), PortfolioError> {
    let mut lines = std::collections::BTreeMap::new();
    for row in rows {
        if let Some(first) = lines.insert(row.name.as_str(), row.line) {
            return Err(PortfolioError::Twice {
                name: row.name.clone(),
                first,
                second: row.line,
            });
        }
    }
    Ok(())
}

/// The cells of one row, by column.
struct Cells<'r> {
    line: usize,
    name: String,
    /// Whether numbers may be written "0,11".
    has_decimal_commas: bool,
    of: &'r dyn Fn(&str) -> Option<&'r str>,
    /// Columns with their heads as written.
    heads: &'r [(&'r str, String)],
}

impl Cells<'_> {
    fn row(&self) -> Result<PortfolioRow, PortfolioError> {
        if self.name.is_empty() {
            return Err(self.missing(RowLacks::Name));
        }
        let source = match (self.of)("project") {
            Some(path) => RowSource::Project {
                path: path.to_owned(),
                study: (self.of)("study").map(str::to_owned),
            },
            None => RowSource::Factors(self.factors()?),
        };
        Ok(PortfolioRow {
            line: self.line,
            name: self.name.clone(),
            source,
            hazard: self.hazard()?,
        })
    }

    /// The name, or a dash for a row without one.
    fn shown_name(&self) -> String {
        match self.name.is_empty() {
            true => "–".to_owned(),
            false => self.name.clone(),
        }
    }

    fn missing(&self, what: RowLacks) -> PortfolioError {
        PortfolioError::Missing {
            line: self.line,
            name: self.shown_name(),
            what: what.into(),
        }
    }

    fn refused(&self, column: &'static str, allowed: RowNeeds) -> PortfolioError {
        PortfolioError::Value {
            line: self.line,
            name: self.name.clone(),
            column: Box::new(self.said(column)),
            given: (self.of)(column).unwrap_or_default().to_owned(),
            allowed: allowed.into(),
        }
    }

    fn said(&self, column: &str) -> Both {
        let head = self.heads.iter().find(|(known, _)| *known == column);
        said(column, head.map(|(_, head)| head.as_str()))
    }

    fn number(&self, column: &'static str) -> Result<Option<f64>, PortfolioError> {
        let Some(text) = (self.of)(column) else {
            return Ok(None);
        };
        let pointed = match self.has_decimal_commas {
            true => text.replace(',', "."),
            false => text.to_owned(),
        };
        let value = pointed
            .parse::<f64>()
            .ok()
            .filter(|value| *value >= 0.0 && value.is_finite());
        value.map(Some).ok_or_else(|| self.refused(column, needed(text)))
    }

    fn factors(&self) -> Result<SixFactors, PortfolioError> {
        let is_given = |column: &str| (self.of)(column).is_some();
        let lacks = || {
            let missing = NEEDED
                .iter()
                .filter(|columns| !columns.iter().any(|one| is_given(one)));
            let missing: Vec<Both> = missing
                .map(|columns| {
                    let each: Vec<Both> = columns.iter().map(|column| self.said(column)).collect();
                    Both::of(|language| joined(&each, "/", language))
                })
                .collect();
            self.missing(match missing.len() < NEEDED.len() {
                true => RowLacks::Columns(Both::of(|language| joined(&missing, ", ", language))),
                false => RowLacks::Factors,
            })
        };
        let storeys = (self.of)("storeys").ok_or_else(lacks)?;
        let storeys: u32 = storeys
            .parse()
            .map_err(|_| self.refused("storeys", RowNeeds::WholeNumber))?;
        let given = |column| self.number(column)?.ok_or_else(lacks);
        let taper_deg = given("taper_deg")?;
        if taper_deg >= 40.0 {
            return Err(self.refused("taper_deg", RowNeeds::Taper));
        }
        if given("body_height_m")? > BODY_MOST_M {
            return Err(self.refused("body_height_m", RowNeeds::BodyHeight));
        }
        let (body_height_m, taper_rad) = (given("body_height_m")?, taper_deg.to_radians());
        let body_base_height_ratio = given("body_base_height_ratio")?;
        let body = self.number("body_slenderness")?;
        if body.is_some_and(|body| body > BODY_SLENDERNESS_MOST) {
            return Err(self.refused("body_slenderness", RowNeeds::Slenderness));
        }
        let angle = self.number("slenderness_angle")?;
        let slenderness = match (angle, body) {
            (Some(angle), Some(body)) => {
                let given = SixFactors {
                    storeys,
                    body_height_m,
                    slenderness_angle: angle,
                    body_slenderness: body,
                    taper_rad,
                    body_base_height_ratio,
                };
                return self.of_one_pagoda(given);
            }
            (Some(angle), None) => PagodaSlenderness::Angle(angle),
            (None, Some(body)) => PagodaSlenderness::Body(body),
            (None, None) => return Err(lacks()),
        };
        SixFactors::of_pagoda(&PagodaFactors {
            storeys,
            body_height_m,
            slenderness,
            taper_rad,
            body_base_height_ratio,
            ..PagodaFactors::default()
        })
        .map_err(|why| self.science(why))
    }

    /// Both measured slendernesses, if the pagoda that λ implies has about the given angle: the score was trained only on such pagodas.
    fn of_one_pagoda(&self, given: SixFactors) -> Result<SixFactors, PortfolioError> {
        let made = SixFactors::of_pagoda(&PagodaFactors {
            storeys: given.storeys,
            body_height_m: given.body_height_m,
            slenderness: PagodaSlenderness::Body(given.body_slenderness),
            taper_rad: given.taper_rad,
            body_base_height_ratio: given.body_base_height_ratio,
            ..PagodaFactors::default()
        })
        .map_err(|why| self.science(why))?;
        let apart = (given.slenderness_angle / made.slenderness_angle).ln().abs();
        if apart <= SLENDERNESS_APART_MOST.ln() {
            return Ok(given);
        }
        Err(PortfolioError::TwoPagodas {
            line: self.line,
            name: self.name.clone(),
            slenderness_angle: given.slenderness_angle,
            body_slenderness: given.body_slenderness,
            made: made.slenderness_angle,
        })
    }

    fn science(&self, why: AssessError) -> PortfolioError {
        PortfolioError::Refused {
            line: self.line,
            name: self.name.clone(),
            why: Box::new(why),
        }
    }

    fn hazard(&self) -> Result<Option<Hazard>, PortfolioError> {
        let zone = match (self.of)("zone_factor_g") {
            Some("I" | "Ⅰ") => Some(KoreanZone::I.factor_g()),
            Some("II" | "Ⅱ") => Some(KoreanZone::II.factor_g()),
            _ => self.number("zone_factor_g")?,
        };
        let soil = (self.of)("soil");
        let (zone_factor_g, soil) = match (zone, soil) {
            (None, None) => return Ok(None),
            (Some(zone), Some(soil)) => (zone, soil),
            _ => return Err(self.missing(RowLacks::ZoneAndSoil)),
        };
        let soil = match soil {
            "S1" => KoreanSite::S1,
            "S2" => KoreanSite::S2,
            "S3" => KoreanSite::S3,
            "S4" => KoreanSite::S4,
            "S5" => KoreanSite::S5,
            "S6" => KoreanSite::S6,
            _ => return Err(self.refused("soil", RowNeeds::Soil)),
        };
        if !(zone_factor_g > 0.0 && zone_factor_g <= ZONE_FACTOR_MOST_G) {
            return Err(self.refused("zone_factor_g", RowNeeds::ZoneFactor));
        }
        let hazard = Hazard::kds_17(zone_factor_g, soil).map_err(|why| self.science(why))?;
        Ok(Some(hazard))
    }
}

/// How to write a number that cannot be read: with a point.
fn needed(text: &str) -> RowNeeds {
    let is_number = |text: &str| {
        text.parse::<f64>()
            .is_ok_and(|value| value >= 0.0 && value.is_finite())
    };
    match text.split_once(',') {
        Some((whole, rest)) if rest.len() == 3 && is_number(&format!("{whole}{rest}")) => {
            RowNeeds::CommaOfEither {
                decimal: format!("{whole}.{rest}"),
                thousands: format!("{whole}{rest}"),
            }
        }
        Some((whole, rest)) if is_number(&format!("{whole}.{rest}")) => {
            RowNeeds::DecimalPoint(format!("{whole}.{rest}"))
        }
        _ => RowNeeds::Number,
    }
}
