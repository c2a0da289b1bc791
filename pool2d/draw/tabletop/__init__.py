"""The table as a picture: layers of wood, leather and cloth, kept on disk."""
