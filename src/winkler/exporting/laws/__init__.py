"""Which problems are contact laws, and their steps as kernels."""
