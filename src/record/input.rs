//! Purpose: one reader for every input: a file, a pipe, a device, or standard input for `-`. Each is opened
//! and read once; what it is, its first bytes tell.
//!
//! Method: for tables one thread reads, hashes and unpacks; the caller parses what has come so far. At most
//! a few blocks are alive, so that memory does not grow with the file.

use super::Source;
use super::foreign;
use super::packed::Unpacked;
use crate::{Error, Result};
use encoding_rs::Decoder;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel, sync_channel};

const BLOCK: u64 = 1 << 18;
const LONGEST_LINE: usize = 16 << 20;
const BLOCKS_WAITING: usize = 4;
/// Longest text that is read whole: a model, parameters, the description of a recording.
const LONGEST_TEXT: u64 = 256 << 20;
/// Bytes that are looked at to tell what an input is.
const START: u64 = 1 << 16;
const MARK: &[u8] = b"\xef\xbb\xbf";

/// Whole lines; only the last block may end without a line end.
pub(super) type Block = Vec<u8>;

/// An input, opened; its bytes come unpacked, without a byte-order mark of UTF-8, and with line ends of
/// carriage returns alone turned into line feeds.
pub(crate) struct Input {
    path: PathBuf,
    bytes: Unpacked,
    /// What was read to look at, and how much of it was handed over.
    start: Vec<u8>,
    taken: usize,
    /// A failure met while looking, to be told when the reader comes there.
    failed: Option<io::Error>,
    /// Whether lines end with carriage returns alone.
    returns: bool,
    /// What turns the bytes into UTF-8, where they are none.
    decoder: Option<Decoder>,
    /// What is to be said of what was turned into text.
    coded: Option<String>,
}

impl Input {
    /// Opens a file, or standard input for `-`.
    ///
    /// # Errors
    /// `Io`.
    pub(crate) fn open(path: &Path) -> Result<Self> {
        let mut bytes = source(path).and_then(Unpacked::new).map_err(|e| Error::io(path, &e))?;
        let mut start = Vec::new();
        let failed = bytes.by_ref().take(START).read_to_end(&mut start).err();
        let taken = if start.starts_with(MARK) { MARK.len() } else { 0 };
        let returns = ends_with_returns(&start);
        Ok(Self { path: path.to_owned(), bytes, start, taken, failed, returns, decoder: None, coded: None })
    }

    /// What was opened.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The first bytes, up to 64 KiB.
    pub(crate) fn start(&self) -> &[u8] {
        let left = &self.start[self.taken.min(self.start.len())..];
        &left[..left.len().min(START as usize)]
    }

    /// Whether the first bytes are all that there are.
    pub(crate) fn is_whole(&self) -> bool {
        (self.start.len() as u64) < START
    }

    /// The same as a table of text, which may be UTF-16 with its mark or Windows-1252 (Latin-1) beside UTF-8, or a file
    /// of MATLAB.
    ///
    /// # Errors
    /// A table of another kind, with what to do; one that is damaged.
    pub(super) fn into_table(mut self) -> Result<Self> {
        let place = |e: Error, path: &Path| e.with_file(path);
        if let Some(turn) = foreign::turn(self.start()).map_err(|e| place(e, &self.path))? {
            let mut bytes = std::mem::take(&mut self.start);
            self.bytes.read_to_end(&mut bytes).map_err(|e| Error::io(&self.path, &e))?;
            let turned = turn(&bytes).map_err(|e| place(e, &self.path))?;
            (self.start, self.taken, self.returns) = (turned.text, 0, false);
            self.coded = Some(turned.note);
            return Ok(self);
        }
        let encoding = match self.start.as_slice() {
            [0xFF, 0xFE, 0, 0, ..] => None,
            [0xFF, 0xFE, ..] => Some(encoding_rs::UTF_16LE),
            [0xFE, 0xFF, ..] => Some(encoding_rs::UTF_16BE),
            start if is_latin(start) => Some(encoding_rs::WINDOWS_1252),
            _ => None,
        };
        let Some(encoding) = encoding else { return Ok(self.with_line_feeds()) };
        let mut decoder = encoding.new_decoder_with_bom_removal();
        let is_last = self.is_whole();
        self.start = decoded(&mut decoder, &self.start, is_last && self.failed.is_none());
        self.taken = 0;
        self.returns = ends_with_returns(&self.start);
        self.decoder = Some(decoder).filter(|_| !is_last);
        self.coded = Some(format!("read as {}", encoding.name()));
        Ok(self.with_line_feeds())
    }

