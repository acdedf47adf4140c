// A small engine that embeds the renderer: its own context, its own drawing before and after, plain
// arrays in, its own framebuffer out. Of the project it includes one header. Ends with 1 where
// something is not as promised.
#include "renderer/renderer.h"

#include "tests/embed/host_gl.h"

#include <algorithm>
#include <cstdio>

namespace {

constexpr uint32_t kWidth = 160, kHeight = 96;
int failures = 0;

void expect(bool good, const std::string& what) {
    if (good) return;
    ++failures;
    std::fprintf(stderr, "embed_host: %s\n", what.c_str());
}

// One side of the cube a line: its normal and two edges.
const glm::vec3 kSides[6][3] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}};

/// A checkered cube on a plane under the sun, in one renderer.
class Scene {
public:
    Scene() {
        rushlight::RendererDesc desc;
        desc.loadGl = host::Context::load;
        desc.validateCommands = true;
        renderer = std::move(rushlight::Renderer::create(desc).value());
        std::vector<glm::vec3> positions, normals;
        std::vector<glm::vec2> uvs;
        std::vector<uint32_t> indices;
        for (const auto& [normal, u, v] : kSides) {
            const uint32_t first = uint32_t(positions.size());
            for (glm::vec2 c : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
                positions.push_back(normal + u * c.x + v * c.y);
                normals.push_back(normal);
                uvs.push_back(c);
            }
            for (uint32_t i : {0, 1, 2, 0, 2, 3}) indices.push_back(first + i);
        }
        rushlight::MeshDesc mesh;
        mesh.label = "cube";
        mesh.positions = positions, mesh.normals = normals, mesh.uv0 = uvs, mesh.indices = indices;
        const std::vector<uint8_t> checker = {255, 40, 40, 255, 250, 250, 250, 255,
                                              30,  30, 30, 255, 250, 250, 250, 255,
                                              255, 40, 40, 255, 9,   9,   99,  255};
        rushlight::MaterialDesc red;
        red.metallic = 0, red.roughness = 0.4f;
        red.baseColorTexture.image = *renderer->createImage({"checker", 3, 2, true, checker});
        cube_.mesh = plane_.mesh = *renderer->createMesh(mesh);
        cube_.material = *renderer->createMaterial(red);
        cube_.worldFromLocal[3] = {0, 1, 0};
        plane_.worldFromLocal = {8, 0, 0, 0, 0.1f, 0, 0, 0, 8, 0, -0.1f, 0};
    }

    void render(GLuint framebuffer) {
        const rushlight::Instance instances[] = {cube_, plane_};
        const rushlight::DirectionalLight sun{glm::normalize(glm::vec3(-1, -2, -0.5f)),
                                              glm::vec3(3)};
        rushlight::FrameInput frame;
        frame.view.viewFromWorld = glm::lookAt(glm::vec3(4, 4, 6), glm::vec3(0, 1, 0),
                                               glm::vec3(0, 1, 0));
        frame.instances = instances;
        frame.lighting.directional = {&sun, 1};
        frame.lighting.ambientSky = {0.2f, 0.3f, 0.5f};
        frame.settings.shadowResolution = 256;
        const auto rendered = renderer->render(frame, {framebuffer, kWidth, kHeight});
        expect(bool(rendered), rendered ? "" : rendered.error().text());
    }

    std::unique_ptr<rushlight::Renderer> renderer;

private:
    rushlight::Instance cube_, plane_;
};

/// The host's frame: its triangle, our picture, its triangle once more over it.
host::Pixels hostFrame(Scene& scene, const host::Triangle& triangle, const host::BadManners* bad,
                       const std::string& name) {
    host::Canvas canvas(kWidth, kHeight);
    triangle.draw(canvas);
    const host::Pixels before = canvas.read();
    if (bad) bad->misbehave();
    scene.render(canvas.framebuffer);
    for (const std::string& broken : host::brokenPromises()) expect(false, name + ": " + broken);
    host::BadManners::behave();
    const host::Pixels ours = canvas.read();
    triangle.draw(canvas);
    const host::Pixels after = canvas.read();
    const size_t inside = (kHeight / 8 * kWidth + kWidth / 8) * 4, outside = after.size() - 4;
    const auto magenta = [](const host::Pixels& p, size_t at) {
        return p[at] == 255 && p[at + 1] == 0 && p[at + 2] == 255 && p[at + 3] == 255;
    };
    expect(magenta(before, inside), name + ": the host's first triangle is not there.");
    expect(!magenta(ours, inside), name + ": the frame does not cover the host's triangle.");
    expect(magenta(after, inside), name + ": the host cannot draw after the frame.");
    expect(std::equal(&after[outside], &after[outside] + 4, &ours[outside]),
           name + ": the host's triangle changes a pixel outside of it.");
    return ours;
}

}  // namespace

int main() {
    host::Context context;
    if (!context.valid()) return std::fprintf(stderr, "embed_host: there is no context.\n"), 4;
    {
        const host::Triangle triangle;
        const host::BadManners bad;
        Scene first;
        const host::Pixels clean = hostFrame(first, triangle, nullptr, "clean");
        const auto lit = std::pair(*std::min_element(clean.begin(), clean.end()),
                                   *std::max_element(clean.begin(), clean.end()));
        expect(lit.first < 40 && lit.second > 200, "the picture has no light and shade.");
        expect(hostFrame(first, triangle, &bad, "hostile") == clean,
               "state that the host left changes the picture.");
        bad.misbehave();  // while textures and meshes are made
        Scene second;
        host::BadManners::recover();
        expect(hostFrame(second, triangle, &bad, "second") == clean,
               "a second renderer, made under the host's state, gives another picture.");
        expect(hostFrame(first, triangle, nullptr, "first again") == clean,
               "a second renderer in the process changes the first one's picture.");
        second = Scene();
        expect(hostFrame(first, triangle, nullptr, "after another is destroyed") == clean,
               "destroying one renderer changes the other's picture.");
    }
    for (const std::string& message : context.messages) expect(false, "GL says: " + message);
    return failures == 0 ? 0 : 1;
}
