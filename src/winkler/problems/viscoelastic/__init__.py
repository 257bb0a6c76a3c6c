"""Viscoelastic contact: paths, impact, sliding, friction and adhesion of bodies that relax."""
