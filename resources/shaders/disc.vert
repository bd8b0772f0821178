layout(location = 0) in vec3 position;

void main()
{
    vec3 view = (viewFromLocal * vec4(position, 1.0)).xyz;
    gl_Position = clipNearer(view, stroke.z > 0.5 ? 0.0 : 0.6 * stroke.x * eye.x + 0.5);
    gl_PointSize = ceil(eye.x * (stroke.x + 2.0 * haloWidth) + 2.0);
}