    /// The same, lone carriage returns of its first bytes turned already: how it is written is told from these.
    fn with_line_feeds(mut self) -> Self {
        if self.returns {
            turn_returns(&mut self.start);
        }
        self
    }

    /// What is to be said of what was turned into text.
    pub(super) fn coded(&self) -> Option<String> {
        self.coded.clone()
    }

    /// Whether this is a TOML file: by its name, or as its first line that says something is `key = …` or `[table]`.
    pub(crate) fn is_toml(&self) -> bool {
        let is = |names: &[&str]| {
            self.path.extension().is_some_and(|e| names.iter().any(|n| e.eq_ignore_ascii_case(n)))
        };
        if is(&["csv", "tsv", "txt", "dat", "asc", "lvm", "mat", "parquet"]) {
            return false;
        }
        is(&["toml"]) || looks_like_toml(&String::from_utf8_lossy(self.start()))
    }

    /// The whole text, and the hash of the bytes as they came.
    ///
    /// # Errors
    /// What is no UTF-8 text; `Io`.
    pub(crate) fn text(mut self) -> Result<(String, Source)> {
        let mut bytes = Vec::new();
        let path = self.path.clone();
        self.by_ref().take(LONGEST_TEXT + 1).read_to_end(&mut bytes).map_err(|e| Error::io(&path, &e))?;
        if bytes.len() as u64 > LONGEST_TEXT {
            return Err(Error::bad_input("more than 256 MiB, and no end: no text is so long")
                .with_file(&path)
                .with_hint("a model, parameters or the description of a recording is a short file"));
        }
        let (sha256, _) = self.bytes.finish().map_err(|e| Error::io(&path, &e))?;
        let text = String::from_utf8(bytes).map_err(|e| {
            let at = e.utf8_error().valid_up_to();
            let what = match e.as_bytes() {
                [0xFF, 0xFE, 0, 0, ..] | [0, 0, 0xFE, 0xFF, ..] => "the file is UTF-32".to_owned(),
                [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] => "the file is UTF-16".to_owned(),
                _ => format!("byte {at} is no UTF-8 text"),
            };
            Error::bad_input(what).with_file(&path).with_hint("save it as UTF-8")
        })?;
        Ok((text, Source { file: path, sha256 }))
    }
}

impl Input {
    /// Fills what is handed over with the next decoded bytes, if there are any and a decoder.
    fn decode_more(&mut self) -> io::Result<()> {
        while let (Some(decoder), true) = (&mut self.decoder, self.start.is_empty()) {
            let mut raw = Vec::new();
            self.bytes.by_ref().take(START).read_to_end(&mut raw)?;
            let is_last = raw.is_empty();
            self.start = decoded(decoder, &raw, is_last);
            if is_last {
                self.decoder = None;
            }
        }
        Ok(())
    }
}

/// Bytes as UTF-8.
fn decoded(decoder: &mut Decoder, bytes: &[u8], is_last: bool) -> Vec<u8> {
    let mut text =
        String::with_capacity(decoder.max_utf8_buffer_length(bytes.len()).unwrap_or(3 * bytes.len() + 8));
    // the room asked for is enough for all, so that nothing is left over
    let _ = decoder.decode_to_string(bytes, &mut text, is_last);
    text.into_bytes()
}

