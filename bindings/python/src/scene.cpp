// Scenes: things that segments are cast into.
#include "physim/scene.hpp"

#include <nanobind/stl/tuple.h>

#include <cmath>
#include <tuple>

#include "world.hpp"

namespace physim::python {
namespace {

/// A scene, with the function of Python that answers beside it.
struct PyScene {
  Scene scene;
  std::optional<Function> engine;

  void raise_kept() const {
    if (engine) engine->raise_kept();
  }
};

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

nb::dict first_hits(const PyScene& py, const Triples& from, const Triples& to, double radius, double time,
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
    py.scene.first_hits(segments, hits, {layers, sensors}, pool.runner());
  }
  py.raise_kept();
  return hit_columns(hits);
}

nb::dict all_hits(const PyScene& py, const std::vector<double>& from, const std::vector<double>& to, double time,
                  double duration) {
  const auto hits = py.scene.all_hits({vec_of(from, "from"), vec_of(to, "to"), 0, time, duration});
  py.raise_kept();
  return hit_columns(hits);
}

void set_engine(PyScene& py, const nb::object& function, double skin) {
  EngineScene engine{.query = {}, .skin = skin};
  std::optional<Function> asked;
  if (!function.is_none()) {
    if (PyCallable_Check(function.ptr()) == 0) fail("is no function", "engine");
    asked.emplace(function);
    engine.query = engine_query(*asked);
  }
  taken(py.scene.set_engine(engine));
  py.engine = std::move(asked);
}

/// What a function of Python said: a part for each segment, NaN where nothing was met, normals and numbers of things.
void put_answers(const nb::object& answer, std::span<SceneHit> hits) {
  const auto [parts, normals, things] = nb::cast<std::tuple<Numbers, Triples, Ids>>(answer);
  check_length(parts.size(), hits.size(), "engine: part");
  check_length(normals.shape(0), hits.size(), "engine: normal");
  check_length(things.size(), hits.size(), "engine: thing");
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (std::isnan(parts(i))) continue;
    hits[i].part = parts(i);
    hits[i].normal = {normals(i, 0), normals(i, 1), normals(i, 2)};
    hits[i].instance.index = static_cast<std::uint32_t>(things(i));
  }
}

}  // namespace

EngineQuery engine_query(const Function& function) {
  return [function](const EngineBatch& batch) {
    function.call([&](const nb::object& f) {
      const auto& all = batch.segments;
      nb::dict q;
      q["start"] = rows_of(all, [](const SceneSegment& s) { return s.from; });
      q["end"] = rows_of(all, [](const SceneSegment& s) { return s.to; });
      q["radius"] = column_of<double>(all, [](const SceneSegment& s) { return s.radius; });
      q["time"] = column_of<double>(all, [](const SceneSegment& s) { return s.time; });
      q["duration"] = column_of<double>(all, [](const SceneSegment& s) { return s.duration; });
      put_answers(f(q, batch.layers), batch.hits);
    });
  };
}

void add_scene(nb::module_& m) {
  nb::class_<PyScene>(m, "Scene", "Things that stand and move.")
      .def(
          "__init__",
          [](PyScene* self, const Setup& setup) {
            new (self) PyScene{taken(scene_of(setup.scenario)), {}};
          },
          "setup"_a)
      .def("set_engine", &set_engine, "function"_a.none(), "skin"_a, "A function of Python that answers beside it.")
      .def("first_hits", &first_hits, "from_"_a, "to"_a, "radius"_a, "time"_a, "duration"_a, "layers"_a, "sensors"_a,
           "threads"_a, "The first hit of each of many segments.")
      .def("all_hits", &all_hits, "from_"_a, "to"_a, "time"_a, "duration"_a, "All that a segment meets.")
      .def(
          "nearest",
          [](const PyScene& py, const std::vector<double>& point, double within, double time) {
            const SceneNearest n = py.scene.nearest(vec_of(point, "point"), within, {}, time);
            nb::dict out;
            out["distance"] = n.distance, out["position"] = array_of(n.position);
            out["instance"] = number_of(n.instance), out["away"] = array_of(n.away);
            return out;
          },
          "point"_a, "within"_a, "time"_a, "The nearest surface.")
      .def(
          "overlaps",
          [](const PyScene& py, const std::vector<double>& middle, double radius, double time) {
            const std::vector<InstanceId> ids = py.scene.overlaps(vec_of(middle, "middle"), radius, {}, time);
            return column_of<std::uint64_t>(ids, [](const InstanceId& id) { return number_of(id); });
          },
          "middle"_a, "radius"_a, "time"_a, "Things that a sphere touches.")
      .def_prop_ro(
          "size", [](const PyScene& py) { return py.scene.size(); }, "Things that stand in it.")
      .def(
          "hash", [](const PyScene& py) { return py.scene.hash(); }, "Of its content.");
}

}  // namespace physim::python
