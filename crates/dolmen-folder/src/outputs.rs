//! Decides what may be written: measured data are never replaced, and files that Dolmen did not write only on request (`--force`).
//!
//! Pages and figures contain a mark. Tables, arrays and JSON are in a list in their folder, each with a checksum; if a table was changed
//! since, somebody edited it, and it is kept.

use crate::Access;
use crate::files::{clear_parts, folder_of, read, start, write};
use crate::open::Found;
use crate::wrong::PathError;
use anyhow::Result;
use dolmen_report::files::{NamedFile, is_marked};
use dolmen_work::study::fingerprint;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Name of the list of files that Dolmen wrote into a folder.
const LIST: &str = ".dolmen-files";
/// Its first line.
const LIST_HEAD: &str =
    "# What Dolmen wrote here, with a sum over each file: these it may replace, others not without --force.";
/// Largest size of a list, in bytes; a larger file is not ours.
const LIST_BYTES_MOST: u64 = 64 << 20;
/// Largest size of a file whose checksum is computed, in bytes.
const KNOWN_BYTES_MOST: u64 = 4 << 30;

/// Decides which files may be replaced.
pub struct Outputs {
    inputs: BTreeSet<PathBuf>,
    force: bool,
}

/// Resolves a path as if its folders existed: `..` after a missing folder removes that folder.
fn settled(path: &Path) -> PathBuf {
    let mut settled = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir if !settled.as_os_str().is_empty() && !settled.exists() => {
                settled.pop();
            }
            part => settled.push(part),
        }
    }
    settled
}

/// What exists at the path of an output.
enum Standing {
    /// Nothing, a file that Dolmen wrote, a device, or an empty file.
    Free,
    /// An input of the command or of its project.
    Input,
    /// A file that Dolmen did not write.
    Foreign,
}

impl Outputs {
    /// Keeps only files that Dolmen did not write.
    pub fn new(access: Access) -> Self {
        Outputs {
            inputs: BTreeSet::new(),
            force: access.force,
        }
    }

    /// As [`Outputs::new`], and also keeps the project file and all files that it names.
    pub fn of(access: Access, found: &Found) -> Self {
        Self::new(access).keeping_project(found)
    }

    /// Always keeps the project file and all files that it names.
    pub fn keeping_project(self, found: &Found) -> Self {
        let folder = folder_of(&found.file);
        let named = dolmen_project::texts(&found.opened.text);
        named.iter().fold(self.keeping(&found.file), |all, name| {
            all.keeping(&folder.join(name))
        })
    }

    /// Always keeps this file.
    pub fn keeping(mut self, path: &Path) -> Self {
        if path.is_file() {
            self.inputs.extend(path.canonicalize());
        }
        self
    }

    fn standing(&self, path: &Path) -> Standing {
        let path = &settled(path);
        let Ok(there) = fs::metadata(path) else {
            return Standing::Free;
        };
        if !there.is_file() {
            return Standing::Free; // a device; writing to a folder fails later
        }
        if path.canonicalize().is_ok_and(|real| self.inputs.contains(&real)) {
            return Standing::Input;
        }
        let is_empty = there.len() == 0; // as `mktemp` makes one: nothing is lost
        match self.force || is_empty || is_marked(&start(path)) || List::of(folder_of(path)).holds(path) {
            true => Standing::Free,
            false => Standing::Foreign,
        }
    }

    /// Refuses a file that may not be replaced; call it before any work is done.
    pub fn refuse(&self, path: &Path) -> Result<()> {
        match self.standing(path) {
            Standing::Free => Ok(()),
            Standing::Input => Err(PathError::IsInput {
                path: path.display().to_string(),
            }
            .into()),
            Standing::Foreign => Err(PathError::IsForeign {
                path: path.display().to_string(),
            }
            .into()),
        }
    }

    /// Writes one file, completely or not at all.
    pub fn file(&self, path: &Path, bytes: &[u8]) -> Result<()> {
        let path = &settled(path);
        self.refuse(path)?;
        if is_marked(bytes) || fs::metadata(path).is_ok_and(|there| !there.is_file()) {
            clear_parts(folder_of(path));
            return write(path, bytes);
        }
        self.within(folder_of(path), &[(path.to_owned(), bytes)])
    }

