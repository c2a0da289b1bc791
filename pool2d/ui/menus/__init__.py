"""What lies around the table: menus, the ends of frames and matches, and the lists to choose from."""
