#include <string_view>

#include "base/kernel_copies.hpp"
#include "emit/column_job.hpp"
#include "flight/kernels.hpp"

namespace physim {

PHYSIM_KERNEL_COPIES(void draw_words(const WordsJob& job); void put_numbers(const NumberJob& job);
                     void put_gradients(const GradientPieces& pieces, const double* x, const ColourColumns& colour);
                     void pack_colours(const ColourColumns& colour, std::uint32_t* packed);
                     void put_parts_of_life(double time, const double* birth, const double* span, double* part);
                     void put_drag_float(const DragJob<float>& job); void put_drag_double(const DragJob<double>& job);)

namespace {

#define PHYSIM_COLUMN_KERNEL(isa)                                                                           \
  {                                                                                                         \
#isa, isa::draw_words, isa::put_numbers, isa::put_gradients, isa::pack_colours, isa::put_parts_of_life, \
        isa::put_drag_float, isa::put_drag_double                                                           \
  }

constexpr ColumnKernel kColumnKernels[] = {
#if PHYSIM_HAVE_AVX512
    PHYSIM_COLUMN_KERNEL(avx512),
#endif
#if PHYSIM_HAVE_AVX2
    PHYSIM_COLUMN_KERNEL(avx2),
#endif
    PHYSIM_COLUMN_KERNEL(base),
};

#undef PHYSIM_COLUMN_KERNEL

}  // namespace

const ColumnKernel& column_kernel() {
  const std::string_view wanted = batch_kernel().name;
  for (const ColumnKernel& kernel : kColumnKernels)
    if (kernel.name == wanted) return kernel;
  return kColumnKernels[std::size(kColumnKernels) - 1];  // "scalar", too: numbers know nothing of how many there are
}

}  // namespace physim
