// Morphs, then skins (linear blend, book 7.11). What comes out is captured, and every pass draws it in place of the mesh at rest.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#ifdef SPLIT
layout(location = 2) in uint vertexOf;  // which vertex, and which corner of the mesh this drawn one is
layout(location = 3) in uint cornerOf;
#endif

uniform samplerBuffer poseData;       // targets that count (weight, index); then three rows a joint
uniform isamplerBuffer jointSlots;    // four a texel
uniform samplerBuffer jointWeights;
uniform samplerBuffer morphDeltas;    // of all targets, one after the other
uniform samplerBuffer morphNormals;

invariant out vec3 posedPosition;
out vec3 posedNormal;

// ids: texels of joints a vertex (0: not skinned), targets that count, vertices of the mesh, normals of the mesh (0: they are not morphed);
// stroke.x: 1 when normals are those of corners.
vec3 morphed(samplerBuffer deltas, int element, int elements, vec3 from)
{
    for (int k = 0; k < ids.y; ++k) {
        vec2 target = texelFetch(poseData, k).xy;
        from += target.x * texelFetch(deltas, int(target.y) * elements + element).xyz;
    }
    return from;
}

void main()
{
#ifdef SPLIT
    int vertex = int(vertexOf), corner = int(cornerOf);
#else
    int vertex = gl_VertexID, corner = vertex;
#endif
    vec3 p = position, n = normal;
#ifdef MORPHED
    p = morphed(morphDeltas, vertex, ids.z, p);
    if (ids.w > 0) n = morphed(morphNormals, stroke.x > 0.5 ? corner : vertex, ids.w, n);
#endif
#ifdef SKINNED
    int joints = (textureSize(poseData) - ids.y) / 3;
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);
    bool any = false;
    for (int texel = 0; texel < ids.x; ++texel) {
        vec4 weights = texelFetch(jointWeights, vertex * ids.x + texel);
        ivec4 slots = texelFetch(jointSlots, vertex * ids.x + texel);
        for (int k = 0; k < 4; ++k) {
            float w = weights[k];
            if (w == 0.0) continue;
            any = true;
            int at = ids.y + 3 * slots[k];
            bool known = slots[k] >= 0 && slots[k] < joints;
            x += w * (known ? texelFetch(poseData, at) : vec4(1.0, 0.0, 0.0, 0.0));
            y += w * (known ? texelFetch(poseData, at + 1) : vec4(0.0, 1.0, 0.0, 0.0));
            z += w * (known ? texelFetch(poseData, at + 2) : vec4(0.0, 0.0, 1.0, 0.0));
        }
    }
    if (any) {
        p = vec3(dot(x, vec4(p, 1.0)), dot(y, vec4(p, 1.0)), dot(z, vec4(p, 1.0)));
        // The inverse transpose but for a positive factor: its rows are products of rows.
        vec3 a = cross(y.xyz, z.xyz), b = cross(z.xyz, x.xyz), c = cross(x.xyz, y.xyz);
        n = (dot(x.xyz, a) < 0.0 ? -1.0 : 1.0) * vec3(dot(a, n), dot(b, n), dot(c, n));
    }
#endif
    float size = length(n);
    posedPosition = p;
    posedNormal = size > 0.0 ? n / size : normal;
}
