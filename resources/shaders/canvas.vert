// Flat things in pixels: boxes, discs, strokes, letters, a colour bar. One instance each, in the order they were put.
layout(location = 0) in vec4 box;     // left, top, right, bottom (strokes: both ends), device pixels from the top left
layout(location = 1) in vec4 fill;
layout(location = 2) in vec4 border;
layout(location = 3) in vec4 shape;   // kind, radius or half width, border width, row of the heat table
layout(location = 4) in vec4 texels;  // letters: place in the atlas; colour bar: range; quads: third and fourth corner

noperspective out vec2 local;
noperspective out vec2 texel;
flat out vec4 itemBox, itemFill, itemBorder, itemShape, itemTexels;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    float grow = shape.x == 1.0 || shape.x == 3.0 ? 0.0 : 1.0 + (shape.x == 2.0 || shape.x == 4.0 ? shape.y : 0.0);
    vec2 low = min(box.xy, box.zw), high = max(box.xy, box.zw);
    if (shape.x == 4.0) {
        low = min(low, min(texels.xy, texels.zw));
        high = max(high, max(texels.xy, texels.zw));
    }
    low -= grow;
    high += grow;
    local = mix(low, high, corner);
    texel = mix(texels.xy, texels.zw, corner);
    itemBox = box;
    itemFill = fill;
    itemBorder = border;
    itemShape = shape;
    itemTexels = texels;
    gl_Position = vec4(2.0 * local.x * viewport.z - 1.0, 1.0 - 2.0 * local.y * viewport.w, 0.0, 1.0);
}
