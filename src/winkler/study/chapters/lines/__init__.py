"""Records of line contacts: kinds and answers, chapter by chapter."""
