"""Fields of the form in the browser: numbers with units, ranges, materials, curves, sweeps."""
