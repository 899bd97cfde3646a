//! Turns a project into rows.

use crate::database::Value;
use crate::earthquake_rows;
use crate::error::StoreError;
use crate::inspection_rows;
use crate::raw::Kept;
use crate::rows::{
    AnalysisRow, ChannelFaultRow, ChannelRow, EnvironmentRow, ModePointRow, ModeRow, ProjectFileRow,
    ProjectRow, ProjectSurveyRow, RawRow, RecordRow, Row, SettingsRow, StatedModeRow, StatedShapeRow,
    SurveyAnalysisRow, SurveyRow, Table, TiltRow,
};
use dolmen::modal::Modes;
use dolmen_project::{Column, EarthquakePart, ModeKind, Project, RecordSource, Survey};
use dolmen_records::stays_within;
use dolmen_work::kept::StoreFault;
use dolmen_work::sensor_alarms::SensorFaults;
use serde_json::{Value as Json, json};
use std::collections::{BTreeMap, BTreeSet};

/// Largest number of bytes in the name of a structure, a path or a person. Our choice.
const NAME_BYTES_MOST: usize = 200;
const PATH_BYTES_MOST: usize = 400;
/// Name of the project file in an exported folder.
pub const PROJECT_FILE: &str = "project.toml";

/// A project to be stored; its text and files are on disk already.
#[derive(Clone, Debug)]
pub struct Incoming<'a> {
    /// The name of the structure in the store.
    pub structure: &'a str,
    /// The project.
    pub project: &'a Project,
    /// Its text.
    pub text: &'a str,
    /// The stored raw file of the text.
    pub text_kept: Kept,
    /// The files that it names, by their paths as it writes them.
    pub files: BTreeMap<String, Kept>,
    /// Modes of the records of surveys, by the name of the survey.
    pub modes: BTreeMap<String, Modes>,
    /// Faults in channels of the records of surveys, by the name of the survey.
    pub faults: SensorFaults,
    /// Earthquakes in the records of surveys, by the name of the survey.
    pub earthquakes: BTreeMap<String, EarthquakePart>,
}

/// Key of an analysis: records, settings and version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct AnalysisKey {
    pub(crate) records: String,
    pub(crate) settings: String,
    pub(crate) settings_text: String,
    pub(crate) version: String,
}

impl AnalysisKey {
    pub(crate) fn hash(&self) -> String {
        analysis_hash(&self.records, &self.settings, &self.version)
    }
}

/// A first row and the rows that belong to it: they are added together, or not at all if the first exists already.
#[derive(Debug)]
pub(crate) struct Group(pub(crate) Vec<(Table, Vec<Value>)>);

/// Groups, each after those that it refers to.
#[derive(Debug, Default)]
pub(crate) struct Rows(pub(crate) Vec<Group>);

impl Rows {
    /// Begins a group.
    pub(crate) fn put<R: Row>(&mut self, row: &R) {
        self.0.push(Group(vec![(R::TABLE, row.values())]));
    }

    /// Adds to the last group.
    pub(crate) fn part<R: Row>(&mut self, row: &R) {
        if let Some(Group(rows)) = self.0.last_mut() {
            rows.push((R::TABLE, row.values()));
        }
    }
}

/// BLAKE3 over pieces, each preceded by its length, so that no two lists of pieces give the same text.
pub(crate) fn hash_of(pieces: &[&str]) -> String {
    let mut hasher = blake3::Hasher::new();
    for piece in pieces {
        hasher.update(&(piece.len() as u64).to_le_bytes());
        hasher.update(piece.as_bytes());
    }
    hasher.finalize().to_hex().to_string()
}

pub(crate) fn project_hash<'a>(
    structure: &str,
    text_hash: &str,
    files: impl Iterator<Item = (&'a str, &'a str)>,
) -> String {
    let mut pieces = vec!["project", structure, text_hash];
    for (path, hash) in files {
        pieces.extend([path, hash]);
    }
    hash_of(&pieces)
}

