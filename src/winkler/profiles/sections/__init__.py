"""Two-dimensional profiles: sections of long bodies, and profiles across the direction of rolling."""
