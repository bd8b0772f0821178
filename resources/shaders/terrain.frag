// Sand, grass, rock and snow by height and slope, water as deep as the ground below it lies. Lit by pixel, so that the light does not
// change with the level of detail; where vertices are as close as samples of the map, they are lit instead: it looks the same.
in vec2 place;
in vec3 local;
flat in float level;
#ifdef DENSE
in vec3 vertexLight;
in vec4 vertexGround;
#endif
out vec4 color;

const vec3 grassDark = vec3(0.0640, 0.1260, 0.0300), grassLight = vec3(0.1750, 0.2380, 0.0680);
const vec3 rockDark = vec3(0.1022, 0.0903, 0.0790), rockLight = vec3(0.2540, 0.2310, 0.2080);
const vec3 sandDark = vec3(0.2470, 0.1870, 0.0980), sandLight = vec3(0.4240, 0.3420, 0.1950);
const vec3 snowDark = vec3(0.6800, 0.7400, 0.8200), snowLight = vec3(0.9000, 0.9250, 0.9500);
const vec3 waterDeep = vec3(0.0120, 0.0620, 0.1420), waterShallow = vec3(0.0700, 0.2300, 0.3000);

/// Level of the height texture whose texels are about as large as pixels.
float lodHere()
{
    vec2 texel = place * samples.zw, dx = dFdx(texel), dy = dFdy(texel);
    return max(0.25 * log2(max(dot(dx, dx), 1e-12) * max(dot(dy, dy), 1e-12)), 0.0);
}

/// Linear. `rise` is the cosine of the slope, `fine` and `broad` the structure near by and over some distance.
vec3 groundColor(float height, float cavity, float rise, vec4 fine, float broad)
{
    float h = height + 0.05 * (broad - 0.5) + 0.018 * (fine.r - 0.5);  // bands do not end along contour lines
    vec3 grass = mix(grassDark, grassLight, clamp(0.55 * fine.r + 0.75 * broad - 0.15, 0.0, 1.0));
    vec3 rock = mix(rockDark, rockLight, clamp(0.75 * fine.g + 0.45 * broad - 0.08, 0.0, 1.0));
    vec3 sand = mix(sandDark, sandLight, clamp(0.6 * fine.b + 0.6 * broad - 0.1, 0.0, 1.0));
    vec3 snow = mix(snowDark, snowLight, clamp(0.4 * fine.a + 0.5 + 0.4 * cavity, 0.0, 1.0));
    vec3 c = mix(sand, grass, smoothstep(bands.x - 0.02, bands.x + 0.02, h));
    c = mix(c, rock, smoothstep(bands.y - 0.03, bands.y + 0.05, h));
    float steep = rise + 0.10 * (fine.g - 0.5) + 0.06 * (broad - 0.5);
    c = mix(c, rock, 1.0 - smoothstep(bands.w - 0.05, bands.w + 0.05, steep));
    // Snow stays on all but cliffs, more in hollows.
    float stays = smoothstep(bands.w - 0.30, bands.w - 0.02, steep - 0.15 * cavity);
    return mix(c, snow, smoothstep(bands.z - 0.03, bands.z + 0.06, h) * stays);
}

#ifdef WATER
/// `bed` is the lit colour of the ground under it, `depth` in shares of the height.
vec3 waterColor(vec3 bed, float depth, vec3 toEye, vec4 fine)
{
    vec3 n = normalize(vec3(0.05 * (fine.r - 0.5), 1.0, 0.05 * (fine.b - 0.5)));
    vec3 body = mix(waterShallow, waterDeep, 1.0 - exp(-depth * 9.0)) * (0.55 + 0.6 * max(dot(n, sun), 0.0));
    vec3 c = mix(bed, body, 0.96 - 0.66 * exp(-depth * 26.0));
    float grazing = 1.0 - max(dot(n, toEye), 0.0), fresnel = 0.03 + 0.6 * grazing * grazing * grazing * grazing;
    c = mix(c, vec3(0.26, 0.36, 0.48), fresnel);
    float glint = max(dot(n, normalize(sun + toEye)), 0.0);
    return c + 0.35 * pow(glint, 64.0);
}

