// The library's promise of equal bits stands on IEEE operations in the order written. cmake/flags.cmake takes back
// what flags from outside allow the compiler beside them; a build of another kind that allows it ends here.
#pragma once

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "PhySim's own sources are compiled without -ffast-math: add -fno-fast-math -ffp-contract=off behind it"
#endif
