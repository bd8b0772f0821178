// What is the same for a whole frame.
layout(std140) uniform Camera {
    mat4 clipFromView;
    vec4 viewport;    // width, height in device pixels, and one over them
    vec4 eye;         // device pixels a logical one; size of a pixel at distance 1 (perspective) or anywhere (not); 1 when perspective
    vec4 skyTop;      // of the background, sRGB
    vec4 skyBottom;
};

const float haloWidth = 1.4;  // logical pixels

vec3 backgroundAt(vec2 pixel) { return mix(skyBottom.rgb, skyTop.rgb, pixel.y * viewport.w); }

/// The size of a pixel in world units at a point of view space.
float pixelSizeAt(vec3 view) { return eye.z > 0.5 ? eye.y * max(-view.z, 1e-9) : eye.y; }

/// Clip position of a point moved towards the eye by some pixels' worth: it stays where it is on screen.
vec4 clipNearer(vec3 view, float pixels)
{
    float by = pixels * pixelSizeAt(view) + 2e-4 * abs(view.z);
    if (eye.z > 0.5) return clipFromView * vec4(view * max(1.0 - by / max(-view.z, 1e-9), 0.5), 1.0);
    return clipFromView * vec4(view + vec3(0.0, 0.0, by), 1.0);
}
