"""Abel transforms, cosine transforms and Fredholm equations of axisymmetric contact."""
