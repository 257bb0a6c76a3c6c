"""Rolling contact: creepage, creep forces, and oscillating contacts."""
