//! Names of files made from names in a project: any name of a study or a damper becomes a single file or folder name.

use unicode_normalization::UnicodeNormalization as _;

/// Largest length of a name without its ending, in bytes. Our choice: common file systems allow 255, and the ending and the name
/// of the temporary file must fit.
const BYTES_MOST: usize = 120;
/// Device names that Windows reserves, with any ending.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];
/// Port names that Windows reserves, each followed by one digit.
const PORTS: [&str; 2] = ["com", "lpt"];

/// A name in composed form (NFC), so that names that look the same are the same.
pub fn composed(name: &str) -> String {
    name.nfc().collect()
}

/// A name as that of a file or folder on Linux, macOS and Windows: never empty, never a path, never a device.
///
/// Letters, digits, inner spaces and dots, and `-`, `_`, `+`, `,`, `=`, `(`, `)` stay as they are, in composed form (NFC). Any other
/// character becomes `%` and its bytes in hexadecimal, as in web addresses; so do a dot or space at either end, and the first letter of a
/// name that Windows reserves. A name of more than 120 bytes is cut, and ends in `~` and a checksum of eight digits.
///
/// Different names give different files, unless they differ only in what [`folded_file_name`] ignores.
///
/// # Example
/// ```
/// use dolmen_words::file_name;
/// assert_eq!(file_name("2층 감쇠기"), "2층 감쇠기");
/// assert_eq!(file_name("../../x"), "%2E.%2F..%2Fx");
/// assert_eq!(file_name("con.csv"), "%63on.csv");
/// ```
pub fn file_name(name: &str) -> String {
    let name: String = name.nfc().collect();
    let device = is_device(&name);
    let last = name.chars().count().saturating_sub(1);
    let mut file = String::with_capacity(name.len());
    for (at, sign) in name.chars().enumerate() {
        let at_end = at == 0 || at == last;
        let stays = match sign {
            '-' | '_' | '+' | ',' | '=' | '(' | ')' => true,
            '.' | ' ' => !at_end,
            sign => sign.is_alphanumeric(),
        };
        if stays && !(device && at == 0) {
            file.push(sign);
        } else {
            let mut bytes = [0; 4];
            for byte in sign.encode_utf8(&mut bytes).bytes() {
                file.push_str(&format!("%{byte:02X}"));
            }
        }
    }
    if file.is_empty() {
        return "%".to_owned();
    }
    shortened(file)
}

/// The file name without regard to case and Unicode normalization, as on Windows and macOS.
pub fn folded_file_name(name: &str) -> String {
    file_name(name).to_lowercase().nfc().collect()
}

fn is_device(name: &str) -> bool {
    let stem = name
        .split('.')
        .next()
        .unwrap_or_default()
        .trim_end()
        .to_lowercase();
    let is_port = |port: &&str| {
        let digits = stem.strip_prefix(*port).map(str::chars);
        digits.is_some_and(|mut digits| {
            let is_digit = |c: char| c.is_ascii_digit() || matches!(c, '¹' | '²' | '³');
            digits.next().is_some_and(is_digit) && digits.next().is_none()
        })
    };
    DEVICES.contains(&stem.as_str()) || PORTS.iter().any(is_port)
}

/// At most [`BYTES_MOST`] bytes, ending in a checksum of the whole.
fn shortened(file: String) -> String {
    if file.len() <= BYTES_MOST {
        return file;
    }
    // FNV-1a, 32 bits: distinguishes names; not for secrets
    let sum = file.bytes().fold(0x811c_9dc5_u32, |sum, byte| {
        (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    let tail = format!("~{sum:08x}");
    let mut end = BYTES_MOST - tail.len();
    while !file.is_char_boundary(end) {
        end -= 1;
    }
    // do not cut within %2F
    let cut = file[..end].rfind('%').filter(|at| end - at < 3).unwrap_or(end);
    format!("{}{tail}", &file[..cut])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_plain_names_stay() {
        for name in ["weak", "2009-05-12", "남측 방향", "x (2)", "a.b", "k_cr", "a+b=c"] {
            assert_eq!(file_name(name), name);
        }
    }

    #[test]
    fn holds_no_name_is_a_path_a_device_or_hidden() {
        let hostile = [
            "",
            ".",
            "..",
            "/",
            "../../x",
            "/abs",
            "a/b",
            "a\\b",
            "C:",
            "c:\\x",
            "\u{0}",
            "a\nb",
            "~",
            "$(x)",
            "a\"b",
            "<k>",
            "x.",
            "x ",
            " x",
            ".git",
            "con",
            "CON",
            "Nul.csv",
            "com1",
            "COM¹.txt",
            "lpt9.a.b",
            "aux .x",
            "\u{202e}gpj",
            "%2F",
            "*?|",
        ];
        let mut seen = std::collections::BTreeSet::new();
        for name in hostile {
            let file = file_name(name);
            let signs = [
                '/', '\\', ':', '\0', '\n', '"', '<', '>', '|', '*', '?', '\u{202e}',
            ];
            assert!(
                !file.is_empty() && !file.contains(signs),
                "{name:?} gives {file:?}"
            );
            assert!(
                !file.starts_with(['.', ' ', '~']) && !file.ends_with(['.', ' ']),
                "{file:?}"
            );
            assert!(!is_device(&file), "{file:?}");
            assert!(seen.insert(file), "{name:?} gives the name of another");
        }
    }

    #[test]
    fn holds_long_names_are_cut_and_stay_apart() {
        let long = "가".repeat(400);
        let (a, b) = (file_name(&long), file_name(&format!("{long}나")));
        assert!(a.len() <= BYTES_MOST && b.len() <= BYTES_MOST);
        assert_ne!(a, b);
        let slashes = file_name(&"/".repeat(400));
        let (body, _) = slashes.split_once('~').unwrap();
        assert_eq!(body.len() % 3, 0, "{slashes}");
    }

    #[test]
    fn exact_composed_and_decomposed_letters_are_one_name() {
        assert_eq!(file_name("\u{1102}\u{1161}"), "나");
        let same = |a: &str, b: &str| folded_file_name(a) == folded_file_name(b);
        assert!(same("Weak", "weak") && same("나", "\u{1102}\u{1161}"));
        assert!(!same("weak", "week"));
    }
}
