// Embree 3 as a contestant, used as its manual says: one device, one scene of one triangle
// geometry, single rays or arrays of them (streams). The mesh's own arrays are shared, not copied;
// Embree wants four readable bytes behind the last vertex, so a padded copy of the vertices is made
// before the clock starts. Its memory monitor counts all that the device allocates.
//
// A device limits the threads of the *process* while it lives, through oneTBB's global control: so
// all contestants of one time must have the same number of threads.

#include "coppice/base/error.h"
#include "coppice/base/timer.h"

#include "tracers/contestant.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <vector>

namespace coppice::lab {

namespace {

struct Settings {
    RTCBuildQuality quality;
    RTCSceneFlags flags;
};

/// What a device has allocated.
class DeviceMemory {
public:
    /// Embree's callback; `bytes` is negative for what is freed.
    static bool on_change(void* self, ssize_t bytes, bool /*post*/) {
        static_cast<DeviceMemory*>(self)->change(bytes);
        return true;
    }

    void restart_peak() noexcept { peak_ = held_.load(); }

    [[nodiscard]] std::int64_t held_bytes() const noexcept { return held_; }

    [[nodiscard]] std::int64_t peak_bytes() const noexcept { return peak_; }

private:
    void change(std::int64_t bytes) noexcept {
        const std::int64_t held = held_.fetch_add(bytes) + bytes;
        std::int64_t peak = peak_;
        while (held > peak && !peak_.compare_exchange_weak(peak, held)) {
        }
    }

    std::atomic<std::int64_t> held_{0};
    std::atomic<std::int64_t> peak_{0};
};

RTCRay embree_ray(const Ray& ray) noexcept {
    return {.org_x = ray.origin.x,
            .org_y = ray.origin.y,
            .org_z = ray.origin.z,
            .tnear = ray.t_min,
            .dir_x = ray.direction.x,
            .dir_y = ray.direction.y,
            .dir_z = ray.direction.z,
            .time = 0.0F,
            .tfar = ray.t_max,
            .mask = std::numeric_limits<unsigned>::max(),
            .id = 0,
            .flags = 0};
}

RTCRayHit embree_query(const Ray& ray) noexcept {
    RTCRayHit query{};
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return query;
}

Hit hit_of(const RTCRayHit& query) noexcept {
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.ray.tfar, query.hit.u, query.hit.v, query.hit.primID};
}

std::uint8_t flag_of(const RTCRay& query) noexcept {
    return query.tfar < 0.0F ? 1 : 0;  // -inf if occluded
}

unsigned count_of(std::span<const Ray> rays) noexcept {
    return static_cast<unsigned>(rays.size());
}

void require_no_error(RTCDevice device, const char* what) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) {
        throw Error(ErrorCode::out_of_memory, fmt::format("Embree, {}: out of memory", what));
    }
    throw Error(ErrorCode::unsupported,
                fmt::format("Embree, {}: error {}", what, static_cast<int>(error)));
}

RTCIntersectContext context_for(Queries queries) noexcept {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (queries == Queries::coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

class EmbreeContestant final : public Contestant {
public:
    EmbreeContestant(Settings settings, int threads)
        : settings_(settings),
          device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
        require_no_error(device_, "its device");
        rtcSetDeviceMemoryMonitorFunction(device_, &DeviceMemory::on_change, &memory_);
    }

    ~EmbreeContestant() override {
        clear();
        rtcReleaseDevice(device_);
    }

    EmbreeContestant(const EmbreeContestant&) = delete;
    EmbreeContestant& operator=(const EmbreeContestant&) = delete;

    BuildFigures build(TriangleMeshView mesh, bool /*is_measured*/) override {
        share_vertices(mesh);
        memory_.restart_peak();
        const std::int64_t before = memory_.held_bytes();
        const Timer wall;
        const CpuTimer cpu;
        scene_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene_, settings_.quality);
        rtcSetSceneFlags(scene_, settings_.flags);
        attach(mesh);
        rtcCommitScene(scene_);
        require_no_error(device_, "its build");
        BuildFigures figures{.wall_seconds = wall.seconds(), .cpu_seconds = cpu.seconds()};
        figures.bytes = static_cast<std::uint64_t>(memory_.held_bytes() - before);
        figures.peak_bytes = static_cast<std::uint64_t>(memory_.peak_bytes() - before);
        return figures;
    }

    void clear() noexcept override {
        if (scene_ != nullptr) rtcReleaseScene(scene_);
        scene_ = nullptr;
    }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits,
                   Queries queries) const noexcept override {
        trace<rtcIntersect1, rtcIntersect1M>(rays, hits, queries, embree_query, hit_of);
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> flags,
                  Queries queries) const noexcept override {
        trace<rtcOccluded1, rtcOccluded1M>(rays, flags, queries, embree_ray, flag_of);
    }

private:
    /// Makes each ray's query, has Embree answer them one by one or all at once, and reads them.
    template <auto trace_one, auto trace_many, typename Answer, typename MakeQuery,
              typename ReadAnswer>
    void trace(std::span<const Ray> rays, std::span<Answer> answers, Queries queries,
               MakeQuery make_query, ReadAnswer read_answer) const noexcept {
        RTCIntersectContext context = context_for(queries);
        if (queries == Queries::single) {
            for (std::size_t i = 0; i < rays.size(); ++i) {
                auto query = make_query(rays[i]);
                trace_one(scene_, &context, &query);
                answers[i] = read_answer(query);
            }
            return;
        }
        std::vector<decltype(make_query(rays[0]))> stream(rays.size());
        std::transform(rays.begin(), rays.end(), stream.begin(), make_query);
        trace_many(scene_, &context, stream.data(), count_of(rays), sizeof(stream[0]));
        std::transform(stream.begin(), stream.end(), answers.begin(), read_answer);
    }

    void share_vertices(TriangleMeshView mesh) {
        if (shared_of_ == mesh.vertices().data()) return;
        vertices_.assign(mesh.vertices().begin(), mesh.vertices().end());
        vertices_.emplace_back();
        shared_of_ = mesh.vertices().data();
    }

    void attach(TriangleMeshView mesh) const {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   vertices_.data(), 0, sizeof(Vec3f), mesh.vertices().size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles().data(), 0, sizeof(TriangleIndices),
                                   mesh.triangles().size());
        rtcSetGeometryBuildQuality(geometry, settings_.quality);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    Settings settings_;
    DeviceMemory memory_;  // outlives the device
    RTCDevice device_;
    RTCScene scene_ = nullptr;
    std::vector<Vec3f> vertices_;
    const Vec3f* shared_of_ = nullptr;
};

template <RTCBuildQuality quality, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE>
std::unique_ptr<Contestant> make(int threads) {
    return std::make_unique<EmbreeContestant>(Settings{quality, flags}, threads);
}

}  // namespace

std::span<const Peer> peer_registry() {
    static constexpr std::array peers{
        Peer{"embree-low", "Embree's low quality (Morton codes)", make<RTC_BUILD_QUALITY_LOW>},
        Peer{"embree-medium", "Embree's medium quality (binned), its default",
             make<RTC_BUILD_QUALITY_MEDIUM>},
        Peer{"embree-high", "Embree's high quality (spatial splits)", make<RTC_BUILD_QUALITY_HIGH>},
        Peer{"embree-robust", "Embree's high quality, robust: it builds as for medium then",
             make<RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_ROBUST>},
    };
    return peers;
}

}  // namespace coppice::lab
