"""Frictional heating: flash temperatures, steady and in time."""
