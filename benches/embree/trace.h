// What all kinds of trace files share: reading, the scene, CPU time.
//
// A trace file is a sequence of little-endian 32-bit words:
//
//     words 0, 1   "SIGHTRAY"
//     word 2       kind: 0 for soft shadows (shadows.cpp), 1 for ambient occlusion (ambient.cpp)
//     word 3       T, the number of triangles
//     9 T words    vertices, x y z each, signed, in cells of the grid
//     the rest     as the kind says
//
// Coordinates are below 2^15 in magnitude, so f32 holds them. Answers go to a second file; times and counts go to standard
// output as one JSON object.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#if EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/// A file's words, read from the front; ends the program with a message where they run out.
class Words {
public:
    explicit Words(const std::string& path);
    uint32_t next();
    int32_t next_signed() { return static_cast<int32_t>(next()); }

private:
    std::string path;
    std::vector<uint32_t> words;
    size_t at = 0;
};

/// Ends the program with exit code 1.
[[noreturn]] void fail(const std::string& message);

/// CPU time of this process, in nanoseconds.
double cpu_ns();

/// Writes words, or fails.
void write_words(const std::string& path, const std::vector<uint32_t>& words);

/// Triangles in an acceleration structure of one thread.
struct Scene {
    std::vector<float> vertices;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double build_ns = 0;

    /// `robust` asks for watertight intersections, which are slower.
    Scene(Words& words, bool robust);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    /// Whether packets of 16 rays are traced as such.
    bool has_packets16() const;
};

/// Which of the first `count` rays of a packet are occluded, as bits; the caller sets origins, directions and ranges.
inline uint32_t occluded16(RTCScene scene, RTCRay16& rays, uint32_t count) {
    alignas(64) int valid[16];
    for (uint32_t i = 0; i < 16; ++i) {
        valid[i] = i < count ? -1 : 0;
        rays.time[i] = 0;
        rays.mask[i] = ~0u;
        rays.id[i] = 0;
        rays.flags[i] = 0;
    }
#if EMBREE >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded16(valid, scene, &rays, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid, scene, &context, &rays);
#endif
    uint32_t occluded = 0;
    for (uint32_t i = 0; i < count; ++i) occluded |= uint32_t(rays.tfar[i] < 0) << i;
    return occluded;
}

/// Traces a file of kind 0 from its word after the triangles, and prints the object.
void trace_shadows(const Scene& scene, Words& words, const std::string& answers);

/// The same for kind 1.
void trace_ambient(const Scene& scene, Words& words, const std::string& answers);
