"""Stiff plates on soft bases under height maps: the contact of maps whose pixels feel each other far away."""
