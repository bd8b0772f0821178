// Three lights that go with the camera, and a sky. Chosen so that a scan reads as clay: a soft key from the upper left, a weak cool fill,
// a rim that lifts the outline off the background. Or (ENVIRONMENT) what comes from all round the scene, and its key light.
layout(std140) uniform Lights {
    vec4 direction[3];  // towards the light, view space
    vec4 light[3];      // linear: what white sends back under it head on; w: 1 when polished things mirror it as a point
    vec4 sky;
    vec4 ground;
    vec4 halfway;  // between the key light and the eye
    mat4 environmentFromView;
    mat4 shadowFromView;  // to 0..1 of the shadow map
    vec4 harmonics[9];    // of the light on a matt surface by its normal, from the environment but without the key light
    vec4 shadow;          // one texel of the map, the same in metres, radius of the soft edge on objects and on the ground in texels
};

vec3 sRGB(vec3 c)
{
    vec3 s = sqrt(clamp(c, 0.0, 1.0));  // within 0.024 of the curve, without powers
    return s * (1.12 + s * (-0.0562 - 0.0638 * s));
}

vec3 exactSRGB(vec3 c)
{
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

/// Light that a matt surface sends back, for albedo 1: of the key light, and of everything else.
vec3 keyLight(vec3 n)
{
#ifdef ENVIRONMENT
    return light[0].rgb * max(dot(n, direction[0].xyz), 0.0);
#else
    return light[0].rgb * max((dot(n, direction[0].xyz) + 0.12) * 0.893, 0.0);  // wrapped a little: no hard terminator
#endif
}

vec3 otherLight(vec3 n)
{
#ifdef ENVIRONMENT
    vec3 d = mat3(environmentFromView) * n;
    vec3 sum = harmonics[0].rgb + harmonics[1].rgb * d.y + harmonics[2].rgb * d.z + harmonics[3].rgb * d.x;
    sum += harmonics[4].rgb * (d.x * d.y) + harmonics[5].rgb * (d.y * d.z) + harmonics[6].rgb * (3.0 * d.z * d.z - 1.0);
    sum += harmonics[7].rgb * (d.x * d.z) + harmonics[8].rgb * (d.x * d.x - d.y * d.y);
    return max(sum, 0.0);
#else
    vec3 sum = mix(ground.rgb, sky.rgb, 0.5 + 0.5 * n.y);
    sum += light[1].rgb * max(dot(n, direction[1].xyz), 0.0);
    return sum + light[2].rgb * max(dot(n, direction[2].xyz), 0.0);
#endif
}

vec3 diffuseLight(vec3 n) { return otherLight(n) + keyLight(n); }

/// Highlight of the key light alone, without powers: enough for matt things.
vec3 softHighlight(vec3 n)
{
    float h = max(dot(n, halfway.xyz), 0.0);
    h *= h;
    h *= h;
    h *= h;
    return light[0].rgb * (light[0].w * h * h);
}
