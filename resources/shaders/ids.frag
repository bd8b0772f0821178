// Which node and which face is seen.
uniform usamplerBuffer triangleFaces;
out uvec2 id;

void main()
{
    int triangle = gl_PrimitiveID + ids.y;
    id = uvec2(ids.x, ids.z != 0 ? texelFetch(triangleFaces, triangle).r : uint(triangle));
}
