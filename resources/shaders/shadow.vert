// Depth as the key light sees it.
layout(location = 0) in vec3 position;
layout(location = 3) in vec2 texcoord;
layout(location = 5) in vec2 texcoord1;
#ifdef MAP_BASE
out vec2 uv;
#endif

void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
#ifdef MAP_BASE
    uv = (ids.w & 1) != 0 ? texcoord1 : texcoord;
    uv.y = 1.0 - uv.y;
#endif
}
