layout(location = 0) in vec3 position;
flat out int pointIndex;

void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
    gl_PointSize = eye.x * stroke.x + 1.0;
    pointIndex = gl_VertexID;
}
