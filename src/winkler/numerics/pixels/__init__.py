"""What pixels that press or are sheared displace on bodies that are not homogeneous."""
