//! What may be written where: nothing that was measured, and nothing that Dolmen did not write, is replaced.
//!
//! Pages and figures carry a mark within. Tables, arrays and JSON are known by a list in their folder, with a sum over the bytes of each: a
//! table that was changed since is somebody's work, and stays.

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

/// The list of what Dolmen wrote into a folder.
const LIST: &str = ".dolmen-files";
/// Its first line.
const LIST_HEAD: &str =
    "# What Dolmen wrote here, with a sum over each file: these it may replace, others not without --force.";
/// Most bytes of a list that is looked at: more is none of ours.
const LIST_BYTES_MOST: u64 = 64 << 20;
/// Most bytes of a file whose sum is taken to know it again.
const KNOWN_BYTES_MOST: u64 = 4 << 30;

/// What may be replaced.
pub struct Outputs {
    inputs: BTreeSet<PathBuf>,
    force: bool,
}

/// The path that is meant once its folders are made: `..` behind a folder that is not there yet leads back to where it would stand.
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

/// What stands where a file is to be written.
enum Standing {
    /// Nothing, or something that Dolmen wrote, or a device, or a file without a byte.
    Free,
    /// An input of the command or of its project.
    Input,
    /// Somebody's file.
    Foreign,
}

impl Outputs {
    /// Nothing is kept but what others wrote.
    pub fn new(access: Access) -> Self {
        Outputs {
            inputs: BTreeSet::new(),
            force: access.force,
        }
    }

    /// As [`Outputs::new`], and the project file and all that it names stay.
    pub fn of(access: Access, found: &Found) -> Self {
        Self::new(access).keeping_project(found)
    }

    /// The project file and all that it names stay, whatever is asked for.
    pub fn keeping_project(self, found: &Found) -> Self {
        let folder = folder_of(&found.file);
        let named = dolmen_project::texts(&found.opened.text);
        named.iter().fold(self.keeping(&found.file), |all, name| {
            all.keeping(&folder.join(name))
        })
    }

    /// This file stays, whatever is asked for.
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
            return Standing::Free; // a device; a folder cannot be replaced
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

    /// Refuses a file that may not be replaced: to be asked before any work is done.
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

    /// Writes one file, whole or not at all.
    pub fn file(&self, path: &Path, bytes: &[u8]) -> Result<()> {
        let path = &settled(path);
        self.refuse(path)?;
        if is_marked(bytes) || fs::metadata(path).is_ok_and(|there| !there.is_file()) {
            clear_parts(folder_of(path));
            return write(path, bytes);
        }
        self.within(folder_of(path), &[(path.to_owned(), bytes)])
    }

    /// Writes files into a folder. One that would replace somebody's is put beside it, and that is an error once all are written.
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

    /// The first of "name-2.csv", "name-3.csv"… that is free.
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

    /// Writes files of one folder and lists them. The list names the new ones before they are there and lets go of the old ones after: whenever the
    /// process is killed, it knows all that is there.
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

/// What Dolmen wrote into a folder: a name, and sums over what it may hold.
#[derive(Clone, Default, PartialEq, Eq)]
struct List {
    sums: BTreeMap<String, BTreeSet<String>>,
}

impl List {
    /// The list of a folder; an empty one if there is none.
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
