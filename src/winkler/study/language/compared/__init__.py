"""What curves are compared with: other models of a study, and expected numbers."""
