#ifdef MAP_BASE
in vec2 uv;
uniform sampler2D baseColorMap;
#endif

void main()
{
#ifdef MAP_BASE
    if (baseColor.a * texture(baseColorMap, uv).a < surface.w) discard;
#endif
}
