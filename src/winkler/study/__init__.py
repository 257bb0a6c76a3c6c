"""Studies: a problem in a text file, read, run, written and compared with expected numbers."""
