//! The bytes of an input: hashed as they come, and unpacked where gzip packed them.

use flate2::bufread::GzDecoder;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::io::{self, BufRead, Read};

const BUFFER: usize = 1 << 18;
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// A stream whose bytes are hashed as they pass, and that can be looked into.
struct Hashed {
    stream: Box<dyn Read + Send>,
    hash: Sha256,
    buffer: Vec<u8>,
    at: usize,
}

impl Hashed {
    /// At least so many of the next bytes, fewer only at the end.
    fn peek(&mut self, count: usize) -> io::Result<&[u8]> {
        while self.buffer.len() - self.at < count {
            self.buffer.drain(..self.at);
            let had = self.buffer.len();
            self.at = 0;
            self.buffer.resize(BUFFER, 0);
            let got = loop {
                match self.stream.read(&mut self.buffer[had..]) {
                    Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                    got => break got,
                }
            };
            self.buffer.truncate(had + *got.as_ref().unwrap_or(&0));
            self.hash.update(&self.buffer[had..]);
            if got? == 0 {
                break;
            }
        }
        Ok(&self.buffer[self.at..])
    }
}

impl Read for Hashed {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let got = self.fill_buf()?.read(into)?;
        self.consume(got);
        Ok(got)
    }
}

impl BufRead for Hashed {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.peek(1)
    }

    fn consume(&mut self, count: usize) {
        self.at += count;
    }
}

/// The bytes of a stream, unpacked.
pub(super) struct Unpacked {
    packed: bool,
    state: State,
}

enum State {
    Plain(Hashed),
    /// Inside one of the members that a gzip file may consist of.
    Member(Box<GzDecoder<Hashed>>),
    /// After the last member.
    Behind(Hashed),
    /// In the midst of a change.
    Nothing,
}

impl Unpacked {
    pub(super) fn new(stream: Box<dyn Read + Send>) -> io::Result<Self> {
        let mut hashed = Hashed { stream, hash: Sha256::new(), buffer: Vec::new(), at: 0 };
        let packed = hashed.peek(GZIP.len())?.starts_with(&GZIP);
        let state =
            if packed { State::Member(Box::new(GzDecoder::new(hashed))) } else { State::Plain(hashed) };
        Ok(Self { packed, state })
    }

    pub(super) fn is_packed(&self) -> bool {
        self.packed
    }

    /// Reads what is left; the hash of all bytes, and what is to be said of those behind the last member. Zeros
    /// are the padding of a tape.
    pub(super) fn finish(self) -> io::Result<(String, Option<String>)> {
        let (mut hashed, behind) = match self.state {
            State::Plain(hashed) => (hashed, false),
            State::Member(decoder) => (decoder.into_inner(), false),
            State::Behind(hashed) => (hashed, true),
            State::Nothing => return Err(io::Error::other("the reader stopped")),
        };
        let (mut count, mut padding) = (0, true);
        loop {
            let bytes = hashed.fill_buf()?;
            if bytes.is_empty() {
                break;
            }
            padding &= bytes.iter().all(|b| *b == 0);
            let length = bytes.len();
            count += length;
            hashed.consume(length);
        }
        let note = (behind && !padding).then(|| {
            format!("{count} bytes follow the end of the gzip data; they are no gzip, and left out")
        });
        Ok((hexadecimal(&hashed.hash.finalize()), note))
    }
}

impl Read for Unpacked {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        loop {
            match &mut self.state {
                State::Plain(hashed) => return hashed.read(into),
                State::Member(decoder) => {
                    let got = decoder.read(into)?;
                    if got > 0 || into.is_empty() {
                        return Ok(got);
                    }
                }
                State::Behind(_) | State::Nothing => return Ok(0),
            }
            let State::Member(decoder) = std::mem::replace(&mut self.state, State::Nothing) else { continue };
            let mut hashed = decoder.into_inner();
            let another = hashed.peek(GZIP.len())?.starts_with(&GZIP);
            self.state =
                if another { State::Member(Box::new(GzDecoder::new(hashed))) } else { State::Behind(hashed) };
        }
    }
}

/// The hash of bytes that lie in memory.
pub(super) fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
