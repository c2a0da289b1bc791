"""Many shots: what is kept of each as numpy columns, who plays them, and studies that play them by a file."""
