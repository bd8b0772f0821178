out vec4 color;

void main()
{
    // A little noise, else the gradient shows bands.
    float noise = fract(dot(gl_FragCoord.xy, vec2(0.7548777, 0.5698403))) - 0.5;
    color = vec4(backgroundAt(gl_FragCoord.xy) + noise / 255.0, skyTop.a);
}
