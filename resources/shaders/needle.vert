// Both ends of a needle at a vertex, drawn as instances of a line.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 viewPoint;
void main()
{
    vec3 along = normalize(mat3(normalFromLocal) * normal + vec3(0.0, 0.0, 1e-20));
    viewPoint = (viewFromLocal * vec4(position, 1.0)).xyz + (gl_VertexID == 0 ? 0.0 : stroke.w) * along;
}
