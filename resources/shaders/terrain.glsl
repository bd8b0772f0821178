// What is the same for one terrain. Local space; heights of the map are 0 to 1 before they are scaled.
layout(std140) uniform Terrain {
    vec4 extent;   // along x and z, height at 1, water level
    vec4 samples;  // of the height texture along x and z; spaces between the first and the last sample of the map, in texels
    vec4 bands;    // sand to, grass to, snow from (shares of the height at 1), cosine of the slope from which rock shows
    vec4 patches;  // along x and z, overlay (0 none, 1 borders, 2 level, 3 slope), 1 when textured
    vec4 brush;    // x, z, radius, radius of the inner ring
    vec4 eyeAt;    // the eye; distance from where haze begins
};
uniform sampler2D heightMap;
uniform sampler2D layerMap;  // fine structure of grass, rock, sand, snow; it tiles

const vec3 sun = vec3(-0.6228, 0.5708, 0.5350);  // the way to it; it stands still, so that relief is read alike from everywhere

struct Ground {
    float height;  // share of the height at 1
    float cavity;  // below (negative) or above its surroundings, in their own size
    vec3 normal;
};

/// Four samples round a place (5.7), as far apart as the level of detail asks for.
Ground groundAt(vec2 place, float lod)
{
    vec2 uv = (place * samples.zw + 0.5) / samples.xy, o = exp2(lod) / samples.xy;
    float h1 = textureLod(heightMap, uv - o, lod).r, h2 = textureLod(heightMap, uv + vec2(o.x, -o.y), lod).r;
    float h3 = textureLod(heightMap, uv + vec2(-o.x, o.y), lod).r, h4 = textureLod(heightMap, uv + o, lod).r;
    vec2 reach = 2.0 * exp2(lod) * extent.xy / samples.zw;
    vec3 a = vec3(-reach.x, extent.z * (h3 - h2), reach.y);  // P3 - P2
    vec3 b = vec3(reach.x, extent.z * (h4 - h1), reach.y);   // P4 - P1
    Ground g;
    g.height = 0.25 * (h1 + h2 + h3 + h4);
    g.normal = normalize(cross(a, b));
    float wide = max(lod + 1.0, log2(samples.x) - 5.5);
    g.cavity = extent.z * (g.height - textureLod(heightMap, uv, wide).r) * samples.z / (extent.x * exp2(wide));
    return g;
}

/// Of sun and sky.
vec3 lightOn(vec3 n, float cavity)
{
    float open = clamp(1.0 + 0.55 * cavity, 0.45, 1.25);
    return open * (vec3(1.02, 0.97, 0.88) * max(dot(n, sun), 0.0) + mix(vec3(0.10, 0.095, 0.085), vec3(0.32, 0.38, 0.46), 0.5 + 0.5 * n.y));
}

vec2 broadPlace(vec2 xz) { return mat2(0.8, 0.6, -0.6, 0.8) * xz * (4.3 / extent.x); }
