"""Pages and questions over another scene."""
