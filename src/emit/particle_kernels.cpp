#include "base/kernel_choice.hpp"
#include "base/kernel_copies.hpp"
#include "emit/particle_job.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void draw_words(const WordsJob& job); void put_outlets(const OutletJob& job);
                     void put_starts(const StartJob& job); void put_numbers(const NumberJob& job);
                     void put_gradients(const GradientPieces& pieces, const double* x, const ColourColumns& colour);
                     void pack_colours(const ColourColumns& colour, std::uint32_t* packed);
                     void put_parts_of_life(double time, const double* birth, const double* span, double* part);)

namespace {

#define PHYSIM_PARTICLE_KERNEL(isa)                                                                         \
  {                                                                                                         \
#isa, isa::draw_words, isa::put_numbers, isa::put_gradients, isa::pack_colours, isa::put_parts_of_life, \
        isa::put_outlets, isa::put_starts                                                                   \
  }

constexpr ParticleKernel kParticleKernels[] = {
#if PHYSIM_HAVE_AVX512
    PHYSIM_PARTICLE_KERNEL(avx512),
#endif
#if PHYSIM_HAVE_AVX2
    PHYSIM_PARTICLE_KERNEL(avx2),
#endif
    PHYSIM_PARTICLE_KERNEL(base),
};

#undef PHYSIM_PARTICLE_KERNEL

}  // namespace

const ParticleKernel& particle_kernel() { return copy_in_use(kParticleKernels); }

}  // namespace physim
