"""Impact of bodies, straight and oblique, with friction and adhesion."""
