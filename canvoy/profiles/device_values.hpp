// The values of a device whose description the compiler knows, by handle: one that the device does
// not have does not compile, and the error names the object. Where a dictionary is known at run
// time only, Values (handle.hpp) answers with an abort code.
//
//     class Lamp : public DeviceValues<Lamp, layout> { public: Node& node(); ... };
//
//     lamp[brightness] = 80;
//     const auto watch = lamp.on(brightness, [](auto value) { show(value.value()); });
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "canvoy/profiles/device_description.hpp"
#include "canvoy/profiles/handle.hpp"
#include "canvoy/profiles/words_of_error.hpp"

namespace canvoy {

namespace wrong {

/// A handle of what the device does not have.
template <Words object, Words entry, Words rule>
struct Handle;

}  // namespace wrong

namespace detail {

/// What a handle names, and a description has.
enum class Presence : std::uint8_t { there, no_object, no_entry };

/// Of blocks of objects, any of them: the handle says at run time which one it means.
template <std::size_t capacity>
constexpr Presence presence(const DeviceDescription<capacity>& device, const ObjectInfo& object,
                            const EntryInfo& entry) {
  Presence found = Presence::no_object;
  for (const Part& part : device) {
    const bool is_same = &part.object() == &object ||
                         (part.object().index == object.index && part.object().name == object.name);
    if (!is_same) continue;
    found = Presence::no_entry;
    const EntryInfo* own = find_entry(part.object(), entry.sub_first);
    if (own != nullptr && own->type == entry.type && part.has(*own)) return Presence::there;
  }
  return found;
}

template <const auto& device, class Place>
consteval bool has_entry_of_handle() {
  constexpr Presence found = presence(device, Place::object, Place::entry);
  if constexpr (found == Presence::there) {
    return true;
  } else if constexpr (found == Presence::no_object) {
    return Must<false, wrong::Handle<words_of<Place::object>(), words_of_entry<Place>(),
                                     "this device has no such object">>::hold;
  } else {
    return Must<false, wrong::Handle<words_of<Place::object>(), words_of_entry<Place>(),
                                     "this device has no such entry">>::hold;
  }
}

}  // namespace detail

/// Tells of a value that the bus has written, as long as it lives: the device must outlive it.
template <class Handle, class Function>
class [[nodiscard]] ValueWatch {
 public:
  ValueWatch(Dictionary& dictionary, const Handle& handle, Function function)
      : dictionary_(dictionary),
        handle_(handle),
        function_(std::move(function)),
        hook_{
            .first = handle.index(),
            .last = handle.index(),
            .after_write = Callback<void(const Entry&, Source)>::to<&ValueWatch::written>(*this)} {
    dictionary.attach(hook_);
  }
  /// Not from within its own function.
  ~ValueWatch() { dictionary_.detach(hook_); }
  ValueWatch(const ValueWatch&) = delete;
  ValueWatch& operator=(const ValueWatch&) = delete;

 private:
  void written(const Entry& entry, Source) {
    if (entry.sub != handle_.sub()) return;
    function_(typename Handle::Reference(dictionary_, handle_.index(), handle_.sub()));
  }

  Dictionary& dictionary_;
  [[no_unique_address]] Handle handle_;
  [[no_unique_address]] Function function_;
  Hook hook_;
};

/// A layout by lay_out_device(), which knows of what description it is.
template <class Layout>
concept DescribedLayout = requires { std::remove_cvref_t<Layout>::description; };

/// Gives `Self`, which has node(), its values by handle.
template <class Self, const auto& layout>
class DeviceValues {
 public:
  /// Costs a look-up, of logarithmic time.
  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle)
    requires DescribedLayout<decltype(layout)>
  {
    check<Handle>();
    return {dictionary(), handle.index(), handle.sub()};
  }
  /// `function` gets the reference of the handle each time that the bus has written the value,
  /// by SDO or PDO, and until what is returned ends.
  template <class Handle, class Function>
  ValueWatch<Handle, Function> on(const Handle& handle, Function function)
    requires DescribedLayout<decltype(layout)>
  {
    check<Handle>();
    return {dictionary(), handle, std::move(function)};
  }

 private:
  template <class Handle>
  static constexpr void check() {
    static_assert(detail::has_entry_of_handle<std::remove_cvref_t<decltype(layout)>::description,
                                              typename Handle::Place>());
  }
  Dictionary& dictionary() { return static_cast<Self&>(*this).node().dictionary(); }
};

/// The same of a device that is put together when the program runs: whether it has what a handle
/// names is an answer of find() and set().
template <class Self>
class FoundValues {
 public:
  /// Without the object it reads as zero, and writes nothing.
  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle) {
    return values()[handle];
  }
  /// See Values.
  template <class Handle>
  [[nodiscard]] AbortCode find(const Handle& handle) {
    return values().find(handle);
  }
  template <class Handle, class Value>
  [[nodiscard]] AbortCode set(const Handle& handle, const Value& value) {
    return values().set(handle, value);
  }
  /// As DeviceValues has it; without the object it is never called.
  template <class Handle, class Function>
  ValueWatch<Handle, Function> on(const Handle& handle, Function function) {
    return {dictionary(), handle, std::move(function)};
  }

 private:
  Values values() { return Values(dictionary()); }
  Dictionary& dictionary() { return static_cast<Self&>(*this).node().dictionary(); }
};

}  // namespace canvoy
