noperspective in vec2 local;
noperspective in vec2 texel;
flat in vec4 itemBox, itemFill, itemBorder, itemShape, itemTexels;
uniform sampler2D atlasMap;
out vec4 color;

void main()
{
    if (itemShape.x == 1.0) {  // a letter
        color = vec4(itemFill.rgb, itemFill.a * texelFetch(atlasMap, ivec2(floor(texel)), 0).r);
    } else if (itemShape.x == 2.0) {  // a stroke with round ends
        vec2 ab = itemBox.zw - itemBox.xy, p = local - itemBox.xy;
        float t = clamp(dot(p, ab) / max(dot(ab, ab), 1e-6), 0.0, 1.0);
        color = vec4(itemFill.rgb, itemFill.a * clamp(itemShape.y + 0.5 - length(p - t * ab), 0.0, 1.0));
    } else if (itemShape.x == 3.0) {  // the colour bar
        color = vec4(heatColor(texel.x, vec4(1.0, 0.0, 0.0, itemShape.w)), itemFill.a);
    } else if (itemShape.x == 4.0) {  // a convex quad: the largest distance from a side
        vec2 p[4] = vec2[4](itemBox.xy, itemBox.zw, itemTexels.xy, itemTexels.zw);
        float area = 0.0, d = -1e6;
        for (int i = 0; i < 4; ++i) area += p[i].x * p[(i + 1) & 3].y - p[(i + 1) & 3].x * p[i].y;
        for (int i = 0; i < 4; ++i) {
            vec2 side = p[(i + 1) & 3] - p[i];
            if (dot(side, side) < 1e-6) continue;
            d = max(d, sign(area) * dot(local - p[i], normalize(vec2(side.y, -side.x))));
        }
        color = vec4(itemFill.rgb, itemFill.a * clamp(0.5 + itemShape.y - d, 0.0, 1.0));
    } else {  // a box with round corners
        vec2 middle = 0.5 * (itemBox.xy + itemBox.zw), half_ = 0.5 * (itemBox.zw - itemBox.xy);
        vec2 q = abs(local - middle) - half_ + itemShape.y;
        float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - itemShape.y;
        float within = clamp(0.5 - d, 0.0, 1.0), line = clamp(0.5 + d + itemShape.z, 0.0, 1.0);
        vec4 c = itemShape.z > 0.0 ? mix(itemFill, itemBorder, line) : itemFill;
        color = vec4(c.rgb, c.a * within);
    }
    if (color.a < 0.004) discard;
}
