"""Controls: buttons, sliders, fields, and the form that holds them."""
