// Four doubles at a time: in one register where the processor has such wide ones, in two elsewhere. The
// same operations in the same order either way, so that both give the same bytes.
#pragma once

#include <cstring>

namespace quicksand {

using Lanes = double __attribute__((vector_size(32)));

// By reference: as a value, Lanes would pass between functions in ways that depend on the processor.
[[gnu::always_inline]] inline void load_lanes(const double* from, Lanes& x) {
  std::memcpy(&x, from, sizeof x);
}
[[gnu::always_inline]] inline void store_lanes(const Lanes& x, double* to) {
  std::memcpy(to, &x, sizeof x);
}

#ifdef __x86_64__

inline bool has_wide_registers() {
  static const bool has = __builtin_cpu_supports("avx2") > 0;
  return has;
}
template <class Work>
[[gnu::target("avx2")]] void in_wide_registers(const Work& work) {
  work();
}

#else

inline bool has_wide_registers() { return false; }
template <class Work>
void in_wide_registers(const Work& work) {
  work();
}

#endif

// Calls work(), compiled for the widest registers that are there. It must be a lambda marked
// __attribute__((always_inline)), and so must be what it calls, or it is compiled once for all processors.
template <class Work>
void with_lanes(const Work& work) {
  if (has_wide_registers())
    in_wide_registers(work);
  else
    work();
}

}  // namespace quicksand
