"""Players who are no people, as they are seen at the table: they look, settle, say what they mean, and strike."""
