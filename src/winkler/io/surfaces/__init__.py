"""Files of instruments and published containers with height maps and line scans, through SurfaceTopography."""
