// Every call that a recording holds is made by some function of the C interface.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace physim::capi_recorded_calls_test {

#define PHYSIM_CALL(name, ...) #name,
constexpr const char* kRecorded[] = {
#include "world/core/recorded_calls.hpp"
};
#undef PHYSIM_CALL

const std::map<std::string, std::string> kMadeBy = {
    {"add_kind", "physim_world_add_kind"},
    {"add_environment", "physim_world_add_environment"},
    {"set_environment", "physim_world_set_environment"},
    {"spawn", "physim_world_spawn"},
    {"spawn_def", "physim_world_spawn_flight"},
    {"spawn_many", "physim_world_spawn"},
    {"despawn", "physim_world_despawn"},
    {"despawn_many", "physim_world_despawn"},
    {"clear", "physim_world_do"},
    {"set_position", "physim_world_put"},
    {"set_velocity", "physim_world_put"},
    {"set_state", "physim_world_put"},
    {"apply_impulse", "physim_world_push"},
    {"set_angular_velocity", "physim_world_put"},
    {"set_gravity_scale", "physim_world_set"},
    {"set_use_gravity", "physim_world_set"},
    {"set_kinematic", "physim_world_set"},
    {"set_frozen", "physim_world_set"},
    {"set_can_sleep", "physim_world_set"},
    {"sleep", "physim_world_rest"},
    {"wake", "physim_world_rest"},
    {"set_smoothing", "physim_world_set"},
    {"set_user_data", "physim_world_put"},
    {"set_layers", "physim_world_set"},
    {"set_colour", "physim_world_set"},
    {"set_label", "physim_world_set"},
    {"set_fidelity", "physim_world_set"},
    {"set_fidelity_many", "physim_world_set"},
    {"set_detail", "physim_world_set_detail"},
    {"set_observer", "physim_world_set_observer"},
    {"add_force", "physim_world_add_force"},
    {"add_force_on", "physim_world_add_force"},
    {"remove_force", "physim_world_remove"},
    {"remove_force_from", "physim_world_release"},
    {"step", "physim_world_step"},
    {"advance", "physim_world_advance"},
    {"single_step", "physim_world_do"},
    {"set_paused", "physim_world_do"},
    {"set_time_scale", "physim_world_do"},
    {"snapshot", "physim_world_snapshot"},
    {"restore", "physim_world_restore"},
    {"set_body", "physim_world_set"},
    {"spawn_departed", "physim_world_spawn_moving"},
    {"set_scene", "physim_world_set_scene"},
    {"remove_scene", "physim_world_set_scene"},
    {"add_shape", "physim_scene_add"},
    {"remove_shape", "physim_world_set_scene"},
    {"add_material", "physim_scene_add"},
    {"add_instance", "physim_scene_copy"},
    {"remove_instance", "physim_scene_remove"},
    {"move_instance", "physim_scene_move"},
    {"set_instance_layers", "physim_scene_set_layers"},
    {"set_instance_motion", "physim_scene_set_motion"},
    {"add_emitter", "physim_world_add_emitter"},
    {"remove_emitter", "physim_world_remove"},
    {"play_emitter", "physim_emitter_do"},
    {"stop_emitter", "physim_emitter_do"},
    {"move_emitter", "physim_emitter_move"},
    {"emit", "physim_emitter_do"},
    {"trigger_emitter", "physim_emitter_do"},
    {"add_joint", "physim_world_add_joint"},
    {"remove_joint", "physim_world_remove"},
    {"move_joint", "physim_joint_move"},
    {"jump_emitter", "physim_emitter_move"},
    {"seek_emitter", "physim_emitter_do"},
    {"set_hit_function", "physim_world_set_hit_function"},
    {"lead_emitter", "physim_emitter_move"},
    {"set_projectile", "physim_world_set"},
    {"set_mass", "physim_world_set"},
    {"set_drag", "physim_world_set"},
    {"set_damping", "physim_world_set"},
    {"set_instance_conveyor", "physim_scene_set_conveyor"},
};

TEST(RecordedCallsInC, each_is_made_by_a_function) {
  std::ostringstream header;
  header << std::ifstream(std::string(PHYSIM_SOURCE_DIR) + "/include/physim/physim.h").rdbuf();
  for (const char* name : kRecorded) {
    const auto found = kMadeBy.find(name);
    ASSERT_NE(found, kMadeBy.end()) << name << ": no function of C makes this call";
    EXPECT_NE(header.str().find(" " + found->second + "("), std::string::npos) << found->second;
  }
  EXPECT_EQ(std::size(kRecorded), kMadeBy.size()) << "of calls that are no more";
}

}  // namespace physim::capi_recorded_calls_test
