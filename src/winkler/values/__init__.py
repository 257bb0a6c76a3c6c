"""What all layers share: values, errors, units, names, checks of what is given, and validity."""
