// A square of the map of colours in which nothing colours light: white, and infinitely far.
layout(location = 0) out vec4 passing;

void main() { passing = vec4(1.0, 1.0, 1.0, 0.0); }
