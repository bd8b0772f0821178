// Clay by default; vertex colours, textures and metal, or values as colours where the variant asks for them.
#if defined(FLAT) || defined(MATERIAL)
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
#ifdef MATERIAL
in vec2 uv;
uniform sampler2D baseColorMap;
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
vec3 shadingNormal(vec3 towardsEye)
{
#ifdef FLAT
    vec3 n = normalize(cross(dFdx(viewPosition), dFdy(viewPosition)));
    return dot(n, towardsEye) < 0.0 ? -n : n;
#else
    vec3 n = normalize(viewNormal);
    return gl_FrontFacing ? n : -n;
#endif
}

void main()
{
#if defined(FLAT) || defined(MATERIAL)
    vec3 v = eye.z > 0.5 ? -normalize(viewPosition) : vec3(0.0, 0.0, 1.0);
    vec3 n = shadingNormal(v);
#else
    vec3 n = shadingNormal(vec3(0.0, 0.0, 1.0));
#endif
    vec4 base = baseColor;
#ifdef COLOR
    base *= tint;
#endif
#ifdef MATERIAL
    vec4 texel = texture(baseColorMap, uv);
    base *= vec4(linearOf(texel.rgb), texel.a);
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
    vec3 diffuse = diffuseLight(n);
#ifdef MATERIAL
    vec3 lit = base.rgb * (1.0 - surface.x) * diffuse + surface.z * highlights(n, v, surface.y, mix(vec3(0.04), base.rgb, surface.x));
#else
    vec3 lit = base.rgb * diffuse + surface.z * softHighlight(n);
#endif
    if (!gl_FrontFacing) lit *= vec3(1.0 - look.z, 1.0 - 0.8 * look.z, 1.0 - 0.6 * look.z);
    vec3 shown = sRGB(lit);
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
