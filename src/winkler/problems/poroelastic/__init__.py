"""Bodies with a pore liquid that flows out of the contact: relaxation of the force at a constant depth."""
