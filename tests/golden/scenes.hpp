// Scenes, studies, emitters and joints in the golden hash.
#pragma once

#include <cstdint>

namespace physim::test {

/// Random worlds and flights that meet things and each other; false where kernels or threads change a bit.
bool add_scenes(std::uint64_t& hash);

/// Studies by each way of drawing; false where kernels or threads change a bit.
bool add_studies(std::uint64_t& hash);

/// Random emitters of every row; false where kernels or threads change a bit.
bool add_emitters(std::uint64_t& hash);
/// Random nets of joints; false where kernels or threads change a bit.
bool add_joints(std::uint64_t& hash);

}  // namespace physim::test
