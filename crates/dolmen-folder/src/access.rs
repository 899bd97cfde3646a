//! Files that may be read and replaced.

/// Which files of a project may be read, and which files may be replaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Access {
    /// Whether a project may name files outside its folder; default false.
    pub allow_outside: bool,
    /// Largest file size in bytes; `None` means the limit for its kind.
    pub largest_file: Option<u64>,
    /// Whether to replace files that Dolmen did not write; default false. Input files are never
    /// replaced.
    pub force: bool,
}

impl Access {
    /// Largest file size in bytes, for a kind whose own limit is `of_the_kind`.
    pub fn most(&self, of_the_kind: u64) -> u64 {
        self.largest_file.unwrap_or(of_the_kind)
    }
}
