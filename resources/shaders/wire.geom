// Gives each corner its share of the triangle, so that the fragment knows how far it is from the edges. An edge that only cuts a polygon
// is moved out of reach.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
invariant gl_Position;
out vec3 share;
#ifdef EDGE_FLAGS
uniform usamplerBuffer edgeFlags;  // bit i: the edge from corner i to the next one is an edge of the face
#endif

void main()
{
    vec3 away = vec3(0.0);
#ifdef EDGE_FLAGS
    uint flags = texelFetch(edgeFlags, gl_PrimitiveIDIn + ids.y).r;
    away = vec3((flags & 2u) != 0u ? 0.0 : 1e3, (flags & 4u) != 0u ? 0.0 : 1e3, (flags & 1u) != 0u ? 0.0 : 1e3);
#endif
    for (int i = 0; i < 3; ++i) {
        gl_Position = gl_in[i].gl_Position;
        share = away + vec3(i == 0, i == 1, i == 2);
        EmitVertex();
    }
}
