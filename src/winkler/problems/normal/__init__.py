"""Normal contact: pressed bodies, their contact area, design to order, and the onset of yield."""
