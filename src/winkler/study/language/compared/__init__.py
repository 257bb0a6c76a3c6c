"""Other models of the curves of a study."""
