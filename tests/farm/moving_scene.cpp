// moving_scene TESTCARD_DIR DIR: writes the moving test card into DIR.

#include "tests/support/scenes/moving_scene.h"

#include <cstdio>

int main(int count, char** arguments) {
    if (count != 3) {
        std::fputs("usage: moving_scene TESTCARD_DIR DIR\n", stderr);
        return 2;
    }
    rushlight::writeMovingScene(arguments[1], arguments[2]);
    return 0;
}
