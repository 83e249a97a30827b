// WeightedChoice: one of many, each as likely as its weight, at a cost that does not depend on how many there are.
//
// Symbols: n how many, w weights, p = n w / sum of w; u a number between 0 and 1.
// Equation: place i = [n u], with r = n u - i: i itself where r < keep(i), otherwise its alias; keeps and aliases are
//   such that each is chosen with the probability p / n. What is left of u is even between 0 and 1 again.
// Source: A. J. Walker, ACM Trans. Math. Software 3 (1977) 253-256; M. D. Vose, IEEE Trans. Software Eng. 17 (1991)
//   972-975, for the tables.
#pragma once

#include <cstdint>
#include <vector>

namespace physim {

class WeightedChoice {
 public:
  WeightedChoice() = default;
  /// Weights are zero or positive, and some are positive; up to 2^32 of them.
  explicit WeightedChoice(const std::vector<double>& weights);

  struct Chosen {
    std::uint32_t which = 0;
    double rest = 0;  // of the number that chose, 0..1
  };
  /// `u`: 0..1.
  [[nodiscard]] Chosen operator()(double u) const;

 private:
  struct Place {
    double keep = 1;
    std::uint32_t alias = 0;
  };
  std::vector<Place> places_;
};

}  // namespace physim
