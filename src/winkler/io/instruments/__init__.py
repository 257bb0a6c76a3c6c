"""Files as nanoindenters write them, each read into the columns of its tests."""
