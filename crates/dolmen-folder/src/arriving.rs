//! A folder into which other programs write files: finds complete files, and moves them when they are stored or
//! unreadable.

use crate::files::write;
use crate::wrong::PathError;
use anyhow::Result;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Endings of unfinished files.
const UNFINISHED: [&str; 6] = [".part", ".partial", ".filepart", ".tmp", ".temp", ".crdownload"];
/// Ending of the text file next to a file in quarantine.
const WHY: &str = ".why.txt";

/// Size and time of a file, which show whether it changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Its size, bytes.
    pub bytes: u64,
    /// Time of the last write.
    pub modified: SystemTime,
}

impl Look {
    /// Size and time of a regular file; `None` for a link, a folder, a pipe or a missing file.
    pub fn at(path: &Path) -> Option<Self> {
        let there = fs::symlink_metadata(path).ok()?;
        let modified = there.modified().unwrap_or(UNIX_EPOCH);
        there.is_file().then_some(Look {
            bytes: there.len(),
            modified,
        })
    }

    /// Time of the last write, s from 1 January 1970 (UTC).
    pub fn modified_s(&self) -> f64 {
        match self.modified.duration_since(UNIX_EPOCH) {
            Ok(since) => since.as_secs_f64(),
            Err(before) => -before.duration().as_secs_f64(),
        }
    }
}

/// A folder into which other programs write files.
#[derive(Debug)]
pub struct Inbox {
    folder: PathBuf,
    rest: Duration,
    passed_over: BTreeSet<PathBuf>,
    seen: BTreeMap<PathBuf, (Look, Instant)>,
    done: BTreeMap<PathBuf, Look>,
}

/// Files in the folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct InboxLook {
    /// Complete files, by name.
    pub at_rest: Vec<(PathBuf, Look)>,
    /// Number of files still being written.
    pub growing: usize,
}

impl Inbox {
    /// Watches a folder; a file is complete when its size and time have not changed for `rest`.
    ///
    /// # Errors
    /// If there is no such folder.
    pub fn new(folder: &Path, rest: Duration) -> Result<Self> {
        if !folder.is_dir() {
            return Err(PathError::NoFolder {
                path: folder.display().to_string(),
            }
            .into());
        }
        Ok(Inbox {
            folder: folder.to_owned(),
            rest,
            passed_over: BTreeSet::new(),
            seen: BTreeMap::new(),
            done: BTreeMap::new(),
        })
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Ignores a file in the folder, such as the store or a table that is written there.
    #[must_use]
    pub fn passing_over(mut self, path: &Path) -> Self {
        self.passed_over.extend(real(path));
        self
    }

    /// Files that are not done yet. Links, folders, hidden files and unfinished files are left out.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn look(&mut self) -> Result<InboxLook> {
        let now = (Instant::now(), SystemTime::now());
        let cannot_read = |why| PathError::CannotOpen {
            path: self.folder.display().to_string(),
            why,
        };
        let mut lying = InboxLook::default();
        let mut seen = BTreeMap::new();
        for entry in fs::read_dir(&self.folder).map_err(cannot_read)? {
            let path = entry.map_err(cannot_read)?.path();
            let Some(look) = Look::at(&path).filter(|_| !self.is_passed_over(&path)) else {
                continue;
            };
            if self.done.get(&path) == Some(&look) {
                continue;
            }
            let since = match self.seen.get(&path) {
                Some((before, since)) if *before == look => *since,
                _ => now.0,
            };
            // an old file is complete when first seen; the age is unknown if the clock of its writer is ahead
            let age = now.1.duration_since(look.modified).unwrap_or_default();
            let rests = age >= self.rest || now.0.duration_since(since) >= self.rest;
            seen.insert(path.clone(), (look, since));
            match rests && look.bytes > 0 {
                true => lying.at_rest.push((path, look)),
                false => lying.growing += usize::from(!rests),
            }
        }
        self.seen = seen;
        self.done.retain(|path, _| path.exists());
        lying.at_rest.sort_by(|a, b| a.0.cmp(&b.0));
        Ok(lying)
    }

    fn is_passed_over(&self, path: &Path) -> bool {
        let name = path.file_name().map(|name| name.to_string_lossy().to_lowercase());
        let name = name.unwrap_or_default();
        let is_unfinished = UNFINISHED.iter().any(|ending| name.ends_with(ending));
        name.starts_with('.')
            || name.ends_with('~')
            || is_unfinished
            || real(path).is_some_and(|real| self.passed_over.contains(&real))
    }

    /// Marks this version of a file as done, so that it is not returned again.
    pub fn set_done(&mut self, path: &Path, look: Look) {
        self.seen.remove(path);
        self.done.insert(path.to_owned(), look);
    }
}

/// The path with its folder resolved; the file itself need not exist.
fn real(path: &Path) -> Option<PathBuf> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok()?;
    Some(folder.join(path.file_name()?))
}

/// Moves a file into a folder by a rename; appends a number to its name rather than replace a file. Returns the new path.
///
/// # Errors
/// If the folder cannot be created, or is on another file system.
pub fn move_into(folder: &Path, file: &Path) -> Result<PathBuf> {
    moved(folder, file, |path| Ok(!is_there(path)))
}

