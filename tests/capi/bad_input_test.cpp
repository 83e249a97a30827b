// Bad input through each function of the C interface: null, freed and foreign handles, null pointers, structs of size
// 0, numbers that are none. Each is refused by a code, and nothing crashes.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "of_all.hpp"
#include "physim/physim.h"

namespace physim::capi_bad_input_test {

struct Handles {
  physim_def* def = nullptr;
  physim_flight* flight = nullptr;
  physim_world* world = nullptr;
  physim_snapshot* snapshot = nullptr;
  physim_scene* scene = nullptr;
  physim_bytes* bytes = nullptr;
  physim_pool* pool = nullptr;
  physim_study* study = nullptr;
  physim_part* part = nullptr;
  physim_figures* figures = nullptr;

  template <class F>
  void each(const F& f) {
    f(def), f(flight), f(world), f(snapshot), f(scene), f(bytes), f(pool), f(study), f(part), f(figures);
  }
};

Handles made() {
  Handles h;
  const auto done = [](physim_result code) { ASSERT_EQ(code, PHYSIM_OK) << physim_last_error(); };
  done(physim_def_create(test::kOfAll, "bad.toml", &h.def));
  done(physim_fly(h.def, nullptr, nullptr, &h.flight));
  done(physim_world_create(h.def, PHYSIM_FIRE_NOTHING, &h.world));
  done(physim_world_snapshot(h.world, &h.snapshot));
  done(physim_scene_create(h.def, &h.scene));
  done(physim_save(h.world, &h.bytes));
  done(physim_pool_create(1, &h.pool));
  done(physim_study_create(h.def, nullptr, &h.study));
  done(physim_study_fly(h.study, 0, 1, nullptr, &h.part));
  done(physim_study_figures(h.study, h.part, 1, &h.figures));
  return h;
}

/// What calls are made with.
struct Given {
  Handles h;
  bool null_pointers = false, no_sizes = false, no_numbers = false;

