// Quality: how much of the scene's looks is drawn, and the picking of one that the machine draws often enough.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace physim::client {

enum class Quality {
  low,     // as medium, but without shadows and, where there are no things, with half of the background's pixels
  medium,  // edges of things are not smoothed, particles in crowds are dots, and no dot lies over another
  high,    // everything; that of pictures, films and scripts
};
[[nodiscard]] std::string_view name(Quality quality);

/// Particles of one emitter from which on lower qualities draw them as dots.
inline constexpr std::size_t kCrowdedEmitter = 1500;

/// Lowers the quality if frames take too long, and raises it again if there is room.
class QualityPicker {
 public:
  static constexpr double kTooLong = 1.0 / 45;  // of the mean frame: it is lowered above [s]
  static constexpr double kRoom = 1.0 / 60;     // of the mean frame: it may be raised below [s]

  /// A frame took so long [s]: its drawing, and what was simulated for it.
  void add(double seconds);
  [[nodiscard]] Quality now() const { return now_; }

 private:
  static constexpr int kFrames = 12;           // whose mean counts
  static constexpr double kFirstWait = 3;      // before it is raised [s of the screen's frames]
  static constexpr double kLongestWait = 600;  // [s]
  static constexpr double kProof = 5;          // a raised quality that is kept for so long has held [s]

  void change(int by);

  Quality now_ = Quality::high;
  double sum_ = 0;  // of the frames since the last mean or change [s]
  int frames_ = 0;
  double since_ = 0;                      // the last change [s]
  double wait_ = kFirstWait;              // twice as long after each rise that did not hold [s]
  std::optional<double> after_lowering_;  // the mean frame right after the last lowering [s]
  bool has_risen_ = false;                // by the last change
};

/// The quality that is drawn now, with the user's choice.
struct QualityChoice {
  Quality now = Quality::high;
  std::optional<Quality> by_hand;  // none: it is picked

  /// The user chose it, or less than everything is drawn.
  [[nodiscard]] bool is_told() const { return by_hand || now != Quality::high; }
  /// "medium (picked)", "low".
  [[nodiscard]] std::string text() const;
};

}  // namespace physim::client
