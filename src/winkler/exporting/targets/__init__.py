"""The languages in which a contact law is written."""
