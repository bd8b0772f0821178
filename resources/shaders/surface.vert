layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 vertexColor;
layout(location = 3) in vec2 texcoord;
layout(location = 4) in float value;

invariant gl_Position;
out vec3 viewPosition;
#ifndef FLAT
out vec3 viewNormal;
#endif
#ifdef COLOR
out vec4 tint;
#endif
#ifdef MATERIAL
out vec2 uv;
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
    viewPosition = (viewFromLocal * vec4(position, 1.0)).xyz;
#ifndef FLAT
    viewNormal = mat3(normalFromLocal) * normal;
#endif
#ifdef COLOR
    tint = vertexColor;
#endif
#ifdef MATERIAL
    uv = vec2(texcoord.x, 1.0 - texcoord.y);
#endif
#if defined(HEAT) || defined(HEAT_CATEGORY)
    heatValue = value;
#endif
}
