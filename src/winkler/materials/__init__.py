"""What the bodies are made of."""
