"""Height maps looked at more closely: true areas and seals, electric contacts, wear."""