/// Whether bytes are text in one byte a character: no UTF-8, and without control characters.
fn is_latin(start: &[u8]) -> bool {
    let bad = std::str::from_utf8(start).is_err_and(|e| e.error_len().is_some());
    bad && !start.iter().any(|b| *b < 9 || (14..32).contains(b) || *b == 127)
}

impl Read for Input {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.start().is_empty() {
            if let Some(e) = self.failed.take() {
                return Err(e);
            }
            (self.start, self.taken) = (Vec::new(), 0);
            self.decode_more()?;
        }
        let mut left = self.start();
        let got = if left.is_empty() {
            if self.coded.is_some() { 0 } else { self.bytes.read(into)? }
        } else {
            let got = left.read(into)?;
            self.taken += got;
            got
        };
        if self.returns {
            turn_returns(&mut into[..got]);
        }
        Ok(got)
    }
}

/// The stream behind a path; `-` is standard input.
fn source(path: &Path) -> io::Result<Box<dyn Read + Send>> {
    if path == Path::new("-") {
        return Ok(Box::new(io::stdin()));
    }
    let file = File::open(path)?;
    if file.metadata()?.is_dir() {
        return Err(io::Error::other("this is a folder; give a file"));
    }
    Ok(Box::new(file))
}

/// Carriage returns become line feeds.
fn turn_returns(bytes: &mut [u8]) {
    bytes.iter_mut().filter(|b| **b == b'\r').for_each(|b| *b = b'\n');
}

/// Whether the first line end outside quotes is a carriage return alone.
fn ends_with_returns(start: &[u8]) -> bool {
    let mut quoted = false;
    let end = start.iter().position(|b| {
        quoted ^= *b == b'"';
        !quoted && matches!(b, b'\r' | b'\n')
    });
    end.is_some_and(|at| start[at] == b'\r' && start.get(at + 1) != Some(&b'\n'))
}

fn looks_like_toml(start: &str) -> bool {
    let mut lines = start.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with('#'));
    let Some(line) = lines.next() else { return false };
    // a spreadsheet's word on what separates its columns
    if line.to_lowercase().strip_prefix("sep=").is_some_and(|s| s.chars().count() == 1) {
        return false;
    }
    let is_key = |text: &str| {
        !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || "_-.\"' ".contains(c))
    };
    let table = line.strip_prefix('[').and_then(|l| l.split('#').next()?.trim_end().strip_suffix(']'));
    let table = table.map(|t| t.strip_prefix('[').and_then(|t| t.strip_suffix(']')).unwrap_or(t));
    table.or_else(|| line.split_once('=').map(|(key, _)| key.trim())).is_some_and(is_key)
}

/// What takes a file's lines in.
pub(super) trait Sink {
    /// Takes whole lines.
    fn take(&mut self, block: &[u8]) -> Result<()>;
    /// The number of whole lines taken, for messages.
    fn lines(&self) -> usize;
}

/// What is known of an input that was read to its end: the hash, and what is to be said of it.
pub(super) type Told = (Source, Option<String>);

/// The hash of an input that was read to its end, and what is to be said of it.
type End = (String, Option<String>);

/// Reads an input through to its end and hands its lines over, block by block.
///
/// # Errors
/// What the sink refuses; an input that cannot be read, or a gzip file that is damaged or cut
/// short, with the last line that could be read.
pub(super) fn read_lines(input: Input, sink: &mut impl Sink) -> Result<Told> {
    let (path, packed) = (input.path.clone(), input.bytes.is_packed());
    let (sender, blocks) = sync_channel(BLOCKS_WAITING);
    let (back, used) = channel();
    // The input follows when the thread is there, so that it is not lost where the system gives none.
    let (give, given) = channel();
    let fetch = move || {
        let input = given.recv().map_err(io::Error::other)?;
        pump(input, |block| sender.send(block).ok().map(|()| used.try_recv().unwrap_or_default()))
    };
    // Not joined where the sink refuses: the writer of a pipe may keep the reader waiting.
    let end = match std::thread::Builder::new().spawn(fetch) {
        Ok(reader) => {
            // A reader that is gone already is told of when it is joined.
            let _ = give.send(input);
            take_all(blocks, &back, sink)?;
            reader.join().unwrap_or_else(|_| Err(io::Error::other("the reader stopped")))
        }
        Err(_) => alone(input, sink)?,
    };
    let (sha256, note) =
        end.map_err(|e| if packed { damaged(&path, &e, sink.lines()) } else { Error::io(&path, &e) })?;
    Ok((Source { file: path, sha256 }, note))
}

