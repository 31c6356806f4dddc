// A value of one lift that is looked up once: like Bound, but for a lift that is known at run time.
//
//     LiftBound<statusword> statusword_(node.dictionary(), settings.lift);
//     statusword_ = 0x0637;
#pragma once

#include <type_traits>

#include "canvoy/profiles/cia417/values.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia417 {

/// `lift` is 1 to 8; `sub` selects one of several entries of one shape, 0: the first.
template <const auto& handle>
class LiftBound : public std::remove_cvref_t<decltype(handle)>::Reference {
 public:
  using Reference = typename std::remove_cvref_t<decltype(handle)>::Reference;  ///< of the handle

  /// Looks the value of lift 1 to 8 up, at a sub-index other than the handle's if `sub` is not 0.
  LiftBound(Dictionary& dictionary, unsigned lift, unsigned sub = 0)
      : Reference(dictionary, in_lift(lift, handle).index(),
                  sub == 0 ? handle.sub() : handle[sub].sub()) {}
  using Reference::operator=;
};

}  // namespace canvoy::cia417
