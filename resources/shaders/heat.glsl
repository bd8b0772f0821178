// Values as colours. Row 0 of the table: viridis, 1: diverging, 2: the categories.
uniform sampler2D heatTable;

const vec3 undefinedColor = vec3(0.5412, 0.5608, 0.5882);

vec3 heatColor(float value, vec4 heat)
{
    if (value < -1e25) return undefinedColor;
    if (heat.z > 0.5) return texelFetch(heatTable, ivec2(int(mod(value + 0.5, heat.z)), 2), 0).rgb;
    float t = clamp(value * heat.x + heat.y, 0.0, 1.0);
    return textureLod(heatTable, vec2((t * 255.0 + 0.5) / 256.0, (heat.w + 0.5) / 3.0), 0.0).rgb;
}
