#pragma once
// Plain CPU data of one loaded glTF file. Nothing here knows a GPU. Indices are into the vectors of
// the same Model; -1 is "none". Units and spaces as glTF 2.0: metres, radians, right-handed, y up.

#include "engine/core/bounds.h"
#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rushlight::assets {

/// 8-bit RGBA, rows from the top, no padding. Whether the colours are sRGB is decided by the use
/// (Model::images doc).
struct Image {
    std::string name;  ///< for messages: URI or image name
    uint32_t width = 0;
    uint32_t height = 0;
    bool isColor = false;   ///< used as base colour or emissive: sRGB encoded
    bool isNormal = false;  ///< used as a normal map
    std::vector<uint8_t> pixels;
};

enum class Wrap : uint8_t { repeat, clampToEdge, mirroredRepeat };
enum class Filter : uint8_t { nearest, linear };

struct Sampler {
    Wrap wrapU = Wrap::repeat;
    Wrap wrapV = Wrap::repeat;
    Filter magnify = Filter::linear;
    Filter minify = Filter::linear;
    Filter mipmap = Filter::linear;
    bool useMipmaps = true;
    bool operator==(const Sampler&) const = default;
};

/// A use of an image by a material. `offset`, `rotation` (radians), `scale` as
/// KHR_texture_transform.
struct TextureUse {
    int image = -1;
    Sampler sampler;
    uint8_t uvSet = 0;  ///< 0 or 1
    vec2 offset{0};
    float rotation = 0;
    vec2 scale{1};

    bool isIdentityTransform() const {
        return offset == vec2(0) && rotation == 0 && scale == vec2(1);
    }
};

enum class AlphaMode : uint8_t { opaque, mask, blend };

struct Material {
    std::string name;
    vec4 baseColor{1};  ///< linear
    TextureUse baseColorTexture;
    float metallic = 1;
    float roughness = 1;
    TextureUse metallicRoughnessTexture;  ///< G roughness, B metallic, linear
    float normalScale = 1;
    TextureUse normalTexture;
    float occlusionStrength = 1;
    TextureUse occlusionTexture;  ///< R, linear
    vec3 emissive{0};             ///< linear, KHR_materials_emissive_strength already multiplied in
    TextureUse emissiveTexture;
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    float transmission = 0;          ///< KHR_materials_transmission, 0 to 1
    TextureUse transmissionTexture;  ///< R, linear
    vec3 transmissionColor{1};       ///< what KHR_materials_volume leaves of the light over its
                                     ///< thickness
    bool doubleSided = false;
    bool unlit = false;
};

/// Weights of the joints that move a vertex: `joints` index Skin::joints, `weights` sum to 1.
struct VertexSkin {
    std::array<uint16_t, 4> joints{};
    vec4 weights{0};
};

/// Offsets of a morph target, each empty or as long as Geometry::positions.
struct MorphTarget {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec3> tangents;
};

/// An indexed triangle list. `normals` is always as long as `positions` (made as the specification
/// says when the file has none); the other attributes are empty or as long. Two primitives that use
/// the same accessors share one.
struct Geometry {
    std::string name;
    std::vector<vec3> positions;
    std::vector<vec3> normals;   ///< unit
    std::vector<vec4> tangents;  ///< unit xyz; w = +1 or -1: bitangent = cross(normal, tangent) * w
    std::vector<vec2> uv0;
    std::vector<vec2> uv1;
    std::vector<vec4> colors;      ///< linear
    std::vector<VertexSkin> skin;  ///< empty, or as long as `positions`
    std::vector<MorphTarget> morphTargets;
    std::vector<uint32_t> indices;  ///< a multiple of three, each < positions.size()
    Aabb bounds;
};

struct Primitive {
    int geometry = -1;
    int material = -1;  ///< -1: the default material of glTF
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<float> weights;  ///< default morph weights
};

/// Rotation is a unit quaternion. A node given by a matrix that is no TRS keeps it in `matrix`.
struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    vec3 translation{0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1};
    bool hasMatrix = false;
    mat4 matrix{1};
    int mesh = -1;
    int skin = -1;
    int camera = -1;
    int light = -1;
    std::vector<float> weights;  ///< overrides Mesh::weights when not empty

    mat4 localTransform() const;
};

/// Looks along its node's local -z.
struct Camera {
    std::string name;
    bool perspective = true;
    float verticalFov = 0.785f;  ///< radians
    float aspect = 0;            ///< 0: that of the picture
    float orthoHalfWidth = 1;
    float orthoHalfHeight = 1;
    float nearPlane = 0.1f;
    float farPlane = 0;  ///< 0: infinite
};

enum class LightType : uint8_t { directional, point, spot };

