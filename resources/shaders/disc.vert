layout(location = 0) in vec3 position;
#ifdef COLOR
layout(location = 1) in vec4 pointColor;
flat out vec4 tint;
#endif

void main()
{
    vec3 view = (viewFromLocal * vec4(position, 1.0)).xyz;
    gl_Position = clipNearer(view, stroke.z > 0.5 ? 0.0 : 0.6 * stroke.x * eye.x + 0.5);
#ifdef COLOR
    tint = vec4(sRGB(pointColor.rgb), pointColor.a);
#endif
    gl_PointSize = ceil(eye.x * (stroke.x + 2.0 * haloWidth) + 2.0);
}
