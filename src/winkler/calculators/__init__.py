"""Calculators without a server: kernels of twelve contact problems as WebAssembly, one page around them, a widget."""
