//! The options of the elastic parts, from the list of parts.

use crate::Result;
use crate::cli::quantity::quantities;
use crate::gyro::elastic::{Elastic, PARTS, PartOption, asked};
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command};
use std::collections::BTreeMap;

/// What was said of the elastic parts: the numbers of each option of it, as text.
pub struct PartOptions(BTreeMap<&'static str, String>);

impl PartOptions {
    /// Whether nothing was said.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The parts asked for.
    pub fn parts(&self) -> Result<Vec<Box<dyn Elastic>>> {
        let mut numbers = BTreeMap::new();
        for option in options() {
            if let Some(text) = self.0.get(option.name) {
                let read = if is_switch(option) {
                    Ok(Vec::new())
                } else {
                    quantities(option.name, text, option.ranges)
                };
                numbers.insert(option.name, read?);
            }
        }
        Ok(asked(|name| numbers.get(name).cloned()))
    }
}

fn options() -> impl Iterator<Item = &'static PartOption> {
    PARTS.iter().flat_map(|part| part.options)
}

fn is_switch(option: &PartOption) -> bool {
    option.numbers.is_empty()
}

impl clap::Args for PartOptions {
    fn augment_args(mut command: Command) -> Command {
        for part in PARTS {
            for option in part.options {
                let arg = Arg::new(option.name).long(option.name).help(option.help);
                let arg = if is_switch(option) {
                    arg.action(ArgAction::SetTrue)
                } else {
                    arg.value_name(option.numbers).allow_hyphen_values(true)
                };
                command = command.arg(arg);
            }
        }
        command.group(ArgGroup::new("part").multiple(true).args(options().map(|o| o.name)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl clap::FromArgMatches for PartOptions {
    fn from_arg_matches(matches: &ArgMatches) -> std::result::Result<Self, clap::Error> {
        let said = |option: &'static PartOption| {
            let text = if is_switch(option) {
                matches.get_flag(option.name).then(String::new)
            } else {
                matches.get_one(option.name).cloned()
            };
            text.map(|text| (option.name, text))
        };
        Ok(Self(options().filter_map(said).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> std::result::Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
