// Names of the slots that C++ binds and GLSL reads. Plain preprocessor: read by both.
#ifndef RL_INTEROP_BINDINGS_H
#define RL_INTEROP_BINDINGS_H

// Vertex attribute locations
#define RL_ATTRIBUTE_POSITION 0
#define RL_ATTRIBUTE_FRAME 1
#define RL_ATTRIBUTE_UV0 2
#define RL_ATTRIBUTE_UV1 3
#define RL_ATTRIBUTE_COLOR 4
#define RL_ATTRIBUTE_INSTANCE_ROW0 5
#define RL_ATTRIBUTE_INSTANCE_ROW1 6
#define RL_ATTRIBUTE_INSTANCE_ROW2 7
#define RL_ATTRIBUTE_INSTANCE_INDICES 8
#define RL_ATTRIBUTE_PREVIOUS_ROW0 9
#define RL_ATTRIBUTE_PREVIOUS_ROW1 10
#define RL_ATTRIBUTE_PREVIOUS_ROW2 11

// Vertex stream slots (one buffer each)
#define RL_STREAM_POSITION 0
#define RL_STREAM_SURFACE 1
#define RL_STREAM_EXTRA 2
#define RL_STREAM_INSTANCE 3

// Uniform blocks
#define RL_UNIFORMS_VIEW 0
#define RL_UNIFORMS_LIGHTING 1
#define RL_UNIFORMS_PASS 2

// Texture units
#define RL_TEXTURE_BASE_COLOR 0
#define RL_TEXTURE_METALLIC_ROUGHNESS 1
#define RL_TEXTURE_NORMAL 2
#define RL_TEXTURE_OCCLUSION 3
#define RL_TEXTURE_EMISSIVE 4
#define RL_TEXTURE_SHADOW 5
#define RL_TEXTURE_ENVIRONMENT 6
#define RL_TEXTURE_BRDF_TABLE 7
#define RL_TEXTURE_GBUFFER0 8
#define RL_TEXTURE_GBUFFER1 9
#define RL_TEXTURE_GBUFFER2 10
#define RL_TEXTURE_DEPTH 11
#define RL_TEXTURE_SOURCE0 12
#define RL_TEXTURE_SOURCE1 13
#define RL_TEXTURE_SOURCE2 14
// What lights surfaces has but one source of its own.
#define RL_TEXTURE_REFLECTION_IRRADIANCE 13
#define RL_TEXTURE_REFLECTION_RECORDS 14
#define RL_TEXTURE_SKY 15
// Texel buffers: on llvmpipe they are read twice as fast as storage blocks
#define RL_TEXTURE_MATERIALS 16
#define RL_TEXTURE_LIGHTS 17
#define RL_TEXTURE_CLUSTERS 18
#define RL_TEXTURE_LIGHT_INDICES 19
#define RL_TEXTURE_IRRADIANCE 20
#define RL_TEXTURE_SHADOW_ATLAS 21
#define RL_TEXTURE_SHADOW_FACES 22
#define RL_TEXTURE_LIGHT_PATTERNS 24
#define RL_TEXTURE_AMBIENT_OCCLUSION 25
// Irradiance probes, where they are looked up; and what lighting reads of that, in the same units
#define RL_TEXTURE_PROBE_DISTANCES 26
#define RL_TEXTURE_LOCAL_TINT 26
#define RL_TEXTURE_PROBE_RECORDS 28
#define RL_TEXTURE_LOCAL_FLOW 28
#define RL_TEXTURE_REFLECTION_CUBES 27
#define RL_TEXTURE_FOG 29
// Surfaces alone read these, and no surface reads the G-buffer: they share its units.
#define RL_TEXTURE_DECAL_COLOR 8
#define RL_TEXTURE_DECAL_DETAIL 9
#define RL_TEXTURE_DECALS 10
#define RL_TEXTURE_DECAL_LISTS 11
#define RL_TEXTURE_LTC 23
// A material's, where nothing else reads a source.
#define RL_TEXTURE_TRANSMISSION 12
#define RL_TEXTURE_SUN_GLASS 30
#define RL_TEXTURE_ATLAS_GLASS 31

#endif
