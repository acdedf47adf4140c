// Black frames that users make: the right cause comes first. Frames that are only dark are let
// alone.
#include "tests/support/scenes/faulty_frames.h"
#include "tests/support/scenes/lit_frame.h"

#include <set>

namespace rushlight {
namespace {

class Diagnose : public LitFrame {
protected:
    Diagnose() : LitFrame(96, 64) {}
    static std::string told(const Diagnosis& diagnosis) {
        std::string text = std::string("the frame is ") + diagnosis.look.name();
        for (const Finding& f : diagnosis.findings)
            text += "\n    " + std::to_string(f.score) + " " + toText(f.cause) + ": " + f.evidence;
        return text;
    }
};

TEST_F(Diagnose, TheRightCauseOfFaultyFramesComesFirst) {
    size_t right = 0;
    std::set<Cause> causes;
    const auto faults = faultyFrames();
    for (const FaultyFrame& fault : faults) {
        Stage stage(*renderer);
        fault.scene(stage);
        fault.mistake(stage);
        const Diagnosis diagnosis = diagnose(*renderer, stage.frame(), stage.size);
        const bool named = !diagnosis.isFine() && diagnosis.findings[0].cause == fault.cause;
        right += named;
        causes.insert(fault.cause);
        if (!named)
            std::printf("[ MISSED ] %s: wanted %s; %s\n", fault.name, toText(fault.cause),
                        told(diagnosis).c_str());
        for (const Finding& f : diagnosis.findings) {
            EXPECT_GT(f.score, 0) << fault.name;
            EXPECT_LE(f.score, 1) << fault.name;
            for (const std::string& sentence : {f.evidence, f.suggestion})
                EXPECT_TRUE(sentence.ends_with('.')) << sentence;
        }
    }
    std::printf("%zu of %zu faults are named first\n", right, faults.size());
    EXPECT_GE(faults.size(), 40u);
    EXPECT_GE(causes.size(), 25u);
    EXPECT_GE(20 * right, 19 * faults.size());
}

TEST_F(Diagnose, HealthyFramesAreFine) {
    const auto healthy = healthyFrames();
    EXPECT_GE(healthy.size(), 10u);
    for (const HealthyFrame& frame : healthy) {
        Stage stage(*renderer);
        frame.scene(stage);
        frame.change(stage);
        const Diagnosis diagnosis = diagnose(*renderer, stage.frame(), stage.size);
        EXPECT_TRUE(diagnosis.isFine())
            << frame.name << ": " << told(diagnosis) << " brightest "
            << diagnosis.look.brightestDrawn << " range " << diagnosis.look.range;
    }
}

}  // namespace
}  // namespace rushlight
