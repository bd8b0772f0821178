// A piece of the ground plane.
layout(location = 0) in vec3 position;
out vec3 viewPosition;

void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
    viewPosition = (viewFromLocal * vec4(position, 1.0)).xyz;
}
