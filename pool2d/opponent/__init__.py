"""Somebody to play against: a hand that misses, shots found by geometry and refined on the engine, and judgement."""
