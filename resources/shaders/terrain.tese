// Listing 5.4: bilinear in the patch (5.3), height from the map (5.6), nothing below the water. Equal spacing: along an edge the same
// fractions k/n on both sides, and triangles that can be counted; lighting by pixel hides where the number changes.
layout(quads, equal_spacing, cw) in;  // u along x and v along z turn the other way seen from above
in vec2 patchCorner[];
patch in float patchLevel;

precise gl_Position;
invariant gl_Position;
#ifndef POSITION_ONLY
out vec2 place;  // shares of the terrain
out vec3 local;
flat out float level;
#ifdef DENSE
out vec3 vertexLight;
out vec4 vertexGround;  // height, cavity, cosine of the slope, broad structure
#endif
#endif

/// Between four samples by hand: texture units keep 8 bits of the way between two, which shows as steps.
float heightAt(vec2 st)
{
    vec2 texel = clamp(st * samples.zw, vec2(0.0), samples.xy - 1.0);
    ivec2 low = min(ivec2(texel), ivec2(samples.xy) - 2);
    vec2 f = texel - vec2(low);
    float a = texelFetch(heightMap, low, 0).r, b = texelFetch(heightMap, low + ivec2(1, 0), 0).r;
    float c = texelFetch(heightMap, low + ivec2(0, 1), 0).r, d = texelFetch(heightMap, low + ivec2(1, 1), 0).r;
    return (1.0 - f.y) * ((1.0 - f.x) * a + f.x * b) + f.y * ((1.0 - f.x) * c + f.x * d);
}

void main()
{
    float u = gl_TessCoord.x, v = gl_TessCoord.y;
    precise vec2 at = (1.0 - u) * (1.0 - v) * patchCorner[0] + u * (1.0 - v) * patchCorner[1] + u * v * patchCorner[2] +
                      (1.0 - u) * v * patchCorner[3];
    precise vec2 st = at / patches.xy;
    precise vec3 p = vec3((st.x - 0.5) * extent.x, max(extent.z * heightAt(st), extent.w), (st.y - 0.5) * extent.y);
    gl_Position = clipFromLocal * vec4(p, 1.0);
#ifndef POSITION_ONLY
    place = st;
    local = p;
    level = patchLevel;
#ifdef DENSE
    Ground g = groundAt(st, max(log2(samples.z / (patches.x * patchLevel)), 0.0));
    vertexLight = lightOn(g.normal, g.cavity);
    vertexGround = vec4(g.height, g.cavity, g.normal.y, textureLod(layerMap, broadPlace(p.xz), 1.0).g);
#endif
#endif
}
