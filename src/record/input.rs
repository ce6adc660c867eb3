//! Purpose: hand a file's lines over in large blocks, unpacked and hashed on the way.
//!
//! Method: one thread reads, hashes and unpacks; the caller parses what has come so far. At most
//! a few blocks are alive, so that memory does not grow with the file.

use super::Source;
use crate::{Error, Result};
use flate2::bufread::MultiGzDecoder;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};

const BLOCK: u64 = 1 << 18;
const LONGEST_LINE: usize = 16 << 20;
const BLOCKS_WAITING: usize = 4;

/// Whole lines; only the last block may end without a line end.
pub(super) type Block = Vec<u8>;

/// A file whose bytes are hashed as they pass.
struct Hashed {
    file: File,
    hash: Sha256,
}

impl Read for Hashed {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let got = self.file.read(into)?;
        self.hash.update(&into[..got]);
        Ok(got)
    }
}

enum Decoder {
    Plain(BufReader<Hashed>),
    Gzip(Box<MultiGzDecoder<BufReader<Hashed>>>),
}

impl Decoder {
    fn open(path: &Path) -> io::Result<Self> {
        let file = File::open(path)?;
        if file.metadata()?.is_dir() {
            return Err(io::Error::other("this is a folder; give a file"));
        }
        let mut reader = BufReader::with_capacity(1 << 18, Hashed { file, hash: Sha256::new() });
        Ok(if reader.fill_buf()?.starts_with(&[0x1f, 0x8b]) {
            Self::Gzip(Box::new(MultiGzDecoder::new(reader)))
        } else {
            Self::Plain(reader)
        })
    }

    fn finish(self) -> io::Result<String> {
        let mut reader = match self {
            Self::Plain(reader) => reader,
            Self::Gzip(gzip) => gzip.into_inner(),
        };
        io::copy(&mut reader, &mut io::sink())?;
        Ok(hexadecimal(&reader.into_inner().hash.finalize()))
    }
}

impl Read for Decoder {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::Plain(reader) => reader.read(into),
            Self::Gzip(reader) => reader.read(into),
        }
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// What takes a file's lines in.
pub(super) trait Sink {
    /// Takes whole lines.
    fn take(&mut self, block: &[u8]) -> Result<()>;
    /// The number of whole lines taken, for messages.
    fn lines(&self) -> usize;
}

/// Reads a file through to its end and hands its lines over, block by block.
///
/// # Errors
/// What the sink refuses; a file that cannot be read, or a gzip file that is damaged or cut
/// short, with the last line that could be read.
pub(super) fn read_lines(path: &Path, sink: &mut impl Sink) -> Result<Source> {
    let decoder = Decoder::open(path).map_err(|e| missing(path, &e))?;
    let packed = matches!(decoder, Decoder::Gzip(_));
    let (sender, blocks) = sync_channel(BLOCKS_WAITING);
    let (back, used) = channel();
    let hash = std::thread::scope(|scope| {
        let reader = scope.spawn(move || pump(decoder, &sender, &used));
        take_all(blocks, &back, sink)?;
        reader
            .join()
            .unwrap_or_else(|_| Err(io::Error::other("the reader stopped")))
            .map_err(|e| if packed { damaged(path, &e, sink.lines()) } else { Error::io(path, &e) })
    })?;
    Ok(Source { file: path.to_owned(), sha256: hash })
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

fn pump(mut decoder: Decoder, sender: &SyncSender<Block>, used: &Receiver<Block>) -> io::Result<String> {
    let mut bytes = Vec::new();
    loop {
        let got = decoder.by_ref().take(BLOCK).read_to_end(&mut bytes);
        let whole = match got {
            Ok(0) => bytes.len(),
            _ => bytes.iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1),
        };
        let mut rest = used.try_recv().unwrap_or_else(|_| Vec::with_capacity(2 * BLOCK as usize));
        rest.extend_from_slice(&bytes[whole..]);
        bytes.truncate(whole);
        // A consumer that has given up has its own error to tell.
        if whole > 0 && sender.send(bytes).is_err() {
            return Ok(String::new());
        }
        bytes = rest;
        match got {
            Ok(0) => return decoder.finish(),
            Ok(_) if bytes.len() > LONGEST_LINE => {
                return Err(io::Error::other("a line is longer than 16 MB; this is no table of text"));
            }
            Ok(_) => {}
            Err(e) => return Err(e),
        }
    }
}

fn missing(path: &Path, e: &io::Error) -> Error {
    let error = Error::io(path, e);
    match e.kind() {
        io::ErrorKind::NotFound => {
            error.with_hint("a path in a TOML recording is relative to the folder of the TOML file")
        }
        _ => error,
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

impl Source {
    /// A file whose bytes were read already.
    pub fn of(path: &Path, bytes: &[u8]) -> Self {
        Self { file: path.to_owned(), sha256: hexadecimal(&Sha256::digest(bytes)) }
    }
}
