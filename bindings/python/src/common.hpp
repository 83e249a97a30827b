// Common parts of the extension module: errors as exceptions, columns as NumPy arrays, functions of Python.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physim/physim.hpp"
#include "physim/scenario.hpp"

namespace physim::python {

namespace nb = nanobind;
using namespace nb::literals;

// ------------------------------------------------------------------------------------------------------------- errors
/// An error of the library on its way to Python, where it becomes a physim.Error.
struct Failure {
  Error error;
};
/// Makes it the exception that Python raises next.
void set_exception(const Error& error);
[[noreturn]] inline void fail(Error error) { throw Failure{std::move(error)}; }
[[noreturn]] inline void fail(std::string message, std::string place, std::string hint = {}) {
  throw Failure{{std::move(message), std::move(place), std::move(hint)}};
}
template <class T>
T taken(Result<T> result) {
  if (!result) fail(result.error());
  return std::move(result).value();
}
inline void taken(const Status& status) {
  if (!status) fail(status.error());
}

// ------------------------------------------------------------------------------------------------------------- arrays
/// A column that is read: float64, side by side. The Python side makes it so, without a copy where it is so already.
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
/// Rows of three numbers that are read.
using Triples = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

[[nodiscard]] inline std::span<const double> span_of(const Numbers& numbers) {
  return {numbers.data(), numbers.size()};
}

/// An array that owns its numbers.
template <class T>
[[nodiscard]] nb::object owned(std::vector<T> values, std::initializer_list<std::size_t> shape) {
  auto* const kept = new std::vector<T>(std::move(values));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, T>(kept->data(), shape.size(), shape.begin(), owner));
}
template <class T>
[[nodiscard]] nb::object owned(std::vector<T> values) {
  const std::size_t size = values.size();
  return owned(std::move(values), {size});
}
[[nodiscard]] inline nb::object array_of(const Vec3d& v) { return owned(std::vector<double>{v.x, v.y, v.z}); }
[[nodiscard]] inline nb::object array_of(const Quatd& q) { return owned(std::vector<double>{q.w, q.x, q.y, q.z}); }
/// Rows of three numbers out of the members of many.
template <class List, class Get>
[[nodiscard]] nb::object rows_of(const List& list, const Get& get) {
  std::vector<double> numbers;
  numbers.reserve(3 * std::size(list));
  for (const auto& each : list) {
    const Vec3d v = get(each);
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
  }
  return owned(std::move(numbers), {std::size(list), 3});
}
template <class T, class List, class Get>
[[nodiscard]] nb::object column_of(const List& list, const Get& get) {
  std::vector<T> numbers;
  numbers.reserve(std::size(list));
  for (const auto& each : list) numbers.push_back(static_cast<T>(get(each)));
  return owned(std::move(numbers));
}

/// A column of true and false.
template <class List, class Get>
[[nodiscard]] nb::object flags_of(const List& list, const Get& get) {
  return column_of<std::uint8_t>(list, [&](const auto& each) { return get(each) ? 1 : 0; }).attr("view")("bool");
}

[[nodiscard]] inline Vec3d vec_of(const std::vector<double>& v, const char* place) {
  if (v.size() != 3) fail("found " + std::to_string(v.size()) + " components", place, "expected three: x, y, z");
  return {v[0], v[1], v[2]};
}

/// A column in the caller's memory: float64 or float32, with any stride. It is never converted: what cannot be written
/// as it is, is refused.
class Output {
 public:
  Output(nb::handle array, const std::string& name);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Memory to be written: the caller's, or a buffer that finish() converts or scatters.
  [[nodiscard]] std::span<double> span() {
    return is_direct() ? std::span<double>(static_cast<double*>(data_), size_) : std::span<double>(buffer_);
  }
  /// Writes what is not in place yet.
  void finish();

 private:
  [[nodiscard]] bool is_direct() const { return is_double_ && stride_ == 1; }

  nb::object kept_;
  void* data_ = nullptr;
  std::size_t size_ = 0;
  std::int64_t stride_ = 1;
  bool is_double_ = true;
  std::vector<double> buffer_;
};

/// Rows of three numbers in the caller's memory, under the rules of Output.
class OutputRows {
 public:
  OutputRows(nb::handle array, const std::string& name);

  [[nodiscard]] std::size_t size() const { return size_; }
  void put(std::size_t row, const Vec3d& v) {
    const double numbers[3] = {v.x, v.y, v.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t at = static_cast<std::int64_t>(row) * strides_[0] + static_cast<std::int64_t>(i) * strides_[1];
      if (is_double_)
        static_cast<double*>(data_)[at] = numbers[i];
      else
        static_cast<float*>(data_)[at] = static_cast<float>(numbers[i]);
    }
  }

