//! From a path to a project: its project file, and the files that it names.

use crate::wrong::PathError;
use crate::{Access, files};
use anyhow::Result;
use dolmen_project::date_of;
use dolmen_records::records::RecordFormat;
use dolmen_records::{FileError, Files, PROJECT_BYTES_MOST, stays_within, time_text};
use dolmen_work::{Opened, Progress, with_stiffness_of_surveys};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{SystemTime, UNIX_EPOCH};

/// A project, its file, and the folder of its other files.
pub struct Found {
    /// The project.
    pub opened: Opened,
    /// The project file.
    pub file: PathBuf,
    /// The folder of the files that it names.
    pub files: Folder,
}

/// Files of a folder.
pub struct Folder {
    path: PathBuf,
    /// Which files may be read and replaced.
    pub access: Access,
    /// Name and text of the project file.
    project: Option<(String, String)>,
    /// Names of the files read so far.
    read: Mutex<BTreeSet<String>>,
}

impl Folder {
    /// Refuses a name that leads out of the folder, directly or by a link.
    fn refuse_outside(&self, name: &str, path: &Path) -> Result<(), FileError> {
        if self.access.allow_outside {
            return Ok(());
        }
        // a missing file cannot lead out
        let root = files::folder_of(&self.path.join("file")).canonicalize();
        let leads_out = |real: PathBuf| root.as_ref().is_ok_and(|root| !real.starts_with(root));
        match !stays_within(name) || path.canonicalize().is_ok_and(leads_out) {
            true => Err(FileError::Outside {
                shown: self.shown(name),
            }),
            false => Ok(()),
        }
    }

    /// Adds to a missing file the line of the project that names it: the first line with the name in quotes that is not a
    /// comment.
    fn with_line(&self, name: &str, why: FileError) -> FileError {
        use FileError::{Absent, Backslash, Misspelt};
        let (Some((file, text)), Absent { .. } | Backslash { .. } | Misspelt { .. }) = (&self.project, &why)
        else {
            return why;
        };
        let quoted = [format!("\"{name}\""), format!("'{name}'"), format!("{name:?}")];
        let names = |line: &str| {
            !line.trim_start().starts_with('#') && quoted.iter().any(|quoted| line.contains(quoted))
        };
        match text.lines().position(names) {
            Some(before) => FileError::NamedIn {
                file: file.clone(),
                line: before + 1,
                why: why.sentence().into(),
            },
            None => why,
        }
    }

    /// Whether a name is that of a regular file within the folder.
    pub fn holds(&self, name: &str) -> bool {
        let path = self.path.join(name);
        !name.is_empty() && path.is_file() && self.refuse_outside(name, &path).is_ok()
    }
}

/// The folder, and the sorted names of its files, without hidden files and subfolders.
///
/// # Errors
/// If it is not a folder, or cannot be read.
pub fn motions_in(path: &Path, access: Access) -> Result<(Folder, Vec<String>)> {
    let shown = || path.display().to_string();
    if !path.is_dir() {
        return Err(PathError::NoFolderOfMotions { path: shown() }.into());
    }
    let entries = std::fs::read_dir(path).map_err(|why| PathError::CannotOpen { path: shown(), why })?;
    let mut names: Vec<String> = entries
        .flatten()
        .filter(|entry| entry.path().is_file())
        .filter_map(|entry| entry.file_name().into_string().ok())
        .filter(|name| !name.starts_with('.'))
        .collect();
    names.sort();
    let folder = Folder {
        path: path.to_owned(),
        access,
        project: None,
        read: Mutex::default(),
    };
    Ok((folder, names))
}

impl Files for Folder {
    fn read(&self, name: &str, most_bytes: u64) -> Result<Vec<u8>, FileError> {
        let path = self.path.join(name);
        self.refuse_outside(name, &path)?;
        let bytes =
            files::read(&path, self.access.most(most_bytes)).map_err(|why| self.with_line(name, why))?;
        if let Ok(mut read) = self.read.lock() {
            read.insert(name.to_owned());
        }
        Ok(bytes)
    }

    fn names_read(&self) -> Vec<String> {
        let read = self.read.lock();
        read.map_or_else(|_| Vec::new(), |read| read.iter().cloned().collect())
    }

    fn is_composed_otherwise(&self, name: &str) -> bool {
        files::is_composed_otherwise(&self.path.join(name))
    }

    fn shown(&self, name: &str) -> String {
        self.path.join(name).display().to_string()
    }

    fn today(&self) -> Option<[u32; 3]> {
        /// Largest lead of local time over UTC (UTC+14), s.
        const FIRST_DAY_S: f64 = 14.0 * 3600.0;
        let now = SystemTime::now().duration_since(UNIX_EPOCH).ok()?;
        date_of(&time_text(now.as_secs_f64() + FIRST_DAY_S))
    }
}

impl Found {
    /// Reads the project file that `path` means: a file, or the `project.toml` of a folder.
    ///
    /// # Errors
    /// If the file is missing, too large, not UTF-8, or a record; or if the project has faults (all are listed).
    pub fn open(path: &Path, access: Access) -> Result<Self> {
        let file = files::project_file(path)?;
        refuse_record(&file)?;
        let text = files::read_text(&file, access.most(PROJECT_BYTES_MOST))?;
        let mut files = Folder {
            path: file.parent().unwrap_or(Path::new(".")).to_owned(),
            access,
            project: None, // faults of the project quote their lines themselves
            read: Mutex::default(),
        };
        let opened = Opened::read(text, file.display().to_string(), &files)?;
        files.project = Some((opened.file.clone(), opened.text.clone()));
        Ok(Found { opened, file, files })
    }

    /// Identifies the stiffness that the project leaves to its surveys, and puts it into the project.
    ///
    /// # Errors
    /// If a survey cannot be identified.
    pub fn with_stiffness_of_surveys(self, progress: &dyn Progress) -> Result<Self> {
        let opened = with_stiffness_of_surveys(self.opened, &self.files, progress)?;
        Ok(Found { opened, ..self })
    }
}

/// Says what to do if a record was given as a project file.
fn refuse_record(file: &Path) -> Result<()> {
    let ending = file.extension().map(|e| e.to_string_lossy().to_lowercase());
    let is_record = ending.is_some_and(|ending| match ending.as_str() {
        "txt" | "dat" | "asc" => false, // may hold TOML as well
        "xls" | "at2" | "v2" | "zip" => true,
        other => RecordFormat::of_ending(other).is_some(),
    });
    if is_record {
        let name = file
            .file_name()
            .map(|n| n.to_string_lossy().into_owned())
            .unwrap_or_default();
        return Err(PathError::IsRecord {
            path: file.display().to_string(),
            name,
        }
        .into());
    }
    Ok(())
}
