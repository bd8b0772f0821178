// A line round objects. The picture's alpha says what is seen: 1 nothing special, 0.7 under the pointer, 0 selected.
uniform sampler2D maskMap;
out vec4 color;

float inside(vec2 pixel) { return 1.0 - textureLod(maskMap, pixel * viewport.zw, 0.0).a; }

float most(float radius)
{
    float m = 0.0;
    for (int i = 0; i < 8; ++i) {
        float a = 0.785398 * float(i);
        m = max(m, inside(gl_FragCoord.xy + radius * vec2(cos(a), sin(a))));
    }
    return m;
}

void main()
{
    float here = inside(gl_FragCoord.xy), near = most(1.6 * eye.x);
    // At the fringe of a selected object the mask is small, too; a little further in it is not.
    bool selected = ids.x != 0 && most(3.2 * eye.x) > 0.5;
    float full = selected ? 1.0 : 0.3;
    float edge = clamp((near - here) / full * 1.1, 0.0, 1.0);
    if (edge < 0.02) discard;
    color = vec4(selected ? vec3(1.0, 0.6039, 0.2353) : vec3(1.0), edge);
}
