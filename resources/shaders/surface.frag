// Clay by default; vertex colours, pictures and metal, or values as colours where the variant asks for them.
#ifdef PLACED
in vec3 viewPosition;
#endif
#ifdef DENSE
in vec4 shade;
#elif !defined(FLAT)
in vec3 viewNormal;
#endif
#if defined(COLOR) && !defined(DENSE)
in vec4 tint;
#endif
#if defined(MAPPED) || defined(CHECKER)
in vec4 uv;
#endif
#ifdef TANGENT
in vec4 viewTangent;
#endif
#ifdef MAP_BASE
uniform sampler2D baseColorMap;
#endif
#ifdef MAP_ROUGHNESS
uniform sampler2D roughnessMap;
#endif
#ifdef MAP_NORMAL
uniform sampler2D normalMap;
#endif
#ifdef MAP_OCCLUSION
uniform sampler2D occlusionMap;
#endif
#ifdef MAP_EMISSIVE
uniform sampler2D emissiveMap;
#endif
#ifdef MATCAP
uniform sampler2D matcapMap;
#endif
#ifdef HEAT
in float heatValue;
#endif
#ifdef HEAT_CATEGORY
flat in float heatValue;
#endif
#ifdef HEAT_FACE
uniform samplerBuffer faceValues;
uniform usamplerBuffer triangleFaces;
#endif
out vec4 color;

#ifdef DENSE
void main()
{
    vec3 shown = gl_FrontFacing ? shade.rgb : shade.a * vec3(1.0 - look.z, 1.0 - 0.8 * look.z, 1.0 - 0.6 * look.z);
#ifdef DIMMED
    shown = mix(shown, backgroundAt(gl_FragCoord.xy), look.x);
#endif
    color = vec4(shown, look.y);
}
#else
#ifdef PLACED
vec3 facetNormal(vec3 towardsEye)
{
    vec3 n = normalize(cross(dFdx(viewPosition), dFdy(viewPosition)));
    return dot(n, towardsEye) < 0.0 ? -n : n;
}
#endif

vec3 shadingNormal(vec3 towardsEye)
{
#ifdef FLAT
    return facetNormal(towardsEye);
#else
    vec3 n = normalize(viewNormal);
    return gl_FrontFacing ? n : -n;
#endif
}

#ifdef MAPPED
/// Where a picture is read: its rows run downwards.
vec2 placeIn(int map)
{
    vec2 at = (ids.w >> map & 1) != 0 ? uv.zw : uv.xy;
    return vec2(at.x, 1.0 - at.y);
}
#endif

#ifdef MAP_NORMAL
/// `n` bent by the picture: x along growing u, y along growing v. Without tangents the directions come from the pixels beside this one.
vec3 mappedNormal(vec3 n)
{
    vec3 bent = texture(normalMap, placeIn(2)).xyz * 2.0 - 1.0;
    bent.xy *= maps.x;
#ifdef TANGENT
    float front = gl_FrontFacing ? 1.0 : -1.0;
    vec3 t = viewTangent.xyz - n * dot(n, viewTangent.xyz);
    if (dot(t, t) < 1e-20) return n;
    t = normalize(t);
    vec3 b = cross(front * n, t) * viewTangent.w;
#else
    vec2 at = (ids.w >> 2 & 1) != 0 ? uv.zw : uv.xy, ux = dFdx(at), uy = dFdy(at);
    float turn = ux.x * uy.y - uy.x * ux.y;
    vec3 t = (dFdx(viewPosition) * uy.y - dFdy(viewPosition) * ux.y) * sign(turn);
    t -= n * dot(n, t);
    if (dot(t, t) < 1e-30) return n;
    t = normalize(t);
    vec3 b = cross(n, t) * sign(turn);  // on the back both turn round, and b stays
    float front = gl_FrontFacing ? 1.0 : -1.0;
#endif
    return normalize(front * (t * bent.x + b * bent.y) + n * max(bent.z, 1e-3));
}
#endif

