"""Checks of values and arguments before a computation: types of fields, sizes, outlines of contacts."""
