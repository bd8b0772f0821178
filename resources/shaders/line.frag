// The core of a line, or the dark halo drawn before all cores.
noperspective in vec2 at;
flat in float segmentLength;
in vec3 lineView;
#ifdef HEAT
flat in float heatValue;
#endif
out vec4 color;

const vec3 haloColor = vec3(0.0627, 0.0706, 0.0824);

void main()
{
    float beyond = max(max(-at.x, at.x - segmentLength), 0.0);
    float d = length(vec2(beyond, at.y)), half_ = 0.5 * stroke.x * eye.x;
#ifdef HALO
    half_ += haloWidth * eye.x;
#endif
    float alpha = 1.0 - smoothstep(half_ - 0.5, half_ + 0.5, d);
#ifdef HALO
    color = vec4(haloColor, 0.85 * mark.a * alpha);
#else
    if (stroke.y == 1.0) {  // dashed
        float period = 9.0 * eye.x, x = mod(at.x, period);
        alpha *= smoothstep(-0.5, 0.5, 0.58 * period - x) * smoothstep(-0.5, 0.5, x);
    }
    color = vec4(mark.rgb, mark.a * alpha);
#endif
#ifdef HEAT
    color = vec4(heatColor(heatValue, heat), mark.a * alpha);
#else
    // The ground's lines fade with the distance; everything else has no range.
    if (heat.x > 0.0) color.a *= 1.0 - smoothstep(0.1, 1.0, length(lineView - heat.yzw) * heat.x);
#endif
    if (color.a < 0.004) discard;
}
