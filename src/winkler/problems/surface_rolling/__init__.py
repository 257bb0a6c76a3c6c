"""Rolling of contacts that need not be elliptic: creep forces of height maps by boundary elements."""