    /// Writes files into a folder. A file that must not be replaced is kept, and the new one is written next to it; the result is then an
    /// error, after all files are written.
    pub fn folder(&self, folder: &Path, files: &[NamedFile]) -> Result<()> {
        let folder = &settled(folder);
        let mut by_folder: BTreeMap<PathBuf, Vec<(PathBuf, &[u8])>> = BTreeMap::new();
        let mut beside = Vec::new();
        for file in files {
            let wanted = file
                .name
                .split('/')
                .fold(folder.to_owned(), |path, part| path.join(part));
            let path = match self.standing(&wanted) {
                Standing::Free => wanted,
                Standing::Input | Standing::Foreign => {
                    let free = self.free_beside(&wanted);
                    beside.push([wanted.display().to_string(), free.display().to_string()]);
                    free
                }
            };
            let within = by_folder.entry(folder_of(&path).to_owned()).or_default();
            within.push((path, &file.bytes));
        }
        for (folder, files) in &by_folder {
            self.within(folder, files)?;
        }
        match beside.is_empty() {
            true => Ok(()),
            false => Err(PathError::LieBeside { beside }.into()),
        }
    }

    /// The first free name of "name-2.csv", "name-3.csv"…
    fn free_beside(&self, path: &Path) -> PathBuf {
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let ending = path
            .extension()
            .map(|ending| format!(".{}", ending.to_string_lossy()));
        let (stem, ending) = (stem.unwrap_or_default(), ending.unwrap_or_default());
        let mut number = 2;
        loop {
            let free = path.with_file_name(format!("{stem}-{number}{ending}"));
            if matches!(self.standing(&free), Standing::Free) {
                return free;
            }
            number += 1;
        }
    }

    /// Writes files into one folder and lists them. New files enter the list before they are written, and old ones leave it afterwards, so
    /// the list is complete even if the process is killed.
    fn within(&self, folder: &Path, files: &[(PathBuf, &[u8])]) -> Result<()> {
        clear_parts(folder);
        let mut list = List::of(folder);
        let (mut before, mut after) = (list.clone(), false);
        for (path, bytes) in files.iter().filter(|(_, bytes)| !is_marked(bytes)) {
            let (name, sum) = (name_of(path), fingerprint(bytes));
            before.sums.entry(name.clone()).or_default().insert(sum.clone());
            let known = list.sums.insert(name, BTreeSet::from([sum.clone()]));
            after |= known.is_some_and(|known| known != BTreeSet::from([sum]));
        }
        if before != List::of(folder) {
            before.write(folder)?;
        }
        for (path, bytes) in files {
            write(path, bytes)?;
        }
        match after {
            true => list.write(folder),
            false => Ok(()),
        }
    }
}

/// List of the files that Dolmen wrote into a folder: for each name, its possible checksums.
#[derive(Clone, Default, PartialEq, Eq)]
struct List {
    sums: BTreeMap<String, BTreeSet<String>>,
}

impl List {
    /// The list of a folder; empty if there is none.
    fn of(folder: &Path) -> Self {
        let text = read(&folder.join(LIST), LIST_BYTES_MOST).unwrap_or_default();
        let mut list = List::default();
        for line in String::from_utf8_lossy(&text).lines().skip(1) {
            if let Some((sum, name)) = line.split_once("  ") {
                list.sums
                    .entry(name.to_owned())
                    .or_default()
                    .insert(sum.to_owned());
            }
        }
        list
    }

    fn holds(&self, path: &Path) -> bool {
        let Some(sums) = self.sums.get(&name_of(path)) else {
            return false;
        };
        read(path, KNOWN_BYTES_MOST).is_ok_and(|bytes| sums.contains(&fingerprint(&bytes)))
    }

    fn write(&self, folder: &Path) -> Result<()> {
        let mut text = format!("{LIST_HEAD}\n");
        for (name, sums) in &self.sums {
            for sum in sums {
                text += &format!("{sum}  {name}\n");
            }
        }
        write(&folder.join(LIST), text.as_bytes())
    }
}

fn name_of(path: &Path) -> String {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    name.unwrap_or_default().replace('\n', " ")
}
