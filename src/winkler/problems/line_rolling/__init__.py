"""Rolling line contacts: cylinders that pull or brake, from rest to steady rolling, and on bodies that relax."""
