//! Tables that are no text: files of MATLAB, and what is refused with what to do.

use gyrospec::record::{Recording, columns};
use std::io::Write;
use std::path::{Path, PathBuf};

/// One element of a MATLAB file.
fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut out = kind.to_le_bytes().to_vec();
    out.extend((data.len() as u32).to_le_bytes());
    out.extend(data);
    out.resize(out.len().next_multiple_of(8), 0);
    out
}

/// One of at most four bytes, which stand in its tag.
fn small(kind: u16, data: &[u8]) -> Vec<u8> {
    let mut out = [kind.to_le_bytes(), (data.len() as u16).to_le_bytes()].concat();
    out.extend(data);
    out.resize(8, 0);
    out
}

/// A variable of a class with what its numbers are stored in.
fn variable(name: &str, (class, kind): (u8, u32), size: [i32; 2], data: &[u8]) -> Vec<u8> {
    let mut inner = element(6, &[class, 0, 0, 0, 0, 0, 0, 0]);
    inner.extend(element(5, &size.map(i32::to_le_bytes).concat()));
    inner.extend(if name.len() <= 4 { small(1, name.as_bytes()) } else { element(1, name.as_bytes()) });
    inner.extend(element(kind, data));
    element(14, &inner)
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

fn packed(element: &[u8]) -> Vec<u8> {
    let mut zip = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    zip.write_all(element).unwrap();
    let data = zip.finish().unwrap();
    [15_u32.to_le_bytes().to_vec(), (data.len() as u32).to_le_bytes().to_vec(), data].concat()
}

fn mat(elements: &[Vec<u8>]) -> Vec<u8> {
    let mut out = b"MATLAB 5.0 MAT-file, made by a test".to_vec();
    out.resize(124, b' ');
    out.extend([0, 1]);
    out.extend(b"IM");
    out.extend(elements.concat());
    out
}

/// Time as a column of doubles, packed; a force as whole numbers in a row; a matrix; a structure; and what is none.
fn example() -> Vec<u8> {
    let whole: Vec<u8> = [3i16, -4, 5].iter().flat_map(|v| v.to_le_bytes()).collect();
    let mut inner = element(6, &[2, 0, 0, 0, 0, 0, 0, 0]);
    inner.extend(element(5, &[1i32, 1].map(i32::to_le_bytes).concat()));
    inner.extend(element(1, b"rig_log"));
    inner.extend(small(5, &8_i32.to_le_bytes()));
    inner.extend(element(1, b"pos_mm\0\0note\0\0\0\0"));
    inner.extend(variable("", (6, 9), [3, 1], &doubles(&[10.0, f64::NAN, 30.0])));
    inner.extend(variable("", (4, 4), [1, 2], &[65, 0, 66, 0]));
    mat(&[
        variable("M", (6, 9), [3, 2], &doubles(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0])),
        packed(&variable("t_s", (6, 9), [3, 1], &doubles(&[0.0, 0.5, 1.0]))),
        variable("force_N", (10, 3), [1, 3], &whole),
        element(14, &inner),
        variable("gain", (6, 9), [1, 1], &doubles(&[7.0])),
        variable("other", (6, 9), [1, 4], &doubles(&[0.0; 4])),
    ])
}

fn written(folder: &Path, name: &str, bytes: &[u8]) -> PathBuf {
    let file = folder.join(name);
    std::fs::write(&file, bytes).unwrap();
    file
}

