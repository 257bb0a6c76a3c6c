"""Line contacts on layers: their integral equation, its flat punches, and grids of strips that wear."""
