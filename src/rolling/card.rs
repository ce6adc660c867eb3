//! The deviation card: the error by heading, in one column for each size of what moves the ship.

use super::{Against, Compass, Excitation, Request, Row, Table};
use crate::estimate::fit::Progress;
use crate::{Error, Result};

/// Errors by heading and by the size of the motion.
#[derive(Debug, Clone)]
pub struct Card {
    /// The compass.
    pub compass: Compass,
    /// Headings of the rows, rad.
    pub headings: Vec<f64>,
    /// One for each size.
    pub columns: Vec<Column>,
}

/// The errors on one motion.
#[derive(Debug, Clone)]
pub struct Column {
    /// The motion; `None` where it was recorded.
    pub excitation: Option<Excitation>,
    /// Rows of the headings that the linear theory reaches.
    pub table: Table,
}

impl Card {
    /// As many columns as one sheet of paper holds.
    pub const MOST: usize = 8;

    /// The same question for each size (a sea's significant height, m; the amplitude of regular roll or the standard
    /// deviation of irregular roll, rad).
    ///
    /// # Errors
    /// `BadInput` for rows that do not run over headings, and for no column or more than [`Card::MOST`].
    pub fn requests(request: &Request, sizes: &[f64]) -> Result<Vec<Request>> {
        headings(request)?;
        if !(1..=Self::MOST).contains(&sizes.len()) {
            let (most, asked) = (Self::MOST, sizes.len());
            return Err(Error::bad_input(format!("a deviation card has 1 to {most} columns, not {asked}")));
        }
        let of_size =
            |s: &f64| Request { excitation: request.excitation.of_size(*s), days: None, ..request.clone() };
        Ok(sizes.iter().map(of_size).collect())
    }

    /// The card of these sizes.
    ///
    /// ```
    /// use gyrospec::rolling::{Against, Card, Compass, Excitation, Request, Source};
    /// use gyrospec::{Silent, gyro::seed::Regular};
    /// let roll = Regular { amplitude: 0.1, frequency: 0.8 };      // rad, rad/s
    /// let excitation = Excitation { source: Source::Regular(roll), band: None };
    /// let asked = Request { compass: Compass::paper(), excitation, against: Against::card(45), days: None };
    /// let card = Card::of(&asked, &[0.05, 0.1], &Silent)?;
    /// // (2.4): with the square of the amplitude
    /// let mean = |column| card.cell(card.headings[1], column).unwrap().0;
    /// assert!((mean(1) / mean(0) - 4.0).abs() < 1e-9);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Card::requests`] and [`Request::table`], but for headings beyond the linear theory: these have no figure.
    pub fn of(request: &Request, sizes: &[f64], progress: &dyn Progress) -> Result<Self> {
        let column = |r: &Request| -> Result<Column> {
            Ok(Column { excitation: Some(r.excitation.clone()), table: r.prepare()?.reached(progress)? })
        };
        let columns = Self::requests(request, sizes)?.iter().map(column).collect::<Result<_>>()?;
        Ok(Self { compass: request.compass.clone(), headings: headings(request)?, columns })
    }

    /// The card of one table whose rows run over headings, in one column.
    pub fn of_table(table: Table) -> Self {
        Self {
            compass: table.compass.clone(),
            headings: table.rows.iter().map(|r| r.heading).collect(),
            columns: vec![Column { excitation: table.excitation.clone(), table }],
        }
    }

    /// Mean to trust and standard deviation on a heading (rad) in a column, both rad; `None` beyond the linear theory.
    pub fn cell(&self, heading: f64, column: usize) -> Option<(f64, f64)> {
        let table = &self.columns.get(column)?.table;
        let row: &Row = table.rows.iter().find(|r| r.heading.to_bits() == heading.to_bits())?;
        Some((table.mean(row), row.error.deviation))
    }
}

fn headings(request: &Request) -> Result<Vec<f64>> {
    match &request.against {
        Against::Heading(headings) => Ok(headings.clone()),
        _ => Err(Error::bad_input("the rows of a deviation card run over headings")),
    }
}
