#include "libraries.hpp"

#include <string_view>

#include "physim/flight.hpp"
#include "report/gnuplot.hpp"
#include "scenario/libraries.hpp"

namespace physim::cli {
namespace {

struct Library {
  std::string_view name;
  bool is_there;
  std::string_view adds;
  std::string_view packages;  // of Debian
};

}  // namespace

std::string build_text() {
  const Library libraries[] = {
      {"Assimp", PHYSIM_HAS_ASSIMP != 0, "meshes from files", "libassimp-dev"},
      {"GDAL", PHYSIM_HAS_GDAL != 0, "terrain from GeoTIFF and SRTM files", "libgdal-dev"},
      {"stb", PHYSIM_HAS_STB != 0, "heights from pictures", "libstb-dev"},
      {"HDF5", PHYSIM_HAS_HDF5 != 0, "shots of a study in columns (study --hdf5)", "libhdf5-dev"},
      {"MPI", PHYSIM_HAS_MPI != 0, "studies flown by the ranks of a job", "libopenmpi-dev openmpi-bin"},
      {"gnuplot", static_cast<bool>(report::check_gnuplot()), "pictures (--plot)", "gnuplot-nox fonts-dejavu-core"},
  };
  std::string text = "kernels:", missing;
  for (const std::string& kernel : kernels()) text += " " + kernel;
  for (const Library& library : libraries) {
    text += std::string("\n") + (library.is_there ? "with     " : "without  ") + std::string(library.name);
    text += std::string(9 - library.name.size(), ' ') + std::string(library.adds);
    if (!library.is_there) missing += " " + std::string(library.packages);
  }
  if (!missing.empty())
    text += "\nto add what is missing: ./dev build --all, or apt-get install" + missing + " and build again";
  return text;
}

}  // namespace physim::cli
