"""Pictures of viscoelastic contacts, solids and fits."""
