// The shadow alone: black, as dense as the key light is missed. mark.a: where nothing of it arrives.
in vec3 viewPosition;
out vec4 color;

void main()
{
    float a = mark.a * (1.0 - arriving((shadowFromView * vec4(viewPosition, 1.0)).xyz, shadow.w, 24, gl_FragCoord.xy));
    if (a < 0.003) discard;
    color = vec4(mark.rgb, a);
}
