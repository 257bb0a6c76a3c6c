"""Line contacts of bodies that relax: a force per length over time."""
