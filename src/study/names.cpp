// Names of a study's enumerators, as they are spelled in its headers.
#include "study/quantities.hpp"

namespace physim {

template <>
std::span<const std::string_view> names_of<Sampling>() {
  static constexpr std::string_view names[] = {"random", "latin_hypercube", "sobol"};
  return names;
}
template <>
std::span<const std::string_view> names_of<DrawnFor>() {
  static constexpr std::string_view names[] = {"round", "occasion"};
  return names;
}
template <>
std::span<const std::string_view> names_of<StudyQuantity>() {
  return kNamesIn<kStudyQuantities>;
}

}  // namespace physim
