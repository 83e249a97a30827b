// The only file that knows stb_image.
#include <memory>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "physim/scenario.hpp"
#include "scenario/libraries.hpp"
#include "scenario/text_file.hpp"

#if PHYSIM_HAS_STB
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#include <stb/stb_image.h>
#pragma GCC diagnostic pop
#endif

namespace physim {

bool reads_height_maps() { return PHYSIM_HAS_STB != 0; }

#if PHYSIM_HAS_STB

Result<HeightFieldShape> read_height_map(const std::string& file, double low, double high) {
  const IeeeMode mode;
  constexpr int kGrey = 1;
  constexpr double kWhite = 65535, kMostPoints = 1e8;
  constexpr std::uintmax_t kLargestPicture = 1 << 30;  // [bytes]
  const auto bytes = read_byte_file(file, kLargestPicture, "height map");
  if (!bytes) return bytes.error();
  const auto* const content = static_cast<const stbi_uc*>(static_cast<const void*>(bytes->data()));
  const auto size = static_cast<int>(bytes->size());
  int columns = 0, rows = 0, channels = 0;
  if (stbi_info_from_memory(content, size, &columns, &rows, &channels) == 0)
    return Error{"this is no picture: " + std::string(stbi_failure_reason()), file, "PNG and PGM are read"};
  if (static_cast<double>(columns) * rows > kMostPoints)
    return Error{"has " + std::to_string(columns) + " by " + std::to_string(rows) + " points", file,
                 "at most 1e8 are read"};
  const std::unique_ptr<stbi_us, void (*)(void*)> grey(
      stbi_load_16_from_memory(content, size, &columns, &rows, &channels, kGrey), &stbi_image_free);
  if (!grey) return Error{"the picture is damaged: " + std::string(stbi_failure_reason()), file, ""};
  PHYSIM_ASSERT(columns > 0);
  PHYSIM_ASSERT(rows > 0);
  HeightFieldShape field;
  field.columns = static_cast<std::uint32_t>(columns);
  field.rows = static_cast<std::uint32_t>(rows);
  const std::size_t points = std::size_t{field.columns} * field.rows;
  for (std::size_t i = 0; i < points; ++i) field.heights.push_back(low + (high - low) * (grey.get()[i] / kWhite));
  return field;
}

#else

Result<HeightFieldShape> read_height_map(const std::string& file, double, double) {
  return Error{"this build reads no heights from pictures", file,
               "build it with stb (libstb-dev), or write heights into the scenario"};
}

#endif

}  // namespace physim