  /// A pointer to room for anything.
  template <class T>
  T* at() const {
    static T room[16];
    if constexpr (requires { room[0].size; }) room[0].size = no_sizes ? 0 : sizeof(T);
    return null_pointers ? nullptr : room;
  }
  [[nodiscard]] double number(double usual) const {
    return no_numbers ? std::numeric_limits<double>::quiet_NaN() : usual;
  }
  [[nodiscard]] const char* text(const char* usual) const { return null_pointers ? nullptr : usual; }
};

/// What is wrong with each call.
enum Bad : unsigned { kHandle = 1, kPointer = 2, kSize = 4, kNumber = 8 };

struct Try {
  const char* name;
  unsigned bad;
  std::function<physim_result(const Given&)> call;
};

#define TRY(name, bad, ...)                                                       \
  Try {                                                                           \
#name, bad, [](const Given& g) -> physim_result { return name(__VA_ARGS__); } \
  }

const std::vector<Try>& all_calls() {
  static const physim_id id{1, 1};
  static const double place[3] = {0, 0, 0};
  static const char* const preset = "game";
  static const std::vector<Try> calls = {
      TRY(physim_bytes_data, kHandle | kPointer, g.h.bytes, g.at<const void*>(), g.at<std::size_t>()),
      TRY(physim_save, kHandle | kPointer, g.h.world, g.at<physim_bytes*>()),
      TRY(physim_pool_create, kPointer, 1, g.at<physim_pool*>()),
      TRY(physim_def_create, kPointer, nullptr, nullptr, g.at<physim_def*>()),
      TRY(physim_def_load, kPointer, g.text("nothing"), g.at<physim_def*>()),
      TRY(physim_def_copy, kHandle | kPointer, g.h.def, g.at<physim_def*>()),
      TRY(physim_set, kHandle | kPointer, g.h.def, g.text("mass"), "1 kg"),
      TRY(physim_set_number, kHandle | kPointer | kNumber, g.h.def, g.text("mass"), g.number(1)),
      TRY(physim_get, kHandle | kPointer, g.h.def, g.text("mass"), g.at<char>(), 16, nullptr),
      TRY(physim_get_number, kHandle | kPointer, g.h.def, "mass", g.at<double>()),
      TRY(physim_count, kHandle | kPointer, g.h.def, "shot", g.at<std::size_t>()),
      TRY(physim_check, kHandle, g.h.def),
      TRY(physim_text, kHandle | kPointer, g.h.def, g.at<char>(), 16, nullptr),
      TRY(physim_setting_at, kPointer | kSize, 0, g.at<physim_setting>()),
      TRY(physim_set_wind_function, kHandle, g.h.def, nullptr, nullptr),
      TRY(physim_set_field_function, kHandle, g.h.def, nullptr, nullptr),
      TRY(physim_fly, kHandle | kPointer, g.h.def, nullptr, nullptr, g.at<physim_flight*>()),
      TRY(physim_flight_read, kHandle | kPointer | kSize, g.h.flight, g.at<physim_flight_info>()),
      TRY(physim_flight_at, kHandle | kPointer | kSize | kNumber, g.h.flight, PHYSIM_AT_TIME, g.number(0),
          g.at<physim_sample>()),
      TRY(physim_flight_jerk, kHandle | kPointer | kNumber, g.h.flight, g.number(0), g.at<double>()),
      TRY(physim_flight_samples, kHandle | kPointer | kSize, g.h.flight, nullptr, 4, g.at<physim_samples>()),
      TRY(physim_flight_events, kHandle | kPointer, g.h.flight, 0, g.at<physim_event>(), sizeof(physim_event), 4,
          g.at<std::size_t>()),
      TRY(physim_flight_notes, kHandle | kPointer, g.h.flight, g.at<char>(), 16, nullptr),
      TRY(physim_batch, kHandle | kPointer | kSize, g.h.def, nullptr, 4, nullptr, nullptr, g.at<physim_ends>(), nullptr,
          nullptr),
      TRY(physim_world_create, kHandle | kPointer, g.h.def, PHYSIM_FIRE_NOTHING, g.at<physim_world*>()),
      TRY(physim_world_read, kHandle | kPointer | kSize, g.h.world, g.at<physim_world_info>()),
      TRY(physim_world_hash, kHandle | kPointer, g.h.world, g.at<std::uint64_t>()),
      TRY(physim_world_set_environment, kHandle, g.h.world, 0, g.h.def),
      TRY(physim_world_add_environment, kHandle | kPointer, g.h.world, g.h.def, g.at<std::uint32_t>()),
      TRY(physim_world_set_detail, kHandle, g.h.world, g.h.def),
      TRY(physim_world_do, kHandle | kNumber, g.h.world, PHYSIM_TIME_SCALE, g.number(1)),
      TRY(physim_world_rest, kHandle | kPointer, g.h.world, g.at<physim_id>(), 4, 1, nullptr),
      TRY(physim_world_release, kHandle | kPointer, g.h.world, id, g.at<physim_id>(), 4, nullptr),
      TRY(physim_world_spawn_moving, kHandle | kPointer | kNumber, g.h.world, g.h.def, nullptr, g.at<double>(),
          g.at<double>(), g.number(0), g.at<physim_id>()),
      TRY(physim_scene_set_layers, kHandle, g.h.scene, id, 1),
      TRY(physim_world_in_ball, kHandle | kPointer | kNumber, g.h.world, g.at<double>(), g.number(1), 1,
          g.at<physim_id>(), 4, g.at<std::size_t>()),
      TRY(physim_world_in_box, kHandle | kPointer | kSize, g.h.world, g.at<physim_transform>(), g.at<double>(), 1,
          g.at<physim_id>(), 4, g.at<std::size_t>()),
      TRY(physim_world_cast, kHandle | kPointer, g.h.world, g.at<physim_segment>(), 1, g.at<physim_projectile_hit>(),
          sizeof(physim_projectile_hit), 4, g.at<std::size_t>()),
      TRY(physim_scene_set_conveyor, kHandle, g.h.scene, id, nullptr),
      TRY(physim_world_set_observer, kHandle | kPointer, g.h.world, g.at<double>()),
      TRY(physim_world_add_kind, kHandle | kPointer, g.h.world, g.h.def, nullptr, 0, 0, g.at<std::uint32_t>()),
      TRY(physim_world_spawn, kHandle, g.h.world, 1, 0, nullptr, nullptr, nullptr),
      TRY(physim_world_spawn_flight, kHandle | kPointer | kNumber, g.h.world, g.h.flight, g.number(0),
          g.at<physim_id>()),
      TRY(physim_world_despawn, kHandle | kPointer, g.h.world, g.at<physim_id>(), 4, nullptr),
      TRY(physim_world_step, kHandle | kNumber, g.h.world, 1, g.number(0)),
      TRY(physim_world_advance, kHandle | kNumber, g.h.world, g.number(0), nullptr),
      TRY(physim_world_events, kHandle | kPointer, g.h.world, 0, g.at<physim_event>(), sizeof(physim_event), 4,
          g.at<std::size_t>()),
      TRY(physim_world_states, kHandle | kPointer | kSize, g.h.world, nullptr, 4, g.at<physim_states>(), nullptr),
      TRY(physim_world_put, kHandle | kPointer | kSize, g.h.world, g.at<physim_id>(), 4, g.at<physim_states>(),
          nullptr),
      TRY(physim_world_push, kHandle | kPointer, g.h.world, g.at<physim_id>(), 4, g.at<double>(), nullptr),
      TRY(physim_world_jerk, kHandle | kPointer, g.h.world, id, g.at<double>()),
      TRY(physim_world_projectile, kHandle | kPointer | kSize, g.h.world, id, g.at<physim_projectile>()),
      TRY(physim_world_set, kHandle | kPointer, g.h.world, id, g.text("mass"), g.text("1 kg")),
      TRY(physim_world_get, kHandle | kPointer, g.h.world, id, g.text("mass"), g.at<char>(), 16, nullptr),
      TRY(physim_world_predict, kHandle | kPointer | kNumber, g.h.world, id, g.number(1), g.at<physim_flight*>()),
      TRY(physim_world_snapshot, kHandle | kPointer, g.h.world, g.at<physim_snapshot*>()),
      TRY(physim_world_restore, kHandle, g.h.world, g.h.snapshot),
      TRY(physim_world_load, kPointer, g.at<char>(), 16, nullptr, nullptr, g.at<physim_world*>()),
      TRY(physim_world_record, kHandle, g.h.world, 1),
      TRY(physim_world_stop_recording, kHandle | kPointer, g.h.world, g.at<physim_bytes*>()),
      TRY(physim_replay, kPointer | kSize, g.at<char>(), 16, nullptr, g.at<physim_replay_info>()),
      TRY(physim_replay_open, kPointer, g.at<char>(), 16, nullptr, g.at<physim_world*>()),
      TRY(physim_replay_next, kHandle, g.h.world, 1, nullptr, nullptr),
      TRY(physim_replay_seek, kHandle, g.h.world, 1, nullptr, nullptr),
      TRY(physim_world_draw, kHandle | kPointer | kSize, g.h.world, g.at<physim_drawing>(), g.at<physim_canvas>()),
      TRY(physim_scene_load, kPointer, g.at<char>(), 16, nullptr, g.at<physim_scene*>()),
      TRY(physim_scene_set_engine, kHandle | kNumber, g.h.scene, nullptr, nullptr, g.number(0)),
      TRY(physim_scene_read_engine, kHandle | kPointer | kSize, g.h.scene, g.at<physim_engine_info>()),
      TRY(physim_scene_create, kHandle | kPointer, g.h.def, g.at<physim_scene*>()),
      TRY(physim_world_set_scene, kHandle, g.h.world, g.h.scene),
      TRY(physim_scene_add, kHandle | kPointer, g.h.scene, g.h.def, g.at<physim_id>(), 4, nullptr),
      TRY(physim_scene_copy, kHandle | kPointer | kSize, g.h.scene, id, g.at<physim_transform>(), g.at<physim_id>()),
      TRY(physim_scene_find, kHandle | kPointer, g.h.scene, g.text("box"), g.at<physim_id>()),
      TRY(physim_scene_move, kHandle | kPointer | kSize, g.h.world, id, g.at<physim_transform>()),
      TRY(physim_scene_set_motion, kHandle | kSize, g.h.scene, id, g.at<physim_motion>()),
      TRY(physim_scene_remove, kHandle, g.h.scene, id),
      TRY(physim_scene_cast, kHandle | kPointer, g.h.scene, g.at<physim_segment>(), 4, ~0U, g.at<physim_hit>(),
          sizeof(physim_hit), nullptr),
      TRY(physim_scene_hits, kHandle | kPointer, g.h.world, g.at<physim_segment>(), ~0U, g.at<physim_hit>(),
          sizeof(physim_hit), 4, g.at<std::size_t>()),
      TRY(physim_scene_nearest, kHandle | kPointer | kSize | kNumber, g.h.scene, g.null_pointers ? nullptr : place,
          g.number(1), ~0U, 0, g.at<physim_nearest>()),
      TRY(physim_scene_overlaps, kHandle | kPointer | kNumber, g.h.scene, g.null_pointers ? nullptr : place,
          g.number(1), ~0U, 0, g.at<physim_id>(), 4, g.at<std::size_t>()),
      TRY(physim_world_add_emitter, kHandle | kPointer, g.h.world, g.h.def, nullptr, nullptr, g.at<physim_id>()),
      TRY(physim_emitter_do, kHandle | kNumber, g.h.world, id, PHYSIM_EMIT, g.number(1)),
      TRY(physim_emitter_move, kHandle | kPointer | kSize | kNumber, g.h.world, id, g.at<physim_transform>(),
          g.number(1)),
      TRY(physim_emitter_read, kHandle | kPointer | kSize, g.h.world, id, g.at<physim_emitter_info>()),
      TRY(physim_emitter_particles, kHandle | kPointer | kSize, g.h.world, id, 4, g.at<physim_particles>(),
          g.at<std::size_t>()),
      TRY(physim_emitter_trails, kHandle | kPointer, g.h.world, id, nullptr, g.at<std::size_t>(), g.at<std::size_t>()),
      TRY(physim_world_add_force, kHandle | kPointer, g.h.world, g.h.def, nullptr, nullptr, 0, nullptr,
          g.at<physim_id>()),
      TRY(physim_world_add_force_function, kHandle | kPointer, g.h.world, nullptr, nullptr, nullptr, 0, 1,
          g.at<physim_id>()),
      TRY(physim_world_set_hit_function, kHandle, g.h.world, nullptr, nullptr),
      TRY(physim_world_add_joint, kHandle | kPointer | kSize, g.h.world, g.at<physim_joint>(), g.at<physim_id>()),
      TRY(physim_joint_move, kHandle | kPointer, g.h.world, id, g.at<double>(), g.at<double>()),
      TRY(physim_joint_read, kHandle | kPointer | kSize, g.h.world, id, g.at<physim_joint_info>()),
      TRY(physim_joint_events, kHandle | kPointer, g.h.world, g.at<physim_joint_event>(), sizeof(physim_joint_event), 4,
          g.at<std::size_t>()),
      TRY(physim_world_remove, kHandle, g.h.world, PHYSIM_A_FORCE, id),
      TRY(physim_aim, kHandle | kPointer | kSize, g.h.def, nullptr, nullptr, g.at<physim_aim_info>()),
      TRY(physim_max_range, kHandle | kPointer | kSize | kNumber, g.h.def, nullptr, g.number(0), 0, 0,
          g.at<physim_farthest>()),
      TRY(physim_suvat, kPointer, g.at<physim_straight>(), g.at<physim_straight>(), g.at<std::size_t>()),
      TRY(physim_compare, kHandle | kPointer, g.h.def, nullptr, &preset, 1, g.at<physim_compared>(),
          sizeof(physim_compared), nullptr),
      TRY(physim_fit, kHandle | kPointer | kSize, g.h.def, nullptr, g.at<physim_measurement>(), 2, nullptr,
          g.at<physim_fit_info>(), nullptr),
      TRY(physim_choose_fidelity, kHandle | kPointer | kSize, g.h.def, nullptr, nullptr, g.at<physim_fidelity_info>(),
          nullptr),
      TRY(physim_study_create, kHandle | kPointer, g.h.def, nullptr, g.at<physim_study*>()),
      TRY(physim_study_read, kHandle | kPointer | kSize, g.h.study, g.at<physim_study_info>()),
      TRY(physim_study_fly, kHandle | kPointer, g.h.study, 0, 1, nullptr, g.at<physim_part*>()),
      TRY(physim_study_set_width, kHandle | kNumber, g.h.study, nullptr, 0, g.number(0)),
      TRY(physim_study_run, kHandle | kPointer | kNumber, g.h.study, nullptr, g.number(0), nullptr, nullptr,
          g.at<physim_figures*>()),
      TRY(physim_part_join, kHandle | kPointer, g.h.part, g.h.part, g.at<physim_part*>()),
      TRY(physim_part_load, kPointer, g.at<char>(), 16, g.at<physim_part*>()),
      TRY(physim_study_figures, kHandle | kPointer, g.h.study, g.h.part, 1, g.at<physim_figures*>()),
      TRY(physim_figures_read, kHandle | kPointer | kSize, g.h.figures, g.at<physim_figures_info>()),
      TRY(physim_figures_quantity, kHandle | kPointer | kSize, g.h.figures, 0, g.at<physim_quantity>()),
      TRY(physim_figures_target, kHandle | kPointer | kSize, g.h.figures, 0, g.at<physim_chance>()),
      TRY(physim_figures_quantile, kHandle | kPointer | kNumber, g.h.figures, 0, g.number(0.5), g.at<double>()),
  };
  return calls;
}

void expect_refused(const Given& given, unsigned which, physim_result code) {
  for (const Try& each : all_calls())
    if (each.bad & which) {
      EXPECT_EQ(each.call(given), code) << each.name << ": " << physim_last_error();
      EXPECT_NE(std::strlen(physim_last_error()), 0U) << each.name;
    }
}

TEST(BadInputOfC, every_function_is_tried) {
  std::set<std::string> tried = {"physim_version", "physim_last_error", "physim_last_place",   "physim_last_hint",
                                 "physim_free",    "physim_name",       "physim_setting_count"};
  for (const Try& each : all_calls()) tried.insert(each.name);
  std::size_t functions = 0;
  std::ostringstream text;
  text << std::ifstream(std::string(PHYSIM_SOURCE_DIR) + "/include/physim/physim.h").rdbuf();
  const std::string all = text.str();
  static const std::regex kFunction(R"(PHYSIM_API [^(;]*\b(physim_\w+)\()");
  for (std::sregex_iterator match(all.begin(), all.end(), kFunction), end; match != end; ++match, ++functions)
    EXPECT_TRUE(tried.contains((*match)[1])) << (*match)[1];
  EXPECT_EQ(functions, tried.size());
}

TEST(BadInputOfC, handles_that_are_null) { expect_refused({}, kHandle, PHYSIM_BAD_HANDLE); }

TEST(BadInputOfC, handles_that_were_freed) {
  Given given{made()};
  given.h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
  expect_refused(given, kHandle, PHYSIM_BAD_HANDLE);
  Handles others = made();  // which take the slots of those before
  expect_refused(given, kHandle, PHYSIM_BAD_HANDLE);
  given.h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_BAD_HANDLE); });
  others.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

