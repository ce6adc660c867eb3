//! Tables as people's programs write them: each dialect in a few lines, with what it must mean.

use gyrospec::Result;
use gyrospec::record::Recording;

/// A recording of the bytes of one file.
fn read(bytes: &[u8]) -> Result<Recording> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.csv");
    std::fs::write(&file, bytes).unwrap();
    Recording::read(&file)
}

fn utf_16(text: &str, of: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(of).collect()
}

#[test]
fn a_recording_knows_the_unit_in_which_its_file_counts_time() {
    let unit = |text: &str| read(text.as_bytes()).unwrap().time_unit().text().to_owned();
    assert_eq!(unit("t [h],F [N]\n0,1\n0.5,2\n1,0\n"), "h");
    assert_eq!(unit("Time (min),F [N]\n0,1\n0.5,2\n1,0\n"), "min");
    // dates are no count of a unit
    let days = "t,F [N]\n2025-04-03T12:00:00Z,1\n2025-04-04T12:00:00Z,2\n2025-04-05T12:00:00Z,0\n";
    assert_eq!(unit(days), "s");
}

/// What every dialect below must give: a force of 1.5, -1234.5 and 0.25 N, at 0, 0.5 and 1 s.
#[track_caller]
fn gives_the_force(name: &str, bytes: &[u8], label: &str) {
    let r = read(bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
    let force = r.channel(label).unwrap_or_else(|e| panic!("{name}: {e}"));
    let since: Vec<f64> = force.time.iter().map(|t| t - force.time[0]).collect();
    assert!(since.iter().zip([0.0, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{name}: {since:?}");
    assert_eq!(force.unit.text(), "N", "{name}");
    assert_eq!(force.values, [1.5, -1234.5, 0.25], "{name}");
}

#[test]
fn forty_dialects_of_one_recording_mean_the_same() {
    let german = "Zeit [s];Kraft [N];Weg [mm]\r\n0,0;1,5;10\r\n0,5;-1234,5;11\r\n1,0;0,25;12\r\n";
    let plain = "t [s],Kraft [N]\n0,1.5\n0.5,-1234.5\n1,0.25\n";
    let clean: [(&str, &str); 56] = [
        ("plain", plain),
        ("spreadsheet, German", german),
        ("byte-order mark", "\u{feff}Zeit [s];Kraft [N]\r\n0;1,5\r\n0,5;-1234,5\r\n1;0,25\r\n"),
        ("thousands, German", "Zeit [s];Kraft [N]\n0,00;1,50\n0,50;-1.234,50\n1,00;0,25\n"),
        ("thousands, English", "Time [s],Kraft [N]\n0,1.5\n0.5,\"-1,234.5\"\n1,0.25\n"),
        ("thousands, Swiss", "Zeit [s];Kraft [N]\n0;1.5\n0.5;-1'234.5\n1;0.25\n"),
        ("thousands, French", "t [s];Kraft [N]\n0;1,5\n0,5;-1\u{202f}234,5\n1;0,25\n"),
        ("all quoted", "\"t [s]\";\"Kraft [N]\"\n\"0\";\"1,5\"\n\"0,5\";\"-1234,5\"\n\"1\";\"0,25\"\n"),
        ("carriage returns", "t [s],Kraft [N]\r0,1.5\r0.5,-1234.5\r1,0.25\r"),
        ("a spreadsheet's word on its separator", "sep=;\nt [s];Kraft [N]\n0;1,5\n0,5;-1234,5\n1;0,25\n"),
        ("tabs", "t [s]\tKraft [N]\n0\t1.5\n0.5\t-1234.5\n1\t0.25\n"),
        ("tabs and decimal commas", "t [s]\tKraft [N]\n0\t1,5\n0,5\t-1234,5\n1\t0,25\n"),
        ("bars", "t [s]|Kraft [N]\n0|1.5\n0.5|-1234.5\n1|0.25\n"),
        ("blanks", "t [s]   Kraft [N]\n  0.0     1.5\n  0.5  -1234.5\n  1.0     0.25\n"),
        ("scientific", "t [s];Kraft [N]\n0;1,5E+00\n5E-1;-1,2345E+03\n1;2,5e-1\n"),
        ("round brackets", "Time (s),Kraft (N)\n0,1.5\n0.5,-1234.5\n1,0.25\n"),
        ("a stroke before the unit", "t / s;Kraft / N\n0;1,5\n0,5;-1234,5\n1;0,25\n"),
        ("an underscore before the unit", "t_s,Kraft_N\n0,1.5\n0.5,-1234.5\n1,0.25\n"),
        ("milliseconds", "t_ms,Kraft_N\n0,1.5\n500,-1234.5\n1000,0.25\n"),
        ("words for units", "Time (sec),Kraft [Newton]\n0,1.5\n0.5,-1234.5\n1,0.25\n"),
        ("a row of units", "t;Kraft\ns;N\n0;1,5\n0,5;-1234,5\n1;0,25\n"),
        ("a row of units of which one is 1", "t;Kraft;n\ns;N;1\n0;1,5;1\n0,5;-1234,5;2\n1;0,25;3\n"),
        ("a row of units in brackets", "t,Kraft,n\n[s],[N],[-]\n0,1.5,1\n0.5,-1234.5,2\n1,0.25,3\n"),
        ("comments above", "# made by hand\n# in May\nt [s],Kraft [N]\n0,1.5\n0.5,-1234.5\n1,0.25\n"),
        ("a commented header", "% t [s] Kraft [N]\n0 1.5\n0.5 -1234.5\n1 0.25\n"),
        ("comments between", "t [s];Kraft [N]\n0;1,5\n# a pause\n0,5;-1234,5\n1;0,25\n"),
        (
            "preamble of a logger",
            "Device;X-Logger 12\nRate;2\nOperator;N. N.\n\nt [s];Kraft [N]\n0;1,5\n0,5;-1234,5\n1;0,25\n",
        ),
        (
            "LabVIEW",
            "LabVIEW Measurement\nWriter_Version\t2\nSeparator\tTab\n***End_of_Header***\n\nX_Value (s)\tKraft (N)\tComment\n0\t1,5\t\n0,5\t-1234,5\t\n1\t0,25\t\n",
        ),
        (
            "Campbell TOA5",
            "\"TOA5\",\"x\",\"CR1000\",\"7\"\n\"TIMESTAMP\",\"RECORD\",\"Kraft\"\n\"TS\",\"RN\",\"N\"\n\"\",\"\",\"Smp\"\n\"2025-04-03 12:00:00\",0,1.5\n\"2025-04-03 12:00:00.5\",1,-1234.5\n\"2025-04-03 12:00:01\",2,0.25\n",
        ),
        (
            "InfluxDB",
            "#group,false,false,false\n#datatype,string,long,dateTime:RFC3339,double\n#default,mean,,,\n,result,table,_time,Kraft [N]\n,,0,2025-04-03T12:00:00Z,1.5\n,,0,2025-04-03T12:00:00.5Z,-1234.5\n,,0,2025-04-03T12:00:01Z,0.25\n",
        ),
        ("index of a data frame", ",t [s],Kraft [N]\n0,0,1.5\n1,0.5,-1234.5\n2,1,0.25\n"),
        (
            "ISO stamps",
            "time,Kraft [N]\n2025-04-03T12:00:00Z,1.5\n2025-04-03T12:00:00.500Z,-1234.5\n2025-04-03T12:00:01Z,0.25\n",
        ),
        (
            "stamps with a zone",
            "time;Kraft [N]\n2025-04-03 12:00:00,0+02:00;1,5\n2025-04-03 12:00:00,5+02:00;-1234,5\n2025-04-03 12:00:01,0+02:00;0,25\n",
        ),
        (
            "German stamps",
            "Zeitstempel;Kraft [N]\n31.12.2024 23:59:59,5;1,5\n01.01.2025 00:00:00,0;-1234,5\n01.01.2025 00:00:00,5;0,25\n",
        ),
        (
            "American stamps",
            "Date/Time,Kraft [N]\n4/13/2025 1:59:59.5 PM,1.5\n4/13/2025 2:00:00 PM,-1234.5\n4/13/2025 2:00:00.5 PM,0.25\n",
        ),
        (
            "MATLAB's dates",
            "Time,Kraft [N]\n03-Apr-2025 12:00:00,1.5\n03-Apr-2025 12:00:00.5,-1234.5\n03-Apr-2025 12:00:01,0.25\n",
        ),
        (
            "day and clock apart",
            "Datum;Uhrzeit;Kraft [N]\n03.04.2025;23:59:59,5;1,5\n04.04.2025;00:00:00,0;-1234,5\n04.04.2025;00:00:00,5;0,25\n",
        ),
        ("a clock past midnight", "Uhrzeit;Kraft [N]\n23:59:59,5;1,5\n00:00:00,0;-1234,5\n00:00:00,5;0,25\n"),
        (
            "a clock with colons",
            "Zeit;Kraft [N]\n12:00:00:000;1,5\n12:00:00:500;-1234,5\n12:00:01:000;0,25\n",
        ),
        ("minutes and seconds", "Zeit (mm:ss);Kraft [N]\n59:58,5;1,5\n59:59,0;-1234,5\n59:59,5;0,25\n"),
        ("MATLAB's durations", "Time,Kraft_N\n0 sec,1.5\n0.5 sec,-1234.5\n1 sec,0.25\n"),
        (
            "ISO's basic form",
            "time,Kraft [N]\n20250403T120000Z,1.5\n20250403T120000.5Z,-1234.5\n20250403T120001Z,0.25\n",
        ),
        (
            "UNIX microseconds with their unit",
            "timestamp_us,Kraft [N]\n1700000000000001,1.5\n1700000000500001,-1234.5\n1700000001000001,0.25\n",
        ),
        ("a minus sign of typography", "t [s];Kraft [N]\n0;1,5\n0,5;\u{2212}1234,5\n1;0,25\n"),
        ("UNIX time", "timestamp,Kraft [N]\n1700000000,1.5\n1700000000.5,-1234.5\n1700000001,0.25\n"),
        (
            "UNIX milliseconds",
            "epoch;Kraft [N]\n1700000000000;1,5\n1700000000500;-1234,5\n1700000001000;0,25\n",
        ),
        (
            "UNIX nanoseconds",
            "time,Kraft [N]\n1700000000000000000,1.5\n1700000000500000000,-1234.5\n1700000001000000000,0.25\n",
        ),
        ("separators at line ends", "t [s];Kraft [N];\n0;1,5;\n0,5;-1234,5;\n1;0,25;\n"),
        ("rows padded", "t [s],Kraft [N],,\n0,1.5,,\n0.5,-1234.5,,\n1,0.25,,\n"),
        ("an inch sign", "t [s];Ort;Kraft [N]\n0;12\" Rohr;1,5\n0,5;3\" Rohr;-1234,5\n1;;0,25\n"),
        ("a line between", "t [s];Kraft [N]\n\n0;1,5\n0,5;-1234,5\n1;0,25\n"),
        ("columns of words", "t [s];Zustand;Kraft [N]\n0;aus;1,5\n0,5;ein, links;-1234,5\n1;aus;0,25\n"),
        (
            "R's write.table, whose header is one name short",
            "\"t_s\" \"Kraft_N\"\n\"1\" 0 1.5\n\"2\" 0.5 -1234.5\n\"3\" 1 0.25\n",
        ),
        (
            "a zone in words",
            "time,Kraft [N]\n2025-04-03 12:00:00 CET,1.5\n2025-04-03 12:00:00.5 CET,-1234.5\n2025-04-03 12:00:01 CET,0.25\n",
        ),
        (
            "an oscilloscope with numbered channels",
            "x-axis,1,Kraft\nsecond,Volt,Newton\n0,1.0E-3,1.5\n0.5,2.0E-3,-1234.5\n1,3.0E-3,0.25\n",
        ),
        ("a column without a unit", "t [s],lfd,Kraft [N]\n0,1,1.5\n0.5,2,-1234.5\n1,3,0.25\n"),
    ];
    for (name, text) in clean {
        gives_the_force(name, text.as_bytes(), "Kraft");
        // without its last line end
        gives_the_force(name, text.trim_end_matches(['\n', '\r']).as_bytes(), "Kraft");
    }
    gives_the_force("UTF-16, little end first", &utf_16(german, u16::to_le_bytes), "Kraft");
    gives_the_force("UTF-16, big end first", &utf_16(plain, u16::to_be_bytes), "Kraft");
    let latin = b"Zeit [s];\xd6ldruck [bar];Kraft [N]\n0;1;1,5\n0,5;2;-1234,5\n1;3;0,25\n";
    gives_the_force("Latin-1", latin, "Kraft");
    assert_eq!(read(latin).unwrap().channel("Öldruck").unwrap().values, [1e5, 2e5, 3e5]);
}

#[test]
fn what_is_missing_is_a_gap_in_any_spelling() {
    for mark in ["", "NaN", "NA", "NULL", "#N/A", "#NV", "-", "n/a", "null", " ", "k.A.", "n.a."] {
        for (separator, decimal) in [(",", "."), (";", ","), ("\t", ".")] {
            let text = format!(
                "t [s]{separator}x [m]{separator}y [m]\n0{separator}1{decimal}5{separator}1\n1{separator}{mark}{separator}2\n2{separator}2{decimal}5{separator}3\n"
            );
            let r = read(text.as_bytes()).unwrap_or_else(|e| panic!("{mark:?}: {e}"));
            let x = &r.channel("x").unwrap().values;
            assert!(x[0] == 1.5 && x[1].is_nan() && x[2] == 2.5, "{mark:?} {separator:?}: {x:?}");
        }
    }
}

/// What can be read in two ways is refused with its place, and what is guessed is said.
#[test]
fn a_wrong_reading_is_never_silent() {
    for (text, place, says) in [
        ("t [s];n [rpm]\n0;950\n1;1.050\n2;1.100\n", (3, 3), "read in two ways"),
        ("t [s];n [rpm]\n0;950\n1;1,050\n2;1,100\n", (3, 3), "read in two ways"),
        ("t [s];x [m]\n0,5;1.5\n1,0;2.5\n", (2, 5), "cannot have the same decimal sign"),
        ("t [s],x [m]\n0,5,1,5\n1,0,2,5\n", (2, 5), "decimal comma"),
        ("t [s],x [m]\n0,\"1,5\"\n1,\"2,5\"\n", (2, 3), "1.5, not 1,5"),
        (
            "time,x [m]\n3/4/2025 12:00:00,1\n4/4/2025 12:00:00,2\n5/4/2025 12:00:00,3\n",
            (3, 1),
            "which of its numbers is the month",
        ),
        ("time,x [m]\n2025-02-29T12:00:00Z,1\n2025-03-01T12:00:00Z,2\n", (2, 1), "28 days"),
        ("time,x [m]\n2025-04-03T12:00:00Z,1\n,2\n2025-04-03T12:00:02Z,3\n", (3, 1), "time is empty"),
        ("time,x [m]\n2025-04-03T12:00:00Z,1\n2025-04-03T12:00:00Z,2\n", (3, 1), "occurs twice"),
        ("time;x [m]\n12:00:00;1\n11:00:00;2\n", (3, 1), "backwards"),
        ("time,x [m]\n2025-04-03T12:00:00Z,1\n2025-04-03T12:00:05,2\n", (3, 1), "no zero in common"),
        ("Zeit;x [m]\n00:00;1\n00:01;2\n", (2, 1), "(mm:ss)"),
        ("time,x [m]\n0,1\n1,2\n", (1, 1), "has no unit"),
        ("0;1\n1;2\n", (1, 2), "semicolons"),
        ("t [s];x [m]\n0;1,5\n1;2,5;7\n2;3,5\n", (3, 7), "the row has 3 fields"),
        ("t [s];x [m]\n0;1,5\n1;warm\n2;3,5\n", (3, 3), "`warm`"),
        ("t [s];x [m];n\n0;1,5;\"a\nb\"\n1;2,5;c\n2;3,5;d\n3;4,5;e\n", (2, 1), "double quote"),
        ("t [s];x [m]\n0;1.900\n1;1.950\n2;2.480\n", (2, 3), "read in two ways"),
        ("t [s];a [m];b [m]\n0;1,234;1.5\n1;2,345;1.6\n", (2, 3), "read in two ways"),
    ] {
        let error = read(text.as_bytes()).map(|_| ()).expect_err(text);
        assert_eq!((error.line(), error.column()), (Some(place.0), Some(place.1)), "{text}: {error}");
        assert!(error.to_string().contains(says) && error.hint().is_some(), "{text}: {error}");
    }
    // what the first 64 KiB do not show
    let long = |row: fn(usize) -> String, last: &str| {
        let rows: String = (0..20_000).map(row).collect();
        read(format!("t [s];x [m]\n{rows}{last}").as_bytes())
    };
    let commas = |i: usize| format!("{i};{},5\n", i % 7);
    let whole = |i: usize| format!("{i};{}\n", 900 + i % 7);
    for (row, last, says) in [
        (commas as fn(usize) -> String, "20000;1.5\n", "another decimal sign"),
        (whole, "20000;1.234\n", "read in two ways"),
        (whole, "20000;1,234\n", "read in two ways"),
        (whole, "20000;1,5\n20001;1.5\n", "another decimal sign"),
        (commas, "20000;1.500\n", "read in two ways"),
    ] {
        let error = long(row, last).map(|_| ()).expect_err(last);
        assert!(error.to_string().contains(says) && error.line() >= Some(20_002), "{error}");
        assert_eq!(error.column(), Some(7), "{error}");
    }
    let ends = |r: Result<Recording>| r.unwrap().channels[0].values.last().copied().unwrap();
    assert_eq!(ends(long(commas, "20000;1.234,5\n20001;1.234\n")), 1234.0);
    assert_eq!(ends(long(whole, "20000;1,234.5\n# a pause\n20001;1,234\n")), 1234.0);
    assert!(ends(long(commas, "20000;#NV\n")).is_nan());
    let notes = |text: &str| -> String {
        read(text.as_bytes()).unwrap().notes.iter().map(|n| format!("{n}\n")).collect()
    };
    let said = notes("Zeit;Kraft_N;Wort\n03.04.2025 12:00:00;1,5;a\n03.04.2025 12:00:01;2,5;b\n");
    for part in [
        "semicolons",
        "commas for decimals",
        "counts from 03.04.2025 12:00:00",
        "`Kraft_N` is read as Kraft in [N]",
        "`Wort` holds words",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert_eq!(notes("t [s],x [m]\n0,1\n1,2\n"), "");
}

#[test]
fn logical_values_are_ones_and_zeros() {
    for (one, other) in [("true", "false"), ("TRUE", "FALSE"), ("WAHR", "FALSCH"), ("vrai", "faux")] {
        for (separator, decimal) in [(",", "."), (";", ",")] {
            let rows: String = [one, other, one]
                .iter()
                .enumerate()
                .map(|(i, v)| format!("{i}{separator}{v}{separator}2{decimal}5\n"))
                .collect();
            let text = format!("t [s]{separator}open [1]{separator}p [psi]\n{rows}");
            let r = read(text.as_bytes()).unwrap_or_else(|e| panic!("{one}: {e}"));
            assert_eq!(r.channel("open").unwrap().values, [1.0, 0.0, 1.0], "{one}");
            // a pound (0.45359237 kg) under 9.80665 m/s² on a square inch
            let psi = 0.45359237 * 9.80665 / (0.0254 * 0.0254);
            assert!((r.channel("p").unwrap().values[0] / (2.5 * psi) - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_column_that_is_left_out_says_why_when_it_is_asked_for() {
    let r = read(b"t [s],x [m],Kraft,y [dgr]\n0,1,2,3\n1,2,3,4\n").unwrap();
    assert_eq!(r.channels.len(), 1);
    for (name, column, says) in [("Kraft", 13, "has no unit"), ("y", 19, "unknown unit")] {
        let error = r.channel(name).unwrap_err();
        assert!(error.to_string().contains(says) && error.hint().is_some(), "{error}");
        assert_eq!((error.line(), error.column()), (Some(1), Some(column)), "{error}");
    }
}

#[test]
fn a_stroke_or_a_second_unit_does_not_cut_the_unit() {
    let r =
        read("t [s];Q in m³/h;v_m_s;vel_N;vel_E;n [RPM]\n0;3600;1,5;1;2;60\n1;3600;2,5;1;2;60\n".as_bytes())
            .unwrap();
    assert_eq!((r.channel("Q").unwrap().values[0], r.channel("v").unwrap().values[0]), (1.0, 1.5));
    assert_eq!(r.channel("n").unwrap().unit.text(), "rpm");
    assert!(r.channel("vel_N").unwrap_err().to_string().contains("no unit"));
}

/// Two tables with dates lie on one clock; dates beside plain seconds have no zero in common.
#[test]
fn tables_with_dates_share_their_zero() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("a.csv", "time;x [m]\n03.04.2025 12:00:00;1\n03.04.2025 12:00:10;2\n");
    write("b.csv", "time,y [m]\n2025-04-03T12:00:04,1\n2025-04-03T12:00:05,2\n");
    write("d.csv", "time,z [m]\n2025-04-03T12:00:04Z,1\n2025-04-03T12:00:05Z,2\n");
    write("c.csv", "t [s],z [m]\n0,1\n1,2\n");
    let with = |second: &str| {
        let channel = if second == "b.csv" { "y" } else { "z" };
        let text = format!(
            "[[tables]]\nfile = \"a.csv\"\ntime = {{ column = \"time\" }}\nchannels.x = {{ column = \"x [m]\" }}\n[[tables]]\nfile = \"{second}\"\nchannels.{channel} = {{ column = \"{channel}\" }}\n"
        );
        write("r.toml", &text);
        Recording::read(folder.path().join("r.toml"))
    };
    let r = with("b.csv").unwrap();
    assert_eq!(
        (&*r.channel("x").unwrap().time, &*r.channel("y").unwrap().time),
        (&[0.0, 10.0][..], &[4.0, 5.0][..])
    );
    let error = with("c.csv").unwrap_err();
    assert!(error.to_string().contains("no zero in common") && error.line() == Some(6), "{error}");
    let error = with("d.csv").unwrap_err();
    assert!(
        error.to_string().contains("no zero in common") && error.hint().unwrap().contains("zone"),
        "{error}"
    );
}

#[test]
fn the_example_as_a_spreadsheet_writes_it_is_the_example() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let [plain, export] = ["clinometer.csv", "export.csv"].map(|f| Recording::read(folder.join(f)).unwrap());
    for (a, b) in plain.channels.iter().zip(&export.channels) {
        assert_eq!((&a.name, &a.time, &a.values), (&b.name, &b.time, &b.values));
    }
    assert_eq!((plain.channels.len(), export.channels.len()), (2, 2));
}

/// A model's names are found with their unit behind them, in the way of the table.
#[test]
fn a_name_with_its_unit_is_found_by_either() {
    let r = read(b"t_s,x_mm,x_min\n0,1,2\n1,2,3\n").unwrap();
    assert_eq!(r.channel("x_mm").unwrap(), r.channel("x").unwrap());
    assert!(r.channel("x_min").unwrap_err().to_string().contains("no unit"));
    let r = read(b"t_s,x_mm,x_m\n0,1,2\n1,2,3\n").unwrap();
    assert_eq!((r.channel("x_mm").unwrap().values[0], r.channel("x_m").unwrap().values[0]), (1e-3, 2.0));
}

#[test]
fn lone_carriage_returns_end_lines_between_semicolons_too() {
    gives_the_force("semicolons", b"t [s];F [N]\r0;1,5\r0,5;-1234,5\r1;0,25\r", "F");
    gives_the_force("commas", b"t [s],F [N]\r0,1.5\r0.5,-1234.5\r1,0.25\r", "F");
}

#[test]
fn rows_of_separators_alone_end_a_table_and_part_none() {
    gives_the_force("below", b"t [s],F [N]\n0,1.5\n0.5,-1234.5\n1,0.25\n,\n,\n", "F");
    gives_the_force("semicolons", b"t [s];F [N]\n0;1,5\n0,5;-1234,5\n1;0,25\n;\n;\n", "F");
    let e = read(b"t [s],F [N]\n0,1.5\n,\n1,0.25\n").unwrap_err().to_string();
    assert!(e.contains(":3:") && e.contains("rows follow"), "{e}");
}
