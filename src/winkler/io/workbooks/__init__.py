"""Sheets of workbooks as rows of texts and numbers."""
