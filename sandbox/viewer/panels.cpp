#include "sandbox/viewer/panels.h"

#include <imgui.h>

#include <algorithm>

namespace rushlight {
namespace {

constexpr float kMargin = 10;  // pixels

/// A window that is as large as what is in it. `x` counts from the right edge when negative.
bool beginPanel(const char* title, float x, float y) {
    const float right = ImGui::GetIO().DisplaySize.x;
    const ImVec2 at(x < 0 ? right + x : x, y);
    ImGui::SetNextWindowPos(at, ImGuiCond_FirstUseEver, ImVec2(x < 0 ? 1.0f : 0.0f, 0));
    return ImGui::Begin(title, nullptr,
                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
}

void drawTotals(const FrameReport& r) {
    ImGui::Text("build %.2f ms  execute %.2f ms  GPU %.2f ms", r.cpuBuildMs, r.cpuExecuteMs,
                r.gpuMs);
    ImGui::Text("draws %u  triangles %llu", r.draws, static_cast<unsigned long long>(r.triangles));
    ImGui::Text("instances visible %u / %u  rejected %u", r.visible, r.instances, r.rejected);
    ImGui::Text("culled by frustum %u  by occlusion %u", r.culledFrustum, r.culledOcclusion);
    ImGui::Text("lights visible %u / %u", r.lightsVisible, r.lights);
    ImGui::Text("shadow views drawn %u  cached %u", r.shadowViewsDrawn, r.shadowViewsCached);
    ImGui::Text("GL calls %u  state changes %u  waits %u", r.glCalls, r.stateChanges, r.waits);
    ImGui::Text("uploads %.1f KiB", double(r.uploadedBytes) / 1024);
}

void drawPassRow(const PassReport& pass) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(pass.name);
    ImGui::TableNextColumn();
    ImGui::Text("%u", pass.draws);
    ImGui::TableNextColumn();
    ImGui::Text("%llu", static_cast<unsigned long long>(pass.triangles));
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", pass.cpuMs);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", pass.gpuMs);
}

void drawPassTable(const FrameReport& report) {
    if (!ImGui::BeginTable("passes", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit))
        return;
    for (const char* heading : {"pass", "draws", "triangles", "CPU ms", "GPU ms"})
        ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    for (const PassReport& pass : report.passes) drawPassRow(pass);
    ImGui::EndTable();
}

struct HelpLine {
    const char* keys;
    const char* meaning;
};
constexpr HelpLine kHelp[] = {
    {"W A S D", "move"},
    {"Q E", "down, up (flying)"},
    {"mouse", "look: click to hold it, or the right button"},
    {"wheel", "flying speed"},
    {"Shift", "faster"},
    {"F or C", "fly / walk"},
    {"Tab", "these panels"},
    {"F1-F12, 1-9", "pass views 1-12, 1-9"},
    {"Shift+1-9", "pass views 10-18"},
    {"PgUp PgDn", "previous, next pass view"},
    {"0, Backspace", "the frame"},
    {"R", "load shaders and level again"},
    {"P", "screenshot into out/"},
    {"Esc", "release the mouse; again: quit"},
};

void comboToneMap(FrameSettings& settings) {
    constexpr const char* kNames[] = {"none", "neutral", "agx", "aces"};
    int current = int(settings.toneMap);
    if (ImGui::Combo("tone map", &current, kNames, IM_ARRAYSIZE(kNames)))
        settings.toneMap = ToneMap(current);
}

void comboAmbientOcclusion(FrameSettings& settings) {
    constexpr const char* kNames[] = {"off", "low", "medium", "high"};
    int current = int(settings.ambientOcclusion);
    if (ImGui::Combo("ambient occlusion", &current, kNames, IM_ARRAYSIZE(kNames)))
        settings.ambientOcclusion = AmbientOcclusion(current);
    if (settings.ambientOcclusion != AmbientOcclusion::off)
        ImGui::SliderFloat("its radius (m)", &settings.ambientOcclusionRadius, 0.05f, 10, "%.2f",
                           ImGuiSliderFlags_Logarithmic);
}

void comboContactShadows(FrameSettings& settings) {
    constexpr const char* kNames[] = {"off", "sun", "sun and lamps"};
    int current = int(settings.contactShadows);
    if (ImGui::Combo("contact shadows", &current, kNames, IM_ARRAYSIZE(kNames)))
        settings.contactShadows = ContactShadows(current);
}

void comboShadowFilter(FrameSettings& settings) {
    constexpr const char* kNames[] = {"hard", "PCF", "soft"};
    int current = int(settings.shadowFilter);
    if (ImGui::Combo("shadow edges", &current, kNames, IM_ARRAYSIZE(kNames)))
        settings.shadowFilter = ShadowFilter(current);
}

void editExposure(FrameSettings& settings) {
    ImGui::Checkbox("automatic exposure", &settings.autoExposure);
    if (settings.autoExposure) return;
    ImGui::Checkbox("EV100", &settings.useExposureValue);
    if (settings.useExposureValue)
        ImGui::SliderFloat("exposure value", &settings.exposureValue, -6, 16, "%.2f");
    else
        ImGui::SliderFloat("exposure scale", &settings.exposureScale, 0.01f, 16, "%.3f",
                           ImGuiSliderFlags_Logarithmic);
}

}  // namespace

