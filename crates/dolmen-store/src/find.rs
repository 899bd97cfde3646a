//! Reads a store: lists, passed on row by row, and a structure with its history.

use crate::database::{Database, Value, all};
use crate::error::StoreError;
use crate::incoming::{AIR_TEMPERATURE, PROJECT_FILE, refuse_path};
use crate::inspection_rows;
use crate::rows::{
    AdoptionRow, AnalysisRow, ArrivalRow, EarthquakeRow, EnvironmentRow, LogRow, ModeRow, ProjectFileRow,
    ProjectRow, RecordRow, Row as _, StatedEarthquakeRow, StatedModeRow, SurveyRow, TiltRow, select,
};
use crate::store::{Store, refuse_unknown};
use dolmen_work::kept::{
    KeptAnalysis, KeptEarthquake, KeptLog, KeptMode, KeptRecord, KeptState, KeptStructure, KeptSurvey,
    KeptTilt, ListedStructure, ListedSurvey, StoreFault,
};

/// Number of log lines that a structure shows.
const LOG_MOST: usize = 20;

/// Filter for the list of structures.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// Part of a name, ignoring case; empty means all.
    pub words: String,
    /// Whether to include structures out of use.
    pub with_removed: bool,
}

/// A project from the store.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The text of the project file, followed by the surveys from watched folders.
    pub text: Vec<u8>,
    /// Number of bytes of the project file when it was added.
    pub own_bytes: usize,
    /// Its files: path, hash and size.
    pub files: Vec<(String, String, u64)>,
}

/// SQL for the latest state of each structure: `a` is its adoption, `p` its project.
const LATEST: &str = "from structure s \
    join adoption a on a.structure = s.name and a.at_us = (select max(at_us) from adoption where structure = s.name) \
    join project p on p.hash = a.project";
/// SQL for whether it is out of use.
const REMOVED: &str =
    "coalesce((select m.is_removed from mark m where m.structure = s.name order by m.at_us desc limit 1), 0)";

/// SQL for the latest analysis of the records of a survey `v`.
pub(crate) const LAST_ANALYSIS: &str = "(select n.hash from survey_analysis sa join analysis n on n.hash = sa.analysis \
     where sa.survey = v.hash order by n.at_us desc, n.hash limit 1)";

fn condition(search: &Search) -> (String, Vec<Value>) {
    let escaped = search.words.to_lowercase().replace('!', "!!");
    let escaped = escaped.replace('%', "!%").replace('_', "!_");
    let like = |column: &str| format!("lower({column}) like $1 escape '!'");
    let removed = match search.with_removed {
        true => String::new(),
        false => format!(" and {REMOVED} = 0"),
    };
    let sql = format!(
        "where ({} or {} or {}){removed}",
        like("s.name"),
        like("p.english"),
        like("p.korean")
    );
    (sql, vec![Value::Text(format!("%{escaped}%"))])
}

/// Reads the values of a row in turn, each with its type.
pub(crate) struct RowReader {
    values: std::vec::IntoIter<Value>,
    of: &'static str,
}

impl RowReader {
    pub(crate) fn of(values: Vec<Value>, of: &'static str) -> Self {
        let values = values.into_iter();
        RowReader { values, of }
    }

    pub(crate) fn take<T: crate::database::Field>(&mut self, column: &'static str) -> Result<T, StoreError> {
        let value = self.values.next().and_then(T::of);
        value.ok_or(StoreError::WrongValue {
            table: self.of,
            column,
        })
    }
}

/// Seconds from microseconds.
fn seconds(us: i64) -> f64 {
    us as f64 / 1e6
}

fn listed(row: Vec<Value>) -> Result<ListedStructure, StoreError> {
    let mut row = RowReader::of(row, "structure");
    Ok(ListedStructure {
        name: row.take("name")?,
        kind: row.take("kind")?,
        english: row.take("english")?,
        korean: row.take("korean")?,
        latitude_deg: row.take("latitude_deg")?,
        longitude_deg: row.take("longitude_deg")?,
        surveys: row.take("surveys")?,
        first_survey: row.take("first_survey")?,
        last_survey: row.take("last_survey")?,
        stored_s: seconds(row.take("at_us")?),
        who: row.take("who")?,
        is_removed: row.take("is_removed")?,
    })
}

