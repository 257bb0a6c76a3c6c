"""Conduction of current and heat through contacts."""
