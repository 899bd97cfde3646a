//! The plan of a study: its cases with their inputs, its motions, and the fingerprint of everything that determines the results.

use super::answer::StudyAnswer;
use super::before::EarlierShaking;
use super::combination_limits::{drift_limit_of, unknown_directions};
use super::combination_motions::{across_left_out, along, counted_otherwise, meets_both, vertical_left_out};
use super::earthquake_of::EarthquakeOf;
use super::error::StudyError;
use super::fitted::Fitted;
use super::input_columns::{CaseInputs, InputColumn};
use super::inputs::{
    Drawn, ReadCombination, case_inputs, drawn, drawn_units, input_columns, set_shown, set_values, value_at,
    written_units,
};
use super::journal::JournalHeader;
use super::kind::StudyKind;
use super::model::{is_undamped, on_columns};
use super::motions::{PreparedMotion, copies, motion_names, prepared};
use super::run::Run;
use super::shaking_measure::ShakingScales;
use super::some_runs::{DamageInRuns, damage_in_runs, said_of_runs};
use super::too_large::refuse_too_large;
use crate::error::WorkError;
use crate::fingerprint::fingerprint;
use crate::in_runs::{LeftOutOfRuns, held_in_runs};
use crate::opened::Opened;
use crate::stack;
use crate::wrong::OfRuns;
use dolmen::assess::{RockingScale, rocking_scale};
use dolmen::stability::stack::{StackLimits, stack_limits};
use dolmen_project::{
    Axis, HazardPart, LawPart, MotionSize, Override, Problem, Project, Quantity, Scan, Structure, StudyPart,
    canonical_text, parse_combination,
};
use dolmen_records::Files;
use dolmen_words::message::Both;
use dolmen_words::{Language, Unit};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// A study ready to run.
pub struct Plan<'o> {
    pub(super) opened: &'o Opened,
    pub(super) files: &'o dyn Files,
    /// The study.
    pub study: &'o StudyPart,
    /// The kind of structure.
    pub kind: StudyKind,
    /// Motions by name, as in the file, without changes of a case.
    pub(super) motions: Vec<(String, PreparedMotion)>,
    /// The motion before the runs, as in the file.
    pub(super) first: Option<PreparedMotion>,
    /// The state of each case after it, computed on first use; empty without one.
    pub(super) before: Vec<OnceLock<EarlierShaking>>,
    pub(super) inputs: Vec<InputColumn>,
    pub(super) cases: Vec<CaseInputs>,
    /// For each combination, the fingerprint of everything that its model is built from.
    models: Vec<String>,
    /// Properties of the file that runs leave out, and those that they include in addition to the structure.
    pub(super) left_out: Vec<Both>,
    held: Vec<Both>,
    /// Damage of inspections in the models of the runs.
    damage: Vec<DamageInRuns>,
    /// Units in which random inputs are shown.
    pub(super) drawn_units: BTreeMap<String, Unit>,
    /// Values that the study sets, as shown.
    set_shown: Vec<String>,
    /// The allowable drift and the hazard that all combinations share.
    pub(super) drift_limit: Option<f64>,
    pub(super) hazard: Option<HazardPart>,
    /// Whether runs of a combination have neither damping nor friction.
    is_undamped: bool,
    /// Whether columns alone support a storey in runs of a combination.
    on_columns: bool,
    fingerprints: Vec<(String, String)>,
}

impl<'o> Plan<'o> {
    /// Reads every combination once, and its motions.
    ///
    /// # Errors
    /// A kind that cannot be studied, motions that cannot be read, a study without shaking, with too many scans, or with samples but no
    /// uncertain inputs.
    pub fn of(opened: &'o Opened, study: &'o StudyPart, files: &'o dyn Files) -> Result<Self, WorkError> {
        let kind = match &opened.project.structure {
            Structure::Stack(_) => StudyKind::Stack,
            Structure::Frame(_) => StudyKind::Frame,
            Structure::Chain(_) => StudyKind::Chain,
            Structure::Building(_) => StudyKind::Building,
            Structure::Survey => return Err(StudyError::SurveyStudied.into()),
        };
        let mut motions = Vec::new();
        if study.scan.is_some() {
            for name in motion_names(study)? {
                let motion = prepared(&opened.project, files, study, &name)?;
                motions.push((name, motion));
            }
        } else if matches!(kind, StudyKind::Stack | StudyKind::Building)
            || (study.harmonic.is_none() && study.release_m.is_none())
        {
            return Err(StudyError::StudyWithoutScan.into());
        }
        refuse_too_large(study, motions.len())?;
        let mut plan = Plan {
            opened,
            files,
            study,
            kind,
            motions,
            first: None,
            before: Vec::new(),
            inputs: Vec::new(),
            cases: Vec::new(),
            models: Vec::new(),
            left_out: Vec::new(),
            held: Vec::new(),
            damage: Vec::new(),
            drawn_units: BTreeMap::new(),
            set_shown: Vec::new(),
            drift_limit: None,
            hazard: None,
            is_undamped: false,
            on_columns: false,
            fingerprints: Vec::new(),
        };
        plan.read_inputs()?;
        plan.prepare_before()?;
        if study.samples.is_some_and(|samples| samples > 1) && !plan.inputs.iter().any(|input| input.is_drawn)
        {
            return Err(StudyError::StudySamplesNothing {
                samples: study.samples.unwrap_or(1),
            }
            .into());
        }
        plan.fingerprints = plan.fingerprints()?;
        Ok(plan)
    }

