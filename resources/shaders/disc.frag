// A disc or a plus with a dark halo.
#ifdef COLOR
flat in vec4 tint;
#endif
out vec4 color;

const vec3 haloColor = vec3(0.0627, 0.0706, 0.0824);

float plus(vec2 p, float reach, float thick)
{
    p = abs(p);
    if (p.y > p.x) p = p.yx;
    return max(p.x - reach, p.y - thick);
}

void main()
{
    float size = ceil(eye.x * (stroke.x + 2.0 * haloWidth) + 2.0), r = 0.5 * stroke.x * eye.x;
    vec2 p = (gl_PointCoord - 0.5) * size;
    float d = stroke.y == 3.0 ? plus(p, r, 0.32 * r) : length(p) - r;
    vec4 core = mark;
#ifdef COLOR
    core *= tint;
#endif
    if (stroke.w > 0.5) {  // one of very many points: no halo, no soft edge
        if (d > 0.0) discard;
        color = core;
        return;
    }
    float outer = clamp(0.5 + haloWidth * eye.x - d, 0.0, 1.0), inner = clamp(0.5 - d, 0.0, 1.0);
    color = vec4(mix(haloColor, core.rgb, inner), core.a * max(inner, 0.85 * outer));
    if (color.a < 0.004) discard;
}
