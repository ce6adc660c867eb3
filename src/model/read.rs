//! Reads a model file.
//!
//! A file that extends a built-in model starts from its lists; what the file gives for a name
//! replaces what the built-in has for it, field by field.

use super::form::{Form, toml};
use super::places::{Places, Text};
use super::{Definition, Initial, Input, Model, Output, Parameter, State, builtin, free, mockup, simulated};
use crate::expression::{Expr, Function, is_name};
use crate::record::{Source, read_text};
use crate::text::one_line;
use crate::units::Unit;
use crate::{Error, Result};
use std::ops::Range;
use std::path::Path;

impl Model {
    /// Reads a model file; `-` is standard input, and a built-in model goes by its name where no file has it.
    ///
    /// ```
    /// assert_eq!(gyrospec::Model::read("gyrosphere")?.inputs[0].name, "roll_acc");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// Everything wrong with the file, with its line and column and what to do.
    pub fn read(path: impl AsRef<Path>) -> Result<Self> {
        Ok(Self::read_with_source(path.as_ref())?.0)
    }

    /// Reads a model file, and tells the file with the hash of its bytes.
    ///
    /// # Errors
    /// As [`Model::read`].
    pub fn read_with_source(path: &Path) -> Result<(Self, Source)> {
        if mockup::is_unit(path) {
            return mockup::read_whole(path);
        }
        let name = path.to_str().filter(|_| !path.exists());
        let misspelt = |e: Error| match name.and_then(builtin::near) {
            Some(name) => {
                e.with_hint(format!("the built-in model is {name}; `gyrospec models` lists them all"))
            }
            None => e,
        };
        let (text, source) = match name.and_then(|name| builtin::text(name).ok()) {
            Some(text) => (text.to_owned(), Source::of(path, text.as_bytes())),
            None => read_text(path).map_err(misspelt)?,
        };
        let folder = path.parent().filter(|_| path != Path::new("-"));
        let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
        let model = Self::parse_in(&text, folder).map_err(place)?;
        Ok((model, source))
    }

    /// Reads the text of a model file.
    ///
    /// ```
    /// use gyrospec::Model;
    /// let text = "name = \"lag\"\n[parameters]\nT = { value = 2, unit = \"min\" }\n[inputs]\nu = { unit = \"V\" }\n\
    ///             [states]\nx = { unit = \"V\", rate = \"(u - x)/T\", initial = 0 }\n\
    ///             [outputs]\ny = { unit = \"mV\", equals = \"x\" }\n";
    /// assert_eq!(Model::parse(text)?.parameters[0].value, 120.0);        // in SI
    /// let e = Model::parse(&text.replace("x)/T", "x)*T")).unwrap_err();
    /// assert_eq!((e.kind(), e.line()), (gyrospec::ErrorKind::Units, Some(7)));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Model::read`].
    pub fn parse(text: &str) -> Result<Self> {
        Self::parse_in(text, None)
    }

    /// The same; files that the text names lie in a folder.
    fn parse_in(text: &str, folder: Option<&Path>) -> Result<Self> {
        let text = Text(text);
        let table = toml(&text)?;
        let root = Form::root(&table, &text);
        root.allow(&[
            "name",
            "extends",
            "fmu",
            "inputs",
            "parameters",
            "definitions",
            "states",
            "outputs",
            "simulated",
        ])?;
        let simulated = simulated::place(&root, folder)?;
        let is_simulated = simulated.is_some();
        let mut model = start(&root, folder)?;
        model.is_free = free::says(&root, &model)?;
        let _speaking = mockup::speaking(&model);
        let mut reader = Reader { model, places: Places::default(), text: &text, is_simulated };
        if let Some(name) = root.string("name")? {
            reader.model.name = one_line(name);
        }
        for section in SECTIONS {
            reader.section(&root, section)?;
        }
        if reader.model.outputs.is_empty() {
            let e = Error::bad_input("the model has no outputs")
                .with_hint("add [outputs] with the measured signals that it predicts");
            return Err(e);
        }
        mockup::finish(&mut reader.model, &root)?;
        if let Some(file) = simulated {
            simulated::attach(&mut reader.model, &root, file)?;
        }
        reader.model.check_at(&reader.places)?;
        reader.model.turns_or_radians(&reader.places)?;
        Ok(reader.model)
    }
}

fn start(root: &Form<'_>, folder: Option<&Path>) -> Result<Model> {
    if let Some(model) = mockup::begun(root, folder)? {
        return Ok(model);
    }
    if let Some(name) = root.string("extends")? {
        return Model::builtin(name).map_err(|e| root.error("extends", e));
    }
    match root.string("name")? {
        Some(_) => Ok(Model::empty()),
        None => Err(Error::bad_input("the model has no name").with_hint("add name = \"…\"")),
    }
}

const SECTIONS: [&str; 5] = ["inputs", "parameters", "definitions", "states", "outputs"];

