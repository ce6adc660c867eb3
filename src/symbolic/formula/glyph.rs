//! How names look in print.

/// Names of Greek letters, as text and in LaTeX.
const GREEK: [(&str, &str, &str); 38] = [
    ("alpha", "α", r"\alpha"),
    ("beta", "β", r"\beta"),
    ("gamma", "γ", r"\gamma"),
    ("delta", "δ", r"\delta"),
    ("epsilon", "ε", r"\varepsilon"),
    ("eps", "ε", r"\varepsilon"),
    ("zeta", "ζ", r"\zeta"),
    ("eta", "η", r"\eta"),
    ("theta", "θ", r"\theta"),
    ("iota", "ι", r"\iota"),
    ("kappa", "κ", r"\kappa"),
    ("lambda", "λ", r"\lambda"),
    ("lam", "λ", r"\lambda"),
    ("mu", "μ", r"\mu"),
    ("nu", "ν", r"\nu"),
    ("xi", "ξ", r"\xi"),
    ("pi", "π", r"\pi"),
    ("rho", "ρ", r"\rho"),
    ("sigma", "σ", r"\sigma"),
    ("tau", "τ", r"\tau"),
    ("upsilon", "υ", r"\upsilon"),
    ("phi", "φ", r"\varphi"),
    ("chi", "χ", r"\chi"),
    ("psi", "ψ", r"\psi"),
    ("omega", "ω", r"\omega"),
    ("Gamma", "Γ", r"\Gamma"),
    ("Delta", "Δ", r"\Delta"),
    ("Theta", "Θ", r"\Theta"),
    ("Lambda", "Λ", r"\Lambda"),
    ("Xi", "Ξ", r"\Xi"),
    ("Pi", "Π", r"\Pi"),
    ("Sigma", "Σ", r"\Sigma"),
    ("Phi", "Φ", r"\Phi"),
    ("Psi", "Ψ", r"\Psi"),
    ("Omega", "Ω", r"\Omega"),
    ("Upsilon", "Υ", r"\Upsilon"),
    ("om", "ω", r"\omega"),
    ("Om", "Ω", r"\Omega"),
];

/// A name as a letter and its index.
fn parts(name: &str) -> (&str, &str) {
    if let Some((letter, index)) = name.split_once('_')
        && !letter.is_empty()
    {
        return (letter, index);
    }
    let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    if digits < name.len() { name.split_at(name.len() - digits) } else { (name, "") }
}

/// The letter of a name, without its index.
pub fn letter_of(name: &str) -> &str {
    parts(name).0
}

/// A name with its Greek letters written out: `θ0` is theta0.
pub fn ascii_name(name: &str) -> String {
    let written = |c: char| {
        GREEK.iter().find(|row| row.1.chars().eq([c])).map_or_else(|| c.to_string(), |row| row.0.to_owned())
    };
    name.chars().map(written).collect()
}

/// A name as text: `theta0` is θ0, `v_N` is v_N.
pub fn text_name(name: &str) -> String {
    let (letter, index) = parts(name);
    let joint = if index.is_empty() || name.len() == letter.len() + index.len() { "" } else { "_" };
    let letter = GREEK.iter().find(|row| row.0 == letter).map_or(letter, |row| row.1);
    format!("{letter}{joint}{index}")
}

/// A name in LaTeX: `theta0` is `\theta_{0}`; a word stands upright as one symbol.
pub fn latex_name(name: &str) -> String {
    let (letter, index) = parts(name);
    let letter = GREEK.iter().find(|row| row.0 == letter || row.1 == letter).map_or_else(
        || {
            if letter.chars().count() == 1 {
                escaped(letter)
            } else {
                format!(r"\mathit{{{}}}", escaped(letter))
            }
        },
        |row| row.2.to_owned(),
    );
    if index.is_empty() { letter } else { format!("{letter}_{{{}}}", escaped(index)) }
}

/// Characters that mean something to LaTeX, set as they are.
fn escaped(text: &str) -> String {
    let escape = |c: char| match c {
        '_' | '%' | '#' | '&' | '$' | '{' | '}' => format!(r"\{c}"),
        '\\' => r"\backslash ".into(),
        '~' | '^' => format!(r"\{c}{{}}"),
        ' ' => r"\ ".into(),
        _ => c.to_string(),
    };
    text.chars().map(escape).collect()
}
