//! The folder of a study: journals that grow, and tables and figures that are written completely or not at all.

use crate::files;
use crate::open::Found;
use crate::outputs::Outputs;
use crate::wrong::{Lying, PathError, of_folders};
use anyhow::Result;
use dolmen_records::JOURNAL_BYTES_MOST;
use dolmen_report::files::study_files;
use dolmen_words::message::Both;
use dolmen_words::{Language, file_name, said_by_system};
use dolmen_work::study::{
    Journal, JournalHeader, JournalText, Run, StudyAnswer, StudyJournals, StudyKind, header_line, is_journal,
    resumed, run_line,
};
use dolmen_work::{WorkError, told_by};
use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io::{Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// The folder of a study's results.
pub struct StudyFolder {
    path: PathBuf,
    outputs: Outputs,
    /// Largest size of a journal in bytes.
    most: u64,
}

/// An open journal, locked against a second process.
pub struct JournalFile {
    file: Mutex<File>,
    path: PathBuf,
}

impl Journal for JournalFile {
    /// Appends the line of a run with a single write.
    fn append(&self, run: &Run) -> Result<(), WorkError> {
        let line = run_line(run);
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let written = file.write_all(line.as_bytes()).and_then(|()| file.flush());
        written.map_err(|why| WorkError::Outside {
            why: Lying::CannotWrite {
                path: self.path.display().to_string(),
                why: said_by_system(&why),
            }
            .into(),
        })
    }
}

/// "2/5": the second of five.
pub fn shard(text: &str) -> Result<(usize, usize)> {
    let parts = text.split_once('/');
    let numbers = parts.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
    match numbers {
        Some((part, of)) if 1 <= part && part <= of => Ok((part, of)),
        _ => Err(PathError::Shard {
            given: text.to_owned(),
        }
        .into()),
    }
}

impl StudyFolder {
    /// `output`/NAME, or studies/NAME beside the project file.
    pub fn of(output: Option<&Path>, found: &Found, study: &str) -> Self {
        let beside = found.file.parent().unwrap_or(Path::new(".")).join("studies");
        let access = found.files.access;
        StudyFolder {
            path: output.unwrap_or(&beside).join(file_name(study)),
            outputs: Outputs::of(access, found),
            most: access.most(JOURNAL_BYTES_MOST),
        }
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Path of a shard's journal.
    pub fn journal_file(&self, (part, of): (usize, usize)) -> PathBuf {
        let name = if of == 1 {
            "journal.tsv".to_owned()
        } else {
            format!("journal-{part}-of-{of}.tsv")
        };
        self.path.join(name)
    }

    /// Opens a shard's journal for appending; also returns its contents.
    pub fn journal(
        &self,
        header: &JournalHeader,
        kind: StudyKind,
        restart: bool,
    ) -> Result<(JournalFile, Vec<Run>)> {
        let path = self.journal_file(header.shard);
        let shown = path.display().to_string();
        fs::create_dir_all(&self.path).map_err(|why| files::cannot_make(&self.path, why))?;
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path);
        let mut file = file.map_err(|why| PathError::CannotOpen {
            path: shown.clone(),
            why,
        })?;
        if file.try_lock().is_err() {
            return Err(PathError::InUse { path: shown }.into());
        }
        let there = files::start(&path);
        if !there.is_empty() && !is_journal(&there) {
            return Err(PathError::NoJournalOfStudy { path: shown }.into());
        }
        let text = if restart {
            String::new()
        } else {
            files::read_whole_lines(&path, self.most)?
        };
        let (keep, runs) = resumed(
            header,
            kind,
            &JournalText {
                shown: shown.clone(),
                text,
            },
        )?;
        let starts_anew = keep == 0;
        let made = file
            .set_len(keep as u64)
            .and_then(|()| file.seek(SeekFrom::End(0)))
            .and_then(|_| {
                if starts_anew {
                    file.write_all(header_line(header).as_bytes())
                } else {
                    Ok(())
                }
            });
        made.map_err(|why| PathError::CannotWrite { path: shown, why })?;
        let file = JournalFile {
            file: Mutex::new(file),
            path,
        };
        Ok((file, runs))
    }

    /// Adds runs of other journals to the journal of the whole study, so that later commands with this folder have them.
    pub fn keep(&self, header: &JournalHeader, kind: StudyKind, runs: &[Run]) -> Result<()> {
        let (journal, kept) = self.journal(header, kind, false)?;
        let key = |run: &Run| (run.job, run.scale.to_bits());
        let kept: BTreeSet<(usize, u64)> = kept.iter().map(key).collect();
        let is_new = |run: &&Run| !kept.contains(&key(run));
        for run in runs.iter().filter(is_new) {
            journal.append(run)?;
        }
        Ok(())
    }

    /// All journals of a study: in its folder, and in the folders `from`.
    pub fn journals(&self, study: &str, from: &[PathBuf]) -> Result<Vec<JournalText>> {
        let mut journals = journals_in(&self.path)?;
        for folder in from {
            let mut found = journals_in(folder)?;
            found.extend(journals_in(&folder.join(file_name(study)))?);
            if found.is_empty() {
                return Err(PathError::NoJournalFrom {
                    path: folder.display().to_string(),
                    study: study.to_owned(),
                }
                .into());
            }
            journals.extend(found);
        }
        journals.sort();
        if journals.is_empty() {
            return Err(PathError::NoJournalIn {
                path: self.path.display().to_string(),
            }
            .into());
        }
        let each = journals.into_iter().map(|path| {
            Ok(JournalText {
                shown: path.display().to_string(),
                text: files::read_whole_lines(&path, self.most)?,
            })
        });
        each.collect()
    }

    /// Writes tables, figures and JSON.
    pub fn write(&self, answer: &StudyAnswer, language: Language) -> Result<()> {
        self.outputs.folder(&self.path, &study_files(answer, language)?)
    }
}

/// The journals in a folder; empty if it does not exist.
fn journals_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        if name.is_some_and(|name| name.starts_with("journal") && name.ends_with(".tsv")) {
            found.push(path);
        }
    }
    Ok(found)
}

/// The journals of each study in the folder of a project.
pub fn journals_beside(found: &Found) -> Vec<StudyJournals> {
    let studies = found.opened.project.studies.iter();
    let run = studies.filter_map(|study| {
        let folder = StudyFolder::of(None, found, &study.name);
        let journals = folder.path.is_dir().then(|| folder.journals(&study.name, &[]))?;
        Some(StudyJournals {
            study: study.name.clone(),
            journals: journals.map_err(|why| WorkError::Outside {
                why: Both::of(|language| told_by(why.as_ref(), language, &of_folders)),
            }),
        })
    });
    run.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_shards_and_refuses_others() {
        assert_eq!(shard("2/5").unwrap(), (2, 5));
        for wrong in ["0/2", "3/2", "1", "a/b", "1/0", ""] {
            assert!(shard(wrong).is_err(), "{wrong}");
        }
    }
}