#ifdef CHECKER
/// Ten squares a unit, warmer along u and cooler along v, so that a mirrored or turned piece is seen. Averaged where they are finer than pixels.
vec3 checkerColor(vec2 at)
{
    vec2 p = at * 10.0, w = max(fwidth(p), vec2(1e-5));
    vec2 i = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
    float light = clamp(0.5 - 0.5 * i.x * i.y, 0.0, 1.0);
    vec2 along = fract(at);
    vec3 tone = vec3(0.55) + vec3(0.30, 0.02, -0.20) * (along.x - 0.5) + vec3(-0.20, 0.05, 0.30) * (along.y - 0.5);
    return tone * mix(0.22, 1.0, light);
}
#endif

#ifdef MATCAP
/// The sphere seen in the picture at the same normal; x and y as the eye sees this point.
vec3 matcapColor(vec3 n, vec3 v)
{
    vec3 x = normalize(vec3(v.z, 0.0, -v.x)), y = cross(v, x);
    return texture(matcapMap, vec2(dot(x, n), dot(y, n)) * 0.49 + 0.5).rgb;
}
#endif

void main()
{
#ifdef PLACED
    vec3 v = eye.z > 0.5 ? -normalize(viewPosition) : vec3(0.0, 0.0, 1.0);
#else
    vec3 v = vec3(0.0, 0.0, 1.0);
#endif
    vec3 n = shadingNormal(v);
#ifdef MAP_NORMAL
    n = mappedNormal(n);
#endif
    vec4 base = baseColor;
#ifdef COLOR
    base *= tint;
#endif
#ifdef MAP_BASE
    base *= texture(baseColorMap, placeIn(0));
#endif
#ifdef CHECKER
    base.rgb = checkerColor(uv.xy);
#endif
#ifdef MATERIAL
    if (base.a < surface.w) discard;
#endif
#if defined(HEAT) || defined(HEAT_CATEGORY)
    base.rgb = linearOf(heatColor(heatValue, heat));
#endif
#ifdef HEAT_FACE
    int triangle = gl_PrimitiveID + ids.y;
    int face = ids.z != 0 ? int(texelFetch(triangleFaces, triangle).r) : triangle;
    base.rgb = linearOf(heatColor(texelFetch(faceValues, face).r, heat));
#endif
#ifdef SHADOW
    float key = keyArriving(viewPosition, facetNormal(v), gl_FragCoord.xy);
#else
    const float key = 1.0;
#endif
#ifdef MATERIAL
    float metallic = surface.x, roughness = surface.y, occlusion = 1.0;
#ifdef MAP_ROUGHNESS
    vec4 polish = texture(roughnessMap, placeIn(1));
    roughness *= polish.g;
    metallic *= polish.b;
#endif
#ifdef MAP_OCCLUSION
    occlusion = 1.0 + emissive.w * (texture(occlusionMap, placeIn(3)).r - 1.0);
#endif
    vec3 lit = litMaterial(base.rgb, n, v, metallic, roughness, occlusion, key);
#ifdef MAP_EMISSIVE
    lit += emissive.rgb * texture(emissiveMap, placeIn(4)).rgb;
#else
    lit += emissive.rgb;
#endif
#elif !defined(MATCAP)
    vec3 lit = base.rgb * (otherLight(n) + key * keyLight(n)) + surface.z * key * softHighlight(n);
#endif
#ifdef MATCAP
    vec3 lit = matcapColor(n, v);
#endif
    if (!gl_FrontFacing) lit *= vec3(1.0 - look.z, 1.0 - 0.8 * look.z, 1.0 - 0.6 * look.z);
#if defined(MATERIAL) || defined(MATCAP)
    vec3 shown = exactSRGB(lit);
#else
    vec3 shown = sRGB(lit);
#endif
#ifdef DIMMED
    shown = mix(shown, backgroundAt(gl_FragCoord.xy), look.x);
#endif
#ifdef MATERIAL
    color = vec4(shown, look.w > 0.5 ? base.a : look.y);
#else
    color = vec4(shown, look.y);
#endif
}
#endif
