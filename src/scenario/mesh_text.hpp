// Corners of meshes in text formats, in double. Libraries read them as floats, which are 31 mm apart at 500 km.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "physim/math.hpp"

namespace physim {

/// A mesh in text whose corners have whole numbers instead of their places. Floats hold them exactly.
struct NumberedMesh {
  using Corner = std::array<float, 3>;

  std::string text{};                ///< the file with whole numbers for corners, less than 2^23 in size
  std::map<Corner, Vec3d> places{};  ///< of the file [its unit], by these numbers
};

/// Nothing if the text is no OBJ, STL or PLY with its corners in digits. Corners that lie nearer to each other than
/// 2^-23 of the size of the mesh are one.
[[nodiscard]] std::optional<NumberedMesh> numbered_mesh(const std::string& text);

}  // namespace physim