struct Reader<'a> {
    model: Model,
    places: Places,
    text: &'a Text<'a>,
    /// Whether an output may be a column of what was simulated.
    is_simulated: bool,
}

impl Reader<'_> {
    fn section(&mut self, root: &Form<'_>, name: &str) -> Result<()> {
        let Some(section) = root.table(name)? else { return Ok(()) };
        for (key, span, fields) in section.tables()? {
            let own = mockup::name_of(&self.model, key);
            let entry = own.as_str();
            self.name(entry, name, &span)?;
            if let (Some(field), Some(unit)) = (fields.field("unit"), fields.string("unit")?) {
                self.places.add(fields.path_of("unit"), self.text, &field.span, unit);
            }
            match name {
                "inputs" => self.input(entry, &fields)?,
                "parameters" => self.parameter(entry, &fields)?,
                "definitions" => self.definition(entry, &fields)?,
                "states" => self.state(entry, &fields)?,
                _ => self.output(entry, &fields)?,
            }
        }
        Ok(())
    }

    /// Refuses what cannot be a name.
    fn name(&self, name: &str, section: &str, span: &Range<usize>) -> Result<()> {
        let problem = if !is_name(name) {
            "a name is a letter or _, then letters, digits and _"
        } else if section != "outputs" && ["pi", "t"].contains(&name) {
            "pi and t (the time) have their meaning already"
        } else if section != "outputs" && Function::named(name).is_some() {
            "it is a function of the expression language"
        } else {
            return Ok(());
        };
        let e = Error::bad_input(format!("{name:?} cannot be a name of {section}: {problem}"));
        Err(self.text.at(e, span))
    }

    fn unit(&self, fields: &Form<'_>, old: Option<&Unit>) -> Result<Unit> {
        let plain = self.model.is_free.then(Unit::one);
        match (fields.string("unit")?, old.or(plain.as_ref())) {
            (Some(text), _) => {
                Unit::parse(text).map_err(|e| fields.error("unit", e.about(&fields.path_of("unit"))))
            }
            (None, Some(unit)) => Ok(unit.clone()),
            (None, None) => Err(fields.missing("unit", "unit = \"…\" (\"1\" for none)")),
        }
    }

    fn meaning(fields: &Form<'_>, old: Option<String>) -> Result<Option<String>> {
        Ok(fields.string("meaning")?.map(one_line).or(old))
    }

    fn expression(&mut self, fields: &Form<'_>, key: &str, old: Option<&Expr>) -> Result<Expr> {
        let Some(text) = fields.string(key)? else {
            let example = format!("{key} = \"…\", an expression");
            return old.cloned().ok_or_else(|| fields.missing(key, &example));
        };
        let path = fields.path_of(key);
        if let Some(field) = fields.field(key) {
            self.places.add(path.clone(), self.text, &field.span, text);
        }
        Expr::parse(text).map_err(|e| self.places.put(&path, e))
    }

    fn input(&mut self, name: &str, fields: &Form<'_>) -> Result<()> {
        fields.allow(if mockup::has(&self.model) {
            &["unit", "meaning", "channel"]
        } else {
            &["unit", "meaning"]
        })?;
        let old = self.model.inputs.iter().find(|x| x.name == name).cloned();
        let entry = Input {
            name: name.to_string(),
            unit: self.unit(fields, old.as_ref().map(|o| &o.unit))?,
            meaning: Self::meaning(fields, old.and_then(|o| o.meaning))?,
        };
        place(&mut self.model.inputs, entry, |x| &x.name);
        Ok(())
    }

    fn parameter(&mut self, name: &str, fields: &Form<'_>) -> Result<()> {
        fields.allow(&["value", "unit", "fit", "min", "max", "meaning"])?;
        let old = self.model.parameters.iter().find(|x| x.name == name).cloned();
        let unit = self.unit(fields, old.as_ref().map(|o| &o.unit))?;
        let si = |key: &str, old: Option<f64>| -> Result<Option<f64>> {
            Ok(fields.number(key)?.map(|x| unit.to_si(x)).or(old))
        };
        let value = si("value", old.as_ref().map(|o| o.value))?;
        let entry = Parameter {
            name: name.to_string(),
            value: value.ok_or_else(|| fields.missing("value", "value = …"))?,
            fit: fields.flag("fit")?.unwrap_or(old.as_ref().is_some_and(|o| o.fit)),
            min: si("min", old.as_ref().and_then(|o| o.min))?,
            max: si("max", old.as_ref().and_then(|o| o.max))?,
            meaning: Self::meaning(fields, old.and_then(|o| o.meaning))?,
            unit,
        };
        bounds(&entry).map_err(|e| fields.error("value", e.about(&fields.path)))?;
        place(&mut self.model.parameters, entry, |x| &x.name);
        Ok(())
    }

    fn definition(&mut self, name: &str, fields: &Form<'_>) -> Result<()> {
        fields.allow(&["equals", "unit", "meaning"])?;
        let old = self.model.definitions.iter().find(|x| x.name == name).cloned();
        let entry = Definition {
            name: name.to_string(),
            equals: self.expression(fields, "equals", old.as_ref().map(|o| &o.equals))?,
            unit: self.unit(fields, old.as_ref().map(|o| &o.unit))?,
            meaning: Self::meaning(fields, old.and_then(|o| o.meaning))?,
        };
        place(&mut self.model.definitions, entry, |x| &x.name);
        Ok(())
    }

    fn state(&mut self, name: &str, fields: &Form<'_>) -> Result<()> {
        fields.allow(&["rate", "unit", "initial", "meaning"])?;
        let old = self.model.states.iter().find(|x| x.name == name).cloned();
        let unit = self.unit(fields, old.as_ref().map(|o| &o.unit))?;
        let entry = State {
            name: name.to_string(),
            rate: self.expression(fields, "rate", old.as_ref().map(|o| &o.rate))?,
            initial: initial(fields, &unit, old.as_ref().map(|o| o.initial))?,
            meaning: Self::meaning(fields, old.and_then(|o| o.meaning))?,
            unit,
        };
        place(&mut self.model.states, entry, |x| &x.name);
        Ok(())
    }

    fn output(&mut self, name: &str, fields: &Form<'_>) -> Result<()> {
        let known = ["equals", "unit", "meaning", "channel"];
        fields.allow(&known[..if mockup::has(&self.model) { 4 } else { 3 }])?;
        let old = self.model.outputs.iter().find(|x| x.name == name).cloned();
        let own = self.is_simulated.then(|| simulated::own_column(name));
        let entry = Output {
            name: name.to_string(),
            equals: self.expression(fields, "equals", old.as_ref().map(|o| &o.equals).or(own.as_ref()))?,
            unit: self.unit(fields, old.as_ref().map(|o| &o.unit))?,
            meaning: Self::meaning(fields, old.and_then(|o| o.meaning))?,
        };
        place(&mut self.model.outputs, entry, |x| &x.name);
        Ok(())
    }
}

