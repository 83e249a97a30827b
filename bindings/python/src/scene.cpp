#include "common.hpp"
namespace physim::python {
void add_scene(nb::module_&) {}
void add_world(nb::module_&) {}
void add_study(nb::module_&) {}
}  // namespace physim::python
