// Loose points in the id buffer: the highest bit tells a vertex from a face.
flat in int pointIndex;
out uvec2 id;

void main()
{
    if (length(gl_PointCoord - 0.5) > 0.5) discard;
    id = uvec2(ids.x, 0x80000000u | uint(pointIndex));
}
