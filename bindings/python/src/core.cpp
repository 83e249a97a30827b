// physim._core: the library as the Python package sees it. Users import physim, which is written on top of it.
#include "common.hpp"

namespace physim::python {
namespace {

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Failure& failure) {
    set_exception(failure.error);
  }
}

}  // namespace
}  // namespace physim::python

NB_MODULE(_core, m) {
  using namespace physim::python;
  m.doc() = "The library itself; use the package physim, which is written on top of it.";
  nb::register_exception_translator(translate);
  nb::set_leak_warnings(false);  // objects that live when the interpreter ends are no mistake
  m.attr("__version__") = physim::kVersion;
  m.def("use_kernel", &physim::use_kernel, "name"_a, "Chooses the instruction set; \"\" chooses the best.");
  Released::wait_for_the_end(m);
  add_setup(m);
  add_flight(m);
  add_solve(m);
  add_scene(m);
  add_world(m);
  add_study(m);
}
