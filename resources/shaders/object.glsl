// What is the same for one draw.
layout(std140) uniform Object {
    mat4 clipFromLocal;
    mat4 viewFromLocal;
    mat4 normalFromLocal;
    vec4 baseColor;  // linear
    vec4 surface;    // metallic, roughness, share of the specular light, alpha below which nothing is drawn
    vec4 look;       // share of the background (dimmed), alpha to write, darkening of back faces, 1 when lit from both sides
    vec4 heat;       // scale and shift from value to 0..1, number of categories (0: a range), row of the table
    vec4 mark;       // colour of marks, sRGB
    vec4 stroke;     // width in logical pixels, style (0 solid, 1 dashed, 2 hatched, 3 plus), 1 when drawn through, length of needles
    ivec4 ids;       // node, first triangle of the draw, 1 when triangleFaces says the face, pictures that read the second coordinates
    vec4 emissive;   // linear; w: strength of occlusion
    vec4 maps;       // strength of the normal map; others unused
};
