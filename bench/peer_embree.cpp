// Embree 3: rays one by one, or sixteen at a time; meshes as instances of one scene.
#include "cast_peers.hpp"

#if PHYSIM_BENCH_EMBREE
#include <embree3/rtcore.h>

#include <cmath>
#include <cstring>

namespace physim::bench {
namespace {

class EmbreeCasts final : public CastPeer {
 public:
  EmbreeCasts(const CastMesh& mesh, const std::vector<CastPlace>& places, bool packets)
      : packets_(packets), device_(rtcNewDevice("threads=1")), scene_(mesh_scene(mesh)) {
    if (places.empty()) return;
    shared_ = scene_;
    scene_ = rtcNewScene(device_);
    for (const CastPlace& place : places) {
      RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, shared_);
      const float columns[12] = {
          place.cosine,     0, -place.sine, 0, 1, 0, place.sine, 0, place.cosine, place.position[0], place.position[1],
          place.position[2]};
      rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
      rtcCommitGeometry(instance);
      rtcAttachGeometry(scene_, instance);
      rtcReleaseGeometry(instance);
    }
    rtcCommitScene(scene_);
  }
  ~EmbreeCasts() override {
    rtcReleaseScene(scene_);
    if (shared_) rtcReleaseScene(shared_);
    rtcReleaseDevice(device_);
  }
  EmbreeCasts(const EmbreeCasts&) = delete;
  EmbreeCasts& operator=(const EmbreeCasts&) = delete;

  void cast(const std::vector<CastSegment>& segments, std::vector<float>& parts) override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (packets_) return cast_packets(context, segments, parts);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const CastSegment& s = segments[i];
      RTCRayHit ray{};
      ray.ray = {s.from[0], s.from[1], s.from[2], 0, s.to[0] - s.from[0], s.to[1] - s.from[1], s.to[2] - s.from[2], 0,
                 1,         ~0u,       0,         0};
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &ray);
      parts[i] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 2 : ray.ray.tfar;
    }
  }

 private:
  RTCScene mesh_scene(const CastMesh& mesh) {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::memcpy(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size() / 3),
        mesh.vertices.data(), mesh.vertices.size() * sizeof(float));
    std::memcpy(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size() / 3),
        mesh.triangles.data(), mesh.triangles.size() * sizeof(std::uint32_t));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
  }
  void cast_packets(RTCIntersectContext& context, const std::vector<CastSegment>& segments, std::vector<float>& parts) {
    alignas(64) RTCRayHit16 packet;
    alignas(64) int valid[16];
    for (std::size_t first = 0; first < segments.size(); first += 16) {
      for (std::size_t lane = 0; lane < 16; ++lane) {
        const CastSegment& s = segments[std::min(first + lane, segments.size() - 1)];
        valid[lane] = first + lane < segments.size() ? -1 : 0;
        packet.ray.org_x[lane] = s.from[0], packet.ray.org_y[lane] = s.from[1], packet.ray.org_z[lane] = s.from[2];
        packet.ray.dir_x[lane] = s.to[0] - s.from[0], packet.ray.dir_y[lane] = s.to[1] - s.from[1];
        packet.ray.dir_z[lane] = s.to[2] - s.from[2];
        packet.ray.tnear[lane] = packet.ray.time[lane] = 0, packet.ray.tfar[lane] = 1;
        packet.ray.mask[lane] = ~0u, packet.ray.flags[lane] = packet.ray.id[lane] = 0;
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid, scene_, &context, &packet);
      for (std::size_t lane = 0; lane < 16 && first + lane < segments.size(); ++lane)
        parts[first + lane] = packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? 2 : packet.ray.tfar[lane];
    }
  }

  bool packets_;
  RTCDevice device_;
  RTCScene scene_, shared_ = nullptr;
};

}  // namespace

std::unique_ptr<CastPeer> embree_scene(const CastMesh& mesh, const std::vector<CastPlace>& places, bool packets) {
  return std::make_unique<EmbreeCasts>(mesh, places, packets);
}

}  // namespace physim::bench

#else

namespace physim::bench {

std::unique_ptr<CastPeer> embree_scene(const CastMesh&, const std::vector<CastPlace>&, bool) { return nullptr; }

}  // namespace physim::bench

#endif
