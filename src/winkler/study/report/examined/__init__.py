"""What fits say beyond their numbers: sentences, sections, figures and files."""
