"""Oliver and Pharr's analysis of unloading curves."""
