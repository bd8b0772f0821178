// Three lights that go with the camera, and a sky. Chosen so that a scan reads as clay: a soft key from the upper left, a weak cool fill,
// a rim that lifts the outline off the background.
layout(std140) uniform Lights {
    vec4 direction[3];  // towards the light, view space
    vec4 light[3];      // linear
    vec4 sky;
    vec4 ground;
    vec4 halfway;  // between the key light and the eye
};

vec3 sRGB(vec3 c)
{
    vec3 s = sqrt(clamp(c, 0.0, 1.0));  // within 0.024 of the curve, without powers
    return s * (1.12 + s * (-0.0562 - 0.0638 * s));
}

vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

/// Light that a matt surface sends back, for albedo 1.
vec3 diffuseLight(vec3 n)
{
    vec3 sum = mix(ground.rgb, sky.rgb, 0.5 + 0.5 * n.y);
    sum += light[0].rgb * max((dot(n, direction[0].xyz) + 0.12) * 0.893, 0.0);  // wrapped a little: no hard terminator
    sum += light[1].rgb * max(dot(n, direction[1].xyz), 0.0);
    sum += light[2].rgb * max(dot(n, direction[2].xyz), 0.0);
    return sum;
}

/// Highlight of the key light alone, without powers: enough for matt things.
vec3 softHighlight(vec3 n)
{
    float h = max(dot(n, halfway.xyz), 0.0);
    h *= h;
    h *= h;
    h *= h;
    return light[0].rgb * (h * h);
}

/// Trowbridge-Reitz highlights of all lights, reflectance `f0` at normal incidence.
vec3 highlights(vec3 n, vec3 v, float roughness, vec3 f0)
{
    float a2 = max(roughness * roughness, 0.002);
    a2 *= a2;
    float nv = max(dot(n, v), 1e-3), k = 0.5 * roughness * roughness;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        vec3 l = direction[i].xyz, h = normalize(l + v);
        float nl = max(dot(n, l), 0.0), nh = max(dot(n, h), 0.0), d = nh * nh * (a2 - 1.0) + 1.0;
        float shape = a2 / (4.0 * d * d * (nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
        float grazing = 1.0 - max(dot(v, h), 0.0);
        vec3 fresnel = f0 + (1.0 - f0) * grazing * grazing * grazing * grazing * grazing;
        sum += light[i].rgb * fresnel * (nl * shape);
    }
    // What a polished thing mirrors of the surroundings: the sky along the reflected ray.
    vec3 r = reflect(-v, n);
    return sum + f0 * mix(ground.rgb, sky.rgb, smoothstep(-0.6, 0.8, r.y)) * 1.4;
}
