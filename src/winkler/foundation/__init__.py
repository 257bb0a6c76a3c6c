"""Beds: rows of springs under an equivalent plane profile (T1 and the springs of step 3 of docs/method.md)."""
