"""Forces of contacts held at constant depths: poroelastic or viscoelastic, and the numbers of a poroelastic body."""
