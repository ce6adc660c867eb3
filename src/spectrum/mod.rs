//! Roll and sea spectra, shaping filters, rational fits.