pub(crate) fn analysis_hash(records: &str, settings: &str, version: &str) -> String {
    hash_of(&["analysis", records, settings, version])
}

pub(crate) fn settings_hash(text: &str) -> String {
    hash_of(&["settings", text])
}

/// The tables of a project file that contain surveys.
pub(crate) struct SurveyTables {
    units: Json,
    surveys: Json,
}

impl SurveyTables {
    /// Reads a text that was accepted as a project before.
    pub(crate) fn of(text: &str) -> Result<Self, StoreError> {
        let unreadable = |why: String| StoreError::Reader(why);
        let root = text
            .parse::<toml::Table>()
            .map_err(|why| unreadable(format!("{why}")))?;
        let root = serde_json::to_value(&root).map_err(|why| unreadable(why.to_string()))?;
        let of = |key: &str| root.get(key).cloned().unwrap_or(Json::Null);
        Ok(SurveyTables {
            units: of("units"),
            surveys: of("survey"),
        })
    }

    /// Reads an arrival: its own table, and the units of the project at that time.
    pub(crate) fn of_arrival(text: &str, units: &str) -> Result<Self, StoreError> {
        let units = serde_json::from_str(units).map_err(|why| StoreError::Reader(why.to_string()))?;
        Ok(SurveyTables {
            units,
            ..SurveyTables::of(text)?
        })
    }

    /// The units, in the form that [`SurveyTables::of_arrival`] reads.
    pub(crate) fn units(&self) -> String {
        self.units.to_string()
    }

    fn survey(&self, name: &str) -> &Json {
        self.surveys.get(name).unwrap_or(&Json::Null)
    }

    /// Names of the surveys.
    pub(crate) fn names(&self) -> Vec<String> {
        let surveys = self.surveys.as_object().into_iter();
        surveys.flat_map(|all| all.keys().cloned()).collect()
    }

    /// The survey's entry in the file, and the bytes of the files that it names.
    pub(crate) fn survey_hash(
        &self,
        structure: &str,
        name: &str,
        hash_of_file: &dyn Fn(&str) -> Option<String>,
    ) -> String {
        let table = self.survey(name);
        let mut texts = Vec::new();
        gather_texts(table, &mut texts);
        let files: Vec<String> = texts.iter().filter_map(|text| hash_of_file(text)).collect();
        hash_of(&[
            "survey",
            structure,
            name,
            &self.units.to_string(),
            &table.to_string(),
            &files.join(" "),
        ])
    }

    /// The settings that determine how the records are read and the modes identified.
    fn settings(&self, name: &str) -> String {
        let table = self.survey(name);
        let of = |key: &str| table.get(key).cloned().unwrap_or(Json::Null);
        let units = &self.units;
        json!({ "records": of("records"), "setups": of("setups"), "merge": of("merge"), "units": units })
            .to_string()
    }
}

fn gather_texts<'a>(value: &'a Json, found: &mut Vec<&'a str>) {
    match value {
        Json::String(text) => found.push(text),
        Json::Array(list) => list.iter().for_each(|value| gather_texts(value, found)),
        Json::Object(table) => table.values().for_each(|value| gather_texts(value, found)),
        Json::Null | Json::Bool(_) | Json::Number(_) => {}
    }
}

pub(crate) fn shown(name: &str) -> String {
    let plain = name
        .chars()
        .map(|sign| if sign.is_control() { '?' } else { sign });
    plain.take(NAME_BYTES_MOST).collect()
}

