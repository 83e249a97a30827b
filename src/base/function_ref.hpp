// A function that is lent for a call: nothing is copied or owned, and no type information is kept.
#pragma once

#include <type_traits>
#include <utility>

namespace physim {

template <class Signature>
class FunctionRef;

template <class Out, class... In>
class FunctionRef<Out(In...)> {
 public:
  template <class F>
  requires(!std::is_same_v<F, FunctionRef>) FunctionRef(const F& f)  // NOLINT: what is called is lent as it is
      : of_(&f),
        call_([](const void* of, In... in) -> Out { return (*static_cast<const F*>(of))(std::forward<In>(in)...); }) {}
  Out operator()(In... in) const { return call_(of_, std::forward<In>(in)...); }

 private:
  const void* of_;
  Out (*call_)(const void*, In...);
};

}  // namespace physim