 private:
  nb::object kept_;
  void* data_ = nullptr;
  std::size_t size_ = 0;
  std::int64_t strides_[2] = {3, 1};
  bool is_double_ = true;
};

/// Refuses a column of another length.
inline void check_length(std::size_t found, std::size_t wanted, const std::string& name) {
  if (found != wanted) fail("found " + std::to_string(found) + " numbers", name, "expected " + std::to_string(wanted));
}

// ---------------------------------------------------------------------------------------------------------------- ids
template <class Named>
[[nodiscard]] std::uint64_t number_of(const Id<Named>& id) {
  return std::uint64_t{id.generation} << 32 | id.index;
}
template <class Id>
[[nodiscard]] Id id_of(std::uint64_t number) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
}
using Ids = nb::ndarray<const std::uint64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// ------------------------------------------------------------------------------------------------------------- threads
/// Lets other threads of Python run while it lives. When the interpreter ends, threads that are still in here wait for
/// the end of the process: Python would end them in the middle of functions of C++, which aborts.
class Released {
 public:
  Released() : state_(PyEval_SaveThread()) {}
  ~Released();
  Released(const Released&) = delete;
  Released& operator=(const Released&) = delete;

  /// True if the interpreter has begun to end, and another thread than this one ends it.
  [[nodiscard]] static bool is_over();
  /// To be called once, by the module.
  static void wait_for_the_end(nb::module_& module);

 private:
  PyThreadState* state_;
};

/// A thread of the library that is to call Python: the interpreter's end waits for it, or it may not.
class Visit {
 public:
  Visit();
  ~Visit();
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;
  explicit operator bool() const { return may_; }

 private:
  bool may_;
};

// ---------------------------------------------------------------------------------------------------------- functions
/// A function of Python that the library calls, from any thread. What it raises is kept, and raised again when the call
/// of the library is over.
class Function {
 public:
  explicit Function(nb::object function);

  [[nodiscard]] nb::object get() const;
  /// For the garbage collector of Python: what is held here, and letting go of it.
  [[nodiscard]] nb::handle held() const { return shared_->function; }
  void let_go() const {
    const nb::object gone = std::move(shared_->function);
    shared_->function = nb::none();
  }
  /// Calls `work` with the interpreter's lock; an exception is kept, and the library gets a C++ exception, as in all
  /// calls from then on until it is raised.
  template <class Work>
  void call(const Work& work) const {
    const Visit visit;
    if (!visit || shared_->has_raised) throw Stopped();
    const nb::gil_scoped_acquire lock;
    try {
      work(shared_->function);
      return;
    } catch (nb::python_error& error) {
      keep(std::move(error));
    } catch (const Failure& failure) {
      set_exception(failure.error);
      keep(nb::python_error());
    } catch (const std::exception& error) {  // a conversion that failed
      PyErr_SetString(PyExc_ValueError, error.what());
      keep(nb::python_error());
    }
    throw Stopped();
  }
  /// Raises what was kept. The interpreter's lock is held.
  void raise_kept() const;
  [[nodiscard]] bool has_raised() const { return shared_->has_raised; }

 private:
  struct Stopped {};
  void keep(nb::python_error&& error) const {
    if (!shared_->raised) shared_->raised = std::make_unique<nb::python_error>(std::move(error));
    shared_->has_raised = true;
  }
  struct Shared {
    nb::object function;
    std::unique_ptr<nb::python_error> raised;
    std::atomic<bool> has_raised{false};
  };
  std::shared_ptr<Shared> shared_;
};

/// A copy of rows of three numbers as an array, and back. A wrong shape is an error of the function.
[[nodiscard]] nb::object array_of(std::span<const Vec3d> rows);
void copy_rows(nb::handle from, std::span<Vec3d> into, const char* what);

// ------------------------------------------------------------------------------------------------------------ threads
/// Threads for a call: null where one is asked for, or where another call has those of this process.
class Threads {
 public:
  explicit Threads(unsigned count);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  [[nodiscard]] TaskRunner* runner() const { return runner_; }

 private:
  TaskRunner* runner_ = nullptr;
  bool is_locked_ = false;
};

// -------------------------------------------------------------------------------------------------- parts of the
// module
void add_setup(nb::module_& module);
void add_flight(nb::module_& module);
void add_solve(nb::module_& module);
void add_world(nb::module_& module);
void add_scene(nb::module_& module);
void add_study(nb::module_& module);

/// Events as columns, the kinds by name.
[[nodiscard]] nb::dict event_columns(std::span<const Event> events);
/// An event as a table of its members.
[[nodiscard]] nb::dict event_table(const Event& event);
/// A state as a table of its numbers.
[[nodiscard]] nb::dict sample_table(const Sample& sample);
/// Fidelity granted, with the reasons where it differs from what was asked for.
[[nodiscard]] nb::list notes_table(const FidelityInUse& in_use);

}  // namespace physim::python
