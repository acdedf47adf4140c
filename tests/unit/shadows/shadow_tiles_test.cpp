#include "renderer/shadows/shadow_tiles.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace rushlight {
namespace {

bool overlap(const ShadowTile& a, const ShadowTile& b) {
    return a.x < b.x + b.size && b.x < a.x + a.size && a.y < b.y + b.size && b.y < a.y + a.size;
}

TEST(ShadowTiles, AreApartAndWithinTheAtlasWhateverCameBefore) {
    Random random(1);
    ShadowTiles tiles;
    tiles.reset(2048, 64);
    std::vector<ShadowTile> held;
    uint32_t refused = 0;
    for (int step = 0; step < 4000; ++step) {
        if (!held.empty() && random.below(5) < 2) {
            const size_t i = random.below(uint32_t(held.size()));
            tiles.release(held[i]);
            held.erase(held.begin() + std::ptrdiff_t(i));
        } else {
            const uint32_t size = 64u << random.below(5);
            const auto tile = tiles.allocate(size);
            if (!tile) {
                ++refused;
                continue;
            }
            EXPECT_EQ(tile->size, size);
            EXPECT_LE(tile->x + tile->size, 2048);
            EXPECT_LE(tile->y + tile->size, 2048);
            for (const ShadowTile& other : held)
                ASSERT_FALSE(overlap(*tile, other)) << "step " << step;
            held.push_back(*tile);
        }
        uint64_t used = 0;
        for (const ShadowTile& tile : held) used += uint64_t(tile.size) * tile.size;
        ASSERT_EQ(tiles.freeTexels(), 2048u * 2048u - used);
    }
    EXPECT_GT(refused, 50u) << "the atlas was never full";
    for (const ShadowTile& tile : held) tiles.release(tile);
    EXPECT_TRUE(tiles.allocate(2048)) << "freed squares are one again";
}

TEST(ShadowTiles, TheLargestFirstFillTheAtlasToTheLastTexel) {
    ShadowTiles tiles;
    tiles.reset(1024, 64);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(tiles.allocate(512));
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(tiles.allocate(256));
    for (int i = 0; i < 32; ++i) EXPECT_TRUE(tiles.allocate(64)) << i;
    EXPECT_EQ(tiles.freeTexels(), 0u);
    EXPECT_FALSE(tiles.allocate(64));
}

}  // namespace
}  // namespace rushlight
