//! Writes XML: every element is closed, and text is escaped.

/// A piece of XML in the making.
#[derive(Debug, Default)]
pub(crate) struct Xml {
    text: String,
}

/// Names of attributes with their values.
pub(crate) type Attributes<'a> = &'a [(&'a str, &'a str)];

impl Xml {
    /// An empty document with its declaration.
    pub(crate) fn document() -> Self {
        Xml {
            text: "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n".to_owned(),
        }
    }

    /// An element with nothing in it.
    pub(crate) fn leaf(&mut self, tag: &str, attributes: Attributes<'_>) {
        self.start(tag, attributes);
        self.text.push_str("/>");
    }

    /// An element with the content that `inside` writes.
    pub(crate) fn element(&mut self, tag: &str, attributes: Attributes<'_>, inside: impl FnOnce(&mut Xml)) {
        self.start(tag, attributes);
        self.text.push('>');
        inside(self);
        self.text.push_str("</");
        self.text.push_str(tag);
        self.text.push('>');
    }

    /// An element with text.
    pub(crate) fn words(&mut self, tag: &str, attributes: Attributes<'_>, words: &str) {
        self.element(tag, attributes, |xml| xml.escaped(words));
    }

    /// Appends XML that was written separately.
    pub(crate) fn append(&mut self, other: Xml) {
        self.text.push_str(&other.text);
    }

    pub(crate) fn finish(self) -> String {
        self.text
    }

    fn start(&mut self, tag: &str, attributes: Attributes<'_>) {
        self.text.push('<');
        self.text.push_str(tag);
        for (name, value) in attributes {
            self.text.push(' ');
            self.text.push_str(name);
            self.text.push_str("=\"");
            self.escaped(value);
            self.text.push('"');
        }
    }

    /// Text; characters that XML forbids, such as control characters, become spaces.
    fn escaped(&mut self, words: &str) {
        for character in words.chars() {
            match character {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                '"' => self.text.push_str("&quot;"),
                c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => self.text.push(' '),
                other => self.text.push(other),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_words_stay_words() {
        let mut xml = Xml::default();
        xml.element("a", &[("b", "<&\">'")], |xml| {
            xml.words("c", &[], "<d/> & \u{1}\n\u{ffff}한");
            xml.leaf("e", &[]);
        });
        let written = "<a b=\"&lt;&amp;&quot;&gt;'\"><c>&lt;d/&gt; &amp;    한</c><e/></a>";
        assert_eq!(xml.finish(), written);
    }
}