fn structures(
    database: &mut dyn Database,
    condition: &str,
    values: &[Value],
    each: &mut dyn FnMut(ListedStructure) -> Result<(), StoreError>,
) -> Result<(), StoreError> {
    const OF_SURVEYS: &str =
        "from project_survey ps join survey v on v.hash = ps.survey where ps.project = p.hash";
    let arrived = format!(
        "from arrival r join survey v on v.hash = r.survey where r.structure = s.name and {}",
        not_in("p.hash")
    );
    let sql = format!(
        "select s.name, p.kind, p.english, p.korean, p.latitude_deg, p.longitude_deg, \
         (select count(*) {OF_SURVEYS}) + (select count(*) {arrived}), \
         (select min(t) from (select min(v.taken_on) as t {OF_SURVEYS} union all select min(v.taken_on) {arrived}) as dates), \
         (select max(t) from (select max(v.taken_on) as t {OF_SURVEYS} union all select max(v.taken_on) {arrived}) as dates), \
         a.at_us, a.who, {REMOVED} {LATEST} {condition} order by s.name"
    );
    database.query(&sql, values, &mut |row| each(listed(row)?))
}

/// SQL for whether an arrival `r` is not among the surveys of this state of the project; one that was exported and added again is.
pub(crate) fn not_in(project: &str) -> String {
    format!(
        "not exists (select 1 from survey own join project_survey own_ps on own_ps.survey = own.hash \
         where own.structure = r.structure and own.name = r.name and own_ps.project = {project})"
    )
}

impl Store {
    /// Passes the structures to a closure one by one, by name.
    ///
    /// # Errors
    /// If the database cannot be read, or `each` fails.
    pub fn structures(
        &mut self,
        search: &Search,
        each: &mut dyn FnMut(ListedStructure) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let (condition, values) = condition(search);
        structures(self.database.as_mut(), &condition, &values, each)
    }

    /// Passes the surveys of the latest states to a closure one by one, by structure and in the order of the file.
    ///
    /// # Errors
    /// As [`Store::structures`].
    pub fn surveys(
        &mut self,
        search: &Search,
        each: &mut dyn FnMut(ListedSurvey) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let columns = format!(
            "s.name, v.name, v.taken_on, \
             (select e.value from environment e where e.survey = v.hash and e.quantity = '{AIR_TEMPERATURE}'), \
             (select count(*) from record r where r.survey = v.hash), \
             coalesce((select min(m.frequency_hz) from mode m where m.analysis = {LAST_ANALYSIS}), \
              (select min(t.frequency_hz) from stated_mode t where t.survey = v.hash)), \
             (select count(*) from stated_earthquake q where q.survey = v.hash) + \
              (select count(*) from earthquake q where q.analysis = {LAST_ANALYSIS}), \
             coalesce((select q.peak_m_s2 from stated_earthquake q where q.survey = v.hash), \
              (select q.peak_m_s2 from earthquake q where q.analysis = {LAST_ANALYSIS}))"
        );
        let of_state = format!(
            "select {columns} {LATEST} join project_survey ps on ps.project = p.hash join survey v on v.hash = ps.survey \
             where s.name = $1 order by ps.position"
        );
        let arrived = format!(
            "select {columns} {LATEST} join arrival r on r.structure = s.name join survey v on v.hash = r.survey \
             where s.name = $1 and {} order by r.name",
            not_in("p.hash")
        );
        let (condition, values) = condition(search);
        let named = all(
            self.database.as_mut(),
            &format!("select s.name {LATEST} {condition} order by s.name"),
            &values,
        )?;
        for structure in named {
            for sql in [&of_state, &arrived] {
                self.database.query(sql, &structure, &mut |row| {
                    let mut row = RowReader::of(row, "survey");
                    each(ListedSurvey {
                        structure: row.take("structure")?,
                        survey: row.take("name")?,
                        date: row.take("taken_on")?,
                        temperature_c: row.take("temperature_c")?,
                        records: row.take("records")?,
                        lowest_frequency_hz: row.take("frequency_hz")?,
                        has_earthquake: row.take::<i64>("has_earthquake")? > 0,
                        earthquake_peak_m_s2: row.take("peak_m_s2")?,
                    })
                })?;
            }
        }
        Ok(())
    }