TEST(BadInputOfC, handles_of_another_kind_and_pointers_that_are_none) {
  Handles h = made();
  Given given{h};
  std::uintptr_t other = std::bit_cast<std::uintptr_t>(h.pool);
  given.h.each([&](auto*& handle) { handle = std::bit_cast<std::remove_reference_t<decltype(handle)>>(other); });
  given.h.pool = std::bit_cast<physim_pool*>(h.def);
  expect_refused(given, kHandle, PHYSIM_BAD_HANDLE);
  int on_the_stack = 0;
  other = std::bit_cast<std::uintptr_t>(&on_the_stack);
  given.h.each([&](auto*& handle) { handle = std::bit_cast<std::remove_reference_t<decltype(handle)>>(other); });
  expect_refused(given, kHandle, PHYSIM_BAD_HANDLE);
  h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

TEST(BadInputOfC, pointers_that_are_null_structs_of_no_size_and_numbers_that_are_none) {
  Given given{made()};
  given.null_pointers = true;
  expect_refused(given, kPointer, PHYSIM_BAD_ARGUMENT);
  given.null_pointers = false;
  given.no_sizes = true;
  expect_refused(given, kSize, PHYSIM_BAD_ARGUMENT);
  given.no_sizes = false;
  given.no_numbers = true;
  expect_refused(given, kNumber, PHYSIM_BAD_ARGUMENT);
  given.h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

TEST(BadInputOfC, ids_of_what_is_not_there_are_found_nowhere) {
  Handles h = made();
  const physim_id stranger{77, 3};
  physim_projectile one{};
  one.size = sizeof one;
  EXPECT_EQ(physim_world_projectile(h.world, stranger, &one), PHYSIM_NOT_FOUND);
  EXPECT_EQ(physim_world_set(h.world, stranger, "mass", "1 kg"), PHYSIM_NOT_FOUND);
  EXPECT_EQ(physim_scene_remove(h.world, stranger), PHYSIM_REFUSED);
  EXPECT_EQ(physim_world_remove(h.world, PHYSIM_A_JOINT, stranger), PHYSIM_REFUSED);
  EXPECT_EQ(physim_emitter_do(h.world, stranger, PHYSIM_PLAY, 0), PHYSIM_REFUSED);
  std::size_t count = 7;
  EXPECT_EQ(physim_world_despawn(h.world, &stranger, 1, &count), PHYSIM_OK);
  EXPECT_EQ(count, 0U);
  h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

TEST(BadInputOfC, bytes_that_are_damaged_are_refused) {
  Handles h = made();
  const void* data = nullptr;
  std::size_t size = 0;
  ASSERT_EQ(physim_bytes_data(h.bytes, &data, &size), PHYSIM_OK);
  const auto* first = static_cast<const unsigned char*>(data);
  const std::vector<unsigned char> save(first, first + size);
  for (std::size_t at = 0; at < size; at += 7) {
    std::vector<unsigned char> bad = save;
    bad[at] ^= 0x55;
    physim_world* world = nullptr;
    EXPECT_EQ(physim_world_load(bad.data(), size, nullptr, nullptr, &world), PHYSIM_REFUSED) << at;
    EXPECT_EQ(physim_world_load(save.data(), at, nullptr, nullptr, &world), PHYSIM_REFUSED) << at;
  }
  h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

TEST(BadInputOfC, each_thread_has_its_own_last_error) {
  EXPECT_EQ(physim_check(nullptr), PHYSIM_BAD_HANDLE);
  const std::string mine = physim_last_error();
  std::thread([] {
    EXPECT_STREQ(physim_last_error(), "");
    EXPECT_EQ(physim_def_load(nullptr, nullptr), PHYSIM_BAD_ARGUMENT);
    EXPECT_STREQ(physim_last_place(), "file");
  }).join();
  EXPECT_EQ(mine, physim_last_error());
}

/// One def, flight and scene read by many threads while handles come and go.
TEST(BadInputOfC, what_is_only_read_serves_many_threads) {
  Handles h = made();
  physim_sample expected{};
  expected.size = sizeof expected;
  ASSERT_EQ(physim_flight_at(h.flight, PHYSIM_AT_END, 0, &expected), PHYSIM_OK);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&h, &expected] {
      for (int i = 0; i < 50; ++i) {
        physim_flight* flight = nullptr;
        physim_sample end{};
        end.size = sizeof end;
        EXPECT_EQ(physim_fly(h.def, nullptr, nullptr, &flight), PHYSIM_OK);
        EXPECT_EQ(physim_flight_at(flight, PHYSIM_AT_END, 0, &end), PHYSIM_OK);
        EXPECT_EQ(end.position[0], expected.position[0]);
        EXPECT_EQ(physim_free(flight), PHYSIM_OK);
      }
    });
  for (std::thread& thread : threads) thread.join();
  h.each([](auto*& handle) { EXPECT_EQ(physim_free(handle), PHYSIM_OK); });
}

}  // namespace physim::capi_bad_input_test
