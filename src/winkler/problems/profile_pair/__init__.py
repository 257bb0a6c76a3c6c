"""Profile on profile: wheels on rails, cams on followers, balls in grooves, by measured or given profiles."""
