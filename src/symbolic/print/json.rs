//! Tables as JSON, schema `gyrospec.table/1`.

use super::{Exporter, programs};
use crate::Result;
use crate::symbolic::polynomial::Polynomial;
use crate::symbolic::table::Table;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// Every term of numerator and denominator.
pub struct Json;

/// All orders in one document, one term a line.
impl Exporter for Json {
    fn name(&self) -> &'static str {
        "json"
    }

    fn print(&self, orders: RangeInclusive<usize>) -> Result<String> {
        let mut text = String::from("{\"schema\":\"gyrospec.table/1\",\"orders\":[");
        for (place, program) in programs(orders)?.iter().enumerate() {
            let table = Table::expand(program)?;
            let comma = if place == 0 { "" } else { "," };
            let _ = write!(text, "{comma}\n{{\"n\":{},\n\"numerator\":[", table.order);
            polynomial(&mut text, &table.numerator);
            text.push_str("],\n\"denominator\":[");
            polynomial(&mut text, &table.denominator);
            text.push_str("]}");
        }
        text.push_str("\n]}\n");
        Ok(text)
    }
}

fn polynomial(text: &mut String, polynomial: &Polynomial) {
    let ring = polynomial.ring();
    for (place, (monomial, coefficient)) in polynomial.terms().iter().enumerate() {
        let comma = if place == 0 { "" } else { "," };
        let _ = write!(text, "{comma}\n {{\"coefficient\":{coefficient},\"powers\":{{");
        for (place, (symbol, exponent)) in ring.powers(*monomial).enumerate() {
            let comma = if place == 0 { "" } else { "," };
            let _ = write!(text, "{comma}\"{}\":{exponent}", ring.names()[symbol]);
        }
        text.push_str("}}");
    }
}
