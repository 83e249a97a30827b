// What users of Vec3 call.
#include "math/vec3.hpp"

namespace physim {

template <class T>
void Vec3<T>::add_scaled(const Vec3<T>& b, const T& s) {
  physim::add_scaled(*this, b, s);
}

#define PHYSIM_VEC3(T)                                         \
  template void Vec3<T>::add_scaled(const Vec3<T>&, const T&); \
  template T dot(const Vec3<T>&, const Vec3<T>&);              \
  template Vec3<T> cross(const Vec3<T>&, const Vec3<T>&);      \
  template T length_squared(const Vec3<T>&);                   \
  template T length(const Vec3<T>&);                           \
  template Vec3<T> normalized(const Vec3<T>&);                 \
  template void normalize(Vec3<T>&);
PHYSIM_VEC3(float)
PHYSIM_VEC3(double)
#undef PHYSIM_VEC3

}  // namespace physim
