"""The validation table: literature cases, run and compared."""
