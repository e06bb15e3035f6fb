// Kind 1: from each vertex towards directions, in packets of 16 neighbouring directions of a vertex. After the triangles follow
//
//     1 word      1 to trace only directions above the vertex' tangent plane, 0 for all
//     1 word      bias: occluders are farther away than so many cells, along the direction's longest axis
//     1 word      V, then 6 V words: x y z of each vertex and of its normal, signed
//     1 word      D, then 3 D words: the directions, signed
//
// A triangle that has a corner at the vertex is met at no distance, so the bias is all that keeps it from counting. Answers: V
// words for each 32 directions; bit i % 32 of word i / 32 * V + v is set where vertex v is occluded towards direction i.

#include "trace.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace {

struct Direction {
    int32_t axes[3];
    float nearest;
};

/// Neighbours on the sphere are neighbours in this order: octant, then a Morton curve over the octant.
uint32_t place(const Direction& direction) {
    uint32_t key = 0, folded[2];
    const double length = std::abs(double(direction.axes[0])) + std::abs(double(direction.axes[1])) +
                          std::abs(double(direction.axes[2]));
    for (int axis = 0; axis < 3; ++axis) key |= uint32_t(direction.axes[axis] < 0) << axis;
    for (int axis = 0; axis < 2; ++axis) folded[axis] = uint32_t(std::abs(direction.axes[axis]) / length * 8191);
    for (int bit = 12; bit >= 0; --bit)
        for (uint32_t f : folded) key = key << 1 | (f >> bit & 1);
    return key;
}

/// Up to sixteen rays, occluded or not, as bits.
uint32_t trace16(RTCScene scene, const int32_t* from, const std::vector<Direction>& directions, const uint32_t* chosen,
                 uint32_t count) {
    alignas(64) RTCRay16 rays;
    for (uint32_t i = 0; i < 16; ++i) {
        const Direction& d = directions[chosen[std::min(i, count - 1)]];
        rays.org_x[i] = float(from[0]);
        rays.org_y[i] = float(from[1]);
        rays.org_z[i] = float(from[2]);
        rays.dir_x[i] = float(d.axes[0]);
        rays.dir_y[i] = float(d.axes[1]);
        rays.dir_z[i] = float(d.axes[2]);
        rays.tnear[i] = d.nearest;
        rays.tfar[i] = 1e30f;
    }
    return occluded16(scene, rays, count);
}

} // namespace

void trace_ambient(const Scene& scene, Words& words, const std::string& answers) {
    const bool above = words.next() != 0;
    const float bias = float(words.next());
    const uint32_t vertices = words.next();
    std::vector<int32_t> points(6 * size_t(vertices));
    for (int32_t& coordinate : points) coordinate = words.next_signed();
    std::vector<Direction> directions(words.next());
    for (Direction& d : directions) {
        for (int32_t& axis : d.axes) axis = words.next_signed();
        const int longest = std::max({std::abs(d.axes[0]), std::abs(d.axes[1]), std::abs(d.axes[2]), 1});
        d.nearest = bias / float(longest);
    }
    std::vector<uint32_t> order(directions.size()), chosen;
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return place(directions[a]) < place(directions[b]); });
    std::vector<uint32_t> occluded((directions.size() + 31) / 32 * vertices);
    uint64_t rays = 0;
    const double start = cpu_ns();
    for (uint32_t v = 0; v < vertices; ++v) {
        const int32_t* point = &points[6 * size_t(v)];
        chosen.clear();
        for (uint32_t i : order) {
            int64_t cosine = 0;
            for (int axis = 0; axis < 3; ++axis) cosine += int64_t(point[3 + axis]) * directions[i].axes[axis];
            if (!above || cosine > 0) chosen.push_back(i);
        }
        rays += chosen.size();
        for (size_t first = 0; first < chosen.size(); first += 16) {
            const uint32_t count = uint32_t(std::min<size_t>(16, chosen.size() - first));
            uint32_t bits = trace16(scene.scene, point, directions, &chosen[first], count);
            for (uint32_t i = 0; bits != 0; ++i, bits >>= 1)
                if (bits & 1) occluded[chosen[first + i] / 32 * size_t(vertices) + v] |= 1u << (chosen[first + i] % 32);
        }
    }
    const double trace_ns = cpu_ns() - start;
    write_words(answers, occluded);
    std::printf("{\"build_ns\":%.0f,\"trace_ns\":%.0f,\"vertices\":%u,\"rays\":%llu,\"packets16\":%s}\n", scene.build_ns,
                trace_ns, vertices, static_cast<unsigned long long>(rays), scene.has_packets16() ? "true" : "false");
}
