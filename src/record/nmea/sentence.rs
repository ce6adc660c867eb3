//! A line of a log: stamp, address, fields, checksum.

/// A sentence whose checksum is right.
pub(super) struct Sentence<'a> {
    /// What stands before it in its line.
    before: &'a str,
    /// Talker and kind (`HEHDT`), or the proprietary name (`PSXN`).
    pub address: &'a str,
    /// The fields after the address.
    pub fields: Vec<&'a str>,
}

/// Why a line is no sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fault {
    NoSentence,
    NoStamp,
    NoClock,
    NoChecksum,
    WrongChecksum,
}

impl Fault {
    pub(super) const ALL: [Self; 5] =
        [Self::NoSentence, Self::NoStamp, Self::NoClock, Self::NoChecksum, Self::WrongChecksum];

    /// What a number of such lines "have".
    pub(super) fn says(self) -> &'static str {
        match self {
            Self::NoSentence => "hold no sentence",
            Self::NoStamp => "have no time stamp before the sentence, or none of a time that there was",
            Self::NoClock => {
                "stand where no ZDA sentence gives them a time, or tell no valid time of their own"
            }
            Self::NoChecksum => "have no checksum, or are cut short",
            Self::WrongChecksum => "have a wrong checksum",
        }
    }
}

/// Takes a line apart and checks it: the checksum is the exclusive or of all bytes between
/// `$` and `*`.
pub(super) fn parse(line: &str) -> Result<Sentence<'_>, Fault> {
    let start = line.find(['$', '!']).ok_or(Fault::NoSentence)?;
    let (before, body) = (&line[..start], &line[start + 1..]);
    let (body, sum) = body.rsplit_once('*').ok_or(Fault::NoChecksum)?;
    let sum = sum.trim_end();
    if sum.len() != 2 {
        return Err(Fault::NoChecksum);
    }
    let sum = u8::from_str_radix(sum, 16).map_err(|_| Fault::NoChecksum)?;
    if body.bytes().fold(0, |x, byte| x ^ byte) != sum {
        return Err(Fault::WrongChecksum);
    }
    let mut fields = body.split(',');
    let address = fields.next().filter(|a| a.len() >= 3).ok_or(Fault::NoSentence)?;
    Ok(Sentence { before, address, fields: fields.collect() })
}

impl<'a> Sentence<'a> {
    /// What should be a time stamp.
    pub(super) fn stamp(&self) -> &'a str {
        self.before.trim_end_matches([' ', '\t', ',', ';']).trim_start()
    }

    /// The field of a number, counted from 1 after the address.
    pub(super) fn field(&self, number: usize) -> &'a str {
        self.fields.get(number - 1).map_or("", |f| f.trim())
    }

    /// Whether this is a sentence of a name (with or without its talker) and number.
    pub(super) fn is(&self, name: &str, id: Option<u32>) -> bool {
        let named = self.address == name || kind(self.address) == name;
        named && id.is_none_or(|id| self.field(1).parse() == Ok(id))
    }
}

/// The kind of an address without its talker; a proprietary address has none.
pub(super) fn kind(address: &str) -> &str {
    if address.starts_with('P') {
        address
    } else {
        address.get(2..).filter(|k| !k.is_empty()).unwrap_or(address)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksum_by_hand() {
        // 'A' ^ 'B' ^ 'C' = 0x40.
        let fine = parse("1970-01-01T00:00:01Z $ABC*40").unwrap();
        assert_eq!((fine.stamp(), fine.address), ("1970-01-01T00:00:01Z", "ABC"));
        assert_eq!(parse("1970-01-01T00:00:01Z $ABC*41").err(), Some(Fault::WrongChecksum));
        assert_eq!(parse("1970-01-01T00:00:01Z $ABC").err(), Some(Fault::NoChecksum));
        assert_eq!(parse("1970-01-01T00:00:01Z $ABC*4").err(), Some(Fault::NoChecksum));
        assert_eq!(parse("$ABC*40").unwrap().stamp(), "");
        assert_eq!(parse("1970-01-01T00:00:01Z").err(), Some(Fault::NoSentence));
    }

    #[test]
    fn the_talker_is_ignored() {
        assert_eq!(kind("HEHDT"), "HDT");
        assert_eq!(kind("PSXN"), "PSXN");
        assert_eq!(kind("é"), "é");
    }
}
