"""Logs of tests as tables: loops of friction, contact resistance, pins on discs, bounces."""
