"""What is asked, how it is solved, and what comes out: one physics a file."""