    /// A structure with its surveys, states and log; with `survey`, only that survey.
    ///
    /// # Errors
    /// If there is no such structure or survey.
    pub fn structure(&mut self, name: &str, survey: Option<&str>) -> Result<KeptStructure, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, name)?;
        let named = [Value::Text(name.to_owned())];
        let mut found = None;
        structures(database, "where s.name = $1", &named, &mut |listed| {
            found = Some(listed);
            Ok(())
        })?;
        let missing = || StoreFault::NoStructure {
            name: name.to_owned(),
            nearest: None,
        };
        let mut adoptions: Vec<AdoptionRow> =
            select(database, "where structure = $1 order by at_us desc", &named)?;
        let latest = adoptions.first().ok_or_else(missing)?.project.clone();
        let mut surveys = Vec::new();
        for row in surveys_of(database, name, &latest)? {
            if survey.is_none_or(|only| only == row.name) {
                surveys.push(kept_survey(database, row)?);
            }
        }
        if let Some(only) = survey.filter(|_| surveys.is_empty()) {
            let all = surveys_of(database, name, &latest)?;
            let last: Vec<&str> = all.iter().rev().take(5).map(|row| row.name.as_str()).collect();
            return Err(StoreFault::NoSurvey {
                name: only.chars().filter(|sign| !sign.is_control()).collect(),
                known: last.join(", "),
            }
            .into());
        }
        let mut states = Vec::new();
        for adoption in adoptions.drain(..) {
            states.push(state(database, adoption)?);
        }
        let condition = format!("where subject = $1 order by at_us desc limit {LOG_MOST}");
        let log: Vec<LogRow> = select(database, &condition, &named)?;
        Ok(KeptStructure {
            structure: found.ok_or_else(missing)?,
            surveys,
            states,
            log: log.into_iter().map(kept_log).collect(),
        })
    }

    /// The latest state of a project, ready to be written into a folder; [`Store::raw`] reads its files one by one.
    ///
    /// # Errors
    /// If there is no such structure, or a file is missing or has a path that leads out of the folder.
    pub fn export(&mut self, name: &str) -> Result<Exported, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, name)?;
        let named = [Value::Text(name.to_owned())];
        let latest =
            "where hash = (select project from adoption where structure = $1 order by at_us desc limit 1)";
        let projects: Vec<ProjectRow> = select(database, latest, &named)?;
        let Some(project) = projects.into_iter().next() else {
            return Err(StoreFault::NoStructure {
                name: name.to_owned(),
                nearest: None,
            }
            .into());
        };
        let mut files = Vec::new();
        let rows: Vec<ProjectFileRow> = select(
            database,
            "where project = $1 order by path",
            &[Value::Text(project.hash.clone())],
        )?;
        for ProjectFileRow { path, hash, .. } in rows {
            refuse_path(&path)?;
            if path.to_lowercase() != PROJECT_FILE {
                let bytes = raw_bytes(database, &hash)?;
                files.push((path, hash, bytes));
            }
        }
        let bytes = raw_bytes(database, &project.text_hash)?;
        let mut text = self.raw.read(&project.text_hash, bytes)?;
        let own_bytes = text.len();
        let arrived = format!("r where r.structure = $1 and {} order by r.name", not_in("$2"));
        let of = [named[0].clone(), Value::Text(project.hash)];
        for ArrivalRow {
            path, raw, text: own, ..
        } in select(database, &arrived, &of)?
        {
            refuse_path(&path)?;
            let bytes = raw_bytes(database, &raw)?;
            text.extend_from_slice(own.as_bytes());
            files.push((path, raw, bytes));
        }
        Ok(Exported {
            text,
            own_bytes,
            files,
        })
    }

    /// The bytes of a raw file of known size, checked against their hash.
    ///
    /// # Errors
    /// If it is missing, or its bytes differ.
    pub fn raw(&self, hash: &str, bytes: u64) -> Result<Vec<u8>, StoreError> {
        self.raw.read(hash, bytes)
    }
}

fn raw_bytes(database: &mut dyn Database, hash: &str) -> Result<u64, StoreError> {
    let rows = all(
        database,
        "select bytes from raw where hash = $1",
        &[Value::Text(hash.to_owned())],
    )?;
    match rows.first().map(Vec::as_slice) {
        Some([Value::Whole(bytes)]) => Ok(u64::try_from(*bytes).unwrap_or(0)),
        _ => Err(StoreFault::Raw {
            hash: hash.to_owned(),
        }
        .into()),
    }
}

fn surveys_of(
    database: &mut dyn Database,
    structure: &str,
    project: &str,
) -> Result<Vec<SurveyRow>, StoreError> {
    let columns: Vec<String> = SurveyRow::TABLE
        .columns
        .iter()
        .map(|(name, _)| format!("v.{name}"))
        .collect();
    let columns = columns.join(", ");
    let sql = format!(
        "select {columns} from project_survey ps join survey v on v.hash = ps.survey where ps.project = $1 order by ps.position"
    );
    let mut rows = all(database, &sql, &[Value::Text(project.to_owned())])?;
    let sql = format!(
        "select {columns} from arrival r join survey v on v.hash = r.survey where r.structure = $1 and {} order by r.name",
        not_in("$2")
    );
    let of = [Value::Text(structure.to_owned()), Value::Text(project.to_owned())];
    rows.extend(all(database, &sql, &of)?);
    rows.into_iter().map(SurveyRow::of).collect()
}

