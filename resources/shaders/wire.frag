// Thin smooth lines along the edges of triangles. Where edges crowd below a few pixels they fade, else a dense mesh turns black.
in vec3 share;
out vec4 color;

void main()
{
    vec3 step_ = max(fwidth(share), vec3(1e-12));
    vec3 pixels = share / step_;
    float d = min(min(pixels.x, pixels.y), pixels.z);
    float half_ = 0.5 * stroke.x * eye.x;
    float line = 1.0 - smoothstep(half_ - 0.5, half_ + 0.5, d);
    float height = 1.0 / max(max(step_.x, step_.y), step_.z);  // of the triangle, in pixels
    float alpha = mark.a * line * mix(0.25, 1.0, smoothstep(1.0, 9.0 * eye.x, height));
    if (alpha < 0.004) discard;
    color = vec4(mark.rgb, alpha);
}
