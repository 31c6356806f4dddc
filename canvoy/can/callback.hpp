// A reference to a function and the object that it works on: two words, copied freely, without
// ownership and allocation.
//
//     Callback<void(const Frame&)> received = callback<&Tool::on_frame>(tool);
#pragma once

#include <utility>

namespace canvoy {

/// Only Callback<Return(Arguments...)> exists.
template <class Signature>
class Callback;

/// A callback. While it is empty, a call does nothing and returns a default value. The object must
/// outlive the callback.
template <class Return, class... Arguments>
class Callback<Return(Arguments...)> {
 public:
  /// What a callback calls: a function with the context before the arguments.
  using Function = Return (*)(void* context, Arguments...);

  constexpr Callback() = default;
  /// `function` is called with `context`, which must outlive the callback.
  constexpr Callback(Function function, void* context) : function_(function), context_(context) {}

  /// Callback of a member function of `object`.
  template <auto method, class Object>
  static constexpr Callback to(Object& object) {
    return {
        [](void* context, Arguments... arguments) -> Return {
          return (static_cast<Object*>(context)->*method)(std::forward<Arguments>(arguments)...);
        },
        &object};
  }
  /// Callback of a function object that outlives it, such as a lambda kept in a variable.
  template <class Functor>
  static constexpr Callback of(Functor& functor) {
    return {[](void* context, Arguments... arguments) -> Return {
              return (*static_cast<Functor*>(context))(std::forward<Arguments>(arguments)...);
            },
            &functor};
  }

  constexpr explicit operator bool() const { return function_ != nullptr; }
  friend constexpr bool operator==(const Callback&, const Callback&) = default;
  Return operator()(Arguments... arguments) const {
    if (function_ == nullptr) return Return();
    return function_(context_, std::forward<Arguments>(arguments)...);
  }

 private:
  Function function_ = nullptr;
  void* context_ = nullptr;
};

/// A member function and its object, before it is known which Callback is wanted.
template <auto member, class Object>
struct BoundMember {
  Object& object;  ///< must outlive the callback

  /// The Callback that is wanted where this is given.
  template <class Return, class... Arguments>
  constexpr operator Callback<Return(Arguments...)>() const {
    return Callback<Return(Arguments...)>::template to<member>(object);
  }
};
/// Callback of a member function of `object`; its signature is that of the place where it is given.
template <auto member, class Object>
constexpr BoundMember<member, Object> callback(Object& object) {
  return {object};
}

namespace detail {

template <class Member>
struct Method;
template <class Object, class Return, class... Arguments>
struct Method<Return (Object::*)(Arguments...)> {
  template <Return (Object::*member)(Arguments...)>
  static Return call(void* object, Arguments... arguments) {
    return (static_cast<Object*>(object)->*member)(std::forward<Arguments>(arguments)...);
  }
};

}  // namespace detail

/// A member function as a plain function that takes its object first: for constant tables of
/// functions, which take no memory in each object.
template <auto member>
inline constexpr auto method = detail::Method<decltype(member)>::template call<member>;

}  // namespace canvoy