    /// Reads every combination once: its inputs, and whether it is possible.
    fn read_inputs(&mut self) -> Result<(), WorkError> {
        let samples = self.study.samples.unwrap_or(1);
        let read: Vec<ReadCombination> = (0..self.study.combinations())
            .into_par_iter()
            .map(|combination| {
                let project = self.project(combination).ok();
                let draw = |sample| match (&project, self.study.samples) {
                    (Some(project), Some(_)) => drawn(project, self.study.seed, sample as u64),
                    _ => Ok(Drawn::default()),
                };
                let value = |(index, axis): (usize, &Axis)| match &self.study.after {
                    Some(after) if after.axis == Some(index) => size_before(self.study, combination),
                    _ => value_at(project.as_ref(), &axis.path),
                };
                let model = project.as_ref().map_or(String::new(), |project| {
                    let all = format!(
                        "{:?}{:?}{}",
                        project.structure, project.loads, project.gravity_m_s2
                    );
                    fingerprint(all.as_bytes())
                });
                let is_rigid = self.study.law == LawPart::Rigid;
                let left_out = project.as_ref().map(|project| {
                    let mut all = LeftOutOfRuns::of(project).words(is_rigid);
                    all.extend(unknown_directions(self.study, project));
                    all.extend(across_left_out(self.study, project, &self.motions));
                    all
                });
                Ok(ReadCombination {
                    model,
                    left_out: left_out.unwrap_or_default(),
                    held: project.as_ref().map(held_in_runs).unwrap_or_default(),
                    damage: project
                        .as_ref()
                        .map(|project| project.damage.clone())
                        .unwrap_or_default(),
                    on_columns: project
                        .as_ref()
                        .is_some_and(|project| on_columns(self.study, project)),
                    is_undamped: project
                        .as_ref()
                        .is_some_and(|project| is_undamped(self.study, project)),
                    drift_limit: drift_limit_of(project.as_ref()),
                    hazard: project
                        .as_ref()
                        .and_then(|project| project.site.as_ref()?.hazard.clone()),
                    samples: (0..samples).map(draw).collect::<Result<_, WorkError>>()?,
                    values: self.study.vary.iter().enumerate().map(value).collect(),
                    written: written_units(self.study, project.as_ref()),
                    set: set_values(self.study, project.as_ref()),
                })
            })
            .collect::<Result<_, WorkError>>()?;
        self.inputs = input_columns(self.study, &read);
        self.models = read.iter().map(|read| read.model.clone()).collect();
        let left_out: Vec<_> = read.iter().map(|read| read.of_runs(&read.left_out)).collect();
        self.left_out = said_of_runs(self.study, &left_out);
        if self.kind != StudyKind::Stack {
            self.left_out.extend(vertical_left_out(&self.motions));
        }
        self.take_limits(&read);
        self.is_undamped = read.iter().any(|read| read.is_undamped);
        self.on_columns = read.iter().any(|read| read.on_columns);
        let held: Vec<_> = read.iter().map(|read| read.of_runs(&read.held)).collect();
        self.held = said_of_runs(self.study, &held);
        let damage: Vec<_> = read.iter().map(|read| read.of_runs(&read.damage)).collect();
        self.damage = damage_in_runs(self.study, &damage);
        self.drawn_units = drawn_units(&self.inputs, &read);
        self.set_shown = set_shown(self.study, &read);
        for (combination, read) in read.iter().enumerate() {
            let (variant, values) = self.study.combination(combination);
            let cases = read
                .samples
                .iter()
                .map(|sample| case_inputs((variant, &values), read, sample, &self.inputs));
            self.cases.extend(cases);
        }
        Ok(())
    }

