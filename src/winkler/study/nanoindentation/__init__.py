"""Studies of nanoindentations: calibration of an indenter, and modulus and hardness of many curves."""
