//! Modes found in the records of a structure, as the history of its surveys needs them, and its files.

use crate::database::{Value, all};
use crate::error::StoreError;
use crate::find::{Exported, LAST_ANALYSIS, RowReader, not_in};
use crate::store::{Store, refuse_unknown};
use crate::stored_files::StoredFiles;
use dolmen::modal::{ObservedMode, ObservedPoint};
use dolmen::signal::Channel;
use dolmen_linalg::Complex64;
use dolmen_project::EarthquakePart;
use dolmen_work::sensor_alarms::{SensorFault, SensorFaults};
use std::collections::BTreeMap;

/// The latest state of the project of a structure.
const LATEST: &str = "(select project from adoption where structure = $1 order by at_us desc limit 1)";

impl Store {
    /// The files of a stored project, read on demand.
    pub fn files(&self, project: &Exported) -> StoredFiles {
        let files = project.files.iter();
        let files = files.map(|(path, hash, bytes)| (path.clone(), (hash.clone(), *bytes)));
        StoredFiles::new(self.raw.clone(), files.collect())
    }

    /// Faults in channels of the records of a structure's surveys.
    ///
    /// # Errors
    /// If there is no such structure, or the database cannot be read.
    pub fn faults(&mut self, name: &str) -> Result<SensorFaults, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, name)?;
        let sql = format!(
            "select v.name as survey, c.channel, c.fault from project_survey ps join survey v on v.hash = ps.survey \
             join channel_fault c on c.survey = v.hash where ps.project = {LATEST} \
             union all select v.name, c.channel, c.fault from arrival r join survey v on v.hash = r.survey \
             join channel_fault c on c.survey = v.hash where r.structure = $1 and {} order by survey",
            not_in(LATEST)
        );
        let mut found = SensorFaults::new();
        for row in all(database, &sql, &[Value::Text(name.to_owned())])? {
            let mut row = RowReader::of(row, "channel_fault");
            let (survey, channel): (String, String) = (row.take("survey")?, row.take("channel")?);
            let word: String = row.take("fault")?;
            // a later version may have other kinds of fault
            if let Some(fault) = SensorFault::of_word(&word) {
                found.entry(survey).or_default().push((channel, fault));
            }
        }
        Ok(found)
    }

    /// The earthquakes in the records of a structure's surveys, from the latest analysis.
    ///
    /// # Errors
    /// If there is no such structure, or the database cannot be read.
    pub fn earthquakes(&mut self, name: &str) -> Result<BTreeMap<String, EarthquakePart>, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, name)?;
        let of = format!(
            "e.peak_m_s2, e.changed, e.changed_sd from {{}} join earthquake e on e.analysis = {LAST_ANALYSIS}"
        );
        let [own, arrived] = [
            "project_survey ps join survey v on v.hash = ps.survey",
            "arrival r join survey v on v.hash = r.survey",
        ]
        .map(|surveys| format!("select v.name as survey, {}", of.replace("{}", surveys)));
        let sql = format!(
            "{own} where ps.project = {LATEST} union all {arrived} where r.structure = $1 and {} order by survey",
            not_in(LATEST)
        );
        let mut found = BTreeMap::new();
        for row in all(database, &sql, &[Value::Text(name.to_owned())])? {
            let mut row = RowReader::of(row, "earthquake");
            let survey: String = row.take("survey")?;
            let part = EarthquakePart {
                peak_m_s2: row.take("peak_m_s2")?,
                is_at_least: false, // rows do not hold it; the table of a survey does
                changed: row.take("changed")?,
                changed_sd: row.take("changed_sd")?,
            };
            found.insert(survey, part);
        }
        Ok(found)
    }

    /// The modes of each survey of the latest state that has records, by the latest analysis of them.
    ///
    /// # Errors
    /// If there is no such structure, or the database cannot be read.
    pub fn observed(&mut self, name: &str) -> Result<BTreeMap<String, Vec<ObservedMode>>, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, name)?;
        let columns = "v.name as survey, m.position as mode, m.frequency_hz, m.frequency_sd_hz, m.damping_ratio, m.damping_ratio_sd, m.is_accepted, \
             q.channel, q.real_part, q.imaginary_part, q.position as point";
        let modes = format!(
            "join mode m on m.analysis = {LAST_ANALYSIS} left join mode_point q on q.analysis = m.analysis and q.mode = m.position"
        );
        let sql = format!(
            "select {columns}, 0 as is_arrival, ps.position as place from project_survey ps join survey v on v.hash = ps.survey {modes} \
             where ps.project = {LATEST} \
             union all select {columns}, 1, 0 from arrival r join survey v on v.hash = r.survey {modes} \
             where r.structure = $1 and {} order by is_arrival, place, survey, mode, point",
            not_in(LATEST)
        );
        let mut found: BTreeMap<String, Vec<ObservedMode>> = BTreeMap::new();
        let mut last = None;
        for row in all(database, &sql, &[Value::Text(name.to_owned())])? {
            let mut row = RowReader::of(row, "mode");
            let survey: String = row.take("survey")?;
            let position: i64 = row.take("position")?;
            let mode = ObservedMode {
                frequency_hz: row.take("frequency_hz")?,
                frequency_sd_hz: row.take("frequency_sd_hz")?,
                damping_ratio: row.take("damping_ratio")?,
                damping_ratio_sd: row.take("damping_ratio_sd")?,
                degrees_of_freedom: f64::INFINITY,
                direction: None,
                accepted: row.take::<Option<bool>>("is_accepted")?.unwrap_or(false),
                shape: Vec::new(),
            };
            let channel: Option<String> = row.take("channel")?;
            let parts: [Option<f64>; 2] = [row.take("real_part")?, row.take("imaginary_part")?];
            let modes = found.entry(survey.clone()).or_default();
            if last.as_ref() != Some(&(survey.clone(), position)) {
                last = Some((survey, position));
                modes.push(mode);
            }
            if let (Some(channel), [Some(re), Some(im)], Some(mode)) = (channel, parts, modes.last_mut()) {
                mode.shape.push(ObservedPoint {
                    channel: Channel::named(channel),
                    component: Complex64::new(re, im),
                });
            }
        }
        Ok(found)
    }
}
