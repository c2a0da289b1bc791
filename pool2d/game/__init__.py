"""What is played on a table, without a screen."""
