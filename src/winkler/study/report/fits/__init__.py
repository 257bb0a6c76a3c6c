"""Pages of single curves that were fitted."""
