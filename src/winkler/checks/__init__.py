"""What values and arguments are compared with before anything is computed: types of fields, sizes, footprints."""
