"""Contacts of many particles, contact laws for particle codes, and elastic-plastic particles."""