void drawStatistics(const StatisticsView& view) {
    if (beginPanel("frame", kMargin, kMargin)) {
        ImGui::Text("%.1f frames/s  %.2f ms (median)  %u x %u", view.meter.framesPerSecond(),
                    view.meter.medianSeconds() * 1000, view.size.x, view.size.y);
        ImGui::TextDisabled("%.*s", int(view.device.size()), view.device.data());
        drawTotals(view.report);
        if (view.allocationsKnown)
            ImGui::Text("allocations %llu", static_cast<unsigned long long>(view.allocations));
        ImGui::Separator();
        drawPassTable(view.report);
    }
    ImGui::End();
}

void drawPassViews(FrameSettings& settings) {
    if (beginPanel("pass views", -kMargin, kMargin)) {
        for (int i = 0; i < int(DebugView::count); ++i) {
            const auto image = DebugView(i);
            if (ImGui::Selectable(toText(image), settings.debugView == image, 0, ImVec2(150, 0)))
                settings.debugView = image;
        }
    }
    ImGui::End();
}

void drawSettings(ViewerSettings& settings, CameraRig& camera) {
    FrameSettings& frame = settings.frame;
    if (beginPanel("settings", -kMargin, 330)) {
        ImGui::Checkbox("shadows", &frame.shadows);
        int cascades = int(frame.shadowCascades);
        if (ImGui::SliderInt("cascades", &cascades, 1, 4))
            frame.shadowCascades = uint32_t(cascades);
        ImGui::Checkbox("cache still shadows", &frame.shadowCaching);
        ImGui::Checkbox("shadows of lamps", &frame.lightShadows);
        comboShadowFilter(frame);
        comboContactShadows(frame);
        comboAmbientOcclusion(frame);
        ImGui::Checkbox("reflections of the screen", &frame.reflections);
        ImGui::Checkbox("bloom", &frame.bloom);
        ImGui::SliderFloat("bloom strength", &frame.bloomStrength, 0, 0.5f, "%.3f");
        bool fxaa = frame.antiAliasing == AntiAliasing::fxaa;
        if (ImGui::Checkbox("FXAA", &fxaa))
            frame.antiAliasing = fxaa ? AntiAliasing::fxaa : AntiAliasing::off;
        ImGui::Checkbox("frustum culling", &frame.frustumCulling);
        ImGui::Checkbox("occlusion culling", &frame.occlusionCulling);
        ImGui::SliderFloat("LOD error (pixels)", &frame.lodPixelError, 0, 8, "%.2f");
        comboToneMap(frame);
        editExposure(frame);
        if (settings.hasEnvironment) ImGui::Checkbox("environment", &settings.useEnvironment);
        if (settings.hasReflectionProbes)
            ImGui::Checkbox("reflection probes", &settings.useReflectionProbes);
        ImGui::SliderFloat("ambient", &settings.ambientScale, 0, 4, "%.2f");
        ImGui::SliderFloat("fog", &settings.fogScale, 0, 8, "%.2f");
        ImGui::Separator();
        bool walking = camera.mode() == CameraMode::walk;
        if (ImGui::Checkbox("walk", &walking))
            camera.setMode(walking ? CameraMode::walk : CameraMode::fly);
        ImGui::SliderFloat("flying speed", &camera.fly().speed, FlyCamera::kMinSpeed, 100,
                           "%.2f m/s", ImGuiSliderFlags_Logarithmic);
        const vec3 at = camera.pose().position;
        ImGui::Text("at %.2f %.2f %.2f", double(at.x), double(at.y), double(at.z));
    }
    ImGui::End();
}

void drawHelp() {
    if (beginPanel("keys", 440, kMargin)) {
        for (const HelpLine& line : kHelp) {
            ImGui::TextUnformatted(line.keys);
            ImGui::SameLine(120);
            ImGui::TextUnformatted(line.meaning);
        }
    }
    ImGui::End();
}

void drawProblem(const char* title, const std::string& message, uvec2 size) {
    if (message.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.35f, 0.02f, 0.02f, 0.9f));
    ImGui::PushStyleColor(ImGuiCol_TitleBg, ImVec4(0.6f, 0.05f, 0.05f, 1));
    ImGui::PushStyleColor(ImGuiCol_TitleBgActive, ImVec4(0.6f, 0.05f, 0.05f, 1));
    const float width = std::min(float(size.x) - 2 * kMargin, 760.0f);
    ImGui::SetNextWindowPos(ImVec2(0.5f * float(size.x), float(size.y) - kMargin),
                            ImGuiCond_Appearing, ImVec2(0.5f, 1));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    if (ImGui::Begin(title, nullptr,
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushTextWrapPos(width - 2 * kMargin);
        ImGui::TextUnformatted(message.data(), message.data() + message.size());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    ImGui::PopStyleColor(3);
}

}  // namespace rushlight