/// Takes blocks as they come and gives them back to be filled again.
fn take_all(blocks: Receiver<Block>, back: &Sender<Block>, sink: &mut impl Sink) -> Result<()> {
    for mut block in blocks {
        sink.take(&block)?;
        block.clear();
        // A reader that is done needs no more.
        let _ = back.send(block);
    }
    Ok(())
}

/// Reads and takes in turn, without a thread.
fn alone(input: Input, sink: &mut impl Sink) -> Result<io::Result<End>> {
    let mut taken = Ok(());
    let end = pump(input, |mut block| {
        taken = sink.take(&block);
        block.clear();
        taken.is_ok().then_some(block)
    });
    taken.map(|()| end)
}

/// Reads to the end; whole lines are handed over for a block to be filled next, and for none where no more is wanted.
fn pump(mut input: Input, mut hand_over: impl FnMut(Block) -> Option<Block>) -> io::Result<End> {
    let mut bytes = Block::new();
    loop {
        let got = input.by_ref().take(BLOCK).read_to_end(&mut bytes);
        let whole = match got {
            Ok(0) => bytes.len(),
            _ => bytes.iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1),
        };
        if whole > 0 {
            let rest = bytes.split_off(whole);
            // A consumer that has given up has its own error to tell.
            let Some(next) = hand_over(bytes) else { return Ok((String::new(), None)) };
            bytes = next;
            bytes.extend_from_slice(&rest);
        }
        match got {
            Ok(0) => return input.bytes.finish(),
            Ok(_) if bytes.len() > LONGEST_LINE => {
                return Err(io::Error::other("a line is longer than 16 MB; this is no table of text"));
            }
            Ok(_) => {}
            Err(e) => return Err(e),
        }
    }
}

fn damaged(path: &Path, e: &io::Error, lines: usize) -> Error {
    let what = match e.kind() {
        io::ErrorKind::UnexpectedEof => "the gzip file is cut short",
        io::ErrorKind::InvalidInput | io::ErrorKind::InvalidData => "the gzip file is damaged",
        _ => return Error::io(path, e),
    };
    Error::bad_input(format!("{what}: {lines} whole lines can be read, the rest cannot"))
        .with_file(path)
        .with_line(lines + 1)
        .with_hint("copy the file again from where it was made; `gzip -t FILE` tests a copy")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn toml_is_told_from_tables() {
        for toml in
            ["[[tables]]\n", "# words\n\nname = \"x\"\n", " [inputs] # words\n", "kind=\"trials\"", "a.b = 1"]
        {
            assert!(looks_like_toml(toml), "{toml}");
        }
        for other in [
            "t [s],x [m]\n",
            "",
            "# words\n",
            "t,a=b\n0,1\n",
            "[1,2]\n",
            "$HEHDT,1*00",
            "t [s]\n0\n",
            "sep=;\n",
        ] {
            assert!(!looks_like_toml(other), "{other}");
        }
    }

    #[test]
    fn line_ends_are_told_by_the_first_outside_quotes() {
        for (text, returns) in [
            ("a\rb", true),
            ("a\r\nb\rc", false),
            ("a\nb\rc", false),
            ("\"a\rb\",c\n", false),
            ("a", false),
            ("a\r", true),
        ] {
            assert_eq!(ends_with_returns(text.as_bytes()), returns, "{text:?}");
        }
    }
}
