// Settings by path, and the functions that no file can hold.
#include <charconv>

#include "capi/objects.hpp"
#include "scenario/by_path.hpp"
#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "scenario/units.hpp"

namespace physim::capi {

constexpr char kPlainDef[] = "physim = 1\n[[shot]]\n";

Status Def::read_again() const {
  if (read_ != nullptr) return {};
  auto read = std::make_unique<Scenario>();
  if (Status status = read_scenario(document, file, Checks::of_each, *read); !status) return status;
  PHYSIM_ASSERT(!read->shots.empty());
  read_ = std::move(read);
  return {};
}

Result<std::shared_ptr<const Checked>> Def::checked() const {
  const std::unique_lock lock(mutex_);
  if (checked_ != nullptr) return checked_;
  auto made = std::make_shared<Checked>();
  if (Status status = read_scenario(document, file, Checks::together, made->scenario); !status) return status.error();
  PHYSIM_ASSERT(!made->scenario.shots.empty());
  made->scenario.environment.wind.field = wind;
  made->scenario.environment.force = field;
  if (!made->scenario.world.given && !made->scenario.things.empty()) {
    Result<Scene> scene = scene_of(made->scenario);
    if (!scene) return scene.error();
    made->scene = std::move(*scene);
  }
  return checked_ = std::move(made);
}

Status Def::set(std::string_view path, std::string_view value) {
  const Place place{std::make_shared<const std::string>(path), 0, 0};
  if (trimmed(value).empty()) return Error{"a setting without a value", std::string(path), "write \"\" for no text"};
  if (Status status = put_setting(document, path, trimmed(value), place); !status) return status;
  changed();
  return {};
}

void Def::changed() {
  const std::unique_lock lock(mutex_);
  read_.reset();
  checked_.reset();
}

Result<std::size_t> shot_in(const Scenario& scenario, const char* shot) {
  PHYSIM_ASSERT(!scenario.shots.empty());
  return index_in(scenario.shots, shot, "shot", [](const ScenarioShot& s) { return s.projectile.name; });
}

WindFunction wind_of(physim_wind_function function, void* user) {
  if (function == nullptr) return {};
  return [function, user](const WindBatch& batch) {
    PHYSIM_ASSERT(batch.time.size() == batch.position.size() && batch.velocity.size() == batch.position.size());
    const physim_wind_batch seen{batch.position.size(), batch.time.data(),
                                 same_memory<const double>(batch.position.data()),
                                 same_memory<double>(batch.velocity.data())};
    function(user, &seen);
  };
}

ForceFunction field_of(physim_field_function function, void* user) {
  if (function == nullptr) return {};
  return [function, user](const FieldForceBatch& batch) {
    PHYSIM_ASSERT(batch.mass.size() == batch.position.size() && batch.force.size() == batch.position.size());
    const physim_field_batch seen{batch.position.size(),
                                  batch.time.data(),
                                  same_memory<const double>(batch.position.data()),
                                  same_memory<const double>(batch.velocity.data()),
                                  batch.mass.data(),
                                  same_memory<double>(batch.force.data())};
    function(user, &seen);
  };
}

namespace {

void make_def(Call& call, const std::string& text, const char* file, physim_def** def) {
  auto made = std::make_shared<Def>();
  made->file = file;
  Result<Value> document = parse_document(text, file);
  if (!call.take(document)) return;
  made->document = std::move(*document);
  if (call.take(made->checked())) call.give(def, std::move(made));
}

}  // namespace
}  // namespace physim::capi

using namespace physim;
using namespace physim::capi;

physim_result physim_def_create(const char* text, const char* file, physim_def** def) {
  return guarded([&](Call& call) {
    call.need(def, "def");
    if (call.ok()) make_def(call, text != nullptr ? text : kPlainDef, file != nullptr ? file : "def", def);
  });
}

physim_result physim_def_load(const char* file, physim_def** def) {
  return guarded([&](Call& call) {
    call.need(file, "file");
    call.need(def, "def");
    if (!call.ok()) return;
    const Result<std::string> text = read_scenario_text(file);
    if (call.take(text)) make_def(call, *text, file, def);
  });
}