/// As [`move_into`], with a text beside the file that gives the reason. The text is written before the file is moved.
///
/// # Errors
/// As [`move_into`].
pub fn quarantine(folder: &Path, file: &Path, why: &str) -> Result<PathBuf> {
    moved(folder, file, |path| {
        let beside = beside(path);
        // a process killed before the rename left the same text
        let is_ours = || fs::read(&beside).is_ok_and(|text| text == why.as_bytes());
        if is_there(path) || (is_there(&beside) && !is_ours()) {
            return Ok(false);
        }
        write(&beside, why.as_bytes()).map(|()| true)
    })
}

fn beside(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(WHY);
    name.into()
}

fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Number of files in quarantine, without the texts.
pub fn quarantined(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path());
    paths
        .filter(|path| path.is_file() && is_there(&beside(path)))
        .count()
}

fn moved(folder: &Path, file: &Path, claim: impl Fn(&Path) -> Result<bool>) -> Result<PathBuf> {
    let failed = |why: std::io::Error| {
        anyhow::Error::new(PathError::CannotMove {
            path: file.display().to_string(),
            folder: folder.display().to_string(),
            why,
        })
    };
    fs::create_dir_all(folder).map_err(|why| PathError::CannotMake {
        path: folder.display().to_string(),
        why,
    })?;
    let name = file.file_name().unwrap_or_default();
    let mut number = 1;
    let target = loop {
        let target = match number {
            1 => folder.join(name),
            number => {
                let mut numbered = std::ffi::OsString::from(format!("{number}-"));
                numbered.push(name);
                folder.join(numbered)
            }
        };
        if claim(&target)? {
            break target;
        }
        number += 1;
    };
    fs::rename(file, &target).map_err(failed)?;
    Ok(target)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("dolmen-inbox-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn names(lying: &InboxLook) -> Vec<String> {
        let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
        lying.at_rest.iter().map(|(path, _)| name(path)).collect()
    }

    fn set_age(path: &Path, seconds: u64) {
        let file = fs::File::options().write(true).open(path).unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(seconds))
            .unwrap();
    }

    #[test]
    fn holds_only_finished_regular_files_that_rest_are_given_and_once() {
        let folder = scratch("look");
        for name in [
            "old.csv",
            "new.csv",
            "half.csv.part",
            ".hidden",
            "empty",
            "store.db",
            "$(x) \"y\".csv",
        ] {
            fs::write(folder.join(name), b"1").unwrap();
            set_age(&folder.join(name), 100);
        }
        fs::write(folder.join("empty"), b"").unwrap();
        set_age(&folder.join("empty"), 100);
        set_age(&folder.join("new.csv"), 0);
        fs::create_dir(folder.join("folder")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(folder.join("old.csv"), folder.join("link.csv")).unwrap();
        let inbox = Inbox::new(&folder, Duration::from_secs(50)).unwrap();
        let mut inbox = inbox.passing_over(&folder.join("store.db"));
        let lying = inbox.look().unwrap();
        assert_eq!(names(&lying), ["$(x) \"y\".csv", "old.csv"]);
        assert_eq!(lying.growing, 1);
        let (path, look) = lying.at_rest[1].clone();
        inbox.set_done(&path, look);
        assert_eq!(names(&inbox.look().unwrap()), ["$(x) \"y\".csv"]);
        // written again: this is another file
        fs::write(&path, b"22").unwrap();
        set_age(&path, 90);
        assert_eq!(names(&inbox.look().unwrap()).len(), 2);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn holds_a_file_of_a_clock_that_is_ahead_rests_once_it_was_seen_long_enough() {
        let folder = scratch("ahead");
        let path = folder.join("a.csv");
        fs::write(&path, b"1").unwrap();
        let file = fs::File::options().write(true).open(&path).unwrap();
        file.set_modified(SystemTime::now() + Duration::from_secs(9000))
            .unwrap();
        let mut inbox = Inbox::new(&folder, Duration::from_millis(30)).unwrap();
        assert_eq!(inbox.look().unwrap().growing, 1);
        std::thread::sleep(Duration::from_millis(40));
        assert_eq!(inbox.look().unwrap().at_rest.len(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn holds_quarantine_replaces_nothing_and_says_why() {
        let folder = scratch("quarantine");
        let to = folder.join("quarantine");
        for content in ["1", "2", "3"] {
            fs::write(folder.join("a.csv"), content).unwrap();
            quarantine(&to, &folder.join("a.csv"), "broken").unwrap();
        }
        let read = |name: &str| fs::read_to_string(to.join(name)).unwrap();
        assert_eq!([read("a.csv"), read("2-a.csv"), read("3-a.csv")], ["1", "2", "3"]);
        assert_eq!(read("2-a.csv.why.txt"), "broken");
        assert_eq!(quarantined(&to), 3);
        // killed between text and rename: the name is still free
        fs::write(to.join("b.csv.why.txt"), "broken").unwrap();
        fs::write(folder.join("b.csv"), "4").unwrap();
        assert_eq!(
            quarantine(&to, &folder.join("b.csv"), "broken").unwrap(),
            to.join("b.csv")
        );
        // a data file with the name of such a text file is kept as well
        fs::write(folder.join("c.csv.why.txt"), "5").unwrap();
        fs::write(folder.join("c.csv"), "6").unwrap();
        quarantine(&to, &folder.join("c.csv.why.txt"), "broken").unwrap();
        quarantine(&to, &folder.join("c.csv"), "broken").unwrap();
        assert_eq!([read("c.csv.why.txt"), read("2-c.csv")], ["5", "6"]);
        fs::remove_dir_all(folder).unwrap();
    }
}
