// Memory that is not set to zero and holds nothing until it is written: what only some rungs use of a large structure.
#pragma once

#include "base/assert.hpp"

namespace physim {

/// Room for a T.
template <class T>
union Unset {
  T value;

  PHYSIM_INLINE Unset() {}  // NOLINT: left uninitialised
  PHYSIM_INLINE T* operator->() { return &value; }
  PHYSIM_INLINE const T* operator->() const { return &value; }
  PHYSIM_INLINE T& operator*() { return value; }
  PHYSIM_INLINE const T& operator*() const { return value; }
};

/// Room for some of them.
template <class T, int kCount>
union UnsetList {
  T item[kCount];

  PHYSIM_INLINE UnsetList() {}  // NOLINT: left uninitialised
  PHYSIM_INLINE T& operator[](int i) { return item[i]; }
  PHYSIM_INLINE const T& operator[](int i) const { return item[i]; }
};

}  // namespace physim
