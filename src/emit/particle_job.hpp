// Columns of numbers that belong to many particles: what the kernels of each instruction set offer, and the choice
// among them. The same bits as for each particle alone (emit/chance.hpp, emit/drawn.hpp), whatever the kernel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physim/math.hpp"

namespace physim {

struct ShapeNumbers;

/// Particles in a column.
inline constexpr std::size_t kColumn = 32;

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
  std::size_t count;               // of words that are needed, the first ones; there is room for a column
  const std::uint64_t* number;     // of the particles
  std::uint32_t* words[4];
};

/// Where particles come out of a shape, and in which direction; as many as are needed, the first ones.
struct OutletJob {
  const ShapeNumbers* shape;
  std::size_t count;
  const double *time, *of_moment, *moment;  // as Birth has them
  const std::uint32_t* words[8]{};          // of the first draws, as many as the shape needs
  double *place[3]{}, *direction[3]{};      // what comes out [m], [-]
};

/// Where they start in the frame of the world, from the pose of their emitter and what they were drawn with.
struct StartJob {
  std::size_t count;
  Vec3d position;                         // of the emitter [m]
  Quatd rotation;                         // of the emitter
  Vec3d velocity;                         // the inherited part [m/s]
  const double *place[3], *direction[3];  // in the emitter's frame [m], [-]
  const double* speed;                    // [m/s]
  double *x[3], *v[3];                    // what comes out [m], [m/s]
};

struct ParticleKernel {
  const char* name;
  void (*words)(const WordsJob& job);
  void (*number)(const NumberJob& job);
  void (*gradient)(const GradientPieces& pieces, const double* x, const ColourColumns& colour);
  /// Each rounded to the nearest.
  void (*pack_colours)(const ColourColumns& colour, std::uint32_t* packed);
  /// Which part of its span each has lived through, 0 to 1.
  void (*part_of_life)(double time, const double* birth, const double* span, double* part);
  void (*outlets)(const OutletJob& job);
  void (*starts)(const StartJob& job);
};

/// That of the instruction set which is in use.
[[nodiscard]] const ParticleKernel& particle_kernel();

}  // namespace physim
