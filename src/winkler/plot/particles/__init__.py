"""Pictures of particles."""
