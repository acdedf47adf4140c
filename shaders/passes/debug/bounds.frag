layout(location = 0) out vec4 color;

void main() { color = vec4(0.2, 1.0, 0.4, 1.0); }