    fn fingerprints(&self) -> Result<Vec<(String, String)>, WorkError> {
        let file = &self.opened.file;
        let text = canonical_text(&self.opened.text, file, &self.study.name)?;
        let mut all = vec![("the project file".to_owned(), fingerprint(text.as_bytes()))];
        for (name, motion) in &self.motions {
            all.push((format!("motion {name}"), motion.fingerprint()));
        }
        if let Some((after, motion)) = self.study.after.as_ref().zip(self.first.as_ref()) {
            all.push((
                format!("motion {} before the runs", after.motion),
                motion.fingerprint(),
            ));
        }
        let cases = format!("{:?}{:?}", self.inputs, self.cases); // includes the files that the project names
        all.push(("inputs of the cases".to_owned(), fingerprint(cases.as_bytes())));
        // everything that a model is built from, including files and the tilt of a survey
        let models = self.models.join(" ");
        all.push(("the structure as read".to_owned(), fingerprint(models.as_bytes())));
        all.extend(counted_otherwise(self.study, &self.opened.project, &self.motions));
        if self.study.samples.is_some() {
            // older journals list samples that fall by themselves as refused
            all.push(("samples that fall by themselves".to_owned(), "counted".to_owned()));
        }
        Ok(all)
    }

    /// The project of a combination, or the reason for its absence, in one line.
    pub(super) fn project(&self, combination: usize) -> Result<Project, Both> {
        let (variant, _) = self.study.combination(combination);
        let laid: Vec<&Override> = self.study.laid_over(combination);
        let file = &self.opened.file;
        parse_combination(&self.opened.text, file, self.files, variant, &laid).map_err(|error| {
            let first = error.problems.first();
            first.map_or_else(
                || Both::from(""),
                |problem| Both::of(|language| in_one_line(problem, file, language)),
            )
        })
    }

    /// The motion of a case by its index: that of the file unless the case changes it, with the remaining rotation. A frame or a chain
    /// moves in one plane: its motion is already rotated, with the size of the acting component.
    pub(super) fn motion(
        &self,
        project: &Project,
        index: usize,
        turn_rad: f64,
    ) -> Result<(PreparedMotion, f64), WorkError> {
        let (name, own) = self.motions.get(index).ok_or(StudyError::StudyWithoutMotion)?;
        let part = |project: &Project| project.motions.iter().find(|part| part.name == *name).cloned();
        let motion = match part(project) == part(&self.opened.project) {
            true => own.clone(),
            false => prepared(project, self.files, self.study, name)?,
        };
        Ok(match self.kind {
            // its components act along and across
            StudyKind::Chain | StudyKind::Frame if self.meets_both(project) => (motion, turn_rad),
            StudyKind::Frame | StudyKind::Chain => {
                (motion.in_plane(turn_rad, along(self.study, project))?, 0.0)
            }
            _ => (motion, turn_rad),
        })
    }

    /// Whether both components of a motion, along x and along y, act on the structure.
    pub(super) fn meets_both(&self, project: &Project) -> bool {
        meets_both(self.study, project)
    }

    /// Factors on a motion, ascending.
    pub(super) fn scales(&self, motion: &PreparedMotion) -> Vec<f64> {
        match &self.study.scan {
            Some(Scan::Scales(scales)) => scales.clone(),
            Some(Scan::Peaks(peaks)) => peaks.iter().map(|peak| peak / motion.peak_m_s2).collect(),
            None => Vec::new(),
        }
    }

    /// Peak of the ground at a factor, m/s²; exactly the given one if the study gives peaks.
    pub(super) fn peak_at(&self, grid: &[f64], scale: f64, motion: &PreparedMotion) -> f64 {
        let given = match &self.study.scan {
            Some(Scan::Peaks(peaks)) => grid
                .iter()
                .position(|on| *on == scale)
                .and_then(|at| peaks.get(at)),
            _ => None,
        };
        given.copied().unwrap_or(scale * motion.peak_m_s2)
    }

    /// The factors of a scan, without preparing the rest of it; `None` if its inputs are refused.
    pub(super) fn grid_of(&self, job: usize) -> Option<Vec<f64>> {
        let turns = self.study.turns_rad.len();
        let (case, motion) = (
            job / (self.motions.len() * turns),
            job / turns % self.motions.len(),
        );
        let turn_rad = self.study.turns_rad[job % turns];
        let found = match self.varies_motions() {
            false => self.motion(&self.opened.project, motion, turn_rad),
            true => self.motion(&self.project(case / self.samples()).ok()?, motion, turn_rad),
        };
        Some(self.scales(&found.ok()?.0))
    }

