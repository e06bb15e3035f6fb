// trace FILE ANSWERS [--robust]: traces a file's rays with Embree on one thread.

#include "trace.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>

#include <pmmintrin.h>
#include <xmmintrin.h>

void fail(const std::string& message) {
    std::fprintf(stderr, "error: %s\n", message.c_str());
    std::exit(1);
}

double cpu_ns() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

Words::Words(const std::string& path) : path(path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) fail(path + ": cannot be opened");
    words.resize(static_cast<size_t>(file.tellg()) / 4);
    file.seekg(0);
    file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
    if (!file) fail(path + ": cannot be read");
}

uint32_t Words::next() {
    if (at == words.size()) fail(path + ": ends after " + std::to_string(at) + " words");
    return words[at++];
}

void write_words(const std::string& path, const std::vector<uint32_t>& words) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
    file.close();
    if (!file) fail(path + ": cannot be written");
}

Scene::Scene(Words& words, bool robust) {
    const uint32_t triangles = words.next();
    for (uint64_t i = 0; i < 9 * uint64_t(triangles); ++i) vertices.push_back(float(words.next_signed()));
    device = rtcNewDevice("threads=1,user_threads=1,set_affinity=0");
    if (!device) fail("Embree has no device");
    const double start = cpu_ns();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* at = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * size_t(triangles));
    std::memcpy(at, vertices.data(), 4 * vertices.size());
    auto* corners = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles));
    for (uint32_t i = 0; i < 3 * triangles; ++i) corners[i] = i;
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("Embree refuses the scene");
    build_ns = cpu_ns() - start;
}

Scene::~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

bool Scene::has_packets16() const {
    return rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
}

int main(int count, char** arguments) {
    const bool robust = count == 4 && std::strcmp(arguments[3], "--robust") == 0;
    if (count != 3 && !robust) fail("usage: trace FILE ANSWERS [--robust]");
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    Words words(arguments[1]);
    // "SIGH", "TRAY".
    if (words.next() != 0x48474953 || words.next() != 0x59415254) fail(std::string(arguments[1]) + ": no trace file");
    const uint32_t kind = words.next();
    if (kind > 1) fail(std::string(arguments[1]) + ": rays of kind " + std::to_string(kind) + " are not known");
    Scene scene(words, robust);
    (kind == 0 ? trace_shadows : trace_ambient)(scene, words, arguments[2]);
    return 0;
}
