// Scenes: things that segments are cast into.
#include "physim/scene.hpp"

#include "scenario/world_run.hpp"
#include "setup.hpp"

namespace physim::python {
namespace {

nb::dict hit_columns(const std::vector<SceneHit>& hits) {
  nb::dict out;
  out["part"] = column_of<double>(hits, [](const SceneHit& h) { return h.part; });
  out["position"] = rows_of(hits, [](const SceneHit& h) { return h.position; });
  out["normal"] = rows_of(hits, [](const SceneHit& h) { return h.normal; });
  out["time"] = column_of<double>(hits, [](const SceneHit& h) { return h.time; });
  out["velocity"] = rows_of(hits, [](const SceneHit& h) { return h.velocity; });
  out["instance"] = column_of<std::uint64_t>(hits, [](const SceneHit& h) { return number_of(h.instance); });
  out["primitive"] = column_of<std::uint32_t>(hits, [](const SceneHit& h) { return h.primitive; });
  out["material"] = column_of<std::uint32_t>(hits, [](const SceneHit& h) { return h.material.index; });
  out["entering"] = flags_of(hits, [](const SceneHit& h) { return h.entering; });
  out["inside"] = flags_of(hits, [](const SceneHit& h) { return h.starts_inside; });
  return out;
}

nb::dict first_hits(const Scene& scene, const Triples& from, const Triples& to, double radius, double time,
                    double duration, std::uint32_t layers, bool sensors, unsigned threads) {
  const std::size_t count = from.shape(0);
  check_length(to.shape(0), count, "to");
  std::vector<SceneSegment> segments(count);
  for (std::size_t i = 0; i < count; ++i)
    segments[i] = {{from(i, 0), from(i, 1), from(i, 2)}, {to(i, 0), to(i, 1), to(i, 2)}, radius, time, duration};
  std::vector<SceneHit> hits(count);
  {
    const Released free;
    const Threads pool(threads);
    scene.first_hits(segments, hits, {layers, sensors}, pool.runner());
  }
  return hit_columns(hits);
}

nb::dict all_hits(const Scene& scene, const std::vector<double>& from, const std::vector<double>& to, double time,
                  double duration) {
  return hit_columns(scene.all_hits({vec_of(from, "from"), vec_of(to, "to"), 0, time, duration}));
}

}  // namespace

void add_scene(nb::module_& m) {
  nb::class_<Scene>(m, "Scene", "Things that stand and move.")
      .def(
          "__init__", [](Scene* self, const Setup& setup) { new (self) Scene(taken(scene_of(setup.scenario))); },
          "setup"_a)
      .def("first_hits", &first_hits, "from_"_a, "to"_a, "radius"_a, "time"_a, "duration"_a, "layers"_a, "sensors"_a,
           "threads"_a, "The first hit of each of many segments.")
      .def("all_hits", &all_hits, "from_"_a, "to"_a, "time"_a, "duration"_a, "All that a segment meets.")
      .def(
          "nearest",
          [](const Scene& scene, const std::vector<double>& point, double within, double time) {
            const SceneNearest n = scene.nearest(vec_of(point, "point"), within, {}, time);
            nb::dict out;
            out["distance"] = n.distance, out["position"] = array_of(n.position);
            out["instance"] = number_of(n.instance), out["away"] = array_of(n.away);
            return out;
          },
          "point"_a, "within"_a, "time"_a, "The nearest surface.")
      .def(
          "overlaps",
          [](const Scene& scene, const std::vector<double>& middle, double radius, double time) {
            const std::vector<InstanceId> ids = scene.overlaps(vec_of(middle, "middle"), radius, {}, time);
            return column_of<std::uint64_t>(ids, [](const InstanceId& id) { return number_of(id); });
          },
          "middle"_a, "radius"_a, "time"_a, "Things that a sphere touches.")
      .def_prop_ro("size", &Scene::size, "Things that stand in it.")
      .def("hash", &Scene::hash, "Of its content.");
}

}  // namespace physim::python
