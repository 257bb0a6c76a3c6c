"""Closed-form solutions of contact problems as plain functions: references for the solvers.

Nothing in the package imports them.  Every function is vectorised over its positional arguments, takes and
returns SI numbers, and uses no profiles, media or problems.  ``depth`` as a function of the contact
radius is the equivalent plane profile: d = g(a).
"""
