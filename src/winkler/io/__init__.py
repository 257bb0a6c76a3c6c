"""Files in and out: measured profiles and tables read, results written."""
