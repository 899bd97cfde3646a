// SOURCE     Every page of the repository in Markdown.
// GOAL       Every link or picture leads to an existing file, and its #anchor to a heading there; each chapter of the book has a picture.
// TOLERANCE  none. Links into the web are not followed.

use super::layout::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Markdown pages below `folder`, without generated and downloaded ones.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if !name.starts_with('.')
                && !["target", "cache", "peer", "advisory-db", "out"].contains(&name.as_str())
            {
                found.extend(pages(&path));
            }
        } else if name.ends_with(".md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Lines of a page outside code blocks, with inline code blanked.
fn prose(text: &str) -> Vec<String> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
            lines.push(String::new());
        } else if fenced {
            lines.push(String::new());
        } else {
            let pieces: Vec<&str> = line.split('`').collect();
            // odd pieces lie between backticks
            let kept = pieces
                .iter()
                .enumerate()
                .map(|(at, piece)| if at % 2 == 1 { "x" } else { piece });
            lines.push(kept.collect());
        }
    }
    lines
}

/// The anchors of headings as GitHub forms them: lower case, hyphens for blanks, other marks omitted, -1 for the second of a name.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut found = BTreeSet::new();
    let mut fenced = false;
    for line in text.lines() {
        fenced ^= line.trim_start().starts_with("```");
        let Some(title) = (!fenced).then(|| line.trim_start_matches('#')) else {
            continue;
        };
        let Some(title) = title.strip_prefix(' ').filter(|_| line.starts_with('#')) else {
            continue;
        };
        // a link in a heading counts only with its text
        let title = match (title.find("]("), title.rfind(')')) {
            (Some(from), Some(to)) if to > from => format!("{}{}", &title[..from], &title[to..]),
            _ => title.to_owned(),
        };
        let mut anchor = String::new();
        for letter in title.trim().to_lowercase().chars() {
            match letter {
                ' ' => anchor.push('-'),
                _ if letter.is_alphanumeric() || letter == '-' || letter == '_' => anchor.push(letter),
                _ => {}
            }
        }
        let count = seen.entry(anchor.clone()).or_default();
        found.insert(if *count == 0 {
            anchor
        } else {
            format!("{anchor}-{count}")
        });
        *count += 1;
    }
    found
}

/// Targets of the links and pictures in a line: `[words](target)`, `[name]: target`, `src="target"`, `href="target"`.
fn targets(line: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for (at, _) in line.match_indices("](") {
        let rest = &line[at + 2..];
        let mut depth = 0;
        let end = rest.find(|letter| {
            depth += i32::from(letter == '(') - i32::from(letter == ')');
            depth < 0
        });
        found.extend(end.map(|end| rest[..end].split(" \"").next().unwrap_or_default().to_owned()));
    }
    if line.starts_with('[')
        && let Some((_, target)) = line.split_once("]: ")
    {
        found.push(target.split(' ').next().unwrap_or_default().to_owned());
    }
    for mark in ["src=\"", "href=\""] {
        for (at, _) in line.match_indices(mark) {
            let rest = &line[at + mark.len()..];
            found.extend(rest.split('"').next().map(str::to_owned));
        }
    }
    found
}

/// Percent signs decoded, `.` and `..` resolved.
fn resolved(folder: &Path, target: &str) -> PathBuf {
    let mut path = PathBuf::new();
    for part in folder.join(target.replace("%20", " ")).components() {
        match part {
            Component::ParentDir => {
                path.pop();
            }
            Component::CurDir => {}
            part => path.push(part),
        }
    }
    path
}

/// Dead links of a page, with their lines.
fn dead(page: &Path, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (number, line) in prose(text).iter().enumerate() {
        for target in targets(line) {
            if target.contains("://") || target.starts_with("mailto:") {
                continue;
            }
            let (file, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let path = if file.is_empty() {
                page.to_owned()
            } else {
                resolved(page.parent().unwrap(), file)
            };
            let there = path == page || path.exists();
            let headed = anchor.is_empty()
                || path == page && anchors(text).contains(anchor)
                || path != page
                    && fs::read_to_string(&path).is_ok_and(|other| anchors(&other).contains(anchor));
            if !there || !headed {
                found.push(format!("{}:{}: {target}", page.display(), number + 1));
            }
        }
    }
    found
}

#[test]
fn holds_every_link_leads_to_what_is_there() {
    let root = fs::canonicalize(root()).unwrap();
    let mut pages_read = 0;
    let mut found = Vec::new();
    for page in pages(&root) {
        found.extend(dead(&page, &fs::read_to_string(&page).unwrap()));
        pages_read += 1;
    }
    assert!(pages_read > 50, "{pages_read} pages only");
    assert!(found.is_empty(), "links that lead nowhere:\n{}", found.join("\n"));
}

#[test]
fn holds_a_dead_link_is_seen() {
    let root = fs::canonicalize(root()).unwrap();
    let text = "# Two words, one\n[there](docs/chain.md) [so](#two-words-one) `[code](gone.md)`\n\
                ![gone](docs/pictures/gone.svg) [no heading](docs/chain.md#gone)\n[here](#gone) [web](https://a.b/c)\n\
                ```\n[listed](gone.md)\n```\n[reference]: gone.md\n";
    let page = root.join("PAGE.md");
    let lines: Vec<String> = dead(&page, text)
        .iter()
        .map(|line| line.rsplit_once("PAGE.md:").unwrap().1.to_owned())
        .collect();
    assert_eq!(
        lines,
        [
            "3: docs/pictures/gone.svg",
            "3: docs/chain.md#gone",
            "4: #gone",
            "8: gone.md"
        ]
    );
}

#[test]
fn holds_every_chapter_has_a_picture() {
    let bare: Vec<PathBuf> = pages(&root().join("docs"))
        .into_iter()
        .filter(|page| !fs::read_to_string(page).unwrap().contains("!["))
        .collect();
    assert!(bare.is_empty(), "chapters without a picture: {bare:?}");
}
