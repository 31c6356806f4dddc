// Values, by handle, of a device with a description that is known at compile time. A value that the
// device does not have does not compile, and the error names the object. Where a dictionary is
// known at run time only, Values (handle.hpp) returns an abort code.
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

#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/handle.hpp"
#include "canvoy/profiles/model/words_of_error.hpp"

namespace canvoy {

namespace wrong {

/// Reports a handle of an object that the device does not have.
template <Words object, Words entry, Words rule>
struct Handle;

}  // namespace wrong

namespace detail {

/// Whether a description has the value that a handle names.
enum class Presence : std::uint8_t { there, no_object, no_entry };

/// For blocks of objects, any of them: the handle selects the block at run time.
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

/// Reports each write of a value from the bus while this exists. The device must outlive it.
template <class Handle, class Function>
class [[nodiscard]] ValueWatch {
 public:
  /// Attaches to the dictionary. `function` gets the reference of the handle.
  ValueWatch(Dictionary& dictionary, const Handle& handle, Function function)
      : dictionary_(dictionary),
        handle_(handle),
        function_(std::move(function)),
        hook_{.first = handle.index(),
              .last = handle.index(),
              .after_write = callback<&ValueWatch::written>(*this)} {
    dictionary.attach(hook_);
  }
  /// Not allowed from within its own function.
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

/// A layout made by lay_out_device(), which holds its description.
template <class Layout>
concept DescribedLayout = requires { std::remove_cvref_t<Layout>::description; };

/// Gives `Self`, which has node(), access to its values by handle.
template <class Self, const auto& layout>
class DeviceValues {
 public:
  /// Costs a look-up in logarithmic time.
  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle)
    requires DescribedLayout<decltype(layout)>
  {
    check<Handle>();
    return {dictionary(), handle.index(), handle.sub()};
  }
  /// Calls `function` with the reference of the handle each time that the bus has written the
  /// value, by SDO or PDO, until the returned object is destroyed.
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

/// Like DeviceValues, but for a device that is composed at run time: find() and set() return
/// whether it has the value that a handle names.
template <class Self>
class FoundValues {
 public:
  /// Without the object, it reads zero and writes nothing.
  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle) {
    return values()[handle];
  }
  /// See Values.
  template <class Handle>
  [[nodiscard]] AbortCode find(const Handle& handle) {
    return values().find(handle);
  }
  /// See Values.
  template <class Handle, class Value>
  [[nodiscard]] AbortCode set(const Handle& handle, const Value& value) {
    return values().set(handle, value);
  }
  /// Like DeviceValues::on(). Without the object, the function is never called.
  template <class Handle, class Function>
  ValueWatch<Handle, Function> on(const Handle& handle, Function function) {
    return {dictionary(), handle, std::move(function)};
  }

 private:
  Values values() { return Values(dictionary()); }
  Dictionary& dictionary() { return static_cast<Self&>(*this).node().dictionary(); }
};

}  // namespace canvoy
