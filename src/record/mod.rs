//! Recordings: CSV, NMEA 0183, gaps, rates, angle wrapping, clocks.