    /// Whether a case may have another motion than the file.
    fn varies_motions(&self) -> bool {
        let paths = self.study.set.iter().map(|set| &set.path);
        let mut paths = paths.chain(self.study.vary.iter().map(|axis| &axis.path));
        !self.study.variants.is_empty() || paths.any(|path| path.starts_with("motion"))
    }

    /// Data for measures of shaking, and names of the joints, by combination.
    fn scales_and_joints(&self) -> (ShakingScales, Vec<Vec<String>>) {
        let (periods_s, damping) = (&self.study.spectral_periods_s, self.study.spectral_damping_ratio);
        let turns = &self.study.turns_rad;
        let motions = (0..self.motions.len()).filter(|_| !self.varies_motions());
        let each = motions.flat_map(|index| turns.iter().map(move |turn| (index, *turn)));
        let each = each.map(|(index, turn)| {
            let (motion, _) = self.motion(&self.opened.project, index, turn)?;
            Ok(motion.spectral_over_peak(periods_s, damping)?)
        });
        let spectral: Result<Vec<Vec<f64>>, WorkError> = each.collect();
        let mut shaking = ShakingScales {
            spectral_over_peak: spectral.unwrap_or_default(), // a period too short for a record
            rocking: Vec::new(),
        };
        if self.kind != StudyKind::Stack {
            return (shaking, Vec::new());
        }
        let each = (0..self.study.combinations()).into_par_iter();
        let each = each.map(|combination| self.of_stack(combination).unwrap_or_default());
        let (rocking, joints) = each.unzip();
        shaking.rocking = rocking;
        (shaking, joints)
    }

    /// The rocking scale and the joints of the stack of a combination, with its mean inputs.
    fn of_stack(&self, combination: usize) -> Option<(Option<RockingScale>, Vec<String>)> {
        let project = self.project(combination).ok()?;
        let Structure::Stack(part) = &project.structure else {
            return None;
        };
        let stack = stack::check::with_gaps(part.build(&mut Quantity::nominal).ok()?).ok()?;
        let limits = stack_limits(&stack, &StackLimits::default()).ok()?;
        let names = stack.joints().iter();
        let names = names.map(|joint| stack::study::joint_words(&stack, joint));
        let scale = rocking_scale(&stack, &limits, self.axis()).ok().flatten();
        Some((scale, names.collect()))
    }

    /// The one axis along which every motion shakes; `None` if there are several.
    fn axis(&self) -> Option<[f64; 2]> {
        self.axis_of_file().filter(|_| !self.varies_motions())
    }

    /// The same for the motions of the file, without changes by variants.
    fn axis_of_file(&self) -> Option<[f64; 2]> {
        let [turn] = self.study.turns_rad.as_slice() else {
            return None;
        };
        let mut along = self.motions.iter().map(|(_, motion)| motion.axis(*turn));
        let first = along.next()??;
        along.all(|other| other == Some(first)).then_some(first)
    }

    /// Number of scans.
    pub fn jobs(&self) -> usize {
        self.cases.len() * self.motions.len() * self.study.turns_rad.len()
    }

    pub(super) fn samples(&self) -> usize {
        self.study.samples.unwrap_or(1)
    }

