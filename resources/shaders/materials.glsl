// Metallic-roughness as in glTF 2.0: what a surface sends back of the lights.

/// Share of the light that is mirrored, by the angle between half vector and eye.
vec3 fresnel(vec3 f0, float vh)
{
    float grazing = 1.0 - max(vh, 0.0), square = grazing * grazing;
    return f0 + (1.0 - f0) * (square * square * grazing);
}

/// Trowbridge-Reitz with Smith's shadowing, times the cosine and pi; without the Fresnel term.
float lobe(float nl, float nv, float nh, float roughness)
{
    float a2 = max(roughness * roughness, 0.002), k = 0.5 * roughness * roughness;
    a2 *= a2;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    return nl * a2 / (4.0 * d * d * (nl * (1.0 - k) + k + 1e-4) * (nv * (1.0 - k) + k));
}

#ifdef ENVIRONMENT
uniform samplerCube environmentMap;  // rougher from level to level
uniform sampler2D reflectanceTable;  // by cosine and roughness: factor and summand of f0

const float lastLevel = 5.0;

/// `key`: how much of the key light arrives.
vec3 litMaterial(vec3 base, vec3 n, vec3 v, float metallic, float roughness, float occlusion, float key)
{
    vec3 f0 = mix(vec3(0.04), base, metallic), matt = base * (1.0 - metallic);
    float nv = clamp(dot(n, v), 1e-3, 1.0);
    vec2 ab = textureLod(reflectanceTable, vec2(nv, roughness) * (31.0 / 32.0) + 0.5 / 32.0, 0.0).rg;
    // What bounces among the facets of a rough surface comes out after all: a white metal loses nothing.
    float lost = 1.0 / max(ab.x + ab.y, 1e-3) - 1.0, coat = (0.04 * ab.x + ab.y) * (1.0 + 0.04 * lost);
    vec3 reflected = mix(vec3(coat), (base * ab.x + ab.y) * (1.0 + base * lost), metallic);
    vec3 r = mat3(environmentFromView) * reflect(-v, n);
    vec3 mirrored = textureLod(environmentMap, r, roughness * lastLevel).rgb;
    vec3 sum = occlusion * (matt * (1.0 - coat) * otherLight(n) + reflected * mirrored);

    vec3 l = direction[0].xyz, h = normalize(l + v);
    float nl = max(dot(n, l), 0.0);
    vec3 f = fresnel(f0, dot(v, h));
    float through = 1.0 - fresnel(vec3(0.04), dot(v, h)).x;
    return sum + key * light[0].rgb * (matt * through * nl + light[0].w * f * lobe(nl, nv, max(dot(n, h), 0.0), roughness));
}
#else
vec3 litMaterial(vec3 base, vec3 n, vec3 v, float metallic, float roughness, float occlusion, float key)
{
    vec3 f0 = mix(vec3(0.04), base, metallic);
    vec3 sum = base * (1.0 - metallic) * (occlusion * otherLight(n) + key * keyLight(n));
    float nv = max(dot(n, v), 1e-3);
    for (int i = 0; i < 3; ++i) {
        vec3 l = direction[i].xyz, h = normalize(l + v);
        float arrives = (i == 0 ? key : occlusion) * lobe(max(dot(n, l), 0.0), nv, max(dot(n, h), 0.0), roughness);
        sum += surface.z * light[i].rgb * fresnel(f0, dot(v, h)) * arrives;
    }
    // What a polished thing mirrors of the surroundings: the sky along the reflected ray.
    vec3 r = reflect(-v, n);
    return sum + surface.z * occlusion * f0 * mix(ground.rgb, sky.rgb, smoothstep(-0.6, 0.8, r.y)) * 1.4;
}
#endif
