layout(location = 0) in vec3 position;
out vec3 viewPoint;
void main() { viewPoint = (viewFromLocal * vec4(position, 1.0)).xyz; }
