"""Rows of springs that slip, relax or roll, step by step."""
