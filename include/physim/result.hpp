// Result<T>: a value, or an error that says what is wrong, where, and what to do about it.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace physim {

/// What went wrong with some input.
struct Error {
  std::string message;  ///< what is wrong, in one sentence [-]
  std::string place;    ///< where: a field ("projectile.mass") or "file:line:col"; may be empty [-]
  std::string hint;     ///< what would be right; may be empty [-]

  /// "place: error: message; hint"
  [[nodiscard]] std::string text() const {
    std::string out = place.empty() ? "error: " + message : place + ": error: " + message;
    return hint.empty() ? out : out + "; " + hint;
  }
};

/// Either a T or an Error. Nothing in the library throws; ask before you take.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT: a value is a result
  Result(Error error) : content_(std::move(error)) {}  // NOLINT: an error is a result

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The value; calling this on an error is a bug in the caller.
  [[nodiscard]] const T& value() const& { return assert(ok()), *std::get_if<0>(&content_); }
  [[nodiscard]] T& value() & { return assert(ok()), *std::get_if<0>(&content_); }
  [[nodiscard]] T&& value() && { return assert(ok()), std::move(*std::get_if<0>(&content_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }

  /// The error; calling this on a value is a bug in the caller.
  [[nodiscard]] const Error& error() const { return assert(!ok()), *std::get_if<1>(&content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success without a value, or an error.
using Status = std::optional<Error>;

}  // namespace physim
