#include "common.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

namespace physim::python {

void set_exception(const Error& error) {
  const nb::object type = nb::module_::import_("physim._errors").attr("Error");
  const nb::object made = type(error.message, error.place, error.hint);
  PyErr_SetObject(type.ptr(), made.ptr());
}

namespace {

using AnyArray = nb::ndarray<nb::device::cpu>;  // no const: read-only arrays are no outputs

AnyArray writable(nb::handle object, const std::string& name) {
  AnyArray array;
  if (!nb::try_cast<AnyArray>(object, array, false))
    fail("is no array that can be written", name, "give a NumPy array of float64 or float32 that is not read-only");
  return array;
}

constexpr const char* kOnEachOther = "has numbers that lie on each other";
constexpr const char* kOfItsOwn = "give an array with a place for each number";

bool is_double(const AnyArray& array, const std::string& name) {
  if (array.dtype() == nb::dtype<double>()) return true;
  if (array.dtype() == nb::dtype<float>()) return false;
  fail("has a wrong type of numbers", name, "give a NumPy array of float64 or float32");
}

}  // namespace

Output::Output(nb::handle object, const std::string& name) : kept_(nb::borrow(object)) {
  const AnyArray array = writable(object, name);
  if (array.ndim() != 1) fail("has " + std::to_string(array.ndim()) + " dimensions", name, "expected one");
  is_double_ = is_double(array, name);
  data_ = array.data();
  size_ = array.shape(0);
  stride_ = array.stride(0);
  if (stride_ == 0 && size_ > 1) fail(kOnEachOther, name, kOfItsOwn);
  if (!is_direct()) buffer_.resize(size_);
}

void Output::finish() {
  for (std::size_t i = 0; i < buffer_.size(); ++i) {
    const std::int64_t at = static_cast<std::int64_t>(i) * stride_;
    if (is_double_)
      static_cast<double*>(data_)[at] = buffer_[i];
    else
      static_cast<float*>(data_)[at] = static_cast<float>(buffer_[i]);
  }
}

OutputRows::OutputRows(nb::handle object, const std::string& name) : kept_(nb::borrow(object)) {
  const AnyArray array = writable(object, name);
  if (array.ndim() != 2 || array.shape(1) != 3) fail("has a wrong shape", name, "expected rows of three: (n, 3)");
  is_double_ = is_double(array, name);
  data_ = array.data();
  size_ = array.shape(0);
  strides_[0] = array.stride(0), strides_[1] = array.stride(1);
  // Number `across` of a row is where a number of an other row is, or of this one.
  for (std::int64_t across = 0; across < 3; ++across) {
    const std::int64_t along = strides_[0], at = across * strides_[1];
    const bool is_met = along == 0 ? at == 0 && (across > 0 || size_ > 1)
                                   : at % along == 0 && std::abs(at / along) < std::int64_t(size_) && across > 0;
    if (is_met) fail(kOnEachOther, name, kOfItsOwn);
  }
}

// ------------------------------------------------------------------------------------------------------------- threads
namespace {

struct Ending {
  std::atomic<bool> has_begun{false};
  std::atomic<int> acquiring{0};  // threads that wait for the interpreter, have just got it, or call a function
  std::atomic<std::thread::id> by{};
};
Ending& ending() {
  static Ending* const one = new Ending;  // threads may outlive the end of main()
  return *one;
}

}  // namespace

bool Released::is_over() { return ending().has_begun && ending().by.load() != std::this_thread::get_id(); }

Visit::Visit() {
  ++ending().acquiring;
  may_ = Py_IsInitialized() != 0 && !Released::is_over();
  if (!may_) --ending().acquiring;
}

Visit::~Visit() {
  if (may_) --ending().acquiring;
}

Released::~Released() {
  const Visit visit;
  if (!visit)
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  PyEval_RestoreThread(state_);
}

void Released::wait_for_the_end(nb::module_& module) {
  module.def("_end", [] {
    ending().by = std::this_thread::get_id();
    ending().has_begun = true;
    // Those that are past their question get the interpreter now. A function that does not return is not waited for.
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (ending().acquiring > 0 && std::chrono::steady_clock::now() < until) {
      PyThreadState* const state = PyEval_SaveThread();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      PyEval_RestoreThread(state);
    }
  });
  nb::module_::import_("atexit").attr("register")(module.attr("_end"));
}

// ---------------------------------------------------------------------------------------------------------- functions
Function::Function(nb::object function)
    : shared_(new Shared{std::move(function), nullptr, {}}, [](Shared* shared) {
        if (!Py_IsInitialized()) {  // the interpreter took the object with it
          shared->function.release();
          static_cast<void>(shared->raised.release());
        } else {
          const nb::gil_scoped_acquire lock;
          shared->function.reset();
          shared->raised.reset();
        }
        delete shared;
      }) {}

nb::object Function::get() const { return shared_->function; }

void Function::raise_kept() const {
  if (!shared_->raised) return;
  const std::unique_ptr<nb::python_error> raised = std::move(shared_->raised);
  shared_->has_raised = false;
  throw nb::python_error(std::move(*raised));
}

nb::object array_of(std::span<const Vec3d> rows) {
  return rows_of(rows, [](const Vec3d& v) { return v; });
}

void copy_rows(nb::handle from, std::span<Vec3d> into, const char* what) {
  const nb::object numpy = nb::module_::import_("numpy");
  const nb::object given = numpy.attr("asarray")(from);
  const bool is_masked = nb::hasattr(from, "mask") && nb::cast<bool>(numpy.attr("ma").attr("is_masked")(from));
  if (is_masked || nb::cast<std::string_view>(given.attr("dtype").attr("kind")) == "c") {
    const std::string message =
        std::string(what) + " must return real numbers, not " + (is_masked ? "masked" : "complex");
    PyErr_SetString(PyExc_ValueError, message.c_str());
    throw nb::python_error();
  }
  const nb::object dense = numpy.attr("ascontiguousarray")(given, "dtype"_a = "float64");
  Triples rows;
  if (!nb::try_cast<Triples>(dense, rows, false) || rows.shape(0) != into.size()) {
    const std::string message = std::string(what) + " must return rows of three numbers, one for each of its " +
                                std::to_string(into.size()) + " inputs: shape (" + std::to_string(into.size()) + ", 3)";
    PyErr_SetString(PyExc_ValueError, message.c_str());
    throw nb::python_error();
  }
  for (std::size_t i = 0; i < into.size(); ++i) into[i] = {rows(i, 0), rows(i, 1), rows(i, 2)};
}

// ------------------------------------------------------------------------------------------------------------ threads
namespace {

struct Pools {
  std::mutex lock;
  std::map<unsigned, std::unique_ptr<TaskRunner>> all;
};

/// Pools of this process: a child that fork() made has none of its parent's threads, and makes its own.
Pools& pools() {
  static std::mutex guard;
  static std::map<pid_t, Pools*> by_process;  // never destroyed: threads may outlive the end of main()
  const std::lock_guard held(guard);
  Pools*& own = by_process[getpid()];
  if (own == nullptr) own = new Pools;
  return *own;
}

}  // namespace

Threads::Threads(unsigned count) {
  if (count == 1) return;
  Pools& all = pools();
  if (!all.lock.try_lock()) return;  // results do not depend on it
  is_locked_ = true;
  std::unique_ptr<TaskRunner>& pool = all.all[count];
  if (pool == nullptr) pool = make_thread_pool(count);
  runner_ = pool.get();
}

Threads::~Threads() {
  if (is_locked_) pools().lock.unlock();
}

}  // namespace physim::python
