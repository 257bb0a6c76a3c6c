"""Heat of friction on contacts of any outline: temperatures of height maps by boundary elements."""
