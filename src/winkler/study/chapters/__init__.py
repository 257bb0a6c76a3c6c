"""What each chapter of physics adds to studies: kinds, answers, formulas and captions."""
