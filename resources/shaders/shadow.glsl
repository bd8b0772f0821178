// How much of the key light arrives at a point.
uniform sampler2DShadow shadowMap;

/// Mean over a disc of `count` points of the map; each is turned otherwise from pixel to pixel, so that no steps are seen.
float arriving(vec3 at, float radius, int count, vec2 pixel)
{
    float turn = 6.2832 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))), sum = 0.0;
    for (int i = 0; i < count; ++i) {
        float r = sqrt((float(i) + 0.5) / float(count)) * radius * shadow.x, a = 2.39996 * float(i) + turn;
        sum += texture(shadowMap, vec3(at.xy + r * vec2(cos(a), sin(a)), at.z));
    }
    return sum / float(count);
}

/// `place` in view space, `facet` the normal of the triangle there, towards the eye.
float keyArriving(vec3 place, vec3 facet, vec2 pixel)
{
    // Away from the surface by as much as the soft edge reaches, else it darkens itself.
    float slope = dot(facet, direction[0].xyz);
    vec3 outside = slope < 0.0 ? -facet : facet;
    vec3 from = place + outside * (shadow.y * (shadow.z + 1.5));
    return arriving((shadowFromView * vec4(from, 1.0)).xyz, shadow.z, 12, pixel);
}
