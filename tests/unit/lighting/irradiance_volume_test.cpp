#include "renderer/lighting/irradiance_volume.h"

#include "interop/irradiance_volume.h"
#include "tests/support/probe_distances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rushlight {
namespace {

IrradianceVolume randomVolume(glm::uvec3 counts) {
    Random random(7);
    ProbeGrid grid;
    grid.origin = {-1, 2, -3};
    grid.spacing = {0.5f, 1, 2};
    grid.counts = counts;
    IrradianceVolume volume = makeIrradianceVolume(grid);
    for (uint32_t i = 0; i < grid.count(); ++i) {
        IrradianceProbe p;
        p.mean = random.vector(0.5f, 2);
        for (int c = 0; c < 3; ++c) p.flow[c] = random.direction() * (p.mean[c] * 0.7f);
        p.offset = random.vector(-0.1f, 0.1f);
        volume.setProbe(i, p);
        seeSmoothly(volume, i, random, 4, 8);
    }
    return volume;
}

TEST(IrradianceVolume, FourCornersAroundAPointInterpolateALinearFieldExactly) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        vec3 f = random.vector(0, 1);
        if (i % 5 == 0) f = glm::floor(f * 3.0f) / 2.0f;  // ties, edges and corners
        const interop::ProbeCorners c = interop::probeCorners(f);
        const vec3 at = c.second * c.shares.y + c.third * c.shares.z + vec3(1) * c.shares.w;
        EXPECT_LT(glm::distance(at, f), 1e-6f);
        EXPECT_NEAR(c.shares.x + c.shares.y + c.shares.z + c.shares.w, 1, 1e-6f);
        for (int k = 0; k < 4; ++k) EXPECT_GE(c.shares[k], -1e-6f);
        EXPECT_EQ(c.second.x + c.second.y + c.second.z, 1);
        EXPECT_EQ(c.third.x + c.third.y + c.third.z, 2);
        for (int k = 0; k < 3; ++k) EXPECT_GE(c.third[k], c.second[k]);
    }
}

TEST(IrradianceVolume, LightOfHalfTheSphereIsExact) {
    const vec3 up(0, 1, 0);
    for (float angle = 0; angle < kPi; angle += 0.1f) {
        const vec3 n(std::sin(angle), std::cos(angle), 0);
        EXPECT_NEAR(interop::irradianceShape(0.5f * up, n), 1 + n.y, 1e-5f);
        EXPECT_NEAR(interop::irradianceShape(0.5001f * up, n), 1 + n.y, 1e-3f);
    }
}

// The mean over all normals is the mean radiance; from one direction alone it is 4 times that at
// most.
TEST(IrradianceVolume, TheShapeOfIrradianceKeepsItsEnergy) {
    for (const float r : {0.0f, 0.3f, 0.7f, 0.99f}) {
        const vec3 axis = glm::normalize(vec3(1, 2, -1)), direction = r * axis;
        double sum = 0, along = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i) {
            const float z = 1 - (2 * float(i) + 1) / float(n), phi = float(i) * 2.3999632f;
            const float ring = std::sqrt(1 - z * z);
            const vec3 d(ring * std::cos(phi), ring * std::sin(phi), z);
            const float shape = interop::irradianceShape(direction, d);
            EXPECT_GE(shape, 0);
            EXPECT_LE(shape, 4.001f);
            sum += double(shape);
            along += double(shape * glm::dot(d, axis));
        }
        EXPECT_NEAR(sum / n, 1, 1e-3);
        EXPECT_NEAR(along / n, double(r) * 2 / 3, 0.07 * double(r) + 1e-3);  // nearly the second
                                                                             // band's
    }
}

TEST(IrradianceVolume, ProbesArePackedWithinTheirPrecision) {
    const IrradianceVolume v = randomVolume({3, 2, 2});
    IrradianceVolume again = makeIrradianceVolume(v.grid);
    for (uint32_t i = 0; i < v.grid.count(); ++i) again.setProbe(i, v.probe(i));
    EXPECT_EQ(again.records, v.records);
}

