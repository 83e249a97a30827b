#!/usr/bin/env bash
# `zig cc` 0.17.1 (ziglang on PyPI, a usual way to build wheels for manylinux) compiles and links
# __builtin_cpu_supports(), and it answers 0 for every feature, SSE2 of x86-64 among them, also behind
# __builtin_cpu_init(). zig's own compiler runtime (lib/compiler_rt/fmv.zig) defines what is read as zeros, and an
# initialiser that returns at once. A library that chooses its kernels by it runs the slowest ones, with no warning of
# the compiler, the linker or the program. gcc on the same processor answers 1. <cpuid.h> works with both.
# Seen on x86-64: zig: sse2 0, sse4.2 0, popcnt 0, by cpuid sse2 1; gcc: sse2 1, by cpuid sse2 1.
set -euo pipefail
[[ $(uname -m) == x86_64 ]] || { echo "for x86-64"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q ziglang==0.17.1
cat >"$folder/asks.c" <<'C'
#include <cpuid.h>
#include <stdio.h>

int main(void) {
  unsigned a, b, c, d = 0;
  __get_cpuid(1, &a, &b, &c, &d);
  __builtin_cpu_init();
  printf("sse2 %d, sse4.2 %d, popcnt %d, by cpuid sse2 %d\n", !!__builtin_cpu_supports("sse2"),
         !!__builtin_cpu_supports("sse4.2"), !!__builtin_cpu_supports("popcnt"), !!(d & bit_SSE2));
  return 0;
}
C
export ZIG_GLOBAL_CACHE_DIR=$folder/cache ZIG_LOCAL_CACHE_DIR=$folder/cache
"$folder/env/bin/python" -m ziglang cc -O2 "$folder/asks.c" -o "$folder/by_zig"
gcc -O2 "$folder/asks.c" -o "$folder/by_gcc"
by_zig=$("$folder/by_zig") by_gcc=$("$folder/by_gcc")
printf 'zig: %s\ngcc: %s\n' "$by_zig" "$by_gcc"
[[ $by_zig == "sse2 0, sse4.2 0, popcnt 0, by cpuid sse2 1" ]]
[[ $by_gcc == "sse2 1, "*", by cpuid sse2 1" ]]
