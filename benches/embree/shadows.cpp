// Kind 0: from each receiver to each sample of a light, in packets of 16 samples. After the triangles follow
//
//     7 words   receivers: x, y, step along x, step along y, height, then columns and rows
//     6 words   samples: x, y, step along x, step along y, columns and rows; their number is a multiple of 32
//
// Only receivers in the shadow's box are traced, as a careful user would: the box of all vertices projected from the corners
// of the light. Answers: for each receiver, row after row, samples / 32 words; bit s % 32 of word s / 32 is set where sample s is
// hidden.

#include "trace.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

struct Lattice {
    int32_t origin[2];
    int32_t step[2];
    int32_t height = 0;
    uint32_t columns, rows;

    Lattice(Words& words, bool has_height) {
        for (int32_t& o : origin) o = words.next_signed();
        for (int32_t& s : step) s = words.next_signed();
        if (has_height) height = words.next_signed();
        columns = words.next();
        rows = words.next();
    }
    float at(int axis, uint32_t i) const { return float(origin[axis] + step[axis] * int32_t(i)); }
    uint32_t count(int axis) const { return axis == 0 ? columns : rows; }
};

struct Range {
    uint32_t first, end;
};

/// Receivers along one axis that any vertex can shade, one more on either side.
Range box(const std::vector<float>& vertices, const Lattice& receivers, const Lattice& samples, int axis) {
    double least = INFINITY, most = -INFINITY;
    const double height = receivers.height;
    for (size_t v = 0; v < vertices.size(); v += 3) {
        const double z = vertices[v + 2];
        for (double s : {samples.at(axis, 0), samples.at(axis, samples.count(axis) - 1)}) {
            const double x = s + (vertices[v + axis] - s) * (height / z);
            least = std::min(least, x);
            most = std::max(most, x);
        }
    }
    const auto index = [&](double x) { return (x - receivers.origin[axis]) / receivers.step[axis]; };
    const double count = receivers.count(axis);
    return {uint32_t(std::clamp(std::floor(index(least)), 0.0, count)),
            uint32_t(std::clamp(std::ceil(index(most)) + 1, 0.0, count))};
}

/// Sixteen samples from s on, hidden from the receiver or not, as bits.
uint32_t trace16(RTCScene scene, const float receiver[3], const std::vector<float>& offsets, uint32_t s) {
    alignas(64) RTCRay16 rays;
    for (uint32_t i = 0; i < 16; ++i) {
        rays.org_x[i] = receiver[0];
        rays.org_y[i] = receiver[1];
        rays.org_z[i] = receiver[2];
        rays.dir_x[i] = offsets[2 * (s + i)] - receiver[0];
        rays.dir_y[i] = offsets[2 * (s + i) + 1] - receiver[1];
        rays.dir_z[i] = -receiver[2];
        rays.tnear[i] = 0;
        rays.tfar[i] = 1;
    }
    return occluded16(scene, rays, 16);
}

} // namespace

void trace_shadows(const Scene& scene, Words& words, const std::string& answers) {
    const Lattice receivers(words, true), samples(words, false);
    const uint32_t count = samples.columns * samples.rows;
    if (count % 32 != 0 || receivers.height <= 0) fail("no light of whole words, or no height");
    const size_t per_set = count / 32;
    std::vector<uint32_t> hidden(size_t(receivers.columns) * receivers.rows * per_set);
    const double start = cpu_ns();
    std::vector<float> offsets;
    for (uint32_t s = 0; s < count; ++s) {
        offsets.push_back(samples.at(0, s % samples.columns));
        offsets.push_back(samples.at(1, s / samples.columns));
    }
    const Range columns = box(scene.vertices, receivers, samples, 0), rows = box(scene.vertices, receivers, samples, 1);
    for (uint32_t y = rows.first; y < rows.end; ++y) {
        for (uint32_t x = columns.first; x < columns.end; ++x) {
            const float receiver[3] = {receivers.at(0, x), receivers.at(1, y), float(receivers.height)};
            const size_t set = (size_t(y) * receivers.columns + x) * per_set;
            for (uint32_t s = 0; s < count; s += 16)
                hidden[set + s / 32] |= trace16(scene.scene, receiver, offsets, s) << (s % 32);
        }
    }
    const double trace_ns = cpu_ns() - start;
    write_words(answers, hidden);
    const uint64_t traced = uint64_t(columns.end - columns.first) * (rows.end - rows.first);
    std::printf("{\"build_ns\":%.0f,\"trace_ns\":%.0f,\"receivers\":%llu,\"rays\":%llu,\"packets16\":%s}\n", scene.build_ns,
                trace_ns, static_cast<unsigned long long>(traced), static_cast<unsigned long long>(traced * count),
                scene.has_packets16() ? "true" : "false");
}