    /// The header of the journal of a shard: everything that determines its results.
    pub fn header(&self, shard: (usize, usize)) -> JournalHeader {
        JournalHeader {
            study: self.study.name.clone(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            jobs: self.jobs(),
            shard,
            inputs: self.fingerprints.clone(),
        }
    }

    pub(super) fn answer(&self, mut runs: Vec<Run>, missing: Vec<usize>) -> StudyAnswer {
        runs.sort_by(|a, b| a.job.cmp(&b.job).then(a.scale.total_cmp(&b.scale)));
        let (shaking, joints) = match self.study.scan {
            Some(_) => self.scales_and_joints(),
            None => Default::default(),
        };
        StudyAnswer {
            shaking,
            joints,
            file: self.opened.file.clone(),
            name: self.opened.project.name.clone(),
            study: self.study.clone(),
            kind: self.kind,
            gravity_m_s2: self.opened.project.gravity_m_s2,
            drift_limit: self.drift_limit,
            // the hazard of the site does not apply to shaking after another earthquake
            hazard: match &self.study.after {
                Some(_) => None,
                None => self.hazard.clone(),
            },
            before: self.states_before(),
            leans_at_rest: self.leans_at_rest(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            notes: self.notes(),
            model_damage: self.damage.clone(),
            drawn_units: self.drawn_units.clone(),
            set_shown: self.set_shown.clone(),
            left_out_of_runs: self.left_out.clone(),
            is_undamped: self.is_undamped,
            on_columns: self.on_columns,
            copies: copies(&self.motions),
            inputs: self.inputs.clone(),
            cases: self.cases.clone(),
            motions: self.motions.iter().map(|(name, _)| name.clone()).collect(),
            earthquakes: self.earthquakes(),
            records: self.records(),
            runs,
            missing,
            maps: Vec::new(),
            fitted: Fitted::default(),
        }
    }

    /// Data of the earthquake of each motion, unless motions are varied.
    fn earthquakes(&self) -> Vec<EarthquakeOf> {
        let motions = self.motions.iter().filter(|_| !self.varies_motions());
        let each = motions.map(|(name, motion)| {
            let part = self.opened.project.motions.iter().find(|part| part.name == *name);
            EarthquakeOf {
                magnitude: part.and_then(|part| part.magnitude),
                distance_km: part.and_then(|part| part.distance_km),
                duration_s: motion.significant_duration_s(),
            }
        });
        each.collect()
    }

    /// The record of each motion, as the index of the first motion from it.
    fn records(&self) -> Vec<usize> {
        let own = &self.opened.project.motions;
        let part = |at: usize| own.iter().find(|part| part.name == self.motions[at].0);
        let mut records: Vec<usize> = (0..self.motions.len()).collect();
        let shaking = |at: usize| &self.motions[at].1;
        for at in 0..self.motions.len() {
            for before in 0..at {
                let is_one = part(at)
                    .zip(part(before))
                    .is_some_and(|(at, before)| at.is_of_one_record(before));
                if (is_one || shaking(at).is_copy_of(shaking(before))) && records[at] != records[before] {
                    let (from, to) = (records[at].max(records[before]), records[at].min(records[before]));
                    records
                        .iter_mut()
                        .filter(|of| **of == from)
                        .for_each(|of| *of = to);
                }
            }
        }
        records
    }

    /// Warnings of the file, each with its line.
    fn notes(&self) -> Vec<Both> {
        let warnings = self.opened.project.warnings.iter();
        let warnings = warnings.map(|warning| Both {
            english: format!(
                "line {}: {}",
                warning.line,
                warning.message.text(Language::English)
            ),
            korean: format!("{}행: {}", warning.line, warning.message.text(Language::Korean)),
        });
        let mut notes: Vec<Both> = warnings.chain(self.held.iter().cloned()).collect();
        if self.study.harmonic.is_some() {
            notes.push(OfRuns::MapAccuracy.into());
        }
        if let (StudyKind::Building, Some([x, y])) = (self.kind, self.axis_of_file()) {
            let degrees = y.atan2(x).to_degrees() + 0.0;
            notes.push(Both {
                english: format!(
                    "every motion shakes along one axis, {degrees:.0} deg from x, and across it nothing is studied: give directions, or motions of two components"
                ),
                korean: format!(
                    "모든 지반운동이 x축에서 {degrees:.0}° 방향의 한 축으로만 작용하며 그 직각 방향은 검토되지 않는다. directions를 주거나 두 성분의 지반운동을 준다"
                ),
            });
        }
        notes
    }

    pub(super) fn cases(&self) -> usize {
        self.cases.len()
    }
}

/// The size of the motion before the runs of a combination, with its SI unit.
fn size_before(study: &StudyPart, combination: usize) -> Option<(f64, &'static str)> {
    study.size_before(combination).map(|size| match size {
        MotionSize::Scale(scale) => (scale, ""),
        MotionSize::Peak(peak_m_s2) => (peak_m_s2, "m/s2"),
    })
}

/// A problem of a project file, with the allowed values and the remedy.
fn in_one_line(problem: &Problem, file: &str, language: Language) -> String {
    let beside = |sign: &str, said: &Option<Both>| {
        let said = said.as_ref().map(|said| format!("{sign}{}", said.text(language)));
        said.unwrap_or_default()
    };
    let line = problem.line;
    format!(
        "{}{}{} ({})",
        problem.message.text(language),
        beside(", ", &problem.allowed),
        beside("; ", &problem.help),
        language.pick(format!("line {line} of {file}"), format!("{file} {line}행"))
    )
}