/// A photometric web of type C: candela by direction, as an IES file (engine/assets/ies.h) has it.
/// Degrees.
struct LightProfile {
    std::string name;
    std::vector<float> verticalAngles;    ///< from the light's direction, increasing, two or more
    std::vector<float> horizontalAngles;  ///< about it; 0 alone, to 90, 180 or 360, or 90 to 270
    std::vector<float> candela;  ///< of each horizontal angle in turn, at all vertical ones
    float largestCandela = 0;
};

/// KHR_lights_punctual: shines along its node's local -z. Or EXT_lights_ies: a point light with a
/// profile.
struct Light {
    std::string name;
    LightType type = LightType::point;
    vec3 color{1};        ///< linear
    float intensity = 1;  ///< lux for directional, candela for point and spot: of its brightest
                          ///< direction
    float range = 0;      ///< metres; 0: unbounded
    float innerConeAngle = 0;
    float outerConeAngle = kPi / 4;
    int profile = -1;  ///< about the node's local -z, the horizontal angle from +x towards +y
    int cookie = -1;   ///< Model::images: upright about +y for who looks along -z
};

enum class AreaShape : uint8_t { rectangle, disk, sphere, tube };

/// Of a node's extras.rushlight: { "areaLight": { "shape", "luminance", "size", "radius", "length",
/// "color", "range", "twoSided" } }. Flat ones shine along the node's local -z; a tube lies along
/// its x. The node's scale counts for flat ones and for a tube's length.
struct AreaLight {
    int node = -1;
    AreaShape shape = AreaShape::rectangle;
    vec2 size{1};      ///< metres along x and y, of a rectangle or a disk
    float radius = 0;  ///< metres, of a sphere or a tube
    float length = 0;  ///< metres, of a tube
    vec3 color{1};
    float luminance = 0;  ///< candela per square metre
    float range = 0;      ///< metres; 0: unbounded
    bool twoSided = false;
};

/// EXT_lights_image_based: what is around the scene. As a cube map of OpenGL, whose faces are +x -x
/// +y -y +z -z.
struct ImageBasedLight {
    std::string name;
    quat rotation{1, 0, 0, 0};  ///< from the light's space to the world's
    float intensity = 1;        ///< a factor on all of it
    /// Of irradiance, in the real harmonics of Ramamoorthi and Hanrahan 2001 (none of them with a
    /// sign of its own): 1; y, z, x; xy, yz, 3z²-1, xz, x²-y².
    std::array<vec3, 9> irradiance{};
    uint32_t size = 0;         ///< texels along a face of level 0; a power of two
    uint32_t levels = 0;       ///< level i is blurred by the roughness i / (levels - 1) and half as
                               ///< large as the one before
    std::vector<vec3> texels;  ///< linear radiance; level by level, in it face by face, rows from t
                               ///< = 0
};

/// Of a node's extras.rushlight: { "reflectionProbe": { "size": [x, y, z], "offset", "blend",
/// "intensity", "resolution" } }. The light is captured where the node is, for a box that is turned
/// as the node is.
struct ReflectionProbe {
    int node = -1;
    vec3 size{1};    ///< metres of the box along the node's axes, before its scale
    vec3 offset{0};  ///< of the box's middle from the node
    /// Metres within the box over which its influence rises. In the file a single number is that of
    /// x and z: a floor is wholly in its room.
    vec3 blend{0};
    float intensity = 1;
    uint32_t resolution = 256;  ///< pixels along a captured face; a power of two
};

struct Skin {
    std::string name;
    std::vector<int> joints;                ///< nodes
    std::vector<mat4> inverseBindMatrices;  ///< as long as joints
};

enum class AnimationPath : uint8_t { translation, rotation, scale, weights };
enum class Interpolation : uint8_t { step, linear, cubicSpline };

struct AnimationChannel {
    int node = -1;
    AnimationPath path = AnimationPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times;   ///< seconds, increasing
    std::vector<float> values;  ///< components per key (3, 4, or weights), three times as many for
                                ///< cubicSpline
};

struct Animation {
    std::string name;
    std::vector<AnimationChannel> channels;
    float duration = 0;  ///< seconds
};

/// What the file asks for, by property, and how well it is honoured.
struct Fidelity {
    std::vector<std::string> exact;
    std::vector<std::string> approximated;
    std::vector<std::string> unsupported;
};

struct Model {
    std::string path;
    std::string generator;
    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<Geometry> geometries;
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<int> roots;  ///< of the scene to show
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<LightProfile> lightProfiles;
    std::optional<ImageBasedLight> imageBasedLight;  ///< of the scene to show
    std::vector<ReflectionProbe> reflectionProbes;
    std::vector<AreaLight> areaLights;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    Fidelity fidelity;
    std::vector<std::string> warnings;  ///< full sentences: what was replaced, as the options allow
};

}  // namespace rushlight::assets
