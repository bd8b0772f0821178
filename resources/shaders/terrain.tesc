// Levels by (5.1) are worked out once an edge (render/terrain_levels.h): both patches at it get the very same number.
layout(vertices = 4) out;
in vec4 corner[];
out vec2 patchCorner[];
patch out float patchLevel;

void main()
{
    patchCorner[gl_InvocationID] = corner[gl_InvocationID].xy;
    if (gl_InvocationID != 0) return;
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = corner[i].z;
    gl_TessLevelInner[0] = corner[0].w;
    gl_TessLevelInner[1] = corner[0].w;
    patchLevel = corner[0].w;
}
