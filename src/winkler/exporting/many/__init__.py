"""Many contacts of one law, stepped in place by the kernels that are exported."""
