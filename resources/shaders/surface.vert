layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 vertexColor;
layout(location = 3) in vec2 texcoord;
layout(location = 4) in float value;
layout(location = 5) in vec2 texcoord1;
layout(location = 6) in vec4 tangent;

invariant gl_Position;
#ifdef PLACED
out vec3 viewPosition;
#endif
#ifdef DENSE
out vec4 shade;  // as shown; and how bright the back is
#elif !defined(FLAT)
out vec3 viewNormal;
#endif
#if defined(COLOR) && !defined(DENSE)
out vec4 tint;
#endif
#if defined(MAPPED) || defined(CHECKER)
out vec4 uv;  // both sets, v upwards
#endif
#ifdef TANGENT
out vec4 viewTangent;
#endif
#ifdef HEAT
out float heatValue;
#endif
#ifdef HEAT_CATEGORY
flat out float heatValue;
#endif

void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
#ifdef PLACED
    viewPosition = (viewFromLocal * vec4(position, 1.0)).xyz;
#endif
#ifdef DENSE
    // Triangles of a few pixels: light at the vertices looks the same and costs half.
    vec3 n = normalize(mat3(normalFromLocal) * normal);
    vec3 base = baseColor.rgb;
#ifdef COLOR
    base *= vertexColor.rgb;
#endif
    shade = vec4(sRGB(base * diffuseLight(n) + surface.z * softHighlight(n)), sRGB(base * diffuseLight(-n)).g);
#elif !defined(FLAT)
    viewNormal = mat3(normalFromLocal) * normal;
#endif
#if defined(COLOR) && !defined(DENSE)
    tint = vertexColor;
#endif
#if defined(MAPPED) || defined(CHECKER)
    uv = vec4(texcoord, texcoord1);
#endif
#ifdef TANGENT
    viewTangent = vec4(mat3(viewFromLocal) * tangent.xyz, tangent.w);
#endif
#if defined(HEAT) || defined(HEAT_CATEGORY)
    heatValue = value;
#endif
}