fn kept_survey(database: &mut dyn Database, row: SurveyRow) -> Result<KeptSurvey, StoreError> {
    let hash = [Value::Text(row.hash)];
    let air: Vec<EnvironmentRow> = select(database, "where survey = $1", &hash)?;
    let mut records = Vec::new();
    let rows: Vec<RecordRow> = select(database, "where survey = $1 order by setup, station", &hash)?;
    for record in rows {
        let of = [
            hash[0].clone(),
            Value::Whole(record.setup),
            Value::Whole(record.station),
        ];
        let sql = "select count(*) from channel where survey = $1 and setup = $2 and station = $3";
        let channels = match all(database, sql, &of)?.first().map(Vec::as_slice) {
            Some([Value::Whole(channels)]) => *channels,
            _ => 0,
        };
        records.push(KeptRecord {
            bytes: raw_bytes(database, &record.hash)? as i64,
            path: record.path,
            hash: record.hash,
            channels,
        });
    }
    let tilts: Vec<TiltRow> = select(database, "where survey = $1 order by direction", &hash)?;
    let stated: Vec<StatedModeRow> =
        select(database, "where survey = $1 order by direction, position", &hash)?;
    let condition =
        "where hash in (select analysis from survey_analysis where survey = $1) order by at_us desc, hash";
    let rows: Vec<AnalysisRow> = select(database, condition, &hash)?;
    let mut analyses = Vec::new();
    for row in rows {
        let of = [Value::Text(row.hash.clone())];
        let modes: Vec<ModeRow> = select(database, "where analysis = $1 order by position", &of)?;
        let found: Vec<EarthquakeRow> = select(database, "where analysis = $1", &of)?;
        let found = found.into_iter().next();
        analyses.push(KeptAnalysis {
            earthquake: found.map(|row| KeptEarthquake {
                peak_m_s2: row.peak_m_s2,
                changed: row.changed,
                changed_sd: row.changed_sd,
            }),
            hash: row.hash,
            version: row.version,
            method: row.method,
            at_s: seconds(row.at_us),
            modes: modes.into_iter().map(identified).collect(),
        });
    }
    let stated_earthquake: Vec<StatedEarthquakeRow> = select(database, "where survey = $1", &hash)?;
    let stated_earthquake = stated_earthquake.into_iter().next();
    Ok(KeptSurvey {
        earthquake: stated_earthquake
            .map(|row| KeptEarthquake {
                peak_m_s2: row.peak_m_s2,
                changed: row.changed,
                changed_sd: row.changed_sd,
            })
            .or_else(|| analyses.first().and_then(|latest| latest.earthquake.clone())),
        name: row.name,
        date: row.taken_on,
        temperature_c: air
            .iter()
            .find(|of| of.quantity == AIR_TEMPERATURE)
            .map(|of| of.value),
        datum: row.datum,
        records,
        tilts: tilts.into_iter().map(kept_tilt).collect(),
        stated_modes: stated.into_iter().map(stated_mode).collect(),
        inspections: inspection_rows::kept(database, &hash)?,
        is_made_up: inspection_rows::is_made_up(database, &hash)?,
        analyses,
    })
}

fn kept_tilt(row: TiltRow) -> KeptTilt {
    KeptTilt {
        direction: row.direction,
        ratio: row.ratio,
        written: row.written,
    }
}

fn stated_mode(row: StatedModeRow) -> KeptMode {
    KeptMode {
        direction: Some(row.direction),
        frequency_hz: row.frequency_hz,
        frequency_sd_hz: row.frequency_sd_hz,
        damping_ratio: row.damping_ratio,
        damping_ratio_sd: row.damping_ratio_sd,
        accepted: false,
    }
}

fn identified(row: ModeRow) -> KeptMode {
    KeptMode {
        direction: None,
        frequency_hz: row.frequency_hz,
        frequency_sd_hz: row.frequency_sd_hz,
        damping_ratio: row.damping_ratio,
        damping_ratio_sd: row.damping_ratio_sd,
        accepted: row.is_accepted,
    }
}

fn kept_log(row: LogRow) -> KeptLog {
    KeptLog {
        at_s: seconds(row.at_us),
        who: row.who,
        verb: row.verb,
        detail: row.detail,
    }
}

fn state(database: &mut dyn Database, adoption: AdoptionRow) -> Result<KeptState, StoreError> {
    let of = [Value::Text(adoption.project.clone())];
    let sql = "select p.dolmen, (select count(*) from project_file f where f.project = p.hash) from project p where p.hash = $1";
    let rows = all(database, sql, &of)?;
    let mut row = RowReader::of(rows.into_iter().next().unwrap_or_default(), "project");
    Ok(KeptState {
        dolmen: row.take("dolmen")?,
        files: row.take("files")?,
        hash: adoption.project,
        stored_s: seconds(adoption.at_us),
        who: adoption.who,
    })
}
