//! What `check` prints and `report` writes of every example in both languages: made once, read by several tests.

use super::verbs::{Answer, Scratch, root};
use std::fs;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The answers on one example in one language.
pub(crate) struct Shown {
    pub(crate) example: String,
    pub(crate) language: &'static str,
    /// The short answer of `check`.
    pub(crate) check: Answer,
    /// The page of `report`.
    pub(crate) page: String,
}

/// The folders of the examples, sorted.
pub(crate) fn examples() -> Vec<String> {
    let all = fs::read_dir(root().join("examples"))
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut names: Vec<String> = all
        .filter(|path| path.join("project.toml").is_file())
        .map(|path| format!("examples/{}", path.file_name().unwrap().to_string_lossy()))
        .collect();
    names.sort();
    names
}

/// The answers on every example: English, then Korean.
pub(crate) fn shown() -> &'static [Shown] {
    static SHOWN: LazyLock<Vec<Shown>> = LazyLock::new(show_all);
    &SHOWN
}

fn show_all() -> Vec<Shown> {
    let scratch = Scratch::with_examples("each-example");
    let asked: Vec<(String, &str)> = examples()
        .into_iter()
        .flat_map(|example| ["en", "ko"].map(|language| (example.clone(), language)))
        .collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut mine = Vec::new();
        while let Some((example, language)) = asked.get(next.fetch_add(1, Ordering::Relaxed)) {
            mine.push(show(&scratch, example, language));
        }
        mine
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut all: Vec<Shown> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap())
            .collect()
    });
    all.sort_by(|a, b| (&a.example, a.language).cmp(&(&b.example, b.language)));
    all
}

fn show(scratch: &Scratch, example: &str, language: &'static str) -> Shown {
    let common = format!("{example} --language {language} --allow-outside");
    let page = format!("{}-{language}.html", example.replace('/', "-"));
    scratch.briefly(&format!("report {common} -o {page}"));
    Shown {
        example: example.to_owned(),
        language,
        check: scratch.briefly(&format!("check {common}")),
        page: fs::read_to_string(scratch.path().join(page)).unwrap(),
    }
}
