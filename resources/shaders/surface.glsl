// What the stages of a surface hand on, by variant.
#if defined(MAP_BASE) || defined(MAP_ROUGHNESS) || defined(MAP_NORMAL) || defined(MAP_OCCLUSION) || defined(MAP_EMISSIVE)
#define MAPPED
#endif
#if defined(FLAT) || defined(MATERIAL) || defined(SHADOW) || defined(MATCAP)
#define PLACED
#endif
