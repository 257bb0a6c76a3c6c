"""The form of the app as plain data: studies, fits and sweeps; no browser in it."""
