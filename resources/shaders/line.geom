// A segment becomes a quad of the wanted width in pixels, with round ends.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 viewPoint[];
noperspective out vec2 at;      // device pixels: along the segment from its start, and across
flat out float segmentLength;
out vec3 lineView;
#ifdef HEAT
uniform samplerBuffer faceValues;  // of the lines
flat out float heatValue;
#endif

void main()
{
#ifdef HALO
    float outer = eye.x * (0.5 * stroke.x + haloWidth) + 0.5;
#else
    float outer = eye.x * 0.5 * stroke.x + 0.5;
#endif
    vec3 a = viewPoint[0], b = viewPoint[1];
    // Cut off what lies behind the eye; beyond that plane division makes no sense.
    float near = eye.z > 0.5 ? -1e-4 * max(abs(a.z), abs(b.z)) - eye.w : 1e30;
    if (a.z > near && b.z > near) return;
    if (a.z > near) a = mix(a, b, (near - a.z) / (b.z - a.z));
    if (b.z > near) b = mix(b, a, (near - b.z) / (a.z - b.z));

    float nearer = stroke.z > 0.5 ? 0.0 : 0.75 * stroke.x * eye.x + 0.5;
    vec4 ca = clipNearer(a, nearer), cb = clipNearer(b, nearer);
    vec3 na = ca.xyz / ca.w, nb = cb.xyz / cb.w;
    vec2 pa = 0.5 * na.xy * viewport.xy, pb = 0.5 * nb.xy * viewport.xy;
    float len = length(pb - pa);
    vec2 dir = len > 1e-6 ? (pb - pa) / len : vec2(1.0, 0.0), side = vec2(-dir.y, dir.x);
    vec2 toNdc = 2.0 * viewport.zw;
    segmentLength = len;
    for (int i = 0; i < 4; ++i) {
        bool end = i >= 2;
        float s = (i & 1) == 0 ? -outer : outer, along = end ? outer : -outer;
        at = vec2((end ? len : 0.0) + along, s);
        lineView = end ? b : a;
#ifdef HEAT
        heatValue = texelFetch(faceValues, gl_PrimitiveIDIn).r;
#endif
        vec3 n = end ? nb : na;
        gl_Position = vec4(n.xy + toNdc * (dir * along + side * s), n.z, 1.0);
        EmitVertex();
    }
}
