out vec4 color;

void main()
{
    // A little noise, else the gradient shows bands.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    color = vec4(backgroundAt(gl_FragCoord.xy) + noise / 255.0, skyTop.a);
}
