//! Outputs that a recording did not measure.

use super::Model;
use crate::record::{Channel, Recording};

impl Model {
    /// Gives a recording a channel of gaps for each output that it did not measure, at the times of the first input, so
    /// that a simulation predicts it there; what to know of each.
    ///
    /// ```
    /// use gyrospec::{Model, Recording};
    /// # let folder = tempfile::tempdir().unwrap();
    /// let file = folder.path().join("roll.csv");
    /// std::fs::write(&file, "t [s],u [1]\n0,1\n1,1\n").unwrap();
    /// let model = Model::parse("name = \"double\"\n[inputs]\nu = { unit = \"1\" }\n[outputs]\ny = { unit = \"1\", equals = \"2*u\" }\n")?;
    /// let mut recording = Recording::read(&file)?;
    /// assert_eq!(model.foresee(&mut recording).len(), 1);
    /// assert!(recording.find("y").is_some());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn foresee(&self, recording: &mut Recording) -> Vec<String> {
        let own = self.simulated.iter().flat_map(|s| s.channels.iter());
        let mut inputs = self.inputs.iter().filter_map(|i| recording.find(&i.name)).chain(own);
        let Some(first) = inputs.next() else { return Vec::new() };
        let (time, table, input) = (first.time.clone(), first.table, first.name.clone());
        drop(inputs);
        let mut told = Vec::new();
        for o in &self.outputs {
            if recording.find(&o.name).is_none() {
                let gaps = vec![f64::NAN; time.len()];
                let channel =
                    Channel { table, ..Channel::new(o.name.clone(), o.unit.clone(), time.clone(), gaps) };
                recording.channels.push(channel);
                told.push(format!(
                    "the recording has no channel `{}`: it is predicted at the times of `{input}`, and compared with nothing",
                    o.name
                ));
            }
        }
        told
    }
}
