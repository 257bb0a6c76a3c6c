"""Materials of the bodies: elastic, viscoelastic, graded, layered and conducting solids."""
