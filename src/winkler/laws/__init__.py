"""The laws of the interface: small records without contact mechanics in them."""
