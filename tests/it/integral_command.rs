//! `gyrospec integral` as other programs call it.

use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Output, Stdio};

fn program(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

fn lines(output: &Output) -> Vec<Value> {
    let text = std::str::from_utf8(&output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn single_answers_have_the_fixed_form() {
    let cases = [
        (vec!["--h", "1 2 3", "--g", "0 1"], "ok", 0),
        (vec!["--h", "1,2,3", "--c", "1"], "ok", 0),
        (vec!["--h", "1 -1 1", "--g", "0 1"], "unstable", 3),
        (vec!["--h", "1 0 1", "--g", "0 1"], "imaginary-axis", 3),
        (vec!["--h", "1e-200 1e-200", "--g", "1"], "out-of-range", 3),
        (vec!["--h", "0 1", "--g", "1"], "bad-input", 2),
        (vec!["--h", "1 2 abc", "--g", "1 2"], "bad-input", 2),
        (vec!["--h", "1,,2", "--g", "1"], "bad-input", 2),
        // a decimal comma, or two numbers
        (vec!["--h", "1,5 2 3", "--g", "0 1"], "bad-input", 2),
        (vec!["--h", "1, 2, 3", "--g", "0 1"], "ok", 0),
        // read as 0, which it is not
        (vec!["--h", "1 2 3", "--g", "1e-400 1"], "bad-input", 2),
    ];
    for (arguments, status, code) in cases {
        let output = program(&[&["integral", "--json"], &arguments[..]].concat(), b"");
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        let answer = &lines(&output)[0];
        assert_eq!(answer["status"], status, "{arguments:?}");
        if status == "ok" {
            // I_2 = b1/(2·a1·a2)
            assert_eq!(answer["value"], json!(1.0 / 12.0));
            assert!(answer["error_bound"].is_f64() && answer["condition"].is_f64());
        }
    }
    let unstable = program(&["integral", "--json", "--h", "1 -1 1", "--g", "0 1"], b"");
    assert_eq!(lines(&unstable)[0]["right_half_plane_roots"], 2);
}

#[test]
fn a_batch_answers_line_by_line_and_survives_broken_lines() {
    let input = b"\xef\xbb\xbf{\"h\":[1,2,3],\"g\":[0,1],\"id\":7}\r\n\n{\"h\":[1,2\n{\"h\":[1,1],\"g\":[NaN]}\n{\"h\":[1,0.1],\"c\":[1]}\n{\"h\":[1,2,3],\"g\":[1E-400,1]}\n{\"h\":[1,2,3],\"g\":[0e-400,1]}\n";
    let output = program(&["integral", "--batch", "-"], input);
    assert_eq!(output.status.code(), Some(0));
    let answers = lines(&output);
    let status: Vec<&str> = answers.iter().map(|a| a["status"].as_str().unwrap()).collect();
    assert_eq!(status, ["ok", "bad-input", "bad-input", "ok", "bad-input", "ok"]);
    assert!(answers[1]["message"].as_str().unwrap().contains("line 3"));
}

#[test]
fn what_is_no_case_in_a_batch_is_told_what_a_case_is() {
    let input = b"[]\r{}\rnull\r7\r\"h\"\rtrue\r[[1,2,3],[0,1],null]\r[1,\r{\"h\":[1,2,3],\"g\":[0,1]}\r";
    let answers = lines(&program(&["integral", "--batch", "-"], input));
    let says = ["a list", "missing field", "null", "a number", "a text", "true or false", "a list", "a list"];
    for (k, (answer, says)) in answers.iter().zip(says).enumerate() {
        let message = answer["message"].as_str().unwrap();
        assert!(message.starts_with(&format!("line {}", k + 1)) && message.contains(says), "{message}");
        assert!(message.contains("such as {\"h\":[1,2,3]") || message.contains(", column"), "{message}");
    }
    assert_eq!((answers.len(), answers[8]["status"].as_str()), (9, Some("ok")));
}

#[test]
fn a_check_shows_the_other_methods() {
    let output = program(&["integral", "--json", "--check", "--h", "1 2 3", "--g", "0 1"], b"");
    let all = &lines(&output)[0]["crosscheck"];
    for method in ["determinant", "quadrature"] {
        assert!((all[method]["value"].as_f64().unwrap() - 1.0 / 12.0).abs() < 1e-10, "{method}");
    }
}
