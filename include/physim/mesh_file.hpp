// Mesh files: triangles out of OBJ, STL, glTF and what else Assimp reads; heights out of pictures. Part of the library
// physim_scenario.
#pragma once

#include <string>

#include "physim/result.hpp"
#include "physim/scene.hpp"

namespace physim {

/// Whether this build reads meshes from files: it does where Assimp was there when it was built.
[[nodiscard]] bool reads_mesh_files();

/// The triangles of all objects of a file, up to 256 MB of it, as they stand in it; equal corners are one vertex. A
/// number of the file is a metre, to float32; y is up, whatever the format says about axes. The error's place is the
/// file.
[[nodiscard]] Result<MeshShape> read_mesh_file(const std::string& file);

/// Whether this build reads heights from pictures: it does where stb was there when it was built.
[[nodiscard]] bool reads_height_maps();

/// Heights out of a picture in grey, PNG of 8 or 16 bits best: black is `low` and white is `high` [m], columns go along
/// x and rows along z, from the upper left corner on; colours count by their brightness. Spacings stay 1 m. Up to 1e8
/// points; the error's place is the file.
[[nodiscard]] Result<HeightFieldShape> read_height_map(const std::string& file, double low, double high);

}  // namespace physim