/// Refuses a name that is empty, too long, or contains control characters for a terminal.
pub(crate) fn refuse_name(what: &'static str, name: &str) -> Result<(), StoreError> {
    let steers = |sign: char| {
        sign.is_control()
            || matches!(sign, '\u{200e}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    match name.trim().is_empty() || name.len() > NAME_BYTES_MOST || name.chars().any(steers) {
        true => Err(StoreFault::Name {
            what,
            shown: shown(name),
        }
        .into()),
        false => Ok(()),
    }
}

/// Refuses a path that leads out of its folder on any system.
pub(crate) fn refuse_path(path: &str) -> Result<(), StoreError> {
    let is_good = stays_within(path)
        && path.len() <= PATH_BYTES_MOST
        && !path.chars().any(char::is_control)
        && path
            .split(['/', '\\'])
            .all(|part| !part.is_empty() && part.len() <= NAME_BYTES_MOST);
    match is_good {
        true => Ok(()),
        false => Err(StoreFault::Name {
            what: "path",
            shown: shown(path),
        }
        .into()),
    }
}

/// The date at the beginning of a survey's name: "2019", "2019-04" or "2019-04-02".
fn date(name: &str) -> Option<String> {
    dolmen_work::survey_date(name).map(|[year, month, day]| match (month, day) {
        (0, _) => format!("{year:04}"),
        (month, 0) => format!("{year:04}-{month:02}"),
        (month, day) => format!("{year:04}-{month:02}-{day:02}"),
    })
}

/// A finite number; an infinite deviation gives no information.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

impl Incoming<'_> {
    /// Refuses a project that cannot be stored.
    pub(crate) fn refuse(&self) -> Result<(), StoreError> {
        refuse_name("structure", self.structure)?;
        self.files.keys().try_for_each(|path| refuse_path(path))
    }

    pub(crate) fn hash(&self) -> String {
        let files = self.files.iter();
        let files = files.map(|(path, kept)| (path.as_str(), kept.hash.as_str()));
        project_hash(self.structure, &self.text_kept.hash, files)
    }

    /// Key of the analysis of a survey's records; `None` if it has none.
    pub(crate) fn key(&self, survey: &Survey, tables: &SurveyTables) -> Option<AnalysisKey> {
        let mut hashes = vec!["records"];
        for (_, _, source) in sources(survey) {
            hashes.push(&self.files.get(&source.file)?.hash);
        }
        if hashes.len() == 1 {
            return None;
        }
        let settings_text = tables.settings(&survey.name);
        Some(AnalysisKey {
            records: hash_of(&hashes),
            settings: settings_hash(&settings_text),
            settings_text,
            version: env!("CARGO_PKG_VERSION").to_owned(),
        })
    }

    /// The kind of its structure, as the project file writes it.
    pub(crate) fn kind(&self) -> &'static str {
        dolmen_work::Kind::of(&self.project.structure).word()
    }

    /// Rows of the project, its files and surveys; `known` lists the analyses in the store.
    pub(crate) fn rows(&self, known: &BTreeSet<String>, who: &str, at_us: i64) -> Result<Rows, StoreError> {
        let tables = SurveyTables::of(self.text)?;
        let mut rows = Rows::default();
        let kept = std::iter::once(&self.text_kept).chain(self.files.values());
        for Kept { hash, bytes, .. } in kept {
            rows.put(&RawRow {
                hash: hash.clone(),
                bytes: *bytes as i64,
                at_us,
            });
        }
        let project = self.hash();
        let mut members = Vec::new();
        for (position, survey) in self.project.surveys.iter().enumerate() {
            let hash_of_file = |path: &str| self.files.get(path).map(|kept| kept.hash.clone());
            let hash = tables.survey_hash(self.structure, &survey.name, &hash_of_file);
            self.survey(&mut rows, survey, &hash)?;
            if let Some(key) = self.key(survey, &tables) {
                let modes = self.modes.get(&survey.name);
                if let Some(modes) = modes {
                    analysis(&mut rows, modes, &key, (who, at_us));
                    self.earthquake_of(&mut rows, &survey.name, &key);
                    self.faults_of(&mut rows, &survey.name, &hash);
                }
                if modes.is_some() || known.contains(&key.hash()) {
                    rows.put(&SurveyAnalysisRow {
                        survey: hash.clone(),
                        analysis: key.hash(),
                    });
                }
            }
            members.push(ProjectSurveyRow {
                project: project.clone(),
                position: position as i64 + 1,
                survey: hash,
            });
        }
        let place = self.project.place.as_ref();
        rows.put(&ProjectRow {
            hash: project.clone(),
            structure: self.structure.to_owned(),
            text_hash: self.text_kept.hash.clone(),
            kind: self.kind().to_owned(),
            english: self.project.name.english().to_owned(),
            korean: self.project.name.korean().to_owned(),
            latitude_deg: place.map(|place| place.latitude_deg),
            longitude_deg: place.map(|place| place.longitude_deg),
            dolmen: env!("CARGO_PKG_VERSION").to_owned(),
        });
        for (path, kept) in &self.files {
            rows.part(&ProjectFileRow {
                project: project.clone(),
                path: path.clone(),
                hash: kept.hash.clone(),
            });
        }
        members.iter().for_each(|member| rows.part(member));
        Ok(rows)
    }

    /// Rows of the channel faults of a survey's records.
    pub(crate) fn faults_of(&self, rows: &mut Rows, survey: &str, hash: &str) {
        for (channel, fault) in self.faults.get(survey).into_iter().flatten() {
            rows.put(&ChannelFaultRow {
                survey: hash.to_owned(),
                channel: shown(channel),
                fault: fault.word().to_owned(),
            });
        }
    }

    /// Rows of the earthquake of a survey's records, after the analysis that found it.
    fn earthquake_of(&self, rows: &mut Rows, survey: &str, key: &AnalysisKey) {
        if let Some(of) = self.earthquakes.get(survey) {
            rows.part(&earthquake_rows::found(key.hash(), of));
        }
    }

    pub(crate) fn survey(&self, rows: &mut Rows, survey: &Survey, hash: &str) -> Result<(), StoreError> {
        rows.put(&SurveyRow {
            hash: hash.to_owned(),
            structure: self.structure.to_owned(),
            name: survey.name.clone(),
            taken_on: date(&survey.name),
            datum: survey.datum.clone(),
            note: survey.note.clone(),
            source: survey.filed_as(),
        });
        if let Some(value) = survey.temperature_c {
            rows.part(&EnvironmentRow {
                survey: hash.to_owned(),
                quantity: AIR_TEMPERATURE.to_owned(),
                value,
                unit: "°C".to_owned(),
            });
        }
        for (direction, tilt) in &survey.tilt {
            rows.part(&TiltRow {
                survey: hash.to_owned(),
                direction: direction.clone(),
                ratio: tilt.ratio,
                written: tilt.written.clone(),
                datum: survey.datum.clone(),
            });
        }
        stated(rows, survey, hash);
        for (setup, station, source) in sources(survey) {
            let Some(kept) = self.files.get(&source.file) else {
                let shown = source.file.clone();
                return Err(StoreFault::Name { what: "path", shown }.into());
            };
            record(rows, source, &kept.hash, (hash, setup, station));
        }
        // separately: an earlier version stored the survey without it
        let entries = inspection_rows::entries(survey, hash);
        entries.iter().for_each(|row| rows.put(row));
        let made_up = inspection_rows::made_up(survey, hash);
        made_up.iter().for_each(|row| rows.put(row));
        if let Some(of) = &survey.earthquake {
            rows.put(&earthquake_rows::stated(hash, of));
        }
        Ok(())
    }
}

