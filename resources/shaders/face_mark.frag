// A tint over faces, or a hatching that stays still on screen.
out vec4 color;

const vec3 haloColor = vec3(0.0627, 0.0706, 0.0824);

void main()
{
    color = mark;
    if (stroke.y == 2.0) {
        float period = 9.0 * eye.x, x = mod(gl_FragCoord.x + gl_FragCoord.y, period), d = abs(x - 0.5 * period) * 0.7071;
        float line = 1.0 - smoothstep(0.8 * eye.x - 0.5, 0.8 * eye.x + 0.5, d);
        color.rgb = mix(mark.rgb, haloColor, 0.9 * line);
        color.a = max(mark.a, 0.9 * line);
    }
}