#[test]
fn a_file_of_matlab_is_a_table() {
    let folder = tempfile::tempdir().unwrap();
    let file = written(folder.path(), "run.mat", &example());
    let r = Recording::read(&file).unwrap();
    let force = r.channel("force").unwrap();
    assert_eq!((&*force.time, &force.values[..]), (&[0.0, 0.5, 1.0][..], &[3.0, -4.0, 5.0][..]));
    let position = &r.channel("rig_log.pos").unwrap().values;
    assert!(position[0] == 0.01 && position[1].is_nan() && position[2] == 0.03, "{position:?}");
    let notes: String = r.notes.iter().map(|n| n.message.clone() + "\n").collect();
    for says in [
        "a MATLAB file: 5 columns of 3 rows",
        "rig_log.note is text",
        "gain is a single number",
        "other has 4 values",
    ] {
        assert!(notes.contains(says), "{says}: {notes}");
    }
    // a matrix has a name a column, which a recording file takes
    let names: Vec<String> = columns(&file).unwrap().into_iter().map(|c| c.name).collect();
    assert!(names.contains(&"M.1".to_owned()) && names.contains(&"M.2".to_owned()), "{names:?}");
    let text = "[[tables]]\nfile = \"run.mat\"\ntime = { column = \"t\", unit = \"s\" }\nchannels.y = { column = \"M.2\", unit = \"mm\" }\n";
    let r = Recording::read(written(folder.path(), "run.toml", text.as_bytes())).unwrap();
    assert_eq!(r.channel("y").unwrap().values, [0.004, 0.005, 0.006]);
}

#[test]
fn a_damaged_file_of_matlab_is_refused_wherever_it_ends() {
    let folder = tempfile::tempdir().unwrap();
    let whole = example();
    let place = |bytes: &[u8]| Recording::read(written(folder.path(), "cut.mat", bytes));
    for end in 128..whole.len() {
        // whole variables may be missing, no number may be another
        if let Ok(r) = place(&whole[..end]) {
            assert!(r.channels.iter().all(|c| c.len() == 3), "{end}");
        }
    }
    let error = place(&whole[..whole.len() - 9]).unwrap_err();
    assert!(error.to_string().contains("damaged or cut short") && error.file().is_some(), "{error}");
    let mut state = 1_u64;
    for _ in 0..3000 {
        let mut bytes = whole.clone();
        for _ in 0..3 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let at = 128 + (state >> 33) as usize % (bytes.len() - 128);
            bytes[at] = (state >> 21) as u8;
        }
        let _ = place(&bytes);
    }
    let mut big = whole;
    big[126..128].copy_from_slice(b"MI");
    assert!(place(&big).unwrap_err().to_string().contains("byte order"));
}

#[test]
fn other_tables_are_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let mut new = b"MATLAB 7.3 MAT-file, Platform: GLNXA64".to_vec();
    new.resize(600, 0);
    // a row of two doubles named t: kind, rows, columns, imaginary part, length of the name, either end first
    let head = [0_u32, 1, 2, 0, 2];
    let mut old = [head.map(u32::to_le_bytes).concat(), b"t\0".to_vec(), doubles(&[0.0, 1.0])].concat();
    let [mut swapped, big] = [old.clone(), [1000, 1, 2, 0, 2].map(u32::to_be_bytes).concat()];
    swapped[..20].copy_from_slice(&big);
    old.extend(old.clone());
    let mut damaged = example();
    damaged[126] = 0;
    let cases: [(&str, &[u8], &str, &str); 8] = [
        ("damaged.mat", &damaged, "damaged or cut short", "copy it again"),
        ("short.mat", &example()[..90], "damaged or cut short", "copy it again"),
        ("old.mat", &old, "format 4", "'-v7'"),
        ("swapped.mat", &swapped, "format 4", "'-v7'"),
        ("a.mat", &new, "format 7.3", "'-v7'"),
        ("a.h5", b"\x89HDF\r\n\x1a\n....", "HDF5", "CSV"),
        ("a.xlsx", b"PK\x03\x04.........", "workbook", "CSV"),
        ("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1....", "old spreadsheet", "CSV"),
    ];
    for (name, bytes, what, hint) in cases {
        let error = Recording::read(written(folder.path(), name, bytes)).unwrap_err();
        assert!(error.to_string().contains(what), "{error}");
        assert!(error.hint().is_some_and(|h| h.contains(hint)) && error.file().is_some(), "{error}");
    }
    let error = Recording::read(written(folder.path(), "a.parquet", b"PAR1....")).unwrap_err();
    let says = if cfg!(feature = "parquet") { "cannot be read" } else { "does not read" };
    assert!(error.to_string().contains(says), "{error}");
}
