"""What happened in a force curve: found from the order of its points, or stated."""
