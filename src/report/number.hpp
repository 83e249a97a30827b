// Numbers as text, the same on every machine and in every locale.
#pragma once

#include <cstdint>
#include <string>

namespace physim::report {

/// The shortest text that reads back to the same double: for files.
[[nodiscard]] std::string shortest(double value);
/// The shortest text of a double without an exponent: "0.00000125".
[[nodiscard]] std::string plain(double value);
/// Fixed decimals, "-3.100"; never "-0.000".
[[nodiscard]] std::string fixed(double value, int decimals);
/// `digits` significant digits, with an exponent if the number is very large or small.
[[nodiscard]] std::string significant(double value, int digits);
/// What a person typed, without the rounding errors of its conversion into SI: "0.026", not "0.026000000000000002".
[[nodiscard]] std::string as_typed(double value);
/// As many decimals as give `digits` significant ones, without an exponent: "1234", "12.3", "0.0123"; six at most.
[[nodiscard]] std::string readable(double value, int digits);
/// As readable(), with an exponent where six decimals or nine digits show a number poorly: "5e-08", "2.001e+17".
[[nodiscard]] std::string sized(double value, int digits);
/// The number of so many significant digits.
[[nodiscard]] double rounded(double value, int digits);
/// "0x00000000000000ff", as hashes are shown.
[[nodiscard]] std::string hex(std::uint64_t value);

}  // namespace physim::report
