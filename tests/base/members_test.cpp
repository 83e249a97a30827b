// The members of structs, counted and taken one by one.
#include "base/members.hpp"

#include <gtest/gtest.h>

#include "base/archive.hpp"
#include "physim/world.hpp"

namespace physim {
namespace base_members_test {

enum class Letter { a, b };
struct Inner {
  std::optional<double> first;
  double second = 2;
};
struct Mixed {
  std::string text;
  Inner inner;
  std::optional<Vec3d> place;
  std::vector<Inner> list;
  Letter letter = Letter::b;
  const char* pointer = nullptr;
  bool flag = false;
};

TEST(Members, are_counted_whatever_their_types) {
  static_assert(kMemberCount<Mixed> == 7);
  static_assert(kMemberCount<Inner> == 2);
  static_assert(kMemberCount<Vec3d> == 3);
  static_assert(kMemberCount<BodyDef> == 26);
  static_assert(kMemberCount<KindId> == 1);
}

TEST(Members, come_in_the_order_of_the_definition) {
  Mixed mixed;
  with_members(mixed, [&](auto& text, auto& inner, auto& place, auto&, auto&, auto&, auto& flag) {
    EXPECT_EQ(&text, &mixed.text);
    EXPECT_EQ(&inner, &mixed.inner);
    EXPECT_EQ(&place, &mixed.place);
    flag = true;
  });
  EXPECT_TRUE(mixed.flag);
}

template <class S>
struct Twin {
  S number;
  S list[2];
  int whole;
  Vec3<S> vector;
};

}  // namespace base_members_test

template <class S>
inline constexpr std::size_t kMemberCount<base_members_test::Twin<S>> = 4;

namespace base_members_test {

TEST(Members, are_cast_to_their_twins) {
  const Twin<double> from{0.1, {0.2, 0.3}, 7, {1, 2, 0.7}};
  Twin<float> to{};
  cast_members(from, to);
  EXPECT_EQ(to.number, 0.1f);
  EXPECT_EQ(to.list[1], 0.3f);
  EXPECT_EQ(to.whole, 7);
  EXPECT_EQ(to.vector.z, 0.7f);
}

template <class T>
std::size_t bytes_of(const T& value) {
  std::vector<std::byte> bytes;
  Writer(bytes).write(value);
  return bytes.size();
}

/// Recordings hold every member. Where one of these numbers changes, old recordings cannot be read any more: raise
/// kRecordingFormat together with them.
TEST(Members, of_recorded_structs_make_the_recording_format) {
  EXPECT_EQ(kRecordingFormat, 17u);
  EXPECT_EQ(bytes_of(ProjectileDef{}), 354u);
  EXPECT_EQ(bytes_of(BodyDef{}), 239u);
  EXPECT_EQ(bytes_of(Launch{}), 172u);
  EXPECT_EQ(bytes_of(WorldDef{}), 240u);
  EXPECT_EQ(bytes_of(ForceDef{}), 53u);
  EXPECT_EQ(bytes_of(Environment{.wind = {.profile = {{}}}}), 142u);
}

}  // namespace base_members_test
}  // namespace physim