physim_result physim_def_copy(const physim_def* def, physim_def** copy) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(copy, "copy");
    if (call.ok()) call.give(copy, std::make_shared<Def>(*from));
  });
}

physim_result physim_set(physim_def* def, const char* path, const char* value) {
  return guarded([&](Call& call) {
    const auto into = call.find(def, "def");
    call.need(path, "path");
    call.need(value, "value");
    if (call.ok()) call.take(into->set(path, value));
  });
}

physim_result physim_set_number(physim_def* def, const char* path, double value) {
  return guarded([&](Call& call) {
    const auto into = call.find(def, "def");
    call.need(path, "path");
    call.need(!std::isnan(value), "value", "is not a number");
    if (call.ok()) call.take(into->set(path, number_text(value)));
  });
}

physim_result physim_get(const physim_def* def, const char* path, char* into, size_t room, size_t* length) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(path, "path");
    call.need_rows(into, room, "into");
    if (!call.ok()) return;
    const Result<std::string> value = from->with_read([&](Scenario& s) { return value_at(s, path); });
    if (call.take(value, PHYSIM_NOT_FOUND)) call.write_text(*value, into, room, length);
  });
}

physim_result physim_get_number(const physim_def* def, const char* path, double* value) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(path, "path");
    call.need(value, "value");
    if (!call.ok()) return;
    const Result<std::string> text = from->with_read([&](Scenario& s) { return value_at(s, path); });
    if (!call.take(text, PHYSIM_NOT_FOUND)) return;
    double number = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
    if (error != std::errc{}) return call.fail(PHYSIM_NOT_FOUND, "is " + *text + ", and no number", path);
    *value = number;
  });
}

physim_result physim_count(const physim_def* def, const char* path, size_t* count) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need(path, "path");
    call.need(count, "count");
    if (!call.ok()) return;
    const Result<std::size_t> length = from->with_read([&](Scenario& s) { return length_at(s, path); });
    if (call.take(length, PHYSIM_NOT_FOUND)) *count = *length;
  });
}

physim_result physim_check(const physim_def* def) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    if (call.ok()) call.take(from->checked());
  });
}

physim_result physim_text(const physim_def* def, char* into, size_t room, size_t* length) {
  return guarded([&](Call& call) {
    const auto from = call.find(def, "def");
    call.need_rows(into, room, "into");
    if (!call.ok()) return;
    const auto checked = from->checked();
    if (call.take(checked)) call.write_text(scenario_text((*checked)->scenario), into, room, length);
  });
}

size_t physim_setting_count(void) {
  std::size_t count = 0;
  static_cast<void>(guarded([&](Call&) { count = settings().size(); }));
  return count;
}

physim_result physim_setting_at(size_t index, physim_setting* setting) {
  return guarded([&](Call& call) {
    call.need_struct(setting, "setting");
    if (!call.ok()) return;
    const auto all = settings();
    if (index >= all.size()) return call.fail(PHYSIM_NOT_FOUND, "there are not so many settings", "index");
    const Setting& found = all[index];
    PHYSIM_ASSERT(!found.path.empty() && !found.type.empty());
    call.write(setting, {.size = 0,
                         .live = found.live,
                         .path = found.path.c_str(),
                         .type = found.type.c_str(),
                         .unit = found.unit.c_str(),
                         .default_value = found.default_value.c_str(),
                         .range = found.range.c_str(),
                         .doc = found.doc.c_str()});
  });
}

physim_result physim_set_wind_function(physim_def* def, physim_wind_function function, void* user) {
  return guarded([&](Call& call) {
    const auto into = call.find(def, "def");
    if (call.ok()) into->wind = wind_of(function, user), into->changed();
  });
}

physim_result physim_set_field_function(physim_def* def, physim_field_function function, void* user) {
  return guarded([&](Call& call) {
    const auto into = call.find(def, "def");
    if (call.ok()) into->field = field_of(function, user), into->changed();
  });
}
