"""The assumptions of contact problems: which problem makes which, and one module for the check of each."""
