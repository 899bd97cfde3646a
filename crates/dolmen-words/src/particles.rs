//! Korean particles, whose form depends on the last sound of the preceding word.

/// The final sound of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// 가, 를, 는, 와, 로.
    Vowel,
    /// ㄹ, which takes 로 like a vowel and 을, 이, 은, 과 like a consonant.
    Rieul,
    /// 이, 을, 은, 과, 으로.
    Consonant,
}

/// Particles as a translator writes them: both forms, of which the preceding sound selects one.
const PARTICLES: [(&str, &str, &str); 5] = [
    ("이(가)", "이", "가"),
    ("을(를)", "을", "를"),
    ("은(는)", "은", "는"),
    ("와(과)", "과", "와"),
    ("(으)로", "으로", "로"),
];

/// Replaces each pair of particles in `text` by the right form; `before` is the ending of what precedes the text, if anything.
///
/// ```
/// use dolmen_words::particles::particles;
/// assert_eq!(particles("노반이(가) 옥개석(으)로", None), "노반이 옥개석으로");
/// ```
pub fn particles(text: &str, before: Option<Ending>) -> String {
    let mut chosen = String::with_capacity(text.len());
    let mut rest = text;
    let first = |rest: &str| {
        let places = PARTICLES
            .iter()
            .filter_map(|particle| rest.find(particle.0).map(|at| (at, *particle)));
        places.min_by_key(|(at, _)| *at)
    };
    while let Some((at, (both, closed, open))) = first(rest) {
        chosen.push_str(&rest[..at]);
        let ending = ending(&chosen).or(before).unwrap_or(Ending::Vowel);
        let takes_open = ending == Ending::Vowel || (both == "(으)로" && ending == Ending::Rieul);
        chosen.push_str(if takes_open { open } else { closed });
        rest = &rest[at + both.len()..];
    }
    chosen + rest
}

/// The ending of a unit read aloud: 헤르츠, 라디안, 파스칼; `None` if the ending is that of the number before it.
pub fn ending_of_unit(symbol: &str) -> Option<Ending> {
    let last = symbol.rsplit(['·', '/', ' ']).next()?;
    let bare = last.trim_end_matches(['²', '³', '⁴']);
    Some(match bare {
        "" => return None,
        "Hz" | "m" | "mm" | "cm" | "km" | "s" | "ms" | "%" | "g" | "°C" | "°" => Ending::Vowel, // 헤르츠, 미터, 초, 퍼센트, 지, 도
        "N" | "kN" | "MN" | "GN" | "rad" | "mrad" | "kg" | "t" => Ending::Consonant, // 뉴턴, 라디안, 킬로그램, 톤
        "Pa" | "kPa" | "MPa" | "GPa" | "gal" => Ending::Rieul,                       // 파스칼, 갈
        _ => return ending(bare),
    })
}

/// The ending of the last word of `text`; `None` if it contains neither letters nor digits.
pub fn ending(text: &str) -> Option<Ending> {
    const SYLLABLES: u32 = 0xAC00;
    const FINALS: u32 = 28; // final consonants of a Hangul syllable, 0: none, 8: ㄹ
    let word = text.trim_end_matches(|c: char| !c.is_alphanumeric());
    let last_word = word.rsplit(char::is_whitespace).next()?;
    // "1/210" is read 210분의 1, so the numerator comes last
    let read = last_word
        .split_once('/')
        .map_or(word, |(numerator, denominator)| {
            let fraction = numerator.ends_with(|c: char| c.is_ascii_digit())
                && denominator.starts_with(|c: char| c.is_ascii_digit());
            if fraction { numerator } else { word }
        });
    Some(match read.chars().last()? {
        last @ '가'..='힣' => match (u32::from(last) - SYLLABLES) % FINALS {
            0 => Ending::Vowel,
            8 => Ending::Rieul,
            _ => Ending::Consonant,
        },
        last if last.is_ascii_alphabetic() => ending_of_latin(read),
        '1' | '7' | '8' => Ending::Rieul,     // 일, 칠, 팔
        '0' | '3' | '6' => Ending::Consonant, // 영, 삼, 육
        _ => Ending::Vowel,
    })
}

/// Ending of a word in Latin letters. Single letters and capitals are read by the names of letters (엘, 알, 엠, 엔), other words as
/// loanwords: 스톤, 프레임, 푸팅, 블록, 캡, 볼; but 로거, 루프, 샤프트.
fn ending_of_latin(read: &str) -> Ending {
    let start = read
        .rfind(|c: char| !c.is_ascii_alphabetic())
        .map_or(0, |at| at + read[at..].chars().next().map_or(0, char::len_utf8));
    let word = &read[start..];
    let is_spelt = word.len() == 1 || word.bytes().all(|letter| letter.is_ascii_uppercase());
    let word = word.to_ascii_lowercase();
    if is_spelt {
        return match word.as_bytes().last() {
            Some(b'l' | b'r') => Ending::Rieul,
            Some(b'm' | b'n') => Ending::Consonant,
            _ => Ending::Vowel,
        };
    }
    let before = |end: &str| word.strip_suffix(end).and_then(|rest| rest.chars().last());
    let is_vowel = |letter: char| "aeiou".contains(letter);
    if ["l", "le"].iter().any(|end| word.ends_with(end)) {
        return Ending::Rieul;
    }
    let is_closed = ["n", "m", "ng", "ne", "me", "ck"]
        .iter()
        .any(|end| word.ends_with(end))
        || ["k", "p", "c"]
            .iter()
            .any(|end| before(end).is_some_and(is_vowel));
    match is_closed {
        true => Ending::Consonant,
        false => Ending::Vowel,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_particles_follow_the_last_sound() {
        for (written, chosen) in [
            ("노반이(가) 들린다", "노반이 들린다"),
            ("기둥 2이(가) 들린다", "기둥 2가 들린다"),
            ("2층 탑신은(는) 흔들린다", "2층 탑신은 흔들린다"),
            ("옥개석(으)로 옮긴다", "옥개석으로 옮긴다"),
            ("기울기 1/210(으)로 본다", "기울기 1/210로 본다"),
            ("‘복발’을(를) 받친다", "‘복발’을 받친다"),
            ("지대석과 지주와(과) 초석", "지대석과 지주와 초석"),
            ("‘keystone’이(가)", "‘keystone’이"),
            ("footing이(가)", "footing이"),
            ("logger은(는)", "logger는"),
            ("crown bowl(으)로", "crown bowl로"),
            ("roof이(가) cap을(를)", "roof가 cap을"),
            ("KDS은(는) x이(가) SPM과 n을(를)", "KDS는 x가 SPM과 n을"),
            ("2023-04-13와(과) 292.3(으)로", "2023-04-13과 292.3으로"),
        ] {
            assert_eq!(particles(written, None), chosen);
        }
        assert_eq!(particles("을(를) 넘는다", Some(Ending::Consonant)), "을 넘는다");
        let read = ["Hz", "kN·m/rad", "N·m", "MPa", "kg/m³", ""].map(ending_of_unit);
        let (vowel, consonant) = (Some(Ending::Vowel), Some(Ending::Consonant));
        assert_eq!(read, [vowel, consonant, vowel, Some(Ending::Rieul), vowel, None]);
    }
}