/// A band of light along the shore.
float shore(float depth)
{
    float width = max(fwidth(depth), 1e-6);
    return (1.0 - smoothstep(0.0, 0.0035 + width, abs(depth))) * step(-width, depth);
}

vec3 wetted(vec3 land, float height, vec4 fine)
{
    float depth = extent.w / extent.z - height;
    if (depth <= 0.0 || local.y > extent.w + 1e-3 * extent.z) return land * (1.0 - 0.3 * (1.0 - smoothstep(0.0, 0.02, -depth)));
    vec3 towards = eye.z > 0.5 ? normalize(eyeAt.xyz - local) : eyeAt.xyz;
    return mix(waterColor(0.6 * land, depth, towards, fine), vec3(0.60, 0.71, 0.71), 0.45 * shore(depth));
}
#endif

float bandOf(float distance, float halfWidth, float pixel)
{
    return 1.0 - smoothstep(halfWidth - 0.6, halfWidth + 0.6, distance / max(pixel, 1e-9));
}

vec3 withBrush(vec3 c)
{
    float d = length(local.xz - brush.xy), pixel = length(vec2(dFdx(d), dFdy(d))), r = eye.x;
    float outer = abs(d - brush.z), inner = abs(d - brush.w);
    c = mix(c, vec3(0.0627, 0.0745, 0.0824), 0.62 * max(bandOf(outer, 3.0 * r, pixel), bandOf(inner, 1.8 * r, pixel)));
    return mix(c, vec3(1.0), max(bandOf(outer, 1.3 * r, pixel), 0.85 * bandOf(inner, 0.7 * r, pixel)));
}

float borderLine()
{
    vec2 at = place * patches.xy, pixel = max(fwidth(at), vec2(1e-9)), d = abs(at - floor(at + 0.5)) / pixel;
    return 1.0 - smoothstep(0.2, 1.2, min(d.x, d.y) / eye.x);
}

vec3 facetNormal()
{
    vec3 n = normalize(cross(dFdy(local), dFdx(local)));
    return n.y < 0.0 ? -n : n;
}

void main()
{
#ifdef DENSE
    float height = vertexGround.x, cavity = vertexGround.y, rise = vertexGround.z;
    vec3 lightHere = vertexLight;
#else
    Ground g = groundAt(place, lodHere());
#ifdef FLAT
    g.normal = facetNormal();
#endif
    float height = g.height, cavity = g.cavity, rise = g.normal.y;
    vec3 lightHere = lightOn(g.normal, g.cavity);
#endif
    vec3 shown;
#ifdef PLAIN
    // Clay, or a number as colour.
    float value = patches.z > 2.5 ? degrees(acos(clamp(rise, 0.0, 1.0))) / 60.0 : level / 64.0;
    vec3 base = patches.z > 1.5 ? linearOf(heatColor(value, vec4(1.0, 0.0, 0.0, 0.0))) : baseColor.rgb;
    shown = sRGB(base * lightHere);
#else
    vec4 fine = texture(layerMap, local.xz * (30.0 / extent.x));
#ifdef DENSE
    float broad = vertexGround.w;
#else
    float broad = texture(layerMap, broadPlace(local.xz)).g;
#endif
    vec3 lit = groundColor(height, cavity, rise, fine, broad) * lightHere;
#ifdef WATER
    lit = wetted(lit, height, fine);
#endif
    shown = sRGB(lit);
#endif
    if (!gl_FrontFacing) shown *= vec3(0.30, 0.31, 0.33);
    float haze = clamp((length(eyeAt.xyz - local) - eyeAt.w) / extent.x, 0.0, 1.0);
    shown = mix(shown, backgroundAt(gl_FragCoord.xy), 0.38 * haze * eye.z);
#ifdef BORDERS
    shown = mix(shown, vec3(1.0), 0.28 * borderLine());
#endif
#ifdef BRUSH
    shown = withBrush(shown);
#endif
    color = vec4(shown, look.y);
}
