//! What is found with inputs as they are read, and with another reading where that may have led to it.

use super::answer::DataFault;
use super::search::{Found, Taken};
use super::{Case, catalogue, compared, feedback, filled, hold};
use crate::Result;
use crate::estimate::Fit;
use crate::simulate::Early;

impl Case<'_> {
    /// What the search finds with inputs as they were settled, or as they were before where that fits better beside it; and
    /// where that may hide a hold, with inputs held that may be, if that is likelier.
    pub(super) fn as_read(&mut self, settled: hold::Settled) -> Result<(Fit, Found)> {
        let hold::Settled { fit: base, held, open, before } = settled;
        let said = feedback::read_first(&mut self.bench.recordings, &mut self.separate, &base);
        self.notes.extend(said.iter().cloned());
        let found = self.named(&self.bench, &self.separate, base.clone(), before.as_deref())?;
        let filled = self.filled(&base, &found)?;
        let before = before.filter(|_| filled.is_none() && self.bench.budget.cut() != Some(Early::Time));
        let (base, found) = filled.unwrap_or((base, found));
        if let Some(straight) = before.and_then(|b| b.returns(&mut self.bench, &mut self.separate, &found)) {
            // steps that were spent on a wrong reading are no reason to keep it
            self.bench.budget.renew();
            self.notes.retain(|n| !said.contains(n));
            let said = feedback::read_first(&mut self.bench.recordings, &mut self.separate, &straight);
            self.notes.extend(said);
            let found = self.named(&self.bench, &self.separate, straight.clone(), None)?;
            let shown = hold::shown_beside(&self.bench, &found);
            let other = self.held(&shown, &straight, &found)?;
            return Ok(other.unwrap_or((straight, found)));
        }
        // where the reading makes no difference it is no fault
        let matters = |f: &DataFault| !found.taken.is_empty() || hold::is_likelier(f);
        let (held, alike): (Vec<_>, Vec<_>) = held.into_iter().partition(matters);
        self.told.extend(held);
        self.notes.extend(alike.iter().map(|f| hold::looks(&f.finding.site.name)));
        // what was missing may have hidden it
        let open = if open.is_empty() { hold::shown_beside(&self.bench, &found) } else { open };
        if hold::may_hide_a_hold(&found)
            && let Some(other) = self.held(&open, &base, &found)?
        {
            return Ok(other);
        }
        let fits = |name: &&String| self.bench.budget.cut().is_some() || self.fits_held(name, &found);
        let notes: Vec<String> = open.iter().filter(fits).map(|name| hold::note(name)).collect();
        self.notes.extend(notes);
        Ok((base, found))
    }

    /// What the search finds with inputs that were repeated in between, where what was found beside shows that.
    fn filled(&mut self, base: &Fit, found: &Found) -> Result<Option<(Fit, Found)>> {
        if found.taken.is_empty() || self.bench.budget.cut() == Some(Early::Time) {
            return Ok(None);
        }
        let is_shift = |t: &Taken| catalogue::find(t.proposal.code).is_ok_and(|m| m.shifts_time);
        // what makes an input earlier hides it
        let shift = found.taken.iter().position(is_shift);
        let bare = shift.and_then(|i| found.without.get(i)?.as_ref());
        let asked = bare.map_or(&found.last, |(fit, _)| fit).clone();
        let (mut bench, mut separate) = (self.bench.clone(), self.separate.clone());
        let (_, notes) = filled::settle(&mut bench, &mut separate, asked);
        if notes.is_empty() {
            return Ok(None);
        }
        bench.budget.renew();
        let base = compared::anew(&bench, base)?;
        let found = self.named(&bench, &separate, base.clone(), None)?;
        (self.bench, self.separate) = (bench, separate);
        self.notes.extend(notes);
        Ok(Some((base, found)))
    }

    /// Whether what was found fits as well with an input held.
    fn fits_held(&self, name: &String, found: &Found) -> bool {
        let mut bench = self.bench.clone();
        hold::read_held(&mut bench.recordings, std::slice::from_ref(name));
        hold::fits_as_well(&bench, found)
    }

    /// What the search finds with inputs held, where that is likelier than what it found.
    fn held(&mut self, names: &[String], base: &Fit, found: &Found) -> Result<Option<(Fit, Found)>> {
        if names.is_empty() || self.bench.budget.cut() == Some(Early::Time) {
            return Ok(None);
        }
        self.bench.budget.renew();
        let (mut bench, mut separate) = (self.bench.clone(), self.separate.clone());
        hold::read_held(&mut bench.recordings, names);
        hold::read_held(&mut separate, names);
        if !hold::fits_as_well(&bench, found) {
            return Ok(None);
        }
        let base = compared::anew(&bench, base)?;
        let said = feedback::read_first(&mut bench.recordings, &mut separate, &base);
        let other = self.named(&bench, &separate, base.clone(), None)?;
        let faults = hold::likelier(names, &other, found);
        if faults.is_empty() {
            return Ok(None);
        }
        (self.bench, self.separate) = (bench, separate);
        self.told.extend(faults);
        self.notes.extend(said);
        Ok(Some((base, other)))
    }
}
