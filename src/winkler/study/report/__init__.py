"""Reports, tables, figures and archives of studies."""