/// Replaces the entry of that name, or adds it at the end.
fn place<T>(list: &mut Vec<T>, entry: T, name: fn(&T) -> &String) {
    match list.iter().position(|x| name(x) == name(&entry)) {
        Some(i) => list[i] = entry,
        None => list.push(entry),
    }
}

fn initial(fields: &Form<'_>, unit: &Unit, old: Option<Initial>) -> Result<Initial> {
    const EXAMPLE: &str = "initial = a number, \"fit\" or \"steady\"";
    let Some(field) = fields.field("initial") else {
        return old.ok_or_else(|| fields.missing("initial", EXAMPLE));
    };
    match fields.string(field.key) {
        Ok(Some("fit")) => Ok(Initial::Fit),
        Ok(Some("steady")) => Ok(Initial::Steady),
        Ok(_) => {
            let e = Error::bad_input(format!("{} is no known start", fields.path_of("initial")));
            Err(fields.error("initial", e.with_hint(EXAMPLE)))
        }
        Err(_) => Ok(Initial::Number(fields.number("initial")?.map_or(0.0, |x| unit.to_si(x)))),
    }
}

fn bounds(p: &Parameter) -> Result<()> {
    let (min, max) = (p.min.unwrap_or(f64::NEG_INFINITY), p.max.unwrap_or(f64::INFINITY));
    let shown = |x: f64| p.unit.decimal_from_si(x);
    if min > max {
        return Err(Error::bad_input(format!("min {} is above max {}", shown(min), shown(max))));
    }
    if p.value < min || p.value > max {
        let (v, lo, hi) = (shown(p.value), shown(min), shown(max));
        return Err(Error::bad_input(format!("the value {v} lies outside its bounds, {lo} to {hi}")));
    }
    Ok(())
}

impl Model {
    /// A model without a name and without anything in it.
    pub(super) fn empty() -> Self {
        Self {
            name: String::new(),
            inputs: Vec::new(),
            parameters: Vec::new(),
            definitions: Vec::new(),
            states: Vec::new(),
            outputs: Vec::new(),
            is_free: false,
            simulated: None,
            #[cfg(feature = "fmu")]
            fmu: None,
        }
    }

    /// The built-in model of that name.
    ///
    /// ```
    /// assert_eq!(gyrospec::Model::builtin("gyrosphere")?.states[0].name, "beta");       // the tilt
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn builtin(name: &str) -> Result<Self> {
        builtin::text(name).and_then(Self::parse)
    }

    /// The file of the built-in model of that name.
    ///
    /// # Errors
    /// As [`Model::builtin`].
    pub fn builtin_text(name: &str) -> Result<&'static str> {
        builtin::text(name)
    }
}