/// The quantity of [`EnvironmentRow`] for a survey's `temperature_c`.
pub(crate) const AIR_TEMPERATURE: &str = "air_temperature";

/// The record files of a survey with the numbers of their setup and station, from 1.
fn sources(survey: &Survey) -> Vec<(i64, i64, &RecordSource)> {
    let each = survey.records.iter().chain(&survey.setups);
    let mut all = Vec::new();
    for (setup, source) in each.enumerate() {
        let stations = match source.stations.as_slice() {
            [] => std::slice::from_ref(source),
            stations => stations,
        };
        for (station, source) in stations.iter().enumerate() {
            all.push((setup as i64 + 1, station as i64 + 1, source));
        }
    }
    all
}

fn stated(rows: &mut Rows, survey: &Survey, hash: &str) {
    for (direction, modes) in &survey.modes {
        for (at, mode) in modes.iter().enumerate() {
            let position = at as i64 + 1;
            let sd = |of: &dolmen_project::Quantity| of.cov.map(|_| of.standard_deviation());
            rows.part(&StatedModeRow {
                survey: hash.to_owned(),
                direction: direction.clone(),
                position,
                frequency_hz: mode.frequency.value,
                frequency_sd_hz: sd(&mode.frequency),
                damping_ratio: mode.damping_ratio.as_ref().map(|damping| damping.value),
                damping_ratio_sd: mode.damping_ratio.as_ref().and_then(sd),
                kind: match mode.kind {
                    ModeKind::Translation => "translation",
                    ModeKind::Torsion => "torsion",
                }
                .to_owned(),
            });
            for (point, of) in mode.shape.iter().enumerate() {
                rows.part(&StatedShapeRow {
                    survey: hash.to_owned(),
                    direction: direction.clone(),
                    mode: position,
                    position: point as i64 + 1,
                    height_m: of.height_m,
                    displacement: of.displacement,
                    displacement_sd: of.displacement_sd,
                });
            }
        }
    }
}

