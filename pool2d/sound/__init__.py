"""The sounds of the table: waves from contacts, and the device that plays them."""
