"""Half-spaces whose modulus follows a power of the depth."""
