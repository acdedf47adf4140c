#pragma once
// A renderer on whichever offscreen context works here; tests are skipped where none does.

#include "engine/jobs/tbb_jobs.h"
#include "renderer/context/context.h"
#include "renderer/renderer.h"

#include <gtest/gtest.h>

#include <memory>

namespace rushlight {

class OffscreenRenderer : public testing::Test {
protected:
    void SetUp() override {
        auto made = createOffscreenContext(ContextChoice::automatic, {});
        if (!made) GTEST_SKIP() << made.error().text();
        context = std::move(*made);
        jobs = createTbbJobs(0);
        RendererDesc desc;
        desc.loadGl = context->loader();
        desc.jobs = jobs.get();
        renderer = std::move(Renderer::create(desc).value());
    }

    std::unique_ptr<Context> context;
    std::unique_ptr<JobSystem> jobs;
    std::unique_ptr<Renderer> renderer;
};

}  // namespace rushlight
