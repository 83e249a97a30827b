// Results and errors; the version; progress and threads of long calls.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// The version of the library.

inline constexpr const char* kVersion = "0.2.0";

// ---------------------------------------------------------------------------------------------------------------------
// Result<T>: a value, or an error that says what is wrong, where, and what to do about it.

/// An error in some input.
struct Error {
  std::string message{};  ///< the error, in one sentence [-]
  std::string place{};    ///< of the error: a field ("projectile.mass") or "file:line:col"; may be empty [-]
  std::string hint{};     ///< the correction; may be empty [-]

  /// "place: error: message; hint"
  [[nodiscard]] std::string text() const {
    std::string out = place.empty() ? "error: " + message : place + ": error: " + message;
    return hint.empty() ? out : out + "; " + hint;
  }
};

/// Receives the text of what ends a program: a value is taken out of a Result that has none, or the library finds a
/// mistake of its own (in builds with asserts). If it returns, the program ends by std::abort().
using FailureHandler = void (*)(const char* text);
/// Sets the handler of the program, for an engine's own log; null: the text goes to stderr. Returns the one before. Any
/// thread may call it. The library writes nothing else to stderr.
FailureHandler set_failure_handler(FailureHandler handler);

namespace result_detail {
/// Asked for what is not there: says so and ends the program, in every build.
[[noreturn]] void end(const char* what, const std::string& text);
}  // namespace result_detail

/// Either a T or an Error; true where it is a T. Nothing in the library throws; ask before you take.
template <class T>
class Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT: a value is a result
  Result(Error error) : content_(std::move(error)) {}  // NOLINT: an error is a result

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value. Calling this on an error is a bug in the caller: it prints the error and ends the program.
  [[nodiscard]] const T& value() const& {
    check();
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T& value() & {
    check();
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T&& value() && {
    check();
    return std::move(*std::get_if<0>(&content_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  /// The error. Calling this on a value is a bug in the caller, which ends the program.
  [[nodiscard]] const Error& error() const {
    if (ok()) result_detail::end("error() of a result that has a value", "");
    return *std::get_if<1>(&content_);
  }

 private:
  void check() const {
    if (!ok())
      result_detail::end("value() of a result that has none; look at it first: if (result) ...", error().text());
  }
  std::variant<T, Error> content_;
};

/// Success without a value, or an Error; true on success, as with other results.
template <>
class Result<void> {
 public:
  /// Success. Written out: a defaulted constructor would clear all the room of an error first, in every `return {};`.
  Result() {}                                        // NOLINT
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: an error is a result

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// The error. Calling this on a success is a bug in the caller, which ends the program.
  [[nodiscard]] const Error& error() const {
    if (ok()) result_detail::end("error() of a success", "");
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

// ---------------------------------------------------------------------------------------------------------------------
// Progress: reports of how much of a long call is done.

/// Called after each part of the work with the number of parts done and of all; may be empty.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

// ---------------------------------------------------------------------------------------------------------------------
// TaskRunner: the one interface through which a world uses threads, so that an engine can lend its own.

/// Runs independent pieces of work. A world's results do not depend on how.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;
  /// Calls task(context, i) for every i < count, in any order, on any threads, and returns when all are done.
  virtual void run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) = 0;
  [[nodiscard]] virtual unsigned threads() const = 0;  ///< that may work at the same time
};

/// Threads of one pool at most.
inline constexpr unsigned kMostThreads = 1024;

/// A pool of threads that sleep until there is work; `threads` counts the caller's, 0: all that the machine has. It has
/// fewer if more than kMostThreads are requested, or the system gives no more: threads() returns the number.
[[nodiscard]] std::unique_ptr<TaskRunner> make_thread_pool(unsigned threads = 0);

}  // namespace physim
