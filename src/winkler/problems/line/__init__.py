"""Line contacts: cylinders, wedges and other two-dimensional profiles on half-planes, in plane strain."""
