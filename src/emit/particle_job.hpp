// Columns of numbers that belong to many particles: what the kernels of each instruction set offer, and the choice
// among them. The same bits as for each particle alone (emit/chance.hpp, emit/drawn.hpp), whatever the kernel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace physim {

/// Particles in a column, and in a short one: few are born at a time.
inline constexpr std::size_t kColumn = 32, kShortColumn = 8;

/// A piece of a curve: c0 + c1 s + c2 s^2 + c3 s^3 with s = x - start.
struct CurvePiece {
  double start;
  std::array<double, 4> c;
  double low, high;  // its ends, between which it stays: rounding would not
  double before;     // the integral from 0 to its start
};
/// A curve; none where it is 1 everywhere.
struct CurvePieces {
  const CurvePiece* at;  // in order; the first starts at 0, the last one is held for ever
  std::size_t count;
  std::size_t first;  // that is not held before its keys
};

/// From a key of a gradient to the next one: colour + (x - start) / length more.
struct GradientPiece {
  double start, length;
  std::array<double, 4> colour, more;
};
struct GradientPieces {
  const GradientPiece* at;  // in order; the first before all keys, the last one behind
  std::size_t count;
};

/// Red, green, blue and alpha of many, 0 to 255.
struct ColourColumns {
  double* part[4];
};

/// A number of each particle: value curve(x), and where `words` were drawn for them, from there to to to_curve(x).
struct NumberJob {
  double value, to;
  CurvePieces curve, to_curve;
  const double* x;
  const std::uint32_t* words;  // null: nothing is drawn
  double* y;
};

/// The four random words of each particle, word by word, see emit_words().
struct WordsJob {
  std::uint64_t seed;
  std::uint32_t stream_and_index;  // the last word of all counters
  const std::uint64_t* number;     // of the particles
  std::uint32_t* words[4];
};

struct ParticleKernel {
  const char* name;
  void (*words)(const WordsJob& job);
  void (*few_words)(const WordsJob& job);  // of a short column
  void (*number)(const NumberJob& job);
  void (*gradient)(const GradientPieces& pieces, const double* x, const ColourColumns& colour);
  /// Each rounded to the nearest.
  void (*pack_colours)(const ColourColumns& colour, std::uint32_t* packed);
  /// Which part of its span each has lived through, 0 to 1.
  void (*part_of_life)(double time, const double* birth, const double* span, double* part);
};

/// That of the instruction set which is in use.
[[nodiscard]] const ParticleKernel& particle_kernel();

}  // namespace physim
