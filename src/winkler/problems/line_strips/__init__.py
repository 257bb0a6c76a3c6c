"""Line contacts in several strips: wavy half-planes, and sections that are rough, tilted or side by side."""
