//! The table of a portfolio (CSV), one row for each structure.

use crate::wrong::{RowLacks, RowNeeds};
use dolmen::assess::demand::KoreanSite;
use dolmen::assess::{AssessError, Hazard, SixFactors};
use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness};
use dolmen_records::utf8;
use dolmen_words::message::Both;

/// Every column; all except `name` are optional.
pub(crate) const COLUMNS: [&str; 11] = [
    "name",
    "storeys",
    "body_height_m",
    "slenderness_angle",
    "body_slenderness",
    "taper_deg",
    "body_base_height_ratio",
    "project",
    "study",
    "zone_factor_g",
    "soil",
];

/// Factor by which tan α may differ from that of the pagoda that λ implies, either way: eaves and bodies of real pagodas differ. Beyond it the
/// score, trained where both agree, gives wrong reasons. Chosen here.
const SLENDERNESS_APART_MOST: f64 = 1.1;

/// Columns of the factors of a pagoda: one of each is needed.
const NEEDED: [&[&str]; 5] = [
    &["storeys"],
    &["body_height_m"],
    &["body_slenderness", "slenderness_angle"],
    &["taper_deg"],
    &["body_base_height_ratio"],
];
/// Height of the body over its width from which a decimal point is missing. Chosen here: pagodas have 1.5 to 6.
const BODY_SLENDERNESS_MOST: f64 = 15.0;
/// Largest height of the body of a stone pagoda, m; a larger number is probably in mm.
const BODY_MOST_M: f64 = 100.0;

/// The column of a Korean heading; other headings stay as they are.
fn column_of(head: &str) -> &str {
    let (name, unit) = head.split_once(['(', '[']).unwrap_or((head, ""));
    // a heading with another unit is not a column
    if !matches!(
        unit.trim_end_matches([')', ']']).trim(),
        "" | "m" | "도" | "°" | "deg" | "g"
    ) {
        return head;
    }
    let plain: String = name.chars().filter(|sign| !sign.is_whitespace()).collect();
    match plain.as_str() {
        "이름" | "명칭" | "석탑" | "구조물" => "name",
        "층수" => "storeys",
        "몸체높이" | "탑신높이" | "탑신부높이" => "body_height_m",
        "세장각" | "세장비각" => "slenderness_angle",
        "몸돌세장비" => "body_slenderness",
        "체감각" => "taper_deg",
        "프로젝트" => "project",
        "지역계수" => "zone_factor_g",
        "지반" | "지반종류" | "지반분류" => "soil",
        _ => head,
    }
}

/// Why a table of structures is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum PortfolioError {
    /// The text is no table.
    Table {
        /// What the reader says.
        why: String,
    },
    /// The table has no column `name`.
    NoName,
    /// An unknown column.
    Column {
        /// Which.
        column: String,
    },
    /// A value is missing.
    Missing {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// What is missing and what to do.
        what: Both,
    },
    /// A value cannot be read.
    Value {
        /// Line in the file, from 1.
        line: usize,
        /// The structure.
        name: String,
        /// Column.
        column: &'static str,
        /// What is there.
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
        /// What the science says.
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
    /// Two rows have one name.
    Twice {
        /// The name.
        name: String,
        /// Line of the first.
        first: usize,
        /// Line of the second.
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
}

/// Reads a table of structures, in UTF-8 or as Korean spreadsheets save it (CP949). Lines that begin with # are comments.
///
/// # Errors
/// [`PortfolioError`] of the table as a whole: no CSV, unknown columns, two rows of one name; and of its first row if none can be taken.
pub fn read_portfolio(bytes: &[u8]) -> Result<PortfolioTable, PortfolioError> {
    let table = |why: csv::Error| PortfolioError::Table { why: why.to_string() };
    let bytes = utf8(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    // Excel in some countries separates by semicolons, and writes decimals with a comma
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let first = lines.find(|line| !line.starts_with(b"#")).unwrap_or_default();
    let is_by_semicolons = first.contains(&b';') && !first.contains(&b',');
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .delimiter(if is_by_semicolons { b';' } else { b',' })
        .trim(csv::Trim::All)
        .from_reader(&*bytes);
    let head: csv::StringRecord = reader.headers().map_err(table)?.iter().map(column_of).collect();
    if let Some(column) = head.iter().find(|column| !COLUMNS.contains(column)) {
        return Err(PortfolioError::Column {
            column: column.to_owned(),
        });
    }
    if !head.iter().any(|column| column == "name") {
        return Err(PortfolioError::NoName);
    }
    let mut rows: Vec<PortfolioRow> = Vec::new();
    let mut refused: Vec<(String, PortfolioError)> = Vec::new();
    for row in reader.records() {
        let row = row.map_err(table)?;
        let line = row.position().map_or(0, |at| at.line() as usize);
        let cells = Cells {
            line,
            name: cell(&head, &row, "name").unwrap_or_default().to_owned(),
            has_decimal_commas: is_by_semicolons,
            of: &|column| cell(&head, &row, column),
        };
        match cells.row() {
            Ok(row) => rows.push(row),
            Err(why) => refused.push((cells.name.clone(), why)),
        }
    }
    let mut lines = std::collections::BTreeMap::new();
    for row in &rows {
        if let Some(first) = lines.insert(row.name.as_str(), row.line) {
            return Err(PortfolioError::Twice {
                name: row.name.clone(),
                first,
                second: row.line,
            });
        }
    }
    match refused.first() {
        Some((_, why)) if rows.is_empty() => Err(why.clone()),
        _ => Ok(PortfolioTable { rows, refused }),
    }
}

fn cell<'r>(head: &csv::StringRecord, row: &'r csv::StringRecord, column: &str) -> Option<&'r str> {
    let place = head.iter().position(|name| name == column)?;
    row.get(place).filter(|text| !text.is_empty())
}

/// The cells of one row, by column.
struct Cells<'r> {
    line: usize,
    name: String,
    /// Whether numbers may be written "0,11".
    has_decimal_commas: bool,
    of: &'r dyn Fn(&str) -> Option<&'r str>,
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

    fn missing(&self, what: RowLacks) -> PortfolioError {
        PortfolioError::Missing {
            line: self.line,
            name: self.name.clone(),
            what: what.into(),
        }
    }

    fn refused(&self, column: &'static str, allowed: RowNeeds) -> PortfolioError {
        PortfolioError::Value {
            line: self.line,
            name: self.name.clone(),
            column,
            given: (self.of)(column).unwrap_or_default().to_owned(),
            allowed: allowed.into(),
        }
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
        value
            .map(Some)
            .ok_or_else(|| self.refused(column, RowNeeds::Number))
    }

    fn factors(&self) -> Result<SixFactors, PortfolioError> {
        let is_given = |column: &str| (self.of)(column).is_some();
        let lacks = || {
            let missing = NEEDED
                .iter()
                .filter(|columns| !columns.iter().any(|one| is_given(one)));
            let missing: Vec<String> = missing.map(|columns| columns.join("/")).collect();
            self.missing(match missing.len() < NEEDED.len() {
                true => RowLacks::Columns {
                    columns: missing.join(", "),
                },
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

    /// Both slendernesses as measured, if the pagoda that λ implies has about the given angle: the score was trained only on such pagodas.
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
        let (zone, soil) = (self.number("zone_factor_g")?, (self.of)("soil"));
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
        let hazard = Hazard::kds_17(zone_factor_g, soil).map_err(|why| self.science(why))?;
        Ok(Some(hazard))
    }
}