TEST(IrradianceVolume, IsSmoothAndFadesOutBeyondItsBorder) {
    const IrradianceVolume v = randomVolume({4, 4, 4});
    const vec3 n = glm::normalize(vec3(1, 1, 1));
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const vec3 a = random.vector(-0.8f, 0.2f) + vec3(0, 4, 0), d = random.direction();
        vec3 last(sampleIrradiance(v, a, n));
        for (int k = 1; k < 400; ++k) {
            const vec3 now(sampleIrradiance(v, a + d * (float(k) * 1e-3f), n));
            EXPECT_LT(glm::distance(now, last), 0.2f);
            last = now;
        }
    }
    EXPECT_EQ(sampleIrradiance(v, v.grid.origin, n).w, 1);
    EXPECT_EQ(sampleIrradiance(v, v.grid.origin - vec3(0.24f, 0, 0), n).w, 1);
    EXPECT_NEAR(sampleIrradiance(v, v.grid.origin - vec3(0.375f, 0, 0), n).w, 0.5f, 1e-5f);
    EXPECT_EQ(sampleIrradiance(v, v.grid.origin - vec3(0.5f, 0, 0), n).w, 0);
}

TEST(IrradianceVolume, TheAtlasRepeatsWhatLiesBeyondEachSquare) {
    const IrradianceVolume v = randomVolume({300, 1, 1});
    const ProbeAtlas atlas = makeProbeAtlas(v);
    EXPECT_EQ(atlas.width, 256u * 18);
    EXPECT_EQ(atlas.height, 2u * 18);
    const auto texel = [&](uint32_t probe, uint32_t x, uint32_t y) {
        return atlas.texels[(probe / 256 * 18 + y) * atlas.width + probe % 256 * 18 + x];
    };
    const auto of = [&](uint32_t probe, uint32_t x, uint32_t y) {
        return v.distances[probe * 256 + y * 16 + x];
    };
    EXPECT_EQ(texel(257, 1, 1), of(257, 0, 0));
    EXPECT_EQ(texel(257, 16, 3), of(257, 15, 2));
    // Over an edge the square goes on mirrored about the edge's middle; at a corner all four meet.
    EXPECT_EQ(texel(5, 0, 3), of(5, 0, 13));
    EXPECT_EQ(texel(5, 2, 17), of(5, 14, 15));
    EXPECT_EQ(texel(5, 0, 0), of(5, 15, 15));
}

TEST(IrradianceVolume, AFileIsReadAsItWasWritten) {
    const IrradianceVolume v = randomVolume({5, 4, 3});
    const std::vector<std::byte> bytes = encodeIrradianceVolume(v);
    const auto read = decodeIrradianceVolume(bytes, "file");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->records, v.records);
    EXPECT_EQ(read->distances, v.distances);
    EXPECT_EQ(read->grid.counts, v.grid.counts);
    EXPECT_EQ(read->grid.origin, v.grid.origin);
    EXPECT_EQ(read->grid.spacing, v.grid.spacing);
}

TEST(IrradianceVolume, ADamagedFileIsRefusedWithAReason) {
    const std::vector<std::byte> good = encodeIrradianceVolume(randomVolume({3, 2, 2}));
    for (size_t i = 0; i < good.size(); i += i < 128 ? 1 : 7)
        for (const int bit : {0, 3, 7}) {
            std::vector<std::byte> bad = good;
            bad[i] ^= std::byte(1 << bit);
            const auto read = decodeIrradianceVolume(bad, "probes.bin");
            ASSERT_FALSE(read) << i;
            EXPECT_EQ(read.error().object, "probes.bin");
            EXPECT_FALSE(read.error().message.empty());
        }
    for (size_t length = 0; length < good.size(); length += 13)
        EXPECT_FALSE(decodeIrradianceVolume(std::span(good).first(length), "file"));
    std::vector<std::byte> longer = good;
    longer.push_back(std::byte(0));
    EXPECT_FALSE(decodeIrradianceVolume(longer, "file"));
}

TEST(IrradianceVolume, WhatIsNotANumberIsRefused) {
    IrradianceVolume v = randomVolume({2, 2, 2});
    EXPECT_TRUE(checkIrradianceVolume(v, "volume"));
    v.records[3].y |= 0x7c00u;
    EXPECT_FALSE(checkIrradianceVolume(v, "volume"));
    EXPECT_FALSE(decodeIrradianceVolume(encodeIrradianceVolume(v), "volume"));
    v = randomVolume({2, 2, 2});
    v.grid.spacing.y = 0;
    EXPECT_FALSE(checkIrradianceVolume(v, "volume"));
    v = randomVolume({2, 2, 2});
    v.grid.counts.x = 3;
    EXPECT_FALSE(checkIrradianceVolume(v, "volume"));
}

}  // namespace
}  // namespace rushlight
