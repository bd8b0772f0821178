// A line round selected objects. The picture's alpha says what is seen: 1 nothing special, 0.7 under the pointer, 0 selected.
uniform sampler2D maskMap;
out vec4 color;

float inside(vec2 pixel) { return 1.0 - textureLod(maskMap, pixel * viewport.zw, 0.0).a; }

void main()
{
    float r = 1.5 * eye.x;
    float most = 0.0, sum = 0.0, here = inside(gl_FragCoord.xy);
    for (int i = 0; i < 8; ++i) {
        float a = 0.785398 * float(i);
        float m = inside(gl_FragCoord.xy + r * vec2(cos(a), sin(a)));
        most = max(most, m);
    }
    bool selected = most > 0.5;
    float edge = selected ? smoothstep(0.0, 0.9, most - here) : smoothstep(0.0, 0.25, most - here);
    color = vec4(selected ? vec3(1.0, 0.6039, 0.2353) : vec3(1.0), edge);
    if (edge < 0.01) discard;
}