fn record(rows: &mut Rows, source: &RecordSource, hash: &str, (survey, setup, station): (&str, i64, i64)) {
    rows.part(&RecordRow {
        survey: survey.to_owned(),
        setup,
        station,
        path: source.file.clone(),
        hash: hash.to_owned(),
        format: source.format.map(|format| format.name().to_owned()),
        sampling_rate_hz: source.sampling_rate_hz,
        unit: source.unit.clone(),
        scale: source.scale,
    });
    for (at, channel) in source.channels.iter().enumerate() {
        let [x_m, y_m, z_m] = channel.position_m.map_or([None; 3], |place| place.map(Some));
        let [direction_x, direction_y, direction_z] =
            channel.direction.map_or([None; 3], |way| way.map(Some));
        rows.part(&ChannelRow {
            survey: survey.to_owned(),
            setup,
            station,
            position: at as i64 + 1,
            source_column: match &channel.column {
                Column::Number(number) => number.to_string(),
                Column::Name(name) => name.clone(),
            },
            name: channel.name.clone(),
            x_m,
            y_m,
            z_m,
            direction_x,
            direction_y,
            direction_z,
            scale: channel.scale,
            is_left_out: channel.leave_out,
        });
    }
}

pub(crate) fn analysis(rows: &mut Rows, modes: &Modes, key: &AnalysisKey, (who, at_us): (&str, i64)) {
    let hash = key.hash();
    rows.put(&SettingsRow {
        hash: key.settings.clone(),
        text: key.settings_text.clone(),
    });
    rows.put(&AnalysisRow {
        hash: hash.clone(),
        records: key.records.clone(),
        settings: key.settings.clone(),
        version: key.version.clone(),
        method: modes.method.name().to_owned(),
        duration_s: modes.duration_s,
        at_us,
        who: who.to_owned(),
    });
    for (at, mode) in modes.modes.iter().enumerate() {
        let position = at as i64 + 1;
        rows.part(&ModeRow {
            analysis: hash.clone(),
            position,
            frequency_hz: mode.frequency_hz,
            frequency_sd_hz: mode.frequency_sd_hz.and_then(finite),
            damping_ratio: mode.damping_ratio.and_then(finite),
            damping_ratio_sd: mode.damping_ratio_sd.and_then(finite),
            phase_collinearity: finite(mode.phase_collinearity),
            is_accepted: !mode.is_found(),
        });
        for (point, (channel, part)) in modes.channels.iter().zip(&mode.shape).enumerate() {
            let sd = mode.shape_sd.as_ref().and_then(|sd| sd.get(point).copied());
            rows.part(&ModePointRow {
                analysis: hash.clone(),
                mode: position,
                position: point as i64 + 1,
                channel: channel.name.clone(),
                real_part: part.re,
                imaginary_part: part.im,
                sd: sd.and_then(finite),
            });
        }
    }
}
