"""Closed-form solutions of contact problems as plain functions: the judges of the solvers.

Nothing in the package imports them.  Every function is vectorised over its positional arguments, takes and
returns SI numbers, and knows nothing of profiles, media or problems.  ``depth`` as a function of the contact
radius is the equivalent plane profile: d = g(a).
"""
