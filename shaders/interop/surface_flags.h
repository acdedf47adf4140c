// What a surface's shader variant does; each flag is a #define of the same name in the shaders.
#ifndef RL_INTEROP_SURFACE_FLAGS_H
#define RL_INTEROP_SURFACE_FLAGS_H
// MaterialData, texels of 4 x uint32:
//
//     texel 0   x: base colour r, g (half)   y: b, a (half)   z: metallic, roughness (unorm16)
//               w: normal scale, occlusion strength (half)
//     texel 1   x: emissive r, g (half)      y: emissive b, alpha cutoff (half)
//               z: array layers: base colour 0-9, metallic-roughness 10-19, normal 20-29
//               w: array layers: occlusion 0-9, emissive 10-19; uv sets: bit 20 + texture slot
//     texel 2   (with TRANSMISSION alone)  x: transmission, 1 where alpha is coverage (half)
//               y: its colour r, g (half)  z: b, 0 (half)   w: array layer
//     then, with UV_TRANSFORMS, for each slot (RL_MATERIAL_SLOT_TRANSMISSION with TRANSMISSION
//     alone) two texels: 2x2 matrix by columns; offset
#define RL_MATERIAL_TEXELS 2
#define RL_MATERIAL_SLOT_TRANSMISSION 5

// The last two bits of the G-buffer's third target
#define RL_SURFACE_AT_REST 0
#define RL_SURFACE_MOVING 1
#define RL_SURFACE_UNLIT 2
#endif
