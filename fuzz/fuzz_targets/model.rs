//! Models: what is read is written as a file that reads as the same model.
#![no_main]

use gyrospec::model::Model;

libfuzzer_sys::fuzz_target!(|text: &str| {
    if let Ok(model) = Model::parse(text) {
        assert_eq!(Model::parse(&model.to_toml()).map(|m| m.to_toml()).ok(), Some(model.to_toml()));
    }
});
