"""Rollers of finite length: the pressure along them, crowned, cut off or tilted."""
