// Elementary functions for float, double and packs of them: the same bits on every machine.
//
// Only IEEE additions, multiplications, divisions, square roots, comparisons and operations on bits are used, each lane
// alone: no libm, no tables, no fused multiply-add (compile with -ffp-contract=off). So a lane's result depends neither
// on the pack nor on compiler, optimisation or instruction set; tests/math/elementary_test.cpp holds a hash.
//
//   function     arguments                            worst error found [ulp]
//                                                        double    float
//   exp          results normal                           0.77      0.77
//                results subnormal (rounded twice)        0.82      0.81
//   expm1        all                                      1.42      1.46
//   log          all, also subnormal                      0.93      0.90
//   log1p        all                                      0.90      0.88
//   pow          x > 0, results normal                    1.00      0.80
//   sin, cos     |x| < 8.2e5 (double), 1.28e4 (float)     0.94      0.94
//   tan          |x| < 1e5 (double), 1e4 (float)          2.29      2.37
//   asin         all                                      1.16      1.15
//   acos         all                                      1.13      1.11
//   atan         all                                      1.29      1.39
//   atan2        all                                      1.53      1.51
//
// The errors are against libm in long double and double, at 8 to 32 million random points each, angles next to every
// multiple of pi/2 included; the tests assert them, rounded up a little. Zeros, infinities and NaN give what C says
// (a NaN's sign and payload excepted). Angles beyond the given range lose digits until sin and cos are mere numbers
// within [-1, 1], the same everywhere; only infinities and NaN give NaN.
#pragma once

#include "math/elementary_exp_log.hpp"
#include "math/elementary_trig.hpp"
